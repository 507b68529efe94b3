# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break: pressure on the far wall against Lobovsky et al. (2014) and Buchner (2002)"""
import os

from riprap.study import Study, Variant
from riprap.wallImpact import analyse, plot

here = os.path.dirname(os.path.abspath(__file__))


Study(
    scene='dambreakPressure',
    variants=[Variant('dp10', ['-spacing', '0.01']), Variant('dp5', ['-spacing', '0.005']),
              Variant('dp2.5'), Variant('dp1.25', ['-spacing', '0.00125']),
              Variant('dp5-freeSlip', ['-spacing', '0.005', '-set', 'walls/slip freeSlip']),
              Variant('dp2.5-freeSlip', ['-set', 'walls/slip freeSlip']),
              Variant('dp1.25-freeSlip', ['-spacing', '0.00125', '-set', 'walls/slip freeSlip']),
              Variant('dp5-stationary',
                      ['-spacing', '0.005', '-set',
                       'walls/model stationary; walls/spacing 0.0025; densityDiffusion none'])],
    quick=[Variant('dp10-quick', ['-spacing', '0.01', '-endTime', '0.6'])],
    analyse=analyse,
    plot=plot,
    headline='plateau at sensor 2',
    orders=[('arrival at sensor 2, t sqrt(g/H)', ['dp5', 'dp2.5', 'dp1.25']),
            ('plateau at sensor 2', ['dp5', 'dp2.5', 'dp1.25'])],
).main(here)
