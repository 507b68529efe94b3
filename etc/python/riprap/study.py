# SPDX-License-Identifier: GPL-3.0-or-later
"""A tutorial's verification: which runs, what is measured, what is drawn

A tutorial's analysis.py makes one Study and calls main(), which understands
    analysis.py plot RUN_DIRECTORY ...
    analysis.py verify [-quick] [-reuse] [-only PATTERN] [-set ENTRIES -label LABEL]
        [-quantities FILE]
verify runs the tutorial's Allrun for each variant, compares with reference/, prints the table,
reports observed orders, draws the figure and appends a row a run to benchmarks/results.
"""
import argparse
import csv
import fnmatch
import glob
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass, field, replace

from . import clouds, records
from .bounds import Bounds, check, printTable, root
from .dictionaries import entry, numberOf, readDictionary
from .logs import readLog
from .measures import observedOrder
from .tables import hasTable, readTable


class Run:
    """A finished run: its directory, dictionaries, log and tables"""

    def __init__(self, path, name=None):
        self.path = os.path.abspath(path)
        self.name = name or os.path.basename(self.path)
        self.control = self.dictionary('system/controlDict')
        onGrid = self.control.get('solver') == 'picDem'
        self.pic = self.dictionary('constant/picProperties') if onGrid else {}
        self.sph = {} if onGrid else self.dictionary('constant/sphProperties')
        self.solid = self.dictionary('constant/solidProperties')
        self.fluid = self.dictionary('constant/fluidProperties')
        self.particles = self.dictionary('system/setParticlesDict')
        self.spacing = numberOf(self.particles.get('spacing'))
        self._log = None

    def dictionary(self, name):
        """Empty where the case has no such file"""
        path = os.path.join(self.path, name)
        return readDictionary(path) if os.path.exists(path) else {}

    @property
    def log(self):
        if self._log is None:
            self._log = readLog(os.path.join(self.path, 'log.riprapFoam'))
        return self._log

    def table(self, name, file=None):
        return readTable(self.path, name, file)

    def sphEntry(self, path, default=None):
        return entry(self.sph, path, default)

    def number(self, path, default=None):
        return numberOf(self.sphEntry(path), default)

    @property
    def density(self):
        return numberOf(self.fluid['rho'])

    @property
    def kinematicViscosity(self):
        if 'nu' in self.fluid:
            return numberOf(self.fluid['nu'])
        return numberOf(self.fluid['mu'])/self.density

    def settings(self):
        """The choices that tell one model from another, in one word each"""
        if self.pic:
            return (' '.join(f'{key}={entry(self.pic, path, default)}' for key, path, default in (
                ('transfer', 'transfer', 'flip'), ('spline', 'spline', 'quadratic'),
                ('affine', 'affine', 'yes'), ('advection', 'advection', 'RungeKutta3'),
                ('reflection', 'reflection', 'yes'),
                ('perDirection', 'seeds/perDirection', '2'), ('jitter', 'seeds/jitter', '0')))
                    + ''.join(f' {w}' for w in self.bodySettings()))
        if not self.sph:
            return ' '.join(f'{key}={entry(self.solid, path, default)}' for key, path, default in (
                ('normal', 'contact/normal', 'hertz'),
                ('tangential', 'contact/tangential', 'history'),
                ('rolling', 'contact/rolling', 'none'),
                ('timeIntegration', 'timeIntegration', 'leapfrog'),
                ('stepFraction', 'stepFraction', '0.2')))

        def of(key, default):
            return f'{key}={self.sphEntry(key, default)}'.replace('/model', '').replace('/type', '')
        return ' '.join([of('kernel', 'wendlandC2'), of('smoothingLength/model', 'constant'),
                         of('smoothingLength/ratio', '1.25'), of('walls/model', 'extrapolated'),
                         of('walls/spacing', 'fluid'), of('viscosity', 'laminarAndArtificial'),
                         of('antiClump', '0.01'), of('XSPH', 'none'),
                         of('densityDiffusion', 'fourtakas'), of('shifting', 'none'),
                         of('timeIntegration', 'symplectic')]
                        + self.artificialSettings() + (self.solidSettings() if self.solid else []))

    def artificialSettings(self):
        """Of the artificial viscosity, where there is one; and walls that forces alone make
        tight"""
        words = []
        if 'rtificial' in self.sphEntry('viscosity', 'laminarAndArtificial'):
            atWalls = self.sphEntry('artificialViscosity/walls', 'no') in ('yes', 'on', 'true')
            words.append(f"alpha={self.sphEntry('artificialViscosity/alpha', '0.02')}"
                         f"{'/walls' if atWalls else ''}")
        if self.sphEntry('walls/impermeable', 'yes') in ('no', 'off', 'false'):
            words.append('impermeable=no')
        return words

    def bodySettings(self):
        """Of solids in the water of cells: what else tells runs apart, lengths in cells. subcycles
        is what came of it, steps of solids a step of the water"""
        if not self.solid:
            return []
        fixed = self.control.get('adjustTimeStep') == 'no'
        words = [f"coupling={self.pic.get('coupling', 'implicit')}",
                 f"contactVelocity={self.pic.get('contactVelocity', '1')}"]
        words += [f"contactVelocityTime={self.pic[key]}" for key in ('contactVelocityTime',)
                  if key in self.pic]
        words.append(f"solver={entry(self.dictionary('system/fvSolution'), 'solvers/p/solver')}")
        words.append(f"deltaT={self.control.get('deltaT')}" if fixed
                     else f"maxCo={self.control.get('maxCo', '0.5')}")
        words.append(f"stepFraction={self.solid.get('stepFraction', '0.2')}")
        cell = self.log['cellSize']
        gaps = {numberOf(pair['gap']) for pair in self.solid.get('pairs', {}).values()
                if isinstance(pair, dict) and 'gap' in pair}
        if cell:
            words.append(f"gap={'/'.join(f'{g/cell:.3g}' for g in sorted(gaps)) or 0}")
            diameter = self.smallestSolid()
            words += [f'cellsDiameter={diameter/cell:.3g}'] if diameter else []
        both = self.log['solidSteps'] and self.log['steps']
        return words + ([f"subcycles={self.log['solidSteps']/self.log['steps']:.3g}"] if both
                        else [])

    def smallestSolid(self):
        """Diameter of the smallest disk or sphere; None of clumps, whose spheres are parts of
        them"""
        names = clouds.times(self.path)
        path = os.path.join(self.path, names[0], 'lagrangian', 'solids', 'radius') if names else ''
        if self.log['clumps'] or not (os.path.exists(path) or os.path.exists(path + '.gz')):
            return None
        return 2*float(clouds.readField(path).min())

    def solidSettings(self):
        """Of solids in the fluid; steps of theirs are told by their share of sqrt(m/k), since their
        number swings with the fluid's step"""
        words = [f"{key}={self.sphEntry(path, default)}" for key, path, default in
                 (('coupling', 'coupling', 'extrapolated'),
                  ('couplingCoeffs/fluidForce', 'couplingCoeffs/fluidForce', 'default'))]
        words.append(f"stepFraction={entry(self.solid, 'stepFraction', '0.2')}")
        bonds = [f"{numberOf(bond['E']):g}" for bond in self.solid.get('bonds', {}).values()
                 if isinstance(bond, dict) and 'E' in bond]
        # of the first material
        words += ([f'E={E}' for E in bonds]
                  or [f"rho={next(iter(self.solid['materials'].values()))['rho']}"])
        damping = {group['localDamping'] for group in self.solid.get('groups', {}).values()
                   if isinstance(group, dict) and 'localDamping' in group}
        return words + [f'localDamping={d}' for d in sorted(damping)]

    def energyDrift(self):
        """Energy that left the particles' balance over the run, relative to the largest kinetic
        plus elastic energy and the change of potential energy (dissipation included)"""
        if not hasTable(self.path, 'energy'):
            return None
        if glob.glob(os.path.join(self.path, 'postProcessing', 'energy', '*', 'solidEnergies.dat')):
            e = self.table('energy', 'solidEnergies.dat')['total']
            return float((e[-1] - e[0])/abs(e).max()) if abs(e).max() > 0 else 0.0
        e = self.table('energy', 'energyBalance.dat')
        scale = max((e['kinetic'] + e['elastic']).max(),
                    abs(e['potential'] - e['potential'][0]).max())
        return float(e['dissipated'][-1]/scale) if scale > 0 else 0.0


