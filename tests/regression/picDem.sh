#!/bin/bash
# Water by PIC: a run, its fields, exact restart, and one message for every entry that can be wrong
# and every mesh that does not fit.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL picDem no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL picDem no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=picDem
. "$root/tests/regression/setParticlesCases"

control()   # ENTRIES, the last of which count
{
    dictionary system/controlDict <<<"application riprapFoam; solver picDem; startFrom latestTime; \
startTime 0; stopAt endTime; endTime 0.1;
deltaT 1e-3; adjustTimeStep yes; maxCo 0.5; sampleInterval 0.05; writeControl adjustableRunTime; \
writeInterval 0.05; writeFormat ascii; writePrecision 12; $1"
}
pic() { dictionary constant/picProperties <<<"$1"; }
good()          # after a mesh: everything else as it should be, and half the tank full
{
    control ''; pic ''
    dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
    dictionary system/setParticlesDict <<<"spacing 0.005; regions ( pool { set fluid; source box; \
box (0 0 -1) (0.1 0.05 1); velocity (0 0 0); pressure hydrostatic; } );"
    setParticles >log 2>&1     # which refuses some of the meshes too
}

# A run and its fields
tank2; good
pic 'guards { maxSpeed 0.1; }'
refused tooFast 'Guard at time .* goes at [0-9.]+ m/s; guards/maxSpeed allows 0.1' riprapFoam
pic ''
riprapFoam >log 2>&1; says run '^End'
says volumeEachStep 'Volume = [0-9.e-]+, error = -?[0-9.e-]+, put right so far'
for field in p U alpha.water lagrangian/fluid/positions
do
    [[ -s 0.1/$field ]] && pass "wrote.$field" || fail "wrote.$field" "no 0.1/$field"
done

# No scheme is needed: fvSolution is read without fvSchemes beside it
mv system/fvSchemes schemes
riprapFoam -dry-run >log 2>&1; says withoutSchemes '^End'
mv schemes system/fvSchemes

# The same in two runs, to the bit
mkdir whole; cp -r 0.1 whole
rm -rf 0.05 0.1
control 'endTime 0.05;'; riprapFoam >log 2>&1
control ''; riprapFoam >log 2>&1
for file in p U lagrangian/fluid/positions lagrangian/fluid/U uniform/riprap/picState
do
    cmp -s "0.1/$file" "whole/0.1/$file" && pass "restart.$file" \
        || fail "restart.$file" "0.1/$file is not what one run writes"
done
rm -rf whole 0.05 0.1

