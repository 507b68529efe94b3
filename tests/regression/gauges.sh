#!/bin/bash
# Gauges that ride on moving walls and on bodies, and their means over time: hydrostatic pressure
# where they have come to, restart, wrong entries.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL gauges no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL gauges no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=gauges
. "$root/tests/regression/setParticlesCases"
library='libs ("libriprapFoam.so");'

properties
dictionary system/blockMeshDict <<'END'
scale 1;
vertices
((0 0 0) (0.2 0 0) (0.2 0.3 0) (0 0.3 0) (0 0 0.01) (0.2 0 0.01) (0.2 0.3 0.01) (0 0.3 0.01));
blocks (hex (0 1 2 3 4 5 6 7) (20 30 1) simpleGrading (1 1 1));
boundary
(
    left { type wall; faces ((0 4 7 3)); }
    gate { type wall; faces ((1 2 6 5)); }
    floor { type wall; faces ((0 1 5 4)); }
    top { type patch; faces ((3 7 6 2)); }
    frontAndBack { type empty; faces ((0 3 2 1) (4 5 6 7)); }
);
END
blockMesh >log 2>&1 || fail mesh "blockMesh failed"

control()   # FUNCTIONS END [startFrom]
{
    dictionary system/controlDict <<<"application riprapFoam; solver sphDem; \
startFrom ${3:-startTime}; startTime 0; stopAt endTime; endTime $2;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.002; writeControl adjustableRunTime; \
writeInterval 0.2; writeFormat ascii; writePrecision 16; functions { $1 }"
}
water()     # MOTION of walls
{
    dictionary constant/sphProperties \
        <<<"device cpu; maxVelocity 2; viscosity laminarAndArtificial; walls { motion { $1 } }"
}
run()
{
    rm -rf 0.* postProcessing
    riprapFoam >log 2>&1 && pass "run.$1" || fail "run.$1" "$(grep -m1 -A4 ERROR log | tr '\n' ' ')"
}
last()      # FILE COLUMN: of the last row
{
    tail -1 "postProcessing/$1" | awk -v c="$2" '{ print $c }'
}
near()      # NAME FOUND EXPECTED BOUND
{
    awk -v a="$2" -v b="$3" -v bound="$4" 'BEGIN { exit !(a != "" && (a - b)^2 <= bound^2) }' \
        && pass "$1" || fail "$1" "${2:-nothing}, expected $3 within $4"
}

# A gate that narrows the tank from 0.2 to 0.184 m: the level is 0.04/0.184 then. 3 % of the
# pressure at the floor
regions 'column { set fluid; source box; box (0 0 0) (0.2 0.2 0.01); pressure hydrostatic; }'
sed -i 's/spacing 0.005/spacing 0.01/' system/setParticlesDict
water 'gate { patches (gate); solidBodyMotionFunction linearMotion; velocity (-0.04 0 0); }'
gauges="riding { type particleProbes; $library fields (p); body gate; average 0.1; \
probeLocations ((0.2 0.05 0) (0.2 0.1 0)); }
disc { type particleProbes; $library fields (p); body gate; average 0.1; sensorRadius 0.02; \
probeLocations ((0.2 0.05 0)); }
left { type particleProbes; $library fields (p); average 0.1; probeLocations ((0 0.05 0)); }
passed { type particleProbes; $library fields (p volumeFraction); probeLocations ((0.2 0.05 0)); }"
control "$gauges" 0.4
setParticles >log 2>&1 || fail column "$(tail -3 log)"
run gate
level=$(awk 'BEGIN { print 0.04/0.184 }')
near gateLow "$(last riding/0/pMean.dat 2)" "$(awk -v l=$level 'BEGIN { print 9810*(l - 0.05) }')" \
    60
near gateHigh "$(last riding/0/pMean.dat 3)" "$(awk -v l=$level 'BEGIN { print 9810*(l - 0.1) }')" \
    60
near gateDisc "$(last disc/0/pMean.dat 2)" "$(awk -v l=$level 'BEGIN { print 9810*(l - 0.05) }')" 60
near gateLeft "$(last left/0/pMean.dat 2)" "$(awk -v l=$level 'BEGIN { print 9810*(l - 0.05) }')" 60
near gateBehind "$(last passed/0/p.dat 2)" 0 1e-9       # 1.6 spacings behind the gate's face

