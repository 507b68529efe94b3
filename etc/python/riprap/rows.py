# SPDX-License-Identifier: GPL-3.0-or-later
"""All rows of benchmarks/results in one form, sorted into series, with the yardstick of each
(standard library alone)

load()    every row, the peers' too; what may not be compared says why in `left`
series()  rows of equal settings and different spacings, newest alone: points with error, cost and
          band, observed order, limit
fronts()  of scenes whose yardstick holds: what an error costs at best, by solver and device

Costs are seconds a simulated second: of the processor for one thread of a CPU, by the clock for
several threads and for a GPU. Of repeats that took the same steps the shortest counts: other
programs only lengthen. The error that a point counts with is `kept`: the largest of its own and of
all finer spacings of its series, so that an error that happens to cross zero earns nothing; where a
series does not fall, the largest of all.
"""
import csv
import glob
import os
import re
from collections import Counter
from dataclasses import dataclass, field
from typing import Optional

from . import convergence
from .bounds import root

roundOff = 1e-6                 # of the quantity: below it there is no error to trade
falling = 1.4                   # coarse over fine: less is no fall

# Parts of a run's name that tell its spacing, precision or device
_resolution = re.compile(
    r'(n\d+(\.\d+)?|dp[\d.]+|a\d+|cells\d+|[\d.]+mm|coarse|medium|fine|half|million|quick|cpu|'
    r'gpu|device|double|mixed)')
_counted = re.compile(r'(square|hexagonal)\d+')
# Settings that follow from the spacing, or came of the run
_follow = ('subcycles', 'gap', 'cellsDiameter')
# What rows without the column `kind` hold that is no error
_values = {'broken bonds', 'first bond: 0 whole, 1 broken in tension, 2 in shear',
           'front two spacings from the far wall [s]', 'arrival at the far wall [s]',
           'half of the cylinders below the mouth [s]', 'iterations',
           'largest acceleration in ten steps / g', 'creep of the base [radii]'}

_short = {'smoothingLength/ratio': 'h/dp', 'stepFraction': 'step', 'timeIntegration': ''}


@dataclass
class Row:
    scene: str
    file: str
    run: str
    solver: str
    settings: str
    variant: str
    spacing: Optional[float]
    particles: Optional[float]
    dimensions: int
    length: Optional[float]         # that matters [m]
    flow: str                       # kind of flow
    precision: str
    device: str                     # CPU or GPU
    processor: str                  # its name
    threads: Optional[int]
    quantity: str
    of: str
    yardstick: str
    error: Optional[float]
    cost: Optional[float]           # seconds a simulated second
    steps: Optional[float]          # a simulated second
    particleSteps: Optional[float]
    simulated: Optional[float]
    memory: Optional[float]
    date: str
    version: str
    chance: str = ''
    left: str = ''                  # why it is in no front
    peer: bool = False

    @property
    def across(self):
        """Spacings over the length that matters"""
        return self.length/self.spacing if self.length and self.spacing else None

    @property
    def place(self):
        """Where cost was taken: CPU, one thread; CPU, n threads; GPU"""
        if self.device == 'GPU':
            return 'GPU'
        return 'CPU, one thread' if self.threads == 1 else 'CPU, several threads'


@dataclass
class Point:
    spacing: float
    rows: list
    error: float                    # median of chance and devices
    low: float
    high: float
    kept: float = 0.0

    def costs(self):
        """{place: (seconds a simulated second, row)}, the cheapest of each"""
        best = {}
        for r in self.rows:
            if r.cost and (r.place not in best or r.cost < best[r.place][0]):
                best[r.place] = (r.cost, r)
        return best


@dataclass
class Series:
    scene: str
    solver: str
    variant: str
    settings: str
    precision: str
    points: list = field(default_factory=list)      # from coarse to fine
    order: object = None
    limit: object = None
    verdict: str = ''

    @property
    def falls(self):
        return self.verdict in ('falls', 'falls to a floor', 'round-off')


def yardsticks(path=None):
    path = path or os.path.join(root(), 'benchmarks', 'yardsticks.csv')
    with open(path, newline='') as f:
        found = list(csv.DictReader(line for line in f
                                    if line.strip() and not line.startswith('#')))
    for y in found:
        if y['use'] not in ('yes', 'no') or (y['use'] == 'no') != bool(y['reason']):
            raise ValueError(
                f"{path}: scene {y['scene']}, runs {y['runs']}: use is yes, or no with a reason")
    return found


def stickOf(sticks, file, run, quantity):
    """The first line of yardsticks.csv that fits, or None"""
    return next((y for y in sticks if y['file'] == file and re.fullmatch(y['runs'], run)
                 and (y['quantity'] == quantity or y['quantity'] == '.*')), None)


