#!/bin/bash
# Solids: counts of setParticles that can be computed by hand, a run, its files, exact restart,
# function objects, and one message for every entry that can be wrong.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL dem no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL dem no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=dem
. "$root/tests/regression/setParticlesCases"

# Last value of a column of a table, to be within LOW..HIGH
column()    # NAME OBJECT COLUMN LOW HIGH
{
    local value
    value=$(awk -v c="$3" '/^#/ {for (i = 2; i <= NF; ++i) if ($i == c) k = i - 1; next} {x = $k}
            END {print x}' postProcessing/"$2"/*/*.dat)
    awk -v x="${value:-nan}" -v a="$4" -v b="$5" 'BEGIN {exit !(x + 0 == x && x >= a && x <= b)}' \
        && pass "$1" || fail "$1" "$3 is '$value', not within $4 and $5"
}
solids()    # MORE ENTRIES of solidProperties
{
    dictionary constant/solidProperties <<<"device cpu;
materials { glass { rho 2500; E 1e7; nu 0.25; } steel { rho 7800; E 1e8; nu 0.3; } }
pairs { default { restitution 0.9; friction 0.3; stiffness 1e4; } } walls { material steel; } $1"
}
control()   # ENTRIES
{
    dictionary system/controlDict <<<"application riprapFoam; solver dem; startFrom latestTime; \
startTime 0; stopAt endTime; endTime 0.1;
deltaT 1e-5; adjustTimeStep yes; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.05; writeFormat ascii; writePrecision 12; $1"
}
set2() { dictionary system/setParticlesDict <<<"regions ( $1 ); ${2:-}"; }
fill() { set2 "$@"; setParticles >log 2>&1; }

# Counts. 2D: tank 0.2 x 0.1 m
tank2; solids ''; control ''
glass='set solids; material glass; radius 0.005;'
fill "pile { $glass source box; box (0 0 0) (0.06 0.06 0.01); }"
says square2 'pile: 36 particles, radius 0.005 m, mass 7\.068[0-9]* kg per metre'
fill "pile { $glass source box; box (0 0 0) (0.06 0.06 0.01); packing layers; }"
says layers2 'pile: 33 particles'                       # 6 + 5 + 6 + 5 + 6 + 5
fill "pile { $glass source box; box (0 0 0) (0.065 0.06 0.01); packing hexagonal; }"
says hexagonal2 'pile: 36 particles'                    # room for 6 in shifted rows as well
fill "pile { $glass source box; box (0 0 0) (0.065 0.06 0.01); packing layers; }"
says layersAlternate2 'pile: 33 particles'
fill "pile { $glass source box; box (0 0 0) (0.06 0.06 0.01); mass cell; }"
says massCell2 'mass 9 kg per metre'                    # rho times the box
fill "pile { $glass source box; box (0 0 0) (0.06 0.06 0.01); spacing 0.011; }"
says spacing2 'pile: 25 particles'
round='set solids; material glass; source cylinder; p1 (0.1 0.05 -1); p2 (0.1 0.05 1); radius 0.03;'
fill "pile { $round particleRadius 0.005; }"
# of 6 x 6 in the square about it those that lie wholly in the circle
says cylinderRadius2 'pile: 16 particles, radius 0.005 m'
fill "pile { $round spacing 0.01; }"
says cylinderSpacing2 'pile: 16 particles, radius 0.005 m'
fill "pile { $round particleRadius 0.03; }"
says cylinderOne2 'pile: 1 particles, radius 0.03 m, mass 7\.068[0-9]* kg'
fill "pile { set solids; material glass; spacing 0.01; source box; box (0 0 0) (0.06 0.06 0.01); }"
says spacingAlone2 'pile: 36 particles, radius 0.005 m'
fill "pile { $round packing random; particleRadius 0.003; largestRadius 0.004; solidFraction 0.5; }"
says cylinderRandom2 'pile: [0-9]+ particles, radius 0.003'
fill "pile { set solids; material glass; source box; box (0 0 0) (0.1 0.1 0.01); radius 0.003; \
largestRadius 0.005; packing random; solidFraction 0.7; }"
says random2 'pile: 1[0-9][0-9] particles, radius 0.003'
cp 0/lagrangian/solids/positions first; setParticles >log 2>&1
cmp -s first 0/lagrangian/solids/positions && pass randomRepeats \
    || fail randomRepeats "another packing with the same seed"
# Sizes with shares: counts are share x solidFraction x 0.01 m2 / (pi r2), of the number with the
# mean area of a disk
sizes='a { set solids; material glass; source box; box (0 0 0) (0.1 0.1 0.01); packing random; '\
'solidFraction 0.6;'
fill "$sizes radii (0.002 0.004); shares (0.3 0.7); }"
# 0.3 0.006/(pi 4e-6) = 143.2
says sharesOfMass \
    'radius 0.002 m: 143 particles, 62\.[0-9]* % of the number, 29\.8[0-9]* % of the mass'
says sharesOfMassLarge \
    'radius 0.004 m: 84 particles, 37\.[0-9]* % of the number, 70\.1[0-9]* % of the mass'
says sharesTotal 'a: 227 particles, radius 0.002 to 0.004 m, mass 15\.[0-9]* kg per metre'
cp 0/lagrangian/solids/positions first; setParticles >log 2>&1
cmp -s first 0/lagrangian/solids/positions && pass sharesRepeat \
    || fail sharesRepeat "another packing with the same seed"
fill "$sizes radii (0.002 0.004); shares (0.8 0.2); sharesOf number; }"
# 0.8 0.006/(pi (0.8 4e-6 + 0.2 16e-6)) = 238.7
says sharesOfNumber 'radius 0.002 m: 239 particles, 79\.9[0-9]* % of the number'
printf 'x,y,z,radius,material,group\n0.05,0.05,0,0.01,steel,held\n0.1,0.05,0,0.02,glass,free\n' \
    >list.csv
solids 'groups { held { fixed all; } }'
fill 'list { set solids; source csv; file "list.csv"; material glass; }'
# pi (7800 1e-4 + 2500 4e-4)
says csv 'list: 2 particles, radius 0.01 to 0.02 m, mass 5\.59[0-9]* kg'
grep -q '(0.1 0.05 0.005' 0/lagrangian/solids/positions && pass csvMidPlane \
    || fail csvMidPlane "particles are not in the mid-plane"
# One rigid body has one velocity: columns of a list would be lost
for columns in 'u,v,w 1,0,0' 'wx,wy,wz 0,0,1' 'group held'
do
    set -- $columns
    printf 'x,y,z,radius,%s\n0.05,0.05,0,0.01,%s\n0.07,0.05,0,0.01,%s\n' "$1" "$2" "$2" >rigid.csv
    set2 'list { set solids; source csv; rigid yes; file "rigid.csv"; material glass; }'
    refused "rigidList.${1%%,*}" "Region list is one rigid body, \
and its list has the columns ${1//,/, }.*velocity.*setParticlesDict" setParticles
done
solids 'bonds { cement { normalStiffness 1e9; shearStiffness 1e9; } }'
fill "bar { $glass source box; box (0 0 0) (0.06 0.02 0.01); }" \
    'bonds ( bar { type cement; groups (free); gapTolerance 1e-6; } );'
says bonds2 'bonds bar: 16'                             # 2 x 5 + 6
[[ -s 0/uniform/lagrangian/solids/bonds/a ]] && pass bondFiles \
    || fail bondFiles "no bonds in 0/uniform/lagrangian/solids"
square='source clumpsFromOutline; outline ((0 0 0) (0.02 0 0) (0.02 0.02 0) (0 0.02 0)); spheres 9;'
fill "brick { set solids; material glass; $square centres ((0.05 0.05 0) (0.1 0.05 0)); \
orientation random; }"
says outline 'brick: 2 clumps of 9 spheres.* area 0\.0004 m2, .* \(0 0 2\.66667e-08\) m4'   # a^4/6
says outlineMass 'mass 2 kg per metre, 2 clumps'        # 2500 a^2 twice
control 'endTime 0.02; writeInterval 0.01;'
riprapFoam >log 2>&1 && pass outlineRuns || fail outlineRuns "$(grep -m1 -A3 ERROR log)"
rm -rf 0.[0-9]*
control 'maxDeltaT 2e-6; endTime 1e-4; sampleInterval 1e-4; writeInterval 1e-4;'
riprapFoam >log 2>&1
says maxDeltaT 'Particle steps = 50 \(50\), deltaT = 2e-06 s, limit: maxDeltaT'
rm -rf 0.[0-9]* 1e-*; control ''
# Momentum of rigid bodies: of 1 kg/m at (0.05 0.05) and (0.1 0.05), with 0.1 m/s and 5 rad/s;
# whatever the masses of their members
dictionary constant/g uniformDimensionedVectorField <<<'dimensions [0 1 -2 0 0 0 0]; value (0 0 0);'
control 'endTime 2e-4; sampleInterval 2e-4; writeInterval 2e-4; '\
'functions { energy { type solidEnergies; libs ("libriprapFoam.so"); } }'
fill "brick { set solids; material glass; $square centres ((0.05 0.05 0) (0.1 0.05 0)); \
orientation random; velocity (0.1 0 0); spin (0 0 5); }"
riprapFoam >log 2>&1 && pass bricksRun || fail bricksRun "$(grep -m1 -A3 ERROR log)"
column momentumOfBodies energy momentumX 0.19999 0.20001
# -y p + I w = -0.05 x 0.2 + 2 x 6.6667e-5 x 5
column angularMomentumOfBodies energy angularZ -0.009334 -0.009332
rm -rf [1-9]*e-* 0.[0-9]* postProcessing
dictionary constant/g uniformDimensionedVectorField \
    <<<'dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);'
tank3; solids ''; control ''
fill 'cube { set solids; material glass; radius 0.005; source box; box (0 0 0) (0.04 0.04 0.04); }'
says square3 'cube: 64 particles'
fill 'cube { set solids; material glass; radius 0.005; source box; box (0 0 0) (0.04 0.04 0.04); '\
'packing layers; }'
says layers3 'cube: [0-9]+ particles'
octahedron constant/triSurface/octa.stl 1
fill 'rock { set solids; material glass; source clumpsFromSurface; file "octa.stl"; '\
'centres ((0.025 0.03 0.02) (0.075 0.03 0.02)); }'
says clumps 'rock: 2 clumps of [0-9]+ spheres'
# m r^2/5
says clumpInertia 'moments of inertia per density \(8\.53333e-10 8\.53333e-10 8\.53333e-10\)'
says clumpMass 'mass 0\.0533333 kg, 2 clumps'          # rho 4/3 r^3 twice, r = 0.02
cp 0/uniform/lagrangian/solids/clumps/orientationReal given
cp 0/lagrangian/solids/positions asGiven
fill 'rock { set solids; material glass; source clumpsFromSurface; file "octa.stl"; '\
'centres ((0.025 0.03 0.02) (0.075 0.03 0.02)); orientation turned; axis (0 0 1); angle 90; }'
says clumpTurned 'rock: 2 clumps of [0-9]+ spheres'
cmp -s given 0/uniform/lagrangian/solids/clumps/orientationReal \
    && fail clumpTurns "turned clumps stand as given" || pass clumpTurns
fill 'rock { set solids; material glass; source clumpsFromSurface; file "octa.stl"; '\
'centres ((0.025 0.03 0.02) (0.075 0.03 0.02)); orientation random; seed 3; }'
cmp -s asGiven 0/lagrangian/solids/positions && fail clumpRandom "random clumps stand as given" \
    || pass clumpRandom
fill 'rock { set solids; material glass; source clumpsFromSurface; file "octa.stl"; '\
'centres ((0.025 0.03 0.02) (0.075 0.03 0.02)); }'

control 'writeFormat binary; functions { energy { type solidEnergies; '\
'libs ("libriprapFoam.so"); } }'
riprapFoam >log 2>&1 && pass clumpsRun || fail clumpsRun "$(grep -m1 -A3 ERROR log)"
[[ -s 0.1/uniform/lagrangian/solids/clumps/orientationReal ]] && pass clumpFiles \
    || fail clumpFiles "no clumps in 0.1/uniform/lagrangian/solids"
mv 0.1 whole; riprapFoam >log 2>&1
says clumpsRestart 'Continuing exactly from time 0.05'
cmp -s 0.1/uniform/riprap/demState whole/uniform/riprap/demState && pass clumpsRestartExact \
    || fail clumpsRestartExact "a continued run is another one"
rm -rf 0.05 0.1 whole postProcessing

# Over an open top particles flow out, rigid bodies as a whole
tank2; solids ''; control ''
fill "up { $glass source box; box (0.05 0.07 0) (0.07 0.09 0.01); velocity (0 1 0); }"
riprapFoam >log 2>&1
says outflow '\(4 in all\), by nearest patch: upper 4.*Escaped through walls in all: 0.* End'
rm -rf 0 0.0* 0.1
fill "up { $glass source box; box (0.05 0.07 0) (0.07 0.09 0.01); velocity (0 1 0); rigid yes; }
stay { $glass source box; box (0.02 0 0) (0.04 0.02 0.01); rigid yes; }"
control 'writeFormat binary; functions { energy { type solidEnergies; '\
'libs ("libriprapFoam.so"); } }'
riprapFoam >log 2>&1
says bodyOutflow '\(4 in all\), by nearest patch: upper 4.*Escaped through walls in all: 0.* End'
mv 0.1 whole; riprapFoam >log 2>&1
says bodyOutflowRestart 'Continuing exactly from time 0.05'
cmp -s 0.1/uniform/riprap/demState whole/uniform/riprap/demState && pass bodyOutflowExact \
    || fail bodyOutflowExact "a continued run is another one"
rm -rf 0 0.0* 0.1 whole postProcessing

# A run: files, restart to the bit, function objects
tank2
library='libs ("libriprapFoam.so");'
objects="functions { motion { type groupMotion; $library } one { type particleDisplacement; \
$library origIds (0); } energy { type solidEnergies; $library }
forces { type solidWallForce; $library } chains { type contactChains; \
$library writeControl writeTime; } broken { type brokenBonds; $library } }"
solids 'bonds { cement { calibration moduli; E 1e7; '\
'G 4e6; } } groups { bar { } lone { viscousDamping 20; } }'
control "$objects"
rm -rf 0
fill "bar { $glass group bar; source box; box (0.1 0.05 0) (0.16 0.06 0.01); } \
lone { $glass group lone; source box; box (0.02 0 0) (0.03 0.01 0.01); }
pile { $glass source box; box (0.04 0 0) (0.09 0.05 0.01); packing layers; velocity (0.1 0 0); }" \
    'bonds ( bar { type cement; groups (bar); gapTolerance 1e-6; } );'
