# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break in 3D: a slab periodic across against the same case in 2D"""
import os
import shutil

from riprap.bounds import Quantity
from riprap.slab import analyse, difference, plot
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
spacings = {'': 0.005, '-fine': 0.004, '-coarse': 0.006}
if shutil.which('nvidia-smi'):
    spacings['-million'] = 0.00136


def compare(runs, results):
    return [Quantity(f'front, 3D against 2D, largest{part}',
                     error=difference(runs['slab3D' + part], runs['slab2D' + part]))
            for part in [*spacings, '-quick']
            if 'slab3D' + part in runs and 'slab2D' + part in runs]


def pair(part, spacing, end=()):
    """The slab and the same case in 2D, with the slab's walls (spacing of the fluid)"""
    options = ['-spacing', f'{spacing:g}', *end]
    return [Variant('slab3D' + part, options),
            Variant('slab2D' + part, [*options, '-set', 'walls/spacing 0.005',
                                      *(end or ('-endTime', '0.4'))], 'sphDem/damBreak')]


# A column of half the size in a tank that its front crosses in 0.12 s
small = ('system/tank:columnWidth 0.078; system/tank:columnHeight 0.156; '
         'system/tank:tankWidth 0.3; system/tank:tankHeight 0.3')

Study(
    scene='damBreak3D',
    variants=[v for part, spacing in spacings.items() for v in pair(part, spacing)],
    quick=pair('-quick', 0.006, ('-endTime', '0.12', '-set', small)),
    analyse=analyse,
    plot=plot,
    headline='front two spacings from the far wall [s]',
    compare=compare,
).main(here)