def rates(loaded):
    """{(solver, dimensions): particle-steps a second of one thread}, medians of rows"""
    found = {}
    for r in loaded:
        if (
                r.place == 'CPU, one thread' and not r.peer and r.particleSteps and r.cost
                and r.simulated and r.cost*r.simulated > 1 and (r.particles or 0) > 10):
            found.setdefault((r.solver, r.dimensions),
                             []).append(r.particleSteps/(r.cost*r.simulated))
    return {key: _median(sorted(values)) for key, values in found.items()}


def load(results=None, sticks=None):
    """Rows of all CSV files whose columns are those of records.py; `left` is empty where a row may
    be compared"""
    results = results or os.path.join(root(), 'benchmarks', 'results')
    sticks = yardsticks() if sticks is None else sticks
    rows = []
    for path in sorted(glob.glob(os.path.join(results, '*.csv'))):
        with open(path, newline='') as f:
            found = list(csv.DictReader(f))
        if found and 'run' in found[0] and 'error' in found[0]:
            name = os.path.splitext(os.path.basename(path))[0]
            common = _common(found)
            rows += [_row(name, r, sticks, common) for r in found]
    return _superseded(rows)


def peers():
    """Other programs on the same scenes and quantities: rows of peers.csv and interFoam.csv"""
    folder = os.path.join(root(), 'benchmarks')
    sticks = yardsticks()
    rows = []
    for name in ('peers.csv', 'interFoam.csv'):
        with open(os.path.join(folder, name), newline='') as f:
            for r in csv.DictReader(f):
                stick = next((y for y in sticks
                              if y['file'] == r['scene'] and y['quantity'] == r['quantity']), None)
                time, simulated = (_number(r.get('cpuTime') or r.get('cost')),
                                   _number(r.get('simulated')))
                if stick and _number(r['error']) and time and simulated and (
                        name == 'interFoam.csv' or r['chart'] == 'cost'):
                    gpu = 'H200' in r['machine']
                    rows.append(Row(
                        stick['scene'], name, r.get('settings') or f"{r['cell']} m {r['walls']}",
                        r.get('peer') or r['solver'] or 'interFoam',
                        r.get('settings') or r['walls'], r.get('walls', ''), _number(r.get('cell')),
                        _number(r.get('elements')), int(stick['dimensions']),
                        _number(stick['length']), stick['kind'], 'double', 'GPU' if gpu else 'CPU',
                        r['machine'], None if gpu else 1, r['quantity'], stick['of'],
                        stick['yardstick'], abs(_number(r['error'])), time/simulated, None,
                        None, simulated, None, '', '',
                        left=stick['reason'] if stick['use'] == 'no' else '', peer=True))
    return rows


def series(rows):
    """Of rows that are not left out: lists of points by spacing, judged"""
    found = {}
    for r in rows:
        if not r.left:
            found.setdefault((r.scene, r.solver, r.variant, r.settings, r.precision),
                             {}).setdefault(r.spacing, []).append(r)
    result = []
    for key, spacings in found.items():
        s = Series(*key)
        for spacing in sorted(spacings, reverse=True):
            errors = sorted(r.error for r in spacings[spacing])
            s.points.append(Point(spacing, spacings[spacing], _median(errors), errors[0],
                                  errors[-1]))
        worst = 0.0
        for p in reversed(s.points):
            worst = p.kept = max(worst, p.error)
        _judge(s)
        if s.verdict == 'does not fall':
            for p in s.points:
                p.kept = worst
        result.append(s)
    return result


def scenes(found):
    """{scene: (its series, why it is left out or '')}"""
    result = {}
    for s in found:
        result.setdefault(s.scene, []).append(s)
    return {scene: (mine, '' if any(s.falls for s in mine) else
                    'one spacing of each setting' if all(len(s.points) < 2 for s in mine)
                    else 'no series falls with its spacing') for scene, mine in result.items()}


def labels(mine):
    """{id of a series: what tells it from the scene's others of its solver}"""
    result = {}
    for s in mine:
        others = [o for o in mine if o.solver == s.solver]
        pairs = [dict(w.split('=', 1) for w in o.settings.split() if '=' in w) for o in others]
        own = dict(w.split('=', 1) for w in s.settings.split() if '=' in w)
        words = [s.variant] if s.variant else []
        if sum(o.variant == s.variant and o.precision == s.precision for o in others) > 1:
            words += [f'{_short.get(k, k)} {v}'.strip() for k, v in own.items()
                      if len({p.get(k) for p in pairs}) > 1][:2]
        if s.precision != 'mixed':
            words.append(s.precision)
        result[id(s)] = ', '.join(words)
    return result


def fronts(mine):
    """{(solver, place): [(cost, kept error, series, point, row)]} of a scene's series of two
    spacings or more, without points that another beats in both"""
    points = {}
    for s in mine:
        if s.verdict == 'one spacing':
            continue
        for p in s.points:
            for place, (cost, row) in p.costs().items():
                points.setdefault((s.solver, place), []).append((cost, p.kept, s, p, row))
    result = {}
    for key, candidates in points.items():
        front = []
        for c in sorted(candidates, key=lambda c: (c[0], c[1])):
            if not front or c[1] < front[-1][1]:
                front.append(c)
        result[key] = front
    return result


