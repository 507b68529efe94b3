# SPDX-License-Identifier: GPL-3.0-or-later
"""Poiseuille flow from rest between cut-cell walls at an angle to the mesh: profiles against the
Fourier series"""
import os

import numpy as np

from riprap import channels, clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
width, force = 0.5, 0.8         # of the channel [m]; of the body [m/s2]
along = np.array([2, 1])/5**0.5


def across(x):
    """Distance from one wall; the channel's middle is y = x/2, and its images up and down"""
    return ((x[:, 1] - 0.5*x[:, 0] + 0.5) % 1 - 0.5)*along[0] + 0.5*width


def state(run, name):
    """Distances from the wall, velocities along and across, and the exact one"""
    c = clouds.readCloud(run.path, name, ['U'])
    y, u = across(c['positions']), c['U'][:, :2]
    return (y, u @ along, u @ np.array([-along[1], along[0]]),
            channels.poiseuille(y, float(name), run.kinematicViscosity, force, width))


def errors(run):
    """nu t/L^2 and the relative L2 error of the velocity over all particles, at the written
    times"""
    rows = []
    for name in clouds.times(run.path):
        if float(name) > 0:
            _, u, v, exact = state(run, name)
            rows.append(
                (run.kinematicViscosity*float(name)/width**2,
                 measures.relativeL2(np.column_stack([u, v]), np.column_stack([exact, 0*exact]))))
    return np.array(rows).T


def analyse(run):
    tau, error = errors(run)
    y, *_ = state(run, clouds.times(run.path)[-1])
    return [Quantity('velocity L2, nu t/L^2 = 0.1', error=error[np.argmin(abs(tau - 0.1))]),
            Quantity('velocity L2, steady', error=error[-1]),
            Quantity('velocity L2, largest from nu t/L^2 = 0.05',
                     error=error[tau > 0.05 - 1e-9].max()),
            Quantity('deepest particle in a bank / cell',
                     computed=float(max(0, -y.min(), y.max() - width)/(2*run.spacing)))]


def plot(runs, path):
    fig, (left, right) = plotting.figure(2)
    finest = min(runs, key=lambda r: r.spacing)
    s = np.linspace(0, width, 201)
    for i, tau in enumerate((0.05, 0.1, 0.2, 1)):
        name = clouds.nearestTime(finest.path, tau*width**2/finest.kinematicViscosity)
        y, u, _, _ = state(finest, name)
        left.plot(y, u, '.', markersize=2, color=plotting.colours[i],
                  label=f'$\\nu t/L^2$ = {tau:g}')
        left.plot(s, channels.poiseuille(s, float(name), finest.kinematicViscosity, force, width),
                  'k-', linewidth=0.7)
    left.set(xlabel='distance from a wall [m]', ylabel='velocity along the channel [m/s]',
             title=f'{finest.name}; lines: exact')
    for run in runs:
        right.semilogy(*errors(run), label=run.name)
    right.axhline(0.02, color='k', linewidth=0.8, linestyle='--', label='bound at 20 cells')
    right.set(xlabel='$\\nu t/L^2$', ylabel='relative L2 error of the velocity')
    plotting.named(left)
    plotting.named(right)
    plotting.save(fig, path)


def cells(n, more=''):
    """n cells across the channel"""
    return ['-spacing', f'{0.5*width/n:.10g}', '-set',
            f'system/tank:nx {4*n}; system/tank:ny {2*n}{more}']


Study(
    scene='picObliqueChannel',
    variants=[Variant(f'n{n}', cells(n))
              for n in (10, 20, 40)] + [Variant('n20-apic', cells(20, '; transfer apic'))],
    quick=[Variant('n10-quick', cells(10) + ['-endTime', '1'])],
    analyse=analyse,
    plot=plot,
    headline='velocity L2, steady',
    orders=[('velocity L2, nu t/L^2 = 0.1', ['n10', 'n20', 'n40']),
            ('velocity L2, steady', ['n10', 'n20', 'n40'])],
).main(here)
