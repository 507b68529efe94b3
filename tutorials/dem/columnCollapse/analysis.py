# SPDX-License-Identifier: GPL-3.0-or-later
"""Collapse of granular columns of several aspect ratios against published scaling laws of the
run-out"""
import os
import re
import sys

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
from deposit import (aspectRatio, column, d, footOfProfile, fronts, grains,  # noqa: E402
                     hasPlates, isSpheres, lastTime, measures, opens, powerOf, runOut)

# friction: 24.8 degrees, measured for glass beads on the walls of the channel (Lajeunesse et al.
# 2004)
beadsOnWall = 0.46
g, rho = 9.81, 2500.0


def staronHinch(a):
    """Disks by contact dynamics, 2005"""
    return np.where(a < 2, 2.5*a, 3.25*a**0.7)


def lagree(a):
    """mu(I) continuum, 2011"""
    return np.where(a < 7, 2.2*a, 3.9*a**0.7)


def lube(a):
    """Sand, rice, sugar, 2005"""
    return np.where(a < 2.3, 1.2*a, 1.9*a**(2/3))


def lajeunesse(a):
    """Glass beads, 2005"""
    return np.where(a < 3, 1.8*a, 2.3*a**(2/3))


def analyse(run):
    a, end = aspectRatio(run), lastTime(run)
    far = runOut(run, end)
    x, r = grains(run, end)
    energy = run.table('energy', 'solidEnergies.dat')
    moving = (energy['translation'] + energy['rotation'])[-1]/energy['potential'][0]
    result = [Quantity('aspect ratio', a)]
    laws = [('Lajeunesse', lajeunesse), ('Lube', lube)]
    if not isSpheres(run):
        laws = [('Staron & Hinch', staronHinch), ('Lagree', lagree)] + laws
    for name, law in laws:
        result.append(Quantity(f'run-out, {name}', far, float(law(a)), abs(far/float(law(a)) - 1)))
    if hasPlates(run):
        mean, law = float(fronts(run, end, 2*d).mean()), float(lajeunesse(a))
        result.append(Quantity('run-out, mean of strips two grains wide, Lajeunesse', mean, law,
                               abs(mean/law - 1)))
    earlier = float(clouds.nearestTime(run.path, end - 0.2))
    result += (
        [Quantity('run-out with surfaces a quarter of a grain apart', runOut(run, end, 0.25*d)),
         Quantity('run-out with surfaces a grain apart', runOut(run, end, d)),
         Quantity('run-out, where half a grain is the depth', footOfProfile(run, end)),
         *([Quantity('run-out, seen through a side plate', float(fronts(run, end, d)[0]))]
           if hasPlates(run) else []),
         Quantity('run-out, 99 % of the grains',
                  float(np.quantile(x[:, 0], 0.99)/column(run)['width'] - 1)),
         Quantity('change of the run-out since 0.2 s before the end',
                  far - runOut(run, earlier) if abs(earlier - end + 0.2) < 0.05 else None),
         Quantity('height of the deposit / width', float((x[:, 1] + r).max()/column(run)['width'])),
         Quantity('kinetic energy at the end / potential at the start', float(moving))])
    return result


def exponents(runs, names):
    """{measure: power of the aspect ratio above 2} over the runs named; empty where there are too
    few"""
    high = [runs[n] for n in names if aspectRatio(runs[n]) > 2]
    if len(high) < 3:
        return {}
    known = [measures(run, lastTime(run)) for run in high]
    return {name: powerOf([aspectRatio(run) for run in high], [k[name] for k in known])
            for name in known[0] if all(name in k for k in known)}


