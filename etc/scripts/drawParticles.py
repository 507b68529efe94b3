# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a case's particles without ParaView, by matplotlib

usage: drawParticles.py CASE [FIELD [TIME ...]]

Draws CASE/<time>/lagrangian/fluid, seen along -z, coloured by FIELD (default U, its magnitude) at the given times
(default: the last) in the box of the mesh up to the highest particle, and saves CASE/<name>-particles.png as etc/scripts/renderCase.py does.
"""
import glob
import os
import sys

import numpy as np

from riprap import clouds, plotting
from riprap.dictionaries import numberOf, readDictionary

labels = {'U': 'speed [m/s]', 'p': 'p [Pa]', 'rho': 'rho [kg/m3]', 'h': 'h [m]'}


def meshBox(case):
    """Corners (2, 3) of the mesh's box"""
    points = clouds.readField(os.path.join(case, 'constant', 'polyMesh', 'points'))
    return np.array([points.min(axis=0), points.max(axis=0)])


def load(case, time, field):
    """Positions (n, 2), the nearest to the eye last, and the field's value or magnitude (n)"""
    cloud = clouds.readCloud(case, time, (field,))
    value = cloud[field]
    order = np.argsort(cloud['positions'][:, 2], kind='stable')
    return cloud['positions'][order, :2], (np.linalg.norm(value, axis=1) if value.ndim > 1 else value)[order]


def main(case, field='U', *times):
    case = os.path.abspath(case)
    spacing = numberOf(readDictionary(os.path.join(case, 'system', 'setParticlesDict')).get('spacing'))
    names = [clouds.nearestTime(case, float(t)) for t in times] or clouds.times(case)[-1:]
    frames = [load(case, name, field) for name in names]
    low, high = meshBox(case)[:, :2]
    # an empty sky is not drawn
    high[1] = min(high[1], low[1] + 1.05*(max(positions[:, 1].max() for positions, _ in frames) - low[1]))
    columns = min(3, len(names))
    rows = -(-len(names)//columns)
    height = min(6.0, 4.0*(high[1] - low[1])/(high[0] - low[0]) + 0.4)
    fig, axes = plotting.figure(columns, rows, 4.0, height)
    top = max(value.max() for _, value in frames)
    for axis, name, (positions, value) in zip(axes, names, frames):
        drawn = plotting.discs(axis, positions, 0.5*spacing, value, cmap='viridis')
        drawn.set_clim(0, top)
        drawn.set_edgecolor('none')
        axis.set(title=f't = {name} s', xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect='equal', xticks=[], yticks=[])
        axis.grid(False)
        for spine in axis.spines.values():
            spine.set_visible(True)
    for axis in axes[len(names):]:
        axis.set_visible(False)
    fig.colorbar(drawn, ax=axes, label=labels.get(field, field), shrink=0.6)
    foam = glob.glob(os.path.join(case, '*.foam'))
    stem = os.path.splitext(foam[0])[0] if foam else os.path.join(case, os.path.basename(case))
    plotting.save(fig, stem + '-particles.png')


if __name__ == '__main__':
    main(*sys.argv[1:])
