# SPDX-License-Identifier: GPL-3.0-or-later
"""Collapse of 33 cylinders: mean centre of mass against Zhang et al. (2009)"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def measured(axis):
    """t [s] and centre of mass over L; what was digitised just before 0 s is at 0 s"""
    data = np.loadtxt(os.path.join(here, 'reference', f'exp_{axis}_com.csv'), delimiter=',', skiprows=1)
    return np.column_stack([np.maximum(data[:, 0], 0), data[:, 1]])


def centre(run):
    table, L = run.table('stack'), numberOf(run.dictionary('system/stack')['tank'])
    return table['Time'], table['freeCentreX']/L, table['freeCentreY']/L


def analyse(run):
    t, x, y = centre(run)
    out = []
    for axis, values in (('x', x), ('y', y)):
        for time, reference in measured(axis):
            computed = np.interp(time, t, values)
            out.append(Quantity(f'{axis} of the centre / L at {round(time, 1):g} s', reference=reference, computed=computed,
                                error=abs(computed - reference)))
    return out


def plot(runs, path):
    fig, axes = plotting.figure(3)
    for run in runs:
        t, x, y = centre(run)
        axes[0].plot(t, x, label=run.name)
        axes[1].plot(t, y, label=run.name)
    for k, axis in enumerate('xy'):
        data = measured(axis)
        plotting.measured(axes[k], data[:, 0], data[:, 1], 'Zhang et al. (2009)')
        axes[k].set(xlabel='t [s]', ylabel=f'{axis} of the centre of mass / L')
        axes[k].legend(fontsize=7)
    run = runs[0]
    for shift, time in enumerate(('0.1', '0.3', '0.5')):
        cloud = clouds.readCloud(run.path, clouds.nearestTime(run.path, float(time)), ['radius'], 'solids')
        for (x, y, _), radius in zip(cloud['positions'], cloud['radius']):
            axes[2].add_patch(plotting.plt.Circle((x + 0.3*shift, y), radius, fill=False, linewidth=0.6))
    axes[2].set(xlim=(0, 0.9), ylim=(0, 0.15), aspect='equal', xlabel=f'x [m], {run.name} at 0.1, 0.3, 0.5 s, side by side')
    plotting.save(fig, path)


def variant(name, *sets):
    return Variant(name, [option for s in sets for option in ('-set', s)])


noGap = ('system/stack:tank 0.26', 'system/stack:spacing 0.01', 'system/stack:corner 0', 'system/stack:width 0.06',
         'pairs/aluminium-aluminium/gap 0', 'pairs/aluminium-wall/gap 0')
variants = [
    variant('gap'),
    variant('gap-oneStep', 'contact/tangential oneStep'),
    variant('noGap', *noGap),
    variant('noGap-linear', *noGap, 'contact/normal linear'),
    variant('noGap-double', *noGap, 'precision double'),
    variant('gap-halfStep', 'stepFraction 0.025'),
]

Study(
    scene='dryCollapse',
    variants=variants,
    quick=[variants[0]],
    analyse=analyse,
    plot=plot,
    headline='x of the centre / L at 0.3 s',
).main(here)
