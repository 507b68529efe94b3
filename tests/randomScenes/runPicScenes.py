#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs random scenes of picDem with bodies (picScenes.py) and says of each whether it holds

    runPicScenes.py [--seeds 1-50] [--dimensions 2] [--scale 1] [--end 0.5] [--jobs 2] [--keep FOLDER] [--limit SECONDS]

A line a scene: PASS or FAIL, then what was measured. A scene holds if
- it runs to its end, and each pressure is solved;
- no particle of water or of a body is lost, or in a wall at the end;
- its energy (water and bodies, contacts included) never grows by more than 1 % of what it had at the start, heights counted from the tank's lowest corner (not with openings);
- momentum of water, bodies and walls balances: each step to 1e-6 of its impulses without `reflection` (single precision 1e-4), with it half of the steps to 5e-3 and their sum to 2 %;
- the same run with another number of threads, and one that goes on from its middle, end with the same bits.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../etc/python'))
from picScenes import PicScene     # noqa: E402
from runScenes import table     # noqa: E402
from riprap.clouds import readPositions, times     # noqa: E402

STATE = 'uniform/riprap/picState'


def growth(folder, scene, mass):
    """Largest rise of the energy above what it was before, over the energy of the start; medians of three samples"""
    e, s = table(folder, 'energy'), table(folder, 'solids')
    if len(e.get('total', [])) < 4 or len(e['total']) != len(s.get('total', [])):
        return float('nan')
    total = e['total'] + s['total']
    smooth = np.median([total[:-2], total[1:-1], total[2:]], axis=0)
    start = max(total[0] - mass*scene.floorPotential(), e['kinetic'].max())
    return float((smooth - np.minimum.accumulate(smooth)).max()/start)


def unbalance(folder, axes):
    """Residual of momentum over the impulses: the median and the largest of a step, and of all steps together"""
    m = table(folder, 'momentum')
    if len(m.get('Time', [])) < 4:
        return float('nan'), float('nan'), float('nan')
    parts = {n: np.stack([m[n + a][1:] for a in axes]) for n in ('water', 'gravity', 'walls', 'solids', 'other', 'residual')}
    impulse = sum(np.abs(parts[n]).sum(axis=0) for n in ('water', 'gravity', 'walls', 'solids', 'other'))
    residual = np.abs(parts['residual']).sum(axis=0)/np.maximum(impulse, 1e-300)
    return float(np.median(residual)), float(residual.max()), float(np.abs(parts['residual'].sum(axis=1)).sum()/impulse.sum())


