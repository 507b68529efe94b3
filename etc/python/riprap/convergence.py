# SPDX-License-Identifier: GPL-3.0-or-later
"""Observed order, and the limit that results tend to, with its uncertainty (standard library alone)

order        slope of log error over log spacing, for yardsticks that are the exact answer
richardson   v(h) = limit + C h^p through the three finest spacings: the limit is a yardstick of its
             own, that of the solver with ever finer spacing. Uncertainty as in the grid convergence
             index of Roache, J. Fluids Eng. 116 (1994) 405, with the factors of Oberkampf & Roy,
             Verification and Validation in Scientific Computing (2010), table 8.1.
"""
import math
from dataclasses import dataclass
from typing import Optional


@dataclass
class Order:
    order: float
    deviation: Optional[float]      # standard error of the slope; None of two spacings
    count: int


@dataclass
class Limit:
    value: float
    uncertainty: float
    order: Optional[float]          # None where the values do not fall in line
    kind: str                       # monotone, oscillating, diverging


def order(spacings, errors):
    """Of errors above zero at two spacings or more, else None"""
    points = sorted({(h, e) for h, e in zip(spacings, errors) if h > 0 and e > 0})
    if len({h for h, _ in points}) < 2:
        return None
    x, y = [math.log(h) for h, _ in points], [math.log(e) for _, e in points]
    n, mx, my = len(x), sum(x)/len(x), sum(y)/len(y)
    spread = sum((a - mx)**2 for a in x)
    slope = sum((a - mx)*(b - my) for a, b in zip(x, y))/spread
    if n == 2:
        return Order(slope, None, n)
    rest = sum((b - my - slope*(a - mx))**2 for a, b in zip(x, y))
    return Order(slope, math.sqrt(rest/(n - 2)/spread), n)


def richardson(spacings, values, formal=2.0):
    """Of three spacings or more, else None. formal: the order that the method has on paper"""
    points = sorted(dict(zip(spacings, values)).items())
    if len(points) < 3:
        return None
    (h1, v1), (h2, v2), (h3, v3) = points[:3]
    fine, coarse = v2 - v1, v3 - v2
    scatter = max(v1, v2, v3) - min(v1, v2, v3)
    if fine == 0 and coarse == 0:
        return Limit(v1, 0.0, None, 'monotone')
    if fine*coarse <= 0:
        return Limit(v1, scatter, None, 'oscillating')
    p = _exponent(h1, h2, h3, coarse/fine)
    if p is None:
        return Limit(v1, 3*scatter, None, 'diverging')
    difference = fine/((h2/h1)**p - 1)
    # With the order near the formal one the difference is trusted; else the lower of the two
    # orders, and a factor of 3
    if abs(p - formal) <= 0.1*formal:
        uncertainty = 1.25*abs(difference)
    else:
        uncertainty = 3*abs(fine)/((h2/h1)**max(0.5, min(p, formal)) - 1)
    return Limit(v1 - difference, uncertainty, p, 'monotone')


def _exponent(h1, h2, h3, ratio):
    """p with (h3^p - h2^p)/(h2^p - h1^p) = ratio; None where no p above 0.05 does that"""
    def of(p):
        return (h3**p - h2**p)/(h2**p - h1**p)
    low, high = 0.05, 12.0
    if of(low) > ratio:
        return None
    if of(high) < ratio:
        return high
    for _ in range(80):
        middle = 0.5*(low + high)
        low, high = (middle, high) if of(middle) < ratio else (low, middle)
    return 0.5*(low + high)
