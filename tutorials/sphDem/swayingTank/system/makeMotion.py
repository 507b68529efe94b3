# SPDX-License-Identifier: GPL-3.0-or-later
"""The sway as OpenFOAM's table, constant/sway.dat"""
import os
import sys

import numpy as np
from riprap.dictionaries import numberOf, readDictionary

sys.path.insert(0, os.environ['RIPRAP_TUTORIAL'])
from linearTheory import Sway  # noqa: E402

tank = readDictionary('system/tank')
sway = Sway(*(numberOf(tank[k]) for k in ('amplitude', 'ratio', 'left', 'right', 'depth')))
t = np.arange(0, numberOf(readDictionary('system/controlDict')['endTime']) + 0.5, 0.01)
with open('constant/sway.dat', 'w') as f:
    f.write('(\n' + '\n'.join(f'({at:.4g} (({x:.8g} 0 0) (0 0 0)))'
                              for at, x in zip(t, sway.place(t))) + '\n)\n')
print(f'{len(t)} places to {t[-1]:.4g} s, angular frequency {sway.omega:.6g} 1/s')
