# SPDX-License-Identifier: GPL-3.0-or-later
"""Particles of rigid bodies, each with its exact share of the body's area or volume, for
constant/solids.csv

Each function gives points about the body's reference point (middle of a circle, sphere or block;
apex of a wedge), their areas or volumes, and their spacing.
"""
import numpy as np


def rings(R, spacing, threeD):
    """A disk of rings, or a sphere of shells, of equal thickness; each cut into equal parts"""
    n = max(int(round(R/spacing)), 1)
    s = R/n
    points, volumes = zip(*(_ring(k, s, threeD) for k in range(n)))
    return np.concatenate(points), np.concatenate(volumes), s


def _ring(k, s, threeD):
    if threeD:
        m = max(int(round(4*np.pi*((k + 0.5)**2 + 1/12))), 4)
        i = np.arange(m) + 0.5
        # spread by the golden angle
        polar, around = np.arccos(1 - 2*i/m), np.pi*(1 + np.sqrt(5))*i
        x = np.column_stack([np.cos(around)*np.sin(polar), np.cos(polar),
                             np.sin(around)*np.sin(polar)])
        volume = 4*np.pi/3*((k + 1)**3 - k**3)*s**3
    else:
        m = max(int(round(2*np.pi*(k + 0.5))), 3)
        angle = 2*np.pi*(np.arange(m) + 0.5)/m
        x = np.column_stack([np.sin(angle), -np.cos(angle), 0*angle])
        volume = np.pi*(2*k + 1)*s**2
    return (k + 0.5)*s*x, np.full(m, volume/m)


def wedge(halfBreadth, deadrise, spacing):
    """A symmetric wedge, its apex below at the origin, flat on top: rows along both faces. Cells of
    the last row are halves"""
    height = halfBreadth*np.tan(deadrise)
    n = max(int(round(height/(spacing*np.sin(deadrise))*np.sqrt(np.sin(2*deadrise)))), 1)
    a = height/(n*np.sin(deadrise))
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(n)))
    i, j = i[i + j < n], j[i + j < n]
    last = i + j + 1 == n
    y = (i + j + 1)*a*np.sin(deadrise) - np.where(last, a*np.sin(deadrise)/3, 0)
    points = np.column_stack([(i - j)*a*np.cos(deadrise), y, 0*y])
    return points, np.where(last, 0.5, 1)*a*a*np.sin(2*deadrise), np.sqrt(np.sin(2*deadrise))*a


def block(sides, spacing):
    """A box of these sides (two or three) about its middle, on a lattice that divides them"""
    n = [max(int(round(side/spacing)), 1) for side in sides]
    axes = [(np.arange(k) + 0.5)*side/k - 0.5*side for k, side in zip(n, sides)]
    grid = [g.ravel() for g in np.meshgrid(*axes, indexing='ij')]
    points = np.column_stack(grid + [np.zeros(len(grid[0]))]*(3 - len(sides)))
    return (points, np.full(len(points), np.prod(sides)/np.prod(n)),
            min(side/k for k, side in zip(n, sides)))


def write(path, points, volumes, spacing, density):
    """The body's csv: places, radius, mass"""
    table = np.column_stack([points, np.full(len(points), 0.5*spacing), density*volumes])
    np.savetxt(path, table, delimiter=',', header='x,y,z,radius,mass', comments='', fmt='%.12g')
