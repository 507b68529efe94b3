# SPDX-License-Identifier: GPL-3.0-or-later
"""What bin/riprapRender draws of made cases: a line PASS, FAIL or SKIP a check

usage: checkPictures.py FOLDER      an empty folder to work in
"""
import os
import subprocess
import sys

import numpy as np
from matplotlib.image import imread

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.dirname(os.path.dirname(here))
sys.path[:0] = [os.path.join(root, 'etc', 'python'), here]

import madeCase                                                     # noqa: E402
from riprap import plotting                                         # noqa: E402
from riprap.pictures import panels                                  # noqa: E402

failed = []


def render(*words, environment=None):
    return subprocess.run([os.path.join(root, 'bin', 'riprapRender'), *words], capture_output=True,
                          text=True, env={**os.environ, **(environment or {})})


def tell(name, good, why=''):
    print(f'PASS pictures {name}' if good else f'FAIL pictures {name}: {why}')
    if not good:
        failed.append(name)


def picture(path):
    image = imread(path)[:, :, :3]
    return image if image.max() <= 1 else image/255.0


def scene(image):
    """Without the colour bar and the title's line"""
    return image[30:, :int(0.9*image.shape[1])]


def blue(image):
    """Which pixels are water"""
    r, g, b = (image[:, :, k] for k in range(3))
    return (b - r > 0.12) & (b >= g - 0.02)


def share(image):
    return (image.min(axis=2) < 0.97).mean()


def hasBar(image):
    """The map's colours, low to high, in order along a column on the right"""
    wanted = plotting.water(np.linspace(0.05, 0.95, 10))[:, :3]
    for x in range(int(0.8*image.shape[1]), image.shape[1]):
        column = image[::-1, x]
        at = [np.abs(column - w).max(axis=1).argmin() for w in wanted]
        near = max(np.abs(column[i] - w).max() for i, w in zip(at, wanted))
        if near < 0.04 and (np.diff(at) > 0).all() and at[-1] - at[0] > 0.3*len(column):
            return True
    return False


def floor(image, top, bottom):
    """Is there a wall across the scene between two of its rows?"""
    rows = scene(image)[top:bottom]
    dark = (np.ptp(rows, axis=2) < 0.12) & (rows.mean(axis=2) < 0.55)
    return bool((dark.mean(axis=1) > 0.6).any())


def check2D(folder):
    for up, flat, shift in ((1, 2, (0, 0, 0)), (2, 1, (5, 0, -3)), (0, 2, (0, 7, 0))):
        name = f"2D, up {'xyz'[up]}"
        case = madeCase.damBreak(os.path.join(folder, f'flat{up}'), up, flat, shift)
        said = render('-case', case, '-times', '0.1', '-o', os.path.join(folder, 'a.png'))
        if said.returncode:
            tell(name, False, said.stderr.strip())
            continue
        image = picture(os.path.join(folder, 'a.png'))
        y, x = np.nonzero(blue(scene(image)))
        tell(name + ', something is there', 0.03 < share(scene(image)) < 0.7,
             f'{share(scene(image)):.3f} of the picture')
        tell(name + ', water lies on the floor', floor(image, y.max() + 1, y.max() + 9)
             and not floor(image, max(y.min() - 60, 0), y.min()), 'no wall under it, or one above')
        tell(name + ', colour bar', hasBar(image), 'not found')
    case = os.path.join(folder, 'flat1')
    said = render('-case', case, '-strip', '4', '-o', os.path.join(folder, 'b.png'), '-size',
                  '1000x600')
    image = picture(os.path.join(folder, 'b.png')) if said.returncode == 0 else np.ones((1, 1, 3))
    tell('strip, size', image.shape[:2] == (600, 1000), f'{image.shape} {said.stderr.strip()}')
    mask = blue(scene(image))
    rows, columns = (np.diff(np.r_[0, mask.any(axis=d).astype(int), 0]) == 1 for d in (1, 0))
    tell('strip, four panels', rows.sum()*columns.sum() == 4,
         f'{rows.sum()} rows of {columns.sum()}')


