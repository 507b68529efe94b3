# SPDX-License-Identifier: GPL-3.0-or-later
"""One style for all figures: colours that colour-blind readers tell apart, experiments as markers"""
import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402

# Okabe & Ito (2008)
colours = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000']
markers = ['o', 's', '^', 'D', 'v', 'P']

plt.rcParams.update({
    'figure.dpi': 100, 'savefig.dpi': 150, 'savefig.bbox': 'tight', 'font.size': 10,
    'axes.grid': True, 'grid.alpha': 0.3, 'axes.spines.top': False, 'axes.spines.right': False,
    'axes.prop_cycle': matplotlib.cycler(color=colours), 'legend.frameon': False,
    'lines.linewidth': 1.6, 'figure.constrained_layout.use': True,
})


def figure(columns=1, rows=1, width=5.0, height=3.8):
    """Figure and its axes as a flat list"""
    fig, axes = plt.subplots(rows, columns, figsize=(width*columns, height*rows), squeeze=False)
    return fig, list(axes.flat)


def measured(axis, x, y, label, index=0):
    """Experimental points"""
    axis.plot(x, y, linestyle='none', marker=markers[index % len(markers)], markerfacecolor='none',
              markeredgecolor='#444444', markersize=5, label=label)


def besideMeasured(path, runs, curve, reference, label, xlabel, ylabel):
    """One figure: what was measured (x, y), and curve(run), x and y, of each run"""
    fig, (axis,) = figure(1)
    measured(axis, *reference, label=label)
    for run in runs:
        axis.plot(*curve(run), linewidth=1, label=run.name)
    axis.set(xlabel=xlabel, ylabel=ylabel)
    axis.legend(fontsize=7)
    save(fig, path)


def discs(axis, positions, radii, colour=None, **options):
    """Bodies to scale in the plane of the first two components, all of one colour or by a value each"""
    size = 2*np.broadcast_to(radii, len(positions))
    flat = np.ndim(colour) > 0
    drawn = EllipseCollection(size, size, np.zeros(len(size)), units='xy', offsets=np.asarray(positions)[:, :2],
                              offset_transform=axis.transData, array=colour if flat else None,
                              facecolor=None if flat else colour or '#56B4E9', edgecolor='#222222', linewidth=0.3, **options)
    axis.add_collection(drawn)
    return drawn


def save(fig, path):
    fig.savefig(path)
    plt.close(fig)
    print(f'Wrote {path}')
