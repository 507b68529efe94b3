# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break on a box against the experiment of Kleefsman et al. (2005)"""
import os

import numpy as np

from riprap import measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))
column = 0.55           # [m] depth of the reservoir
window = 0.009          # [s] moving average of pressures
wet = 1000              # [Pa] the front has reached a sensor when the pressure passes this
front, top = range(4), range(4, 8)


def experiment(name):
    """Time, pressures and levels; pressures from what the sensors show before water comes"""
    data = np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1)
    full = np.loadtxt(os.path.join(here, 'reference', 'experiment.csv'), delimiter=',', skiprows=1)
    data[:, 1:9] -= full[full[:, 0] < 0.35, 1:9].mean(axis=0)
    return data[:, 0], data[:, 1:9], data[:, 9:13]


def impulse(t, p, begin, end):
    """[Pa s]"""
    times = np.linspace(begin, end, 2001)
    return float(np.trapz(np.interp(times, t, p), times))


def analyse(run):
    table = run.table('sensors', 'p.dat')
    t, p = table['Time'], stacked(table, 'p')
    smooth = np.array([measures.movingAverage(t, p[:, k], window) for k in range(8)]).T
    te, pe, he = experiment('experiment')
    ti, pi, _ = experiment('experiment_impact')
    smoothE = np.array([measures.movingAverage(ti, pi[:, k], window) for k in range(8)]).T
    result = []
    arrival, measured = (measures.crossing(t, smooth[:, 0], wet),
                         measures.crossing(ti, smoothE[:, 0], wet))
    result.append(Quantity('arrival at P1 [s]', arrival, measured,
                           None if arrival is None else abs(arrival/measured - 1)))
    impact = (t > 0.35) & (t < 0.8)
    for k in front:
        peak, peakE = (smooth[impact, k].max() if impact.any() else None), smoothE[:, k].max()
        result.append(Quantity(f'peak at P{k + 1} over 9 ms [Pa]', peak, peakE,
                               None if peak is None else abs(peak/peakE - 1)))
    if impact.any():
        result.append(Quantity('peak at P1, not averaged [Pa]', p[impact, 0].max(), pi[:, 0].max()))
    for sensors, begin in ((front, 0.4), (top, 1.5)):
        if t[-1] < begin + 0.5:
            continue
        for k in sensors:
            value, valueE = (impulse(t, p[:, k], begin, begin + 0.5),
                             impulse(te, pe[:, k], begin, begin + 0.5))
            result.append(Quantity(f'impulse at P{k + 1}, {begin} to {begin + 0.5} s [Pa s]', value,
                                   valueE, abs(value/valueE - 1)))
    dry = t < 0.38
    result.append(Quantity('largest |p| of dry sensors [Pa]', np.abs(p[dry]).max()))
    result.append(Quantity('lowest p of all [Pa]', p.min()))
    table = run.table('levels', 'waterLevel.dat')
    t, h = table['Time'], stacked(table, 'level')
    for k in range(4):
        within = t <= te[-1]
        error = (measures.movingAverage(t, h[:, k], 0.05)
                 - np.interp(t, te, measures.movingAverage(te, he[:, k], 0.05)))
        result.append(Quantity(f'level H{k + 1}, rms error / column',
                               error=float(np.sqrt(np.mean(error[within]**2))/column)))
    result.append(Quantity('end of the run [s]', t[-1]))
    result.append(Quantity('share lost through walls',
                           run.log['throughWalls']/run.log['fluidParticles']))
    result.append(Quantity('share taken out', run.log['takenOut']/run.log['fluidParticles']))
    return result


def plot(runs, path):
    fig, axes = plotting.figure(3, 2, width=5.2, height=3)
    te, pe, he = experiment('experiment')
    ti, pi, _ = experiment('experiment_impact')
    panels = [(0, 'P1, 21 mm', (0.35, 0.8)), (2, 'P3, 101 mm', (0.35, 0.8)), (0, 'P1', (0, 6)),
              (4, 'P5, top', (0, 6))]
    for axis, (k, title, span) in zip(axes[:4], panels):
        fine = span[1] < 1
        axis.plot(ti if fine else te, (pi if fine else pe)[:, k]/1e3, color='#444444', linewidth=1,
                  label='experiment')
        axis.set(title=title, xlim=span, ylabel='p [kPa]', ylim=(-1, 14 if k < 4 else 4))
    for axis, k, title in ((axes[4], 1, 'H2, x = 0.992 m'), (axes[5], 2, 'H3, behind the box')):
        axis.plot(te, he[:, k], color='#444444', linewidth=1, label='experiment')
        axis.set(title=title, xlim=(0, 6), ylabel='level [m]', ylim=(0, 0.6))
    for run in runs:
        table = run.table('sensors', 'p.dat')
        t, p = table['Time'], stacked(table, 'p')
        for axis, (k, _, _) in zip(axes[:4], panels):
            axis.plot(t, measures.movingAverage(t, p[:, k], window)/1e3, linewidth=1,
                      label=run.name)
        table = run.table('levels', 'waterLevel.dat')
        for axis, k in ((axes[4], 1), (axes[5], 2)):
            axis.plot(table['Time'], stacked(table, 'level')[:, k], linewidth=1, label=run.name)
    for axis in axes:
        axis.set(xlabel='t [s]')
        plotting.named(axis)
    plotting.save(fig, path)


Study(
    scene='damBreakBox',
    variants=[Variant('dp20'), Variant('dp12.5', ['-spacing', '0.0125'], large=True),
              Variant('dp8.2', ['-spacing', '0.0082'], large=True)],
    quick=[Variant('dp40-quick', ['-spacing', '0.04', '-endTime', '0.5'])],
    analyse=analyse,
    plot=plot,
    headline='impulse at P1, 0.4 to 0.9 s [Pa s]',
).main(here)
