# SPDX-License-Identifier: GPL-3.0-or-later
"""Water-level gauges every five spacings along the bed: constant/gauges"""
import numpy as np
from riprap.dictionaries import numberOf, readDictionary

tank = readDictionary('system/tank')
start, end = numberOf(tank['reservoir']), numberOf(tank['length'])
step = 5*numberOf(readDictionary('system/setParticlesDict')['spacing'])
x = np.arange(start + step, end - 0.5*step, step)
with open('constant/gauges', 'w') as f:
    f.write('points\n(\n' + ''.join(f'    ({at:.6g} 0 0.005)\n' for at in x) + ');\n')
print(f'{len(x)} gauges')
