#!/bin/bash
# setParticles -parallel: clouds of 2, 3 and 4 processes are those of one process and decomposePar,
# particle by particle to the bit, each on the process that has its cell; a run goes on from them
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL setParticlesParallel no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam decomposePar
do
    command -v $program >/dev/null || { echo "FAIL setParticlesParallel no $program"; exit 1; }
done
command -v mpirun >/dev/null || { echo "SKIP setParticlesParallel no mpirun"; exit 0; }
python=${RIPRAP_PYTHON:-python3}
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=setParticlesParallel
. "$root/tests/regression/setParticlesCases"
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

onRanks()   # N PROGRAM [OPTIONS]
{
    mpirun -np "$1" --oversubscribe --mca mpi_yield_when_idle 1 "$2" -parallel "${@:3}"
}
divide()    # N METHOD
{
    rm -rf processor*
    dictionary system/decomposeParDict <<<"numberOfSubdomains $1; method $2"
    FOAM_SIGFPE=false decomposePar >log.divide 2>&1 || tail -5 log.divide
}
simple() { divide $(($1*$2*$3)) "simple; simpleCoeffs { n ($1 $2 $3); delta 0.001; }"; }
# Each cell to a process: RANK is awk's, of the cell's number i
manual()    # N RANK
{
    local cells
    cells=$(sed -n 's/.*nCells: *\([0-9]*\).*/\1/p' constant/polyMesh/owner)
    {
        echo 'FoamFile { version 2.0; format ascii; class labelList; object parts; }'
        awk -v n="$cells" \
            "BEGIN { print n \"(\"; for (i = 0; i < n; ++i) print int($2); print \")\" }"
    } >constant/parts
    divide "$1" 'manual; manualCoeffs { dataFile "parts"; }'
}
control()   # [ENTRIES]
{
    dictionary system/controlDict <<<"application riprapFoam; solver ${solver:-sphDem}; \
startFrom startTime; startTime 0; stopAt endTime; endTime 0.002; deltaT 1e-4; adjustTimeStep yes; \
sampleInterval 0.002; writeControl adjustableRunTime; writeInterval 0.002; writeFormat binary; \
writePrecision 10; timePrecision 9; ${1:-}"
}
same()      # NAME CASE TIME OTHER OTHERTIME [OPTIONS]
{
    local name=$1 said
    shift
    said=$("$python" "$root/tests/python/sameClouds.py" "$@" 2>&1) && pass "$name" \
        || fail "$name" "$(tail -1 <<<"$said")"
}
# Has each process the particles that one process has in its cells?
sameOwners()    # NAME
{
    local said
    said=$(PYTHONPATH=$root/tests/python "$python" - 2>&1 <<'END'
import glob, sys
from sameClouds import readList
cells = [row[3] for row in readList('one/0/lagrangian/fluid/positions', '<dddi')]
ids = [i for (i,) in readList('one/0/lagrangian/fluid/id')]
wrong = []
for part in sorted(glob.glob('processor*')):
    whole = [c for (c,) in readList(f'{part}/constant/polyMesh/cellProcAddressing')]
    own, parts = set(whole), f'{part}/0/lagrangian/fluid'
    a = {i: whole[row[3]] for (i,), row in zip(readList(f'{parts}/id'),
                                               readList(f'{parts}/positions', '<dddi'))}
    b = {i: c for i, c in zip(ids, cells) if c in own}
    if a != b:
        wrong.append(f'{part}: {len(a)} and {len(b)}, {sorted(set(a) ^ set(b))[:3]}')
print('; '.join(wrong))
sys.exit(bool(wrong))
END
    ) && pass "$1" || fail "$1" "$said"
}
sameLines() # NAME FIRST LAST LOG OTHER: from the first line that begins so to the last that matches
{
    local said
    said=$(diff <(sed -nE "/^$2/,${3}p" "$4") <(sed -nE "/^$2/,${3}p" "$5"))
    [[ -z $said ]] && grep -qE "^$2" "$4" && pass "$1" || fail "$1" "$(tr '\n' ' ' <<<"$said")"
}
# One process here in one/, all processes beside it: positions, fields, ids, owners; the same words
check()     # NAME N DIVISION...
{
    local name=$1 n=$2
    shift 2
    rm -rf one 0 processor*
    mkdir one && cp -r constant system one
    (cd one && setParticles >log 2>&1) || fail "$name.one" "$(tail -1 one/log)"
    "$@"
    onRanks "$n" setParticles >log 2>&1 || fail "$name.ran" "$(oneLine | tail -c 300)"
    if [[ -d one/0/lagrangian/fluid ]]
    then
        same "$name.water" . 0 one 0 --fluid
        sameOwners "$name.owners"
    fi
    [[ ! -d one/0/lagrangian/solids ]] || same "$name.solids" . 0 one 0
    sameLines "$name.log" GPU '/^Written/' log one/log
}