class Run:
    def __init__(self, seed, options):
        self.seed, self.options, self.faults = seed, options, []
        self.folder = os.path.join(options.keep, str(seed))
        self.scene = PicScene(seed, options.scale)
        self.scene.end = float('%.3g' % (self.scene.end*options.end))

    def program(self, name, folder, threads=1):
        """Its log; a fault unless it ends well"""
        path = os.path.join(folder, 'log.' + name)
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads))
        with open(path, 'w') as log:
            try:
                status = subprocess.run([name], cwd=folder, stdout=log, stderr=subprocess.STDOUT, env=environment, timeout=self.options.limit).returncode
            except subprocess.TimeoutExpired:
                status = 'time'
        with open(path) as f:
            text = f.read()
        if status:
            why = re.findall(r'(Guard at[^\n]*|FATAL[^\n]*\n[^\n]*)', text)
            reached = re.findall(r'^Time = (\S+)', text, re.M)
            self.faults.append('%s %s at %s of %g: %s' % (name, status, reached[-1] if reached else '-', self.scene.end, ' '.join(why)[:300].replace('\n', ' ')))
        return text

    def state(self, folder):
        with open(os.path.join(folder, times(folder)[-1], STATE), 'rb') as f:
            return f.read()

    def repeats(self):
        whole, middle = self.state(self.folder), times(self.folder)[1]
        for name, keep, threads in (('another run', '0', 2), ('a continued run', middle, 1)):
            again = self.folder + '.again'
            shutil.rmtree(again, ignore_errors=True)
            os.makedirs(again)
            for part in ('constant', 'system', keep):
                shutil.copytree(os.path.join(self.folder, part), os.path.join(again, part))
            text = self.program('riprapFoam', again, threads)
            if keep == middle and 'Continuing exactly' not in text:
                self.faults.append('it does not continue exactly')
            elif not self.faults and self.state(again) != whole:
                self.faults.append(name + ' has other bits')
            if not self.options.kept:
                shutil.rmtree(again)

    def lost(self, log):
        count = int((re.findall(r'Escaped through walls in all: (\d+)', log) or ['0'])[-1])
        if count:
            self.faults.append('%d through walls' % count)
        first, last = times(self.folder)[0], times(self.folder)[-1]
        for cloud in ('fluid', 'solids'):
            now, before = (readPositions(os.path.join(self.folder, t, 'lagrangian', cloud, 'positions')) for t in (last, first))
            if cloud == 'solids' and len(now) != len(before):
                self.faults.append('%d of %s lost' % (len(before) - len(now), cloud))
            hidden = self.scene.behind(now)
            if hidden:
                self.faults.append('%d of %s in walls' % (hidden, cloud))

    def check(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.scene.files(self.folder)
        start, log, mass = time.time(), '', []
        for name in ('blockMesh', 'setParticles', 'riprapFoam'):
            if not self.faults:
                log = self.program(name, self.folder)
                mass = mass or re.findall(r'total: .*mass (\S+) kg', log)
        rise = growth(self.folder, self.scene, float(mass[0])) if mass else float('nan')
        if not self.scene.opens and not rise <= 0.01:
            self.faults.append('energy grows')
        median, largest, whole = unbalance(self.folder, 'XZ' if self.scene.dim == 2 else 'XYZ')
        bound = 1e-6 if self.scene.precision == 'double' else 1e-4
        if not (largest <= bound if not self.scene.reflection else median <= 5e-3 and whole <= 0.02):
            self.faults.append('momentum does not balance')
        if 'not converged' in log:
            self.faults.append('a pressure is not solved')
        if not self.faults:
            self.lost(log)
        if not self.faults:
            self.repeats()
        steps = (re.findall(r'Particle steps = \d+ \((\d+)\)', log) or ['0'])[-1]
        print('%s random bodies in water %d: %dD, %s%s, %d of %s, %s, %s%s steps, %.1f s, energy %+.3f %%, momentum %.0e %.0e %.0e%s' % (
            'FAIL' if self.faults else 'PASS', self.seed, self.scene.dim, self.scene.kind, ' in a stream' if self.scene.opens else '', len(self.scene.materials),
            ' '.join('%.2g' % (rho/1000) for rho in self.scene.materials), self.scene.precision, '' if self.scene.reflection else 'without reflection, ', steps,
            time.time() - start, 100*rise, median, largest, whole, '; ' + '; '.join(self.faults) if self.faults else ''), flush=True)
        return not self.faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--seeds', default='1-50')
    parser.add_argument('--scale', type=int, default=1)
    parser.add_argument('--end', type=float, default=1, help='part of the time that a scene has')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--keep')
    parser.add_argument('--dimensions', type=int, help='2 or 3: the others are passed over')
    parser.add_argument('--limit', type=float, default=300)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        options.kept = bool(options.keep)
        options.keep = options.keep or scratch
        seeds = []
        for part in options.seeds.split(','):
            first, _, last = part.partition('-')
            seeds += range(int(first), int(last or first) + 1)
        seeds = [s for s in seeds if options.dimensions in (None, PicScene(s, 1).dim)]
        with ThreadPoolExecutor(options.jobs) as pool:
            good = list(pool.map(lambda s: Run(s, options).check(), seeds))
    print('%d of %d scenes hold' % (sum(good), len(good)))
    return 0 if all(good) else 1


if __name__ == '__main__':
    sys.exit(main())
