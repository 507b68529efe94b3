# SPDX-License-Identifier: GPL-3.0-or-later
"""What picStability found"""
from riprap import plotting

from . import groups, number


def draw(rows, path):
    if not rows:
        print('picStability: no rows to draw')
        return
    fig, axes = plotting.figure(2, 3, width=5.6, height=4.4)
    drawSteps(axes[0], [r for r in rows if r['test'] == 'step'])
    drawBlend(axes[1], [r for r in rows if r['test'] == 'blend'])
    drawParticles(axes[2], [r for r in rows if r['test'] == 'particles'], 'velocity L2')
    drawParticles(axes[3], [r for r in rows if r['test'] == 'particles'], 'noise')
    drawTolerance(axes[4], [r for r in rows if r['test'] == 'tolerance'])
    drawLevels(axes[5], [r for r in rows if r['test'] == 'levels'])
    plotting.save(fig, path)


def drawSteps(axis, rows):
    kinds = list(dict.fromkeys(r['kind'] for r in rows))
    for i, (quantity, points) in enumerate(groups(rows, lambda r: r['quantity']).items()):
        axis.barh([kinds.index(r['kind']) + 0.36*i for r in points],
                  [number(r['measured']) for r in points], height=0.34, color=plotting.colours[i],
                  label=quantity.split(', ')[1])
    axis.set_yticks([k + 0.18 for k in range(len(kinds))], kinds, fontsize=6)
    axis.axvline(0.5, color='k', linestyle='--', linewidth=0.8, label='maxCo of the tutorials')
    axis.set(xlabel='largest Courant number (2: none found)', title='Energy grows by less than 5 %')
    plotting.named(axis)


def drawBlend(axis, rows):
    for i, (quantity, points) in enumerate(groups(rows, lambda r: r['quantity']).items()):
        mixed = [r for r in points if r['kind'] == 'flipPic']
        axis.semilogx([max(number(r['setting']), 1e-3) for r in mixed],
                      [number(r['measured']) for r in mixed], 'o-', markersize=3,
                      color=plotting.colours[i], label=quantity)
        for r in points:
            if r['kind'] == 'apic':
                axis.axhline(number(r['measured']), color=plotting.colours[i], linestyle=':',
                             linewidth=1)
    axis.set(xlabel='PIC\'s part (1e-3: none); dotted: APIC',
             title='Vortices without viscosity, 32 cells, t U/L = 4')
    plotting.named(axis)


def drawParticles(axis, rows, quantity):
    for i, (kind, points) in enumerate(groups([r for r in rows if r['quantity'] == quantity],
                                              lambda r: r['kind']).items()):
        axis.loglog([number(r['setting']) for r in points], [number(r['measured']) for r in points],
                    marker=plotting.markers[i], markersize=4, linewidth=1,
                    color=plotting.colours[i], label=kind)
    axis.set(xlabel='particles a cell', ylabel=quantity, title='Vortices, t U/L = 2')
    plotting.named(axis)


def drawTolerance(axis, rows):
    for i, quantity in enumerate(('volume put right', 'volume error')):
        points = [r for r in rows if r['quantity'] == quantity]
        axis.loglog([number(r['setting']) for r in points],
                    [max(number(r['measured']), 1e-16) for r in points], 'o-', markersize=4,
                    color=plotting.colours[i], label=quantity)
    axis.set(xlabel='tolerance of p', ylabel='relative', title='Sloshing, four periods')
    plotting.named(axis)


def drawLevels(axis, rows):
    for i, (kind, points) in enumerate(groups(rows, lambda r: r['kind']).items()):
        axis.semilogy([number(r['setting']) for r in points],
                      [max(number(r['measured']), 1e-18) for r in points], 'o-', markersize=4,
                      color=plotting.colours[i], label=f'{kind} anywhere in a cell')
    axis.axhline(1e-6, color='k', linestyle='--', linewidth=0.8, label='bound')
    axis.set(xlabel='place in the cell', ylabel='largest speed [m/s]',
             title='Pools at rest: theta, apertures')
    plotting.named(axis)
