#!/bin/bash
# What riprapFoam -dry-run says that a scene does not need: each claim is made where it holds and
# nowhere else, and a run without these entries and models has the same bits. What a step takes is
# on a page of its own, and counts are those of the table: benchmarks/sceneNeeds -check. The barest
# scenes take no more instructions than there: -instructions
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL sceneNeeds no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL sceneNeeds no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=sceneNeeds
. "$root/tests/regression/setParticlesCases"
export OMP_NUM_THREADS=1

control()   # SOLVER END MORE
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom startTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-3; adjustTimeStep yes; sampleInterval $2; writeControl adjustableRunTime; \
writeInterval $2; writeFormat binary; ${3:-}"
}
wrong() { grep -A4 -m1 'FOAM FATAL' log | tr '\n' ' '; }
fill() { rm -rf 0 VTK; setParticles >log 2>&1 || fail fill "$(wrong)"; }
# Of the particles at the end, every file
bits()      # NAME
{
    rm -rf 0.* [1-9]* postProcessing
    riprapFoam >log 2>&1 || fail "$1.runs" "$(wrong)"
    find 0.* -path '*lagrangian*' -type f ! -name cloudProperties -exec cksum {} + | sort >"$1.bits"
    [[ -s $1.bits ]] || fail "$1.bits" 'nothing was written'
}
same()      # NAME FIRST SECOND
{
    cmp -s "$2.bits" "$3.bits" && pass "$1" \
        || fail "$1" "$(diff "$2.bits" "$3.bits" | head -4 | tr '\n' ' ')"
}
# The places that the dry run names, sorted, one a line
named() { sed -n 's/^    \(\(constant\|system\)[^:]*, entry [^:]*\): .*/\1/p' log | sort; }
claims()    # NAME PLACE...: these, and no others
{
    local name=$1; shift
    riprapFoam -dry-run >log 2>&1 || { fail "$name" "$(wrong)"; return; }
    printf '%s\n' "$@" | grep . | sort >expected; named >found
    cmp -s expected found && pass "$name" || fail "$name" "$(diff expected found | tr '\n' ' ')"
}
none()
{
    claims "$1"
    says "$1.says" 'Entries and models without effect on this scene: none found'
}

# sphDem: entries
sph() { dictionary constant/sphProperties <<<"device cpu; $1"; }
tank2; regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.08 0.01); }'
common='viscosity none; densityDiffusion none; equationOfState linear; '
control sphDem 0.005 'maxCo 0.3; maxFlyingCo 2;'
sph "$common gamma 6; smoothingLength { maxGrowth 1.4; } artificialViscosity { alpha 0.3; } \
laminarViscosity { softening 0.1; } densityDiffusionCoeffs { delta 0.3; }
shiftingCoeffs { A 4; } walls { slip freeSlip; } guards { wild stop; maxWild 0.1; escape stop; \
maxEscaped 0.5; }"
fill
claims sph.idle 'constant/sphProperties, '\
'entry '{gamma,smoothingLength/maxGrowth,artificialViscosity,laminarViscosity,\
densityDiffusionCoeffs,shiftingCoeffs,walls/slip,guards/maxWild,guards/maxEscaped} \
    'constant/fluidProperties, entry mu' 'system/controlDict, entry '{maxCo,maxFlyingCo}
says sph.why 'constant/sphProperties, entry walls/slip: no term that is chosen acts at walls'
bits with
control sphDem 0.005; sph "$common guards { wild stop; escape stop; }"
dictionary constant/fluidProperties <<<'rho 1000; mu 1;'
bits without; same sph.idle.bits with without
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'
claims sph.without 'constant/fluidProperties, entry mu'
control sphDem 0.005 'adjustTimeStep no; deltaT 2e-5; maxDeltaT 1e-5;'
sph 'acousticCourant 0.1; forceCourant 0.1; viscousCourant 0.1;'
claims sph.fixed 'constant/sphProperties, entry '{acoustic,force,viscous}Courant \
    'system/controlDict, entry maxDeltaT'