riprapFoam >log 2>&1 && pass run || fail run "$(grep -m1 -A3 ERROR log)"
says models 'contact +normal hertz, tangential history, rolling none, within bonds: no'
says off 'off +\(rolling clumps movingWalls movingGroups orientation sleep\)'
says unused 'not used +\(stiffness\)'
for field in U omega radius mass material group force contacts brokenBonds origId
do
    [[ -s 0.1/lagrangian/solids/$field ]] || fail "field.$field" "not written"
done
[[ -s VTK/bonds/bonds_0.1.vtp && -s VTK/bonds.vtp.series && -s VTK/chains/chains_0.1.vtp ]] \
    && pass vtp || fail vtp "no lines for ParaView"
# Its weight of 1.926 N/m sinks into the floor by 0.164 mm (Hertz, E* = 9.72 MPa); it still swings a
# little
column centre motion loneCentreY 0.0048 0.00487
column mass motion loneMass 0.19634 0.19636
column whole broken whole 5 5
column noneBroken broken broken 0 0
mv 0.1 whole; mv postProcessing whole/
riprapFoam >log 2>&1
says continues 'Continuing exactly from time 0.05'
same=yes
for file in lagrangian/solids/{positions,U,omega,force,moment} uniform/riprap/demState
do
    cmp -s 0.1/$file whole/$file || same="$file differs"
