# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run of a mutated case shows: clear, runs, or a finding"""
import os
import re

FINDINGS = ('crash', 'hang', 'late', 'unclear', 'senseless')


def including(case, file):
    """Files that include this one: OpenFOAM knows those alone once it has read them"""
    found = []
    for folder in ('system', 'constant'):
        for name in os.listdir(os.path.join(case, folder)):
            path = os.path.join(case, folder, name)
            if not os.path.isfile(path) or os.path.getsize(path) > 1e5:
                continue
            with open(path, errors='replace') as f:
                if re.search(r'#include\s+"[^"]*\b%s"' % re.escape(os.path.basename(file)),
                             f.read()):
                    found.append(os.path.join(folder, name))
    return found


def verdict(status, log, case, file, entry, neverRight):
    """One of clear, runs, FINDINGS. status: exit status, None after the time limit; case: the
    folder without the mistake"""
    if status is None:
        return 'hang'
    if re.search(r'printStack|sigHandler|Segmentation|terminate called|core dumped|FOAM aborting',
                 log) or status < 0 or status > 128:
        return 'crash'
    if status == 0:
        return 'senseless' if neverRight else 'runs'
    start = log.find('FOAM FATAL')
    if start < 0:
        return 'unclear'
    message = log[start:]
    if 'First steps, with all guards' in log[:start]:
        return 'late'
    # File and entry, or the line of the file where the text itself is broken
    named = any(os.path.basename(f) in message for f in [file, *including(case, file)])
    parts = [p for p in entry.split('/') if p]
    word = parts[-1] if parts else ''
    place = (re.search(r'\b' + re.escape(word) + r'\b', message)
             or re.search(r'at line \d|from line \d|line \d', message))
    return 'clear' if named and place and message.count('FOAM FATAL') == 1 else 'unclear'


def summary(log):
    """The message, a line"""
    start = log.find('FOAM FATAL')
    text = log[start:] if start >= 0 else log[-400:]
    return re.sub(r'\s+', ' ', re.sub(r'/\S*/', '', text))[:300]
