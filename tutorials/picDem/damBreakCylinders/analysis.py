# SPDX-License-Identifier: GPL-3.0-or-later
"""A column of water with layers of cylinders in it collapses: who arrives when, and does anything
overlap"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
radius = 0.005
shown = [0.1, 0.2, 0.3, 0.5]


def tank(run, entry):
    return numberOf(run.dictionary('system/tank')[entry])


def cylinders(run):
    """Times and positions of all cylinders"""
    names = clouds.times(run.path)
    return [float(n) for n in names], [
        clouds.readCloud(run.path, n, ('radius',), 'solids')['positions'][:, :2] for n in names]


def closest(x):
    """Smallest distance of two surfaces"""
    d = np.hypot(*(x[:, None, :] - x[None, :, :]).transpose(2, 0, 1)) - 2*radius
    return d[np.triu_indices(len(x), 1)].min()


def arrival(run):
    """The first sample at which a cylinder touches the far wall, from when it could begin to move;
    nan: not yet"""
    motion = run.table('stack', 'groupMotion.dat')
    # of their surfaces
    there = motion['freeMaxX'] >= (tank(run, 'tank') - tank(run, 'gap'))*(1 - 1e-3)
    return float(motion['Time'][np.argmax(there)]) - lift(run)[1] if there.any() else float('nan')


def lift(run):
    """Speed of the plate, how long it stands; 0, 0: there is none"""
    speed = numberOf(run.dictionary('system/tank').get('lift'), 0)
    return speed, tank(run, 'held') if speed else 0.0


def bottom(run, t):
    """Of the plate, as system/makeParticles.py lifts it"""
    speed, held = lift(run)
    starts, t = 0.02, max(t - held, 0)
    return speed*(0.5*t*t/starts if t < starts else t - 0.5*starts)


def inOrder(run, name, cloud, key):
    """Positions by the particles' own numbers"""
    c = clouds.readCloud(run.path, name, (key,), cloud)
    return c['positions'][np.argsort(c[key])]


def behindPlate(run):
    """Does it hold, and does anything pass through it: particles that cross its middle above its
    lower edge between two written times"""
    names = clouds.times(run.path)
    held, face, thickness = lift(run)[1], tank(run, 'waterWidth'), 0.002
    beyond, through, before, way = 0, 0, None, 0.0
    first = inOrder(run, names[0], 'solids', 'origId')
    for name in names[1:]:
        t, x = float(name), inOrder(run, name, 'fluid', 'id')
        edge = bottom(run, t) + tank(run, 'cellSize')
        if t <= held + 1e-9:
            beyond += int((x[:, 0] > face + thickness).sum())
            way = max(way,
                      np.hypot(*(inOrder(run, name, 'solids', 'origId') - first)[:, :2].T).max())
        if before is not None and len(before) == len(x):
            a, b = before[:, 0] - face - 0.5*thickness, x[:, 0] - face - 0.5*thickness
            through += int(((a*b < 0) & (np.minimum(before[:, 1], x[:, 1]) > edge)).sum())
        before = x
    return [Quantity('particles beyond the plate that stands', computed=beyond),
            Quantity('particles through the plate', computed=through),
            Quantity('way of a cylinder behind the plate / gap',
                     computed=float(way)/tank(run, 'gap'))]


def water(run, k):
    """Particles of the k-th written time; those of time 0 are what the run seeded its own by"""
    return len(clouds.readCloud(run.path, clouds.times(run.path)[k], ())['positions'])


def at(run, column, moment):
    """Of the samples, over the tank's length; nan: not yet"""
    motion = run.table('stack', 'groupMotion.dat')
    there = motion['Time'][-1] >= moment - 1e-9
    return (float(np.interp(moment, motion['Time'], motion[column])/tank(run, 'tank')) if there
            else float('nan'))


