# SPDX-License-Identifier: GPL-3.0-or-later
"""Cantilever of bonded particles, several through its thickness, against beam theory"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import entry, numberOf, readDictionary
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
E, nu, rho = 10e6, 0.4, 1100
e, L = 5e-3, 7.9375e-2                          # thickness, length
inertia = e**3/12
paper = 1.536e-3                                # its tip displacement [m]
planeStrain = E*(1 - nu)/((1 + nu)*(1 - 2*nu))  # section 6.3.3
shearRatio = 0.5                                # ks/kn there


def beamTip(length, load=1.0):
    """Euler-Bernoulli: 1.6003 mm for L and 1 N/m"""
    return load*length**3/(3*E*inertia)


def withShear(length):
    """Timoshenko, kappa = 5/6: 1.6056 mm"""
    return beamTip(length) + length/(5/6*E/(2*(1 + nu))*e)


def elasticaTip(length, load, points=400):
    """Deflection of an inextensible beam of any deflection under a load that keeps its direction: E
    I theta'' = -P cos(theta), theta(0) = 0, theta'(L) = 0; by shooting"""
    h = length/points

    def shot(curvature):
        theta, k, y = 0.0, curvature, 0.0
        for _ in range(points):             # midpoint rule
            half, slope = theta + 0.5*h*k, k - 0.5*h*load*np.cos(theta)/(E*inertia)
            theta, k, y = theta + h*slope, k - h*load*np.cos(half)/(E*inertia), y + h*np.sin(half)
        return k, y
    low, high = 0.0, load*length/(E*inertia)
    for _ in range(50):
        middle = 0.5*(low + high)
        low, high = (low, middle) if shot(middle)[0] > 0 else (middle, high)
    return shot(low)[1]


def beamFrequency(length):
    return 1.8751041**2/(2*np.pi*length**2)*np.sqrt(E*inertia/(rho*e))


def lattice(kind, rows, columns):
    """Entries of system/plate; the length is that from the first column to the last. Boxes are a
    little wider than their particles, since dictionaries keep six digits"""
    height = np.sqrt(3)/2 if kind == 'hexagonal' else 1
    s = e/(rows*height)
    half = s/2 if kind == 'hexagonal' else 0
    half += 0.05*s
    numbers = {'radius': s/2, 'spacing': s, 'thickness': s*(1.05 + (rows - 1)*height),
               'clampEnd': s + half, 'beamStart': s, 'beamEnd': (columns - 1)*s + half,
               'tipStart': (columns - 1)*s, 'tipEnd': columns*s + half}
    return (f'system/plate:packing {kind}; '
            + '; '.join(f'system/plate:{k} {v:.12g}' for k, v in numbers.items()))


def cement(young, shear, radius='mean'):
    return (
        f'; bonds/cement/E {young:.10g}; bonds/cement/G {shear:.10g}; bonds/cement/radius {radius}')


def square(rows, columns):
    return lattice('square', rows, columns) + cement(E, E/(1 + nu))


def hexagonal(rows, columns):
    """Springs of a triangular lattice whose plane modulus is E (README); ks/kn as the paper's"""
    young = E*(3 + shearRatio)/(2*np.sqrt(3)*(1 + shearRatio))
    return lattice('hexagonal', rows, columns) + cement(young, shearRatio*young)


def hexagonalCounted(rows, columns):
    """The same with the rows counted: n rows of bonds, n - 1 strips of slanted ones between them,
    each bond's own bending"""
    n, k, h, s = rows, shearRatio, e/rows, 2*e/(np.sqrt(3)*rows)
    strips = 2*k/(3 + k)*(n - 1)*((n - 1)**2 - 1)
    young = E*inertia/(s*(h**2*(n*(n**2 - 1) + strips) + s**2*(n + 0.5*(n - 1)))/12)
    return lattice('hexagonal', rows, columns) + cement(young, k*young)


def paperLike(kind, rows, columns, radius):
    return lattice(kind, rows, columns) + cement(planeStrain, shearRatio*planeStrain, radius)


free = ('; groups/beam/viscousDamping 0; groups/tip/viscousDamping 0; '
        'groups/tip/sharedForce (0 -0.1 0)')


# [N/m] bends the plate by more than half of its length
largeLoad = 40
large = f'; groups/tip/sharedForce (0 {-largeLoad} 0)'


def lengthOf(run):
    plate = readDictionary(os.path.join(run.path, 'system', 'plate'))
    return numberOf(plate['tipStart'])


def tip(run):
    """Time and displacement of the last column against y"""
    table = run.table('plate', 'groupMotion.dat')
    return table['Time'], table['tipCentreY'][0] - table['tipCentreY']


def isFree(run):
    return numberOf(entry(run.solid, 'groups/tip/viscousDamping')) == 0


def frequency(t, u):
    """Of the sine that fits best beside a mean: the first mode dominates"""
    def misfit(f):
        base = np.column_stack([np.ones_like(t), np.cos(2*np.pi*f*t), np.sin(2*np.pi*f*t)])
        rest = u - base@np.linalg.lstsq(base, u, rcond=None)[0]
        return rest@rest
    low, high = 8.0, 16.0
    for _ in range(6):
        tried = np.linspace(low, high, 81)
        best = tried[np.argmin([misfit(f) for f in tried])]
        step = tried[1] - tried[0]
        low, high = best - 2*step, best + 2*step
    return best


