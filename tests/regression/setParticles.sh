#!/bin/bash
# setParticles and wall points: counts and masses that can be computed by hand, walls that fill
# space together with the fluid, files that OpenFOAM's utilities accept, and one message for every
# entry that can be wrong.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL setParticles no environment"; exit 1; }
for program in blockMesh setParticles
do
    command -v $program >/dev/null || { echo "FAIL setParticles no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=setParticles
. "$root/tests/regression/setParticlesCases"

# The number behind a pattern in the log, to be within LOW..HIGH
within()    # NAME PATTERN LOW HIGH
{
    local value
    value=$(sed -nE "s/.*$2([-+0-9.e]+).*/\1/p" log | head -1)
    awk -v x="${value:-nan}" -v a="$3" -v b="$4" 'BEGIN {exit !(x + 0 == x && x >= a && x <= b)}' &&
        pass "$1" || fail "$1" "$2 is '$value', not within $3 and $4"
}
fill() { regions "$@"; setParticles >log 2>&1; }

tank='tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); }'

# Placing. 2D: 40 x 20 particles of 5 mm in a tank of 0.2 x 0.1 m
tank2
fill "$tank"
says box2 'tank: 800 particles, volume 0.02 m3 per metre, mass 20 kg per metre'
# rho g times the lowest particle's depth; Tait with c0 = 10 sqrt(2 g H)
within hydrostatic 'highest pressure ' 956.4 956.5
within density 'density up to ' 1004.80 1004.81
fill 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); pressure hydrostatic; '\
'freeSurface 0.2; }'
within freeSurface 'highest pressure ' 1937.4 1937.5
fill 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); pressure zero; }'
says zeroPressure 'highest pressure 0 Pa, density up to 1000 kg'
fill 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); pressure 500; velocity (1 2 0); }'
says numberPressure 'highest pressure 500 Pa'
grep -q '{(1 2 0)}' 0/lagrangian/fluid/U && pass velocity \
    || fail velocity "U is not uniform (1 2 0)"

fill 'a { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); } b { set fluid; source box; '\
'box (0.1 0 0) (0.2 0.1 0.01); }'
says neighbours 'total: 800 particles'
# Hexagonal packing has the same number density: within a row's rounding
sed -i 's/packing square/packing hexagonal/' system/setParticlesDict
regions "${tank/; \}/; clip yes; \}}" hexagonal; setParticles >log 2>&1
within hexagonal2 'tank: ' 740 830
fill 'drop { set fluid; source cylinder; p1 (0.1 0.05 -1); p2 (0.1 0.05 1); radius 0.04; }'
within cylinder2 'drop: ' 195 208                       # pi 8^2 = 201
fill 'drop { set fluid; source sphere; centre (0.1 0.05 0.005); radius 0.04; }'
within sphere2 'drop: ' 195 208
fill 'drop { set fluid; source box; box (-0.1 -0.1 -1) (0.1 0.1 1); clip yes; }'
says clip 'drop: 400 particles'
printf 'x,y,z,u,v,w\n0.05,0.05,0,1,0,0\n0.15,0.05,0,0,1,0\n' >points.csv
fill 'list { set fluid; source csv; file "points.csv"; pressure zero; }'
says csv 'list: 2 particles'
grep -q '(0.15 0.05 0.005' 0/lagrangian/fluid/positions && pass csvMidPlane \
    || fail csvMidPlane "particles are not in the mid-plane"

