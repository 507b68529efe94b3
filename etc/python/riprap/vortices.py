# SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor-Green vortices: velocity of every particle and its decay against the exact solution"""
import os

import numpy as np

from . import clouds, measures, plotting
from .bounds import Quantity, root


def exact(x, y, t, nu):
    """Velocity at time t: decays by exp(-8 pi^2 nu t) in the unit square"""
    decay = np.exp(-8*np.pi**2*nu*t)
    return decay*np.column_stack([-np.cos(2*np.pi*x)*np.sin(2*np.pi*y),
                                  np.sin(2*np.pi*x)*np.cos(2*np.pi*y)])


def histories(run):
    """t, relative L2 error of the velocity, kinetic energy over the initial one, at written
    times"""
    rows, start = [], None
    for name in clouds.times(run.path):
        c = clouds.readCloud(run.path, name, ['U'])
        u, t = c['U'][:, :2], float(name)
        energy = np.mean(np.sum(u**2, axis=1))
        start = start or energy
        e = exact(c['positions'][:, 0], c['positions'][:, 1], t, run.kinematicViscosity)
        rows.append((t, measures.relativeL2(u, e), energy/start))
    return np.array(rows).T


def decay():
    """t U/L, velocity, kinetic energy of the exact solution at Re 100, over the initial ones"""
    file = os.path.join(root(), 'tutorials', 'sphDem', 'taylorGreen', 'reference', 'decayRe100.csv')
    return np.loadtxt(file, delimiter=',', skiprows=1)


def analyse(run):
    t, error, energy = histories(run)
    reference = decay()
    exactEnergy = np.interp(t, reference[:, 0], reference[:, 2])
    half = np.argmin(abs(t - 0.5))
    return [Quantity('velocity L2, t U/L = 0.5', error=error[half]),
            Quantity('velocity L2, t U/L = 1', error=error[-1]),
            Quantity('kinetic energy, t U/L = 1', computed=energy[-1], reference=exactEnergy[-1],
                     error=abs(energy[-1]/exactEnergy[-1] - 1))]


def plot(runs, path):
    fig, (error, energy) = plotting.figure(2)
    reference = decay()
    for run in runs:
        t, e, k = histories(run)
        error.semilogy(t[1:], e[1:], 'o-', markersize=3, label=f'{run.name}: L/{1/run.spacing:.0f}')
        energy.plot(t, k, label=f'{run.name}: L/{1/run.spacing:.0f}')
    energy.plot(reference[:, 0], reference[:, 2], 'k:', label='exact')
    energy.set(xlabel='t U/L', ylabel='kinetic energy / initial', xlim=(0, 1))
    error.axhline(0.02, color='k', linewidth=0.8, linestyle='--',
                  label='bound of the stated resolution')
    error.set(xlabel='t U/L', ylabel='relative L2 error of the velocity')
    for axis in (error, energy):
        plotting.named(axis)
    plotting.save(fig, path)
