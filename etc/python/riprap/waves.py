# SPDX-License-Identifier: GPL-3.0-or-later
"""A standing wave: period and decay of its first mode against linear theory

Period 2 pi/omega with omega^2 = g k tanh(k H); decay of the amplitude 2 nu k^2 (Lamb,
Hydrodynamics, art. 348, over a free-slip bottom at any depth).
"""
import os

import numpy as np

from . import plotting
from .bounds import root
from .dictionaries import numberOf
from .tables import stacked


class Wave:
    def __init__(self, run):
        tank = run.dictionary('system/tank')
        self.L, self.H, V = (numberOf(tank[k])
                             for k in ('wavelength', 'depth', 'velocityAmplitude'))
        self.k = 2*np.pi/self.L
        self.omega = np.sqrt(9.81*self.k*np.tanh(self.k*self.H))
        self.period = 2*np.pi/self.omega
        self.decay = 2*run.kinematicViscosity*self.k**2
        self.amplitude = V/self.omega
        table = run.table('gauges', 'waterLevel.dat')
        self.t, levels = table['Time'], stacked(table, 'level')
        x = (np.arange(levels.shape[1]) + 0.5)*self.L/levels.shape[1]
        self.mode = 2*np.mean(levels*np.cos(self.k*x), axis=1)

    def steepPeriod(self):
        """Longer than linear theory's by the wave's steepness e = k a, to the second order:
        Tadjbakhsh & Keller (1960), J. Fluid Mech. 8, 442: w/sqrt(g k) = w0 + e^2 w2/2, w0^2 =
        tanh(k H), w2 = (9 w0^-7 - 12 w0^-3 - 3 w0 - 2 w0^5)/32; e^2/8 of the period in deep water
        [s]"""
        w0 = np.sqrt(np.tanh(self.k*self.H))
        w2 = (9*w0**-7 - 12*w0**-3 - 3*w0 - 2*w0**5)/32
        return exactPeriod()/(1 + 0.5*(self.k*self.amplitude)**2*w2/w0)

    def fit(self):
        """omega and decay rate of A sin(omega t) + B cos(omega t) + C, all times exp(-decay t):
        linear least squares inside, a search over a shrinking grid outside"""
        def cost(omega, decay):
            e = np.exp(-decay*self.t)
            basis = np.column_stack([e*np.sin(omega*self.t), e*np.cos(omega*self.t),
                                     np.ones_like(self.t)])
            c, *_ = np.linalg.lstsq(basis, self.mode, rcond=None)
            return np.sum((basis @ c - self.mode)**2), np.hypot(c[0], c[1])
        centre, width = (np.array([self.omega, self.decay]),
                         np.array([0.15*self.omega, 2*self.decay + 0.2]))
        for _ in range(40):
            grid = [centre + width*np.array([i, j])/4 for i in range(-4, 5) for j in range(-4, 5)]
            centre = min(grid, key=lambda p: cost(*p)[0])
            width = 0.6*width
        return centre[0], centre[1], cost(*centre)[1]


def exactPeriod():
    """Of the reference table: wavelength 1 m, depth 0.5 m"""
    table = np.genfromtxt(os.path.join(root(), 'tutorials', 'sphDem', 'standingWave', 'reference',
                                       'linearTheory.csv'), delimiter=',', skip_header=1)
    return table[0, 4]


def plot(runs, path):
    fig, (mode, energy) = plotting.figure(2, width=6)
    for run in runs:
        wave = Wave(run)
        label = f'{run.name}: L/{wave.L/run.spacing:.0f}'
        mode.plot(wave.t/wave.period, wave.mode/wave.amplitude, label=label)
        e = run.table('energy', 'energyBalance.dat')
        energy.semilogy(e['Time']/wave.period, e['kinetic']/e['kinetic'][0], label=label)
    t = wave.t
    decaying = np.exp(-wave.decay*t)
    mode.plot(t/wave.period, decaying*np.sin(wave.omega*t), 'k:', label='linear theory')
    energy.semilogy(t/wave.period, decaying**2, 'k:', label='$\\exp(-4\\nu k^2 t)$')
    mode.set(xlabel='t/T', ylabel='first mode / V/$\\omega$')
    energy.set(xlabel='t/T', ylabel='kinetic energy / initial', ylim=(1e-3, 1.5))
    for axis in (mode, energy):
        plotting.named(axis)
    plotting.save(fig, path)
