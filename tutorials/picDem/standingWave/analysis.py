# SPDX-License-Identifier: GPL-3.0-or-later
"""Standing wave by PIC: period and decay of its first mode against theory"""
import os

import numpy as np

from riprap.bounds import Quantity
from riprap.study import Study, Variant
from riprap.waves import Wave, plot

here = os.path.dirname(os.path.abspath(__file__))


def analyse(run):
    wave = Wave(run)
    omega, decay, amplitude = wave.fit()
    period = 2*np.pi/omega
    peaks = (
        np.array([abs(wave.mode[(wave.t >= k*wave.period) & (wave.t < (k + 1)*wave.period)]).max()
                  for k in range(int(wave.t[-1]/wave.period))]))
    return [Quantity('period [s]', computed=period, reference=wave.steepPeriod(),
                     error=abs(period/wave.steepPeriod() - 1)),
            # of the fitted amplitude over a period, viscosity's share taken off; positive: it grows
            Quantity('change of the amplitude a period',
                     computed=np.exp(-(decay - wave.decay)*period) - 1),
            Quantity('amplitude, last period over first', computed=peaks[-1]/peaks[0]),
            Quantity('amplitude [m]', computed=amplitude, reference=wave.amplitude)]


def wave(n, more=''):
    """n cells a wavelength, and an amplitude of one cell"""
    k = 2*np.pi
    V = np.sqrt(9.81*k*np.tanh(0.5*k))/n
    return ['-spacing', f'{0.5/n:.10g}', '-set',
            f'system/tank:nx {n}; system/tank:ny {7*n//10}; '
            f'system/tank:velocityAmplitude {V:.8g}{more}']


Study(
    scene='picStandingWave',
    variants=[Variant(f'n{n}', wave(n)) for n in (50, 100, 200)]
    + [Variant('n100-apic', wave(100, '; transfer apic')),
       Variant('n100-flipPic', wave(100, '; transfer flipPic'))],
    quick=[Variant('n50-quick', wave(50) + ['-endTime', '3.2'])],
    analyse=analyse,
    plot=plot,
    headline='period [s]',
    orders=[('period [s]', ['n50', 'n100', 'n200'])],
).main(here)
