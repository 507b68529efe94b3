# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres of the test that system/test names, just before they touch: constant/particles.csv"""
import math

from riprap.dictionaries import readDictionary

columns = 'x,y,z,u,v,w,wx,wy,wz,radius,material'.split(',')
apart = 1 + 1e-6                                # of the radius, before they touch


def thrown(x, radius, material, down, along=0.0, spin=0.0):
    """Towards the plane z = 0, spin about y"""
    return [x, 0, radius*apart, along, 0, -down, 0, spin, 0, radius, material]


def flying(x, radius, material, speed, angle):
    """The same, angle from the plane's normal"""
    return thrown(x, radius, material, speed*math.cos(angle), speed*math.sin(angle))


def meeting(y, left, right, spins):
    """Two spheres (radius, material, speed along x) that meet at x = 0, spins about z"""
    return [[side*radius*apart, y, 1, speed, 0, 0, 0, 0, w, radius, material]
            for side, (radius, material, speed), w in zip((-1, 1), (left, right), spins)]


def pair():
    """Test 1"""
    rows = []
    for x, material in ((-0.1, 'glass'), (0.1, 'limestone')):
        for side in (-1, 1):
            rows.append([x + side*0.01*apart, 0, 0.2, -10*side, 0, 0, 0, 0, 0, 0.01, material])
    return rows


def plane():
    """Test 2"""
    return [thrown(-0.3, 0.1, 'aluminium', 0.2), thrown(0.3, 0.1, 'magnesium', 0.2)]


def restitution():
    """Test 3"""
    return [thrown(-0.1, 0.0025, 'alumina', 3.9), thrown(0.1, 0.0025, 'castIron', 3.9)]


def oblique():
    """Test 4: Kharaz's impacts, one speed"""
    return [flying(0.01*i, 0.0025, material, 3.9, math.radians(degrees))
            for i, (material, degrees) in enumerate((m, d) for m in ('alumina', 'alloy')
                                                    for d in range(5, 90, 5))]


def tangential():
    """Test 5: one normal velocity; tangential velocities are 0.25 to 20 mu v_n"""
    ratios = [0.25*i for i in range(1, 33)] + [10, 12, 15, 20]
    return [thrown(3e-5*(i - 36), 1e-5, material, 5, r*0.3*5)
            for i, (material, r) in enumerate((m, r) for m in ('steel', 'polyethylene')
                                              for r in ratios)]


def angular():
    """Test 6: one normal velocity, no tangential one, spins of 0.1 to 6 v_n/R"""
    ratios = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4,
              5, 6]
    return [thrown(0.3*(i - 20), 0.1, material, 0.2, spin=r*2)
            for i, (material, r) in enumerate((m, r) for m in ('alloy', 'copper') for r in ratios)]


spins = (0.175, 0.5, 1, 2, 3, 4, 5, 7, 9, 12, 16, 22)


def twoSpheres():
    """Test 7: equal spheres, equal spins, 0.2 m/s each"""
    rows = []
    for i, (material, w) in enumerate((m, w) for m in ('alloy', 'copper') for w in spins):
        rows += meeting(0.5*(i - 12), (0.1, material, 0.2), (0.1, material, -0.2), (w, w))
    return rows


def unequal():
    """Test 8: a spinning sphere against one of five times the radius and a thousand times the
    density, at rest"""
    rows = []
    for i, (material, w) in enumerate((m, w) for m in ('alloy', 'nylon') for w in spins):
        rows += meeting(1.2*(i - 12), (0.1, material, 0.2),
                        (0.5, 'heavy' + material.capitalize(), 0), (w, 0))
    return rows


springs = (10, 25, 50, 100, 500, 5000)          # [kN/m], each with a material of its own


def drop():
    """MFIX's DEM01 and DEM02: falls by 0.4 m on springs"""
    return [[i - 2.5, 0, 0.5, 0, 0, 0, 0, 0, 0, 0.1, f'spring{k}'] for i, k in enumerate(springs)]


def stack():
    """MFIX's DEM03: two spheres in a gap that is too small for them"""
    return [[0, 0, z, 0, 0, 0, 0, 0, 0, 0.0005, material]
            for z, material in ((0.00045, 'stackLower'), (0.00135, 'stackUpper'))]


def slide():
    """MFIX's DEM04: at rest on the plane in z under gravity, k = 1e4 N/m, and moving along x"""
    radius, k = 0.0005, 1e4
    weight = 1e4*4/3*math.pi*radius**3*9.81
    return [[0, 0, radius - weight/k, 0.1, 0, 0, 0, 0, 0, radius, 'mfix']]


angles = [0, 0.5, 1, 1.5, 2] + [2.5*i for i in range(1, 27)]


def kharaz():
    """MFIX's DEM05: its angles"""
    return [flying(0.01*i, 0.0025, 'dem05', 3.9, math.radians(degrees))
            for i, degrees in enumerate(angles)]


def kharazPair():
    """The same on spheres of fifty times the radius and the wall's material, too heavy to move"""
    size = 50*0.0025
    targets = [[0.3*(i - 15), 0, -size, 0, 0, 0, 0, 0, 0, size, 'heavyAnvil']
               for i in range(len(angles))]
    return [flying(0.3*(i - 15), 0.0025, 'dem05', 3.9, math.radians(degrees))
            for i, degrees in enumerate(angles)] + targets


rows = globals()[readDictionary('system/test')['name']]()
with open('constant/particles.csv', 'w') as f:
    f.write(','.join(columns) + '\n')
    for row in rows:
        f.write(','.join(v if isinstance(v, str) else f'{v:.17g}' for v in row) + '\n')
