#!/bin/bash
# maxVelocity auto: the estimate of the start from falls, speeds, moving walls and solids; the raise
# in a run, its energy and its restart.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL maxVelocity no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL maxVelocity no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=maxVelocity
. "$root/tests/regression/setParticlesCases"

sph() { dictionary constant/sphProperties <<<"device cpu; $1"; }
control()   # ENDTIME INTERVAL MORE
{
    dictionary system/controlDict <<<"application riprapFoam; solver sphDem; startFrom latestTime; \
startTime 0; stopAt endTime; endTime $1;
deltaT 1e-3; adjustTimeStep yes; sampleInterval $2; writeControl adjustableRunTime; \
writeInterval $2; writeFormat ascii; writePrecision 12; timePrecision 9; ${3:-}"
}
water()     # BOX MORE: spacing 5 mm
{
    rm -rf 0 0.*; regions "tank { set fluid; source box; box $1; ${2:-} }"
    setParticles >log 2>&1 || fail fill "$(oneLine)"
}
# What a run takes, of the first written time, against a formula
estimate()  # NAME FORMULA [TOLERANCE]
{
    rm -rf 0.*; riprapFoam >log 2>&1
    local file; file=$(ls -d 0.*/uniform/riprap/sphRun 2>/dev/null | head -1)
    [[ -s $file ]] || { fail "$1" "no run: $(grep -m1 -A3 ERROR log)"; return; }
    awk -v name="maxVelocity.$1" \
        "/^maxVelocity/ { sub(\";\", \"\"); g = 9.81; e = $2; d = \$2 - e; if (d < 0) d = -d
        if (d <= ${3:-1e-9}*e) print \"PASS \" name; \
else print \"FAIL \" name \" it is \" \$2 \", not \" e }" "$file"
}
motion()
{
    sph "walls { motion { wall { patches ($1); solidBodyMotionFunction oscillatingLinearMotion; \
oscillatingLinearMotionCoeffs { amplitude $2; omega $3; } } } }"
}

# The start. The tank is 0.1 m high; lattices end half a spacing from the faces
tank2; control 1e-4 1e-4; sph ''
water '(0 0 0) (0.1 0.08 0.01)';                        estimate standing 'sqrt(2*g*0.08)'
water '(0 0.05 0) (0.1 0.08 0.01)';                     estimate drops 'sqrt(2*g*0.08)'
water '(0 0.05 0) (0.1 0.08 0.01)' 'velocity (3 0 0);'; estimate thrown 'sqrt(2*g*0.08 + 9)'
control 0.02 1e-4; sed -i 's/stopAt endTime/stopAt nextWrite/' system/controlDict
water '(0 0 0) (0.1 0.08 0.01)'
motion right '(0.002 0 0)' 500;                         estimate piston 'sqrt(2*g*0.08 + 1)' 1e-3
# Pressures are those of setParticles, whatever speed of sound the run takes
p=$(awk '/^\(/ {n = 1; next} n && /^[0-9]/ {if ($1 > most) most = $1} END {print most}' \
    0/lagrangian/fluid/p)
now=$(awk '/^\(/ {n = 1; next} n && /^[0-9]/ {if ($1 > most) most = $1} END {print most}' \
    0.*/lagrangian/fluid/p)
awk -v a="$p" -v b="$now" 'BEGIN { exit !(a > 700 && b > 0.97*a && b < 1.03*a) }' \
    && pass pressureKept \
    || fail pressureKept "highest pressure $p Pa of setParticles, $now Pa in the run"
motion '".*"' '(0 0 0)' 1;                              control 1e-4 1e-4
estimate restingMotion 'sqrt(2*g*0.08)'

