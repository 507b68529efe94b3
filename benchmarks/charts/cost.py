# SPDX-License-Identifier: GPL-3.0-or-later
"""Error against cost, one chart a scene, one panel a quantity

Cost is wall time a simulated second: runs of a scene may end at different times. Points of equal
settings and different spacings are joined. The grey steps are the Pareto front: what an error costs
at best. Settings on it have their names, of which only what differs between the chart's rows; the
other settings are faint, and counted. Errors of exactly zero (a bond that held, or broke, as it
should) stand at the foot of the chart, at 0.
"""
import re

from riprap import plotting

from . import groups, newest, number


# What rows without the column `kind` hold that is no error
values = {'broken bonds', 'first bond: 0 whole, 1 broken in tension, 2 in shear',
          'front two spacings from the far wall [s]', 'arrival at the far wall [s]',
          'half of the cylinders below the mouth [s]', 'iterations',
          'largest acceleration in ten steps / g', 'creep of the base [radii]'}


def kindOf(row):
    """relative, error (in the quantity's unit) or value"""
    if row.get('kind'):
        return row['kind']
    if row['quantity'] in values:
        return 'value'
    unit = re.search(r'\[([^\]]+)\]', row['quantity'])
    return ('relative' if unit and 'rms' not in row['quantity']
            and unit.group(1) not in ('radii', 'draughts') else 'error')


def claim(quantity, kind):
    """Title of a panel, label of its axis and factor of its numbers"""
    unit = re.search(r'\s*\[([^\]]+)\]', quantity)
    bare = quantity.replace(unit.group(0), '') if unit else quantity
    if kind == 'relative':
        return bare, 'relative error [%]', 100.0
    if kind == 'value':
        return bare + ': the value, not an error', unit.group(0).strip() if unit else 'value', 1.0
    return bare, 'error' + (unit.group(0) if unit else ''), 1.0


def draw(scene, rows, peers, path):
    rows = [r for r in rows
            if 'quick' not in r['run'] and costOf(r) and number(r['error']) is not None]
    rows = [dict(row, settings=choices(row['settings'])) for row in rows]
    for row in rows:
        # of a GPU it does not matter
        row['host'] = '' if 'NVIDIA' in row['device'] else row['machine']
    # settings that all rows of a run tell: later ones tell more of the same
    common = {}
    for row in rows:
        common[row['run']] = common.get(row['run'], keys(row)) & keys(row)
    for row in rows:
        row['known'] = ' '.join(word for word in row['settings'].split()
                                if word.split('=')[0] in common[row['run']])
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
    # the same in all panels
    styles = {label: i for i, label in enumerate(groups(rows, labels))}
    for axis, quantity in zip(axes, quantities):
        panel(axis, [r for r in rows if r['quantity'] == quantity],
              [p for p in others if p['quantity'] == quantity], labels, styles)
    fig.suptitle(scene, x=0.01, ha='left', fontsize=12)
    plotting.save(fig, path)


def panel(axis, rows, peers, labels, styles):
    kind = kindOf(rows[-1])
    title, label, factor = claim(rows[0]['quantity'], kind)
    sizes = [factor*abs(float(r['error'])) for r in [*rows, *peers] if float(r['error']) != 0]
    foot = min(sizes)/4 if sizes else 1e-16
    height = ((lambda r: factor*abs(float(r['error']))) if kind == 'value'
              else (lambda r: max(factor*abs(float(r['error'])), foot)))
    scale = axis.semilogx if kind == 'value' else axis.loglog
    points = [(costOf(r), height(r)) for r in rows]
    front = set() if kind == 'value' else set(plotting.drawPareto(axis, points))
    names, others = [], 0
    for name, mine in groups(rows, labels).items():
        mine.sort(key=costOf)
        i = styles[name]
        colour = plotting.colours[i % len(plotting.colours)]
        on = [(costOf(r), height(r)) for r in mine if (costOf(r), height(r)) in front]
        chosen = bool(on) or len(styles) < 5
        others += not chosen
        scale([costOf(r) for r in mine], [height(r) for r in mine],
              linestyle='none' if kind == 'value' else '-',
              marker=plotting.markers[i % len(plotting.markers)], markersize=6 if chosen else 4,
              linewidth=1.2 if chosen else 0.8, color=colour, alpha=1.0 if chosen else 0.35)
        if chosen and len(styles) > 1:
            names.append((*(on[0] if on else (costOf(mine[0]), height(mine[0]))), name, colour))
    for i, (peer, mine) in enumerate(groups(peers, lambda p: p['peer']).items()):
        at = [(costOf(p), height(p)) for p in mine]
        plotting.measured(axis, *zip(*at), '_' + peer, i)
        names.append((*min(at), peer, '#444444'))
    plotting.callouts(axis, names)
    axis.set_title(title + (f'\nfaint: {others} '
                            + ('setting that costs' if others == 1 else 'settings that cost')
                            + ' more for the same error' if others else ''), fontsize=9)
    axis.set(xlabel='wall time a simulated second [s]', ylabel=label)
    axis.margins(0.12)
    if kind != 'value' and len(sizes) < len(rows) + len(peers):
        axis.axhline(foot, color='#999999', linewidth=0.8, linestyle=':')
        axis.annotate('0', (0, foot), xycoords=('axes fraction', 'data'), xytext=(-4, 0),
                      textcoords='offset points', ha='right', va='center', fontsize=8)


def peersOfSolids(rows):
    """Rows of runPeers `error of <quantity>; <variant>` as points, their cost from `seconds a
    simulated second, <quantity>; <variant>`"""
    latest = {(r['case'], r['code'], r['quantity']): r['value'] for r in rows}
    points = []
    for (case, code, quantity), value in latest.items():
        what = quantity[len('error of '):]
        cost = latest.get((case, code, f'seconds a simulated second, {what}'))
        if quantity.startswith('error of ') and cost:
            points.append({'chart': 'cost', 'scene': case, 'quantity': what.split(';')[0],
                           'peer': code, 'error': value, 'cost': cost, 'simulated': '1'})
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
        pairs['device'] = (row['device'].split(',')[0]
                           + ('' if 'NVIDIA' in row['device'] else f' ({threads})'))
        return pairs
    all_ = [settings(r) for r in rows]
    varying = [k for k in all_[0] if len({s.get(k) for s in all_}) > 1]
    # what follows from the rest need not be said
    for key in [k for k in varying if k not in ('precision', 'device', 'walls')]:
        rest = [k for k in varying if k != key]
        if len({tuple(s.get(k) for k in rest)
                for s in all_}) == len({tuple(s.get(k) for k in varying) for s in all_}):
            varying = rest
    names = {'smoothingLength': 'h', 'walls': 'walls', 'precision': '', 'device': ''}
    return lambda row: ', '.join(f'{names.get(k, k)} {settings(row).get(k)}'.strip()
                                 for k in varying) or 'riprap'
