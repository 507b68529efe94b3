# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of n touching spheres of 0.1 m along x: the first one held, the last one moved.
constant/particles.csv"""
from riprap.dictionaries import numberOf, readDictionary

bar = readDictionary('system/bar')
n, rigid = int(numberOf(bar['n'])), bar['rigid'] == 'yes'
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,radius,group\n')
    for i in range(n):
        left = i < n//2
        if rigid or i in (0, n - 1):
            group = 'held' if left else 'moved'
        else:
            group = 'left' if left else 'right'
        f.write(f'{0.2*i:.17g},0,0,0.1,{group}\n')