# A list; then particles on the faces between the parts, by any division, one of which has no cells
tank2; control
regions 'low { set fluid; source box; box (0.0025 0.0025 0) (0.19 0.06 0.01); }
list { set fluid; source csv; file "constant/list.csv"; }' hexagonal
printf 'x,y,z,u,v,w,p\n0.1,0.08,0,1,2,0,30\n0.2,0.1,0,0,0,0,20\n0.11,0.09,0,0,1,0,10\n' \
    >constant/list.csv
check hexagonal 3 simple 3 1 1
regions 'all { set fluid; source box; box (0.0025 0.0025 0) (0.2 0.095 0.01); clip yes; }'
check scattered 4 manual 4 'i % 7 % 3 + (i % 7 % 3 == 2)'

# Two regions off the grid, a solid of constant/geometry; how walls and water fill space
regions 'low { set fluid; source box; box (0.0021 0.0013 0) (0.2 0.05 0.01); clip yes; }
drop { set fluid; source cylinder; p1 (0.15 0.078 0); p2 (0.15 0.078 1); radius 0.02;
velocity (0 -1 0); pressure zero; }'
pier='pier { type searchableCylinder; point1 (0.1 0.04 -1); point2 (0.1 0.04 1); radius 0.015; }'
geometry "$pier"
check pier 2 simple 2 1 1
onRanks 2 setParticles -dry-run -checkWalls >log 2>&1
(cd one && setParticles -dry-run -checkWalls >log 2>&1)
sameLines walls 'Walls and fluid' /rms/ log one/log
says walls.some 'Shepard sum .* at [1-9][0-9]+ particles near walls'
rm constant/geometry

# In 3D: a box, a ball, a closed surface on a lattice that meets the faces between the parts
tank3; control
octahedron constant/triSurface/octa.stl 1
regions 'octa { set fluid; source surface; file "octa.stl"; velocity (1 0 0); }
ball { set fluid; source sphere; centre (0.085 0.045 0.02); radius 0.011; pressure 5; }
low { set fluid; source box; box (-1 -0.0025 -0.0025) (2 0.008 1); clip yes; freeSurface 0.02; }'
check dice 4 manual 4 '(i % 10 < 5) + 2*(int(i/10) % 6 < 3)'
onRanks 4 riprapFoam >log 2>&1
says dice.runs 'Processes = 4'
(cd one && riprapFoam >log 2>&1)
same dice.runs.same . 0.002 one 0.002 --fluid
regions 'low { set fluid; source box; box (0 0 0) (0.1 0.02 0.04); }' hexagonal
check close 2 simple 1 1 2

