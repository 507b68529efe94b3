# SPDX-License-Identifier: GPL-3.0-or-later
"""Two fixed disks under the bar, just out of touch, and one that flies at its middle:
constant/particles.csv"""
from riprap.dictionaries import numberOf, readDictionary

speed = numberOf(readDictionary('system/blow')['speed'])
rows = [(x, -0.00401, 0, 0.004, 'supports') for x in (0.015, 0.105)]
top = 0.001*(2 + 6*3**0.5)          # of seven rows
rows.append((0.06, top + 0.00801, -speed, 0.008, 'hammer'))
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,u,v,w,radius,group\n')
    for x, y, v, radius, group in rows:
        f.write(f'{x:.17g},{y:.17g},0,0,{v:.17g},0,{radius:.17g},{group}\n')
