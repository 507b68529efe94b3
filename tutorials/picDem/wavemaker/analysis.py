# SPDX-License-Identifier: GPL-3.0-or-later
"""A piston makes waves, a beach takes them: height of the waves against the wavemaker theory,
reflection of the beach

Linear theory of a piston (Dean & Dalrymple 1991, Water Wave Mechanics for Engineers and Scientists,
eq. 6.25):
H/S = 2 (cosh 2kh - 1)/(sinh 2kh + 2kh), omega^2 = g k tanh kh.
"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import entry, numberOf
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81


def waveNumber(omega, h):
    k = omega**2/g
    for _ in range(200):
        k = 0.5*(k + omega**2/(g*np.tanh(k*h)))
    return k


class Flume:
    def __init__(self, run):
        tank = run.dictionary('system/tank')
        self.h, self.S = numberOf(tank['depth']), numberOf(tank['stroke'])
        self.omega = (
            numberOf(entry(run.pic, 'walls/motion/piston/oscillatingLinearMotionCoeffs/omega')))
        self.k = waveNumber(self.omega, self.h)
        self.period = 2*np.pi/self.omega
        table = run.table('gauges', 'waterLevel.dat')
        self.t, self.eta = table['Time'], stacked(table, 'level') - self.h
        self.x = 2 + 0.06*np.arange(self.eta.shape[1])

    @property
    def theory(self):
        return transfer(self.k*self.h)*self.S

    def separate(self, last=4):
        """Amplitudes of the wave that comes and of the one that goes back over the last periods:
        least squares over all gauges"""
        late = self.t > self.t[-1] - last*self.period
        t, x = np.meshgrid(self.t[late], self.x, indexing='ij')
        basis = ([f(self.k*x + s*self.omega*t).ravel() for s in (-1, 1) for f in (np.cos, np.sin)]
                 + [np.ones(t.size)])
        c = np.linalg.lstsq(np.column_stack(basis), self.eta[late].ravel(), rcond=None)[0]
        return np.hypot(c[0], c[1]), np.hypot(c[2], c[3])


def frequency(kh, stroke):
    """Of waves of this k h on 0.3 m of water"""
    omega = np.sqrt(g*kh/0.3*np.tanh(kh))
    return (f'; system/tank:stroke {stroke}; '
            f'walls/motion/piston/oscillatingLinearMotionCoeffs/amplitude ({0.5*stroke} 0 0); '
            f'walls/motion/piston/oscillatingLinearMotionCoeffs/omega {omega:.6g}')


def analyse(run):
    f = Flume(run)
    incoming, reflected = f.separate()
    return [Quantity('wave height [m]', 2*incoming, f.theory, abs(2*incoming/f.theory - 1)),
            Quantity('reflection of the beach', error=reflected/incoming)]


def transfer(kh):
    """Height of the waves over the stroke"""
    return 2*(np.cosh(2*kh) - 1)/(np.sinh(2*kh) + 2*kh)


def plot(runs, path):
    fig, (gauge, profile, heights) = plotting.figure(3, width=6)
    kh = np.linspace(0.1, 3, 60)
    heights.plot(kh, transfer(kh), 'k-', linewidth=0.8, label='theory')
    for i, run in enumerate(runs):
        f = Flume(run)
        heights.plot(f.k*f.h, 2*f.separate()[0]/f.S, linestyle='none',
                     marker=plotting.markers[i % len(plotting.markers)], label=run.name)
    runs = [run for run in runs if '-k' not in run.name]        # of one frequency
    for run in runs:
        f = Flume(run)
        gauge.plot(f.t/f.period, f.eta[:, 20]/f.S, linewidth=0.8, label=run.name)
        profile.plot(f.x, f.eta[-1]/f.S, label=run.name)
    half = 0.5*f.theory/f.S
    for sign in (-1, 1):
        for axis in (gauge, profile):
            axis.axhline(sign*half, color='k', linewidth=0.8, linestyle=':',
                         label='theory, amplitude' if sign > 0 else None)
    gauge.set(xlabel='t/T', ylabel=f'level at x = {f.x[20]:.2f} m / stroke')
    profile.set(xlabel='x [m]', ylabel=f'level at {f.t[-1]:.1f} s / stroke')
    heights.set(xlabel='k h', ylabel='height of the waves / stroke')
    for axis in (gauge, profile, heights):
        plotting.named(axis)
    plotting.save(fig, path)


def grid(n, more=''):
    """n cells over the depth"""
    return ['-spacing', f'{0.15/n:.10g}', '-set',
            f'system/tank:nx {25*n}; system/tank:ny {3*n//2}{more}']


Study(
    scene='picWavemaker',
    variants=[Variant('n12', grid(12)), Variant('n24', grid(24)), Variant('n36', grid(36)),
              Variant('n24-k1', grid(24, frequency(1, 0.02))),
              Variant('n24-k2.2', grid(24, frequency(2.2, 0.01))),
              Variant('n24-wall', grid(24, '; absorb/beach/rate 0'))],
    quick=[Variant('n8-quick', grid(8) + ['-endTime', '12'])],
    analyse=analyse,
    plot=plot,
    headline='wave height [m]',
    orders=[('wave height [m]', ['n12', 'n24', 'n36'])],
).main(here)
