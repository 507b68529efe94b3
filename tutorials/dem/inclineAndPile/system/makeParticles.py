# SPDX-License-Identifier: GPL-3.0-or-later
"""A sphere on the plane z = 0, or a pyramid of 4 x 4 + 3 x 3 + 2 x 2 + 1 spheres:
constant/particles.csv"""
import math

from riprap.dictionaries import readDictionary

radius = 0.005
weight = 2500*4/3*math.pi*radius**3*9.81
rows = []
if readDictionary('system/scene')['name'] == 'slope':
    rows.append((0, 0, radius - weight*math.cos(math.radians(10))/2e4, 'noSpin'))
else:
    for layer, n in enumerate((4, 3, 2, 1)):
        for i in range(n):
            for j in range(n):
                offset = radius*(1 - n)
                rows.append((offset + 2*radius*i, offset + 2*radius*j,
                             radius*(1 + layer*math.sqrt(2)), 'noSpin'))
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,radius,group\n')
    for x, y, z, group in rows:
        f.write(f'{x:.17g},{y:.17g},{z:.17g},{radius:.17g},{group}\n')
