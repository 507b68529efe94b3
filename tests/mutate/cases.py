# SPDX-License-Identifier: GPL-3.0-or-later
"""Base cases: each tutorial once, meshed and filled on its coarsest setting; copies of them with
one file changed"""
import json
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), '..', '..'))
NAME = 'mutate'                 # of the runs
# not riprap's, or not used by what runs here
OTHER = {'blockMeshDict', 'decomposeParDict', 'fvSchemes'}
READ = {'g', 'geometry', 'fluidProperties', 'sphProperties', 'picProperties', 'solidProperties',
        'controlDict', 'fvSolution', 'fvSchemes', 'setParticlesDict'}

QUICK = '''
import importlib.util, json, sys
spec = importlib.util.spec_from_file_location('analysis', sys.argv[1])
analysis = importlib.util.module_from_spec(spec)
sys.path.insert(0, sys.argv[2])
spec.loader.exec_module(analysis)
studies = [v for v in vars(analysis).values() if type(v).__name__ == 'Study']
print(json.dumps([v.options for v in studies[0].quick if v.case == '.'][0]))
'''


def tutorials(pattern=''):
    found = []
    for module in sorted(os.listdir(os.path.join(ROOT, 'tutorials'))):
        folder = os.path.join(ROOT, 'tutorials', module)
        found += [module + '/' + t for t in sorted(os.listdir(folder))
                  if os.path.exists(os.path.join(folder, t, 'Allrun'))]
    return [t for t in found if pattern in t]


def prepare(tutorial):
    """\\return the base case, or None with what is wrong"""
    folder = os.path.join(ROOT, 'tutorials', tutorial)
    base = os.path.join(folder, 'runs', NAME)
    if os.path.exists(os.path.join(base, 'log.setParticles')):
        return base, ''
    python = os.environ.get('RIPRAP_PYTHON', sys.executable)
    environment = dict(os.environ, PYTHONPATH=os.path.join(ROOT, 'etc', 'python'),
                       PYTHONDONTWRITEBYTECODE='1')
    quick = subprocess.run([python, '-c', QUICK, os.path.join(folder, 'analysis.py'), folder],
                           capture_output=True, text=True, env=environment)
    options = json.loads(quick.stdout) if quick.returncode == 0 else []
    made = subprocess.run([os.path.join(folder, 'Allrun'), *options, '-name', NAME, '-noRun',
                           '-noPlot'], capture_output=True, text=True, env=environment)
    if made.returncode:
        shutil.rmtree(base, ignore_errors=True)
        return None, made.stdout[-300:] + made.stderr[-300:]
    return base, ''


def files(base):
    """Dictionaries that the case's solver reads, and what they include"""
    with open(os.path.join(base, 'system', 'controlDict')) as f:
        solver = re.search(r'^\s*solver\s+(\w+)', f.read(), re.M).group(1)
    left = {'sphDem': {'picProperties', 'fvSolution'}, 'picDem': {'sphProperties'},
            'dem': {'sphProperties', 'picProperties', 'fluidProperties', 'fvSolution'}}[solver]
    found = []
    for part in ('constant', 'system'):
        folder = os.path.join(base, part)
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            if (
                    name in OTHER | left or name.endswith('.py') or not os.path.isfile(path)
                    or os.path.getsize(path) > 20000):
                continue
            with open(path, errors='replace') as f:
                if 'FoamFile' in f.read(2000):
                    found.append(part + '/' + name)
    return found


def unused(base, file):
    """Of a file that others include: does no dictionary but blockMeshDict use this entry as
    $name?"""
    texts = []
    for other in files(base):
        with open(os.path.join(base, other)) as f:
            texts.append(f.read())
    if not re.search(r'#include\s+"[^"]*\b%s"' % re.escape(os.path.basename(file)),
                     '\n'.join(texts)) and file.split('/')[1] in READ:
        return lambda e: False
    return (lambda e: not e.block and '/' not in e.path
            and not any(re.search(r'\$[{:.]*%s\b' % re.escape(e.path), t) for t in texts))


def mutant(base, folder, file, text):
    """A copy in folder in which file has this text. Large things are links: a dry run writes
    nothing"""
    os.makedirs(folder)
    for name in os.listdir(base):
        if name.startswith('log.') or name in ('postProcessing', 'VTK'):
            continue
        source = os.path.join(base, name)
        if name in ('constant', 'system'):
            os.mkdir(os.path.join(folder, name))
            for part in os.listdir(source):
                one = os.path.join(source, part)
                if os.path.isdir(one):
                    os.symlink(one, os.path.join(folder, name, part))
                else:
                    shutil.copy(one, os.path.join(folder, name, part))
        else:
            os.symlink(source, os.path.join(folder, name))
    with open(os.path.join(folder, file), 'w') as f:
        f.write(text)


def commands(base, file):
    """What reads the file: setParticles, or a dry run; both where it is not clear"""
    name = os.path.basename(file)
    set_, run = ['setParticles', '-dry-run'], ['riprapFoam', '-dry-run']
    with open(os.path.join(base, 'system', 'setParticlesDict')) as f:
        sets = f.read()
    if name == 'setParticlesDict' or '#include "%s"' % name in sets:
        return [set_]
    return [run]
