# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of riprapRender"""
import math
import os
import re
import shutil
import sys
import traceback

from . import PictureError

usage = """Usage: riprapRender [options]

Draws a case's water, bodies and walls, with up against g.

  -case DIR       the case; default: here
  -times LIST     written times nearest to these: 0.2,0.4,0.8, a range 0.1:0.5, `all`, `first` or
                  `last`; default: the last one; -strip: some that are evenly spread; -film:
                  all
  -field NAME     colours by a field of the water (U, p, ...), of the bodies (solids/U, ...) or of
                  bonds (bonds/tension), or `none`; default: U, of the bodies where there is
                  no water
  -range LOW,HIGH ends of the colour bar; default: of the field at the times drawn
  -strip [N]      N times side by side in one picture; default: 4, or all of -times. Several -times
                  make a strip, too
  -film           a film of the times: .mp4 with ffmpeg, or .gif
  -fps N          pictures a second of a film; default: 12
  -size W[xH]     pixels; default: 1400 wide, as high as the scene needs
  -hide NAMES     what is not drawn: patches, surfaces of constant/geometry, groups of bodies; names
                  or patterns, atmosphere,"gate.*"
  -view VIEW      3D: oblique, front, back, left, right, top, or AZIMUTH,ELEVATION in degrees; 2D:
                  front, back
  -o FILE         .png, .pdf, .svg, .jpg; films .mp4, .gif; default: <case>.png, <case>-strip.png,
                  <case>.mp4 in the case
  -noParaView     3D by matplotlib, as where there is no ParaView
  -help

3D scenes need ParaView (etc/bootstrap --paraview); without it matplotlib draws discs. 2D scenes are
drawn by matplotlib.
"""

most = 24               # panels
pictures, films = ('.png', '.pdf', '.svg', '.jpg'), ('.mp4', '.gif')


class Options:
    def __init__(self, words):
        self.case, self.times, self.field, self.range, self.view, self.out, self.hide = (
            '.', None, None, None, None, None, [])
        self.strip, self.count, self.film, self.rate, self.size, self.paraview = (
            False, None, False, 12.0, (1400, None), True)
        words = list(words)
        while words:
            word = words.pop(0)
            if word in ('-help', '--help', '-h'):
                print(usage, end='')
                raise SystemExit(0)
            elif word == '-film':
                self.film = True
            elif word == '-noParaView':
                self.paraview = False
            elif word == '-strip':
                self.strip = True
                if words and re.fullmatch(r'\d+', words[0]):
                    self.count = int(words.pop(0))
                    if not 1 <= self.count <= most:
                        raise PictureError(f'-strip {self.count}: from 1 to {most}')
            elif word in ('-case', '-times', '-field', '-range', '-fps', '-size', '-hide', '-view',
                          '-o'):
                # a range may begin with a minus
                if not words or (words[0].startswith('-') and not re.match(r'-[\d.]', words[0])):
                    raise PictureError(f'{word} needs a value (-help tells)')
                getattr(self, '_' + word[1:])(words.pop(0))
            else:
                raise PictureError(f"unknown option {word}: -case, -times, -field, -range, -strip, "
                                   "-film, -fps, -size, -hide, -view, -o, -noParaView, -help")
        if self.film and self.strip:
            raise PictureError('-film and -strip exclude each other')
        self._checkFile()

    def _case(self, value):
        self.case = value
        if not os.path.isdir(value):
            raise PictureError(f'-case {value}: no such folder')

    def _times(self, value):
        self.times = []
        for part in re.split(r'[,\s]+', value.strip()):
            if part in ('all', 'first', 'last'):
                self.times.append(part)
                continue
            try:
                ends = [float(p) for p in part.split(':')]
                if len(ends) > 2 or not all(math.isfinite(e) for e in ends):
                    raise ValueError
            except ValueError:
                raise PictureError(f"-times {part}: a time, a range FROM:TO, all, "
                                   "first or last") from None
            self.times.append(tuple(ends))

    def _field(self, value):
        self.field = value

    def _range(self, value):
        try:
            low, high = (float(v) for v in value.split(','))
        except ValueError:
            raise PictureError(f'-range {value}: two numbers LOW,HIGH') from None
        if not (low < high and math.isfinite(low) and math.isfinite(high)):
            raise PictureError(f'-range {value}: LOW is below HIGH')
        self.range = low, high

    def _fps(self, value):
        try:
            self.rate = float(value)
        except ValueError:
            self.rate = 0.0
        if not 0.1 <= self.rate <= 120:
            raise PictureError(f'-fps {value}: a number from 0.1 to 120')

    def _size(self, value):
        match = re.fullmatch(r'(\d+)(?:x(\d+))?', value)
        if not match or not 200 <= int(match.group(1)) <= 8000 or (match.group(2) and not 150
                                                                   <= int(match.group(2)) <= 8000):
            raise PictureError(f'-size {value}: W or WxH in pixels, as 1400 or 1400x800, '
                               'from 200x150 to 8000x8000')
        self.size = int(match.group(1)), int(match.group(2)) if match.group(2) else None

    def _hide(self, value):
        self.hide += [p.strip('"') for p in re.split(r'[,\s]+', value.strip())]
        for pattern in self.hide:
            try:
                re.compile(pattern)
            except re.error as wrong:
                raise PictureError(f'-hide {pattern}: no pattern: {wrong}') from None
            if not pattern:
                raise PictureError(f'-hide {value}: a name is empty')

    def _view(self, value):
        self.view = value

    def _o(self, value):
        self.out = value

    def _checkFile(self):
        if self.out is None:
            return
        known = films if self.film else pictures
        if os.path.splitext(self.out)[1].lower() not in known:
            raise PictureError(f"-o {self.out}: its name ends in one of {' '.join(known)}"
                               + ('' if self.film else '; films need -film'))
        folder = os.path.dirname(self.out)
        if folder and not os.path.isdir(folder):
            raise PictureError(f'-o {self.out}: no folder {folder}')

    def chosenTimes(self, case):
        """Names of the times to draw"""
        there = case.times
        if self.times is None:
            if self.film:
                return there
            if self.strip:
                return spread(there, self.count or 4)
            return there[-1:]
        names = []
        for part in self.times:
            if part == 'all':
                names += there
            elif part in ('first', 'last'):
                names.append(there[0 if part == 'first' else -1])
            elif len(part) == 2:
                found = [t for t in there if part[0] - 1e-9 <= float(t) <= part[1] + 1e-9]
                if not found:
                    raise PictureError(
                        f'-times {part[0]:g}:{part[1]:g}: nothing was written there; times: '
                        f'{there[0]} to {there[-1]}, {len(there)} of them')
                names += found
            else:
                names.append(case.nearest(part[0]))
        names = sorted(set(names), key=float)
        return spread(names, self.count) if self.count else names

    def chosenField(self, case):
        """(fluid, solids or bonds; name), or None"""
        if self.field == 'none':
            return None
        choices = case.choices()
        if self.field is None:
            name = 'U' if case.water else 'solids/U'
            return _split(name) if name in choices else None
        wanted = self.field if case.water or '/' in self.field else 'solids/' + self.field
        if wanted not in choices:
            raise PictureError(f"-field {self.field}: one of {', '.join(choices)}")
        return _split(wanted)