# Walls. 3 layers behind 40 + 2 x 20 points, two corners of 9
fill "$tank"
says walls2 '^Walls: 258 points'
setParticles -checkWalls >log 2>&1
within shepardLeast2 'least ' 0.999999 1.000001
within shepardMost2 'most ' 0.999999 1.000001
dictionary constant/sphProperties <<<'kernel cubicSpline;'
setParticles -checkWalls >log 2>&1
says shepardCubic2 'over that of a lattice \(0.99[0-9]*\)'
within shepardCubicLeast2 'least ' 0.999999 1.000001
walls 'spacing 0.0025;'
setParticles -checkWalls >log 2>&1
says wallsHalf2 '^Walls: 850 points'
# Sums over lattices of two spacings: up to 2.7 % in corners, though space is filled exactly
within shepardHalfLeast2 'least ' 0.99 1.01
within shepardHalfMost2 'most ' 0.99 1.03
walls ''
channel2
fill "$tank"
says cyclic2 '^Walls: 240 points'
odd2
fill 'tank { set fluid; source box; box (0 0 0) (0.2031 0.1017 0.01); clip yes; }'
says odd2 'wall spacing along \(1 0 0\) from 0.0049537 to 0.005 m'

tank3
fill 'tank { set fluid; source box; box (0 0 0) (0.1 0.06 0.04); }'
says box3 'tank: 1920 particles, volume 0.00024 m3, mass 0.24 kg'
says walls3 '^Walls: 3540 points'
setParticles -checkWalls >log 2>&1
within shepardLeast3 'least ' 0.999999 1.000001
within shepardMost3 'most ' 0.999999 1.000001
octahedron constant/triSurface/octa.stl 1; octahedron constant/triSurface/inverted.stl -1
octahedron constant/triSurface/open.stl 0
fill 'drop { set fluid; source surface; file "octa.stl"; }'
within surface3 'drop: ' 80 91                          # 4/3 r^3 = 85.3 particles, r = 4 spacings
count=$(sed -n 's/.*drop: \([0-9]*\).*/\1/p' log)
fill 'drop { set fluid; source surface; file "inverted.stl"; }'
says surfaceInverted3 "drop: $count particles"
fill 'drop { set fluid; source sphere; centre (0.05 0.03 0.02); radius 0.02; }'
within sphere3 'drop: ' 255 281                         # 4/3 pi 4^3 = 268
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.06 0.04); clip yes; }' hexagonal
setParticles >log 2>&1
within hexagonal3 'tank: ' 1600 2000

# Bodies of constant/geometry: their points inside, no fluid in them
tank2
geometry 'block { type searchableBox; min (0.05 0.02 -1); max (0.08 0.05 1); }'
fill "$tank"
says solidRefused 'are in the solid block of constant/geometry'
fill "${tank/; \}/; clip yes; \}}"
says solidClipped 'tank: 764 particles.* 36 clipped'
says solidWalls 'block: 36 points, nearest two 1 spacings'
geometry 'plate { type searchablePlate; origin (0.1 0 -1); span (0 0.05 2); }'
fill "${tank/; \}/; clip yes; \}}"
says plate 'plate: 40 points'
setParticles -checkWalls >log 2>&1
rm constant/geometry

# Files
fill "$tank"
printf 'x' >0/uniform/stay; mkdir -p 0/uniform/riprap; touch 0/uniform/riprap/sphState
setParticles >log 2>&1
[[ ! -e 0/uniform/riprap/sphState && -e 0/uniform/stay ]] && pass staleState \
    || fail staleState "the state of an earlier run is still there"
rm -r 0; setParticles -dry-run >log 2>&1
[[ ! -e 0/lagrangian ]] && grep -q 'total: 800' log && pass dryRun \
    || fail dryRun "-dry-run wrote, or did not report"
for format in ascii binary
do
    sed -i "s/writeFormat [a-z]*/writeFormat $format/" system/controlDict
    setParticles >log 2>&1; foamToVTK >log 2>&1
    grep -q 'Lagrangian: .*fluid_0.vtp' log && pass foamToVTK.$format \
        || fail foamToVTK.$format "$(grep -m1 -A2 ERROR log)"
    FOAM_SIGFPE=false decomposePar -force >log 2>&1
    [[ -s processor1/0/lagrangian/fluid/coordinates ]] && pass decomposePar.$format \
        || fail decomposePar.$format "no cloud for processor1"
    rm -rf processor* VTK
