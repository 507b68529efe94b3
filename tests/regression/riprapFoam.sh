#!/bin/bash
# riprapFoam: its options, one message for every entry of sphProperties and fluidProperties that can
# be wrong, what a restart makes of edits, walls of no thickness, and the way through decomposePar
# and reconstructPar.
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
suite=riprapFoam
. "$root/tests/regression/setParticlesCases"

sph() { dictionary constant/sphProperties <<<"device cpu; $1"; }
control()   # startFrom ENDTIME
{
    dictionary system/controlDict <<<"application riprapFoam; solver sphDem; startFrom $1; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.005; writeControl adjustableRunTime; \
writeInterval 0.005; writeFormat ascii; timePrecision 9;"
}
wrong() { local name=$1 message=$2; shift 2; refused "$name" "$message" riprapFoam -dry-run "$@"; }

tank2
control startTime 0.005
regions 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); }'
sph ''
setParticles >log 2>&1 || { fail case "setParticles failed"; tail -5 log; exit 1; }

# Options
riprapFoam -help >log 2>&1
says help 'riprapFoam \[OPTIONS\].*-dry-run.*-solver'
wrong solver 'Unknown solver nonsense .*available are \(.*sphDem.*controlDict' -solver nonsense

# Entries of sphProperties
bad() { sph "$2"; wrong "$1" "$3.*sphProperties"; }
bad unknownEntry 'kernal wendlandC2;' 'Unknown entry kernal; valid are .*kernel'
bad kernel 'kernel gauss;' 'kernel has the unknown word gauss; valid are .*wendlandC2 cubicSpline'
bad precision 'precision half;' 'precision has the unknown word half; valid are .*mixed double'
bad device 'device tpu;' 'device has the unknown word tpu; valid are .*auto cpu gpu'
bad gpuOfCpu 'gpu 0;' \
    'Entry gpu names a GPU, and device is cpu: leave gpu out, or take auto or gpu for device'
bad gpuFraction 'gpu 1.5;' 'Entry gpu is 1.5: it must be a whole number'
dictionary constant/sphProperties <<<'gpu 99;'
wrong gpuNumber 'Entry gpu is 99, '\
'and (the GPUs of this machine are 0 \(|riprap was built without CUDA|there is no).*sphProperties'
bad balance 'parallel { balance work; }' 'balance has the unknown word work; '\
'valid are .*(time particles|particles time)'
bad messages 'parallel { messages fast; }' 'messages has the unknown word fast; '\
'valid are \(direct host\)'
bad imbalance 'parallel { imbalance 0; }' 'Entry imbalance is 0: it must be positive'
bad ratio 'smoothingLength { ratio 0.5; }' 'Entry ratio is 0.5: it must be from 0.8 to 4'
bad model 'smoothingLength { model adaptive; }' 'model has the unknown word adaptive; '\
'valid are .*constant variable|model has the unknown word adaptive; valid are .*variable constant'
bad maxGrowth 'smoothingLength { maxGrowth 0.9; }' 'Entry maxGrowth is 0.9: it must be from 1 to 4'
bad unknownInSmoothing 'smoothingLength { h 1; }' 'Unknown entry h; valid are .*ratio'
bad smoothingNoDict 'smoothingLength 1.25;' 'Entry smoothingLength must be a dictionary'
bad equationOfState 'equationOfState ideal;' \
    'equationOfState has the unknown word ideal; valid are .*Tait linear'
bad gamma 'gamma 0;' 'Entry gamma is 0: it must be positive'
bad maxVelocity 'maxVelocity -1;' 'Entry maxVelocity is -1: it must be positive'
bad maxVelocityWord 'maxVelocity fast;' \
    'maxVelocity has the unknown word fast; valid are .*auto <number>'
