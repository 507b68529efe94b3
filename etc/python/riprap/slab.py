# SPDX-License-Identifier: GPL-3.0-or-later
"""A collapsing column in 3D, a slab periodic across, beside the same one in 2D"""
import numpy as np

from . import measures, plotting
from .bounds import Quantity
from .dictionaries import numberOf


def front(run):
    """t and x/a until the front is two spacings from the far wall"""
    tank = run.dictionary('system/tank')
    table = run.table('front', 'frontPosition.dat')
    t, x = measures.upTo(table['Time'], table['frontFloor'],
                         numberOf(tank['tankWidth']) - 2*run.spacing)
    return t, x/numberOf(tank['columnWidth'])


def analyse(run):
    table = run.table('front', 'frontPosition.dat')
    t, z = front(run)
    return [Quantity('front two spacings from the far wall [s]', computed=t[-1]),
            Quantity('front at 0.2 s [a]', computed=float(np.interp(0.2, t, z))),
            Quantity('particles lost', computed=table['escaped'][-1]/table['particles'][0])]


def difference(solid, flat):
    """Largest |x3D - x2D|/x2D while both are on their way, on the 2D run's times"""
    (t3, z3), (t2, z2) = front(solid), front(flat)
    common = t2 <= min(t2[-1], t3[-1])
    return float(np.max(abs(np.interp(t2[common], t3, z3)/z2[common] - 1)))


def plot(runs, path):
    fig, (curve, kinetic) = plotting.figure(2)
    for run in runs:
        flat = '2D' in run.name
        t, z = front(run)
        curve.plot(t, z, '--' if flat else '-', label=run.name)
        e = run.table('energy', 'energyBalance.dat')
        kinetic.plot(e['Time'], e['kinetic']/e['total'][0], '--' if flat else '-', label=run.name)
    curve.set(xlabel='t [s]', ylabel='front x/a')
    kinetic.set(xlabel='t [s]', ylabel='kinetic energy / total at the start')
    for axis in (curve, kinetic):
        plotting.named(axis)
    plotting.save(fig, path)
