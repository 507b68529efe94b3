# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against cost, one chart a scene, one panel a quantity

Cost is wall time a simulated second: runs of a scene may end at different times. Points of equal settings and different
spacings are joined; a label names only what differs between the chart's rows. Errors of exactly zero (a bond that held, or broke, as it should)
stand at the foot of the chart.
"""
from riprap import plotting

from . import groups, newest, number


foot = 1e-16


def draw(scene, rows, peers, path):
    rows = [r for r in rows if 'quick' not in r['run'] and costOf(r) and number(r['error']) is not None]
    rows = [dict(row, settings=choices(row['settings'])) for row in rows]
    for row in rows:
        row['host'] = '' if 'NVIDIA' in row['device'] else row['machine']       # of a GPU it does not matter
    common = {}                     # settings that all rows of a run tell: later ones tell more of the same
    for row in rows:
        common[row['run']] = common.get(row['run'], keys(row)) & keys(row)
    for row in rows:
        row['known'] = ' '.join(word for word in row['settings'].split() if word.split('=')[0] in common[row['run']])
    rows = newest(rows, ('run', 'known', 'spacing', 'precision', 'device', 'host', 'quantity'))
    if not rows:
        print(f'{scene}: no complete runs to draw')
        return
    others = [p for p in peers if p['chart'] == 'cost' and p['scene'] == scene]
    quantities = list(groups(rows, lambda r: r['quantity']))
    columns = min(4, len(quantities))
    fig, axes = plotting.figure(columns, -(-len(quantities)//columns), width=6.0, height=4.6)
    for axis in axes[len(quantities):]:
        axis.set_visible(False)
    labels = labelMaker(rows)
    styles = {label: i for i, label in enumerate(groups(rows, labels))}         # the same in all panels
    handles = {}
    for axis, quantity in zip(axes, quantities):
        mine = [r for r in rows if r['quantity'] == quantity]
        for label, points in groups(mine, labels).items():
            points.sort(key=costOf)
            i = styles[label]
            handles[label], = axis.loglog([costOf(p) for p in points], [max(abs(float(p['error'])), foot) for p in points], '-',
                                          marker=plotting.markers[i % len(plotting.markers)], markersize=5, linewidth=1,
                                          color=plotting.colours[i % len(plotting.colours)], label=label)
        for i, (peer, points) in enumerate(groups([p for p in others if p['quantity'] == quantity],
                                                  lambda p: p['peer']).items()):
            plotting.measured(axis, [costOf(p) for p in points], [float(p['error']) for p in points], peer, i)
            handles[peer] = axis.lines[-1]
        axis.set(xlabel='wall time a simulated second [s]', title=f'{scene}: error of\n{quantity}')
        axis.title.set_fontsize(9)
    fig.legend(handles.values(), handles.keys(), fontsize=7, loc='upper center', bbox_to_anchor=(0.5, 0), ncol=min(2, columns), frameon=False)
    plotting.save(fig, path)


def peersOfSolids(rows):
    """Rows of runPeers `error of <quantity>; <variant>` as points, their cost from `seconds a simulated second, <quantity>; <variant>`"""
    latest = {(r['case'], r['code'], r['quantity']): r['value'] for r in rows}
    points = []
    for (case, code, quantity), value in latest.items():
        what = quantity[len('error of '):]
        cost = latest.get((case, code, f'seconds a simulated second, {what}'))
        if quantity.startswith('error of ') and cost:
            points.append({'chart': 'cost', 'scene': case, 'quantity': what.split(';')[0], 'peer': code, 'error': value, 'cost': cost, 'simulated': '1'})
    return points


def choices(settings):
    """Without what came of a run"""
    return ' '.join(word for word in settings.split() if not word.startswith('subcycles='))


def keys(row):
    return {word.split('=')[0] for word in row['settings'].split()}


def costOf(row):
    """Of a run or a peer's point; None where it was not recorded"""
    time, simulated = number(row.get('wallTime') or row.get('cost')), number(row.get('simulated'))
    return time/simulated if time and simulated else None


def labelMaker(rows):
    """A function of a row: the settings in which rows differ, with precision and device"""
    def settings(row):
        pairs = dict(word.split('=', 1) for word in row['settings'].split() if '=' in word)
        # a wall spacing that follows the fluid's is no setting of its own
        try:
            pairs['walls/spacing'] = f"{float(pairs['walls/spacing'])/float(row['spacing']):.2g} dp"
        except (KeyError, ValueError):
            pass
        pairs['precision'] = row['precision']
        threads = row['machine'].split('(')[-1].rstrip(')')
        pairs['device'] = row['device'].split(',')[0] + ('' if 'NVIDIA' in row['device'] else f' ({threads})')
        return pairs
    all_ = [settings(r) for r in rows]
    varying = [k for k in all_[0] if len({s.get(k) for s in all_}) > 1]
    # what follows from the rest need not be said
    for key in [k for k in varying if k not in ('precision', 'device', 'walls')]:
        rest = [k for k in varying if k != key]
        if len({tuple(s.get(k) for k in rest) for s in all_}) == len({tuple(s.get(k) for k in varying) for s in all_}):
            varying = rest
    names = {'smoothingLength': 'h', 'walls': 'walls', 'precision': '', 'device': ''}
    return lambda row: ', '.join(f'{names.get(k, k)} {settings(row).get(k)}'.strip() for k in varying) or 'riprap'
