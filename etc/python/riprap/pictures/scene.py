# SPDX-License-Identifier: GPL-3.0-or-later
"""A case and what there is to see of it at a time"""
import glob
import os
import re

import numpy as np

from .. import clouds
from ..dictionaries import numberOf
from . import PictureError, foamFiles, motions, shapes, surface
from .foamFiles import vectorOf

labels = {'U': 'speed [m/s]', 'p': 'pressure [Pa]', 'rho': 'density [kg/m³]',
          'h': 'smoothing length [m]', 'id': 'particle number', 'omega': 'spin [rad/s]',
          'force': 'force [N]', 'moment': 'moment [N m]', 'radius': 'radius [m]',
          'mass': 'mass [kg]', 'contacts': 'contacts', 'brokenBonds': 'broken bonds',
          'turned': 'turned by [rad]', 'group': 'group', 'material': 'material',
          'tension': 'tension in bonds [N]', 'stretch': 'stretch of bonds [m]',
          'alpha.water': 'fraction of water'}


# from so many on a rigid body of particles of one size is drawn as a smooth one
manyParticles = 30


class Item:
    """Something of one kind to be drawn: points and triangles in 3D, lines (arrays of points in the
    plane) in 2D"""

    def __init__(self, kind, points=None, triangles=None, lines=None, group=0, value=None,
                 hollow=False):
        self.kind, self.points, self.triangles, self.lines = kind, points, triangles, lines
        self.group, self.value, self.hollow = group, value, hollow


class Frame:
    """What is seen at a time"""

    def __init__(self, time, name):
        self.time, self.name = time, name
        self.grid = None            # of the water
        self.water = None           # (positions, values, spacing) of its particles
        self.drops = None           # the same of water too thin for the surface
        self.balls = []             # (positions, radii, group, values)
        self.blends = []            # (grid, group, value): bodies of many particles
        self.blended = []           # their particles, as balls
        self.items = []             # bodies' shapes, obstacles, moving walls
        self.unseen = []            # walls that -hide names: the tank is as large without them
        # (low, high) of the mesh with its walls where they are now: obstacles are cut there
        self.bounds = None
        self.bonds = None           # (segments, values)
        self.shown = []             # values of what is coloured
        self.boxes = []             # (low, high) of what the picture has to hold

    def hold(self, points, spare=0.0):
        if len(points):
            self.boxes.append((points.min(axis=0) - spare, points.max(axis=0) + spare))


