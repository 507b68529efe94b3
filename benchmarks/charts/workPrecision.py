# SPDX-License-Identifier: GPL-3.0-or-later
"""Error over cost of one scene: both solvers, what an error costs at best, peers

A colour a solver, filled on one thread of a CPU, open on a GPU, a cross on several threads. Thin
lines join spacings of equal settings; the broad line of steps is the Pareto front of a solver on a
device, on which an error counts that all finer spacings keep. Bars span chance.
"""
from riprap import plotting, rows

colours = {'picDem': plotting.colours[1], 'sphDem': plotting.colours[0], 'dem': plotting.colours[2]}
fills = {'CPU, one thread': 'o', 'GPU': 's', 'CPU, several threads': 'X'}


def headline(fronts, wanted=(0.01, 0.003, 0.03, 0.1, 0.001)):
    """What the figure says, in a line: the cost of the first of these errors that most fronts
    reach"""
    best = max(wanted, key=lambda e: (sum(rows.cheapest(f, e) is not None for f in fronts.values()),
                                      -wanted.index(e)))
    said, solvers = [], sorted({solver for solver, _ in fronts})
    for solver in solvers:
        for device, at in (('one thread', ('CPU, one thread',)), ('GPU', ('GPU',)),
                           ('threads', ('CPU, several threads',))):
            points = [p for place in at if (solver, place) in fronts
                      for p in [rows.cheapest(fronts[solver, place], best)] if p]
            if points and (device != 'threads' or not any(s.startswith(solver) for s in said)):
                said.append(f'{solver} {shown(min(p[0] for p in points))} s ({device})')
        if not any(s.startswith(solver) for s in said):
            said.append(f'{solver} does not reach it')
    return f"{100*best:g} %: {'; '.join(said)}"


def draw(scene, mine, peers, path):
    fronts = rows.fronts(mine)
    fronts = {(solver, place): f for (solver, place), f in fronts.items()
              if place != 'CPU, several threads' or (solver, 'CPU, one thread') not in fronts}
    names = rows.labels(mine)
    fig, (axis,) = plotting.figure(1, width=7.2, height=4.8)
    callouts = []
    for s in mine:
        colour = colours[s.solver]
        lonely = s.verdict == 'one spacing'
        joined = {}
        for p in s.points:
            for place, (cost, _) in p.costs().items():
                joined.setdefault(place, []).append((cost, p))
        for place, points in joined.items():
            x, y = [c for c, _ in points], [100*p.error for _, p in points]
            axis.plot(x, y, '-', marker=fills[place], color=colour,
                      markerfacecolor='none' if place == 'GPU' else colour,
                      markersize=4 if lonely else 6, linewidth=0.9, alpha=0.4 if lonely else 1)
            for c, p in points:
                if p.high > 1.02*p.low:
                    axis.plot([c, c], [100*p.low, 100*p.high], color=colour, linewidth=3, alpha=0.3,
                              solid_capstyle='butt')
    costs = [c for f in fronts.values() for c, *_ in f] + [p.cost for p in peers]
    far = 1.6*max(costs)
    for (solver, place), front in fronts.items():
        x, y = [c[0] for c in front] + [far], [100*c[1] for c in front] + [100*front[-1][1]]
        axis.step(x, y, where='post', color=colours[solver], linewidth=5, alpha=0.25,
                  solid_capstyle='butt', zorder=0.5)
        for i in sorted({0, len(front) - 1}):
            cost, kept, s, p, row = front[i]
            callouts.append((cost, 100*kept, f"{solver} {places(place)}, {spacing(p.spacing)}"
                             + (f' {names[id(s)]}' if names[id(s)] else ''), colours[solver]))
    known = {}
    for p in peers:
        known.setdefault(p.solver, []).append((p.cost, 100*p.error))
    for i, (name, points) in enumerate(sorted(known.items())):
        plotting.measured(axis, *zip(*points), '_' + name, 2 + i)
        callouts.append((*min(points), name, '#444444'))
    axis.set(xscale='log', yscale='log', xlabel='seconds a simulated second',
             ylabel=f'error [% of {mine[0].points[0].rows[0].of}]')
    axis.margins(0.12)
    first = mine[0].points[0].rows[0]
    axis.set_title(f"{scene}: {first.quantity} (yardstick: {first.yardstick})\n{headline(fronts)}",
                   fontsize=9, loc='left')
    used = [place for place in fills if any(place in p.costs() for s in mine for p in s.points)]
    axis.legend([axis.plot([], [], linestyle='none', marker=fills[place], color='#666666',
                           markerfacecolor='none' if place == 'GPU' else '#666666')[0]
                 for place in used],
                used, fontsize=7.5, loc='upper center', bbox_to_anchor=(0.5, -0.13), ncols=3)
    plotting.callouts(axis, callouts)
    plotting.save(fig, path)


def places(place):
    return {'CPU, one thread': 'CPU', 'CPU, several threads': 'CPU threads', 'GPU': 'GPU'}[place]


def spacing(metres):
    return f'{1000*metres:.3g} mm'


def shown(value):
    return f'{value:.2g}' if value < 10 else f'{value:.0f}'