def cheapest(front, error):
    """The first point of a front that keeps this error, or None"""
    return next((c for c in front if c[1] <= error), None)


def _judge(s):
    spacings, errors = [p.spacing for p in s.points], [p.error for p in s.points]
    if len(s.points) < 2:
        s.verdict = 'one spacing'
        return
    s.order = convergence.order(spacings, errors)
    s.limit = convergence.richardson(spacings, errors)
    if max(errors) < roundOff:
        s.verdict = 'round-off'
    elif s.points[0].kept < falling*s.points[-1].kept:
        s.verdict = 'does not fall'
    elif (s.limit and s.limit.kind == 'monotone'
          and s.limit.value - s.limit.uncertainty > 0.1*s.points[-1].error):
        s.verdict = 'falls to a floor'
    else:
        s.verdict = 'falls'


def _row(file, r, sticks, common):
    run = r['run']
    stick = stickOf(sticks, file, run, r['quantity'])
    time, simulated = _number(r['wallTime']), _number(r['simulated'])
    spacing, steps = _number(r['spacing']), _number(r['steps'])
    gpu = 'NVIDIA' in r['device']
    row = Row(stick['scene'] if stick else file, file, run, r['model'],
              _settings(r, spacing, common), variantOf(run, stick['chance'] if stick else ''),
              spacing, _number(r['particles']), int(stick['dimensions']) if stick else 0,
              _number(stick['length']) if stick else None, stick['kind'] if stick else '',
              r['precision'],
              'GPU' if gpu else 'CPU', r['device'].split(',')[0] if gpu else r['machine'],
              None if gpu else _threads(r), r['quantity'], stick['of'] if stick else '',
              stick['yardstick'] if stick else '', None if _number(r['error']) is None
              else abs(_number(r['error'])), time/simulated if time and simulated else None,
              steps/simulated if steps and simulated else None,
              _number(r['particleSteps']), simulated, _number(r['memory']), r['date'], r['version'],
              run)
    row.left = ('a quick run: shorter, with its own bounds' if 'quick' in run else
                'it stopped' if row.error is None else
                'no yardstick named' if not stick else
                stick['reason'] if stick['use'] == 'no' else
                'a value, no error' if (r.get('kind') == 'value' or row.quantity in _values) else
                'no spacing' if spacing is None else
                'no cost recorded' if row.cost is None else '')
    return row


def _superseded(rows):
    """Of the same run and settings on the same device the newest counts, with the shortest time of
    those that took its steps"""
    newest = {}
    for r in rows:
        if not r.left:
            newest.setdefault((r.scene, r.solver, r.chance, r.settings, r.spacing, r.precision,
                               r.place), []).append(r)
    for same in newest.values():
        last = same[-1]
        alike = [r.cost for r in same
                 if r.steps and last.steps and abs(r.steps/last.steps - 1) < 0.05]
        last.cost = min([last.cost, *alike])
        for r in same[:-1]:
            r.left = 'a newer row of the same settings'
    return rows


def variantOf(run, chance=''):
    """A run's name without what tells spacing, precision, device or chance"""
    if chance:
        run = re.sub(chance + r'(?=-|$)', '', run)
    words = [w for w in run.split('-') if w]
    numbered = any(re.fullmatch(r'n\d+', w) for w in words)       # there `half` is a level
    words = [_counted.sub(r'\1', w) for w in words
             if not _resolution.fullmatch(w) or (numbered and w == 'half')]
    return '-'.join(w for w in words if w not in ('column', 'rows'))


def _common(found):
    """Settings that all rows of a file tell, by solver: later rows tell more"""
    counts, total = {}, Counter(r['model'] for r in found)
    for r in found:
        counts.setdefault(r['model'],
                          Counter()).update({w.split('=')[0] for w in r['settings'].split()})
    return {model: {k for k, n in c.items() if n == total[model]} for model, c in counts.items()}


def _settings(r, spacing, common):
    words = []
    for word in r['settings'].split():
        key, _, value = word.partition('=')
        if key in _follow or key not in common[r['model']] or (key == 'stepFraction'
                                                               and r['model'] == 'picDem'):
            continue
        if key == 'walls/spacing' and _number(value) and spacing:
            word = f'{key}={_number(value)/spacing:.2g}dp'
        if key == 'jitter' and 0 < (_number(value) or 0) < 0.01:
            word = 'jitter=0'           # that moves seeds for chance's sake
        words.append(word)
    return ' '.join(words)


def _threads(r):
    match = re.search(r'(\d+) threads', r['device']) or re.search(r'\((\d+) threads', r['machine'])
    return int(match.group(1)) if match else None


def _median(values):
    n = len(values)
    return values[n//2] if n % 2 else 0.5*(values[n//2 - 1] + values[n//2])


def _number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None