done
[[ $same == yes ]] && pass restart || fail restart "$same"
rm -r 0.1; cp -r 0.05 kept
sed -i '0,/^(0\./s/^(0\./(0.00/' 0.05/lagrangian/solids/positions; riprapFoam >log 2>&1
says edited 'State in uniform/riprap is not used: the cloud has been changed|overlap'
rm -rf 0.05 0.1; mv kept 0.05
foamToVTK -time 0.05 >log 2>&1
grep -q 'Lagrangian: .*solids_' log && pass foamToVTK || fail foamToVTK "$(grep -m1 -A2 ERROR log)"
rm -rf 0.05 0.1 VTK postProcessing whole
riprapFoam -dry-run >log 2>&1
says dryRun 'Particle steps to time 0.1'
[[ ! -e 0.05 ]] && pass dryRunWritesNothing || fail dryRunWritesNothing "-dry-run wrote"

# Walls and groups that move by a table which begins with the run and ends with it
tank2
printf '( (0 ((0 0 0) (0 0 0))) (0.05 ((0 0.001 0) (0 0 0))) (0.1 ((0 0.004 0) (0 0 0))) )' \
    >constant/table
table='solidBodyMotionFunction tabulated6DoFMotion; tabulated6DoFMotionCoeffs { CofG (0 0 0); '\
'timeDataFileName "constant/table"; }'
dictionary constant/solidProperties <<<"device cpu; materials { glass { rho 2500; E 1e7; \
nu 0.25; } } pairs { default { restitution 0.9; friction 0.3; } }
walls { material glass; motion { floor { patches (lower); \
$table } } } groups { lid { motion { $table } } }"
control "functions { motion { type groupMotion; $library } }"
fill "lid { $glass group lid; source box; \
box (0.05 0.03 0) (0.07 0.04 0.01); } pile { $glass source box; box (0.1 0 0) (0.15 0.03 0.01); }"
riprapFoam >log 2>&1 && pass tableOfTheRun || fail tableOfTheRun "$(grep -m1 -A3 ERROR log)"
column tableGroup motion lidCentreY 0.03899 0.03901
cp -r 0.1 whole; rm -r 0.1; riprapFoam >log 2>&1
cmp -s 0.1/uniform/riprap/demState whole/uniform/riprap/demState && pass tableRestart \
    || fail tableRestart "a continued run is another one"
rm -rf 0.05 0.1 whole postProcessing

