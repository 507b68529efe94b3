# SPDX-License-Identifier: GPL-3.0-or-later
"""A cylinder sinks in a closed channel: its velocity against Glowinski et al. (2001)"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def reference():
    return np.loadtxt(os.path.join(here, 'reference', 'glowinski2001_v.csv'), delimiter=',',
                      skiprows=1).T


def motion(run):
    table = run.table('stack', 'groupMotion.dat')
    return table['Time'], table['freeCentreX'], table['freeCentreY'], table['freeUy']


def analyse(run):
    t, x, y, v = motion(run)
    when, measured = reference()
    known = (when <= t[-1]) & (when >= 0.05)
    off = np.abs(np.interp(when[known], t, v) - measured[known])/np.abs(measured).max()
    result = [Quantity('velocity, largest difference / largest velocity', error=float(off.max())),
              Quantity('way off the middle / diameter',
                       computed=float(np.abs(x - 0.01).max()/0.0025))]
    late = t >= 0.4
    if late.any():
        computed, terminal = -v[late].mean(), -np.interp(t[late], when, measured).mean()
        result.append(Quantity('terminal velocity [m/s]', computed, terminal,
                               abs(computed/terminal - 1)))
    return result


def plot(runs, path):
    plotting.besideMeasured(path, runs, lambda run: (motion(run)[0], motion(run)[3]), reference(),
                            'Glowinski et al. (2001)', 't [s]', 'velocity [m/s]')


def cells(across):
    h = 0.0025/across
    return (f'system/tank:nx {8*across}; system/tank:ny {24*across}; '
            f'system/tank:spacing {h/2:.8g}; constant/solidProperties:pairs/default/gap {2*h:.8g}')


Study(
    scene='picSedimentingCylinder',
    variants=[Variant('d10', ['-set', cells(10)]), Variant('d16', ['-set', cells(16)])],
    quick=[Variant('d6-quick', ['-endTime', '0.1', '-set', cells(6)])],
    analyse=analyse,
    plot=plot,
    headline='terminal velocity [m/s]',
).main(here)
