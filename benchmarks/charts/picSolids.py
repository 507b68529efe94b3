# SPDX-License-Identifier: GPL-3.0-or-later
"""Six layers of cylinders in a column that breaks: error against cost, one panel a choice, beside
the base (star) and what chance makes of it (grey); open: against finer cells of the same choice"""
from riprap import plotting

from . import groups, newest, number
from .cost import costOf

panels = (('cells a diameter', ('cells',)), ('beta of Eq. 20, once a step', ('beta',)),
          ('gap in cells', ('gap',)), ('steps of solids, of sqrt(m/k)', ('steps',)),
          ('transfer', ('transfer-',)), ('coupling', ('coupling-',)), ('maxCo', ('maxCo',)),
          ('device', ('device-', 'cells20')))


def settings(row):
    return dict(word.split('=', 1) for word in row['settings'].split() if '=' in word)


def labelOf(row, title):
    s = settings(row)
    if title == 'device':
        return (f"{'GPU' if 'NVIDIA' in row['device'] else 'CPU'}, {float(s['cellsDiameter']):.0f} "
                "cells")
    key = {'cells a diameter': 'cellsDiameter', 'beta of Eq. 20, once a step': 'contactVelocity',
           'gap in cells': 'gap', 'transfer': 'transfer', 'coupling': 'coupling',
           'maxCo': 'maxCo'}.get(title)
    if key:
        return s[key]
    many = f": {float(s['subcycles']):.1f} a step of the water" if 'subcycles' in s else ''
    return f"{float(s['stepFraction']):.3g}{many}"


def draw(rows, path):
    rows = newest([r for r in rows if costOf(r) or number(r['error']) is None], ('run', 'quantity'))
    base = next((r for r in rows if r['run'] == 'rows-base'), None)
    if base is None:
        print('picSolids: no base to draw')
        return
    first = base['quantity']
    chance = [float(r['error']) for r in rows if r['run'].startswith('rows-chance')
              and r['quantity'] == first] + [float(base['error'])]
    fig, axes = plotting.figure(4, 2, width=3.6, height=3.4)
    for axis, (title, starts) in zip(axes, panels):
        axis.axhspan(100*min(chance), 100*max(chance), color='#cccccc', alpha=0.6, linewidth=0)
        axis.loglog(costOf(base), 100*float(base['error']), marker='*', markersize=10,
                    color='#000000', linestyle='none', label=labelOf(base, title))
        mine = [r for r in rows if r['run'][len('rows-'):].startswith(starts)
                and not (title != 'device' and 'NVIDIA' in r['device'])]
        for i, (label, points) in enumerate(groups(mine, lambda r: labelOf(r, title)).items()):
            style = dict(linestyle='none', marker=plotting.markers[i % len(plotting.markers)],
                         markersize=6, color=plotting.colours[i % 6])
            for p in points:
                if number(p['error']) is None:
                    axis.plot([], [], label=f'{label}: stops', **style)
                else:
                    named = ({'label': label} if p['quantity'] == first
                             else {'markerfacecolor': 'none'})
                    axis.loglog(costOf(p), 100*float(p['error']), **style, **named)
        axis.set(xlabel='time a simulated second [s]', ylabel='error of the centre [%]',
                 title=title, xlim=(8, 500), ylim=(0.4, 100))
        plotting.named(axis)
    plotting.save(fig, path)