# Those that leave are not missed: the rest continues to the bit
tank2
solids 'bonds { cement { normalStiffness 1e9; shearStiffness 1e9; } } guards { maxEscaped 1; }'
control ''
fill "leaving { set solids; material glass; radius 0.006; source box; \
box (0.05 0.08 0) (0.062 0.092 0.01); velocity (0 3 0); }
pair { $glass source box; box (0.1 0.08 0) (0.12 0.09 0.01); \
velocity (0 2 0); } pile { $glass source box; box (0 0 0) (0.06 0.03 0.01); velocity (0.3 0 0); }" \
    'bonds ( pair { type cement; groups (free); gapTolerance 1e-6; } );'
riprapFoam >log 2>&1 && pass escapeRun || fail escapeRun "$(grep -m1 -A3 ERROR log)"
says escaped 'scaped'
cp -r 0.1 whole; rm -r 0.1; riprapFoam >log 2>&1
says escapeContinues 'Continuing exactly from time 0.05'
cmp -s 0.1/uniform/riprap/demState whole/uniform/riprap/demState && pass escapeRestart \
    || fail escapeRestart "a continued run is another one"
rm -rf 0.05 0.1 whole

plain="functions { motion { type groupMotion; $library } energy { type solidEnergies; \
$library } forces { type solidWallForce; $library } }"

# Ctrl-C ends with a written time, from which a run goes on exactly
tank2; solids ''; control 'endTime 1000; writeInterval 1000;'
fill "pile { $glass source box; box (0.04 0 0) (0.09 0.05 0.01); packing layers; \
velocity (0.1 0 0); }"
rm -f log; riprapFoam >log 2>&1 & pid=$!
for ((i = 0; i < 300; ++i)); do grep -q '^Time = ' log && break; sleep 0.1; done
kill -INT $pid; wait $pid && pass interruptStatus || fail interruptStatus "exit status $?"
says interrupt 'Stopping on SIGINT: writing this time'
reached=$(foamListTimes -latestTime 2>/dev/null | tail -1)
[[ -s ${reached:-none}/lagrangian/solids/positions && -s $reached/uniform/riprap/demState ]] \
    && pass interruptWrites || fail interruptWrites "nothing in time '$reached'"
control "endTime $(awk -v t="${reached:-0}" 'BEGIN {printf "%.10g", t + 0.02}');"
riprapFoam >log 2>&1
says interruptContinues "Continuing exactly from time $reached"

# -postProcess gives what the run gave at the times that it wrote
tank2; rm -rf [1-9]* 0.* postProcessing first
control "$plain"
fill "pile { $glass source box; box (0.04 0 0) (0.09 0.05 0.01); packing layers; \
velocity (0.1 0 0); }"
riprapFoam >log 2>&1; mv postProcessing first
riprapFoam -postProcess >log 2>&1 && pass postProcess \
    || fail postProcess "$(grep -m1 -A3 ERROR log)"
for file in energy/*/solidEnergies.dat motion/*/groupMotion.dat
do
    # within 1e-6 of the largest: times are written with twelve digits, and a velocity is that of
    # the half step
    awk '/^#/ {next} FNR == NR {for (i = 2; i <= NF; ++i) {run[$1 + 0, i] = $i;
            if ($i^2 > big[i]^2) big[i] = $i} next}
        ($1 + 0, 2) in run {++rows;
            for (i = 2; i <= NF; ++i) if (($i - run[$1 + 0, i])^2 > (1e-6*big[i])^2)
                print $1, i, $i, run[$1 + 0, i]}
        END {if (rows < 3) print rows + 0, "common rows"; print "compared"}' first/$file \
        postProcessing/$file >differences
    [[ $(cat differences) != compared ]] && fail "postProcess.${file##*/}" \
        "$(head -3 differences | tr '\n' ';')" || pass "postProcess.${file##*/}"
done
rm -rf first postProcessing

# Walls in constant/geometry: a disk falls on a shelf and rests there, another one beside it falls
# past it to the floor
tank2; rm -rf 0.*
geometry 'shelf { type searchablePlate; origin (0.02 0.05 -1); span (0.06 0 2); }'
printf 'x,y,z,radius,group\n0.05,0.0551,0,0.005,upper\n0.15,0.0551,0,0.005,lower\n' >list.csv
solids 'groups { upper { viscousDamping 60; } lower { viscousDamping 60; } }'
control "endTime 0.6; $plain"
fill 'list { set solids; source csv; file "list.csv"; material glass; }'
riprapFoam >log 2>&1 && pass geometry || fail geometry "$(grep -m1 -A3 ERROR log)"
column geometryRests motion upperCentreY 0.05483 0.05484      # 0.164 mm deep, as on the floor
column geometryFalls motion lowerCentreY 0.00483 0.00487
column geometryCarries forces shelfFy -1.93 -1.92         # its weight, 2500 pi R^2 g = 1.926 N/m
rm constant/geometry

# A hopper of soft grains, which go farther in a step than the skin holds and are pressed through
# plates and floor by more than their radius: nothing stops it, none is lost, the softness is told,
# and it continues to the bit
block 0.4 0.6 0.01 '1 1 1' "$sides $lower $open $flat"; rm -rf 0.* postProcessing
plate()     # FROM TO: x and y of two lines along z
{
    printf 'facet normal 0 0 0\nouter loop\nvertex %s -1\nvertex %s -1\nvertex %s '\
'1\nendloop\nendfacet\n' "$1" "$2" "$2"
    printf 'facet normal 0 0 0\nouter loop\nvertex %s -1\nvertex %s 1\nvertex %s '\
'1\nendloop\nendfacet\n' "$1" "$2" "$1"
}
{ echo 'solid h'; plate '0 0.3' '0.17 0.15'; plate '0.4 0.3' '0.23 0.15'; echo 'endsolid h'; } \
    >constant/triSurface/hopper.stl
geometry 'hopper { type triSurfaceMesh; file "hopper.stl"; }'
dictionary constant/solidProperties <<<'device cpu; materials { grain { rho 2500; E 3e6; '\
'nu 0.25; } } pairs { default { restitution 0.5; friction 0.5; } } walls { material grain; }'
control 'endTime 0.4; writeInterval 0.2;'
fill 'grains { set solids; source box; box (0.01 0.305 0) (0.39 0.42 0.01); packing random; '\
'radius 0.005; largestRadius 0.007; solidFraction 0.3; material grain; }'
riprapFoam >log 2>&1 && pass softHopper || fail softHopper "$(grep -m1 -A3 ERROR log)"
says softHopperTells 'Warning: at time [0-9.]+ s bodies overlap by [0-9.]+ % of a diameter, '\
'above 5 %.* E about [0-9.e+]+ times as large'
[[ $(grep -c 'bodies overlap' log) == 1 ]] && pass softHopperTellsOnce \
    || fail softHopperTellsOnce 'not said once'
