# SPDX-License-Identifier: GPL-3.0-or-later
"""Bonded cantilever: deflection of its tip against the closed form of n bonds and against the
continuum, and torsion"""
import math
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


class Beam:
    def __init__(self, run):
        beam, cement = run.dictionary('system/beam'), run.solid['bonds']['cement']
        self.n, self.length = int(numberOf(beam['n'])), numberOf(beam['length'])
        self.L = self.length/(self.n - 1)
        Rb = numberOf(cement['radiusFactor'])*self.L/2
        if cement['section'] == 'plate' and beam['frontAndBack'] == 'empty':
            self.A, self.I = 2*Rb, 2/3*Rb**3
        else:
            self.A, self.I = math.pi*Rb**2, math.pi*Rb**4/4
        self.J = 2*self.I
        self.E, self.G = numberOf(cement['E']), numberOf(cement['G'])
        self.kn, self.ks = self.E/self.L, self.G/self.L

    def tip(self, P):
        """Bending of each bond at its middle, and shear (ERRATA of the paper's 6.1)"""
        arms = (np.arange(1, self.n) - 0.5)*self.L
        return P*np.sum(arms**2)/(self.kn*self.I) + P*(self.n - 1)/(self.ks*self.A)

    def continuum(self, P):
        """Timoshenko's beam whose shear is taken up by the whole section, as a bond's is"""
        return P*self.length**3/(3*self.E*self.I) + P*self.length/(self.G*self.A)


def vectorOf(text):
    return [float(x) for x in text.strip('() ').split()]


def analyse(run):
    beam, tip = Beam(run), run.solid['groups']['tip']
    table = run.table('bodies')
    id_ = beam.n - 1
    out = []
    moment = vectorOf(tip['moment'])[0] if 'moment' in tip else 0
    if moment:
        last = clouds.times(run.path)[-1]
        cloud = clouds.readCloud(run.path, last, ['turned', 'origId'], 'solids')
        twist = cloud['turned'][np.argmax(cloud['origId']), 0]
        exact = moment*(beam.n - 1)/(beam.ks*beam.J)
        return [Quantity('twist of the tip [rad]', reference=exact, computed=twist,
                         error=abs(twist/exact - 1))]
    P = -vectorOf(tip['force'])[1]
    D = -table[f'{id_}Dy']
    exact, continuum = beam.tip(P), beam.continuum(P)
    out.append(Quantity('tip deflection [m]', reference=exact, computed=D[-1],
                        error=abs(D[-1]/exact - 1)))
    out.append(Quantity('still moving: change in the last tenth',
                        error=abs(D[-1]/D[int(0.9*len(D))] - 1)))
    out.append(Quantity('against the continuum', reference=continuum, computed=D[-1],
                        error=abs(D[-1]/continuum - 1)))
    return out


def compare(runs, results):
    """Order at which the continuum is reached with more and more particles"""
    errors = {}
    for name, run in runs.items():
        if name in ('n5', 'n11', 'n21'):
            errors[Beam(run).n] = next(q.error for q in results[name]
                                       if q.name == 'against the continuum')
    if len(errors) < 2:
        return []
    n = sorted(errors)
    order = math.log(errors[n[0]]/errors[n[-1]])/math.log((n[-1] - 1)/(n[0] - 1))
    return [Quantity('order of the continuum error in 1/n', reference=2, computed=order)]


def plot(runs, path):
    fig, (converge, settle) = plotting.figure(2)
    points = []
    for run in runs:
        beam, tip = Beam(run), run.solid['groups']['tip']
        if 'moment' in tip:
            continue
        table = run.table('bodies')
        P = -vectorOf(tip['force'])[1]
        D = -table[f'{beam.n - 1}Dy']
        settle.plot(table['Time'], D/beam.tip(P), label=run.name)
        if run.name in ('n5', 'n11', 'n21') or len(runs) == 1:
            points.append((beam.n, D[-1]/beam.continuum(P)))
    points = np.array(sorted(points))
    if len(points):
        n = np.arange(3, 42)
        converge.plot(points[:, 0], points[:, 1], 'o', label='computed')
        converge.plot(n, 1 - 1/(4*(n - 1.0)**2), '-', linewidth=0.8,
                      label='$1 - 1/4(n - 1)^2$: bending of n - 1 bonds')
        converge.axhline(1, color='k', linewidth=0.8, linestyle='--', label='continuum')
    converge.set(xlabel='particles', ylabel='tip deflection / continuum')
    settle.set(xlabel='t [s]', ylabel='tip deflection / closed form')
    for axis in (converge, settle):
        plotting.named(axis)
    plotting.save(fig, path)


def beam(n, *sets, section=0.1, length=2.0):
    """n particles, bonds of this radius [m], and long enough to come to rest"""
    factor = section/(0.5*length/(n - 1))
    sets = (f'system/beam:n {n}', f'bonds/cement/radiusFactor {factor:.17g}', *sets)
    return [option for s in sets for option in ('-set', s)]


variants = [
    Variant('n5', beam(5)),
    Variant('n11', beam(11)),
    Variant('n21', beam(21)),
    Variant('n11-E5', beam(11, 'bonds/cement/E 5e9')),
    Variant('n11-E2', beam(11, 'bonds/cement/E 2e9')),
    Variant('n11-G1', beam(11, 'bonds/cement/G 1e8')),
    Variant('n11-G8', beam(11, 'bonds/cement/G 8e8')),
    Variant('n11-thin', beam(11, section=0.08)),
    Variant('n11-thick', beam(11, section=0.15)),
    Variant('n11-plate', beam(11, 'bonds/cement/section plate')),
    *(Variant(f'n{n}-3D', beam(n, 'system/beam:frontAndBack patch')) for n in (5, 11, 21)),
    Variant('n11-torsion', beam(11, 'system/beam:frontAndBack patch', 'groups/tip/force (0 0 0)',
                                'groups/tip/moment (1 0 0)')),
    Variant('n11-verlet', beam(11, 'timeIntegration velocityVerlet')),
]

Study(
    scene='bondedCantilever',
    variants=variants,
    quick=[variants[0]],
    analyse=analyse,
    plot=plot,
    headline='tip deflection [m]',
    compare=compare,
).main(here)