done
sed -i 's/startFrom startTime/startFrom latestTime/' system/controlDict; mkdir 0.5
rm -rf 0/lagrangian; setParticles >log 2>&1
[[ -e 0/lagrangian/fluid/positions && ! -e 0.5/lagrangian ]] && pass startTime \
    || fail startTime "with startFrom latestTime, particles are not at startTime"
rmdir 0.5
cp system/setParticlesDict system/other; rm system/setParticlesDict
setParticles -dict other >log 2>&1; says otherDict 'total: 800 particles'
setParticles -dict system/other >log 2>&1; says otherDictPath 'total: 800 particles'

# Numbers under names of one's own: used as $name, or from an included file
echo 'wide 0.2; high 0.1; notUsedHere 3;' >system/size
dictionary system/setParticlesDict <<'END'
#include "size"
spacing 0.005;
thick 0.01;
regions ( tank { set fluid; source box; box (0 0 0) ($wide ${high} $:thick); } );
END
setParticles >log 2>&1; says macros 'total: 800 particles'
quiet macrosQuiet 'Warning'
# foamDictionary puts values in their place, and leaves numbers that nothing uses
foamDictionary system/setParticlesDict -entry spacing -set 0.01 >log 2>&1
setParticles >log 2>&1; says macrosReplaced \
    'Warning.*Numbers that nothing uses: \(wide high notUsedHere thick\).*total: 200 particles'

# Particles for the solver that will run, whatever other files are there
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-9; relTol 0; } }'
dictionary constant/picProperties </dev/null
sed -i 's/startFrom latestTime/startFrom startTime/' system/controlDict
regions "$tank"
inControl() { sed -i "s/solver [a-zA-Z]*;/solver $1;/" system/controlDict; }
of()        # SOLVER HOW OPTIONS...
{
    local solver=$1 how=$2 points=no rho=no told=no; shift 2
    rm -rf 0 VTK; setParticles "$@" >log 2>&1
    says "for.$solver.$how" 'total: 800 particles'
    [[ $solver != sphDem ]] || points=yes
    [[ ! -e 0/lagrangian/fluid/rho ]] || rho=yes
    ! grep -q '^Walls:' log || told=yes
    [[ $rho$told == $points$points ]] && pass "for.$solver.$how.fields" \
        || fail "for.$solver.$how.fields" "rho is there: $rho, wall points told: $told"
}
inControl picDem; of picDem control; of sphDem option -solver sphDem
inControl sphDem; of sphDem control; of picDem option -solver picDem
# A surface that the run would refuse, whatever the spacing
geometry 'below { type searchableBox; min (0.05 -0.05 -1); max (0.08 -0.01 1); }'
sed -i 's/; }/; clip yes; }/' system/setParticlesDict
for spacing in 0.0044 0.02
do
    sed -i "s/spacing [0-9.]*;/spacing $spacing;/" system/setParticlesDict
    refused "below.$spacing" 'Surface below of constant/geometry, .*does not meet the mesh, .*: '\
'move it there, or leave it out.*constant/geometry' setParticles -solver picDem
done
rm constant/geometry; regions "$tank"
# With neither file of the other it does not matter; the one that is needed is named
rm constant/picProperties
refused for.picDem 'cannot find file .*constant/picProperties' setParticles -solver picDem

