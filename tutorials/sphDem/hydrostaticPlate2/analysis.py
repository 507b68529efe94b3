# SPDX-License-Identifier: GPL-3.0-or-later
"""Aluminium plate under two metres of water at rest: the middle's displacement against plate
theory"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g, rho, rhoPlate = 9.81, 1000, 2700
e, L, H = 0.05, 1.0, 2.0
E, nu = 67.5e9, 0.34
analytic = 6.849e-5                     # reference/analytic_midspan.csv


def shear():
    """What a thin plate leaves out: q L^2/(8 kappa G e), kappa = 5/6"""
    return g*(rho*H + rhoPlate*e)*L**2/(8*5/6*E/(2*(1 + nu))*e)


def middle(run):
    """Time and how far the middle has sunk: mean of the particles about it"""
    table = run.table('middle', 'particleDisplacement.dat')
    return table['Time'], -np.mean([table[c] for c in table if c.endswith('Dy')], axis=0)


def analyse(run):
    t, w = middle(run)
    last = t > 0.75*t[-1]
    at = w[last].mean()
    third = w[(t > 0.5*t[-1]) & ~last].mean()
    return [Quantity('middle [um]', 1e6*at, 1e6*analytic, abs(at/analytic - 1)),
            Quantity('middle [um], theory with shear', 1e6*at, 1e6*(analytic + shear()),
                     abs(at/(analytic + shear()) - 1)),
            Quantity('drift, third quarter to last', error=float(abs(at/third - 1))),
            Quantity('rms about the mean in the last quarter', computed=float(w[last].std()/at))]


def plot(runs, path):
    fig, (axis,) = plotting.figure(1)
    for run in runs:
        t, w = middle(run)
        axis.plot(t, 1e6*w, linewidth=0.8, label=run.name)
    t, y = np.loadtxt(os.path.join(here, 'reference', 'ng2020_sph_vcpm.csv'), delimiter=',',
                      skiprows=1, unpack=True)
    axis.plot(t, -1e2*y, '.', color='#888888', markersize=2, label='SPH-VCPM, Ng et al. 2020')
    axis.axhline(1e6*analytic, color='k', linewidth=0.8, linestyle='--', label='thin plate')
    axis.axhline(1e6*(analytic + shear()), color='k', linewidth=0.8, linestyle=':',
                 label='with shear')
    axis.set(xlabel='t [s]', ylabel='middle sinks by [um]',
             xlim=(0, max(middle(r)[0][-1] for r in runs)), ylim=(0, 140))
    plotting.named(axis)
    plotting.save(fig, path)


Study(
    scene='hydrostaticPlate2',
    variants=[Variant('extrapolated'),
              Variant('pressureGradient', ['-set', 'coupling pressureGradient'])],
    quick=[Variant('quick', ['-endTime', '0.06'])],
    analyse=analyse,
    plot=plot,
    headline='middle [um]',
).main(here)
