#!/bin/bash
# riprapFoam -parallel with solvers dem and sphDem: clouds of 2 and 3 processes are those of one, to
# the bit, written, put together, divided and continued; what several processes cannot do, and
# processes that fail
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL parallel no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam decomposePar reconstructPar
do
    command -v $program >/dev/null || { echo "FAIL parallel no $program"; exit 1; }
done
command -v mpirun >/dev/null || { echo "SKIP parallel no mpirun"; exit 0; }
python=${RIPRAP_PYTHON:-python3}
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=parallel
. "$root/tests/regression/setParticlesCases"
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

launch()    # N [OPTIONS]: becomes mpirun
{
    local n=$1
    shift
    exec mpirun -np "$n" --oversubscribe --mca mpi_yield_when_idle 1 riprapFoam -parallel "$@"
}
onRanks() { (launch "$@"); }
divide()    # N [OPTIONS]
{
    local n=$1
    shift
    rm -rf processor*
    dictionary system/decomposeParDict \
        <<<"numberOfSubdomains $n; method simple; simpleCoeffs { n ($n 1 1); delta 0.001; }"
    FOAM_SIGFPE=false decomposePar "$@" >log.divide 2>&1 || tail -5 log.divide
}
control()   # ENDTIME INTERVAL [ENTRIES]
{
    dictionary system/controlDict <<<"application riprapFoam; solver $solver; \
startFrom latestTime; startTime 0; stopAt endTime; endTime $1;
deltaT 1e-4; adjustTimeStep yes; sampleInterval $2; writeControl adjustableRunTime; \
writeInterval $2; writeFormat binary; writePrecision 10;
timePrecision 9; functions { $functions } ${3:-}"
}
solver=dem
functions='energy { type solidEnergies; libs ("libriprapFoam.so"); } walls { type solidWallForce; '\
'libs ("libriprapFoam.so"); }
grains { type groupMotion; libs ("libriprapFoam.so"); } chains { type contactChains; '\
'libs ("libriprapFoam.so"); writeControl writeTime; }'
same()      # NAME CASE TIME OTHER OTHERTIME [OPTIONS]
{
    local name=$1 said
    shift
    said=$("$python" "$root/tests/python/sameClouds.py" "$@" 2>&1) && pass "$name" \
        || fail "$name" "$(tail -1 <<<"$said")"
}
# Numbers of all tables to round-off
sameTables()    # NAME CASE OTHER
{
    local said
    said=$("$python" - "$2" "$3" 2>&1 <<'END'
import glob, os, sys
wrong = []


def rows(case, table):
    """By time: a run that goes on begins another folder"""
    of = {}
    for path in sorted(glob.glob(os.path.join(case, 'postProcessing', table[0], '*', table[1])),
                       key=lambda p: float(p.split('/')[-2])):
        for row in ([float(x.strip('()')) for x in line.split()]
                    for line in open(path) if line[0] != '#'):
            of[row[0]] = row
    return of


names = {(p.split('/')[-3], p.split('/')[-1])
         for p in glob.glob(os.path.join(sys.argv[2], 'postProcessing/*/*/*.dat'))
         if 'wallTimes' not in p}
tables = len(names)
for table in sorted(names):
    a, b = (rows(case, table) for case in sys.argv[1:3])
    bound = 1e-9*max(abs(x) for row in b.values() for x in row)
    if set(a) != set(b) or not all(len(a[t]) == len(b[t])
                                   and all(abs(x - y) <= bound for x, y in zip(a[t], b[t]))
                                   for t in b):
        wrong.append(table[1])
print(' '.join(wrong), tables, 'tables')
sys.exit(bool(wrong) or tables < 4)
END
    ) && pass "$1" || fail "$1" "other numbers: $said"
}

# Fields of the mesh, binary, number for number
sameFields()    # NAME CASE OTHER TIME
{
    local field wrong=''
    for field in p U alpha.water
    do
        [[ -s $2/$4/$field ]] && cmp -s <(sed '1,/^internalField/d' "$2/$4/$field") \
            <(sed '1,/^internalField/d' "$3/$4/$field") || wrong+=" $field"
    done
    [[ -z $wrong ]] && pass "$1" || fail "$1" "differ:$wrong"
}

