# SPDX-License-Identifier: GPL-3.0-or-later
"""3D scenes by ParaView's VTK, in a process of its own: pictures without text, as arrays"""
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.image import imread

from . import PictureError, camera as cameras, style, surface

script = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'vtkPanels.py')


def program():
    """The command that runs a script with VTK, or None: this python where it has VTK (Debian's
    ParaView, a wheel), else ParaView's"""
    command = None
    if importlib.util.find_spec('vtkmodules'):
        command = [sys.executable]
    else:
        for name in ('pvbatch', 'pvpython'):
            if shutil.which(name):
                command = [name, '--force-offscreen-rendering']
                break
    if command and not os.environ.get('DISPLAY') and shutil.which('xvfb-run'):
        return ['xvfb-run', '-a', '-s', '-noreset -screen 0 1280x1024x24'] + command
    return command


def draw(case, frames, camera, size, colours, window):
    """Pictures (height, width, 3) of the frames. colours: a ScalarMappable or None; window: (low,
    high) of what is shown"""
    with tempfile.TemporaryDirectory(prefix='riprapRender') as folder:
        seen = [contents(case, frame, camera, colours, window) for frame in frames]
        for k, content in enumerate(seen):
            np.savez(os.path.join(folder, f'frame{k}.npz'), **content)
        # edges get smooth by drawing twice as large
        finer = 2 if size[0]*size[1] <= 3e6 else 1
        job = jobOf(case, frames, camera, [finer*int(s) for s in size], colours, window)
        with open(os.path.join(folder, 'job.json'), 'w') as f:
            json.dump(job, f)
        said = subprocess.run(program() + [script, folder], capture_output=True, text=True)
        pictures = [os.path.join(folder, f'frame{k}.png') for k in range(len(frames))]
        if said.returncode or not all(os.path.exists(p) for p in pictures):
            words = (said.stderr.strip() or said.stdout.strip() or 'no word why').splitlines()
            raise PictureError(f'ParaView failed ({said.returncode}): {words[-1]}')
        return [coarser(imread(p)[:, :, :3], finer) for p in pictures]


def coarser(image, times):
    h, w = image.shape[0]//times, image.shape[1]//times
    return image[:h*times, :w*times].reshape(h, times, w, times, 3).mean(axis=(1, 3))


# of the scene's size: walls are drawn so much inside of where they are, lest water's sides in the
# same plane show through
slack = 1e-3


def jobOf(case, frames, camera, size, colours, window):
    inside = any(f.balls or f.blends or any(i.kind in ('body', 'obstacle') for i in f.items)
                 for f in frames)
    water = any(f.grid is not None for f in frames)
    # nothing is cut from a tank that is shown whole
    planes = planesOf(window, 2*slack*np.linalg.norm(np.subtract(window[1], window[0])))
    job = {
        'frames': len(frames), 'size': size, 'level': surface.level, 'ink': to_rgb(style.ink),
        'plainWater': to_rgb(style.plainWater), 'line': max(1.0, size[0]/1100),
        'length': float(np.linalg.norm(np.subtract(window[1], window[0]))),
        'planes': [[end.tolist() for end in plane] for plane in planes],
        'opacity': 0.48 if inside and water else 1.0, 'translucent': inside and water,
        'shade': True, 'camera': {'focus': camera.focus.tolist(),
                                  'eye': camera.eye.tolist(), 'up': camera.up.tolist(),
                                  'angle': float(np.degrees(2*np.arctan(camera.half[1])))}}
    if colours is not None:
        job['map'] = colours.cmap(np.linspace(0, 1, 256)).tolist()
        job['range'] = [colours.norm.vmin, colours.norm.vmax]
    return job


def planesOf(box, spare):
    """(point, normal to within) of the six sides of a box that is larger by a length"""
    found = []
    for d in range(3):
        for end, sign in ((0, 1), (1, -1)):
            point = np.array(box[end], dtype=float)
            point[d] -= sign*spare
            found.append((point, sign*np.eye(3)[d]))
    return found


def bytesOf(colour, n):
    return np.tile((255*np.array(to_rgb(colour))).astype(np.uint8), (n, 1))


def contents(case, frame, camera, colours, window):
    """Arrays of a frame"""
    data, meshes = {}, []
    for item in frame.items:
        if item.points is not None and len(item.triangles):
            kind = 'hollow' if item.hollow else item.kind
            colour = {'body': style.body(item.group), 'obstacle': style.obstacle,
                      'hollow': style.floor, 'wall': style.floor, 'open': style.floor}[kind]
            colour = (to_rgb(colour) if item.value is None
                      else tuple(colours.to_rgba(item.value))[:3])
            meshes.append((kind, item.points, item.triangles, colour))
    middle = 0.5*np.add(*window)
    for k, (kind, points, triangles, colour) in enumerate(meshes):
        if kind in ('wall', 'open'):
            points = middle + (1 - slack)*(points - middle)
        data.update({f'meshKind{k}': kind, f'meshPoints{k}': points, f'meshTriangles{k}': triangles,
                     f'meshColour{k}': colour})
    data['meshes'] = len(meshes)
    # obstacles end at the mesh; faces in its sides are not cut
    data['bounds'] = np.array(planesOf(cameras.common(window, frame.bounds),
                                       0.1*slack*np.linalg.norm(np.subtract(*window))))
    if frame.grid is not None:
        grid = surface.closed(frame.grid)
        data['water'], data['waterPlace'] = (grid.f.astype(np.float32),
                                             np.concatenate([grid.low, grid.cell]))
        if grid.value is not None and colours is not None:
            data['waterValue'] = grid.value.astype(np.float32)
    if frame.drops is not None and len(frame.drops[0]):
        positions, values, spacing = frame.drops
        inside = np.all((positions >= window[0]) & (positions <= window[1]), axis=1)
        n = int(inside.sum())
        if n:
            data['dropPositions'], data['dropRadii'] = (positions[inside],
                                                        np.full(n, spacing*(3/(4*np.pi))**(1/3)))
            data['dropColours'] = (bytesOf(style.plainWater, n) if values is None or colours is None
                                   else colours.to_rgba(values[inside], bytes=True)[:, :3])
    if frame.balls:
        data['ballPositions'] = np.concatenate([b[0] for b in frame.balls])
        data['ballRadii'] = np.concatenate([np.broadcast_to(b[1], len(b[0])) for b in frame.balls])
        data['ballColours'] = np.concatenate([bytesOf(style.body(b[2]), len(b[0])) if b[3] is None
                                              else colours.to_rgba(b[3], bytes=True)[:, :3]
                                              for b in frame.balls])
    for k, (grid, group, value) in enumerate(frame.blends):
        grid = surface.closed(grid)
        data[f'blend{k}'], data[f'blendPlace{k}'] = (grid.f.astype(np.float32),
                                                     np.concatenate([grid.low, grid.cell]))
        data[f'blendColour{k}'] = to_rgb(style.body(group) if value is None
                                         else colours.to_rgba(value))
    data['blends'] = len(frame.blends)
    if frame.bonds is not None and len(frame.bonds[0]):
        segments, values = frame.bonds
        data['bonds'] = segments.reshape(-1, 3)
        data['bondColours'] = colours.to_rgba(values, bytes=True)[:, :3]
        data['bondRadius'] = 0.12*np.median(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1))
    return data
