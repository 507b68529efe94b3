# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break with an elastic gate: the gate's end against two digitisations of the experiment"""
import os

import numpy as np

from gateModel import impliedModulus, levelFrom
from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import entry, numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
digitisations = ('chrono', 'pysph')
face, thickness = 0.1, 5e-3             # of the gate, where the water meets it
# of the experiment, mean of the two digitisations
peakX, peakTimeX, peakY = 0.0462, 0.161, 0.0171


def reference(name):
    return np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1,
                      unpack=True)


def end(run):
    """Time, and how far the gate's end has moved outwards and up: mean of its lowest row [m]"""
    table = run.table('end', 'particleDisplacement.dat')
    mean = [np.mean([table[c] for c in table if c.endswith(axis)], axis=0) for axis in ('Dx', 'Dy')]
    return table['Time'], mean[0], mean[1]


def peak(t, u, until=0.25):
    """Value and time of the largest displacement of the opening phase"""
    early = t <= until
    k = np.argmax(u[early])
    return u[early][k], t[early][k]


def closing(t, u, axis):
    """rms difference from the experiment after its peak, over its peak"""
    if t[-1] < 0.39:
        return None
    differences = []
    for which in digitisations:
        when, value = reference(f'exp_gate_end_{axis}_{which}')
        late = (when > peakTimeX) & (when <= t[-1])
        differences.append(np.interp(when[late], t, u) - value[late])
    d = np.concatenate(differences)
    return float(np.sqrt(np.mean(d**2))/(peakX if axis == 'x' else peakY))


def noise(t, u):
    """rms of what a parabola through each 40 ms does not follow, over the peak"""
    rest = []
    for begin in np.arange(0.02, t[-1] - 0.039, 0.04):
        part = (t >= begin) & (t < begin + 0.04)
        if part.sum() > 5:
            rest.append(u[part]
                        - np.polyval(np.polyfit(t[part] - begin, u[part], 2), t[part] - begin))
    return float(np.sqrt(np.mean(np.concatenate(rest)**2))/abs(u).max()) if rest else None


def closingModulus(t, x, level):
    """E of the gate at rest that is where the gate is in the closing phase, from 0.24 s on, under
    the level 5 cm behind it"""
    if t[-1] < 0.39:
        return None
    return float(np.mean([impliedModulus(np.interp(when, t, x), np.interp(when, t, level))
                          for when in np.arange(0.24, 0.381, 0.02)]))


def bendingModulus(run):
    return numberOf(entry(run.solid, 'bonds/rubber/E'))


def published(file, discharge):
    """E that a published closing phase shows, and the level at 0.36 s that goes with its opening:
    {axis} in file stands for x and y"""
    curves = []
    for axis in 'xy':
        t, u = reference(file.format(axis=axis))
        late = t > 0.01
        curves.append((np.concatenate([[0], t[late]]), np.concatenate([[0], u[late]])))
    t = np.linspace(0, 0.36, 181)
    x, y = (np.interp(t, *curve) for curve in curves)
    level = levelFrom(t, x, y, 2.5e-4, discharge)
    return np.mean([impliedModulus(np.interp(w, t, x), np.interp(w, t, level))
                    for w in (0.24, 0.28, 0.32, 0.36)]), level[-1]


def softness(runs):
    """Undamped gates that differ in E alone: E [MPa] rising, and their ends' x over time"""
    return sorted((1e-6*bendingModulus(runs[name]), *end(runs[name])[:2]) for name in scale
                  if name in runs)


def modulusThen(gates, t, x, when):
    """E of the gate that is where a curve is at that time; not a number beyond those that were
    run"""
    there = [np.interp(when, *gate[1:]) for gate in gates]
    return float(1/np.interp(np.interp(when, t, x), there[::-1],
                             [1/gate[0] for gate in gates[::-1]], left=np.nan, right=np.nan))


