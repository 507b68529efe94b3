# SPDX-License-Identifier: GPL-3.0-or-later
"""Spheres of the test that system/test names, just before they touch: constant/particles.csv"""
import math

from riprap.dictionaries import readDictionary

columns = 'x,y,z,u,v,w,wx,wy,wz,radius,material'.split(',')


def flying(x, radius, material, speed, angle=0.0, spin=0.0):
    """Towards the plane z = 0, angle from its normal in the xz plane, spin about y"""
    return [x, 0, radius*(1 + 1e-6), speed*math.sin(angle), 0, -speed*math.cos(angle), 0, spin, 0, radius, material]


def pair():
    rows = []
    for x, material in ((-0.1, 'glass'), (0.1, 'limestone')):
        for side in (-1, 1):
            rows.append([x + side*0.01*(1 + 1e-6), 0, 0.2, -10*side, 0, 0, 0, 0, 0, 0.01, material])
    return rows


def plane():
    return [flying(-0.3, 0.1, 'aluminium', 0.2), flying(0.3, 0.1, 'magnesium', 0.2)]


def restitution():
    return [flying(-0.1, 0.0025, 'alumina', 3.9), flying(0.1, 0.0025, 'castIron', 3.9)]


def oblique():
    return [flying(0.01*i, 0.0025, material, 3.9, math.radians(degrees))
            for i, (material, degrees) in enumerate((m, d) for m in ('alumina', 'alloy') for d in range(5, 90, 5))]


def spin():
    return [flying(0.3*i - 2.5, 0.1, material, 0.2, spin=w)
            for i, (material, w) in enumerate((m, w) for m in ('aluminium', 'copper') for w in (2, 4, 6, 8, 12, 16, 20, 24))]


def slide():
    """MFIX's DEM04: at rest on the plane in z under gravity, k = 1e4 N/m, and moving along x"""
    radius, k = 0.0005, 1e4
    weight = 1e4*4/3*math.pi*radius**3*9.81
    return [[0, 0, radius - weight/k, 0.1, 0, 0, 0, 0, 0, radius, 'mfix']]


rows = globals()[readDictionary('system/test')['name']]()
with open('constant/particles.csv', 'w') as f:
    f.write(','.join(columns) + '\n')
    for row in rows:
        f.write(','.join(v if isinstance(v, str) else f'{v:.17g}' for v in row) + '\n')
