# SPDX-License-Identifier: GPL-3.0-or-later
"""Which solver, spacing and device reach an error, and what that costs, from the rows of other
scenes (standard library alone)

etc/advice.csv holds, for each series of benchmarks/results that a yardstick holds for, a line a
spacing and device. Scenes are compared by `across`: spacings over the length that matters (a
wavelength, a channel's width, a diameter, a column's width).

What an error needs is told by a mean of scenes: of each the best settings, log error over log
across, scenes of the same kind of flow ten times as heavy as others. Where the case's own error at
one spacing is given (`measured`), it is scaled by the order that the solver's scenes show. Cost
goes with particles times steps, across^(dimensions + 1); a GPU takes as long for few particles as
for 50,000.
How far each can be trusted, leaveOneOut() measures: every scene foretold from the others.
riprapAdvise states it with its figures.
"""
import csv
import io
import math
import os
from dataclasses import dataclass
from typing import Optional

from . import convergence, rows
from .bounds import root

columns = ['scene', 'flow', 'dimensions', 'solver', 'settings', 'precision', 'yardstick', 'place',
           'processor', 'spacing', 'across', 'particles', 'error', 'cost', 'steps', 'total']
others = 0.1                    # weight of scenes of another kind of flow
# as many times more across than the finest of any scene are still foretold
farther = 2.0
fewOnGpu = 5e4                  # particles below which a step of a GPU takes as long
shortest = 2.0                  # seconds: the cost of shorter runs is that of starting
flows = {'dam break': 'water that falls, runs and hits',
         'waves': 'waves, sloshing, tanks that move',
         'vortices': 'flow without a surface or walls that matter',
         'viscous channel': 'viscous flow between walls', 'open channel': 'flow through openings',
         'rest': 'water at rest', 'bodies in water': 'rigid bodies in water',
         'elastic': 'bonded, elastic bodies'}


@dataclass
class Spent:
    """Of one spacing on one device: a simulated second's cost and steps, particles, and what the
    whole run took"""
    across: float
    cost: float
    steps: float
    particles: Optional[float]
    total: float


@dataclass
class Known:
    """A series of one scene: (across, error) from coarse to fine, and by place what was spent"""
    scene: str
    flow: str
    dimensions: int
    solver: str
    settings: str
    precision: str
    yardstick: str
    errors: list
    places: dict

    @property
    def order(self):
        """Of errors, within what methods have"""
        o = convergence.order([1/n for n, _ in self.errors], [e for _, e in self.errors])
        return max(0.5, min(o.order, 2.5)) if o else 1.0

    def errorAt(self, across):
        """By interpolation; outside by the order"""
        return _between(self.errors, across, -min(self.order, 2.0))

    def costAt(self, across, place):
        return _between([(s.across, s.cost) for s in self.places[place]], across,
                        self.dimensions + 1)


def table(judged, loaded=None):
    """Text of etc/advice.csv"""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator='\n')
    writer.writerow(columns)
    for scene, (mine, why) in sorted(judged.items()):
        if why:
            continue
        names = rows.labels(mine)
        for s in mine:
            first = s.points[0].rows[0]
            if s.verdict not in ('falls', 'falls to a floor', 'round-off') or not first.across:
                continue
            for p in s.points:
                for place, (cost, r) in sorted(p.costs().items()):
                    if r.across:
                        writer.writerow([scene, first.flow, first.dimensions, s.solver,
                                         names[id(s)], s.precision, first.yardstick, place,
                                         r.processor, f'{p.spacing:.6g}', f'{r.across:.4g}',
                                         _count(r.particles), f'{p.kept:.4g}', f'{cost:.4g}',
                                         f'{r.steps:.5g}', f'{cost*r.simulated:.4g}'])
    for line in _ownLimits(loaded or []):
        writer.writerow(line)
    return out.getvalue()


def _ownLimits(loaded):
    """Dam breaks: their experiment is no yardstick, so what a solver tends to by itself is, with
    its uncertainty added"""
    newest = {}
    for r in loaded:
        if (
                r.flow == 'dam break' and r.across and r.cost and r.error is not None
                and r.yardstick == 'experiment' and 'quick' not in r.run):
            newest.setdefault((r.scene, r.solver, r.variant, r.settings, r.precision),
                              {})[r.spacing, r.place] = r
    for (scene, solver, variant, _, precision), found in sorted(newest.items()):
        values = {spacing: r.error for (spacing, _), r in found.items()}
        limit = convergence.richardson(list(values), list(values.values()))
        if limit is None or limit.kind != 'monotone' or limit.uncertainty > 0.1*abs(limit.value):
            continue
        for (spacing, place), r in sorted(found.items(), reverse=True):
            error = abs(r.error - limit.value) + limit.uncertainty
            yield [scene, r.flow, r.dimensions, solver, variant, precision, 'its own limit',
                   place, r.processor, f'{spacing:.6g}', f'{r.across:.4g}', _count(r.particles),
                   f'{error:.4g}', f'{r.cost:.4g}', f'{r.steps:.5g}', f'{r.cost*r.simulated:.4g}']