def compare(runs, results):
    result = []
    for kind, names, expected in (('disks', r'disks-[\d.]+$', 0.7),
                                  ('spheres', r'spheres-[\d.]+$', 2/3),
                                  *((f'spheres in a channel{name}',
                                     rf'spheres-[\d.]+-channel{name}$', 2/3) for name in channels)):
        powers = exponents(runs, [n for n in runs if re.match(names, n)])
        for front, value in powers.items():
            result.append(Quantity(f'exponent above a = 2, {kind}' + (
                f': {front}' if front != 'heap' else ''), value, expected, abs(value - expected)))
    for size, name, expected in (('disks-2', 'Staron & Hinch', staronHinch),
                                 ('disks-2-fine', 'Staron & Hinch', staronHinch),
                                 ('spheres-1', 'Lajeunesse', lajeunesse)):
        packings = [runs[n] for n in (size, size + '-seed2', size + '-seed3') if n in runs]
        if len(packings) < 2:
            continue
        far = [runOut(r, lastTime(r)) for r in packings]
        law = float(np.mean([expected(aspectRatio(r)) for r in packings]))
        result += [Quantity(f'run-out of {size}, mean over packings, {name}', float(np.mean(far)),
                            law, abs(np.mean(far)/law - 1)),
                   Quantity(f'run-out of {size}, range over packings / mean',
                            float(np.ptp(far)/np.mean(far)))]
    for a, ratios in changes({n: reaches(r) for n, r in runs.items() if '-channel' in n}).items():
        result += [Quantity(f'change of the run-out, a = {a}: {what}', change)
                   for what, change in ratios.items() if what]
    return result


def drawHeap(axis, run, time):
    x, r, U = grains(run, time, 'U')
    plotting.discs(axis, 100*x, 100*r, np.linalg.norm(U, axis=1) if isSpheres(run) else None)
    size = column(run)
    axis.set(xlim=(0, 100*min(size['length'], 5*size['width'] + 0.3)),
             ylim=(0, 100*1.05*size['height']), aspect='equal',
             title=f'{run.name}, {time - opens:.1f} s', xlabel='x [cm]')
    axis.grid(False)


families = {'-channel': '39 grains wide', '-channel-similar': 'as wide as the column is long',
            '-channel-slot': 'half as wide', '-channel-periodic': 'no plates'}


def plotChannels(found, path):
    """found: {name of a run: its reaches}. Run-out over the aspect ratio in channels of different
    widths, and over the law, by the heap and by the mean of strips"""
    fig, axes = plotting.figure(2, 1, width=5.6, height=4)
    a = np.geomspace(0.4, 12, 200)
    line, = axes[0].loglog(a, lajeunesse(a), linewidth=1, label='Lajeunesse et al. 2005, 10 %')
    axes[0].fill_between(a, 0.9*lajeunesse(a), 1.1*lajeunesse(a), alpha=0.15,
                         color=line.get_color())
    axes[1].axhspan(-10, 10, alpha=0.15, color=line.get_color())
    for i, (family, label) in enumerate(families.items()):
        chosen = sorted(reach for name, reach in found.items()
                        if re.match(rf'spheres-[\d.]+{family}$', name))
        if not chosen:
            continue
        ratio = np.array([c[0] for c in chosen])
        style = dict(marker=plotting.markers[i], markersize=5, linewidth=1,
                     color=plotting.colours[i + 1])
        axes[0].loglog(ratio, [c[1] for c in chosen], label=label, **style)
        axes[1].semilogx(ratio, [100*(far/lajeunesse(at) - 1) for at, far, _ in chosen],
                         label=label, **style)
        others = [(at, other['mean of strips']) for at, _, other in chosen
                  if 'mean of strips' in other]
        style.update(linestyle=':', markersize=3)
        axes[1].semilogx([o[0] for o in others],
                         [100*(far/lajeunesse(at) - 1) for at, far in others], **style)
    axes[0].set(xlabel='aspect ratio $a$', ylabel='run-out $(L-L_0)/L_0$',
                title='spheres in channels, rough floor')
    axes[1].set(xlabel='aspect ratio $a$', ylabel='beyond the law [%]',
                title='farthest grain of the heap; dotted: mean of strips across')
    for axis in axes:
        plotting.named(axis)
    plotting.save(fig, path)


packings = ('', 'seed2', 'seed3')


def reaches(run):
    """Aspect ratio, run-out of the heap, and by the other measures of the front"""
    others = measures(run, lastTime(run))
    return aspectRatio(run), others.pop('heap'), others


