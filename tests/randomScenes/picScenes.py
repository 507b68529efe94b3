#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a random case of picDem with bodies: picScenes.py SEED FOLDER [scale]

A tank (closed, level or tilted by gravity's direction) with a pool or a column of water, a step, a
cylinder or a slope in it, or a channel with openings; balls, disks, boxes, prisms and clumps of
0.05 to 10 times the water's density, hard and soft, that fall in, enter flat, rise and breach the
surface, float, collide under water or slide down the slope into it; 2D and 3D, with and without
`reflection`. scale: cells per length against the coarse scene (1).
"""
import math
import os
import random
import sys

import numpy as np

from makeScene import write

# Scenes whose gap of 0 is beyond what the method holds (docs/stability.md, light bodies wedged
# among others): the gap, in cells, that the page asks for
BEYOND = {30: 0.5}
KINDS = ('drop', 'flat', 'breach', 'float', 'collide', 'slide')


def hull(points):
    """Convex outline, counter-clockwise"""
    points = sorted(points)

    def chain(of):
        out = []
        for p in of:
            while (len(out) > 1 and (out[-1][0] - out[-2][0])*(p[1] - out[-2][1])
                   <= (out[-1][1] - out[-2][1])*(p[0] - out[-2][0])):
                out.pop()
            out.append(p)
        return out[:-1]
    return chain(points) + chain(points[::-1])


def thicknessOf(outline):
    """Diameter of the largest circle of a few hundred in a convex outline about the origin"""
    sides = list(zip(outline, outline[1:] + outline[:1]))
    reach = max(max(abs(c) for c in p) for p in outline)

    def depth(x, z):
        return min(((b[0] - a[0])*(z - a[1]) - (b[1] - a[1])*(
            x - a[0]))/math.hypot(b[0] - a[0], b[1] - a[1]) for a, b in sides)
    return 2*max(depth(0.1*i*reach, 0.1*j*reach) for i in range(-10, 11) for j in range(-10, 11))


class PicScene:
    """Lengths in cells until they are written; z is up, y the third axis (2D: empty)"""

    def __init__(self, seed, scale=1):
        r = self.r = random.Random(seed)
        self.seed, self.scale = seed, scale
        self.dim = 3 if r.random() < 0.3 else 2
        flat = self.dim == 2
        self.h = r.choice([0.005, 0.01, 0.02, 0.05])/scale
        self.nx = (r.randint(40, 56) if flat else r.randint(22, 26))*scale
        self.nz = (r.randint(36, 44) if flat else r.randint(22, 26))*scale
        self.ny = 1 if flat else r.randint(11, 13)*scale
        self.tilt = math.radians(r.choice([0, 0, r.uniform(-15, 15)]))
        self.reflection = r.random() < 0.7
        self.precision = r.choice(['mixed', 'double'])
        self.gap = r.choice([0, 1, 2])
        self.gap = BEYOND.get(seed, self.gap)
        self.soft = r.choice([0.005, 0.03])       # of a body's size: what an impact presses it in
        self.friction = r.choice([0, 0.3, 0.6])
        self.regions, self.materials, self.obstacles, self.fastest = [], [], [], 0
        # every kind in its turn, so that few scenes have all
        self.kind = KINDS[seed % len(KINDS)]
        self.opens = self.kind in ('drop', 'float') and r.random() < 0.4
        if self.opens:
            self.tilt = 0
        self.depth = r.uniform(0.4, 0.55)*self.nz
        self.column = self.kind == 'drop' and not self.opens and r.random() < 0.4
        self.wide = r.uniform(0.25, 0.4)*self.nx if self.column else self.nx
        self.waveTime = math.sqrt(self.nz*self.h/9.81)
        self.end = float('%.3g' % (4*self.waveTime))
        self.heaviest = 0
        self.furnish()

    # * * * bodies

    def density(self, low=0.05, high=10):
        return 1000*math.exp(self.r.uniform(math.log(low), math.log(high)))

    def body(self, x, z, size, rho, v=(0, 0, 0), shape=None, angle=0):
        """About (x, z), as large as fits into a circle of this diameter; heights are those of its
        middle"""
        k, h, flat = len(self.materials), self.h, self.dim == 2
        y = 0.5*self.ny
        shape = shape or self.r.choice(['ball', 'box', 'prism', 'clump'])
        self.materials.append(rho)
        common = ('set solids; material m%d; group body%d; velocity (%g %g %g);'
                  % ((k, k) + tuple(v)))
        self.heaviest = max(self.heaviest, rho*(size*h)**self.dim)
        self.fastest = max(self.fastest, math.sqrt(sum(u*u for u in v)))
        if shape in ('ball', 'clump'):
            balls = [(x, z, 0.5*size)]
            if shape == 'clump':
                a, far = self.r.uniform(0, math.pi), 0.17*size
                balls = [(x + s*far*math.cos(a), z + s*far*math.sin(a), 0.33*size) for s in (-1, 1)]
            name = 'body%d.csv' % k
            rows = ''.join('%.9g,%.9g,%.9g,%.9g\n' % (b[0]*h, y*h, b[1]*h, b[2]*h) for b in balls)
            self.files_.append((name, 'x,y,z,radius\n' + rows))
            self.regions.append('body%d { %s source csv; file "constant/%s"; %s }'
                                % (k, common, name, 'rigid yes;' if shape == 'clump' else ''))
            return
        thin = 2.2*self.scale       # half of what a body must have at least, and a little
        if shape == 'box':
            a = math.radians(self.r.uniform(15, 60))
            w, d = (max(0.5*size*c, thin) for c in (math.cos(a), math.sin(a)))
            outline = [(-w, -d), (w, -d), (w, d), (-w, d)]
        elif shape == 'flat':
            w, d = 0.45*size, max(0.22*size, thin)
            outline = [(-w, -d), (w, -d), (w, d), (-w, d)]
        else:
            while True:
                angles = [self.r.uniform(0, 2*math.pi) for _ in range(self.r.randint(3, 7))]
                outline = hull([(0.5*size*math.cos(t), 0.5*size*math.sin(t)) for t in angles])
                if len(outline) > 2 and thicknessOf(outline) > 2*thin:
                    break
        turn = 'orientation turned; %s angle %g;' % ('' if flat else 'axis (0 1 0);', angle)
        spheres = 'spheres %d; smallestRadius %g;' % (12 if flat else 20, 0.4*h)
        centre = 'centres ((%.9g %.9g %.9g));' % (x*h, y*h, z*h)
        if flat:
            points = ' '.join('(%.9g 0 %.9g)' % (p[0]*h, p[1]*h) for p in outline)
            self.regions.append('body%d { %s source clumpsFromOutline; outline (%s); %s %s %s }'
                                % (k, common, points, spheres, centre, turn))
        else:
            name = 'body%d.stl' % k
            self.files_.append(('triSurface/' + name,
                                self.prism(outline, min(0.4*size, 0.5*self.ny - 2.2))))
            self.regions.append('body%d { %s source clumpsFromSurface; file "%s"; resolution 24; '
                                '%s %s %s }' % (k, common, name, spheres, centre, turn))

    def prism(self, outline, half):
        """STL of an outline in x and z between -half and half along y"""
        h, text, n = self.h, 'solid body\n', len(outline)

        def face(*corners):
            return ('facet normal 0 0 0\nouter loop\n'
                    + ''.join('vertex %.9g %.9g %.9g\n' % tuple(c*h for c in p) for p in corners)
                    + 'endloop\nendfacet\n')

        def at(i, y):
            return (outline[i % n][0], y, outline[i % n][1])
        for i in range(n):
            text += (face(at(i, -half), at(i, half), at(i + 1, half))
                     + face(at(i, -half), at(i + 1, half), at(i + 1, -half)))
        for i in range(1, n - 1):
            text += (face(at(0, -half), at(i, -half), at(i + 1, -half))
                     + face(at(0, half), at(i + 1, half), at(i, half)))
        return text + 'endsolid body\n'

    def size(self):
        return (self.r.uniform(7.5, 10)*self.scale if self.dim == 2
                else self.r.uniform(6.5, 7.5)*self.scale)

    def speed(self):
        return self.r.choice([0, self.r.uniform(0.3, 1.5)])*math.sqrt(9.81*self.nz*self.h)

    def furnish(self):
        r = self.r
        self.files_ = []
        room = 2.5*self.scale       # beside walls and other bodies: their gaps
        top = self.nz - room
        obstacle = r.choice(['box', 'cylinder', 'none'])
        columns = 3 if self.dim == 2 else 2
        if self.kind == 'slide':
            # from the left down to the floor, out of the water
            self.slope = math.radians(r.uniform(25, 40))
            self.foot = 0.75*self.nx
            size = self.size()
            s = 0.5*size + (0.9*self.nx*0.75/math.cos(self.slope) if self.dim == 2
                            else 0.8*self.nx*0.75/math.cos(self.slope))
            high = 0.22*size + room
            s = min(s, (top - 0.5*size - high)/math.sin(self.slope),
                    (self.foot - 0.6*size)/math.cos(self.slope) - high*math.tan(self.slope))
            x = self.foot - s*math.cos(self.slope) + high*math.sin(self.slope)
            z = s*math.sin(self.slope) + high*math.cos(self.slope)
            self.depth = min(self.depth, z - 0.2*size)
            self.body(max(x, 0.6*size), z, size, self.density(0.3), shape='flat',
                      angle=math.degrees(self.slope))
            self.obstacles.append(('slope',))
            return
        bodies = r.randint(1, columns)
        if obstacle != 'none' and not self.opens:
            w = r.uniform(4, 7)*self.scale
            height = r.uniform(0.15, 0.3)*self.nz
            self.obstacles.append((obstacle, r.uniform(0.6, 0.85)*self.nx, w, height))
        for k in range(bodies):
            size = self.size()
            x = (k + 0.5)*self.nx/columns
            if size + 2*room > self.nx/columns:
                size = self.nx/columns - 2*room
            low = 0.5*size + room
            for o in self.obstacles:
                if abs(x - o[1]) < 0.5*(size + o[2]) + room:
                    low += o[3] + (0.5*o[2] if o[0] == 'cylinder' else 0)
            self.place(k, x, size, low, top - 0.5*size)

    def place(self, k, x, size, low, high):
        r, v = self.r, self.speed()
        above = self.depth + 0.5*size + r.uniform(0.5, 4)
        if self.column and x > self.wide:
            above = low
        if self.kind == 'breach':
            self.body(x, min(low + r.uniform(0, 1), high), size, self.density(0.05, 0.6))
        elif self.kind == 'float':
            self.body(x, max(low, min(self.depth + r.uniform(-0.4, 0.4)*size, high)), size,
                      self.density(), angle=r.uniform(-40, 40))
        elif self.kind == 'collide' and k == 0:
            smaller = 0.75*size if self.dim == 2 else 0.9*size
            self.depth = max(self.depth, min(low + 2.2*size + 4*self.scale, self.nz - 4))
            self.body(x, low, smaller, self.density(0.05, 0.7))
            self.body(x + r.uniform(-1, 1), min(low + smaller + 5*self.scale, high), smaller,
                      self.density(1.5, 10))
        elif self.kind == 'flat':
            self.body(x, max(low, min(above, high)), size, self.density(), (0, 0, -v), shape='flat')
        else:
            angle = r.uniform(-0.5, 0.5)
            self.body(x, max(low, min(above, high)), size, self.density(),
                      (v*math.sin(angle), 0, -v*math.cos(angle)), angle=r.uniform(-40, 40))

    # * * * what must hold

    def floorPotential(self):
        """Potential of a unit mass in the lowest corner of the tank [m2/s2]"""
        gx, gz = 9.81*math.sin(self.tilt), -9.81*math.cos(self.tilt)
        return min(-gx*x*self.h - gz*z*self.h for x in (0, self.nx) for z in (0, self.nz))

    def distance(self, X, Z):
        """Signed, of an obstacle at positions [cells], negative in it, where it is within two
        cells"""
        least = np.full(np.shape(X), 2.0)
        for o in self.obstacles:
            if o[0] == 'slope':
                d = (X - self.foot)*math.sin(self.slope) + Z*math.cos(self.slope)
            elif o[0] == 'box':
                a, b = np.abs(X - o[1]) - 0.5*o[2], np.abs(Z - 0.5*(o[3] - 1)) - 0.5*(o[3] + 1)
                d = np.hypot(np.maximum(a, 0), np.maximum(b, 0)) + np.minimum(np.maximum(a, b), 0)
            else:
                d = np.hypot(X - o[1], Z - o[3]) - 0.5*o[2]
            least = np.minimum(least, np.maximum(d, -2))
        return least

    def sampledDistance(self, X, Z):
        """The same as the cut cells have it: exact at the nodes of the grid, linear between them.
        At a right edge that is up to 0.29 cells less than the whole, at a cylinder of 2 cells
        0.07"""
        i, k = (np.clip(np.floor(c), 0, n - 1) for c, n in ((X, self.nx), (Z, self.nz)))
        f, g = X - i, Z - k
        return ((1 - f)*((1 - g)*self.distance(i, k) + g*self.distance(i, k + 1)) +
                f*((1 - g)*self.distance(i + 1, k) + g*self.distance(i + 1, k + 1)))

    def sunk(self, x, distance):
        """How deep each of these positions (n, 3) [m] is in a wall or, by this distance, in an
        obstacle [cells]; negative: in none"""
        X, Y, Z = (x/self.h).T
        out = [-X, X - self.nx, -Z, Z - self.nz, -distance(X, Z)]
        if self.dim == 3:
            out += [-Y, Y - self.ny]
        return np.max(out, axis=0)

    def behind(self, cloud, x):
        """How many of the positions of this cloud are in a wall. Water is kept out of solids as the
        grid has them, whose round ones have flat sides (0.0075 cells). Solids touch the exact
        shapes, and press into them"""
        distance, most = {'fluid': (self.sampledDistance, 0.01),
                          'solids': (self.distance, 0.05)}[cloud]
        return int((self.sunk(x, distance) > most).sum())

    # * * * files

    def files(self, folder):
        h = self.h
        L, W, H = self.nx*h, self.ny*h, self.nz*h
        left = 'patch' if self.opens else 'wall'
        patches = ('floor { type wall; faces ((0 3 2 1)); } left { type %s; faces ((0 4 7 3)); } '
                   'right { type %s; faces ((1 2 6 5)); }\n' % (left, left))
        patches += ('sides { type wall; faces (%s); }\n' if self.dim == 3
                    else 'frontAndBack { type empty; faces (%s); }\n') % '(0 1 5 4) (3 7 6 2)'
        patches += 'top { type wall; faces ((4 5 6 7)); }\n'
        write(folder, 'system', 'blockMeshDict',
              'scale 1;\nvertices ((0 0 0) (%.9g 0 0) (%.9g %.9g 0) (0 %.9g 0) (0 0 %.9g) '
              '(%.9g 0 %.9g) (%.9g %.9g %.9g) (0 %.9g %.9g));\n'
              % (L, L, W, W, H, L, H, L, W, H, W, H) +
              'blocks (hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (1 1 1));\nedges ();\n'
              'boundary\n(\n%s);\nmergePatchPairs ();\n'
              % (self.nx, self.ny, self.nz, patches))
        water = ('water { set fluid; source box; box (0 0 0) (%.9g %.9g %.9g); clip yes; '
                 'pressure zero; }' % (self.wide*h, W, self.depth*h))
        write(folder, 'system', 'setParticlesDict',
              'spacing %.9g;\nregions\n(\n%s\n%s\n);\n' % (0.5*h, water, '\n'.join(self.regions)))
        for name, text in self.files_:
            path = os.path.join(folder, 'constant', name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w') as f:
                f.write(text)
        self.geometry(folder)
        write(folder, 'constant', 'g', 'dimensions [0 1 -2 0 0 0 0];\nvalue (%.9g 0 %.9g);\n'
              % (9.81*math.sin(self.tilt), -9.81*math.cos(self.tilt)),
              'uniformDimensionedVectorField')
        write(folder, 'constant', 'fluidProperties', 'rho 1000;\nmu 1e-3;\n')
        openings = ''
        if self.opens:
            flow = 0.15*self.depth*h*W*math.sqrt(9.81*self.depth*h)
            openings = ('openings { left { type flowRate; flowRate %.6g; } right { type level; '
                        'level %.9g; } }\n' % (flow, self.depth*h))
        write(folder, 'constant', 'picProperties', 'device cpu;\nprecision %s;\nreflection %s;\n%s'
              % (self.precision, 'yes' if self.reflection else 'no', openings))
        fastest = max(self.fastest, math.sqrt(2*9.81*self.nz*h))
        stiffness = self.heaviest*(fastest/(self.soft*6*h))**2
        write(folder, 'constant', 'solidProperties',
              'contact { normal linear; tangential history; rolling none; }\n'
              'materials { %s tank { rho 2500; } }\n'
              % ' '.join('m%d { rho %.6g; }' % m for m in enumerate(self.materials)) +
              'pairs { default { stiffness %.6g; restitution %g; friction %g; stiffnessRatio 0.5; '
              'gap %.9g; } }\nwalls { material tank; }\ngroups { %s }\n'
              % (stiffness, self.r.choice([0.2, 0.8]), self.friction, self.gap*h,
                 ' '.join('body%d {}' % k for k in range(len(self.materials)))))
        write(folder, 'system', 'fvSolution',
              'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }\n')
        write(folder, 'system', 'fvSchemes',
              'ddtSchemes {}\ngradSchemes {}\ndivSchemes {}\nlaplacianSchemes {}\n'
              'interpolationSchemes {}\nsnGradSchemes {}\n')
        functions = (('energy', 'energyBalance'), ('solids', 'solidEnergies'),
                     ('momentum', 'momentumBalance'))
        write(folder, 'system', 'controlDict',
              'application riprapFoam;\nsolver picDem;\nstartFrom latestTime;\nstartTime 0;\n'
              'stopAt endTime;\nendTime %.9g;\n'
              % self.end + 'deltaT 1e-4;\nadjustTimeStep yes;\nmaxCo 0.5;\nsampleInterval 0;\n'
                           'writeControl adjustableRunTime;\nwriteInterval %.9g;\n'
              % (self.end/2) + 'writeFormat binary;\nwritePrecision 10;\ntimeFormat general;\n'
                               'timePrecision 8;\nrunTimeModifiable no;\n'
              'functions\n{\n%s}\n' % ''.join('%s { type %s; libs ("libriprapFoam.so"); }\n' % f
                                              for f in functions))

    def geometry(self, folder):
        h, text, W = self.h, '', self.ny*self.h
        for o in self.obstacles:
            if o[0] == 'slope':
                c, s = math.cos(self.slope), math.sin(self.slope)
                # its surface goes through the foot; e1 down the slope, e2 out of it
                length, deep = 3*self.nx*h, 2*self.nz*h
                origin = (self.foot*h - 2*self.nx*h*c - deep*s, -W, 2*self.nx*h*s - deep*c)
                text += ('slope { type searchableRotatedBox; origin (%.9g %.9g %.9g); '
                         'span (%.9g %.9g %.9g); e1 (%.9g 0 %.9g); e3 (0 -1 0); }\n'
                         % (origin[0], 2*W, origin[2], length, deep, 4*W, c, -s))
            elif o[0] == 'box':
                text += ('step { type searchableBox; min (%.9g %.9g %.9g); max (%.9g %.9g %.9g); '
                         '}\n' % ((o[1] - 0.5*o[2])*h, -W, -h, (o[1] + 0.5*o[2])*h, 2*W, o[3]*h))
            else:
                text += ('post { type searchableCylinder; '
                         'point1 (%.9g %.9g %.9g); point2 (%.9g %.9g %.9g); radius %.9g; }\n'
                         % (o[1]*h, -W, o[3]*h, o[1]*h, 2*W, o[3]*h, 0.5*o[2]*h))
        if text:
            write(folder, 'constant', 'geometry', text)


def main():
    PicScene(int(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) > 3 else 1).files(sys.argv[2])


if __name__ == '__main__':
    main()