def analyse(run):
    times, x = cylinders(run)
    mean = x[-1].mean(axis=0)/tank(run, 'tank')
    held = lift(run)[1]
    result = [Quantity('end [s]', computed=round(times[-1] - held, 9)),
              Quantity('smallest distance of two surfaces / gap',
                       computed=min(closest(p) for p in x)/tank(run, 'gap')),
              Quantity('cylinders', computed=len(x[-1])),
              Quantity('water lost', computed=1 - water(run, -1)/water(run, 1)),
              Quantity('x/L of the centre of mass at 0.25 s',
                       computed=at(run, 'freeCentreX', 0.25)),
              Quantity('x/L of the foremost surface at 0.25 s', computed=at(run, 'freeMaxX', 0.25)),
              Quantity('x/L of the centre of mass at the end', computed=mean[0]),
              Quantity('y/L of the centre of mass at the end', computed=mean[1]),
              Quantity('x/L of the centre of mass 0.2 s after',
                       computed=float(np.interp(held + 0.2, *centre(run), right=np.nan))),
              Quantity('arrival at the far wall [s]', computed=arrival(run))]
    return result + behindPlate(run) if lift(run)[0] else result


def snapshot(axis, run, moment):
    name = clouds.nearestTime(run.path, moment)
    water = clouds.readCloud(run.path, name, ('U',))
    solids = clouds.readCloud(run.path, name, ('radius',), 'solids')
    speed = np.hypot(*water['U'][:, :2].T)
    axis.scatter(100*water['positions'][:, 0], 100*water['positions'][:, 1], c=speed, s=0.3,
                 cmap='Blues', vmin=-0.5, vmax=1.5)
    plotting.discs(axis, 100*solids['positions'], 100*solids['radius'])
    axis.set(xlim=(0, 100*tank(run, 'tank')), ylim=(0, 16), aspect='equal',
             title=f'{run.name}, {float(name):g} s')
    axis.grid(False)


def kind(run):
    """Runs of one line of the chart have the same beta, cells and gap"""
    return numberOf(run.pic['contactVelocity']), tank(run, 'cellSize'), tank(run, 'gap')


def layers(run):
    return int(run.name.split('-')[0])


def plain(run):
    """With the variant's usual step, and no plate"""
    return not any(word in run.name for word in ('-co', '-plate'))


def centre(run):
    motion = run.table('stack', 'groupMotion.dat')
    return motion['Time'], motion['freeCentreX']/tank(run, 'tank')


def plotArrivals(runs, path):
    """As the paper's Figure 10: arrival against layers; beside it the centre of all cylinders"""
    runs = [run for run in runs if plain(run)]
    runs = [run for run in runs
            if len({layers(other) for other in runs if kind(other) == kind(run)}) > 1]
    if not runs:
        return
    fig, (left, right) = plotting.figure(2, width=5, height=3.6)
    for beta, cell, gap in sorted({kind(run) for run in runs}):
        points = sorted((layers(run), arrival(run)) for run in runs
                        if kind(run) == (beta, cell, gap))
        left.plot(*zip(*points), 'o-',
                  label=f'beta {beta:g}, cells {1000*cell:g} mm, gap {1000*gap:g} mm')
    for run in runs:
        right.plot(*centre(run), '-' if kind(run)[0] < 1 else '--', linewidth=1,
                   color=f'C{layers(run)//2}', label=run.name)
    left.set(xlabel='layers', ylabel='first cylinder at the far wall [s]')
    left.margins(y=0.1)
    left.set_ylim(bottom=0)
    right.set(xlabel='t [s]', ylabel='centre of all cylinders, x/L')
    for axis in (left, right):
        plotting.named(axis)
    plotting.save(fig, path)


