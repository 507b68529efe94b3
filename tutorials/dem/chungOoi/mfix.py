# SPDX-License-Identifier: GPL-3.0-or-later
"""MFIX's verification DEM01-DEM05: linear springs with dashpots in closed form, and Kharaz's
impacts"""
import math

import numpy as np

from riprap.bounds import Quantity
from riprap.dictionaries import numberOf
from spheres import records, rms, spheres

g = 9.80665                     # MFIX's


def dashpot(e, m, k):
    """c of a spring-dashpot with restitution e"""
    ln = math.log(e)
    return -2*ln*math.sqrt(m*k/(math.pi**2 + ln*ln)) if e < 1 else 0.0


class Drop:
    """A sphere that falls from y0 on a spring-dashpot, in closed form: phases of flight and contact
    in turn, each (start, y, v) with a function of the time since"""

    def __init__(self, radius, m, k, e, y0, bounces):
        self.radius = radius
        self.w0, self.beta = math.sqrt(k/m), dashpot(e, m, k)/(2*m)
        self.w = math.sqrt(self.w0**2 - self.beta**2)
        self.phases, self.peaks = [], [y0]
        t, v = math.sqrt(2*(y0 - radius)/g), -math.sqrt(2*g*(y0 - radius))
        self.phases.append((0.0, y0, 0.0, False))
        for _ in range(bounces):
            self.phases.append((t, radius, v, True))
            end = self.contactEnd(v)
            if end is None:                             # it stays on its spring
                return
            v = self.contact(end, v)[1]
            t += end
            self.phases.append((t, radius, v, False))
            self.peaks.append(radius + v*v/(2*g))
            t, v = t + 2*v/g, -v

    def contact(self, s, v):
        """y, v at s after first touch with the velocity v: damped oscillation about -g/w0^2"""
        rest = -g/self.w0**2
        a, b = -rest, (v - self.beta*rest)/self.w
        decay = np.exp(-self.beta*s)
        c, d = np.cos(self.w*s), np.sin(self.w*s)
        y = rest + decay*(a*c + b*d)
        return self.radius + y, decay*((b*self.w - self.beta*a)*c - (a*self.w + self.beta*b)*d)

    def contactEnd(self, v):
        s = np.linspace(0, 2*math.pi/self.w, 4001)[1:]
        above = np.flatnonzero(self.contact(s, v)[0] > self.radius)
        if not len(above):
            return None
        i = above[0]
        low, high = s[i - 1] if i else s[0]/2, s[i]
        for _ in range(60):
            middle = (low + high)/2
            low, high = ((low, middle) if self.contact(middle, v)[0] > self.radius
                         else (middle, high))
        return high

    def at(self, t):
        """y, v at the times t"""
        starts = np.array([p[0] for p in self.phases])
        y, v = np.empty(len(t)), np.empty(len(t))
        which = np.searchsorted(starts, t, side='right') - 1
        for i in set(which):
            start, y0, v0, touching = self.phases[i]
            here, s = which == i, t[which == i] - starts[i]
            y[here], v[here] = self.contact(s, v0) if touching else (y0 + v0*s - g*s*s/2, v0 - g*s)
        return y, v


def drop(run):
    """DEM01: height and velocity until the second impact; DEM02: heights of the bounces above 1
    mm"""
    e = numberOf(run.solid['pairs']['default']['restitution'])
    height = peak = table = 0.0
    hard = []
    data, bounces = records('DEM01_height'), records('DEM02_bounces')
    for s in spheres(run):
        k = numberOf(run.solid['pairs'][s.material + '-rigid']['stiffness'])
        exact = Drop(s.radius, s.mass, k, e, 0.5, 25)
        early = s.t < 0.55
        height = max(height, abs(s.x[early, 2] - exact.at(s.t[early])[0]).max()/0.5)
        mine = (data['e'] == e) & (data['k'] == k)
        if mine.any():
            table = max(table, abs(exact.at(data['t'][mine])[0] - data['y'][mine]).max())
        computed = peaks(s)
        n = min(len(computed), len([p for p in exact.peaks if p - s.radius > 1e-3]))
        peak = max(peak, max(abs(a - b)/0.5 for a, b in zip(computed[:n], exact.peaks[:n])))
        rows = (bounces['e'] == e) & (bounces['k'] == k) & (bounces['bounce'] < n)
        if rows.any() and k == 5e6:
            hard = [rms([computed[int(b)] - y for b, y in zip(
                bounces['bounce'][rows], bounces[of][rows])])/0.5 for of in ('y', 'y_MFIX')]
    out = [Quantity('DEM01: height, largest difference / 0.5 m', error=height),
           Quantity('DEM02: heights of bounces, largest difference / 0.5 m', error=peak)]
    if table:
        out.append(Quantity("DEM01: closed form here against MFIX's table [m]", error=table))
    if hard:
        out.append(Quantity('DEM02: rms against a hard sphere, 5 MN/m / 0.5 m', computed=hard[0]))
        out.append(Quantity('DEM02: rms against MFIX, 5 MN/m / 0.5 m', computed=hard[1]))
    return out


