#!/bin/bash
# Obstacles and solids in the water of picDem: a run with both, exact restart, solids without water
# as with solver dem, and what is refused.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL picSolids no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL picSolids no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=picSolids
. "$root/tests/regression/setParticlesCases"

control()       # SOLVER END MORE
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom latestTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-3; adjustTimeStep yes; maxCo 0.3; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.02; writeFormat ascii; writePrecision 12; $3"
}
pressure()      # ENTRIES of p
{
    dictionary system/fvSolution <<<"solvers { p { $1 } }"
}
water() { dictionary constant/picProperties <<<"device cpu; precision double; $1"; }
stones()        # MORE ENTRIES of the pair
{
    dictionary constant/solidProperties <<<"materials { stone { rho 2500; E 1e9; \
nu 0.25; } } contact { normal linear; tangential history; }
pairs { default { restitution 0.5; friction 0.3; stiffness 1e5; $1 } } walls { material stone; }"
}
fill()          # REGIONS
{
    dictionary system/setParticlesDict <<<"spacing 0.005; packing square; regions ( $1 );"
    rm -rf 0; setParticles >log 2>&1 || fail fill "$(oneLine)"
}
sum() { cat "$1"/lagrangian/*/{positions,U} "$1"/p 2>/dev/null | cksum; }

pond='water { set fluid; source box; box (0 0 0) (0.2 0.06 0.01); clip yes; }'
pair='stones { set solids; material stone; radius 0.021; source csv; file "stones.csv"; }'
coupled='solver coupledPCG; tolerance 1e-9; relTol 0; preconditioner DIC;'
tank2
mkdir -p constant; printf 'x,y,z\n0.06,0.045,0.005\n0.13,0.07,0.005\n' >stones.csv
cp stones.csv constant/
control picDem 0.04 ''; pressure "$coupled"; water ''; stones 'gap 0.01;'
geometry 'sill { type searchableBox; min (-1 -1 -1); max (0.03 0.02 1); }'
fill "$pond $pair"
riprapFoam >log 2>&1 && pass run || fail run "$(grep -m1 -A3 ERROR log)"
says obstacles 'obstacles +\(sill\), moving: 0'
says solids 'coupling +implicit, contactVelocity 1'
says solved 'coupledPCG: +Solving for p, Initial residual'
says forces 'Solids: steps = [0-9]+ \([0-9]+\), [0-9]+ a step of the fluid, .*force of the fluid'
whole=$(sum 0.04)
rm -rf 0.04; riprapFoam >log 2>&1
says continues 'Continuing exactly from time 0.02'
[[ $(sum 0.04) == "$whole" ]] && pass exact || fail exact 'the continued run ends elsewhere'
rm -rf 0.0*

# Solids of 0.008 of the water's density stay in it, also with reflection
stones 'gap 0.01;'; sed -i 's/rho 2500/rho 20/' constant/solidProperties; setParticles >log 2>&1
riprapFoam >log 2>&1 && pass light || fail light "$(grep -m1 -A3 ERROR log)"
rm -rf 0.0*; stones 'gap 0.01;'; setParticles >log 2>&1

# By riprap's own multigrid: the same motion
pressure 'solver cudaPCG; tolerance 1e-9;'
riprapFoam >log 2>&1 && pass own || fail own "$(grep -m1 -A3 ERROR log)"
says ownSolved 'cudaPCG: +Solving for p, Initial residual'
rm -rf 0.0*

water 'coupling weak; contactVelocity 0.5;'; pressure 'solver cudaPCG; tolerance 1e-9;'
control picDem 0.01 ''
riprapFoam >log 2>&1 && pass weak || fail weak "$(grep -m1 -A3 ERROR log)"
says slowedAStep 'coupling +weak, contactVelocity 0.5 a step'
rm -rf 0.0*
water 'contactVelocity 0.5; contactVelocityTime 1e-3;'; riprapFoam -dry-run >log 2>&1
says slowedInTime 'coupling +implicit, contactVelocity 0.5 in 0.001 s'

# Placed within each other's gap: told before the first step
water ''; stones 'gap 0.06;'; riprapFoam -dry-run >log 2>&1
says touching 'Warning: solids touch at the start. The contacts of 2 bodies hold .* J, '\
'enough to throw them .* m up'
stones 'gap 0.01;'; riprapFoam -dry-run >log 2>&1
grep -q 'touch at the start' log && fail apart 'a warning of solids that do not touch' || pass apart

# A body of its own shape, turned: cut by its outline, continued to the bit
brick='source clumpsFromOutline; outline ((0 0 0) (0.06 0 0) (0.06 0.045 0) (0 0.045 0)); '\
'spheres 12; centres ((0.1 0.055 0.005)); orientation turned; angle 20;'
water ''; control picDem 0.04 ''; fill "$pond brick { set solids; material stone; $brick }"
riprapFoam >log 2>&1 && pass shape || fail shape "$(grep -m1 -A3 ERROR log)"
says shapes 'shapes +\(brick\)'
cp 0.04/lagrangian/solids/U whole; rm -rf 0.04; riprapFoam >log 2>&1
says shapeContinues 'Continuing exactly from time 0.02'
cmp -s whole 0.04/lagrangian/solids/U && pass shapeRestart \
    || fail shapeRestart 'the continued run ends elsewhere'
rm -rf 0.0*
fill "$pond leaf { set solids; material stone; ${brick//0.045/0.02} }"
refused thin 'solids of shape leaf, .* thinner than 4 cells' riprapFoam

# Without water: what solver dem does
motion='functions { stones { type groupMotion; libs ("libriprapFoam.so"); groups (free); } }'
rm constant/geometry; dictionary system/setParticlesDict <<<"regions ( $pair );"
rm -rf 0; setParticles >log 2>&1 || fail dryFill "$(oneLine)"
# as dem's default
pressure "$coupled"; dictionary constant/picProperties <<<"device cpu; precision mixed;"
for solver in dem picDem
do
    control $solver 0.1 "$motion"
    riprapFoam >log 2>&1 || fail "dry$solver" "$(grep -m1 -A3 ERROR log)"
    cp postProcessing/stones/0/groupMotion.dat $solver.dat; rm -rf 0.[0-9]* postProcessing
done
cmp -s dem.dat picDem.dat && pass dry \
    || fail dry 'solids without water move otherwise than with solver dem'

# What is refused
control picDem 0.01 ''; fill "$pond $pair"
pressure 'solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0;'
refused host 'solver PCG of p cannot move free bodies with the water. Valid: coupledPCG, cudaPCG' \
    riprapFoam
pressure "$coupled"
water 'coupling strong;'
refused coupling 'coupling.*strong.*weak|coupling.*strong.*implicit' riprapFoam
water 'contactVelocity 1.5;'
refused contactVelocity 'contactVelocity.*1.5' riprapFoam
for time in 0 -0.0001
do
    water "contactVelocity 0.5; contactVelocityTime $time;"
    refused "contactVelocityTime$time" "contactVelocityTime is $time: it must be positive" \
        riprapFoam
done
water 'contactVelocity 0.5; contactVelocityTime never;'
refused contactVelocityWord \
    "expected scalar value, found on line 2: word 'never'.*contactVelocityTime" riprapFoam
water 'walls { slip noSlip; motion { gone { patches (gone); solidBodyMotionFunction linearMotion; '\
'linearMotionCoeffs { velocity (0 0 0); } } } }'
refused motion 'no constant/geometry: picDem moves entries of that dictionary' riprapFoam
water ''
cp constant/solidProperties kept
sed -i 's/stiffness [0-9.e]*/stiffness 1e18/' constant/solidProperties
refused stiffness 'Solids would take .* steps of .* s .* in a step of the fluid, '\
'.* at most 1(000000|e\+06) are taken.*solidProperties' riprapFoam
mv kept constant/solidProperties
geometry 'far { type searchableBox; min (5 5 -1); max (6 6 1); }'
refused obstacle 'Surface far of constant/geometry, .* does not meet the mesh' riprapFoam
rm constant/geometry
printf 'x,y,z\n0.06,0.045,0.005\n0.09,0.045,0.005\n' >overlapping.csv
printf 'x,y,z\n0.06,0.045,0.005\n0.5,0.045,0.005\n' >outside.csv
printf 'x,y,z,mass\n0.06,0.045,0.005,0\n' >massless.csv
for list in overlapping outside massless
do
    dictionary system/setParticlesDict <<<"spacing 0.005; packing square; regions ( $pond stones { \
set solids; material stone; radius 0.021; source csv; file \"$list.csv\"; } );"
    case $list in
        overlapping) why='Particles overlap at the start: .*region stones at' ;;
        outside) why='outside the mesh' ;;
        massless) why='mass is 0: it must be positive' ;;
    esac
    refused $list "$why" setParticles
