# SPDX-License-Identifier: GPL-3.0-or-later
"""Sloshing in a closed tank for 30 periods: volume, and energy, which may only decay"""
import os
import re

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))


def volumes(run):
    """t and the error of the volume that each line of the log gives"""
    rows, t = [], None
    with open(os.path.join(run.path, 'log.riprapFoam')) as log:
        for line in log:
            if line.startswith('Time = '):
                t = float(line.split()[-1])
            found = re.match(r'Volume = \S+, error = (\S+),', line)
            if found and t is not None:
                rows.append((t, float(found.group(1))))
    return np.array(rows).T


def wave(run):
    """t and the height at the left wall less that at the right one, over twice the amplitude"""
    table = run.table('gauges', 'waterLevel.dat')
    level = stacked(table, 'level')
    return (table['Time'],
            (level[:, 0] - level[:, 1])/(2*numberOf(run.dictionary('system/tank')['amplitude'])))


def mechanical(run):
    """t and the energy above that of the flat pool, over that of the start"""
    e = run.table('energy', 'energyBalance.dat')
    tank = {k: numberOf(v) for k, v in run.dictionary('system/tank').items() if k != 'FoamFile'}
    start = 0.25*run.density*9.81*tank['amplitude']**2*tank['width']
    total = e['kinetic'] + e['potential']
    return e['Time'], 1 + (total - total[0])/start


def analyse(run):
    t, error = volumes(run)
    te, energy = mechanical(run)
    early = abs(error[t <= 10]).max()
    return [Quantity('largest error of the volume, to 10 s', error=early),
            Quantity('largest error of the volume', error=abs(error).max()),
            Quantity('largest energy over that of the start', computed=energy.max()),
            Quantity('energy at the end', computed=energy[-1])]


def plot(runs, path):
    fig, (level, volume, energy) = plotting.figure(3)
    for run in runs:
        level.plot(*wave(run), linewidth=0.8, label=run.name)
        t, error = volumes(run)
        volume.semilogy(t, np.maximum(abs(error), 1e-16), label=run.name)
        energy.plot(*mechanical(run), label=run.name)
    level.set(xlabel='t [s]', ylabel='first mode at the walls / amplitude')
    volume.set(xlabel='t [s]', ylabel='relative error of the volume')
    energy.set(xlabel='t [s]', ylabel='wave energy / initial')
    for axis in (level, volume, energy):
        plotting.named(axis)
    plotting.save(fig, path)


def grid(n, more=''):
    return ['-spacing', f'{0.5/n:.10g}', '-set',
            f'system/tank:nx {n}; system/tank:ny {7*n//10}{more}']


Study(
    scene='picSloshing',
    variants=[Variant('n20', grid(20)), Variant('n40', grid(40)), Variant('n80', grid(80)),
              Variant('n40-apic', grid(40, '; transfer apic'))],
    quick=[Variant('n20-quick', grid(20) + ['-endTime', '5'])],
    analyse=analyse,
    plot=plot,
    headline='largest error of the volume',
).main(here)