# The mean beside the raw value, by hand from the raw rows: trapezoids over the last 0.1 s
mean=$(awk '!/^#/ { t[++n] = $1; p[n] = $2 } END {
        for (i = n; t[i] > t[n] - 0.1 + 1e-9; --i) s += 0.5*(p[i] + p[i - 1])*(t[i] - t[i - 1]);
        print s/(t[n] - t[i]) }' postProcessing/left/0/p.dat)
near meanByHand "$(last left/0/pMean.dat 2)" "$mean" 0.01
[[ $(grep -vc '^#' postProcessing/left/0/pMean.dat) == 201 ]] && pass meanRows \
    || fail meanRows "not a row each sample"

# A continued run: the mean goes on over the restart. Raw values swing by hundreds of Pa; ascii
# positions are not those of before to the bit
rm -rf first; mv postProcessing first; rm -r 0.4
control "$gauges" 0.25 latestTime
riprapFoam >log 2>&1
at() { awk -v t="$2" '!/^#/ && ($1 - t)^2 < 1e-12 { print $2 }' "$1"; }
for object in riding left disc
do
    for time in 0.2 0.202 0.25
    do
        near "restart.$object.$time" "$(at postProcessing/$object/0.2/pMean.dat $time)" \
            "$(at first/$object/0/pMean.dat $time)" 1
    done
done

# All of the tank and its water at 0.5 m/s: as at rest, and a gauge that stays behind is soon dry
tank()      # NAME VELOCITY
{
    sed -i "s/pressure hydrostatic.*}/pressure hydrostatic; velocity ($2 0 0); }/" \
        system/setParticlesDict
    water "tank { patches (left gate floor); solidBodyMotionFunction linearMotion; \
velocity ($2 0 0); }"
    control "riding { type particleProbes; $library fields (p U); body tank; average 0.1; \
probeLocations ((0.2 0.05 0) (0 0.05 0) (0.1 0 0)); }
staying { type particleProbes; $library fields (volumeFraction); probeLocations ((0 0.05 0)); }" 0.2
    rm -rf 0; setParticles >log 2>&1
    run "$1"
}
tank tankAtRest 0
still=$(tail -1 postProcessing/riding/0/pMean.dat)
# 5 %: what comes to rest is pressed by half a spacing of surface
near restRight "$(awk '{ print $2 }' <<<"$still")" 1471 75
tank tankMoving 0.5
for column in 2 3 4
do
    near "tankPressure$column" "$(last riding/0/pMean.dat $column)" \
        "$(awk -v c=$column '{ print $c }' <<<"$still")" 10
done
near tankVelocity "$(last riding/0/UMean.dat 2)" 0.5 0.005
near tankGone "$(last staying/0/volumeFraction.dat 2)" 0 1e-9

# Films of two spacings, thinner than what counts in the air: on a box of constant/geometry, on the
# floor above a gauge's foot; and one that flies
geometry 'step { type searchableBox; min (0.1 0 -1); max (0.2 0.1 1); }'
regions 'onStep { set fluid; source box; box (0.1 0.1 0) (0.2 0.12 0.01); } onFloor { set fluid; '\
'source box; box (0 0 0) (0.1 0.02 0.01); } sheet { set fluid; source box; '\
'box (0 0.2 0) (0.2 0.22 0.01); }'
sed -i 's/spacing 0.005/spacing 0.01/' system/setParticlesDict
water ''
control "films { type waterLevel; $library points ((0.15 0 0) (0.05 0 0) (0.05 -0.1 0)); } \
all { type waterLevel; $library points ((0.15 0 0)); minThickness 0; }" 0.002
rm -rf 0; setParticles >log 2>&1 || fail films "$(tail -3 log)"
run films
level() { awk -v c="$2" '!/^#/ { print $c; exit }' "postProcessing/$1/0/waterLevel.dat"; }
near filmOnStep "$(level films 2)" 0.12 0.005
near filmOnFloor "$(level films 3)" 0.02 0.005
near filmAboveFoot "$(level films 4)" 0.12 0.005
near sheetInTheAir "$(level all 2)" 0.22 0.005
rm constant/geometry

