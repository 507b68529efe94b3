#!/bin/bash
# riprapFoam -parallel with solvers dem, sphDem and picDem, solids in the water of both: clouds of 2
# and 3 processes are those of one, to the bit (solids in the water of picDem: nearly), written, put
# together, divided and continued; what several processes cannot do, and processes that fail
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

# Water of a case whose run by one process to 0.03 is beside it, in ../one: two processes
waterOnTwo()    # NAME
{
    divide 2
    control 0.01 0.01
    onRanks 2 >log 2>&1
    says "$1.log" 'Processes = 2, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
}
# They have what one has, and go on; then one process does, and in ../again, where this ends, three
waterGoesOn()   # NAME
{
    same "$1.0.01" . 0.01 ../one 0.01 --fluid
    control 0.02 0.01
    onRanks 2 >log 2>&1
    says "$1.continues" 'Continuing exactly from time 0.01'
    same "$1.0.02" . 0.02 ../one 0.02 --fluid
    reconstructPar >log 2>&1
    same "$1.reconstructed" . 0.02 ../one 0.02 --whole --close --fluid
    sameFields "$1.fields" . ../one 0.02
    cp -r . ../again
    rm -rf 0.01
    control 0.03 0.01
    riprapFoam >log 2>&1
    says "$1.oneGoesOn" 'Continuing exactly from time 0.02'
    same "$1.one" . 0.03 ../one 0.03 --whole --fluid
    cd ../again || exit 1
    divide 3
    control 0.03 0.01
    onRanks 3 >log 2>&1
    says "$1.othersGoOn" 'Continuing exactly from time 0.02'
    same "$1.three" . 0.03 ../one 0.03 --fluid
    sameTables "$1.tables" . ../one
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
says disks.busy 'Busiest process = [12]([.][0-9]+)? of the mean time in steps without waiting'
for t in 0.005 0.01; do same "disks.$t" . $t ../one $t; done
sameTables disks.tables . ../one
reconstructPar >log 2>&1
same disks.reconstructed . 0.01 ../one 0.01 --whole --close
# Older times go when those of all processes are there, written while the run goes on or not
for how in yes no
do
    rm -rf processor*/0.0*
    control 0.01 0.005 "purgeWrite 1; writeAsynchronously $how;"
    onRanks 2 >log 2>&1
    left=$(echo processor*/0.0*)
    if [[ $left == 'processor0/0.01 processor1/0.01' ]]
    then
        pass "disks.purge.$how"
    else
        fail "disks.purge.$how" "$left"
    fi
    same "disks.purged.$how" . 0.01 ../one 0.01
done
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
            'Entry device is gpu: several processes of solver dem run on CPUs '\
'alone.*constant/solidProperties';;
    esac
    mv kept constant/solidProperties
done
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

# Bonded bars that break, while grains leave over an open top
cd "$case" || exit 1
rm -rf one again disks spheres
functions+='
broken { type brokenBonds; libs ("libriprapFoam.so"); }'
# Files in uniform/lagrangian/solids that the first process writes, number for number
sameFiles()     # NAME FOLDER/FILES PATH OTHERPATH, of times. FILES as "a b"
{
    local file wrong='' folder=uniform/lagrangian/solids/${2%%/*}
    for file in ${2#*/}
    do
        [[ -s $3/$folder/$file ]] && cmp -s <(sed '1,/^}/d' "$3/$folder/$file") \
            <(sed '1,/^}/d' "$4/$folder/$file") || wrong+=" $file"
    done
    [[ -z $wrong ]] && pass "$1" || fail "$1" "differ:$wrong"
}
# The case here: 3 processes, which go on; then one, then two, also from the cloud alone
goesOn()        # NAME FOLDER/FILES PATTERN (of the log on 3 processes) one|fromCloud (whose tables)
{
    local name=$1 files=$2 here=$PWD
    control 0.03 0.01
    mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
    divide 3
    control 0.01 0.01
    onRanks 3 >log 2>&1
    says "$name.log" "$3"
    same "$name.0.01" . 0.01 ../one 0.01
    sameFiles "$name.files.0.01" "$files" processor0/0.01 ../one/0.01
    cp -r . ../again
    control 0.02 0.01
    onRanks 3 >log 2>&1
    says "$name.continues" 'Continuing exactly from time 0.01'
    same "$name.0.02" . 0.02 ../one 0.02
    sameFiles "$name.files.0.02" "$files" processor0/0.02 ../one/0.02
    reconstructPar >log 2>&1
    rm -rf 0.01
    control 0.03 0.01
    riprapFoam >log 2>&1
    says "$name.oneGoesOn" 'Continuing exactly from time 0.02'
    same "$name.one" . 0.03 ../one 0.03 --whole --close
    sameFiles "$name.files.one" "$files" 0.03 ../one/0.03
    [[ $4 != one ]] || sameTables "$name.tables" . ../one
    cd ../again || exit 1
    reconstructPar >log 2>&1
    divide 2
    control 0.02 0.01
    onRanks 2 >log 2>&1
    says "$name.othersGoOn" 'Continuing exactly from time 0.01'
    same "$name.two" . 0.02 ../one 0.02 --close
    sameFiles "$name.files.two" "$files" processor0/0.02 ../one/0.02
    rm -rf processor?/0.02/uniform/riprap ../one/0.02/uniform/riprap ../one/0.03
    control 0.03 0.01
    onRanks 2 >log 2>&1
    quiet "$name.fromCloud.says" 'Continuing exactly'
    (cd ../one && riprapFoam >log 2>&1)
    same "$name.fromCloud" . 0.03 ../one 0.03 --close
    sameFiles "$name.fromCloud.files" "$files" processor0/0.03 ../one/0.03
    [[ $4 != fromCloud ]] || sameTables "$name.tables" . ../one
    cd "$here" || exit 1
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
goesOn bonded 'bonds/a b type broken gap' 'broken bonds = [1-9]' fromCloud
# points are in another order
cmp -s <(sed '1,/<CellData/d' VTK/bonds/bonds_0.02.vtp) \
    <(sed '1,/<CellData/d' ../one/VTK/bonds/bonds_0.02.vtp) && pass bonded.lines \
    || fail bonded.lines "VTK/bonds differs"

# Rocks of several disks that roll, one that leaves over the open top, and a beam on a spring
# through all processes
cd "$case" || exit 1
rm -rf one again bonded
functions="${functions%broken *}"'springs { type springForces; libs ("libriprapFoam.so"); } '\
'inside { type regionMass; libs ("libriprapFoam.so"); regions ( left { source box; '\
'box (0 0 -1) (0.1 0.1 1); } ); }'
mkdir rocks && cd rocks || exit 1
tank2
dictionary constant/solidProperties <<<'materials { glass { rho 2500; E 1e7; nu 0.25; } }
pairs { default { restitution 0.5; friction 0.4; rollingFriction 0.1; } }
contact { rolling spring; } walls { material glass; } groups { beam { springs { coil {
anchor (0.06 0.1 0); point (0.06 0.08 0); stiffness 500; damping 1; restLength 0.015; } } } }'
rock='set solids; source clumpsFromOutline; material glass; spheres 6; orientation random; seed 1;
outline ((0 0 0) (0.014 0 0) (0.018 0.008 0) (0.009 0.013 0) (0 0.009 0));'
dictionary system/setParticlesDict <<<"regions ( rocks { $rock velocity (0.6 0.2 0); centres (
(0.015 0.015 0) (0.04 0.015 0) (0.065 0.015 0) (0.09 0.015 0) (0.115 0.015 0) (0.14 0.015 0)
(0.02 0.04 0) (0.045 0.04 0) (0.07 0.04 0) (0.095 0.04 0) (0.12 0.04 0) (0.145 0.04 0)); }
flyer { $rock velocity (0 1.5 0); centres ((0.02 0.085 0)); }
beam { set solids; rigid yes; source box; box (0.04 0.076 -1) (0.18 0.084 1); spacing 0.004;
material glass; group beam; velocity (0.3 -0.5 0); } grains { set solids; material glass;
source box; box (0.16 0.005 -1) (0.19 0.06 1); radius 0.003; velocity (-0.8 0 0); } );"
setParticles >log 2>&1 || fail rocks.made "$(oneLine | tail -c 300)"
says rocks.bodies ' 14 clumps'
goesOn rocks \
    'clumps/position U omega orientationReal orientationImaginary mass inertia group' \
    'Processes = 3, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*' one

