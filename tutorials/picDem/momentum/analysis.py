# SPDX-License-Identifier: GPL-3.0-or-later
"""Does what water, solids and walls give each other in a step add up?"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def balance(run):
    """Times, impulses by name (steps, 3), and what they are together in each step"""
    table = run.table('momentum', 'momentumBalance.dat')
    impulse = {name: np.array([table[name + axis][1:] for axis in 'XYZ']).T for name in (
        'water', 'gravity', 'walls', 'solids', 'other', 'residual', 'particles')}
    scale = sum(np.linalg.norm(impulse[name], axis=1) for name in ('gravity', 'walls', 'solids'))
    return table['Time'][1:], impulse, scale


def analyse(run):
    t, impulse, scale = balance(run)
    residual = np.linalg.norm(impulse['residual'], axis=1)
    again = (impulse['gravity'] + impulse['other'] - impulse['walls'] - impulse['solids']
             - impulse['water'])
    share = np.linalg.norm(impulse['solids'], axis=1)/scale
    return [Quantity('end [s]', computed=float(t[-1])),
            Quantity('steps', computed=len(t)),
            Quantity('residual of a step / its impulses, largest',
                     computed=float((residual/scale).max())),
            Quantity('residual of a step / its impulses, median',
                     computed=float(np.median(residual/scale))),
            Quantity('residual of all steps / their impulses',
                     computed=float(np.linalg.norm(again.sum(axis=0))/scale.sum())),
            Quantity('solids / impulses, mean', computed=float(share.mean())),
            Quantity('what particles got beside it / impulses, mean', computed=float(
                (np.linalg.norm(impulse['particles'] - impulse['water'], axis=1)/scale).mean()))]


def plot(runs, path):
    fig, (left, right) = plotting.figure(2, width=5, height=3.4)
    t, impulse, scale = balance(runs[0])
    dt = np.diff(t, prepend=0)
    kick = 0.5*(dt + np.append(0, dt[:-1]))                     # what a step kicks with
    for name, sign, label in (('gravity', 1, 'weight of the water'), ('walls', -1, 'of walls'),
                              ('solids', -1, 'of solids'), ('water', 1, 'sum: what it gets')):
        left.plot(t, sign*impulse[name][:, 1]/kick, linewidth=0.8, label=label)
    left.set(xlabel='t [s]', ylabel='force on the water, upwards [N]', title=runs[0].name)
    plotting.named(left)
    for run in runs:
        t, impulse, scale = balance(run)
        right.semilogy(t, np.maximum(np.linalg.norm(impulse['residual'], axis=1)/scale, 1e-18),
                       linewidth=0.8, label=run.name)
    right.set(xlabel='t [s]', ylabel='residual of a step / its impulses')
    plotting.named(right)
    plotting.save(fig, path)


space = ('system/tank:depth 0.3; system/sides:nz 30; system/sides:sideType wall; system/tank:list '
         '"system/balls.csv"; constant/solidProperties:pairs/default/stiffness 5e3')
once = 'reflection no'
loose = 'system/fvSolution:solvers/p/tolerance 1e-4'
Study(
    scene='picMomentum',
    variants=[Variant('disks'), Variant('disks-short', ['-set', 'system/controlDict:maxCo 0.1']),
              Variant('disks-once', ['-set', once]),
              Variant('disks-once-loose', ['-set', f'{once}; {loose}']),
              Variant('disks-once-mixed', ['-set', f'{once}; precision mixed']),
              Variant('balls', ['-endTime', '0.5', '-set', space]),
              Variant('balls-once', ['-endTime', '0.5', '-set', f'{space}; {once}'])],
    quick=[Variant('disks-quick', ['-endTime', '0.1', '-set', once])],
    analyse=analyse,
    plot=plot,
    headline='residual of a step / its impulses, largest',
).main(here)