bad soundSpeedRatio 'soundSpeedRatio 0;' 'Entry soundSpeedRatio is 0: it must be positive'
bad viscosity 'viscosity some;' 'viscosity has the unknown word some; valid are .*laminar'
bad alpha 'artificialViscosity { alpha -1; }' 'Entry alpha is -1: it must be from 0 to 100'
bad antiClump 'antiClump -1;' 'Entry antiClump is -1: it must be zero or positive'
bad antiClumpWord 'antiClump off;' 'antiClump has the unknown word off; valid are .*none <number>'
bad XSPH 'XSPH -0.5;' 'Entry XSPH is -0.5: it must be zero or positive'
bad densityDiffusion 'densityDiffusion delta;' \
    'densityDiffusion has the unknown word delta; valid are .*none molteni fourtakas'
bad delta 'densityDiffusionCoeffs { delta -1; }' 'Entry delta is -1: it must be from 0 to 10'
bad shifting 'shifting ficks;' 'shifting has the unknown word ficks; valid are .*none fickian'
bad shiftingA 'shiftingCoeffs { A -1; }' 'Entry A is -1: it must be zero or positive'
bad surfaceThresholdZero 'shifting fickian; shiftingCoeffs { surfaceThreshold 0; }' \
    'Entry surfaceThreshold is 0: it must be positive'
bad surfaceThresholdNegative 'shiftingCoeffs { surfaceThreshold -1; }' \
    'Entry surfaceThreshold is -1: it must be positive'
bad surfaceThresholdLarge 'shiftingCoeffs { surfaceThreshold 2; }' \
    'Entry surfaceThreshold is 2: it must be less than 2 in 2D'
bad timeIntegration 'timeIntegration Euler;' \
    'timeIntegration has the unknown word Euler; valid are .*leapfrog symplectic'
bad acousticCourant 'acousticCourant 0;' 'Entry acousticCourant is 0: it must be positive'
bad forceCourant 'forceCourant 0;' 'Entry forceCourant is 0: it must be positive'
bad viscousCourant 'viscousCourant 0;' 'Entry viscousCourant is 0: it must be positive'
bad acousticCourantHigh 'acousticCourant 2.5;' 'Entry acousticCourant is 2.5: it must be from 0 to'
bad forceCourantHigh 'forceCourant 2;' 'Entry forceCourant is 2: it must be from 0 to 1'
bad viscousCourantHigh 'viscousCourant 0.5;' \
    'Entry viscousCourant is 0.5: it must be from 0 to 0.25'
bad wallModel 'walls { model mirror; }' \
    'model has the unknown word mirror; valid are .*stationary extrapolated'
bad wallSpacing 'walls { spacing 0; }' 'Entry spacing is 0: it must be positive'
bad wallLayers 'walls { layers 1.5; }' \
    'Entry layers is 1.5: it must be auto or a whole number from 1 to 20'
bad wallSlip 'walls { slip half; }' 'slip has the unknown word half; valid are .*noSlip freeSlip'
bad wallPatch 'walls { patches (nowhere); }' \
    'no patch nowhere that can be a wall; valid ones are .*lower'
bad wallVelocity 'walls { velocity { lower (1 0 0); } }' \
    'Unknown entry velocity; valid are .*motion'
bad motionNoDict 'walls { motion { piston left; } }' 'Entry piston is no dictionary'
bad kernelDict 'kernel { }' 'Entry kernel must be a value, not a dictionary'
bad kernelNumber 'kernel 5;' 'expected word.*(label|int32) 5'
bad semicolonNone 'antiClump none XSPH 0.5;' "Entry 'antiClump' has 2 excess tokens"
bad semicolonAuto 'maxVelocity auto kernel wendlandC2;' "Entry 'maxVelocity' has 2 excess tokens"
bad kernelTwice 'kernel wendlandC2 cubicSpline;' "Entry 'kernel' has 1 excess tokens"
bad gammaWord 'gamma seven;' "expected scalar value.*word 'seven'"
bad softening 'laminarViscosity { softening 0; }' 'Entry softening is 0: it must be positive'
bad unknownInLaminar 'laminarViscosity { eta 1; }' 'Unknown entry eta; valid are \(softening\)'
bad unknownInArtificial 'artificialViscosity { beta 1; }' \
    'Unknown entry beta; valid are \(alpha walls\)'