# Water: the dam break of the tutorial on 2 processes, which go on; then one, then three
cd "$case" || exit 1
rm -rf one again rocks
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
waterOnTwo water
waterGoesOn water
for word in gpu noSuchGpu
do
    cp constant/sphProperties kept
    case $word in
        gpu)
            # where there is one the run is compared with one process on it
            [[ -e /dev/nvidiactl ]] && { mv kept constant/sphProperties; continue; }
            echo 'device gpu;' >>constant/sphProperties
            refusedOn 3 waterGpu \
                'Entry device is gpu, but .*: process 0 on .*constant/sphProperties';;
        noSuchGpu)
            printf 'device gpu;\ngpu 99;\n' >>constant/sphProperties
            refusedOn 3 waterNoSuchGpu \
                'Entry gpu is 99, and .*: process 0 on .*constant/sphProperties';;
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

# Solids in the water: a bonded gate that is held at its foot, a body with faces, grains and a bar
# that is moved; 3 processes, which go on; then one, then two
cd "$case" || exit 1
rm -rf one waves
mkdir gate && cd gate || exit 1
library='libs ("libriprapFoam.so");'
functions="energy { type energyBalance; $library } solids { type solidEnergies; $library }
motion { type groupMotion; $library } walls { type solidWallForce; $library }
broken { type brokenBonds; $library }
inside { type regionMass; $library regions ( left { source box; box (0 0 -1) (0.1 0.1 1); } ); }
tip { type particleDisplacement; $library origIds (20 21); }
mesh { type particlesToMesh; $library writeControl writeTime; }
level { type waterLevel; $library points ((0.03 0 0)); }"
tank2
dictionary constant/sphProperties <<<'viscosity laminarAndArtificial; XSPH 0.05; antiClump 0.01;
smoothingLength { model variable; maxGrowth 1.1; } walls { impermeable yes; }
coupling extrapolated; couplingCoeffs { XSPH yes; antiClump yes; fluidForce impulse; }'
dictionary constant/solidProperties <<<'materials { rubber { rho 1100; } light { rho 600; } }
contact { normal linear; tangential history; } pairs { default { stiffness 1e5; restitution 0.5;
friction 0.3; stiffnessRatio 0.5; } } walls { material rubber; }
bonds { rubber { calibration moduli; E 1e6; G 4e5; tensileStrength 5e3; shearStrength 5e3; } }
groups { gate {} body {} foot { fixed all; } bar { motion { solidBodyMotionFunction linearMotion;
linearMotionCoeffs { velocity (-0.3 0 0); } } } }'
dictionary system/setParticlesDict <<<'spacing 0.005; packing square; regions (
water { set fluid; source box; box (0 0 -1) (0.09 0.055 1); velocity (0.6 0 0);
pressure hydrostatic; }
gate { set solids; source box; box (0.1 0.005 -1) (0.11 0.06 1); radius 0.0025; material rubber;
group gate; mass cell; }
foot { set solids; source box; box (0.1 0 -1) (0.11 0.005 1); radius 0.0025; material rubber;
group foot; mass cell; }
body { set solids; source box; box (0.01 0.06 -1) (0.07 0.075 1); spacing 0.005; rigid yes;
material light; group body; velocity (0.2 -1 0); }
bar { set solids; source box; box (0.13 0.02 -1) (0.14 0.03 1); radius 0.0025; material rubber;
group bar; mass cell; }
grains { set solids; source box; box (0.15 0 -1) (0.19 0.02 1); radius 0.0025; packing layers;
material rubber; velocity (-1 0 0); } );
bonds ( gate { type rubber; groups (gate foot); gapTolerance 1e-6; } );'
setParticles >log 2>&1 || fail gate.made "$(oneLine | tail -c 300)"
control 0.03 0.01
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
# The domain is that of all motion until endTime
divide 3
control 0.03 0.01 'stopAt nextWrite;'
onRanks 3 >log 2>&1
says gate.log 'Processes = 3, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
says gate.faces 'impermeable +1 of 1 rigid bodies'
both()          # NAME TIME [OPTIONS]: both clouds, and files of solids
{
    local name=$1 t=$2
    shift 2
    same "$name.solids" . "$t" ../one "$t" "$@"
    same "$name.fluid" . "$t" ../one "$t" --fluid "$@"
}
both gate.0.01 0.01
sameFiles gate.bonds 'bonds/a b type broken gap' processor0/0.01 ../one/0.01
sameFiles gate.bodies 'clumps/position U omega orientationReal' processor0/0.01 ../one/0.01
onRanks 3 >log 2>&1
says gate.continues 'Continuing exactly from time 0.01'
both gate.0.02 0.02
reconstructPar >log 2>&1
both gate.reconstructed 0.02 --whole --close
sameFields gate.fields . ../one 0.02
cp -r . ../again
rm -rf 0.01
control 0.03 0.01
riprapFoam >log 2>&1
says gate.oneGoesOn 'Continuing exactly from time 0.02'
both gate.one 0.03 --whole --close
cd ../again || exit 1
divide 2
control 0.03 0.01
onRanks 2 >log 2>&1
says gate.othersGoOn 'Continuing exactly from time 0.02'
both gate.two 0.03 --close
sameFiles gate.bodies.two 'clumps/position U omega orientationReal' processor0/0.03 ../one/0.03
sameTables gate.tables . ../one
echo 'sleep { speed 1e-3; after 0.01; }' >>constant/solidProperties
refusedOn 2 gateSleep 'solids in a fluid do not sleep.*constant/solidProperties'