bits with; control sphDem 0.005 'adjustTimeStep no; deltaT 2e-5;'; sph ''; bits without
same sph.fixed.bits with without
none sph.none
sph 'smoothingLength { model variable; maxGrowth 1; }'
claims sph.growth 'constant/sphProperties, entry smoothingLength/model'
says sph.growth.says 'maxGrowth is 1, so h stays what it is; `model constant` '\
'(saves [0-9.]+ % of a step \(measured\)|does the same)'
sph 'smoothingLength { model variable; maxGrowth 1.1; }'; none sph.grows
resting='walls { motion { lid { patches (right); solidBodyMotionFunction oscillatingLinearMotion; '
sph "$resting omega 40; amplitude (0 0 0); } } }"
claims sph.resting 'constant/sphProperties, entry walls/motion/lid'
says sph.resting.says 'entry walls/motion/lid: its walls rest until endTime; without it they are '\
'fixed, which takes less'
sph "$resting omega 40; amplitude (1e-6 0 0); } } }"; none sph.moves

# Terms that are on with a factor of 0
control sphDem 0.005
sph 'viscosity laminarAndArtificial; artificialViscosity { alpha 0; } densityDiffusion molteni; '\
'densityDiffusionCoeffs { delta 0; } shifting fickian; shiftingCoeffs { A 0; }'
claims sph.on 'constant/sphProperties, entry '{viscosity,densityDiffusion,shifting}
says sph.on.viscosity 'entry viscosity: a factor of its terms is 0; '\
'`viscosity laminar` does the same, tried for [1-9][0-9]* steps; saves ([0-9.]+ % of a step '\
'\([0-9.]+ of [0-9.]+ us, measured\)|less than 2 % of a step \(measured\))'
says sph.on.diffusion 'entry densityDiffusion: .*`densityDiffusion none` does the same'
says sph.on.shifting 'entry shifting: A is 0; '\
'`shifting none` does the same.* saves .* and [0-9.]+ [kM]?B of [0-9.]+ [kM]?B'
bits with; sph 'viscosity laminar; densityDiffusion none; shifting none;'; bits without
same sph.on.bits with without

# dem: entries
tank2; rm -f constant/sphProperties constant/fluidProperties
control dem 0.01
dictionary system/setParticlesDict \
    <<<'regions ( two { set solids; material glass; radius 0.005; spacing 0.01; packing square; '\
'source box; box (0.02 0 0) (0.08 0.04 0.01); velocity (0.3 -0.2 0); } );'
solids()    # PAIR MATERIALS PAIRS MORE
{
    dictionary constant/solidProperties \
        <<<"device cpu; materials { glass { rho 2500; nu 0.25; } $2 }
contact { normal linear; ${5:-} } pairs { default { restitution 0.9; stiffness 1e5; \
$1 } $3 } walls { material glass; } $4"
}
solids 'friction 0.2;' '' '' ''; fill
solids 'friction 0.2; rollingFriction 0.1; theta 0.02;' 'steel { rho 7800; nu 0.3; }' \
    'glass-steel { restitution 0.5; stiffness 5e4; friction 0; }' \
    'groups { tip { fixed all; } } bonds { cement { normalStiffness 1e8; '\
'shearStiffness 1e8; } } guards { escape stop; maxEscaped 0.1; }' 'withinBonds yes;'
claims dem.idle 'constant/solidProperties, '\
'entry '{materials/steel,pairs/glass-steel,pairs/default/rollingFriction,pairs/default/theta,\
groups/tip,bonds/cement,contact/withinBonds,guards/maxEscaped}
says dem.group 'entry groups/tip: no solid is in this group'
bits with; solids 'friction 0.2;' '' '' 'guards { escape stop; }'; bits without
same dem.idle.bits with without
none dem.none
solids 'friction 0.2;' '' '' "$resting omega 40; amplitude (0 0 0); } } }"
claims dem.resting 'constant/solidProperties, entry walls/motion/lid'
# Nobody meets so, and yet it decides on the step
solids 'friction 0.2;' 'steel { rho 7800; nu 0.3; }' \
    'glass-steel { restitution 0.5; stiffness 4e5; friction 0; }'  ''
