# SPDX-License-Identifier: GPL-3.0-or-later
"""A box that floats, 0.3 m wide with a draught of 0.1 m, let go from 0.02 m above where it floats,
or turned by 5 degrees: periods, against linear potential theory (riprap.floatingBox)"""
import math
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.floatingBox import FloatingBox
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
width, height, draught, rho = 0.3, 0.16, 0.1, 625
floats = height/2 - draught         # height of the centre


def tank(run):
    return run.dictionary('system/tank')


def kind(run):
    """heave, roll or still, by what the run begins with"""
    if numberOf(tank(run)['angle']):
        return 'roll'
    return 'still' if abs(numberOf(tank(run)['centre']) - floats) < 1e-9 else 'heave'


def series(run):
    """Times, and the height above where it floats or the angle, over the first"""
    if kind(run) == 'roll':
        table = run.table('ends', 'particleDisplacement.dat')
        a, b = (n[:-1] for n in table if n[:-1].isdigit() and n.endswith('X'))
        line = np.arctan2(table[b + 'Y'] - table[a + 'Y'], table[b + 'X'] - table[a + 'X'])
        return table['Time'], line - line[0] + math.radians(numberOf(tank(run)['angle']))
    table = run.table('box', 'groupMotion.dat')
    return table['Time'], table[tank(run)['moves'] + 'CentreY'] - floats


def theory(run, times):
    depth = -numberOf(tank(run)['bottom'])
    if kind(run) == 'roll':
        mass = rho*width*height
        return FloatingBox(width, draught, depth,
                           axis=floats).roll(times, mass*(width**2 + height**2)/12, floats)
    return FloatingBox(width, draught, depth).heave(times)


def crossings(times, values):
    i = np.flatnonzero(values[:-1]*values[1:] < 0)
    return times[i] - values[i]*(times[i + 1] - times[i])/(values[i + 1] - values[i])


def period(times, values):
    """From the first time that it passes where it floats to the third"""
    found = crossings(times, values)
    return float(found[2] - found[0]) if len(found) > 2 else math.nan


def analyse(run):
    times, values = series(run)
    if kind(run) == 'still':
        return [Quantity('drift of the draught [draughts]', float(np.abs(values).max()/draught))]
    exact = theory(run, times)
    computed, reference = period(times, values), period(times, exact)
    first = times < 1.2*reference
    rms = math.sqrt(np.mean((values[first]/values[0] - exact[first])**2))
    return [Quantity('period [s]', computed, reference, abs(computed/reference - 1)),
            Quantity('rms of the first 1.2 periods', rms)]


def plot(runs, path):
    fig, axes = plotting.figure(2)
    for axis, motion in zip(axes, ('heave', 'roll')):
        mine = [r for r in runs if kind(r) == motion]
        for r in mine:
            times, values = series(r)
            axis.plot(times, values/values[0], linewidth=1, label=r.name)
        if mine:
            axis.plot(times, theory(mine[0], times), 'k--', linewidth=1, label='potential theory')
            plotting.named(axis)
        axis.set(xlabel='t [s]', ylabel=f'{motion} / first')
    plotting.save(fig, path)


def grid(motion, offset=0, n=250):
    """offset: of the grid against the surface, in cells; n: cells in the length"""
    h = 5/n
    bottom = -0.5 - offset*h
    top = bottom + 36*0.02
    entries = (f'system/tank:nx {n}; system/tank:ny {round(0.72/h)}; system/tank:bottom '
               f'{bottom:.12g}; system/tank:top {top:.12g}; system/tank:spacing {h/4:.12g}')
    if motion != 'heave':
        entries += f'; system/tank:centre {floats:.12g}'
    if motion == 'roll':
        entries += '; system/tank:angle 5; system/tank:moves roll'
    if motion == 'still':
        entries += '; system/tank:moves free'
    return ['-set', entries]


offsets = (0, 0.25, 0.5, 0.75)
Study(
    scene='picFloatingBox',
    variants=[Variant(f'{motion}-{offset:g}', grid(motion, offset))
              for motion in ('heave', 'roll', 'still') for offset in offsets]
    + [Variant(f'{motion}-fine', grid(motion, 0.25, 500)) for motion in ('heave', 'roll')],
    quick=[Variant('heave-0.25-quick', grid('heave', 0.25, 125)),
           Variant('roll-0.5-quick', grid('roll', 0.5, 125))],
    analyse=analyse,
    plot=plot,
    headline='period [s]',
).main(here)
