# SPDX-License-Identifier: GPL-3.0-or-later
"""Waves pass over a mound of rocks at rest: what does it change that they sleep, and what does it
save?"""
import os

import numpy as np

from riprap import clouds, plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant
from riprap.tables import stacked

here = os.path.dirname(os.path.abspath(__file__))
# gauges [m], as in system/controlDict
before = np.array([0.6, 0.75, 0.9, 1.05, 1.2, 1.35, 1.5, 1.65, 1.8, 1.95])
behind = np.arange(3.0, 3.75, 0.1)
diameter, omega = 0.06, 6.6633


def rocks(run):
    """Times and places of the rocks, in the same order"""
    names = clouds.times(run.path)
    places = []
    for name in names:
        cloud = clouds.readCloud(run.path, name, ('origId',), 'solids')
        places.append(cloud['positions'][np.argsort(cloud['origId']), :2])
    return np.array([float(n) for n in names]), np.array(places)


def levels(run):
    table = run.table('gauges', 'waterLevel.dat')
    return table['Time'], stacked(table, 'level') - numberOf(run.dictionary('system/tank')['depth'])


def amplitude(run, gauges):
    """Root mean square of the level over the last four periods, times the square root of 2"""
    t, eta = levels(run)
    late = t > t[-1] - 4*2*np.pi/omega
    return float(np.sqrt(2*eta[late][:, gauges].var(axis=0).mean()))


def analyse(run):
    t, x = rocks(run)
    settled = np.argmax(t >= min(1.0, t[-1]))
    way = np.hypot(*(x - x[settled])[settled:].transpose(2, 0, 1)).max()
    result = [Quantity('farthest way of a rock after 1 s / diameter', computed=float(way/diameter)),
              Quantity('end [s]', computed=float(t[-1]))]
    if t[-1] >= 8:
        result += [Quantity('amplitude before the mound [m]',
                            computed=amplitude(run, slice(0, len(before)))),
                   Quantity('amplitude behind it [m]',
                            computed=amplitude(run, slice(len(before), None)))]
    seconds, steps = run.log['executionTime'], run.log['steps']
    if seconds and steps:
        result.append(Quantity('processor time a step [s]', computed=seconds/steps))
    return result


def compare(runs, results):
    """Sleepers against those awake: places of rocks, and levels over the waves' amplitude"""
    asleep, awake = (next((r for name, r in runs.items() if name.startswith(kind)), None)
                     for kind in ('asleep', 'awake'))
    if not asleep or not awake:
        return []
    t, eta = levels(asleep)
    s, other = levels(awake)
    n = min(len(t), len(s))
    place = np.hypot(*(rocks(asleep)[1][-1] - rocks(awake)[1][-1]).T).max()
    return [Quantity('places of rocks, largest difference / diameter', error=float(place/diameter)),
            Quantity('levels, rms of the difference / rms of the levels',
                     error=float(np.sqrt(((eta[:n] - other[:n])**2).mean()/(other[:n]**2).mean())))]


def plot(runs, path):
    fig, (gauge, scene) = plotting.figure(2, width=7)
    for run in runs:
        t, eta = levels(run)
        gauge.plot(t, 1000*eta[:, len(before) + 3], linewidth=0.8, label=run.name)
    gauge.set(xlabel='t [s]', ylabel='level behind the mound [mm]')
    plotting.named(gauge)
    run = runs[0]
    name = clouds.times(run.path)[-1]
    water = clouds.readCloud(run.path, name, ('U',))
    solids = clouds.readCloud(run.path, name, ('radius',), 'solids')
    scene.scatter(*water['positions'][:, :2].T, c=np.hypot(*water['U'][:, :2].T), s=0.4,
                  cmap='Blues', vmin=-0.1, vmax=0.3)
    plotting.discs(scene, solids['positions'], solids['radius'])
    scene.set(xlim=(1.9, 3.4), ylim=(0, 0.4), aspect='equal', xlabel='x [m]',
              title=f'{run.name}, {float(name):g} s')
    scene.grid(False)
    plotting.save(fig, path)


awake = ['-set', 'constant/solidProperties:sleep/after 0']
Study(
    scene='picRubbleMound',
    variants=[Variant('asleep'), Variant('awake', awake)],
    quick=[Variant('asleep-quick', ['-endTime', '1']),
           Variant('awake-quick', ['-endTime', '1'] + awake)],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='farthest way of a rock after 1 s / diameter',
).main(here)
