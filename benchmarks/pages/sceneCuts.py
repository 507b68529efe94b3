# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs written without something (benchmarks/sceneCuts.txt): compiled from a copy of src"""
import concurrent.futures
import glob
import hashlib
import os
import re
import shutil
import subprocess

here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
cutsFile = os.path.join(here, 'sceneCuts.txt')
sources = os.path.join(os.path.dirname(here), 'src')
# What the scenes of sceneCounts run; all else is that of the library
units = {'sphDem': ['solvers/instantiate/sphCpu2Mixed.C'],
         'dem': ['solvers/instantiate/demCpu3Mixed.C'],
         'picDem': ['solvers/instantiate/picCpu2Mixed.C',
                    'solvers/pic/transfer/gridToParticlesCpu2.C']}


def readCuts(text):
    """{(solver, without): (names of others that belong to it, [[file, old, new]])}"""
    cuts, edits, file = {}, None, None
    for number, line in enumerate(text.splitlines(), 1):
        head = re.match(r'\[(\w+): ([^\]]+)\](?: = (.*))?$', line)
        if head:
            solver, name, parts = head.groups()
            edits, file = [], None
            cuts[solver, name] = (parts.split(', ') if parts else [], edits)
        elif not line or line.startswith('#'):
            continue
        elif not re.match(r'[-+]( |$)', line):
            file = line
        elif edits is None or file is None:
            raise ValueError(f'benchmarks/sceneCuts.txt, line {number}: of no file')
        elif line[0] == '-':
            if not edits or edits[-1][0] != file or edits[-1][2] is not None:
                edits.append([file, line[2:], None])
            else:
                edits[-1][1] += '\n' + line[2:]
        elif not edits or edits[-1][0] != file:
            raise ValueError(f'benchmarks/sceneCuts.txt, line {number}: in place of nothing')
        else:
            before = edits[-1][2]
            edits[-1][2] = line[2:] if before is None else before + '\n' + line[2:]
    return cuts


def editsOf(cuts, solver, name):
    """Those of a program, with what all of its solver have"""
    def one(name):
        parts, own = cuts[solver, name]
        return [edit for part in parts for edit in one(part)] + own
    return cuts[solver, 'common'][1] + one(name)


def edited(edits, read):
    """{file: text} after all edits; read(file) is what it is before"""
    texts = {}
    for file, old, new in edits:
        text = texts[file] if file in texts else read(file)
        if text.count(old) != 1 or new is None:
            raise ValueError(f'benchmarks/sceneCuts.txt: src/{file} has {text.count(old)} times: '
                             f'{old.strip()}')
        texts[file] = text.replace(old, new)
    return texts


def readSource(file):
    with open(os.path.join(sources, file)) as f:
        return f.read()


def stale(cuts):
    """Cuts that sources no longer have"""
    wrong = []
    for solver, name in cuts:
        if name == 'common':
            continue
        try:
            edited(editsOf(cuts, solver, name), readSource)
        except (ValueError, OSError) as problem:
            wrong.append(f'[{solver}: {name}] {problem}')
    return wrong


def flags():
    """Those of the build that . etc/bashrc has chosen"""
    script = ('include $(RIPRAP_DIR)/etc/wmake/riprap\n'
              'show:\n\t@echo $(RIPRAP_OPT) $(RIPRAP_FLAGS)\n')
    return subprocess.run(
        ['make', '-s', '-f', '-', 'show'], input=script, check=True, stdout=subprocess.PIPE,
        universal_newlines=True,
        env=dict(os.environ, WM_OPTIONS=os.environ['RIPRAP_OPTIONS'])).stdout.split()


def compilerOf():
    """The compiler and its flags, as rows name them"""
    compiler = os.environ.get('CXX', 'g++')
    version = subprocess.run([compiler, '-dumpfullversion'], check=True, stdout=subprocess.PIPE,
                             universal_newlines=True).stdout.strip()
    return ' '.join([compiler, version, *flags()])


def copySources(edits):
    """A folder of platforms/cuts with src after edits, named by what it has: whoever asks for the
    same again gets what is compiled there"""
    mark = hashlib.sha1(repr((edits, compilerOf())).encode())
    for where, folders, files in os.walk(sources):
        folders.sort()
        for file in sorted(files):
            if file.endswith(('.hpp', '.C', '.h', '.H')):
                with open(os.path.join(where, file), 'rb') as f:
                    mark.update(f.read())
    folder = os.path.join(os.path.dirname(sources), 'platforms', 'cuts', mark.hexdigest()[:12])
    copy = os.path.join(folder, 'src')
    if not os.path.isdir(copy):
        os.makedirs(folder, exist_ok=True)
        part = copy + '.part'
        shutil.rmtree(part, ignore_errors=True)
        shutil.copytree(sources, part, ignore=shutil.ignore_patterns('Make', 'lnInclude'))
        for file, text in edited(edits, readSource).items():
            with open(os.path.join(part, file), 'w') as f:
                f.write(text)
        os.rename(part, copy)
    return copy


def compiled(options, file, target):
    """Compiles a file, where that has not been done"""
    if os.path.exists(target):
        return
    done = subprocess.run(
        [os.environ.get('CXX', 'g++'), *options, '-c', file, '-o', target + '.part'],
        stderr=subprocess.PIPE, universal_newlines=True)
    if done.returncode:
        raise ValueError(f'{file} does not compile: {done.stderr[:2000]}')
    os.rename(target + '.part', target)


def build(cuts, solver, name):
    """The program sceneCounts without something: its path"""
    copy = copySources(editsOf(cuts, solver, name))
    whole = glob.glob(os.path.join(here, 'sceneCounts', 'Make', os.environ['RIPRAP_OPTIONS'],
                                   '*.o'))
    if not whole:
        raise ValueError('./Allwmake src benchmarks/sceneCounts first')
    files = [os.path.join(copy, unit) for unit in units[solver]]
    options = ['-std=c++17', '-w', '-I' + copy, *flags()]
    folder = os.path.dirname(copy)
    objects = [os.path.join(folder, os.path.basename(f)[:-2] + '.o') for f in files]
    with concurrent.futures.ThreadPoolExecutor(2) as two:
        list(two.map(lambda pair: compiled(options, *pair), zip(files, objects)))
    library, path = os.environ['RIPRAP_LIBBIN'], os.path.join(folder, 'sceneCounts')
    subprocess.run([os.environ.get('CXX', 'g++'), *options, *objects, *whole, '-o', path,
                    '-L' + library, '-lriprap', '-Wl,-rpath,' + library, '-lpthread'], check=True)
    return path