# One message, with the file and what is wrong
bad()       # NAME MESSAGE REGIONS
{
    regions "$3"
    wrong "$1" "$2"
}
wrong() { refused "$1" "$2" setParticles; }
top() { dictionary system/setParticlesDict <<<"$1 regions ( $tank );"; }
top 'packing square;';              wrong noSpacing "spacing' not found.*setParticlesDict"
top 'spacing -1;'
wrong negativeSpacing 'Entry spacing is -1: it must be positive.*setParticlesDict'
top 'spacing 0;';                   wrong zeroSpacing 'Entry spacing is 0: it must be positive'
top 'spacing fine;'
wrong wordSpacing 'fine.*setParticlesDict|setParticlesDict.*fine'
top 'spacing 1e-9;';                wrong tinySpacing 'is it meant|is the spacing meant'
top 'spacing 0.005; packing cubic;'
wrong packing 'packing has the unknown word cubic; valid are .*square hexagonal.*setParticlesDict'
top 'spacing 5mm;'
wrong unitSpacing 'spacing.*setParticlesDict|setParticlesDict.*spacing'
top 'spacing 0.005; spaceing 0.01;'
wrong unknownNumber 'Unknown entry spaceing; valid are .*spacing packing regions.*setParticlesDict'
top 'spacing 0.005; // $spaceing
spaceing 0.01;';                    wrong unknownNumberComment 'Unknown entry spaceing'
top 'spacing 0.005; spaceing wide;'
wrong unknownEntry 'Unknown entry spaceing; valid are .*spacing packing regions.*setParticlesDict'
top 'spacing { }'
wrong spacingDict 'Entry spacing must be a value, not a dictionary.*setParticlesDict'
top 'spacing 0.005; overlapTolerance 0;'
wrong solidsEntry 'Unknown entry overlapTolerance; valid are .*spacing packing regions'
top 'spacing 1e-9;'; sed -i 's/; }/; clip yes; }/' system/setParticlesDict; walls 'patches ();'
wrong tinySpacingClipped 'would hold about .*is the spacing meant'
walls ''
dictionary system/setParticlesDict <<<"spacing 0.005; regions { $tank }"
wrong regionsDict 'Entry regions must be a value'
dictionary system/setParticlesDict <<<'spacing 0.005; regions all;'
wrong regionsWord "word 'all'.*setParticlesDict.regions"
dictionary system/setParticlesDict <<<'spacing 0.005;'; wrong noRegions "regions.*setParticlesDict"
bad emptyRegions 'Entry regions is empty' ''
bad regionNoDict 'setParticlesDict' 'a b;'
bad noSet "set' not found" 'a { source box; box (0 0 0) (0.2 0.1 0.01); }'
bad set 'set has the unknown word solid; valid are .*fluid.*setParticlesDict' \
    'a { set solid; source box; box (0 0 0) (0.2 0.1 0.01); }'
bad setNear 'set has the unknown word solid; valid are .fluid solids.; did you mean solids\?' \
    'a { set solid; source box; box (0 0 0) (0.2 0.1 0.01); }'
bad setDict 'Entry set must be a value.*regions.a' 'a { set { } }'
bad noSource "source' not found" 'a { set fluid; box (0 0 0) (0.2 0.1 0.01); }'
bad source 'source has the unknown word cone; valid are .*box csv cylinder sphere surface' \
    'a { set fluid; source cone; }'
bad noBox "box.*setParticlesDict" 'a { set fluid; source box; }'
bad flatBox 'Entry box has no volume' 'a { set fluid; source box; box (0 0 0) (0.2 0 0.01); }'
bad boxDict 'Entry box must be a value' 'a { set fluid; source box; box { } }'
bad wordBox 'setParticlesDict' 'a { set fluid; source box; box big; }'
bad longBox 'setParticlesDict' 'a { set fluid; source box; box (0 0 0) (0.2 0.1 0.01) 3; }'
bad radius 'Entry radius is -1: it must be positive' \
    'a { set fluid; source cylinder; p1 (0 0 0); p2 (0 0 1); radius -1; }'
bad noLength 'Entries p1 and p2 are the same' \
    'a { set fluid; source cylinder; p1 (0 0 1); p2 (0 0 1); radius 1; }'
bad noP2 "p2' not found" 'a { set fluid; source cylinder; p1 (0 0 1); radius 1; }'
bad sphereRadius "radius' not found" 'a { set fluid; source sphere; centre (0 0 0); }'
bad sphereCentre "centre' not found" 'a { set fluid; source sphere; radius 1; }'
bad noFile "file' not found" 'a { set fluid; source surface; }'
bad missingFile 'there is no .*nothing.stl.; constant/triSurface holds .*octa.stl' \
    'a { set fluid; source surface; file "nothing.stl"; }'
