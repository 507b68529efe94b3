# SPDX-License-Identifier: GPL-3.0-or-later
"""Chung & Ooi (2011), tests 1-4 and 7, and MFIX's DEM04: impacts of single spheres against closed forms"""
import csv
import math
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


class Sphere:
    """A sphere's line of constant/particles.csv and its history"""

    def __init__(self, run, index, line, table):
        self.radius, self.material = float(line['radius']), line['material']
        self.t = table['Time']
        def of(name):
            return np.column_stack([table[f'{index}{name}{axis}'] for axis in 'xyz'])
        self.x = np.column_stack([table[f'{index}{axis}'] for axis in 'XYZ'])
        self.U, self.W, self.F = of('U'), of('W'), of('F')
        m = run.solid['materials'][self.material]
        self.E, self.nu, self.rho = (numberOf(m[k]) for k in ('E', 'nu', 'rho'))
        self.mass = self.rho*4/3*math.pi*self.radius**3


def spheres(run):
    table = run.table('bodies')
    with open(os.path.join(run.path, 'constant', 'particles.csv')) as f:
        return [Sphere(run, i, line, table) for i, line in enumerate(csv.DictReader(f))]


def hertz(E, R, m, v):
    """Largest overlap, largest force and duration of an elastic impact (E*, R*, m* of the pair)"""
    overlap = (15*m*v*v/(16*E*math.sqrt(R)))**0.4
    return overlap, 4/3*E*math.sqrt(R)*overlap**1.5, 2.943275*overlap/v


def duration(t, overlap):
    """Between the zeros of the overlap"""
    i = np.flatnonzero(overlap > 0)
    a, b = i[0], i[-1]
    start = t[a - 1] + (t[a] - t[a - 1])*(-overlap[a - 1])/(overlap[a] - overlap[a - 1])
    end = t[b] + (t[b + 1] - t[b])*overlap[b]/(overlap[b] - overlap[b + 1])
    return end - start


def impact(name, t, overlap, force, exact):
    computed = (overlap.max(), force.max(), duration(t, overlap))
    return [Quantity(f'{what}, {name}', reference=e, computed=c, error=abs(c/e - 1))
            for what, e, c in zip(('largest overlap [m]', 'largest force [N]', 'duration [s]'), exact, computed)]


def pair(run):
    """Test 1: two equal spheres, 20 m/s"""
    out, all_ = [], spheres(run)
    for a, b in (all_[:2], all_[2:]):
        overlap = 2*a.radius - np.linalg.norm(a.x - b.x, axis=1)
        E = a.E/(2*(1 - a.nu**2))
        out += impact(a.material, a.t, overlap, np.linalg.norm(a.F, axis=1), hertz(E, a.radius/2, a.mass/2, 20.0))
    return out


def plane(run):
    """Test 2: a sphere on a rigid plane, 0.2 m/s"""
    out = []
    for s in spheres(run):
        E = s.E/(1 - s.nu**2)
        out += impact(s.material, s.t, s.radius - s.x[:, 2], s.F[:, 2], hertz(E, s.radius, s.mass, 0.2))
    return out


def restitution(run):
    """Test 3: the speed after over that before"""
    e = numberOf(run.solid['pairs']['default']['restitution'])
    return [Quantity(f'restitution, {s.material}', reference=e, computed=s.U[-1, 2]/3.9, error=abs(s.U[-1, 2]/3.9 - e))
            for s in spheres(run)]


def afterOblique(s, e, mu):
    """Tangential restitution and spin of a sphere, and those of a rigid one that slides throughout"""
    dv = mu*(1 + e)*-s.U[0, 2]
    return (s.U[-1, 0]/s.U[0, 0], 1 - dv/s.U[0, 0]), (s.W[-1, 1], 2.5*dv/s.radius)


def oblique(run):
    """Test 4: 5 to 85 degrees; beyond 32.5 degrees a rigid sphere slides throughout"""
    worst = {'tangential restitution': 0.0, 'spin': 0.0}
    for s in spheres(run):
        if math.degrees(math.atan2(s.U[0, 0], -s.U[0, 2])) < 37:        # elastic spheres stick a little longer
            continue
        for name, (computed, exact) in zip(worst, afterOblique(s, 0.98, 0.092)):
            worst[name] = max(worst[name], abs(computed/exact - 1))
    return [Quantity(f'{name}, from 40 degrees', error=error) for name, error in worst.items()]


