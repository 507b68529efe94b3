# SPDX-License-Identifier: GPL-3.0-or-later
"""A rectangle that floats on water of finite depth: added mass and damping of heave and roll by
linear potential theory, and its free decay

Eigenfunctions under the body and beside it, matched at its sides (Black, Mei & Bray 1971, J. Fluid
Mech. 46, 151; heave also Lee 1995, Ocean Eng. 22, 19). x is across, z up from the surface, b half
the width, T the draught, h the depth, s = h - T. For e^{iwt} and unit velocity

    under it    heave: ((z + h)^2 - x^2)/(2 s) + A_0
                       + sum A_n cosh(n pi x/s)/cosh(n pi b/s) cos(n pi (z + h)/s)
                roll:  (x^3/3 - x (z + h)^2)/(2 s) + A_0 x/b
                       + sum A_n sinh(n pi x/s)/sinh(n pi b/s) cos(n pi (z + h)/s)
    beside it   sum C_m Y_m(z) e^{-a_m (x - b)}, a_0 = i k_0, a_m = k_m;
                w^2 = g k_0 tanh k_0 h = -g k_m tan k_m h

A + B/(iw) = -rho int phi N dS, N the normal velocity into the water. The damping is also what the
waves take away on either side, 2 rho w k_0 |C_0|^2.

A body let go at rest from z_0 does (Cummins 1962, by Fourier)
z(t)/z_0 = 2/pi int Re (iw (M + A) + B)/(C - w^2 (M + A) + iw B) cos wt dw.
"""
import functools

import numpy as np


@functools.lru_cache
def quadrature(points):
    return np.polynomial.legendre.leggauss(points)


class FloatingBox:
    """Per metre of length; axis: height above the surface of the axis about which it rolls"""

    def __init__(self, width, draught, depth, axis=0, density=1000, g=9.81, terms=40):
        self.b, self.T, self.h, self.axis, self.density, self.g, self.terms = (
            width/2, draught, depth, axis, density, g, terms)

    def wavenumbers(self, omega):
        """k_0, and k_m from 1 on"""
        nu, h = omega**2/self.g, self.h
        k = max(nu, np.sqrt(nu/h))
        for _ in range(60):
            t = np.tanh(k*h)
            k -= (k*t - nu)/(t + k*h*(1 - t*t))
        low = (np.arange(1, self.terms + 1) - 0.5)*np.pi
        high = low + 0.5*np.pi
        for _ in range(60):
            middle = 0.5*(low + high)
            inside = middle*np.tan(middle) + nu*h > 0
            low, high = np.where(inside, low, middle), np.where(inside, middle, high)
        return k, 0.5*(low + high)/h

    def solve(self, omega, roll=False):
        """Added mass and damping, and the damping that the waves tell"""
        b, h, s, N = self.b, self.h, self.h - self.T, self.terms
        k0, km = self.wavenumbers(omega)
        # Y_m = cos(k_m (z + h))/norm; of i k_0 the hyperbolic one
        k = np.concatenate([[1j*k0], km])
        norm = np.sqrt(h/2 + np.sin(2*k*h)/(4*k))
        alpha = k
        n = np.arange(N)
        q = n*np.pi/s
        # int over the gap of Y_m cos(q_n (z + h)): y = z + h from 0 to s
        kk, qq = np.meshgrid(k, q, indexing='ij')
        E = ((-1.0)**n*kk*np.sin(kk*s)/(kk**2 - qq**2))/norm[:, None]
        weight = np.where(n == 0, s, s/2)
        # particular solution at x = b: potential on the gap in cosines, and its slope
        y2 = np.where(n == 0, s**3/3, 2*s*(-1.0)**n/np.where(n == 0, 1, q)**2)     # int y^2 cos
        if roll:
            particular = (np.where(n == 0, b**3/3*s, 0) - b*y2)/(2*s)
            ratio = np.where(n == 0, 1/b, q/np.tanh(np.where(n == 0, 1, q*b)))
            # slope: (b^2 - y^2)/(2 s), and z - axis on the side
            slope = (self.gap(k, norm, s, lambda y: (b*b - y*y)/(2*s))
                     + self.side(k, norm, lambda y: y - h - self.axis))
        else:
            particular = (y2 - np.where(n == 0, b*b*s, 0))/(2*s)
            ratio = np.where(n == 0, 0, q*np.tanh(q*b))
            slope = self.gap(k, norm, s, lambda y: -b/s + 0*y)
        # C_m = -(slope + sum A_n ratio E)/alpha;  particular_n + A_n weight_n = sum C_m E_mn
        matrix = np.diag(weight).astype(complex) + (E/alpha[:, None]).T @ (E*ratio)
        A = np.linalg.solve(matrix, -(particular + (E/alpha[:, None]).T @ slope))
        C = -(slope + (E*ratio) @ A)/alpha
        if roll:
            # under it: the potential times x; N = x
            x3, x5 = 2*b**3/3, 2*b**5/5
            with np.errstate(over='ignore', divide='ignore', invalid='ignore'):
                odd = np.where(n == 0, x3/b,
                               2*(b/np.tanh(np.where(n == 0, 1, q*b))/np.where(n == 0, 1, q)
                                  - 1/np.where(n == 0, 1, q)**2))
            under = (x5/3 - x3*s*s)/(2*s) + np.sum(A*odd*(-1.0)**n)
            integral = -under - 2*np.sum(C*self.side(k, norm, lambda y: y - h - self.axis))
        else:
            even = np.where(n == 0, 2*b, 2*np.tanh(q*b)/np.where(n == 0, 1, q))
            integral = (2*b*s*s - 2*b**3/3)/(2*s) + np.sum(A*even*(-1.0)**n)
        waves = 2*self.density*omega*k0*abs(C[0])**2
        return self.density*integral.real, -self.density*omega*integral.imag, waves

    def gap(self, k, norm, s, f):
        return self.project(k, norm, 0, s, f)

    def side(self, k, norm, f):
        return self.project(k, norm, self.h - self.T, self.h, f)

    def project(self, k, norm, low, high, f):
        x, w = quadrature(200)
        y = low + (high - low)*0.5*(x + 1)
        return (np.cos(np.outer(k, y)) @ (f(y)*w))*(high - low)/2/norm

    def decay(self, times, mass, stiffness, roll=False, highest=30, count=300):
        """z/z_0 at these times after the body has been let go at rest; frequencies up to so many
        [rad/s]"""
        omega = highest*(np.arange(count) + 0.5)/count
        A, B, _ = np.array([self.solve(w, roll) for w in omega]).T
        Z = (1j*omega*(mass + A) + B)/(stiffness - omega**2*(mass + A) + 1j*omega*B)
        # beyond: Z = 1/(iw) + ..; its cosine transform's tail is left out, as it is in the part
        # from zero: both are made one at t = 0
        z = 2/np.pi*(np.cos(np.outer(times, omega)) @ Z.real)*(omega[1] - omega[0])
        return z/(2/np.pi*Z.real.sum()*(omega[1] - omega[0]))

    def heave(self, times, **more):
        return self.decay(times, self.density*2*self.b*self.T, self.density*self.g*2*self.b, **more)

    def roll(self, times, inertia, centre, **more):
        """centre: height of the centre of mass above the surface; the axis goes through it"""
        b, T = self.b, self.T
        stiffness = self.density*self.g*(2*b**3/3 + 2*b*T*(-T/2 - centre))
        return self.decay(times, inertia, stiffness, roll=True, **more)