bad unknownInDiffusion 'densityDiffusionCoeffs { D 1; }' 'Unknown entry D; valid are \(delta\)'
bad unknownInShifting 'shiftingCoeffs { B 1; }' 'Unknown entry B; valid are \(A surfaceThreshold\)'
bad unknownInGuards 'guards { speed 1; }' \
    'Unknown entry speed; valid are \(densityDeviation speedRatio wild maxWild escape maxEscaped\)'
bad unknownInWalls 'walls { material steel; }' \
    'Unknown entry material; valid are .*layers slip impermeable patches motion'
bad wallsNoDict 'walls extrapolated;' 'Entry walls must be a dictionary'
bad wallSpacingTiny 'walls { spacing 1e-9; }' \
    'walls/spacing of constant/sphProperties.*is the spacing meant'
bad wallLayersWord 'walls { layers many; }' \
    'layers has the unknown word many; valid are \(auto <number>\)'
bad wallLayersMany 'walls { layers 21; }' 'Entry layers is 21: it must be auto or a whole number'
bad wallPatchesWord 'walls { patches lower; }' "expected <int> or '\('.*word 'lower'"
bad wallPatchesDict 'walls { patches { } }' 'Entry patches must be a value'
linear='solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity'
bad motionNoFunction 'walls { motion { p { patches (left); } } }' 'Motion p: '\
'entry solidBodyMotionFunction is missing; valid are \(.*linearMotion .*rotatingMotion'
bad motionFunction 'walls { motion { p { patches (left); solidBodyMotionFunction wobble; } } }' \
    'Entry solidBodyMotionFunction has the unknown word wobble; '\
'valid are \(.*oscillatingLinearMotion'
bad motionNoPatches "walls { motion { p { $linear (1 0 0); } } } }" "'patches' not found"
bad motionPatch "walls { motion { p { patches (lefft); $linear (1 0 0); } } } }" \
    'patches \(lefft\) selects no wall; valid are \(left right lower\)'
bad motionTwice "walls { motion { p { patches (left); $linear (1 0 0); } } q { patches (\".*\"); \
$linear (1 0 0); } } } }" 'Wall left moves with p already'
bad motionPlane "walls { motion { p { patches (left); $linear (1 0 1); } } } }" \
    'Motion p leaves the plane of this 2D case: z'
bad motionUnknown "walls { motion { p { patches (left); patch (left); $linear (1 0 0); } } } }" \
    'Unknown entry patch; valid are \(patches solidBodyMotionFunction linearMotionCoeffs\)'
bad motionSurplus "walls { motion { p { patches (left); $linear (1 0 0) 2; } } } }" \
    'Motion p: entry velocity holds more than its value'
bad motionOther "walls { motion { p { patches (left); $linear (1 0 0); } rotatingMotionCoeffs { \
origin (0 0 0); axis (0 0 banana); omega 1; } } } }" "expected scalar value.*word 'banana'"
bad motionFar "walls { motion { p { patches (left); $linear (1e12 0 0); } } } }" \
    'Motion p takes its walls .* m away, '\
'more than 10000 times the size of the mesh.*is there a wrong unit among \(velocity\)'
bad XSPH 'XSPH 1e12;' 'Entry XSPH is 1e.12: it must be from 0 to 2'
bad maxVelocitySmall 'maxVelocity 1e-12;' 'Entries maxVelocity, 1e-12 m/s, '\
'and soundSpeedRatio give the fluid a speed of sound of 1e-11 m/s'
bad motionCoeffs 'walls { motion { p { patches (left); solidBodyMotionFunction linearMotion; '\
'linearMotionCoeffs { v (1 0 0); } } } }' "'velocity' not found.*linearMotionCoeffs"
bad guardDensity 'guards { densityDeviation 0; }' 'Entry densityDeviation is 0: it must be positive'
bad guardSpeed 'guards { speedRatio 0; }' 'Entry speedRatio is 0: it must be positive'
bad guardEscape 'guards { escape ignore; }' \
    'escape has the unknown word ignore; valid are .*stop warn'
bad guardMaxEscapedNegative 'guards { maxEscaped -0.1; }' \
    'Entry maxEscaped is -0.1: it must be from 0 to 1'
