# SPDX-License-Identifier: GPL-3.0-or-later
"""A body of rings (2D) or shells (3D) of equal thickness, and water on a lattice about it:
constant/solids.csv, constant/particles.csv

A ring or shell is cut into equal parts of about the body's spacing, each with its exact area or
volume. Two more of water surround it, then a lattice. The water is as much as fills the tank to
`depth` about the body at rest: what the layers and the lattice do not take stands on top.
"""
import sys

import numpy as np
from riprap.dictionaries import numberOf, readDictionary

# potentialFlow.py is in the case, of which a run is in runs/NAME
sys.path[:0] = ['.', '../..']
from potentialFlow import Body  # noqa: E402

tank = {k: v for k, v in readDictionary('system/tank').items() if k != 'FoamFile'}
tank = {k: numberOf(v) for k, v in tank.items()}
threeD = readDictionary('system/frontAndBack')['frontAndBack'] == 'wall'
D = 3 if threeD else 2
dp = numberOf(readDictionary('system/setParticlesDict')['spacing'])
rhoWater = numberOf(readDictionary('constant/fluidProperties')['rho'])
rho = numberOf(readDictionary('constant/solidProperties')['materials']['body']['rho'])
R, width, depth = tank['radius'], tank['width'], tank['depth']
body = Body(R, min(rho/rhoWater, 1), D)
height = depth + body.centre + tank['displacement'] if rho < rhoWater else tank['start']
middle = np.array([0.5*width, height, 0.5*tank['thickness']])
layers = 2                              # of water about the body


def ring(inner, s, cell=None):
    """Points half-way through a ring or shell from radius `inner` on, s thick: of about its own
    spacing, or as many as `cell` goes into its volume; that volume"""
    k, r = inner/s, inner + 0.5*s
    volume = np.pi*(2*k + 1)*s**2 if D == 2 else 4*np.pi/3*((k + 1)**3 - k**3)*s**3
    if cell:
        m = int(round(volume/cell))
    else:
        m = (max(int(round(2*np.pi*(k + 0.5))), 3) if D == 2
             else max(int(round(4*np.pi*((k + 0.5)**2 + 1/12))), 4))
    i = np.arange(m) + 0.5
    if threeD:
        # spread by the golden angle
        polar, around = np.arccos(1 - 2*i/m), np.pi*(1 + np.sqrt(5))*i
        x = np.column_stack([np.cos(around)*np.sin(polar), np.cos(polar),
                             np.sin(around)*np.sin(polar)])
    else:
        angle = 2*np.pi*i/m
        x = np.column_stack([np.sin(angle), -np.cos(angle), 0*angle])
    return middle + r*x, volume


def rings():
    n = max(int(round(R/(tank['bodySpacing']*dp))), 1)
    s = R/n
    all = [ring(k*s, s) for k in range(n)]
    return (np.concatenate([x for x, _ in all]),
            np.concatenate([np.full(len(x), v/len(x)) for x, v in all]), s)


x, volume, s = rings()
np.savetxt('constant/solids.csv', np.column_stack([x, np.full(len(x), 0.5*s), rho*volume]),
           delimiter=',', header='x,y,z,radius,mass', comments='', fmt='%.12g')

nx = int(round(width/dp))
side = (np.arange(nx) + 0.5)*width/nx
cell = (width/nx)**(D - 1)*dp
rows = int(round(tank['height']/dp)) - 1
grid = np.meshgrid((np.arange(rows) + 0.5)*dp, side, side if threeD else [middle[2]], indexing='ij')
lattice = np.column_stack([grid[1].ravel(), grid[0].ravel(), grid[2].ravel()])
# layers about the body first: a lattice that is cut at its surface leaves half a spacing empty
points = np.concatenate([ring(R + k*dp, dp, cell)[0] for k in range(layers)]
                        + [lattice[np.linalg.norm(lattice - middle, axis=1) > R + layers*dp]])
inside = np.all((points > 0.25*dp) & (points < [width - 0.25*dp, rows*dp,
                                                width - 0.25*dp if threeD else 1]), axis=1)
points = points[inside]
points = points[np.argsort(np.floor(points[:, 1]/dp), kind='stable')]               # row by row
row = np.floor(points[:, 1]/dp)
immersed = body.volume*min(rho/rhoWater, 1)
count = int(round((depth*(width if D == 2 else width*tank['thickness']) - immersed)/cell))
full, top = points[row < row[count]], points[row == row[count]]
# what is left over of the last row stands evenly on it
water = np.concatenate(
    [full, top[np.unique(np.linspace(0, len(top) - 1, count - len(full)).round().astype(int))]])
p = rhoWater*9.81*np.maximum(row[count]*dp - water[:, 1], 0)
zero = np.zeros(len(water))
np.savetxt('constant/particles.csv', np.column_stack([water, zero, zero, zero, p]), delimiter=',',
           header='x,y,z,u,v,w,p', comments='', fmt='%.12g')
print(f'{len(water)} particles of water, {len(x)} of the body, centre {height:.5f} m')