def analyse(run):
    t, u = tip(run)
    length = lengthOf(run)
    if isFree(run):
        f, theory = frequency(t, u), beamFrequency(L)
        own = beamFrequency(length)
        energy = run.table('energy', 'solidEnergies.dat')
        work = 0.1*u
        stored = energy['translation'] + energy['rotation'] + energy['bond']
        return [Quantity('first natural frequency [Hz]', f, theory, abs(f/theory - 1)),
                Quantity('first natural frequency, beam of the own length', f, own, abs(f/own - 1)),
                Quantity('energy - work of the load, largest, over the largest work',
                         float(abs(stored - work).max()/work.max()))]
    if 'large' in run.name:
        theory = elasticaTip(length, largeLoad)
        return [Quantity('tip displacement [mm], large', 1e3*u[-1], 1e3*theory,
                         abs(u[-1]/theory - 1))]
    settled = abs(u[-1] - np.interp(0.9*t[-1], t, u))/u[-1]
    theory, own = beamTip(L), beamTip(length)
    return [Quantity('tip displacement [mm]', 1e3*u[-1], 1e3*theory, abs(u[-1]/theory - 1)),
            Quantity('tip displacement [mm], beam of the own length', 1e3*u[-1], 1e3*own,
                     abs(u[-1]/own - 1)),
            Quantity('tip displacement [mm], the same with shear', 1e3*u[-1], 1e3*withShear(length),
                     abs(u[-1]/withShear(length) - 1)),
            Quantity("tip displacement [mm], the paper's program", 1e3*u[-1], 1e3*paper,
                     abs(u[-1]/paper - 1)),
            Quantity('change in the last tenth of the time', float(settled))]


def compare(runs, results):
    if not {'square8', 'square8-double'} <= set(runs):
        return []
    u = [tip(runs[n])[1][-1] for n in ('square8', 'square8-double')]
    return [Quantity('tip displacement, mixed against double', error=float(abs(u[0]/u[1] - 1)))]


def rowsOf(run):
    plate = readDictionary(os.path.join(run.path, 'system', 'plate'))
    height = np.sqrt(3)/2 if plate['packing'] == 'hexagonal' else 1
    return round(e/(numberOf(plate['spacing'])*height))


def plot(runs, path):
    fig, axes = plotting.figure(2, 2, width=5.5, height=3.2)
    for run in runs:
        t, u = tip(run)
        if 'large' in run.name:
            continue
        axis = axes[1] if isFree(run) else axes[0]
        axis.plot(t, 1e3*u, linewidth=1, label=run.name)
    axes[0].axhline(1e3*beamTip(L), color='#444444', linewidth=0.7, linestyle='--')
    axes[0].set(xlabel='t [s]', ylabel='tip displacement [mm]',
                title='critically damped; dashed: beam')
    t = np.linspace(0, 0.4, 400)
    axes[1].plot(t, 1e2*beamTip(L)*(1 - np.cos(2*np.pi*beamFrequency(L)*t)), color='#444444',
                 linewidth=0.7, linestyle='--', label='first mode of the beam')
    axes[1].set(xlabel='t [s]', ylabel='tip displacement [mm]', title='not damped, 0.1 N/m')
    for kind in ('square', 'hexagonal'):
        points = sorted((rowsOf(r), abs(tip(r)[1][-1]/withShear(lengthOf(r)) - 1)) for r in runs
                        if r.name.startswith(kind) and '-' not in r.name)
        if points:
            axes[2].loglog(*zip(*points), marker='o', label=kind)
    axes[2].set(xlabel='particles through the thickness', ylabel='error of the tip displacement',
                title='beam of the own length, with shear')
    shown = next((r for r in runs if r.name.startswith('hexagonal4')), runs[0])
    cloud = clouds.readCloud(shown.path, clouds.times(shown.path)[-1], ('radius',), 'solids')
    plotting.discs(axes[3], 1e3*cloud['positions'], 1e3*cloud['radius'])
    axes[3].set(xlim=(-2, 84), ylim=(-6, 8), aspect='equal', xlabel='x [mm]',
                title=f'{shown.name}, 1 N/m')
    for axis in axes[:3]:
        if axis.get_legend_handles_labels()[0]:
            plotting.named(axis)
    plotting.save(fig, path)


def variant(name, settings, duration=None):
    return Variant(name, ['-set', settings] + (['-endTime', str(duration)] if duration else []))


Study(
    scene='cantileverPlate',
    variants=[variant('square2', square(2, 33)), variant('square4', square(4, 64)),
              variant('square8', square(8, 128)), variant('square16', square(16, 255)),
              variant('square8-double', square(8, 128) + '; precision double'),
              variant('hexagonal4', hexagonal(4, 56)), variant('hexagonal8', hexagonal(8, 111)),
              variant('hexagonal12', hexagonal(12, 166)),
              variant('hexagonal4-counted', hexagonalCounted(4, 56)),
              variant('hexagonal8-counted', hexagonalCounted(8, 111)),
              variant('paper-square', paperLike('square', 4, 64, 'mean')),
              variant('paper-square-equivalent', paperLike('square', 4, 64, 'harmonic')),
              variant('paper-hexagonal', paperLike('hexagonal', 4, 56, 'mean')),
              variant('paper-hexagonal-equivalent', paperLike('hexagonal', 4, 56, 'harmonic')),
              variant('square4-free', square(4, 64) + free, 0.4),
              variant('square8-free', square(8, 128) + free, 0.4),
              variant('square4-large', square(4, 64) + large),
              variant('square8-large', square(8, 128) + large),
              variant('hexagonal8-free', hexagonalCounted(8, 111) + free, 0.4)],
    quick=[variant('square4-quick', square(4, 64))],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='tip displacement [mm]',
    orders=[('tip displacement [mm], the same with shear',
             ['hexagonal4', 'hexagonal8', 'hexagonal12'])],
).main(here)
