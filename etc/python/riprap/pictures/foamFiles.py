# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh, fields on it, surfaces in files and gravity of a case"""
import base64
import os
import re
import shutil
import struct
import subprocess

import numpy as np

from .. import clouds
from ..dictionaries import readDictionary
from . import PictureError


def vectorOf(text):
    """Three numbers of '(0 0 -9.81)', with dimensions before them or without"""
    numbers = [float(x) for x in re.findall(r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?',
                                            re.sub(r'\[[^\]]*\]', ' ', text))]
    if len(numbers) != 3:
        raise ValueError(f'three numbers expected in {text}')
    return np.array(numbers)


def dictionary(path):
    """A dictionary; by foamDictionary where it has directives that are calculated"""
    with open(path) as f:
        text = re.sub(r'/\*.*?\*/|//[^\n]*', ' ', f.read(), flags=re.S)
    if re.search(r'#calc|#eval|#if\b|#codeStream|\$\{|\$[.:]',
                 text) and shutil.which('foamDictionary'):
        said = subprocess.run(['foamDictionary', '-expand', os.path.basename(path)],
                              cwd=os.path.dirname(os.path.abspath(path)), capture_output=True,
                              text=True)
        if said.returncode:
            raise PictureError(
                f'{path}: foamDictionary cannot expand it: {said.stderr.strip().splitlines()[-1:]}')
        return readDictionary(path, text=said.stdout)
    return readDictionary(path)


def gravity(case):
    path = os.path.join(case, 'constant', 'g')
    return vectorOf(dictionary(path)['value']) if os.path.exists(path) else np.zeros(3)


class Patch:
    """Part of the mesh's boundary: name, type and faces, lists of points (corners of all faces in a
    row, and where each begins)"""

    def __init__(self, name, kind, faces):
        self.name, self.kind, self.faces = name, kind, faces


class Mesh:
    """Points and boundary. Cells are asked for only where fields are drawn"""

    def __init__(self, case):
        self.folder = os.path.join(case, 'constant', 'polyMesh')
        if not os.path.isdir(self.folder):
            raise PictureError(f'{case}: no mesh (constant/polyMesh)')
        self.points = clouds.readField(os.path.join(self.folder, 'points'))
        self.low, self.high = self.points.min(axis=0), self.points.max(axis=0)
        entries = _boundary(os.path.join(self.folder, 'boundary'))
        faces = boundaryFaces(os.path.join(self.folder, 'faces'),
                              min((e[2] for e in entries), default=0))
        first = min((e[2] for e in entries), default=0)
        self.patches = [Patch(name, kind, faces[start - first:start - first + n])
                        for name, kind, start, n in entries]

    @property
    def emptyAxis(self):
        """0, 1 or 2 of a 2D case, else None"""
        for patch in self.patches:
            if patch.kind == 'empty' and len(patch.faces):
                face = self.points[patch.faces[0]]
                return int(np.argmin(np.ptp(face, axis=0)))
        return None

    def lattice(self):
        """Of a mesh of equal cells: its counts along x, y, z and each cell's place in it; None of
        another mesh"""
        owner, neighbour = (clouds.readField(os.path.join(self.folder, name))
                            for name in ('owner', 'neighbour'))
        n = int(max(owner.max(initial=0), neighbour.max(initial=0))) + 1
        edges = [np.unique(np.round((self.points[:, d] - self.low[d])/(self.high[d] - self.low[d]),
                                    6)) for d in range(3)]
        counts = np.array([len(e) - 1 for e in edges])
        if counts.prod() != n or any(len(e) < 2 or np.ptp(np.diff(e)) > 1e-3*np.diff(e).mean()
                                     for e in edges):
            return None
        faces = boundaryFaces(os.path.join(self.folder, 'faces'), 0)
        corners = np.array([f[0] for f in faces]), np.array([f[2] for f in faces])
        middle = 0.5*(self.points[corners[0]] + self.points[corners[1]])
        total, hits = np.zeros((n, 3)), np.zeros(n)
        for cells, rows in ((owner, middle), (neighbour, middle[:len(neighbour)])):
            hits += np.bincount(cells, minlength=n)
            for d in range(3):
                total[:, d] += np.bincount(cells, rows[:, d], minlength=n)
        place = ((total/hits[:, None] - self.low)/(self.high - self.low)*counts).astype(int)
        return counts, np.minimum(place, counts - 1)


def _boundary(path):
    """(name, type, first face, faces) of each patch"""
    with open(path, 'rb') as f:
        text = re.sub(r'/\*.*?\*/|//[^\n]*', ' ', f.read().decode(), flags=re.S)
    text = re.sub(r'FoamFile\s*\{.*?\}', ' ', text, flags=re.S)
    result = []
    for name, body in re.findall(r'([^\s(){};]+)\s*\{([^{}]*)\}', text):
        values = dict(re.findall(r'(\w+)\s+([^;]+);', body))
        result.append((name, values['type'].strip(), int(values['startFace']),
                       int(values['nFaces'])))
    return sorted(result, key=lambda e: e[2])


