# SPDX-License-Identifier: GPL-3.0-or-later
"""OpenFOAM's solidBodyMotionFunctions: where a moving wall is at a time, as a rotation and a
shift"""
import os
import re

import numpy as np

from ..dictionaries import numberOf
from .foamFiles import vectorOf
from .shapes import unit

still = (np.eye(3), np.zeros(3))


def turned(axis, angle, origin):
    """About an axis through origin by an angle"""
    x, y, z = unit(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    R = np.eye(3) + np.sin(angle)*cross + (1 - np.cos(angle))*(cross @ cross)
    return R, origin - R @ origin


def byAngles(angles):
    """OpenFOAM's tabulated6DoFMotion and oscillatingRotatingMotion: about x, then y, then z
    [rad]"""
    R = np.eye(3)
    for axis, angle in zip(np.eye(3), angles):
        R = R @ turned(axis, angle, np.zeros(3))[0]
    return R


def transformation(entries, time, case):
    """(R, s) of a group's motion; None for a function that is not known here"""
    kind = entries.get('solidBodyMotionFunction')
    coeffs = {**entries, **entries.get(f'{kind}Coeffs', {})}
    if kind == 'multiMotion':
        R, s = still
        for part in coeffs.values():
            if isinstance(part, dict) and 'solidBodyMotionFunction' in part:
                inner = transformation(part, time, case)
                if inner is None:
                    return None
                R, s = R @ inner[0], R @ inner[1] + s
        return R, s
    known = {'linearMotion': _linear, 'oscillatingLinearMotion': _oscillating,
             'rotatingMotion': _rotating, 'axisRotationMotion': _axis,
             'oscillatingRotatingMotion': _rocking, 'tabulated6DoFMotion': _tabulated}
    return known[kind](coeffs, time, case) if kind in known else None


def _linear(c, time, case):
    return np.eye(3), time*vectorOf(c['velocity'])


def _oscillating(c, time, case):
    phase = (numberOf(c['omega'])*(time + numberOf(c.get('phaseShift'), 0)) if 'phaseShift' in c
             else numberOf(c['omega'])*time)
    shift = vectorOf(c['amplitude'])*np.sin(phase)
    return np.eye(3), shift + (vectorOf(c['verticalShift']) if 'verticalShift' in c else 0)


def _rotating(c, time, case):
    return turned(vectorOf(c['axis']), numberOf(c['omega'])*time, vectorOf(c['origin']))


def _axis(c, time, case):
    speed = np.radians(vectorOf(c['radialVelocity']))
    size = np.linalg.norm(speed)
    return turned(speed, size*time, vectorOf(c['origin'])) if size else still


def _rocking(c, time, case):
    origin = vectorOf(c['origin'])
    R = byAngles(np.radians(vectorOf(c['amplitude']))*np.sin(numberOf(c['omega'])*time))
    return R, origin - R @ origin


def _tabulated(c, time, case):
    path = c['timeDataFileName'].strip('"').replace('$FOAM_CASE', case)
    path = path if os.path.isabs(path) else os.path.join(case, path)
    with open(path) as f:
        text = re.sub(r'/\*.*?\*/|//[^\n]*', ' ', f.read(), flags=re.S)
    numbers = np.array(re.findall(r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?', text), dtype=float)
    # the list's length stands first
    rows = (numbers[1:] if len(numbers) % 7 == 1 else numbers).reshape(-1, 7)
    values = np.array([np.interp(time, rows[:, 0], rows[:, k]) for k in range(1, 7)])
    origin = vectorOf(c['CofG'])
    R = byAngles(np.radians(values[3:]))
    return R, origin - R @ origin + values[:3]
