# SPDX-License-Identifier: GPL-3.0-or-later
"""Case directories of interFoam and interIsoFoam: mesh, water and walls of riprap's tutorials

Water and air with their viscosities; adaptive steps with Courant number 0.5; schemes and solvers of
OpenFOAM's own damBreak tutorials. Waves and pools have no surface tension, as riprap has none.
"""
import os
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Scene:
    width: float                    # of the mesh [m]
    height: float
    end: float                      # [s]
    water: tuple                    # width and height of the box of water [m]
    sigma: float = 0                # [N/m]
    walls: str = 'slip'
    periodic: bool = False
    sides: bool = True              # walls at both ends
    maxDeltaT: float = 1
    tolerance: float = 1e-9         # of p_rgh
    interval: float = 0.005         # of what is measured [s]
    # of p at the far wall or the obstacle's front, above the floor [m]
    probes: list = field(default_factory=list)
    obstacle: tuple = ()            # a box on the floor: from x, to x, height [m]


scenes = {
    'damBreak': Scene(0.584, 1.2, 0.5, (0.146, 0.292), sigma=0.07, walls='noSlip', tolerance=1e-7),
    'dambreakPressure': Scene(1.61, 1, 0.95, (0.6, 0.3), sigma=0.07, walls='noSlip', tolerance=1e-7,
                              probes=[0.003, 0.015, 0.03, 0.08, 0.06]),
    # a slice of the tank of Kleefsman et al. (2005), seen from the other side
    'damBreakBox': Scene(3.22, 1, 0.95, (1.228, 0.55), walls='noSlip', tolerance=1e-7,
                         probes=[0.021, 0.061, 0.101, 0.141], obstacle=(2.3955, 2.5565, 0.161)),
    'standingWave': Scene(1, 0.7, 8, (1, 0.5), periodic=True, maxDeltaT=0.005, interval=0.02),
    'hydrostatic': Scene(0.5, 0.375, 5, (0.5, 0.25), maxDeltaT=0.005, interval=0.25),
}
header = 'FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n'


def write(case, path, kind, text):
    path = os.path.join(case, path)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as f:
        f.write(header.format(kind, os.path.basename(path)) + text)


