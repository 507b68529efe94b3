# SPDX-License-Identifier: GPL-3.0-or-later
"""A tank at rest: pressure against rho g (H - y), and how fast it moves although it should not"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81


def depth(run):
    return numberOf(run.dictionary('system/tank')['depth'])


def particles(run):
    """y, p and the hydrostatic pressure of all particles at the last written time"""
    c = clouds.readCloud(run.path, clouds.times(run.path)[-1], ['p'])
    y = c['positions'][:, 1]
    return y, c['p'], run.density*g*(depth(run) - y)


def speed(run):
    """t and the largest speed over sqrt(g H)"""
    e = run.table('energy', 'energyBalance.dat')
    return e['Time'], e['maxSpeed']/np.sqrt(g*depth(run))


def analyse(run):
    y, p, exact = particles(run)
    t, v = speed(run)
    end = t[-1]
    front = run.table('front', 'frontPosition.dat')
    return [Quantity('pressure L2', error=measures.relativeL2(p, exact)),
            Quantity('largest speed / sqrt(g H)', computed=v.max()),
            # In the first tenths of a second the particles at the surface settle onto the walls
            Quantity('largest speed after 0.5 s / sqrt(g H)',
                     computed=v[t > 0.5].max() if end > 0.5 else None),
            # Mean of the largest speed in the last quarter over that in the second: 1 is steady
            Quantity('growth of the speed',
                     computed=v[t > 0.75*end].mean()/v[(t > 0.25*end) & (t < 0.5*end)].mean()),
            Quantity('water level', reference=depth(run), computed=front['height'][-1],
                     error=abs(front['height'][-1]/depth(run) - 1)),
            Quantity('particles lost', computed=front['escaped'][-1])]


def plot(runs, path):
    fig, (pressure, speeds) = plotting.figure(2)
    for run in runs:
        y, p, exact = particles(run)
        label = f'{run.name}: H/{depth(run)/run.spacing:.0f}'
        pressure.plot((p - exact)/(run.density*g*depth(run)), y/depth(run), '.', markersize=2,
                      label=label)
        t, v = speed(run)
        speeds.semilogy(t, np.maximum(v, 1e-12), label=label)
    pressure.axvline(0, color='k', linewidth=0.8)
    pressure.set(xlabel='$(p - \\rho g (H - y))/(\\rho g H)$ at the end', ylabel='y/H')
    speeds.axhline(0.005, color='k', linewidth=0.8, linestyle='--', label='bound')
    speeds.set(xlabel='t [s]', ylabel='largest speed / $\\sqrt{gH}$')
    for axis in (pressure, speeds):
        plotting.named(axis)
    plotting.save(fig, path)


# A tank with a square base of 0.1 m and walls on all four sides, ten particles across: h of 1.5
# spacings, that corners do not reach one another; a higher sound speed, since the lattice's
# settling at the start is slower with it
tank3D = ('system/tank:width 0.1; system/tank:thickness 0.1; system/frontAndBack:frontAndBack wall;'
          'system/tank:nx 10; system/tank:nz 10; smoothingLength/ratio 1.5; soundSpeedRatio 40')

Study(
    scene='hydrostatic',
    variants=[Variant('tank2D-coarse', ['-spacing', '0.0125']),
              Variant('tank2D-medium', ['-spacing', '0.00833333']),
              Variant('tank2D', ['-spacing', '0.00625']),
              Variant('symplectic2D', ['-spacing', '0.0125', '-set', 'timeIntegration symplectic']),
              Variant('stationary2D', ['-spacing', '0.0125', '-set',
                                       'walls/model stationary; densityDiffusion none'],
                      mayFail=True),
              Variant('tank3D-coarse', ['-spacing', '0.0166667', '-set', tank3D]),
              Variant('tank3D-medium', ['-spacing', '0.0125', '-set', tank3D]),
              Variant('tank3D', ['-spacing', '0.01', '-set', tank3D])],
    quick=[Variant('tank2D-quick', ['-spacing', '0.0125', '-endTime', '1'])],
    analyse=analyse,
    plot=plot,
    headline='pressure L2',
    orders=[('pressure L2', ['tank2D-coarse', 'tank2D-medium', 'tank2D']),
            ('pressure L2', ['tank3D-coarse', 'tank3D-medium', 'tank3D'])],
).main(here)
