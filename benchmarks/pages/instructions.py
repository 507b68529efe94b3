# SPDX-License-Identifier: GPL-3.0-or-later
"""Instructions that a step of sceneCounts takes, counted by valgrind's tool callgrind: the same
from run to run, on a busy machine too

    perStep(program, 'sphDem', '-without', 'solids')  ->  what it prints, [{function: instructions}]
"""
import glob
import os
import re
import shutil
import subprocess
import tempfile

# `rep stosb` and `rep movsb` would count once a byte
PLAIN = ':'.join(f'glibc.cpu.x86_rep_{what}_threshold=1000000000' for what in ('stosb', 'movsb'))
STEPS = {'sphDem': 20, 'picDem': 2, 'dem': 20}      # one search for neighbours among them


class Missing(Exception):
    """No valgrind, or no program"""


def readFunctions(text):
    """Of a dump: {function: its own instructions}. Calls' lines are those of what was called"""
    names, own = {}, {}
    function, called = None, False
    for line in text.splitlines():
        found = re.match(r'(c?fn)=\((\d+)\)(?: (.*))?$', line)
        if found:
            kind, number, name = found.groups()
            if name:
                names[number] = name
            if kind == 'fn':
                function = names[number]
        elif line.startswith('calls='):
            called = True
        elif line[:1].isdigit() or line[:1] in '+-*':
            cost = line.split()[1:]
            if not called and function and cost:
                own[function] = own.get(function, 0) + int(cost[0])
            called = False
    return own


def dumps(folder):
    """Texts in the order of rows"""
    files = sorted(glob.glob(os.path.join(folder, 'out.*')), key=lambda f: int(f.split('.')[-1]))
    for name in files:
        with open(name) as f:
            yield f.read()


def perStep(program, solver, *options):
    """Printed rows, and of each row the instructions of a step by function"""
    valgrind, path = shutil.which('valgrind'), shutil.which(program)
    if not valgrind:
        raise Missing('valgrind is not in PATH (apt-get install valgrind)')
    if not path:
        raise Missing(f'the program {program} is not in PATH: '
                      './Allwmake src benchmarks/sceneCounts && . etc/bashrc')
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [valgrind, '--tool=callgrind', '--instr-atstart=no',
             '--callgrind-out-file=' + os.path.join(folder, 'out'), path,
             '-steps', str(STEPS[solver]), *options, solver],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
            env=dict(os.environ, GLIBC_TUNABLES=PLAIN))
        if done.returncode:
            raise Missing(f'{program} ended with {done.returncode} under valgrind: '
                          + done.stderr[-300:])
        counted = [{name: n/STEPS[solver] for name, n in readFunctions(text).items()}
                   for text in dumps(folder)]
    lines = done.stdout.splitlines()
    if len(counted) != len(lines) - 1:
        raise Missing(f'{len(lines) - 1} rows, and instructions of {len(counted)}: sceneCounts is '
                      'to be compiled where valgrind is installed')
    return done.stdout, counted
