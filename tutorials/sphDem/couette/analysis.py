# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane Couette flow from rest: profiles against the Fourier series"""
import os

from riprap import channels
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def profile(y, t, nu):
    return channels.couette(y, t, nu, U=1.0)


def analyse(run):
    table = os.path.join(here, 'reference', 'profiles.csv')
    series = channels.checkSeries(lambda y, tau: profile(y, tau/0.1, 0.1), table, 1.0)
    return [*channels.analyse(run, profile), Quantity('series against reference table', error=series)]


def plot(runs, path):
    channels.plot(runs, path, profile, 'plane Couette')


steady = 'velocity L2, steady'
developing = 'velocity L2, largest from nu t/L^2 = 0.05'

Study(
    scene='couette',
    variants=[Variant('n25', ['-spacing', '0.04']), Variant('n50', ['-spacing', '0.02']),
              Variant('n100', ['-spacing', '0.01']),
              Variant('n50-stationary', ['-spacing', '0.02', '-set', 'walls/model stationary'])],
    quick=[Variant('n25-quick', ['-spacing', '0.04', '-endTime', '5'])],
    analyse=analyse,
    plot=plot,
    headline=steady,
    orders=[(steady, ['n25', 'n50', 'n100']), (developing, ['n25', 'n50', 'n100'])],
).main(here)
