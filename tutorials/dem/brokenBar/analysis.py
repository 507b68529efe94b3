# SPDX-License-Identifier: GPL-3.0-or-later
"""A bonded bar that is struck and breaks: energy never grows, pieces are counted by the bonds that
hold"""
import os
import re

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def labels(path):
    """A labelList in ASCII: (...) or n{value}"""
    text = open(path).read().split('//', 1)[1]
    same = re.search(r'(\d+)\{(-?\d+)\}', text)
    if same:
        return np.full(int(same.group(1)), int(same.group(2)))
    return np.array(re.search(r'\(([^()]*)\)', text).group(1).split(), int)


def pieces(run, time):
    """Sizes of what hangs together by whole bonds at a written time, the largest first"""
    folder = os.path.join(run.path, time, 'uniform', 'lagrangian', 'solids', 'bonds')
    a, b, broken = (labels(os.path.join(folder, name)) for name in ('a', 'b', 'broken'))
    root = {i: i for i in np.concatenate([a, b])}

    def find(i):
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i
    for i, j in zip(a[broken == 0], b[broken == 0]):
        root[find(i)] = find(j)
    return sorted(np.unique([find(i) for i in root], return_counts=True)[1], reverse=True)


def analyse(run):
    energy, bonds = run.table('energy', 'solidEnergies.dat'), run.table('broken', 'brokenBonds.dat')
    total = energy['total']
    sizes = pieces(run, clouds.times(run.path)[-1])
    return [Quantity('largest rise of energy / start', error=float(np.diff(total).max()/total[0])),
            Quantity('energy lost / start', computed=float(1 - total[-1]/total[0])),
            Quantity('broken bonds', computed=float(bonds['broken'][-1])),
            Quantity('pieces of more than five disks', computed=float(sum(s > 5 for s in sizes))),
            Quantity('difference of the two largest pieces',
                     computed=float(sizes[0] - sizes[1]) if len(sizes) > 1 else None)]


def plot(runs, path):
    fig, (energy, bonds) = plotting.figure(2)
    for run in runs:
        e, b = run.table('energy', 'solidEnergies.dat'), run.table('broken', 'brokenBonds.dat')
        energy.plot(e['Time']*1e3, e['total']/e['total'][0], label=run.name)
        bonds.plot(b['Time']*1e3, b['broken'], label=run.name)
    energy.set(xlabel='t [ms]', ylabel='energy / start')
    bonds.set(xlabel='t [ms]', ylabel='broken bonds')
    for axis in (energy, bonds):
        plotting.named(axis)
    plotting.save(fig, path)


def variant(name, *sets):
    return Variant(name, [option for s in sets for option in ('-set', s)])


Study(
    scene='brokenBar',
    variants=[variant('bar'), variant('bar-fine', 'stepFraction 0.05'),
              variant('bar-verlet', 'timeIntegration velocityVerlet'),
              variant('bar-mixed', 'precision mixed'),
              variant('bar-slow', 'system/blow:speed 0.1')],
    quick=[variant('bar-quick', 'stepFraction 0.2')],
    analyse=analyse,
    plot=plot,
    headline='largest rise of energy / start',
).main(here)
