# SPDX-License-Identifier: GPL-3.0-or-later
"""Water at rest over an oblique floor and about a pier: how fast it moves although it should not,
and its pressure"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81
depth = 0.25            # [m]
centre, radius, foot, slope = np.array([0.27, 0.19]), 0.041, 0.02, 0.3


def state(run):
    """Positions, p and the hydrostatic pressure of all particles at the last written time"""
    c = clouds.readCloud(run.path, clouds.times(run.path)[-1], ['p'])
    x = c['positions'][:, :2]
    return x, c['p'], run.density*g*(depth - x[:, 1])


def analyse(run):
    x, p, exact = state(run)
    e = run.table('energy', 'energyBalance.dat')
    below = x[:, 1] < depth - 2*run.spacing
    away = np.hypot(*(x - centre).T) - radius
    above = (x[:, 1] - foot - slope*x[:, 0])/np.hypot(1, slope)
    wave = np.sqrt(g*depth)
    return [Quantity('largest speed / sqrt(gH)', computed=e['maxSpeed'].max()/wave),
            Quantity('pressure L2', error=measures.relativeL2(p[below], exact[below])),
            Quantity('deepest particle in a solid / cell',
                     computed=float(max(0, -min(away.min(), above.min()))/(2*run.spacing)))]


def plot(runs, path):
    fig, (speeds, water) = plotting.figure(2)
    for run in runs:
        e = run.table('energy', 'energyBalance.dat')
        speeds.semilogy(e['Time'], np.maximum(e['maxSpeed'], 1e-18)/np.sqrt(g*depth),
                        label=run.name)
    speeds.axhline(1e-4, color='k', linewidth=0.8, linestyle='--', label='bound')
    speeds.set(xlabel='t [s]', ylabel='largest speed / sqrt(gH)')
    plotting.named(speeds)
    run = runs[-1]
    x, p, exact = state(run)
    points = water.scatter(x[:, 0], x[:, 1], c=p, s=1)
    fig.colorbar(points, ax=water, label='p [Pa]')
    water.set(aspect='equal', xlabel='x [m]', ylabel='y [m]', title=run.name)
    plotting.save(fig, path)


def tank(cells):
    h = 0.5/cells
    return (f'system/tank:nx {cells}; system/tank:ny {cells*3//4}; '
            f'system/tank:height {h*(cells*3//4):.10g}')


Study(
    scene='picObliqueFloor',
    variants=[Variant('n20', ['-spacing', '0.0125', '-set', tank(20)]),
              Variant('n40', ['-spacing', '0.00625', '-set', tank(40)]),
              Variant('n80', ['-spacing', '0.003125', '-set', tank(80)]),
              Variant('n40-mixed',
                      ['-spacing', '0.00625', '-set', tank(40) + '; precision mixed'])],
    quick=[Variant('n20-quick', ['-spacing', '0.0125', '-endTime', '1', '-set', tank(20)])],
    analyse=analyse,
    plot=plot,
    headline='pressure L2',
).main(here)
