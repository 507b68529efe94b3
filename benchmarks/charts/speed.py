# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed against size, from the rows of sphSpeed; peers as open markers, goals as dashed lines

Peers count every particle, riprap's rows count fluid particles alone.
"""
from riprap import plotting

from . import groups, newest, number

pairGoals = ((1.5e11, 'goal, 65 neighbours'), (1.7e11, 'goal, 160 neighbours'))
stepGoals = ((2e3, 2e4, 25), (1e5, 2e5, 80))       # particles from, to; microseconds a step in 2D


def draw(rows, peers, path):
    rows = newest(rows, ('name', 'scene', 'fluid', 'device', 'threads', 'precision', 'integrator', 'terms', 'wallModel',
                         'ratio', 'note'))
    if not rows:
        print('speed: no rows to draw')
        return
    fig, (two, three, small, pairs) = plotting.figure(2, 2, width=6.2, height=4.4)
    gpu = any('NVIDIA' in r['device'] for r in rows)
    for axis, scene in ((two, 'damBreak2D'), (three, 'damBreak3D')):
        series(axis, [r for r in rows if r['scene'] == scene], 'particleSteps')
        for i, p in enumerate(p for p in peers if p['chart'] == 'speed' and p['scene'] == scene[-2:]):
            plotting.measured(axis, [float(p['elements'])], [float(p['particleSteps'])],
                              f"{p['peer']}, {p['settings']}, {p['machine']}", i)
        axis.set(xlabel='particles', ylabel='particle-steps a second', title=scene)
    series(small, [r for r in rows if r['scene'] == 'damBreak2D'], 'time')
    small.set(xlabel='fluid particles', ylabel='time a step [$\\mu$s]', title='damBreak2D')
    series(pairs, [r for r in rows if r['scene'] == 'damBreak3D'], 'pairs')
    pairs.set(xlabel='fluid particles', ylabel='pair interactions a second', title='damBreak3D')
    if gpu:
        for goal, label in pairGoals:
            pairs.axhline(goal, color='k', linestyle='--' if goal < 1.6e11 else ':', linewidth=0.8, label=label)
        pairs.axhline(6.8e10, color='0.5', linestyle='-.', linewidth=0.8, label='DualSPHysics, H200')
        for low, high, goal in stepGoals:
            small.plot([low, high], [goal, goal], 'k--', linewidth=0.8, label=f'goal: {goal} $\\mu$s')
    for axis in (two, three, small, pairs):
        axis.legend(fontsize=5.5)
    plotting.save(fig, path)


def series(axis, rows, quantity):
    for i, (label, points) in enumerate(groups(rows, labelOf).items()):
        points = sorted((float(p['fluid']), number(p[quantity])) for p in points if number(p[quantity]))
        axis.loglog(*zip(*points), '-', marker=plotting.markers[i % len(plotting.markers)], markersize=4, linewidth=1,
                    color=plotting.colours[i % len(plotting.colours)], label=label)


def labelOf(row):
    device = row['device'].split(';')[0].replace('NVIDIA ', '')
    threads = '' if 'NVIDIA' in row['device'] else f" {row['threads']} thread{'s' if row['threads'] != '1' else ''}"
    return f"{device}{threads}, {row['precision']}, {row['integrator']}, {row['terms']}, h/dp {row['ratio']}" + \
        ('' if row['wallModel'] == 'extrapolated' else f", {row['wallModel']} walls") + \
        (f" ({row['note']})" if row['note'] else '')