def _split(name):
    of, _, what = name.rpartition('/')
    return of or 'fluid', what


def spread(names, count):
    """So many of them, evenly in time, the last among them and the first only if there are no
    others"""
    times = [float(n) for n in names]
    if count >= len(names):
        return names
    if count == 1:
        return names[-1:]
    found = []
    for k in range(count):
        wanted = times[0] + (k + 1)*(times[-1] - times[0])/count
        found.append(min(names, key=lambda n: abs(float(n) - wanted)))
    return sorted(set(found), key=float)


def main(words):
    try:
        options = Options(words)
        for module in ('numpy', 'matplotlib'):
            try:
                __import__(module)
            except ImportError:
                raise PictureError(f'this python has no {module} (Debian: python3-{module}); '
                                   'RIPRAP_PYTHON names another') from None
        render(options)
    except PictureError as wrong:
        print(f'riprapRender: {wrong}', file=sys.stderr)
        return 1
    except (OSError, ValueError, KeyError, IndexError, AttributeError) as wrong:
        if os.environ.get('RIPRAP_DEBUG'):
            raise
        where = traceback.extract_tb(wrong.__traceback__)[-1]
        print(f'riprapRender: the case cannot be read: {type(wrong).__name__}: {wrong} '
              f'({os.path.basename(where.filename)}, line {where.lineno}; '
              'RIPRAP_DEBUG=1 tells more)', file=sys.stderr)
        return 1
    return 0


def render(options):
    from . import panels, scene, sheet
    case = scene.Case(options.case)
    case.hide(options.hide)
    names, field = options.chosenTimes(case), options.chosenField(case)
    several = options.strip or (len(names) > 1 and not options.film)
    if several and len(names) > most:
        raise PictureError(f'{len(names)} times are too many for one picture: -strip N takes some, '
                           '-film draws all')
    out = options.out
    if out is None:
        suffix = sheet.suffixOfFilms() if options.film else '-strip.png' if several else '.png'
        out = os.path.join(case.folder, case.name + suffix)
    if options.film and out.lower().endswith('.mp4') and not shutil.which('ffmpeg'):
        raise PictureError('-film: .mp4 needs ffmpeg (Debian: ffmpeg); -o NAME.gif does without')
    picture = sheet.Picture(case, names, field, options.view, options.range, options.paraview)
    if case.flat is None and not picture.paraview and options.paraview and panels.program() is None:
        print('riprapRender: no ParaView: 3D by matplotlib (etc/bootstrap --paraview installs it)')
    if options.film:
        count = sheet.film(picture, options.size, out, options.rate)
        print(f'Wrote {out}: {count} pictures')
    else:
        sheet.write(sheet.draw(picture, picture.frames, options.size), out)
        print(f'Wrote {out}')
    for note in case.notes:
        print(f'riprapRender: {note}')
