#!/bin/bash
# Function objects: values that can be computed by hand on a column of water in a tank, restart,
# -postProcess, and wrong entries.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL functionObjects no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL functionObjects no $program"; exit 1; }
done

case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=functionObjects
. "$root/tests/regression/setParticlesCases"
mkdir system constant

# Column 0.2 x 0.2 m of 400 particles in a tank 0.4 x 0.3 m, and one particle that flies ahead.
# Cells are as large as particles
dictionary system/blockMeshDict <<'END'
scale 1;
vertices
((0 0 0) (0.4 0 0) (0.4 0.3 0) (0 0.3 0) (0 0 0.01) (0.4 0 0.01) (0.4 0.3 0.01) (0 0.3 0.01));
blocks (hex (0 1 2 3 4 5 6 7) (40 30 1) simpleGrading (1 1 1));
boundary
(
    tank { type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4)); }
    top { type patch; faces ((3 7 6 2)); }
    frontAndBack { type empty; faces ((0 3 2 1) (4 5 6 7)); }
);
END
dictionary system/fvSchemes <<<'ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {} '\
'interpolationSchemes {} snGradSchemes {}'
dictionary system/fvSolution </dev/null
dictionary constant/g uniformDimensionedVectorField \
    <<<'dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);'
dictionary constant/fluidProperties <<<'rho 1000; mu 1e-3;'
dictionary constant/sphProperties <<<'device cpu; maxVelocity 2; XSPH none; antiClump none;'
dictionary system/setParticlesDict <<'END'
spacing 0.01;
packing square;
regions
(
    column { set fluid; source box; box (0 0 0) (0.2 0.2 0.01); pressure hydrostatic; }
    drop { set fluid; source box; box (0.35 0.25 0) (0.36 0.26 0.01); pressure zero; }
);
END
library='libs ("libriprapFoam.so");'
control()   # FUNCTIONS [startFrom]
{
    dictionary system/controlDict <<END
application riprapFoam; solver sphDem; startFrom ${2:-startTime}; startTime 0; stopAt endTime; \
endTime 0.1;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.05; writeFormat ascii; writePrecision 16;
functions { $1 }
END
}
functions="
onMesh { type particlesToMesh; $library }
front { type frontPosition; $library }
gauges { type waterLevel; $library points ((0 0 0) (0.1 0.05 0) (0.3 0 0) (0.355 0 0)); }
splashes { type waterLevel; $library points ((0.355 0 0)); minThickness 0; }
probes { type particleProbes; $library fields (p U rho volumeFraction); \
probeLocations ((0.1 0.1 0) (0 0.1 0) (0.1 0 0) (0.3 0.1 0)); }
surface { type particleProbes; $library fields (p); surfaceCorrection on; \
probeLocations ((0.1 0.195 0) (0 0.2 0) (0.2 0.1 0) (0 0 0)); }
sensor { type particleProbes; $library fields (p); sensorRadius 0.02; probeLocations ((0 0.1 0)); }
energy { type energyBalance; $library }
sparse { type energyBalance; $library writeControl timeStep; writeInterval 5; }
force { type wallForce; $library }
mass { type regionMass; $library regions ( left { source box; \
box (0 0 0) (0.1 0.3 0.01); } all { source box; box (0 0 0) (0.4 0.3 0.01); }
    disk { source cylinder; p1 (0.1 0.1 0); p2 (0.1 0.1 0.01); radius 0.052; } ); }
