# SPDX-License-Identifier: GPL-3.0-or-later
"""30 rocks above the water, a gap and more apart, of different sizes, by system/shape: balls
(constant/solids.csv), clumps of four balls (constant/solids<n>.csv), or stones of the surface
constant/triSurface/stone.stl; system/rocks: their regions of setParticlesDict"""
import math
import random

from riprap.dictionaries import numberOf, readDictionary

shape = readDictionary('system/shape')['shape']
density = numberOf(readDictionary('constant/solidProperties')['materials']['rock']['rho'])
random.seed(1)


def places(x, y, z, pitch):
    """Two layers of 5 x 3, the innermost loop along z"""
    return [(x + pitch*i + 0.001*random.random(), y + pitch*layer, z + pitch*k
             + 0.001*random.random()) for layer in range(2) for i in range(5) for k in range(3)]


def balls():
    pitch = 0.065
    with open('constant/solids.csv', 'w') as out:
        out.write('x,y,z,radius\n')
        for layer in range(2):
            for i in range(5):
                for k in range(3):
                    at = (0.11 + pitch*i + 0.001*random.random(), 0.155 + pitch*layer,
                          0.055 + pitch*k + 0.001*random.random())
                    out.write('%.6g,%.6g,%.6g,%.6g\n' % (*at, 0.022 + 0.006*random.random()))
    return ['rocks { set solids; source csv; file "constant/solids.csv"; material rock; }']


def volumeOf(centres, radius, n=60):
    """Of balls that overlap, by points of a lattice"""
    h = 2*(radius + max(abs(v) for c in centres for v in c))/n
    inside = 0
    for i in range(n):
        for j in range(n):
            for k in range(n):
                x = [(m + 0.5 - n/2)*h for m in (i, j, k)]
                inside += any(sum((a - b)**2 for a, b in zip(x, c)) < radius**2 for c in centres)
    return inside*h**3


def clumps():
    """Each a rigid region: balls of 16 mm a radius on the corners of a tetrahedron, turned as
    chance has it. A ball weighs a quarter of what the four together displace"""
    radius, out = 0.016, 0.011
    corners = [[s*out/3**0.5 for s in signs]
               for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
    mass = density*volumeOf(corners, radius)/4
    regions = []
    for number, at in enumerate(places(0.09, 0.16, 0.045, 0.072)):
        a, b, c = (2*math.pi*random.random() for _ in range(3))
        name = 'constant/solids%d.csv' % number
        with open(name, 'w') as out:
            out.write('x,y,z,radius,mass\n')
            for x, y, z in corners:
                x, y = x*math.cos(a) - y*math.sin(a), x*math.sin(a) + y*math.cos(a)
                y, z = y*math.cos(b) - z*math.sin(b), y*math.sin(b) + z*math.cos(b)
                x, y = x*math.cos(c) - y*math.sin(c), x*math.sin(c) + y*math.cos(c)
                out.write('%.6g,%.6g,%.6g,%.6g,%.6g\n'
                          % (at[0] + x, at[1] + y, at[2] + z, radius, mass))
        regions.append('rock%d { set solids; source csv; file "%s"; material rock; rigid yes; }'
                       % (number, name))
    return regions


def stones():
    """Of two sizes, each turned by chance. Contacts see 60 balls in it, water its surface"""
    centres = places(0.09, 0.16, 0.045, 0.075)
    return ['rocks%d { set solids; source clumpsFromSurface; file "stone.stl"; scale %g; '
            'spheres 60; orientation random; seed %d; material rock;\n    centres (%s); }'
            % (size, scale, size, ' '.join('(%.6g %.6g %.6g)' % at for at in centres[size::2]))
            for size, scale in enumerate((1.12, 1.04))]


with open('system/rocks', 'w') as out:
    out.write('// Of setParticlesDict, by system/makeParticles.py\n')
    # REUSE-IgnoreStart
    out.write('// SPDX-License-Identifier: GPL-3.0-or-later\n')
    # REUSE-IgnoreEnd
    out.write('\n'.join({'balls': balls, 'clumps': clumps, 'stones': stones}[shape]()) + '\n')
