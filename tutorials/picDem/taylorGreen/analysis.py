# SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor-Green vortices by PIC: velocity of every particle and its decay against the exact solution"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def exact(x, y, t, nu):
    """Velocity at time t: decays by exp(-8 pi^2 nu t) in the unit square"""
    decay = np.exp(-8*np.pi**2*nu*t)
    return decay*np.column_stack([-np.cos(2*np.pi*x)*np.sin(2*np.pi*y), np.sin(2*np.pi*x)*np.cos(2*np.pi*y)])


def histories(run):
    """t, relative L2 error of the velocity, kinetic energy over the initial one, at written times"""
    rows, start = [], None
    for name in clouds.times(run.path):
        c = clouds.readCloud(run.path, name, ['U'])
        u, t = c['U'][:, :2], float(name)
        energy = np.mean(np.sum(u**2, axis=1))
        start = start or energy
        e = exact(c['positions'][:, 0], c['positions'][:, 1], t, run.kinematicViscosity)
        rows.append((t, measures.relativeL2(u, e), energy/start))
    return np.array(rows).T


def analyse(run):
    t, error, energy = histories(run)
    reference = np.loadtxt(os.path.join(here, 'reference', 'decayRe100.csv'), delimiter=',', skiprows=1)
    exactEnergy = np.interp(t, reference[:, 0], reference[:, 2])
    half = np.argmin(abs(t - 0.5))
    return [Quantity('velocity L2, t U/L = 0.5', error=error[half]),
            Quantity('velocity L2, t U/L = 1', error=error[-1]),
            Quantity('kinetic energy, t U/L = 1', computed=energy[-1], reference=exactEnergy[-1],
                     error=abs(energy[-1]/exactEnergy[-1] - 1))]


def plot(runs, path):
    fig, (error, energy) = plotting.figure(2)
    reference = np.loadtxt(os.path.join(here, 'reference', 'decayRe100.csv'), delimiter=',', skiprows=1)
    for run in runs:
        t, e, k = histories(run)
        error.semilogy(t[1:], e[1:], 'o-', markersize=3, label=run.name)
        energy.plot(t, k, label=run.name)
    energy.plot(reference[:, 0], reference[:, 2], 'k:', label='exact')
    energy.set(xlabel='t U/L', ylabel='kinetic energy / initial', xlim=(0, 1))
    error.set(xlabel='t U/L', ylabel='relative L2 error of the velocity')
    for axis in (error, energy):
        axis.legend(fontsize=8)
    plotting.save(fig, path)


def grid(n):
    return ['-spacing', f'{0.5/n:.10g}', '-set', f'system/tank:n {n}']


def grids(suffix, sets):
    return [Variant(f'n{n}{suffix}', grid(n) + ['-set', sets]) for n in (16, 32, 64)]


Study(
    scene='picTaylorGreen',
    variants=[Variant(f'n{n}', grid(n)) for n in (16, 32, 64)] + grids('-apic', 'transfer apic')
    + grids('-plain', 'reflection no'),
    quick=[Variant('n32-quick', grid(32))],
    analyse=analyse,
    plot=plot,
    headline='velocity L2, t U/L = 1',
    orders=[('velocity L2, t U/L = 1', [f'n{n}{s}' for n in (16, 32, 64)]) for s in ('', '-apic', '-plain')],
).main(here)