# Function objects, riprap's and OpenFOAM's, on a pool at rest: 0.05 m deep, 0.2 m wide, 0.01 m
# across
library='libs ("libriprapFoam.so");'
cell='writeControl timeStep; writeInterval 1;'
rm -rf 0 postProcessing
dictionary system/setParticlesDict <<<"spacing 0.005; regions ( pool { set fluid; source box; \
box (0 0 -1) (0.2 0.05 1); pressure hydrostatic; } );"
setParticles >log 2>&1
control "functions
{
front { type frontPosition; $library }
gauges { type waterLevel; $library points ((0.1 0 0)); }
probes { type particleProbes; $library fields (p); probeLocations ((0.1 0.02 0.005)); }
energy { type energyBalance; $library }
momentum { type momentumBalance; $library }
points { type probes; libs (\"libsampling.so\"); fields (p); \
$cell probeLocations ((0.105 0.025 0.005)); }
volume { type volFieldValue; libs (\"libfieldFunctionObjects.so\"); fields (alpha.water); \
operation volIntegrate; regionType all; writeFields no; $cell }
floor { type surfaceFieldValue; libs (\"libfieldFunctionObjects.so\"); fields (p); \
operation areaAverage; regionType patch; name lower; writeFields no; $cell }
}"
riprapFoam >log 2>&1; says functions.run '^End'
near()      # NAME FILE COLUMN EXPECTED BOUND: at the last time, by number or name of the column
{
    local found
    found=$(awk -v column="$3" \
        '/^#/ { n = split($0, name, /[ \t]+/); for (i = 2; i <= n; ++i) at[name[i]] = i - 1; next }
        { last = $(column ~ /^[0-9]+$/ ? column : at[column]) } END { print last }' \
        postProcessing/"$2")
    if awk -v a="$found" -v b="$4" \
        -v bound="$5" 'BEGIN { exit !(a != "" && (a - b)^2 <= bound^2) }'; then pass "functions.$1"
    else fail "functions.$1" "is ${found:-not there}, expected $4 within $5"; fi
}
near level gauges/0/waterLevel.dat level0 0.05 1e-6
# of the particles farthest out: half of their part of a cell
near front front/0/frontPosition.dat front 0.2 1e-3
near probe probes/0/p.dat p0 294.3 0.1                              # 0.03 m deep
# per metre across: rho g 0.2 0.05^2/2
near potential energy/0/energyBalance.dat potential 2.4525 1e-3
near speed energy/0/energyBalance.dat maxSpeed 0 1e-6
# of impulses of 0.1 N s and more: the floor gets the weight
near residual momentum/0/momentumBalance.dat residualY 0 1e-9
awk '!/^#/ { g = $6; w = $9 } END { exit !(g < 0 && (w/g - 1)^2 < 1e-12) }' \
    postProcessing/momentum/0/momentumBalance.dat && pass functions.floorImpulse \
 || fail functions.floorImpulse 'the floor does not get the weight of the water'
# the middle of a cell, 0.025 m deep
near foamProbe points/0/p 2 245.25 0.1
near foamVolume volume/0/volFieldValue.dat 2 1e-4 1e-9
near foamFloor floor/0/surfaceFieldValue.dat 2 490.5 0.2            # 0.05 m deep
good; rm -rf 0.05 0.1 postProcessing

# Fields reach OpenFOAM's function objects at each sample, and are written right where nobody else
# looks at them
column='spacing 0.005; regions ( column { set fluid; source box; box (0 0 -1) (0.1 0.08 1); '\
'velocity (0 0 0); pressure hydrostatic; } );'
short='endTime 0.04; sampleInterval 0.01; writeInterval 0.04;'
dictionary system/setParticlesDict <<<"$column"
control "$short functions { points { type probes; libs (\"libsampling.so\"); fields (p); \
probeLocations ((0.05 0.01 0.005)); }
residuals { type solverInfo; libs (\"libutilityFunctionObjects.so\"); fields (p); } }"
setParticles >log 2>&1; riprapFoam >log 2>&1
# solverInfo: solver, initial and final residual, iterations of the first solution of each sample;
# several were found
first=$(awk '/Solving for p/ && !seen { seen = 1; gsub(",", "");
        first = sprintf("%s %.4e %.4e %d", $1, $8, $12, $15) } /^Time = / { if (seen) print first;
        seen = 0 }' log)
rows=$(awk '!/^#/ { printf "%s: %.4e %.4e %d\n", $2, $3, $4, $5 }' \
    postProcessing/residuals/0/solverInfo.dat)
[[ -n $first && $rows == "$first" \
    && $(grep -c 'Solving for p' log) -gt $(wc -l <<<"$first") ]] && pass residuals \
    || fail residuals "the log has ${first//$'\n'/; }, solverInfo ${rows//$'\n'/; }"
[[ $(awk '!/^#/ { print $2 }' postProcessing/points/0/p | sort -u | wc -l) -ge 4 ]] \
    && pass fields.eachSample || fail fields.eachSample 'a probe sees the same p at several samples'
cp -r 0.04 read; rm -rf 0.04 postProcessing
control "$short"; riprapFoam >log 2>&1
for field in p U alpha.water
do
    cmp -s read/$field 0.04/$field && pass fields.$field \
        || fail fields.$field 'is another without function objects'
done
says wallTimes 'Wall time \[s\].*start.*solver.*fields.*writing.*all +[0-9.]+ +100.0 %'
[[ -s postProcessing/wallTimes/0/wallTimes.dat ]] && pass wallTimes.file \
    || fail wallTimes.file 'no postProcessing/wallTimes'
good; rm -rf read 0.04 postProcessing

# A channel with a given flow on one side and a level on the other: 0.05 m deep at 0.2 m/s; steady,
# and exact when continued
block 0.2 0.1 0.01 '20 10 1' "in { type patch; faces ((0 4 7 3)); } out { type patch; \
faces ((1 2 6 5)); } $lower $open $flat"
good; control ''
dictionary system/setParticlesDict <<<"spacing 0.005; regions ( pool { set fluid; source box; \
box (0 0 -1) (0.2 0.05 1); velocity (0.2 0 0); pressure hydrostatic; } );"
setParticles >log 2>&1
pic 'openings { in { type flowRate; flowRate 1e-4; } out { type level; '\
'level table ((0 0.05) (1 0.05)); } }'
control "endTime 0.2; functions { gauges { type waterLevel; \
$library points ((0.1 0 0)); } energy { type energyBalance; $library } }"
riprapFoam >log 2>&1; says openings.run '^End'
says openings.passed 'Opening in: particles in = [1-9][0-9]*, out = 0, volume in all = 0.00[0-9]*'
near channelLevel gauges/0/waterLevel.dat level0 0.05 5e-4
near channelSpeed energy/0/energyBalance.dat maxSpeed 0.2 0.01
mkdir whole; cp -r 0.2 whole
rm -rf 0.1[0-9]* 0.2
riprapFoam >log 2>&1
for file in p lagrangian/fluid/positions uniform/riprap/picState
do
    cmp -s "0.2/$file" "whole/0.2/$file" && pass "openings.restart.$file" \
        || fail "openings.restart.$file" "0.2/$file is not what one run writes"
done
# From the fields alone the count of what has passed goes on: 1e-4 m3/s, 0.01 m across, for 0.2 s
rm -rf 0.1[0-9]* 0.2
pic 'precision double; openings { in { type flowRate; flowRate 1e-4; } out { type level; '\
'level table ((0 0.05) (1 0.05)); } }'
riprapFoam >log 2>&1
says openings.fields 'State in uniform/riprap is not used: .*written with another precision'
volume=$(sed -n 's/^Opening in: .*volume in all = //p' log | tail -1)
awk -v v="${volume:-0}" 'BEGIN {exit !(v > 2e-3*(1 - 1e-6) && v < 2e-3*(1 + 1e-6))}' \
    && pass openings.count || fail openings.count "volume in all is $volume, for 2e-3"
rm -rf whole 0.05 0.1 0.1[0-9]* 0.2 postProcessing
tank2; good

# Entries
while IFS=$'\t' read -r name message entries
do
    [[ $name == \#* ]] && continue
    pic "$entries"
    refused "$name" "$message.*picProperties|picProperties.*$message" riprapFoam
done <"$root/tests/regression/wrongPicEntries.tsv"
pic ''

wrongControl()      # NAME MESSAGE ENTRIES
{
    control "$3"
    refused "$1" "$2" riprapFoam
    control ''
}
wrongControl maxCoLarge 'Entry maxCo is 2.5: it must be from 1e-06 to 2' 'maxCo 2.5;'
wrongControl maxCoNegative 'Entry maxCo is -0.5: it must be from' 'maxCo -0.5;'
wrongControl maxFlyingCo 'Entry maxFlyingCo is 0.3: it must be from 0.5 to 4' 'maxFlyingCo 0.3;'
wrongControl deltaT 'deltaT' 'adjustTimeStep no; deltaT -1;'
wrongControl meshFields 'expected word.*label 17|17.*functions.f' \
    'functions { f { type particlesToMesh; libs ("libriprapFoam.so"); fields (17 U); } }'
dictionary constant/fluidProperties <<<'mu 1e-3;'; refused noRho "rho.* not found|'rho'" riprapFoam
dictionary constant/fluidProperties <<<'rho -1000; mu 1e-3;'
refused rhoNegative 'Entry rho is -1000: it must be positive' riprapFoam
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'
dictionary system/fvSolution </dev/null
refused noSolver 'There is no dictionary p in solvers.*system/fvSolution' riprapFoam
dictionary system/fvSolution <<<'solvers { }'
refused noPressure 'There is no dictionary p in solvers.*system/fvSolution' riprapFoam
wrongSolver()       # NAME MESSAGE ENTRIES
{
    dictionary system/fvSolution <<<"solvers { p { $3 } }"
    refused "$1" "$2" riprapFoam
    ! grep -q 'Solving for p' log || fail "$1" "told after the first solution"
}
gamg='solver coupledPCG; tolerance 1e-9; preconditioner { preconditioner GAMG; smoother'
wrongSolver solverEmpty "'solver' not found.*fvSolution" ''
wrongSolver solverList "fvSolution.solvers.p.relTol" 'solver PCG; preconditioner DIC; relTol (1 2);'
wrongSolver solverEntry "unknown entry 'tolerence' of the solver of p. Valid: \
.*tolerance.*fvSolution" 'solver PCG; preconditioner DIC; tolerence 1e-9;'
wrongSolver solverRelTol 'Entry relTol of the solver of p must be less than 1' \
    'solver PCG; preconditioner DIC; relTol 2;'
wrongSolver solverSweeps "unknown entry 'nFinestSweesp' of the solver of \
p.*fvSolution.solvers.p.preconditioner" "$gamg symGaussSeidel; nFinestSweesp 1; }"
wrongSolver solverCycles 'fvSolution.solvers.p.preconditioner.nVcycles' \
    "$gamg symGaussSeidel; nVcycles 1e18; }"
wrongSolver solverSmoother "unknown smoother 'sandpaper' for p. Valid: .*GaussSeidel" \
    "$gamg sandpaper; }"
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'

# No water
rm -rf 0; refused noParticles 'lagrangian|setParticles' riprapFoam

# Meshes
mesh()      # NAME MESSAGE
{
    good
    refused "$1.setParticles" "$2" setParticles
    refused "$1" "$2" riprapFoam
}
block 0.2 0.1 0.01 '20 11 1' "$sides $lower $open $flat"
mesh notSquare 'PIC needs a mesh that is one block of equal squares'
dictionary system/setParticlesDict <<<'regions ( stones { set solids; } );'
refused notSquare.solids 'PIC needs a mesh that is one block of equal squares' setParticles
block 0.2 0.1 0.01 '20 10 1' "$sides $lower $open $flat"
sed -i 's/simpleGrading (1 1 1)/simpleGrading (1 3 1)/' system/blockMeshDict; blockMesh >log 2>&1
mesh graded 'PIC needs a mesh that is one block of equal squares .*without grading'
block 0.2 0.1 0.01 '20 10 1' "$sides $lower upper { type symmetryPlane; faces ((3 7 6 2)); } $flat"
mesh patchType 'Patch upper has the type symmetryPlane.*valid are wall, patch'
