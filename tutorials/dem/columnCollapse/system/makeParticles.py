# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/gate: how the gate goes. From 0.5 s on it retreats at 5 m/s, faster than any grain follows, to the end of the
floor. Points are dense where it starts, since OpenFOAM puts a spline through them; some are before 0, where a run looks too."""
from riprap.dictionaries import numberOf, readDictionary

column = readDictionary('system/column')
way = numberOf(column['length']) - numberOf(column['width'])
opens, speed = 0.5, 5.0

table = [(-1, 0), (0.4, 0), (opens - 1e-4, 0), (opens, 0)]
after, step = 1e-4, 1e-4
while speed*after < way:
    table.append((opens + after, speed*after))
    step = min(after, 0.01)
    after += step
end = opens + after
table += [(end + k*step, way) for k in range(4)] + [(100, way)]
with open('constant/gate', 'w') as f:
    f.write('(\n' + ''.join(f'({t:g} (({x:.6g} 0 0) (0 0 0)))\n' for t, x in table) + ')\n')
