# SPDX-License-Identifier: GPL-3.0-or-later
"""A bonded bar holds just below its strength, and breaks at one bond just above it"""
import os
import re

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def bar(run):
    return run.dictionary('system/bar')


def statics(run):
    """What system/makeParticles.py says of the first bond: N, V, M, T, stresses"""
    with open(os.path.join(run.path, 'constant', 'cement')) as f:
        return [float(x)
                for x in re.findall(r'(?:N|V|M|T|stress) ([-\d.e+]+)', f.read().split('//')[1])]


def bonds(run):
    """First end and kind of breakage of each bond, at the last time"""
    folder = os.path.join(run.path, clouds.times(run.path)[-1], 'uniform', 'lagrangian', 'solids',
                          'bonds')
    return [clouds.readField(os.path.join(folder, name)) for name in ('a', 'broken')]


def analyse(run):
    test, breaks = bar(run)['test'], numberOf(bar(run)['margin']) < 0
    first, broken = bonds(run)
    expected = (2 if test in ('shear', 'torsion') else 1) if breaks else 0
    result = [Quantity('first bond: 0 whole, 1 broken in tension, 2 in shear',
                       float(broken[first == 0][0]), expected,
                       abs(float(broken[first == 0][0]) - expected)),
              Quantity('bonds broken elsewhere', float(np.count_nonzero(broken[first != 0])))]
    if not breaks:
        table = run.table('bonds', 'brokenBonds.dat')
        N, V = statics(run)[:2]
        for name, column, exact in (('pull', 'maxTension', N), ('shear force', 'maxShear', V)):
            if exact > 0:
                computed = table[column][-1]
                result.append(Quantity(f'{name} in the first bond [N]', computed, exact,
                                       abs(computed/exact - 1)))
                result.append(Quantity(f'{name}, largest on the way over statics',
                                       float(table[column].max()/exact - 1)))
    return result


def plot(runs, path):
    fig, axes = plotting.figure(2, width=5.5, height=3.4)
    for run in runs:
        if numberOf(bar(run)['margin']) < 0:
            continue
        table = run.table('bonds', 'brokenBonds.dat')
        N, V = statics(run)[:2]
        column, exact = ('maxTension', N) if N > 0 else ('maxShear', V)
        if exact > 0:
            axes[0].semilogy(1e3*table['Time'][1:], np.abs(1 - table[column][1:]/exact),
                             linewidth=1, label=run.name)
    axes[0].axhline(1e-6, color='#444444', linewidth=0.7, linestyle='--')
    axes[0].set(xlabel='t [ms]', ylabel='1 - force / statics',
                title='first bond, just below its strength')
    plotting.named(axes[0])
    for k, run in enumerate(runs):
        first, broken = bonds(run)
        colour = ['#bbbbbb', '#D55E00', '#0072B2']
        for i in range(6):
            axes[1].add_patch(plotting.plt.Circle((i, k), 0.3, facecolor='#eeeeee',
                                                  edgecolor='#222222', linewidth=0.5))
        for a, b in zip(first, broken):
            axes[1].plot([a + 0.3, a + 0.7], [k, k], color=colour[int(b)],
                         linewidth=3 if b == 0 else 1.5, linestyle='-' if b == 0 else ':')
    axes[1].set(yticks=range(len(runs)), yticklabels=[r.name for r in runs],
                xlabel='particle', xlim=(-0.5, 5.5), ylim=(-0.7, len(runs) - 0.3),
                title='grey: whole, red: broken in tension, blue: in shear')
    axes[1].tick_params(axis='y', labelsize=6)
    axes[1].grid(False)
    plotting.save(fig, path)


def variants():
    for test in ('tension', 'shear', 'bending', 'combined', 'torsion'):
        for space, sides in (('2D', 'empty'), ('3D', 'patch')):
            if test == 'torsion' and space == '2D':
                continue
            for word, margin in (('holds', '1e-6'), ('breaks', '-1e-6')):
                yield Variant(f'{test}{space}-{word}',
                              ['-set', f'system/bar:test {test}; system/bar:margin {margin}; '
                                       f'system/bar:sides {sides}',
                               '-endTime', '0.1' if test in ('tension', 'torsion') else '0.6'])


Study(
    scene='bondStrength',
    variants=list(variants()),
    quick=[v for v in variants() if v.name.startswith('bending2D')],
    analyse=analyse,
    plot=plot,
    headline='first bond: 0 whole, 1 broken in tension, 2 in shear',
).main(here)
