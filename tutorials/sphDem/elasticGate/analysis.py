# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break with an elastic gate: the gate's end against two digitisations of the experiment"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
digitisations = ('chrono', 'pysph')
# of the experiment, mean of the two digitisations
peakX, peakTimeX, peakY = 0.0462, 0.161, 0.0171


def reference(name):
    return np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1, unpack=True)


def end(run):
    """Time, and how far the gate's end has moved outwards and up: mean of its lowest row [m]"""
    table = run.table('end', 'particleDisplacement.dat')
    mean = [np.mean([table[c] for c in table if c.endswith(axis)], axis=0) for axis in ('Dx', 'Dy')]
    return table['Time'], mean[0], mean[1]


def peak(t, u, until=0.25):
    """Value and time of the largest displacement of the opening phase"""
    early = t <= until
    k = np.argmax(u[early])
    return u[early][k], t[early][k]


def closing(t, u, axis):
    """rms difference from the experiment after its peak, over its peak"""
    if t[-1] < 0.39:
        return None
    differences = []
    for which in digitisations:
        when, value = reference(f'exp_gate_end_{axis}_{which}')
        late = (when > peakTimeX) & (when <= t[-1])
        differences.append(np.interp(when[late], t, u) - value[late])
    d = np.concatenate(differences)
    return float(np.sqrt(np.mean(d**2))/(peakX if axis == 'x' else peakY))


def noise(t, u):
    """rms of what a parabola through each 40 ms does not follow, over the peak"""
    rest = []
    for begin in np.arange(0.02, t[-1] - 0.039, 0.04):
        part = (t >= begin) & (t < begin + 0.04)
        if part.sum() > 5:
            rest.append(u[part] - np.polyval(np.polyfit(t[part] - begin, u[part], 2), t[part] - begin))
    return float(np.sqrt(np.mean(np.concatenate(rest)**2))/abs(u).max()) if rest else None


def analyse(run):
    t, x, y = end(run)
    bestX, timeX = peak(t, x)
    bestY, timeY = peak(t, y)
    q = [Quantity('largest x of the end [mm]', 1e3*bestX, 1e3*peakX, abs(bestX/peakX - 1)),
         Quantity('its time [s]', timeX, peakTimeX, abs(timeX/peakTimeX - 1)),
         Quantity('largest y of the end [mm]', 1e3*bestY, 1e3*peakY, abs(bestY/peakY - 1)),
         Quantity('its time, y [s]', timeY, peakTimeX, abs(timeY/peakTimeX - 1)),
         Quantity('noise of x', computed=noise(t, x))]
    for axis, u in (('x', x), ('y', y)):
        q.append(Quantity(f'closing phase, rms of {axis} / peak', error=closing(t, u, axis)))
    level = run.table('level', 'waterLevel.dat')
    for k, where in ((0, 'at the gate'), (1, '5 cm behind')):
        q.append(Quantity(f'water level {where} at the end [mm]', computed=1e3*level[f'level{k}'][-1]))
    return q


def drawExperiment(axis, which):
    for name, marker in zip(digitisations, 'os'):
        t, u = reference(f'exp_gate_end_{which}_{name}')
        axis.plot(t, 1e3*u, marker, color='k', markersize=3, fillstyle='none', label=f'experiment ({name})')
    t, u = reference(f'sph_antoci_gate_end_{which}_chrono')
    axis.plot(t, 1e3*u, '--', color='#888888', linewidth=0.8, label='SPH, Antoci et al. 2007')


def plot(runs, path):
    fig, axes = plotting.figure(2, 2, width=5.5, height=3.4)
    for k, which in enumerate('xy'):
        drawExperiment(axes[k], which)
        for run in runs:
            t, x, y = end(run)
            axes[k].plot(t, 1e3*(x if which == 'x' else y), linewidth=0.9, label=run.name)
        axes[k].set(xlabel='t [s]', ylabel=f'{which} of the end [mm]')
        axes[k].legend(fontsize=5)
    for run in runs:
        level = run.table('level', 'waterLevel.dat')
        axes[2].plot(level['Time'], 1e3*level['level0'], linewidth=0.8, label=f'{run.name}, at the gate')
        axes[2].plot(level['Time'], 1e3*level['level1'], linewidth=0.8, linestyle=':')
    axes[2].set(xlabel='t [s]', ylabel='water level [mm]; dotted: 5 cm behind')
    run = runs[0]
    times = clouds.times(run.path)
    when = min(times, key=lambda t: abs(float(t) - 0.16))
    f, s = clouds.readCloud(run.path, when, ('U',)), clouds.readCloud(run.path, when, ('radius',), 'solids')
    dots = axes[3].scatter(1e3*f['positions'][:, 0], 1e3*f['positions'][:, 1], c=np.linalg.norm(f['U'], axis=1), s=0.8)
    axes[3].scatter(1e3*s['positions'][:, 0], 1e3*s['positions'][:, 1], s=0.8, color='k')
    fig.colorbar(dots, ax=axes[3], label='|U| [m/s]')
    axes[3].set(aspect='equal', xlim=(-5, 260), ylim=(-5, 150), xlabel='x [mm]', title=f'{run.name}, {float(when):g} s')
    plotting.save(fig, path)


solid = 'constant/solidProperties:'


def rubber(E, nu, plane=False):
    """Bending stiffness E e^3/12 as a beam, or E/(1 - nu^2) of plane strain"""
    return f'{solid}bonds/rubber/E {E/(1 - nu**2) if plane else E:.8g}; {solid}bonds/rubber/G {E/(1 + nu):.8g}'


def damped(alpha):
    return f'{solid}groups/gate/localDamping {alpha}; {solid}groups/sides/localDamping {alpha}'


held = f'{solid}groups/sides/fixed all'
attempt1 = f'coupling stationary; {rubber(12e6, 0.33)}; {damped(0.157)}; {held}'
attempt2 = f'coupling stationary; {rubber(12e6, 0.33)}; {damped(0.0134)}; {held}; viscosity none; XSPH none'


def variant(name, sets=''):
    return Variant(name, ['-set', sets] if sets else [])


Study(
    scene='elasticGate',
    variants=[variant('pressureGradient'),
              variant('stationary', 'coupling stationary'),
              variant('pressureApproximation', 'coupling pressureApproximation'),
              variant('extrapolated', 'coupling extrapolated'),
              variant('attempt1', attempt1),
              variant('attempt2', attempt2)],
    quick=[Variant('quick', ['-endTime', '0.1'])],
    analyse=analyse,
    plot=plot,
    headline='largest x of the end [mm]',
).main(here)
