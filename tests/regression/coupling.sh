#!/bin/bash
# Solids in the fluid: what setParticles and a run say, files of both sets, exact restart, function
# objects of both, and what is refused.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL coupling no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL coupling no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
. "$root/tests/regression/setParticlesCases"

pass() { echo "PASS coupling.$1"; }
fail() { echo "FAIL coupling.$1 $2"; }
says() { grep -qE -- "$2" log && pass "$1" || fail "$1" "the log does not say: $2"; }
# One message, with the file and what is wrong
wrong()     # NAME MESSAGE PROGRAM...
{
    local name=$1 message=$2 status said
    shift 2
    "$@" >log 2>&1; status=$?
    said=$(tr '\n' ' ' <log | tr -s ' ')
    if ((status == 0)); then fail "bad.$name" "was accepted"
    elif [[ $(grep -c 'FOAM FATAL' log) != 1 ]]
    then fail "bad.$name" "not one message: ${said:${#said}<400?0:-400}"
    elif ! grep -qE -- "$message" <<<"$said"
    then fail "bad.$name" "the message is not '$message': ${said:${#said}<400?0:-400}"
    else pass "bad.$name"
    fi
}

fluid()     # MORE ENTRIES of sphProperties
{
    dictionary constant/fluidProperties <<<"rho 1000; mu 1e-3;"
    dictionary constant/sphProperties <<<"device cpu; $1"
}
solids()    # MORE ENTRIES of solidProperties
{
    dictionary constant/solidProperties <<<"materials { rubber { rho 800; E 1e6; nu 0.3; } }
contact { normal linear; } pairs { default { restitution 0.9; friction 0.3; \
stiffness 1e5; } } walls { material rubber; }
bonds { cement { calibration moduli; E 1e6; G 4e5; } } $1"
}
control()   # ENTRIES
{
    dictionary system/controlDict <<<"application riprapFoam; solver sphDem; startFrom latestTime; \
startTime 0; stopAt endTime; endTime 0.02;
deltaT 1e-5; adjustTimeStep yes; sampleInterval 0.005; writeControl adjustableRunTime; \
writeInterval 0.01; writeFormat ascii; writePrecision 12; $1"
}
fill()      # BOX of the block
{
    dictionary system/setParticlesDict <<<"spacing 0.005; packing square;
regions
(
    water { set fluid; source box; box (0 0 0) (0.1 0.04 0.01); pressure hydrostatic; }
    block { set solids; material rubber; radius 0.002; mass cell; source box; box $1; }
);
bonds ( block { type cement; groups (free); gapTolerance 1e-6; } );"
    rm -rf 0; setParticles >log 2>&1
}

library='libs ("libriprapFoam.so");'
tank2; fluid ''; solids ''
control "functions { level { type waterLevel; \
$library points ((0.05 0 0)); } one { type particleDisplacement; $library origIds (0); }
energy { type energyBalance; $library } solidEnergy { type solidEnergies; $library } }"
above='(0.04 0.042 0) (0.06 0.05 0.01)'
fill "$above"
says bothSets 'Written 160 particles to 0/lagrangian/fluid'
says bothSets2 'Written 10 particles, 13 bonds'
riprapFoam >log 2>&1 && pass run || fail run "$(grep -m1 -A3 ERROR log)"
says coupling 'coupling +extrapolated, fluidForce impulse, viscosity yes, XSPH no, antiClump no'
says subcycles 'timeIntegration +leapfrog, step [0-9.e-]+ s \(.*\): [0-9]+ a step of the fluid'
says step 'Solids: steps = [0-9]+ \([0-9]+\), [0-9]+ a step of the fluid'
for field in fluid/positions fluid/p solids/positions solids/U solids/origId
do
    [[ -s 0.02/lagrangian/$field ]] && pass "field.${field/\//.}" \
        || fail "field.${field/\//.}" "not written"
done
for table in level/0/waterLevel.dat one/0/particleDisplacement.dat energy/0/energyBalance.dat \
    solidEnergy/0/solidEnergies.dat
do
    [[ $(grep -vc '^#' postProcessing/$table) == 5 ]] && pass "table.${table%%/*}" \
        || fail "table.${table%%/*}" "not 5 rows"
done
cp 0.02/lagrangian/solids/positions solids; cp 0.02/lagrangian/fluid/positions fluid
rm -r 0.02; riprapFoam >log 2>&1
says restart 'Continuing exactly from time 0.01'
cmp -s solids 0.02/lagrangian/solids/positions && pass restartSolids \
    || fail restartSolids "other positions"
cmp -s fluid 0.02/lagrangian/fluid/positions && pass restartFluid \
    || fail restartFluid "other positions"
sed -i 's/^(0.04\([0-9]*\) /(0.0400\1 /' 0.01/lagrangian/solids/positions
rm -r 0.02; riprapFoam >log 2>&1
says edited 'State in uniform/riprap is not used: lagrangian/solids has been changed'
for kind in stationary pressureGradient pressureApproximation
do
    rm -rf 0.0* postProcessing; fluid "coupling $kind;"
    riprapFoam >log 2>&1 && pass "run.$kind" || fail "run.$kind" "$(grep -m1 -A3 ERROR log)"
    says "says.$kind" "coupling +$kind"
