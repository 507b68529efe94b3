# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam break: front and height against Koshizuka & Oka (1996) and Martin & Moyce (1952)"""
import os
import shutil

from riprap.bounds import Quantity
from riprap.collapse import analyse, plot
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))


def compare(runs, results):
    """Error at half the spacing less that at the stated one: no worse"""
    out = []
    for kind in ('', '-constantH', '-stationary', '-stationary-constantH'):
        for shape, name in (('column', 'Koshizuka & Oka'), ('square', 'Martin & Moyce n2=1')):
            pair = [f'{shape}{kind}', f'{shape}{kind}-half']
            if all(p in results and results[p] for p in pair):
                e = [next(q.error for q in results[p] if q.name == f'front rms [a], {name}')
                     for p in pair]
                out.append(Quantity(f'rms at half the spacing - rms, {pair[0]}', error=e[1] - e[0]))
    return out


# The square column of 57.15 mm has the same number of particles across as the paper's column
square = (
    'system/tank:columnWidth 0.05715; system/tank:columnHeight 0.05715; '
    'system/tank:tankWidth 0.5715;system/tank:tankHeight 0.12; system/tank:nx 200; '
    'system/tank:ny 42; system/controlDict:endTime 0.32;system/controlDict:sampleInterval 0.001')
# Stationary walls push by the fluid's own density: diffusing it lets particles through
stationary = 'walls/model stationary; densityDiffusion none'
# The paper's terms alone: nothing damps the noise of pressure
paper = stationary + '; viscosity laminar'
constantH = 'smoothingLength/model constant'


def variants():
    """The stated resolution with and without variable h and with each wall model, each of them at
    half the spacing as well; for the default a coarser one, double precision and, beside a GPU, the
    CPU; the paper's terms alone"""
    spacings = {'coarse-column': '0.0073', 'column': '0.005', 'column-half': '0.0025'}
    result = [Variant('coarse-column', ['-spacing', '0.0073'])]
    for name, dp in spacings.items():
        result.append(Variant(f'{name}-double', ['-spacing', dp, '-set', 'precision double']))
        if shutil.which('nvidia-smi'):      # else all of them are the CPU's
            result.append(Variant(f'{name}-cpu', ['-spacing', dp, '-device', 'cpu']))
    for suffix, sets in (('', []), ('-constantH', [constantH]), ('-stationary', [stationary]),
                         ('-stationary-constantH', [stationary, constantH])):
        for shape, base, spacing in (('column', [], 0.005), ('square', [square], 0.05715/29)):
            changes = [option for s in base + sets for option in ('-set', s)]
            for part, dp in (('', spacing), ('-half', spacing/2)):
                end = [] if shape == 'square' or suffix == '' else ['-endTime', '0.5']
                result.append(Variant(f'{shape}{suffix}{part}',
                                      ['-spacing', f'{dp:.8g}', *changes, *end]))
    for name, dp in (('paper-column', '0.005'), ('paper-column-half', '0.0025')):
        result.append(Variant(name, ['-spacing', dp, '-set', paper, '-endTime', '0.5'],
                              mayFail=True))
    return result


Study(
    scene='damBreak',
    variants=variants(),
    quick=[Variant('quick-column', ['-spacing', '0.0073', '-endTime', '0.4'])],
    analyse=analyse,
    plot=plot,
    headline='front rms [a], Koshizuka & Oka',
    orders=[('front rms [a], Koshizuka & Oka', ['coarse-column', 'column', 'column-half'])],
    compare=compare,
).main(here)
