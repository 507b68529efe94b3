# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of docs/stability.md: where methods fail, with the figures of benchmarks/results

A Boundary names the rows that its figures come from; a row that is not there, or not alone, is an
error. So is a test that is not there. `sides` says whether the tests hold the boundary from both
sides, from one, or not at all; the page lists those that want a test.
"""
import csv
import glob
import os
import re
from dataclasses import dataclass, field

root = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))


@dataclass
class Boundary:
    mode: str
    seen: str
    # (what it is, file of results, {column: value}, theory where the rows have none)
    rows: list
    remedy: str
    guard: str = '-'
    # suite.name of tests/unit, or a file of tests/regression
    tests: list = field(default_factory=list)
    sides: str = 'none'             # both; free: none is known, and the test holds that; one; none
    missing: str = ''               # what a test would have to show


def sph(quantity, **more):
    return 'stability', {'kernel': 'wendlandC2', 'ratio': '1.25', 'quantity': quantity, **more}


def dem(test, scene, quantity, **more):
    return 'demStability', {'test': test, 'scene': scene, 'integrator': 'leapfrog',
                            'quantity': quantity, **more}


def coupled(test, coupling, force, body, setting='0.4'):
    return 'couplingStability', {'test': test, 'coupling': coupling, 'force': force, 'body': body,
                                 'setting': setting}


def pic(test, kind, setting, quantity):
    return 'picStability', {'test': test, 'kind': kind, 'setting': setting, 'quantity': quantity}


def picDem(test, kind, setting, quantity):
    return 'picDemStability', {'test': test, 'kind': kind, 'setting': setting, 'quantity': quantity}


step = 'largest dt / sqrt(m/k)'
density = 'least density ratio, 60 steps (0.001: none found)'
floats = 'least density ratio that floats for 0.5 s, half out at the start (0.001: none found)'
thin = 'largest speed that stays in the gap [m/s]'
firstAcceleration = 'error of the first acceleration, rms over nine places; 1e9: stops'
parts = ('largest step over sqrt(m/k) that keeps them apart and parts them no faster than 1.05 '
         'times as they came (3.2: none found)')

areas = {
    'sph': [
        Boundary('Sound, symplectic',
                 'shortest waves grow by 1.5 a step; speed guard within some 20 steps',
                 [('c0 dt/h', *sph('largest c0 dt/h', test='acoustic', integrator='symplectic',
                                   terms='none'), None),
                  ('with density diffusion',
                   *sph('largest c0 dt/h', test='acoustic', integrator='symplectic',
                        terms='densityDiffusion'), None)],
                 '`acousticCourant` 0.4 to 0.6',
                 '`acousticCourant` above 2 is refused; `speedRatio`',
                 ['SoundWave.SymplecticIsStableToTwo',
                  'StabilityLimits.DiffusionShortensTheStepOfSound'], 'both'),
        Boundary('Sound, leapfrog', 'noise grows slowly everywhere, as (omega dt)^4/4 a step',
                 [('growth a step at omega dt 0.2',
                   *sph('growth a step at omega dt = 0.2', test='acoustic', integrator='leapfrog',
                        terms='none'), None),
                  ('c0 dt/h with density diffusion',
                   *sph('largest c0 dt/h', test='acoustic', integrator='leapfrog',
                        terms='densityDiffusion'), None)],
                 '`acousticCourant` 0.1, or 0.3 with `densityDiffusion`',
                 '`acousticCourant` above 0.7 is refused',
                 ['SoundWave.LeapfrogGrowsByTheFourthPower'], 'both'),
        Boundary('Viscosity', 'the shortest shear wave changes sign and grows',
                 [('nu dt/h^2', *sph('largest nu dt/h^2', test='viscous', integrator='symplectic',
                                     terms='laminar'), None)],
                 '`viscousCourant` 0.125', '`speedRatio`', ['StabilityLimits.ViscousStep'], 'both'),
        Boundary('Impact on a wall', 'a block at 0.5 c0 gains energy in the impact',
                 [('dt (c0 + v)/h at 0.1 c0',
                   *sph('largest dt (c0 + v)/h; impact at 0.1 c0', test='force',
                        integrator='symplectic', terms='none', walls='extrapolated'), None),
                  ('at 0.5 c0', *sph('largest dt (c0 + v)/h; impact at 0.5 c0', test='force',
                                     integrator='symplectic', terms='none', walls='extrapolated'),
                   None)],
                 '`forceCourant` 0.25; symplectic', '`densityDeviation`', [], 'none',
                 'a block at 0.5 c0 with steps of 0.6 and 1'),
        Boundary('Tension', 'particles pair up and leave voids; pressure below zero',
                 [('growth [c0/h] at 1 % tension',
                   *sph('growth rate h/c0 at rho/rho0 - 1 = -0.01', test='tensile',
                        integrator='symplectic', terms='none'), None),
                  ('antiClump 0.2', *sph('growth rate h/c0 at rho/rho0 - 1 = -0.01', test='tensile',
                                         integrator='symplectic', terms='antiClump 0.2'), None),
                  ('tension that clumps in 500 h/c0',
                   *sph('1 - rho/rho0 that clumps in 500 h/c0', test='tensile',
                        integrator='symplectic', terms='none'), None)],
                 '`antiClump`; a start pressure above zero where there is no surface',
                 'none: it is slow', [], 'none', 'pairs at 1 % tension, none at 1 % pressure'),
        Boundary('Walls of particles', 'a block of water goes through',
                 [('speed / (c0/10), points dp',
                   *sph('block: speed that passes / (c0/10)', test='passage',
                        integrator='symplectic', walls='extrapolated dp'), None),
                  ('points dp/2', *sph('block: speed that passes / (c0/10)', test='passage',
                                       integrator='symplectic', walls='extrapolated dp/2'), None)],
                 '`impermeable yes`, the default; a larger `maxVelocity`',
                 '`densityDeviation` 0.5, `speedRatio` 4, `escape`',
                 ['Guards.DensityStopsWithTheParticle', 'Guards.SpeedStopsWithTheParticle',
                  'dryRun.sh'], 'one',
                 'a block at 4 and at 5 c0/10 on walls with `impermeable no`'),
        Boundary('Impermeable walls', 'a particle passes a face in one long step',
                 [('way of a step / dp, solid', *sph('particle: way of a step that passes / dp',
                                                     test='faces', walls='solid'), None),
                  ('way / thickness, plate', *sph('particle: way of a step that passes / thickness',
                                                  test='faces', walls='plate'), None)],
                 'adaptive steps; plates thicker than 0.63 dp', '`escape`',
                 ['WallFaces.HoldUpToTheirLimits', 'WallFaces.HoldAtAnySpeedWithAdaptiveSteps'],
                 'both'),
        Boundary('Wild particles', 'single particles are taken out, and told',
                 [('density deviation', *sph('noise of density that takes out [rho0]', test='wild',
                                             terms='defaults alpha 0.02'), None),
                  ('block on a wall: speed / (c0/10)',
                   *sph('block: speed that takes out / (c0/10)', test='wild'), None)],
                 'a larger `maxVelocity`', '`wild stop`; `maxWild`', ['Wild.ItsLimits'], 'both'),
    ],
    'dem': [
        Boundary('Step: one contact', 'a body that rests on a floor jumps higher and higher',
                 [('dt / sqrt(m/k)', *dem('limits', 'one body on a floor', step), None),
                  ('e = 0.5', *dem('limits', 'one body on a floor, e = 0.50', step), None),
                  ('e = 0.1', *dem('limits', 'one body on a floor, e = 0.10', step), None)],
                 '`stepFraction` 0.2', 'steps above 0.5 sqrt(m/k) are refused (`allowLargeStep`)',
                 ['StabilityOfSolids.BodyOnAFloor', 'DemPlan.LimitsOfSprings', 'dryRun.sh'],
                 'both'),
        Boundary('Step: packings', 'a bed heats up and flies apart',
                 [('chain', *dem('limits', 'chain', step), None),
                  ('hexagonal, kt/kn 0.5', *dem('limits', 'hexagonal, kt/kn = 0.5', step), None),
                  ('close packing, kt/kn 1', *dem('limits', 'close packing, kt/kn = 1.0', step),
                   None)],
                 '`stepFraction` 0.2; above 0.3 look at the energy',
                 'none: the guard of 0.5 lets dense frictional packings through',
                 ['StabilityOfSolids.Packings'], 'both'),
        Boundary('Step: bonds', 'a bonded body shakes itself apart',
                 [('chain, ks/kn 0.5', *dem('limits', 'bonded chain, ks/kn = 0.50', step), None),
                  ('hexagonal', *dem('limits', 'bonded hexagonal, ks/kn = 0.5', step), None),
                  ('close packing', *dem('limits', 'bonded close packing, ks/kn = 0.5', step),
                   None)],
                 '`stepFraction` 0.2; with dashpots half',
                 'steps above sqrt(m/k) of all bonds of a particle are refused',
                 ['DemBonded.StandsTheLargestStep'], 'one',
                 'that 1.01 of the chain\'s limit fails'),
        Boundary('Energy of impacts', 'a granular gas heats up',
                 [('change of energy at 0.2 sqrt(m/k)',
                   *dem('drift', 'gas, linear',
                        'largest change of energy at dt / sqrt(m/k) = 0.20'), None),
                  ('at 0.5', *dem('drift', 'gas, linear',
                                  'largest change of energy at dt / sqrt(m/k) = 0.50'), None)],
                 '`stepFraction` 0.02 to 0.1 for elastic bodies', 'as above',
                 ['ContactLaws.ElasticObliqueImpactsNeverGainEnergy', 'DemMany.MomentumAndEnergy',
                  'LawCards.ImpactsGainNoEnergy'], 'one', 'that energy changes at 0.5'),
        Boundary('One-step spring', 'a heap creeps downhill for ever, faster with shorter steps',
                 [('speed / (g sqrt(m/k)) at dt 0.2',
                   *dem('creep', 'one-step spring, 10 degrees',
                        'speed / (g sqrt(m/k)) at dt / sqrt(m/k) = 0.20'), None),
                  ('at 0.01', *dem('creep', 'one-step spring, 10 degrees',
                                   'speed / (g sqrt(m/k)) at dt / sqrt(m/k) = 0.01'), None)],
                 '`tangential history`, the default', 'none',
                 ['DemImpact.OneStepSpringCreeps', 'ContactLaws.OneStepSpring'], 'both'),
        Boundary('Stiffness against impact', 'the gap is used up and bodies overlap',
                 [('speed / (2 dx/sqrt(theta dx/g)), wall',
                   *dem('cellSpring', 'body and wall',
                        'speed that uses up the gap / (2 dx/sqrt(theta dx/g))'), None),
                  ('two bodies', *dem('cellSpring', 'two bodies', 'speed that uses up the gap / (2 '
                                                                  'dx/sqrt(theta dx/g))'), None)],
                 'a smaller theta, a wider gap', 'the start names the speed that uses up the gap',
                 ['StabilityOfSolids.SpeedThatUsesUpAGap', 'DemWalls.SoftBodiesStayOnTheirSide'],
                 'both'),
        Boundary('Local damping in flight', 'bodies fall too slowly and rise against more than g',
                 [('falling, alpha 0.5: a/g',
                   *dem('localDamping', 'falling', 'acceleration / g, alpha = 0.5'), None),
                  ('rising', *dem('localDamping', 'rising', 'acceleration / g, alpha = 0.5'),
                   None)],
                 '`dampingRatio` of bonds, restitution of contacts', 'none',
                 ['StabilityOfSolids.LocalDampingInFlight'], 'both'),
    ],
    'coupling': [
        Boundary('Light bodies, `held`', 'a rigid body swings up against the water',
                 [('density ratio, pressureGradient',
                   *coupled('density', 'pressureGradient', 'held', 'rigid'), None),
                  ('extrapolated', *coupled('density', 'extrapolated', 'held', 'rigid'), None)],
                 '`fluidForce impulse`, the default without local damping', '`speedRatio`',
                 ['StabilityLimits.HeldForcesThrowLightBodies'], 'both'),
        Boundary('Light bodies, `interpolated`', 'the same',
                 [('density ratio, pressureGradient',
                   *coupled('density', 'pressureGradient', 'interpolated', 'rigid'), None),
                  ('extrapolated', *coupled('density', 'extrapolated', 'interpolated', 'rigid'),
                   None)],
                 '`fluidForce impulse`', '`speedRatio`',
                 ['StabilityLimits.HeldForcesThrowLightBodies'], 'both'),
        Boundary('Light bodies, `impulse`', 'none seen down to the least ratio tried',
                 [('density ratio, pressureGradient',
                   *coupled('density', 'pressureGradient', 'impulse', 'rigid'), None),
                  ('extrapolated', *coupled('density', 'extrapolated', 'impulse', 'rigid'), None)],
                 '-', '-', ['Coupling.LightBodiesAreStable'], 'one', 'where it fails'),
        Boundary('Undamped bonds', 'the body rings louder and louder',
                 [('density ratio, held', *coupled('density', 'pressureGradient', 'held', 'bonded'),
                   None),
                  ('impulse', *coupled('density', 'pressureGradient', 'impulse', 'bonded'), None),
                  ('impulse, extrapolated',
                   *coupled('density', 'extrapolated', 'impulse', 'bonded'), None)],
                 '`dampingRatio` 0.02 to 0.1', '`speedRatio`', ['Coupling.EnergyIsKept'], 'one',
                 'a bonded body at 0.05'),
        Boundary('Step with a light body', 'as without a body, sooner',
                 [('c0 dt/h, ratio 0.3, impulse',
                   *coupled('step', 'extrapolated', 'impulse', 'rigid', '0.3'), None),
                  ('held, extrapolated', *coupled('step', 'extrapolated', 'held', 'rigid', '0.3'),
                   None)],
                 '`acousticCourant` 0.5', '`speedRatio`', [], 'none', 'c0 dt/h of 1.3 and 1.6'),
    ],
    'pic': [
        Boundary('Step', 'none seen up to the largest that is taken',
                 [('Courant number, flip', *pic('step', 'flip, RungeKutta3', '3',
                                                'largest Courant number, vortices'), None),
                  ('apic', *pic('step', 'apic, RungeKutta3', '3',
                                'largest Courant number, vortices'), None)],
                 '`maxCo` 0.5', '`guards/Courant` 5 stops the run', ['dryRun.sh'], 'one',
                 'vortices at 2 keep their energy'),
        Boundary('FLIP noise', 'velocities of neighbours differ',
                 [('noise, flip', *pic('particles', 'flip', '4', 'noise'), None),
                  ('flip without gradients', *pic('particles', 'flip, no gradients', '4', 'noise'),
                   None),
                  ('flipPic, 5 % PIC', *pic('blend', 'flipPic', '0.05', 'noise'), None)],
                 '`affine yes`, the default; `flipPic`', 'none', [], 'none',
                 'noise with and without gradients'),
        Boundary('Tolerance of p', 'water loses or gains volume, then the wave',
                 [('volume put right, 1e-2', *pic('tolerance', 'flip', '0.01', 'volume put right'),
                   None),
                  ('1e-4', *pic('tolerance', 'flip', '0.0001', 'volume put right'), None)],
                 '`tolerance 1e-8` or less', '`guards/Courant`', [], 'none',
                 'volume kept at 1e-4, lost at 1e-1'),
        Boundary('Flat bottoms, levels in a cell', 'a pool that should rest moves',
                 [('speed [m/s], surface at 0.5 cells',
                   *pic('levels', 'surface', '0.5', 'largest speed'), None),
                  ('floor at 0.001 cells', *pic('levels', 'floor', '0.001', 'largest speed'),
                   None)],
                 '-', '-',
                 ['PicFlow.APoolStaysAtRest', 'PicInsideScene.WaterRestsOnAnObliqueFloor'], 'free'),
        Boundary('Viscous steps', 'none: implicit beyond the explicit limit',
                 [], 'the default `automatic`', '-', ['PicFlow.ImplicitViscosityIsStable'], 'free'),
    ],
    'picDem': [
        Boundary('Density, `weak`',
                 'a body is blown out of the water within 60 steps, however short they are',
                 [('density ratio, steps of 0.025 sqrt(h/g)',
                   *picDem('density', 'weak', '0.025', density), None),
                  ('0.2 sqrt(h/g)', *picDem('density', 'weak', '0.2', density), None)],
                 '`coupling implicit`, the default', '`guards/Courant`',
                 ['PicSolidScene.HoldsAtAnyDensityWhereWeakCouplingDoesNot'], 'both'),
        Boundary('Density, `implicit`', 'none seen but with long steps',
                 [('density ratio, 0.1 sqrt(h/g)', *picDem('density', 'implicit', '0.1', density),
                   None),
                  ('0.2 sqrt(h/g)', *picDem('density', 'implicit', '0.2', density), None)],
                 '`maxCo` 0.5', '`guards/Courant`',
                 ['PicSolidScene.HoldsAtAnyDensityWhereWeakCouplingDoesNot'], 'one',
                 'a ratio of 0.001 with steps of 0.2'),
        Boundary('Light bodies half out of water', 'they are thrown up',
                 [('disk', *picDem('shapes', 'disk, reflection', '5', floats), None),
                  ('square on its edge',
                   *picDem('shapes', 'square on its edge, reflection', '5', floats), None)],
                 'heavier bodies, or `reflection no`', '`guards/Courant`',
                 ['PicSolidScene.LightOnesThatHitReflectingWaterBringNoEnergy'], 'one',
                 'a disk of 0.01 and 0.03, half out'),
        Boundary('Step', 'bodies fall faster than freely',
                 [('dt/sqrt(h/g), ratio 0.01', *picDem(
                     'step', 'implicit', '0.01', 'largest step over sqrt(h/g), 4 sqrt(h/g)'), None),
                  ('2.7', *picDem('step', 'implicit', '2.7',
                                  'largest step over sqrt(h/g), 4 sqrt(h/g)'), None)],
                 '`maxCo` 0.5', '`guards/Courant`', [], 'none', 'steps of 1 and 1.5'),
        Boundary('Fast impacts in a gap', 'bodies overlap',
                 [('speed [m/s], theta 0.01',
                   *picDem('speed', 'implicit', '0.01',
                           'largest speed of an impact that stays in the gap [m/s]'),
                   'half of it: springs alone'),
                  ('theta 0.1', *picDem('speed', 'implicit', '0.1',
                                        'largest speed of an impact that stays in the gap [m/s]'),
                   'half of it')],
                 'a smaller theta', 'the start names the speed', [], 'none',
                 'an impact at 20 and 21 m/s'),
        Boundary('Thin gaps', 'a disk goes through its gap to the floor',
                 [('speed [m/s], gap of 1 cell', *picDem('thin', 'disk and floor', '1', thin),
                   'half of it: springs alone'),
                  ('0.1 cells', *picDem('thin', 'disk and floor', '0.1', thin), 'half of it')],
                 'a wider gap', 'none', [], 'none',
                 'an impact below and above, with a gap of a cell'),
        Boundary('Few cells across', 'the first acceleration is wrong',
                 [('error, ratio 2.7, 4 cells',
                   *picDem('size', 'start, density ratio 2.7', '4', firstAcceleration), None),
                  ('2 cells', *picDem('size', 'start, density ratio 2.7', '2', firstAcceleration),
                   None),
                  ('ratio 0.01, 4 cells',
                   *picDem('size', 'start, density ratio 0.01', '4', firstAcceleration), None)],
                 'ten cells across', 'fewer than four are refused', ['picSolids.sh'], 'both'),
        Boundary('Steps of the solids', 'elastic disks part faster than they came',
                 [('dt/sqrt(m/k), theta 0.001, 1 m/s',
                   *picDem('subcycles', 'overlap at rest 0.001 cells', '1', parts),
                   '1.41: springs alone'),
                  ('theta 0.0001', *picDem('subcycles', 'overlap at rest 0.0001 cells', '1', parts),
                   '1.41')],
                 '`stepFraction` 0.2', 'steps above 0.5 sqrt(m/k) are refused',
                 ['DemPlan.LimitsOfSprings'], 'one', 'elastic disks in water at 1 and 2'),
    ],
}


def fill(text):
    """The page with its generated parts made anew: a table an area, and the list of missing
    tests"""
    parts = {name: table(boundaries) for name, boundaries in areas.items()}
    parts['missing'] = missing()
    found = set(re.findall(r'<!-- generated (\w+)', text))
    if found != set(parts):
        raise ValueError(
            f'docs/stability.md: generated parts are {sorted(found)}, wanted {sorted(parts)}')
    return re.sub(r'(<!-- generated (\w+)[^>]*-->).*?<!-- end -->',
                  lambda m: f'{m.group(1)}\n\n{parts[m.group(2)]}\n\n<!-- end -->', text,
                  flags=re.S)


def table(boundaries):
    lines = ['| mode | what is seen | boundary | measured | theory | remedy | guard | tests |',
             '| --- | --- | --- | --- | --- | --- | --- | --- |']
    known = tests()
    for b in boundaries:
        for test in b.tests:
            if test not in known:
                raise ValueError(f'stability, {b.mode}: there is no test {test}')
        held = ', '.join(f'`{t}`' for t in b.tests) or '**missing**'
        sides = ' (one side)' if b.sides == 'one' else ''
        figures = ([(what, *figure(file, where), given) for what, file, where, given in b.rows]
                   or [('-', '-', '-', None)])
        for i, (what, measured, theory, given) in enumerate(figures):
            about = [b.remedy, b.guard, held + sides] if i == 0 else ['', '', '']
            lines.append(f"| {b.mode if i == 0 else ''} | {b.seen if i == 0 else ''} | {what} | "
                         f"{measured} | {given or theory} | {' | '.join(about)} |")
    return '\n'.join(lines)


def missing():
    lines = []
    for name, boundaries in areas.items():
        for b in boundaries:
            if b.sides in ('one', 'none'):
                lines.append(
                    f"- {names[name]}, {b.mode}: {'no test' if b.sides == 'none' else 'one side'}; "
                    f"wanted: {b.missing}.")
    held = sum(b.sides in ('both', 'free') for bs in areas.values() for b in bs)
    return (f'{held} of {sum(map(len, areas.values()))} boundaries have tests from both sides, '
            'or tests that there is none. The others:\n\n' + '\n'.join(lines))


names = {'sph': 'SPH', 'dem': 'Solids', 'coupling': 'Solids in SPH water',
         'pic': 'Particles in cells', 'picDem': 'Solids in PIC water'}


def figure(file, where):
    """Measured and theory, as text, of the one row"""
    with open(os.path.join(root, 'benchmarks', 'results', file + '.csv'), newline='') as f:
        found = [r for r in csv.DictReader(f) if all(r[k] == v for k, v in where.items())]
    if len(found) != 1:
        raise ValueError(f'stability: {len(found)} rows of {file}.csv are {where}')
    return (_shown(found[0]['measured'], found[0].get('quantity', '')),
            _shown(found[0].get('theory') or '', '') or '-')


def _shown(text, quantity):
    try:
        x = float(text)
    except ValueError:
        return text
    if x != x:
        return '-'
    limit = re.search(r'\(([\d.]+): none found\)', quantity)
    sign = ('< ' if 'least' in quantity else '> ') if limit and x == float(limit.group(1)) else ''
    # the least that is tried
    sign = '< ' if quantity == 'least density ratio' and x == 0.05 else sign
    return sign + f'{x:.3g}'


def tests():
    """Names suite.name of the unit tests, and files of tests/regression"""
    found = set(os.listdir(os.path.join(root, 'tests', 'regression')))
    for folder in ('unit', 'unitFoam'):
        for name in glob.glob(os.path.join(root, 'tests', folder, '**', '*.C'), recursive=True):
            with open(name) as f:
                found |= {f'{suite}.{test}' for suite, test in re.findall(
                    r'^TEST(?:_P|_F)?\((\w+), *(\w+)\)', f.read(), re.M)}
    return found
