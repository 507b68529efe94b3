# SPDX-License-Identifier: GPL-3.0-or-later
"""The plate before the water, by `lift` and `held` of system/tank: its shape (constant/geometry),
how it moves, and when (constant/lift.dat). No plate: none of them"""
import os

from riprap.dictionaries import numberOf, readDictionary

tank = {key: numberOf(value) for key, value in readDictionary('system/tank').items()
        if not isinstance(value, dict)}
# [m], [m], [s] until it has its speed, [s] between rows
thickness, top, starts, step = 0.002, 0.25, 0.02, 0.005


def way(t):
    """Of the plate: at rest, uniformly faster and faster, at one speed"""
    t -= tank['held']
    return 0 if t < 0 else tank['lift']*(0.5*t*t/starts if t < starts else t - 0.5*starts)


def write(name, text):
    """What comes after the header of the dictionary constant/plateMotion"""
    with open('constant/plateMotion') as f:
        header = f.read().split('// * *')[0].replace('plateMotion', name)
    with open('constant/' + name, 'w') as f:
        f.write(header + '// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * '
                         '* * //\n\n' + text
                + '\n// ************************************************************************* '
                  '//\n')


if tank['lift'] > 0:
    write('geometry', 'plate\n{\n    type    searchableBox;\n    min     (%g 0 -1);\n    max     '
                      '(%g %g 1);\n}\n' % (tank['waterWidth'], tank['waterWidth'] + thickness, top))
    write('plateMotion', 'motion\n{\n    plate\n    {\n        patches (plate);\n'
                         '        solidBodyMotionFunction tabulated6DoFMotion;\n'
          '        tabulated6DoFMotionCoeffs\n        {\n            CofG (0 0 0);\n'
          '            timeDataFileName "constant/lift.dat";\n        }\n    }\n}\n')
    with open('constant/lift.dat', 'w') as out:
        rows = ['(%.6g ((0 %.9g 0) (0 0 0)))' % (i*step, way(i*step))
                for i in range(round((tank['held'] + 2)/step) + 1)]
        out.write('(\n' + '\n'.join(rows) + '\n)\n')
elif os.path.exists('constant/geometry'):
    os.remove('constant/geometry')
    os.remove('constant/lift.dat')
    write('plateMotion',
          '// How the plate moves: written anew by system/makeParticles.py where there is one\n')