# Disks: the column of the tutorial, whose gate goes at once
mkdir disks && cd disks || exit 1
cp -r "$root"/tutorials/dem/columnCollapse/{constant,system} .
control 0.01 0.005
printf '(\n(-1 ((0 0 0) (0 0 0)))\n(0 ((0 0 0) (0 0 0)))\n(0.001 ((0.01 0 0) (0 0 0)))\n(0.01 '\
'((0.1 0 0) (0 0 0)))\n(0.05 ((0.5 0 0) (0 0 0)))\n(100 ((0.5 0 0) (0 0 0)))\n)\n' >constant/gate
{ blockMesh && setParticles; } >log 2>&1 || fail disks.made "$(tail -1 log)"
divide 2 -cellDist
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
onRanks 2 >log 2>&1
says disks.log 'Processes = 2, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
for t in 0.005 0.01; do same "disks.$t" . $t ../one $t; done
sameTables disks.tables . ../one
reconstructPar >log 2>&1
same disks.reconstructed . 0.01 ../one 0.01 --whole --close
cd ..; rm -rf one

# Spheres that roll over a cylinder among walls: 3 processes, which go on; then one, then two
grains='grains { set solids; material glass; source box; '\
'box (0.005 0.005 0.004) (0.04 0.055 0.036); packing random; radius 0.002; largestRadius 0.003; '\
'solidFraction 0.4; seed 1; velocity (0.8 0 0); }'
glass='contact { normal linear; tangential history; rolling spring; } '\
'materials { glass { rho 2500; } } pairs { default { stiffness 2e4; restitution 0.5; '\
'friction 0.4; stiffnessRatio 0.3; rollingFriction 0.05; } } walls { material glass; }'
mkdir spheres && cd spheres || exit 1
tank3
geometry 'pier { type searchableCylinder; point1 (0.06 0 -0.01); point2 (0.06 0 0.05); '\
'radius 0.012; }'
dictionary constant/solidProperties <<<"$glass"
dictionary system/setParticlesDict <<<"regions ( $grains );"
setParticles >log 2>&1 || fail spheres.made "$(oneLine | tail -c 300)"
control 0.03 0.01
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 3
control 0.01 0.01
onRanks 3 >log 2>&1
says spheres.starts 'Positions of lagrangian/solids are those of the case'
same spheres.0.01 . 0.01 ../one 0.01
cp -r . ../again
control 0.02 0.01
onRanks 3 >log 2>&1
says spheres.continues 'Continuing exactly from time 0.01'
same spheres.0.02 . 0.02 ../one 0.02
reconstructPar >log 2>&1
rm -rf 0.01
control 0.03 0.01
riprapFoam >log 2>&1
says spheres.oneGoesOn 'Continuing exactly from time 0.02'
same spheres.one . 0.03 ../one 0.03 --whole
cd ../again || exit 1
reconstructPar >log 2>&1
divide 2
control 0.02 0.01
onRanks 2 >log 2>&1
says spheres.othersGoOn 'Continuing exactly from time 0.01'
same spheres.two . 0.02 ../one 0.02

# What several processes cannot do; processes that fail
refusedOn()     # N NAME MESSAGE [OPTIONS]
{
    local n=$1 name=bad.$2 message=$3 status said start=$SECONDS
    shift 3
    onRanks "$n" "$@" >log 2>&1; status=$?
    said=$(oneLine | sed 's/\[[0-9]*\] //g')
    if ((status == 0)); then fail "$name" "was accepted"
    elif ((SECONDS - start > 20)); then fail "$name" "took $((SECONDS - start)) s"
    elif [[ $(grep -c 'FOAM FATAL' log) != 1 ]]
    then fail "$name" "not one message: ${said:${#said}<400?0:-400}"
    elif ! grep -qE -- "$message" <<<"$said"
    then fail "$name" "the message is not '$message': ${said:${#said}<400?0:-400}"
    else pass "$name"
    fi
}
for word in sleep gpu
do
    cp constant/solidProperties kept
    case $word in
        sleep) echo 'sleep { speed 1e-3; after 0.01; }' >>constant/solidProperties
        refusedOn 2 sleep 'Entry speed is 0.001: '\