def read(path=None):
    """Series of etc/advice.csv"""
    with open(path or os.path.join(root(), 'etc', 'advice.csv'), newline='') as f:
        return series(csv.DictReader(f))


def series(lines):
    found = {}
    for r in lines:
        key = (r['scene'], r['flow'], int(r['dimensions']), r['solver'], r['settings'],
               r['precision'], r['yardstick'])
        found.setdefault(key, []).append(r)
    result = []
    for key, mine in found.items():
        errors, places = {}, {}
        for r in mine:
            n = float(r['across'])
            errors[n] = float(r['error'])
            places.setdefault(r['place'], []).append(
                Spent(n, float(r['cost']), float(r['steps']),
                      float(r['particles']) if r['particles'] else None, float(r['total'])))
        if len(errors) > 1:
            result.append(Known(*key, sorted(errors.items()),
                                {p: sorted(v, key=lambda s: s.across) for p, v in places.items()}))
    return result


def family(scene):
    """The same in 2D and 3D is no other scene"""
    return scene[:-2] if scene.endswith('3D') else scene


def weighed(known, solver, flow, without=None):
    """[(series, weight)]: of each scene that the solver has the best settings, at 40 across; but
    for that scene and its like in 3D"""
    best = {}
    for k in known:
        if k.errors[0][1] < rows.roundOff and k.flow != flow:
            continue                # exact there says nothing of other flows
        if k.solver == solver and (without is None or family(k.scene) != family(without)) and (
                k.scene not in best or k.errorAt(40) < best[k.scene].errorAt(40)):
            best[k.scene] = k
    return [(k, 1 if k.flow == flow else others) for k in best.values()]


def foretoldError(pool, across):
    return math.exp(sum(w*math.log(k.errorAt(across)) for k, w in pool)/sum(w for _, w in pool))


def acrossFor(pool, error):
    """Spacings over the length that matters which an error needs by the mean of scenes: not fewer
    than a scene of the flow has; None beyond what is foretold"""
    alike = [k for k, w in pool if w == 1] or [k for k, _ in pool]
    low, high = min(k.errors[0][0] for k in alike), farther*max(k.errors[-1][0] for k, _ in pool)
    if foretoldError(pool, high) > error:
        return None
    if foretoldError(pool, low) <= error:
        return low
    for _ in range(60):
        middle = math.sqrt(low*high)
        low, high = (middle, high) if foretoldError(pool, middle) > error else (low, middle)
    return high