bad guardMaxEscaped 'guards { maxEscaped 2; }' 'Entry maxEscaped is 2: it must be from 0 to 1'
sph 'shifting fickian; shiftingCoeffs { surfaceThreshold 1.9; }'
riprapFoam -dry-run >log 2>&1 && pass surfaceThreshold \
    || fail surfaceThreshold "1.9 is refused in 2D"
sph ''
fluid() { dictionary constant/fluidProperties <<<"$2"; wrong "$1" "$3.*fluidProperties"; }
fluid noRho 'mu 1e-3;' "'rho' not found"
fluid rho 'rho 0; mu 1e-3;' 'Entry rho is 0: it must be positive'
fluid rhoUnit 'rho 5mm; mu 1e-3;' "'rho' has 1 excess tokens"
fluid rhoDimensions 'rho [0 1 0 0 0 0 0] 1; mu 1e-3;' 'Entry rho has the dimensions'
fluid muAndNu 'rho 1000; mu 1e-3; nu 1e-6;' 'One of the entries mu .* must be there, not both'
fluid noMu 'rho 1000;' 'One of the entries mu .* must be there'
fluid mu 'rho 1000; mu 0;' 'Entry mu is 0: it must be positive'
fluid nu 'rho 1000; nu -1e-6;' 'Entry nu is -1e-06: it must be positive'
fluid nuLarge 'rho 1000; nu 1e12;' \
    'The viscosity, mu or nu, is 1e.12 m2/s: it spreads over a spacing in .* steps'
fluid nuWord 'rho 1000; nu water;' 'nu has the unknown word water; valid are \(<number>'
fluid rhoDict 'rho { } nu 1e-6;' 'Entry rho must be a value, not a dictionary'
fluid muDimensions 'rho 1000; mu [0 2 -1 0 0 0 0] 1e-6;' 'Entry mu has the dimensions'
fluid unknownFluid 'rho 1000; mu 1e-3; sigma 0.07;' 'Unknown entry sigma; valid are .*rho'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'
gravity() { dictionary constant/g uniformDimensionedVectorField <<<"$2"; wrong "g.$1" "$3"; }
gravity dimensions 'dimensions [0 1 -1 0 0 0 0]; value (0 -9.81 0);' \
    'constant/g: entry dimensions is .*: it must be \[0 1 -2'
gravity short 'dimensions [0 1 -2 0 0 0 0]; value (0 -9.81);' \
    'expected scalar value.*constant/g.value'
gravity noValue 'dimensions [0 1 -2 0 0 0 0];' "'value' not found.*constant/g"
gravity huge 'dimensions [0 1 -2 0 0 0 0]; value (0 -1e200 0);' \
    'Entry value holds -1e200: numbers up to 1e.20 are valid'
gravity zero 'dimensions [0 1 -2 0 0 0 0]; value (0 0 0);' \
    'Entry maxVelocity is auto, but there is neither gravity nor an initial velocity.*sphProperties'
dictionary constant/g uniformDimensionedVectorField \
    <<<'dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);'

# Entries of controlDict that riprapFoam reads; an entry of the second part goes over one of the
# first
controlled()
{
    control startTime 0.005
    echo "$2" >>system/controlDict
    wrong "control.$1" "$3.*controlDict"
}
controlled adjustTimeStep 'adjustTimeStep maybe;' "found maybe"
controlled maxDeltaT 'maxDeltaT 0;' 'Entry maxDeltaT is 0: it must be positive'
controlled deltaT 'adjustTimeStep no; deltaT 0;' 'Entry deltaT is 0: it must be positive'
controlled deltaTNegative 'adjustTimeStep no; deltaT -1;' 'Entry deltaT is -1: it must be positive'
controlled sampleInterval 'sampleInterval -1;' \
    'Entry sampleInterval is -1: it must be zero .every particle step. or positive'
controlled sampleIntervalWord 'sampleInterval often;' "expected scalar value.*word 'often'"
controlled writeInterval 'writeInterval 0;' 'Entry writeInterval is 0: it must be positive'
controlled writeIntervalNegative 'writeControl runTime; writeInterval -1;' \
    'Entry writeInterval is -1: it must be positive'
