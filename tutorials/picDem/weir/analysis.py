# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow over a round weir in a channel: head against flow, depth over a drowned crest, water in less
water out

A weir whose crest has the radius R lets the flow q [m2/s] over under the head H [m], both of the
water far upstream and above the crest:
    q = sqrt(g) (2 H/3)^(3/2) (1 + 22/81 H/R),
critical flow, and the first correction for curved streamlines (Matthew 1963, Proc. Inst. Civ. Eng.
25, from Boussinesq's equation
    E - z = h + q^2/(2 g h^2) (1 + (2 h h'' - h'^2)/3 + h z'' + z'^2),
which the same correction is taken from where the crest is drowned: h'' = -z''/(1 - q^2/(g h^3))).
"""
import os
import re

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import entry, numberOf
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81
crest, R, at = 0.1, 0.75, 0.8   # height and radius of the weir, x of its crest [m]
thickness = 0.01                # of the mesh [m]
approach = (0.15, 0.35)         # where the head is taken, two depths before the weir [m]


def bed(x):
    return np.maximum(0, np.sqrt(np.maximum(0, R**2 - (x - at)**2)) - (R - crest))


def flowOver(H):
    return np.sqrt(g)*(2*H/3)**1.5*(1 + 22/81*H/R)


def headOf(q):
    low, high = 0.0, 1.0
    for _ in range(60):
        H = 0.5*(low + high)
        low, high = (H, high) if flowOver(H) < q else (low, H)
    return H


def depth(q, E, fast, curvature=0.0):
    """h + q^2/(2 g h^2) (1 + corrections of a crest) = E, the slow or the fast root; the critical
    one where there is none"""
    def energy(h):
        more = curvature*h*(1 - 2/(3*(1 - q*q/(g*h**3)))) if curvature else 0
        return h + q*q/(2*g*h*h)*(1 + more)
    critical = (q*q/g)**(1/3)
    low, high = ((1e-3*critical, critical) if fast
                 else (critical*(1 + 1e-9 if not curvature else 1.05), max(E, critical)))
    for _ in range(80):
        h = 0.5*(low + high)
        low, high = (h, high) if (energy(h) > E) == fast else (low, h)
    return h


class Channel:
    def __init__(self, run):
        flow = str(entry(run.pic, 'openings/river/flowRate'))
        self.q = float(re.findall(r'[-+.\deE]+', flow)[-1])/thickness
        self.sea = numberOf(entry(run.pic, 'openings/sea/level'))
        table = run.table('levels', 'waterLevel.dat')
        t, eta = table['Time'], stacked(table, 'level')
        self.t, self.eta = t, eta
        self.x = 0.025 + 0.05*np.arange(eta.shape[1])
        self.level = eta[t > 0.5*t[-1]].mean(axis=0)
        self.before = self.level[(self.x > approach[0]) & (self.x < approach[1])].mean()
        self.E = self.before + (self.q/self.before)**2/(2*g)
        with open(os.path.join(run.path, 'log.riprapFoam'), errors='replace') as f:
            text = f.read()
        self.volume = np.array([float(v) for v in re.findall(r'^Volume = (\S+),', text, re.M)])
        self.passed = (
            [np.array([float(v) for v in re.findall(rf'^Opening {name}: .*volume in all = (\S+)',
                                                    text, re.M)]) for name in ('river', 'sea')])
        self.escaped = max([int(n) for n in re.findall(r'^Escaped .*\((\d+) in all\)', text, re.M)],
                           default=0)

    @property
    def drowned(self):
        """The water beyond stands so high that the flow stays slow"""
        return self.sea > crest + headOf(self.q)

    @property
    def unbalanced(self):
        """Water that the openings let in and that is not there, over what the river has brought,
        from the first sample to the last"""
        came = self.passed[0] + self.passed[1]
        return abs((self.volume[-1] - self.volume[0]) - (came[-1] - came[0]))/self.passed[0][-1]

    @property
    def flowOut(self):
        """Over the second half of the run"""
        half = len(self.passed[1])//2
        return -(self.passed[1][-1]
                 - self.passed[1][half])/(len(self.passed[1]) - 1 - half)/(self.t[-1] - self.t[-2])


def analyse(run):
    c = Channel(run)
    middle = np.interp(at, c.x, c.level) - crest
    if c.drowned:
        E = c.sea + (c.q/c.sea)**2/(2*g)
        h = depth(c.q, E - crest, fast=False, curvature=-1/R)
        result = [Quantity('head before the weir [m]', c.E, E, abs(c.E/E - 1)),
                  Quantity('dip of the surface over the crest [m]', c.sea - crest - middle, c.sea
                           - crest - h, abs((c.sea - crest - middle)/(c.sea - crest - h) - 1))]
    else:
        H = headOf(c.q)
        result = [Quantity('head over the crest [m]', c.E - crest, H, abs((c.E - crest)/H - 1)),
                  Quantity('depth over the crest / critical depth', middle/(c.q**2/g)**(1/3))]
    return result + [
        Quantity('flow out [m2/s]', c.flowOut, c.q, abs(c.flowOut/c.q - 1)),
        Quantity('water not accounted for / water in', error=c.unbalanced),
        Quantity('particles lost', computed=float(c.escaped))]


def plot(runs, path):
    fig, (profile, rating) = plotting.figure(2, width=6.5)
    x = np.linspace(0, 2, 401)
    profile.fill_between(x, bed(x), color='#999999')
    drawn = set()
    for run in runs:
        c = Channel(run)
        line, = profile.plot(c.x, c.level, linewidth=1, label=run.name)
        if (c.q, c.drowned) in drawn:
            continue
        drawn.add((c.q, c.drowned))
        E = c.sea + (c.q/c.sea)**2/(2*g) if c.drowned else crest + 1.5*(c.q**2/g)**(1/3)
        profile.plot(x, [z + depth(c.q, E - z, fast=not c.drowned and s > at)
                         for s, z in zip(x, bed(x))], 'k:', linewidth=0.8,
                     label='Bernoulli, hydrostatic' if len(drawn) == 1 else None)
    H = np.linspace(0.03, 0.16, 50)
    rating.plot(H, flowOver(H), 'k-', linewidth=0.8, label='theory')
    rating.plot(H, np.sqrt(g)*(2*H/3)**1.5, 'k:', linewidth=0.8, label='hydrostatic')
    for i, run in enumerate(runs):
        c = Channel(run)
        if not c.drowned:
            rating.plot(c.E - crest, c.q, linestyle='none',
                        marker=plotting.markers[i % len(plotting.markers)], label=run.name)
    profile.set(xlabel='x [m]', ylabel='level, mean of the second half [m]')
    rating.set(xlabel='head over the crest [m]', ylabel='flow [m$^2$/s]')
    for axis in (profile, rating):
        plotting.named(axis)
    plotting.save(fig, path)


def grid(n, more=''):
    """n cells over the height of the weir"""
    return ['-spacing', f'{0.05/n:.10g}', '-set',
            f'system/channel:nx {20*n}; system/channel:ny {3*n}{more}']


def flow(q, upstream):
    return f'; openings/river/flowRate {q*thickness:g}; system/channel:upstream {upstream}'


Study(
    scene='picWeir',
    variants=[Variant('n8', grid(8)), Variant('n12', grid(12)), Variant('n18', grid(18)),
              Variant('n12-low', grid(12, flow(0.03, 0.165))),
              Variant('n12-high', grid(12, flow(0.09, 0.23))),
              Variant('n12-drowned',
                      grid(12, '; openings/sea/level 0.215; system/channel:upstream 0.215; '
                               'system/channel:downstream 0.215; system/channel:start 0.279; '
                               'system/channel:behind 0.279') + ['-endTime', '40'])],
    quick=[Variant('n8-quick', grid(8) + ['-endTime', '4'])],
    analyse=analyse,
    plot=plot,
    headline='head over the crest [m]',
    recorded=['n8', 'n12', 'n18'],
    orders=[('head over the crest [m]', ['n8', 'n12', 'n18'])],
).main(here)
