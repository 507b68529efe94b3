# SPDX-License-Identifier: GPL-3.0-or-later
"""What runners of random scenes share: programs and why they stopped, the same bits again, seeds,
options"""
import argparse
import os
import re
import shutil
import signal
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

from riprap.clouds import times

PROGRAMS = ('blockMesh', 'setParticles', 'riprapFoam')


def program(name, folder, threads, limit, end):
    """Its log, and why it did not end well or nothing. limit: of its processor time [s], which
    other programs beside it do not lengthen; four times that by the clock"""
    path = os.path.join(folder, 'log.' + name)
    with open(path, 'w') as log:
        try:
            command = 'ulimit -t %d; exec "$0"' % (limit*threads)
            status = subprocess.run(['bash', '-c', command, name], cwd=folder, stdout=log,
                                    stderr=subprocess.STDOUT,
                                    env=dict(os.environ, OMP_NUM_THREADS=str(threads)),
                                    timeout=4*limit).returncode
            if status in (-signal.SIGXCPU, -signal.SIGKILL):
                status = 'time'
        except subprocess.TimeoutExpired:
            status = 'time'
    with open(path) as f:
        text = f.read()
    if not status:
        return text, ''
    why = re.findall(r'(Guard at[^\n]*|FATAL[^\n]*\n[^\n]*)', text)
    reached = re.findall(r'^Time = (\S+)', text, re.M)
    return text, '%s %s at %s of %g: %s' % (name, status, reached[-1] if reached else '-', end,
                                            ' '.join(why)[:300].replace('\n', ' '))


class SceneRun:
    """A scene, its runs and what is wrong with them. state: file of the exact state below a time"""

    def __init__(self, scene, seed, options, state=None):
        self.scene, self.seed, self.options, self.faults, self.exact = (scene, seed, options, [],
                                                                        state)
        self.folder = os.path.join(options.keep, str(seed))

    def program(self, name, folder, threads=1):
        """Its log; a fault unless it ends well"""
        text, fault = program(name, folder, threads, self.options.limit, self.scene.end)
        if fault:
            self.faults.append(fault)
        return text

    def files(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.scene.files(self.folder)

    def run(self, threads=1):
        """All programs, up to one that fails: the last log, and the mass of the particles [kg] or
        None"""
        log, mass = '', None
        for name in PROGRAMS:
            if not self.faults:
                log = self.program(name, self.folder, threads)
                found = re.findall(r'total: .*mass (\S+) kg', log)
                mass = float(found[0]) if mass is None and found else mass
        return log, mass

    def state(self, folder):
        with open(os.path.join(folder, times(folder)[-1], self.exact), 'rb') as f:
            return f.read()

    def repeats(self):
        """Another run, with two threads, and one from the middle, end with the same bits"""
        whole, middle = self.state(self.folder), times(self.folder)[1]
        for name, keep, threads in (('another run', '0', 2), ('a continued run', middle, 1)):
            again = self.folder + '.again'
            shutil.rmtree(again, ignore_errors=True)
            os.makedirs(again)
            for part in {'constant', 'system', '0', keep}:
                shutil.copytree(os.path.join(self.folder, part), os.path.join(again, part))
            text = self.program('riprapFoam', again, threads)
            if keep == middle and 'Continuing exactly' not in text:
                self.faults.append('it does not continue exactly')
            if not self.faults and self.state(again) != whole:
                self.faults.append(name + ' has other bits')
            if not self.options.kept:
                shutil.rmtree(again)


def parser(text):
    """Options that all runners have"""
    p = argparse.ArgumentParser(description=text,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument('--seeds', default='1-50')
    p.add_argument('--scale', type=int, default=1)
    p.add_argument('--jobs', type=int, default=os.cpu_count())
    p.add_argument('--keep')
    p.add_argument('--dimensions', type=int, help='2 or 3: the others are passed over')
    p.add_argument("--limit", type=float, default=300,
                   help="of each program, processor time [s]")
    return p


def runAll(options, dimensions, check):
    """check(seed, options) of each seed, several at once. dimensions(seed): of its scene. Exit
    status"""
    with tempfile.TemporaryDirectory() as scratch:
        options.kept = bool(options.keep)
        options.keep = options.keep or scratch
        seeds = []
        for part in options.seeds.split(','):
            first, _, last = part.partition('-')
            seeds += range(int(first), int(last or first) + 1)
        seeds = [s for s in seeds if options.dimensions in (None, dimensions(s))]
        with ThreadPoolExecutor(options.jobs) as pool:
            good = list(pool.map(lambda s: check(s, options), seeds))
    print('%d of %d scenes hold' % (sum(good), len(good)))
    return 0 if all(good) else 1
