# SPDX-License-Identifier: GPL-3.0-or-later
"""A square of 1 m that turns by 1 rad/s about its middle: constant/particles.csv"""
import numpy as np
from riprap.dictionaries import numberOf, readDictionary

spacing = numberOf(readDictionary('system/setParticlesDict')['spacing'])
n = round(1/spacing)
centre = (np.arange(n) + 0.5)/n - 0.5
x, y = (a.ravel() for a in np.meshgrid(centre, centre))
z = np.full_like(x, 0.005)
np.savetxt('constant/particles.csv', np.column_stack([x, y, z, y, -x, 0*x, 0*x]),
           delimiter=',', header='x,y,z,u,v,w,p', comments='', fmt='%.12g')
print(f'{n*n} particles')
