# SPDX-License-Identifier: GPL-3.0-or-later
"""A cylinder or a sphere let go in water: draught at rest against Archimedes, heave against linear
potential flow in the same tank"""
import os
import sys

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)

from potentialFlow import Body, Tank, firstSwing  # noqa: E402
from riprap import clouds, plotting  # noqa: E402
from riprap.bounds import Quantity  # noqa: E402
from riprap.dictionaries import numberOf  # noqa: E402
from riprap.study import Study, Variant  # noqa: E402

g = 9.81


class Release:
    def __init__(self, run):
        tank = {k: numberOf(v) for k, v in run.dictionary('system/tank').items() if k != 'FoamFile'}
        self.D = 3 if run.dictionary('system/frontAndBack')['frontAndBack'] == 'wall' else 2
        self.R, self.depth, self.displacement = tank['radius'], tank['depth'], tank['displacement']
        self.ratio = numberOf(run.solid['materials']['body']['rho'])/run.density
        self.plan = tank['width']*(1 if self.D == 2 else tank['thickness'])
        # a round tank of the square one's area
        self.W = 0.5*tank['width'] if self.D == 2 else np.sqrt(self.plan/np.pi)
        self.body = Body(self.R, min(self.ratio, 1), self.D)
        self.start = tank['start']
        table = run.table('body', 'groupMotion.dat')
        self.t, self.y, self.v = (np.asarray(table[k]) for k in ('Time', 'freeCentreY', 'freeUy'))
        self.floats = self.ratio < 1
        self.water = self.depth*self.plan - self.body.volume*min(self.ratio, 1)

    def draught(self, y):
        """How deep the lowest point is under the level that the water takes about the body"""
        low, high = 0.0, 3*self.depth
        for _ in range(60):
            level = 0.5*(low + high)
            if self.water + self.body.immersed(y - level) < level*self.plan:
                high = level
            else:
                low = level
        return level - (y - self.R)

    def meanDraught(self):
        """Over the last whole swings, half of the run at most but one swing at least"""
        period = firstSwing(*self.theory())
        late = self.t > self.t[-1] - max(1, int(0.5*self.t[-1]/period))*period
        return float(np.mean([self.draught(y) for y in self.y[late]]))

    def theory(self):
        """Times and heights of the centre by potential flow"""
        tank = Tank(self.body, self.W, self.depth, size=self.R/12)
        end = max(self.t[-1], 3)        # one swing of the slowest
        t, x = tank.heave(self.displacement, end, steps=int(end*1500))
        return t, self.depth + self.body.centre + x

    def fall(self):
        """Acceleration of a body let go in water: potential flow, and that of the run until it has
        gone a tenth of its radius"""
        tank = Tank(self.body, self.W, self.depth, centre=self.start - self.depth, size=self.R/12)
        exact = (self.body.volume
                 - self.ratio*self.body.volume)*g/(self.ratio*self.body.volume + tank.added)
        way = (self.t <= 0.1) & (np.abs(self.y - self.y[0]) < 0.1*self.R)
        t, y = self.t[way], self.y[way] - self.y[0]
        return 2*float(t**2 @ y/(t**2 @ t**2)), exact


def swing(t, y):
    """First swing of samples: a parabola about each turn"""
    turns = []
    window = max(int(0.03/(t[1] - t[0])), 2)
    for k in range(window, len(t) - window):
        near = y[k - window:k + window + 1]
        if t[k] > 0.05 and (y[k] == near.max() or y[k] == near.min()):
            a, b, _ = np.polyfit(t[k - window:k + window + 1] - t[k], near, 2)
            if not turns or t[k] - turns[-1] > 0.05:
                turns.append(t[k] - 0.5*b/a)
    return turns[1] if len(turns) > 1 else np.nan


def analyse(run):
    r = Release(run)
    if not r.floats:
        a, exact = r.fall()
        rest = r.y[r.t > 0.9*r.t[-1]]
        return [Quantity('acceleration [m/s2]', a, exact, abs(a/exact - 1)),
                Quantity('height at rest on the bottom / R', rest.mean()/r.R, 1,
                         abs(rest.mean()/r.R - 1)),
                Quantity('still moving [R]', error=float(np.ptp(rest)/r.R))]
    draught, exact = r.meanDraught(), r.R - r.body.centre
    t, y = r.theory()
    period, theory = swing(r.t, r.y), firstSwing(t, y)
    return [Quantity('draught [m]', draught, exact, abs(draught/exact - 1)),
            Quantity('first swing [s]', period, theory, abs(period/theory - 1)),
            Quantity('heave, rms to 1.5 s / displacement', error=float(rms(r, t, y))),
            Quantity('largest speed / sqrt(g R)', error=float(np.abs(r.v).max()/np.sqrt(g*r.R)))]


