# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels, titles and a colour bar on one sheet; films of such sheets"""
import os
import shutil
import subprocess
import tempfile

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from . import PictureError, camera as cameras, flat, panels, points, scene, style

dpi = 100


class Picture:
    """What all sheets of a case share: camera, window and colours"""

    def __init__(self, case, names, field, view=None, limits=None, paraview=True):
        self.case, self.field = case, field
        self.frames = [case.frame(name, field) for name in names]
        boxes = [box for frame in self.frames for box in frame.boxes]
        up = cameras.upOf(case.gravity, case.flat)
        tank = self._tank()
        self.window = cameras.shown(tank, boxes, up)
        self.camera = cameras.choose(case.gravity, case.flat, self.window[1] - self.window[0], view)
        self.paraview = paraview and case.flat is None and panels.program() is not None
        self.colours = None
        if field is not None:
            of, what = field
            shown = [v for frame in self.frames for v in frame.shown]
            low, high = limits or style.limits(shown, what)
            self.colours = ScalarMappable(Normalize(low, high), style.maps(of, what, low, high))
            everything = np.concatenate(shown) if shown else np.zeros(1)
            slack = 1e-6*(high - low)
            beyond = (everything.max(initial=low) > high + slack,
                      everything.min(initial=high) < low - slack)
            self.extend = {(True, True): 'both', (True, False): 'max',
                           (False, True): 'min'}.get(beyond, 'neither')

    def _tank(self):
        """Corners of what the walls reach in all frames; None without walls"""
        mesh = self.case.mesh
        items = [i for frame in self.frames for i in frame.items + frame.unseen if i.kind == 'wall']
        if not items:
            return None
        if self.case.flat is None:
            points = np.concatenate([i.points for i in items])
            return points.min(axis=0), points.max(axis=0)
        ends = np.concatenate([line for i in items for line in i.lines])
        low, high = mesh.low.astype(float), mesh.high.astype(float)
        low[list(self.case.plane)], high[list(self.case.plane)] = ends.min(axis=0), ends.max(axis=0)
        return low, high

    def byParaView(self, frames, pixels):
        """Pictures of 3D frames; None where ParaView is there and does not work, as without a
        display"""
        try:
            return panels.draw(self.case, frames, self.camera, pixels, self.colours, self.window)
        except PictureError as wrong:
            self.case.note(f'{wrong}; drawn by matplotlib')
            return None

    def planar(self):
        """(left, right, bottom, top) of a 2D scene"""
        places = self.camera.plane(cameras.corners(*self.window))
        low, high = places.min(axis=0), places.max(axis=0)
        edge = 0.015*(high - low).max()
        return low[0] - edge, high[0] + edge, low[1] - edge, high[1] + edge

    def shape(self):
        """Height over width of a panel"""
        if self.case.flat is not None:
            left, right, bottom, top = self.planar()
            return (top - bottom)/(right - left)
        return 1/self.camera.fit(cameras.corners(*self.window))


