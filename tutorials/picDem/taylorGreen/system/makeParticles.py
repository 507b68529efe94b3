# SPDX-License-Identifier: GPL-3.0-or-later
"""Square lattice with the Taylor-Green velocity and pressure: constant/particles.csv

    u = -U cos(2 pi x) sin(2 pi y),  v = U sin(2 pi x) cos(2 pi y)
    p = -rho U^2/4 (cos(4 pi x) + cos(4 pi y)) + p0

p0 = rho U^2/2 keeps the whole square out of tension; in a closed square it stays and moves nothing.
"""
import numpy as np
from riprap.dictionaries import numberOf, readDictionary

spacing = numberOf(readDictionary('system/setParticlesDict')['spacing'])
rho = numberOf(readDictionary('constant/fluidProperties')['rho'])
n = round(1/spacing)
centre = (np.arange(n) + 0.5)/n
x, y = (a.ravel() for a in np.meshgrid(centre, centre))
u = -np.cos(2*np.pi*x)*np.sin(2*np.pi*y)
v = np.sin(2*np.pi*x)*np.cos(2*np.pi*y)
p = rho*(0.5 - 0.25*(np.cos(4*np.pi*x) + np.cos(4*np.pi*y)))
z = np.full_like(x, 0.005)
np.savetxt('constant/particles.csv', np.column_stack([x, y, z, u, v, 0*u, p]),
           delimiter=',', header='x,y,z,u,v,w,p', comments='', fmt='%.12g')
print(f'{n*n} particles')
