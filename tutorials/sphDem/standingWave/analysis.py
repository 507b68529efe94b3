# SPDX-License-Identifier: GPL-3.0-or-later
"""Standing wave: period and decay of its first mode against linear theory"""
import os

import numpy as np

from riprap.bounds import Quantity
from riprap.study import Study, Variant
from riprap.waves import Wave, exactPeriod, plot

here = os.path.dirname(os.path.abspath(__file__))


def analyse(run):
    wave = Wave(run)
    omega, decay, amplitude = wave.fit()
    period = 2*np.pi/omega
    return [Quantity('period [s]', computed=period, reference=exactPeriod(),
                     error=abs(period/exactPeriod() - 1)),
            Quantity('decay rate [1/s]', computed=decay, reference=wave.decay),
            Quantity('amplitude [m]', computed=amplitude, reference=wave.amplitude),
            Quantity('period, theory here against the table',
                     error=abs(wave.period/exactPeriod() - 1))]


Study(
    scene='standingWave',
    variants=[Variant('n50', ['-spacing', '0.02']), Variant('n100', ['-spacing', '0.01']),
              Variant('n200', ['-spacing', '0.005']),
              Variant('n100-stationary',
                      ['-spacing', '0.01', '-set', 'walls/model stationary; densityDiffusion none'],
                      mayFail=True)],
    quick=[Variant('n50-quick', ['-spacing', '0.02', '-endTime', '2.4'])],
    analyse=analyse,
    plot=plot,
    headline='period [s]',
    orders=[('period [s]', ['n50', 'n100', 'n200'])],
).main(here)
