# SPDX-License-Identifier: GPL-3.0-or-later
"""The roll as OpenFOAM's table, constant/roll.dat"""
import numpy as np
from riprap.dictionaries import readDictionary

roll = np.loadtxt(f"system/{readDictionary('system/history')['history']}.csv", delimiter=',',
                  skiprows=1)
with open('constant/roll.dat', 'w') as f:
    f.write('(\n' + '\n'.join(f'({t:.4g} ((0 0 0) (0 0 {angle:.6g})))' for t, angle in roll)
            + '\n)\n')
print(f'{len(roll)} angles to {roll[-1, 0]:.4g} s')
