# SPDX-License-Identifier: GPL-3.0-or-later
"""Cylinders fall through a pipe into a tank: levels, flow in the mouth, when all are out"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
radius, mouth, wall = 0.005, 0.04, 0.001
names = ('tank', 'waterHeight', 'pipeLeft', 'pipeRight')
# [s]: fall, reversed flow, what is left; as the paper's Figures 12 and 13
pictures, close = [0.2, 0.4, 0.6, 0.8], [0.5]


class Tank:
    def __init__(self, run):
        entries = run.dictionary('system/tank')
        self.length, self.depth, self.left, self.right = (numberOf(entries[n]) for n in names)


def read(run, name):
    """Water, its velocity, centres of the cylinders"""
    water = clouds.readCloud(run.path, name, ('U',))
    return (water['positions'][:, :2], water['U'][:, :2],
            clouds.readCloud(run.path, name, ('radius',), 'solids')['positions'][:, :2])


def moment(x, u, q, tank, particle):
    """Level in the pipe and beside it, velocity in its mouth, cylinders above the mouth, lowest
    cylinder"""
    inside = (x[:, 0] > tank.left) & (x[:, 0] < tank.right) & (x[:, 1] > mouth)
    beside = ((x[:, 0] < tank.left - wall) | (x[:, 0] > tank.right + wall)) & (x[:, 1] > mouth)
    above = (q[:, 0] > tank.left) & (q[:, 0] < tank.right) & (q[:, 1] > mouth)
    wet = above & (q[:, 1] < mouth + inside.sum()*particle/(tank.right - tank.left))
    level = mouth + (inside.sum()*particle + wet.sum()*np.pi*radius**2)/(tank.right - tank.left)
    outside = mouth + beside.sum()*particle/(tank.length - (tank.right - tank.left) - 2*wall)
    gate = inside & (x[:, 1] < mouth + 2*radius)
    return (level, outside, u[gate, 1].mean() if gate.any() else 0.0,
            (q[:, 1] + radius > mouth).sum(), q[:, 1].min())


class Moments:
    """Of each written time but the first, whose particles are what the run seeded its own by"""

    def __init__(self, run):
        written = clouds.times(run.path)[1:]
        tank, rows, particle = Tank(run), [], None
        for name in written:
            x, u, q = read(run, name)
            particle = particle or (tank.length*tank.depth - 2*wall*(tank.depth - mouth))/len(x)
            rows.append((*moment(x, u, q, tank, particle), len(x)))
        self.t = np.array([float(n) for n in written])
        self.level, self.outside, self.flow, self.above, self.lowest, self.water = np.array(rows).T


def firstTime(t, true):
    return float(t[np.argmax(true)]) if true.any() else float('nan')


def quantities(m):
    return [Quantity('end [s]', computed=float(m.t[-1])),
            Quantity('first cylinder below the mouth [s]',
                     computed=firstTime(m.t, m.lowest + radius < mouth)),
            Quantity('half of the cylinders below the mouth [s]',
                     computed=firstTime(m.t, m.above <= 16)),
            Quantity('all cylinders below the mouth [s]', computed=firstTime(m.t, m.above == 0)),
            Quantity('cylinders in pipe and funnel at the end', computed=float(m.above[-1])),
            Quantity('largest difference of level, outside less inside [m]',
                     computed=float((m.outside - m.level).max())),
            Quantity('fastest flow down in the mouth [m/s]', computed=float(-m.flow.min())),
            Quantity('fastest flow up in the mouth [m/s]', computed=float(m.flow.max())),
            Quantity('time with flow up [s]', computed=float((m.flow > 0.02).sum()*np.diff(
                m.t).mean()) if len(m.t) > 1 else 0.0),
            Quantity('water lost', computed=float(1 - m.water[-1]/m.water[0]))]


def analyse(run):
    return quantities(Moments(run))


def compare(runs, results):
    value = {v: {q.name: q.computed for q in found} for v, found in results.items()}
    if not {'continuous', 'perforated'} <= set(value):
        return []
    return [Quantity(f'{name}, continuous less perforated',
                     computed=value['continuous'][name] - value['perforated'][name])
            for name in ('half of the cylinders below the mouth [s]', 'time with flow up [s]')]


def walls(axis, tank):
    for x in (tank.left, tank.right):
        axis.plot([100*x, 100*x], [100*mouth, 14], color='black', linewidth=0.8)
    for x, way in ((tank.left, -1), (tank.right, 1)):
        axis.plot([100*x, 100*x + 7.1*way], [14, 21.1], color='black', linewidth=0.8)


def picture(axis, x, u, q, tank, title, arrows=False):
    """All of it coloured by the vertical velocity; arrows: about the mouth"""
    axis.scatter(100*x[:, 0], 100*x[:, 1], c=u[:, 1], s=0.2 if not arrows else 1.5, cmap='RdBu',
                 vmin=-0.5, vmax=0.5, linewidths=0)
    plotting.discs(axis, 100*q, 100*radius + 0*q[:, 0])
    walls(axis, tank)
    axis.set(xlim=(0, 100*tank.length), ylim=(0, 22), aspect='equal', title=title)
    axis.grid(False)
    if arrows:
        near = np.flatnonzero((x[:, 1] < 0.1) & (np.abs(x[:, 0] - 0.5*tank.length) < 0.06))
        shown = np.random.default_rng(1).permutation(near)[:500]
        axis.quiver(*100*x[shown].T, *u[shown].T, scale=8, width=0.003)
        axis.set(xlim=(9.6, 21.6), ylim=(0, 10))


def curves(axis, m, title):
    axis.plot(m.t, 100*m.level, label='level inside [cm]')
    axis.plot(m.t, 100*m.outside, label='level outside [cm]')
    axis.plot(m.t, 10*m.flow, label='flow in the mouth [dm/s]')
    axis.plot(m.t, m.above, label='cylinders above the mouth')
    plotting.named(axis)
    axis.set(xlabel='t [s]', title=title)


def draw(rows, path):
    """rows: (name, tank, moments, t -> particles)"""
    count = max(1, len(pictures) + len(close) + 1)
    fig, axes = plotting.figure(count, len(rows), width=3.6, height=2.8)
    axes = np.atleast_1d(axes).ravel()
    for row, (name, tank, m, at) in enumerate(rows):
        own = axes[row*count:(row + 1)*count]
        for k, (t, arrows) in enumerate([(t, False) for t in pictures]
                                        + [(t, True) for t in close]):
            if t <= m.t[-1] + 1e-9:
                picture(own[k], *at(t), tank, f'{name}, {t:g} s', arrows)
            else:
                own[k].set_visible(False)
        curves(own[-1], m, name)
    plotting.save(fig, path)


def plot(runs, path):
    draw([(r.name, Tank(r), Moments(r), lambda t, r=r: read(r, clouds.nearestTime(r.path, t)))
          for r in runs], path)


holes = ['-set', '; '.join(f'constant/geometry:{side}{k}/span (0.001 0.019 3)'
                           for side in ('left', 'right') for k in range(1, 6))]
Study(
    scene='fallPipe',
    variants=[Variant('continuous'), Variant('perforated', holes)],
    quick=[Variant('perforated-quick', ['-endTime', '0.04'] + holes)],
    analyse=analyse,
    compare=compare,
    plot=plot,
    headline='half of the cylinders below the mouth [s]',
).main(here)
