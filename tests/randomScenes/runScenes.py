#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs random scenes with an empty sphProperties and says of each whether it holds

    runScenes.py [--seeds 1-50] [--dimensions 2] [--scale 1] [--set "entry value; ..;"] [--jobs 2]
        [--keep FOLDER] [--limit SECONDS]

A line a scene: PASS or FAIL, then what was measured. A scene holds if
- it runs to its end;
- nothing leaves but through an open top, no particle of water or of a body is in a wall at the end
  (plates have no inside), and none of water in a body;
- no pair can have been missed;
- its energy never grows by more than 1 %: energy of bodies counted in, what moving walls do, and
  what the pressure of walls does (docs/theory, Energy). Of walls that do not move riprap does not
  sum the latter: a scene whose energy grows without it is run once more with walls whose motion has
  no amplitude.
"""
import glob
import os
import re
import sys
import time

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../etc/python'))
from makeScene import Scene     # noqa: E402
from sceneRuns import SceneRun, parser, runAll     # noqa: E402
from riprap.clouds import readPositions, times     # noqa: E402


def table(folder, name):
    """Columns of the function object's table, by name"""
    rows, names = [], []
    for path in sorted(glob.glob(os.path.join(folder, 'postProcessing', name, '*', '*.dat'))):
        with open(path) as f:
            for line in f:
                if line.startswith('#'):
                    names = line[1:].split()
                else:
                    rows.append([float(x) for x in line.split()])
    width = min(map(len, rows)) if rows else 0
    values = np.array([r[:width] for r in rows]) if rows else np.zeros((0, len(names)))
    return {n: values[:, k] for k, n in enumerate(names[:width])}


def growth(folder, scene, mass):
    """Largest rise of the energy above what it was before, over the energy of the start, heights
    counted from the tank's lowest corner; and the most that the pressure of walls has given in all.
    What moving walls do is counted, and what the pressure of walls does beyond that. Medians of
    three samples: where nothing moves that is not summed, and single samples of an impact dip by up
    to 3 % and come back"""
    e = table(folder, 'energy')
    if not len(e.get('Time', [])):
        return float('nan'), 0
    balance = e['total'] - e['wallWork'] - e['wallPressureWork'] - e['stiffening']
    kinetic = e['kinetic'].max()
    start = e['total'][0] - mass*scene.floorPotential()
    s = table(folder, 'solids')
    if len(s.get('total', [])) == len(balance):
        balance = balance + s['total']
    smooth = (np.median([balance[:-2], balance[1:-1], balance[2:]], axis=0) if len(balance) > 2
              else balance)
    whole = max(start, kinetic)
    return (float((smooth - np.minimum.accumulate(smooth)).max()/whole),
            float(e['wallPressureWork'].max()/whole))


def behind(folder, scene, cloud):
    """Particles in walls at the end; of solids, whose contacts are soft, their centres"""
    last = times(folder)[-1]
    path = os.path.join(folder, last, 'lagrangian', cloud, 'positions')
    return scene.behind(readPositions(path), float(last)) if os.path.exists(path) else 0


def inBody(folder, scene):
    """Particles of water in the body at the end"""
    first, last = times(folder)[0], times(folder)[-1]

    def at(time, cloud):
        return readPositions(os.path.join(folder, time, 'lagrangian', cloud, 'positions'))

    return scene.inBody(at(last, 'fluid'), at(first, 'solids'), at(last, 'solids'))


# Walls that move by nothing: their pressure's work is summed
STILL = (
    'walls { motion { still { patches (".*"); solidBodyMotionFunction oscillatingLinearMotion; '
    'oscillatingLinearMotionCoeffs { amplitude (0 0 0); omega 1; } } } }')


def setEntries(folder, text):
    with open(os.path.join(folder, 'constant', 'sphProperties'), 'a') as f:
        f.write('#inputMode merge\n' + text + '\n')


def withWallWork(seed, options, mass):
    """Growth of the same scene with the work of fixed walls' pressure counted in, or not a
    number"""
    its = SceneRun(Scene(seed, options.scale), seed, options)
    its.folder += '.still'
    its.files()
    for text in filter(None, (options.set, STILL)):
        setEntries(its.folder, text)
    its.run(options.threads)
    return float('nan') if its.faults else growth(its.folder, its.scene, mass)[0]


def run(seed, options):
    its = SceneRun(Scene(seed, options.scale), seed, options)
    folder, scene, faults = its.folder, its.scene, its.faults
    its.files()
    if options.set:
        setEntries(folder, options.set)
    start = time.time()
    text, mass = its.run(options.threads)
    ended = not faults
    lost = int((re.findall(r'Escaped through walls in all: (\d+)', text) or ['0'])[-1])
    if lost:
        faults.append('%d through walls' % lost)
    wild = (re.findall(r'Taken out in all: (\d+)', text) or ['0'])[-1]
    rise, lent = growth(folder, scene, mass) if mass else (float('nan'), 0)
    told = '%+.3f %%' % (100*rise)
    if ended and rise > 0.01 and not scene.motion:
        rise = withWallWork(seed, options, mass)
        told += ' (%+.3f %% with what the pressure of fixed walls does)' % (100*rise)
    if not rise <= 0.01:
        faults.append('energy grows')
    if ended:
        hidden = {cloud: behind(folder, scene, cloud) for cloud in ('fluid', 'solids')}
        faults += ['%d of %s in walls' % (n, cloud) for cloud, n in hidden.items() if n]
        wet = inBody(folder, scene) if scene.bodies else 0
        if wet:
            faults.append('%d of fluid in the body' % wet)
    if 'Missed pairs' in text:
        faults.append('missed pairs')
    counts = re.findall(r'Put back at faces of walls: (\d+)', text)
    particles = (re.findall(r'fluid (\d+), walls', text) or ['0'])[0]
    steps = (re.findall(r'Particle steps = \d+ \((\d+)\)', text) or ['0'])[-1]
    print('%s random scene %d: %dD, %s particles, %s steps, %.0f s, energy %s, '
          'lent by walls %.1f %%, put back %s, taken out %s%s' % (
              'FAIL' if faults else 'PASS', seed, scene.dim, particles, steps, time.time() - start,
              told, 100*lent, counts[-1] if counts else 0, wild,
              '; ' + '; '.join(faults) if faults else ''), flush=True)
    return not faults


def main():
    options = parser(__doc__)
    options.add_argument('--set')
    options.add_argument('--threads', type=int, default=1)
    return runAll(options.parse_args(), lambda s: Scene(s, 1).dim, run)


if __name__ == '__main__':
    sys.exit(main())
