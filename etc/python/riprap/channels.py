# SPDX-License-Identifier: GPL-3.0-or-later
"""Transient plane channel flows from rest: exact profiles and a run's errors against them

    Poiseuille, body force F:  u = F/(2 nu) y (L - y) - sum_n 4 F L^2/(nu pi^3 (2n+1)^3)
                                   sin(pi y (2n+1)/L) exp(-(2n+1)^2 pi^2 nu t/L^2)
    Couette, wall y = L at U:  u = U y/L + sum_n 2 U/(n pi) (-1)^n sin(n pi y/L) exp(-n^2 pi^2 nu
                               t/L^2)

Morris, Fox & Zhu (1997), J. Comput. Phys. 136, 214-226.
"""
import os

import numpy as np

from . import clouds, measures, plotting
from .bounds import Quantity, root
from .study import Study, Variant

terms = 200


def poiseuille(y, t, nu, F, L=1.0):
    n = 2*np.arange(terms)[:, None] + 1
    series = 4*F*L**2/(nu*np.pi**3*n**3)*np.sin(np.pi*y*n/L)*np.exp(-n**2*np.pi**2*nu*t/L**2)
    return F/(2*nu)*y*(L - y) - series.sum(axis=0)


def couette(y, t, nu, U, L=1.0):
    n = np.arange(1, 2*terms)[:, None]
    series = 2*U/(n*np.pi)*(-1.0)**n*np.sin(n*np.pi*y/L)*np.exp(-n**2*np.pi**2*nu*t/L**2)
    return U*y/L + series.sum(axis=0)


def errors(run, profile):
    """nu t/L^2 and the relative L2 error of (u, v) over all particles, at the written times"""
    rows = []
    for name in clouds.times(run.path):
        t = float(name)
        if t > 0:
            c = clouds.readCloud(run.path, name, ['U'])
            u = profile(c['positions'][:, 1], t, run.kinematicViscosity)
            rows.append((run.kinematicViscosity*t,
                         measures.relativeL2(c['U'][:, :2], np.column_stack([u, 0*u]))))
    return np.array(rows).T


def analyse(run, profile):
    tau, error = errors(run, profile)
    developing = error[(tau >= 0.05 - 1e-9)]
    return [Quantity('velocity L2, nu t/L^2 = 0.1', error=error[np.argmin(abs(tau - 0.1))]),
            Quantity('velocity L2, steady', error=error[-1]),
            Quantity('velocity L2, largest from nu t/L^2 = 0.05', error=developing.max())]


def checkSeries(profile, file, scale):
    """Largest difference between the series and the reference table of profiles: u/scale at
    columns '...@nu*t/L^2=0.05'"""
    with open(file) as f:
        taus = [float(c.split('=')[-1]) for c in f.readline().split(',')[1:]]
    data = np.loadtxt(file, delimiter=',', skiprows=1)
    return max(abs(profile(data[:, 0], tau)/scale - data[:, i + 1]).max()
               for i, tau in enumerate(taus))


def plot(runs, path, profile, title):
    fig, (left, right) = plotting.figure(2)
    finest = min(runs, key=lambda r: r.spacing)
    y = np.linspace(0, 1, 201)
    for i, tau in enumerate((0.025, 0.05, 0.1, 0.2, 0.5)):
        name = clouds.nearestTime(finest.path, tau/finest.kinematicViscosity)
        c = clouds.readCloud(finest.path, name, ['U'])
        left.plot(c['positions'][:, 1], c['U'][:, 0], '.', markersize=2, color=plotting.colours[i],
                  label=f'$\\nu t/L^2$ = {float(name)*finest.kinematicViscosity:.3g}')
        left.plot(y, profile(y, float(name), finest.kinematicViscosity), 'k-', linewidth=0.7)
    left.set(xlabel='y/L', ylabel='u [m/s]',
             title=f'{title}, L/{1/finest.spacing:.0f}; lines: exact')
    for run in runs:
        tau, error = errors(run, profile)
        right.semilogy(tau, error, label=f'{run.name}: L/{1/run.spacing:.0f}')
    right.axhline(0.02, color='k', linewidth=0.8, linestyle='--',
                  label='bound of the stated resolution')
    right.set(xlabel='$\\nu t/L^2$', ylabel='relative L2 error of the velocity')
    plotting.named(left)
    plotting.named(right)
    plotting.save(fig, path)


def ofParticles():
    """Variants of sphDem, the quick one, and the three resolutions"""
    return ([Variant('n25', ['-spacing', '0.04']), Variant('n50', ['-spacing', '0.02']),
             Variant('n100', ['-spacing', '0.01']),
             Variant('n50-stationary', ['-spacing', '0.02', '-set', 'walls/model stationary'])],
            [Variant('n25-quick', ['-spacing', '0.04', '-endTime', '5'])], ['n25', 'n50', 'n100'])


def onGrid():
    """The same of picDem, with n cells across"""
    def cells(n, more=''):
        return ['-spacing', f'{0.5/n:.8g}', '-set',
                f'system/tank:n {n}; system/tank:nx {3*n//5}{more}']
    return ([Variant(f'n{n}', cells(n)) for n in (10, 20, 40)]
            + [Variant(f'n20-{word}', cells(20, f'; {entry}')) for word, entry in (
                ('apic', 'transfer apic'), ('explicit', 'viscosity explicit'),
                ('implicit', 'viscosity implicit'))],
            [Variant('n10-quick', cells(10) + ['-endTime', '5'])], ['n10', 'n20', 'n40'])


def verify(scene, here, profile, scale, title, runs=None):
    """The tutorial here: its runs (ofParticles() or onGrid()) and main program; scale: of the
    velocities in sphDem's reference/profiles.csv, at nu = 0.1"""
    variants, quick, resolutions = runs or ofParticles()
    steady = 'velocity L2, steady'
    developing = 'velocity L2, largest from nu t/L^2 = 0.05'

    def analysed(run):
        table = os.path.join(root(), 'tutorials', 'sphDem', os.path.basename(here), 'reference',
                             'profiles.csv')
        series = checkSeries(lambda y, tau: profile(y, tau/0.1, 0.1), table, scale)
        return [*analyse(run, profile), Quantity('series against reference table', error=series)]

    Study(
        scene=scene,
        variants=variants,
        quick=quick,
        analyse=analysed,
        plot=lambda runs, path: plot(runs, path, profile, title),
        headline=steady,
        orders=[(steady, resolutions), (developing, resolutions)],
    ).main(here)
