# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids beside LAMMPS and LIGGGHTS: rows of runPeers"""
from riprap import plotting

from . import groups


def draw(rows, path):
    if not rows:
        print('peers: no rows to draw')
        return
    # of several runs the last one
    latest = {(r['case'], r['code'], r['quantity']): r for r in rows}
    rows = list(latest.values())
    fig, (speed, energy, reach) = plotting.figure(3, width=5.6, height=3.6)
    rates = [r for r in rows
             if r['case'] == 'column' and r['quantity'].startswith('particle-steps')]
    colours = [plotting.colours[0 if r['code'].startswith('riprap') else 1] for r in rates]
    speed.barh([r['code'] for r in rates], [float(r['value']) for r in rates], color=colours,
               height=0.6)
    speed.invert_yaxis()
    speed.set(xlabel='particle-steps a second of processor time',
              title='Column of 50,000 spheres, one thread')
    for i, (code, points) in enumerate(groups([r for r in rows if r['case'] == 'impacts'],
                                              lambda r: r['code']).items()):
        found = sorted((float(r['quantity'].split()[-2]), 100*float(r['value'])) for r in points)
        energy.plot(*zip(*found), plotting.markers[i % len(plotting.markers)] + '-',
                    color=plotting.colours[i % len(plotting.colours)], linewidth=1, markersize=4,
                    label=code)
    energy.axhline(0, color='k', linewidth=0.8)
    energy.set(xlabel='angle of incidence [degrees]', ylabel='energy after / before - 1 [%]',
               title='Elastic impacts without slip')
    plotting.named(energy)
    for i, (code, points) in enumerate(groups([r for r in rows if r['case'] == 'collapse'],
                                              lambda r: r['code']).items()):
        reach.plot([float(r['value']) for r in points],
                   [r['quantity'].replace('run-out, ', '') for r in points],
                   plotting.markers[i % len(plotting.markers)],
                   color=plotting.colours[i % len(plotting.colours)], markersize=5, label=code)
    reach.invert_yaxis()
    reach.set(xlabel='run-out / initial length', title='Columns of spheres, slices of six grains')
    if reach.lines:
        plotting.named(reach)
    plotting.save(fig, path)