'solids sleep on one process alone.*constant/solidProperties.sleep';;
        gpu) echo 'device gpu;' >>constant/solidProperties; refusedOn 2 gpu \
            'Entry device is gpu: several processes run on CPUs alone.*constant/solidProperties';;
    esac
    mv kept constant/solidProperties
done
refusedOn 2 solver 'Entry solver is picDem, which runs on one process' -solver picDem
refusedOn 3 count \
    'umber of processor directories = 2 is not equal to the number of (processors|ranks) = 3'
refusedOn 2 dryRun 'Options -parallel and -dry-run exclude each other' -dry-run

# A file of one process that is cut short: that time is passed over by all
head -c 300 processor1/0.02/lagrangian/solids/U >cut; cp cut processor1/0.02/lagrangian/solids/U
onRanks 2 >log 2>&1
says damaged 'Time 0.02 is passed over: processor1: lagrangian/solids/U is cut short'
same damaged.goesOn . 0.02 ../one 0.02

# A disk that takes nothing more from one process
control 0.03 0.01
: >processor1/0.03
refusedOn 2 full 'processor1/0.03'
rm processor1/0.03
onRanks 2 >log 2>&1
says full.passedOver 'Time 0.03 is passed over: processor0: the run that wrote it was stopped'
says full.continues 'Continuing exactly from time 0.02'
same full.goesOn . 0.03 ../one 0.03

# One process is killed: the other ends, and the next run goes on from the last time
rm -rf processor*/0.03
control 0.5 0.01
launch 2 >log 2>&1 &
run=$!
for _ in $(seq 200); do [[ -e processor1/0.03/uniform/riprap/manifest ]] && break; sleep 0.1; done
start=$SECONDS
kill -9 "$(pgrep -P "$run" riprapFoam | tail -1)"
if wait "$run"
then
    fail killed.status 'mpirun says that all went well'
else
    pass killed.status
fi
if ((SECONDS - start < 15))
then
    pass killed.soon
else
    fail killed.soon "$((SECONDS - start)) s"
fi
rm -rf processor*/0.0[3-9]* processor*/0.[1-9]*
control 0.03 0.01
onRanks 2 >log 2>&1
says killed.goesOn 'Continuing exactly from time 0.02'
same killed.same . 0.03 ../one 0.03

# Bonded bars that break, while grains leave over an open top: 3 processes, which go on; then one,
# then two, also from the cloud alone
cd "$case" || exit 1
rm -rf one again disks spheres
functions+='
broken { type brokenBonds; libs ("libriprapFoam.so"); }'
# Files of bonds, which the first process writes, number for number
sameBonds()     # NAME PATH OTHERPATH, of times
{
    local file wrong=''
    for file in a b type broken gap
    do
        [[ -s $2/uniform/lagrangian/solids/bonds/$file ]] \
            && cmp -s <(sed '1,/^}/d' "$2/uniform/lagrangian/solids/bonds/$file") \
                <(sed '1,/^}/d' "$3/uniform/lagrangian/solids/bonds/$file") || wrong+=" $file"
    done
    [[ -z $wrong ]] && pass "$1" || fail "$1" "differ:$wrong"
}
mkdir bonded && cd bonded || exit 1
tank2
dictionary constant/solidProperties <<<'materials { glass { rho 2500; E 1e7; nu 0.25; } }
pairs { default { restitution 0.5; friction 0.3; } } walls { material glass; }
bonds { weak { calibration moduli; E 1e6; G 4e5; tensileStrength 2e3; shearStrength 2e3; } }'
dictionary system/setParticlesDict <<<'regions ( bar { set solids; material glass; source box;
box (0.02 0.07 -1) (0.2 0.1 1); radius 0.005; velocity (0.4 0.5 0); } grains { set solids;
material glass; source box; box (0.02 0 -1) (0.2 0.04 1); radius 0.005; packing layers;
velocity (0.4 0 0); } ); bonds ( all { type weak; groups (free); gapTolerance 1e-6; } );'
setParticles >log 2>&1 || fail bonded.made "$(oneLine | tail -c 300)"
control 0.03 0.01
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 3
control 0.01 0.01
onRanks 3 >log 2>&1
says bonded.log 'broken bonds = [1-9]'
same bonded.0.01 . 0.01 ../one 0.01
sameBonds bonded.files.0.01 processor0/0.01 ../one/0.01
cp -r . ../again
control 0.02 0.01
onRanks 3 >log 2>&1
says bonded.continues 'Continuing exactly from time 0.01'
same bonded.0.02 . 0.02 ../one 0.02
sameBonds bonded.files.0.02 processor0/0.02 ../one/0.02
# points are in another order
cmp -s <(sed '1,/<CellData/d' VTK/bonds/bonds_0.02.vtp) \
    <(sed '1,/<CellData/d' ../one/VTK/bonds/bonds_0.02.vtp) && pass bonded.lines \
    || fail bonded.lines "VTK/bonds differs"