done
fill "$pond stones { set solids; material stone; radius 0.01; source csv; file \"stones.csv\"; }"
refused small 'solid particle 0 of radius 0.01.* m is smaller than 4 cells' riprapFoam

# Boxes, cylinders and spheres of their own entries, with particles that are finer than the grid:
# held in water they bear what they displace, whatever their centre of mass. A box with ballast
# floats, and its run continues to the bit
lift()          # FILE: the last force along y
{
    awk '!/^#/ {gsub(/[()]/, " "); y = $3} END {print y}' "$1"
}
within()        # NAME FOUND WANTED TOLERANCE
{
    awk -v a="$2" -v b="$3" -v t="$4" 'BEGIN {d = a/b - 1; exit !(d < t && d > -t)}' && pass "$1" \
        || fail "$1" "$2 instead of $3"
}
forceOf='functions { lift { type particleForces; libs ("libriprapFoam.so"); groups (held); '\
'CofR (0 0 0); } }'
held='groups { held { fixed all; } }'
pond='water { set fluid; source box; box (0 0 0) (0.2 0.1 0.2); clip yes; pressure zero; }'
block 0.2 0.2 0.2 '20 20 20' "$sides $lower $open back { type wall; \
faces ((0 3 2 1)); } front { type wall; faces ((4 5 6 7)); }"
rm -f constant/geometry; water ''; pressure 'solver cudaPCG; tolerance 1e-9;'
control picDem 0.02 "$forceOf"
stones ''; echo "$held" >>constant/solidProperties
float='set solids; material stone; group held; rigid yes; spacing 0.012;'
# turned principal axes
ballast='density 500; centreOfMass (0.1 0.08 0.1); inertia (3e-4 2e-5 0 4e-4 0 3e-4);'
while read -r name volume entries
do
    fill "$pond $name { $float $entries }"
    riprapFoam >log 2>&1 || fail "$name" "$(grep -m1 -A3 ERROR log)"
    says "${name}Shape" "shapes +\\($name\\)"
    within "$name" "$(lift postProcessing/lift/0/force.dat)" \
        "$(awk -v v="$volume" 'BEGIN {print 9810*v}')" 0.01
    rm -rf 0.[0-9]* postProcessing
done <<EOF
box        1.92e-4      source box; box (0.06 0.06 0.07) (0.14 0.14 0.13); density 500;
ballasted  1.92e-4      source box; box (0.06 0.06 0.07) (0.14 0.14 0.13); $ballast
drum       1.413717e-4  source cylinder; p1 (0.1 0.05 0.1); p2 (0.1 0.15 0.1); radius 0.03; \
packing fitted; density 500;
ball       1.130973e-4  source sphere; centre (0.1 0.1 0.1); radius 0.0378; packing fitted; \
density 500;
EOF

fill "$pond float { ${float/held/free} source box; box (0.06 0.06 0.07) (0.14 0.14 0.13); \
$ballast }"
control picDem 0.04 ''
riprapFoam >log 2>&1 && pass float || fail float "$(grep -m1 -A3 ERROR log)"
cp 0.04/lagrangian/solids/U whole; rm -rf 0.04; riprapFoam >log 2>&1
says floatContinues 'Continuing exactly from time 0.02'
cmp -s whole 0.04/lagrangian/solids/U && pass floatRestart \
    || fail floatRestart 'the continued run ends elsewhere'
exit 0
