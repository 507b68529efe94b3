# SPDX-License-Identifier: GPL-3.0-or-later
"""The first step of a body at rest in a round tank, against its added mass; iterations over density
ratios and numbers of bodies"""
import math
import os
import re

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import entry, numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
g, radius = 9.81, 0.01
ratios = [1e-3, 1e-2, 0.1, 0.5, 2.7, 10, 1e3]
weak = [0.01, 0.5, 1, 2, 2.7, 10]
crowds = [1, 33, 100, 400, 1000]
# a neutral one has a linear pressure, which deflation holds whole: nothing to solve
crowdRatios = [1e-3, 0.1, 0.5, 0.9, 2.7, 1e3]


def tank(run, name):
    return numberOf(run.dictionary('system/tank')[name])


def ratio(run):
    return numberOf(entry(run.solid, 'materials/body/rho'))/run.density


def accelerations(run):
    """Of the bodies, in each step [m/s2]; what a run that stopped has written"""
    table = run.table('bodies', 'groupMotion.dat')
    return np.diff(np.atleast_1d(table['freeUy']))/np.diff(np.atleast_1d(table['Time']))


def theory(run):
    """(rs - rf)/(rs + C rf) g, C of concentric circles and spheres (Lamb, Hydrodynamics, 68 and
    93)"""
    s, a, b = ratio(run), radius, tank(run, 'tankRadius')
    if tank(run, 'dimensions') == 2:
        c = (b**2 + a**2)/(b**2 - a**2)
    else:
        c = 0.5*(b**3 + 2*a**3)/(b**3 - a**3)
    return -(s - 1)/(s + c)*g


def iterations(run):
    """The most that a solution took"""
    with open(os.path.join(run.path, 'log.riprapFoam'), errors='replace') as f:
        return max(int(n) for n in re.findall(r'Solving for p,.*No Iterations (\d+)', f.read()))


def analyse(run):
    a = accelerations(run)
    if run.pic.get('coupling') == 'weak':
        return [Quantity('largest acceleration in ten steps / g',
                         computed=float(np.abs(a).max()/g)),
                Quantity('it grows by a step',
                         computed=float((abs(a[-1])/abs(a[0]))**(1/max(1, len(a) - 1))))]
    result = [Quantity('iterations', computed=iterations(run))]
    if tank(run, 'bodies') == 1 and not run.name.startswith(('crowd', 'surface')):
        result.append(Quantity('acceleration in the first step [m/s2]', float(a[0]), theory(run),
                               abs(a[0]/theory(run) - 1)))
    result.append(Quantity('largest acceleration in ten steps / g',
                           computed=float(np.abs(a).max()/g)))
    return result


def find(results, name, pattern):
    """Values of a quantity by the number in the variants' names"""
    found = {}
    for variant, quantities in results.items():
        match = re.fullmatch(pattern, variant)
        value = [q for q in quantities if q.name == name]
        if match and value:
            found[match.group(1)] = value[0].computed
    return found


def compare(runs, results):
    """Iterations: the most over the fewest, over all density ratios and numbers of bodies"""
    result = []
    for dimensions, name in ((2, 'crowd'), (3, 'crowd3d')):
        for solver in ('', '-host'):
            counts = find(results, 'iterations', name + r'(\d+-[\d.e-]+)' + solver)
            if len(counts) > 1:
                result.append(Quantity(f'iterations in {dimensions}D, most / '
                                       'fewest' + (', coupledPCG' if solver else ''),
                                       computed=max(counts.values())/min(counts.values())))
    counts = find(results, 'iterations', r'surface(\d+-[\d.e-]+)')
    if len(counts) > 1:
        result.append(Quantity('iterations in 2D under a surface, most / fewest',
                               computed=max(counts.values())/min(counts.values())))
    for name in ('2d', '3d'):
        errors = []
        for v, quantities in results.items():
            match = re.fullmatch(name + r'-0\.001-a(\d+)(?:-\w+)?', v)
            error = [q.error for q in quantities if q.name.startswith('acceleration')]
            if match and error:
                errors.append((int(match.group(1)), error[0]))
        sizes = sorted({n for n, _ in errors})
        if len(sizes) > 1:
            mean = [math.sqrt(np.mean([e**2 for n, e in errors if n == s]))
                    for s in (sizes[0], sizes[-1])]
            result.append(Quantity(f'{name}: observed order',
                                   computed=math.log(mean[0]/mean[1])/math.log(sizes[-1]/sizes[0])))
    return result


