# SPDX-License-Identifier: GPL-3.0-or-later
"""A column of water with layers of cylinders in it collapses: who arrives when, and does anything overlap"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
radius = 0.005
shown = [0.1, 0.2, 0.3, 0.5]


def tank(run, entry):
    return numberOf(run.dictionary('system/tank')[entry])


def cylinders(run):
    """Times and positions of all cylinders"""
    names = clouds.times(run.path)
    return [float(n) for n in names], [clouds.readCloud(run.path, n, ('radius',), 'solids')['positions'][:, :2] for n in names]


def closest(x):
    """Smallest distance of two surfaces"""
    d = np.hypot(*(x[:, None, :] - x[None, :, :]).transpose(2, 0, 1)) - 2*radius
    return d[np.triu_indices(len(x), 1)].min()


def arrival(run):
    """When a cylinder first touches the far wall, between two written times; nan: not yet"""
    times, x = cylinders(run)
    limit = tank(run, 'tank') - tank(run, 'gap') - radius
    front = [p[:, 0].max() for p in x]
    for k in range(1, len(times)):
        if front[k] >= limit*(1 - 1e-3):
            return times[k]
    return float('nan')


def analyse(run):
    times, x = cylinders(run)
    energy = run.table('energy', 'energyBalance.dat')
    mean = x[-1].mean(axis=0)/tank(run, 'tank')
    result = [Quantity('end [s]', computed=times[-1]),
              Quantity('smallest distance of two surfaces / gap', computed=min(closest(p) for p in x)/tank(run, 'gap')),
              Quantity('cylinders', computed=len(x[-1])),
              Quantity('water lost', computed=1 - len(clouds.readCloud(run.path, clouds.times(run.path)[-1], ())['positions'])
                       /len(clouds.readCloud(run.path, clouds.times(run.path)[0], ())['positions'])),
              Quantity('x/L of the centre of mass at the end', computed=mean[0]),
              Quantity('y/L of the centre of mass at the end', computed=mean[1]),
              Quantity('arrival at the far wall [s]', computed=arrival(run))]
    return result


def snapshot(axis, run, moment):
    name = clouds.nearestTime(run.path, moment)
    water = clouds.readCloud(run.path, name, ('U',))
    solids = clouds.readCloud(run.path, name, ('radius',), 'solids')
    speed = np.hypot(*water['U'][:, :2].T)
    axis.scatter(100*water['positions'][:, 0], 100*water['positions'][:, 1], c=speed, s=0.3, cmap='Blues', vmin=-0.5, vmax=1.5)
    plotting.discs(axis, 100*solids['positions'], 100*solids['radius'])
    axis.set(xlim=(0, 100*tank(run, 'tank')), ylim=(0, 16), aspect='equal', title=f'{run.name}, {float(name):g} s')
    axis.grid(False)


def plot(runs, path):
    moments = [m for m in shown if any(float(t) >= m for t in clouds.times(runs[0].path))] or [0]
    fig, axes = plotting.figure(len(moments), len(runs), width=4.2, height=2.4)
    axes = np.atleast_1d(axes).ravel()
    for row, run in enumerate(runs):
        for column, moment in enumerate(moments):
            snapshot(axes[row*len(moments) + column], run, moment)
    plotting.save(fig, path)


def layers(n):
    """So many, at cells of 1 mm"""
    return f'system/tank:stackHeight {0.002 + 0.01 + (n - 1)*0.0103924 + 0.0005:.6g}'


Study(
    scene='damBreakCylinders',
    variants=[Variant('6-beta05'), Variant('6-beta1', ['-set', 'contactVelocity 1'])]
    + [Variant(f'{n}-beta{b}', ['-set', f'contactVelocity {v}; {layers(n)}']) for n in (8, 10, 12) for b, v in (('05', 0.5), ('1', 1))],
    quick=[Variant('6-quick', ['-endTime', '0.04'])],
    analyse=analyse,
    plot=plot,
    headline='arrival at the far wall [s]',
).main(here)
