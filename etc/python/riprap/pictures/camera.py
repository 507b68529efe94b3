# SPDX-License-Identifier: GPL-3.0-or-later
"""Up is against g; what of a scene fits on a picture"""
import numpy as np

from . import PictureError
from .motions import turned
from .shapes import unit

names = {'front': (0, 0), 'back': (180, 0), 'right': (90, 0), 'left': (-90, 0), 'top': (0, 89.9),
         'oblique': (26, 20)}
angle = 20.0            # of the view, degrees


class Camera:
    """right, up and toEye are a right-handed frame; focus, distance and half-widths after fit()"""

    def __init__(self, right, up, toEye):
        self.right, self.up, self.toEye = (np.asarray(v, dtype=float) for v in (right, up, toEye))
        self.focus, self.distance, self.half = np.zeros(3), None, (1.0, 1.0)

    @property
    def eye(self):
        return self.focus + self.distance*self.toEye

    def plane(self, points):
        """Places (n, 2) to the right and up, without perspective"""
        return np.asarray(points) @ np.column_stack([self.right, self.up])

    def project(self, points):
        """Places (n, 2) on a picture from (-1, -1) to (1, 1), and the depth from the eye"""
        off = np.asarray(points) - self.eye
        depth = -off @ self.toEye
        flat = off @ np.column_stack([self.right, self.up])/depth[:, None]
        return flat/self.half, depth

    def fit(self, corners, shape=None, margin=0.04):
        """Holds all corners. shape: width over height of the picture, or None: as the scene has it.
        Returns it"""
        corners = np.asarray(corners, dtype=float)
        self.focus = 0.5*(corners.min(axis=0) + corners.max(axis=0))
        size = np.linalg.norm(np.ptp(corners, axis=0))
        self.distance = size/(2*np.tan(np.radians(angle/2)))*1.1
        for _ in range(8):
            off = corners - self.eye
            flat = off @ np.column_stack([self.right, self.up])/(-off @ self.toEye)[:, None]
            middle = 0.5*(flat.min(axis=0) + flat.max(axis=0))
            self.focus = self.focus + self.distance*(middle[0]*self.right + middle[1]*self.up)
        half = 0.5*np.ptp(flat, axis=0)*(1 + 2*margin)
        own = half[0]/half[1]
        shape = shape or min(max(own, 0.5), 4.0)
        self.half = (max(half[0], half[1]*shape), max(half[1], half[0]/shape))
        return shape


def upOf(gravity, flat):
    """Against g in the plane; without g y, or z where y is the empty direction"""
    g = np.array(gravity, dtype=float)
    if flat is not None:
        g[flat] = 0
    if np.linalg.norm(g) > 1e-12:
        return -unit(g)
    return np.eye(3)[2 if flat == 1 else 1]


def straight(v):
    """Axis along which a vector lies, else None"""
    k = int(np.argmax(np.abs(v)))
    return k if abs(abs(v[k]) - 1) < 1e-6 else None


def choose(gravity, flat, size, view=None):
    """Camera. size: of the scene along x, y, z. view: a name, or 'AZIMUTH,ELEVATION' in degrees;
    None: front in 2D, oblique in 3D"""
    up = upOf(gravity, flat)
    if flat is not None:
        if view not in (None, 'front', 'back'):
            raise PictureError(f"-view {view}: a 2D case is seen from front or back")
        toEye = np.eye(3)[flat]
        right = np.cross(up, toEye)
        if right[np.argmax(np.abs(right))] < 0:
            right, toEye = -right, -toEye
        if view == 'back':
            right, toEye = -right, -toEye
        return Camera(right, up, toEye)
    # the longest side lies across the picture, the first of equals
    sides = [k for k in range(3) if abs(up[k]) < 0.9]
    longest = max(sides, key=lambda k: (round(size[k]/max(size), 1), -k))
    right = np.eye(3)[longest]
    right = unit(right - np.dot(right, up)*up)
    azimuth, elevation = _angles(view or 'oblique')
    toEye = np.cross(right, up)
    R = turned(up, np.radians(azimuth), np.zeros(3))[0]
    right, toEye = R @ right, R @ toEye
    R = turned(right, -np.radians(elevation), np.zeros(3))[0]
    return Camera(right, R @ up, R @ toEye)


def _angles(view):
    if view in names:
        return names[view]
    try:
        azimuth, elevation = (float(w) for w in view.split(','))
    except ValueError:
        raise PictureError(f"-view {view}: one of {', '.join(names)}, "
                           "or AZIMUTH,ELEVATION in degrees") from None
    if abs(elevation) >= 90:
        raise PictureError(f'-view {view}: the elevation is between -90 and 90 degrees')
    return azimuth, elevation


def shown(tank, boxes, up, spare=0.08):
    """(low, high) of what is looked at: the content, and the tank unless that is much larger; of a
    high sky only a little. tank: None where there are no walls"""
    if tank is None:
        tank = np.full(3, np.inf), np.full(3, -np.inf)
    content = np.array([np.min([b[0] for b in boxes], axis=0),
                        np.max([b[1] for b in boxes], axis=0)]) if boxes else np.array(tank)
    low, high = np.array(tank[0], dtype=float), np.array(tank[1], dtype=float)
    size = np.maximum(content[1] - content[0], 1e-12)
    whole = max(size.max(), 1e-12)
    for d in range(3):
        if low[d] > high[d]:
            low[d], high[d] = content[0][d] - spare*whole, content[1][d] + spare*whole
            continue
        above, below = (0.5, 0.5) if abs(up[d]) > 0.5 else (2.5, 2.5)
        reach = max(size[d], 0.3*whole)
        # half a particle stands out of a tank, which is no reason to look beyond it
        if content[0][d] - low[d] > below*reach or content[0][d] < low[d] - 0.03*whole:
            low[d] = content[0][d] - spare*whole
        if high[d] - content[1][d] > above*reach or content[1][d] > high[d] + 0.03*whole:
            high[d] = content[1][d] + spare*whole
    return low, high


def common(window, bounds):
    """(low, high) of what two boxes share; where they share nothing, a slice without width at the
    first one's rim"""
    low, high = np.maximum(window[0], bounds[0]), np.minimum(window[1], bounds[1])
    return np.minimum(low, window[1]), np.maximum(high, np.minimum(low, window[1]))


def corners(low, high):
    return np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1)
                     for j in (0, 1) for k in (0, 1)])
