#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Is a run that stops and goes on the same to the bit as one that does not stop?

    runRestarts.py [--short] [--keep FOLDER] [--limit SECONDS] [PATTERN ...]

A line of variants.tsv is a tutorial with options. It is run to 2 T; from what was written at T to 2
T; and to endTime T and, with another endTime, to 2 T. PASS: continued runs said `Continuing
exactly`, and the files of particles, fields and states at 2 T are the same. --short: the lines
marked so, for each test of riprap.
"""
import argparse
import fnmatch
import os
import shutil
import subprocess
import sys
import tempfile
import time

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.normpath(os.path.join(here, '..', '..'))


class Stopped(Exception):
    pass


def variants():
    with open(os.path.join(here, 'variants.tsv')) as f:
        for line in f:
            if line.strip() and not line.startswith('#'):
                name, short, tutorial, T, options = (line.rstrip('\n').split('\t') + [''])[:5]
                yield name, short == 'short', tutorial, T, options


def run(command, folder, log, limit):
    environment = dict(os.environ, RIPRAP_DIR=root)
    with open(log, 'w') as out:
        try:
            status = subprocess.run(command, cwd=folder, env=environment, stdout=out,
                                    stderr=subprocess.STDOUT, timeout=limit).returncode
        except subprocess.TimeoutExpired:
            raise Stopped(f'{command[0]} took more than {limit} s') from None
    if status:
        raise Stopped(f'{os.path.basename(command[0])} ended with {status}: {reason(log)}')


def reason(log):
    with open(log, errors='replace') as f:
        lines = [line.strip() for line in f]
    fatal = next((i for i, line in enumerate(lines) if 'FATAL' in line), len(lines) - 3)
    return ' '.join(line for line in lines[fatal + 1:fatal + 6] if line)


def control(folder, entries):
    for entry, value in entries.items():
        subprocess.run(['foamDictionary', 'system/controlDict', '-disableFunctionEntries', '-entry',
                        entry, '-set', value], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def times(folder):
    def isTime(name):
        try:
            return float(name) >= 0
        except ValueError:
            return False
    return sorted((n for n in os.listdir(folder) if isTime(n)), key=float)


def latest(folder):
    return times(folder)[-1]


def written(folder):
    """Files of the last time, but for what counts the time steps of OpenFOAM and sums up the
    others"""
    top = os.path.join(folder, latest(folder))
    names = (os.path.relpath(os.path.join(path, name), top) for path, _, files in os.walk(top)
             for name in files)
    return {name: os.path.join(top, name) for name in names
            if name != 'uniform/time' and 'functionObject' not in name and 'manifest' not in name}


def contents(path):
    with open(path, 'rb') as f:
        return f.read()


def differences(a, b):
    one, other = written(a), written(b)
    if latest(a) != latest(b) or latest(a) == '0':
        return [f'times {latest(a)} and {latest(b)}']
    return (sorted(set(one) ^ set(other))
            + sorted(n for n in one if n in other and contents(one[n]) != contents(other[n])))


def start(case, whole, name, steps):
    """A copy of a run, from its times up to a number of writes after the start"""
    folder = os.path.join(case, 'runs', name)
    shutil.copytree(whole, folder,
                    ignore=shutil.ignore_patterns('postProcessing', 'VTK', 'log.riprapFoam*'))
    while len(times(folder)) > 1 + steps:
        shutil.rmtree(os.path.join(folder, latest(folder)))
    return folder


def goOn(folder, entries, limit):
    control(folder, entries)
    log = os.path.join(folder, 'log.riprapFoam')
    run(['riprapFoam'], folder, log, limit)
    with open(log) as f:
        return f.read()


def compared(log, whole, folder):
    """Why a run that says that it continues exactly has not; empty: it has"""
    if 'Continuing exactly' not in log:
        return next((line for line in log.split('\n') if 'is not used' in line
                     or 'passed over' in line), 'it does not say that it continues')
    other = differences(whole, folder)
    return f'{len(other)} files differ: {" ".join(other[:6])}' if other else ''


def check(tutorial, T, options, folder, limit):
    """Why a variant is not continued exactly; empty: it is"""
    case = os.path.join(folder, os.path.basename(tutorial))
    shutil.copytree(os.path.join(root, 'tutorials', tutorial), case,
                    ignore=shutil.ignore_patterns('runs'))
    end = f'{2*float(T):.12g}'
    sets = ['system/controlDict:writeControl adjustableRunTime',
            f'system/controlDict:writeInterval {T}', 'system/controlDict:purgeWrite 0']
    sets += [s for s in [options] if s]
    run([os.path.join(case, 'Allrun'), '-noPlot', '-name', 'whole', '-endTime', end, '-set',
         '; '.join(sets)], case, folder + '/log', limit)
    whole = os.path.join(case, 'runs', 'whole')

    continued = start(case, whole, 'continued', 1)
    why = compared(goOn(continued, {'startFrom': 'latestTime'}, limit), whole, continued)
    if why:
        return why
    # With an endTime that is moved on what depends on it may be another; then the log must say so
    extended = start(case, whole, 'extended', 0)
    goOn(extended, {'endTime': T}, limit)
    log = goOn(extended, {'endTime': end, 'startFrom': 'latestTime'}, limit)
    if (
            'is not used: walls move beyond the domain' in log
            or 'is not used: saved state: it is of another domain' in log):
        return ''
    why = compared(log, whole, extended)
    return f'endTime moved on: {why}' if why else ''


def main():
    parser = argparse.ArgumentParser(prog='runRestarts.py')
    parser.add_argument('patterns', nargs='*', metavar='PATTERN', help='names of variants')
    parser.add_argument('--short', action='store_true', help='those marked short')
    parser.add_argument('--keep', help='leave the cases in this folder')
    parser.add_argument('--limit', type=float, default=300, help='seconds that a program may take')
    options = parser.parse_args()

    failed = done = 0
    for name, short, tutorial, T, sets in variants():
        if options.short and not short or options.patterns and not any(fnmatch.fnmatch(name, p)
                                                                       for p in options.patterns):
            continue
        done += 1
        start = time.time()
        with tempfile.TemporaryDirectory() as scratch:
            folder = os.path.join(options.keep or scratch, 'tutorials', name.replace('/', '_'))
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder)
            try:
                why = check(tutorial, T, sets, folder, options.limit)
            except Stopped as problem:
                why = str(problem)
        failed += bool(why)
        print(f'{"FAIL" if why else "PASS"} restart {name}'
              + (f' {why}' if why else f': {time.time() - start:.0f} s'), flush=True)
    if not done:
        print('FAIL restart no variant has that name')
    return 1 if failed or not done else 0


if __name__ == '__main__':
    sys.exit(main())
