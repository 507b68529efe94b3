# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces as points (n, 3) and triangles (m, 3), counter-clockwise from outside; their sections
and poses"""
import numpy as np


def box(low, high):
    low, high = np.minimum(low, high), np.maximum(low, high)
    return parallelepiped(low, *np.diag(high - low))


def parallelepiped(corner, a, b, c):
    """From a corner by three edges of a right-handed frame"""
    corners = np.array([corner + i*a + j*b + k*c for k in (0, 1) for j in (0, 1) for i in (0, 1)],
                       dtype=float)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def rotatedBox(origin, span, e1, e3):
    """OpenFOAM's searchableRotatedBox: its axes are e1, e3 x e1 and e3, made orthogonal as
    coordinateRotation does"""
    e3 = unit(e3)
    e1 = unit(e1 - np.dot(e1, e3)*e3)
    e2 = np.cross(e3, e1)
    return parallelepiped(origin, span[0]*e1, span[1]*e2, span[2]*e3)


def unit(v):
    v = np.asarray(v, dtype=float)
    return v/np.linalg.norm(v)


def across(n):
    """Two unit vectors that with n are a right-handed frame"""
    n = unit(n)
    a = unit(np.cross([1, 0, 0] if abs(n[0]) < 0.9 else [0, 1, 0], n))
    return a, np.cross(n, a)


def cylinder(p1, p2, radius, around=96):
    p1, p2 = np.asarray(p1, dtype=float), np.asarray(p2, dtype=float)
    a, b = across(p2 - p1)
    angle = 2*np.pi*np.arange(around)/around
    rim = radius*(np.outer(np.cos(angle), a) + np.outer(np.sin(angle), b))
    points = np.concatenate([p1 + rim, p2 + rim, [p1], [p2]])
    i = np.arange(around)
    j = (i + 1) % around
    low, high = np.full(around, 2*around), np.full(around, 2*around + 1)
    triangles = np.concatenate([np.column_stack(t) for t in
                                ((i, j, around + j), (i, around + j, around + i), (low, j, i),
                                 (high, around + i, around + j))])
    return points, triangles


def disk(origin, normal, radius, around=96):
    a, b = across(normal)
    angle = 2*np.pi*np.arange(around)/around
    rim = origin + radius*(np.outer(np.cos(angle), a) + np.outer(np.sin(angle), b))
    i = np.arange(around)
    return (np.concatenate([rim, [origin]]),
            np.column_stack([i, (i + 1) % around, np.full(around, around)]))


def plate(origin, span):
    """A rectangle; one of the spans is 0"""
    a, b = [s for s in np.diag(np.asarray(span, dtype=float)) if np.any(s)]
    origin = np.asarray(origin, dtype=float)
    return (np.array([origin, origin + a, origin + a + b, origin + b]),
            np.array([(0, 1, 2), (0, 2, 3)]))


def sphere(centre, radius, around=48):
    rows = around//2
    polar = np.pi*np.arange(1, rows)/rows
    angle = 2*np.pi*np.arange(around)/around
    ring = np.array([[np.sin(p)*np.cos(a), np.sin(p)*np.sin(a), np.cos(p)] for p in polar
                     for a in angle])
    points = np.concatenate([[[0, 0, 1]], ring, [[0, 0, -1]]])
    last = len(points) - 1
    triangles = []
    for i in range(around):
        j = (i + 1) % around
        triangles += [(0, 1 + i, 1 + j), (last, last - around + j, last - around + i)]
        for r in range(rows - 2):
            a, b = 1 + r*around, 1 + (r + 1)*around
            triangles += [(a + i, b + i, b + j), (a + i, b + j, a + j)]
    return np.asarray(centre) + radius*points, np.array(triangles)


def rotation(q):
    """Matrix of a unit quaternion (w, x, y, z)"""
    w, x, y, z = q
    return np.array([[1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y)],
                     [2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x)],
                     [2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)]])


def massProperties(points, triangles):
    """Volume, centre and inertia about the centre of a closed surface of density 1, by tetrahedra
    from the origin of its box"""
    origin = 0.5*(points.min(axis=0) + points.max(axis=0))
    a, b, c = (points[triangles[:, k]] - origin for k in range(3))
    six = np.einsum('ij,ij->i', a, np.cross(b, c))
    volume = six.sum()/6
    centre = np.einsum('i,ij->j', six, a + b + c)/(24*volume)
    total = a + b + c
    second = sum(np.einsum('i,ij,ik->jk', six, v, v) for v in (a, b, c, total))/120
    second -= volume*np.outer(centre, centre)
    return volume, origin + centre, np.trace(second)*np.eye(3) - second


def principalAxes(J):
    """Columns: the axes, by the turns that src/riprapFoam/shapes/principalAxes.H makes, so that
    they are the same ones"""
    axes = np.eye(3)
    J = np.array(J, dtype=float)
    for _ in range(50):
        for p in range(2):
            for q in range(p + 1, 3):
                if abs(J[p, q]) <= 1e-16*np.linalg.norm(J):
                    continue
                angle = 0.5*np.arctan2(2*J[p, q], J[q, q] - J[p, p])
                turn = np.eye(3)
                turn[p, p] = turn[q, q] = np.cos(angle)
                turn[p, q], turn[q, p] = np.sin(angle), -np.sin(angle)
                J = turn.T @ J @ turn
                axes = axes @ turn
    return axes


def outlineMiddle(outline, axes):
    """Centre of the area within a closed line (n, 3), in the plane of two axes"""
    a = outline[:, axes]
    b = np.roll(a, -1, axis=0)
    c = a[:, 0]*b[:, 1] - a[:, 1]*b[:, 0]
    middle = np.zeros(3)
    middle[list(axes)] = ((a + b)*c[:, None]).sum(axis=0)/(3*c.sum())
    return middle


def rigidFit(before, after):
    """Rotation and shift (R, s) with after = R before + s, of least squares"""
    a, b = before.mean(axis=0), after.mean(axis=0)
    u, _, v = np.linalg.svd((before - a).T @ (after - b))
    d = np.sign(np.linalg.det(v.T @ u.T)) or 1
    R = v.T @ np.diag([1, 1, d]) @ u.T
    return R, b - R @ a


def section(points, triangles, axis, height):
    """Segments (n, 2, 3) where triangles cut the plane; points in it count as above, so that each
    line is cut once"""
    off = points[:, axis] - height
    above = off[triangles] >= 0
    cut = [[], []]
    mixed = triangles[above.any(axis=1) & ~above.all(axis=1)]
    for t in mixed:
        ends = []
        for k in range(3):
            i, j = t[k], t[(k + 1) % 3]
            if (off[i] >= 0) != (off[j] >= 0):
                ends.append(points[i] + off[i]/(off[i] - off[j])*(points[j] - points[i]))
        for k in range(2):
            cut[k].append(ends[k])
    return np.stack(cut, axis=1) if mixed.size else np.zeros((0, 2, 3))


def chains(segments, tolerance):
    """Segments (n, 2, d) joined to lines, as a list of arrays; a closed one ends where it begins"""
    if not len(segments):
        return []
    ends = np.round(segments.reshape(-1, segments.shape[-1])/tolerance).astype(np.int64)
    _, name = np.unique(ends, axis=0, return_inverse=True)
    name = name.reshape(-1, 2)
    at = {}
    for k, (a, b) in enumerate(name):
        if a != b:
            at.setdefault(a, []).append(k)
            at.setdefault(b, []).append(k)
    used, lines = set(), []
    # ends of open lines first
    for start in sorted(at, key=lambda n: len(at[n]) != 1):
        while True:
            k = next((k for k in at[start] if k not in used), None)
            if k is None:
                break
            here, line = start, []
            while k is not None:
                used.add(k)
                forward = name[k][0] == here
                if not line:
                    line.append(segments[k][0 if forward else 1])
                line.append(segments[k][1 if forward else 0])
                here = name[k][1 if forward else 0]
                k = next((k for k in at[here] if k not in used), None)
            lines.append(np.array(line))
    return lines
