# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/solids.csv: 30 rocks above the water, a gap and more apart, of different sizes"""
import random

random.seed(1)
pitch = 0.065
with open('constant/solids.csv', 'w') as out:
    out.write('x,y,z,radius\n')
    for layer in range(2):
        for i in range(5):
            for k in range(3):
                at = (0.11 + pitch*i + 0.001*random.random(), 0.155 + pitch*layer, 0.055 + pitch*k + 0.001*random.random())
                out.write('%.6g,%.6g,%.6g,%.6g\n' % (*at, 0.022 + 0.006*random.random()))
