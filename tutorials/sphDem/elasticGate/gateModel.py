# SPDX-License-Identifier: GPL-3.0-or-later
"""The gate at rest under water: an inextensible beam of any deflection, clamped at its top, under
hydrostatic pressure and its weight

    E I dtheta/ds = M(s),  E I theta(0) = 0, M(s) the moment of pressure rho g (H - y) normal to the
                           beam and of the weight below s
theta from the vertical; acceleration of the water and the pressure that its flow under the gate
takes away are left out.
"""
import numpy as np

g, rho, rhoGate = 9.81, 1000, 1100
length, thickness, top = 0.07875, 5e-3, 0.079
inertia = thickness**3/12


def deflection(young, level, points=200):
    """How far the end has moved outwards and up [m]"""
    ds = length/points
    theta = np.zeros(points + 1)

    def along(q):
        return np.concatenate([[0], np.cumsum((q[1:] + q[:-1])/2*ds)])

    def below(q):
        return along(q)[-1] - along(q)

    for _ in range(400):
        x, y = along(np.sin(theta)), top - along(np.cos(theta))
        pressure = rho*g*np.maximum(level - y, 0)
        fx, fy = pressure*np.cos(theta), pressure*np.sin(theta) - rhoGate*thickness*g
        moment = below(x*fy - y*fx) - x*below(fy) + y*below(fx)
        new = along(moment)/(young*inertia)
        if np.abs(new - theta).max() < 1e-8:
            break
        theta = 0.7*theta + 0.3*new
    return x[-1], y[-1] - top + length


def impliedModulus(x, level):
    """E with which the gate at rest is x outwards under this level [Pa]"""
    low, high = 2e6, 4e7
    for _ in range(30):
        middle = np.sqrt(low*high)
        low, high = (middle, high) if deflection(middle, level)[0] > x else (low, middle)
    return low


def levelFrom(t, x, y, foot, discharge, depth=0.14, tank=0.1, shape=0.345):
    """Level [m] of a tank that empties through the opening under the gate: tank dH/dt = -discharge
    a sqrt(2 g (H - a)) - shape L dx/dt, a = foot + y; shape L x is what the gate sweeps (the
    elastica's 0.33 to 0.36)"""
    level = [depth]
    for k in range(1, len(t)):
        dt, a = t[k] - t[k - 1], foot + max(y[k], 0)
        h = level[-1]
        out = discharge*a*np.sqrt(2*g*max(h - a, 0))*dt + shape*length*(x[k] - x[k - 1])
        level.append(h - out/tank)
    return np.array(level)