def analyse(run):
    t, x, y = end(run)
    level = run.table('level', 'waterLevel.dat')
    bestX, timeX = peak(t, x)
    bestY, timeY = peak(t, y)
    q = [Quantity('largest x of the end [mm]', 1e3*bestX, 1e3*peakX, abs(bestX/peakX - 1)),
         Quantity('its time [s]', timeX, peakTimeX, abs(timeX/peakTimeX - 1)),
         Quantity('largest y of the end [mm]', 1e3*bestY, 1e3*peakY, abs(bestY/peakY - 1)),
         Quantity('its time, y [s]', timeY, peakTimeX, abs(timeY/peakTimeX - 1)),
         Quantity('noise of x', computed=noise(t, x))]
    for axis, u in (('x', x), ('y', y)):
        q.append(Quantity(f'closing phase, rms of {axis} / peak', error=closing(t, u, axis)))
    modulus, own = closingModulus(t, x, level['level1']), bendingModulus(run)
    if modulus is not None:
        q.append(Quantity('E that the closing phase shows [MPa]', 1e-6*modulus, 1e-6*own,
                          abs(modulus/own - 1)))
    for k, where in ((0, '5 mm behind the gate'), (1, '5 cm behind')):
        q.append(Quantity(f'water level {where} at the end [mm]',
                          computed=1e3*level[f'level{k}'][-1]))
    return q


def drawExperiment(axis, which):
    for name, marker in zip(digitisations, 'os'):
        t, u = reference(f'exp_gate_end_{which}_{name}')
        axis.plot(t, 1e3*u, marker, color='k', markersize=3, fillstyle='none',
                  label=f'experiment ({name})')
    t, u = reference(f'sph_antoci_gate_end_{which}_chrono')
    axis.plot(t, 1e3*u, '--', color='#888888', linewidth=0.8, label='SPH, Antoci et al. 2007')


def others():
    """Curves of other authors: name, t, x"""
    for name, file in (('ISPH, Khayyer et al. 2018', 'isph_khayyer2018_gate_end_x'),
                       ('SPH-VCPM, Ng et al. 2020', 'sphvcpm_ng2020_gate_end_x'),
                       ('SPH-FEM, Yang et al. 2012', 'sphfem_yang2012_gate_end_x_chrono'),
                       ('SPH, Antoci et al. 2007', 'sph_antoci_gate_end_x_chrono')):
        yield (name, *reference(file))


def plotSensitivity(runs, path):
    """Each change from attempt 3: how far, when, and where the gate is at 0.36 s"""
    rows = []
    for kind, variants in sensitivity.items():
        rows += [(f'{kind}: {v.name}', *end(runs[v.name])[:2], plotting.colours[k]) for k, v in
                 ((list(sensitivity).index(kind), v) for v in variants) if v.name in runs]
    rows += [(name, *end(runs[name])[:2], 'k') for name in mainVariants if name in runs]
    rows += [(name, t, x, '#888888') for name, t, x in others()]
    rows += [('experiment',
              *np.mean([[t, x] for t, x in (reference('exp_gate_end_x_chrono')[:, -9:],
                                            reference('exp_gate_end_x_pysph'))], axis=0), 'r')]
    base = end(runs[mainVariants[0]])
    fig, axes = plotting.figure(3, width=3.2, height=0.17*len(rows) + 1)
    for column, (measure, label) in enumerate(((lambda t, x: 1e3*peak(t, x)[0], 'largest x [mm]'),
                                               (lambda t, x: peak(t, x)[1], 'its time [s]'),
                                               (lambda t, x: 1e3*np.interp(0.36, t, x)
                                                if t[-1] > 0.35 else np.nan, 'x at 0.36 s [mm]'))):
        axis = axes[column]
        for k, (name, t, x, colour) in enumerate(rows):
            axis.plot(measure(t, x), -k, 'o', color=colour, markersize=3.5)
        axis.axvline(measure(*base[:2]), color='k', linewidth=0.7)
        axis.axvline(measure(*rows[-1][1:3]), color='r', linewidth=0.7, linestyle='--')
        axis.locator_params(axis='x', nbins=5)
        axis.set(xlabel=label, yticks=-np.arange(len(rows)), ylim=(-len(rows) + 0.5, 0.5))
        axis.set_yticklabels([r[0] for r in rows] if column == 0 else [], fontsize=6)
    plotting.save(fig, path)


