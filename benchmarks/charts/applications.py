# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the wall time of applications goes: seconds, and shares with their goals, from the rows of
runApplications; a peer's whole runs beside

Runs of the newest machine of each kind of device. Of rows of one run the last counts.
"""
import re

from riprap import plotting

from . import groups, newest, number

# what is drawn, from the left; the share of the first has goals
parts = ('solver', 'function objects', 'fields', 'writing', 'waiting for writing', 'start', 'other')
both = 'writing and waiting for it'
paint = dict(zip((*parts, both), ('#0072B2', '#CC79A7', '#56B4E9', '#E69F00', '#D55E00', '#009E73',
                                  '#999999', '#DD7D00')))
titles = {'sphDem': 'sphDem/damBreak3D', 'damBreakColumn': 'damBreakColumn (SPH)',
          'dem': 'spheres (dem)', 'picDem': 'picDem/damBreak3D', 'elasticGate': 'elasticGate'}


def draw(rows, peers, path):
    rows = chosen(rows)
    if not rows:
        print('applications: no rows to draw')
        return
    peers = [p for p in peers if p['chart'] == 'applications']
    bars = []                       # (label, row or None, costs of a peer)
    for r in rows:
        bars.append((labelOf(r), r, None))
        mine = [p for p in peers if p['scene'] == r['name'] and machineOf(r) in p['machine']
                and number(p['simulated']) == number(r['endTime'])]
        for (peer, _), runs in groups(mine, lambda p: (p['peer'], p['machine'])).items():
            bars.append((f'{peer}, the same dam break', None, [float(p['cost']) for p in runs]))
    fig, (wall, share) = plotting.figure(2, width=4.6, height=0.9 + 0.46*len(bars))
    fig.suptitle(', '.join(dict.fromkeys(machineOf(r) for r in rows)), fontsize=10)
    longest = max(max(costs) if row is None else float(row['wall']) for _, row, costs in bars)
    for y, (_, row, costs) in enumerate(bars):
        if row is None:
            drawPeer(wall, y, costs)
        else:
            drawRun(wall, share, y, row)
            drawTimes(wall, share, y, row, longest)
    wall.set(xlabel='wall time [s]', xlim=(0, 1.14*longest), yticks=range(len(bars)))
    wall.set_yticklabels([label for label, _, _ in bars], fontsize=8)
    share.set(xlabel='share of the wall time [%]', xlim=(0, 100), yticks=range(len(bars)),
              yticklabels=[])
    for axis in (wall, share):
        axis.set_ylim(len(bars) - 0.4, -0.6)
        axis.grid(False, axis='y')
    handles, names = share.get_legend_handles_labels()
    found = dict(zip(names, handles))
    order = [p for p in (*parts, both, 'goal') if p in found]
    fig.legend([found[p] for p in order], order, loc='upper center', ncols=4,
               fontsize=8, bbox_to_anchor=(0.5, 0))
    plotting.save(fig, path)


def chosen(rows):
    """The newest rows of whole runs: of GPUs those of the machine that was measured last"""
    rows = [r for r in rows if number(r['solverShare'])]
    last = {r['device']: machineOf(r) for r in rows}
    rows = newest([r for r in rows if machineOf(r) == last[r['device']]],
                  ('name', 'device', 'particles', 'endTime'))
    return sorted(rows, key=lambda r: (r['device'] != 'gpu', list(titles).index(r['name'])
                                       if r['name'] in titles else len(titles),
                                       number(r['endTime']) or 0))


def machineOf(row):
    """The GPU, by the note; CPU"""
    found = re.search(r'\b[A-Z]+\d+\b', row['note'])
    return 'CPU' if row['device'] == 'cpu' else found.group() if found else 'GPU'


def labelOf(row):
    count = float(row['particles'])
    size = f'{count/1e6:.1f} million' if count >= 1e6 else f'{count:,.0f}'
    return (titles.get(row['name'], row['name']) + (', CPU' if row['device'] == 'cpu' else '')
            + f"\n{size}, {row['endTime']} s")


def secondsOf(row):
    """{part: seconds}; older rows do not tell writing from waiting for it"""
    seconds = {p: number(row.get(p.replace('function objects', 'functionObjects'))) or 0
               for p in parts}
    waiting = number(row.get('waiting'))
    if waiting is None:
        seconds[both] = seconds.pop('writing')
    else:
        seconds['waiting for writing'] = waiting
        seconds['writing'] -= waiting
    return seconds


def drawRun(wall, share, y, row):
    whole, seconds = float(row['wall']), secondsOf(row)
    for axis, scale in ((wall, 1), (share, 100/whole)):
        left = 0
        for part in (*parts[:3], both, *parts[3:]):
            if seconds.get(part, 0) > 0:
                axis.barh(y, scale*seconds[part], left=left, height=0.62, linewidth=0,
                          color=paint[part],
                          label=None if part in axis.get_legend_handles_labels()[1] else part)
                left += scale*seconds[part]


def drawTimes(wall, share, y, row, longest):
    """The wall time beside its bar, and the goal: of the solver's share, or of the wall time"""
    whole = at = float(row['wall'])
    bound = row['bound'].split()
    if bound:
        goal = float(bound[0])
        axis = wall if bound[1:] else share
        axis.plot([goal, goal], [y - 0.36, y + 0.36], color='black', linewidth=1.8,
                  label=None if 'goal' in axis.get_legend_handles_labels()[1] else 'goal')
        axis.annotate(f"{goal:g} {'s' if bound[1:] else '%'}", (goal, y - 0.36), xytext=(0, 1),
                      textcoords='offset points', ha='center', va='bottom', fontsize=7)
        if axis is wall and whole < goal < whole + 0.15*longest:
            at = goal
    wall.annotate(f'{whole:.1f} s', (at, y), xytext=(4, 0), textcoords='offset points',
                  va='center', fontsize=8)


def drawPeer(wall, y, costs):
    """From the shortest to the longest of its runs"""
    wall.barh(y, min(costs), height=0.62, color='#dddddd', linewidth=0)
    wall.barh(y, max(costs) - min(costs), left=min(costs), height=0.62, color='#dddddd',
              hatch='////', edgecolor='#888888', linewidth=0)
    wall.annotate(f'{min(costs):g} to {max(costs):g} s', (max(costs), y), xytext=(4, 0),
                  textcoords='offset points', va='center', fontsize=8)