# Solids of all kinds: on each process those in its cells, bonds and bodies by the first. Water is
# cut at them
glass='materials { glass { rho 2500; E 1e7; nu 0.25; } } pairs { default {
restitution 0.5; friction 0.4; } } walls { material glass; } bonds { weak { calibration moduli;
E 1e6; G 4e5; tensileStrength 2e3; shearStrength 2e3; } }'
solids='grains { set solids; material glass; source box; box (0.005 0.044 0.004) (0.09 0.058 0.036);
packing random; radius 0.002; largestRadius 0.003; solidFraction 0.3; seed 1; }
bar { set solids; material glass; source box; box (0.01 0.034 0.01) (0.09 0.042 0.03);
radius 0.002; }'
dictionary constant/solidProperties <<<"$glass"
regions 'low { set fluid; source box; box (0 0 0) (0.1 0.028 0.04); clip yes; }
float { set solids; material glass; source sphere; centre (0.0508 0.02 0.02); radius 0.012;
particleRadius 0.0015; packing fitted; rigid yes; } '"$solids"
echo 'bonds ( all { type weak; groups (free); gapTolerance 1e-6; } );' >>system/setParticlesDict
check cut 3 manual 3 '(i % 10 < 5) + (int(i/10) % 6 < 2)'
onRanks 3 riprapFoam >log 2>&1
(cd one && riprapFoam >log 2>&1)
same cut.runs . 0.002 one 0.002 --fluid
same cut.runs.solids . 0.002 one 0.002

# Solids alone, for solver dem
sed -i 's/ low {[^}]*}//; s/spacing 0.005; packing square;//' system/setParticlesDict
solver=dem; control
check bodies 2 simple 1 2 1

# picDem
rm constant/solidProperties
block 0.64 0.16 0.01 '64 16 1' "$sides $lower $open $flat"
solver=picDem; control
dictionary constant/picProperties <<<'precision double;'
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
regions 'low { set fluid; source box; box (0.0013 0 0) (0.3 0.08 0.01); }
drop { set fluid; source sphere; centre (0.4 0.1 0.005); radius 0.0301; }'
check grid 2 simple 2 1 1
onRanks 2 riprapFoam >log 2>&1
says grid.runs 'pressure +gathered'
(cd one && riprapFoam >log 2>&1)
same grid.runs.same . 0.002 one 0.002 --fluid

# One message, that of one process
tank2; solver=sphDem; control
simple 2 1 1
refusedOn() # NAME MESSAGE REGIONS [OPTIONS]
{
    local name=bad.$1 message=$2 status said
    regions "$3"
    onRanks 2 setParticles "${@:4}" >log 2>&1; status=$?
    said=$(oneLine | sed 's/\[[0-9]*\] //g')
    if ((status == 0)); then fail "$name" "was accepted"
    elif [[ $(grep -c 'FOAM FATAL' log) != 1 ]]
    then fail "$name" "not one message: ${said:${#said}<400?0:-400}"
    elif ! grep -qE -- "$message" <<<"$said"
    then fail "$name" "the message is not '$message': ${said:${#said}<400?0:-400}"
    else pass "$name"
    fi
}
refusedOn outside 'a: 160 of 960 particles are outside the mesh, the first at \(0.2025 0.0025' \
    'a { set fluid; source box; box (0 0 0) (0.24 0.1 0.01); }'
box='source box; box (0 0 0) (0.2 0.1 0.01);'
refusedOn pressure 'Entry pressure: 1000000000 Pa at .*guards/densityDeviation' \
    "a { set fluid; $box pressure 1e9; }"
# On both sides of the border between the parts, which is at 0.1
refusedOn overlap 'Regions a and b overlap at \(0.1005' "a { set fluid; source box;
box (0.001 0 0) (0.1005 0.1 0.01); } b { set fluid; source box; box (0.098 0.05 0) (0.15 0.06 1); }"
geometry "$pier"
refusedOn pier 'Region a: [1-9][0-9] of 800 particles are in the solid pier of constant' \
    "a { set fluid; $box }"
rm constant/geometry
simple 3 1 1
refusedOn count 'specifies 3 processors but job was started with 2|is not equal to the number of' \
    "a { set fluid; $box }"
