# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours of pictures"""
import numpy as np

from .. import plotting

ink = '#1d2b36'
wall = '#5b6770'
obstacle = '#98a2a9'
floor = '#e9ecee'
plainWater = '#2f86c1'
bodies = ['#c8a97e', '#a65d3f', '#7d8f69', '#d9b44a', '#8e6c8a', '#6b7a8f']     # by group
still = '#7c868d'


def body(group):
    return bodies[group % len(bodies)]


def maps(of, field, low, high):
    """Colour map of a field"""
    if low < 0 and -low > 0.05*high:
        return plotting.diverging
    if of == 'fluid' and field == 'U':
        return plotting.water
    return plotting.sequential


def limits(values, field):
    """Low and high that leave out the few that are far beyond; of what has both signs as far to
    both sides"""
    values = np.concatenate(values) if values else np.zeros(1)
    values = values[np.isfinite(values)]
    if not len(values):
        return 0.0, 1.0
    low, high = np.quantile(values, (0.005, 0.995))
    if low < 0 and -low > 0.05*high:
        high = max(-low, high)
        low = -high
    elif field in ('U', 'p', 'omega', 'force', 'moment', 'tension', 'turned', 'contacts',
                   'brokenBonds'):
        low = 0.0
    if high - low < 1e-9*max(abs(high), abs(low), 1e-30):
        low, high = low - 0.5*abs(low or 1), high + 0.5*abs(high or 1)
        low = 0.0 if values.min() >= 0 and low < 0 else low
    return float(low), float(high)
