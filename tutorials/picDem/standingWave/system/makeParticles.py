# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat water with the velocity of a standing wave as it passes through rest level:
constant/particles.csv

    phi = V/(k sinh(k H)) cosh(k y) cos(k x),   (u, v) = grad phi,   p = rho g (H - y)

V is the amplitude of the surface's vertical velocity: eta = V/omega sin(omega t) cos(k x).
"""
import numpy as np
from riprap.dictionaries import numberOf, readDictionary

tank = {k: numberOf(v) for k, v in readDictionary('system/tank').items() if k != 'FoamFile'}
spacing = numberOf(readDictionary('system/setParticlesDict')['spacing'])
rho = numberOf(readDictionary('constant/fluidProperties')['rho'])
L, H, V = tank['wavelength'], tank['depth'], tank['velocityAmplitude']
k = 2*np.pi/L
nx, ny = round(L/spacing), round(H/spacing)
x, y = (a.ravel() for a in np.meshgrid((np.arange(nx) + 0.5)*L/nx, (np.arange(ny) + 0.5)*H/ny))
scale = V/np.sinh(k*H)
u = -scale*np.cosh(k*y)*np.sin(k*x)
v = scale*np.sinh(k*y)*np.cos(k*x)
p = rho*9.81*(H - y)
z = np.full_like(x, 0.005)
np.savetxt('constant/particles.csv', np.column_stack([x, y, z, u, v, 0*u, p]),
           delimiter=',', header='x,y,z,u,v,w,p', comments='', fmt='%.12g')
print(f'{nx*ny} particles')