controlled writeIntervalSteps 'writeControl timeStep; writeInterval 0;' 'writeInterval < 1'
controlled writeControl 'writeControl sometimes;' \
    'sometimes is not in enumeration.*timeStep.*adjustableRunTime'
controlled endTime 'endTime -1;' 'Entry endTime is -1, before time 0 at which the run starts'
controlled stopAt 'stopAt never;' 'never is not in enumeration.*endTime.*writeNow'
controlled startFrom 'startFrom middle;' \
    "expected startTime, firstTime or latestTime found 'middle'"
controlled runTimeModifiable 'runTimeModifiable 17;' 'expected word, found.*(label|int32) 17'
controlled functionValue 'functions { f 17; }' 'Entry f of functions must be a dictionary: f . type'
controlled functionInterval 'functions { f { type wallForce; libs ("libriprapFoam.so"); '\
'writeControl adjustableRunTime; writeInterval 0; } }' \
    'Entry writeInterval is 0: it must be positive'
control startTime 0.005; sed -i 's/solver sphDem;//' system/controlDict
wrong control.noSolver "'solver' not found.*controlDict"
control startTime 0.005; sed -i 's/^deltaT 1e-3;//' system/controlDict
wrong control.noDeltaT "'deltaT' not found.*controlDict"
control startTime 0.005

# Files that are not there, and meshes that cannot be used
without() { mv "$2" aside; wrong "without.$1" "$3"; mv aside "$2"; }
without sphProperties constant/sphProperties 'cannot find file .*constant/sphProperties'
without fluidProperties constant/fluidProperties 'cannot find file .*constant/fluidProperties'
without g constant/g 'cannot find file .*constant/g'
without controlDict system/controlDict 'cannot find file .*system/controlDict'
without mesh constant/polyMesh 'Cannot find file .points. in directory .polyMesh.'
without particles 0/lagrangian 'There are no particles at time 0: .*Has setParticles been run'
wrong case 'cannot open .*nowhere|cannot find file .*nowhere' -case nowhere
cp -r constant/polyMesh aside
sed -i 's/type  *patch/type symmetryPlane/' constant/polyMesh/boundary
wrong patchType 'Patch upper has the type symmetryPlane, .*valid are wall, patch .open., '\
'empty and cyclic .constant/polyMesh/boundary'
rm -r constant/polyMesh; mv aside constant/polyMesh

# A file of walls is there or it is not: none is passed over
walled()
{
    local name=$1
    shift
    "$@" >constant/geometry
    wrong "geometry.$name" 'does not begin as a dictionary does.*constant/geometry'
    rm constant/geometry
}
plate='plate { type searchablePlate; origin (0.1 0 -1); span (0 0.1 2); }'
header='FoamFile { version 2.0; format ascii; class dictionary; object geometry; }'
walled noHeader echo "$plate"
walled wrongClass echo "${header/dictionary/volScalarField} $plate"
walled mark printf '\xef\xbb\xbf%s\n' "$header $plate"
walled empty true
walled includeFirst printf '#include "nowhere"\n%s\n' "$header $plate"
geometry '#include "nowhere"'
wrong geometry.include 'nowhere.*constant/geometry|constant/geometry.*nowhere'; rm constant/geometry

# Particles that are damaged, or were edited to what cannot be.
cp -r 0 aside
damaged()   # NAME MESSAGE COMMAND...
{
    local name=$1 message=$2; shift 2
    (cd 0 && "$@") || fail "bad.$name" "the test's own edit"
    wrong "$name" "$message"
    rm -r 0; cp -r aside 0
}
cut() { head -c "$2" "lagrangian/fluid/$1" >cut && mv cut "lagrangian/fluid/$1"; }
spread()    # FIELD VALUE: of the tenth particle, others 1000
{
    local file=lagrangian/fluid/$1
    {
        sed -n '1,/^}/p' "$file"
        echo '800('
        for i in {0..799}; do ((i == 9)) && echo "$2" || echo 1000; done
        echo ')'
    } >spread && mv spread "$file"
}
damaged cutPositions 'Bad token.*lagrangian/fluid/positions' cut positions 9039
damaged cutRho 'lagrangian/fluid/rho' cut rho 1500
damaged emptyPositions 'There are no particles' cut positions 0
damaged noU 'no vector field U; there are \(\).*0/lagrangian/fluid' rm lagrangian/fluid/U
damaged shortU 'lagrangian/fluid/U.*holds 3 values for 800 particles|holds 3 values for 800 '\
'particles.*lagrangian/fluid/U' sed -i '/^[0-9][0-9]*{/s/.*/3{(0 0 0)}/' lagrangian/fluid/U
damaged rhoNegative 'lagrangian/fluid/rho has the value -1 at entry 9: it must be positive' spread \
    rho -1