def orderOf(known, solver, without=None):
    """Median of the orders of the solver's scenes; None where there is no other"""
    orders = sorted(k.order for k, _ in weighed(known, solver, None, without)
                    if k.errors[0][1] > rows.roundOff)
    return orders[len(orders)//2] if orders else None


def costRatio(dimensions, place, particles, finer):
    """Cost with a spacing `finer` times finer over that with these particles"""
    more = finer**dimensions
    if place == 'GPU':
        return finer*max(particles*more, fewOnGpu)/max(particles, fewOnGpu)
    return finer*more


@dataclass
class Held:
    """A point of a scene foretold from the others, its cost from that scene's coarsest run as a dry
    run would tell it"""
    scene: str
    solver: str
    flow: str
    settings: str
    asked: float
    reached: Optional[float]        # None: not known
    cost: Optional[float] = None    # foretold over true; None where runs were too short to tell


def leaveOneOut(known, measured=''):
    """[Held], one for each error but the coarsest of each series that is its scene's best.
    measured: 'error': with the coarsest error known; 'difference': of the second spacing the error
    is told by the difference of the coarsest two, as a user can"""
    result = []
    for k in known:
        pool = weighed(known, k.solver, k.flow, k.scene)
        if k.errors[0][1] < rows.roundOff or all(k is not mine for mine, _ in weighed(
                [o for o in known if o.scene == k.scene], k.solver, k.flow)):
            continue
        order = orderOf(known, k.solver, k.scene)
        for n, asked in k.errors[2 if measured == 'difference' else 1:]:
            across = None
            if pool and measured:
                (n0, e0), (n1, e1) = k.errors[:2]
                if measured == 'difference':
                    n0, e0 = n1, (e0 - e1)/((n1/n0)**order - 1)
                across = n0*(e0/asked)**(1/order) if e0 > 0 else None
            elif pool:
                across = acrossFor(pool, asked)
            if across is None:
                result.append(Held(k.scene, k.solver, k.flow, k.settings, asked, None))
                continue
            result.append(Held(k.scene, k.solver, k.flow, k.settings, asked, k.errorAt(across),
                               _costOff(k, across)))
    return result


def _costOff(k, across):
    place = max(k.places, key=lambda p: len([s for s in k.places[p] if s.total >= shortest]))
    spent = [s for s in k.places[place] if s.total >= shortest and s.particles and s.particles > 10]
    if len(spent) < 2:
        return None
    true = _between([(s.across, s.cost) for s in spent], across, k.dimensions + 1)
    return spent[0].cost*costRatio(k.dimensions, place, spent[0].particles,
                                   across/spent[0].across)/true


@dataclass
class Score:
    """Of errors, or of costs: how many were foretold, how many within a factor of two, the factor
    that two thirds are within"""
    told: int
    within: int
    factor: float


def score(ratios):
    off = sorted(abs(math.log(r)) for r in ratios)
    return Score(len(off), sum(o <= math.log(2)*(1 + 1e-9) for o in off),
                 math.exp(off[min(int(0.68*len(off)), len(off) - 1)]) if off else math.inf)


def scores(known, measured='', flow=None):
    """(of errors, of costs, of both, how many were not known)"""
    held = [h for h in leaveOneOut(known, measured) if flow in (None, h.flow)]
    told = [h for h in held if h.reached]
    two = math.log(2)*(1 + 1e-9)
    both = [h for h in told
            if h.cost and abs(math.log(h.reached/h.asked)) <= two and abs(math.log(h.cost)) <= two]
    return (score([h.reached/h.asked for h in told]), score([h.cost for h in told if h.cost]),
            len(both), len(held) - len(told))


def stepTime(known, solver, dimensions, place):
    """(a, b) with a + b N seconds a step of N particles, through rows of this place, weighed by
    their own times; None of fewer than three"""
    points = [(s.particles, s.cost/s.steps) for k in known for s in k.places.get(place, [])
              if (k.solver, k.dimensions) == (solver, dimensions) and s.particles
              and s.particles > 10 and s.total >= shortest]
    if len({n for n, _ in points}) < 3:
        return None
    if place != 'GPU':
        rates = sorted(t/n for n, t in points)
        return 0.0, rates[len(rates)//2]
    # least squares of (a + b n)/t - 1
    uu = sum(1/t**2 for n, t in points)
    un = sum(n/t**2 for n, t in points)
    nn = sum((n/t)**2 for n, t in points)
    u, v = sum(1/t for n, t in points), sum(n/t for n, t in points)
    determinant = uu*nn - un*un
    a, b = (u*nn - v*un)/determinant, (uu*v - un*u)/determinant
    return (a, b) if a > 0 and b > 0 else (u/uu, 0.0) if b <= 0 else (0.0, v/nn)


def stepsRatio(known, solver, other, dimensions):
    """Steps of `other` over those of `solver` at equal spacing: median of scenes that both have;
    None without one"""
    ratios = []
    for k in known:
        for o in known:
            if (k.scene, k.solver, o.scene, o.solver, k.dimensions) == (
                    o.scene, solver, k.scene, other, dimensions):
                mine = sorted((s.across, s.steps) for p in k.places.values() for s in p)
                for p in o.places.values():
                    for s in p:
                        if mine[0][0] <= s.across <= mine[-1][0]:
                            ratios.append(s.steps/_between(mine, s.across, 1))
    return sorted(ratios)[len(ratios)//2] if ratios else None


def _count(value):
    return '' if value is None else f'{value:.0f}'


def _between(points, at, slope):
    """Log-log interpolation of (x, y), with the given slope outside"""
    if at <= points[0][0]:
        return points[0][1]*(at/points[0][0])**slope
    for (x1, y1), (x2, y2) in zip(points, points[1:]):
        if at <= x2:
            return y1*(y2/y1)**(math.log(at/x1)/math.log(x2/x1))
    return points[-1][1]*(at/points[-1][0])**slope
