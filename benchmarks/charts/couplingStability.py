# SPDX-License-Identifier: GPL-3.0-or-later
"""What couplingStability found, beside theory"""
import numpy as np

from riprap import plotting

from . import groups, number

forces = ('held', 'interpolated', 'impulse')
hatches = {'held': '', 'interpolated': '//', 'impulse': '..'}


def draw(rows, path):
    if not rows:
        print('couplingStability: no rows to draw')
        return
    fig, axes = plotting.figure(2, 2, width=6.6, height=5)
    density, step, bonds, damping = axes
    drawBars(density, [r for r in rows if r['test'] == 'density' and r['body'] == 'rigid'],
             'least density ratio', 'Rigid body, $c_0 dt = 0.4 h$')
    theory = [number(r['theory']) for r in rows if r['test'] == 'density' and r['body'] == 'rigid']
    if theory:
        density.axhline(theory[0], color='k', linestyle=':', linewidth=1,
                        label='half the water that sound reaches')
    density.set_yscale('log')
    plotting.named(density)
    drawBars(step, [r for r in rows if r['test'] == 'step' and number(r['setting']) < 1],
             'largest $c_0 dt/h$', 'Rigid body, density ratio 0.3')
    drawGain(bonds, [r for r in rows if r['quantity'].startswith('energy')])
    drawDamping(damping, [r for r in rows if r['quantity'] == 'least damping ratio'])
    plotting.save(fig, path)


def drawBars(axis, rows, label, title):
    kinds = list(dict.fromkeys(r['coupling'] for r in rows))
    for k, force in enumerate(forces):
        found = {r['coupling']: number(r['measured']) for r in rows if r['force'] == force}
        axis.bar(np.arange(len(kinds)) + 0.27*(k - 1), [found.get(c, np.nan) for c in kinds],
                 width=0.25, color=plotting.colours[k], label=force)
    axis.set_xticks(range(len(kinds)), [c.replace('pressure', 'p. ') for c in kinds], fontsize=6)
    axis.set(ylabel=label, title=title)
    plotting.named(axis)


def drawGain(axis, rows):
    for i, ((force, coupling), points) in (
            enumerate(groups(rows, lambda r: (r['force'], r['coupling'])).items())):
        gain = [min(max(number(r['measured']), 1e-4), 1e2) for r in points]
        axis.loglog([number(r['setting']) for r in points], gain,
                    ('.-' if coupling == 'extrapolated' else 'x--'),
                    color=plotting.colours[forces.index(force)], linewidth=1,
                    label=f'{force}, {coupling}')
    axis.set(xlabel='$E/(\\rho c_0^2)$', ylabel='energy gained / kinetic',
             title='Undamped bonds, density ratio 1.1')
    plotting.named(axis)


def drawDamping(axis, rows):
    for i, (coupling, points) in enumerate(groups(rows, lambda r: r['coupling']).items()):
        x = [number(r['setting']) for r in points]
        axis.loglog(x, [number(r['measured']) for r in points], plotting.markers[i],
                    color=plotting.colours[i], markersize=4, label=f'{coupling}, held')
        axis.loglog(x, [number(r['theory']) for r in points], '-', color=plotting.colours[i],
                    linewidth=1, label='0.362 of the share of stiffness')
    axis.set(xlabel='$E/(\\rho c_0^2)$', ylabel='least damping ratio of bonds',
             title='What holds them (1e-4: none needed)')
    plotting.named(axis)