def check3D(folder, how, words):
    for up in (2, 1):
        case = madeCase.damBreak(os.path.join(folder, f'deep{up}'), up, None, (1, 2, 3), 0.03)
        madeCase.put(os.path.join(case, 'constant'), 'geometry',
                     madeCase.header('dictionary', 'geometry') +
                     'ball { type searchableSphere; centre (%g %g %g); radius 0.08; }\n' % tuple(
                         np.array((1, 2, 3)) + {2: (0.85, 0.15, 0.2), 1: (0.85, 0.2, 0.15)}[up]))
        path = os.path.join(folder, f'{how}.png')
        said = render('-case', case, '-times', '0.1', '-o', path, '-size', '700', *words)
        name = f"3D by {how}, up {'xyz'[up]}"
        if said.returncode or (how == 'ParaView' and 'failed' in said.stdout):
            tell(name, False, (said.stderr or said.stdout).strip())
            continue
        image = picture(path)
        water = blue(scene(image))
        y, x = np.nonzero(water)
        tell(name + ', water is there', 0.05 < water.mean() < 0.6,
             f'{water.mean():.3f} of the picture')
        tell(name + ', on the left, where it stands', x.mean() < 0.45*water.shape[1],
             f'middle at {x.mean()/water.shape[1]:.2f}')
        grey = (np.ptp(scene(image), axis=2) < 0.08) & (scene(image).mean(axis=2) < 0.72)
        tell(name + ', obstacle', grey[:, int(0.5*water.shape[1]):].mean() > 0.004,
             f'{grey.mean():.4f} of the picture')
        tell(name + ', colour bar', hasBar(image), 'not found')
        said = render('-case', case, '-times', '0.1', '-o', path, '-size', '700', '-hide',
                      'ba.*,xHigh', *words)
        bare = scene(picture(path))
        left = ((np.ptp(bare, axis=2) < 0.08)
                & (bare.mean(axis=2) < 0.72))[:, int(0.5*water.shape[1]):].mean()
        grey = grey[:, int(0.5*water.shape[1]):].mean()
        tell(name + ', without what is hidden', said.returncode == 0 and left < 0.5*grey,
             f'{left:.4f} of the picture, with it {grey:.4f} {said.stderr.strip()}')
        # beside a time when it stands high, low water is in the lower part of its panel
        said = render('-case', case, '-times', '0,0.4', '-o', path, '-size', '1200x500', *words)
        image = picture(path)
        panel = image[30:, int(0.47*image.shape[1]):int(0.9*image.shape[1])]
        drawn, water = (np.nonzero(a.any(axis=1))[0]
                        for a in (panel.min(axis=2) < 0.97, blue(panel)))
        tell(name + ', water lies below',
             len(water) and water.mean() > 0.5*(drawn.min() + drawn.max()),
             f'{water.min()} to {water.max()} of {drawn.min()} to {drawn.max()}')


def checkFilm(folder):
    from PIL import Image
    case, path = os.path.join(folder, 'flat1'), os.path.join(folder, 'c.gif')
    said = render('-case', case, '-film', '-o', path, '-size', '400')
    if said.returncode:
        return tell('film', False, said.stderr.strip())
    with Image.open(path) as film:
        frames = []
        for k in range(film.n_frames):
            film.seek(k)
            frames.append(np.asarray(film.convert('RGB')).astype(int))
    tell('film, frames', len(frames) == 5, f'{len(frames)} of 5')
    tell('film, that differ', all(np.abs(a - b).max() > 60 for a, b in zip(frames, frames[1:])),
         'two are alike')


def checkErrors(folder):
    case = os.path.join(folder, 'flat1')
    for words, wanted in ((('-field', 'T'), 'one of none, U, p'), (
            ('-times', 'x'), 'all, first or last'), (('-times', '8:9'), 'times: 0 to 0.4'),
                          (('-view', 'top'), 'front or back'), (('-o', 'a.doc'), '.png'),
                          (('-size', '3'), 'WxH'), (('-fps', 'x'), 'from 0.1'),
                          (('-strip', '99'), 'from 1 to 24'), (('-range', '2,1'), 'LOW'),
                          (('-hide', 'xHigh,ball'),
                           '-hide ball: no patch, surface or group of bodies has that name; '
                           'there are patches xLow, xHigh, yLow, yHigh; surfaces none'),
                          (('-hide', 'a['), 'no pattern'), (('-hide', 'xLow,'), 'empty'),
                          (('-nonsense',), '-case'), (('-case', '/nowhere'), 'no such folder'),
                          (('-case', here), 'no case'), (('-film', '-o', 'a.png'), '.gif'),
                          (('-field',), 'needs a value'), (('-film', '-strip'), 'exclude')):
        said = render(*(() if '-case' in words else ('-case', case)), *words)
        lines = said.stderr.strip().splitlines()
        tell('wrong ' + ' '.join(words).replace(root, ''), said.returncode == 1 and len(lines) == 1
             and wanted in lines[0] and lines[0].startswith('riprapRender: '),
             f'status {said.returncode}: {said.stderr.strip() or said.stdout.strip()}')
    said = render('-help')
    tell('-help', said.returncode == 0 and '-strip' in said.stdout, said.stderr)


def main(folder):
    check2D(folder)
    checkErrors(folder)
    try:
        import PIL                                                  # noqa: F401
        checkFilm(folder)
    except ImportError:
        print('SKIP pictures film: this python has no PIL')
    check3D(folder, 'matplotlib', ('-noParaView',))
    if panels.program() is None:
        print('SKIP pictures 3D by ParaView: no ParaView here (etc/bootstrap --paraview)')
    else:
        check3D(folder, 'ParaView', ())
    return bool(failed)


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