claims dem.stiff 'constant/solidProperties, entry '{materials/steel,pairs/glass-steel}
said=$(sed -nE 's/.*pairs.glass-steel: no solid .* sets the time step: ([0-9.e-]+) s, '\
'and ([0-9.e-]+) s without it/\1 \2/p' log)
steps() { sed -nE 's/^Time step of the particles: ([0-9.e-]+) s.*/\1/p' log; }
with=$(steps); solids 'friction 0.2;' '' '' ''; riprapFoam -dry-run >log 2>&1
awk -v s="$said $with $(steps)" 'BEGIN { split(s, v, " ");
        exit !(v[2] > 1.9*v[1] && v[1]/v[3] > 0.99 && v[1]/v[3] < 1.01 &&
            v[2]/v[4] > 0.99 && v[2]/v[4] < 1.01) }' &&
    pass dem.stiff.steps || fail dem.stiff.steps "said $said, steps $with and $(steps)"
dictionary constant/solidProperties <<<'device cpu; materials { glass { rho 2500; E 1e7; '\
'nu 0.25; } } contact { normal linear; } walls { material glass; } stepFraction 0.1;
pairs { glass-glass { restitution 0.9; stiffness 1e5; friction 0.2; } default { restitution 0.5; '\
'stiffness 2e5; friction 0; } }'
control dem 0.01 'adjustTimeStep no; deltaT 1e-5; maxDeltaT 1e-6;'
claims dem.fixed 'constant/solidProperties, entry '{materials/glass/E,pairs/default,stepFraction} \
    'system/controlDict, entry maxDeltaT'
bits with; control dem 0.01 'adjustTimeStep no; deltaT 1e-5;'
solids 'friction 0.2;' '' '' ''; bits without; same dem.fixed.bits with without

# Laws that are on without friction; with it in a pair that meets none
control dem 0.01
solids 'friction 0; rollingFriction 0;' 'steel { rho 7800; nu 0.3; }' 'steel-steel { restitution '\
'0.5; stiffness 2e5; friction 0.3; rollingFriction 0.1; }' '' 'rolling spring;'
claims dem.on 'constant/solidProperties, '\
'entry '{materials/steel,pairs/steel-steel,contact/rolling,contact/tangential}
says dem.on.rolling 'contact/rolling: rollingFriction is 0 in all pairs that can meet; '\
'`rolling none` does the same, tried for [1-9][0-9]* steps; saves .*of [0-9.]+ [kM]?B'
says dem.on.tangential 'contact/tangential: friction is 0 in all pairs that can meet, '\
'and rolling does nothing; `tangential none` does the same'
bits with
dictionary constant/solidProperties \
    <<<'device cpu; materials { glass { rho 2500; nu 0.25; } } contact { normal linear; '\
'tangential none; } pairs { default { restitution 0.9; stiffness 1e5; } } walls { material glass; }'
bits without; same dem.on.bits with without
solids 'friction 0; rollingFriction 0.1;' '' '' '' 'rolling spring;'
none dem.rolls

# Damping of solids that are fixed
dictionary system/setParticlesDict \
    <<<'regions ( two { set solids; material glass; group held; radius 0.005; spacing 0.01; '\
'packing square; source box; box (0.02 0 0) (0.08 0.04 0.01); } );'
held() { solids 'friction 0.2;' '' '' "groups { held { fixed $1; ${2:-} } }"; }
held all 'viscousDamping 5; viscousSpinDamping 2;'; fill
claims dem.held 'constant/solidProperties, entry groups/held/'{viscousDamping,viscousSpinDamping}
says dem.held.why 'entry groups/held/viscousDamping: its solids are fixed'
bits with; held all; bits without; same dem.held.bits with without
held '(x spin)' 'viscousDamping 5;'; none dem.notHeld

