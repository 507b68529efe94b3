# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/gate: how the gate goes. From 0.5 s on it retreats at 5 m/s, faster than any grain
follows, to the end of the floor, or is lifted at the speed `lift` of system/column. OpenFOAM puts a
spline through these points, which must not push the column before the gate goes: it comes up to
speed in 5 ms, by the third power of time, and points are dense there; some are before 0, where a
run looks too.

With `glued 1` in system/column also the grains that are glued to the floor (constant/particles.csv,
and system/gluedGrains, a region of system/setParticlesDict): grains of 5 mm on a square lattice 1.1
grains wide, each moved by up to 0.045 grains along both of its axes, so that none falls through;
their tops are at y = 0, or up to `uneven` grains below."""
import os
import random

from riprap.dictionaries import numberOf, readDictionary

column = readDictionary('system/column')
lift = numberOf(column['lift'])
way = (numberOf(column['height']) + 0.1 if lift
       else numberOf(column['length']) - numberOf(column['width']))
opens, speed, start = 0.5, lift or 5.0, 0.005       # [s], [m/s], [s] to come up to speed


def wayAfter(t):
    return speed*t**3/(3*start**2) if t < start else speed*(t - 2/3*start)


table = [(-1, 0), (0.4, 0), (opens - 5e-4, 0), (opens - 2.5e-4, 0), (opens, 0)]
after, step = 2.5e-4, 2.5e-4
while wayAfter(after) < way:
    table.append((opens + after, wayAfter(after)))
    step = 2.5e-4 if after < start else min(1.3*step, 0.01)
    after += step
end = opens + after
table += [(end + k*step, way) for k in range(4)] + [(100, way)]
with open('constant/gate', 'w') as f:
    f.write('(\n' + ''.join(f'({t:g} (({0 if lift else x:.6g} {x if lift else 0:.6g} 0) (0 0 0)))\n'
                            for t, x in table) + ')\n')

region = 'system/gluedGrains'
if os.path.exists(region):
    os.remove(region)
if numberOf(column['glued']):
    diameter, spread, uneven = 0.005, 0.045, numberOf(column['uneven'])
    counts = [max(1, int(numberOf(column[side])/(1.1*diameter))) for side in ('length', 'depth')]
    steps = [numberOf(column[side])/n for side, n in zip(('length', 'depth'), counts)]
    moved = random.Random(1)
    with open('constant/particles.csv', 'w') as f:
        f.write('x,y,z,radius,group\n')
        for i in range(counts[0]):
            for k in range(counts[1]):
                x, z = ((n + 0.5)*s + moved.uniform(-spread, spread)*diameter
                        for n, s in zip((i, k), steps))
                y = -(0.5 + moved.uniform(0, uneven))*diameter if uneven else -0.5*diameter
                f.write(f'{x:.6f},{y:.6g},{z:.6f},{0.5*diameter},glued\n')
    with open(region, 'w') as f:
        f.write(
            'glued { set solids; source csv; file "constant/particles.csv"; material grain; }\n')