bad openSurface 'open.stl. is not closed' 'a { set fluid; source surface; file "open.stl"; }'
echo junk | tee constant/triSurface/junk.stl >constant/triSurface/junk.xyz
bad emptyFile 'there is no .*; constant/triSurface holds .*octa.stl' \
    'a { set fluid; source surface; file ""; }'
bad junkFile 'Entry file: .*junk.stl. cannot be read as a surface.*setParticlesDict' \
    'a { set fluid; source surface; file "junk.stl"; }'
bad junkType 'Entry file: .*junk.xyz. cannot be read as a surface: unknown file extension' \
    'a { set fluid; source surface; file "junk.xyz"; }'
bad scale 'Entry scale is 0: it must be positive' \
    'a { set fluid; source surface; file "octa.stl"; scale 0; }'
bad csvMissing 'there is no .*nothing.csv' 'a { set fluid; source csv; file "nothing.csv"; }'
csv() { printf "$2" >bad.csv; bad "$1" "$3" 'a { set fluid; source csv; file "bad.csv"; }'; }
csv csvHeader '1,2,3\n' "line 1 .*the header is '1,2,3', not x,y,z"
csv csvShort 'x,y,z\n0.1,0.05,0\n0.1,0.05\n' 'line 3 .*2 values, not 3'
csv csvWord 'x,y,z\n0.1,half,0\n' "line 2 .*'half' is no number"
csv csvNaN 'x,y,z\n0.1,nan,0\n' "line 2 .*'nan' is no number"
csv csvNaNPressure 'x,y,z,u,v,w,p\n0.1,0.05,0,0,0,0,-nan\n' "line 2 .*'-nan' is no number"
csv csvColumns 'x,x,y\n0.1,0.05,0\n' "the header is 'x,x,y', not x,y,z"
csv csvEmpty 'x,y,z\n' 'Region a holds no particle'
csv csvTwice 'x,y,z\n0.1,0.05,0\n0.1,0.05,0\n' 'Regions a and a overlap at \(0.1 0.05'
box='source box; box (0 0 0) (0.2 0.1 0.01);'
bad velocity 'setParticlesDict' "a { set fluid; $box velocity fast; }"
bad pressure 'pressure has the unknown word high; valid are .*hydrostatic zero <number>' \
    "a { set fluid; $box pressure high; }"
bad pressureVector 'pressure has the unknown word .*; valid are \(hydrostatic zero <number>\)' \
    "a { set fluid; $box pressure (0 1); }"
bad pressureDeep 'Entry pressure: -1000000 Pa at .* is beyond what the equation of state' \
    "a { set fluid; $box pressure -1e6; }"
bad pressureHigh 'Entry pressure: 1000000000 Pa at .*guards/densityDeviation' \
    "a { set fluid; $box pressure 1e9; }"
bad freeSurfaceUnused 'Entry freeSurface is used by pressure hydrostatic alone' \
    "a { set fluid; $box pressure zero; freeSurface 0.1; }"
bad freeSurface 'setParticlesDict' "a { set fluid; $box freeSurface top; }"
bad clipWord 'clip has the unknown word maybe; valid are .*yes no' \
    "a { set fluid; $box clip maybe; }"
bad unknownInRegion 'Unknown entry colour; valid are .*velocity.*setParticlesDict' \
    "a { set fluid; $box colour blue; }"
bad outside 'Region a: 160 of 960 particles are outside the mesh, the first at \(' \
    'a { set fluid; source box; box (0 0 0) (0.24 0.1 0.01); }'
bad offPlane 'Region a holds no particle\. The mesh is .*mid-plane must be in the region' \
    'a { set fluid; source box; box (0 0 1) (0.2 0.1 2); }'