class Layout:
    """Places of panels on a sheet of `size` pixels; what is not given follows the panels' shape"""

    title, edge, bar, ticks = 28, 14, 100, 62

    def __init__(self, count, shape, size, coloured, planar):
        width, height = size
        left = self.ticks + self.edge if planar else self.edge
        right = (self.bar if coloured else 0) + self.edge
        foot = self.ticks - 10 if planar else self.edge
        best = None
        for columns in range(1, count + 1):
            rows = -(-count//columns)
            gap = 10
            wide = (width - left - right - gap*(columns - 1))/columns
            if wide < 60:
                continue
            high = wide*shape
            total = rows*(high + self.title) + foot + self.edge
            scale = 1.0
            # without a height a sheet is about half as high as wide, and not higher than wide
            most = height or 0.8*width
            worth = -abs(np.log(total/width/0.5)) - 5*(1 - count/(rows*columns))
            if total > most:
                scale = max((most - foot - self.edge - rows*self.title)/(rows*high), 0.05)
            if height:
                worth = wide*scale
            if best is None or worth > best[0]:
                best = worth, columns, rows, wide*scale, high*scale, height or min(total, most)
        if best is None:
            raise PictureError(f'-size: {width} pixels are too few for {count} panels side by side')
        _, self.columns, self.rows, self.wide, self.high, total = best
        used = left + right + gap*(self.columns - 1) + self.columns*self.wide
        self.size = width, int(round(total))
        spare = 0.5*(width - used)
        top = (self.edge
               + 0.5*max(0, self.size[1] - foot - self.edge - self.rows*(self.high + self.title)))
        self.places = []
        for k in range(count):
            row, column = divmod(k, self.columns)
            x = spare + left + column*(self.wide + gap)
            y = top + row*(self.high + self.title) + self.title
            self.places.append((x/width, 1 - (y + self.high)/self.size[1], self.wide/width,
                                self.high/self.size[1]))
        bottom = top + self.rows*(self.high + self.title)
        length = min(bottom - top - self.title, max(160, min(0.7*(bottom - top), 480)))
        middle = 0.5*(top + self.title + bottom)
        x = spare + left + self.columns*self.wide + gap*(self.columns - 1) + 14
        self.barPlace = (x/width, 1 - (middle + 0.5*length)/self.size[1], 13/width,
                         length/self.size[1])

    def outer(self, k, count):
        """Is it the first of its row; the last of its column"""
        return k % self.columns == 0, k + self.columns >= count


def draw(picture, frames, size):
    """A sheet of these frames"""
    case = picture.case
    planar = case.flat is not None
    layout = Layout(len(frames), picture.shape(), size, picture.colours is not None, planar)
    images = None
    if picture.paraview:
        pixels = int(round(layout.wide)), int(round(layout.high))
        picture.camera.fit(cameras.corners(*picture.window), pixels[0]/pixels[1])
        images = picture.byParaView(frames, pixels)
    elif not planar:
        picture.camera.fit(cameras.corners(*picture.window), layout.wide/layout.high)
    return compose(picture, frames, layout, images)


def compose(picture, frames, layout, images):
    """images: of 3D panels, or None"""
    case, planar = picture.case, picture.case.flat is not None
    fig = Figure(figsize=(layout.size[0]/dpi, layout.size[1]/dpi), dpi=dpi, facecolor='white')
    fig.set_layout_engine('none') if hasattr(fig, 'set_layout_engine') else None
    digits = timeDigits([f.time for f in picture.frames])
    for k, frame in enumerate(frames):
        axis = fig.add_axes(layout.places[k])
        if planar:
            flat.draw(axis, case, frame, picture.camera, picture.planar(), picture.colours)
            measures(axis, picture, *layout.outer(k, len(frames)))
        elif images is not None:
            axis.imshow(images[k], aspect='auto', interpolation='antialiased')
            axis.set_axis_off()
        else:
            points.draw(axis, case, frame, picture.camera, picture.window, picture.colours)
        axis.set_title(f't = {frame.time:.{digits}f} s', loc='left', fontsize=12, color=style.ink,
                       pad=5)
    if picture.colours is not None:
        axis = fig.add_axes(layout.barPlace)
        bar = fig.colorbar(picture.colours, cax=axis, extend=picture.extend)
        bar.set_label(scene.label(picture.field[1]), fontsize=11, color=style.ink)
        bar.outline.set_visible(False)
        bar.ax.tick_params(labelsize=10, length=3, color=style.ink, labelcolor=style.ink)
        bar.ax.set_gid('colourBar')
    return fig


def timeDigits(times):
    """Decimals that tell these times apart: two where they do"""
    for digits in range(1, 9):
        shown = [round(t, digits) for t in times]
        if all(abs(a - b) < 0.02*max(abs(a), 10.0**-digits)
               for a, b in zip(times, shown)) and len(set(shown)) == len(set(times)):
            return digits
    return 9


def measures(axis, picture, first, last):
    """Scales in metres on the outer panels"""
    axis.tick_params(labelsize=9, length=3, color=style.wall, labelcolor=style.ink, labelleft=first,
                     labelbottom=last)
    axis.locator_params(nbins=6 if np.ptp(axis.get_xlim()) > np.ptp(axis.get_ylim()) else 5,
                        axis='x')
    axis.locator_params(nbins=4, axis='y')
    for spine in axis.spines.values():
        spine.set_visible(False)
    names = []
    for direction, fallback in ((picture.camera.right, 'along'), (picture.camera.up, 'up')):
        k = cameras.straight(direction)
        names.append(('xyz'[k] if k is not None else fallback, k is not None and direction[k] < 0))
    for which, (name, reverse), shown in (('x', names[0], last), ('y', names[1], first)):
        if shown:
            (axis.set_xlabel if which == 'x'
             else axis.set_ylabel)(f'{name} [m]', fontsize=10, color=style.ink)
        if reverse:
            (axis.xaxis if which == 'x'
             else axis.yaxis).set_major_formatter(lambda v, _: f'{-v:g}' if v else '0')


def write(fig, path):
    folder = os.path.dirname(path)
    if folder and not os.path.isdir(folder):
        raise PictureError(f'-o {path}: no folder {folder}')
    # the style of charts crops what it saves: that would change the size
    with rc_context({'savefig.bbox': None}):
        fig.savefig(path, dpi=dpi, facecolor='white')


def pixels(fig):
    """As an array"""
    canvas = FigureCanvasAgg(fig)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[:, :, :3].copy()


def film(picture, size, path, rate):
    """One sheet a frame, into a .gif or .mp4. Returns the number of frames"""
    case, frames = picture.case, picture.frames
    planar = case.flat is not None
    even = (size[0] - size[0] % 2, size[1] and size[1] - size[1] % 2)
    layout = Layout(1, picture.shape(), even, picture.colours is not None, planar)
    layout.size = layout.size[0], layout.size[1] - layout.size[1] % 2
    images = [None]*len(frames)
    if picture.paraview:
        pixel = int(round(layout.wide)), int(round(layout.high))
        picture.camera.fit(cameras.corners(*picture.window), pixel[0]/pixel[1])
        images = picture.byParaView(frames, pixel) or images
    elif not planar:
        picture.camera.fit(cameras.corners(*picture.window), layout.wide/layout.high)
    sheets = (pixels(compose(picture, [f], layout, None if images[k] is None else [images[k]]))
              for k, f in enumerate(frames))
    (_gif if path.lower().endswith('.gif') else _mp4)(sheets, path, rate)
    return len(frames)


def _gif(sheets, path, rate):
    try:
        from PIL import Image
    except ImportError:
        raise PictureError('-film: a .gif needs Python\'s PIL (Debian: python3-pil)') from None
    images = [Image.fromarray(s) for s in sheets]
    # one palette for all, of the last picture, where the colours are most spread
    palette = images[-1].quantize(128, method=Image.Quantize.MEDIANCUT)
    images = [i.quantize(palette=palette, dither=Image.Dither.NONE) for i in images]
    images[0].save(path, save_all=True, append_images=images[1:], duration=int(round(1000/rate)),
                   loop=0, optimize=True, disposal=1)


def _mp4(sheets, path, rate):
    with tempfile.TemporaryDirectory(prefix='riprapFilm') as folder:
        from PIL import Image
        for k, s in enumerate(sheets):
            Image.fromarray(s).save(os.path.join(folder, f'{k:05d}.png'), compress_level=1)
        said = subprocess.run(['ffmpeg', '-y', '-loglevel', 'error', '-framerate', str(rate), '-i',
                               os.path.join(folder, '%05d.png'), '-c:v', 'libx264', '-pix_fmt',
                               'yuv420p', '-crf', '20', '-movflags', '+faststart', path],
                              capture_output=True, text=True)
        if said.returncode:
            raise PictureError(
                f'ffmpeg failed: {(said.stderr.strip().splitlines() or ["no word why"])[-1]}')


def suffixOfFilms():
    return '.mp4' if shutil.which('ffmpeg') else '.gif'
