# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds on a slope, and a pile: springs that remember do, the one-step spring creeps at m g
sin(theta)/(kt dt)"""
import math
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
mass = 2500*4/3*math.pi*0.005**3


def slope(run):
    table = run.table('bodies')
    t, x = table['Time'], table['0Dx']
    late = t > 0.5*t[-1]
    speed = np.polyfit(t[late], x[late], 1)[0]
    gravity = [float(v) for v in run.dictionary('constant/g')['value'].strip('() ').split()]
    if run.solid['contact']['tangential'] == 'oneStep':
        kt = 0.2857*2e4
        predicted = mass*gravity[0]/(kt*numberOf(run.control['deltaT']))
        # with its dashpot the force is (kt dt + ct) v: the creep without one is the law's own
        return [Quantity('speed of creep [m/s]', reference=predicted, computed=speed,
                         error=abs(speed/predicted - 1))]
    return [Quantity('speed at rest [m/s]', error=abs(speed)),
            Quantity('displacement [radii]', error=abs(x[-1])/0.005)]


def pile(run):
    table = run.table('bodies')
    base = range(16)
    moved = [math.hypot(table[f'{i}Dx'][-1], table[f'{i}Dy'][-1])/0.005 for i in base]
    energy = run.table('energy')
    kinetic = energy['translation'] + energy['rotation']
    name = ('creep of the base [radii]' if run.solid['contact']['tangential'] == 'oneStep'
            else 'base moved by [radii]')
    return [Quantity(name, computed=max(moved)),
            Quantity('kinetic energy at the end / m g R', computed=kinetic[-1]/(mass*9.81*0.005))]


def analyse(run):
    return slope(run) if run.dictionary('system/scene')['name'] == 'slope' else pile(run)


def plot(runs, path):
    fig, (slopes, piles) = plotting.figure(2)
    for run in runs:
        table = run.table('bodies')
        if run.dictionary('system/scene')['name'] == 'slope':
            slopes.plot(table['Time'], table['0Dx']/0.005, label=run.name)
        else:
            moved = np.max([np.hypot(table[f'{i}Dx'], table[f'{i}Dy']) for i in range(16)], axis=0)
            piles.semilogy(table['Time'][1:], moved[1:]/0.005, label=run.name)
    slopes.set(xlabel='t [s]', ylabel='moved down the slope [radii]')
    piles.set(xlabel='t [s]', ylabel='base of the pile moved by [radii]')
    for axis in (slopes, piles):
        plotting.named(axis)
    plotting.save(fig, path)


def variant(name, *sets):
    return Variant(name, [option for s in sets for option in ('-set', s)])


oneStep = ('contact/tangential oneStep', 'pairs/default/tangentialDamping no')
pyramid = ('system/scene:name pile', 'constant/g:value (0 0 -9.81)', 'system/controlDict:endTime 4',
           'pairs/default/friction 0.8')

Study(
    scene='inclineAndPile',
    variants=[
        variant('slope'),
        variant('slope-incremental', 'contact/normal incremental'),
        variant('slope-oneStep', *oneStep),
        variant('slope-oneStep-2dt', *oneStep, 'system/controlDict:deltaT 2e-5'),
        variant('pile', *pyramid),
        variant('pile-oneStep', *pyramid, *oneStep),
    ],
    quick=[variant('slope'), variant('slope-oneStep', *oneStep)],
    analyse=analyse,
    plot=plot,
    headline='displacement [radii]',
).main(here)
