# SPDX-License-Identifier: GPL-3.0-or-later
"""Bonds break at the strength that they were given, and nowhere else"""
import os

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def analyse(run):
    table = run.table('broken')
    broken, tension, shear = (int(table[name][-1]) for name in ('broken', 'inTension', 'inShear'))
    if run.name.startswith('bar'):
        bonds = 9
        # which one: the halves part between particles 4 and 5
        bodies = run.table('bodies')
        gaps = [bodies[f'{i + 1}Dx'][-1] - bodies[f'{i}Dx'][-1] for i in range(bonds)]
        return [Quantity('broken bonds', computed=broken),
                Quantity('broken in tension', computed=tension),
                Quantity('the bond that parted', computed=max(range(bonds), key=lambda i: gaps[i]))]
    out = [Quantity('broken bonds', computed=broken)]
    if 'above' in run.name:
        out.append(Quantity('in the way that was meant',
                            computed=shear if 'shear' in run.name else tension))
    return out


def plot(runs, path):
    fig, axes = plotting.figure(1)
    for run in runs:
        if run.name.startswith('bar'):
            table = run.table('broken')
            axes[0].plot(table['Time'], table['maxTension'],
                         label=f'{run.name}: largest tension of whole bonds')
            axes[0].plot(table['Time'], table['broken']*1e2,
                         label=f'{run.name}: broken bonds x 100')
    axes[0].set(xlabel='t [s]', ylabel='[N]')
    if axes[0].lines:
        plotting.named(axes[0])
    plotting.save(fig, path)


# The weak bond of two halves whose motion is given carries 10000 Pa at 0.1 s, whatever the way. It
# is given 9999.99 Pa, since foamDictionary, which sets entries, keeps six digits: at 0.0999998 s
# the bond is 1e-6 below its strength, at 0.1 s above it
turned = ('groups/moved/motion/solidBodyMotionFunction rotatingMotion',)
ways = {
    'tension': ('bonds/weak/tensileStrength 9999.99',),
    'shear': ('groups/moved/motion/linearMotionCoeffs/velocity (0 2e-4 0)',
              'bonds/weak/tensileStrength none',
              'bonds/weak/shearStrength 9999.99'),
    'bending': ('bonds/weak/tensileStrength 9999.99', *turned),
}


def single(way, mesh, side):
    end = '0.0999998' if side == 'below' else '0.1'
    sets = ('system/bar:n 4', 'system/bar:rigid yes', f'system/bar:frontAndBack {mesh}',
            f'system/controlDict:writeInterval {end}', 'system/controlDict:sampleInterval 0.01',
            *ways[way])
    name = f'{way}-{"2D" if mesh == "empty" else "3D"}-{side}'
    return Variant(name, ['-endTime', end, *(option for s in sets for option in ('-set', s))])


singles = [single(way, mesh, side) for way in ways for mesh in ('empty', 'patch')
           for side in ('below', 'above')]

Study(
    scene='bondBreakage',
    variants=[*singles, Variant('bar'),
              Variant('bar3D', ['-set', 'system/bar:frontAndBack patch'])],
    quick=[*singles[:2], Variant('bar')],
    analyse=analyse,
    plot=plot,
    headline='broken bonds',
).main(here)
