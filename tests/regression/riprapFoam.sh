#!/bin/bash
# riprapFoam: its options, one message for every entry of sphProperties and fluidProperties that can be wrong, what a restart makes of edits,
# walls of no thickness, and the way through decomposePar and reconstructPar.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL riprapFoam no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL riprapFoam no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
. "$root/tests/regression/setParticlesCases"

pass() { echo "PASS riprapFoam.$1"; }
fail() { echo "FAIL riprapFoam.$1 $2"; }
# The log as one line: OpenFOAM breaks messages
says() { tr '\n' ' ' <log | tr -s ' ' | grep -qE -- "$2" && pass "$1" || fail "$1" "the log does not say: $2"; }
quiet() { tr '\n' ' ' <log | tr -s ' ' | grep -qE -- "$2" && fail "$1" "the log says: $2" || pass "$1"; }
sph() { dictionary constant/sphProperties <<<"device cpu; $1"; }
control()   # startFrom ENDTIME
{
    dictionary system/controlDict <<<"application riprapFoam; solver sphDem; startFrom $1; startTime 0; stopAt endTime; endTime $2;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.005; writeControl adjustableRunTime; writeInterval 0.005; writeFormat ascii; timePrecision 9;"
}
# One message, with the file and what is wrong
wrong()     # NAME MESSAGE [OPTION...]
{
    local name=$1 message=$2 status said; shift 2
    riprapFoam -dry-run "$@" >log 2>&1; status=$?
    said=$(tr '\n' ' ' <log | tr -s ' ')
    if ((status == 0)); then fail "bad.$name" "was accepted"
    elif [[ $(grep -c 'FOAM FATAL' log) != 1 ]]; then fail "bad.$name" "not one message"
    elif ! grep -qE -- "$message" <<<"$said"; then fail "bad.$name" "the message is not '$message': ${said:${#said}<400?0:-400}"
    else pass "bad.$name"
    fi
}

tank2
control startTime 0.005
regions 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); }'
sph ''
setParticles >log 2>&1 || { fail case "setParticles failed"; tail -5 log; exit 1; }

# Options
riprapFoam -help >log 2>&1
says help 'riprapFoam \[OPTIONS\].*-dry-run.*-solver'
quiet helpParallel 'parallel|hostRoots'
riprapFoam -parallel >log 2>&1; status=$?
((status)) && [[ $(grep -c 'FOAM FATAL' log) == 1 ]] && pass parallelRefused || fail parallelRefused "status $status, or not one message"
says parallelMessage 'Option -parallel: riprapFoam cannot run in parallel yet; it uses all cores of one process'
wrong solver 'nonsense' -solver nonsense