bad clippedAway 'Region a holds no particle after clipping' \
    'a { set fluid; source box; box (1 0 0) (2 0.1 1); clip yes; }'
bad overlap 'Regions a and b overlap at \(' "a { set fluid; $box } b { set fluid; source cylinder; \
p1 (0.1 0.05 0); p2 (0.1 0.05 1); radius 0.02; }"
bad twice 'two are named a' "a { set fluid; source box; \
box (0 0 0) (0.1 0.1 0.01); } a { set fluid; source box; box (0.1 0 0) (0.2 0.1 0.01); }"
regions "$tank"
walls 'patches (lower nowhere);'
wrong wallPatch 'no patch nowhere that can be a wall; valid ones are .*left right lower upper'
walls 'patches (fb);';              wrong wallEmpty 'no patch fb that can be a wall'
walls ''
wrongGeometry() { geometry "$3"; wrong "$1" "$2"; rm constant/geometry; }
wrongGeometry geometryType 'Unknown type torus of a; valid types are .*searchableBox' \
    'a { type torus; }'
wrongGeometry geometrySide 'Unknown solidSide left; valid ones are .*inside outside both' \
    'a { type searchableSphere; centre (0.1 0.05 0); radius 0.02; solidSide left; }'
wrongGeometry geometryOpen 'no closed surface: only both' \
    'a { type searchablePlate; origin (0.1 0 -1); span (0 0.05 2); solidSide inside; }'
wrongGeometry geometryAway 'does not meet the mid-plane' \
    'a { type searchableSphere; centre (0.1 0.05 1); radius 0.02; }'
wrongGeometry geometryInverted 'point into it: run surfaceOrient' \
    'inverted.stl { type triSurfaceMesh; name inverted; }'
wrongGeometry geometryFile 'nothing.stl' 'nothing.stl { type triSurfaceMesh; }'
wrongGeometry geometryNoDict \
    'Entry a is no dictionary: each surface needs one with its type.*constant/geometry' 'a sphere;'
wrongGeometry geometryNoType "'type' not found.*geometry.a" 'a { radius 1; }'
wrongGeometry geometryEntry 'Unknown entry solidSied; valid are .*radius .*solidSide' \
    'a { type sphere; centre (0.1 0.05 0); radius 0.02; solidSied both; }'
wrongGeometry geometryRadius 'Entry radius is -1: it must be positive.*geometry.a' \
    'a { type sphere; centre (0.1 0.05 0); radius -1; }'
wrongGeometry geometryRadiusZero 'Entry radius is 0: it must be positive' \
    'a { type disk; origin (0.1 0.05 0); normal (1 0 0); radius 0; }'
wrongGeometry geometryNoRadius "'radius' not found" 'a { type sphere; centre (0.1 0.05 0); }'
wrongGeometry geometryNormal 'Entry normal is the null vector' \
    'a { type disk; origin (0.1 0.05 0); normal (0 0 0); radius 1; }'
wrongGeometry geometryBox 'Entries min and max are .*nothing between' \
    'a { type box; min (0.1 0.05 1); max (0.05 0.02 -1); }'
wrongGeometry geometryCylinder 'Entries point1 and point2 are .*nothing between' \
    'a { type cylinder; point1 (0 0 1); point2 (0 0 1); radius 1; }'

# What is not there
cp system/setParticlesDict aside; rm system/setParticlesDict
wrong noDictionary 'cannot find file .*system/setParticlesDict'
refused noOtherDictionary 'cannot find file .*system/nothing' setParticles -dict nothing
mv aside system/setParticlesDict; mv constant/polyMesh/points aside
wrong noMesh 'Cannot find file .points.'
mv aside constant/polyMesh/points
sed -i 's/writeInterval 0.1/writeInterval 0/' system/controlDict
wrong writeInterval 'Entry writeInterval is 0: it must be positive.*controlDict'
