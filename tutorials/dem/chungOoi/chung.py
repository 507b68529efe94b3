# SPDX-License-Identifier: GPL-3.0-or-later
"""Chung & Ooi's tests: what is measured, and what it should be"""
import math

import numpy as np

from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from spheres import points, rms, spheres


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
            for what, e, c in zip(('largest overlap [m]', 'largest force [N]', 'duration [s]'),
                                  exact, computed)]


def pair(run):
    """Test 1: two equal spheres, 20 m/s"""
    out, all_ = [], spheres(run)
    for a, b in (all_[:2], all_[2:]):
        overlap = 2*a.radius - np.linalg.norm(a.x - b.x, axis=1)
        E = a.E/(2*(1 - a.nu**2))
        out += impact(a.material, a.t, overlap, np.linalg.norm(a.F, axis=1),
                      hertz(E, a.radius/2, a.mass/2, 20.0))
    return out


def plane(run):
    """Test 2: a sphere on a rigid plane, 0.2 m/s"""
    out = []
    for s in spheres(run):
        E = s.E/(1 - s.nu**2)
        out += impact(s.material, s.t, s.radius - s.x[:, 2], s.F[:, 2],
                      hertz(E, s.radius, s.mass, 0.2))
    return out


def restitution(run):
    """Test 3: the speed after over that before"""
    e = numberOf(run.solid['pairs']['default']['restitution'])
    return [Quantity(f'restitution, {s.material}', reference=e, computed=s.U[-1, 2]/3.9,
                     error=abs(s.U[-1, 2]/3.9 - e)) for s in spheres(run)]


def afterOblique(s, e, mu):
    """Tangential restitution and spin of a sphere, and those of a rigid one that slides
    throughout"""
    dv = mu*(1 + e)*-s.U[0, 2]
    return (s.U[-1, 0]/s.U[0, 0], 1 - dv/s.U[0, 0]), (s.W[-1, 1], 2.5*dv/s.radius)


def oblique(run):
    """Test 4: 5 to 85 degrees; beyond 32.5 degrees a rigid sphere slides throughout"""
    worst = {'tangential restitution': 0.0, 'spin': 0.0}
    for s in spheres(run):
        # elastic spheres stick a little longer
        if math.degrees(math.atan2(s.U[0, 0], -s.U[0, 2])) < 37:
            continue
        for name, (computed, exact) in zip(worst, afterOblique(s, 0.98, 0.092)):
            worst[name] = max(worst[name], abs(computed/exact - 1))
    return [Quantity(f'{name}, from 40 degrees', error=error) for name, error in worst.items()]


def tangentialCurve(run, material):
    """Test 5, e = 1: v/(mu v_n) before, R w/(mu v_n) and the contact point's v/(mu v_n) after
    (signs as the paper's)"""
    scale = 0.3*5
    return np.array(
        [(s.U[0, 0]/scale, -s.radius*s.W[-1, 1]/scale, (s.U[-1, 0] - s.radius*s.W[-1, 1])/scale)
         for s in spheres(run) if s.material == material])


def slidingSpin(s):
    """R w/(mu v_n) of an elastic sphere that slides throughout on a rigid plane: 5 on an arm that
    the overlap shortens; it does so by the overlap's mean over the impulse, the integral of (1 -
    u^2)^(2/5) = 0.81759 times the largest one"""
    overlap = hertz(s.E/(1 - s.nu**2), s.radius, s.mass, 5.0)[0]
    return 5*(1 - 0.81759*overlap/s.radius)


def tangential(run):
    """Test 5: a sphere that slides throughout ends with R w = 5 mu v_n; below that, the paper's
    curves"""
    out = []
    for material in ('steel', 'polyethylene'):
        v, w, recoil = tangentialCurve(run, material).T
        spin = slidingSpin(next(s for s in spheres(run) if s.material == material))
        slides = v >= 8
        out.append(Quantity(f'gross sliding, {material}',
                            error=float(max(abs(w[slides]/-spin - 1).max(),
                                            abs((v - recoil)[slides]/(2 + spin) - 1).max()))))
        longer = w*5/spin                       # Chung & Ooi's arms are R, whatever the overlap
        for what, computed, file in (('spin', longer, 'post_collision_ang_vel'),
                                     ('recoil', recoil + longer - w, 'recoil_angle')):
            data = points(f'chung_test_5_normalized_{file}_vs_normalized_incident_angle_{material}')
            out.append(Quantity(f'{what}, {material}: rms against Chung & Ooi',
                                error=rms(np.interp(data[:, 0], v, computed) - data[:, 1])))
    v, w, _ = tangentialCurve(run, 'steel').T
    steel = (
        points('chung_test_5_normalized_post_collision_ang_vel_vs_normalized_incident_angle_steel'))
    again, elements = points('cabana_test5_dem_steel_chung'), points('cabana_test5_fem_wu_2003')
    out.append(Quantity('spin, steel: rms against finite elements',
                        error=rms(np.interp(elements[:, 0], v, w) - elements[:, 1])))
    out.append(Quantity('spin, steel: rms between two readings of that figure',
                        computed=rms(np.interp(steel[:, 0], *again.T) - steel[:, 1])))
    return out


