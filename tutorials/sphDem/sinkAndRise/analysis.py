# SPDX-License-Identifier: GPL-3.0-or-later
"""A cube sinks and lands on the bottom, a light block rises and floats: acceleration, rest,
draught"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g = 9.81
# Added mass over the displaced mass in unbounded water: square, moved along a side, 1.51 pi
# (side/2)^2 (Newman, Marine Hydrodynamics, 1977, table 4.3: 4.754 of a half side squared); cube
# 0.638: panels on its faces give 0.6513, 0.6456, 0.6430 with 10, 14, 18 an edge, 0.639 extrapolated
addedMass = {2: 1.189, 3: 0.638}


class Block:
    def __init__(self, run):
        self.D = 3 if run.dictionary('system/shape')['frontAndBack'] == 'wall' else 2
        body, tank = run.dictionary('system/body'), run.dictionary('system/tank')
        self.side, self.start = numberOf(body['side']), numberOf(body['start'])
        self.width, self.depth = numberOf(tank['width']), numberOf(tank['depth'])
        self.ratio = numberOf(run.solid['materials']['body']['rho'])/run.density
        table = run.table('body', 'groupMotion.dat')
        self.t, self.y, self.v = (table[k] for k in ('Time', 'freeCentreY', 'freeUy'))
        self.low = self.y - 0.5*self.side
        self.sinks = self.ratio > 1

    def acceleration(self):
        """Of the run, over the first tenth of the side, and in unbounded water"""
        at = (np.abs(self.y - self.y[0]) < 0.1*self.side) & (self.t < 0.2)
        t, y = self.t[at], self.y[at] - self.y[0]
        return 2*float(t**2 @ y/(t**2 @ t**2)), (1 - self.ratio)*g/(self.ratio + addedMass[self.D])

    def draught(self):
        """Mean of the last third: how deep the lower face is under the level of the water"""
        level = self.depth - (1 - self.ratio)*(self.side/self.width)**(self.D - 1)*self.side
        return float(np.mean(level - self.low[self.t > 2/3*self.t[-1]]))


def analyse(run):
    b = Block(run)
    a, exact = b.acceleration()
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    result = [Quantity('acceleration [m/s2]', a, exact, abs(a/exact - 1)),
              Quantity('particles lost', error=first - last)]
    if b.sinks:
        rest = b.low[b.t > 0.9*b.t[-1]]
        # free fall from the start less what the added mass takes: no drag
        fastest = np.sqrt(2*abs(exact)*b.start)
        return (result
                + [Quantity('largest speed / without drag', computed=float(-b.v.min()/fastest)),
                   Quantity('height of the lower face at rest / side',
                            error=float(abs(rest.mean())/b.side)),
                   Quantity('still moving [side]', error=float(np.ptp(rest)/b.side))])
    draught, exact = b.draught(), b.ratio*b.side
    return result + [Quantity('draught [m]', draught, exact, abs(draught/exact - 1))]


def plot(runs, path):
    fig, (height, speed) = plotting.figure(2, width=5)
    for k, run in enumerate(runs):
        b, colour = Block(run), plotting.colours[k % len(plotting.colours)]
        height.plot(b.t, b.low/b.side, color=colour, linewidth=0.9, label=run.name)
        speed.plot(b.t, b.v, color=colour, linewidth=0.9, label=run.name)
        a = b.acceleration()[1]
        early = b.t < 0.25
        speed.plot(b.t[early], a*b.t[early], color=colour, linestyle=':', linewidth=0.9)
    height.set(xlabel='t [s]', ylabel='lower face over the bottom / side')
    speed.set(xlabel='t [s]', ylabel='velocity [m/s]',
              title='dotted: added mass in unbounded water')
    plotting.named(height)
    plotting.save(fig, path)


light = 'constant/solidProperties:materials/body/rho 500; system/body:start 0.2'
flat = 'system/shape:frontAndBack empty; system/tank:thickness 0.01; system/tank:width 0.9'

Study(
    scene='sinkAndRise',
    variants=[Variant('cube'), Variant('cube-fine', ['-spacing', '0.00625'], large=True),
              Variant('cube-rises', ['-endTime', '3', '-set', light]),
              Variant('square', ['-spacing', '0.01', '-set', flat]),
              Variant('square-rises',
                      ['-spacing', '0.01', '-endTime', '4', '-set', f'{flat}; {light}'])],
    quick=[Variant('quick-square', ['-spacing', '0.02', '-endTime', '0.8', '-set', flat]),
           Variant('quick-rises',
                   ['-spacing', '0.02', '-endTime', '2.4', '-set', f'{flat}; {light}'])],
    analyse=analyse,
    plot=plot,
    headline='acceleration [m/s2]',
).main(here)