def gauges(cell):
    """Middles of 25 columns of standingWave's cells, evenly spaced: [m]"""
    every = round(scenes['standingWave'].width/cell)//25
    return [(i*every + every//2 + 0.5)*cell for i in range(25)]


def makeCase(case, solver, name, cell, walls, end, wave):
    scene = scenes[name]
    mesh(case, scene, cell)
    write(case, 'system/setFieldsDict', 'dictionary',
          f'''defaultFieldValues (volScalarFieldValue alpha.water 0);
regions (boxToCell {{ box (-1 -1 -1) ({scene.water[0]} {scene.water[1]} 1); \
fieldValues (volScalarFieldValue alpha.water 1); }});
''')
    write(case, 'constant/g', 'uniformDimensionedVectorField',
          'dimensions [0 1 -2 0 0 0 0];\nvalue (0 -9.81 0);\n')
    write(case, 'constant/turbulenceProperties', 'dictionary', 'simulationType laminar;\n')
    write(case, 'constant/dynamicMeshDict', 'dictionary', 'dynamicFvMesh staticFvMesh;\n')
    write(case, 'constant/transportProperties', 'dictionary', f'''phases (water air);
water {{ transportModel Newtonian; nu 1e-06; rho 1000; }}
air {{ transportModel Newtonian; nu 1.48e-05; rho 1; }}
sigma {scene.sigma};
''')
    fields(case, scene, walls, waveVelocity(scene, cell, wave) if wave else None)
    numerics(case, solver, scene)
    control(case, solver, name, cell, end)


def mesh(case, scene, cell):
    if scene.obstacle:
        return meshAboutObstacle(case, scene, cell)
    nx, ny = round(scene.width/cell), round(scene.height/cell)
    W, H = nx*cell, ny*cell
    walls = 'walls { type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4)); }'
    if scene.periodic:
        walls = '''walls { type wall; faces ((0 1 5 4)); }
    left { type cyclic; neighbourPatch right; faces ((0 4 7 3)); }
    right { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }'''
    write(case, 'system/blockMeshDict', 'dictionary', f'''scale 1;
vertices ((0 0 0) ({W} 0 0) ({W} {H} 0) (0 {H} 0) \
(0 0 {cell}) ({W} 0 {cell}) ({W} {H} {cell}) (0 {H} {cell}));
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} 1) simpleGrading (1 1 1));
boundary
(
    {walls}
    atmosphere {{ type patch; faces ((3 7 6 2)); }}
    frontAndBack {{ type empty; faces ((0 3 2 1) (4 5 6 7)); }}
);
''')


def meshAboutObstacle(case, scene, cell):
    """Five blocks; cells as near to squares as the obstacle's sides let them be"""
    x, y = (0, *scene.obstacle[:2], scene.width), (0, scene.obstacle[2], scene.height)
    vertices = '\n'.join(f'({a} {b} {c})' for c in (0, cell) for b in y for a in x)
    solid = {(1, 0)}
    blocks, faces = [], {'walls': [], 'atmosphere': [], 'frontAndBack': []}
    for j in range(2):
        for i in range(3):
            if (i, j) in solid:
                continue
            v = [k + i + 4*j + d for k in (0, 12) for d in (0, 1, 5, 4)]
            n = [max(1, round(length/cell)) for length in (x[i + 1] - x[i], y[j + 1] - y[j])]
            blocks.append(f"hex ({' '.join(map(str, v))}) ({n[0]} {n[1]} 1) simpleGrading (1 1 1)")
            for (di, dj), face in {(-1, 0): (0, 4, 7, 3), (1, 0): (1, 2, 6, 5),
                                   (0, -1): (0, 1, 5, 4), (0, 1): (3, 7, 6, 2)}.items():
                beside = (i + di, j + dj)
                if beside in solid or not (0 <= beside[0] < 3 and 0 <= beside[1] < 2):
                    faces['atmosphere' if beside[1] == 2 else 'walls'].append([v[k] for k in face])
            faces['frontAndBack'] += [[v[k] for k in face] for face in ((0, 3, 2, 1), (4, 5, 6, 7))]
    patches = '\n    '.join(
        f"{name} {{ type {kind}; "
        f"faces ({' '.join('(' + ' '.join(map(str, f)) + ')' for f in faces[name])}); }}"
        for name, kind in (('walls', 'wall'), ('atmosphere', 'patch'), ('frontAndBack', 'empty')))
    lines = '\n    '.join(blocks)
    write(case, 'system/blockMeshDict', 'dictionary', f'''scale 1;
vertices
(
{vertices}
);
blocks
(
    {lines}
);
boundary
(
    {patches}
);
''')


def waveVelocity(scene, cell, cells):
    """Flat water that passes through rest level, with an amplitude of one cell; potential flow in
    the air above, too"""
    nx, ny = round(scene.width/cell), round(scene.height/cell)
    k, H = 2*np.pi/scene.width, scene.water[1]
    V = cells*cell*np.sqrt(9.81*k*np.tanh(k*H))
    x, y = np.meshgrid((np.arange(nx) + 0.5)*cell, (np.arange(ny) + 0.5)*cell)
    wet = y < H
    below = np.where(wet, y, 0)
    u = np.where(wet, -np.cosh(k*below)/np.sinh(k*H), np.exp(-k*(y - H)))*V*np.sin(k*x)
    v = np.where(wet, np.sinh(k*below)/np.sinh(k*H), np.exp(-k*(y - H)))*V*np.cos(k*x)
    rows = '\n'.join(f'({a:.8g} {b:.8g} 0)' for a, b in zip(u.ravel(), v.ravel()))
    return f'nonuniform List<vector> {nx*ny}\n(\n{rows}\n)'


def fields(case, scene, walls, velocity):
    ends = 'left { type cyclic; } right { type cyclic; } ' if scene.periodic else ''
    for name, kind, dimensions, wall, top in (
            ('U', 'volVectorField', '[0 1 -1 0 0 0 0]', walls,
             'pressureInletOutletVelocity; value uniform (0 0 0)'),
            ('p_rgh', 'volScalarField', '[1 -1 -2 0 0 0 0]', 'fixedFluxPressure; value uniform 0',
             'totalPressure; p0 uniform 0'),
            ('alpha.water', 'volScalarField', '[0 0 0 0 0 0 0]', 'zeroGradient',
             'inletOutlet; inletValue uniform 0; value uniform 0')):
        zero = 'uniform (0 0 0)' if kind == 'volVectorField' else 'uniform 0'
        write(case, f'0/{name}', kind, f'''dimensions {dimensions};
internalField {velocity if name == 'U' and velocity else zero};
boundaryField {{ walls {{ type {wall}; }} {ends}atmosphere {{ type {top}; }} \
frontAndBack {{ type empty; }} }}
''')


def numerics(case, solver, scene):
    iso = solver == 'interIsoFoam'
    convection = 'limitedLinearV 1' if iso else 'linearUpwind grad(U)'
    write(case, 'system/fvSchemes', 'dictionary', f'''ddtSchemes {{ default Euler; }}
gradSchemes {{ default Gauss linear; }}
divSchemes
{{
    div(rhoPhi,U) Gauss {convection};
    div(phi,alpha) Gauss vanLeer;
    div(phirb,alpha) Gauss {'interfaceCompression' if iso else 'linear'};
    div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;
}}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
''')
    alpha = ('isoFaceTol 1e-6; surfCellTol 1e-6; nAlphaBounds 3; snapTol 1e-12; clip true; '
             'nAlphaSubCycles 1; cAlpha 1;' if iso else
             'nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5; '
             'solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0;')
    write(case, 'system/fvSolution', 'dictionary', f'''solvers
{{
    "alpha.water.*" {{ {alpha} }}
    "pcorr.*" {{ solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; }}
    p_rgh {{ solver GAMG; smoother DICGaussSeidel; tolerance {scene.tolerance:g}; relTol 0.05; }}
    p_rghFinal {{ $p_rgh; relTol 0; }}
    "U.*" {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }}
}}
PIMPLE {{ momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }}
relaxationFactors {{ equations {{ ".*" 1; }} }}
''')


def control(case, solver, name, cell, end):
    scene = scenes[name]
    middle, sampled = cell/2, f'writeControl adjustableRunTime; writeInterval {scene.interval:g};'

    top = round(scene.height/cell)*cell

    def columns(x):
        lines = ' '.join(f'column{i} {{ type midPoint; axis y; start ({a:.10g} {0.01*cell:.10g} '
                         f'{middle:.10g}); end ({a:.10g} {top - 0.01*cell:.10g} {middle:.10g}); }}'
                         for i, a in enumerate(x))
        return (f'heights {{ type sets; libs (sampling); fields (alpha.water); '
                f'interpolationScheme cell; setFormat raw; {sampled} sets ( {lines} ); }}\n')

    functions, interval = '', end
    if scene.probes:
        wall = scene.obstacle[0] if scene.obstacle else scene.width
        points = ' '.join(f'({wall - 0.3*cell} {max(y, 0.01*cell)} {middle})' for y in scene.probes)
        functions = (f'wallProbes {{ type probes; libs (sampling); fields (p); '
                     f'writeControl timeStep; writeInterval 1; probeLocations ({points}); }}')
    elif name == 'damBreak':
        functions = (columns([middle])
                     + f'''    floor {{ type sets; libs (sampling); fields (alpha.water); \
interpolationScheme cell; setFormat raw; {sampled}
        sets ( row {{ type midPoint; axis x; start (0 {middle} {middle}); \
end ({scene.width} {middle} {middle}); }} ); }}''')
    elif name == 'standingWave':
        functions = columns(gauges(cell))
    else:
        interval = scene.interval
    write(case, 'system/controlDict', 'dictionary', f'''application {solver};
startFrom startTime; startTime 0; stopAt endTime; endTime {end:g};
deltaT 0.0005; adjustTimeStep yes; maxCo 0.5; maxAlphaCo 0.5; maxDeltaT {scene.maxDeltaT:g};
writeControl adjustableRunTime; writeInterval {interval:g}; writePrecision 10;
functions
{{
    {functions}
}}
''')
