# SPDX-License-Identifier: GPL-3.0-or-later
"""A wedge, a cylinder or a sphere enters water: its velocity and way against boundary elements,
theory and experiments"""
import os
import sys

import numpy as np

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)

from impactTheory import Cylinder, Sphere, Wedge, check, entry, g  # noqa: E402
from riprap import clouds, plotting  # noqa: E402
from riprap.bounds import Quantity  # noqa: E402
from riprap.dictionaries import numberOf  # noqa: E402
from riprap.study import Study, Variant  # noqa: E402


class Entry:
    """Time from the touch, depth and velocity of the run's body, and of theory over the depth"""

    def __init__(self, run):
        body, tank = run.dictionary('system/body'), run.dictionary('system/tank')
        self.kind, self.size = run.dictionary('system/shape')['shape'], numberOf(body['size'])
        self.deadrise = round(numberOf(body['deadrise']))
        self.shape = {'wedge': lambda: Wedge(self.size, self.deadrise),
                      'cylinder': lambda: Cylinder(self.size),
                      'sphere': lambda: Sphere(self.size)}[self.kind]()
        table = run.table('body', 'groupMotion.dat')
        y, self.x = table['freeCentreY'], table['freeCentreX']
        gap = numberOf(body['gap'])*run.spacing
        self.s, self.v = y[0] - y - gap, -table['freeUy']
        self.touch = np.sqrt(numberOf(body['vertical'])**2 + 2*g*gap)
        self.t = table['Time'] - (self.touch + numberOf(body['vertical']))/g
        self.ratio = numberOf(run.solid['materials']['body']['rho'])/run.density
        self.depths, self.theory = entry(self.shape, self.ratio, self.touch)
        self.width = numberOf(tank['width'])
        self.reference = self.boundaryElements()

    def boundaryElements(self):
        """Name of the file in reference/ for this body and velocity, if there is one"""
        if self.kind == 'wedge' and self.deadrise == 25 and abs(self.touch - 5.05) < 0.1:
            return 'wedge25'
        if (
                self.kind == 'cylinder' and abs(self.size - 0.055) < 1e-6
                and abs(self.touch - 2.955) < 0.1 and self.ratio in (0.5, 1)):
            return f'cylinder{1000*self.ratio:.0f}'
        return None

    @property
    def inside(self):
        return (self.s > 0) & (self.s <= self.shape.end)

    def atTheory(self):
        return np.interp(self.s[self.inside], self.depths, self.theory)


def read(name):
    return np.loadtxt(os.path.join(here, 'reference', name + '.csv'), delimiter=',', skiprows=1).T


def againstElements(e):
    t, values = read(e.reference + '_bem')
    if e.kind == 'wedge':
        t = 1e-3*t
        at = t <= e.t[-1]
        v = np.interp(t[at], e.t, e.v)
        return [Quantity('velocity, largest difference / entry',
                         error=float(np.abs(v - values[at]).max()/e.touch)),
                Quantity('velocity after 20 ms [m/s]', np.interp(0.02, e.t, e.v),
                         np.interp(0.02, t, values),
                         float(abs(np.interp(0.02, e.t, e.v)/np.interp(0.02, t, values) - 1)))]
    D = 2*e.size
    t = t*np.sqrt(D/g)
    at = (t > 0) & (t <= e.t[-1])
    s = np.interp(t[at], e.t, e.s)/D
    last = s[-1]/values[at][-1] - 1
    return (
        [Quantity('penetration, largest difference [D]', error=float(np.abs(s - values[at]).max())),
         Quantity('mean velocity to the end [m/s]', s[-1]*D/t[at][-1], values[at][-1]*D/t[at][-1],
                  float(abs(last)))])