# Entries of sphProperties
bad() { sph "$2"; wrong "$1" "$3.*sphProperties"; }
bad unknownEntry 'kernal wendlandC2;' 'Unknown entry kernal; valid are .*kernel'
bad kernel 'kernel gauss;' 'kernel has the unknown word gauss; valid are .*wendlandC2 cubicSpline'
bad precision 'precision half;' 'precision has the unknown word half; valid are .*mixed double'
bad device 'device tpu;' 'device has the unknown word tpu; valid are .*auto cpu gpu'
bad ratio 'smoothingLength { ratio 0.5; }' 'Entry ratio is 0.5: it must be from 0.8 to 4'
bad model 'smoothingLength { model adaptive; }' 'model has the unknown word adaptive; valid are .*constant variable|model has the unknown word adaptive; valid are .*variable constant'
bad maxGrowth 'smoothingLength { maxGrowth 0.9; }' 'Entry maxGrowth is 0.9: it must be from 1 to 4'
bad unknownInSmoothing 'smoothingLength { h 1; }' 'Unknown entry h; valid are .*ratio'
bad smoothingNoDict 'smoothingLength 1.25;' 'Entry smoothingLength must be a dictionary'
bad equationOfState 'equationOfState ideal;' 'equationOfState has the unknown word ideal; valid are .*Tait linear'
bad gamma 'gamma 0;' 'Entry gamma is 0: it must be positive'
bad maxVelocity 'maxVelocity -1;' 'Entry maxVelocity is -1: it must be positive'
bad maxVelocityWord 'maxVelocity fast;' 'maxVelocity has the unknown word fast; valid are .*auto <number>'
bad soundSpeedRatio 'soundSpeedRatio 0;' 'Entry soundSpeedRatio is 0: it must be positive'
bad viscosity 'viscosity some;' 'viscosity has the unknown word some; valid are .*laminar'
bad alpha 'artificialViscosity { alpha -1; }' 'Entry alpha is -1: it must be zero or positive'
bad antiClump 'antiClump -1;' 'Entry antiClump is -1: it must be zero or positive'
bad antiClumpWord 'antiClump off;' 'antiClump has the unknown word off; valid are .*none <number>'
bad XSPH 'XSPH -0.5;' 'Entry XSPH is -0.5: it must be zero or positive'
bad densityDiffusion 'densityDiffusion delta;' 'densityDiffusion has the unknown word delta; valid are .*none molteni fourtakas'
bad delta 'densityDiffusionCoeffs { delta -1; }' 'Entry delta is -1: it must be zero or positive'
bad shifting 'shifting ficks;' 'shifting has the unknown word ficks; valid are .*none fickian'
bad shiftingA 'shiftingCoeffs { A -1; }' 'Entry A is -1: it must be zero or positive'
bad surfaceThresholdZero 'shifting fickian; shiftingCoeffs { surfaceThreshold 0; }' 'Entry surfaceThreshold is 0: it must be positive'
bad surfaceThresholdNegative 'shiftingCoeffs { surfaceThreshold -1; }' 'Entry surfaceThreshold is -1: it must be positive'
bad surfaceThresholdLarge 'shiftingCoeffs { surfaceThreshold 2; }' 'Entry surfaceThreshold is 2: it must be less than 2 in 2D'
bad timeIntegration 'timeIntegration Euler;' 'timeIntegration has the unknown word Euler; valid are .*leapfrog symplectic'
bad acousticCourant 'acousticCourant 0;' 'Entry acousticCourant is 0: it must be positive'
bad forceCourant 'forceCourant 0;' 'Entry forceCourant is 0: it must be positive'
bad viscousCourant 'viscousCourant 0;' 'Entry viscousCourant is 0: it must be positive'
bad wallModel 'walls { model mirror; }' 'model has the unknown word mirror; valid are .*stationary extrapolated'
bad wallSpacing 'walls { spacing 0; }' 'Entry spacing is 0: it must be positive'
bad wallLayers 'walls { layers 1.5; }' 'Entry layers is 1.5: it must be auto or a whole number from 1 to 20'
bad wallSlip 'walls { slip half; }' 'slip has the unknown word half; valid are .*noSlip freeSlip'
bad wallPatch 'walls { patches (nowhere); }' 'no patch nowhere that can be a wall; valid ones are .*lower'
bad wallVelocity 'walls { velocity { lower (1 0 0); } }' 'Unknown entry velocity; valid are .*motion'
bad motionNoDict 'walls { motion { piston left; } }' 'Entry piston is no dictionary'
bad guardDensity 'guards { densityDeviation 0; }' 'Entry densityDeviation is 0: it must be positive'
bad guardSpeed 'guards { speedRatio 0; }' 'Entry speedRatio is 0: it must be positive'
bad guardEscape 'guards { escape ignore; }' 'escape has the unknown word ignore; valid are .*stop warn'
bad guardMaxEscaped 'guards { maxEscaped 2; }' 'Entry maxEscaped is 2: it must be from 0 to 1'
sph 'shifting fickian; shiftingCoeffs { surfaceThreshold 1.9; }'
riprapFoam -dry-run >log 2>&1 && pass surfaceThreshold || fail surfaceThreshold "1.9 is refused in 2D"
sph ''
fluid() { dictionary constant/fluidProperties <<<"$2"; wrong "$1" "$3.*fluidProperties"; }
fluid noRho 'mu 1e-3;' "rho.*not found|rho"
fluid rho 'rho 0; mu 1e-3;' 'Entry rho is 0: it must be positive'
fluid rhoUnit 'rho 5mm; mu 1e-3;' "rho"
fluid rhoDimensions 'rho [0 1 0 0 0 0 0] 1; mu 1e-3;' 'Entry rho has the dimensions'
fluid muAndNu 'rho 1000; mu 1e-3; nu 1e-6;' 'One of the entries mu .* must be there, not both'
fluid unknownFluid 'rho 1000; mu 1e-3; sigma 0.07;' 'Unknown entry sigma; valid are .*rho'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'

