# SPDX-License-Identifier: GPL-3.0-or-later
"""A free disk at rest in the middle of a round tank full of water, released: the force that water
puts on it in one step

Potential flow between circles of radius a and R (Lamb, Hydrodynamics, chapter IV): the added mass
is
C = (R^2 + a^2)/(R^2 - a^2) of the displaced water's. With s the density ratio the disk starts with
g (1 - s)/(s + C) upwards, and the water's force on it, over the weight of the displaced water, is s
(1 + C)/(s + C).
"""
import os

from riprap import plotting
from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from riprap.study import Study, Variant

here = os.path.dirname(os.path.abspath(__file__))
R, a, g = 0.45, 0.2, 9.81
C = (R**2 + a**2)/(R**2 - a**2)
ratios = (0.01, 0.5, 2.7, 1000)


def density(run):
    return numberOf(run.solid['materials']['disk']['rho'])/run.density


def force(run):
    """Of the water, over the displaced water's weight: computed, exact"""
    table, s = run.table('disk', 'groupMotion.dat'), density(run)
    acceleration = table['freeUy'][-1]/table['Time'][-1]
    return s*(acceleration/g + 1), s*(1 + C)/(s + C)


def analyse(run):
    computed, exact = force(run)
    s = density(run)
    # the coefficient that the force tells
    return [Quantity('force / displaced weight', computed, exact, abs(computed/exact - 1)),
            Quantity('added mass / displaced mass', s*(1 - computed)/(computed - s), C)]


def plot(runs, path):
    fig, (axis,) = plotting.figure(1)
    for s in ratios:
        mine = sorted((r for r in runs if density(r) == s), key=lambda r: r.spacing)
        if not mine:
            continue
        cells = [a/(2*r.spacing) for r in mine]
        errors = [abs(x/y - 1) for x, y in map(force, mine)]
        axis.loglog(cells, errors, 'o-', markersize=4, label=f'density ratio {s:g}')
    axis.loglog([6, 24], [0.02, 0.02/16], 'k:', label='second order')
    axis.axhline(0.01, color='k', linewidth=0.8, linestyle='--', label='bound at 12 cells')
    axis.set(xlabel='cells a radius', ylabel="error of the water's force")
    plotting.named(axis)
    plotting.save(fig, path)


def grid(n, s):
    """n cells a radius, density ratio s"""
    return ['-set', f'system/tank:n {5*n}; system/tank:spacing {0.1/n:.12g}; '
                    f'constant/solidProperties:materials/disk/rho {1000*s:g}']


Study(
    scene='picAddedMass',
    variants=[Variant(f'n{n}-{s:g}', grid(n, s)) for s in ratios for n in (6, 12, 24)],
    quick=[Variant('n12-0.5-quick', grid(12, 0.5))],
    analyse=analyse,
    plot=plot,
    headline='force / displaced weight',
    orders=[('force / displaced weight', [f'n{n}-{s:g}' for n in (6, 12, 24)]) for s in ratios],
).main(here)