@dataclass
class Variant:
    """One run of verify: options of Allrun beside -name; case: another tutorial, as module/name;
    label: added to the name of the run's folder; mayFail: a model that is shown at its limit and
    may stop; large: hours on a CPU, or of a GPU alone; left out where there is none unless it is
    finished and reused, or named by -only"""
    name: str
    options: list = field(default_factory=list)
    case: str = ''
    mayFail: bool = False
    large: bool = False
    label: str = ''


@dataclass
class Study:
    scene: str
    variants: list                  # run by verify
    quick: list                     # run by verify -quick
    analyse: callable               # Run -> [Quantity]
    plot: callable                  # ([Run], path of the figure)
    headline: str                   # the quantity whose error goes to benchmarks/results
    orders: list = field(default_factory=list)      # (quantity, [names of variants])
    recorded: list = None           # names of variants that go to benchmarks/results, if not all
    compare: callable = None        # {name: Run}, {name: [Quantity]} -> [Quantity] between runs

    def main(self, here):
        parser = argparse.ArgumentParser(prog='analysis.py')
        commands = parser.add_subparsers(dest='command', required=True)
        plot = commands.add_parser('plot')
        plot.add_argument('runs', nargs='+')
        verify = commands.add_parser('verify')
        verify.add_argument('-quick', action='store_true',
                            help='one coarse run with its own bounds')
        verify.add_argument('-reuse', action='store_true',
                            help='use finished runs of the same name')
        verify.add_argument('-only', default='*', help='variants whose name matches this pattern')
        verify.add_argument('-set', dest='sets',
                            help="entries for all runs, as Allrun's; nothing is recorded or drawn")
        verify.add_argument('-label', default='',
                            help="added to the names of the runs' folders; needed with -set")
        verify.add_argument('-quantities', help='CSV file: a row a quantity')
        options = parser.parse_args()
        if options.command == 'verify' and options.sets and not options.label:
            parser.error('-set needs -label')
        here = os.path.abspath(here)
        if options.command == 'plot':
            runs = [Run(r) for r in options.runs]
            self.plot(runs, os.path.join(runs[0].path, self.scene + '.png'))
            return
        sys.exit(1 if self.verify(here, options) else 0)

    def verify(self, here, options):
        """Number of failures"""
        level = 'quick' if options.quick else 'full'
        bounds = Bounds(self.scene, level)
        chosen = [v for v in (self.quick if options.quick else self.variants)
                  if fnmatch.fnmatch(v.name, options.only)]
        left = [v for v in chosen if v.large and options.only == '*'
                and not shutil.which('nvidia-smi') and not (options.reuse and finished(here, v))]
        chosen = [v for v in chosen if v not in left]
        for v in left:
            print(f'{v.name}: left out without a GPU: large, or meant for one (-only {v.name} '
                  'runs it)')
        runs, results, failures = {}, {}, 0
        if options.sets:
            chosen = [replace(v, options=[*v.options, '-set', options.sets],
                              label=f'-{options.label}') for v in chosen]
        for v in chosen:
            try:
                path = launch(here, v, options.reuse)
                run = Run(path, v.name)
                results[v.name] = self.analyse(run)
                runs[v.name] = run
            except Exception as problem:            # one bad run must not hide the others
                results[v.name] = []
                failures += not v.mayFail
                print(f'{v.name}: {"stopped, which is allowed" if v.mayFail else "FAILED"}: '
                      f'{problem}')
        if self.compare:
            results['between runs'] = self.compare(runs, results)
        rows, out, findings = check(bounds, results)
        failures += out
        print(f'\n{self.scene} ({level})')
        printTable(rows)
        self.printOrders(runs, results)
        failures += self.missing(bounds, options, left)
        if not bounds.rows:
            print(f'no bounds for {self.scene}, {level}, in tests/regression/tolerances.csv')
            failures += 1
        if options.quantities:
            writeQuantities(options.quantities, bounds, runs, results)
        # A copy of a tutorial is no result of riprap's
        shipped = here.startswith(os.path.join(root(), 'tutorials', ''))
        for name, run in runs.items() if shipped and not options.sets else ():
            if self.recorded is not None and name not in self.recorded:
                continue
            q = headline(results[name], self.headline)
            records.append(self.scene, run, q.name, q.checked, q.kind)
        if runs and not (options.quick or options.sets):
            images = os.path.join(root(), 'docs', 'images') if shipped else here
            os.makedirs(images, exist_ok=True)
            self.plot(list(runs.values()), os.path.join(images, self.scene + '.png'))
        told = f'; findings that miss their bounds: {findings}' if findings else ''
        print(f'{self.scene}: ' + (f'{failures} out of bounds' if failures else 'all within bounds')
              + told)
        return failures

    def printOrders(self, runs, results):
        for quantity, names in self.orders:
            known = [(runs[n].spacing, valueOf(results[n], quantity)) for n in names if n in runs]
            order = observedOrder(*zip(*known)) if len(known) > 1 else None
            if order is not None:
                errors = ', '.join(f'{e:.3g} ({s:g} m)' for s, e in known if e is not None)
                print(f'observed order of {quantity}: {order:.2f}   [{errors}]')

    @staticmethod
    def missing(bounds, options, left):
        if options.only != '*':
            return 0
        missed = [r for r in bounds.unused()
                  if not any(fnmatch.fnmatch(v.name, r['run']) for v in left)]
        for r in missed:
            print(f"bound without a quantity: {r['run']}: {r['quantity']}")
        return len(missed)


