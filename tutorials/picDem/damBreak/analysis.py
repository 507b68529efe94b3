# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break by PIC: front and height against Koshizuka & Oka (1996) and Martin & Moyce (1952)"""
import os

from riprap.collapse import analyse, plot
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def cells(n, more=''):
    """n cells over the column's width; particles as given half a cell apart"""
    h = 0.146/n
    ny = int(1.2/h)
    return ['-spacing', f'{0.5*h:.8g}', '-set',
            f'system/tank:nx {4*n}; system/tank:ny {ny}; system/tank:tankHeight {ny*h:.8g}{more}']


Study(
    scene='picDamBreak',
    variants=[Variant('n10', cells(10)), Variant('n20', cells(20)), Variant('n40', cells(40)),
              Variant('n20-co1', cells(20, '; system/controlDict:maxCo 1')),
              Variant('n20-co2', cells(20, '; system/controlDict:maxCo 2')),
              Variant('n20-apic',
                      cells(20, '; constant/picProperties:transfer apic') + ['-endTime', '0.5'])],
    quick=[Variant('n10-quick', cells(10) + ['-endTime', '0.4'])],
    analyse=analyse,
    plot=plot,
    headline='front rms [a], Koshizuka & Oka',
    orders=[('front rms [a], Koshizuka & Oka', ['n10', 'n20', 'n40'])],
).main(here)
