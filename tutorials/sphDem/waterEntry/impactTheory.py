# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity of a body that enters water: momentum with the added mass m(s) that a published slamming
force stands for

    F = V^2 dm/ds at constant velocity;  d/dt[(M + m) V] = M g - rho g A(s)

s is the depth of the lowest point under the still water, A the area or volume of the body below it.

    wedge       F = C rho V^2 s, C of the similarity solution: Zhao & Faltinsen (1993), J. Fluid
                Mech. 246, 593, table 1
    cylinder    F = rho R V^2 Cs, Cs = 5.15 [D/(D + 19 s) + 0.107 s/D]: Campbell & Peyrard (1980),
                measured; as in DNV-RP-C205
    sphere      F = rho pi R^2 V^2 Cs/2, Cs = 5.50 b^0.5 - 4.19 b - 4.26 b^1.5, b = s/R: Miloh
                (1991), Appl. Ocean Res. 13, 34
"""
import numpy as np

g = 9.81
# deadrise [degrees], height of the pressure's peak over the still water / (V t), F/(rho V^3 t)
similarity = np.array([(20, 0.5087, 42.485), (25, 0.4709, 23.657), (30, 0.4243, 14.139),
                       (40, 0.2866, 5.477)])


class Wedge:
    def __init__(self, halfBreadth, deadrise):
        row = similarity[similarity[:, 0] == round(deadrise)]
        if len(row) == 0:
            raise ValueError(f'no similarity solution at hand for {deadrise} degrees, '
                             f'but for {similarity[:, 0]}')
        (_, rise, self.coefficient), = row
        self.slope = np.tan(np.radians(deadrise))
        self.volume = halfBreadth**2*self.slope
        # of the reference point over the lowest one
        self.lowest = 0
        # the peak of the pressure is at the edge: the flow separates
        self.end = halfBreadth*self.slope/(1 + rise)

    def added(self, s):
        return 0.5*self.coefficient*s**2

    def immersed(self, s):
        return s**2/self.slope


class Cylinder:
    def __init__(self, R):
        self.R, self.volume, self.end = R, np.pi*R*R, R

    def added(self, s):
        D = 2*self.R
        return self.R*5.15*D*(np.log(1 + 19*s/D)/19 + 0.0535*(s/D)**2)

    def immersed(self, s):
        h = np.clip(1 - s/self.R, -1, 1)
        return self.R**2*(np.arccos(h) - h*np.sqrt(1 - h*h))


class Sphere:
    def __init__(self, R):
        self.R, self.volume, self.end = R, 4*np.pi*R**3/3, 0.3*R

    def added(self, s):
        b = s/self.R
        return 0.5*np.pi*self.R**3*(11/3*b**1.5 - 2.095*b**2 - 1.704*b**2.5)

    def immersed(self, s):
        return np.pi*s**2*(self.R - s/3)


def entry(shape, ratio, V, steps=4000):
    """Depths and velocities from the touch at velocity V; ratio: the body's density over the
    water's"""
    s = np.linspace(0, shape.end, steps + 1)
    M = ratio*shape.volume
    m = shape.added(s)
    # P = (M + m) V:  dP/ds = (M - A) g/V
    P, v = np.empty_like(s), np.empty_like(s)
    P[0], v[0] = M*V, V
    for k in range(steps):
        mid = P[k] + 0.5*(s[k + 1] - s[k])*(M - shape.immersed(s[k]))*g/v[k]
        sm = 0.5*(s[k] + s[k + 1])
        P[k + 1] = P[k] + (s[k + 1] - s[k])*(M - shape.immersed(sm))*g*(M + shape.added(sm))/mid
        v[k + 1] = P[k + 1]/(M + m[k + 1])
    return s, v


def logvinovich(deadrise, points=200001):
    """F/(rho V^3 t) of a wedge by Korobkin's modified Logvinovich model (Euro. J. Appl. Math. 15
    (2004) 683), with Wagner's wetted half breadth c = pi h/(2 tan beta): p/(rho V^2) = c'/cos a -
    1/(2 cos^2 a (1 + f'^2)) - f'^2/(2 (1 + f'^2)), x = c sin a, f' = tan beta, where p > 0"""
    slope = np.tan(np.radians(deadrise))
    growth = 0.5*np.pi/slope
    a = np.linspace(0, 0.5*np.pi, points)[:-1]
    p = growth/np.cos(a) - 0.5/(np.cos(a)**2*(1 + slope**2)) - 0.5*slope**2/(1 + slope**2)
    values = np.where(p > 0, p, 0)*growth*np.cos(a)
    return float(np.sum(values[1:] + values[:-1])*(a[1] - a[0]))


def check():
    """Errors: entry() over the closed form of a wedge, (M + m)^2 V^2 = M^2 V0^2 + 2 g int (M - A)(M
    + m) ds with A = a s^2, m = b s^2; and of the similarity table at 20 degrees over the modified
    Logvinovich model, which at steeper deadrise is too high (Korobkin 2004)"""
    shape, ratio, V = Wedge(0.6, 25), 0.4666, 5.05
    s, v = entry(shape, ratio, V)
    M, a, b = ratio*shape.volume, 1/shape.slope, 0.5*shape.coefficient
    integral = M*M*s + M*(b - a)*s**3/3 - a*b*s**5/5
    exact = np.sqrt(M*M*V*V + 2*g*integral)/(M + b*s*s)
    return float(np.abs(v/exact - 1).max()), abs(Wedge(1, 20).coefficient/logvinovich(20) - 1)