def changes(found):
    """found: {name of a run: its reaches}. {aspect ratio: {what: change of the run-out over the
    law}} of all that differs in one thing from the column of the study, of its measures of the
    front, and what would bring it to the law"""
    result = {}
    for a in ('4', '10'):
        base = f'spheres-{a}-channel-study'
        if base not in found:
            continue
        ratios = {name[len(base):].strip('-'): far/float(lajeunesse(at))
                  for name, (at, far, _) in found.items() if name.startswith(base)}
        mean = np.mean([ratios[p] for p in packings if p in ratios])
        for size, name in ((0.5/0.7, '-half'), (1/0.7, ''), (1.6/0.7, '-larger')):
            at, far, _ = found.get(f'spheres-{a}-channel{name}', (1, None, None))
            if far:
                ratios[f'{size:.1f} times as many across'] = far/float(lajeunesse(at))
        at, _, others = found[base]
        ratios.update({f'front: {name}': far/float(lajeunesse(at)) for name, far in others.items()
                       if far})
        ratios['the law'] = 1
        result[a] = {what: float(ratio/mean - 1) for what, ratio in ratios.items()}
    return result


def plotTerms(found, path):
    """What one change at a time, or another measure, does to the run-out"""
    told = changes(found)
    names = list(dict.fromkeys(what for ratios in told.values() for what in ratios
                               if what != 'the law')) + ['the law']
    fig, axes = plotting.figure(1, 1, width=7, height=0.8 + 0.27*len(names))
    for shift, marker, (a, ratios) in zip((-0.15, 0.15), 'os', told.items()):
        axes[0].plot([100*v for v in ratios.values()], [
            names.index(what) + shift for what in ratios], marker, markersize=5, label=f'a = {a}')
    axes[0].axvline(0, color='k', linewidth=0.6)
    axes[0].set(yticks=range(len(names)),
                yticklabels=[n or 'the column of the study' for n in names],
                ylim=(len(names) - 0.5, -0.5), xlabel='change of the run-out [%]',
                title='spheres in a channel: one thing changed at a time')
    plotting.named(axes[0])
    plotting.save(fig, path)


def plot(runs, path):
    if any(r.name.endswith('-channel-study') for r in runs):
        plotTerms({r.name: reaches(r) for r in runs if '-channel' in r.name},
                  path.replace('.png', 'Terms.png'))
    runs = [r for r in runs if '-study' not in r.name]
    if not runs:
        return
    inChannels = [r for r in runs if '-channel' in r.name]
    if inChannels:
        plotChannels({r.name: reaches(r) for r in inChannels}, path.replace('.png', 'Channel.png'))
    if len(inChannels) == len(runs):
        return
    shown = next((r for r in runs if r.name == 'disks-2'), runs[0])
    fig, axes = plotting.figure(3, 2, width=4.8, height=3.4)
    a = np.geomspace(0.3, 15, 100)
    for axis, kind, laws in ((axes[0], 'disks', (('Staron & Hinch 2005, disks', staronHinch),
                                                 ('Lagrée et al. 2011', lagree))),
                             (axes[1], 'spheres', (('Lube et al. 2005, sand', lube),
                                                   ('Lajeunesse et al. 2005, glass', lajeunesse)))):
        for label, law in laws:
            line, = axis.loglog(a, law(a), linewidth=1, label=label)
            axis.fill_between(a, 0.9*law(a), 1.1*law(a), alpha=0.15, color=line.get_color())
        ours = [r for r in runs if isSpheres(r) == (kind == 'spheres')]
        plain = r'[a-z]+-[\d.]+$'
        for style, label, chosen in (
                ('o', 'riprap' + (', slice of six grains' if kind == 'spheres' else ''),
                 [r for r in ours if re.match(plain, r.name)]),
                ('s', 'riprap, channel', [r for r in ours if re.match(r'.*\d-channel$', r.name)]),
                ('x', 'riprap, variants',
                 [r for r in ours if not re.match(plain + r'|.*\d-channel$', r.name)])):
            if chosen:
                axis.plot([aspectRatio(r) for r in chosen],
                          [runOut(r, lastTime(r)) for r in chosen], style, color='#000000',
                          markersize=5, label=label)
        axis.set(title=kind, xlabel='aspect ratio $a$', ylabel='run-out $(L-L_0)/L_0$')
        plotting.named(axis)
    for run in runs:
        if run.name.count('-') > 1:
            continue
        t = np.array([float(n) for n in clouds.times(run.path) if float(n) >= opens])
        H = aspectRatio(run)*column(run)['width']
        axes[2].plot((t - opens)/np.sqrt(H/g), [runOut(run, s) for s in t], linewidth=1,
                     label=run.name)
    axes[2].set(xlabel='$t / \\sqrt{H/g}$', ylabel='run-out')
    plotting.named(axes[2])
    for axis, t in zip(axes[3:], (opens, opens + 0.3, lastTime(shown))):
        drawHeap(axis, shown, t)
    plotting.save(fig, path)