def plotModulus(runs, path):
    """Which constant E would have brought the gate where it is: of a gate that has one, a level
    line"""
    gates = softness(runs)
    fig, (axis,) = plotting.figure(1, width=5.5, height=3.4)
    when = np.arange(0.08, 0.3601, 0.01)
    curves = [(f'experiment ({which})', *reference(f'exp_gate_end_x_{which}'), 'k', marker)
              for which, marker in zip(digitisations, 'os')]
    curves += [(name, t, x, plotting.colours[k], None) for k, (name, t, x) in enumerate(others())]
    curves += [
        (f'{name}, E = {1e-6*bendingModulus(runs[name]):g} MPa', *end(runs[name])[:2], colour, None)
        for name, colour in (('extrapolated-undamped', '#bbbbbb'), ('fine-undamped', '#888888'),
                             ('pressureGradient', 'r'), ('drag-100', 'm')) if name in runs]
    for name, t, x, colour, marker in curves:
        at = t[(t > 0.07) & (t < 0.37)] if marker else when[when <= t[-1]]
        axis.plot(at, [modulusThen(gates, t, x, w) for w in at], color=colour, marker=marker,
                  linewidth=0.9, markersize=4, fillstyle='none', label=name)
    axis.set(xlabel='t [s]', ylabel='E of the undamped gate there [MPa]', ylim=(3, 19))
    plotting.named(axis)
    plotting.save(fig, path)


