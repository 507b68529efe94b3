# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break in 3D by PIC: a slab periodic across against the same case in 2D"""
import os

from riprap.slab import analyse, difference, plot
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def pair(part, n, end):
    """The slab with n cells over the column's width, and the same case in 2D"""
    h = 0.146/n
    ny = int(0.9/h)
    tank = f'system/tank:nx {4*n}; system/tank:ny {ny}; system/tank:tankHeight {ny*h:.8g}'
    options = ['-spacing', f'{0.5*h:.8g}', '-endTime', end]
    return [Variant('slab3D' + part,
                    [*options, '-set', f'{tank}; system/tank:nz 4; system/tank:span {4*h:.8g}']),
            Variant('slab2D' + part, [*options, '-set', tank], 'picDem/damBreak')]


def compare(runs, results):
    return [Quantity(f'front, 3D against 2D, largest{part}',
                     error=difference(runs['slab3D' + part], runs['slab2D' + part]))
            for part in ('', '-fine', '-quick')
            if 'slab3D' + part in runs and 'slab2D' + part in runs]


Study(
    scene='picDamBreak3D',
    variants=pair('', 10, '0.4') + pair('-fine', 20, '0.3'),
    quick=pair('-quick', 8, '0.2'),
    analyse=analyse,
    plot=plot,
    headline='front two spacings from the far wall [s]',
    compare=compare,
).main(here)
