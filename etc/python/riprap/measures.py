# SPDX-License-Identifier: GPL-3.0-or-later
"""Norms and orders"""
import numpy as np


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def relativeL2(values, reference):
    """|values - reference| / |reference|, Euclidean norms over everything"""
    difference = np.asarray(values) - np.asarray(reference)
    return float(np.linalg.norm(difference)/np.linalg.norm(reference))


def observedOrder(spacings, errors):
    """Slope of log(error) over log(spacing), least squares; None without two positive errors"""
    pairs = [(s, e) for s, e in zip(spacings, errors) if e is not None and e > 0]
    if len(pairs) < 2:
        return None
    s, e = np.log(np.array(pairs)).T
    return float(np.polyfit(s, e, 1)[0])


def crossing(x, y, level):
    """First x at which y, linear between samples, reaches level from below; None if it never
    does"""
    above = np.flatnonzero(np.asarray(y) >= level)
    if len(above) == 0:
        return None
    i = above[0]
    if i == 0:
        return float(x[0])
    return float(x[i - 1] + (x[i] - x[i - 1])*(level - y[i - 1])/(y[i] - y[i - 1]))


def upTo(x, y, level):
    """x and y up to and including the first sample with y >= level"""
    above = np.flatnonzero(np.asarray(y) >= level)
    n = above[0] + 1 if len(above) else len(x)
    return x[:n], y[:n]


def movingAverage(t, values, width):
    """Mean over a window of the given width in t centred on each sample (trapezoidal)"""
    t, values = np.asarray(t), np.asarray(values)
    integral = np.concatenate([[0], np.cumsum(0.5*(values[1:] + values[:-1])*np.diff(t))])
    low = np.clip(t - 0.5*width, t[0], t[-1])
    high = np.clip(t + 0.5*width, t[0], t[-1])
    return (np.interp(high, t, integral) - np.interp(low, t, integral))/(high - low)