def settings(width, height, duration, spheres=False, rolling=0.1, plates=None, depth=None,
             rough=False, friction=0.5, lift=0, stiff=1000):
    """height: of the settled column. Random packings are filled loosely and settle. plates:
    friction of side plates, `depth` apart; rough: a floor of glued grains; lift: speed of the gate
    upwards over sqrt(g H), 0: it retreats; stiff: stiffness over rho g H d"""
    a = height/width
    filled = height*(0.82/0.65 if not spheres else 0.60/0.45)
    reach = float(staronHinch(a))
    numbers = {'width': width, 'height': filled, 'length': width*(1 + 1.3*reach) + 0.3,
               'top': filled + 0.1, 'solidFraction': 0.45 if spheres else 0.65}
    text = '; '.join(f'system/column:{k} {v:.5g}' for k, v in numbers.items())
    # 1000: overlaps of a thousandth of a grain under the column's weight
    stiffness = stiff*rho*g*height*(d if spheres else 1)
    text += (f'; constant/geometry:gate/origin ({width:g} {0 if rough else -0.01:g} -1); '
             f'constant/geometry:gate/span (0 {filled + 0.02:.5g} 2)')
    text += ''.join(f'; pairs/{p}/stiffness {stiffness:.5g}'
                    for p in ('grain-grain', 'grain-smooth', 'grain-plate'))
    if lift:
        text += f'; system/column:lift {lift*np.sqrt(g*height):.4g}'
    if rough:
        text += '; system/column:glued 1; system/column:bottom -0.01'
    if spheres:
        text += f'; system/column:depth {depth or 0.03:g}; pairs/grain-grain/friction {friction:g}'
        text += ('; system/sides:sides cyclic' if plates is None
                 else f'; system/sides:sides wall; pairs/grain-plate/friction {plates:g}'
                 + ''.join(f'; walls/materials/{side} plate' for side in ('front', 'back')))
        if rolling:
            text += f'; contact/rolling spring; pairs/grain-grain/rollingFriction {rolling:g}' \
                + ''.join(f'; pairs/grain-{m}/rollingFriction 1e-9' for m in ('smooth', 'plate'))
    return ['-set', text, '-endTime', f'{opens + duration:g}']


def variant(name, *size, extra='', large=False, **more):
    options = settings(*size, **more)
    options[1] += extra
    return Variant(name, options, large=large)


def spheresOf(a, width, name='', duration=(6, 0.4), **changed):
    """Glass beads: free to roll, on a floor of glued beads. duration: in sqrt(H/g), and in s"""
    height = a*width
    how = dict(spheres=True, rolling=0, rough=True)
    how.update(changed)
    return variant(f'spheres-{a:g}{name}', width, height,
                   float(f'{duration[0]*np.sqrt(height/g) + duration[1]:.2g}'), **how)


def channelOf(a, name='', size=1, end='plate', extra='', shape=None, **changed):
    """As in the experiments: side plates 39 grains (45 mm) apart, or `shape` lengths of the column;
    the column against an end wall of the same kind, 2500 grains in the side view; size: times as
    many across. end: material of the end wall. Everything is at rest after 4 sqrt(H/g)"""
    wall = f'; walls/materials/symmetry {end}'
    width = float(f'{50*size*d/np.sqrt(a):.4g}')
    depth = float(f'{shape*width:.3g}') if shape else 39*d
    return spheresOf(a, width, '-channel' + name, large=True, extra=wall + extra,
                     duration=(4.5, 0.2),
                     **{'plates': beadsOnWall, 'depth': depth, 'stiff': 250, **changed})


def everyPair(entry, value):
    return ''.join(f'; pairs/grain-{other}/{entry} {value}'
                   for other in ('grain', 'smooth', 'plate'))