# Solids: what falls, what is held, what is bonded to something held
solids()    # REGION MORE BONDS
{
    local bonds='bonds ( block { type cement; groups (free); gapTolerance 1e-6; } );'
    (($# < 3)) || bonds=$3
    dictionary constant/solidProperties \
        <<<"materials { rubber { rho 800; E 1e6; nu 0.3; } } contact { normal linear; }
pairs { default { restitution 0.9; friction 0; stiffness 1e5; } } walls { material rubber; } \
bonds { cement { calibration moduli; E 1e6; G 4e5; } } ${2:-}"
    dictionary system/setParticlesDict <<<"spacing 0.005; packing square; \
regions ( tank { set fluid; source box; box (0 0 0) (0.1 0.04 0.01); }
block { set solids; material rubber; radius 0.002; mass cell; source box; $1 } ); $bonds"
    rm -rf 0 0.*; setParticles >log 2>&1 || fail fill "$(oneLine)"
}
sph ''
block='box (0.12 0.08 0) (0.14 0.088 0.01);'
solids "$block";                                        estimate fallingBody 'sqrt(2*g*0.08)'
solids "$block velocity (0 -2 0);";                     estimate thrownBody 'sqrt(2*g*0.08 + 4)'
solids "$block group held;" 'groups { held { fixed all; } }' '';  estimate heldBody 'sqrt(2*g*0.04)'
solids "$block group moved;" 'groups { moved { motion { solidBodyMotionFunction linearMotion; '\
'linearMotionCoeffs { velocity (0 3 0); } } } }' ''
estimate movedBody 'sqrt(2*g*0.04 + 9)'
rm -f constant/solidProperties

# In a run: two sheets of water fall together at 1 m/s, 40 degrees each from their plane, and throw
# a jet of 1/tan(20 degrees) = 2.75 m/s (Birkhoff et al. 1948), which no estimate of the start can
# know
block 0.3 0.2 0.01 '30 20 1' "$sides $lower $open $flat"
dictionary constant/g uniformDimensionedVectorField <<<'dimensions [0 1 -2 0 0 0 0]; value (0 0 0);'
awk 'BEGIN { pi = atan2(0, -1); b = 40*pi/180; d = 0.0025; print "x,y,z,u,v,w"
    for (side = -1; side <= 1; side += 2) for (i = 2; i < 32; ++i) for (j = 0; j < 8; ++j)
    {
        s = (i + 0.5)*d; n = (j + 0.5)*d
        print 0.07 + s*cos(b) - n*sin(b) "," 0.1 + side*(s*sin(b) + n*cos(b)) ",0.005," sin(b) \
            "," (-side*cos(b)) ",0"
    } }' >sheets.csv
dictionary system/setParticlesDict <<<'spacing 0.0025; packing square; '\
'regions ( sheets { set fluid; source csv; file "sheets.csv"; pressure zero; } );'
rm -rf 0 0.*; setParticles >log 2>&1 || fail fill "$(oneLine)"
control 0.06 0.005 'functions { energy { type energyBalance; libs ("libriprapFoam.so"); '\
'writeControl timeStep; writeInterval 1; } }'
sph 'artificialViscosity { alpha 0.02; } viscosity artificial;'
rm -rf postProcessing
riprapFoam >log 2>&1 && pass jetRuns || fail jetRuns "$(grep -m1 -A4 ERROR log)"
says raise 'maxVelocity auto: 1 to [0-9.]+ m/s, c0 10 to [0-9.]+ m/s at time [0-9.]+ s: '\
'[0-9.]+ % of the fluid is faster'
says stepsOfAList 'limit: [a-z]+, steps a list = [0-9.]+'
awk '/^maxVelocity auto:/ {v = $5} /^max\(mag\(U\)\)/ {if ($3 > most) most = $3}
        END {exit !(v > 1.2 && v < 6 && most > 1.2)}' log && pass raised \
    || fail raised "$(grep 'maxVelocity auto' log | tail -1)"
# Energy: what raises of c0 change is named, and what is left never grows by more than a thousandth
# of the kinetic energy of the start
awk '/^# Time/ {for (i = 2; i <= NF; ++i) at[$i] = i - 1} /^[0-9]/ { d = $at["dissipated"];
        k = $at["kinetic"]; s = $at["stiffening"]
        if (!first) {first = k; last = d} if (d < last - 1e-3*first) bad = $1; last = d }
    END { if (bad) print "dissipated falls at " bad; else
        if (!(s < 0)) print "nothing of the raise"; else print "good" }' \
    postProcessing/energy/0/energyBalance.dat >said
grep -q good said && pass energy || fail energy "$(cat said)"
# Continued from a time after the raise
raisedAt=$(sed -n 's/^maxVelocity auto: .* at time \([0-9.]*\) s:.*/\1/p' log | head -1)
from=$(awk -v t="$raisedAt" 'BEGIN { printf "%g", 0.005*int(t/0.005 + 0.5) }')
mv 0.06 before
for t in 0.*; do awk -v t="$t" -v f="$from" 'BEGIN {exit !(t > f + 1e-9)}' && rm -r "$t"; done
riprapFoam >log 2>&1
says continued "Continuing exactly from time $from"
diff -r before/lagrangian 0.06/lagrangian >/dev/null && pass restart \
    || fail restart "the run continued from $from, the time of the first raise, differs"
# Given, it stays
rm -rf 0.*; sph 'maxVelocity 1; artificialViscosity { alpha 0.02; } viscosity artificial;'
riprapFoam >log 2>&1
quiet given 'maxVelocity auto'
