# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases made for tests of the Python: a box of cells, clouds, gravity, geometry"""
import os

import numpy as np

sides = ('xLow', 'xHigh', 'yLow', 'yHigh', 'zLow', 'zHigh')


def header(kind, name, form='ascii'):
    return (f'FoamFile\n{{\n    version 2.0;\n    format {form};\n    class {kind};\n'
            f'    object {name};\n}}\n\n')


def put(folder, name, text):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), 'w') as f:
        f.write(text)


def listOf(values):
    values = np.asarray(values)
    if values.ndim == 1:
        return f'{len(values)}\n(\n' + '\n'.join(f'{v:.10g}' for v in values) + '\n)\n'
    return f'{len(values)}\n(\n' + '\n'.join('(' + ' '.join(f'{v:.10g}' for v in row) + ')'
                                             for row in values) + '\n)\n'


def mesh(case, low, high, cells=(1, 1, 1), kinds=None):
    """kinds: type of a side by its name; default: wall"""
    low, high, n = np.array(low, dtype=float), np.array(high, dtype=float), np.array(cells)
    at = lambda i, j, k: i + (n[0] + 1)*(j + (n[1] + 1)*k)                      # noqa: E731
    cell = lambda i, j, k: i + n[0]*(j + n[1]*k)                                # noqa: E731
    points = [low + (high - low)*np.array([i, j, k])/n for k in range(n[2] + 1)
              for j in range(n[1] + 1) for i in range(n[0] + 1)]
    inner, outer = [], {s: [] for s in sides}
    for k in range(n[2]):
        for j in range(n[1]):
            for i in range(n[0]):
                for d, (quad, up) in enumerate((
                        ([at(i + 1, j, k), at(i + 1, j + 1, k), at(i + 1, j + 1, k + 1),
                          at(i + 1, j, k + 1)], (1, 0, 0)),
                        ([at(i, j + 1, k), at(i, j + 1, k + 1), at(i + 1, j + 1, k + 1),
                          at(i + 1, j + 1, k)], (0, 1, 0)),
                        ([at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                          at(i, j + 1, k + 1)], (0, 0, 1)))):
                    here, there = np.array([i, j, k]), np.array([i, j, k]) + up
                    if there[d] < n[d]:
                        inner.append((quad, cell(*here), cell(*there)))
                    else:
                        outer[sides[2*d + 1]].append((quad, cell(*here)))
                if i == 0:
                    outer['xLow'].append(([at(0, j, k), at(0, j, k + 1), at(0, j + 1, k + 1),
                                           at(0, j + 1, k)], cell(i, j, k)))
                if j == 0:
                    outer['yLow'].append(([at(i, 0, k), at(i + 1, 0, k), at(i + 1, 0, k + 1),
                                           at(i, 0, k + 1)], cell(i, j, k)))
                if k == 0:
                    outer['zLow'].append(([at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0),
                                           at(i + 1, j, 0)], cell(i, j, k)))
    faces, owner, neighbour = [f[0] for f in inner], [f[1] for f in inner], [f[2] for f in inner]
    boundary = ''
    for side in sides:
        boundary += (f"    {side}\n    {{\n        type {(kinds or {}).get(side, 'wall')};\n"
                     f"        nFaces {len(outer[side])};\n        startFace {len(faces)};\n"
                     f"    }}\n")
        faces += [f[0] for f in outer[side]]
        owner += [f[1] for f in outer[side]]
    folder = os.path.join(case, 'constant', 'polyMesh')
    put(folder, 'points', header('vectorField', 'points') + listOf(points))
    put(folder, 'faces', header('faceList', 'faces') + f'{len(faces)}\n(\n'
        + '\n'.join(f"4({' '.join(map(str, f))})" for f in faces) + '\n)\n')
    put(folder, 'owner', header('labelList', 'owner') + listOf(owner))
    put(folder, 'neighbour', header('labelList', 'neighbour') + listOf(neighbour))
    put(folder, 'boundary',
        header('polyBoundaryMesh', 'boundary') + f'{len(sides)}\n(\n{boundary})\n')


def gravity(case, g):
    put(os.path.join(case, 'constant'), 'g', header('uniformDimensionedVectorField', 'g')
        + f"dimensions [0 1 -2 0 0 0 0];\nvalue ({' '.join(map(str, g))});\n")


def cloud(case, time, name, positions, spacing=None, **fields):
    folder = os.path.join(case, time, 'lagrangian', name)
    positions = np.asarray(positions, dtype=float)
    rows = '\n'.join(f"({' '.join(f'{v:.10g}' for v in p)}) 0" for p in positions)
    put(folder, 'positions',
        header('Cloud<passiveParticle>', 'positions') + f'{len(positions)}\n(\n{rows}\n)\n')
    for field, values in fields.items():
        values = np.asarray(values)
        kind = ('vectorField' if values.ndim > 1 else 'labelField' if values.dtype.kind == 'i'
                else 'scalarField')
        put(folder, field, header(kind, field) + listOf(values))
    if spacing:
        put(os.path.join(case, time, 'uniform', 'lagrangian', name), 'cloudProperties',
            header('dictionary', 'cloudProperties') + f'geometry positions;\nspacing {spacing};\n')


def block(low, high, spacing):
    """A lattice that fills a box"""
    axes = [np.arange(low[d] + 0.5*spacing, high[d], spacing) for d in range(3)]
    return np.stack(np.meshgrid(*axes, indexing='ij'), axis=-1).reshape(-1, 3)


def damBreak(case, up=1, flat=2, shift=(0, 0, 0), spacing=0.02):
    """A column of water in the corner of a tank of 1 x 0.6 (x 0.3), the axes chosen: up, and the
    empty one or None"""
    shift = np.array(shift, dtype=float)
    across = next(d for d in range(3)
                  if d not in (up, flat if flat is not None else 3 - up - (0 if up else 1)))
    deep = flat if flat is not None else next(d for d in range(3) if d not in (up, across))
    size = np.zeros(3)
    size[across], size[up], size[deep] = 1, 0.6, 0.3 if flat is None else spacing
    kinds = {sides[2*deep]: 'empty', sides[2*deep + 1]: 'empty'} if flat is not None else {}
    mesh(case, shift, shift + size, kinds=kinds)
    g = np.zeros(3)
    g[up] = -9.81
    gravity(case, g)
    for k, time in enumerate(('0', '0.1', '0.2', '0.3', '0.4')):
        water = size.copy()
        water[across], water[up] = 0.3 + 0.1*k, 0.12/(0.3 + 0.1*k)
        x = shift + block(np.zeros(3), water, spacing)
        U = np.zeros_like(x)
        U[:, across] = (x - shift)[:, across]*(k + 1)
        cloud(case, time, 'fluid', x, spacing, U=U, p=9810*(water[up] - (x - shift)[:, up]))
    return case
