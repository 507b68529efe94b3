# SPDX-License-Identifier: GPL-3.0-or-later
"""A block under water: constant/solids.csv, constant/particles.csv. It stands on the water's
lattice, in the place of whole particles"""
import numpy as np
from riprap import bodies
from riprap.dictionaries import numberOf, readDictionary

tank, body = (readDictionary(f'system/{name}') for name in ('tank', 'body'))
threeD = readDictionary('system/shape')['frontAndBack'] == 'wall'
dp = numberOf(readDictionary('system/setParticlesDict')['spacing'])
rho = numberOf(readDictionary('constant/solidProperties')['materials']['body']['rho'])
rhoWater = numberOf(readDictionary('constant/fluidProperties')['rho'])
side, width, depth, thickness = (numberOf(d[k]) for d, k in ((body, 'side'), (tank, 'width'),
                                                             (tank, 'depth'), (tank, 'thickness')))
cells = [width/dp, depth/dp, side/dp, numberOf(body['start'])/dp]
if any(abs(c - round(c)) > 1e-6 for c in cells) or round(cells[0] - cells[2]) % 2:
    raise SystemExit(f'spacing {dp} does not divide width {width}, depth {depth}, side {side} '
                     'and start of system/body, or the block is not in the middle of cells')

x, volume, s = bodies.block([side]*(3 if threeD else 2), dp*numberOf(body['bodySpacing']))
middle = np.array([0.5*width, numberOf(body['start']) + 0.5*side, 0.5*thickness])
bodies.write('constant/solids.csv', x + middle, volume, s, rho)

across = (np.arange(round(width/dp)) + 0.5)*dp
up = (np.arange(round(depth/dp)) + 0.5)*dp
grid = np.meshgrid(up, across, across if threeD else [middle[2]], indexing='ij')
points = np.column_stack([grid[1].ravel(), grid[0].ravel(), grid[2].ravel()])
reach = np.abs(points - middle)[:, :3 if threeD else 2].max(axis=1)
water = points[reach > 0.5*side]
p = rhoWater*9.81*(depth - water[:, 1])
zero = np.zeros(len(water))
np.savetxt('constant/particles.csv', np.column_stack([water, zero, zero, zero, p]), delimiter=',',
           header='x,y,z,u,v,w,p', comments='', fmt='%.12g')
print(f'{len(water)} particles of water, {len(x)} of the block, {rho*volume.sum():.6g} kg')