quiet softHopperKeepsAll '^(Escaped|Passed)'
mv 0.4 whole; riprapFoam >log 2>&1
says softHopperContinues 'Continuing exactly from time 0.2'
cmp -s 0.4/uniform/riprap/demState whole/uniform/riprap/demState && pass softHopperRestart \
    || fail softHopperRestart "a continued run is another one"
rm -rf 0.* whole constant/geometry

# A body that no wall can hold is named: through a plate within the mesh, and out of the mesh
tank2; geometry 'shelf { type searchablePlate; origin (0.02 0.05 -1); span (0.06 0 2); }'
printf 'x,y,z,u,v,w,radius\n0.05,0.08,0,0,-5,0,0.005\n0.15,0.08,0,0,-5,0,0.005\n' >list.csv
dictionary constant/solidProperties <<<'device cpu; '\
'contact { normal linear; } guards { maxEscaped 1; } materials { glass { rho 2500; } }
pairs { default { restitution 0.9; friction 0.3; stiffness 1e4; } } walls { material glass; }'
control 'endTime 0.03; sampleInterval 1e-3; writeInterval 0.03;'
fill 'list { set solids; source csv; file "list.csv"; material glass; }'
riprapFoam >log 2>&1 && pass passing || fail passing "$(grep -m1 -A3 ERROR log)"
says passesShelf 'Passed walls: 1 particles \(1 since the start of this run\), one of them 0'
says passesFloor 'Passed a wall: particle 1 at .* \(nearest patch: lower\)'
rm -rf 0.* constant/geometry

# A periodic channel without friction: a disk leaves at x = 0.2, comes in at 0, and hits one that
# waits there; they exchange velocities
channel2; rm -rf 0.* postProcessing
printf 'x,y,z,u,v,w,radius,group\n0.18,0.05,0,0.5,0,0,0.005,thrown\n'\
'0.03,0.05,0,0,0,0,0.005,waiting\n' >list.csv
solids 'contact { normal linear; '\
'tangential none; } groups { thrown { gravity no; } waiting { gravity no; } }'
sed -i 's/restitution 0.9/restitution 1/' constant/solidProperties
control "endTime 0.2; deltaT 2e-5; adjustTimeStep no; $plain"
fill 'list { set solids; source csv; file "list.csv"; material glass; }'
riprapFoam >log 2>&1 && pass cyclic || fail cyclic "$(grep -m1 -A3 ERROR log)"
column cyclicStops motion thrownUx -0.001 0.001
column cyclicGoesOn motion waitingUx 0.499 0.501
# 0.02 + v/2 pi sqrt(m/(2 k)): they move on while they touch
column cyclicWraps motion thrownCentreX 0.02245 0.02247
rm -rf 0.* postProcessing

# Adhesion: two disks that meet at 0.02 m/s, below the speed at which they would part (0.033 m/s by
# 7.09 (w^5 R*^4/E*^2)^(1/3)), go on as one; with a thousandth of it they rebound
tank2; rm -rf 0.* postProcessing
printf 'x,y,z,u,v,w,radius,group\n0.08,0.05,0,0.02,0,0,0.005,thrown\n'\
'0.0905,0.05,0,0,0,0,0.005,waiting\n' >list.csv
for w in 50 0.05
do
    solids "contact { normal jkr; \
tangential none; } groups { thrown { gravity no; } waiting { gravity no; } }
pairs { default { restitution 0.5; workOfAdhesion $w; stiffness 1e4; } }"
    control "endTime 0.3; $plain"
    fill 'list { set solids; source csv; file "list.csv"; material glass; }'
    riprapFoam -dry-run >log 2>&1
    says "jkrDryRun$w" "glass-glass: E\\* 5.33333e\\+06 Pa, workOfAdhesion $w J/m2, \
restitution 0.5 .*not used *\\(friction stiffness\\) of pairs"
    riprapFoam >log 2>&1 && pass "jkr$w" || fail "jkr$w" "$(grep -m1 -A3 ERROR log)"
    if [[ $w == 50 ]]
    then
        column jkrSticks motion thrownUx 0.0099 0.0101
        column jkrBoth motion waitingUx 0.0099 0.0101
    else
        column jkrRebounds motion thrownUx 0.0045 0.0055
        column jkrBoth motion waitingUx 0.0145 0.0155
    fi
    rm -rf 0.* postProcessing
done
tank2; solids ''; control ''

# Wrong regions
control ''; solids 'bonds { cement { normalStiffness 1e9; shearStiffness 1e9; } }'
bad() { set2 "$3" "${4:-}"; refused "$1" "$2" setParticles; }
box='source box; box (0 0 0) (0.06 0.06 0.01);'
bad noMaterial "material' not found" "a { set solids; radius 0.005; $box }"
bad unknownMaterial 'Unknown material wood; constant/solidProperties has \(glass steel\)' \
    "a { set solids; material wood; radius 0.005; $box }"
bad unknownGroup 'Unknown group beam; constant/solidProperties has \(free\)' \
    "a { $glass group beam; $box }"
bad nearGroup 'Unknown group fre; constant/solidProperties has .free.; did you mean free\?' \
    "a { $glass group fre; $box }"
bad noRadius 'Region a: How large are the particles\? Write .particleRadius' \
    "a { set solids; material glass; $box }"
bad diskOfOne 'Region a: radius 0\.03 is that of the cylinder, not of its particles. '\
'How large are the particles\? Write .particleRadius .* or .spacing' "a { $round }"
bad diskRandom 'Region a: radius 0\.03 is that of the cylinder.* Write .particleRadius' \
    "a { $round spacing 0.01; packing random; solidFraction 0.5; }"
bad ballOfOne 'radius 0\.03 is that of the sphere' \
    "a { set solids; material glass; source sphere; centre (0.1 0.05 0.005); radius 0.03; }"
bad twoRadii 'Entries radius and particleRadius are both there' \
    "a { $glass $box particleRadius 0.005; }"
