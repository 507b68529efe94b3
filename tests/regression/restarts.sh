#!/bin/bash
# Runs that stop and go on are those that do not stop, to the bit: the short part of tests/restarts,
# and what no tutorial has
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL restarts no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL restarts no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=restarts
. "$root/tests/regression/setParticlesCases"

control()   # SOLVER ENDTIME INTERVAL
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom latestTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-4; adjustTimeStep yes; maxCo 0.5; sampleInterval $3; writeControl adjustableRunTime; \
writeInterval $3; writeFormat ascii;
writePrecision 6; timePrecision 9;"
}
# One run to the end; then from its first written time on
exact()     # NAME
{
    local name=$1 first last
    rm -rf 0.* whole
    riprapFoam >log 2>&1 || { fail "$name" "$(grep -A3 FATAL log | tr '\n' ' ')"; return; }
    first=$(ls -d 0.* | sort -g | head -1) last=$(ls -d 0.* | sort -g | tail -1)
    mkdir whole; mv "$last" whole; for t in 0.*; do [[ $t == "$first" ]] || rm -r "$t"; done
    riprapFoam >log 2>&1
    says "$name.says" "Continuing exactly from time $first"
    diff -rq -x manifest -x time "whole/$last" "$last" >differ && pass "$name" \
        || fail "$name" "$(tr '\n' ' ' <differ)"
}
pool='pool { set fluid; source box; box (0 0 -1) (0.06 0.05 1); }'
grains='grains { set solids; material glass; source box; box (0.11 0 -1) (0.19 0.04 1); '\
'radius 0.005; packing layers; velocity (0.3 0 0); }'
glass='materials { glass { rho 2500; E 1e7; nu 0.25; } } pairs { default { restitution 0.5; '\
'friction 0.3; } } walls { material glass; } device cpu;'

# A wall that goes out of the mesh and comes back: the rest of the run does not see how far it went
tank2; regions "$pool"; control sphDem 0.12 0.06
dictionary constant/sphProperties \
    <<<'device cpu; walls { motion { piston { patches (right); solidBodyMotionFunction '\
'oscillatingLinearMotion; oscillatingLinearMotionCoeffs { amplitude (0.05 0 0); omega 31.4; } } } }'
setParticles >log 2>&1; exact movesOut

# Grains across a periodic side
channel2; control dem 0.1 0.05; dictionary constant/solidProperties <<<"$glass"
dictionary system/setParticlesDict <<<"regions ( $grains );"; setParticles >log 2>&1; exact cyclic

# A group that is moved in the water, slower and slower
tank2; regions "$pool ${grains/glass;/glass; group paddle;}"; control sphDem 0.02 0.01; walls ''
echo 'device cpu;' >>constant/sphProperties
dictionary constant/solidProperties <<<"$glass groups { paddle { motion { solidBodyMotionFunction \
oscillatingLinearMotion; oscillatingLinearMotionCoeffs { amplitude (0.002 0 0); omega 60; } } } }"
setParticles >log 2>&1; exact paddle

# Grains that leave over an open top while bonds break
tank2; control dem 0.04 0.02
dictionary constant/solidProperties <<<"$glass bonds { weak { calibration moduli; E 1e6; G 4e5; \
tensileStrength 2e3; shearStrength 2e3; } }"
dictionary system/setParticlesDict <<<"regions ( bar { set solids; material glass; source box; \
box (0.02 0.08 -1) (0.18 0.1 1); radius 0.005; velocity (0 0.5 0); }
${grains/velocity (0.3 0 0)/velocity (0.2 0 0)} ); bonds ( all { type weak; groups (free); \
gapTolerance 1e-6; } );"
setParticles >log 2>&1; exact escapesAndBreaks

# Soft grains that are behind a plane when they are written
tank2; control dem 0.04 0.02
dictionary constant/solidProperties \
    <<<"materials { glass { rho 2500; } } contact { normal linear; tangential history; } \
pairs { default { stiffness 2e3; restitution 0.5; friction 0.3; stiffnessRatio 0.3; } }
walls { material glass; planes { net { point (0.15 0 0); normal (-1 0 0); } } } device cpu;"
dictionary system/setParticlesDict \
    <<<"regions ( ${grains/box (0.11 0 -1) (0.19 0.04 1)/box (0.1 0.02 -1) (0.14 0.1 1)} );"
sed -i 's/velocity (0.3 0 0)/velocity (2 0 0)/' system/setParticlesDict; setParticles >log 2>&1
exact softPlane

"${RIPRAP_PYTHON:-python3}" "$root/tests/restarts/runRestarts.py" --short 2>/dev/null
