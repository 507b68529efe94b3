# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure on the wall that a dam break hits, against Lobovsky et al. (2014) and Buchner (2002)"""
import os

import numpy as np

from . import measures, plotting
from .bounds import Quantity, root
from .tables import stacked

g, H = 9.81, 0.3
heights = [0.003, 0.015, 0.03, 0.08, 0.06]     # of the probes, as in system/controlDict
sensor2 = 1
window = 0.05           # [sqrt(H/g)] moving average of the computed pressure, 9 ms: see README
arrivalLevel = 0.5      # [rho g H] the pressure has arrived when it passes this level


def reference(name):
    return np.loadtxt(os.path.join(root(), 'tutorials', 'sphDem', 'dambreakPressure', 'reference',
                                   name + '.csv'), delimiter=',', skiprows=1)


def pressures(run):
    """T = t sqrt(g/H) and p/(rho g H) of all probes"""
    table = run.table('wallProbes', 'p.dat')
    return table['Time']*np.sqrt(g/H), stacked(table, 'p')/(run.density*g*H)


def plateau(T, p):
    """Mean between the impact and the fall of the backward plunging wave"""
    return float(p[(T >= 3.6) & (T <= 5)].mean())


def analyse(run):
    T, p = pressures(run)
    raw = p[:, sensor2]
    smooth = measures.movingAverage(T, raw, window)
    band = reference('lobovsky2014_sensor2_percentiles')        # T, 2.5 %, median, 97.5 %
    arrival = measures.crossing(T, smooth, arrivalLevel)
    measured = measures.crossing(band[:, 0], band[:, 2], arrivalLevel)
    impact = (T >= 2) & (T <= 3.2)
    level = plateau(band[:, 0], band[:, 2])
    result = [
        Quantity('arrival at sensor 2, t sqrt(g/H)', computed=arrival, reference=measured,
                 error=None if arrival is None else abs(arrival/measured - 1)),
        # 1.871: median of the experiment's peaks, at the full sampling rate
        Quantity('peak at sensor 2 [rho g H]',
                 computed=smooth[impact].max() if impact.any() else None, reference=1.871),
        Quantity('peak at sensor 2, not averaged',
                 computed=raw[impact].max() if impact.any() else None, reference=1.871)]
    if T[-1] > 5:
        computed = plateau(T, raw)
        inside = within(T, smooth, band)
        result += [Quantity('plateau at sensor 2', computed=computed, reference=level,
                            error=abs(computed/level - 1)),
                   Quantity('share of the time inside the band, 2.6 to 5', computed=inside)]
        for i, name in ((0, 'p1'), (2, 'p3'), (3, 'p4')):
            e = reference(f'lobovsky2014_{name}')
            level = plateau(e[:, 0], e[:, 1])
            value = plateau(T, p[:, i])
            result.append(Quantity(f'plateau at {1000*heights[i]:.0f} mm', computed=value,
                                   reference=level, error=abs(value/level - 1)))
    return result


def within(T, p, band):
    """Share of 2.6 < T < 5 in which p lies between the 2.5 and 97.5 percentiles"""
    t = np.linspace(2.6, 5, 500)
    low, high, value = (np.interp(t, band[:, 0], band[:, 1]), np.interp(t, band[:, 0], band[:, 3]),
                        np.interp(t, T, p))
    return float(np.mean((value >= low) & (value <= high)))


def plot(runs, path):
    fig, axes = plotting.figure(3, 2, width=4.6, height=3.2)
    band = reference('lobovsky2014_sensor2_percentiles')
    axes[1].fill_between(band[:, 0], band[:, 1], band[:, 3], color='#bbbbbb',
                         label='Lobovsky, 2.5 to 97.5 %')
    axes[1].plot(band[:, 0], band[:, 2], color='#444444', linewidth=1, label='Lobovsky, median')
    single = [(0, 'lobovsky2014_p1', 'Lobovsky'), (2, 'lobovsky2014_p3', 'Lobovsky'),
              (3, 'lobovsky2014_p4', 'Lobovsky'), (4, 'buchner2002_p1', 'Buchner, P1')]
    for i, name, label in single:
        e = reference(name)
        e = e[np.argsort(e[:, 0])]
        axes[i].plot(e[:, 0], e[:, 1], color='#444444', linewidth=1, label=label)
    for file, label in (('decourcy2024_sph_p2', 'SPH, De Courcy 2024'),
                        ('interFoam_noSlip_sensor2', 'interFoam 2.5 mm, noSlip'),
                        ('interFoam_slip_sensor2', 'interFoam 2.5 mm, slip')):
        peer = reference(file)
        axes[1].plot(peer[:, 0], peer[:, 1], ':', linewidth=1, label=label)
    for run in runs:
        if 'stationary' in run.name:        # leaks; its numbers are in the table
            continue
        T, p = pressures(run)
        for i, axis in enumerate(axes[:5]):
            axis.plot(T, measures.movingAverage(T, p[:, i], window), linewidth=1, label=run.name)
            axis.set(title=f'{1000*heights[i]:.0f} mm above the floor', xlim=(2, 7), ylim=(-0.3, 3))
        e = run.table('energy', 'energyBalance.dat')
        axes[5].plot(e['Time']*np.sqrt(g/H), e['dissipated']/e['total'][0], label=run.name)
    axes[5].set(title='dissipated / energy at the start')
    for axis in axes:
        axis.set(xlabel='$t\\,\\sqrt{g/H}$')
        plotting.named(axis)
    axes[0].set(ylabel='$p/(\\rho g H)$')
    axes[3].set(ylabel='$p/(\\rho g H)$')
    plotting.save(fig, path)
