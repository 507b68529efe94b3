# SPDX-License-Identifier: GPL-3.0-or-later
"""One row a run in benchmarks/results/<scene>.csv: what speed against accuracy is drawn from

RIPRAP_RESULTS names another folder.
"""
import csv
import datetime
import os
import platform
import subprocess

from .bounds import root

columns = ['date', 'scene', 'run', 'model', 'settings', 'spacing', 'particles', 'precision',
           'device', 'quantity', 'error', 'wallTime', 'deviceTime', 'steps', 'particleSteps',
           'memory', 'energyDrift', 'version', 'machine', 'simulated', 'kind']


def append(scene, run, quantity, error, kind=''):
    """run: a study.Run. kind of the error: relative, error (in the quantity's unit), or value where
    there is no error"""
    log = run.log
    row = {
        'date': datetime.date.today().isoformat(), 'scene': scene, 'run': run.name,
        'model': run.control.get('solver', 'sphDem'), 'settings': run.settings(),
        'spacing': _show(run.spacing), 'particles': _count(log['fluidParticles']),
        'precision': log['precision'] or (run.sph or run.pic or run.solid).get('precision', ''),
        'device': log['device'], 'quantity': quantity, 'error': _show(error),
        'wallTime': wallTime(log), 'deviceTime': log['deviceTime'], 'steps': _count(log['steps']),
        'particleSteps': _show(log['particleSteps']), 'memory': _count(log['memory']),
        'energyDrift': _show(run.energyDrift()), 'version': log['version'] or version(),
        'machine': machine(), 'simulated': run.control.get('endTime', ''), 'kind': kind,
    }
    folder = os.environ.get('RIPRAP_RESULTS') or os.path.join(root(), 'benchmarks', 'results')
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, scene + '.csv')
    new = not os.path.exists(path)
    known = columns
    if not new:
        with open(path, newline='') as f:
            known = next(csv.reader(f))         # a file of before `kind` keeps its columns
    with open(path, 'a', newline='') as f:
        writer = csv.DictWriter(f, known, lineterminator='\n', extrasaction='ignore')
        if new:
            writer.writeheader()
        writer.writerow(row)


def wallTime(log):
    """Whole seconds by the clock; of one thread its processor time, which a shared machine does not
    lengthen"""
    if '1 threads' in (log['device'] or ''):
        return log['executionTime'] or log['clockTime']
    return log['clockTime'] or log['executionTime']


def version():
    """git's description of the working tree"""
    try:
        return subprocess.run(['git', '-C', root(), 'describe', '--always', '--dirty', '--tags'],
                              capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ''


def machine():
    """Processor and its count of cores: no host names"""
    name = platform.processor() or platform.machine()
    try:
        with open('/proc/cpuinfo') as f:
            name = next(line.split(':', 1)[1].strip() for line in f
                        if line.startswith('model name'))
    except (OSError, StopIteration):
        pass
    return os.environ.get('RIPRAP_MACHINE') or f'{name} ({os.cpu_count()} threads)'


def _show(value):
    return '' if value is None else f'{value:.6g}'


def _count(value):
    return '' if value is None else f'{value:.0f}'
