# SPDX-License-Identifier: GPL-3.0-or-later
"""The body above the water: constant/solids.csv"""
import numpy as np
from riprap import bodies
from riprap.dictionaries import numberOf, readDictionary

tank, body, kind = (readDictionary(f'system/{name}') for name in ('tank', 'body', 'shape'))
threeD = kind['frontAndBack'] == 'wall'
dp = numberOf(readDictionary('system/setParticlesDict')['spacing'])
rho = numberOf(readDictionary('constant/solidProperties')['materials']['body']['rho'])
size, spacing = numberOf(body['size']), dp*numberOf(body['bodySpacing'])
lowest = numberOf(tank['depth']) + dp*numberOf(body['gap'])
shape = kind['shape']
if shape not in ('wedge', 'cylinder', 'sphere') or (shape == 'sphere') != threeD:
    raise SystemExit(f'shape {shape} of system/shape: wedge and cylinder are 2D (frontAndBack '
                     'empty), sphere is 3D (frontAndBack wall)')
if shape == 'wedge':
    x, volume, s = bodies.wedge(size, np.radians(numberOf(body['deadrise'])), spacing)
else:
    x, volume, s = bodies.rings(size, spacing, threeD)
    lowest += size
middle = [0.5*numberOf(tank['width']), lowest, 0.5*numberOf(tank['thickness'])]
bodies.write('constant/solids.csv', x + middle, volume, s, rho)
print(f'{shape}: {len(x)} particles, {rho*volume.sum():.6g} kg')
