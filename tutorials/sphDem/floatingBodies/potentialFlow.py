# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear potential flow about a circle or a sphere that heaves in a tank: a cylinder between plane
walls, or a sphere in a round tank

    Laplace phi = 0;  walls and bottom: phi_n = 0;  body: phi_n = V n_y
    free surface: eta_t = phi_y, phi_t = -g eta
    body: M x'' = -C x - rho int phi_t n_y dS

phi_t solves the same problem with -g eta on the surface and x'' n_y on the body, so that the force
is f.eta - a x'', a the added mass of instants (infinite frequency). Sources stand a little outside
the fluid (Cao, Schultz & Beck 1991, Int. J. Numer. Meth. Fluids 12, 785): pairs of lines mirrored
at x = 0, or rings. What is solved is the tank at hand, with its bottom and its reflections, about
the body's rest position.

    potentialFlow.py        compares with known added masses and periods
"""
import numpy as np

g = 9.81


def elliptic(m):
    """Complete elliptic integrals K(m), E(m) by the arithmetic-geometric mean"""
    a, b = np.ones_like(m), np.sqrt(1 - m)
    s, power = 0.5*m, 0.5
    for _ in range(12):
        a, b, c = 0.5*(a + b), np.sqrt(a*b), 0.5*(a - b)
        power *= 2
        s = s + power*c*c
    K = np.pi/(2*a)
    return K, K*(1 - s)


def linePair(x, y, u, v):
    """Potential of unit lines at (u, v) and (-u, v), and its gradient"""
    p = q = r = 0
    for w in (u, -u):
        d2 = (x - w)**2 + (y - v)**2
        p, q, r = p + 0.5*np.log(d2), q + (x - w)/d2, r + (y - v)/d2
    return p, q, r


def ring(x, y, u, v):
    """Potential of a ring of radius u at height v, -1/r summed around it, and its gradient"""
    s = (x + u)**2 + (y - v)**2
    t = (x - u)**2 + (y - v)**2
    K, E = elliptic(np.clip(4*x*u/s, 0, 1 - 1e-14))
    root = np.sqrt(s)
    byX = 2*u/root*((x*x - u*u - (y - v)**2)/t*E + K)/np.maximum(x, 1e-12)
    return -4*u*K/root, byX, 4*u*(y - v)*E/(root*t)


class Body:
    """A circle of radius R whose part below the level is the share `density` of it; centre at
    height `centre` above the level"""

    def __init__(self, R, density, dimensions):
        self.R, self.density, self.dimensions = R, density, dimensions
        self.volume = np.pi*R*R if dimensions == 2 else 4*np.pi*R**3/3
        self.mass = density*self.volume         # over the water's density
        low, high = -R, R
        for _ in range(60):
            middle = 0.5*(low + high)
            low, high = ((middle, high) if self.immersed(middle) > density*self.volume
                         else (low, middle))
        self.centre = 0.5*(low + high)
        half2 = max(R*R - self.centre**2, 0)
        self.waterplane = 2*np.sqrt(half2) if dimensions == 2 else np.pi*half2

    def immersed(self, centre):
        R, h = self.R, np.clip(self.R - centre, 0, 2*self.R)       # draught
        if self.dimensions == 3:
            return np.pi*h*h*(3*R - h)/3
        return R*R*np.arccos(1 - h/R) - (R - h)*np.sqrt(max(2*R*h - h*h, 0))


def panels(corners, counts, outward):
    """Middles, lengths and ends of straight panels along a polyline; normals to the left of it
    where outward is 1"""
    points = [np.array(corners[0], float)]
    for a, b, n in zip(corners, corners[1:], counts):
        points += [np.asarray(a) + (np.asarray(b) - np.asarray(a))*k/n for k in range(1, n + 1)]
    return fromPoints(np.array(points), outward)


def fromPoints(points, outward):
    along = np.diff(points, axis=0)
    length = np.hypot(*along.T)
    normal = outward*np.column_stack([-along[:, 1], along[:, 0]])/length[:, None]
    return 0.5*(points[1:] + points[:-1]), length, normal


class Tank:
    """Half-width (or radius) W, depth H of the water with the body at its place, centre at height
    `centre` above the level"""

    def __init__(self, body, W, H, centre=None, size=None):
        self.body = body
        c = body.centre if centre is None else centre
        R, size = body.R, size or body.R/16
        floating = abs(c) < R
        # angle from straight down to the level
        end = np.arccos(c/R) if floating else np.pi
        n = max(int(round(R*end/size)), 8)
        # shorter towards the waterline, where the flow has a corner
        angle = end*(np.sin(np.linspace(0, np.pi/2, n + 1)) if floating
                     else np.linspace(0, 1, n + 1))
        hull = fromPoints(np.column_stack([R*np.sin(angle), c - R*np.cos(angle)]), 1)
        start = R*np.sin(end) if floating else 0
        m = int(round((W - start)/size))
        s = np.linspace(0, 1, m + 1)
        s = s if not floating else s + 0.6*np.sin(np.pi*s)/np.pi*(s - 1)
        surface = fromPoints(np.column_stack([start + (W - start)*s, 0*s]), 1)
        coarse = 1.5*size
        rest = panels([(W, 0), (W, -H), (0, -H)], [int(H/coarse), int(W/coarse)], 1)
        self.nSurface, self.nHull = len(surface[0]), len(hull[0])
        middle, self.length, self.normal = (np.concatenate(a) for a in zip(surface, hull, rest))
        self.x, self.y = middle.T
        self.solve(1.5)

    def solve(self, offset):
        S, B = slice(0, self.nSurface), slice(self.nSurface, self.nSurface + self.nHull)
        source = np.column_stack([self.x, self.y]) + offset*self.length[:, None]*self.normal
        # away from the axis: a ring of no radius has no source
        source[:, 0] = np.maximum(source[:, 0], 0.25*self.length)
        kernel = linePair if self.body.dimensions == 2 else ring
        phi, byX, byY = kernel(self.x[:, None], self.y[:, None], source[None, :, 0],
                               source[None, :, 1])
        rows = self.normal[:, :1]*byX + self.normal[:, 1:]*byY
        rows[S] = phi[S]
        inverse = np.linalg.inv(rows)
        ny = self.normal[B, 1]
        self.rise = byY[S] @ inverse[:, S]                      # eta_t = rise phi + lift V
        self.lift = byY[S] @ inverse[:, B] @ ny
        around = 2 if self.body.dimensions == 2 else 2*np.pi*self.x[B]
        area = around*self.length[B]*ny
        self.added = float(area @ phi[B] @ inverse[:, B] @ ny)  # over the water's density
        self.push = g*area @ phi[B] @ inverse[:, S]             # force by the surface's height

    def heave(self, amplitude, end, steps=4000):
        """Height of the body over its rest after it was let go: times, heights"""
        n, M, C = self.nSurface, self.body.mass, g*self.body.waterplane

        def rate(s):
            phi, eta, x, V = s[:n], s[n:2*n], s[-2], s[-1]
            return np.concatenate([-g*eta, self.rise @ phi + self.lift*V,
                                   [V, (self.push @ eta - C*x)/(M + self.added)]])
        dt = end/steps
        s = np.zeros(2*n + 2)
        s[-2] = amplitude
        heights = [amplitude]
        for _ in range(steps):
            k1 = rate(s)
            k2 = rate(s + 0.5*dt*k1)
            k3 = rate(s + 0.5*dt*k2)
            k4 = rate(s + dt*k3)
            s = s + dt/6*(k1 + 2*k2 + 2*k3 + k4)
            heights.append(s[-2])
        return np.linspace(0, end, steps + 1), np.array(heights)


def firstSwing(t, x):
    """Time from the release to the first turn on the same side: one period of heave. None where
    there is none"""
    rising = np.diff(x) > 0
    turns = np.nonzero(rising[1:] != rising[:-1])[0] + 1
    return t[turns[1]] if len(turns) > 1 else None


def main():
    # half-immersed in a tank that is wide and deep: half of the added mass of the doubled body
    # without a surface
    for dimensions, exact, name in ((2, np.pi/2, 'cylinder'), (3, np.pi/3, 'sphere')):
        tank = Tank(Body(1, 0.5, dimensions), 30, 20, size=1/12)
        print(f'{name}: added mass of instants {tank.added:.4f} rho R^{dimensions}, '
              f'exact {exact:.4f}')
        t, x = tank.heave(1, 20/np.sqrt(g))
        print(f'    first swing {firstSwing(t, x)*np.sqrt(g):.3f} sqrt(R/g)')
    deep = Tank(Body(1, 1.2, 2), 30, 40, centre=-20, size=1/8)
    print(f'cylinder deep in water: {deep.added:.4f} rho R^2, exact {np.pi:.4f}')


if __name__ == '__main__':
    main()
