# SPDX-License-Identifier: GPL-3.0-or-later
"""Proposes solver, spacing, precision and device for an error that a case asks for: riprapAdvise,
and riprapFoam -advise

    riprapAdvise ERROR [-case DIR] [-measured ERROR] [-length METRES] [-flow KIND]

ERROR is a share, as 2% or 0.02. Reads the case's dictionaries and what `riprapFoam -dry-run` says
of it (particles, steps, time, memory; nothing is written), and the rows of etc/advice.csv: errors
and costs of the tutorials at several spacings.

-measured  the case's own error at its present spacing. Run it at this spacing and at twice that:
           with PIC the difference of what you look for is three times this error, with SPH about
           twice. The answer is better, as the last lines say, and needs no -length.
-length    the length that matters [m]: wavelength, width of a channel, size of a vortex, diameter
           of a body, thickness, head over a weir. By default the smallest side of a column that
           breaks, and the depth of water at rest; other flows need it
-flow      the kind of flow; default: by the dictionaries, where they tell. One of: dam break,
           waves, vortices, viscous channel, open channel, rest, bodies in water, elastic
-log FILE  of an earlier `riprapFoam -dry-run` of this case, instead of running it
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from typing import Optional

from . import advice
from .dictionaries import entry, numberOf, readDictionary

_number = r'([-+]?\d*\.?\d+(?:[eE][-+]?\d+)?)'


class Wrong(Exception):
    """What the user is told, in one line"""


@dataclass
class Case:
    solver: str
    spacing: float
    flow: str
    why: str                        # how flow was told
    length: Optional[float]
    lengthIs: str
    dimensions: int
    particles: float
    steps: float                    # a simulated second
    cost: float                     # seconds a simulated second, of the solver
    simulated: float
    device: str
    place: str
    memory: Optional[float]
    precision: str


def share(text):
    """Of '2%', '2 %' or '0.02'"""
    match = re.fullmatch(rf'\s*{_number}\s*(%?)\s*', text)
    value = float(match.group(1))/(100 if match.group(2) else 1) if match else None
    if value is None or not 0 < value < 1:
        raise Wrong(
            f"the error '{text}' is no share: give one as 2% or 0.02, above 0 and below 100%")
    return value


def dictionary(case, name):
    path = os.path.join(case, name)
    return readDictionary(path) if os.path.isfile(path) else {}


def boxes(particles):
    """(lower, upper corner) of the boxes that hold fluid"""
    found = []
    for region in _dictionaries(particles.get('regions', '')):
        if region.get('set') == 'fluid' and region.get('source') == 'box' and 'box' in region:
            numbers = [float(n) for n in re.findall(_number, region['box'])]
            if len(numbers) == 6:
                found.append((numbers[:3], numbers[3:]))
    return found


def _dictionaries(regions):
    """Of the list `( name { ... } ... )`, which readDictionary keeps as text, or of a dictionary"""
    if isinstance(regions, dict):
        return [r for r in regions.values() if isinstance(r, dict)]
    body = regions.strip()[1:-1] if regions.strip().startswith('(') else regions
    return [r for r in readDictionary('', body).values() if isinstance(r, dict)]


def flowOf(case, solver, axes, widths, periodic):
    """(kind of flow, what told it)"""
    solid = dictionary(case, 'constant/solidProperties')
    fluid = dictionary(case,
                       'constant/picProperties' if solver == 'picDem' else 'constant/sphProperties')
    particles = dictionary(case, 'system/setParticlesDict')
    if solid and solver != 'dem':
        return (('elastic', 'its solids are bonded') if 'bonds' in particles
                else ('bodies in water', 'there are solids in the water'))
    if solver == 'dem':
        if 'bonds' in particles:
            return 'elastic', 'its solids are bonded'
        raise Wrong('grains have the size that they have: '
                    'no spacing makes a run of dem without bonds more accurate')
    if 'openings' in fluid:
        return 'open channel', 'it has openings'
    gravity = [float(n) for n in re.findall(
        _number, re.sub(r'\[[^\]]*\]', ' ', dictionary(case, 'constant/g').get('value', '')))]
    if not any(gravity):
        walls = ('noSlip' in str(fluid.get('walls', '')) or 'bodyForce' in fluid
                 or 'acceleration' in fluid)
        return (('viscous channel', 'no gravity, and walls that hold the flow') if walls
                else ('vortices', 'no gravity'))
    if isinstance(fluid.get('walls'), dict) and 'motion' in fluid['walls']:
        return 'waves', 'its walls move'
    regions = [particles, *_dictionaries(particles.get('regions', ''))]
    if any(re.search('[1-9]', r.get('velocity', '')) or 'velocityField' in r for r in regions
           if isinstance(r.get('velocity', ''), str)):
        return 'waves', 'gravity, and water that moves at the start'
    up = max(range(len(gravity)), key=lambda d: abs(gravity[d]))
    water = boxes(particles)
    if not water or not widths or periodic:
        raise Wrong('the dictionaries do not tell the kind of flow; give it by -flow: '
                    + ', '.join(advice.flows))
    for d in axes:
        if d != up and max(b[1][d] for b in water) - min(b[0][d] for b in water) < 0.98*widths[d]:
            return 'dam break', 'gravity, and water that does not reach from wall to wall'
    return 'rest', 'gravity, and water from wall to wall that does not move'


def widthsOf(case):
    """Of the mesh along x, y, z, from its points; None where they are not written as text"""
    path = os.path.join(case, 'constant/polyMesh/points')
    if not os.path.isfile(path):
        return None
    with open(path, errors='replace') as f:
        text = f.read(20000000)
    if 'format      ascii' not in text and 'format ascii' not in re.sub(r' +', ' ', text[:2000]):
        return None
    points = re.findall(rf'\({_number} {_number} {_number}\)', text)
    if not points:
        return None
    columns = list(zip(*((float(x), float(y), float(z)) for x, y, z in points)))
    return {d: max(c) - min(c) for d, c in enumerate(columns)}


def dryRun(case, solver, log):
    """What -dry-run says"""
    if log:
        if not os.path.isfile(log):
            raise Wrong(f'there is no log {log}')
        with open(log, errors='replace') as f:
            return f.read()
    if not shutil.which('riprapFoam'):
        raise Wrong('riprapFoam is not in PATH: . etc/bashrc of riprap first')
    done = subprocess.run(['riprapFoam', '-case', case, '-solver', solver, '-dry-run'],
                          capture_output=True, text=True)
    if done.returncode:
        said = (done.stdout + done.stderr)
        error = re.search(r'FOAM FATAL.*?\n(.*?)\n\s*\n', said, re.S)
        raise Wrong('riprapFoam -dry-run refuses the case: '
                    + ' '.join((error.group(1) if error else said[-400:]).split()))
    return done.stdout


def read(case, length, flow, log, measured=None):
    if not os.path.isdir(case):
        raise Wrong(f'there is no case {case}')
    control = dictionary(case, 'system/controlDict')
    if not control:
        raise Wrong(f'{case} is no case: it has no system/controlDict')
    solver = control.get('solver')
    if solver not in ('sphDem', 'picDem', 'dem'):
        raise Wrong(
            f"solver of {case}/system/controlDict is '{solver}'; sphDem, picDem, dem are known")
    particles = dictionary(case, 'system/setParticlesDict')
    said = dryRun(case, solver, log)

    def told(pattern, what):
        match = re.search(pattern, said, re.M)
        if not match:
            raise Wrong(f'riprapFoam -dry-run does not say {what}')
        return match

    space = told(r'^\s+(?:space|grid)\s+(\d)D: (?:(.*) cells of (\S+) m along )?((?:[xyz] ?)+); '
                 r'periodic: (.*)$', 'how many dimensions the case has')
    dimensions, axes = int(space.group(1)), ['xyz'.index(a) for a in space.group(4).split()]
    count = float((re.search(rf'^Particles\s*\n\s+(?:fluid|solids): {_number}', said, re.M) or told(
        rf'^\s*particles\s+(?:fluid )?{_number}', 'how many particles there are')).group(1))
    end, steps = told(rf'^Particle steps to time {_number}: (\d+) with this step',
                      'how many steps the run takes').groups()
    most = re.search(r'with this step, about (\d+) at maxVelocity', said)
    solverTime = float(told(rf'^\s+solver\s+{_number}', 'what the run takes').group(1))
    begin = numberOf(control.get('startTime'), 0.0)
    simulated = float(end) - begin
    if simulated <= 0:
        raise Wrong('there is nothing left to simulate')
    device = told(r'^\s*device\s+(\S.*?)\s*(?:\(|$)', 'the device').group(1)
    memory = re.search(rf'^\s+all: {_number} ([kMGT]?)B', said, re.M)
    threads = re.search(r'^\s*threads\s+(\d+)', said, re.M)
    place = ('GPU' if 'NVIDIA' in device else 'CPU, one thread'
             if threads and threads.group(1) == '1' else 'CPU, several threads')
    spacing = numberOf(particles.get('spacing'))
    if space.group(3):
        spacing = float(space.group(3))/numberOf(entry(dictionary(case, 'constant/picProperties'),
                                                       'seeds/perDirection'), 2)
    if not spacing:
        raise Wrong(f'{case}/system/setParticlesDict has no spacing')
    why = 'as asked for'
    if flow is None:
        widths = (
            dict(zip(axes, (float(space.group(3))*int(n) for n in space.group(2).split(' x '))))
            if space.group(3) else widthsOf(case))
        flow, why = flowOf(case, solver, axes, widths, space.group(5).strip() != 'none')
    lengthIs = 'as asked for'
    if length is None:
        length, lengthIs = lengthOf(case, particles, flow, axes)
    if length is None and not measured:
        raise Wrong(f'not known: the length that matters in {flow}. Give {matters[flow]} '
                    'by -length METRES, or the error of this spacing by -measured (-help)')
    return Case(solver, spacing, flow, why, length, lengthIs, dimensions, count,
                float(most.group(1) if most else steps)/simulated, solverTime/simulated, simulated,
                device, place, float(memory.group(1))*1000**' kMGT'.index(memory.group(2) or ' ')
                if memory else None,
                (re.search(r'^\s*precision\s+(\w+)', said, re.M) or [None, 'mixed'])[1])


matters = {'dam break': 'the width or height of the column', 'waves': 'the wavelength',
           'vortices': 'the size of a vortex', 'viscous channel': 'the width of the channel',
           'open channel': 'the head over the weir, or the depth',
           'rest': 'the depth', 'bodies in water': 'the diameter of the smallest body',
           'elastic': 'the thickness of the thinnest body'}


def lengthOf(case, particles, flow, axes):
    """Where the boxes of water tell it"""
    water = boxes(particles)
    gravity = [float(n) for n in re.findall(
        _number, re.sub(r'\[[^\]]*\]', ' ', dictionary(case, 'constant/g').get('value', '')))]
    if flow == 'dam break' and water:
        return (min(b[d] - a[d] for a, b in water for d in axes),
                "smallest side of the water's boxes")
    if flow == 'rest' and water and any(gravity):
        up = max(range(len(gravity)), key=lambda d: abs(gravity[d]))
        return max(b[1][up] for b in water) - min(b[0][up] for b in water), 'depth of the water'
    return None, ''


@dataclass
class Proposal:
    solver: str
    across: Optional[float]         # spacings over the length that matters, where that is known
    spacing: float
    # seconds a simulated second on the case's device; None: not known
    cost: Optional[float]
    particles: float
    memory: Optional[float]
    pool: list
    current: bool


def propose(case, known, error, measured):
    """[Proposal], the cheapest first, and what is not known"""
    result, unknown = [], []
    now = case.length/case.spacing if case.length else None
    for solver in ('picDem', 'sphDem', 'dem'):
        pool = advice.weighed(known, solver, case.flow)
        if not any(w == 1 for _, w in pool):
            if solver == case.solver and not measured:
                unknown.append(f'{solver}: no scene of this kind ({case.flow}) has rows of it')
            if solver != case.solver or not measured:
                continue
        if measured and solver != case.solver:
            continue
        if measured:
            finer = (measured/error)**(1/advice.orderOf(known, solver))
            across = now*finer if now else None
        else:
            across = advice.acrossFor(pool, error)
            finer = across/now if across else None
        if finer is None:
            finest = advice.foretoldError(pool,
                                          advice.farther*max(k.errors[-1][0] for k, _ in pool))
            unknown.append(f'{solver}: {shown(100*error)} % lies beyond what its scenes tell of, '
                           f'{shown(100*finest)} %')
            continue
        cost = case.cost*advice.costRatio(case.dimensions, case.place, case.particles, finer)
        if solver != case.solver:
            cost = otherCost(case, known, solver, cost, finer)
        result.append(Proposal(
            solver, across, case.spacing/finer, cost, case.particles*finer**case.dimensions,
            case.memory*finer**case.dimensions if case.memory and solver == case.solver else None,
            pool, solver == case.solver))
    return sorted(result, key=lambda p: (p.cost is None, p.cost or 0)), unknown


def otherCost(case, known, solver, cost, finer):
    """Of another solver at the same spacing: by the steps of scenes that both have, and the time of
    a step of each"""
    steps = advice.stepsRatio(known, case.solver, solver, 2)
    mine, other = (advice.stepTime(known, s, 2, case.place) for s in (case.solver, solver))
    if not (steps and mine and other) or case.dimensions != 2:
        return None
    n = case.particles*finer**case.dimensions
    return cost*steps*(other[0] + other[1]*n)/(mine[0] + mine[1]*n)


def report(case, known, error, measured):
    proposals, unknown = propose(case, known, error, measured)
    # an own error is told by the difference of two runs
    way = 'difference' if measured else ''
    errors, costs, _, _ = advice.scores(known, way)
    flow = advice.scores(known, way, case.flow)[0]
    factor = max(errors.factor, flow.factor) if flow.told else errors.factor
    lines = [f'Case: {case.solver}, {case.dimensions}D, {case.particles:.0f} '
             f'particles {1000*case.spacing:.3g} mm apart, {case.device}, '
             f'{seconds(case.cost*case.simulated)} for {shown(case.simulated)} s by the dry run',
             f'Taken for: {case.flow} ({case.why}); -flow says otherwise',
             *([f'Length that matters: {case.length:.3g} m, {case.length/case.spacing:.0f} '
                f'spacings ({case.lengthIs}); -length says otherwise'] if case.length else []), '']
    if not proposals:
        lines += ['Not known: ' + text for text in unknown]
        lines.append('What can be done: run the case at its spacing and at twice that, '
                     'and give the error that follows by -measured (riprapAdvise -help)')
        return '\n'.join(lines), 3
    own = [k for k in proposals if k.current]
    if own and case.length and not measured:
        lines.append('At its present spacing: an error of '
                     f'{shown(100*advice.foretoldError(own[0].pool, case.length/case.spacing))} % '
                     'is expected')
    lines.append(f'For an error of {shown(100*error)} %' + (
        f', {shown(100*measured)} % being that of {1000*case.spacing:.3g} mm' if measured else ''))
    for i, p in enumerate(proposals):
        lines.append(f"{'Proposed' if i == 0 else 'Or'}: solver {p.solver}, "
                     f"spacing {p.spacing*1000:.3g} mm"
                     + (f' ({p.across:.0f} over the length)' if p.across else '')
                     + (', cells of twice that' if p.solver == 'picDem' else '')
                     + ", precision mixed, device auto")
        expected = (min(error, advice.foretoldError(p.pool, p.across)) if p.across and not measured
                    else error)
        lines.append(f'    expected error {shown(100*expected)} %, '
                     f'from {shown(100*expected/factor)} to {shown(100*expected*factor)} %'
                     + (': hardly known' if factor > 5 else ''))
        if p.cost is None:
            lines.append(f'    cost not known: no rows of both solvers on {case.place} '
                         f'in {case.dimensions}D; a dry run with solver {p.solver} tells')
        else:
            whole = p.cost*case.simulated
            within = costs.factor if p.current else 2*costs.factor
            lines.append(f'    expected cost {seconds(whole)} for {shown(case.simulated)} s on '
                         f'{case.device}, from {seconds(whole/within)} to {seconds(whole*within)}'
                         + ('' if p.current else ', by scenes that both solvers have'))
        lines.append(f'    {p.particles:.0f} particles'
                     + (f', {shown(p.memory/1e6)} MB on the device' if p.memory else ''))
        if not measured:
            resting = sorted({k.scene for k, w in p.pool if w == 1})
            lines.append(f"    rests on {', '.join(resting)}; {len(p.pool) - len(resting)} "
                         "scenes of other kinds count a tenth each")
        else:
            lines.append(f'    rests on the order {advice.orderOf(known, p.solver):.1f}, '
                         f'median of {len(p.pool)} scenes')
        if p.across and p.across > max(k.errors[-1][0] for k, _ in p.pool):
            lines.append('    finer than any scene of it: less sure')
    lines += ['Not known: ' + text for text in unknown]
    lines += ['', f'How far to trust this: each scene foretold from the others, {errors.within} '
                  f'of {errors.told} errors and {costs.within} of {costs.told} costs are within a '
                  f'factor of 2, two thirds within {errors.factor:.1f} and {costs.factor:.1f}'
              + (f'; of {case.flow} {flow.within} of {flow.told} errors' if flow.told else '')]
    better = advice.scores(known, 'error')[0]
    if measured:
        lines.append('With errors that are known, not told by the difference of two runs, it is '
                     f'{better.within} of {better.told}, two thirds within {better.factor:.1f}')
    else:
        two = advice.scores(known, 'difference')[0]
        lines.append(
            f"Better: by the case's own error at one spacing (-measured) it is {better.within} "
            f"of {better.told}, by the difference of two runs {two.within} of {two.told}")
    return '\n'.join(lines), 0


def shown(value):
    return f'{value:.2g}' if abs(value) < 10 else f'{value:.0f}'


def seconds(value):
    return (f'{shown(value)} s' if value < 120 else f'{shown(value/60)} min' if value < 7200
            else f'{shown(value/3600)} h')


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Wrong(message + ' (-help: the options)')


def main(arguments):
    if {'-h', '-help', '--help'} & set(arguments):
        print(__doc__.split('\n', 2)[2].strip())
        return 0
    try:
        parser = Parser(prog='riprapAdvise', add_help=False)
        parser.add_argument('error')
        parser.add_argument('-case', default='.')
        parser.add_argument('-measured')
        parser.add_argument('-length')
        parser.add_argument('-flow')
        parser.add_argument('-log')
        options = parser.parse_args(arguments)
        error = share(options.error)
        measured = share(options.measured) if options.measured else None
        length = None
        if options.length is not None:
            if not re.fullmatch(_number, options.length) or float(options.length) <= 0:
                raise Wrong(f"-length '{options.length}' is no length: metres, above 0")
            length = float(options.length)
        if options.flow is not None and options.flow not in advice.flows:
            raise Wrong(f"-flow '{options.flow}' is not known; there are {', '.join(advice.flows)}")
        text, status = report(read(options.case, length, options.flow, options.log, measured),
                              advice.read(), error, measured)
        print(text, flush=True)
        return status
    except BrokenPipeError:
        return 0
    except Wrong as problem:
        print(f'riprapAdvise: {problem}', file=sys.stderr)
        return 1
