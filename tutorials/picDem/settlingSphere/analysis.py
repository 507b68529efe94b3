# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere settles in a closed box: its velocity against ten Cate et al. (2002), four Reynolds
numbers"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
diameter = 0.015
#       Reynolds number: density, viscosity, end of the run
cases = {'1p5': (970, 0.373, 4.2), '4p1': (965, 0.212, 2.6), '11p6': (962, 0.113, 1.8),
         '31p9': (960, 0.058, 1.4)}


def number(run):
    """The name of the run's Reynolds number"""
    return next(k for k, (rho, mu, end) in cases.items() if abs(run.density/rho - 1) < 1e-6)


def reference(run):
    table = np.loadtxt(os.path.join(here, 'reference', f'fig5b_velocity_Re{number(run)}.csv'),
                       delimiter=',', skiprows=1)
    return table[np.argsort(table[:, 0])].T


def motion(run):
    table = run.table('stack', 'groupMotion.dat')
    return table['Time'], table['freeCentreY'] - 0.5*diameter, table['freeUy']


def analyse(run):
    t, gap, v = motion(run)
    when, measured = reference(run)
    # down to where the liquid between sphere and floor is as thin as the grid's cells
    falls = (when <= t[-1]) & (when <= t[gap > 0.5*diameter][-1])
    off = np.interp(when[falls], t, v) - measured[falls]
    result = [Quantity('velocity, rms of the difference / largest velocity',
                       error=float(np.sqrt((off**2).mean())/np.abs(measured).max()))]
    result.append(Quantity('speed at the end [m/s]', computed=float(-v[-1])))
    if t[-1] >= 0.95*when[np.abs(measured).argmax()]:
        fastest = float(-v.min())
        result.append(Quantity('largest velocity [m/s]', fastest, float(-measured.min()),
                               abs(fastest/-measured.min() - 1)))
    return result


def plot(runs, path):
    fig, (left, right) = plotting.figure(2)
    for k, run in enumerate(runs):
        t, gap, v = motion(run)
        colour = f'C{k % 10}'
        left.plot(*reference(run), 'o', color=colour, markersize=3, fillstyle='none')
        left.plot(t, v, linewidth=1, color=colour, label=run.name)
        right.plot(t, gap/diameter, linewidth=1, color=colour)
        table = np.loadtxt(os.path.join(here, 'reference',
                                        f'fig5a_gap_h_over_d_Re{number(run)}.csv'), delimiter=',',
                           skiprows=1)
        right.plot(*table.T, 'o', color=colour, markersize=3, fillstyle='none')
    left.set(xlabel='t [s]', ylabel='velocity [m/s]', title='o ten Cate et al. (2002)')
    right.set(xlabel='t [s]', ylabel='gap above the floor / diameter')
    plotting.named(left)
    plotting.save(fig, path)


def case(name, across=None):
    rho, mu, end = cases[name]
    text = f'constant/fluidProperties:rho {rho}; constant/fluidProperties:mu {mu}'
    if across:
        text += (f'; system/tank:nx {across}; system/tank:ny {int(1.6*across)}; '
                 f'system/tank:spacing {0.1/across:.8g}')
    return ['-endTime', str(end), '-set', text]


Study(
    scene='picSettlingSphere',
    variants=[Variant(f'Re{name}', case(name))
              for name in cases] + [Variant('Re31p9-fine', case('31p9', 80), large=True)],
    quick=[Variant('Re1p5-quick', ['-endTime', '0.1', '-set', case('1p5', 30)[3]])],
    analyse=analyse,
    plot=plot,
    headline='largest velocity [m/s]',
).main(here)