bad particleRadius 'Entry particleRadius is -1: it must be positive' \
    "a { $round particleRadius -1; }"
bad radius 'Entry radius is 0: it must be positive' \
    "a { set solids; material glass; radius 0; $box }"
bad packing 'packing has the unknown word loose; valid are .*square hexagonal layers random' \
    "a { $glass $box packing loose; }"
bad source 'source has the unknown word cone; valid are .*clumpsFromSurface' \
    "a { $glass source cone; }"
bad set 'set has the unknown word solid; valid are \(fluid solids\)' \
    "a { $glass $box } b { set solid; }"
bad mass 'mass has the unknown word heavy; valid are \(cell particle\)' \
    "a { $glass $box mass heavy; }"
bad entry 'Unknown entry colour' "a { $glass $box colour red; }"
bad overlap 'Particles overlap at the start: one of region a at \(.* and one of region b' \
    "a { $glass $box } b { $glass source box; box (0.055 0 0) (0.1 0.06 0.01); }"
bad squeezed 'Particles overlap at the start' "a { $glass $box spacing 0.009; }"
bad outside 'particles are outside the mesh' \
    "a { $glass source box; box (0.15 0 0) (0.25 0.05 0.01); }"
bad inWall "in the mesh's walls by more than overlapTolerance" \
    "a { $glass source box; box (-0.002 0 0) (0.05 0.05 0.01); }"
bad small 'Region a holds no particle' "a { $glass source box; box (0 0 0) (0.005 0.05 0.01); }"
bad full 'cannot be brought apart at solidFraction 0.95' \
    "a { $glass source box; box (0 0 0) (0.03 0.03 0.01); packing random; solidFraction 0.95; }"
bad twice 'two are named a' \
    "a { $glass $box } a { $glass source box; box (0.1 0 0) (0.16 0.06 0.01); }"
bad bondType 'Unknown bond type glue; constant/solidProperties has \(cement\)' "a { $glass $box }" \
    'bonds ( a { type glue; groups (free); gapTolerance 0; } );'
bad bondGroup 'Unknown group beam' "a { $glass $box }" \
    'bonds ( a { type cement; groups (beam); gapTolerance 0; } );'
bad noBonds 'bonds nothing: no two particles of these groups are nearer than gapTolerance 0.0001' \
    "a { $glass $box spacing 0.012; }" \
    'bonds ( a { type cement; groups (free); gapTolerance 1e-4; } );'
bad bondTolerance 'Entry gapTolerance is -1' "a { $glass $box }" \
    'bonds ( a { type cement; groups (free); gapTolerance -1; } );'
bad materialDict 'Entry material must be a value' \
    "a { set solids; material { } radius 0.005; $box }"
bad spacingUnused 'Unknown entry spacing; valid are .*overlapTolerance regions bonds' \
    "a { $glass $box }" 'spacing 0.01;'
bad tolerance 'Entry overlapTolerance is -1: it must be zero or positive' "a { $glass $box }" \
    'overlapTolerance -1;'
bad tiny 'would hold about .*is the particles. radius or spacing meant' \
    "a { set solids; material glass; radius 1e-9; $box }"
bad tinyRandom 'would hold about .*is the particles. radius meant' \
    "a { set solids; material glass; radius 1e-9; $box packing random; solidFraction 0.5; }"
bad fraction 'Entry solidFraction is 2: it must be from 0 to 1' \
    "a { $glass $box packing random; solidFraction 2; }"
bad seed 'Entry seed is 1.5: it must be a whole number' \
    "a { $glass $box packing random; solidFraction 0.5; seed 1.5; }"
bad largest 'Entry largestRadius is 0.001, less than the particles. radius 0.005' \
    "a { $glass $box packing random; solidFraction 0.5; largestRadius 0.001; }"
sized="a { set solids; material glass; $box packing random; solidFraction 0.5;"
bad shares 'Entry shares is missing: sizes need radii' "$sized radii (0.002 0.004); }"
bad sharesFew 'Entry radii has 2 values and entry shares 1: each radius needs its share' \
    "$sized radii (0.002 0.004); shares (1); }"
bad sharesSum 'Entry shares adds up to 100: shares are fractions of the mass that add up to 1' \
    "$sized radii (0.002 0.004); shares (30 70); }"
bad sharesNegative 'Entry shares is -0.3: it must be positive' \
    "$sized radii (0.002 0.004); shares (-0.3 1.3); }"
bad sharesOf 'sharesOf has the unknown word volume; valid are \(number mass\)' \
    "$sized radii (0.002 0.004); shares (0.3 0.7); sharesOf volume; }"
bad sharesNone 'less than half a body of' "$sized radii (0.001 0.009); shares (0.99 0.01); }"
bad sharesBoth 'Entries radii and largestRadius are both there' \
    "$sized radii (0.002 0.004); shares (0.3 0.7); largestRadius 0.004; }"
bad sharesCell 'Entry sharesOf is mass, but with .mass cell;. all particles have one mass: '\
'valid is number' "$sized radii (0.002 0.004); shares (0.3 0.7); mass cell; }"
bad sharesLattice 'Entry radii needs .packing random;.' \
    "a { set solids; material glass; $box radii (0.002 0.004); shares (0.3 0.7); }"
bad velocity 'regions.a.velocity' "a { $glass $box velocity fast; }"
bad spin 'regions.a.spin' "a { $glass $box spin fast; }"
bad clipWord 'clip has the unknown word maybe' "a { $glass $box clip maybe; }"
bad rigidClumps 'Entry rigid is yes, but the bodies of source clumpsFromSurface are rigid ones '\
'already' 'a { set solids; material glass; source clumpsFromSurface; file "octa.stl"; rigid yes; }'
bad rigidWord 'rigid.*maybe.*yes.*no' \
    "a { $glass source box; box (0 0 0) (0.02 0.02 0.02); radius 0.005; rigid maybe; }"
bad clumps2D 'clumpsFromSurface needs a case in 3D' \
    'a { set solids; material glass; source clumpsFromSurface; file "octa.stl"; }'
bad outline3 'Entry outline needs at least three points' \
    'a { set solids; material glass; source clumpsFromOutline; outline ((0 0 0) (1 0 0)); }'