def againstTheory(e, name):
    if e.s[-1] < e.shape.end:
        raise ValueError(
            f'{name}: the run ends at a depth of {e.s[-1]:.4g} m, before {e.shape.end:.4g} m')
    v, theory = e.v[e.inside], e.atTheory()
    return [Quantity('velocity, largest difference', error=float(np.abs(v/theory - 1).max())),
            Quantity('velocity at the end [m/s]', v[-1], theory[-1],
                     float(abs(v[-1]/theory[-1] - 1))),
            Quantity('velocity lost [m/s]', e.touch - v[-1], e.touch - theory[-1])]


def analyse(run):
    e = Entry(run)
    names = clouds.times(run.path)
    first, last = (len(clouds.readCloud(run.path, at, ())['positions'])
                   for at in (names[0], names[-1]))
    return (againstElements(e) if e.reference else againstTheory(e, run.name)) + [
        Quantity('drift to the side / half breadth',
                 error=float(np.abs(e.x - e.x[0]).max()/e.size)),
        Quantity('particles lost', error=first - last),
        *(Quantity(f'theory: {name}', error=e)
          for name, e in zip(('closed form', 'wedge of 20 degrees, Logvinovich'), check()))]


def plot(runs, path):
    fig, (wedges, cylinders, velocity, picture) = plotting.figure(4, width=4.2)
    for name, label in (('bem', 'BEM'), ('experiment', 'experiment'), ('sph', 'SPH, Sun et al.')):
        wedges.plot(*read('wedge25_' + name),
                    linestyle=':' if name == 'sph' else '--' if name == 'bem' else 'none',
                    marker='o' if name == 'experiment' else None, markersize=3,
                    markerfacecolor='none', color='#444444', linewidth=0.9, label=label)
    for k, r in enumerate((500, 1000)):
        cylinders.plot(*read(f'cylinder{r}_bem'), '--', color='#444444', linewidth=0.9,
                       label='BEM' if k else None)
        plotting.measured(cylinders, *read(f'cylinder{r}_experiment'), f'Greenhow & Lin, {r} kg/m3',
                          k)
    for k, run in enumerate(runs):
        e, colour = Entry(run), plotting.colours[k % len(plotting.colours)]
        if e.reference == 'wedge25':
            wedges.plot(1e3*e.t, e.v, color=colour, linewidth=0.9, label=run.name)
        elif e.reference:
            cylinders.plot(e.t*np.sqrt(0.5*g/e.size), 0.5*e.s/e.size, color=colour, linewidth=0.9,
                           label=run.name)
        else:
            velocity.plot(e.s[e.inside]/e.shape.end, e.v[e.inside]/e.touch, color=colour,
                          linewidth=0.9, label=run.name)
            velocity.plot(e.depths/e.shape.end, e.theory/e.touch, color=colour, linewidth=0.9,
                          linestyle=':')
    wedges.set(xlabel='t [ms]', ylabel='velocity [m/s]', xlim=(0, 40), title='wedge of 25 degrees')
    cylinders.set(xlabel='$t\\,\\sqrt{g/D}$', ylabel='penetration / D', xlim=(0, 1.85),
                  title='cylinder of 0.11 m')
    velocity.set(xlabel='depth / depth at the end', ylabel='velocity / velocity at the touch',
                 title='dotted: theory')
    for axis in (wedges, cylinders, velocity):
        plotting.named(axis)
    drawWater(fig, picture, runs[0])
    plotting.save(fig, path)


def drawWater(fig, picture, run):
    e = Entry(run)
    at = clouds.times(run.path)[-1]
    f, b = (clouds.readCloud(run.path, at, ('p',)),
            clouds.readCloud(run.path, at, ('radius',), 'solids'))
    dots = picture.scatter(*f['positions'].T[:2], c=1e-3*f['p'], s=1)
    picture.scatter(*b['positions'].T[:2], s=1, color='#444444')
    fig.colorbar(dots, ax=picture, label='p [kPa]')
    middle, low = 0.5*e.width, b['positions'][:, 1].min()
    picture.set(aspect='equal', xlim=(middle - 2*e.size, middle + 2*e.size),
                ylim=(low - e.size, low + 1.5*e.size), title=run.name)


