# SPDX-License-Identifier: GPL-3.0-or-later
"""What picDemStability found"""
from riprap import plotting

from . import groups, number

# test, words that the quantity has, across, along, title
panels = (
    ('density', '', 'step over sqrt(h/g)', 'least density ratio', 'A disk in water, 60 steps'),
    ('step', '', 'density ratio', 'largest step over sqrt(h/g)', 'Coupled implicitly'),
    ('gap', '', 'overlap at rest [cells]', 'least gap [cells]', 'Two disks come to rest'),
    ('speed', '', 'overlap at rest [cells]', 'speed [m/s]',
     'Impact that stays in a gap of two cells'),
    ('subcycles', 'largest step', 'speed of the meeting [m/s]', 'largest step over sqrt(m/k)',
     'Two disks meet: step of the solids'),
    ('subcycles', 'after over before', 'speed of the meeting [m/s]', 'speed after over before',
     'Elastic meeting, short steps of the solids'),
    ('size', 'first acceleration', 'cells across', 'error of the first acceleration',
     'Disks of few cells in a round tank'),
    ('size', 'overlap', 'cells across', 'largest overlap over the diameter',
     'Ten in a heap without a gap'),
    ('thin', '', 'gap [cells]', 'largest speed [m/s]', 'Impact that stays in the gap'))


def draw(rows, path):
    if not rows:
        print('picDemStability: no rows to draw')
        return
    chosen = [(panel, [r for r in rows if r['test'] == panel[0] and panel[1] in r['quantity']])
              for panel in panels]
    chosen = [(panel, mine) for panel, mine in chosen if mine]
    columns = min(5, len(chosen))
    fig, axes = plotting.figure(columns, -(-len(chosen)//columns), width=4.2, height=3.4)
    for axis in axes[len(chosen):]:
        axis.set_visible(False)
    for axis, ((test, words, across, along, title), mine) in zip(axes, chosen):
        for i, (kind, points) in enumerate(groups(mine, lambda r: r['kind']).items()):
            known = [r for r in points if number(r['measured']) < 1e8]
            axis.loglog([number(r['setting']) for r in known],
                        [number(r['measured']) for r in known], marker=plotting.markers[i],
                        markersize=4, linewidth=1, color=plotting.colours[i], label=kind)
        axis.set(xlabel=across, ylabel=along, title=title)
        axis.title.set_fontsize(9)
        if len(groups(mine, lambda r: r['kind'])) > 1:
            plotting.named(axis)
    plotting.save(fig, path)
