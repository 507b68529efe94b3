# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/speedAndAccuracy.md: what an error costs, how fast errors fall, what is left out
and why"""
import csv
import io
import re
from collections import Counter

from riprap import advice, convergence, rows

wanted = (0.1, 0.03, 0.01, 0.003)


def fill(text, loaded, judged, peers):
    """The page with its generated parts made anew: from `<!-- generated NAME ... -->` to `<!-- end
    -->`"""
    parts = {'cheapest': cheapest(judged), 'orders': orders(judged), 'limits': limits(loaded),
             'left': left(loaded, judged, peers), 'figures': figures(judged),
             'advice': score(loaded, judged)}
    found = set(re.findall(r'<!-- generated (\w+)', text))
    if found != set(parts):
        raise ValueError(f'docs/speedAndAccuracy.md: generated parts are {sorted(found)}, '
                         f'wanted {sorted(parts)}')

    def part(match):
        return f'{match.group(1)}\n\n{parts[match.group(2)]}\n\n<!-- end -->'
    return re.sub(r'(<!-- generated (\w+)[^>]*-->).*?<!-- end -->', part, text, flags=re.S)


def cheapest(judged):
    lines = ['| scene | on | 10 % | 3 % | 1 % | 0.3 % |', '| --- | --- | --- | --- | --- | --- |']
    for scene, (mine, why) in sorted(judged.items()):
        if why:
            continue
        fronts, names = rows.fronts(mine), rows.labels(mine)
        for place in ('CPU, one thread', 'CPU, several threads', 'GPU'):
            here = [(solver, front) for (solver, at), front in sorted(fronts.items())
                    if at == place and (place != 'CPU, several threads'
                                        or (solver, 'CPU, one thread') not in fronts)]
            cells = []
            for error in wanted:
                points = [(p[0], solver, p) for solver, front in here
                          for p in [rows.cheapest(front, error)] if p]
                if not points:
                    cells.append('-')
                    continue
                cost, solver, (_, _, s, p, row) = min(points, key=lambda c: c[0])
                cells.append(f"{_value(cost)} s: {solver}, {_value(1000*p.spacing)} mm"
                             + (f', {names[id(s)]}' if names[id(s)] else ''))
            if here:
                lines.append(f'| {scene} | {place} | ' + ' | '.join(cells) + ' |')
    return '\n'.join(lines)


def orders(judged):
    lines = ['| scene | solver, settings | spacings [mm] | error [%] | order | error tends to [%] '
             '| verdict |', '| --- | --- | --- | --- | --- | --- | --- |']
    for scene, (mine, _) in sorted(judged.items()):
        names = rows.labels(mine)
        for s in mine:
            if len(s.points) < 2:
                continue
            order = (f'{s.order.order:.1f}' + (f' ± {s.order.deviation:.1f}'
                                               if s.order.deviation is not None else '')
                     if s.order and s.verdict != 'round-off' else '-')
            lines.append(f"| {scene} | {', '.join(w for w in (s.solver, names[id(s)]) if w)} | "
                         f"{', '.join(_value(1000*p.spacing) for p in s.points)} "
                         f"| {', '.join(_value(100*p.error) for p in s.points)} | {order} | "
                         f"{_limit(s.limit, 100, '-') if s.verdict != 'round-off' else '0'} | "
                         f"{s.verdict} |")
    return '\n'.join(lines)


def limits(loaded):
    """Where an experiment or a value is no yardstick: what each solver tends to by itself"""
    lines = ['| scene | solver, settings | quantity | spacings [mm] | values | tends to | order |',
             '| --- | --- | --- | --- | --- | --- | --- |']
    for scene, solver, variant, quantity, spacings, values in ownSeries(loaded):
        limit = convergence.richardson(spacings, values)
        order = f'{limit.order:.1f}' if limit.order else limit.kind
        lines.append(f"| {scene} | {', '.join(w for w in (solver, variant) if w)} | {quantity} | "
                     f"{', '.join(_value(1000*h) for h in spacings)} | "
                     f"{', '.join(f'{v:.4g}' for v in values)} | {_limit(limit, 1, '-')} | {order} "
                     "|")
    return '\n'.join(lines)


def ownSeries(loaded):
    """(scene, solver, variant, quantity, spacings, values) of rows with three spacings that no
    yardstick is known for"""
    newest = {}
    for r in loaded:
        stick = not r.left or r.left.startswith(('a newer row', 'a quick run', 'it stopped', 'no '))
        if (
                not stick and r.error is not None and r.spacing
                and r.flow in ('dam break', 'elastic', 'waves') and 'count' not in r.left):
            newest.setdefault((r.scene, r.solver, r.variant, r.settings, r.quantity),
                              {})[r.spacing] = r.error
    for (scene, solver, variant, _, quantity), found in sorted(newest.items()):
        if len(found) >= 3:
            spacings = sorted(found, reverse=True)
            yield scene, solver, variant, quantity, spacings, [found[h] for h in spacings]


def left(loaded, judged, peers):
    lines = ['| scene | rows | why they are in no front |', '| --- | --- | --- |']
    counts = Counter((r.scene, r.left) for r in loaded if r.left)
    counts.update((scene, why) for scene, (mine, why) in judged.items() if why for s in mine
                  for p in s.points for _ in p.rows)
    counts.update((p.scene, f'peers: {p.left}') for p in peers if p.left)
    for (scene, why), n in sorted(counts.items()):
        if why != 'a newer row of the same settings':
            lines.append(f'| {scene} | {n} | {why} |')
    old = sum(n for (_, why), n in counts.items() if why == 'a newer row of the same settings')
    lines.append(f'| all | {old} | a newer row of the same settings |')
    return '\n'.join(lines)


def score(loaded, judged):
    """How well errors and costs of a scene are foretold from the other scenes"""
    known = advice.series(csv.DictReader(io.StringIO(advice.table(judged, loaded))))
    lines = ['| from | flow | errors within a factor of 2 | two thirds within | costs within a '
             'factor of 2 | both | not known |', '| --- | --- | --- | --- | --- | --- | --- |']
    for name, measured in (('other scenes', ''), ('the own error at the coarsest spacing', 'error'),
                           ('the difference of the two coarsest runs', 'difference')):
        for flow in (None, *sorted({k.flow for k in known} if not measured else ())):
            errors, costs, both, unknown = advice.scores(known, measured, flow)
            if errors.told or unknown:
                lines.append(f"| {name} | {flow or '**all**'} | {errors.within} of {errors.told} | "
                             f"{_value(errors.factor) if errors.told else '-'} | {costs.within} "
                             f"of {costs.told} | {both} | {unknown} |")
    return '\n'.join(lines)


def figures(judged):
    lines = []
    for scene, (mine, why) in sorted(judged.items()):
        if not why and any(s.verdict not in ('round-off', 'one spacing') for s in mine):
            lines.append(f'![{scene}: error over cost](charts/workPrecision-{scene}.png)')
    return '\n\n'.join(lines)


def _limit(limit, factor, none):
    if limit is None:
        return none
    if limit.kind != 'monotone':
        return f'{limit.kind}, {_value(factor*limit.value)} ± {_value(factor*limit.uncertainty)}'
    return f'{_value(factor*limit.value)} ± {_value(factor*limit.uncertainty)}'


def _value(x):
    if x == 0:
        return '0'
    return f'{x:.2g}' if abs(x) < 10 else f'{x:.0f}' if abs(x) < 1e5 else f'{x:.1e}'
