#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs random scenes of dem (demScenes.py) and says of each whether it holds

    runDemScenes.py [--seeds 1-50] [--dimensions 2] [--scale 1] [--jobs 2] [--keep FOLDER] [--limit SECONDS]

A line a scene: PASS or FAIL, then what was measured. A scene holds if
- it runs to its end;
- nothing escapes, passes a wall or is in one at the end;
- its energy (kinetic, potential, elastic, of bonds) never grows by more than 1 % of what it had at the start, heights counted from the tank's lowest corner;
- at each sample what walls do to bodies is what bodies do to walls (momentum, to round-off of the sum of forces);
- the same run, and one that goes on from its middle, end with the same bits.
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
from demScenes import DemScene     # noqa: E402
from runScenes import table     # noqa: E402
from riprap.clouds import readField, readPositions, times     # noqa: E402

STATE = 'uniform/riprap/demState'


def growth(folder, scene, mass):
    """Largest rise of the energy above what it was before, over the energy of the start"""
    e = table(folder, 'energy')
    if len(e.get('total', [])) < 2:
        return float('nan')
    start = max(e['total'][0] - mass*scene.floorPotential(), (e['translation'] + e['rotation']).max())
    return float((e['total'] - np.minimum.accumulate(e['total'])).max()/start)


def unbalance(folder, scene):
    """Of the last time: what acts on bodies and is neither weight nor done by walls, over the sum of all that acts"""
    last = times(folder)[-1]
    cloud = os.path.join(folder, last, 'lagrangian', 'solids')
    force, mass = readField(os.path.join(cloud, 'force')), readField(os.path.join(cloud, 'mass'))
    contacts = force - mass.reshape(-1, 1)*np.array(scene.gravity())
    walls = table(folder, 'forces')
    byWalls = -np.array([sum(walls[n][-1] for n in walls if n.endswith('F' + axis)) for axis in 'xyz'])
    return float(np.abs(contacts.sum(axis=0) - byWalls).max()/max(np.abs(contacts).sum() + np.abs(force).sum(), 1e-30))


class Run:
    def __init__(self, seed, options):
        self.seed, self.options, self.faults = seed, options, []
        self.folder = os.path.join(options.keep, str(seed))
        self.scene = DemScene(seed, options.scale)
        self.log = ''

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
        """Another run, with two threads, and one from the middle"""
        whole = self.state(self.folder)
        middle = times(self.folder)[1]
        for name, keep in (('another run', '0'), ('a continued run', middle)):
            again = self.folder + '.again'
            shutil.rmtree(again, ignore_errors=True)
            os.makedirs(again)
            for part in ('constant', 'system', '0', keep):
                if not os.path.exists(os.path.join(again, part)):
                    shutil.copytree(os.path.join(self.folder, part), os.path.join(again, part))
            text = self.program('riprapFoam', again, 1 if keep == middle else 2)
            if keep == middle and 'Continuing exactly' not in text:
                self.faults.append('it does not continue exactly')
            if not self.faults and self.state(again) != whole:
                self.faults.append(name + ' has other bits')
            if not self.options.kept:
                shutil.rmtree(again)

    def check(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.scene.files(self.folder)
        start = time.time()
        mass, rise, apart = [], float('nan'), float('nan')
        for name in ('blockMesh', 'setParticles', 'riprapFoam'):
            if not self.faults:
                self.log = self.program(name, self.folder)
                mass = mass or re.findall(r'total: .*mass (\S+) kg', self.log)
        if mass:
            rise = growth(self.folder, self.scene, float(mass[0]))
        if not rise <= 0.01:
            self.faults.append('energy grows')
        lost = re.findall(r'^(?:Escaped|Passed)[^\n]*', self.log, re.M)
        if lost:
            self.faults.append('; '.join(lost)[-200:])
        if not self.faults:
            apart = unbalance(self.folder, self.scene)
            if not apart < 1e-4:
                self.faults.append('forces do not balance')
            hidden = self.scene.lost(readPositions(os.path.join(self.folder, times(self.folder)[-1], 'lagrangian', 'solids', 'positions')))
            if hidden:
                self.faults.append('%d in walls' % hidden)
            self.repeats()
        counts = (re.findall(r'solids (\d+), clumps', self.log) or ['0'])[0]
        steps = (re.findall(r'Particle steps = \d+ \((\d+)\)', self.log) or ['0'])[-1]
        overlap = (re.findall(r'overlap by (\S+) %', self.log) or ['-'])[0]
        print('%s random solids %d: %dD, %s, %s/%s/%s, %s bodies, %s steps, %.1f s, energy %+.3f %%, forces apart %.0e, overlap above 5 %%: %s%s' % (
            'FAIL' if self.faults else 'PASS', self.seed, self.scene.dim, self.scene.inside, self.scene.normal, self.scene.tangential, self.scene.rolling,
            counts, steps, time.time() - start, 100*rise, apart, overlap, '; ' + '; '.join(self.faults) if self.faults else ''), flush=True)
        return not self.faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--seeds', default='1-50')
    parser.add_argument('--scale', type=int, default=1)
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
        seeds = [s for s in seeds if options.dimensions in (None, DemScene(s, 1).dim)]
        with ThreadPoolExecutor(options.jobs) as pool:
            good = list(pool.map(lambda s: Run(s, options).check(), seeds))
    print('%d of %d scenes hold' % (sum(good), len(good)))
    return 0 if all(good) else 1


if __name__ == '__main__':
    sys.exit(main())
