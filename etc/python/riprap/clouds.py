# SPDX-License-Identifier: GPL-3.0-or-later
"""Particles of a time directory: <time>/lagrangian/<cloud>/{positions,U,p,...}

Ascii, binary and compressed (.gz) files of OpenFOAM. Binary positions are `(` three doubles and an
int32 `)` for each particle, a line each, binary fields are one block; labels are int32.
"""
import gzip
import os
import re

import numpy as np


def times(case):
    """Names of the time directories that hold a cloud, in order of time"""
    found = []
    for name in os.listdir(case):
        try:
            value = float(name)
        except ValueError:
            continue
        if os.path.isdir(os.path.join(case, name, 'lagrangian')):
            found.append((value, name))
    return [name for _, name in sorted(found)]


def hasCloud(case, time, cloud):
    """Whether there are its positions"""
    path = os.path.join(case, time, 'lagrangian', cloud, 'positions')
    return os.path.exists(path) or os.path.exists(path + '.gz')


def nearestTime(case, t):
    """Name of the written time nearest to t"""
    return min(times(case), key=lambda name: abs(float(name) - t))


def readCloud(case, time, fields=('U', 'p'), cloud='fluid'):
    """Dictionary with positions (n, 3) and the named fields"""
    folder = os.path.join(case, time, 'lagrangian', cloud)
    result = {'positions': readPositions(os.path.join(folder, 'positions'))}
    for name in fields:
        result[name] = readField(os.path.join(folder, name))
    return result


def readPositions(path):
    header, count, body = split(path)
    if header['format'] != 'binary':
        return numbers(body).reshape(count, -1 if count else 3)[:, :3]
    record = np.dtype([('open', 'S1'), ('x', '<f8', 3), ('cell', '<i4'), ('close', 'S1'),
                       ('end', 'S1')])
    return np.frombuffer(_afterBracket(body).lstrip(b'\n'), record, count)['x'].copy()


def readField(path):
    header, count, body = split(path)
    width = 3 if 'vector' in header['class'] else 1
    integer = 'label' in header['class']
    if body.lstrip()[:1] == b'{':                       # uniform list: n{value}
        values = np.tile(numbers(body[:body.index(b'}')]), (count, 1))
    elif header['format'] == 'binary':
        values = binaryList(body, count*width, '<i4' if integer else '<f8')[0].reshape(count, width)
    else:
        values = numbers(body).reshape(count, width)
    values = values.astype(int if integer else float)
    return values if width > 1 else values[:, 0]


def content(path):
    """Bytes of a file, or of the same with .gz"""
    opener = open
    if not os.path.exists(path) and os.path.exists(path + '.gz'):
        path, opener = path + '.gz', gzip.open
    with opener(path, 'rb') as f:
        return f.read()


def split(path):
    """Header entries, length of the list and the bytes from its opening bracket on"""
    data = content(path)
    head = re.search(rb'FoamFile\s*\{(.*?)\}', data, re.S)
    header = {k.decode(): v.decode().strip('" ') for k, v in
              re.findall(rb'(\w+)\s+([^;]+);', head.group(1))}
    rest = data[head.end():]
    start = 0
    while True:                                         # comments between header and list
        m = re.compile(rb'\s*(//[^\n]*\n|/\*.*?\*/)', re.S).match(rest, start)
        if not m:
            break
        start = m.end()
    number = re.compile(rb'\s*(\d+)').match(rest, start)
    if not number:
        raise ValueError(f'{path}: no list')
    return header, int(number.group(1)), rest[number.end():]


def binaryList(body, count, kind):
    """The values of a list whose bracket is the first in body, and where they end in it"""
    values = np.frombuffer(_afterBracket(body), kind, count) if count else np.zeros(0, kind)
    return values, (body.index(b'(') + 1 + values.nbytes) if count else 0


def numbers(body):
    """All numbers up to the closing comment, whatever brackets stand between them"""
    end = body.find(b'// *')
    text = (body if end < 0 else body[:end]).translate(_blanks)
    return np.array(text.split(), dtype=float)


_blanks = bytes.maketrans(b'(){}', b'    ')


def _afterBracket(body):
    return body[body.index(b'(') + 1:]