class Case:
    """What does not change: mesh, gravity, walls, shapes of bodies"""

    def __init__(self, folder):
        self.folder = os.path.abspath(folder)
        if not os.path.isdir(os.path.join(self.folder, 'constant')):
            raise PictureError(f'{folder}: no case (no folder constant)')
        self.mesh = foamFiles.Mesh(self.folder)
        self.flat = self.mesh.emptyAxis
        self.gravity = foamFiles.gravity(self.folder)
        self.times = [t for t in clouds.times(self.folder)
                      if clouds.hasCloud(self.folder, t, 'fluid')
                      or clouds.hasCloud(self.folder, t, 'solids')]
        if not self.times:
            raise PictureError(
                f'{folder}: no time with particles (lagrangian/fluid or lagrangian/solids)')
        self.water = any(clouds.hasCloud(self.folder, t, 'fluid') for t in self.times)
        self.solids = any(clouds.hasCloud(self.folder, t, 'solids') for t in self.times)
        self.properties = {name: self._read('constant', name + 'Properties')
                           for name in ('sph', 'pic', 'solid')}
        self.obstacles = self._obstacles()
        self.groups = self._motions()
        self.notes = []
        self.hidden = set()         # (kind, name) as in names()
        self._lattice = None
        self._shapes = None
        self._first = {}

    @property
    def name(self):
        foam = sorted(glob.glob(os.path.join(self.folder, '*.foam')))
        return (os.path.splitext(os.path.basename(foam[0]))[0] if foam
                else os.path.basename(self.folder))

    @property
    def plane(self):
        """The axes of a 2D case, in the order of the empty one's right-handed frame"""
        return None if self.flat is None else ((self.flat + 1) % 3, (self.flat + 2) % 3)

    @property
    def middle(self):
        return 0.5*(self.mesh.low + self.mesh.high)

    def note(self, text):
        if text not in self.notes:
            self.notes.append(text)

    def _read(self, *names):
        path = os.path.join(self.folder, *names)
        return foamFiles.dictionary(path) if os.path.exists(path) else {}

    def spacing(self, time):
        """Of the water's particles"""
        properties = self._read(time, 'uniform', 'lagrangian', 'fluid', 'cloudProperties')
        found = numberOf(properties.get('spacing'))
        if found is None:
            found = numberOf(self._read('system', 'setParticlesDict').get('spacing'))
        if found is None:
            raise PictureError(
                f'{self.folder}: neither {time}/uniform/lagrangian/fluid/cloudProperties nor '
                'system/setParticlesDict says the spacing')
        return found

    # Fields ---------------------------------------------------------------------------------------

    def fields(self, cloud):
        """Names of the fields that can be drawn, of the last time"""
        for time in reversed(self.times):
            if clouds.hasCloud(self.folder, time, cloud):
                names = os.listdir(os.path.join(self.folder, time, 'lagrangian', cloud))
                return sorted({n[:-3] if n.endswith('.gz') else n for n in names} - {
                    'positions', 'coordinates', 'origId', 'clump', 'inertia', 'origProcId'})
        return []

    def choices(self):
        """What -field may be"""
        found = ['none']
        if self.water:
            found += self.fields('fluid')
        if self.solids:
            found += ['solids/' + f for f in self.fields('solids')]
        if glob.glob(os.path.join(self.folder, 'VTK', 'bonds', 'bonds_*.vtp')):
            found += ['bonds/' + f for f in ('tension', 'stretch')]
        return found

    # What is left out -----------------------------------------------------------------------------

    def names(self):
        """What -hide may name, by kind"""
        found = {'patches': [p.name for p in self.mesh.patches if p.kind != 'empty'
                             and len(p.faces)], 'surfaces': list(self.obstacles), 'groups': []}
        for time in self.times:
            found['groups'] += [n for n in self.groupNames(time) if n not in found['groups']]
        return found

    def groupNames(self, time):
        """Of the bodies, in the order of their numbers; those of another time where this one does
        not say"""
        for t in [time] + self.times:
            properties = self._read(t, 'uniform', 'lagrangian', 'solids', 'cloudProperties')
            if 'groups' in properties:
                text = properties['groups']
                return text[text.find('('):].strip('() ').split()
        return []

    def hide(self, patterns):
        """Leaves out what is named so"""
        names = self.names() if patterns else {}
        for pattern in patterns:
            found = {(kind, n) for kind, of in names.items() for n in of
                     if n == pattern or re.fullmatch(pattern, n)}
            if not found:
                there = '; '.join(f"{kind} {', '.join(of) or 'none'}" for kind, of in names.items())
                raise PictureError(f'-hide {pattern}: no patch, '
                                   f'surface or group of bodies has that name; there are {there}')
            self.hidden |= found

    def seen(self, cloud, time):
        """The solids of a cloud whose group is drawn"""
        away = [k for k, n in enumerate(self.groupNames(time)) if ('groups', n) in self.hidden]
        keep = ~np.isin(cloud['group'], away)
        return {name: values[keep] for name, values in cloud.items()}

    # Walls ----------------------------------------------------------------------------------------

    def _obstacles(self):
        """name -> (points, triangles, hollow)"""
        found = {}
        for name, entries in self._read('constant', 'geometry').items():
            if isinstance(entries, dict) and name != 'FoamFile':
                try:
                    found[name] = self._obstacle(entries)
                except (KeyError, ValueError) as wrong:
                    raise PictureError(f'{self.folder}/constant/geometry: {name}: '
                                       f'{wrong}') from None
        return found

    def _obstacle(self, e):
        kind, hollow = e['type'], e.get('solidSide') == 'outside'
        if kind == 'searchableBox':
            made = shapes.box(vectorOf(e['min']), vectorOf(e['max']))
        elif kind == 'searchableRotatedBox':
            made = shapes.rotatedBox(*(vectorOf(e[k]) for k in ('origin', 'span', 'e1', 'e3')))
        elif kind == 'searchableSphere':
            made = shapes.sphere(vectorOf(e.get('centre') or e['origin']), numberOf(e['radius']))
        elif kind == 'searchableCylinder':
            made = shapes.cylinder(vectorOf(e['point1']), vectorOf(e['point2']),
                                   numberOf(e['radius']))
        elif kind == 'searchablePlate':
            made = shapes.plate(vectorOf(e['origin']), vectorOf(e['span']))
        elif kind == 'searchableDisk':
            made = shapes.disk(vectorOf(e['origin']), vectorOf(e['normal']), numberOf(e['radius']))
        elif kind in ('triSurfaceMesh', 'closedTriSurfaceMesh'):
            made = self.surfaceFile(e)
        else:
            raise ValueError(f'a {kind} cannot be drawn')
        return (*made, hollow)

    def surfaceFile(self, entries):
        name = entries['file'].strip('"').replace('$FOAM_CASE', self.folder)
        for folder in (os.path.join('constant', 'triSurface'), ''):
            path = os.path.join(self.folder, folder, name)
            if os.path.exists(path):
                break
        return foamFiles.readSurface(path, numberOf(entries.get('scale'), 1.0))

    def _motions(self):
        """(patterns of patches and obstacles, entries) of each group that moves"""
        found, seen = [], set()
        for name in ('sph', 'pic', 'solid'):
            walls = self.properties[name].get('walls')
            for group, entries in (walls.get('motion', {}) if isinstance(walls, dict)
                                   else {}).items():
                if isinstance(entries, dict) and group not in seen:
                    seen.add(group)
                    found.append((re.findall(r'[^\s()]+', entries.get('patches', '')), entries))
        return found

    def pose(self, name, time):
        """(R, s) of a patch or obstacle"""
        for patterns, entries in self.groups:
            if any(re.fullmatch(p.strip('"'), name) for p in patterns):
                try:
                    found = motions.transformation(entries, time, self.folder)
                except (KeyError, ValueError, OSError, AttributeError):
                    found = None
                if found is None:
                    self.note(f"{name} is drawn where it stood at first: the motion "
                              f"{entries.get('solidBodyMotionFunction')} cannot be followed")
                    return motions.still
                return found
        return motions.still

    def moves(self, name):
        return any(re.fullmatch(p.strip('"'), name) for patterns, _ in self.groups
                   for p in patterns)

    def walls(self, frame):
        """Items of patches (3D: kind 'wall', and 'open' for what is no wall) and of obstacles, into
        a frame"""
        time, reach = frame.time, []
        for patch in self.mesh.patches:
            if patch.kind == 'empty' or not len(patch.faces):
                continue
            R, s = self.pose(patch.name, time)
            kind = 'wall' if patch.kind == 'wall' else 'open'
            items = frame.unseen if ('patches', patch.name) in self.hidden else frame.items
            used, inverse = np.unique(np.concatenate(patch.faces), return_inverse=True)
            placed = self.mesh.points[used] @ R.T + s
            reach.append((placed.min(axis=0), placed.max(axis=0)))
            if self.flat is not None:
                lines = [self._edge(face) @ R.T + s for face in patch.faces]
                items.append(Item(kind, lines=[line[:, self.plane] for line in lines]))
            else:
                triangles, at = [], 0
                for face in patch.faces:
                    own = inverse[at:at + len(face)]
                    at += len(face)
                    triangles += [(own[0], own[i], own[i + 1]) for i in range(1, len(own) - 1)]
                items.append(Item(kind, placed, np.array(triangles)))
        low, high = ((np.array(e, dtype=float) for e in zip(*reach)) if reach
                     else (self.mesh.low[None], self.mesh.high[None]))
        frame.bounds = low.min(axis=0), high.max(axis=0)
        if self.flat is not None:
            for end, mesh in zip(frame.bounds, (self.mesh.low, self.mesh.high)):
                end[self.flat] = mesh[self.flat]
        for name, (points, triangles, hollow) in self.obstacles.items():
            if ('surfaces', name) in self.hidden:
                continue
            R, s = self.pose(name, time)
            frame.items.append(self.shape('obstacle', points @ R.T + s, triangles, hollow=hollow))

    def _edge(self, face):
        """Ends of what a face of a 2D mesh is in its plane"""
        points = self.mesh.points[face]
        near = points[np.abs(points[:, self.flat] - self.mesh.low[self.flat]) < 1e-3*(
            self.mesh.high - self.mesh.low)[self.flat]]
        return near if len(near) == 2 else points[:2]

    def shape(self, kind, points, triangles, **more):
        """Of a surface what is drawn: itself, or its section in 2D"""
        if self.flat is None:
            return Item(kind, points, triangles, **more)
        segments = shapes.section(points, triangles, self.flat,
                                  self.middle[self.flat])[:, :, self.plane]
        return Item(kind, lines=shapes.chains(segments, 1e-7*np.ptp(self.mesh.points)), **more)

    # Bodies ---------------------------------------------------------------------------------------

    def ownShapes(self):
        """('surface', body, points, triangles) where it stood at first, ('shape', number, middle,
        axes, points, triangles or None)"""
        if self._shapes is None:
            self._shapes = []
            for time in self.times:
                properties = self._read(time, 'uniform', 'lagrangian', 'solids', 'cloudProperties')
                if properties:
                    break
            else:
                properties = {}
            for entries in properties.get('surfaces', {}).values():
                made = self._bodySurface(entries)
                if made is not None:
                    self._shapes.append(('surface', int(numberOf(entries['body'])), *made))
            for number, entries in enumerate(v for v in properties.get('shapes', {}).values()
                                             if isinstance(v, dict)):
                if 'outline' in entries:
                    points, triangles = pointsOf(entries['outline']), None
                    if self.flat is None:
                        continue
                    points[:, self.flat] = 0
                    middle, axes = shapes.outlineMiddle(points, self.plane), np.eye(3)
                else:
                    points, triangles = (self._bodySurface(entries) if 'source' in entries
                                         else self.surfaceFile(entries))
                    _, middle, J = shapes.massProperties(points, triangles)
                    axes = shapes.principalAxes(J)
                # a body's own frame, if it is not that of its uniform shape
                if 'centreOfMass' in entries:
                    middle = vectorOf(entries['centreOfMass'])
                    if self.flat is not None:
                        middle[self.flat] = 0
                if 'axes' in entries:
                    axes = np.array(clouds.numbers(entries['axes'].encode())).reshape(3, 3)
                self._shapes.append(('shape', number, middle, axes, points, triangles))
        return self._shapes

    def _bodySurface(self, e):
        source = e['source']
        if source == 'box':
            corners = clouds.numbers(e['box'].encode()).reshape(2, 3)
            if self.flat is not None:
                corners[:, self.flat] = self.mesh.low[self.flat] - 1, self.mesh.high[self.flat] + 1
            return shapes.box(*corners)
        if source == 'cylinder':
            p1, p2 = vectorOf(e['p1']), vectorOf(e['p2'])
            if self.flat is not None and abs(shapes.unit(p2 - p1)[self.flat]) > 0.5:
                p1[self.flat], p2[self.flat] = (self.mesh.low[self.flat] - 1,
                                                self.mesh.high[self.flat] + 1)
            return shapes.cylinder(p1, p2, numberOf(e['radius']))
        if source == 'sphere':
            return shapes.sphere(vectorOf(e['centre']), numberOf(e['radius']))
        return self.surfaceFile(e) if 'file' in e else None

    def _rigid(self, time):
        """Poses of rigid bodies at a time whose state is there: position, orientation, and the same
        at first; None of a picture"""
        folder = os.path.join(self.folder, time, 'uniform', 'lagrangian', 'solids', 'clumps')
        if not (os.path.exists(os.path.join(folder, 'position'))
                or os.path.exists(os.path.join(folder, 'position.gz'))):
            return None

        def read(name):
            path = os.path.join(folder, name)
            return (clouds.readField(path) if os.path.exists(path) or os.path.exists(path + '.gz')
                    else None)
        real, axis, first, firstAxis = (read(n) for n in ('orientationReal', 'orientationImaginary',
                                                          'startOrientationReal',
                                                          'startOrientationImaginary'))
        result = {'position': read('position'),
                  'R': [shapes.rotation((w, *v)) for w, v in zip(real, axis)],
                  'group': read('group'), 'shape': read('shape')}
        result['startPosition'] = read('startPosition')
        if first is None:
            result['startPosition'], first, firstAxis = result['position'], real, axis
        result['startR'] = [shapes.rotation((w, *v)) for w, v in zip(first, firstAxis)]
        return result

    def poses(self, time, cloud):
        """The same; of a picture by the places of each body's particles, beside those of a time
        whose state is there"""
        now = self._rigid(time)
        if now is not None:
            return now
        if 'poses' not in self._first:
            known = next(((t, r) for t in self.times for r in [self._rigid(t)] if r is not None),
                         None)
            self._first['poses'] = known and (
                known[1], clouds.readCloud(self.folder, known[0], ('clump', 'origId'), 'solids'))
        if not self._first['poses']:
            return None
        base, then = self._first['poses']
        at = {k: i for i, k in enumerate(then['origId'])}
        result = {**base, 'position': base['position'].copy(), 'R': list(base['R'])}
        for k in range(len(base['position'])):
            members = np.flatnonzero(cloud['clump'] == k)
            members = [i for i in members if cloud['origId'][i] in at]
            if members:
                before = then['positions'][[at[cloud['origId'][i]] for i in members]]
                R, s = shapes.rigidFit(before, cloud['positions'][members])
                if len(members) < (2 if self.flat is not None else 3):
                    R, s = np.eye(3), (cloud['positions'][members] - before).mean(axis=0)
                result['position'][k] = R @ base['position'][k] + s
                result['R'][k] = R @ base['R'][k]
        return result

    def _addConstants(self, cloud, n):
        """Fields of the solids that never change, of a time that has them, where a picture
        (pictureFields) lacks them"""
        for name in ('origId', 'radius', 'group', 'clump'):
            if name in cloud:
                continue
            known = next((t for t in self.times
                          if {name, 'origId'} <= set(self.fieldsAt(t, 'solids'))), None)
            if known is not None:
                other = clouds.readCloud(self.folder, known, ('origId', name), 'solids')
                if name == 'origId' and len(other['origId']) == n:
                    cloud[name] = other[name]           # particles stand in the order of their ids
                elif 'origId' in cloud:
                    at = dict(zip(other['origId'], other[name]))
                    cloud[name] = np.array([at.get(i, 0) for i in cloud['origId']])
            if name not in cloud and name == 'radius':
                raise PictureError(
                    f'{self.folder}: no time has radius and origId of lagrangian/solids')
            if name not in cloud and name == 'group':
                cloud[name] = np.zeros(n, dtype=int)

    def bodies(self, frame, field):
        """Balls, shapes and bonded bodies into a frame. field: that colours them, or None"""
        there = self.fieldsAt(frame.name, 'solids')
        wanted = [n for n in ('origId', 'radius', 'group', 'clump') if n in there]
        if field is not None and field not in there:
            raise PictureError(f'{self.folder}/{frame.name}/lagrangian/solids: no field {field}; '
                               f'there are {" ".join(there)}')
        cloud = clouds.readCloud(self.folder, frame.name, wanted
                                 + ([field] if field and field not in wanted else []), 'solids')
        n = len(cloud['positions'])
        if not n:
            return
        self._addConstants(cloud, n)
        cloud = self.seen(cloud, frame.name)
        n = len(cloud['positions'])
        if not n:
            return
        value = None if field is None else sizes(cloud[field])
        left = np.ones(n, dtype=bool)
        if 'clump' in cloud:
            left &= ~self._shaped(frame, cloud, value)
        bonded = self._bonded(frame.name, cloud) & left
        radius = cloud['radius']
        if value is None and bonded.any() and np.ptp(radius[bonded]) < 0.02*radius[bonded].max():
            apart = self.bondedSpacing(cloud, bonded)
            grid = surface.blend(self.inPlane(cloud['positions'][bonded]), apart,
                                 refine=4 if self.flat is not None else 2, smooth=0.5)
            frame.blends.append((grid, int(np.bincount(cloud['group'][bonded]).argmax()), None))
            frame.blended.append((cloud['positions'][bonded], radius[bonded], frame.blends[-1][1],
                                  None))
            left &= ~bonded
        if 'clump' in cloud:
            left &= ~self._lists(frame, cloud, value, left)
        for group in np.unique(cloud['group'][left]):
            mine = left & (cloud['group'] == group)
            frame.balls.append((cloud['positions'][mine], radius[mine], int(group),
                                None if value is None else value[mine]))
        if value is not None:
            frame.shown.append(value)
        reach = radius.max()
        frame.hold(cloud['positions'], reach)

    def _lists(self, frame, cloud, value, left):
        """Rigid bodies whose surface is not known, of many particles of one size: each smooth.
        Which particles are theirs"""
        mine = np.zeros(len(left), dtype=bool)
        names, counts = np.unique(cloud['clump'][left], return_counts=True)
        for k in names[(names >= 0) & (counts >= manyParticles)]:
            members = left & (cloud['clump'] == k)
            radius = cloud['radius'][members]
            if np.ptp(radius) > 0.02*radius.max():
                continue
            x = self.inPlane(cloud['positions'][members])
            # as many as fill it: lists differ in how far apart they are
            apart = np.linalg.norm(x[:, None] - x[None], axis=2) if len(x) <= 2000 else None
            near = (2*radius.max() if apart is None
                    else float(np.median(np.where(apart > 1e-12, apart, np.inf).min(axis=1))))
            colour = None if value is None else float(value[members].mean())
            group = int(cloud['group'][members][0])
            frame.blends.append((surface.blend(x, near, refine=4 if self.flat is not None else 2,
                                               smooth=0.7), group, colour))
            frame.blended.append((cloud['positions'][members], radius, group,
                                  None if value is None else value[members]))
            mine |= members
        return mine

    def bondedSpacing(self, cloud, bonded):
        """Distance of neighbours at the start: the median of the nearest one's, of some"""
        if 'bondedSpacing' not in self._first:
            x = cloud['positions'][bonded]
            some = x[np.linspace(0, len(x) - 1, min(200, len(x))).astype(int)]
            apart = np.linalg.norm(some[:, None] - x[None], axis=2)
            apart[apart < 1e-12] = np.inf
            self._first['bondedSpacing'] = (float(np.median(apart.min(axis=1))) if len(x) > 1
                                            else 2*cloud['radius'][bonded][0])
        return self._first['bondedSpacing']

    def _bonded(self, time, cloud):
        """Which particles have bonds at the start of the run"""
        if 'bonded' not in self._first:
            ids = set()
            for t in self.times:
                folder = os.path.join(self.folder, t, 'uniform', 'lagrangian', 'solids', 'bonds')
                if os.path.exists(os.path.join(folder, 'a')) or os.path.exists(
                        os.path.join(folder, 'a.gz')):
                    for end in 'ab':
                        ids.update(clouds.readField(os.path.join(folder, end)))
                    break
            self._first['bonded'] = ids
        ids = self._first['bonded']
        return (np.array([i in ids for i in cloud['origId']]) if ids and 'origId' in cloud
                else np.zeros(len(cloud['positions']), dtype=bool))

    def _shaped(self, frame, cloud, value):
        """Items of bodies whose surface is known; which particles are theirs"""
        mine = np.zeros(len(cloud['positions']), dtype=bool)
        own = self.ownShapes()
        poses = self.poses(frame.name, cloud) if own else None
        if poses is None:
            return mine
        done = set()
        for kind, number, *made in own:
            if kind == 'surface':
                bodies = [number]
            elif poses['shape'] is not None:
                bodies = [k for k in np.flatnonzero(poses['shape'] == number) if k not in done]
            else:
                bodies = []
            for k in bodies:
                members = cloud['clump'] == k
                if not members.any():
                    continue                # it has left
                done.add(k)
                mine |= members
                if kind == 'surface':
                    points, triangles = made
                    local = (points - poses['startPosition'][k]) @ poses['startR'][k]
                else:
                    middle, axes, points, triangles = made
                    local = (points - middle) @ axes
                placed = local @ poses['R'][k].T + poses['position'][k]
                colour = None if value is None else float(value[members].mean())
                group = int(cloud['group'][members][0])
                if triangles is None:
                    item = Item('body',
                                lines=[placed[:, self.plane][list(range(len(placed))) + [0]]],
                                group=group, value=colour)
                else:
                    if self.flat is not None and kind == 'shape':
                        placed[:, self.flat] += (self.middle[self.flat]
                                                 - poses['position'][k][self.flat])
                    item = self.shape('body', placed, triangles, group=group, value=colour)
                frame.items.append(item)
        return mine

    def bondLines(self, frame, field):
        """Whole bonds of VTK/bonds, coloured by tension or stretch"""
        files = {}
        for path in glob.glob(os.path.join(self.folder, 'VTK', 'bonds', 'bonds_*.vtp')):
            files[float(os.path.basename(path)[6:-4])] = path
        if not files:
            raise PictureError(f'{self.folder}: no bonds in VTK/bonds')
        nearest = min(files, key=lambda t: abs(t - frame.time))
        points, ends, arrays = foamFiles.readLines(files[nearest])
        if field not in arrays:
            raise PictureError(
                f'{files[nearest]}: no {field}; there are {" ".join(sorted(arrays))}')
        whole = arrays['broken'] < 0.5
        if any(kind == 'groups' for kind, _ in self.hidden):
            whole &= self._seenBonds(frame, ends, len(points))
        frame.bonds = points[ends[whole]], sizes(arrays[field][whole])
        frame.shown.append(frame.bonds[1])

    def _seenBonds(self, frame, ends, n):
        """Which of the bonds between n particles have an end in a group that is drawn"""
        cloud = clouds.readCloud(self.folder, frame.name, ('group',) if 'group'
                                 in self.fieldsAt(frame.name, 'solids') else (), 'solids')
        if len(cloud['positions']) != n:
            self.note(f'bonds of hidden groups are drawn at {frame.name}: '
                      'their file is of a time with other particles')
            return np.ones(len(ends), dtype=bool)
        cloud['place'] = np.arange(n)
        self._addConstants(cloud, n)
        return np.isin(ends, self.seen(cloud, frame.name)['place']).any(axis=1)

    # Water ----------------------------------------------------------------------------------------

    def inPlane(self, points):
        return points if self.flat is None else points[:, self.plane]

    def box(self):
        """The mesh's, in the plane in 2D, if its walls stand still; else None"""
        if any(self.moves(p.name) for p in self.mesh.patches):
            return None
        return self.inPlane(self.mesh.low[None])[0], self.inPlane(self.mesh.high[None])[0]

    def fieldsAt(self, time, cloud):
        folder = os.path.join(self.folder, time, 'lagrangian', cloud)
        names = os.listdir(folder) if os.path.isdir(folder) else []
        return sorted({n[:-3] if n.endswith('.gz') else n for n in names}
                      - {'positions', 'coordinates'})

    def waterOf(self, frame, field):
        """Grid and drops into a frame. field: that colours it, or None"""
        there = self.fieldsAt(frame.name, 'fluid')
        if field is not None and field not in there:
            raise PictureError(f'{self.folder}/{frame.name}/lagrangian/fluid: no field {field}; '
                               f'there are {" ".join(there)}')
        cloud = clouds.readCloud(self.folder, frame.name, (field,) if field else ())
        positions = cloud['positions']
        if not len(positions):
            return
        spacing = self.spacing(frame.name)
        value = sizes(cloud[field]) if field else None
        flat = self.flat is not None
        x = self.inPlane(positions)
        box = self.box()
        pic = (bool(self.properties['pic']) and not self.properties['sph']
               or self._solver() == 'picDem')
        # particles of a grid lie as chance has it: two spacings are a cell
        smooth = 1.0 if pic else surface.width
        grid = surface.blend(x, spacing, value, box, refine=4 if flat else 2, smooth=smooth,
                             largest=4e6 if flat else 12e6)
        # particles alone, or nearly; cells beside bodies have little water and are no drops
        thin = grid.at(x) < (0.6 if pic else 1.0)*surface.level
        if pic:
            mesh = self._waterOfMesh(frame)
            if mesh is not None:
                grid = self._merge(grid, mesh)
        frame.grid = grid
        frame.water = positions, value, spacing
        frame.drops = positions[thin], (value[thin] if field else None), spacing
        if value is not None:
            frame.shown.append(value)
        # a few drops high above need not be on the picture
        low, high = np.quantile(positions, (0.002, 0.998), axis=0)
        fall = np.argmax(np.abs(self.gravity))
        if self.gravity[fall] < 0:
            high[fall] = np.quantile(positions[:, fall], 0.985)
        elif self.gravity[fall] > 0:
            low[fall] = np.quantile(positions[:, fall], 0.015)
        frame.hold(np.array([low, high]), 0.5*spacing)

    def _solver(self):
        return self._read('system', 'controlDict').get('solver')

    def _waterOfMesh(self, frame):
        """picDem's fraction of water in the cells, at nodes; None where it was not written or the
        mesh is not of equal cells"""
        path = os.path.join(self.folder, frame.name, 'alpha.water')
        if not (os.path.exists(path) or os.path.exists(path + '.gz')):
            return None
        if self._lattice is None:
            self._lattice = self.mesh.lattice() or False
        if not self._lattice:
            return None
        counts, place = self._lattice
        alpha = foamFiles.volumeField(path, len(place))
        return surface.ofCells(counts, place, self.mesh.low, self.mesh.high, np.clip(alpha, 0, 1),
                               axes=self.plane or (0, 1, 2))

    def _merge(self, grid, mesh):
        """The particles' grid with f of the mesh where that has any water: level 1/2 of the mesh is
        the surface"""
        index = np.stack(np.meshgrid(*[grid.low[d] + grid.cell[d]*np.arange(grid.f.shape[d])
                                       for d in range(grid.f.ndim)], indexing='ij'), axis=-1)
        of = mesh.at(index.reshape(-1, grid.f.ndim)).reshape(grid.f.shape)
        grid.f = np.maximum(of, 0) + (surface.level - 0.5)
        return grid

    # Frames ---------------------------------------------------------------------------------------

    def nearest(self, t):
        return min(self.times, key=lambda name: abs(float(name) - t))

    def frame(self, name, field):
        """field: (what it colours: fluid, solids or bonds; its name), or None"""
        frame = Frame(float(name), name)
        of, what = field or (None, None)
        if clouds.hasCloud(self.folder, name, 'fluid'):
            self.waterOf(frame, what if of == 'fluid' else None)
        if clouds.hasCloud(self.folder, name, 'solids'):
            self.bodies(frame, what if of == 'solids' else None)
        if of == 'bonds':
            self.bondLines(frame, what)
        self.walls(frame)
        return frame


def pointsOf(text):
    """Of a list of OpenFOAM, ((x y z) ..), whose length may stand before it"""
    return clouds.numbers(text[text.find('('):].encode()).reshape(-1, 3)


def sizes(values):
    """Magnitudes of vectors; numbers as they are"""
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else np.asarray(values, dtype=float)


def label(what):
    return labels.get(what, what)
