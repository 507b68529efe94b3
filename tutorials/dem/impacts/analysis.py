# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic impacts at any angle, slip or stick: energy may be lost by friction, and must never
grow"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
mass = 2500*4/3*np.pi*0.005**3
angles = range(0, 90, 10)


class Pair:
    """Two spheres: kinetic energy and momenta over time"""

    def __init__(self, table, i):
        self.energy, self.linear, self.angular = 0.0, 0.0, 0.0
        self.force = None
        for id_ in (2*i, 2*i + 1):
            x, u, w, force = (np.column_stack([table[f'{id_}{name}{axis}'] for axis in axes])
                              for name, axes in (('', 'XYZ'), ('U', 'xyz'), ('W', 'xyz'),
                                                 ('F', 'xyz')))
            inertia = 0.4*mass*0.005**2
            self.energy += 0.5*mass*np.sum(u**2, axis=1) + 0.5*inertia*np.sum(w**2, axis=1)
            self.linear += mass*u
            self.angular += mass*np.cross(x, u) + inertia*w
            self.touches = np.linalg.norm(force, axis=1) > 0

    @property
    def gain(self):
        """Energy after over energy before, less one"""
        return self.energy[-1]/self.energy[0] - 1


def pairs(run):
    table = run.table('bodies')
    return [Pair(table, i) for i in range(len(angles))]


def analyse(run):
    all_ = pairs(run)
    p = mass*1.0
    still = run.solid['pairs']['default']['friction'] == '0'
    out = [Quantity('largest gain of energy', computed=max(q.gain for q in all_)),
           Quantity('gain at 60 degrees', computed=all_[6].gain),
           Quantity('linear momentum, largest change / m v',
                    error=max(abs(q.linear).max() for q in all_)/p),
           Quantity('angular momentum, largest change / m v R',
                    error=max(abs(q.angular - q.angular[0]).max() for q in all_)/(p*0.005)),
           Quantity('still touching', computed=sum(bool(q.touches[-1]) for q in all_))]
    if still:
        out.append(Quantity('loss without friction', error=max(abs(q.gain) for q in all_)))
    return out


def plot(runs, path):
    fig, axes = plotting.figure(1)
    for run in runs:
        axes[0].plot(list(angles), [q.gain for q in pairs(run)], '.-', label=run.name)
    axes[0].set(xlabel='angle of incidence [degrees]', ylabel='energy after / before - 1')
    plotting.named(axes[0])
    plotting.save(fig, path)


def variant(name, dt, *sets):
    sets = (f'system/controlDict:deltaT {dt}', *sets)
    return Variant(name, [option for s in sets for option in ('-set', s)])


Study(
    scene='impacts',
    variants=[
        variant('hertz', '1e-7'),
        variant('hertz-fine', '2.5e-8'),
        variant('hertz-coarse', '1e-6'),
        variant('hertz-verlet', '1e-7', 'timeIntegration velocityVerlet'),
        variant('hertz-mu2', '1e-7', 'pairs/default/friction 2'),
        variant('hertz-smooth', '1e-7', 'pairs/default/friction 0'),
        variant('linear', '1e-7', 'contact/normal linear'),
        variant('linear-mu2', '1e-7', 'contact/normal linear', 'pairs/default/friction 2'),
        variant('incremental', '1e-7', 'contact/normal incremental'),
    ],
    quick=[variant('hertz', '1e-6')],
    analyse=analyse,
    plot=plot,
    headline='largest gain of energy',
).main(here)
