# SPDX-License-Identifier: GPL-3.0-or-later
"""Six layers of cylinders collapse, dry: by picDem as by dem"""
import os

import numpy as np

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
dem = 'dem/dryCollapse'


def centre(run):
    """Time, x/L, y/L"""
    length = numberOf(run.dictionary('system/tank')['tank'])
    table = run.table('stack', 'groupMotion.dat')
    return table['Time'], table['freeCentreX']/length, table['freeCentreY']/length


def analyse(run):
    t, x, y = centre(run)
    return [Quantity('x/L at the end', computed=float(x[-1])),
            Quantity('y/L at the end', computed=float(y[-1]))]


def compare(runs, results):
    pair = [centre(r) for n, r in runs.items() if n.startswith(('picDem', 'dem'))]
    if len(pair) < 2:
        return []
    off = max(float(np.abs(a - b).max()) for a, b in zip(*pair))
    return [Quantity('centre of mass, picDem against dem, largest difference', error=off)]


def plot(runs, path):
    fig, axes = plotting.figure(2)
    for run in runs:
        t, x, y = centre(run)
        axes[0].plot(t, x, linewidth=1, label=run.name)
        axes[1].plot(t, y, linewidth=1, label=run.name)
    for axis, name in zip(axes, 'xy'):
        axis.set(xlabel='t [s]', ylabel=f'${name}/L$')
    plotting.named(axes[0])
    plotting.save(fig, path)


Study(
    scene='picDryCollapse',
    variants=[Variant('picDem'), Variant('dem', case=dem)],
    quick=[Variant('picDem-quick', ['-endTime', '0.1']),
           Variant('dem-quick', ['-endTime', '0.1'], case=dem)],
    analyse=analyse,
    plot=plot,
    compare=compare,
    headline='x/L at the end',
).main(here)
