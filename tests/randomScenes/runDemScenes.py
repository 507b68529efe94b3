#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs random scenes of dem (demScenes.py) and says of each whether it holds

    runDemScenes.py [--seeds 1-50] [--dimensions 2] [--scale 1] [--jobs 2] [--keep FOLDER]
        [--limit SECONDS]

A line a scene: PASS or FAIL, then what was measured. A scene holds if
- it runs to its end;
- nothing escapes, passes a wall or is in one at the end;
- its energy (kinetic, potential, elastic, of bonds) never grows by more than 1 % of what it had at
  the start, heights counted from the tank's lowest corner;
- at each sample what walls do to bodies is what bodies do to walls (momentum, to round-off of the
  sum of forces);
- the same run, and one that goes on from its middle, end with the same bits.
"""
import os
import re
import sys
import time

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../etc/python'))
from demScenes import DemScene     # noqa: E402
from runScenes import table     # noqa: E402
from sceneRuns import SceneRun, parser, runAll     # noqa: E402
from riprap.clouds import readField, readPositions, times     # noqa: E402


def growth(folder, scene, mass):
    """Largest rise of the energy above what it was before, over the energy of the start"""
    e = table(folder, 'energy')
    if len(e.get('total', [])) < 2:
        return float('nan')
    start = max(e['total'][0] - mass*scene.floorPotential(),
                (e['translation'] + e['rotation']).max())
    return float((e['total'] - np.minimum.accumulate(e['total'])).max()/start)


def unbalance(folder, scene):
    """Of the last time: what acts on bodies and is neither weight nor done by walls, over the sum
    of all that acts"""
    last = times(folder)[-1]
    cloud = os.path.join(folder, last, 'lagrangian', 'solids')
    force, mass = readField(os.path.join(cloud, 'force')), readField(os.path.join(cloud, 'mass'))
    contacts = force - mass.reshape(-1, 1)*np.array(scene.gravity())
    walls = table(folder, 'forces')
    byWalls = -np.array([sum(walls[n][-1] for n in walls if n.endswith('F' + axis))
                         for axis in 'xyz'])
    return float(np.abs(contacts.sum(axis=0)
                        - byWalls).max()/max(np.abs(contacts).sum() + np.abs(force).sum(), 1e-30))


class Run(SceneRun):
    def __init__(self, seed, options):
        super().__init__(DemScene(seed, options.scale), seed, options, 'uniform/riprap/demState')

    def check(self):
        self.files()
        start, apart = time.time(), float('nan')
        log, mass = self.run()
        rise = growth(self.folder, self.scene, mass) if mass else float('nan')
        if not rise <= 0.01:
            self.faults.append('energy grows')
        lost = re.findall(r'^(?:Escaped|Passed)[^\n]*', log, re.M)
        if lost:
            self.faults.append('; '.join(lost)[-200:])
        if not self.faults:
            apart = unbalance(self.folder, self.scene)
            if not apart < 1e-4:
                self.faults.append('forces do not balance')
            hidden = self.scene.lost(readPositions(os.path.join(
                self.folder, times(self.folder)[-1], 'lagrangian', 'solids', 'positions')))
            if hidden:
                self.faults.append('%d in walls' % hidden)
            self.repeats()
        counts = (re.findall(r'solids (\d+), clumps', log) or ['0'])[0]
        steps = (re.findall(r'Particle steps = \d+ \((\d+)\)', log) or ['0'])[-1]
        overlap = (re.findall(r'overlap by (\S+) %', log) or ['-'])[0]
        print('%s random solids %d: %dD, %s, %s/%s/%s, %s bodies, %s steps, %.1f s, '
              'energy %+.3f %%, forces apart %.0e, overlap above 5 %%: %s%s' % (
                  'FAIL' if self.faults else 'PASS', self.seed, self.scene.dim, self.scene.inside,
                  self.scene.normal, self.scene.tangential, self.scene.rolling, counts, steps,
                  time.time() - start, 100*rise, apart, overlap,
                  '; ' + '; '.join(self.faults) if self.faults else ''), flush=True)
        return not self.faults


def main():
    return runAll(parser(__doc__).parse_args(), lambda s: DemScene(s, 1).dim,
                  lambda s, options: Run(s, options).check())


if __name__ == '__main__':
    sys.exit(main())
