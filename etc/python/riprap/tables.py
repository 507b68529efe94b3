# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables that function objects write: postProcessing/<name>/<start time>/<file>.dat

Comment lines start with #, the last one before the data names the columns. A run that was restarted
leaves one folder a start; rows after the next start are superseded and dropped.
"""
import os

import numpy as np


def readTable(case, name, file=None):
    """Columns by name, as arrays; file defaults to <name of the function object's type>.dat when
    there is only one"""
    folder = os.path.join(case, 'postProcessing', name)
    starts = sorted((d for d in os.listdir(folder) if _isNumber(d)), key=float)
    if not starts:
        raise FileNotFoundError(f'no time folders in {folder}')
    columns, parts = None, []
    for i, start in enumerate(starts):
        columns, rows = _readOne(_find(os.path.join(folder, start), file))
        if i + 1 < len(starts):
            rows = rows[rows[:, 0] < float(starts[i + 1]) - 1e-12]
        parts.append(rows)
    data = np.vstack(parts)
    return {c: data[:, i] for i, c in enumerate(columns)}


def hasTable(case, name):
    return os.path.isdir(os.path.join(case, 'postProcessing', name))


def stacked(table, prefix):
    """Columns prefix0, prefix1, ... as one array (rows, probes)"""
    names = []
    while f'{prefix}{len(names)}' in table:
        names.append(f'{prefix}{len(names)}')
    return np.column_stack([table[n] for n in names])


def _find(folder, file):
    if file:
        return os.path.join(folder, file)
    files = [f for f in os.listdir(folder) if f.endswith('.dat')]
    if len(files) != 1:
        raise FileNotFoundError(f'{folder}: one .dat expected, found {files}')
    return os.path.join(folder, files[0])


def _readOne(path):
    """Vectors in brackets, as OpenFOAM writes forces, are columns of their own"""
    header, rows = None, []
    with open(path) as f:
        for line in f:
            line = line.replace('(', ' ').replace(')', ' ')
            if line.startswith('#'):
                header = line
            elif line.strip():
                rows.append([float(x) for x in line.split()])
    columns = header.lstrip('#').split()
    data = np.array(rows).reshape(len(rows), -1)
    if data.shape[1] != len(columns):
        raise ValueError(f'{path}: {len(columns)} columns named, {data.shape[1]} there')
    return columns, data


def _isNumber(text):
    try:
        float(text)
        return True
    except ValueError:
        return False
