# SPDX-License-Identifier: GPL-3.0-or-later
"""The round tank, constant/geometry, and one body near its middle, or many that do not touch:
constant/particles.csv"""
import itertools
import math
import random

from riprap.dictionaries import numberOf, readDictionary

tank = readDictionary('system/tank')
value = {name: numberOf(tank[name]) for name in ('radius', 'bodies', 'tankRadius', 'middle',
                                                 'middleZ', 'side', 'cells', 'dimensions')}
h = value['side']/value['cells']
offset = [float(x) for x in tank['offset'].strip('()').split()]
planar = value['dimensions'] == 2


def single():
    centre = [value['middle'], value['middle'], value['middleZ']]
    return [[c + (0 if planar and k == 2 else o*h) for k, (c, o) in enumerate(zip(centre, offset))]
            + [value['radius']]]


def many(count):
    """At random, apart from each other and from the wall by two cells; those of like place in
    bins"""
    chance = random.Random(7)
    least, gap = (4.5, 2*h) if planar else (2.5, 2*h)
    bin = (2*(least + 1) + 2)*h
    placed, bins = [], {}
    axes = 'xy' if planar else 'xyz'
    while len(placed) < count:
        r = (least + chance.random())*h
        x = [(2*chance.random() - 1)*value['tankRadius'] for _ in axes]
        if math.dist(x, [0]*len(x)) + r + gap > value['tankRadius']:
            continue
        at = [int(c//bin) for c in x]
        near = [p for step in itertools.product((-1, 0, 1), repeat=len(x))
                for p in bins.get(tuple(a + i for a, i in zip(at, step)), [])]
        if any(math.dist(x, p[0]) < r + p[1] + gap for p in near):
            continue
        bins.setdefault(tuple(at), []).append((x, r))
        placed.append([value['middle'] + x[0], value['middle'] + x[1],
                       value['middleZ'] + (0 if planar else x[2]), r])
    return placed


rows = single() if value['bodies'] == 1 else many(value['bodies'])
with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,radius\n')
    for row in rows:
        f.write(','.join(f'{v:.17g}' for v in row) + '\n')

middle = f'{value["middle"]:.17g} {value["middle"]:.17g}'
if planar:
    shape = f'type searchableCylinder; point1 ({middle} -1); point2 ({middle} 1);'
else:
    shape = f'type searchableSphere; centre ({middle} {value["middleZ"]:.17g});'
with open('constant/geometry', 'w') as f:
    f.write('FoamFile { version 2.0; format ascii; class dictionary; object geometry; }\n'
            f'basin {{ {shape} radius {value["tankRadius"]:.17g}; solidSide outside; }}\n')