def plot(runs, path):
    fig, axes = plotting.figure(3)
    for name, label in (('2d', '2D, 10 cells a radius'), ('3d', '3D, 6 cells')):
        points = sorted((ratio(r), abs(accelerations(r)[0]/theory(r) - 1)) for r in runs
                        if re.fullmatch(name + r'-[\d.]+', r.name))
        if points:
            axes[0].loglog(*zip(*points), 'o-', label=label)
    axes[0].set(xlabel='density ratio', ylabel='error of the acceleration')
    plotting.named(axes[0])
    for prefix, style in (('crowd', 'o-'), ('crowd3d', '^:')):
        for k, n in enumerate(crowds):
            points = sorted((ratio(r), iterations(r)) for r in runs
                            if r.name.startswith(f'{prefix}{n}-') and not r.name.endswith('-host'))
            if points:
                axes[1].semilogx(*zip(*points), style, color=plotting.colours[k],
                                 label=f'{"disks" if prefix == "crowd" else "spheres"}: {n}')
    axes[1].set(xlabel='density ratio', ylabel='iterations to 1e-10', ylim=(0, None))
    plotting.named(axes[1])
    for r in runs:
        if r.name.startswith(('weak', '2d-0.5')) and not r.name.endswith('Faces'):
            a = np.abs(accelerations(r))/g
            axes[2].semilogy(range(1, len(a) + 1), a, 'o-', label=r.name, markersize=3)
    axes[2].set(xlabel='step', ylabel='|acceleration| / g')
    plotting.named(axes[2])
    plotting.save(fig, path)


def sets(across, s, more='', dimensions=2, reach=2, bodies=1, surface=False):
    """`across` cells a radius; the tank's radius is `reach` of the body's; it is full, or a
    twentieth of its height is air"""
    h = radius/across
    n = math.ceil(2*reach*across) + 5
    side = n*h
    top = side/2 + 0.9*reach*radius if surface else side
    of = dict(side=side, top=top, middle=side/2, cells=n, spacing=h/2, tankRadius=reach*radius,
              bodies=bodies, depth=h, middleZ=h/2)
    if dimensions == 3:
        of.update(depth=side, middleZ=side/2, layers=n, ends='wall', dimensions=3)
    text = '; '.join(f'system/{"water" if key in ("side", "spacing", "top") else "tank"}:{key} '
                     f'{value if isinstance(value, str) else format(value, ".10g")}'
                     for key, value in of.items())
    return ['-set', f'{text}; constant/solidProperties:materials/body/rho {1000*s:g}{more}']


# coupledPCG with OpenFOAM's GAMG on the host, as in the tutorials that use it
host = ''.join(f'; system/fvSolution:solvers/p/{entry}' for entry in (
    'solver coupledPCG', 'preconditioner/preconditioner GAMG',
    'preconditioner/smoother symGaussSeidel', 'preconditioner/nVcycles 1',
    'preconditioner/nPreSweeps 1', 'preconditioner/nPostSweeps 1', 'preconditioner/nFinestSweeps 1',
    'preconditioner/directSolveCoarsest true', 'preconditioner/nCellsInCoarsestLevel 20',
    'preconditioner/tolerance 1e-2', 'preconditioner/relTol 0'))


def crowd(n, s, dimensions=2, onHost=False):
    """So many disks of a radius of about five cells, a third of the tank, or spheres of three, a
    fifth of it"""
    more = host if onHost else ''
    name = f'crowd{"" if dimensions == 2 else "3d"}{n}-{s:g}{"-host" if onHost else ""}'
    if dimensions == 2:
        return Variant(name,
                       sets(10, s, more, reach=max(2.0, math.sqrt(n*5.6**2/0.33)/10), bodies=n))
    reach = max(0.8, math.cbrt(n*3.6**3/0.2)/10)
    more += (f'; system/tank:radius {0.3*radius:g}; system/water:spacing {radius/10:g}; '
             'seeds/perDirection 1; system/controlDict:endTime 3e-4; '
             'system/controlDict:writeFormat binary')
    return Variant(name, sets(10, s, more, dimensions=3, reach=reach, bodies=n), large=n > 100)


def underSurface(n, s):
    """Disks as in crowd(), in water that is open above"""
    return Variant(f'surface{n}-{s:g}',
                   sets(10, s, reach=max(2.0, math.sqrt(n*5.6**2/0.33)/10), bodies=n, surface=True))


onFaces = '; system/tank:offset (0 0 0)'
atEdges = '; system/tank:offset (0.5 0.5 0.5)'
Study(
    scene='picFreeBody',
    variants=[Variant(f'2d-{s:g}', sets(10, s)) for s in ratios]
    + [Variant(f'2d-0.001-a{n}{name}', sets(n, 1e-3, at)) for n in (5, 10, 20)
       for name, at in (('-onFaces', onFaces), ('-edges', atEdges), ('-off', ''))]
    + [Variant(f'3d-{s:g}', sets(6, s, dimensions=3)) for s in (1e-3, 0.5, 2.7, 1e3)]
    + [Variant(f'3d-0.001-a{n}', sets(n, 1e-3, dimensions=3)) for n in (4, 8)]
    + [Variant(f'weak-{s:g}', sets(10, s, '; coupling weak'), mayFail=True) for s in weak]
    + [crowd(n, s, dimensions, onHost) for dimensions in (2, 3) for n in crowds for s in crowdRatios
       for onHost in (False, True)]
    + [underSurface(n, s) for n in crowds[:4] for s in crowdRatios],
    quick=[Variant('2d-0.001-quick', sets(10, 1e-3, onFaces)),
           Variant('2d-2.7-quick', sets(10, 2.7))],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='acceleration in the first step [m/s2]',
).main(here)
