# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of equal spheres that fly at each other at 10 to 80 degrees from their line of centres,
each pair on its own plane"""
import math

from riprap.dictionaries import numberOf, readDictionary

impact = readDictionary('system/impact')
speed, radius = numberOf(impact['speed']), numberOf(impact['radius'])
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,u,v,w,radius\n')
    for i, degrees in enumerate(range(0, 90, 10)):
        angle = math.radians(degrees)
        for side in (-1, 1):
            x, z = side*radius*(1 + 1e-6), 0.1*(i - 4)
            u, v = -side*speed*math.cos(angle), -side*speed*math.sin(angle)
            f.write(f'{x:.17g},0,{z:.17g},{u:.17g},{v:.17g},0,{radius:.17g}\n')