damaged rhoWord "expected scalar value.*word 'nan'.*lagrangian/fluid/rho" spread rho nan
damaged tooMany '3e\+09 particles; a cloud, which counts them in 32 bits, can have '\
'5e\+08.*lagrangian/fluid/positions' sed -i 's/^800$/3000000000/' lagrangian/fluid/positions
damaged outside '0/lagrangian/fluid.*fluid particle 0 .*outside the domain' sed \
    -i '0,/^(0.0025 0.0025/s//(77 0.0025/' lagrangian/fluid/positions
damaged cell 'particle 0 is in cell 9999 of a mesh of 200 cells.*lagrangian/fluid/positions' sed \
    -i '0,/^\((0.0025 0.0025 [^)]*)\) .*/s//\1 9999/' lagrangian/fluid/positions
damaged spacing 'Entry spacing is -1: it must be positive.*cloudProperties' sed \
    -i 's/^spacing .*/spacing -1;/' uniform/lagrangian/fluid/cloudProperties
# reconstructPar of v2512 leaves cells out
sed -i 's/^\(([^)]* [^)]*)\) [0-9]*$/\1 -1/' 0/lagrangian/fluid/positions
grep -q '^(.*) -1$' 0/lagrangian/fluid/positions && riprapFoam -dry-run >log 2>&1 \
    && pass cellsNotKnown || fail cellsNotKnown "$(grep -m1 -A1 FATAL log)"
rm -r 0; cp -r aside 0
rm -r aside

# 2D: the empty coordinate is the mesh's mid-plane, whatever the cloud says
sed -i '/^(0.0025 0.0025 0.005)/s/0.005)/0.0071)/' 0/lagrangian/fluid/positions
grep -q '0.0071)' 0/lagrangian/fluid/positions || fail midPlane "the test's own edit"
riprapFoam >log 2>&1
says run 'Written 0.005: 800 particles'
[[ $(grep -cE '^\(.* 0\.005\) [0-9]' 0.005/lagrangian/fluid/positions) == 800 ]] && pass midPlane \
    || fail midPlane "written particles are not in the mid-plane"

# What OpenFOAM's controls make of it: times that are there, and restarts from every format
times() { ls -d [0-9]* | sort -g | tr '\n' ' ' | sed 's/ $//'; }
controls()  # NAME TIMES ENTRIES
{
    rm -rf 0.*; control startTime 0.01; echo "sampleInterval 0.0025; $3" >>system/controlDict
    riprapFoam >log 2>&1
    [[ $(times) == "$2" ]] && pass "controls.$1" || fail "controls.$1" "times are $(times), not $2"
}
exactly()   # NAME: continued from 0.005 it writes what it wrote before
{
    mv 0.01 before; sed -i 's/startFrom startTime/startFrom latestTime/' system/controlDict
    riprapFoam >log 2>&1
    diff -r before/lagrangian 0.01/lagrangian >/dev/null \
        && grep -q 'Continuing exactly from time 0.005' log && pass "exact.$1" \
        || fail "exact.$1" "the continued run differs"
    rm -r before
}
controls binary '0 0.005 0.01' 'writeFormat binary;'; exactly binary
controls compressed '0 0.005 0.01' 'writeCompression on;'; exactly compressed
[[ -s 0.01/lagrangian/fluid/U.gz ]] && pass compressed || fail compressed "U is not compressed"
controls purge '0 0.0075 0.01' 'writeInterval 0.0025; purgeWrite 2;'
controls timeStep '0 0.0075' 'writeControl timeStep; writeInterval 3;'
controls writeNow '0 0.0025' 'stopAt writeNow;'
controls noWriteNow '0' 'stopAt noWriteNow;'
controls nextWrite '0 0.005' 'stopAt nextWrite;'
rm -rf 0.*; control startTime 0.005; mkdir elsewhere
(cd elsewhere && riprapFoam -case .. >../log 2>&1 && [[ -z $(ls) ]]) \
    && [[ $(times) == '0 0.005' ]] && pass caseElsewhere || fail caseElsewhere "times are $(times)"