# what is changed in the channel, one thing at a time. Spheres that resist rolling with 0.04 rest at
# the angle of the experiment's beads
periodicSides = dict(plates=None, extra=f'; pairs/grain-plate/friction {beadsOnWall}')
terms = {
    'study': {}, 'study-seed2': dict(extra='; system/column:seed 2'),
    'study-seed3': dict(extra='; system/column:seed 3'), 'study-smoothEnd': dict(end='smooth'),
    'study-periodic': periodicSides, 'study-narrow': dict(depth=20*d),
    'study-wide': dict(depth=78*d), 'study-lift': dict(lift=1), 'study-slowLift': dict(lift=0.5),
    'study-friction0.3': dict(friction=0.3), 'study-friction0.7': dict(friction=0.7),
    'study-restitution0.9': dict(extra=everyPair('restitution', 0.9)),
    'study-rolling0.04': dict(rolling=0.04), 'study-stiff': dict(stiff=1000),
    'study-rougher': dict(extra='; system/column:uneven 0.3'),
}
# channels for all aspect ratios: 39 grains wide; as wide as the column is long, half of it; without
# plates
channels = {'': {}, '-similar': dict(shape=1), '-slot': dict(shape=0.5), '-periodic': periodicSides}
# of those as wide as the column is long
similar = {'seed2': dict(extra='; system/column:seed 2'), 'stiff': dict(stiff=1000),
           'repose': dict(rolling=0.04), 'lift': dict(lift=1), 'fine': dict(size=1.6)}


widths = {0.5: 0.15, 1: 0.1, 2: 0.07, 4: 0.05, 7: 0.04, 10: 0.04}

study = Study(
    scene='columnCollapse',
    variants=[variant('disks-0.5', 0.3, 0.15, 1.0), variant('disks-1', 0.2, 0.2, 1.2),
              variant('disks-2', 0.15, 0.3, 1.4), variant('disks-4', 0.1, 0.4, 1.6),
              variant('disks-7', 0.08, 0.56, 1.8), variant('disks-10', 0.07, 0.7, 2.0),
              variant('disks-2-seed2', 0.15, 0.3, 1.4, extra='; system/column:seed 2'),
              variant('disks-2-seed3', 0.15, 0.3, 1.4, extra='; system/column:seed 3'),
              variant('disks-2-fine', 0.3, 0.6, 1.8),
              variant('disks-2-fine-seed2', 0.3, 0.6, 1.8, extra='; system/column:seed 2'),
              variant('disks-2-fine-seed3', 0.3, 0.6, 1.8, extra='; system/column:seed 3'),
              variant('disks-2-friction0.5', 0.15, 0.3, 1.4,
                      extra='; pairs/grain-grain/friction 0.5'),
              *(spheresOf(a, width) for a, width in widths.items()),
              spheresOf(1, 0.1, '-seed2', extra='; system/column:seed 2'),
              spheresOf(1, 0.1, '-seed3', extra='; system/column:seed 3'),
              spheresOf(1, 0.1, '-friction0.2', friction=0.2),
              spheresOf(1, 0.1, '-rollingFriction0.1', rolling=0.1),
              spheresOf(1, 0.1, '-sleep', extra='; sleep/speed 1e-3; sleep/after 0.02'),
              # on a flat floor, where a sphere that rolls is not stopped by anything
              spheresOf(1, 0.1, '-flat', rough=False),
              spheresOf(1, 0.1, '-flat-rollingFriction0.1', rough=False, rolling=0.1),
              spheresOf(1, 0.1, '-flat-noSpin', rough=False, extra='; groups/free/fixed (spin)'),
              # in more grains, and between plates
              *(spheresOf(a, 2*width, '-fine', large=True) for a, width in widths.items()),
              spheresOf(1, 0.4, '-finer', large=True),
              spheresOf(1, 0.2, '-fine-flat', large=True, rough=False),
              spheresOf(1, 0.4, '-finer-flat', large=True, rough=False),
              *(channelOf(a, name, **changed) for name, changed in channels.items()
                for a in widths), channelOf(1, '-flat', rough=False),
              *(channelOf(a, '-' + name, size) for a in (4, 10)
                for name, size in (('half', 0.5), ('larger', 1.6))),
              *(channelOf(a, '-similar-' + name, shape=1, **changed) for a in (1, 4, 10)
                for name, changed in similar.items()),
              *(channelOf(a, '-' + name, 0.7, **changed) for a in (4, 10)
                for name, changed in terms.items())],
    quick=[variant('disks-1-quick', 0.1, 0.1, 0.9)],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='run-out, Staron & Hinch',
)

if __name__ == '__main__':
    study.main(here)
