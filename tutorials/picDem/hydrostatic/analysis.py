# SPDX-License-Identifier: GPL-3.0-or-later
"""A tank at rest on a grid: how fast it moves although it should not, and its pressure"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81


def depth(run):
    return numberOf(run.dictionary('system/tank')['depth'])


def particles(run):
    """y, p and the hydrostatic pressure of all particles at the last written time"""
    c = clouds.readCloud(run.path, clouds.times(run.path)[-1], ['p'])
    y = c['positions'][:, 1]
    return y, c['p'], run.density*g*(depth(run) - y)


def analyse(run):
    y, p, exact = particles(run)
    e = run.table('energy', 'energyBalance.dat')
    below = y < depth(run) - 2*run.spacing      # a particle at the surface may lie above it
    return [Quantity('largest speed [m/s]', computed=e['maxSpeed'].max()),
            Quantity('largest speed in the second half [m/s]',
                     computed=e['maxSpeed'][len(e['maxSpeed'])//2:].max()),
            Quantity('pressure L2', error=measures.relativeL2(p[below], exact[below]))]


def plot(runs, path):
    fig, (speeds,) = plotting.figure(1)
    for run in runs:
        e = run.table('energy', 'energyBalance.dat')
        speeds.semilogy(e['Time'], np.maximum(e['maxSpeed'], 1e-18), label=run.name)
    speeds.axhline(1e-6, color='k', linewidth=0.8, linestyle='--', label='bound')
    speeds.set(xlabel='t [s]', ylabel='largest speed of a particle [m/s]')
    plotting.named(speeds)
    plotting.save(fig, path)


def tank(cells, depth):
    """A tank 40 or so cells wide; the depth in cells need not be whole"""
    h = 0.5/cells
    return (f'system/tank:nx {cells}; system/tank:ny {cells*3//4}; '
            f'system/tank:height {h*(cells*3//4):.10g}; system/tank:depth {h*depth:.10g}')


Study(
    scene='picHydrostatic',
    variants=[Variant('n20', ['-spacing', '0.0125', '-set', tank(20, 10)]),
              Variant('n40', ['-spacing', '0.00625', '-set', tank(40, 20)]),
              Variant('n80', ['-spacing', '0.003125', '-set', tank(80, 40)]),
              # the surface at the middle of cells, and at a quarter of one
              Variant('n40-half', ['-spacing', '0.00625', '-set', tank(40, 19.5)]),
              Variant('n40-quarter', ['-spacing', '0.003125', '-set', tank(40, 20.25)]),
              Variant('n40-apic',
                      ['-spacing', '0.00625', '-set', tank(40, 20) + '; transfer apic']),
              Variant('n40-mixed',
                      ['-spacing', '0.00625', '-set', tank(40, 20.5) + '; precision mixed'])],
    quick=[Variant('n20-quick', ['-spacing', '0.0125', '-endTime', '1', '-set', tank(20, 10.5)])],
    analyse=analyse,
    plot=plot,
    headline='pressure L2',
).main(here)
