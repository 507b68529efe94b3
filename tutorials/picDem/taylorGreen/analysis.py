# SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor-Green vortices by PIC: velocity of every particle and its decay against the exact
solution"""
import os

from riprap.study import Study, Variant
from riprap.vortices import analyse, plot

here = os.path.dirname(os.path.abspath(__file__))


def grid(n):
    return ['-spacing', f'{0.5/n:.10g}', '-set', f'system/tank:n {n}']


def grids(suffix, sets):
    return [Variant(f'n{n}{suffix}', grid(n) + ['-set', sets]) for n in (16, 32, 64)]


Study(
    scene='picTaylorGreen',
    variants=[Variant(f'n{n}', grid(n)) for n in (16, 32, 64)] + grids('-apic', 'transfer apic')
    + grids('-plain', 'reflection no'),
    quick=[Variant('n32-quick', grid(32))],
    analyse=analyse,
    plot=plot,
    headline='velocity L2, t U/L = 1',
    orders=[('velocity L2, t U/L = 1', [f'n{n}{s}' for n in (16, 32, 64)])
            for s in ('', '-apic', '-plain')],
).main(here)
