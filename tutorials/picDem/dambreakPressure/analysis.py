# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break by PIC: pressure on the far wall against Lobovsky et al. (2014) and Buchner (2002)"""
import os

from riprap.study import Study, Variant
from riprap.wallImpact import analyse, plot

here = os.path.dirname(os.path.abspath(__file__))


def cells(n, more=''):
    """n cells over the water's height of 0.3 m; 161 of 10 mm fit the tank's length, so n is a
    multiple of 30"""
    k = n//30
    return ['-spacing', f'{0.15/n:.8g}', '-set',
            f'system/tank:nx {161*k}; system/tank:ny {100*k}{more}']


Study(
    scene='picDambreakPressure',
    variants=[Variant('n30', cells(30)), Variant('n60', cells(60)), Variant('n120', cells(120)),
              Variant('n30-freeSlip', cells(30, '; constant/picProperties:walls/slip freeSlip'))],
    quick=[Variant('n30-quick', cells(30) + ['-endTime', '0.6'])],
    analyse=analyse,
    plot=plot,
    headline='plateau at sensor 2',
).main(here)
