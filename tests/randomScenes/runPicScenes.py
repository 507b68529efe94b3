#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs random scenes of picDem with bodies (picScenes.py) and says of each whether it holds

    runPicScenes.py [--seeds 1-50] [--dimensions 2] [--scale 1] [--end 0.5] [--jobs 2]
        [--keep FOLDER] [--limit SECONDS]

A line a scene: PASS or FAIL, then what was measured. A scene holds if
- it runs to its end, and each pressure is solved;
- no particle of water or of a body is lost (bodies leave by openings), or in a wall or an obstacle
  at the end: of water by 0.01 cells of the obstacle as the grid has it, of bodies by 0.05 cells of
  its exact shape;
- its energy (water and bodies, contacts included) never grows by more than 1 % of what it had at
  the start, heights counted from the tank's lowest corner (not with openings);
- momentum of water, bodies and walls balances: each step to 1e-6 of its impulses (single precision
  1e-4);
- the same run with another number of threads, and one that goes on from its middle, end with the
  same bits.
"""
import os
import re
import sys
import time

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../etc/python'))
from picScenes import PicScene     # noqa: E402
from runScenes import table     # noqa: E402
from sceneRuns import SceneRun, parser, runAll     # noqa: E402
from riprap.clouds import readPositions, times     # noqa: E402


def growth(folder, scene, mass):
    """Largest rise of the energy above what it was before, over the energy of the start; medians of
    three samples"""
    e, s = table(folder, 'energy'), table(folder, 'solids')
    if len(e.get('total', [])) < 4 or len(e['total']) != len(s.get('total', [])):
        return float('nan')
    total = e['total'] + s['total']
    smooth = np.median([total[:-2], total[1:-1], total[2:]], axis=0)
    start = max(total[0] - mass*scene.floorPotential(), e['kinetic'].max())
    return float((smooth - np.minimum.accumulate(smooth)).max()/start)


def unbalance(folder, axes):
    """Residual of momentum over the impulses: the median and the largest of a step, and of all
    steps together"""
    m = table(folder, 'momentum')
    if len(m.get('Time', [])) < 4:
        return float('nan'), float('nan'), float('nan')
    parts = {n: np.stack([m[n + a][1:] for a in axes])
             for n in ('water', 'gravity', 'walls', 'solids', 'other', 'residual')}
    impulse = sum(np.abs(parts[n]).sum(axis=0)
                  for n in ('water', 'gravity', 'walls', 'solids', 'other'))
    residual = np.abs(parts['residual']).sum(axis=0)/np.maximum(impulse, 1e-300)
    return (float(np.median(residual)), float(residual.max()),
            float(np.abs(parts['residual'].sum(axis=1)).sum()/impulse.sum()))


class Run(SceneRun):
    def __init__(self, seed, options):
        super().__init__(PicScene(seed, options.scale), seed, options, 'uniform/riprap/picState')
        self.scene.end = float('%.3g' % (self.scene.end*options.end))

    def lost(self, log):
        count = int((re.findall(r'Escaped through walls in all: (\d+)', log) or ['0'])[-1])
        if count:
            self.faults.append('%d through walls' % count)
        first, last = times(self.folder)[0], times(self.folder)[-1]
        for cloud in ('fluid', 'solids'):
            now, before = (readPositions(os.path.join(self.folder, t, 'lagrangian', cloud,
                                                      'positions')) for t in (last, first))
            # bodies may leave by an opening
            if cloud == 'solids' and len(now) != len(before) and not self.scene.opens:
                self.faults.append('%d of %s lost' % (len(before) - len(now), cloud))
            hidden = self.scene.behind(cloud, now)
            if hidden:
                self.faults.append('%d of %s in walls' % (hidden, cloud))

    def check(self):
        self.files()
        start = time.time()
        log, mass = self.run()
        rise = growth(self.folder, self.scene, mass) if mass else float('nan')
        if not self.scene.opens and not rise <= 0.01:
            self.faults.append('energy grows')
        median, largest, whole = unbalance(self.folder, 'XZ' if self.scene.dim == 2 else 'XYZ')
        bound = 1e-6 if self.scene.precision == 'double' else 1e-4
        if not largest <= bound:
            self.faults.append('momentum does not balance')
        if 'not converged' in log:
            self.faults.append('a pressure is not solved')
        if not self.faults:
            self.lost(log)
        if not self.faults:
            self.repeats()
        steps = (re.findall(r'Particle steps = \d+ \((\d+)\)', log) or ['0'])[-1]
        print('%s random bodies in water %d: %dD, %s%s, %d of %s, %s, %s%s steps, %.1f s, '
              'energy %+.3f %%, momentum %.0e %.0e %.0e%s' % (
                  'FAIL' if self.faults else 'PASS', self.seed, self.scene.dim, self.scene.kind,
                  ' in a stream' if self.scene.opens else '', len(self.scene.materials),
                  ' '.join('%.2g' % (rho/1000) for rho in self.scene.materials),
                  self.scene.precision, '' if self.scene.reflection else 'without reflection, ',
                  steps, time.time() - start, 100*rise, median, largest, whole,
                  '; ' + '; '.join(self.faults) if self.faults else ''), flush=True)
        return not self.faults


def main():
    options = parser(__doc__)
    options.add_argument('--end', type=float, default=1, help='part of the time that a scene has')
    return runAll(options.parse_args(), lambda s: PicScene(s, 1).dim,
                  lambda s, options: Run(s, options).check())


if __name__ == '__main__':
    sys.exit(main())
