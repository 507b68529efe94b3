# SPDX-License-Identifier: GPL-3.0-or-later
"""A cylinder as heavy as the liquid in shear: how it moves to the middle, against Feng &
Michaelides (2002)"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
height = 0.01


def reference():
    return np.loadtxt(os.path.join(here, 'reference', 'feng2002_migration_y.csv'), delimiter=',',
                      skiprows=1).T


def motion(run):
    table = run.table('stack', 'groupMotion.dat')
    return table['Time'], table['freeCentreX'], table['freeCentreY'], table['freeUx']


def analyse(run):
    t, x, y, u = motion(run)
    when, known = reference()
    seen = when <= t[-1]
    off = np.abs(np.interp(when[seen], t, y) - known[seen])/height
    return [Quantity('height over the channel, largest difference', error=float(off.max())),
            Quantity('height at the end [m]', computed=float(y[-1])),
            Quantity('way along the channel [m]', computed=float(x[-1] - x[0]))]


def plot(runs, path):
    plotting.besideMeasured(path, runs, lambda run: (motion(run)[0], motion(run)[2]), reference(),
                            'Feng & Michaelides (2002)', 't [s]', 'y [m]')


def cells(across):
    h = 0.0025/across
    return f'system/tank:nx {48*across}; system/tank:ny {4*across}; system/tank:spacing {h/2:.8g}'


Study(
    scene='picNeutralCylinder',
    variants=[Variant('d6', ['-set', cells(6)]), Variant('d10')],
    quick=[Variant('d5-quick', ['-endTime', '1', '-set', cells(5)])],
    analyse=analyse,
    plot=plot,
    headline='height over the channel, largest difference',
).main(here)
