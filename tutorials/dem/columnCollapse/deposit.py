#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The deposit of a collapsed column: how far it reaches by several measures of its front, and the
power of the aspect ratio that it follows

    deposit.py RUN_DIRECTORY ...        a line a run; then, over runs with a > 2, the power for each
                                        measure
"""
import os
import sys

import numpy as np

if __name__ == '__main__':
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..',
                                    'etc', 'python'))
from riprap import clouds
from riprap.dictionaries import numberOf, readDictionary
from riprap.tables import hasTable

opens = 0.5             # [s] when the gate moves
d = 0.005               # [m] mean diameter


def column(run):
    return {k: numberOf(v) for k, v in readDictionary(os.path.join(
        run.path, 'system', 'column')).items() if k != 'FoamFile'}


def isSpheres(run):
    return readDictionary(os.path.join(run.path, 'system', 'sides'))['sides'] != 'empty'


def hasPlates(run):
    return readDictionary(os.path.join(run.path, 'system', 'sides'))['sides'] == 'wall'


def grains(run, time, *more):
    """Positions and radii, and fields named, of the grains that are not glued to the floor"""
    cloud = clouds.readCloud(run.path, clouds.nearestTime(run.path, time),
                             ('radius', 'group', *more), 'solids')
    free = cloud['group'] == 0
    return [cloud[name][free] for name in ('positions', 'radius', *more)]


def aspectRatio(run):
    """Of the column at rest: as high as twice its centre of mass is"""
    table = run.table('grains', 'groupMotion.dat')
    return 2*np.interp(opens, table['Time'], table['freeCentreY'])/column(run)['width']


def heap(x, r, reach):
    """Grains that hang together with those at the wall, neighbours being nearer than `reach`
    between surfaces"""
    order = np.argsort(x[:, 0])
    x, r = x[order], r[order]
    joined = np.zeros(len(x), bool)
    front = [i for i in range(len(x)) if x[i, 0] < 4*r[i]]
    joined[front] = True
    while front:
        i = front.pop()
        low, high = np.searchsorted(x[:, 0], [x[i, 0] - 2*d - reach, x[i, 0] + 2*d + reach])
        near = np.arange(low, high)
        near = near[~joined[near]]
        near = near[np.linalg.norm(x[near, :] - x[i], axis=1) < r[near] + r[i] + reach]
        joined[near] = True
        front.extend(near)
    return x[joined], r[joined]


def reachOf(x, r, width, reach=0.5*d):
    """(L - L0)/L0 of the heap without grains that rolled off alone"""
    x, r = heap(x, r, reach)
    return float((x[:, 0] + r).max()/width - 1)


def runOut(run, time, reach=0.5*d):
    x, r = grains(run, time)
    return reachOf(x if isSpheres(run) else x[:, :2], r, column(run)['width'], reach)


def fronts(run, time, width, reach=0.5*d):
    """The same of the grains in each strip of this width, from plate to plate: the first is what is
    seen through a plate"""
    x, r = grains(run, time)
    strip = (x[:, 2]/width).astype(int)
    ends = [heap(x[strip == k], r[strip == k], reach) for k in range(strip.max() + 1)
            if np.count_nonzero(strip == k) > 50]
    return (np.array([(at[:, 0] + size).max() for at, size in ends if len(at)])/column(run)['width']
            - 1)


def footOf(x, r, width, depth=None):
    """The same where the heap's depth falls below half a grain: depth of strips two grains wide,
    0.6 of it grains; disks, which have no depth, 0.8"""
    strip = 2*d
    solid = np.pi*r**2/0.8 if depth is None else 4/3*np.pi*r**3/(0.6*depth)
    height = np.bincount((x[:, 0]/strip).astype(int), solid)/strip
    shallow = np.nonzero(height < 0.5*d)[0]
    return float((shallow[0] if len(shallow) else len(height))*strip/width - 1)


def footOfProfile(run, time):
    x, r = grains(run, time)
    size = column(run)
    return footOf(x, r, size['width'], size['depth'] if isSpheres(run) else None)


def lastTime(run):
    return float(clouds.times(run.path)[-1])


def measures(run, time):
    """{measure of the front: (L - L0)/L0}"""
    x, _ = grains(run, time)
    plates = {'mean of strips': float(fronts(run, time, 2*d).mean()),
              'seen through a plate': float(fronts(run, time, d)[0])} if hasPlates(run) else {}
    return {'heap': runOut(run, time), **plates, 'half a grain deep': footOfProfile(run, time),
            '99 % of the grains': float(np.quantile(x[:, 0], 0.99)/column(run)['width'] - 1)}


def platesShare(run):
    """Of the momentum along the floor that end wall and gate give to the grains, what the side
    plates take away; the rest is the floor's"""
    table = run.table('walls', 'solidWallForce.dat')
    late = table['Time'] >= opens

    def impulse(wall):
        return (np.trapz(table[wall + 'Fx'][late], table['Time'][late]) if wall + 'Fx' in table
                else 0.0)
    return -(impulse('front') + impulse('back'))/(impulse('symmetry') + impulse('gate'))


def powerOf(ratios, reach):
    """The exponent of reach ~ ratio^exponent, by least squares of the logarithms"""
    return float(np.polyfit(np.log(ratios), np.log(reach), 1)[0])


def main(paths):
    from riprap.study import Run
    runs = sorted((Run(path) for path in paths), key=aspectRatio)
    found = [(aspectRatio(run), measures(run, lastTime(run))) for run in runs]
    for run, (a, reach) in zip(runs, found):
        share = (f"; plates' share of the momentum {platesShare(run):.2f}"
                 if hasPlates(run) and hasTable(run.path, 'walls') else '')
        print(f'{run.name}: a = {a:.3g}; '
              + '; '.join(f'{name} {value:.3g}' for name, value in reach.items()) + share)
    high = [(a, reach) for a, reach in found if a > 2]
    for name in found[0][1] if len(high) > 1 else ():
        print(f'power of a above 2, {name}: '
              f'{powerOf([a for a, _ in high], [reach[name] for _, reach in high]):.3f}')


if __name__ == '__main__':
    main(sys.argv[1:])