# Boxes with faces that float among stones of several spheres, in 3D; 3 processes
cd "$case" || exit 1
rm -rf one again gate
mkdir boxes && cd boxes || exit 1
functions="energy { type energyBalance; $library } motion { type groupMotion; $library }
forces { type particleForces; $library groups (boxes stones); } walls { type solidWallForce; \
$library } floor { type particleForces; $library patches (lower); }"
tank3
dictionary constant/sphProperties <<<'precision double; timeIntegration leapfrog; XSPH 0.05;
walls { impermeable yes; } coupling pressureApproximation;
couplingCoeffs { fluidForce interpolated; }'
dictionary constant/solidProperties <<<'materials { wood { rho 700; } rock { rho 2500; } }
contact { normal linear; } pairs { default { stiffness 1e4; restitution 0.5; friction 0.4; } }
walls { material rock; } groups { boxes {} stones {} }'
box='set solids; source box; spacing 0.005; rigid yes; material wood; group boxes;'
dictionary system/setParticlesDict <<<"spacing 0.005; packing square; regions (
water { set fluid; source box; box (0 0 0) (0.1 0.03 0.04); velocity (0.3 0 0);
pressure hydrostatic; }
left { $box box (0.01 0.032 0.01) (0.05 0.042 0.03); velocity (0.2 -0.8 0); }
right { $box box (0.06 0.032 0.01) (0.08 0.042 0.03); velocity (-0.5 -0.8 0.2); }
stones { set solids; source box; rigid yes; spacing 0.005; material rock; group stones;
box (0.085 0.035 0.01) (0.095 0.045 0.02); velocity (0 -1 0); } );"
setParticles >log 2>&1 || fail boxes.made "$(oneLine | tail -c 300)"
control 0.01 0.01
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 3
onRanks 3 >log 2>&1
says boxes.faces 'impermeable +3 of 3 rigid bodies'
both boxes.0.01 0.01
sameFiles boxes.bodies 'clumps/position U omega orientationReal' processor0/0.01 ../one/0.01
sameTables boxes.tables . ../one