bad outlineCrosses 'Entry outline crosses itself' 'a { set solids; material glass; '\
'source clumpsFromOutline; outline ((0 0 0) (1 1 0) (1 0 0) (0 1 0)); }'
bad orientation 'orientation has the unknown word upside; valid are .*random' \
    "a { set solids; material glass; $square orientation upside; }"
bad angle "'angle' not found" "a { set solids; material glass; $square orientation turned; }"
bad noType "'type' not found.*bonds.a" "a { $glass $box }" \
    'bonds ( a { groups (free); gapTolerance 0; } );'
bad noGroups "'groups' not found.*bonds.a" "a { $glass $box }" \
    'bonds ( a { type cement; gapTolerance 0; } );'
bad noTolerance "'gapTolerance' not found.*bonds.a" "a { $glass $box }" \
    'bonds ( a { type cement; groups (free); } );'
bad bondEntry 'Unknown entry colour; valid are \(type groups gapTolerance\)' "a { $glass $box }" \
    'bonds ( a { type cement; groups (free); gapTolerance 0; colour 1; } );'
bad bondsDict 'Entry bonds must be a value' "a { $glass $box }" 'bonds { }'
csv()
{
    printf "$2" >bad.csv
    bad "$1" "$3" 'a { set solids; material glass; source csv; file "bad.csv"; }'
}
csv csvHeader 'x,y,colour\n' "unknown column 'colour'"
csv csvShort 'x,y,radius\n' 'the columns \(x y z\) must be there'
csv csvRadius 'x,y,z,radius\n0.1,0.05,0,-1\n' 'radius is -1: it must be positive'
csv csvMaterial 'x,y,z,radius,material\n0.1,0.05,0,0.01,wood\n' 'Unknown material wood'

# Wrong properties: said by setParticles already, which reads them all
set2 "a { $glass $box }"
properties_()   # NAME MESSAGE PROPERTIES
{
    dictionary constant/solidProperties <<<"$3"
    refused "$1" "$2" setParticles
}
m='materials { glass { rho 2500; E 1e7; nu 0.25; } }' w='walls { material glass; }'
p='pairs { glass-glass { restitution 0.9; friction 0.3; stiffness 1e4; } }'
properties_ noMaterials 'Entry materials is missing or empty' "$p $w"
properties_ density 'Entry rho is -1: it must be positive' \
    "materials { glass { rho -1; E 1e7; nu 0.25; } } $p $w"
properties_ zeroE 'Entry E is 0: it must be positive' \
    "materials { glass { rho 1; E 0; nu 0.25; } } $p $w"
properties_ nu 'Entry nu is 0.7: it must be from' \
    "materials { glass { rho 1; E 1; nu 0.7; } } $p $w"
properties_ zeroStiffness 'Entry stiffness is 0: it must be positive.*solidProperties' \
    "$m $w contact { normal linear; } pairs { default { restitution 1; friction 0; stiffness 0; } }"
properties_ noStiffness "stiffness.*solidProperties" \
    "$m $w contact { normal linear; } pairs { default { restitution 1; friction 0; } }"
properties_ pairName 'Entry glass names no pair' "$m $w pairs { glass { } }"
properties_ pairMaterial 'Unknown material wood; constant/solidProperties has \(glass\)' \
    "$m $w pairs { glass-wood { } }"
properties_ pairTwice 'this pair is there twice' \
    "materials { glass { rho 1; E 1; nu 0; } steel { rho 1; E 1; nu 0; } } $w
pairs { glass-steel { restitution 1; friction 0; } steel-glass { restitution 1; friction 0; } }"
properties_ friction 'Entry friction is -1' \
    "$m $w pairs { default { restitution 1; friction -1; } }"
properties_ restitution 'Entry restitution is 2: it must be from' \
    "$m $w pairs { default { restitution 2; friction 0; } }"
properties_ normal 'normal has the unknown word soft; '\
'valid are .*linear incremental cellSpring hertz jkr' "$m $p $w contact { normal soft; }"
properties_ tangential 'tangential has the unknown word all; valid are .*none history oneStep' \
    "$m $p $w contact { tangential all; }"
properties_ rolling 'rolling has the unknown word all; valid are .*none constantTorque spring' \
    "$m $p $w contact { rolling all; }"
properties_ rollingSlides 'rolling friction needs friction' "$m $w contact { tangential none; \
rolling spring; } pairs { default { restitution 1; rollingFriction 0.1; } }"
properties_ rollingFriction "rollingFriction.*solidProperties" \
    "$m $p $w contact { rolling spring; }"
properties_ sleepSpeed 'Entry speed is -1' "$m $p $w sleep { speed -1; }"
properties_ sleepAfter 'Entry after is the time' "$m $p $w sleep { after 0.1; }"
properties_ sleepEntry 'Unknown entry long' "$m $p $w sleep { speed 1e-3; long 1; }"
properties_ fixed 'fixed has the unknown word w; valid are .*x y z spin' \
    "$m $p $w groups { a { fixed (w); } }"
properties_ damping 'Entry localDamping is 2: it must be from 0 to 1' \
    "$m $p $w groups { a { localDamping 2; } }"
properties_ bondE 'Entry E is -1' "$m $p $w bonds { a { calibration moduli; E -1; G 1; } }"
properties_ calibration 'calibration has the unknown word best; '\
'valid are .*direct moduli planeStrain' "$m $p $w bonds { a { calibration best; } }"
properties_ strength 'tensileStrength has the unknown word much; valid are .*none <number>' \
    "$m $p $w bonds { a { normalStiffness 1; shearStiffness 1; tensileStrength much; } }"
properties_ entry 'Unknown entry contacts; valid are .*contact.*solidProperties' \
    "$m $p $w contacts { }"

good_materials=$m good_pairs='pairs { default { restitution 0.9; friction 0.3; stiffness 1e4; } }' \
    good_walls=$w
