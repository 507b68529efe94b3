# SPDX-License-Identifier: GPL-3.0-or-later
"""A dam break carries crates and logs against a column: is anything lost, does a body pass a wall,
does energy fall?"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def tank(run, entry):
    return numberOf(run.dictionary('system/tank')[entry])


def column(run):
    """Its lower and upper corner"""
    box = run.dictionary('constant/geometry')['column']
    return [np.array([float(v) for v in str(box[end]).strip('()').split()])
            for end in ('min', 'max')]


def balls(run, name):
    """In the bodies: where they are, how large, of which body"""
    cloud = clouds.readCloud(run.path, name, ('radius',), 'solids')
    return (cloud['positions'], cloud['radius'],
            clouds.readField(os.path.join(run.path, name, 'lagrangian', 'solids', 'clump')))


def nearest(run, name):
    """Distance of the balls' surfaces to walls and column; negative: in them"""
    x, r, body = balls(run, name)
    low, high = column(run)
    toWalls = np.minimum(x, np.array([tank(run, e) for e in ('length', 'width', 'height')]) - x)
    toWalls[:, 2] = x[:, 2]                     # open above
    toColumn = np.linalg.norm(np.maximum(np.maximum(low - x, x - high), 0), axis=1)
    return (np.minimum(toWalls.min(axis=1), toColumn) - r).min()


def water(run, name):
    """Particles"""
    return len(clouds.readCloud(run.path, name, ())['positions'])


def force(run):
    """Of water and bodies on the column along the street, over time"""
    t = run.table('column', 'force.dat')
    return t['Time'], t['total_x']


def analyse(run):
    names = clouds.times(run.path)
    energy = run.table('energy', 'energyBalance.dat')
    total = energy['total']
    t, f = force(run)
    x, r, body = balls(run, names[-1])
    behind = sum(x[body == b, 0].mean() > column(run)[1][0] for b in np.unique(body))
    return [Quantity('end [s]', computed=float(names[-1])),
            Quantity('water lost', computed=1 - water(run, names[-1])/water(run, names[0])),
            Quantity('bodies', computed=len(np.unique(body))),
            Quantity('nearest wall or column to a body [m]',
                     computed=float(min(nearest(run, n) for n in names))),
            Quantity('growth of the energy / first', computed=float(np.diff(total).max()/total[0])),
            Quantity('largest force on the column, 0.02 s mean [N]',
                     computed=float(np.convolve(f, [0.5, 0.5], 'valid').max())),
            Quantity('bodies past the column', computed=int(behind))]


def plot(runs, path):
    fig, axes = plotting.figure(2)
    for run in runs:
        axes[0].plot(*force(run), linewidth=1, label=run.name)
        motion = run.table('debris', 'groupMotion.dat')
        axes[1].plot(motion['Time'], motion['freeCentreX'], label=run.name)
    axes[0].set(xlabel='t [s]', ylabel='force on the column [N]')
    axes[1].set(xlabel='t [s]', ylabel='centre of the debris, x [m]')
    plotting.named(axes[0])
    plotting.save(fig, path)


def cells(size):
    """The tank in cells of this size"""
    counts = '; '.join(f'system/tank:{n} {round(length/size)}'
                       for n, length in (('nx', 4), ('ny', 1), ('nz', 2)))
    return f'{counts}; system/tank:spacing {size/2:.10g}'


Study(
    scene='picDebris',
    variants=[Variant('debris')],
    quick=[Variant('debris-quick', ['-endTime', '0.1', '-set', cells(0.04)])],
    analyse=analyse,
    plot=plot,
    headline='water lost',
).main(here)