def peaks(s):
    """Heights of the flights between impacts, from energy (samples need not meet the peak)"""
    top = s.x[:, 2] + s.U[:, 2]**2/(2*g)
    free = s.x[:, 2] > s.radius
    # a flight is a run of free samples in which the velocity falls; a new one begins where it has
    # risen
    new = np.diff(s.U[:, 2]) > 0
    out, start = [], 0
    for i in [*(np.flatnonzero(new) + 1), len(top)]:
        inside = [j for j in range(start, i) if free[j]]
        if inside:
            out.append(top[inside[len(inside)//2]])
        start = i
    return out


def stackMatrix(e, m, k):
    """y' = A y + b for (y1, y2, v1, v2) of two spheres between floor and lid, radius 0.5 mm, gap
    1.8 mm"""
    R, gap = 5e-4, 1.8e-3
    walls = [dashpot(e, mi, k) for mi in m]
    between = dashpot(e, m[0]*m[1]/(m[0] + m[1]), k)
    A, b = np.zeros((4, 4)), np.zeros(4)
    A[0, 2] = A[1, 3] = 1
    A[2] = np.array([-2*k, k, -walls[0] - between, between])/m[0]
    A[3] = np.array([k, -2*k, between, -walls[1] - between])/m[1]
    b[2] = k*(R - 2*R)/m[0] - g
    b[3] = k*(2*R - R + gap)/m[1] - g
    return A, b


def stackExact(e, m, k, t):
    """Heights at the times t, by the eigenvectors of the linear system"""
    A, b = stackMatrix(e, m, k)
    rest = -np.linalg.solve(A, b)
    values, vectors = np.linalg.eig(A)
    start = np.linalg.solve(vectors, np.array([4.5e-4, 1.35e-3, 0, 0]) - rest)
    return (rest[:, None] + (vectors @ (start[:, None]*np.exp(np.outer(values, t)))).real)[:2]


def stack(run):
    """DEM03: both heights until 1 ms"""
    e = numberOf(run.solid['pairs']['default']['restitution'])
    lower, upper = spheres(run)
    exact = stackExact(e, (lower.mass, upper.mass), 1e3, lower.t)
    error = max(abs(s.x[:, 2] - y).max() for s, y in zip((lower, upper), exact))/5e-4
    table = 0.0
    for i in range(2):
        data = records(f'DEM03_height{i + 1}')
        mine = data['e'] == e
        table = max(table, abs(stackExact(e, (lower.mass, upper.mass), 1e3, data['t'][mine])[i]
                               - data['y'][mine]).max()/5e-4)
    return [Quantity('DEM03: heights, largest difference / R', error=error),
            Quantity("DEM03: closed form here against MFIX's table / R", error=table)]


def slide(run):
    """DEM04: from sliding to rolling"""
    s, mu = spheres(run)[0], numberOf(run.solid['pairs']['default']['friction'])
    v = s.U[:, 0]
    exact = 2*0.1/(7*mu*9.81)
    # the line of sliding meets the level of rolling
    early = s.t < 0.8*exact
    slope, at0 = np.polyfit(s.t[early], v[early], 1)
    time = (v[-1] - at0)/slope
    return [Quantity('velocity when rolling / u0', reference=5/7, computed=v[-1]/0.1,
                     error=abs(v[-1]/0.1*7/5 - 1)),
            Quantity('spin when rolling, R w / u0', reference=5/7, computed=s.W[-1, 1]*s.radius/0.1,
                     error=abs(s.W[-1, 1]*s.radius/0.1*7/5 - 1)),
            Quantity('end of sliding [s]', reference=exact, computed=time,
                     error=abs(time/exact - 1))]


measured = {'e_t': 'tangential restitution', 'omega_rad_s': 'spin',
            'rebound_angle_deg': 'rebound angle'}


def kharazCurves(run):
    """{quantity: (angle of incidence, value)} of DEM05"""
    rows = {name: [] for name in measured}
    for s in (s for s in spheres(run) if s.material == 'dem05'):
        angle = math.degrees(math.atan2(s.U[0, 0], -s.U[0, 2]))
        rows['omega_rad_s'].append((angle, s.W[-1, 1]))
        # MFIX's rebound angle is that of the centre
        rows['rebound_angle_deg'].append((angle, math.degrees(math.atan2(s.U[-1, 0], s.U[-1, 2]))))
        if angle > 0.1:
            rows['e_t'].append((angle, s.U[-1, 0]/s.U[0, 0]))
    return {name: np.array(r).T for name, r in rows.items()}


def kharazPair(run):
    """DEM05 on spheres that stand for the wall"""
    return kharaz(run, 'particle_particle')


def kharaz(run, against='particle_wall'):
    """DEM05: against MFIX's own run with the same law, and against the experiment beside it"""
    law = 'HERTZIAN' if run.solid['contact']['normal'] == 'hertz' else 'LINEAR'
    out = []
    for name, (angle, value) in kharazCurves(run).items():
        data, experiment = records('DEM05_mfix_' + name), records('DEM05_exp_kharaz_' + name)
        mine = np.char.startswith(data['model'], law)
        x, y = data['impact_angle_deg'][mine], data[against][mine]
        out.append(Quantity(f'{measured[name]}: rms against MFIX / largest',
                            error=rms(np.interp(x, angle, value) - y)/abs(y).max()))
        far = [rms(np.interp(experiment['impact_angle_deg'], *curve) - experiment[name])
               for curve in ((angle, value), (x, y))]
        out.append(Quantity(f"{measured[name]}: rms against Kharaz / MFIX's",
                            computed=far[0]/far[1]))
    return out