while IFS=$'\t' read -r name message entries
do
    [[ $name == \#* ]] && continue
    text=$entries
    for part in materials pairs walls
    do
        good=good_$part
        [[ $entries =~ (^|\}\ )$part\  ]] || text+=" ${!good}"
    done
    properties_ "solid.$name" "$message.*solidProperties" "$text"
done <"$root/tests/regression/wrongSolidEntries.tsv"

# Wrong only when a scene is made
solids ''; fill "a { $glass $box }"
properties2()   # NAME MESSAGE PROPERTIES [CONTROL]
{
    dictionary constant/solidProperties <<<"$3"
    control "${4:-}"
    refused "$1" "$2" riprapFoam
}
two='materials { glass { rho 2500; E 1e7; nu 0.25; } steel { rho 7800; E 1e8; nu 0.3; } }'
properties2 missingPair 'Entry pairs: missing are \(glass-steel\), which can meet' \
    "$two pairs { glass-glass { restitution 1; friction 0; } } walls { material steel; }"
properties2 wallMaterial 'wall tank has no material|wall [a-z]+ has no material' \
    "$two pairs { default { restitution 1; friction 0; } }"
properties2 gapWide 'gap of glass-glass is 1000 m, more than 100 times the largest particle' \
    "${two} pairs { default { restitution 1; friction 0; gap 1000; } } walls { material steel; }"
properties2 wallWood 'Unknown material wood' \
    "$two pairs { default { restitution 1; friction 0; } } walls { material wood; }"
properties2 wallName 'nowhere selects no wall; valid are' "$two pairs { default { restitution 1; \
friction 0; } } walls { material steel; materials { nowhere glass; } }"
good="$two pairs { default { restitution 1; friction 0; } }"
properties2 planeNoNormal "'normal' not found.*planes.a" \
    "$good walls { material steel; planes { a { point (0 0 0); } } }"
properties2 planeEntry 'Unknown entry colour; valid are .point normal' \
    "$good walls { material steel; planes { a { point (0 0 0); normal (0 1 0); colour 1; } } }"
properties2 planeAcross 'Entry normal of plane a is \(0 0 1\): it needs a length in the plane of '\
'this 2D case' "$good walls { material steel; planes { a { point (0 0 0); normal (0 0 1); } } }"
linear='solidBodyMotionFunction linearMotion; linearMotionCoeffs { velocity'
properties2 groupMotionPlane 'Motion free leaves the plane of this 2D case: z.*solidProperties' \
    "$good walls { material steel; } groups { free { motion { $linear (1 0 1); } } } }"
properties2 groupTurnsOut 'Motion free leaves the plane' "$good walls { material steel; }
groups { free { motion { solidBodyMotionFunction rotatingMotion; \
rotatingMotionCoeffs { origin (0 0 0); axis (1 0 0); omega 5; } } } }"
properties2 wallMotionName 'Entry patches \(nowhere\) selects no wall; valid are' \
    "$good walls { material steel; motion { m { patches (nowhere); $linear (1 0 0); } } } }"
properties2 wallPatch 'no patch nowhere that can be a wall; valid ones are' \
    "$good walls { material steel; patches (nowhere); }"
properties2 planeNormal 'needs a length' "$two pairs { default { restitution 1; \
friction 0; } } walls { material steel; planes { a { point (0 0 0); normal (0 0 0); } } }"
properties2 planeBehind 'Entry planes of walls: '\
'of a, particle 0 is .* m behind the entry point.*normal must point to the particles' \
    "$good walls { material steel; planes { a { point (0 100 0); normal (0 1 0); } } }"
properties2 largeStep '0\.5 sqrt\(m/k\)|allowLargeStep' "$two pairs { default { restitution 1; \
friction 0; } } walls { material steel; }" 'adjustTimeStep no; deltaT 0.01;'
solids ''
object()
{
    control "functions { f { $2 libs (\"libriprapFoam.so\"); } }"
    refused "object.$1" "$3.*functions.f" riprapFoam
}
object group 'type groupMotion; groups (nobody);' \
    'Unknown group nobody; constant/solidProperties has \(free\)'
object noGroups 'type groupMotion; groups ();' 'Entry groups of .* is empty'
object noIds 'type particleDisplacement; origIds ();' 'Entry origIds of .* is empty'
object noPoints 'type particleDisplacement; points ();' 'Entry points of .* is empty'
object ids 'type particleDisplacement; origIds (99999);' \
    'Entry origIds .*there is no particle 99999'
object idsWord 'type particleDisplacement; origIds some;' "word 'some'"
object idsSurplus 'type particleDisplacement; origIds all 17;' "'origIds' has 1 excess tokens"
object both 'type particleDisplacement; origIds (1); points ((0 0 0));' \
    'needs one of the entries origIds and points'
object none 'type particleDisplacement;' 'needs one of the entries origIds and points'
object entry 'type solidEnergies; groups (free);' 'Unknown entry groups; valid are .*writeInterval'
object water 'type waterLevel; points ((0 0 0));' 'needs a running particle scene'

# A state that is damaged, and particles
rm -rf [0-9]*.*
control 'endTime 1e-3; sampleInterval 1e-3; writeInterval 1e-3;'
riprapFoam >log 2>&1 || fail damagedRun "$(grep -m1 -A3 ERROR log)"
control 'endTime 2e-3; sampleInterval 1e-3; writeInterval 1e-3;'; mv 0.001 written
damaged()   # NAME MESSAGE COMMAND...
{
    local name=$1 message=$2; shift 2
    rm -rf 0.001 0.002; cp -r written 0.001
    (cd 0.001 && "$@") || fail "bad.$name" "the test's own edit"
    refused "$name" "$message" riprapFoam
}
whole='is damaged .*: remove the folder .*0.001/uniform/riprap. to continue from the fields'
# Named: latestTime would pass it over
control 'startFrom startTime; startTime 0.001; endTime 0.002; writeInterval 0.001;'
damaged stateCut "$whole" truncate -s 1000 uniform/riprap/demState
damaged stateMissing "$whole" rm uniform/riprap/demState
damaged runEntry "$whole" sed -i /timeStep/d uniform/riprap/demRun
damaged noRadius 'is damaged .lagrangian/solids/radius is missing' rm lagrangian/solids/radius
damaged radius 'lagrangian/solids/radius has the value -0.005 at entry 0: it must be positive' sed \
    -i 's/{0.005}/{-0.005}/' lagrangian/solids/radius
damaged material 'lagrangian/solids/material has the value 7 at entry 0: '\
'it counts from 0 in \(glass steel\)' sed -i 's/{0}/{7}/' lagrangian/solids/material
damaged cutU 'is damaged .lagrangian/solids/U is cut short' truncate -s 1100 lagrangian/solids/U
rm -rf 0.001 0.002 written
control ''
rm -r 0/lagrangian; refused noParticles 'There are no particles at time 0' riprapFoam