def plotResolution(runs, path):
    """Six layers by cells a diameter, with a gap of two cells, as in the paper, and with one of 1
    mm for all: centre against time, and its place and the arrival against cells"""
    six = [run for run in runs
           if layers(run) == 6 and plain(run) and numberOf(run.control['maxCo']) == 1]
    rows = [(beta, name,
             sorted((run for run in six if kind(run)[0] == beta and rule(*kind(run)[1:])),
                    key=lambda run: kind(run)[1])) for beta in sorted({kind(run)[0] for run in six})
            for name, rule in (('two cells', lambda cell, gap: abs(gap/cell - 2) < 1e-6),
                               ('1 mm', lambda cell, gap: abs(gap - 0.001) < 1e-9))]
    rows = [row for row in rows if len(row[2]) > 1]
    if not rows:
        return
    fig, axes = (plotting.figure(3, 2, width=4.2, height=3.2) if len(rows) == 4
                 else plotting.figure(len(rows) + 2, width=4, height=3.2))
    for axis, (beta, name, group) in zip(axes, rows):
        for run in group:
            axis.plot(*centre(run), linewidth=1,
                      label=f'{2*radius/kind(run)[1]:.0f} cells a diameter')
        axis.set(xlabel='t [s]', ylabel='centre of all cylinders, x/L',
                 title=f'beta {beta:g}, gap {name}', xlim=(0, 0.35), ylim=(0.1, 0.45))
        plotting.named(axis)
    for beta, name, group in rows:
        cells = [2*radius/kind(run)[1] for run in group]
        at = [(c, np.interp(0.2, *centre(run))) for c, run in zip(cells, group)
              if centre(run)[0][-1] >= 0.2 - 1e-9]
        style = dict(color=f'C{int(beta < 1)}', linestyle='-' if name == '1 mm' else '--',
                     marker='o', markersize=4, linewidth=1, label=f'beta {beta:g}, gap {name}')
        axes[-2].plot(*zip(*at), **style)
        axes[-1].plot(cells, [arrival(run) for run in group], **style)
    axes[-2].set(ylabel='centre of all cylinders at 0.2 s, x/L')
    axes[-1].set(ylabel='first cylinder at the far wall [s]', ylim=(0.2, 0.35))
    for axis in axes[-2:]:
        axis.set(xlabel='cells a diameter')
        plotting.named(axis)
    plotting.save(fig, path)


def plotPlate(runs, path):
    """Centre of all cylinders and the farthest one against the time since they could move;
    snapshots with the one at 1 m/s"""
    lifted = sorted((run for run in runs if lift(run)[0]), key=lambda run: lift(run)[0])
    if not lifted:
        return
    free = [run for run in runs if layers(run) == 6 and plain(run) and kind(run) == kind(lifted[0])]
    fig, axes = plotting.figure(2, 2, width=5, height=2.6)
    axes = np.atleast_1d(axes).ravel()
    for run in lifted + free:
        motion, (speed, held) = run.table('stack', 'groupMotion.dat'), lift(run)
        for axis, column in zip(axes, ('freeCentreX', 'freeMaxX')):
            axis.plot(motion['Time'] - held, motion[column]/tank(run, 'tank'), linewidth=1,
                      label=f'lifted at {speed:g} m/s' if speed else 'gone at once')
    for axis, name in zip(axes, ('centre of all cylinders', 'farthest surface of a cylinder')):
        axis.set(xlabel='t [s] since they could move', ylabel=name + ', x/L', xlim=(-0.05, 0.5))
        plotting.named(axis)
    run = next((r for r in lifted if lift(r)[0] == 1), lifted[0])
    for axis, moment in zip(axes[2:], (0.07, 0.2)):
        snapshot(axis, run, lift(run)[1] + moment)
        x, y = 100*tank(run, 'waterWidth'), 100*bottom(run, lift(run)[1] + moment)
        axis.fill([x, x + 0.2, x + 0.2, x], [y, y, 30, 30], color='k')
        axis.set_ylim(0, 16)
    plotting.save(fig, path)


def plot(runs, path):
    plotPlate(runs, path.replace('.png', 'Plate.png'))
    runs = [run for run in runs if not lift(run)[0]] or runs
    if len(runs) > 1:
        plotArrivals(runs, path.replace('.png', 'Arrival.png'))
        plotResolution(runs, path.replace('.png', 'Resolution.png'))
    finest = [run for run in runs if run.name.endswith('-fine') and layers(run) in (6, 12)]
    runs = finest or runs
    moments = [m for m in shown if any(float(t) >= m for t in clouds.times(runs[0].path))] or [0]
    fig, axes = plotting.figure(len(moments), len(runs), width=4.2, height=2.4)
    axes = np.atleast_1d(axes).ravel()
    for row, run in enumerate(runs):
        for column, moment in enumerate(moments):
            snapshot(axes[row*len(moments) + column], run, moment)
    plotting.save(fig, path)


