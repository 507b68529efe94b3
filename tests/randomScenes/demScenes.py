#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a random case of dem: demScenes.py SEED FOLDER [scale]

A closed tank (level or tilted by gravity's direction, or without gravity), a hopper or obstacles in
it, and above them random fills, blocks of a lattice, bonded bodies, rigid boxes, clumps of an
outline (2D) or a surface (3D) and single balls, at rest, falling or thrown at up to 10 m/s; 2D and
3D; all contact laws but paper 2's; soft and stiff: overlaps of 0.5 to 25 % of a diameter in the
hardest impact of a ball, more of a body. scale: bodies per length against the coarse scene (1).
"""
import math
import os
import random
import sys

from makeScene import write


class DemScene:
    """Lengths in diameters of the smallest bodies until they are written"""

    def __init__(self, seed, scale=1):
        r = self.r = random.Random(seed)
        self.dim = 3 if r.random() < 0.35 else 2
        self.d = r.choice([0.002, 0.005, 0.01, 0.02, 0.05])/scale
        self.scale = scale
        flat = self.dim == 2
        self.nx = r.randint(20, 32)*scale if flat else r.randint(9, 12)*scale
        self.nz = r.randint(18, 30)*scale if flat else r.randint(11, 15)*scale
        self.ny = 1 if flat else r.randint(6, 8)*scale
        self.tilt = math.radians(r.choice([0, 0, r.uniform(-30, 30)]))
        self.g = r.choice([9.81, 9.81, 9.81, 0])
        self.density = r.choice([500, 1000, 2500, 7800])
        self.speed = r.choice([0 if self.g else 0.3, 1, 3, 10])*r.uniform(0.3, 1)
        self.inside = r.choice(['hopper', 'box', 'cylinder', 'plate', 'none'])
        self.regions, self.materials, self.groups, self.bonds, self.outlines = [], [], [], '', []
        self.heaviest = self.mass(1)
        self.furnish()
        self.laws()

    # * * * what is in it

    def mass(self, diameter):
        """Of a ball [kg], in 2D per metre"""
        return self.density*(math.pi/4*(diameter*self.d)**2 if self.dim == 2
                             else math.pi/6*(diameter*self.d)**3)

    def furnish(self):
        r, s = self.r, self.scale
        self.floor = 0      # above the obstacles
        if self.inside == 'hopper':
            self.bottom, self.rim, self.gap = 0.2*self.nz, 0.5*self.nz, r.uniform(2.5, 5)
            self.floor = self.rim
        elif self.inside != 'none':
            self.width, self.height, self.at = (r.uniform(2, 3)*s,
                                                r.uniform(2, 5 if self.dim == 2 else 3)*s,
                                                r.uniform(0.3, 0.7)*self.nx)
            self.floor = self.height + (0.5*self.width if self.inside == 'cylinder' else 0)
        columns = 3 if self.dim == 2 else 2
        width = self.nx/columns
        for k in range(columns):
            kind = (r.choice(['fill', 'block']) if k == 0
                    else r.choice(['fill', 'block', 'bonded', 'rigid', 'clumps', 'ball']))
            low, high = k*width + 0.6, (k + 1)*width - 0.6
            z = self.floor + r.uniform(0.7, 2)
            v = (0, 0, 0)
            if self.speed:
                angle = r.uniform(0, 2*math.pi)
                v = (self.speed*math.cos(angle), 0 if self.dim == 2
                     else self.speed*r.uniform(-0.3, 0.3), self.speed*math.sin(angle))
            getattr(self, kind)(k, low, high, z, v)

    def region(self, k, low, high, z, top, v, entries, deep=True):
        """One of the columns, across the tank or in its middle"""
        y = ((0.6, self.ny - 0.6) if deep
             else (0.5*self.ny - 0.5*(high - low), 0.5*self.ny + 0.5*(high - low)))
        if self.dim == 2:
            y = (0, 1)
        box = ' '.join('(%.9g %.9g %.9g)' % tuple(x*self.d for x in c)
                       for c in ((low, y[0], z), (high, y[1], top)))
        self.regions.append('r%d { set solids; source box; box %s; velocity (%g %g %g); '
                            'material stone; %s }' % ((k, box) + v + (entries,)))

    def fill(self, k, low, high, z, v):
        top = min(self.nz - 0.6, z + self.r.uniform(6, 12)*self.scale)
        largest = self.r.choice([1, 1.4, 2])
        self.region(k, low, high, z, top, v,
                    'packing random; radius %.9g; largestRadius %.9g; solidFraction %g; seed %d;'
                    % (0.5*self.d, 0.5*largest*self.d, self.r.uniform(0.4, 0.7) if self.dim == 2
                       else self.r.uniform(0.15, 0.3), k + 1))

    def block(self, k, low, high, z, v):
        packing = self.r.choice(['square', 'hexagonal', 'layers'])
        top = min(self.nz - 0.6, z + self.r.uniform(4, 9)*self.scale)
        self.region(k, low, high, z, top, v, 'radius %.9g; packing %s;' % (0.5*self.d, packing))

    def bonded(self, k, low, high, z, v):
        self.groups.append('g%d { }' % k)
        self.bonds = self.r.choice(['whole', 'breaks'])
        self.region(k, low, low + min(5*self.scale, high - low), z, z + 3.01*self.scale, v,
                    'radius %.9g; packing square; group g%d;' % (0.5*self.d, k))
        self.outlines.append('bonds%d { type cement; groups (g%d); gapTolerance %g; }'
                             % (k, k, 1e-3*self.d))

    def rigid(self, k, low, high, z, v):
        a = min(self.r.uniform(2.2, 4)*self.scale, high - low,
                self.ny - 1.2 if self.dim == 3 else 99)
        density = self.density*self.r.choice([0.3, 1, 3])
        size = (a*self.d)**self.dim
        self.heaviest = max(self.heaviest, density*size)
        self.region(k, low, low + a, z, z + a, v,
                    'spacing %.9g; rigid yes; density %g;' % (self.d, density), False)

    def clumps(self, k, low, high, z, v):
        a = min(self.r.uniform(2, 3)*self.scale, 0.5*(high - low),
                0.5*self.ny if self.dim == 3 else 99)
        x = 0.5*(low + high)
        middle = [(x, 0.5*self.ny, h)
                  for h in (min(z + 0.6*a, self.nz - 0.6*a), min(z + 1.8*a, self.nz - 0.6*a))]
        centres = ' '.join('(%.9g %.9g %.9g)' % tuple(q*self.d for q in c)
                           for c in middle[:2 if middle[1][2] - middle[0][2] > 1.1*a else 1])
        shape = ('source clumpsFromSurface; file "body.stl"; scale %.9g;' % (0.5*a*self.d)
                 if self.dim == 3 else 'source clumpsFromOutline; outline (%s);' % ' '.join(
                     '(%.9g 0 %.9g)' % (0.5*a*self.d*p, 0.5*a*self.d*q) for p, q in self.polygon()))
        self.heaviest = max(self.heaviest, self.density*(a*self.d)**self.dim)
        self.regions.append('r%d { set solids; %s centres (%s); orientation random; seed %d; '
                            'smallestRadius %.9g; material stone; velocity (%g %g %g); }'
                            % ((k, shape, centres, k + 1, 0.25*self.d) + v))

    def polygon(self):
        corners = self.r.randint(3, 6)
        return [(math.cos(2*math.pi*c/corners + 0.3), math.sin(2*math.pi*c/corners + 0.3))
                for c in range(corners)]

    def ball(self, k, low, high, z, v):
        a = self.r.uniform(1, 3)
        self.heaviest = max(self.heaviest, self.mass(a))
        x, y, h = 0.5*(low + high)*self.d, 0.5*self.ny*self.d, (z + 0.5*a)*self.d
        ends = ' '.join('%s (%.9g %.9g %.9g);' % (name, x, y + sign*self.d, h)
                        for name, sign in (('p1', -1), ('p2', 1)))
        shape = 'source cylinder; %s radius %.9g;' % (ends, 0.5*a*self.d) if self.dim == 2 else \
            'source sphere; centre (%.9g %.9g %.9g); radius %.9g;' % (x, y, h, 0.5*a*self.d)
        self.regions.append('r%d { set solids; %s particleRadius %.9g; velocity (%g %g %g); '
                            'spin (0 %g 0); material stone; }'
                            % ((k, shape, 0.5*a*self.d) + v + (self.r.choice([0, 50]),)))

    # * * * how it acts

    def laws(self):
        """Stiffness for an overlap in the hardest impact there can be, and a time for two crossings
        of the tank or as many steps as one can wait for"""
        r, d = self.r, self.d
        self.normal = r.choice(['hertz', 'hertz', 'linear', 'incremental'])
        self.tangential = r.choice(['history', 'history', 'none', 'oneStep'])
        self.rolling = ('none' if self.tangential == 'none'
                        else r.choice(['none', 'none', 'constantTorque', 'spring']))
        fall = math.sqrt(2*self.g*math.hypot(self.nx, self.nz)*d)
        self.fastest = math.hypot(self.speed, fall) + 0.1
        overlap = r.choice([0.005, 0.015, 0.04, 0.1, 0.25])*d
        # a body lands on several of its members, and seldom on one
        mass = math.sqrt(self.heaviest*self.mass(1))
        k = mass*(self.fastest/overlap)**2
        self.E = 15*mass*self.fastest**2/(16*math.sqrt(0.25*d)*overlap**2.5)*2*(1 - 0.25**2)
        if self.normal == 'hertz':
            k = 2*self.E/(2*(1 - 0.25**2))*math.sqrt(0.25*d*overlap)
        self.k = k
        step = 0.1*math.sqrt(self.mass(1)/k)
        self.end = min(2*self.nz*d/max(self.fastest/2, 0.3*math.sqrt(9.81*self.nz*d)),
                       6000*step if self.dim == 2 else 3000*step)

    def floorPotential(self):
        """Potential of a unit mass in the lowest corner of the tank [m2/s2]"""
        g = self.gravity()
        return min(-sum(a*x for a, x in zip(g, (X, Y, Z))) for X in (0, self.nx*self.d)
                   for Y in (0, self.ny*self.d) for Z in (0, self.nz*self.d))

    def gravity(self):
        return (self.g*math.sin(self.tilt), 0, -self.g*math.cos(self.tilt))

    def lost(self, x):
        """How many of these positions (n, 3) [m] are outside the tank, in an obstacle, or outside
        of the hopper above its mouth"""
        d = self.d
        X, Y, Z = (x[:, k]/d for k in range(3))
        out = (X < 0) | (X > self.nx) | (Z < 0) | (Z > self.nz)
        if self.dim == 3:
            out |= (Y < 0) | (Y > self.ny)
        if self.inside == 'box':
            out |= (X > self.at) & (X < self.at + self.width) & (Z < self.height)
        elif self.inside == 'cylinder':
            out |= (X - self.at)**2 + (Z - self.height)**2 < (0.5*self.width)**2
        return int(out.sum())

    # * * * files

    def files(self, folder):
        d = self.d
        L, W, H = self.nx*d, self.ny*d, self.nz*d
        sides = ('sides { type %s; faces ((0 1 5 4) (3 7 6 2)); }\n'
                 % ('wall' if self.dim == 3 else 'empty'))
        write(folder, 'system', 'blockMeshDict',
              'scale 1;\nvertices ((0 0 0) (%g 0 0) (%g %g 0) (0 %g 0) (0 0 %g) (%g 0 %g) '
              '(%g %g %g) (0 %g %g));\n'
              % (L, L, W, W, H, L, H, L, W, H, W, H) +
              'blocks (hex (0 1 2 3 4 5 6 7) (%d %d %d) simpleGrading (1 1 1));\nedges ();\n'
              'boundary\n(\n' % self.r.choice([(1, 1, 1), (3, 1, 2)]) +
              'floor { type wall; faces ((0 3 2 1)); } ends { type wall; faces ((0 4 7 3) '
              '(1 2 6 5)); } lid { type wall; faces ((4 5 6 7)); }\n' + sides +
              ');\nmergePatchPairs ();\n')
        bonds = 'bonds ( %s );\n' % ' '.join(self.outlines) if self.outlines else ''
        write(folder, 'system', 'setParticlesDict',
              'regions\n(\n%s\n);\n%s' % ('\n'.join(self.regions), bonds))
        write(folder, 'constant', 'g', 'dimensions [0 1 -2 0 0 0 0];\nvalue (%g %g %g);\n'
              % self.gravity(), 'uniformDimensionedVectorField')
        self.geometry(folder)
        write(folder, 'constant', 'solidProperties', self.properties())
        sample = float('%.3g' % (self.end/40))
        write(folder, 'system', 'controlDict',
              'application riprapFoam;\nsolver dem;\nstartFrom latestTime;\nstartTime 0;\n'
              'stopAt endTime;\nendTime %.8g;\n'
              'deltaT 1e-5;\nadjustTimeStep yes;\nsampleInterval %.8g;\n'
              'writeControl adjustableRunTime;\nwriteInterval %.8g;\nwriteFormat binary;\n'
              'writePrecision 10;\ntimeFormat general;\ntimePrecision 8;\nrunTimeModifiable no;\n'
              'functions\n{\n'
              'energy { type solidEnergies; libs ("libriprapFoam.so"); }\n'
              'forces { type solidWallForce; libs ("libriprapFoam.so"); }\n}\n'
              % (40*sample, sample, 20*sample))
        write(folder, 'system', 'fvSchemes',
              'ddtSchemes {}\ngradSchemes {}\ndivSchemes {}\nlaplacianSchemes {}\n'
              'interpolationSchemes {}\nsnGradSchemes {}\n')

    def properties(self):
        r = self.r
        friction = r.choice([0, 0.2, 0.5, 1])
        pair = 'restitution %.3g; friction %g; stiffness %.6g; rollingFriction %g;' % (
            r.choice([1, 0.9, 0.5, 0.1]), friction, self.k, r.choice([0.02, 0.2]))
        cement = ''
        if self.outlines:
            per = self.k/3/(1 if self.dim == 2 else math.pi*self.d/4)
            strength = ('tensileStrength %.6g; shearStrength %.6g;' % (0.02*per, 0.02*per)
                        if self.bonds == 'breaks' else '')
            cement = ('bonds { cement { calibration moduli; E %.6g; G %.6g; dampingRatio %g; %s } '
                      '}\n' % (per, 0.4*per, r.choice([0, 0.05]), strength))
        integration = r.choice(['leapfrog', 'leapfrog', 'velocityVerlet'])
        return ('device cpu;\nprecision %s;\ncontact { normal %s; tangential %s; rolling %s; }\n'
                'materials { stone { rho %g; E %.6g; nu 0.25; } }\n'
                'pairs { default { %s } }\nwalls { material stone; }\ngroups { %s }\n'
                '%stimeIntegration %s;\n'
                % (r.choice(['mixed', 'double']), self.normal, self.tangential, self.rolling,
                   self.density, self.E, pair, ' '.join(self.groups), cement, integration))

    def geometry(self, folder):
        d, W = self.d, self.ny*self.d
        far = (-W, 2*W)
        if self.inside == 'hopper':
            self.stl(folder, 'hopper', self.funnel())
            write(folder, 'constant', 'geometry',
                  'hopper { type triSurfaceMesh; file "hopper.stl"; }\n')
        elif self.inside == 'box':
            write(folder, 'constant', 'geometry',
                  'block { type searchableBox; min (%g %g %g); max (%g %g %g); }\n' % (
                      self.at*d, far[0], -0.5*d, (self.at + self.width)*d, far[1], self.height*d))
        elif self.inside == 'cylinder':
            write(folder, 'constant', 'geometry', 'pipe { type searchableCylinder; point1 (%g %g '
                                                  '%g); point2 (%g %g %g); radius %g; }\n' % (
                                                      self.at*d, far[0], self.height*d, self.at*d,
                                                      far[1], self.height*d, 0.5*self.width*d))
        elif self.inside == 'plate':
            write(folder, 'constant', 'geometry',
                  'plate { type searchablePlate; origin (%g %g 0); span (0 %g %g); }\n' % (
                      self.at*d, far[0], 3*W, self.height*d))
        if any('body.stl' in region for region in self.regions):
            up = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]
            self.stl(folder, 'body', [(up[k], up[(k + 1) % 4], (0, 0, 1)) for k in range(4)]
                     + [(up[(k + 1) % 4], up[k], (0, 0, -1)) for k in range(4)])

    def funnel(self):
        """Two or four plates from the walls down to the mouth"""
        d = self.d
        x0, x1 = 0.5*(self.nx - self.gap)*d, 0.5*(self.nx + self.gap)*d
        L, W, top, low = self.nx*d, self.ny*d, self.rim*d, self.bottom*d
        if self.dim == 2:
            quads = [((0, -W, top), (0, 2*W, top), (x0, 2*W, low), (x0, -W, low)),
                     ((L, -W, top), (L, 2*W, top), (x1, 2*W, low), (x1, -W, low))]
        else:
            y0, y1 = 0.5*(self.ny - self.gap)*d, 0.5*(self.ny + self.gap)*d
            rim = [(0, 0, top), (L, 0, top), (L, W, top), (0, W, top)]
            mouth = [(x0, y0, low), (x1, y0, low), (x1, y1, low), (x0, y1, low)]
            quads = [(rim[k], rim[(k + 1) % 4], mouth[(k + 1) % 4], mouth[k]) for k in range(4)]
        return [t for p, q, u, v in quads for t in ((p, q, u), (p, u, v))]

    @staticmethod
    def stl(folder, name, triangles):
        os.makedirs(os.path.join(folder, 'constant', 'triSurface'), exist_ok=True)
        with open(os.path.join(folder, 'constant', 'triSurface', name + '.stl'), 'w') as f:
            f.write('solid %s\n' % name)
            for t in triangles:
                f.write('facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n'
                        % ''.join('vertex %.9g %.9g %.9g\n' % p for p in t))
            f.write('endsolid %s\n' % name)


def main():
    DemScene(int(sys.argv[1]), int(sys.argv[3]) if len(sys.argv) > 3 else 1).files(sys.argv[2])


if __name__ == '__main__':
    main()