rmdir elsewhere
# Stopped: by signals, and by an edit of controlDict, which OpenFOAM takes for one when it is much
# younger than the file was
stopped()   # NAME STATUS PATTERN COMMAND...
{
    local name=$1 expected=$2 pattern=$3 pid status; shift 3
    rm -rf 0.* log; control startTime 1000; sed -i 's/sampleInterval 0.005/sampleInterval 0.05; '\
'runTimeModifiable yes/; s/writeInterval 0.005/writeInterval 500/' system/controlDict
    touch -d '100 seconds ago' system/controlDict
    sph 'walls { patches (".*"); }'
    riprapFoam >log 2>&1 & pid=$!
    for ((i = 0; i < 1200; ++i)); do grep -q '^Time = ' log 2>/dev/null && break; sleep 0.1; done
    "$@"
    for ((i = 0; i < 600; ++i)); do kill -0 $pid 2>/dev/null || break; sleep 0.1; done
    kill -9 $pid 2>/dev/null
    wait $pid; status=$?
    ((status == expected)) && pass "stopped.$name" || fail "stopped.$name" "status $status"
    says "stopped.$name.says" "$pattern"
}
change() { sed -i "$1" system/controlDict; }
INT() { kill -INT $pid; }
TERM() { kill -TERM $pid; }
stopped INT 0 'Stopping on SIGINT: writing this time.*Written .*End' INT
stopped TERM 0 'Stopping on SIGTERM: writing this time.*Written .*End' TERM
stopped writeNow 0 'Written .*End' change 's/stopAt endTime/stopAt writeNow/'
stopped noWriteNow 0 'Time = .*End' change 's/stopAt endTime/stopAt noWriteNow/'
quiet stopped.noWriteNow.quiet 'Written'
stopped interval 1 'Entry writeInterval is 0: it must be positive' change \
    's/writeInterval 500/writeInterval 0/'
rm -rf 0.*; sph ''; control startTime 0.005
riprapFoam >log 2>&1

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
says editedRho \
    'State in uniform/riprap is not used: the cloud has been changed since it was written \(rho\)'
again edit U '30s/.*/(0.5 0 0)/'
says editedU 'has been changed since it was written \(U\)'
again edit p '30s/.*/9999/'
says editedP 'Warning.*Field p of lagrangian/fluid at time 0.005 is not what rho gives, '\
'at 1 particles.*edit rho instead'
again edit h 's/\{0.00625\}/{0.007}/'
says editedH 'Warning.*Field h of lagrangian/fluid at time 0.005 is not what smoothingLength.*at '\
'800 particles'
again dictionary constant/fluidProperties <<<'rho 1100; mu 1e-3;'
says editedFluid 'Warning.*Entry rho of constant/fluidProperties is 1100, '\
'and was 1000 in the run that is continued. The new one is used'
says editedFluidExact 'Continuing exactly'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'

# A state that is damaged says which folder to remove
state()     # NAME COMMAND...
{
    local name=$1; shift
    rm -rf 0.005 0.01; cp -r written 0.005
    (cd 0.005/uniform/riprap && "$@")
    sed -i 's/startFrom latestTime; startTime 0;/startFrom startTime; startTime 0.005;/' \
        system/controlDict
    refused "state.$name" 'is damaged .*: remove the folder .*0.005/uniform/riprap. '\
'to continue from the fields' riprapFoam
}
state cut truncate -s 2000 sphState
state empty truncate -s 0 sphState
state missing rm sphState
state flipped dd if=/dev/zero of=sphState bs=1 seek=3000 count=8 conv=notrunc status=none
state runCut truncate -s 600 sphRun
state runMissing rm sphRun
state runEntry sed -i /maxVelocity/d sphRun
state runValue sed -i 's/^spacing .*/spacing 0;/' sphRun

