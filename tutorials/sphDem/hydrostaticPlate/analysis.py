# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic plate under a water column at rest: the middle's displacement against plate theory"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g, rho, rhoPlate = 9.81, 1000, 1100
e, L, H = 5e-3, 0.07875, 0.1575
E, nu = 10e6, 0.4
paper = 1.263e-3                        # its program [m]


def thinPlate(span=L):
    """Eq. 44: 1.2894 mm. Clamped at both ends, without shear; 0.0026 stands for 1/384"""
    D = E*e**3/(12*(1 - nu**2))
    return 0.0026*g*(rho*H + rhoPlate*e)*span**4/D


def withShear(span=L):
    """Timoshenko, kappa = 5/6: q L^2/(8 kappa G e) more"""
    q = g*(rho*H + rhoPlate*e)
    return thinPlate(span) + q*span**2/(8*5/6*E/(2*(1 + nu))*e)


def withStretching():
    """Clamps do not come nearer: w (1 + 0.75 (w/e)^2) = w of small displacements, for the shape 1 -
    cos(2 pi x/L)"""
    w = withShear()
    for _ in range(50):
        w = withShear()/(1 + 0.75*(w/e)**2)
    return w


def middle(run):
    """Time and how far the middle has sunk: mean of the particles about it"""
    table = run.table('middle', 'particleDisplacement.dat')
    columns = [c for c in table if c.endswith('Dy')]
    return np.asarray(table['Time']), -np.mean([table[c] for c in columns], axis=0)


def settled(t, w):
    """Mean over the last quarter"""
    return w[t > 0.75*t[-1]].mean()


def drift(t, w):
    """Change of the mean from the third quarter to the last, over the mean"""
    third = w[(t > 0.5*t[-1]) & (t <= 0.75*t[-1])].mean()
    return abs(settled(t, w)/third - 1)


def lowestWater(run):
    """Median height of the water's lowest particles over the plate below them, in spacings of the
    water: 1/2 where a wall holds it"""
    last = clouds.times(run.path)[-1]
    water, solid = (clouds.readCloud(run.path, last, ())['positions'],
                    clouds.readCloud(run.path, last, ('radius',), 'solids'))
    radius = solid['radius'][0]
    column = np.round(solid['positions'][:, 0]/(2*radius)).astype(int)
    surface = {k: solid['positions'][column == k, 1].max() + radius for k in np.unique(column)}
    inner = water[(water[:, 0] > 0.1*L) & (water[:, 0] < 0.9*L)]
    height = inner[:, 1] - [surface[k] for k in np.round(inner[:, 0]/(2*radius)).astype(int)]
    return float(np.median(height[(height > -radius) & (height < run.spacing)])/run.spacing)


def lost(run):
    """Share of the water that is no longer there, or under the plate's upper surface by more than
    two rows"""
    first, last = (clouds.readCloud(run.path, clouds.times(run.path)[k], ())['positions']
                   for k in (0, -1))
    return 1 - np.count_nonzero(last[:, 1] > 0.5*e)/len(first)


def analyse(run):
    t, w = middle(run)
    at = settled(t, w)
    noise = w[t > 0.75*t[-1]].std()/at
    theory = withStretching()
    return [Quantity('middle [mm], thin plate', 1e3*at, 1e3*thinPlate(), abs(at/thinPlate() - 1)),
            Quantity('middle [mm], with shear and stretching', 1e3*at, 1e3*theory,
                     abs(at/theory - 1)),
            Quantity("middle [mm], the paper's program", 1e3*at, 1e3*paper, abs(at/paper - 1)),
            Quantity('drift, third quarter to last', error=float(drift(t, w))),
            Quantity('rms about the mean in the last quarter', computed=float(noise)),
            Quantity('lowest water over the plate [spacings]', computed=lowestWater(run)),
            Quantity('share of the water that leaked', error=float(lost(run)))]


def sizeRatio(run):
    """Of the water's spacing to the plate's"""
    last = clouds.times(run.path)[-1]
    return run.spacing/(2*clouds.readCloud(run.path, last, ('radius',), 'solids')['radius'][0])


