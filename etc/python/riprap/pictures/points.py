# SPDX-License-Identifier: GPL-3.0-or-later
"""A 3D scene on axes of matplotlib, where there is no ParaView: discs and faces, the farthest first

Water: particles near its surface, lit by the slope of the smooth field there.
"""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb

from . import camera as cameras, style

light = np.array([-0.45, 0.75, 0.5])        # right, up, towards the eye
sides = 12
most = 60000


def draw(axis, case, frame, camera, window, colours):
    axis.set(xlim=(-1, 1), ylim=(-1, 1), xticks=[], yticks=[])
    axis.set_aspect(camera.half[1]/camera.half[0])
    axis.set_axis_off()
    frameAxes = np.column_stack([camera.right, camera.up, camera.toEye])
    toLight = frameAxes @ (light/np.linalg.norm(light))
    polygons, depths, faces = [], [], []

    def shade(colour, slope):
        return np.clip(np.asarray(colour)*(0.5 + 0.5*np.clip(slope, 0, 1))[:, None], 0, 1)

    def discs(positions, radii, colour, corners=sides, nearer=0.0):
        if not len(positions):
            return
        places, depth = camera.project(positions)
        angle = 2*np.pi*np.arange(corners)/corners
        rim = np.column_stack([np.cos(angle), np.sin(angle)])
        size = (np.broadcast_to(radii, len(positions))/depth)[:, None, None]/np.array(camera.half)
        polygons.extend(places[:, None] + size*rim)
        depths.append(depth - np.broadcast_to(radii, len(positions)) - nearer)
        faces.append(colour)

    for item in frame.items:
        if item.points is None or item.kind in ('open',) or not len(item.triangles):
            continue
        corner = item.points[item.triangles]
        if item.kind != 'wall':
            corner = within(corner,
                            window if item.kind == 'body' else cameras.common(window, frame.bounds),
                            0.08*np.linalg.norm(np.subtract(*window)))
            if not len(corner):
                continue
        normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
        towards = np.einsum('ij,ij->i', normal, camera.eye - corner[:, 0])
        if item.kind == 'wall' or item.hollow:
            corner, normal = corner[towards < 0], -normal[towards < 0]
            corner = np.clip(corner, window[0], window[1])
        else:
            corner, normal = corner[towards > 0], normal[towards > 0]
        if not len(corner):
            continue
        places, depth = camera.project(corner.reshape(-1, 3))
        far = item.kind == 'wall'
        colour = to_rgb({'body': style.body(item.group), 'obstacle': style.floor if item.hollow
                         else style.obstacle, 'wall': style.floor}[item.kind])
        if item.value is not None:
            colour = colours.to_rgba(item.value)[:3]
        polygons.extend(places.reshape(-1, 3, 2))
        depths.append(depth.reshape(-1, 3).mean(axis=1) + (1e6 if far else 0))
        faces.append(shade(colour, 0.75 + 0.25*normal @ toLight if far else normal @ toLight))
    if frame.water is not None:
        positions, values, spacing = frame.water
        f, slope = lit(frame.grid, positions, toLight)
        # at the surface, or at a side of the tank
        box = case.box()
        rim = np.zeros(len(f), dtype=bool) if box is None else np.any(
            (positions < box[0] + 0.8*spacing) | (positions > box[1] - 0.8*spacing), axis=1)
        seen = np.flatnonzero((f < 0.93) | rim)
        if len(seen) > most:
            seen = seen[np.linspace(0, len(seen) - 1, most).astype(int)]
        colour = (np.array(to_rgb(style.plainWater))[None] if values is None or colours is None
                  else colours.to_rgba(values[seen])[:, :3])
        discs(positions[seen], 0.62*spacing,
              shade(np.broadcast_to(colour, (len(seen), 3)), 0.5 + 0.5*slope[seen]))
    for positions, radii, group, values in frame.balls + frame.blended:
        colour = (np.broadcast_to(to_rgb(style.body(group)), (len(positions), 3)) if values is None
                  else colours.to_rgba(values)[:, :3])
        discs(positions, radii, 0.78*np.asarray(colour), 24 if len(positions) < 3000 else sides)
        if len(positions) < 3000:
            # rounder by two lighter discs towards the light
            for size, gain in ((0.72, 0.95), (0.4, 1.1)):
                at = (positions
                      + (1 - size)*0.55*np.broadcast_to(radii, len(positions))[:, None]*toLight)
                discs(at, size*radii, np.clip(gain*np.asarray(colour), 0, 1), 24, (1 - size)*radii)
    if polygons:
        order = np.argsort(-np.concatenate(depths), kind='stable')
        colour = np.concatenate(faces)[order]
        axis.add_collection(PolyCollection([polygons[i] for i in order], facecolors=colour,
                                           edgecolors=0.8*colour, linewidths=0.2))
    if frame.bonds is not None and len(frame.bonds[0]):
        segments, values = frame.bonds
        places, _ = camera.project(segments.reshape(-1, 3))
        axis.add_collection(LineCollection(places.reshape(-1, 2, 2), colors=colours.to_rgba(values),
                                           linewidths=1.5))
    corners, _ = camera.project(cameras.corners(*window))
    edges = [(i, j) for i in range(8) for j in range(i) if bin(i ^ j).count('1') == 1]
    axis.add_collection(LineCollection([corners[[i, j]] for i, j in edges], colors=style.wall,
                                       linewidths=0.6, alpha=0.6))


def within(triangles, window, longest):
    """The part of triangles (n, 3, 3) in a box, in pieces of no more than a length, which the order
    by depth needs"""
    for d in range(3):
        for end, sign in ((0, 1), (1, -1)):
            off = sign*(triangles[:, :, d] - window[end][d])
            inside = (off >= 0).sum(axis=1)
            pieces = [triangles[inside == 3]]
            for t, o in zip(triangles[(inside > 0) & (inside < 3)],
                            off[(inside > 0) & (inside < 3)]):
                ring = []
                for a, b in ((0, 1), (1, 2), (2, 0)):
                    if o[a] >= 0:
                        ring.append(t[a])
                    if (o[a] >= 0) != (o[b] >= 0):
                        ring.append(t[a] + o[a]/(o[a] - o[b])*(t[b] - t[a]))
                pieces.append(np.array([(ring[0], ring[k], ring[k + 1])
                                        for k in range(1, len(ring) - 1)]).reshape(-1, 3, 3))
            triangles = np.concatenate(pieces)
    for _ in range(12):
        sides_ = np.linalg.norm(np.roll(triangles, -1, axis=1) - triangles, axis=2)
        long_ = sides_.max(axis=1) > longest
        if not long_.any():
            break
        t, k = triangles[long_], sides_[long_].argmax(axis=1)
        n = np.arange(len(t))
        a, b, c = t[n, k], t[n, (k + 1) % 3], t[n, (k + 2) % 3]
        middle = 0.5*(a + b)
        triangles = np.concatenate([triangles[~long_], np.stack([a, middle, c], axis=1),
                                    np.stack([middle, b, c], axis=1)])
    return triangles


def lit(grid, positions, toLight):
    """f, and the cosine between the surface's normal and the light, at particles"""
    f = grid.at(positions)
    step = np.diag(grid.cell)
    slope = np.stack([grid.at(positions - s) - grid.at(positions + s) for s in step],
                     axis=1)/(2*grid.cell)
    return f, slope @ toLight/np.maximum(np.linalg.norm(slope, axis=1), 1e-30)
