#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Are the solids, or with --fluid the fluid, of two cases the same particles, number for number?

    sameClouds.py CASE TIME OTHER OTHERTIME [--whole] [--close | --nearly] [--fluid]

CASE is read from its processors' folders, with --whole from its own time; OTHER from its own time.
Files are binary. Particles are compared by origId (id of the fluid): their fields to the bit, with
--close positions to 1e-9 m, with --nearly all to 1e-8 of the field's largest. Prints what differs
and exits with 1, else how many particles there are.
"""
import glob
import os
import re
import struct
import sys

components = {'labelField': ('i', 1), 'labelList': ('i', 1), 'scalarField': ('d', 1),
              'vectorField': ('d', 3)}


def readList(path, form='<ddd'):
    """Rows of a cloud's file, as tuples; form: of positions, '<dddi' with their cells"""
    with open(path, 'rb') as f:
        data = f.read()
    head = re.search(rb'FoamFile\s*\{(.*?)\}', data, re.S)
    entries = dict(re.findall(rb'(\w+)\s+([^;\n]+);', head.group(1)))
    kind, binary = entries[b'class'].decode().strip('"'), entries[b'format'] == b'binary'
    found = re.compile(rb'(?:\s*//[^\n]*\n)*\s*(\d+)\s*([({]?)').match(data, head.end())
    count, start = int(found.group(1)), found.end()
    if count == 0:
        return []
    if not binary:
        raise ValueError(f'{path} is not binary')
    if kind.startswith('Cloud'):
        row = struct.Struct(form)
        size = 3*8 + 4 + 3                  # in brackets, with the cell behind them, a line each
        start += data[start:start + 1] == b'\n'
        return [row.unpack_from(data, start + 1 + i*size) for i in range(count)]
    letter, width = components[kind]
    if found.group(2) == b'{':
        return [tuple(float(x) for x in data[start:data.index(b'}', start)].split())]*count
    row = struct.Struct('<' + letter*width)
    return [row.unpack_from(data, start + i*row.size) for i in range(count)]


def read(folders, ids):
    """Of each particle its fields, by name"""
    particles = {}
    for folder in folders:
        names = sorted(set(os.listdir(folder)) - {'coordinates'})
        fields = {name: readList(os.path.join(folder, name)) for name in names}
        for i, (number,) in enumerate(fields[ids]):
            if number in particles:
                raise ValueError(f'particle {number} is there twice')
            particles[number] = {name: rows[i] for name, rows in fields.items()}
    return particles


def main(arguments):
    whole, close, nearly = (f'--{word}' in arguments for word in ('whole', 'close', 'nearly'))
    cloud, ids = ('fluid', 'id') if '--fluid' in arguments else ('solids', 'origId')
    case, time, other, otherTime = [a for a in arguments if not a.startswith('--')]
    parts = [case] if whole else sorted(glob.glob(os.path.join(case, 'processor*')))
    a = read([os.path.join(part, time, 'lagrangian', cloud) for part in parts], ids)
    b = read([os.path.join(other, otherTime, 'lagrangian', cloud)], ids)
    if set(a) != set(b) or not a:
        print(f'{len(a)} particles, and {len(b)}, or others')
        return 1
    bounds = {'positions': 1e-9} if close else {}
    if nearly:
        bounds = {name: 1e-8*max(abs(x) for fields in b.values() for x in fields[name])
                  for name in next(iter(b.values()))}
    wrong = {}
    for number, fields in a.items():
        for name, value in fields.items():
            there = b[number].get(name, ())
            near = (name in bounds and len(value) == len(there)
                    and all(abs(x - y) <= bounds[name] for x, y in zip(value, there)))
            if value != there and not near:
                wrong.setdefault(name, []).append(number)
    print('; '.join(f'{name} of {len(numbers)}, {numbers[0]} the first'
                    for name, numbers in wrong.items()) or f'{len(a)} particles')
    return bool(wrong)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