def plotLeaks(runs, path):
    """Water in the plate, and how low the first layer stands, over the size ratio"""
    fig, (share, layer) = plotting.figure(2, width=4.0, height=3.2)
    for k, c in enumerate(couplings):
        mine = sorted((sizeRatio(r), 100*lost(r), lowestWater(r)) for r in runs
                      if r.name.startswith('ratio') and r.name.endswith('-' + c))
        if mine:
            ratio, leaked, height = zip(*mine)
            share.plot(ratio, leaked, '-', marker=plotting.markers[k], markersize=4,
                       color=plotting.colours[k], label=c)
            layer.plot(ratio, height, '-', marker=plotting.markers[k], markersize=4,
                       color=plotting.colours[k], label=c)
    layer.axhline(0.5, color='k', linewidth=0.7, linestyle='--')
    share.set(xlabel='spacing of the water / of the plate', ylabel='water that leaked [%]')
    layer.set(xlabel='spacing of the water / of the plate',
              ylabel='first layer over the plate [spacings]')
    plotting.named(share)
    plotting.save(fig, path)


def plot(runs, path):
    if any(r.name.startswith('ratio') for r in runs):
        plotLeaks(runs, path.replace('.png', 'Leaks.png'))
    runs = [r for r in runs if not r.name.startswith('ratio')] or runs
    fig, (time, shape) = plotting.figure(2)
    for run in runs:
        t, w = middle(run)
        time.plot(t, 1e3*w, linewidth=0.8, label=run.name)
    for w, style, label in ((thinPlate(), '--', 'thin plate'),
                            (withStretching(), ':', 'with shear and stretching')):
        time.axhline(1e3*w, color='k', linewidth=0.8, linestyle=style, label=label)
    time.set(xlabel='t [s]', ylabel='middle sinks by [mm]', ylim=(0, 2.2))
    plotting.named(time)
    last = runs[0]
    c = clouds.readCloud(last.path, clouds.times(last.path)[-1], ('radius',), 'solids')
    f = clouds.readCloud(last.path, clouds.times(last.path)[-1], ('p',))
    dots = shape.scatter(1e3*f['positions'][:, 0], 1e3*f['positions'][:, 1], c=f['p'], s=1.5)
    shape.scatter(1e3*c['positions'][:, 0], 1e3*c['positions'][:, 1], s=1.5, color='#444444')
    fig.colorbar(dots, ax=shape, label='p [Pa]')
    shape.set(aspect='equal', xlabel='x [mm]', ylabel='y [mm]', ylim=(-3, 40), title=last.name)
    plotting.save(fig, path)


def sized(across, fluid):
    """Another number of particles through the plate, the fluid's spacing with it"""
    s = e/across
    numbers = {'size': s, 'radius': s/2, 'gap': 1e-3*s, 'left': -3.5*s, 'leftEnd': 0.5*s,
               'rightEnd': L - 0.5*s, 'right': L + 3.5*s, 'thickness': s, 'fluidSpacing': fluid}
    return '; '.join(f'system/plate:{k} {v:.10g}' for k, v in numbers.items())


def ratioOf(size, rows):
    """Plates of other particles and about the same thickness under the same water: widths are whole
    numbers of them"""
    numbers = {'size': size, 'radius': size/2, 'gap': 1e-3*size, 'left': -3.5*size,
               'leftEnd': 0.5*size, 'rightEnd': L - 0.5*size, 'right': L + 3.5*size,
               'thickness': size, 'top': rows*size, 'surface': rows*size + H}
    return '; '.join(f'system/plate:{k} {v:.10g}' for k, v in numbers.items())


couplings = ('extrapolated', 'pressureGradient', 'stationary', 'pressureApproximation')

Study(
    scene='hydrostaticPlate',
    variants=[Variant('extrapolated'),
              Variant('pressureGradient', ['-set', 'coupling pressureGradient']),
              Variant('stationary', ['-set', 'coupling stationary']),
              Variant('pressureApproximation', ['-set', 'coupling pressureApproximation']),
              Variant('fine', ['-endTime', '1', '-set', sized(8, 8.75e-4)]),
              *(Variant(f'ratio{1.75e-3/s:.3g}-{c}',
                        ['-endTime', '0.6', '-set', f'{ratioOf(s, rows)}; coupling {c}'])
                for s, rows in ((2.625e-3, 2), (1.75e-3, 3), (1.25e-3, 4), (8.75e-4, 6),
                                (6.25e-4, 8)) for c in couplings)],
    quick=[Variant('quick', ['-endTime', '0.15'])],
    analyse=analyse,
    plot=plot,
    headline='middle [mm], thin plate',
).main(here)
