# SPDX-License-Identifier: GPL-3.0-or-later
"""Six layers of cylinders collapse, dry, against Zhang et al. (2009)"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf, readDictionary
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
shown = [0, 0.1, 0.3, 0.5]      # times of the experiment's photographs [s]
noGap = ('system/tank:tank 0.26; system/tank:gap 0; system/tank:pitch 0.01; '
         'system/tank:stackWidth 0.06; pairs/default/gap 0')
fractions = [0.02, 0.03, 0.05, 0.06]


def reference(axis):
    """Times and centre of mass over the tank's length"""
    return np.loadtxt(os.path.join(here, 'reference', f'zhang2009_{axis}.csv'), delimiter=',',
                      skiprows=1).T


def centre(run):
    """Time, x/L, y/L"""
    length = numberOf(readDictionary(os.path.join(run.path, 'system', 'tank'))['tank'])
    table = run.table('stack', 'groupMotion.dat')
    return table['Time'], table['freeCentreX']/length, table['freeCentreY']/length


def differences(run):
    """|computed - measured| at the experiment's times: x and y"""
    t, x, y = centre(run)
    result = []
    for axis, values in (('x', x), ('y', y)):
        when, measured = reference(axis)
        result.append(np.abs(np.interp(when, t, values) - measured))
    return result


def analyse(run):
    result = []
    t, *computed = centre(run)
    for axis, values, off in zip('xy', computed, differences(run)):
        when, measured = reference(axis)
        for k, moment in enumerate(shown):
            if moment <= t[-1]:
                result.append(Quantity(f'{axis}/L at {moment:g} s', np.interp(when[k], t, values),
                                       measured[k], off[k]))
        known = when <= t[-1]
        result.append(Quantity(f'{axis}/L, largest difference', error=float(off[known].max())))
    energy = run.table('energy', 'solidEnergies.dat')['total']
    # nothing feeds the scene: what it gains against the least it had is the contact law's or the
    # integrator's
    gained = (energy - np.minimum.accumulate(energy)).max()
    result.append(Quantity('energy gained / energy at the start', float(gained/energy[0])))
    return result


def compare(runs, results):
    """How much of a difference is chance: the same scene with other time steps"""
    family = [centre(runs[n]) for n in runs if n == 'gap' or n.startswith('gap-step')]
    if len(family) < 2:
        return []
    t = shown[1:]
    result = []
    for axis in (1, 2):
        values = np.array([np.interp(t, c[0], c[axis]) for c in family])
        result.append(Quantity(f'{"xy"[axis - 1]}/L, range over time steps, largest',
                               float(np.ptp(values, axis=0).max())))
    return result


def stack(axis, run, moment):
    """The cylinders at a time"""
    name = clouds.nearestTime(run.path, moment)
    cloud = clouds.readCloud(run.path, name, ('radius',), 'solids')
    length = numberOf(readDictionary(os.path.join(run.path, 'system', 'tank'))['tank'])
    plotting.discs(axis, 100*cloud['positions'], 100*cloud['radius'])
    axis.set(xlim=(0, 100*length), ylim=(0, 8), aspect='equal',
             title=f'{run.name}, {float(name):g} s', xlabel='x [cm]')
    axis.grid(False)


def plot(runs, path):
    wanted = [r for r in runs if not r.name.startswith('gap-step')]
    drawn = [r for r in runs if r.name in ('gap', 'noGap')] or runs[:1]
    fig, axes = plotting.figure(3, 1 + len(drawn), width=4.6, height=2.6)
    for axis, k, label in ((axes[0], 1, 'x'), (axes[1], 2, 'y')):
        plotting.measured(axis, *reference(label), label='Zhang et al. (2009)')
        for run in wanted:
            table = centre(run)
            axis.plot(table[0], table[k], linewidth=1, label=run.name)
        for run in runs:
            if run.name.startswith('gap-step'):
                table = centre(run)
                axis.plot(table[0], table[k], linewidth=0.5, color='#bbbbbb', zorder=0)
        axis.set(xlabel='t [s]', ylabel=f'${label}$ of the centre of mass $/L$')
    plotting.named(axes[0])
    for run in wanted:
        energy = run.table('energy', 'solidEnergies.dat')
        axes[2].plot(energy['Time'], energy['total']/energy['total'][0], linewidth=1,
                     label=run.name)
    axes[2].set(xlabel='t [s]', ylabel='energy / at the start')
    for row, run in enumerate(drawn):
        for axis, moment in zip(axes[3*(row + 1):], shown[1:]):
            stack(axis, run, moment)
    plotting.save(fig, path)


Study(
    scene='dryCollapse',
    variants=[Variant('gap'), Variant('noGap', ['-set', noGap]),
              Variant('gap-oneStep', ['-set', 'contact/tangential oneStep']),
              Variant('noGap-oneStep', ['-set', noGap + '; contact/tangential oneStep']),
              Variant('noGap-linear', ['-set', noGap + '; contact/normal linear']),
              *[Variant(f'gap-step{f:g}', ['-set', f'stepFraction {f}']) for f in fractions]],
    quick=[Variant('gap-quick', ['-endTime', '0.3'])],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='x/L, largest difference',
).main(here)
