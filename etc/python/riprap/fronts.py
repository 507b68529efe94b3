# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam-break fronts against experiments

An experiment's clock starts when the gate starts to move, a calculation's when the water is free.
The two differ by ONE constant, found by least squares: the shift s for which Z(T - s) is nearest to
the measured points. Before its release the column stands: Z = Z(0) for T - s < 0. Points beyond the
end of the calculated curve (the far wall) are left out.
"""
import numpy as np

from .measures import rms


def readReference(path):
    """Comma-separated file with one header line, as an array"""
    return np.loadtxt(path, delimiter=',', skiprows=1, ndmin=2)


def residuals(T, Z, reference, shift=0.0):
    """Z(T - shift) minus the measured points that the curve reaches"""
    t = reference[:, 0] - shift
    known = t <= T[-1]
    return np.interp(t[known], T, Z) - reference[known, 1]


def fitShift(T, Z, reference, low=-0.2, high=0.6):
    """The shift in T of the least rms distance, and that rms.

    A scan in steps of 0.01 finds the valley (points leave the curve's end as the shift changes, so
    the function is not smooth), a golden section refines it.
    """
    def cost(shift):
        r = residuals(T, Z, reference, shift)
        return rms(r) if len(r) >= 0.7*len(reference) else np.inf
    scan = np.arange(low, high + 1e-9, 0.01)
    best = scan[int(np.argmin([cost(s) for s in scan]))]
    a, b = best - 0.01, best + 0.01
    ratio = 0.5*(np.sqrt(5) - 1)
    while b - a > 1e-4:
        c, d = b - ratio*(b - a), a + ratio*(b - a)
        a, b = (a, d) if cost(c) < cost(d) else (c, b)
    shift = min((best, 0.5*(a + b)), key=cost)
    return float(shift), float(cost(shift))
