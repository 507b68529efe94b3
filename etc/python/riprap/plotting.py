# SPDX-License-Identifier: GPL-3.0-or-later
"""One style for all figures: colours that colour-blind readers tell apart, experiments as markers,
names beside the curves

named(axis) instead of axis.legend(): save() writes each name beside its curve. callouts(axis, ...)
names single points. Log axes get plain numbers, and numbers between the powers of ten where there
are few powers.
"""
import textwrap

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of the backend)
import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

# Okabe & Ito (2008)
colours = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9', '#000000']
markers = ['o', 's', '^', 'D', 'v', 'P']

# Of fields in pictures: water by its speed, other numbers, numbers of both signs
water = LinearSegmentedColormap.from_list('riprapWater', ['#0b3c68', '#14639e', '#2a8fca',
                                                          '#63bbe3', '#9fd9ee', '#d3f0f3'])
sequential = plt.get_cmap('viridis')
diverging = plt.get_cmap('RdBu_r')

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
    named(axis)
    save(fig, path)


def discs(axis, positions, radii, colour=None, **options):
    """Bodies to scale in the plane of the first two components, all of one colour or by a value
    each"""
    size = 2*np.broadcast_to(radii, len(positions))
    flat = np.ndim(colour) > 0
    drawn = EllipseCollection(size, size, np.zeros(len(size)), units='xy',
                              offsets=np.asarray(positions)[:, :2], offset_transform=axis.transData,
                              array=colour if flat else None,
                              facecolor=None if flat else colour or '#56B4E9', edgecolor='#222222',
                              linewidth=0.3, **options)
    axis.add_collection(drawn)
    return drawn


def named(axis, width=26):
    """Writes the names of curves and points beside them when the figure is saved. Lines of a name:
    of so many letters"""
    axis.riprapNames = width


def callouts(axis, points):
    """Names of single points, (x, y, text, colour) each, placed where they hide least when the
    figure is saved"""
    axis.riprapCallouts = list(points)


def pareto(points):
    """Of (cost, error) those that none other beats in both, in order of cost"""
    front = []
    for cost, error in sorted(points):
        if not front or error < front[-1][1]:
            front.append((cost, error))
    return front


def drawPareto(axis, points, label='Pareto front'):
    """What an error costs at best, as a line of steps under the points"""
    front = pareto(points)
    if not front:
        return front
    far = max(cost for cost, _ in points)
    x, y = zip(*front, (max(far, front[-1][0]), front[-1][1]))
    axis.step(x, y, where='post', color='#bbbbbb', linewidth=5, alpha=0.6, solid_capstyle='butt',
              zorder=0.5, label='_' + label)
    return front


def plain(value, _=None):
    """A number as one would write it by hand: 0.02, 5, 300, 2e5, 1e-6"""
    if value == 0:
        return '0'
    if 1e-3 <= abs(value) < 1e5:
        return f'{value:g}' if abs(value) < 1e4 else f'{value:,.0f}'.replace(',', ' ')
    power = int(np.floor(np.log10(abs(value)) + 1e-9))
    front = value/10.0**power
    return f'$10^{{{power}}}$' if abs(front - 1) < 1e-6 else f'${front:g}\\cdot 10^{{{power}}}$'


def readableLogs(axis):
    """Ticks of log axes: 1, 2, 5 where less than two powers of ten are shown, else powers, few
    enough to be read"""
    for which, limits in ((axis.xaxis, axis.get_xlim()), (axis.yaxis, axis.get_ylim())):
        if which.get_scale() != 'log' or min(limits) <= 0:
            continue
        powers = abs(np.log10(limits[1]/limits[0]))
        subs = np.arange(1, 10) if powers < 0.5 else (1, 2, 5) if powers < 2.2 else (1,)
        if powers < 0.25:
            which.set_major_locator(matplotlib.ticker.MaxNLocator(4))
        else:
            which.set_major_locator(LogLocator(base=10, subs=subs,
                                               numticks=30 if powers < 8 else 8))
        which.set_major_formatter(FuncFormatter(plain))
        which.set_minor_formatter(NullFormatter())


def save(fig, path):
    axes = [a for a in fig.axes if a.get_visible()]
    for axis in axes:
        readableLogs(axis)
    fig.draw_without_rendering()
    for axis in axes:
        if getattr(axis, 'riprapNames', None):
            _name(axis, axis.riprapNames)
        if getattr(axis, 'riprapCallouts', None):
            _callOut(axis, axis.riprapCallouts)
    fig.savefig(path)
    plt.close(fig)
    print(f'Wrote {path}')


_small = 7.5            # points


def _endOf(axis, handle):
    """Where a curve leaves the axes, as a part of their height, and the part of their width; None:
    it is not in them"""
    x, y = (np.ma.filled(np.ma.asarray(v, dtype=float), np.nan)
            for v in handle.get_data(orig=False))
    places = axis.transAxes.inverted().transform(
        handle.get_transform().transform(np.column_stack([x, y])))
    inside = (np.isfinite(places).all(axis=1) & (places >= -0.02).all(axis=1)
              & (places <= 1.02).all(axis=1))
    if not inside.any():
        return None
    ends = places[inside]
    return ends[np.argmax(ends[:, 0])]


