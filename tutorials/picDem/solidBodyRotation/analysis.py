# SPDX-License-Identifier: GPL-3.0-or-later
"""A square patch of water that turns freely: angular momentum and energy, which nothing takes from
it"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
transfers = ('flip', 'flipPic', 'apic', 'pic')


def histories(run):
    """t, angular momentum and kinetic energy over those of the start, at the written times"""
    rows = []
    for name in clouds.times(run.path):
        c = clouds.readCloud(run.path, name, ['U'])
        x, u = c['positions'], c['U']
        rows.append((float(name), np.sum(x[:, 0]*u[:, 1] - x[:, 1]*u[:, 0]), 0.5*np.sum(u**2)))
    t, momentum, energy = np.array(rows).T
    return t, momentum/momentum[0], energy/energy[0]


def analyse(run):
    t, momentum, energy = histories(run)
    return [Quantity('angular momentum lost, 1 rad', computed=1 - np.interp(1, t, momentum)),
            Quantity('angular momentum lost', computed=1 - momentum[-1]),
            Quantity('kinetic energy lost', computed=1 - energy[-1])]


def plot(runs, path):
    fig, (left, right) = plotting.figure(2)
    for run in runs:
        t, momentum, energy = histories(run)
        left.plot(t, momentum, label=run.name)
        right.plot(t, energy, label=run.name)
    left.set(xlabel='$\\omega t$', ylabel='angular momentum / initial')
    right.set(xlabel='$\\omega t$', ylabel='kinetic energy / initial')
    for axis in (left, right):
        plotting.named(axis)
    plotting.save(fig, path)


def grid(n, transfer='flip'):
    return ['-spacing', f'{0.5/n:.10g}', '-set',
            f'system/tank:n {n}; system/tank:n4 {4*n}; transfer {transfer}']


Study(
    scene='picSolidBodyRotation',
    variants=[Variant(f'n24-{t}', grid(24, t))
              for t in transfers] + [Variant('n12-flip', grid(12)), Variant('n48-flip', grid(48))],
    quick=[Variant('n12-quick', grid(12) + ['-endTime', '1'])],
    analyse=analyse,
    plot=plot,
    headline='angular momentum lost',
    orders=[('angular momentum lost', ['n12-flip', 'n24-flip', 'n48-flip'])],
).main(here)
