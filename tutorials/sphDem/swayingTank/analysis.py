# SPDX-License-Identifier: GPL-3.0-or-later
"""A tank that sways: level and pressure of the walls against linear theory, until 8 s"""
import os
import sys

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
import linearTheory  # noqa: E402
from riprap import clouds, measures, plotting  # noqa: E402
from riprap.bounds import Quantity  # noqa: E402
from riprap.dictionaries import numberOf  # noqa: E402
from riprap.study import Study, Variant  # noqa: E402
from riprap.tables import stacked  # noqa: E402

rho = 1000


class Sides:
    """Half differences of left and right, of the run and of theory: level [m], pressure [Pa]"""

    def __init__(self, run):
        tank = {k: numberOf(v) for k, v in run.dictionary('system/tank').items() if k != 'FoamFile'}
        sway = (
            linearTheory.Sway(*(tank[k] for k in ('amplitude', 'ratio', 'left', 'right', 'depth'))))
        gauges, sensors = run.table('gauges', 'waterLevel.dat'), run.table('sensors', 'p.dat')
        self.t = gauges['Time']
        levels = stacked(gauges, 'level')
        self.level, self.pressure = (0.5*(levels[:, 0] - levels[:, 1]),
                                     0.5*(sensors['p0'] - sensors['p1']))
        b = sway.solve(self.t)
        X = sway.place(self.t)
        # the gauges stand still, the tank does not
        left, right = (sway.level(b, tank[f'gauge{side}'] - tank['left'] - X)
                       for side in ('Left', 'Right'))
        self.levelTheory = 0.5*(left - right)
        self.pressureTheory = rho*sway.wallPressure(b, self.t, tank['sensorY'] - tank['depth'])


def turns(t, values, least):
    """Times and heights of the extremes beyond least: one between two zeros, by a parabola through
    the three highest samples"""
    out = []
    for part in np.split(np.arange(len(t)), np.flatnonzero(np.diff(np.sign(values)) != 0) + 1):
        k = part[np.argmax(np.abs(values[part]))]
        if abs(values[k]) < least or k in (0, len(t) - 1) or k in (part[0], part[-1]):
            continue
        a, b, c = np.abs(values[k - 1:k + 2])
        shift = 0.5*(a - c)/(a - 2*b + c)
        out.append((t[k] + shift*(t[k + 1] - t[k]),
                    float(np.sign(values[k])*(b - 0.25*(a - c)*shift))))
    return np.array(out)


def analyse(run):
    s = Sides(run)
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    smooth = [measures.movingAverage(s.t, v, 0.05) for v in (s.level, s.levelTheory)]
    largest = np.abs(s.levelTheory).max()
    found, theory = (turns(s.t, v, 0.3*largest) for v in smooth)
    near = np.array([found[np.argmin(np.abs(found[:, 0] - at))] for at, _ in theory])
    return (
        [Quantity('peaks: largest error of time',
                  error=float(np.abs(near[:, 0]/theory[:, 0] - 1).max())),
         Quantity('peaks: largest error of level / largest',
                  error=float(np.abs(near[:, 1] - theory[:, 1]).max()/largest)),
         Quantity('level, rms / rms',
                  error=measures.rms(s.level - s.levelTheory)/measures.rms(s.levelTheory)),
         Quantity('pressure, rms / rms',
                  error=measures.rms(s.pressure - s.pressureTheory)/measures.rms(s.pressureTheory)),
         Quantity('theory against closed form', error=linearTheory.check()),
         Quantity('particles lost', error=first - last)])


def plot(runs, path):
    fig, axes = plotting.figure(1, 2, width=9, height=3)
    for k, run in enumerate(runs):
        s = Sides(run)
        for axis, computed, theory, unit in ((axes[0], s.level, s.levelTheory, 1e3),
                                             (axes[1], s.pressure, s.pressureTheory, 1)):
            if k == 0:
                axis.plot(s.t, unit*theory, color='#444444', linewidth=1, linestyle='--',
                          label='linear theory')
            axis.plot(s.t, unit*computed, linewidth=0.7, label=run.name)
    axes[0].set(xlabel='t [s]', ylabel='level, half difference [mm]')
    axes[1].set(xlabel='t [s]', ylabel='p on the walls, half difference [Pa]')
    for axis in axes:
        plotting.named(axis)
    plotting.save(fig, path)


wide = 'smoothingLength/ratio 2.5'
coarse = 'system/controlDict:sampleInterval 0.02'

Study(
    scene='swayingTank',
    variants=[Variant('dp20', ['-spacing', '0.02']), Variant('dp10'), Variant('dp5', [
        '-spacing', '0.005'], large=True), Variant('wide-dp20', ['-spacing', '0.02', '-set', wide]),
              Variant('wide-dp10', ['-set', wide]),
              Variant('wide-dp5', ['-spacing', '0.005', '-set', wide], large=True)],
    quick=[Variant('quick', ['-spacing', '0.025', '-endTime', '4', '-set', coarse]),
           Variant('quick-wide',
                   ['-spacing', '0.025', '-endTime', '4', '-set', f'{wide}; {coarse}'])],
    analyse=analyse,
    plot=plot,
    headline='peaks: largest error of time',
    orders=[('level, rms / rms', ['wide-dp20', 'wide-dp10', 'wide-dp5'])],
).main(here)
