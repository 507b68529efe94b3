#!/bin/bash
# What two files say: a property that was changed after setParticles is used, or is one message that
# names both values and both files.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL twoFiles no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam foamDictionary
do
    command -v $program >/dev/null || { echo "FAIL twoFiles no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=twoFiles
. "$root/tests/regression/setParticlesCases"

control()   # SOLVER ENDTIME
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom latestTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-4; adjustTimeStep yes; maxCo 0.5; sampleInterval 0.002; writeControl adjustableRunTime; \
writeInterval 0.002; writeFormat ascii; writePrecision 6; timePrecision 9;"
}
solids()    # RHO of wood
{
    dictionary constant/solidProperties \
        <<<"materials { wood { rho $1; E 1e6; nu 0.25; } steel { rho 7800; E 1e6; nu 0.25; } }
pairs { default { restitution 0.5; friction 0.3; } } walls { material steel; }"
}
fill()
{
    dictionary system/setParticlesDict <<<"${2-spacing 0.005;} regions ( $1 );"
    setParticles >log 2>&1 || cat log
}
pool='pool { set fluid; source box; box (0 0 -1) (0.1 0.05 1); }'
log='log { set solids; material wood; source cylinder; p1 (0.15 0.06 -1); p2 (0.15 0.06 1); '\
'radius 0.0301; spacing 0.005; rigid yes; }'

# rho of solids, from which setParticles has made masses: in all three solvers, at the start and
# when continued
tank2; solids 500
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
for solver in dem sphDem picDem
do
    rm -rf 0 0.*; control $solver 0.002; walls ''
    rm -f constant/picProperties constant/sphProperties
    case $solver in
        dem) fill "$log" '' ;;
        sphDem) walls ''; fill "$pool $log" ;;
        picDem) dictionary constant/picProperties </dev/null; fill "$pool $log" ;;
    esac
    riprapFoam >log 2>&1 && pass $solver.run || fail $solver.run "$(grep -m1 -A3 ERROR log)"
    solids 700
    control $solver 0.004
    refused $solver.continued 'Material wood: rho is 700, and the masses of lagrangian/solids '\
'at time 0.002 were made with 500 \(.*0.002/uniform/lagrangian/solids/cloudProperties"?\).*Run '\
'setParticles.*solidProperties' riprapFoam
    rm -rf 0.*
    refused $solver.start 'Material wood: rho is 700, and the masses of lagrangian/solids at '\
'time 0 were made with 500 \(.*0/uniform/lagrangian/solids/cloudProperties"?\).*solidProperties' \
        riprapFoam
    setParticles >log 2>&1; riprapFoam >log 2>&1; says $solver.again '^End'
    solids 500
done
# Of a material that no particle has it does not matter
rm -rf 0 0.*; control dem 0.002; fill "$log" ''
sed -i 's/7800/8000/' constant/solidProperties; riprapFoam >log 2>&1; says wallDensity '^End'
solids 500

# system/setParticlesDict, which a run does not read: an edit without setParticles
edit()      # NAME MESSAGE SED-COMMAND...
{
    local name=$1 message=$2; shift 2
    cp system/setParticlesDict aside; sed -i "$@" system/setParticlesDict
    refused "edit.$name" "The particles of time 0 were made from other entries, which \
.*0/uniform/riprap/setParticlesDict. holds: $message.*Run setParticles.*system/setParticlesDict" \
        riprapFoam -dry-run
    mv aside system/setParticlesDict
}
rm -rf 0 0.*; control sphDem 0.002; walls ''; fill "$pool $log"
edit spacing 'spacing: 0.004, was 0.005' 's/spacing 0.005; regions/spacing 0.004; regions/'
edit radius 'regions/log/radius: 0.03, was 0.0301' 's/0.0301/0.03/'
edit material 'regions/log/material: steel, was wood' 's/material wood/material steel/'
edit mass 'regions/log/mass: 2, was not there' 's/rigid yes;/rigid yes; mass 2;/'
edit velocity 'regions/pool/velocity: \( 1 0 0 \), was not there' \
    's/set fluid;/set fluid; velocity (1 0 0);/'
edit packing 'packing: hexagonal, was not there' 's/^spacing/packing hexagonal; spacing/'
edit region 'regions/log: not there, was \{ .. \}' 's/ log {.*} );/ );/'
refused otherDict "spacing: 0.005, was 0.0025" bash -c 'sed "s/spacing 0.005; '\
'regions/spacing 0.0025; regions/" system/setParticlesDict >system/fine; '\
'setParticles -dict fine >/dev/null 2>&1; sed -i "s/0.0025/0.005/" system/fine; riprapFoam -dry-run'
fill "$pool $log"
# What is the same, or no one's: numbers as utilities write them, comments, numbers of the user's
# own
sed -i 's/0.0301/3.01000001e-2/; s/^spacing/mine 3; spacing/; 2i // a remark' \
    system/setParticlesDict
riprapFoam -dry-run >log 2>&1; says edit.same '^End'
rm 0/uniform/riprap/setParticlesDict; sed -i 's/3.01000001e-2/0.03/' system/setParticlesDict
riprapFoam -dry-run >log 2>&1; says edit.asTheyAre '^End'
fill "$pool $log"; riprapFoam >log 2>&1; sed -i 's/0.0301/0.03/' system/setParticlesDict
control sphDem 0.004
riprapFoam >log 2>&1; says edit.continued 'Continuing exactly.*End'

# rho of the fluid: the new one is used, also where no exact state is; particles keep their pressure
# in units of it
rm -rf 0 0.*; rm constant/solidProperties; control sphDem 0.002; fill "$pool"
riprapFoam >log 2>&1; says density.same '^End'; quiet density.quiet 'Warning'
cp 0.002/lagrangian/fluid/rho before; rm -rf 0.*
dictionary constant/fluidProperties <<<'rho 2000; mu 2e-3;'
riprapFoam >log 2>&1
says density.changed 'Warning.*Entry rho of constant/fluidProperties is 2000, '\
'and was 1000 when lagrangian/fluid of time 0 was written.*The new one is used.*End'
# To the digits of the files: the same motion with twice the density
paste <(sed -n '/^[0-9.]*$/p' before) <(sed -n '/^[0-9.]*$/p' 0.002/lagrangian/fluid/rho) \
    | awk 'NF == 2 && $1 > 900 && ($2/$1 - 2)^2 > 1e-9 {bad = 1} NF == 2 && $1 > 900 {++n}
        END {exit !(n > 100 && !bad)}' &&
    pass density.twice || fail density.twice 'densities are not twice those of half the rho'
rm -rf 0.002/uniform/riprap; control sphDem 0.004; riprapFoam >log 2>&1
says density.fields 'Starting from the fields.*End'; quiet density.fieldsQuiet 'Warning'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'

# Gravity, of which hydrostatic pressures are
rm -rf 0.*; control sphDem 0.002; fill "$pool"
dictionary constant/g uniformDimensionedVectorField \
    <<<'dimensions [0 1 -2 0 0 0 0]; value (0 -5 0);'
riprapFoam >log 2>&1; says gravity 'Warning.*Entry value of constant/g is \(0 -5 0\), '\
'and was \(0 -9.81 0\) when setParticles made lagrangian/fluid.*End'
rm -rf 0.*; setParticles >log 2>&1; riprapFoam >log 2>&1; says gravity.again '^End'
quiet gravity.quiet 'Warning'