def case(layers, beta, cell=0.001, gap=2, more=''):
    """Gap in cells; lengths along which cylinders lie are stretched by it"""
    gap *= cell
    pitch = 2*radius + gap
    nx = round(26*pitch/cell)
    of = dict(cellSize=cell, gap=gap, pitch=pitch, tank=nx*cell, nx=nx, ny=round(0.6/cell),
              waterWidth=6*pitch + gap, stackWidth=6*pitch,
              stackHeight=gap + 2*radius + (layers - 1)*pitch*0.75**0.5 + 0.5*cell)
    text = '; '.join(f'system/tank:{key} {value:.8g}' for key, value in of.items())
    return ['-set', f'contactVelocity {beta}; {text}; system/setParticlesDict:spacing '
                    f'{cell/2:.8g}; constant/solidProperties:pairs/default/cellSize {cell:.8g}; '
                    f'constant/solidProperties:pairs/default/gap {gap:.8g}{more}']


def fine(layers, beta, cell=0.0005, gap=2, more=''):
    """The paper's cells; the Courant number keeps the step of the coarser ones"""
    return case(layers, beta, cell, gap, '; system/controlDict:maxCo 1' + more)


def courant(beta, co, more=''):
    """Six layers at 0.5 mm with another step"""
    return case(6, beta, 0.0005, more=f'{more}; system/controlDict:maxCo {co}')


# A plate that stands for 0.2 s; written often, so that what would pass through it is seen
def plate(speed):
    return (case(6, 0.5, more=f'; system/tank:lift {speed}; system/controlDict:writeInterval 0.005')
            + ['-endTime', '0.7'])


betas = (('05', 0.5), ('1', 1))
every = [(n, name, beta) for n in (6, 8, 10, 12) for name, beta in betas]
# [s] about the mean step of six layers at 0.5 mm with maxCo 0.5
perTime = '; contactVelocityTime 9.06e-5'
# six layers by cells, and gaps in cells
resolutions = [('2mm', 0.002, 2), ('2mm-gap1mm', 0.002, 0.5), ('1mm', 0.001, 2),
               ('1mm-gap1mm', 0.001, 1), ('quarter', 0.00025, 2), ('quarter-gap1mm', 0.00025, 4)]
study = Study(
    scene='damBreakCylinders',
    variants=[Variant(f'{n}-beta{name}', case(n, beta)) for n, name, beta in every]
    + [Variant(f'6-gap{gap:g}', case(6, 0.5, gap=gap))
       for gap in (1, 0.5)] + [Variant('6-beta1-gap1', case(6, 1, gap=1))]
    + [Variant(f'6-plate-{speed:g}', plate(speed)) for speed in (0.5, 1, 4)]
    + [Variant(f'{n}-beta{name}-fine', fine(n, beta), large=True) for n, name, beta in every]
    + [Variant(f'6-{name}-co{label}', courant(beta, co), large=True)
       for name, beta in (('once', 0.5), ('beta1', 1)) for label, co in (('05', 0.5), ('2', 2))]
    + [Variant(f'6-T-co{label}', courant(0.5, co, perTime), large=True)
       for label, co in (('05', 0.5), ('1', 1), ('2', 2))]
    + [Variant(f'6-beta{name}-{way}', fine(6, beta, cell, gap), large=cell < 0.0005)
       for name, beta in betas for way, cell, gap in resolutions],
    quick=[Variant('6-quick', ['-endTime', '0.04'])],
    analyse=analyse,
    plot=plot,
    headline='arrival at the far wall [s]',
)
if __name__ == '__main__':         # benchmarks/runPicSolids takes case() alone
    study.main(here)