done
for force in held interpolated
do
    rm -rf 0.0* postProcessing; fluid "couplingCoeffs { fluidForce $force; }"
    riprapFoam >log 2>&1 && pass "run.$force" || fail "run.$force" "$(grep -m1 -A3 ERROR log)"
    says "says.$force" "fluidForce $force"
    cp 0.02/lagrangian/fluid/positions fluid; rm -r 0.02; riprapFoam >log 2>&1
    says "restart.$force" 'Continuing exactly from time 0.01'
    cmp -s fluid 0.02/lagrangian/fluid/positions && pass "restartExact.$force" \
        || fail "restartExact.$force" "other positions"
done
rm -rf 0.0* postProcessing; fluid ''; solids 'groups { block { localDamping 0.1; } }'
fill "$above"; riprapFoam -dry-run >log 2>&1; says heldByLocalDamping 'fluidForce held'
solids ''; sed -i 's/material rubber; radius/rigid yes; material rubber; radius/; /^bonds/d' \
    system/setParticlesDict; rm -rf 0; setParticles >log 2>&1
# m (20^2 + 8^2)/12 mm2
says rigidBody 'block: one rigid body, mass 0\.128 kg per metre, centre \(0\.05 0\.046 0\.005\), '\
'principal moments of inertia \(0 0 4\.94933e-06\)'
says rigidCount 'Written 10 particles, 0 bonds and 1 clumps'
riprapFoam >log 2>&1 && pass run.rigid || fail run.rigid "$(grep -m1 -A3 ERROR log)"
says rigidLog 'particles +10, clumps 1, bonds 0'
says rigidFaces 'impermeable +1 of 1 rigid bodies'
grep -lqs surfaces 0.*/uniform/lagrangian/solids/cloudProperties && pass rigidFacesKept \
    || fail rigidFacesKept 'no written time knows the surface of the body'
cp 0.02/lagrangian/fluid/positions fluid; rm -r 0.02; riprapFoam >log 2>&1
says restartRigid 'Continuing exactly from time 0.01'
says rigidFacesAgain 'impermeable +1 of 1 rigid bodies'
cmp -s fluid 0.02/lagrangian/fluid/positions && pass restartRigidFluid \
    || fail restartRigidFluid "other positions"
rm -rf 0.0* postProcessing; fill "$above"
riprapFoam -dry-run >log 2>&1 && pass dryRun || fail dryRun "$(grep -m1 -A3 ERROR log)"
says memory 'solid points'

# Particles that the water cannot see as they are: h = 1.25 spacings, the kernel reaches 0.0125 m
sized() # SPACING of the block, 0.02 m square
{
    fill '(0.04 0.042 0) (0.06 0.062 0.01)'
    sed -i "s/radius 0.002;/spacing $1;/; /^bonds/d" system/setParticlesDict; rm -rf 0
    setParticles >log 2>&1 || fail "sized$1" "$(grep -m1 -A3 ERROR log)"
}
sized 0.005; riprapFoam -dry-run >log 2>&1
grep -q 'larger than the fluid' log \
    && fail sizeEqual 'warned of particles as large as the spacing' || pass sizeEqual
sized 0.01; riprapFoam -dry-run >log 2>&1
tr '\n' ' ' <log | tr -s ' ' >line
grep -q '4 of 4 solid particles are larger than the fluid.s spacing: .* a square of 0.01 m; '\
'the fluid.s spacing is 0.005 m' line &&
    pass sizeWarned || fail sizeWarned 'the log does not say how many are larger'
sized 0.02; wrong coarse 'Solids are too coarse for the fluid: .* a square of 0\.02 m; '\
'.*kernel reaches 0\.0125 m.*rigid yes.*spacing 0\.005' riprapFoam -dry-run

# What is refused
fluid 'couplingCoeffs { fluidForce impulse; }'; solids 'groups { block { localDamping 0.1; } }'
wrong impulseDamped 'Entry fluidForce of couplingCoeffs is impulse, '\
'but group block .* local damping.*held and interpolated' riprapFoam
solids ''
fluid 'coupling glue;'; wrong word \
    'coupling.*glue.*stationary.*pressureGradient.*pressureApproximation.*extrapolated' riprapFoam
fluid 'couplingCoeffs { XSPH yes; }'; wrong xsph \
    'Entry XSPH of couplingCoeffs is yes, but XSPH of constant/sphProperties is none' riprapFoam
fluid 'antiClump none; couplingCoeffs { antiClump yes; }'
wrong antiClump 'Entry antiClump of couplingCoeffs is yes' riprapFoam
fluid 'couplingCoeffs { fluidForce late; }'
wrong fluidForce 'fluidForce.*late.*held.*interpolated.*impulse' riprapFoam
fluid 'couplingCoeffs { drag yes; }'; wrong entry 'drag.*viscosity' riprapFoam
fluid ''; solids 'precision double;'
wrong precision 'Entry precision is double, and mixed in constant/sphProperties' riprapFoam
solids ''; fill '(0.04 0.03 0) (0.06 0.038 0.01)'
wrong overlap 'Solids overlap the fluid at the start: [0-9]+ particles of lagrangian/fluid' \
    riprapFoam
wrong thin 'block' fill '(0.04 0.042 0) (0.06 0.0432 0.01)'
fill "$above"; rm -r 0/lagrangian/solids; wrong noSolids 'solids' riprapFoam
fill "$above"; mv constant/solidProperties kept; fluid 'coupling stationary;'
wrong noProperties 'constant/solidProperties is missing' riprapFoam