def boundaryFaces(path, first):
    """Lists of points of the faces from `first` on"""
    header, count, body = clouds.split(path)
    if header['class'] == 'faceCompactList':
        start, used = clouds.binaryList(body, count, '<i4')
        rest = body[used:]
        n = int(re.match(rb'\)?\s*(\d+)', rest).group(1))
        corners, _ = clouds.binaryList(rest[rest.index(b'('):], n, '<i4')
        return [corners[a:b] for a, b in zip(start[first:-1], start[first + 1:])]
    numbers = clouds.numbers(body).astype(int)
    faces, at = [], 0
    if len(numbers) == 5*count and (numbers[::5] == 4).all():
        return list(numbers.reshape(count, 5)[first:, 1:])
    for i in range(count):
        n = numbers[at]
        if i >= first:
            faces.append(numbers[at + 1:at + 1 + n])
        at += n + 1
    return faces


def volumeField(path, cells):
    """Values in the cells, (n) or (n, 3); None where there is no file"""
    if not os.path.exists(path) and not os.path.exists(path + '.gz'):
        return None
    data = clouds.content(path)
    match = re.search(rb'internalField\s+(uniform|nonuniform)\s+', data)
    if not match:
        raise PictureError(f'{path}: no internalField')
    width = 3 if b'volVectorField' in data[:match.start()] else 1
    rest = data[match.end():]
    if match.group(1) == b'uniform':
        value = clouds.numbers(rest[:rest.index(b';')])
        return np.tile(value, (cells, 1)) if width > 1 else np.full(cells, value[0])
    count = int(re.match(rb'List<\w+>\s*(\d+)', rest).group(1))
    body = rest[rest.index(b'('):]
    if re.search(rb'format\s+binary', data[:match.start()]):
        values, _ = clouds.binaryList(body, count*width, '<f8')
    else:
        values = clouds.numbers(body[:body.index(b';')])
    return values.reshape(count, width) if width > 1 else values


def readSurface(path, scale=1.0):
    """Points (n, 3) and triangles (m, 3) of an STL or OBJ file"""
    if not os.path.exists(path):
        raise PictureError(f'{path}: no such surface')
    with open(path, 'rb') as f:
        data = f.read()
    if path.lower().endswith('.obj'):
        points, triangles = _obj(data)
    else:
        corners = _stl(data, path)
        points, inverse = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        triangles = inverse.reshape(-1, 3)
    return scale*points, triangles


def _stl(data, path):
    n = struct.unpack('<I', data[80:84])[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50*n:
        record = np.dtype([('normal', '<f4', 3), ('corner', '<f4', (3, 3)), ('colour', '<u2')])
        return np.frombuffer(data, record, n, 84)['corner'].astype(float)
    found = re.findall(rb'vertex\s+(\S+)\s+(\S+)\s+(\S+)', data)
    if not found or len(found) % 3:
        raise PictureError(f'{path}: no STL file')
    return np.array(found, dtype=float).reshape(-1, 3, 3)


def _obj(data):
    points, triangles = [], []
    for line in data.decode().splitlines():
        words = line.split()
        if words[:1] == ['v']:
            points.append([float(w) for w in words[1:4]])
        elif words[:1] == ['f']:
            corner = [int(w.split('/')[0]) for w in words[1:]]
            corner = [c - 1 if c > 0 else len(points) + c for c in corner]
            triangles += [[corner[0], corner[i], corner[i + 1]] for i in range(1, len(corner) - 1)]
    return np.array(points), np.array(triangles, dtype=int)


def readLines(path):
    """Points, lines as pairs of them, and the lines' values by name, of a polydata file (.vtp) as
    riprapFoam writes bonds"""
    with open(path) as f:
        text = f.read()
    kinds = {'Int32': '<i4', 'Int64': '<i8', 'Float32': '<f4', 'Float64': '<f8', 'UInt8': 'u1'}

    def arrays(section):
        body = re.search(rf'<{section}\b.*?>(.*?)</{section}>', text, re.S)
        found = {}
        for head, data in re.findall(r'<DataArray\s+(.*?)>(.*?)</DataArray>',
                                     body.group(1) if body else '', re.S):
            entries = dict(re.findall(r'(\w+)=[\'"](.*?)[\'"]', head))
            if entries.get('format') == 'ascii':
                values = np.array(data.split(), dtype=kinds[entries['type']])
            else:
                values = np.frombuffer(base64.b64decode(data.strip())[8:], kinds[entries['type']])
            width = int(entries.get('NumberOfComponents', 1))
            found[entries.get('Name', '')] = values.reshape(-1, width) if width > 1 else values
        return found
    points = next(iter(arrays('Points').values())).astype(float)
    return points, arrays('Lines')['connectivity'].reshape(-1, 2), arrays('CellData')