reconstructPar >log 2>&1
rm -rf 0.01
control 0.03 0.01
riprapFoam >log 2>&1
says bonded.oneGoesOn 'Continuing exactly from time 0.02'
same bonded.one . 0.03 ../one 0.03 --whole --close
sameBonds bonded.files.one 0.03 ../one/0.03
cd ../again || exit 1
reconstructPar >log 2>&1
divide 2
control 0.02 0.01
onRanks 2 >log 2>&1
says bonded.othersGoOn 'Continuing exactly from time 0.01'
same bonded.two . 0.02 ../one 0.02 --close
rm -rf processor?/0.02/uniform/riprap ../one/0.02/uniform/riprap ../one/0.03
control 0.03 0.01
onRanks 2 >log 2>&1
quiet bonded.fromCloud.says 'Continuing exactly'
(cd ../one && riprapFoam >log 2>&1)
same bonded.fromCloud . 0.03 ../one 0.03 --close
sameBonds bonded.fromCloud.files processor0/0.03 ../one/0.03
sameTables bonded.tables . ../one

# Water: the dam break of the tutorial on 2 processes, which go on; then one, then three
cd "$case" || exit 1
rm -rf one again bonded
solver=sphDem
functions='front { type frontPosition; libs ("libriprapFoam.so"); origin (0 0 0); '\
'direction (1 0 0); up (0 1 0); }
level { type waterLevel; libs ("libriprapFoam.so"); '\
'points ((0.01 0 0) (0.2 0 0)); } energy { type energyBalance; libs ("libriprapFoam.so"); }
force { type wallForce; libs ("libriprapFoam.so"); } parts { type particleForces; '\
'libs ("libriprapFoam.so"); patches (leftWall floor); }
sensors { type particleProbes; libs ("libriprapFoam.so"); '\
'probeLocations ((0 0.05 0) (0.07 0.0 0) (0.146 0.02 0)); fields (p U rho volumeFraction); }
mesh { type particlesToMesh; libs ("libriprapFoam.so"); writeControl writeTime; }'
mkdir water && cd water || exit 1
cp -r "$root"/tutorials/sphDem/damBreak/{constant,system} .
control 0.03 0.01
{ blockMesh && setParticles; } >log 2>&1 || fail water.made "$(oneLine | tail -c 300)"
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 2
control 0.01 0.01
onRanks 2 >log 2>&1
says water.log 'Processes = 2, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
same water.0.01 . 0.01 ../one 0.01 --fluid
control 0.02 0.01
onRanks 2 >log 2>&1
says water.continues 'Continuing exactly from time 0.01'
same water.0.02 . 0.02 ../one 0.02 --fluid
reconstructPar >log 2>&1
same water.reconstructed . 0.02 ../one 0.02 --whole --close --fluid
sameFields water.fields . ../one 0.02
cp -r . ../again
rm -rf 0.01
control 0.03 0.01
riprapFoam >log 2>&1
says water.oneGoesOn 'Continuing exactly from time 0.02'
same water.one . 0.03 ../one 0.03 --whole --fluid
cd ../again || exit 1
divide 3
control 0.03 0.01
onRanks 3 >log 2>&1
says water.othersGoOn 'Continuing exactly from time 0.02'
same water.three . 0.03 ../one 0.03 --fluid
sameTables water.tables . ../one
for word in gpu solids
do
    cp constant/sphProperties kept
    case $word in
        gpu) echo 'device gpu;' >>constant/sphProperties; refusedOn 3 waterGpu \
            'Entry device is gpu: several processes run on CPUs alone.*constant/sphProperties';;
        solids)
            dictionary constant/solidProperties <<<"$glass"
            refusedOn 3 waterSolids \
                'solids in its fluid, which run on one process alone.*constant/solidProperties';;
    esac
    mv kept constant/sphProperties
