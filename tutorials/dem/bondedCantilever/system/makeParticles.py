# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of n touching spheres along x: constant/particles.csv"""
from riprap.dictionaries import numberOf, readDictionary

beam = readDictionary('system/beam')
n, length = int(numberOf(beam['n'])), numberOf(beam['length'])
radius = 0.5*length/(n - 1)
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,radius,group\n')
    for i in range(n):
        group = 'clamp' if i == 0 else 'tip' if i == n - 1 else 'beam'
        f.write(f'{2*radius*i:.17g},0,0,{radius:.17g},{group}\n')
