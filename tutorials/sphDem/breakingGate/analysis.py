# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break with a gate that breaks: where and when, what is carried away, and the energy of water
and gate together"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf, readDictionary
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def geometry(run, name):
    return numberOf(readDictionary(os.path.join(run.path, 'system', 'gate'))[name])


def bond(run, name):
    return numberOf(run.solid['bonds']['brittle'][name])


def brokenAt(run):
    """How far from the clamp those particles were at the start that have lost a bond, weighted by
    the bonds lost, in rows"""
    first = clouds.readCloud(run.path, clouds.times(run.path)[0], ('origId',), 'solids')
    last = clouds.readCloud(run.path, clouds.times(run.path)[-1], ('origId', 'brokenBonds'),
                            'solids')
    height = dict(zip(first['origId'].astype(int), first['positions'][:, 1]))
    rows = np.array([(height[int(i)] - geometry(run, 'gateTop'))/geometry(run, 'size')
                     for i in last['origId']])
    return np.repeat(rows, last['brokenBonds'].astype(int))


def balance(run):
    """Time, energy of water and solids together [J/m], and what moves: kinetic energy and that of
    bonds"""
    water, solid = (run.table('energy', 'energyBalance.dat'),
                    run.table('solidEnergy', 'solidEnergies.dat'))
    moving = water['kinetic'] + solid['translation'] + solid['rotation'] + solid['bond']
    return water['Time'], water['total'] + solid['total'], moving


def surfaceStress(run):
    """Of the root [Pa]: the outermost row of bonds lies at 3/4 of the half thickness where there
    are four"""
    rows = round((geometry(run, 'gateBack') - geometry(run, 'gateFace'))/geometry(run, 'size'))
    table = run.table('broken', 'brokenBonds.dat')
    return table['Time'], table['maxTension']/geometry(run, 'size')*rows/(rows - 1)


def firstBreak(run):
    table = run.table('broken', 'brokenBonds.dat')
    broken = table['broken'] > 0
    return table['Time'][broken][0] if broken.any() else None


def analyse(run):
    table, gate = run.table('broken', 'brokenBonds.dat'), run.table('gate', 'groupMotion.dat')
    q = [Quantity('broken bonds', computed=float(table['broken'][-1]))]
    if table['broken'][-1] > 0:
        rows = brokenAt(run)
        q += [Quantity('first break [s]', computed=float(firstBreak(run))),
              Quantity('broken bonds away from the root, share',
                       error=float(np.mean(np.abs(rows) > 1))),
              Quantity('pieces: nearest to the tank at the end [m]',
                       computed=float(gate['gateMinX'][-1]))]
    t, total, moving = balance(run)
    released = table['broken'][-1]*bond(run, 'tensileStrength')**2/(2*bond(
        run, 'E'))*geometry(run, 'size')**2 if table['broken'][-1] else 0
    q += [Quantity('energy gone / largest kinetic and bond energy',
                   computed=float((total[0] - total[-1])/moving.max())),
          Quantity('largest change of energy / the same',
                   error=float(np.abs(total - total[0]).max()/moving.max())),
          Quantity('stored in broken bonds, at most / the same',
                   computed=float(released/moving.max()))]
    return q


def compare(runs, results):
    """The gate that does not break says when the other one must"""
    if not {'pressureGradient', 'whole'} <= set(runs):
        return []
    t, stress = surfaceStress(runs['whole'])
    strength = bond(runs['pressureGradient'], 'tensileStrength')
    expected, seen = t[np.argmax(stress >= strength)], firstBreak(runs['pressureGradient'])
    return [Quantity('first break [s], whole gate at the strength', seen, expected,
                     abs(seen/expected - 1))]


def picture(axis, run, when):
    times = clouds.times(run.path)
    when = min(times, key=lambda t: abs(float(t) - when))
    f, s = (clouds.readCloud(run.path, when, ('U',)),
            clouds.readCloud(run.path, when, ('radius',), 'solids'))
    axis.scatter(1e3*f['positions'][:, 0], 1e3*f['positions'][:, 1],
                 c=np.linalg.norm(f['U'], axis=1), s=0.6, vmin=0, vmax=1.7)
    axis.scatter(1e3*s['positions'][:, 0], 1e3*s['positions'][:, 1], s=0.6, color='k')
    axis.set(aspect='equal', xlim=(-5, 420), ylim=(-5, 150), title=f'{float(when):g} s')


def plot(runs, path):
    run = runs[0]
    fig, axes = plotting.figure(2, 3, width=5.5, height=2.4)
    for axis, when in zip(axes, (0.05, 0.1, 0.2, 0.3)):
        picture(axis, run, when)
    for one in runs:
        t, stress = surfaceStress(one)
        axes[4].plot(t, 1e-6*stress, linewidth=0.8, label=one.name)
        t, total, moving = balance(one)
        axes[5].plot(t, (total - total[0])/moving.max(), linewidth=0.8, label=one.name)
    axes[4].axhline(1e-6*bond(run, 'tensileStrength'), color='k', linewidth=0.8, linestyle='--')
    axes[4].set(xlabel='t [s]', ylabel='stress of the surface [MPa]')
    axes[5].set(xlabel='t [s]', ylabel='change of energy / largest moving')
    plotting.named(axes[4])
    plotting.named(axes[5])
    plotting.save(fig, path)


# Nothing in water, bonds, contacts and walls that takes energy
lossless = ('viscosity none; XSPH none; antiClump none; densityDiffusion none; '
            'smoothingLength/model constant; walls/model stationary; walls/slip freeSlip; '
            'constant/solidProperties:bonds/brittle/dampingRatio 0; '
            'constant/solidProperties:pairs/rubber-rubber/restitution 1; '
            'constant/solidProperties:pairs/rubber-rubber/friction 0')

Study(
    scene='breakingGate',
    variants=[Variant('pressureGradient'),
              Variant('whole', ['-endTime', '0.15', '-set',
                                'constant/solidProperties:bonds/brittle/tensileStrength none']),
              Variant('lossless', ['-set', lossless])],
    quick=[Variant('quick', ['-endTime', '0.06'])],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='largest change of energy / the same',
).main(here)
