# SPDX-License-Identifier: GPL-3.0-or-later
"""Six layers of cylinders in a column that breaks: error against cost, one panel a choice, beside the base and what chance makes of it"""
from riprap import plotting

from . import groups, newest, number
from .cost import costOf

panels = (('cells a diameter', ('cells',)), ('beta of Eq. 20, once a step', ('beta',)), ('gap in cells', ('gap',)), ('steps of solids, of sqrt(m/k)', ('steps',)),
          ('transfer', ('transfer-',)), ('coupling', ('coupling-',)), ('maxCo', ('maxCo',)), ('device', ('device-', 'cells20')))


def settings(row):
    return dict(word.split('=', 1) for word in row['settings'].split() if '=' in word)


def labelOf(row, title):
    s = settings(row)
    if title == 'device':
        return f"{'GPU' if 'NVIDIA' in row['device'] else 'CPU'}, {float(s['cellsDiameter']):.0f} cells"
    key = {'cells a diameter': 'cellsDiameter', 'beta of Eq. 20, once a step': 'contactVelocity', 'gap in cells': 'gap', 'transfer': 'transfer', 'coupling': 'coupling', 'maxCo': 'maxCo'}.get(title)
    if key:
        return s[key]
    return f"{float(s['stepFraction']):.3g} (K {float(s['subcycles']):.0f})"


def draw(rows, path):
    rows = newest([r for r in rows if costOf(r) and number(r['error']) is not None], ('run', 'quantity'))
    base = next((r for r in rows if r['run'] == 'rows-base'), None)
    if base is None:
        print('picSolids: no base to draw')
        return
    first = base['quantity']
    chance = [float(r['error']) for r in rows if r['run'].startswith('rows-chance') and r['quantity'] == first] + [float(base['error'])]
    fig, axes = plotting.figure(4, 2, width=3.6, height=3.2)
    for axis, (title, starts) in zip(axes, panels):
        axis.axhspan(100*min(chance), 100*max(chance), color='#cccccc', alpha=0.5, linewidth=0)
        mine = [r for r in rows if r['run'][len('rows-'):].startswith(starts) and not (title != 'device' and 'NVIDIA' in r['device'])]
        for i, (quantity, points) in enumerate(groups(mine, lambda r: r['quantity']).items()):
            axis.plot([costOf(p) for p in points], [100*float(p['error']) for p in points], linestyle='none', marker='os'[quantity != first], markersize=5,
                      markerfacecolor='none' if quantity != first else None, color=plotting.colours[0])
            for p in points:
                axis.annotate(labelOf(p, title), (costOf(p), 100*float(p['error'])), xytext=(4, 3), textcoords='offset points', fontsize=7)
        axis.plot(costOf(base), 100*float(base['error']), marker='*', markersize=10, color=plotting.colours[1], linestyle='none')
        axis.annotate(labelOf(base, title), (costOf(base), 100*float(base['error'])), xytext=(5, -9), textcoords='offset points', fontsize=7, color=plotting.colours[1])
        axis.set(xscale='log', xlabel='time a simulated second [s]', ylabel='error of the centre [%]', title=title)
        axis.set_ylim(bottom=0)
        axis.margins(x=0.25)
        axis.set_ylim(0, axis.get_ylim()[1]*1.1)
    plotting.save(fig, path)
