# SPDX-License-Identifier: GPL-3.0-or-later
"""What sphStability found, beside theory"""
import numpy as np

from riprap import plotting

from . import groups, number


def draw(rows, path):
    if not rows:
        print('stability: no rows to draw')
        return
    fig, (growth, step, tension, impact) = plotting.figure(2, 2, width=6.0, height=4.4)
    drawGrowth(growth, [r for r in rows if r['quantity'].startswith('growth a step')
                        and r['kernel'] == 'wendlandC2'])
    drawSteps(step, [r for r in rows if r['quantity'] == 'largest c0 dt/h'])
    drawTension(tension, [r for r in rows if r['quantity'].startswith('growth rate')
                          and r['kernel'] == 'wendlandC2' and r['ratio'] == '1.25'])
    drawImpact(impact, [r for r in rows if r['test'] == 'passage'
                        and r['quantity'].startswith('block') and r['terms'] == 'short steps'])
    plotting.save(fig, path)


def drawGrowth(axis, rows):
    """The leapfrog with predicted density: two-step Adams-Bashforth"""
    z = np.linspace(0.1, 1, 200)
    b = 1 + 1.5j*z
    exact = np.abs(b + np.sqrt(b*b - 2j*z))/2 - 1
    axis.loglog(z, exact, color='k', linewidth=1, label='theory: Adams-Bashforth')
    axis.loglog(z, z**4/4, 'k:', linewidth=1, label='$(\\omega\\,dt)^4/4$')
    points = [(float(r['quantity'].split('=')[1]), number(r['measured'])) for r in rows
              if number(r['measured'])]
    if points:
        axis.loglog(*zip(*points), 'o', color=plotting.colours[0], label='measured')
    axis.set(xlabel='$\\omega\\,dt$ of the fastest sound wave', ylabel='growth a step',
             title='Sound wave, leapfrog without damping')
    plotting.named(axis)


def drawSteps(axis, rows):
    names, measured, theory = [], [], []
    for r in rows:
        names.append(f"{r['integrator']}, {r['terms']}, "
                     f"{r['kernel'].replace('wendlandC2', 'W').replace('cubicSpline', 'C')} "
                     f"{r['ratio']}")
        measured.append(number(r['measured']))
        theory.append(number(r['theory']))
    y = np.arange(len(names))
    axis.barh(y, measured, color=plotting.colours[0], height=0.6, label='measured')
    axis.plot(theory, y, 'k|', markersize=7, label='theory')
    axis.set_yticks(y, names, fontsize=5)
    axis.set(xlabel='largest $c_0\\,dt/h$', title='Sound; leapfrog, none: growth of 1e-3 a step',
             ylim=(len(names) + 1.8, -0.8))
    plotting.named(axis)


def drawTension(axis, rows):
    for i, (terms, points) in enumerate(groups(rows, lambda r: r['terms']).items()):
        found = sorted((-float(r['quantity'].split('=')[1]), number(r['measured']),
                        number(r['theory'])) for r in points)
        found = [f for f in found if f[0] > 0]
        colour = plotting.colours[i % len(plotting.colours)]
        axis.loglog([f[0] for f in found], [f[2] for f in found], '-', color=colour, linewidth=1)
        axis.loglog([f[0] for f in found], [f[1] for f in found],
                    plotting.markers[i % len(plotting.markers)], color=colour, markersize=4,
                    label=terms)
    axis.set(xlabel='tension $1 - \\rho/\\rho_0$', ylabel='growth of displacements [$c_0/h$]',
             title='Tensile instability, square lattice; lines: theory')
    plotting.named(axis)


def drawImpact(axis, rows):
    theory = {}
    for i, (walls, points) in enumerate(groups(rows, lambda r: r['walls']).items()):
        value = {r['quantity'].split(': ')[1]: number(r['measured']) for r in points}
        known = sorted((float(q.split(' ')[3]), v) for q, v in value.items()
                       if q.startswith('density deviation at'))
        theory.update({float(r['quantity'].split(' ')[4]): number(r['theory']) for r in points
                       if number(r['theory'])})
        passed = value.get('speed that passes / (c0/10)')
        colour = plotting.colours[i % len(plotting.colours)]
        axis.plot(*zip(*known), 'o-', color=colour, markersize=4, label=walls)
        if passed:
            axis.axvline(passed, color=colour, linestyle='--', linewidth=1)
    axis.plot(*zip(*sorted(theory.items())), 'k-', linewidth=1, label='water hammer')
    axis.set(xlabel='speed of the block / $(c_0/10)$', ylabel='largest $\\rho/\\rho_0 - 1$',
             title='Block thrown on a wall; dashed: passes')
    plotting.named(axis)
