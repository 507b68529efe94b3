# SPDX-License-Identifier: GPL-3.0-or-later
"""A column of water that collapses: front and height against Koshizuka & Oka (1996) and Martin &
Moyce (1952)"""
import os

import numpy as np

from . import fronts, measures, plotting
from .bounds import Quantity, root
from .dictionaries import numberOf

# Experiments: name, file, factor of sqrt(g/a) in its time, factor of its ordinate to units of a
columnFronts = [('Koshizuka & Oka', 'koshizukaOka1996_front', 2**0.5, 1),
                ('Martin & Moyce n2=2', 'martinMoyce1952_n2_2_front', 2**0.5, 1)]
columnHeights = [('Koshizuka & Oka', 'koshizukaOka1996_height', 2**0.5, 2),
                 ('Martin & Moyce n2=2', 'martinMoyce1952_n2_2_height', 1, 2)]
squareFronts = [('Martin & Moyce n2=1', 'martinMoyce1952_n2_1_front', 1, 1)]
squareHeights = [('Martin & Moyce n2=1', 'martinMoyce1952_n2_1_height', 1, 1)]


class Collapse:
    """Front and height of a run, made dimensionless, and the experiments that belong to it"""

    def __init__(self, run):
        tank = run.dictionary('system/tank')
        self.a, height, self.width = (numberOf(tank[k])
                                      for k in ('columnWidth', 'columnHeight', 'tankWidth'))
        self.square = height < 1.5*self.a
        table = run.table('front', 'frontPosition.dat')
        self.t, self.front = table['Time'], table['frontFloor']
        self.height = run.table('columnHeight', 'waterLevel.dat')['lowest0']
        self.lost = table['escaped'][-1]/table['particles'][0]
        self.rate = np.sqrt(9.81/self.a)
        self.hit = measures.crossing(self.t, self.front, self.width - 2*run.spacing)
        self.fronts = squareFronts if self.square else columnFronts
        self.heights = squareHeights if self.square else columnHeights

    def frontCurve(self, factor):
        """T and Z until the front reaches the far wall"""
        t, x = measures.upTo(self.t, self.front, self.width - 2e-9 if self.hit is None
                             else np.interp(self.hit, self.t, self.front))
        return t*self.rate*factor, x/self.a


def reference(name):
    return fronts.readReference(os.path.join(root(), 'tutorials', 'sphDem', 'damBreak', 'reference',
                                             name + '.csv'))


def analyse(run):
    c = Collapse(run)
    result = []
    for name, file, factor, _ in c.fronts:
        T, Z = c.frontCurve(factor)
        shift, rms = fronts.fitShift(T, Z, reference(file))
        result.append(Quantity(f'front rms [a], {name}', error=rms))
        result.append(Quantity(f'shift in T of the gate, {name}', computed=shift))
    for name, file, factor, scale in c.heights:
        measured = heightData(c, file, factor, scale)
        if len(measured):
            computed = np.interp(measured[:, 0], c.t, c.height/c.a)
            result.append(Quantity(f'height rms [a], {name}',
                                   error=measures.rms(computed - measured[:, 1])))
    if not c.square:
        result.append(Quantity('far wall hit [s]', reference=0.26, computed=c.hit))
    result.append(Quantity('particles lost', computed=c.lost))
    result.append(Quantity('front at the start [a]', reference=1, computed=c.front[0]/c.a))
    return result


def heightData(c, file, factor, scale):
    """Measured t and h/a while the water is still falling at the left wall: up to the run's end,
    and
    in the tank until the wave from the far wall can be back (0.5 s)"""
    data = reference(file)
    t = data[:, 0]/(c.rate*factor)
    keep = t <= min(c.t[-1], np.inf if c.square else 0.5)
    return np.column_stack([t[keep], scale*data[keep, 1]])


def plot(runs, path):
    fig, (front, height, energy) = plotting.figure(3)
    marked = set()
    for run in runs:
        c = Collapse(run)
        if c.square and len(runs) > 1:
            continue
        T, Z = c.frontCurve(2**0.5)
        colour = front.plot(T, Z, label=run.name)[0].get_color()
        height.plot(c.t*c.rate*2**0.5, c.height/c.a, label=run.name)
        for i, (name, file, factor, _) in enumerate(c.fronts):
            if name not in marked:
                marked.add(name)
                shift, _ = fronts.fitShift(*c.frontCurve(factor), reference(file))
                data = reference(file)
                plotting.measured(front, (data[:, 0] - shift)*2**0.5/factor, data[:, 1],
                                  f'{name}, T - {shift:.2f}', i)
        for i, (name, file, factor, scale) in enumerate(c.heights):
            if name + 'h' not in marked:
                marked.add(name + 'h')
                data = heightData(c, file, factor, scale)
                plotting.measured(height, data[:, 0]*c.rate*2**0.5, data[:, 1], name, i)
        e = run.table('energy', 'energyBalance.dat')
        total = e['potential'][0] + e['kinetic'][0] + e['elastic'][0]
        for name, style in (('kinetic', '-'), ('potential', '--'), ('dissipated', ':')):
            energy.plot(e['Time'], e[name]/total, style, color=colour,
                        label=name if run is runs[0] else None)
    front.set(xlabel='$T = t\\,\\sqrt{2g/a}$', ylabel='front $x/a$', ylim=(0.9, 4.1))
    height.set(xlabel='$T$', ylabel='height at the left wall $h/a$', ylim=(0, 2.1))
    energy.set(xlabel='t [s]', ylabel='energy / energy at the start')
    for axis in (front, height, energy):
        plotting.named(axis)
    plotting.save(fig, path)