# 2D: the empty coordinate is the mesh's mid-plane, whatever the cloud says
sed -i '/^(0.0025 0.0025 0.005)/s/0.005)/0.0071)/' 0/lagrangian/fluid/positions
grep -q '0.0071)' 0/lagrangian/fluid/positions || fail midPlane "the test's own edit"
riprapFoam >log 2>&1
says run 'Written 0.005: 800 particles'
[[ $(grep -cE '^\(.* 0\.005\) [0-9]' 0.005/lagrangian/fluid/positions) == 800 ]] && pass midPlane || fail midPlane "written particles are not in the mid-plane"

# Continuing: what was edited takes effect, or the log says that it does not
cp -r 0.005 written
again()     # COMMAND...: on the written time, then run on
{
    rm -rf 0.005 0.01; cp -r written 0.005
    "$@"
    control latestTime 0.01
    riprapFoam >log 2>&1
}
edit() { sed -i -E "$2" "0.005/lagrangian/fluid/$1"; }
again true
says continued 'Continuing exactly from time 0.005'
quiet continuedQuietly 'Warning'
again edit rho '30s/.*/1010/'
says editedRho 'State in uniform/riprap is not used: the cloud has been changed since it was written \(rho\)'
again edit U '30s/.*/(0.5 0 0)/'
says editedU 'has been changed since it was written \(U\)'
again edit p '30s/.*/9999/'
says editedP 'Warning.*Field p of lagrangian/fluid at time 0.005 is not what rho gives, at 1 particles.*edit rho instead'
again edit h 's/\{0.00625\}/{0.007}/'
says editedH 'Warning.*Field h of lagrangian/fluid at time 0.005 is not what smoothingLength.*at 800 particles'
again dictionary constant/fluidProperties <<<'rho 1100; mu 1e-3;'
says editedFluid 'Warning.*Entry rho of constant/fluidProperties is 1100, and was 1000 in the run that is continued. The new one is used'
says editedFluidExact 'Continuing exactly'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'

# Decomposed and put together again
rm -rf 0.005 0.01 written
control startTime 0.005
sed -i 's/startFrom latestTime/startFrom startTime/' system/controlDict
cp 0/lagrangian/fluid/positions before
decomposePar -force >log 2>&1
rm -r 0/lagrangian 0/uniform
reconstructPar -withZero >log 2>&1
[[ -s 0/lagrangian/fluid/positions ]] && pass reconstructedPositions || fail reconstructedPositions "reconstructPar -withZero wrote none"
riprapFoam >log 2>&1
says reconstructed 'Written 0.005: 800 particles'
rm -rf processor*

# Walls of no thickness: two blocks that touch, with a wall on either side between them
baffle()    # TYPE OF right SIDE'S PATCH
{
    dictionary system/blockMeshDict <<<"scale 1;
vertices ((0 0 0) (0.1 0 0) (0.1 0.1 0) (0 0.1 0) (0 0 0.01) (0.1 0 0.01) (0.1 0.1 0.01) (0 0.1 0.01)
(0.1 0 0) (0.2 0 0) (0.2 0.1 0) (0.1 0.1 0) (0.1 0 0.01) (0.2 0 0.01) (0.2 0.1 0.01) (0.1 0.1 0.01));
blocks (hex (0 1 2 3 4 5 6 7) (10 10 1) simpleGrading (1 1 1) hex (8 9 10 11 12 13 14 15) (10 10 1) simpleGrading (1 1 1));
boundary ( tank { type wall; faces ((0 4 7 3) (9 10 14 13) (0 1 5 4) (8 9 13 12)); } upper { type patch; faces ((3 7 6 2) (11 15 14 10)); }
thin { type wall; faces ((1 2 6 5)); } back { type $1; faces ((8 12 15 11)); }
fb { type empty; faces ((0 3 2 1) (4 5 6 7) (8 11 10 9) (12 13 14 15)); } );"
    rm -rf 0 0.* constant/polyMesh; blockMesh >log 2>&1 || cat log
    regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); }'
}
baffle wall
setParticles >log 2>&1
says baffle 'FATAL.*Patch (thin|back) is a baffle: a face of patch (thin|back) is right behind it, at \(0.1 .*constant/geometry'
sph 'walls { patches (tank); }'
geometry 'plate { type searchablePlate; origin (0.1 0 -1); span (0 0.1 2); }'
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); clip yes; }'
setParticles >log 2>&1
says bafflePlate 'plate: [0-9]+ points'
riprapFoam >log 2>&1
says bafflePlateRuns 'Written 0.005'
