# SPDX-License-Identifier: GPL-3.0-or-later
"""Rocks are dumped into water: do they come down, does anything overlap, is the water kept?"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def tank(run, entry):
    return numberOf(run.dictionary('system/tank')[entry])


def rocks(run, name):
    cloud = clouds.readCloud(run.path, name, ('radius', 'U'), 'solids')
    return cloud['positions'], cloud['radius'], cloud['U']


def closest(x, r):
    """Smallest distance of two surfaces"""
    d = np.sqrt(((x[:, None] - x[None])**2).sum(axis=2)) - r[:, None] - r[None]
    return d[np.triu_indices(len(x), 1)].min()


def water(run, name):
    """Particles"""
    return len(clouds.readCloud(run.path, name, ())['positions'])


def analyse(run):
    names = clouds.times(run.path)
    x, r, u = rocks(run, names[-1])
    lost = 1 - water(run, names[-1])/water(run, names[1])
    return [Quantity('end [s]', computed=float(names[-1])),
            Quantity('smallest distance of two surfaces [m]', computed=float(min(closest(*rocks(run, n)[:2]) for n in names))),
            Quantity('lowest rock above the floor [m]', computed=float((x[:, 1] - r).min())),
            Quantity('mean height of the rocks [m]', computed=float(x[:, 1].mean())),
            Quantity('fastest rock [m/s]', computed=float(np.sqrt((u**2).sum(axis=1)).max())),
            Quantity('rocks', computed=len(x)),
            Quantity('water lost', computed=lost)]


def plot(runs, path):
    fig, axes = plotting.figure(len(runs))
    for run, axis in zip(runs, np.atleast_1d(axes)):
        for name in clouds.times(run.path):
            x, r, u = rocks(run, name)
            axis.plot(float(name) + 0*r, x[:, 1], '.', color='C0', markersize=3)
        axis.axhline(tank(run, 'waterHeight'), color='C1', linewidth=0.8)
        axis.set(xlabel='t [s]', ylabel='heights of the rocks [m]', title=run.name)
    plotting.save(fig, path)


coarse = 'system/tank:nx 48; system/tank:ny 30; system/tank:nz 24; system/tank:spacing 0.005'
Study(
    scene='picRockDumping',
    variants=[Variant('rocks')],
    quick=[Variant('rocks-quick', ['-endTime', '0.12', '-set', coarse])],
    analyse=analyse,
    plot=plot,
    headline='water lost',
).main(here)