def valueOf(quantities, name):
    return next((q.checked for q in quantities if q.name == name), None)


def writeQuantities(path, bounds, runs, results):
    """A row a quantity: its error, or its value where it has none, and its bounds; a run that
    failed has a row without any"""
    with open(path, 'w', newline='') as f:
        writer = csv.writer(f, lineterminator='\n')
        writer.writerow(['run', 'quantity', 'value', 'low', 'high', 'seconds', 'particles',
                         'device'])
        for name, quantities in results.items():
            log = runs[name].log if name in runs else {'fluidParticles': None, 'device': None}
            about = [records.wallTime(log) if name in runs else '', '' if log['fluidParticles']
                     is None else f"{log['fluidParticles']:.0f}", log['device'] or '']
            for q in quantities:
                low, high = bounds.find(name, q.name)[0] or (None, None)
                writer.writerow([name, q.name, *('' if v is None else f'{v:.6g}'
                                                 for v in (q.checked, low, high)), *about])
            if not quantities and name != 'between runs':
                writer.writerow([name, 'stopped', '', '', '', *about])


def headline(quantities, name):
    """The quantity that stands for a run: the named one, else the first error"""
    found = ([q for q in quantities if q.name == name]
             + [q for q in quantities if q.error is not None])
    return found[0] if found else quantities[0]


def place(here, variant):
    """The case that a variant is a run of, and the run's folder"""
    case = os.path.join(root(), 'tutorials', variant.case) if variant.case else here
    return case, os.path.join(case, 'runs', variant.name + variant.label)


def finished(here, variant):
    path = place(here, variant)[1]
    return os.path.exists(os.path.join(path, 'log.riprapFoam')) and Run(path).log['ended']


def launch(here, variant, reuse):
    """Run a variant by its tutorial's Allrun; path of the run"""
    case, path = place(here, variant)
    if reuse and finished(here, variant):
        print(f'Reusing {variant.name}')
        return path
    command = [os.path.join(case, 'Allrun'), '-name', variant.name + variant.label, '-noPlot',
               *variant.options]
    subprocess.run(command, check=True)
    return path
