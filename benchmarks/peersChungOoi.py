# SPDX-License-Identifier: GPL-3.0-or-later
"""Impacts of single spheres of tutorials/dem/chungOoi in LAMMPS and LIGGGHTS, against the same
closed forms

Test 1 (two glass spheres, 20 m/s), test 3 (alumina on a plane, e = 0.2 to 1) and MFIX's DEM04 (a
sphere set down in motion), with that tutorial's steps. Dashpots of both may pull.
"""
import math
import os
import sys

here = os.path.dirname(os.path.abspath(__file__))
tutorial = os.path.join(os.path.dirname(here), 'tutorials', 'dem', 'chungOoi')


class Lammps:
    name, program = 'LAMMPS granular', 'lmp'
    head = ('units si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n'
            'atom_modify map array\n')

    @staticmethod
    def hertz(E, nu, e):
        return 'pair_style granular\npair_coeff * * ' + Lammps.law(E, nu, e)

    @staticmethod
    def law(E, nu, e):
        damping = 'tsuji' if e < 1 else 'velocity'
        return (f'hertz/material {E} {e if e < 1 else 0} {nu} '
                f'tangential linear_nohistory 0 0 damping {damping}\n')

    @staticmethod
    def plane(E, nu, e):
        return (Lammps.hertz(E, nu, e)
                + f'fix w all wall/gran granular {Lammps.law(E, nu, e).strip()} zplane 0.0 NULL\n')

    @staticmethod
    def slope(k, mass, size, mu):
        zeta = -math.log(0.9)/math.hypot(math.pi, math.log(0.9))
        law = (f'hooke {k} {2*zeta*math.sqrt(k*mass):.9g} tangential linear_history {2/7*k:.9g} '
               f'1 {mu} damping velocity')
        return (f'pair_style granular\npair_coeff * * {law}\n'
                f'fix w all wall/gran granular {law} zplane 0.0 NULL\n')


class Liggghts:
    name, program = 'LIGGGHTS', 'liggghts'
    head = ('units si\natom_style granular\nhard_particles yes\nboundary f f f\nnewton off\n'
            'communicate single vel yes\natom_modify map array\n')

    @staticmethod
    def material(E, nu, e, mu):
        return (f'fix E all property/global youngsModulus peratomtype {E}\n'
                f'fix nu all property/global poissonsRatio peratomtype {nu}\n'
                f'fix e all property/global coefficientRestitution peratomtypepair 1 {e}\n'
                f'fix mu all property/global coefficientFriction peratomtypepair 1 {mu}\n')

    @staticmethod
    def hertz(E, nu, e):
        return (Liggghts.material(E, nu, e, 0)
                + 'pair_style gran model hertz tangential no_history\npair_coeff * *\n')

    @staticmethod
    def plane(E, nu, e):
        return (Liggghts.hertz(E, nu, e) + 'fix w all wall/gran model hertz tangential no_history '
                                           'primitive type 1 zplane 0.0\n')

    @staticmethod
    def slope(k, mass, size, mu):
        # k = 16/15 sqrt(R) Y* (15 m V^2/(16 sqrt(R) Y*))^(1/5), Y* = Y/2
        speed, R = 1.0, size/2
        effective = (k*15/16/math.sqrt(R)/(15*mass*speed**2/(16*math.sqrt(R)))**0.2)**1.25
        return (Liggghts.material(f'{2*effective:.9g}', 0, 0.9, mu)
                + f'fix V all property/global characteristicVelocity scalar {speed}\n'
                'pair_style gran model hooke tangential history\npair_coeff * *\n'
                'fix w all wall/gran model hooke tangential history primitive type 1 zplane 0.0\n')