# With picDem, on a piston that comes from 0.05 to 0.066 m: the level is 0.0225/0.134, 5 % of the
# pressure at the floor for the wave that it makes
geometry 'piston { type searchableBox; min (-1 -1 -1); max (0.05 2 1); }'
regions 'column { set fluid; source box; box (0.05 0 0) (0.2 0.15 0.01); }'
dictionary constant/picProperties <<<'device cpu; walls { motion { piston { patches (piston); '\
'solidBodyMotionFunction linearMotion; velocity (0.04 0 0); } } }'
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }'
mv constant/sphProperties .
control "riding { type particleProbes; $library fields (p); body piston; average 0.1; \
probeLocations ((0.0501 0.05 0)); }" 0.4
sed -i 's/solver sphDem/solver picDem/' system/controlDict
rm -rf 0; setParticles >log 2>&1 || fail piston "$(tail -3 log)"
run piston
near piston "$(last riding/0/pMean.dat 2)" "$(awk 'BEGIN { print 9810*(0.0225/0.134 - 0.05) }')" 80
mv sphProperties constant; rm constant/geometry constant/picProperties

# A block of solids in the water that turns: of two gauges on opposite sides the left one sinks by
# 0.02 sin(3 t), the right one rises as much
regions 'below { set fluid; source box; box (0 0 0) (0.2 0.06 0.01); pressure hydrostaticTo; } '\
'left { set fluid; source box; box (0 0.06 0) (0.08 0.1 0.01); pressure hydrostaticTo; }
right { set fluid; source box; box (0.12 0.06 0) (0.2 0.1 0.01); pressure hydrostaticTo; } '\
'above { set fluid; source box; box (0 0.1 0) (0.2 0.2 0.01); pressure hydrostaticTo; }
block { set solids; material stone; group block; radius 0.005; source box; '\
'box (0.08 0.06 0) (0.12 0.1 0.01); }'
sed -i 's/spacing 0.005/spacing 0.01/; s/pressure hydrostaticTo/pressure hydrostatic; '\
'freeSurface 0.2/g' system/setParticlesDict
water ''
dictionary constant/solidProperties \
    <<<'materials { stone { rho 2000; } } contact { normal linear; } '\
'pairs { default { stiffness 1e5; restitution 0.3; friction 0.3; } } walls { material stone; }
groups { block { motion { solidBodyMotionFunction rotatingMotion; origin (0.1 0.08 0); '\
'axis (0 0 1); omega 3; } } }'
gauge="type particleProbes; $library fields (p); probeLocations ((0.08 0.08 0));"
sides="left { $gauge body block; sensorNormal (-1 0 0); average 0.1; }
right { type particleProbes; $library fields (p); probeLocations ((0.12 0.08 0)); body block; \
sensorNormal (1 0 0); average 0.1; }"
control "$sides" 0.4
rm -rf 0; setParticles >log 2>&1 || fail block "$(tail -3 log)"
run block
# at rest on the lattice: what the sensor's plane hides is integrated
near blockStart "$(at postProcessing/left/0/p.dat 0)" 1177.2 1
apart()
{
    awk -v a="$(last left/$1/pMean.dat 2)" \
        -v b="$(last right/$1/pMean.dat 2)" 'BEGIN { print a - b }'
}
near blockTurned "$(apart 0)" "$(awk 'BEGIN { print 9810*0.04*(cos(0.9) - cos(1.2))/0.3 }')" 40
before=$(apart 0)
rm -r 0.4; control "$sides" 0.4 latestTime
riprapFoam >log 2>&1
near blockRestart "$(apart 0.2)" "$before" 1

wrong()     # NAME ENTRIES MESSAGE
{
    control "wrong { $gauge $2 }" 0.4
    refused "$1" "$3.*controlDict.functions.wrong" riprapFoam
}
wrong body 'body blok;' \
    'Entry body of .*blok is no group of walls that moves and none of solids; valid are.*block'
wrong empty 'body free; sensorNormal (1 0 0);' 'Entry body: group free of solids has no particles'
wrong normal 'body block;' 'Entry sensorNormal of .*missing: probe 0 .*rides on solids'
wrong across 'body block; sensorNormal (0 0 1);' 'Entry sensorNormal .*across the plane'
wrong outside 'probeLocations ((0.08 0.5 0)); body block; sensorNormal (1 0 0);' \
    'Entry probeLocations .*probe 0 .*outside of the mesh'
wrong average 'average -1;' 'Entry average of .*is -1: it must not be negative'