# Decomposed and put together again
rm -rf 0.005 0.01 written
control startTime 0.005
sed -i 's/startFrom latestTime/startFrom startTime/' system/controlDict
cp 0/lagrangian/fluid/positions before
FOAM_SIGFPE=false decomposePar -force >log 2>&1
rm -r 0/lagrangian 0/uniform
reconstructPar -withZero >log 2>&1
[[ -s 0/lagrangian/fluid/positions ]] && pass reconstructedPositions \
    || fail reconstructedPositions "reconstructPar -withZero wrote none"
riprapFoam >log 2>&1
says reconstructed 'Written 0.005: 800 particles'
rm -rf processor*
# The same of a written time with nothing deleted first: reconstructPar keeps its positions, and
# writes fields in the order of processors. What follows is what follows from the fields that were
# written
cp -r 0.005 written
rm -r 0.005/uniform/riprap; control latestTime 0.01; riprapFoam >log 2>&1
mv 0.01 expected; rm -rf 0.005; cp -r written 0.005
FOAM_SIGFPE=false decomposePar -force -latestTime >log 2>&1; reconstructPar -latestTime >log 2>&1
cmp -s 0.005/lagrangian/fluid/id written/lagrangian/fluid/id \
    && fail scrambled "reconstructPar has changed nothing" || pass scrambled
riprapFoam >log 2>&1
says scrambledOrder 'Fields of lagrangian/fluid are not in the order of its positions, '\
'as reconstructPar leaves them: they are put in the order of ids'
says scrambledChanged 'Changed since riprapFoam wrote time 0.005: .*lagrangian/fluid/U'
cmp -s 0.01/lagrangian/fluid/U expected/lagrangian/fluid/U && pass scrambledRepaired \
    || fail scrambledRepaired "it does not go on as from the fields that were written"
rm -rf 0.005 0.01 written expected processor*

# Walls of no thickness: two blocks that touch, with a wall on either side between them
baffle()    # TYPE OF right SIDE'S PATCH
{
    dictionary system/blockMeshDict <<<"scale 1;
vertices ((0 0 0) (0.1 0 0) (0.1 0.1 0) (0 0.1 0) (0 0 0.01) (0.1 0 0.01) (0.1 0.1 0.01) (0 0.1 \
0.01)
(0.1 0 0) (0.2 0 0) (0.2 0.1 0) (0.1 0.1 0) (0.1 0 0.01) (0.2 0 0.01) (0.2 0.1 0.01) (0.1 0.1 \
0.01));
blocks (hex (0 1 2 3 4 5 6 7) (10 10 1) simpleGrading (1 1 1) hex (8 9 10 11 12 13 14 15) (10 10 \
1) simpleGrading (1 1 1));
boundary ( tank { type wall; faces ((0 4 7 3) (9 10 14 13) (0 1 5 4) (8 9 13 12)); } \
upper { type patch; faces ((3 7 6 2) (11 15 14 10)); }
thin { type wall; faces ((1 2 6 5)); } back { type $1; faces ((8 12 15 11)); }
fb { type empty; faces ((0 3 2 1) (4 5 6 7) (8 11 10 9) (12 13 14 15)); } );"
    rm -rf 0 0.* constant/polyMesh; blockMesh >log 2>&1 || cat log
    regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); }'
}
baffle wall
setParticles >log 2>&1
says baffle 'FATAL.*Patch (thin|back) is a baffle: '\
'a face of patch (thin|back) is right behind it, at \(0.1 .*constant/geometry'
sph 'walls { patches (tank); }'
geometry 'plate { type searchablePlate; origin (0.1 0 -1); span (0 0.1 2); }'
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); clip yes; }'
setParticles >log 2>&1
says bafflePlate 'plate: [0-9]+ points'
riprapFoam >log 2>&1
says bafflePlateRuns 'Written 0.005'