# Water about a cylinder among walls, through periodic sides that are cut, too; 3 processes
cd "$case" || exit 1
rm -rf one boxes
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

# Water on a grid: the dam break of the tutorial on 2 processes, which go on; then one, then three.
# Each process solves for the pressure of all cells, so bits are those of one process
cd "$case" || exit 1
rm -rf one pier
solver=picDem
functions="front { type frontPosition; $library } level { type waterLevel; $library
points ((0.01 0 0) (0.2 0 0)); } energy { type energyBalance; $library }
parts { type particleForces; $library
patches (leftWall floor); } sensors { type particleProbes; $library fields (p U volumeFraction);
probeLocations ((0 0.05 0) (0.07 0 0) (0.146 0.02 0)); }
points { type probes; libs (\"libsampling.so\"); fields (p U); writeControl timeStep;
probeLocations ((0.004 0.05 0.005) (0.14 0.02 0.005)); }
floor { type surfaceFieldValue; libs (\"libfieldFunctionObjects.so\"); fields (p);
operation areaIntegrate; regionType patch; name floor; writeFields no; writeControl timeStep; }"
mkdir grid && cd grid || exit 1
cp -r "$root"/tutorials/sphDem/damBreak/{constant,system} .
dictionary constant/picProperties <<<'precision mixed; walls { slip noSlip; }'
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
control 0.03 0.01
{ blockMesh && setParticles; } >log 2>&1 || fail grid.made "$(oneLine | tail -c 300)"
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
waterOnTwo grid
says grid.sent 'Sent in all: steps [0-9.]+ [kM]B, particles to other processes [0-9]+'
says grid.pressure 'pressure +gathered: each process solves for all 10950 cells'
waterGoesOn grid
for field in p U
do
    cmp -s <(tail -n 1 postProcessing/points/0.02/$field) \
        <(tail -n 1 ../one/postProcessing/points/0/$field) \
        && [[ -s postProcessing/points/0.02/$field ]] && pass grid.probes.$field \
        || fail grid.probes.$field "other values of OpenFOAM's probes"
done

# The pressure divided, too: results to round-off
cp system/fvSolution kept
sed -i 's/cudaPCG;/& gatheredCells 0;/' system/fvSolution
sed -i 's/mixed;/double;/' constant/picProperties
rm -rf 0.01 0.02 processor*/0.0* ../one/{0.0*,postProcessing}
cp constant/picProperties ../one/constant
(cd ../one && control 0.01 0.01 && riprapFoam >log 2>&1)
control 0.01 0.01
divide 3
onRanks 3 >log 2>&1
says grid.divided 'pressure +divided over the processes.*gatheredCells 0'
same grid.nearly . 0.01 ../one 0.01 --fluid --nearly
mv kept system/fvSolution

# What several processes of it cannot have: said by the core, with file and entry
refusedEntry()  # NAME FILE TEXT MESSAGE
{
    local made=true
    [[ ! -e $2 ]] || { cp "$2" kept; made=false; }
    if $made; then dictionary "$2" <<<"$3"; else echo "$3" >>"$2"; fi
    refusedOn 3 "grid.$1" "$4"
    if $made; then rm "$2"; else mv kept "$2"; fi
}
pic=constant/picProperties
refusedEntry gpu $pic 'device gpu;' 'Entry device, with -parallel: .*CPUs alone.*picProperties'
refusedEntry Courant $pic 'guards { Courant 8; }' \
    'Entry Courant, with -parallel: .* 6 cells a step.*picProperties.guards'
refusedEntry linearSolver system/fvSolution 'solvers { p { solver PCG; preconditioner DIC; } }' \
    'Entry solver of p, with -parallel: several processes need p solved by cudaPCG.*fvSolution'
functions='momentum { type momentumBalance; libs ("libriprapFoam.so"); }'
control 0.02 0.01
refusedOn 3 grid.momentum \
    'Function object momentum .*: momentum is balanced on one process.*controlDict.functions'
mkdir ../small && cd ../small || exit 1
functions=''
tank2
control 0.01 0.01
dictionary constant/picProperties </dev/null
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; } }'
regions 'pool { set fluid; source box; box (0 0 -1) (0.1 0.05 1); }'
setParticles >log 2>&1
divide 3
refusedOn 3 grid.tooMany \
    'Entry numberOfSubdomains: 3 processes are too many for this mesh.*decomposeParDict'