def spin(run):
    """Test 7: a spinning sphere falls on a plane: mu (1 + e) v of tangential velocity while it slides throughout"""
    worst = 0.0
    for s in spheres(run):
        if abs(s.W[0, 1])*s.radius > 3.5*0.4*1.5*0.2*1.2:
            worst = max(worst, abs(abs(s.U[-1, 0])/(0.4*1.5*0.2) - 1))
    return [Quantity('tangential velocity in gross sliding', error=worst)]


def slide(run):
    """DEM04: from sliding to rolling"""
    s, mu = spheres(run)[0], numberOf(run.solid['pairs']['default']['friction'])
    v = s.U[:, 0]
    exact = 2*0.1/(7*mu*9.81)
    # the line of sliding meets the level of rolling
    early = s.t < 0.8*exact
    slope, at0 = np.polyfit(s.t[early], v[early], 1)
    time = (v[-1] - at0)/slope
    return [Quantity('velocity when rolling / u0', reference=5/7, computed=v[-1]/0.1, error=abs(v[-1]/0.1*7/5 - 1)),
            Quantity('spin when rolling, R w / u0', reference=5/7, computed=s.W[-1, 1]*s.radius/0.1,
                     error=abs(s.W[-1, 1]*s.radius/0.1*7/5 - 1)),
            Quantity('end of sliding [s]', reference=exact, computed=time, error=abs(time/exact - 1))]


def analyse(run):
    return globals()[run.dictionary('system/test')['name']](run)


def points(name):
    return np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1)


def plot(runs, path):
    fig, (force, angle) = plotting.figure(2)
    for run in runs:
        name = run.dictionary('system/test')['name']
        if name == 'pair':
            for s, material in zip(spheres(run)[::2], ('glass', 'limestone')):
                force.plot(s.t*1e6, np.linalg.norm(s.F, axis=1)/1e3, label=material)
                data = points(f'chung_test_1_{material}')
                plotting.measured(force, data[:, 0], data[:, 1], f'{material}, Chung & Ooi', material == 'limestone')
        if name == 'oblique':
            for k, material in enumerate(('alumina', 'alloy')):
                rows = [(math.degrees(math.atan2(s.U[0, 0], -s.U[0, 2])), s.U[-1, 0]/s.U[0, 0])
                        for s in spheres(run) if s.material == material]
                angle.plot(*np.array(rows).T, '.-', label=material)
            for k, file in enumerate(('al_oxide', 'al_alloy')):
                data = points(f'chung_test_4_incident_angle_vs_tng_restitution_{file}')
                plotting.measured(angle, data[:, 0], data[:, 1], f'{file}, Chung & Ooi', k)
    force.set(xlabel='t [us]', ylabel='normal force [kN]', title='test 1')
    angle.set(xlabel='angle of incidence [degrees]', ylabel='tangential restitution', title='test 4')
    for axis in (force, angle):
        axis.legend(fontsize=7)
    plotting.save(fig, path)


def test(name, size, dt, end, *sets):
    changes = [f'system/test:name {name}', f'system/test:size {size}', f'system/controlDict:deltaT {dt}',
               f'system/controlDict:writeInterval {end}', *sets]
    return ['-endTime', end, *(option for s in changes for option in ('-set', s))]


tests = [
    Variant('pair', test('pair', 0.5, '2e-8', '6e-5')),
    Variant('pair-mixed', test('pair', 0.5, '2e-8', '6e-5', 'precision mixed')),
    Variant('plane', test('plane', 1, '4e-7', '1e-3')),
    *(Variant(f'restitution{e}', test('restitution', 0.5, '5e-9', '3e-5', f'pairs/default/restitution {e}'))
      for e in ('0.2', '0.4', '0.6', '0.8', '1')),
    Variant('oblique', test('oblique', 1, '5e-9', '2e-5', 'pairs/default/restitution 0.98',
                            'pairs/default/friction 0.092')),
    Variant('spin', test('spin', 5, '4e-7', '1.5e-3', 'pairs/default/restitution 0.5', 'pairs/default/friction 0.4')),
    *(Variant(f'slide{mu}', test('slide', 0.01, '1e-6', '0.02', 'contact/normal linear', 'pairs/default/restitution 0.9',
                                 f'pairs/default/friction {mu}', 'constant/g:value (0 0 -9.81)',
                                 'system/controlDict:sampleInterval 1e-5'))
      for mu in ('0.2', '0.5', '1')),
]

Study(
    scene='chungOoi',
    variants=tests,
    quick=[tests[0], tests[5]],
    analyse=analyse,
    plot=plot,
    headline='largest overlap [m], glass',
).main(here)
