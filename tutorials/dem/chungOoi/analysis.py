# SPDX-License-Identifier: GPL-3.0-or-later
"""Chung & Ooi (2011), tests 1-8, and MFIX's DEM01-DEM05: impacts of single spheres against closed
forms and published curves"""
import math
import os

import numpy as np

import chung
import mfix
from riprap import plotting
from riprap.study import Study, Variant
from spheres import points, records, spheres, testOf

here = os.path.dirname(os.path.abspath(__file__))


def analyse(run):
    name = testOf(run)
    return getattr(chung if hasattr(chung, name) else mfix, name)(run)


def plotPair(run, axis):
    for s, material in zip(spheres(run)[::2], ('glass', 'limestone')):
        axis.plot(s.t*1e6, np.linalg.norm(s.F, axis=1)/1e3, label=material)
        data = points(f'chung_test_1_{material}')
        plotting.measured(axis, data[:, 0], data[:, 1], f'{material}, Chung & Ooi',
                          material == 'limestone')
    axis.set(xlabel='t [us]', ylabel='normal force [kN]', title='test 1')


def plotOblique(run, axis):
    for k, (material, file) in enumerate((('alumina', 'al_oxide'), ('alloy', 'al_alloy'))):
        rows = [(math.degrees(math.atan2(s.U[0, 0], -s.U[0, 2])), s.U[-1, 0]/s.U[0, 0])
                for s in spheres(run) if s.material == material]
        axis.plot(*np.array(rows).T, '.-', label=material)
        data = points(f'chung_test_4_incident_angle_vs_tng_restitution_{file}')
        plotting.measured(axis, data[:, 0], data[:, 1], f'{material}, Chung & Ooi', k)
    axis.set(xlabel='angle of incidence [degrees]', ylabel='tangential restitution', title='test 4')


def plotTangential(run, axis):
    half = run.name.endswith('half')
    v, w, _ = chung.tangentialCurve(run, 'steel').T
    axis.plot(v, w, '--' if half else '-', label='steel, half the stiffness' if half else 'steel')
    if half:
        for k, (name, label) in enumerate((
                ('chung_test_5_normalized_post_collision_ang_vel_'
                 'vs_normalized_incident_angle_steel',
                 'DEM, Chung & Ooi'),
                ('cabana_test5_fem_wu_2003', 'finite elements, Wu et al.'))):
            plotting.measured(axis, *points(name).T, label, k)
    axis.set(xlabel='v / (mu v_n) before', ylabel='R w / (mu v_n) after', title='test 5',
             xlim=(0, 10))


def plotAngular(run, axis):
    axis.plot(*chung.angularCurve(run, 'alloy').T, label='alloy')
    axis.plot(*chung.angularCurve(run, 'copper').T, '--', label='copper')
    plotting.measured(axis, *points('cabana_test6_dem_al_alloy_chung').T, 'alloy, Chung & Ooi', 0)
    axis.set(xlabel='R w / v_n before', ylabel='surface over normal speed after', title='test 6')


def plotUnequal(run, axis):
    axis.plot(*chung.unequalCurve(run, 'alloy').T, '.:', label='alloy, test 8')


def plotKharaz(run, axis):
    law = run.solid['contact']['normal']
    axis.plot(*mfix.kharazCurves(run)['rebound_angle_deg'], label=law)
    data = records('DEM05_mfix_rebound_angle_deg')
    mine = np.char.startswith(data['model'], 'HERTZ' if law == 'hertz' else 'LINEAR')
    axis.plot(data['impact_angle_deg'][mine], data['particle_wall'][mine], ':',
              label=f'{law}, MFIX')
    if law == 'hertz':
        data = records('DEM05_exp_kharaz_rebound_angle_deg')
        plotting.measured(axis, data['impact_angle_deg'], data['rebound_angle_deg'],
                          'Kharaz et al.', 0)
    axis.set(xlabel='angle of incidence [degrees]', ylabel='angle of rebound [degrees]',
             title='DEM05')


def plotDrop(run, axis):
    for s in (s for s in spheres(run) if s.material == 'spring50'):
        early = s.t < 1.5
        line, = axis.plot(s.t[early], s.x[early, 2],
                          label=f"e {run.solid['pairs']['default']['restitution']}, 50 kN/m")
        bounces = mfix.Drop(s.radius, s.mass, 5e4,
                            float(run.solid['pairs']['default']['restitution']), 0.5, 25)
        t = np.linspace(0, 1.5, 400)
        axis.plot(t, bounces.at(t)[0], ':', color='k', linewidth=0.8)
    axis.set(xlabel='t [s]', ylabel='height [m]', title='DEM01, DEM02')


