# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/solids.csv: three rows of rocks, each in the hollows of the one below, a gap apart"""
from riprap.dictionaries import numberOf, readDictionary

tank = readDictionary('system/tank')
gap, foot = numberOf(tank['gap']), numberOf(tank['foot'])
radius = 0.03
pitch = 2*radius + gap
with open('constant/solids.csv', 'w') as out:
    out.write('x,y,z,radius\n')
    for row, count in enumerate((7, 6, 5)):
        for i in range(count):
            out.write('%.10g,%.10g,0.005,%g\n' % (foot + radius + pitch*(i + 0.5*row),
                                                  gap + radius + row*pitch*0.75**0.5, radius))