def scene(code, atoms, law, dt, steps, columns, every, gravity='', move='nve/sphere'):
    """atoms: diameter, density, position, velocity. columns: of the table, by LAMMPS's words; move:
    nve without turning"""
    text = code.head + 'region b block -0.3 0.3 -0.3 0.3 -0.3 0.3\ncreate_box 1 b\n'
    text += ''.join('create_atoms 1 single {:.15g} {:.15g} {:.15g}\n'.format(*x)
                    for _, _, x, _ in atoms)
    text += ''.join(f'set atom {i + 1} diameter {size} density {rho} vx {u[0]} vy {u[1]} '
                    f'vz {u[2]}\n' for i, (size, rho, _, u) in enumerate(atoms))
    variables = ''.join(f'variable q{i} equal {c}\n' for i, c in enumerate(columns))
    return (text + 'neighbor 0.001 bin\nneigh_modify delay 0 every 1 check yes\n' + law + gravity
            + f'fix i all {move}\n' + variables
            + f'timestep {dt}\nthermo {every}\n'
              f'thermo_style custom step {" ".join(f"v_q{i}" for i in range(len(columns)))}\n'
            + f'thermo_modify format float %.12g lost ignore norm no\nrun {steps}\n')


def runChungOoi(folder, tools):
    """tools: what runs a program on a text, the rows of its table, processor time of finished
    programs"""
    import numpy as np
    sys.path.insert(0, tutorial)
    import chung

    def table(code, *what, **more):
        before = tools.childSeconds()
        output = tools.lammps(code.program, scene(code, *what, **more), folder)
        return np.array(tools.tableRows(output)), tools.childSeconds() - before

    for code in (Lammps, Liggghts):
        R, E, nu, rho, dt, steps = 0.01, 4.8e10, 0.2, 2800, 2e-8, 3000
        rows, cost = table(code, [(2*R, rho, (-R*(1 + 1e-6), 0, 0), (10, 0, 0)),
                                  (2*R, rho, (R*(1 + 1e-6), 0, 0), (-10, 0, 0))],
                           code.hertz(E, nu, 1), dt, steps, ('x[2]-x[1]', 'fx[1]'), 1)
        mass = rho*4/3*math.pi*R**3
        for q in chung.impact('glass', rows[:, 0]*dt, 2*R - rows[:, 1], abs(rows[:, 2]),
                              chung.hertz(E/(2*(1 - nu**2)), R/2, mass/2, 20.0)):
            yield 'chungOoi', code.name, f'error of {q.name}', q.error
        yield ('chungOoi', code.name, 'seconds a simulated second, largest overlap [m], glass',
               cost/(steps*dt))

        R, E, nu, rho, dt, steps = 0.0025, 3.8e11, 0.23, 4000, 5e-9, 6000
        for e in (0.2, 0.4, 0.6, 0.8, 1):
            rows, cost = table(code, [(2*R, rho, (0, 0, R*(1 + 1e-6)), (0, 0, -3.9))],
                               code.plane(E, nu, e), dt, steps, ('vz[1]',), 1000)
            yield ('chungOoi', code.name, f'error of restitution, alumina; e {e}',
                   abs(rows[-1, 1]/3.9 - e))
            yield ('chungOoi', code.name,
                   f'seconds a simulated second, restitution, alumina; e {e}', cost/(steps*dt))

        R, rho, k, dt, steps = 0.0005, 1e4, 1e4, 1e-6, 20000
        mass = rho*4/3*math.pi*R**3
        for mu in (0.2, 0.5, 1):
            rows, cost = table(code, [(2*R, rho, (0, 0, R - mass*9.81/k), (0.1, 0, 0))],
                               code.slope(k, mass, 2*R, mu), dt, steps, ('vx[1]',), 1000,
                               gravity='fix g all gravity 9.81 vector 0 0 -1\n')
            yield ('chungOoi', code.name, f'error of velocity when rolling / u0; mu {mu}',
                   abs(rows[-1, 1]/0.1*7/5 - 1))
            yield ('chungOoi', code.name,
                   f'seconds a simulated second, velocity when rolling / u0; mu {mu}',
                   cost/(steps*dt))