# picDem: entries, and a viscosity that the grid does not resolve
tank2; rm -f constant/solidProperties constant/sphProperties
control picDem 0.02
dictionary system/fvSolution \
    <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; reflectionTolerance 1e-3; } }'
pic() { dictionary constant/picProperties <<<"device cpu; $1"; }
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.05 0.01); }'
pic 'reflection no; viscosity none; seeds { perDirection 0; jitter 0.5; } absorb { beach { from '\
'(0.3 0 0); to (0.4 0 0); rate 5; } calm { from (0.1 0 0); to (0.2 0 0); rate 0; } }
contactVelocity 0.5; contactVelocityTime 0.1; coupling weak; guards { escape stop; '\
'maxEscaped 0.1; }'
fill
claims pic.idle 'constant/picProperties, '\
'entry '{seeds/jitter,absorb/beach,absorb/calm,contactVelocity,contactVelocityTime,coupling,\
guards/maxEscaped} \
    'system/fvSolution, entry solvers/p/reflectionTolerance'
says pic.none 'off +\(viscosity reflection '
bits with
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }'
pic 'reflection no; viscosity none; seeds { perDirection 0; } guards { escape stop; }'; bits without
same pic.idle.bits with without
none pic.nothing
control picDem 0.02 'adjustTimeStep no; deltaT 1e-3; maxDeltaT 1e-4; maxCo 0.2; maxFlyingCo 1;'
claims pic.fixed 'system/controlDict, entry '{maxDeltaT,maxCo,maxFlyingCo}
bits with; control picDem 0.02 'adjustTimeStep no; deltaT 1e-3;'; bits without
same pic.fixed.bits with without

functions='functions { energy { type energyBalance; libs ("libriprapFoam.so"); } }'
energy() { bits "$1"; awk '!/#/ { e = $2 } END { print e }' postProcessing/energy/0/*.dat; }
control picDem 1; pic ''
claims pic.viscosity 'constant/picProperties, entry viscosity'
says pic.viscosity.says \
    'entry viscosity: nu 1e-06 m2/s damps waves of 10 cells by 0\.[5-7][0-9]+ % until endTime; '\
'nu dt/dx\^2 is [0-9.e-]+, and its kernels take [0-9.]+ % of the time of all: `viscosity none`'
control picDem 0.1 "$functions"
with=$(energy with); pic 'viscosity none;'; without=$(energy without)
# Kinetic energy goes with the square of velocities; walls do not slip
cmp -s with.bits without.bits && fail pic.viscosity.acts 'the same bits without viscosity' \
    || pass pic.viscosity.acts
awk -v a="$with" -v b="$without" 'BEGIN { d = a/b - 1; exit !(a > 0 && d < 2e-3 && d > -2e-3) }' \
    && pass pic.viscosity.little \
    || fail pic.viscosity.little "energy $with, $without without viscosity"
dictionary constant/fluidProperties <<<'rho 1000; mu 1;'; pic ''
quiet pic.viscous 'entry viscosity: nu'
none pic.viscous.none

# No scene runs a loop or holds a field for what it does not have
"$root/Allwmake" benchmarks/sceneCounts >log 2>&1 && . "$root/etc/bashrc" \
    || fail counts.build "$(tail -3 log)"
if said=$("${RIPRAP_PYTHON:-python3}" "$root/benchmarks/sceneNeeds" -check 2>&1)
then
    pass counts
else
    fail counts "${said//$'\n'/; }"
fi

# What is not used costs no more instructions than it did
said=$("${RIPRAP_PYTHON:-python3}" "$root/benchmarks/sceneNeeds" -instructions 2>&1)
case $? in
    0) pass instructions;;
    3) echo "SKIP $suite.instructions ${said//$'\n'/; }";;
    *) fail instructions "${said//$'\n'/; }";;
esac