def plotTimes(run, path):
    """Water and gate every 0.04 s, as the paper's Table 6"""
    times = [t for t in clouds.times(run.path) if float(t) > 0]
    fig, axes = plotting.figure(5, -(-len(times)//5), width=2.0, height=1.7)
    for axis in axes[len(times):]:
        axis.set_visible(False)
    for axis, when in zip(axes, times):
        f, s = (clouds.readCloud(run.path, when, ('U',)),
                clouds.readCloud(run.path, when, ('radius',), 'solids'))
        dots = axis.scatter(1e3*f['positions'][:, 0], 1e3*f['positions'][:, 1],
                            c=np.linalg.norm(f['U'], axis=1), s=0.3, vmin=0, vmax=1.6)
        axis.scatter(1e3*s['positions'][:, 0], 1e3*s['positions'][:, 1], s=0.3, color='k')
        axis.set(aspect='equal', xlim=(-5, 200), ylim=(-5, 150))
        axis.set_title(f'{float(when):g} s', fontsize=7)
        axis.tick_params(labelsize=5)
    fig.colorbar(dots, ax=list(axes), label='|U| [m/s]')
    plotting.save(fig, path)


def plot(runs, path):
    byName = {r.name: r for r in runs}
    if 'pressureGradient' in byName and len(clouds.times(byName['pressureGradient'].path)) > 5:
        plotTimes(byName['pressureGradient'], path.replace('.png', 'Times.png'))
    if len(byName) > len(mainVariants):
        plotSensitivity(byName, path.replace('.png', 'Sensitivity.png'))
    if all(name in byName for name in scale):
        plotModulus(byName, path.replace('.png', 'Modulus.png'))
    runs = [r for r in runs if r.name in mainVariants] or runs
    fig, axes = plotting.figure(2, 2, width=5.5, height=3.4)
    for k, which in enumerate('xy'):
        drawExperiment(axes[k], which)
        for run in runs:
            t, x, y = end(run)
            axes[k].plot(t, 1e3*(x if which == 'x' else y), linewidth=0.9, label=run.name)
        axes[k].set(xlabel='t [s]', ylabel=f'{which} of the end [mm]')
        plotting.named(axes[k])
    for run in runs:
        level = run.table('level', 'waterLevel.dat')
        near, = axes[2].plot(level['Time'], 1e3*level['level0'], linewidth=0.8)
        axes[2].plot(level['Time'], 1e3*level['level1'], linewidth=0.8, linestyle=':',
                     color=near.get_color())
    axes[2].set(xlabel='t [s]', ylabel='water level [mm]; dotted: 5 cm behind')
    run = runs[0]
    times = clouds.times(run.path)
    when = min(times, key=lambda t: abs(float(t) - 0.16))
    f, s = (clouds.readCloud(run.path, when, ('U',)),
            clouds.readCloud(run.path, when, ('radius',), 'solids'))
    dots = axes[3].scatter(1e3*f['positions'][:, 0], 1e3*f['positions'][:, 1],
                           c=np.linalg.norm(f['U'], axis=1), s=0.8)
    axes[3].scatter(1e3*s['positions'][:, 0], 1e3*s['positions'][:, 1], s=0.8, color='k')
    fig.colorbar(dots, ax=axes[3], label='|U| [m/s]')
    axes[3].set(aspect='equal', xlim=(-5, 260), ylim=(-5, 150), xlabel='x [mm]',
                title=f'{run.name}, {float(when):g} s')
    plotting.save(fig, path)


solid, control, gate = 'constant/solidProperties:', 'system/controlDict:', 'system/gate:'


def rubber(E, nu, plane=False):
    """Bending stiffness E e^3/12 as a beam, or E/(1 - nu^2) of plane strain"""
    return (f'{solid}bonds/rubber/E {E/(1 - nu**2) if plane else E:.8g}; '
            f'{solid}bonds/rubber/G {E/(1 + nu):.8g}')


def damped(alpha):
    return f'{solid}groups/gate/localDamping {alpha}; {solid}groups/sides/localDamping {alpha}'


held = f'{solid}groups/sides/fixed all'
attempt1 = f'coupling stationary; {rubber(12e6, 0.33)}; {damped(0.157)}; {held}'
attempt2 = (f'coupling stationary; {rubber(12e6, 0.33)}; {damped(0.0134)}; {held}; viscosity none; '
            'XSPH none')


def sized(size, foot, fluid):
    """Another spacing of the gate's particles, height of its lower end and spacing of the fluid
    [m]; the walls' with the gate's"""
    columns = round(thickness/size)
    lowest = ' '.join(f'({face + (k + 0.5)*size:.9g} {foot + 0.5*size:.9g} 0)'
                      for k in range(columns))
    numbers = {'size': size, 'radius': size/2, 'gap': 1e-3*size, 'gateFoot': foot, 'spacing': fluid,
               'thickness': size}
    return '; '.join([f'{gate}{k} {v:.9g}' for k, v in numbers.items()]
                     + [f'walls/spacing {size:.9g}', f'{control}functions/end/points ({lowest})'])


def variant(name, sets='', **more):
    return Variant(name, ['-set', sets] if sets else [], **more)


mainVariants = ('pressureGradient', 'stationary', 'pressureApproximation', 'extrapolated',
                'attempt1', 'attempt2')
undamped = f'{damped(0)}; couplingCoeffs/fluidForce impulse'
# undamped gates that differ in E alone
scale = ('E-4MPa-undamped', 'E-6MPa-undamped', 'E-7.8MPa-undamped', 'undamped', 'E-12MPa-undamped',
         'E-15MPa-undamped')
# What is changed from attempt 3 with pressureGradient, by kind; the chart's bars
sensitivity = {
    'gate': [*(variant(f'E-{e}MPa', rubber(e*1e6, 0.4)) for e in (6, 7.8)),
             variant('E-12MPa', rubber(12e6, 0.4)), variant('planeStrain', rubber(10e6, 0.4, True)),
             *(variant(f'E-{e}MPa-undamped', f'{rubber(e*1e6, 0.4)}; {undamped}')
               for e in (4, 6, 7.8, 12, 15)),
             variant('allHeld', held)],
    'damping': [variant('undamped', undamped),
                variant('undamped-held', f'{damped(0)}; couplingCoeffs/fluidForce held'),
                variant('damping-0.0134', damped(0.0134)),
                variant('bondDamping-0.1', f'{damped(0)}; {solid}bonds/rubber/dampingRatio 0.1'),
                *(variant(f'{c}-undamped', f'coupling {c}; {undamped}')
                  for c in ('stationary', 'pressureApproximation', 'extrapolated')),
                # a soft gate that something holds back: force on each particle, -c m v
                *(variant(f'drag-{c}',
                          f'{rubber(4.4e6, 0.4)}; {undamped}; {solid}groups/gate/viscousDamping '
                          f'{c}; {solid}groups/sides/viscousDamping {c}') for c in (100, 200))],
    'clearance': [variant('foot-1.5mm', sized(1.25e-3, 1.5e-3, 1.75e-3)),
                  variant('foot-2.75mm', sized(1.25e-3, 2.75e-3, 1.75e-3))],
    'water': [variant('inviscid', 'viscosity none; XSPH none; walls/slip freeSlip'),
              variant('XSPH-0.5', 'XSPH 0.5'),
              variant('alpha-0.05', 'artificialViscosity/alpha 0.05'),
              variant('wet-frictionless', 'couplingCoeffs/viscosity no'),
              variant('sound-20', 'soundSpeedRatio 20'),
              variant('wallsStationary', 'walls/model stationary')],
    'resolution': [variant('water-3.33mm', f'{gate}spacing 0.003333333333'),
                   variant('gate-0.625mm', sized(6.25e-4, 2.5e-4, 1.75e-3)),
                   variant('gate-0.625mm-undamped',
                           f'{sized(6.25e-4, 2.5e-4, 1.75e-3)}; {undamped}'),
                   variant('fine', sized(6.25e-4, 2.5e-4, 8.75e-4)),
                   variant('fine-undamped', f'{sized(6.25e-4, 2.5e-4, 8.75e-4)}; {undamped}')],
    'numerics': [variant('double', 'precision double'),
                 variant('solidStep-0.2', f'{solid}stepFraction 0.2'),
                 variant('solidStep-0.9-undamped', f'{undamped}; {solid}stepFraction 0.9'),
                 variant('gpu', 'device gpu', large=True)],
    # the model of the authors in reference/: E = 12 MPa, nu = 0.4 in plane strain, held, nothing
    # damped
    'others': [variant('others', f'{rubber(12e6, 0.4, True)}; {held}; {undamped}'),
               variant('others-beam', f'{rubber(12e6, 0.4)}; {held}; {undamped}')],
}


def compare(runs, results):
    """What published curves say of their gates: the level from their opening, with the discharge
    coefficient that gives the level here"""
    if 'pressureGradient' not in runs:
        return []
    t, x, y = end(runs['pressureGradient'])
    level = runs['pressureGradient'].table('level', 'waterLevel.dat')['level1']
    if t[-1] < 0.37:
        return []
    tried = np.linspace(0.6, 1.2, 61)
    discharge = tried[np.argmin([abs(np.interp(0.36, t, levelFrom(t, x, y, 2.5e-4, d))
                                     - np.interp(0.36, t, level)) for d in tried])]
    q = [Quantity('discharge coefficient of the opening', computed=float(discharge))]
    for name, file in (('experiment', 'exp_gate_end_{axis}_chrono'),
                       ('experiment (2)', 'exp_gate_end_{axis}_pysph'),
                       ('Khayyer et al.', 'isph_khayyer2018_gate_end_{axis}'),
                       ('Ng et al.', 'sphvcpm_ng2020_gate_end_{axis}'),
                       ('Yang et al.', 'sphfem_yang2012_gate_end_{axis}_chrono'),
                       ('Antoci et al., SPH', 'sph_antoci_gate_end_{axis}_chrono')):
        young, height = published(file, discharge)
        q += [Quantity(f'{name}: E that the closing phase shows [MPa]', computed=1e-6*float(young)),
              Quantity(f'{name}: level with it at 0.36 s [mm]', computed=1e3*float(height))]
    if all(name in runs for name in scale):
        curves = [('experiment', *reference('exp_gate_end_x_chrono')),
                  ('experiment (2)', *reference('exp_gate_end_x_pysph')), *others()]
        curves += [(name, *end(runs[name])[:2])
                   for name in ('extrapolated-undamped', 'fine-undamped', 'pressureGradient',
                                'drag-100', 'drag-200') if name in runs]
        q += [Quantity(f'{name}: E of a gate that is there at {when:g} s [MPa]',
                       computed=modulusThen(softness(runs), t, x, when)) for name, t, x in curves
              for when in (0.08, 0.12, 0.16, 0.2, 0.24, 0.36)]
    return q


Study(
    scene='elasticGate',
    variants=[variant('pressureGradient'),
              variant('stationary', 'coupling stationary'),
              variant('pressureApproximation', 'coupling pressureApproximation'),
              variant('extrapolated', 'coupling extrapolated'),
              variant('attempt1', attempt1),
              variant('attempt2', attempt2),
              *(v for kind in sensitivity.values() for v in kind)],
    quick=[Variant('quick', ['-endTime', '0.1'])],
    analyse=analyse,
    plot=plot,
    compare=compare,
    # coupling, damping, resolution, precision, steps, device; what the gate is and how it is held
    # is another chart
    recorded=['quick', 'pressureGradient', 'stationary', 'pressureApproximation', 'extrapolated',
              *(v.name for kind in ('damping', 'resolution', 'numerics') for v in sensitivity[kind]
                if not v.name.startswith(('bond', 'damping', 'drag')))],
    headline='largest x of the end [mm]',
).main(here)
