# SPDX-License-Identifier: GPL-3.0-or-later
"""A 2D scene on axes of matplotlib: water as an area in its colours, bodies as their shapes,
walls"""
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.patches import PathPatch
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from . import style, surface


def draw(axis, case, frame, camera, window, colours):
    """window: (left, right, bottom, top) in the camera's plane; colours: a ScalarMappable, or
    None"""
    view = View(case, camera)
    axis.set(xlim=window[:2], ylim=window[2:], aspect='equal')
    axis.grid(False)
    domain = _rectangle(*window)
    low, high = (case.inPlane(end[None])[0] for end in frame.bounds)
    tank = Path(view(np.array([low, (high[0], low[1]), high, (low[0], high[1]), low])))
    for item in frame.items:
        if item.kind == 'obstacle':
            _area(axis, [view(line) for line in item.lines], domain if item.hollow else None, tank,
                  facecolor=style.obstacle, edgecolor=style.wall, linewidth=0.8, zorder=2.5)
            opened = [view(line) for line in item.lines if not _isClosed(line)]
            plates = axis.add_collection(LineCollection(opened, colors=style.wall, linewidths=2.2,
                                                        capstyle='round', zorder=3.6))
            plates.set_clip_path(tank, axis.transData)
    _water(axis, frame, view, camera, colours)
    for grid, group, value in frame.blends:
        contour = _contour(axis, grid, view)
        colour = (style.floor if frame.bonds is not None else style.body(group) if value is None
                  else colours.to_rgba(value))
        axis.add_patch(PathPatch(contour, facecolor=colour, edgecolor=style.ink, linewidth=0.6,
                                 zorder=3))
    for positions, radii, group, values in frame.balls:
        size = 2*np.broadcast_to(radii, len(positions))
        discs = EllipseCollection(
            size, size, np.zeros(len(size)), units='xy', offsets=camera.plane(positions),
            offset_transform=axis.transData, zorder=3,
            facecolors=style.body(group) if values is None else colours.to_rgba(values),
            edgecolors=style.ink, linewidths=0.4 if len(positions) < 3000 else 0.1)
        axis.add_collection(discs)
    for item in frame.items:
        if item.kind == 'body':
            colour = style.body(item.group) if item.value is None else colours.to_rgba(item.value)
            _area(axis, [view(line) for line in item.lines], None, None, facecolor=colour,
                  edgecolor=style.ink, linewidth=0.8, zorder=3.2)
    if frame.bonds is not None:
        segments, values = frame.bonds
        lines = camera.plane(segments.reshape(-1, 3)).reshape(-1, 2, 2)
        axis.add_collection(LineCollection(lines, colors=colours.to_rgba(values), linewidths=1.6,
                                           zorder=3.4))
    for item in frame.items:
        if item.kind == 'wall':
            axis.add_collection(LineCollection([view(line) for line in item.lines],
                                               colors=style.wall, linewidths=2.2,
                                               capstyle='projecting', zorder=4))


class View:
    """Points (n, 2) of the case's plane as places on the picture"""

    def __init__(self, case, camera):
        self.M = np.column_stack([camera.right, camera.up])[list(case.plane)]

    def __call__(self, points):
        return np.asarray(points) @ self.M


def _water(axis, frame, view, camera, colours):
    grid = frame.grid
    if grid is not None:
        path = _contour(axis, grid, view)
        if len(path.vertices):
            colour = style.plainWater
            if grid.value is None or colours is None:
                axis.add_patch(PathPatch(path, facecolor=colour, edgecolor='none', zorder=2))
            else:
                _image(axis, grid, view, colours, path)
            axis.add_patch(PathPatch(path, facecolor='none', edgecolor=style.ink, linewidth=0.5,
                                     alpha=0.7, zorder=2.2))
    if frame.drops is not None and len(frame.drops[0]):
        positions, values, spacing = frame.drops
        size = np.full(len(positions), spacing*2/np.pi**0.5)
        axis.add_collection(EllipseCollection(
            size, size, 0*size, units='xy', offsets=camera.plane(positions),
            offset_transform=axis.transData, facecolors=style.plainWater if values is None
            or colours is None else colours.to_rgba(values), edgecolors='none', zorder=2.1))


def _image(axis, grid, view, colours, path):
    """The values as an image in the grid's own directions, turned as the view is, and cut at the
    surface"""
    rgba = colours.to_rgba(grid.value.T)
    M = view.M
    turn = Affine2D(np.array([[M[0, 0], M[1, 0], 0], [M[0, 1], M[1, 1], 0], [0, 0, 1]]))
    half = 0.5*grid.cell
    extent = (grid.low[0] - half[0], grid.high[0] + half[0], grid.low[1] - half[1],
              grid.high[1] + half[1])
    image = axis.imshow(rgba, extent=extent, origin='lower', interpolation='bilinear', zorder=2,
                        aspect='equal', transform=turn + axis.transData)
    image.set_clip_path(path, axis.transData)


def _contour(axis, grid, view):
    """Outline of the area in which f exceeds the level, as a path on the picture"""
    shut = surface.closed(grid)
    x, y = (shut.low[d] + shut.cell[d]*np.arange(shut.f.shape[d]) for d in range(2))
    drawn = axis.contour(x, y, np.maximum(shut.f.T, -50), levels=[surface.level], linewidths=0)
    sets = (drawn.get_paths() if not hasattr(drawn, 'collections')
            else [p for c in drawn.collections for p in c.get_paths()])
    drawn.remove() if hasattr(drawn, 'remove') and not hasattr(drawn, 'collections') else [
        c.remove() for c in drawn.collections]
    lines = [polygon for path in sets for polygon in path.to_polygons(closed_only=False)]
    return _compound([view(line) for line in lines if len(line) > 2])


def _compound(lines):
    vertices, codes = [np.zeros((0, 2))], []
    for line in lines:
        vertices.append(line)
        codes += ([Path.MOVETO] + [Path.LINETO]*(len(line) - 2)
                  + [Path.CLOSEPOLY if np.allclose(line[0], line[-1]) else Path.LINETO])
    return Path(np.concatenate(vertices), codes or None)


def _area(axis, lines, around, within, **look):
    """Fills closed lines; around: with what lies between them and this rectangle instead; within: a
    path that cuts it"""
    shut = [line for line in lines if _isClosed(line)]
    if around is not None:
        inner = [line if _area2(line) < 0 else line[::-1] for line in shut]
        shut = [around] + inner
    if shut:
        patch = axis.add_patch(PathPatch(_compound(shut), **look))
        if within is not None:
            patch.set_clip_path(within, axis.transData)


def _area2(line):
    a, b = line[:-1], line[1:]
    return (a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0]).sum()


def _isClosed(line):
    return len(line) > 3 and np.allclose(line[0], line[-1])


def _rectangle(left, right, bottom, top):
    w, h = right - left, top - bottom
    return np.array([[left - w, bottom - h], [right + w, bottom - h], [right + w, top + h],
                     [left - w, top + h], [left - w, bottom - h]])
