# SPDX-License-Identifier: GPL-3.0-or-later
"""The same scenes by riprap's two models and by OpenFOAM's interFoam and interIsoFoam: error
against processor time

One panel a scene. Runs on one thread of a CPU are drawn filled, others (sphDem's on several threads
or a GPU) open: their wall time is no processor time. Points of a model are joined from coarse to
fine.
"""
import re

from riprap import plotting

from . import newest, number
from .cost import claim, kindOf

# scene, quantity, runs of sphDem and of picDem (as patterns), walls of interFoam
panels = [('damBreak', 'front rms [a], Koshizuka & Oka', r'(coarse-)?column(-half)?(-cpu)?',
           r'n\d+(-apic|-gpu)?', 'noSlip'),
          ('standingWave', 'period [s]', r'n\d+', r'n\d+(-apic)?', 'slip'),
          ('hydrostatic', 'pressure L2', r'tank2D.*', r'n\d+(-apic)?', 'slip')]
# grey steps: the best of one CPU thread (Pareto front); of a model the same colour and marker in
# every panel
models = ['sphDem', 'picDem flip', 'picDem apic', 'interFoam', 'interIsoFoam']


def draw(read, vof, path):
    fig, axes = plotting.figure(len(panels), width=5.6, height=4.6)
    for axis, (scene, quantity, sph, pic, walls) in zip(axes, panels):
        series = {}
        for model, name, pattern in (('sphDem', scene, sph),
                                     ('picDem', 'pic' + scene[0].upper() + scene[1:], pic)):
            rows = [r for r in read(name) if re.fullmatch(pattern, r['run'])
                    and r['quantity'] == quantity and number(r['error'])]
            for r in newest(rows, ('run', 'spacing', 'precision', 'device')):
                serial = '1 threads' in r['device']
                kind = ('one CPU thread' if serial
                        else ('H200' if 'H200' in r['device'] else 'CPU, all threads'))
                transfer = re.search(r'transfer=(\w+)', r['settings'])
                label = f'{model}{" " + transfer.group(1) if transfer else ""}, {kind}'
                series.setdefault((label, serial), []).append(
                    (number(r['wallTime'])/number(r['simulated']), number(r['error'])))
        rows = [r for r in vof if r['scene'] == scene and r['quantity'] == quantity
                and r['walls'] == walls and number(r['error'])]
        for r in newest(rows, ('solver', 'cell')):
            solver = r['solver'] or 'interFoam'
            series.setdefault((f'{solver}, one CPU thread', True), []).append(
                (number(r['cpuTime'])/number(r['simulated']), number(r['error'])))
        title, unit, factor = claim(quantity, kindOf({'quantity': quantity}))
        series = {key: [(cost, factor*error) for cost, error in points]
                  for key, points in series.items()}
        plotting.drawPareto(axis,
                            [p for (_, serial), points in series.items() if serial for p in points])
        for (label, serial), points in series.items():
            x, y = zip(*sorted(points))
            i = models.index(label.split(',')[0])
            axis.loglog(x, y, '-' if serial else '--', marker=plotting.markers[i], markersize=5,
                        linewidth=1, label=label, color=plotting.colours[i],
                        markerfacecolor=None if serial else 'none')
        axis.set(xlabel='time a simulated second [s]', ylabel=unit, title=f'{scene}: {title}')
        plotting.named(axis)
    plotting.save(fig, path)
