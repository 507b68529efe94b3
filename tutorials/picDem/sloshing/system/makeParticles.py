# SPDX-License-Identifier: GPL-3.0-or-later
"""Water at rest under a surface y = H + A cos(pi x/L): constant/particles.csv"""
import numpy as np
from riprap.dictionaries import numberOf, readDictionary

tank = {k: numberOf(v) for k, v in readDictionary('system/tank').items() if k != 'FoamFile'}
spacing = numberOf(readDictionary('system/setParticlesDict')['spacing'])
L, H, A = tank['width'], tank['depth'], tank['amplitude']
nx = round(L/spacing)
rows = []
for i in range(nx):
    x = (i + 0.5)*L/nx
    top = H + A*np.cos(np.pi*x/L)
    ny = round(top/spacing)
    rows += [(x, (j + 0.5)*top/ny, 0.005, 0, 0, 0, 0) for j in range(ny)]
np.savetxt('constant/particles.csv', np.array(rows), delimiter=',', header='x,y,z,u,v,w,p',
           comments='', fmt='%.12g')
print(f'{len(rows)} particles')
