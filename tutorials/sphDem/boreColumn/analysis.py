# SPDX-License-Identifier: GPL-3.0-or-later
"""A bore hits a tall column: net force against Yeh & Petroff's experiment"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
window = 0.02           # [s] moving average of both forces
arrivalLevel = 8        # [N] the bore has come: a quarter of the peak
# [s] after the arrival, over which the mean is taken: until the wave from the end wall comes back
steady = 0.6


class Force:
    """Averaged net force along the flume from the arrival on"""

    def __init__(self, t, force):
        grid = np.arange(t[0], t[-1], 0.001)
        self.t, self.raw = grid, np.interp(grid, t, force)
        self.force = measures.movingAverage(grid, self.raw, window)
        self.arrival = measures.crossing(grid, self.force, arrivalLevel)
        if self.arrival is None:
            raise ValueError('the bore has not come')
        self.fromArrival = grid - self.arrival

    def after(self, end):
        return (self.fromArrival >= 0) & (self.fromArrival <= end)

    def peak(self):
        return float(self.force[self.after(0.2)].max())

    def mean(self):
        return float(self.force[self.after(steady)].mean())


def measured(name):
    data = np.loadtxt(os.path.join(here, 'reference', f'yehPetroff_{name}.csv'), delimiter=',',
                      skiprows=1)
    times = np.unique(data[:, 0])
    return times, np.array([data[data[:, 0] == t, 1].mean() for t in times])


def computed(run):
    table = run.table('forces', 'wallForce.dat')
    return Force(table['Time'], table['columnFx'])


def analyse(run):
    f, e = computed(run), Force(*measured('force'))
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    result = [Quantity('peak of the force [N]', f.peak(), e.peak(), abs(f.peak()/e.peak() - 1)),
              Quantity('peak, not averaged [N]', computed=float(f.raw[f.after(0.2)].max())),
              Quantity('arrival after the gate [s]', f.arrival, e.arrival)]
    if f.fromArrival[-1] >= steady:
        result.append(Quantity('mean over 0.6 s [N]', f.mean(), e.mean(),
                               abs(f.mean()/e.mean() - 1)))
    t, u = measured('velocity')
    probe = run.table('velocity', 'U.dat')
    came = measures.crossing(probe['Time'], probe['Ux0'], 0.5)
    if came is not None:
        at = (t > 0.05) & (t < min(0.5, probe['Time'][-1] - came))
        result.append(Quantity('velocity ahead of the column, mean [m/s]',
                               float(np.mean(np.interp(came + t[at], probe['Time'], probe['Ux0']))),
                               float(u[at].mean())))
    return result + [Quantity('particles lost', error=first - last)]


def plot(runs, path):
    fig, (force, velocity) = plotting.figure(2, width=5)
    e = Force(*measured('force'))
    plotting.measured(force, *(lambda t, f: (t - e.arrival, f))(*measured('force')),
                      'Yeh & Petroff')
    plotting.measured(velocity, *measured('velocity'), 'Yeh & Petroff')
    for run in runs:
        f = computed(run)
        force.plot(f.fromArrival, f.force, linewidth=1, label=run.name)
        probe = run.table('velocity', 'U.dat')
        came = measures.crossing(probe['Time'], probe['Ux0'], 0.5)
        if came is not None:
            velocity.plot(probe['Time'] - came, probe['Ux0'], linewidth=1, label=run.name)
    force.set(xlabel='time from the arrival [s]', ylabel='net force on the column [N]',
              xlim=(-0.1, 1.5), ylim=(-20, 60))
    velocity.set(xlabel='time from the arrival [s]', ylabel='velocity ahead of the column [m/s]',
                 xlim=(-0.1, 1))
    for axis in (force, velocity):
        plotting.named(axis)
    plotting.save(fig, path)


coarse = ('system/tank:width 0.6; system/tank:bed 0.03; constant/geometry:column/min (0.9 0 0.24); '
          'constant/geometry:column/max (1.02 0.8 0.36)')

Study(
    scene='boreColumn',
    variants=[Variant('dp10', large=True), Variant('dp5', ['-spacing', '0.005'], large=True),
              Variant('dp20', ['-spacing', '0.02', '-set', coarse.replace('0.03', '0.02')])],
    quick=[Variant('quick', ['-spacing', '0.04', '-endTime', '0.5', '-set',
                             coarse.replace('0.03', '0.04')])],
    analyse=analyse,
    plot=plot,
    headline='mean over 0.6 s [N]',
    orders=[('mean over 0.6 s [N]', ['dp20', 'dp10', 'dp5'])],
).main(here)
