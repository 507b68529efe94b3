# SPDX-License-Identifier: GPL-3.0-or-later
"""Taylor-Green vortices: velocity of every particle and its decay against the exact solution"""
import os

from riprap.study import Study, Variant
from riprap.vortices import analyse, plot

here = os.path.dirname(os.path.abspath(__file__))


Study(
    scene='taylorGreen',
    variants=[Variant('n50', ['-spacing', '0.02']), Variant('n100', ['-spacing', '0.01']),
              Variant('n200', ['-spacing', '0.005']),
              Variant('n100-double', ['-spacing', '0.01', '-set', 'precision double'])],
    quick=[Variant('n32', ['-spacing', '0.03125'])],
    analyse=analyse,
    plot=plot,
    headline='velocity L2, t U/L = 1',
    orders=[('velocity L2, t U/L = 0.5', ['n50', 'n100', 'n200']),
            ('velocity L2, t U/L = 1', ['n50', 'n100', 'n200'])],
).main(here)
