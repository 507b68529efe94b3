#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a random case of sphDem with an empty sphProperties: makeScene.py SEED FOLDER [scale]

A tank (open or with a lid, level or tilted by gravity's direction), water columns, blocks of water
that fly, obstacles, bodies that fall, rise or are thrown, a wall or a tank that moves; 2D and 3D;
speeds to 10 m/s; 1 to 8 s. scale: particles per length against the coarse scene (1).
"""
import math
import os
import random
import sys

import numpy as np

HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {cls};
    object      {name};
}}

"""


def write(folder, place, name, text, cls='dictionary'):
    os.makedirs(os.path.join(folder, place), exist_ok=True)
    with open(os.path.join(folder, place, name), 'w') as f:
        f.write(HEADER.format(cls=cls, name=name) + text)


class Scene:
    """Lengths in units of the spacing until they are written: columns and shelves of a grid keep
    everything apart"""

    def __init__(self, seed, scale):
        r = self.r = random.Random(seed)
        self.seed = seed
        self.dim = 3 if r.random() < 0.35 else 2
        self.dp = r.choice([0.005, 0.01, 0.02, 0.05])/scale
        s = scale
        self.nx = int(r.randint(24 if self.dim == 2 else 18, 60 if self.dim == 2 else 24)*s)
        self.nz = int(r.randint(20 if self.dim == 2 else 16, 40 if self.dim == 2 else 20)*s)
        self.ny = int(r.randint(5, 8)*s) if self.dim == 3 else 1
        self.tilt = math.radians(r.choice([0, 0, r.uniform(-30, 30)]))
        self.lid = r.random() < 0.5
        self.scale = s
        self.fluids, self.bodies, self.obstacles, self.materials = [], [], [], []
        self.motion = None
        # of what moves: shift along x [m] and angle about y [rad] at a time, once its files are
        # made
        self.moved = {}
        self.fill()

    def speed(self):
        """Up to 10 m/s, but no more than 12 times the waves of this tank"""
        return self.r.uniform(0.2, 1)*min(10, 12*math.sqrt(9.81*self.nz*self.dp))

    def fill(self):
        r, s = self.r, self.scale
        kind = r.choice(['column', 'pool', 'twoColumns', 'column', 'pool'])
        deep = int(r.uniform(0.25, 0.6)*self.nz)
        wide = int(r.uniform(0.2, 0.5)*self.nx)
        depthOfPool = 0
        if kind == 'pool':
            depthOfPool = max(int(4*s), int(r.uniform(0.15, 0.4)*self.nz))
            self.fluids.append((0, 0, self.nx, depthOfPool, None))
        else:
            u = self.speed() if r.random() < 0.3 else None
            self.fluids.append((0, 0, wide, deep, (u, 0) if u else None))
            if kind == 'twoColumns':
                self.fluids.append((self.nx - int(wide*0.6), 0, self.nx, int(deep*0.8), None))
        used = depthOfPool
        # obstacles on the floor in the free part, or in the pool
        if r.random() < 0.6:
            w, h = int(r.uniform(3, 6)*s), int(r.uniform(3, 8)*s)
            x = int(r.uniform(0.55, 0.75)*self.nx)
            self.obstacles.append((r.choice(['box', 'cylinder', 'box', 'plate']), x, w, h,
                                   depthOfPool > 0))
        # water that flies
        free = self.nz - max(used, deep if kind != 'pool' else 0)
        if r.random() < 0.5 and free > 14*s:
            a = int(r.uniform(4, 8)*s)
            z = self.nz - a - int(3*s)
            x = int(r.uniform(0.15, 0.6)*self.nx)
            v = self.speed()
            angle = r.uniform(-0.4, 0.4) - math.pi/2
            self.fluids.append((x, z, x + a, z + a, (v*math.cos(angle), v*math.sin(angle))))
        # a body: dropped or thrown, light or heavy
        elif r.random() < 0.75 and free > 12*s:
            a = int(r.uniform(4, 7)*s)
            x = int(r.uniform(0.35, 0.6)*self.nx)
            z = max(used, deep if kind != 'pool' and x < wide + 2*s else 0) + int(r.uniform(2, 4)*s)
            for _, at, w, h, _ in self.obstacles:
                if x - w - s < at < x + a + w + s:
                    z = max(z, h + w + int(4*s))
            z = min(z, self.nz - a - 1)
            self.lid = True     # a body that flies out of the tank ends a run
            v = r.choice([0, self.speed()])
            self.bodies.append((x, z, a, r.choice([300, 600, 1500, 3000, 7800]), v))
        if r.random() < 0.25 and not self.bodies:
            self.motion = r.choice(['paddle', 'tank'])
        self.end = min(
            8, max(1, r.choice([1, 2, 3])*math.sqrt(self.dp/0.005)*(1 if self.dim == 2 else 0.5)))

    def floorPotential(self):
        """Potential of a unit mass in the lowest corner of the tank [m2/s2]"""
        gx, gz = 9.81*math.sin(self.tilt), -9.81*math.cos(self.tilt)
        return min(-gx*x*self.dp - gz*z*self.dp for x in (0, self.nx) for z in (0, self.nz))

    def behind(self, x, time):
        """How many of these positions (n, 3) [m] are in a wall at this time: outside the tank but
        through its open top, in a box, a cylinder or the paddle. Plates have no inside"""
        d, near = self.dp, 1e-3*self.dp
        _, angle = self.moved.get('tank', lambda t: (0, 0))(time)
        across, up = x[:, 0] - 0.5*self.nx*d, x[:, 2]
        # into the frame of a tank that turns about y
        X = 0.5*self.nx*d + math.cos(angle)*across - math.sin(angle)*up
        Y, Z = x[:, 1], math.sin(angle)*across + math.cos(angle)*up
        inside = self.inBox((X, Y, Z), (0, 0, 0),
                            (self.nx*d, self.ny*d, self.nz*d if self.lid else 1e30), -near)
        count = ~inside
        for kind, at, w, h, _ in self.obstacles:
            if kind == 'box':
                y0, y1 = (0.25*self.ny*d, 0.75*self.ny*d) if self.dim == 3 else (-1e30, 1e30)
                count |= self.inBox((X, Y, Z), (at*d, y0, -1e30), ((at + w)*d, y1, h*d), near)
            elif kind == 'cylinder':
                count |= (X - at*d)**2 + (Z - (h + w)*d)**2 < (0.5*w*d - near)**2
        if 'paddle' in self.moved:
            shift = self.moved['paddle'](time)[0]
            count |= self.inBox((X - shift, Y, Z), (6*d, -1e30, 0), (9*d, 1e30, (self.nz - 4)*d),
                                near)
        return int(count.sum())

    def inBox(self, x, low, high, by):
        """Are they deeper in the box than this? In 2D y is none"""
        inside = True
        for k in (0, 2) if self.dim == 2 else (0, 1, 2):
            inside = inside & (x[k] > low[k] + by) & (x[k] < high[k] - by)
        return inside

    def depthOfBody(self, a):
        """From where to where a body of so many spacings reaches along y"""
        if self.dim == 2:
            return 0, self.ny*self.dp
        if a > self.ny - 2:
            return self.dp, (self.ny - 1)*self.dp
        return (self.ny/2 - a/2)*self.dp, (self.ny/2 + a/2)*self.dp

    def inBody(self, x, before, now):
        """How many of these positions (n, 3) are deeper in the body than a tenth of a spacing, by
        the positions of its particles at the start and now"""
        X, Z, a = self.bodies[0][:3]
        y, yy = self.depthOfBody(a)
        middle, centre = before.mean(0), now.mean(0)
        # the rotation between them (Kabsch 1976)
        u, _, v = np.linalg.svd((before - middle).T @ (now - centre))
        turn = v.T @ np.diag([1, 1, np.linalg.det(v.T @ u.T)]) @ u.T
        own = (x - centre) @ turn + middle
        return int(np.sum(self.inBox(own.T, (X*self.dp, y, Z*self.dp),
                                     ((X + a)*self.dp, yy, (Z + a)*self.dp), 0.1*self.dp)))

    # * * * files

    def box(self, x0, z0, x1, z1):
        d, far = self.dp, self.ny*self.dp
        return '(%g %g %g) (%g %g %g)' % (x0*d, 0, z0*d, x1*d, far, z1*d)

    def files(self, folder):
        d = self.dp
        L, W, H = self.nx*d, self.ny*d, self.nz*d
        sides = '(0 1 5 4) (3 7 6 2)'
        top = '(4 5 6 7)'
        patches = ('floor { type wall; faces ((0 3 2 1)); } left { type wall; faces ((0 4 7 3)); } '
                   'right { type wall; faces ((1 2 6 5)); }\n')
        patches += ('sides { type wall; faces (%s); }\n' if self.dim == 3
                    else 'frontAndBack { type empty; faces (%s); }\n') % sides
        patches += 'top { type %s; faces (%s); }\n' % ('wall' if self.lid else 'patch', top)
        write(folder, 'system', 'blockMeshDict',
              'scale 1;\nvertices ((0 0 0) (%g 0 0) (%g %g 0) (0 %g 0) (0 0 %g) (%g 0 %g) '
              '(%g %g %g) (0 %g %g));\n'
              % (L, L, W, W, H, L, H, L, W, H, W, H) +
              'blocks (hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (1 1 1));\nedges ();\n'
              'boundary\n(\n%s);\nmergePatchPairs ();\n'
              % (max(2, self.nx//4), max(1, self.ny//4), max(2, self.nz//4), patches))
        regions = ''
        for k, (x0, z0, x1, z1, u) in enumerate(self.fluids):
            velocity = 'velocity (%g 0 %g);' % u if u else ''
            pressure = 'pressure zero;' if u and u[1] else ''
            regions += ('water%d { set fluid; source box; box %s; clip yes; %s %s }\n'
                        % (k, self.box(x0, z0, x1, z1), velocity, pressure))
        for k, (x, z, a, rho, v) in enumerate(self.bodies):
            y, yy = self.depthOfBody(a)
            regions += ('body%d { set solids; source box; box (%g %g %g) (%g %g %g); radius %g; '
                        'material m%d; group body%d; rigid yes; mass cell; velocity (0 0 %g); }\n'
                        % (k, x*d, y, z*d, (x + a)*d, yy, (z + a)*d, 0.5*d, k, k, -v))
        write(folder, 'system', 'setParticlesDict',
              'spacing %g;\nregions\n(\n%s);\n' % (d, regions))
        self.geometry(folder)
        g = 9.81
        write(folder, 'constant', 'g', 'dimensions [0 1 -2 0 0 0 0];\nvalue (%g 0 %g);\n'
              % (g*math.sin(self.tilt), -g*math.cos(self.tilt)), 'uniformDimensionedVectorField')
        write(folder, 'constant', 'fluidProperties', 'rho 1000;\nmu 1e-3;\n')
        write(folder, 'constant', 'sphProperties', self.walls())
        if self.bodies:
            self.solids(folder)
        energies = ('solids { type solidEnergies; libs ("libriprapFoam.so"); }\n' if self.bodies
                    else '')
        write(folder, 'system', 'controlDict',
              'application riprapFoam;\nsolver sphDem;\nstartFrom startTime;\nstartTime 0;\n'
              'stopAt endTime;\nendTime %g;\n'
              % self.end + 'deltaT 1e-5;\nadjustTimeStep yes;\nsampleInterval %g;\n'
                           'writeControl adjustableRunTime;\nwriteInterval %g;\n'
              % (self.end/100, self.end/2) + 'writeFormat binary;\nwritePrecision 10;\ntimeFormat '
                                             'general;\ntimePrecision 8;\nrunTimeModifiable no;\n'
              'functions\n{\nenergy { type energyBalance; libs ("libriprapFoam.so"); }\n'
              '%s}\n' % energies)
        for name in ('fvSchemes',):
            write(folder, 'system', name,
                  'ddtSchemes {}\ngradSchemes {}\ndivSchemes {}\nlaplacianSchemes {}\n'
                  'interpolationSchemes {}\nsnGradSchemes {}\n')

    def geometry(self, folder):
        d, text = self.dp, ''
        W = self.ny*d
        for k, (kind, x, w, h, inPool) in enumerate(self.obstacles):
            if kind == 'box':
                y0, y1 = (-W, 2*W) if self.dim == 2 else (0.25*W, 0.75*W)
                text += ('obstacle%d { type searchableBox; min (%g %g 0); max (%g %g %g); }\n'
                         % (k, x*d, y0, (x + w)*d, y1, h*d))
            elif kind == 'cylinder':
                z = (h + w)*d
                text += ('obstacle%d { type searchableCylinder; point1 (%g %g %g); point2 (%g %g '
                         '%g); radius %g; }\n' % (k, x*d, -W, z, x*d, 2*W, z, 0.5*w*d))
            else:
                text += ('obstacle%d { type searchablePlate; origin (%g %g 0); span (0 %g %g); }\n'
                         % (k, x*d, -W, 3*W, h*d))
        if self.motion == 'paddle':
            text += ('paddle { type searchableBox; min (%g %g 0); max (%g %g %g); }\n'
                     % (6*d, -W, 9*d, 2*W, (self.nz - 4)*d))
        if text:
            write(folder, 'constant', 'geometry', text)

    def walls(self):
        if not self.motion:
            return ''
        amplitude = self.r.uniform(1, 4)*self.dp
        omega = self.r.uniform(0.5, 1.2)*math.sqrt(9.81*3.14/(self.nx*self.dp))
        if self.motion == 'paddle':
            self.moved = {'paddle': lambda time: (amplitude*math.sin(omega*time), 0)}
            return ('walls { motion { paddle { patches (paddle); solidBodyMotionFunction '
                    'oscillatingLinearMotion; oscillatingLinearMotionCoeffs { amplitude (%g 0 0); '
                    'omega %g; } } } }\n' % (amplitude, omega))
        degrees = self.r.uniform(2, 12)
        self.moved = {'tank': lambda time: (0, math.radians(degrees)*math.sin(omega*time))}
        every = '"(floor|left|right|sides|top|obstacle.*)"'
        return ('walls { motion { tank { patches (%s); solidBodyMotionFunction '
                'oscillatingRotatingMotion; oscillatingRotatingMotionCoeffs { origin (%g 0 0); '
                'amplitude (0 %g 0); omega %g; } } } }\n'
                % (every, 0.5*self.nx*self.dp, degrees, omega))

    def solids(self, folder):
        d = self.dp
        materials, heaviest = '', max(b[3] for b in self.bodies)
        for k, b in enumerate(self.bodies):
            materials += 'm%d { rho %g; } ' % (k, b[3])
        # an overlap of a hundredth of a spacing under the fastest impact that is possible
        fastest = max(max(b[4] for b in self.bodies), 2*math.sqrt(9.81*self.nz*d))
        area = d*(1 if self.dim == 2 else d)
        stiffness = heaviest*d*area*(fastest/(0.05*d))**2
        write(folder, 'constant', 'solidProperties',
              'contact { normal linear; tangential history; rolling none; }\n'
              'materials { %s tank { rho 2500; } }\n' % materials +
              'pairs { default { stiffness %g; restitution 0.3; friction 0.3; stiffnessRatio 0.5; '
              '} }\nwalls { material tank; }\ngroups { %s }\n'
              % (stiffness, ' '.join('body%d {}' % k for k in range(len(self.bodies)))))


def main():
    seed, folder = int(sys.argv[1]), sys.argv[2]
    scene = Scene(seed, int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    scene.files(folder)


if __name__ == '__main__':
    main()
