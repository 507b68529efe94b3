# SPDX-License-Identifier: GPL-3.0-or-later
"""Speed against size, from the rows of sphSpeed; peers as open markers, goals as dashed lines

Peers count every particle, riprap's rows count fluid particles alone. Names say what differs from
mixed precision, leapfrog, the fewest terms and h/dp 1.25; of rows of one name and size the last
counts.
"""
from riprap import plotting

from . import groups, newest, number

pairGoals = ((1.5e11, 'goal, 65 neighbours'), (1.7e11, 'goal, 160 neighbours'))
stepGoals = ((2e3, 2e4, 25), (1e5, 2e5, 80))       # particles from, to; microseconds a step in 2D


def draw(rows, peers, path):
    rows = newest(rows, ('name', 'scene', 'fluid', 'device', 'threads', 'precision', 'integrator',
                         'terms', 'wallModel', 'ratio', 'note'))
    if not rows:
        print('speed: no rows to draw')
        return
    fig, (two, three, small, pairs) = plotting.figure(2, 2, width=6.2, height=4.4)
    gpu = any('NVIDIA' in r['device'] for r in rows)
    for axis, scene in ((two, 'damBreak2D'), (three, 'damBreak3D')):
        series(axis, [r for r in rows if r['scene'] == scene], 'particleSteps')
        for i, p in enumerate(p for p in peers
                              if p['chart'] == 'speed' and p['scene'] == scene[-2:]):
            at = float(p['elements']), float(p['particleSteps'])
            plotting.measured(axis, [at[0]], [at[1]], '_', i)
            axis.riprapCallouts.append((*at, f"{p['peer']}, {p['settings']}, "
                                             f"{p['machine'].replace('NVIDIA ', '')}", '#444444'))
        axis.set(xlabel='particles', ylabel='particle-steps a second', title=scene)
    series(small, [r for r in rows if r['scene'] == 'damBreak2D'], 'time')
    small.set(xlabel='fluid particles', ylabel='time a step [$\\mu$s]', title='damBreak2D')
    series(pairs, [r for r in rows if r['scene'] == 'damBreak3D'], 'pairs')
    pairs.set(xlabel='fluid particles', ylabel='pair interactions a second', title='damBreak3D')
    if gpu:
        right = pairs.get_xlim()[0]
        for goal, label in (*pairGoals, (6.8e10, 'DualSPHysics, H200')):
            pairs.axhline(goal, color='0.5', linestyle='--' if label.startswith('goal') else '-.',
                          linewidth=0.8)
            pairs.annotate(label, (right, goal),
                           xytext=(4, 2 if goal > 1.6e11 or goal < 1e11 else -9),
                           textcoords='offset points', fontsize=7, color='0.3')
        for low, high, goal in stepGoals:
            small.plot([low, high], [goal, goal], 'k--', linewidth=0.8)
            small.annotate(f'goal: {goal} $\\mu$s', (low, goal), xytext=(0, 4),
                           textcoords='offset points', fontsize=7)
    for axis in (two, three, small, pairs):
        axis.margins(0.12)
    plotting.save(fig, path)


def series(axis, rows, quantity):
    names = []
    for i, (label, points) in enumerate(groups(rows, labelOf).items()):
        points = sorted({float(p['fluid']): (float(p['fluid']), number(p[quantity])) for p in points
                         if number(p[quantity])}.values())
        if not points:
            continue
        colour = plotting.colours[i % len(plotting.colours)]
        axis.loglog(*zip(*points), '-', marker=plotting.markers[i % len(plotting.markers)],
                    markersize=5, linewidth=1, color=colour)
        names.append((*points[-1], label, colour))
    plotting.callouts(axis, names)


def labelOf(row):
    """The processor, and what differs from mixed precision, leapfrog, the fewest terms and h/dp
    1.25"""
    device = row['device'].split(';')[0].replace('NVIDIA ', '')
    threads = ('' if 'NVIDIA' in row['device']
               else f" {row['threads']} thread{'s' if row['threads'] != '1' else ''}")
    usual = {'precision': 'mixed', 'integrator': 'leapfrog', 'terms': 'minimal',
             'wallModel': 'extrapolated'}
    own = [row[k] + (' walls' if k == 'wallModel' else '') for k, v in usual.items() if row[k] != v]
    if float(row['ratio']) != 1.25:
        own.append(f"h/dp {row['ratio']}")
    return ', '.join([device + threads, *own])