def rms(r, t, y):
    at = r.t <= min(1.5, r.t[-1])
    return np.sqrt(np.mean((r.y[at] - np.interp(r.t[at], t, y))**2))/r.displacement


def couplingOf(run):
    return run.sphEntry('coupling', 'extrapolated')


def plotDraughts(axis, runs):
    """Draught at rest over Archimedes', by coupling"""
    for k, c in enumerate(('extrapolated', *others)):
        for name, marker in (('cylinder', 'o'), ('sphere', '^')):
            mine = [Release(r) for r in runs if couplingOf(r) == c and r.name.startswith(name)
                    and not r.name.endswith(('coarse', 'fine'))]
            points = [(r.ratio, r.meanDraught()/(r.R - r.body.centre)) for r in mine if r.floats]
            if points:
                axis.plot(*zip(*sorted(points)), marker + '-', color=plotting.colours[k],
                          markersize=4, linewidth=0.8, label=f'{name}, {c}')
    axis.axhspan(0.97, 1.03, color='#dddddd')
    axis.set(xlabel='density over that of water', ylabel='draught / Archimedes')
    plotting.named(axis)


def plot(runs, path):
    fig, (heave, draughts, picture) = plotting.figure(3, width=4.2)
    for k, run in enumerate([r for r in runs
                             if couplingOf(r) == 'extrapolated' and Release(r).floats][:6]):
        r = Release(run)
        colour = plotting.colours[k]
        zero = r.depth + r.body.centre
        heave.plot(r.t, 1e3*(r.y - zero), color=colour, linewidth=0.9, label=run.name)
        t, y = r.theory()
        heave.plot(t, 1e3*(y - zero), color=colour, linewidth=0.9, linestyle=':')
    heave.set(xlabel='t [s]', ylabel='centre over its place at rest [mm]',
              title='dotted: potential flow')
    plotting.named(heave)
    plotDraughts(draughts, runs)
    withClouds = [r for r in runs if clouds.times(r.path)]
    if withClouds:
        plotLast(fig, picture, withClouds[0])
    else:
        picture.set_visible(False)
    plotting.save(fig, path)


def plotLast(fig, picture, last):
    at = clouds.times(last.path)[-1]
    f, b = (clouds.readCloud(last.path, at, ('p',)),
            clouds.readCloud(last.path, at, ('radius',), 'solids'))
    # of a sphere's tank the slice through its middle
    tank = last.dictionary('system/tank')
    inSlice = [np.abs(cloud['positions'][:, 2] - 0.5*numberOf(tank['thickness']))
               < 0.75*last.spacing for cloud in (f, b)]
    x, y = (cloud['positions'][kept] for cloud, kept in zip((f, b), inSlice))
    dots = picture.scatter(1e3*x[:, 0], 1e3*x[:, 1], c=f['p'][inSlice[0]], s=1)
    picture.scatter(1e3*y[:, 0], 1e3*y[:, 1], s=1, color='#444444')
    fig.colorbar(dots, ax=picture, label='p [Pa]')
    picture.set(aspect='equal', xlabel='x [mm]', ylabel='y [mm]', title=last.name)


def of(ratio, *more):
    return ['-set',
            '; '.join([f'constant/solidProperties:materials/body/rho {1000*ratio:g}', *more])]


cube = ('system/frontAndBack:frontAndBack wall; system/tank:width 0.5; system/tank:thickness 0.5; '
        'system/tank:depth 0.3; system/tank:height 0.5; system/tank:start 0.18')
ratios = (0.3, 0.5, 0.9, 1.2, 2.7)
others = ('pressureGradient', 'stationary', 'pressureApproximation')


def sphere(ratio, spacing, *more):
    return ['-spacing', spacing, '-endTime', '2', *of(ratio, cube, *more)]


Study(
    scene='floatingBodies',
    variants=[Variant(f'cylinder-{d}', of(d)) for d in ratios]
    + [Variant(f'sphere-{d}', sphere(d, '0.0125')) for d in ratios]
    + [Variant(f'cylinder-{d}-{c}', of(d, f'coupling {c}')) for c in others for d in ratios]
    + [Variant(f'sphere-{d}-pressureGradient', sphere(d, '0.0125', 'coupling pressureGradient'))
       for d in ratios]
    + [Variant('cylinder-0.5-coarse', ['-spacing', '0.0142857143', *of(0.5)]),
       Variant('cylinder-0.5-fine', ['-spacing', '0.005', *of(0.5)]),
       Variant('sphere-0.5-coarse', sphere(0.5, '0.0166666667'))]
    + [Variant(f'sphere-{d}-fine', sphere(d, '0.01'), large=True) for d in ratios],
    quick=[Variant('quick', ['-endTime', '2', *of(0.3)])],
    analyse=analyse,
    plot=plot,
    orders=[('draught [m]', ['cylinder-0.5-coarse', 'cylinder-0.5', 'cylinder-0.5-fine'])],
    headline='draught [m]',
).main(here)
