# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear potential flow in a tank, 0 < x < L, -h < z < 0, that sways by X(t)

    Phi = X' x + sum a_n cos(k_n x) cosh(k_n (z + h))/cosh(k_n h),
    eta = sum b_n cos(k_n x), k_n = n pi/L
    x - L/2 = sum c_n cos(k_n x),  c_n = -4/(L k_n^2) for odd n, else 0
    b_n' = a_n k_n tanh(k_n h),  a_n' = -g b_n - c_n X'' (surface: eta_t = Phi_z, Phi_t + g eta = 0)

Faltinsen, J. Ship Res. 18 (1974) 224 and 22 (1978) 193 have the same. Odd modes alone: the level is
antisymmetric about the middle, and the waves' own second order, symmetric, is not in the half
difference of two sides.
"""
import numpy as np

g = 9.81
modes = np.arange(1, 40, 2)


class Sway:
    """X = A s(t/T) sin(omega t), s(u) = u^2 (3 - 2 u) until u = 1, then 1; T = 2 pi/omega"""

    def __init__(self, amplitude, ratio, left, right, depth):
        self.A, self.L, self.h = amplitude, right - left, depth
        self.k = modes*np.pi/self.L
        self.natural = np.sqrt(g*self.k*np.tanh(self.k*depth))
        self.omega = ratio*self.natural[0]
        self.c = -4/(self.L*self.k**2)

    def place(self, t):
        return self.derivatives(t)[0]

    def derivatives(self, t):
        """X and X'' """
        w = self.omega
        T = 2*np.pi/w
        u = np.minimum(np.asarray(t)/T, 1)
        s, ds, dds = u*u*(3 - 2*u), 6*u*(1 - u)/T, np.where(u < 1, 6*(1 - 2*u)/T**2, 0)
        sin, cos = np.sin(w*np.asarray(t)), np.cos(w*np.asarray(t))
        return self.A*s*sin, self.A*(dds*sin + 2*ds*w*cos - s*w*w*sin)

    def solve(self, t):
        """b_n at the times t, a row a time"""
        return integrate(self.natural, -self.c*self.k*np.tanh(self.k*self.h),
                         lambda at: self.derivatives(at)[1], t)

    def level(self, b, x):
        """eta at x (from the left wall), a value a time"""
        return np.sum(b*np.cos(np.multiply.outer(x, self.k)), axis=-1)

    def wallPressure(self, b, t, z):
        """Half of the left wall's excess over the right one's, over rho"""
        C = np.cosh(self.k*(z + self.h))/np.cosh(self.k*self.h)
        return np.sum(b*C, axis=-1)*g - self.derivatives(t)[1]*np.sum(self.c*(1 - C))


def integrate(natural, force, acceleration, t, step=1e-3):
    """b'' + natural^2 b = force*acceleration(t) from rest: each mode exactly, the acceleration
    linear over a step"""
    b, v, out, now = np.zeros_like(natural), np.zeros_like(natural), [], 0.0
    for at in t:
        n = max(1, int(np.ceil((at - now)/step)))
        dt = (at - now)/n
        w, cos, sin = natural, np.cos(natural*dt), np.sin(natural*dt)
        for k in range(n if dt > 0 else 0):
            f0, f1 = (force*acceleration(now + (k + j)*dt) for j in (0, 1))
            slope = (f1 - f0)/dt
            # particular solution (f0 + slope tau)/w^2
            p, q = b - f0/w**2, (v - slope/w**2)/w
            b, v = p*cos + q*sin + f1/w**2, w*(q*cos - p*sin) + slope/w**2
        now = at
        out.append(b)
    return np.array(out)


def check():
    """Largest error of integrate over a closed form: X'' = cos(w t), b = force (cos w t - cos
    natural t)/(natural^2 - w^2)"""
    natural, w, t = np.array([5.3, 11.0]), 4.3, np.linspace(0, 8, 81)
    b = integrate(natural, np.ones(2), lambda at: np.cos(w*at), t)
    exact = (np.cos(w*t)[:, None] - np.cos(np.multiply.outer(t, natural)))/(natural**2 - w**2)
    return float(np.abs(b - exact).max()/np.abs(exact).max())