def plot(runs, path):
    fig, axes = plotting.figure(3, 2)
    panels = {'pair': (plotPair, 0), 'oblique': (plotOblique, 1), 'tangential': (plotTangential, 2),
              'angular': (plotAngular, 3), 'unequal': (plotUnequal, 3), 'kharaz': (plotKharaz, 4),
              'drop': (plotDrop, 5)}
    for run in runs:
        draw, panel = panels.get(testOf(run), (None, 0))
        shown = run.name in ('pair', 'drop0.5', 'drop0.9') or testOf(run) not in ('pair', 'drop')
        if draw and (shown or len(runs) == 1):
            draw(run, axes[panel])
    for axis in axes:
        if axis.lines or axis.collections:
            plotting.named(axis)
    plotting.save(fig, path)


def test(name, size, dt, end, *sets):
    changes = [f'system/test:name {name}', f'system/test:size {size}',
               f'system/controlDict:deltaT {dt}', f'system/controlDict:writeInterval {end}', *sets]
    return ['-endTime', end, *(option for s in changes for option in ('-set', s))]


gravity, gravityMfix = ('constant/g:value (0 0 -%s)' % x for x in (9.81, 9.80665))
sample = 'system/controlDict:sampleInterval '
friction, e = 'pairs/default/friction ', 'pairs/default/restitution '
linear, pulls = 'contact/normal linear', 'pairs/default/attraction yes'

kharazLaws = (('hertz', ()), ('linear', (f'pairs/default/stiffnessRatio {1.48/1.72:.6f}',)))

tests = [
    Variant('pair', test('pair', 0.5, '2e-8', '6e-5')),
    Variant('pair-mixed', test('pair', 0.5, '2e-8', '6e-5', 'precision mixed')),
    Variant('plane', test('plane', 1, '4e-7', '1e-3')),
    *(Variant(f'restitution{x}', test('restitution', 0.5, '5e-9', '3e-5', e + x))
      for x in ('0.2', '0.4', '0.6', '0.8', '1')),
    Variant('oblique',
            test('oblique', 1, '5e-9', '2e-5', e + '0.98', friction + '0.092', sample + '1e-6')),
    Variant('tangential',
            test('tangential', 0.002, '5e-11', '2.2e-7', friction + '0.3', sample + '2e-8')),
    Variant('tangential-half', test('tangential', 0.002, '5e-11', '2.2e-7', friction + '0.3',
                                    sample + '2e-8', 'pairs/steel-rigid/stiffnessRatio 0.41176',
                                    'pairs/polyethylene-rigid/stiffnessRatio 0.375')),
    Variant('angular',
            test('angular', 7, '4e-7', '1.5e-3', e + '0.5', friction + '0.4', sample + '1e-4')),
    Variant('twoSpheres',
            test('twoSpheres', 7, '4e-7', '1.5e-3', e + '0.5', friction + '0.4', sample + '1e-4')),
    Variant('unequal',
            test('unequal', 16, '4e-7', '4e-3', e + '0.5', friction + '0.4', sample + '1e-4')),
    *(Variant(f'drop{x}',
              test('drop', 4, dt, end, linear, pulls, gravityMfix, e + x, sample + '5e-3'))
      for x, dt, end in (('0.5', '5e-7', '1.5'), ('0.6', '5e-7', '1.8'), ('0.7', '5e-7', '2.4'),
                         ('0.8', '5e-7', '3.4'), ('0.9', '5e-7', '6.5'), ('1', '2e-6', '14.5'))),
    *(Variant(f'stack{x}', test('stack', 0.01, '1e-7', '1e-3', linear, pulls, gravityMfix, e + x,
                                sample + '1e-5', 'walls/planes/lid/point (0 0 0.0018)',
                                'pairs/default/stiffness 1e3',
                                'system/setParticlesDict:overlapTolerance 0.3'))
      for x in ('0.5', '0.6', '0.7', '0.8', '0.9', '1')),
    *(Variant(f'slide{mu}', test('slide', 0.01, '1e-6', '0.02', linear, e + '0.9', friction + mu,
                                 gravity, sample + '1e-5')) for mu in ('0.2', '0.5', '1')),
    *(Variant(f'kharaz-{law}', test('kharaz', 1, '5e-9', '3e-5', f'contact/normal {law}',
                                    friction + '0.092', sample + '1e-6', 'walls/material anvil',
                                    'pairs/default/stiffness 1.72e7', *more))
      for law, more in kharazLaws),
    *(Variant(f'kharazPair-{law}',
              test('kharazPair', 5, '5e-9', '3e-5', f'contact/normal {law}', friction + '0.092',
                   sample + '1e-6', 'walls/planes/floor/point (0 0 -1)',
                   'pairs/default/stiffness 1.72e7', *more)) for law, more in kharazLaws),
]

Study(
    scene='chungOoi',
    variants=tests,
    quick=[v for v in tests if v.name in ('pair', 'restitution0.6', 'tangential', 'stack0.7')],
    analyse=analyse,
    plot=plot,
    headline='largest overlap [m], glass',
).main(here)
