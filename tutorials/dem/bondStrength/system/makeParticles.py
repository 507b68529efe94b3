# SPDX-License-Identifier: GPL-3.0-or-later
"""constant/particles.csv, loads and cement of the bar. Each free particle carries the load w, one
of them P more: the last one, in shear the first, since a bent bar that lets go springs back and
breaks in shear all along. The first bond carries most. Stresses are those of statics; loads are so
small that the bar turns by less than 1e-6."""
from math import pi

from riprap.dictionaries import numberOf, readDictionary

bar = readDictionary('system/bar')
test, margin, disks = bar['test'], numberOf(bar['margin']), bar['sides'] == 'empty'
n, R, E, G = 6, 0.01, 1e9, 4e8
s = 2*R
A, I = (2*R, 2/3*R**3) if disks else (pi*R**2, pi*R**4/4)
J = 2*I
P = 0.04 if disks else 0.04*3*pi*R/8            # as stiff as in 2D
w = P/20
loaded = 1 if test == 'shear' else n - 1

force = [0, 0]                                  # along the bar, across it
if test in ('tension', 'combined'):
    force[0] = 1
if test in ('shear', 'bending', 'combined'):
    force[1] = -1
N = (P + (n - 1)*w)*abs(force[0])
V = (P + (n - 1)*w)*abs(force[1])
M = s*((loaded - 0.5)*P + w*sum(j - 0.5 for j in range(1, n)))*abs(force[1])
torque = s*P if test == 'torsion' else 0
T = torque*(1 + (n - 1)/20)
tensile, shear = N/A + M*R/I, V/A + T*R/J

damping = '3e5' if test in ('tension', 'torsion') else '1e5'      # [1/s] nothing overshoots
weak = shear if test in ('shear', 'torsion') else tensile
strength = {'tensileStrength': 'none', 'shearStrength': 'none'}
strength['shearStrength' if test in ('shear', 'torsion') else 'tensileStrength'] = (
    f'{weak*(1 + margin):.17g}')

with open('constant/particles.csv', 'w') as f:
    f.write('x,y,z,radius,group\n')
    for i in range(n):
        f.write(f"{s*i:.17g},0,0,{R},{'clamp' if i == 0 else 'loaded' if i == loaded else 'bar'}\n")
with open('constant/loads', 'w') as f:
    for group, load, moment in (('bar', w, torque/20), ('loaded', P + w, torque*21/20)):
        f.write(f'{group} {{ force ({load*force[0]:.17g} {load*force[1]:.17g} '
                f'0); moment ({moment:.17g} 0 0); viscousDamping {damping}; '
                f'viscousSpinDamping {damping}; }}\n')
with open('constant/cement', 'w') as f:
    f.write(f"calibration moduli; E {E:g}; G {G:g}; section {'plate' if disks else 'round'};\n")
    f.write(''.join(f'{k} {v};\n' for k, v in strength.items()))
    f.write(f'// The first bond: N {N:.10g} N, V {V:.10g} N, M {M:.10g} N m, T {T:.10g} N m; '
            f'tensile stress {tensile:.10g} Pa, shear stress {shear:.10g} Pa\n')
