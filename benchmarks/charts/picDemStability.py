# SPDX-License-Identifier: GPL-3.0-or-later
"""What picDemStability found"""
from riprap import plotting

from . import groups, number


def draw(rows, path):
    if not rows:
        print('picDemStability: no rows to draw')
        return
    panels = (
        ('density', 'step over sqrt(h/g)', 'least density ratio', 'A disk in water, 60 steps'),
        ('step', 'density ratio', 'largest step over sqrt(h/g)', 'Coupled implicitly'),
        ('gap', 'overlap at rest [cells]', 'least gap [cells]', 'Two disks come to rest'),
        ('speed', 'overlap at rest [cells]', 'speed [m/s]', 'Impact that stays in a gap of two cells'))
    panels = [p for p in panels if any(r['test'] == p[0] for r in rows)]
    fig, axes = plotting.figure(len(panels), width=5.2, height=3.8)
    for axis, (test, across, along, title) in zip(axes, panels):
        for i, (kind, points) in enumerate(groups([r for r in rows if r['test'] == test], lambda r: r['kind']).items()):
            known = [r for r in points if number(r['measured']) < 1e8]
            axis.loglog([number(r['setting']) for r in known], [number(r['measured']) for r in known], marker=plotting.markers[i], markersize=4,
                        linewidth=1, color=plotting.colours[i], label=kind)
        axis.set(xlabel=across, ylabel=along, title=title)
        if test == 'density':
            axis.legend(fontsize=7)
    plotting.save(fig, path)
