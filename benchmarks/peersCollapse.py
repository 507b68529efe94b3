# SPDX-License-Identifier: GPL-3.0-or-later
"""Collapsing columns of spheres of tutorials/dem/columnCollapse in LAMMPS and LIGGGHTS: from the
grains as they stand when the gate goes

The slice of six grains across, periodic, on a floor of glued grains. Springs are linear with a
history, restitution 0.5, friction 0.5; the plane of symmetry is smooth. In LIGGGHTS springs along
contacts are as stiff as those across them (0.5 in the others) and stiffness goes with the grains'
size. In both the dashpot may pull, and the gate is gone at once.
"""
import glob
import math
import os
import sys

here = os.path.dirname(os.path.abspath(__file__))
tutorial = os.path.join(os.path.dirname(here), 'tutorials', 'dem', 'columnCollapse')
restitution, friction, rho = 0.5, 0.5, 2500.0

head = '''units si
atom_style {style}
boundary f f p
newton off
{modify}
read_data grains.data
group free type 1
group glued type 2
neighbor 0.001 bin
neigh_modify delay 0 every 1 check yes exclude group glued glued
'''
tail = '''fix g free gravity 9.81 vector 0 -1 0
fix move free nve/sphere
timestep {dt:.9g}
thermo 100000
thermo_modify lost ignore norm no
dump d all custom {steps} end.*.dump id type x y z radius
run {steps}
'''


def inLammps(k, mass, size):
    # a dashpot of gamma m* v has the restitution asked for beside k and m* of two mean grains; the
    # wall's likewise
    zeta = -math.log(restitution)/math.hypot(math.pi, math.log(restitution))
    gamma = 2*zeta*math.sqrt(k/(mass/2))
    law = (f'hooke {k:.9g} {gamma:.9g} tangential linear_history {0.5*k:.9g} 0.7 {friction} '
           'damping mass_velocity')
    wall = (f'hooke {k:.9g} {gamma/math.sqrt(2):.9g} tangential linear_nohistory 0 0 damping '
            'mass_velocity')
    return (f'pair_style granular\npair_coeff * * {law}\n'
            f'fix w free wall/gran granular {wall} xplane 0.0 NULL\n')


def inLiggghts(k, mass, size):
    # k = 16/15 sqrt(R*) Y* (15 m* V^2/(16 sqrt(R*) Y*))^(1/5) of two mean grains; poissonsRatio 0,
    # so Y* = Y/2
    speed, R, m = 1.0, size/4, mass/2
    effective = (k*15/16/math.sqrt(R)/(15*m*speed**2/(16*math.sqrt(R)))**0.2)**1.25
    pairs = ' '.join(str(0.0 if 3 in (a, b) else friction) for a in (1, 2, 3) for b in (1, 2, 3))
    return (
        f'''fix E all property/global youngsModulus peratomtype {' '.join(3*[f'{2*effective:.9g}'])}
fix nu all property/global poissonsRatio peratomtype 0 0 0
fix e all property/global coefficientRestitution peratomtypepair 3 {' '.join(9*[str(restitution)])}
fix mu all property/global coefficientFriction peratomtypepair 3 {pairs}
fix V all property/global characteristicVelocity scalar {speed}
pair_style gran model hooke tangential history
pair_coeff * *
fix w free wall/gran model hooke tangential history primitive type 3 xplane 0.0
''')


codes = {'LAMMPS granular': ('lmp', 'sphere', 'comm_modify vel yes', inLammps),
         'LIGGGHTS': ('liggghts', 'granular', 'communicate single vel yes\natom_modify map array',
                      inLiggghts)}


def lastDump(folder):
    """id, type, x, y, z, radius of the last dump"""
    import numpy as np
    path = max(glob.glob(os.path.join(folder, 'end.*.dump')), key=lambda p: int(p.split('.')[-2]))
    return np.loadtxt(path, skiprows=9)


def runCollapse(folder, tools):
    """tools: what runs a program on a text, what writes a data file, what runs Allrun"""
    import numpy as np
    sys.path.insert(0, tutorial)
    import analysis
    import deposit
    from riprap import clouds
    from riprap.study import Run

    def told(code, a, x, r, width, depth):
        for what, value in (('heap', deposit.reachOf(x, r, width)),
                            ('half a grain deep', deposit.footOf(x, r, width, depth)),
                            ('99 % of the grains', np.quantile(x[:, 0], 0.99)/width - 1)):
            yield 'collapse', code, f'a = {a:g}: run-out, {what}', value

    for a in (4, 10):
        variant = analysis.spheresOf(a, analysis.widths[a], '-peers', duration=(4.5, 0.2),
                                     stiff=250)
        tools.run([os.path.join(tutorial, 'Allrun'), '-name', variant.name, '-noPlot',
                   *variant.options], tutorial)
        run = Run(os.path.join(tutorial, 'runs', variant.name), variant.name)
        size = deposit.column(run)
        yield from told('riprap', a, *deposit.grains(run, deposit.lastTime(run)), size['width'],
                        size['depth'])
        cloud = clouds.readCloud(run.path, clouds.nearestTime(run.path, deposit.opens),
                                 ('radius', 'group'), 'solids')
        x, r, kind = cloud['positions'], cloud['radius'], cloud['group']
        tools.writeData(os.path.join(folder, 'grains.data'),
                        ((-0.01, size['length']), (-0.02, size['top']), (0, size['depth'])),
                        [f'{1 + (g > 0)} {2*s:.9g} {rho} {p[0]:.9g} {p[1]:.9g} '
                         f'{p[2] % size["depth"]:.9g}' for p, s, g in zip(x, r, kind)], kinds=3)
        k = float(run.solid['pairs']['grain-grain']['stiffness'])
        mean = 2*float(r[kind == 0].mean())
        dt = deposit.lastTime(run)/run.log['steps']
        steps = int((deposit.lastTime(run) - deposit.opens)/dt)
        for code, (program, style, modify, law) in codes.items():
            for old in glob.glob(os.path.join(folder, 'end.*.dump')):
                os.remove(old)
            tools.lammps(program, head.format(style=style, modify=modify)
                         + law(k, rho*math.pi/6*mean**3, mean) + tail.format(dt=dt, steps=steps),
                         folder)
            rows = lastDump(folder)
            rows = rows[rows[:, 1] == 1]
            yield from told(code, a, rows[:, 2:5], rows[:, 5], size['width'], size['depth'])