def angularCurve(run, material):
    """Test 6: surface speed over normal speed, before and after"""
    return np.array([(-s.radius*s.W[0, 1]/s.U[0, 2], (s.radius*s.W[-1, 1] - s.U[-1, 0])/s.U[-1, 2])
                     for s in spheres(run) if s.material == material])


def angular(run):
    """Test 6: mu 0.4, e 0.5; a rigid sphere slides throughout above R w = 3.5 mu (1 + e) v_n = 2.1
    v_n"""
    out = []
    for material in ('alloy', 'copper'):
        before, after = angularCurve(run, material).T
        slides = before >= 3
        exact = (before - 2.1)/0.5
        out.append(Quantity(f'recoil in gross sliding, {material}',
                            error=float(abs(after/exact - 1)[slides].max())))
    before, after = angularCurve(run, 'alloy').T
    data = points('cabana_test6_dem_al_alloy_chung')
    for what, part in (('sticking', data[:, 0] < 2.5), ('sliding', data[:, 0] >= 2.5)):
        out.append(Quantity(f'recoil, alloy, {what}: rms against Chung & Ooi',
                            error=rms((np.interp(data[:, 0], before, after) - data[:, 1])[part])))
    return out


def twoSpheres(run):
    """Test 7: while they slide throughout, each gets mu (1 + e) v of tangential velocity; arms and
    impulses agree in any case"""
    out, all_ = [], spheres(run)
    gain, spin = 0.4*1.5*0.2, 0.0
    for material in ('alloy', 'copper'):
        pairs = [(a, b) for a, b in zip(all_[::2], all_[1::2]) if a.material == material]
        sliding = max(abs(abs(a.U[-1, 1])/gain - 1) for a, b in pairs
                      if a.W[0, 2]*a.radius > 3.5*gain*1.4)
        out.append(Quantity(f'tangential velocity in gross sliding, {material}', error=sliding))
        spin = max(spin, max(abs((a.W[0, 2] - a.W[-1, 2])*0.4*a.radius/abs(a.U[-1, 1]) - 1)
                             for a, b in pairs))
    out.append(Quantity('loss of spin, 5/2 v/R', error=spin))
    out.append(Quantity('equal and opposite', error=max(abs(a.U[-1] + b.U[-1]).max()/0.2
                                                        for a, b in zip(all_[::2], all_[1::2]))))
    return out


def unequalCurve(run, material):
    """Test 8: as test 6, of the small sphere"""
    all_ = spheres(run)
    return np.array([(s.radius*s.W[0, 2]/s.U[0, 0],
                      (s.radius*s.W[-1, 2] + s.U[-1, 1] - big.U[-1, 1])/-s.U[-1, 0])
                     for s, big in zip(all_[::2], all_[1::2]) if s.material == material])


def unequal(run):
    """Test 8: a sphere 125 000 times as heavy is a plane to the small one"""
    out, all_ = [], spheres(run)
    for material in ('alloy', 'nylon'):
        before, after = unequalCurve(run, material).T
        slides = before >= 3
        out.append(Quantity(f'recoil in gross sliding, {material}',
                            error=float(abs(after/((before - 2.1)/0.5) - 1)[slides].max())))
    worst = 0.0
    for a, b in zip(all_[::2], all_[1::2]):
        def angular_(s, i):
            return s.mass*np.cross(s.x[i], s.U[i]) + 0.4*s.mass*s.radius**2*s.W[i]
        change = angular_(a, -1) + angular_(b, -1) - angular_(a, 0) - angular_(b, 0)
        worst = max(worst, np.linalg.norm(change)/(a.mass*0.2*a.radius))
    out.append(Quantity('angular momentum, change / m v R', error=float(worst)))
    return out