# Solids in the water of picDem: stones that roll, light ones that float, a plate that is moved,
# water that sticks to them; 3 processes, which go on, then one, then two
cd "$case" || exit 1
rm -rf one again grid small
mkdir stones && cd stones || exit 1
functions="energy { type energyBalance; $library } solids { type solidEnergies; $library }
motion { type groupMotion; $library } level { type waterLevel; $library points ((0.03 0 0)); }
parts { type particleForces; $library groups (stones); } walls { type solidWallForce; $library }"
block 0.2 0.1 0.01 '80 40 1' "$sides $lower $open $flat"
geometry 'plate { type searchableBox; min (0.1 0.012 -1); max (0.112 0.09 1); }'
moves='motion { plate { patches (plate); solidBodyMotionFunction linearMotion; '
moves+='linearMotionCoeffs { velocity (0.02 0.3 0); } } }'
dictionary constant/picProperties \
    <<<"device auto; precision double; viscosity implicit; walls { slip noSlip; $moves }"
dictionary constant/fluidProperties <<<'rho 1000; nu 1e-4;'
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-12; relTol 0; } }'
dictionary constant/solidProperties <<<"device auto;
materials { rock { rho 2500; } cork { rho 400; } } contact { normal linear; tangential history; }
pairs { default { stiffness 1e4; restitution 0.4; friction 0.4; } }
walls { material rock; $moves } groups { stones {} corks {} }"
dictionary system/setParticlesDict <<<'spacing 0.00125; packing square; regions (
water { set fluid; source box; box (0 0 -1) (0.095 0.055 1); pressure hydrostatic; }
stones { set solids; source box; box (0.12 0 -1) (0.19 0.05 1); radius 0.006; packing layers;
material rock; group stones; velocity (-0.4 0 0); }
corks { set solids; source box; box (0.01 0.06 -1) (0.07 0.08 1); radius 0.0055; packing layers;
material cork; group corks; velocity (0.1 -0.5 0); } );'
setParticles >log 2>&1 || fail stones.made "$(oneLine | tail -c 300)"
control 0.03 0.01
mkdir ../one && cp -r 0 constant system ../one && (cd ../one && riprapFoam >log 2>&1)
divide 3
control 0.03 0.01 'stopAt nextWrite;'
onRanks 3 >log 2>&1
says stones.log 'Processes = 3, largest part = [0-9.]+ of the mean, ghosts = [1-9][0-9]*'
says stones.pressure 'pressure +divided over the processes, as there are solids'
both stones.0.01 0.01 --nearly
onRanks 3 >log 2>&1
says stones.continues 'Continuing exactly from time 0.01'
both stones.0.02 0.02 --nearly
reconstructPar >log 2>&1
both stones.reconstructed 0.02 --whole --nearly
cp -r . ../again
control 0.03 0.01
riprapFoam >log 2>&1
says stones.oneGoesOn 'Continuing exactly from time 0.02'
both stones.one 0.03 --whole --nearly
cd ../again || exit 1
divide 2
onRanks 2 >log 2>&1
says stones.othersGoOn 'Continuing exactly from time 0.02'
both stones.two 0.03 --nearly