done

# A wave maker and a paddle in the dam break: 2 processes, then 3, then one
cd "$case" || exit 1
rm -rf one again water
mkdir waves && cd waves || exit 1
functions='level { type waterLevel; libs ("libriprapFoam.so"); points ((0.03 0 0) (0.13 0 0)); }
energy { type energyBalance; libs ("libriprapFoam.so"); }
force { type wallForce; libs ("libriprapFoam.so"); } parts { type particleForces; '\
'libs ("libriprapFoam.so"); patches (leftWall floor); surfaces (paddle); }
mesh { type particlesToMesh; libs ("libriprapFoam.so"); writeControl writeTime; }'
cp -r "$root"/tutorials/sphDem/damBreak/{constant,system} .
sed -i 's/pressure .*hydrostatic;/& clip yes;/' system/setParticlesDict
geometry 'paddle { type searchableBox; min (0.06 0.05 -1); max (0.08 0.15 1); }'
dictionary constant/sphProperties <<<'precision double; XSPH 0.05;
smoothingLength { model variable; maxGrowth 1.1; }
walls { spacing 0.0025; motion { piston { patches (leftWall);
solidBodyMotionFunction oscillatingLinearMotion;
oscillatingLinearMotionCoeffs { amplitude (0.01 0 0); omega 60; } }
paddle { patches (paddle); solidBodyMotionFunction rotatingMotion;
rotatingMotionCoeffs { origin (0.07 0.1 0); axis (0 0 1); omega 10; } } } }'
control 0.03 0.01
{ blockMesh && setParticles; } >log 2>&1 || fail waves.made "$(oneLine | tail -c 300)"
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 2
# The domain is that of all motion until endTime
control 0.03 0.01 'stopAt nextWrite;'
onRanks 2 >log 2>&1
says waves.log 'Processes = 2, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
same waves.0.01 . 0.01 ../one 0.01 --fluid
reconstructPar >log 2>&1
sameFields waves.fields . ../one 0.01
divide 3
onRanks 3 >log 2>&1
says waves.othersGoOn 'Continuing exactly from time 0.01'
same waves.three . 0.02 ../one 0.02 --fluid
reconstructPar -latestTime >log 2>&1
control 0.03 0.01
riprapFoam >log 2>&1
says waves.oneGoesOn 'Continuing exactly from time 0.02'
same waves.one . 0.03 ../one 0.03 --whole --fluid
sameTables waves.tables . ../one

# Water about a cylinder among walls, through periodic sides that are cut, too; 3 processes
cd "$case" || exit 1
rm -rf one waves
mkdir pier && cd pier || exit 1
functions='energy { type energyBalance; libs ("libriprapFoam.so"); } parts { type particleForces; '\
'libs ("libriprapFoam.so"); surfaces (pier); }
force { type wallForce; libs ("libriprapFoam.so"); } level { type waterLevel; '\
'libs ("libriprapFoam.so"); points ((0.01 0 0.02)); }'
block 0.1 0.06 0.04 '10 6 4' "left { type cyclic; neighbourPatch right; \
faces ((0 4 7 3)); } right { type cyclic; neighbourPatch left; faces ((1 2 6 5)); }
$lower $open back { type wall; faces ((0 3 2 1)); } front { type wall; faces ((4 5 6 7)); }"
geometry 'pier { type searchableCylinder; point1 (0.06 -0.01 0.02); point2 (0.06 0.07 0.02); '\
'radius 0.01; }'
dictionary constant/sphProperties \
    <<<'precision double; timeIntegration leapfrog; densityDiffusion fourtakas; XSPH 0.05;'
regions 'column { set fluid; source box; box (0 0 0) (0.04 0.04 0.04); velocity (0.8 0 0); '\
'pressure hydrostatic; }'
control 0.02 0.02
setParticles >log 2>&1 || fail pier.made "$(oneLine | tail -c 300)"
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 3
onRanks 3 >log 2>&1
same pier.0.02 . 0.02 ../one 0.02 --fluid
sameTables pier.tables . ../one
