# SPDX-License-Identifier: GPL-3.0-or-later
"""A rolling tank: times and peaks of the impacts on its side, time of the first one on its roof,
against SPHERIC's test 10"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
window = 0.005          # [s] moving average of the computed pressure
level = 800             # [Pa] averaged pressure of an impact
search = 0.3            # [s] about a measured impact


class Sensor:
    def __init__(self, run):
        self.case = run.dictionary('system/history')['history']
        table = run.table('sensor', 'p.dat')
        self.t, self.raw = table['Time'], table['p0']
        self.p = measures.movingAverage(self.t, self.raw, window)

    def impact(self, time):
        """When the averaged pressure rises, and its largest value of the next 0.1 s"""
        at = (self.t > time - search) & (self.t < time + search)
        came = measures.crossing(self.t[at], self.p[at], level) if at.any() else None
        if came is None:
            return None, None
        return came, float(self.p[(self.t >= came) & (self.t < came + 0.1)].max())


def impacts(case):
    """Time, peak, low and high of each measured impact; nan where not known"""
    with open(os.path.join(here, 'reference', 'impacts.csv')) as f:
        rows = [line.strip().split(',') for line in f][1:]
    return [[float(v) if v else np.nan for v in row[1:]] for row in rows if row[0] == case]


def analyse(run):
    s = Sensor(run)
    result = []
    for k, (time, peak, low, high) in enumerate(impacts(s.case)):
        if time + search > s.t[-1]:
            continue
        came, value = s.impact(time)
        result.append(Quantity(f'impact {k + 1}: time [s]', came, time,
                               None if came is None else abs(came/time - 1)))
        if came is None:
            result[-1].error = np.nan
        if not np.isnan(high):
            # 0 is the record, 1 the edge of the scatter
            away = np.nan if value is None else abs(value - peak)/(high - peak)
            result.append(Quantity(f'impact {k + 1}: 5 ms peak [Pa], off / scatter', value, peak,
                                   away))
        elif value is not None:
            result.append(Quantity(f'impact {k + 1}: 5 ms peak [Pa]', value, peak))
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    return result + [Quantity('particles lost', error=first - last)]


def plot(runs, path):
    fig, axes = plotting.figure(1, 2, width=9, height=3)
    for axis, case in zip(axes, ('lateral', 'roof')):
        measured = np.loadtxt(os.path.join(here, 'reference', f'{case}_pressure.csv'),
                              delimiter=',', skiprows=1)
        axis.plot(*measured.T, color='#444444', linewidth=1, label='experiment')
    for run in runs:
        s = Sensor(run)
        axes[s.case == 'roof'].plot(s.t, s.p, linewidth=0.7, label=run.name)
    axes[1].set(xlim=(1.5, 2.3))
    for axis, title in zip(axes, ('sensor 1, on the side', 'sensor 3, on the roof')):
        axis.set(xlabel='t [s]', ylabel='p [Pa], mean of 5 ms', title=title)
        plotting.named(axis)
    plotting.save(fig, path)


roof = ['-set', 'system/history:history roof; system/tank:depth 0.356; system/tank:sensorX -0.425; '
                'system/tank:sensorY 0.508; system/controlDict:endTime 2.3; '
                'system/controlDict:sampleInterval 0.001']

Study(
    scene='rollingTank',
    variants=[Variant('lateral-6mm', ['-spacing', '0.0062', '-set',
                                      'system/tank:left -0.4495; system/tank:right 0.4495']),
              Variant('lateral', large=True),
              Variant('lateral-1.5mm', ['-spacing', '0.0015'], large=True),
              Variant('roof', ['-spacing', '0.004', *roof], large=True),
              Variant('roof-2mm', ['-spacing', '0.002', *roof], large=True)],
    quick=[Variant('quick', ['-spacing', '0.0093', '-endTime', '2.7', '-set',
                             'system/tank:left -0.45105; system/tank:right 0.45105; '
                             'system/controlDict:sampleInterval 0.005'])],
    analyse=analyse,
    plot=plot,
    headline='impact 1: time [s]',
    orders=[('impact 1: time [s]', ['lateral-6mm', 'lateral', 'lateral-1.5mm'])],
).main(here)
