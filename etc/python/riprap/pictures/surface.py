# SPDX-License-Identifier: GPL-3.0-or-later
"""Particles as a smooth field on a grid; the water's surface is where it passes `level`

    f(x) = sum_i W(x - x_i) / int_domain W,     W a Gaussian of deviation `width` spacings, times
                                                the particle's volume

Particles go to the nodes by linear weights, and the nodes are smoothed along one axis after the
other. The division by the part of W that lies in the domain keeps f = 1 up to flat walls, so that
water ends at them and not half a spacing before. Values are means by the same weights.
"""
import numpy as np

level = 0.4
width = 0.65


class Grid:
    """f and values at nodes low + cell*(i, j[, k])"""

    def __init__(self, low, cell, f, value=None):
        self.low, self.cell, self.f, self.value = low, cell, f, value

    @property
    def high(self):
        return self.low + self.cell*(np.array(self.f.shape) - 1)

    def at(self, points):
        """f at points, linear between nodes"""
        total = 0
        for weight, index in _corners(points, self.low, self.cell, self.f.shape):
            total = total + weight*self.f.reshape(-1)[index]
        return total


def blend(positions, spacing, value=None, box=None, refine=2, smooth=width, largest=12e6,
          reach=None):
    """Grid of particles (n, D) of spacing^D each. box: (low, high) of the domain, whose flat sides
    hold water; reach: (low, high) outside of which nobody looks"""
    D = positions.shape[1]
    margin = 3*smooth*spacing + spacing
    low, high = positions.min(axis=0) - margin, positions.max(axis=0) + margin
    for bounds in (box, reach):
        if bounds is not None:
            low, high = np.maximum(low, bounds[0]), np.minimum(high, bounds[1])
    high = np.maximum(high, low + spacing)
    cell = spacing/refine
    cell *= max(1.0, (np.prod((high - low)/cell + 1)/largest)**(1/D))
    shape = np.maximum(np.ceil((high - low)/cell - 1e-6).astype(int), 1) + 1
    cells = (high - low)/(shape - 1)                # ends of the grid are ends of the domain
    f = _deposit(positions, None, low, cells, shape)*(spacing**D/np.prod(cells))
    held = (None if value is None
            else _deposit(positions, value, low, cells, shape)*(spacing**D/np.prod(cells)))
    for d in range(D):
        taps = gaussian(smooth*spacing/cells[d])
        f = filtered(f, taps, d)
        held = None if held is None else filtered(held, taps, d)
    mean = None if held is None else held/np.maximum(f, 1e-30)
    if box is not None:
        for d in range(D):
            f = f/_inside(low[d] + cells[d]*np.arange(shape[d]), box[0][d], box[1][d],
                          smooth*spacing).reshape([-1 if k == d else 1 for k in range(D)])
    return Grid(low, cells, f, mean)


def ofCells(counts, place, low, high, alpha, value=None, axes=(0, 1, 2), smooth=0.6):
    """Grid of a field in equal cells, with nodes at centres, faces and walls. axes: those that are
    kept"""
    n = [counts[d] for d in axes]
    at = tuple(place[:, d] for d in axes)
    f = np.zeros(n)
    f[at] = alpha
    held = None
    if value is not None:
        held = np.zeros(n)
        held[at] = alpha*value
    for d in range(len(n)):
        taps = gaussian(smooth)
        f, held = (None if a is None else filtered(a, taps, d, edge=True) for a in (f, held))
    f, held = (None if a is None else _twice(a) for a in (f, held))
    low, high = np.asarray(low)[list(axes)], np.asarray(high)[list(axes)]
    cells = (high - low)/(np.array(f.shape) - 1)
    return Grid(low, cells, f, None if held is None else held/np.maximum(f, 1e-30))


def closed(grid):
    """The same with a rim beyond its ends, such that the surface is shut there"""
    f = np.pad(grid.f, 1, constant_values=-50.0)
    value = None if grid.value is None else np.pad(grid.value, 1, mode='edge')
    return Grid(grid.low - grid.cell, grid.cell, f, value)


def gaussian(deviation):
    """Weights of a Gaussian on nodes, of sum 1"""
    n = max(1, int(np.ceil(3*deviation)))
    x = np.arange(-n, n + 1)
    w = np.exp(-0.5*(x/max(deviation, 1e-6))**2)
    return w/w.sum()


def filtered(a, taps, axis, edge=False):
    n = len(taps)//2
    pad = [(n, n) if d == axis else (0, 0) for d in range(a.ndim)]
    wide = np.pad(a, pad, mode='edge' if edge else 'constant')
    length, result = a.shape[axis], np.zeros_like(a)
    for k, w in enumerate(taps):
        result += w*wide[tuple(slice(k, k + length) if d == axis else slice(None)
                               for d in range(a.ndim))]
    return result


def _twice(a):
    """From n cells along each axis to 2n + 1 nodes: a wall, a centre, a face, ..."""
    for d in range(a.ndim):
        a = np.moveaxis(a, d, 0)
        wide = np.empty((2*len(a) + 1,) + a.shape[1:])
        wide[1::2] = a
        wide[2:-1:2] = 0.5*(a[1:] + a[:-1])
        wide[0], wide[-1] = a[0], a[-1]
        a = np.moveaxis(wide, 0, d)
    return a


def _corners(points, low, cells, shape):
    """(weight, flat index of a node) of the 2^D nodes about each point; those outside are moved to
    the rim with weight 0"""
    D = points.shape[1]
    x = (points - low)/cells
    inside = np.all((x >= -1e-9) & (x <= np.array(shape) - 1 + 1e-9), axis=1)
    x = np.clip(x, 0, np.array(shape) - 1)
    i = np.minimum(x.astype(int), np.maximum(np.array(shape) - 2, 0))
    part = x - i
    for corner in range(2**D):
        weight, index = inside.astype(float), np.zeros(len(points), dtype=np.int64)
        for d in range(D):
            up = corner >> d & 1
            weight = weight*(part[:, d] if up else 1 - part[:, d])
            index = index*shape[d] + np.minimum(i[:, d] + up, shape[d] - 1)
        yield weight, index


def _deposit(points, value, low, cells, shape):
    total = np.zeros(int(np.prod(shape)))
    for weight, index in _corners(points, low, cells, shape):
        total += np.bincount(index, weight if value is None else weight*value, minlength=len(total))
    # a node on a wall stands for half a cell
    return total.reshape(shape)


def _inside(x, low, high, deviation):
    """Part of a Gaussian about x that lies between low and high"""
    return np.maximum(0.5*(_erf((high - x)/deviation/2**0.5) - _erf((low - x)/deviation/2**0.5)),
                      0.05)


def _erf(x):
    """Abramowitz & Stegun 7.1.26: to 1.5e-7"""
    t = 1/(1 + 0.3275911*np.abs(x))
    y = 1 - t*np.exp(-x*x)*(0.254829592
                            + t*(-0.284496736 + t*(1.421413741 + t*(-1.453152027 + t*1.061405429))))
    return np.sign(x)*y