def _name(axis, width):
    handles, labels = axis.get_legend_handles_labels()
    if len(labels) < 2 and not any(isinstance(h, tuple) for h in handles):
        if not labels:
            return
    found, others = [], []
    for handle, label in zip(handles, labels):
        end = _endOf(axis, handle) if hasattr(handle, 'get_data') else None
        (others if end is None else found).append((end, handle, label))
    pixel = axis.get_window_extent().height
    line = _small*1.25*axis.figure.dpi/72/pixel
    found.sort(key=lambda f: f[0][1])
    texts = [textwrap.fill(label, width) for _, _, label in found]
    heights = np.array([line*(t.count('\n') + 1.35) for t in texts])
    if others or heights.sum() > 1.12 or len(axis.figure.axes) > 8:
        # bars, areas and what would not fit: a list under the axes
        wide = max(map(len, labels)) > 30
        axis.legend(handles, [textwrap.fill(label, 60) for label in labels], fontsize=_small,
                    loc='upper center', borderaxespad=0.2,
                    bbox_to_anchor=(0.5, -3.6*axis.xaxis.label.get_size()*axis.figure.dpi/72/pixel),
                    ncols=1 if wide or len(labels) < 4 else 2)
        return
    middles = spread(np.array([f[0][1] for f in found]), heights, -0.06, 1.06)
    for (end, handle, _), middle, text in zip(found, middles, texts):
        colour = (handle.get_markeredgecolor() if handle.get_linestyle() in ('None', 'none', '')
                  else handle.get_color())
        axis.annotate(text, xy=(end[0], end[1]), xycoords='axes fraction', xytext=(1.05, middle),
                      textcoords='axes fraction', va='center', ha='left', fontsize=_small,
                      color=colour, annotation_clip=False, linespacing=1.05,
                      arrowprops={'arrowstyle': '-', 'color': colour, 'linewidth': 0.6,
                                  'alpha': 0.55, 'shrinkA': 1, 'shrinkB': 2, 'linestyle': ':'})


def spread(wanted, heights, low, high):
    """Middles of boxes in the order given, as near to where they are wanted as they can be without
    overlap"""
    at = np.array(wanted, dtype=float)
    for _ in range(200):
        moved = False
        for i in range(len(at) - 1):
            gap = 0.5*(heights[i] + heights[i + 1]) - (at[i + 1] - at[i])
            if gap > 1e-6:
                at[i] -= 0.5*gap
                at[i + 1] += 0.5*gap
                moved = True
        over = at[-1] + 0.5*heights[-1] - high if len(at) else 0
        if over > 0:
            at[-1] -= over
            moved = True
        under = low - at[0] + 0.5*heights[0] if len(at) else 0
        if under > 0:
            at[0] += under
            moved = True
        if not moved:
            break
    return at


def _callOut(axis, points):
    dots = []
    for handle in axis.lines:
        if handle.get_marker() not in ('None', None, ''):
            at = handle.get_transform().transform(np.column_stack(handle.get_data(orig=False)))
            dots.append(at)
            if handle.get_linestyle() not in ('None', 'none', '') and len(at) > 1:
                part = np.linspace(0, 1, 15)[:, None, None]
                dots.append((at[:-1] + part*(at[1:] - at[:-1])).reshape(-1, 2))
    dots = np.concatenate(dots) if dots else np.zeros((0, 2))
    frame = axis.get_window_extent()
    scale = axis.figure.dpi/72
    taken = []
    for x, y, text, colour in points:
        text = textwrap.fill(text, 24)
        lines = text.split('\n')
        w, h = 0.56*_small*scale*max(map(len, lines)), 1.2*_small*scale*len(lines)
        at = axis.transData.transform((x, y))
        best = None
        for reach in (8, 22, 40, 62, 90):
            for turn in np.arange(0, 360, 30):
                d = reach*scale*np.array([np.cos(np.radians(turn)), np.sin(np.radians(turn))])
                left = at[0] + d[0] - (w if d[0] < -1 else 0 if d[0] > 1 else 0.5*w)
                bottom = at[1] + d[1] - 0.5*h
                box = left, bottom, left + w, bottom + h
                hit = ((dots[:, 0] > box[0] - 4) & (dots[:, 0] < box[2] + 4)
                       & (dots[:, 1] > box[1] - 4) & (dots[:, 1] < box[3] + 4)).sum()
                overlap = sum(max(0, min(box[2], t[2]) - max(box[0], t[0]))*max(
                    0, min(box[3], t[3]) - max(box[1], t[1])) for t in taken)
                out = (max(0, frame.x0 - box[0]) + max(0, box[2] - frame.x1)
                       + max(0, frame.y0 - box[1]) + max(0, box[3] - frame.y1))
                worth = 12*hit + overlap + 6*out + 0.35*reach
                if best is None or worth < best[0]:
                    best = worth, box, d
        _, box, d = best
        taken.append(box)
        offset = np.array([box[0] + (w if d[0] < -1 else 0 if d[0] > 1 else 0.5*w),
                           box[1] + 0.5*h]) - at
        axis.annotate(text, xy=(x, y), xytext=offset/scale, textcoords='offset points',
                      fontsize=_small, color=colour, va='center', ha='right' if d[0] < -1
                      else 'left' if d[0] > 1 else 'center', linespacing=1.05, zorder=5,
                      arrowprops={'arrowstyle': '-', 'color': colour, 'linewidth': 0.6,
                                  'alpha': 0.6, 'shrinkA': 0, 'shrinkB': 3})
