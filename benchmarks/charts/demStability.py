# SPDX-License-Identifier: GPL-3.0-or-later
"""What demStability found, beside theory, and the settled pile of runPeers"""
import numpy as np

from riprap import plotting

from . import groups, number


def draw(rows, peers, path):
    if not rows:
        print('demStability: no rows to draw')
        return
    fig, (limits, drift, pile, creep, gap, damping) = plotting.figure(3, 2, width=6.4, height=4.6)
    drawLimits(limits, [r for r in rows if r['test'] == 'limits' and r['integrator'] == 'leapfrog'])
    drawDrift(drift, [r for r in rows if r['test'] == 'drift'])
    drawPile(pile, [p for p in peers if p['case'] == 'step'])
    drawCreep(creep, [r for r in rows if r['test'] == 'creep'])
    drawGap(gap, [r for r in rows if r['test'] == 'gapLeft'])
    drawDamping(damping, [r for r in rows if r['test'] == 'localDamping'])
    plotting.save(fig, path)


def stepOf(row):
    return float(row['quantity'].split('= ')[1])


def drawLimits(axis, rows):
    y = np.arange(len(rows))
    axis.barh(y, [number(r['measured']) for r in rows], color=plotting.colours[0], height=0.6,
              label='measured')
    axis.plot([number(r['theory']) for r in rows], y, 'k|', markersize=9, label='theory: 2/w')
    for x, name, style in ((0.5, 'refused above', '-'), (0.2, 'default', ':')):
        axis.axvline(x, color=plotting.colours[1], linestyle=style, linewidth=1, label=name)
    axis.set_yticks(y, [r['scene'] for r in rows], fontsize=6)
    axis.set(xlabel='largest $dt/\\sqrt{m/k}$', title='Undamped springs; e: with a dashpot',
             ylim=(len(rows) - 0.4, -0.6))
    plotting.named(axis)


def drawDrift(axis, rows):
    for i, ((scene, integrator), points) in (
            enumerate(groups(rows, lambda r: (r['scene'], r['integrator'])).items())):
        axis.loglog([stepOf(r) for r in points], [number(r['measured']) for r in points],
                    '.-' if integrator == 'leapfrog' else 'x--',
                    color=plotting.colours[0 if 'linear' in scene else 1], linewidth=1,
                    label=f'{scene}, {integrator}')
    axis.set(xlabel='$dt/\\sqrt{m/k}$', ylabel='largest change of energy',
             title='Elastic gas, 125 bodies, $t = 20000 \\sqrt{m/k}$')
    plotting.named(axis)


def drawPile(axis, rows):
    for i, (code, points) in enumerate(groups(rows, lambda r: r['code'].split(',')[0]).items()):
        axis.semilogy([float(r['code'].split()[-2]) for r in points],
                      [max(float(r['value']), 1e-28) for r in points],
                      plotting.markers[i] + '-', color=plotting.colours[i], markersize=4,
                      linewidth=1, label=code)
    axis.set(xlabel='$dt/\\sqrt{m/k}$', ylabel='kinetic energy after 4 s / $m g R$',
             title='Pyramid of 30 spheres at rest, linear springs')
    plotting.named(axis)


def drawCreep(axis, rows):
    axis.loglog([stepOf(r) for r in rows], [number(r['theory']) for r in rows], 'k-', linewidth=1,
                label='$m g \\sin/(k_t dt)$')
    axis.loglog([stepOf(r) for r in rows], [number(r['measured']) for r in rows], 'o',
                color=plotting.colours[0], label='measured')
    axis.set(xlabel='$dt/\\sqrt{m/k}$', ylabel='speed / $(g \\sqrt{m/k})$',
             title='One-step spring on a slope of 10 degrees')
    plotting.named(axis)


def drawGap(axis, rows):
    for i, (scene, points) in enumerate(groups(rows, lambda r: r['scene']).items()):
        v = np.array([stepOf(r) for r in points])
        slope = np.polyfit(v, [1 - number(r['theory']) for r in points], 1)[0]
        axis.plot([0, 1/slope], [1, 0], '-', color=plotting.colours[i], linewidth=1,
                  label=f'{scene}: $1 - {slope:.2f} v$')
        axis.plot(v, [number(r['measured']) for r in points], plotting.markers[i],
                  color=plotting.colours[i], markersize=5)
    axis.set(xlabel='$v\\ /\\ (2 dx/\\sqrt{\\theta dx/g})$', ylabel='gap left / $2 dx$',
             ylim=(0, 1.02), xlim=(0, 1.5),
             title="Paper 2's stiffness $m g/(\\theta dx)$ in an impact")
    plotting.named(axis)


def drawDamping(axis, rows):
    alpha = np.array([0, 1])
    for i, (scene, points) in enumerate(groups(rows, lambda r: r['scene']).items()):
        sign = 1 if scene == 'rising' else -1
        axis.plot(alpha, 1 + sign*alpha, '-', color=plotting.colours[i], linewidth=1,
                  label=f'{scene}: $1 {"+" if sign > 0 else "-"} \\alpha$')
        axis.plot([stepOf(r) for r in points], [number(r['measured']) for r in points],
                  plotting.markers[i], color=plotting.colours[i], markersize=5)
    axis.axhline(1, color='0.5', linestyle=':', linewidth=1)
    axis.set(xlabel='local damping $\\alpha$', ylabel='acceleration / $g$',
             title='Local damping in free flight')
    plotting.named(axis)
