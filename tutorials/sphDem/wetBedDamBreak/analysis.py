# SPDX-License-Identifier: GPL-3.0-or-later
"""A dam breaks onto a wet bed: celerity and depth of the bore against Stoker's solution and the
experiment of Janosi et al. (2004)"""
import os

import numpy as np

from riprap import clouds, measures, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81


def stoker(h0, bed):
    """Depth and velocity behind the bore and its celerity, shallow water: the rarefaction's 2 c + u
    = 2 c0 and the jump's mass and momentum"""
    def excess(h):
        return 2*(np.sqrt(g*h0) - np.sqrt(g*h)) - (h - bed)*np.sqrt(g*(h + bed)/(2*h*bed))
    low, high = bed, h0
    for _ in range(80):
        h = 0.5*(low + high)
        low, high = (h, high) if excess(h) > 0 else (low, h)
    u = 2*(np.sqrt(g*h0) - np.sqrt(g*h))
    return h, u, h*u/(h - bed)


class Bore:
    def __init__(self, run):
        tank = {k: numberOf(v) for k, v in run.dictionary('system/tank').items() if k != 'FoamFile'}
        self.dam, self.h0, self.bed, self.length = (tank['reservoir'], tank['depth'], tank['bed'],
                                                    tank['length'])
        self.h, self.u, self.celerity = stoker(self.h0, self.bed)
        table = run.table('gauges', 'waterLevel.dat')
        self.t, self.levels = table['Time'], stacked(table, 'level')
        step = 5*run.spacing
        self.x = np.arange(self.dam + step, self.length - 0.5*step, step)[:self.levels.shape[1]]

    def front(self, level):
        """Furthest place that stands higher than level, linear between gauges; the dam before
        that"""
        at = np.full(len(self.t), self.dam)
        for k, row in enumerate(self.levels):
            high = np.flatnonzero(row > level)
            if len(high) and high[-1] + 1 < len(row):
                i = high[-1]
                at[k] = (self.x[i]
                         + (self.x[i + 1] - self.x[i])*(row[i] - level)/(row[i] - row[i + 1]))
            elif len(high):
                at[k] = np.nan          # at the end of the tank
        return at

    def window(self):
        """From where the dam's own acceleration has died away (7 sqrt(h0/g)) to where the wave
        reflected by the back wall may have come"""
        return 7*np.sqrt(self.h0/g), 1.35*self.dam/np.sqrt(g*self.h0)


def slope(t, x):
    good = np.isfinite(x)
    return float(np.polyfit(t[good], x[good], 1)[0])


def experiment(level):
    """Times, and the furthest point of the experiment's surface that is higher than level"""
    data = np.loadtxt(os.path.join(here, 'reference', 'janosi2004_d38.csv'), delimiter=',',
                      skiprows=1)
    times = np.unique(data[:, 0])
    return times, np.array([data[(data[:, 0] == t) & (data[:, 2] > level), 1].max() for t in times])


def analyse(run):
    b = Bore(run)
    lost = Quantity('particles lost', error=lostParticles(run))
    if run.name.startswith('janosi'):
        level = 0.06
        times, measured = experiment(level)
        x = np.interp(times, b.t, b.front(level))
        c, reference = slope(times, x), slope(times, measured)
        away = x - measured
        return [Quantity('celerity, 0.156 to 0.593 s [m/s]', c, reference, abs(c/reference - 1)),
                Quantity('front, rms after a shift [depth]',
                         error=measures.rms(away - away.mean())/b.h0),
                Quantity('shift of the front [depth]', computed=float(away.mean()/b.h0)), lost]
    level = 0.5*(b.h + b.bed)
    start, end = b.window()
    inside = (b.t >= start) & (b.t <= min(end, b.t[-1]))
    front = b.front(level)
    c = slope(b.t[inside], front[inside])
    # depth: half way between the dam and the bore, at the end of the window
    last = np.flatnonzero(inside)[-1]
    behind = (b.x > b.dam + 0.35*(front[last] - b.dam)) & (b.x < b.dam + 0.75*(front[last] - b.dam))
    depth = float(np.median(b.levels[last, behind]))
    return [Quantity('celerity [m/s]', c, b.celerity, abs(c/b.celerity - 1)),
            Quantity('depth behind the bore [m]', depth, b.h, abs(depth/b.h - 1)), lost]


def lostParticles(run):
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    return first - last


def plot(runs, path):
    fig, (fronts, profile, compared) = plotting.figure(3, width=4.2)
    for k, run in enumerate(runs):
        b, colour = Bore(run), plotting.colours[k % len(plotting.colours)]
        level = 0.06 if run.name.startswith('janosi') else 0.5*(b.h + b.bed)
        fronts.plot(b.t, b.front(level) - b.dam, color=colour, linewidth=0.9, label=run.name)
        if run.name.startswith('janosi'):
            k5 = int(np.argmin(np.abs(b.t - 0.593)))
            compared.plot(b.x, b.levels[k5], color=colour, linewidth=0.9,
                          label=f'{run.name}, {b.t[k5]:.3g} s')
        else:
            fronts.plot(b.t, b.celerity*b.t, color=colour, linestyle=':', linewidth=0.9)
            last = np.flatnonzero(b.t <= min(b.window()[1], b.t[-1]))[-1]
            profile.plot((b.x - b.dam)/b.t[last], b.levels[last], color=colour, linewidth=0.9,
                         label=f'{run.name}, {b.t[last]:.3g} s')
            s = np.array([0, b.u - np.sqrt(g*b.h), b.celerity, b.celerity, 1.5*b.celerity])
            profile.plot(s, [b.h, b.h, b.h, b.bed, b.bed], color=colour, linestyle=':',
                         linewidth=0.9)
    times, measured = experiment(0.06)
    plotting.measured(fronts, times, measured - 0.38, 'Janosi et al.')
    data = np.loadtxt(os.path.join(here, 'reference', 'janosi2004_d38.csv'), delimiter=',',
                      skiprows=1)
    plotting.measured(compared, *data[data[:, 0] == times[-1], 1:].T, 'Janosi et al., 0.593 s')
    fronts.set(xlabel='t [s]', ylabel='front, from the dam [m]', title='dotted: Stoker')
    profile.set(xlabel='(x - dam)/t [m/s]', ylabel='level [m]')
    compared.set(xlabel='x [m]', ylabel='level [m]')
    for axis in (fronts, profile, compared):
        plotting.named(axis)
    plotting.save(fig, path)


janosi = ['-set', 'system/tank:reservoir 0.38; system/tank:depth 0.15; system/tank:bed 0.038; '
                  'system/tank:length 1.6; system/tank:nx 80; system/controlDict:endTime 0.62; '
                  'system/controlDict:sampleInterval 0.005']
short = ['-endTime', '0.9', '-set', 'system/tank:reservoir 0.96; system/tank:length 2.56; '
                                    'system/tank:nx 128; system/controlDict:writeInterval 0.45']

Study(
    scene='wetBedDamBreak',
    variants=[Variant('stoker-8mm', ['-spacing', '0.008']), Variant('stoker', large=True),
              Variant('stoker-2mm', ['-spacing', '0.002'], large=True),
              Variant('janosi', ['-spacing', '0.002', *janosi]),
              Variant('janosi-1mm', ['-spacing', '0.001', *janosi], large=True)],
    quick=[Variant('quick', ['-spacing', '0.008', *short])],
    analyse=analyse,
    plot=plot,
    headline='celerity [m/s]',
    orders=[('celerity [m/s]', ['stoker-8mm', 'stoker', 'stoker-2mm'])],
).main(here)