def of(time, *sets):
    """Runs of this time, with some hundred samples"""
    return ['-set', '; '.join([f'system/controlDict:endTime {time:.6g}',
                               f'system/controlDict:sampleInterval {time/200:.6g}',
                               f'system/controlDict:writeInterval {time/5:.6g}', *sets])]


def cylinder(speed, ratio, radius, time, width, depth):
    return of(time, 'system/shape:shape cylinder', f'system/body:size {radius}',
              f'system/body:vertical -{speed}', 'constant/solidProperties:materials/body/rho '
                                                f'{1000*ratio:g}', f'system/tank:width {width}',
              f'system/tank:depth {depth}', f'system/tank:height {depth + 0.7}')


def greenhow(ratio, end=1.85, width=2, depth=1):
    """Greenhow & Lin (1983), until t sqrt(g/D) = end. The boundary elements know no walls: 18 D by
    9 D of water"""
    return cylinder(2.955, ratio, 0.055, end*np.sqrt(0.11/g) + 0.004, width, depth)


def fast(speed):
    """A cylinder of 2700 kg/m3, until it is half immersed"""
    return cylinder(speed, 2.7, 0.1, 0.15/speed, 1.2, 0.6)


def sphere(speed):
    return of(0.06/speed, 'system/shape:shape sphere', 'system/shape:frontAndBack wall',
              'system/body:size 0.1', f'system/body:vertical -{speed}',
              'constant/solidProperties:materials/body/rho 1000', 'system/tank:width 0.6',
              'system/tank:thickness 0.6', 'system/tank:depth 0.3', 'system/tank:height 0.7')


def steep(speed):
    """The wedge of the drop test of Zhao, Faltinsen & Aarsnes (1996): 241 kg a metre, 0.5 m broad,
    until it is 0.148 m deep at this speed"""
    return of(0.148/speed, 'system/body:size 0.25', 'system/body:deadrise 30',
              f'system/body:vertical -{speed}', 'constant/solidProperties:materials/body/rho 6679',
              'system/tank:width 2', 'system/tank:depth 1', 'system/tank:height 1.6')


Study(
    scene='waterEntry',
    variants=[Variant('wedge-20mm', ['-spacing', '0.02']), Variant('wedge'), Variant('wedge-5mm', [
        '-spacing', '0.005'], large=True), Variant('wedge30', ['-spacing', '0.005', *steep(6.15)]),
              *(Variant(f'wedge30-{v}', ['-spacing', '0.005', *steep(v)]) for v in (1, 10)),
              *(Variant(f'cylinder-{r}', ['-spacing', '0.0055', *greenhow(r)]) for r in (0.5, 1)),
              *(Variant(f'cylinder-{r}-fine', ['-spacing', '0.00275', *greenhow(r)], large=True)
                for r in (0.5, 1)),
              *(Variant(f'fast-cylinder-{v}', ['-spacing', '0.005', *fast(v)]) for v in (1, 3, 10)),
              Variant('sphere-5-coarse', ['-spacing', '0.0125', *sphere(5)]),
              *(Variant(f'sphere-{v}', ['-spacing', '0.00625', *sphere(v)], large=True)
                for v in (1, 5, 10))],
    quick=[Variant('quick-wedge',
                   ['-spacing', '0.0125', '-set',
                    'system/tank:width 2; system/tank:depth 0.75; system/tank:height 1.4']),
           Variant('quick-cylinder', ['-spacing', '0.011', *greenhow(1, 0.9, 0.66, 0.33)]),
           Variant('quick-sphere', ['-spacing', '0.025', *sphere(5)])],
    analyse=analyse,
    plot=plot,
    headline='velocity after 20 ms [m/s]',
    orders=[('velocity after 20 ms [m/s]', ['wedge-20mm', 'wedge', 'wedge-5mm'])],
).main(here)