volume { type volFieldValue; libs (\"libfieldFunctionObjects.so\"); fields (alpha.water); \
operation volIntegrate; regionType all; writeFields no; }
"

value()     # FILE COLUMN TIME: from a table, by the column's name
{
    awk -v column="$2" -v time="$3" '
        /^#/ { n = split($0, name, /[ \t]+/); for (i = 2; i <= n; ++i) at[name[i]] = i - 1; next }
        { if (($1 - time)^2 < 1e-16) print $(at[column]) }' postProcessing/$1
}
near()      # NAME FILE COLUMN TIME EXPECTED BOUND
{
    local found; found=$(value "$2" "$3" "$4")
    if awk -v a="$found" -v b="$5" -v bound="$6" 'BEGIN { exit !(a != "" && (a - b)^2 <= bound^2) }'
    then
        echo "PASS $1"
    else
        echo "FAIL $1 $3 at $4 s is ${found:-not there}, expected $5 within $6"
    fi
}
wrong()     # NAME FUNCTION MESSAGE
{
    control "wrong { $2 $library }"
    refused "$1" "$3.*controlDict.functions.wrong" riprapFoam
}

control "$functions"
if ! { blockMesh && setParticles && riprapFoam; } >log 2>&1
then
    tail -20 log
    echo "FAIL functionObjectsRun see above"; exit 1
fi
echo "PASS functionObjectsRun"

# The start, on the lattice. Pressure: h = 0.1 and 0.2 m below the surface; 1 %: h/dp = 1.25 sums
# lattices to 0.99
near probeInside probes/0/p.dat p0 0 981 10
near probeOnSideWall probes/0/p.dat p1 0 981 10
near probeOnFloor probes/0/p.dat p2 0 1962 20
near probeDry probes/0/p.dat p3 0 0 0
near probeVelocity probes/0/U.dat Uy1 0 0 1e-12
# Tait, c0 = 20 m/s: 1000 (1 + 7 x 981/4e5)^(1/7)
near probeDensity probes/0/rho.dat rho0 0 1002.43 0.05
near probeFraction probes/0/volumeFraction.dat f1 0 1 0.03         # two lattice sums of 0.99
# Carried from the centroid of the fluid: exact at a free surface too, on the lattice and with
# Tait's slight curvature
near surfaceBelow surface/0/p.dat p0 0 49.05 1
near surfaceOnWall surface/0/p.dat p1 0 0 1
near surfaceUpright surface/0/p.dat p2 0 981 1
near surfaceInCorner surface/0/p.dat p3 0 1962 1
near sensorOnWall sensor/0/p.dat p0 0 981 10
# Level and front to a quarter of a spacing and exactly
near levelOnWall gauges/0/waterLevel.dat level0 0 0.2 0.0025
near levelAboveFoot gauges/0/waterLevel.dat level1 0 0.15 0.0025
near levelDry gauges/0/waterLevel.dat lowest2 0 0 0
# The drop, one particle of 0.01 m at 0.255 m, is no water unless asked for; half of a spacing and
# the kernel's smoothing
near levelDrop gauges/0/waterLevel.dat level3 0 0 0
near levelDropLowest gauges/0/waterLevel.dat lowest3 0 0.26 0.01
near levelSplashes splashes/0/waterLevel.dat level0 0 0.26 0.01
near frontStart front/0/frontPosition.dat front 0 0.2 1e-6
near frontFloorStart front/0/frontPosition.dat frontFloor 0 0.2 1e-6
near frontMax front/0/frontPosition.dat max 0 0.36 1e-6         # the drop
near frontHeight front/0/frontPosition.dat height 0 0.2 0.0025
near frontParticles front/0/frontPosition.dat particles 0 401 0
# Energy: sums over the lattice, m = 0.1 kg/m: 9.81 (40 x 0.1 + 0.1 x 0.255); masses to 0.1 %
near energyPotential energy/0/energyBalance.dat potential 0 39.490 0.04
near energyKinetic energy/0/energyBalance.dat kinetic 0 0 1e-12
near energyDissipatedStart energy/0/energyBalance.dat dissipated 0 0 1e-9

# 10 x 20 particles of 0.1 kg; 88 centres lie in the disk
near massLeft mass/0/regionMass.dat leftFluidMass 0 20 1e-9
near massLeftFraction mass/0/regionMass.dat leftFluidFraction 0 0.66666667 1e-7
near massAll mass/0/regionMass.dat allFluidMass 0 40.1 1e-9
near massDisk mass/0/regionMass.dat diskFluidMass 0 8.8 1e-9
near massDiskFraction mass/0/regionMass.dat diskFluidFraction 0 1.0359 1e-3
near massKept mass/0/regionMass.dat allFluidMass 0.1 40.1 1e-9

# The end: the balance closes by definition, volume is kept
now=$(value energy/0/energyBalance.dat total 0.1)
near energyDissipated energy/0/energyBalance.dat dissipated 0.1 \
    "$(awk -v a="$(value energy/0/energyBalance.dat total 0)" -v b="$now" \
        'BEGIN { print a - b }')" 1e-3
near energyTotal energy/0/energyBalance.dat \
    total 0.1 "$(awk -v k="$(value energy/0/energyBalance.dat kinetic 0.1)" \
    -v p="$(value energy/0/energyBalance.dat potential 0.1)" \
    -v e="$(value energy/0/energyBalance.dat elastic 0.1)" 'BEGIN { print k + p + e }')" 1e-3
for time in 0.01 0.1
do
    # 0.2 x 0.2 m and the drop, 0.01 m thick: 2 %
    near "volumeOnMesh$time" volume/0/volFieldValue.dat "volIntegrate(alpha.water)" $time 4.01e-4 \
        8e-6
done
rows=$(grep -vc '#' postProcessing/sparse/0/energyBalance.dat)
[[ $rows == 3 ]] && echo "PASS writeControlOfRows" \
    || echo "FAIL writeControlOfRows $rows rows, expected those of 0, 0.05 and 0.1"
missing=$(for t in 0 0.05 \
    0.1; do for f in p U alpha.water; do [[ -f $t/$f ]] || echo $t/$f; done; done)
[[ -z $missing && ! -e 0.01 ]] && echo "PASS fieldsAtWriteTimes" \
    || echo "FAIL fieldsAtWriteTimes missing: $missing"
grep -A2 frontAndBack 0.1/p | grep -q empty && grep -A2 tank 0.1/p | grep -q zeroGradient \
    && echo "PASS fieldPatches" || echo "FAIL fieldPatches"

# Written times again, and in a continued run
mv postProcessing first
control "$functions"
riprapFoam -postProcess -time 0.1 >log 2>&1
near postProcessFront front/*/frontPosition.dat front 0.1 \
    "$(awk '$1 + 0 == 0.1 { print $2 }' first/front/0/frontPosition.dat)" 1e-6
rm -rf postProcessing 0.1
control "$functions" latestTime
riprapFoam >log 2>&1
for file in front/0/frontPosition.dat energy/0/energyBalance.dat probes/0/p.dat
do
    if cmp -s <(grep -v '#' first/$file | tail -5) \
        <(grep -v '#' postProcessing/${file/\/0\//\/0.05\/} | tail -5)
    then echo "PASS restart ${file##*/}"
    else
        echo "FAIL restart ${file##*/} rows differ"
        diff <(tail -5 first/$file) <(tail -5 postProcessing/${file/\/0\//\/0.05\/})
    fi
done

# What is wrong is said
rm -rf 0.* postProcessing
probes='type particleProbes; probeLocations ((0.1 0.1 0));'
wrong field 'type particleProbes; fields (p T); probeLocations ((0 0 0));' \
    'Entry fields of .*unknown field T; valid are \(p U rho volumeFraction\)'
wrong noFields "$probes fields ();" 'Entry fields of .* is empty; valid are \(p U'
wrong probeOutside 'type particleProbes; probeLocations ((0 5 0));' \
    'Entry probeLocations .*probe 0 .*outside of the mesh'
wrong noLocations 'type particleProbes;' "'probeLocations' not found"
wrong emptyLocations 'type particleProbes; probeLocations ();' 'Entry probeLocations of .* is empty'
wrong average "$probes average -1;" 'Entry average of .* is -1: it must not be negative'
wrong body "$probes body gate;" \
    'Entry body of .* gate is no group of walls that moves and none of solids; valid are'
wrong sensorRadius "$probes sensorRadius -1;" \
    'Entry sensorRadius of .* is -1: it must not be negative'
wrong noNormal "$probes sensorRadius 0.01;" \
    'Entry sensorNormal of .* is missing: probe 0 .*on no wall'
wrong normalAcross "$probes sensorRadius 0.01; sensorNormal (0 0 1);" \
    'Entry sensorNormal .*across the plane'
wrong minVolumeFraction "$probes minVolumeFraction 7;" \
    'Entry minVolumeFraction is 7: it must be from 0 to 1'
wrong wallCorrection "$probes wallCorrection maybe;" 'maybe'
wrong surfaceCorrection "$probes surfaceCorection on;" \
    'Unknown entry surfaceCorection; valid are .*wallCorrection surfaceCorrection'
wrong gaugeOutside 'type waterLevel; points ((5 0 0));' 'Entry points .*meets nothing'
wrong minThickness 'type waterLevel; points ((0 0 0)); minThickness -1;' \
    'Entry minThickness of .* is -1: it must not be negative'
wrong frontThickness 'type frontPosition; minThickness -1;' \
    'Entry minThickness of .* is -1: it must not be negative'
wrong noGauges 'type waterLevel; points ();' 'Entry points of .* is empty'
wrong gaugeAcross 'type waterLevel; points ((0 0 0)); up (0 0 1);' \
    'Entry up of .* has no length in the plane of the 2D mesh'
wrong direction 'type frontPosition; direction (0 0 0);' 'Entry direction of .* has no length'
wrong spacing 'type frontPosition; spacing 0;' 'Entry spacing is 0: it must be positive'
wrong floorHeight 'type frontPosition; floorHeight -1;' \
    'Entry floorHeight of .* is -1: it must not be negative'
wrong minNeighbours 'type frontPosition; minNeighbours -1;' \
    'Entry minNeighbours of .* is -1: it must not be negative'
wrong meshField 'type particlesToMesh; fields (T);' \
    'Entry fields of .*unknown field T; valid are \(p U alpha.water\)'
wrong meshDry 'type particlesToMesh; minVolumeFraction -1;' \
    'Entry minVolumeFraction is -1: it must be from 0 to 1'
control "first { type particlesToMesh; $library } wrong { type particlesToMesh; $library }"
refused meshTwice 'the mesh has a field p of another owner already.*controlDict.functions.wrong' \
    riprapFoam
wrong unknown 'type energyBalance; fields (p);' 'Unknown entry fields; valid are .*writeInterval'
wrong picOnly 'type momentumBalance;' 'needs a running particle scene, and there is no picScene'
wrong massOfNothing 'type regionMass; regions ();' 'Entry regions of function object wrong is empty'
printf 'x,y,z\n0.1,0.1,0.005\n' >constant/points.csv; cp constant/points.csv .
wrong massOfList 'type regionMass; regions ( a { source csv; file "points.csv"; } );' \
    'region a: its source is no volume: box, cylinder, sphere and surface are'
wrong massSource 'type regionMass; regions ( a { source cube; } );' 'cube.*valid are'
wrong massEntry 'type regionMass; regions ( a { source box; box (0 0 0) (1 1 1); '\
'velocity (0 0 0); } );' 'Unknown entry velocity; valid are'
wrong massBesides 'type regionMass; regions ( a { source box; box (0 0 1) (1 1 2); } );' \
    'region a: the mid-plane of the 2D mesh does not cut it'
wrong solidsOnly 'type groupMotion;' 'needs a running scene of solids'
wrong writeControl 'type wallForce; writeControl sometimes;' 'sometimes'

# Written times: one without particles is a warning, others are processed, and the end says so
control "gauges { type waterLevel; points ((0.1 0 0)); $library }"
mkdir 0.05
riprapFoam -postProcess >log 2>&1 && fail postProcessStatus "ended with status 0" \
    || says postProcessStatus \
        'FATAL ERROR: (\(openfoam-[0-9]+\) )?1 of 2 times could not be processed'
says postProcessOther 'Warning.*There are no particles at time 0.05'
[[ -s postProcessing/gauges/0/waterLevel.dat ]] && pass postProcessRow \
    || fail postProcessRow "the good time has no row"
rmdir 0.05
refused postProcessTime 'no written time is selected; there are \(0\)' riprapFoam -postProcess \
    -time 5:99
refused postProcessDry 'Options -dry-run and -postProcess exclude each other' riprapFoam \
    -postProcess -dry-run
control "gauges { type waterLevel; $library points ((0 0 0)); }"
postProcess >log 2>&1
says noScene 'needs a running particle scene'
