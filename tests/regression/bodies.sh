#!/bin/bash
# Rigid bodies as users have them: mass, centre and inertia of boxes, disks, balls and surfaces
# against closed forms whatever their particles are, water that is cut at them, hinges, guides,
# springs and moorings, and one message for every entry that can be wrong.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL bodies no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL bodies no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=bodies
. "$root/tests/regression/setParticlesCases"

# The number behind a pattern in the log, to be within LOW..HIGH
within()    # NAME PATTERN LOW HIGH
{
    local value
    value=$(oneLine | sed -nE "s/.*$2([-+0-9.e]+).*/\1/p" | head -1)
    awk -v x="${value:-nan}" -v a="$3" -v b="$4" 'BEGIN {exit !(x + 0 == x && x >= a && x <= b)}' \
        && pass "$1" || fail "$1" "$2 is '$value', not within $3 and $4"
}
last()      # OBJECT COLUMN: its last value
{
    awk -v c="$2" '/^#/ {for (i = 2; i <= NF; ++i) if ($i == c) k = i - 1; next} {x = $k}
            END {print x}' postProcessing/"$1"/*/*.dat
}
# The same, to be within LOW..HIGH
column()    # NAME OBJECT COLUMN LOW HIGH
{
    local value
    value=$(last "$2" "$3")
    awk -v x="${value:-nan}" -v a="$4" -v b="$5" 'BEGIN {exit !(x + 0 == x && x >= a && x <= b)}' \
        && pass "$1" || fail "$1" "$3 is '$value', not within $4 and $5"
}
solids()    # MORE ENTRIES of solidProperties
{
    dictionary constant/solidProperties \
        <<<"device cpu; materials { wood { rho 500; E 1e7; nu 0.25; } }
contact { normal linear; } pairs { default { restitution 0.5; friction 0.3; \
stiffness 1e5; } } walls { material wood; patches (); } $1"
}
control()   # SOLVER END MORE
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom latestTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-5; adjustTimeStep yes; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval $2; writeFormat ascii; writePrecision 12; $3"
}
fill()      # REGIONS [SPACING of the water]
{
    dictionary system/setParticlesDict <<<"${2:+spacing $2;} regions ( $1 );"
    rm -rf 0 0.* postProcessing; setParticles >log 2>&1
}
run() { riprapFoam >log 2>&1 && pass "$1" || fail "$1" "$(oneLine | grep -o 'FATAL.\{0,300\}')"; }
motion='functions { motion { type groupMotion; libs ("libriprapFoam.so"); } }'
turning='functions { motion { type groupMotion; libs ("libriprapFoam.so"); rotation yes; } }'
lines='functions { motion { type groupMotion; '\
'libs ("libriprapFoam.so"); } lines { type springForces; libs ("libriprapFoam.so"); } }'

# Mass, centre, inertia. The lattice of 6 x 6 disks of 5 mm in 0.065 x 0.06 m holds 0.92 of the box
tank2; solids ''; control dem 0.1 ''
wood='set solids; material wood; rigid yes;'
box="$wood source box; box (0.05 0.02 0) (0.115 0.08 0.01); radius 0.005;"
fill "block { $box }"
says box2 'one rigid body, mass 1\.95 kg per metre, centre \(0\.0825 0\.05 0\.005\), '\
'.* \(0 0 0\.00127156\) kg m2 per metre, volume 0\.0039 m3 per metre; '\
'the cells of its particles are 0\.923077 of it'
says boxTotal 'block: 36 particles, radius 0\.005 m, mass 1\.95 kg per metre, 1 clumps'
fill "block { $box mass cell; }"
says boxCell2 'one rigid body, mass 1\.95 kg'
fill "block { $box density 800; }"
says boxDensity2 'mass 3\.12 kg per metre, .*volume 0\.0039 m3'
fill "block { $box mass 3; centreOfMass (0.09 0.04 0); inertia 0.01; }"
says boxGiven2 \
    'mass 3 kg per metre, centre \(0\.09 0\.04 0\.005\), principal moments of inertia \(0 0 0\.01\)'
riprapFoam -dry-run >log 2>&1
says boxLog \
    'rigid body +group free, mass 3 kg per metre, centre \(0\.09 0\.04 0\.005\), principal '\
'moments of inertia 0\.01 kg m2 per metre, volume 0\.0039 m3 per metre, 769\.23[0-9]* kg/m3'
disk="$wood source cylinder; p1 (0.1 0.05 -1); p2 (0.1 0.05 1); radius 0.03;"
fill "disk { $disk spacing 0.005; }"
# rho pi R^2, m R^2/2
says disk2 'mass 1\.41372 kg per metre, centre \(0\.1 0\.05 0\.005\), .* \(0 0 0\.000636173\)'
says diskCount2 'disk: 113 particles'                   # pi R^2/spacing^2 = 113.1
# In layers: the outermost all at half a spacing from the surface, so that some 2 pi (R - s/2)/s =
# 34.6 are
awk '/^\([0-9]/ {gsub(/[()]/, ""); r = sqrt(($1 - 0.1)^2 + ($2 - 0.05)^2);
        if (r > 0.0274 && r < 0.0276) ++n; if (r > 0.0276) ++out}
    END {exit !(n >= 30 && n <= 38 && !out)}' 0/lagrangian/solids/positions && pass diskLayer2 \
    || fail diskLayer2 "no layer at half a spacing from the disk's surface"
fill "disk { $disk spacing 0.005; packing square; }"
says diskSquare2 'mass 1\.41372 kg per metre'
octahedron constant/triSurface/octa.stl 1
cut="$wood source surface; file \"octa.stl\"; spacing 0.0005;"
fill "cut { $cut }"
# at 5 mm a square of half diagonal 5 mm, m d^2/3
says section2 'mass 0\.025 kg per metre, centre \(0\.05 0\.03 0\.005\), .* \(0 0 2\.08333e-07\)'

tank3; solids ''; control dem 0.1 ''
fill "rock { $wood source surface; file \"octa.stl\"; spacing 0.004; }"
# rho 4/3 r^3, m r^2/5
says surface3 'mass 0\.00533333 kg, centre \(0\.05 0\.03 0\.02\), '\
'.*\(4\.26667e-07 4\.26667e-07 4\.26667e-07\) kg m2, volume 1\.06667e-05 m3'
printf 'x,y,z\n0.05,0.03,0.02\n0.06,0.03,0.02\n' >rock.csv
fill "rock { $wood source csv; file \"rock.csv\"; radius 0.004; surface { source surface; \
file \"octa.stl\"; } }"
says listed3 'mass 0\.00533333 kg, centre \(0\.05 0\.03 0\.02\), '\
'.*\(4\.26667e-07 4\.26667e-07 4\.26667e-07\) kg m2, volume 1\.06667e-05 m3 rock: 2 particles'
sed -n '/^shapes/,/^}/p' 0/uniform/lagrangian/solids/cloudProperties | grep -q 'octa.stl' \
    && pass listedShape3 || fail listedShape3 "picDem is not told the surface"
# Turned axes: its faces are where its particles are, and those must follow them
fill "rock { $wood source surface; file \"octa.stl\"; spacing 0.004; }"
awk 'BEGIN {print "x,y,z"} /^\([0-9]/ {gsub(/[()]/, ""); print $1 "," $2 "," $3}' \
    0/lagrangian/solids/positions >rock.csv
pool='pool { set fluid; source box; box (0 0 0) (0.1 0.06 0.01); clip yes; }'
rock="$wood source csv; file \"rock.csv\"; radius 0.002; inertia (2e-5 1e-5 0 2e-5 0 2e-5);"
fill "$pool rock { $rock surface { source surface; file \"octa.stl\"; } }" 0.005
says covered3 'Written [0-9]+ particles, 0 bonds and 1 clumps'
sed -i '/^0.06/d' rock.csv
dictionary system/setParticlesDict <<<"spacing 0.005; \
regions ( $pool rock { $rock surface { source surface; file \"octa.stl\"; } } );"
refused uncovered3 'Region rock: '\
'no particle of the list is within 0\.007 m of its entry surface at \(0\.0[67]' setParticles
fill "ball { $wood source sphere; centre (0.05 0.03 0.02); radius 0.015; spacing 0.003; }"
says sphere3 'mass 0\.00706858 kg, .*\(6\.36173e-07 6\.36173e-07 6\.36173e-07\)'
says sphereCount3 'ball: 524 particles'                 # 4/3 pi 5^3
fill "log { $wood source cylinder; p1 (0.02 0.03 0.02); p2 (0.08 0.03 0.02); radius 0.01; \
spacing 0.004; }"
says cylinder3 'mass 0\.00942478 kg, centre \(0\.05 0\.03 0\.02\)'
fill "block { $wood source box; box (0 0 0) (0.02 0.03 0.04); spacing 0.01; \
inertia (1e-5 2e-5 2.5e-5); mass 0.1; }"
says box3 'mass 0\.1 kg, .*\(1e-05 2e-05 2\.5e-05\)'
fill "block { $wood source box; box (0 0 0) (0.02 0.03 0.04); spacing 0.01; \
inertia (2e-5 1e-5 0 2e-5 0 2e-5); }"
says boxTensor3 'principal moments of inertia \((1e-05|3e-05|2e-05) '

# A cube turns about any axis alike: by spin t, in degrees
fill "block { $wood group free; source box; box (0.02 0.03 0.01) (0.04 0.05 0.03); spacing 0.005; \
spin (1 2 -2); }"
control dem 0.05 "$turning"; run turns3
for c in X:1 Y:2 Z:-2
do
    column "turns3${c%:*}" motion "freeRotation${c%:*}" \
        $(awk -v w="${c#*:}" 'BEGIN {a = w*2.864789; print a - 1e-3, a + 1e-3}')
done
rm -rf 0.* postProcessing

# A hinge: small swings of a rod about its end, 2 pi sqrt(2 L/(3 g)) = 0.5184 s for L = 0.1 m: after
# a quarter it hangs down
bigger() { block 0.4 0.4 0.01 '4 4 1' "$sides $lower $open $flat"; }
bigger
rod="$wood group rod; source box; box (0.2 0.1 0) (0.204 0.2 0.01); spacing 0.004;"
solids 'groups { rod { constrain { hinge { point (0.202 0.2 0); } } } }'
fill "rod { $rod spin (0 0 0.2); }"
control dem 0.2592 "$turning"
run hinge
# How it has turned, by where its centre is
turned()    # NAME
{
    awk '/^#/ {for (i = 2; i <= NF; ++i) {if ($i ~ /CentreX/) x = i - 1;
            if ($i ~ /CentreY/) y = i - 1; if ($i ~ /RotationZ/) r = i - 1}; next}
        {a = atan2($x - 0.202, 0.2 - $y)*45/atan2(1, 1); d = a - $r;
            if (d*d > 1e-10) bad = bad " " $1; if (a > most) most = a; ++n}
        END {if (!n || bad || most < 0.9) {print n + 0, "rows, most " most ", wrong at" bad;
            exit 1}}' postProcessing/motion/*/groupMotion.dat >turned && pass "$1" \
        || fail "$1" "$(cat turned)"
}
turned hingeTurns
# w0/w sin(w T/2) = 0; the end goes round the hinge
column hingeBack motion rodCentreX 0.20195 0.20205
column hingeRadius motion rodCentreY 0.1499 0.1501
rm -rf 0.* postProcessing; control dem 0.1296 "$motion"; run hingeQuarter
# 0.2/12.12 rad at L/2, and the sine's turn
column hingeSwings motion rodCentreX 0.20281 0.20284
# A continued run counts from the first start, and -postProcess from the time it begins with
rm -rf 0.* postProcessing; control dem 0.06 "$turning"; riprapFoam >log 2>&1
control dem 0.1296 "$turning"; run hingeGoesOn
turned hingeTurnsOn
says hingeLog 'constrain +group rod: hinge about \(0 0 1\) through \(0\.202 0\.2 0\)'

# Several bodies have no rotation of their own
fill "rod { $rod } other { $wood group rod; source box; box (0.1 0.1 0) (0.12 0.12 0.01); \
spacing 0.004; }"
solids 'groups { rod {} }'; control dem 0.1 "$turning"
refused rotationOfTwo 'Entry rotation: group rod of solids is several bodies' riprapFoam

# Guided alike by `fixed` and by `constrain`: the same motion
block_="$wood group guided; source box; box (0.1 0.1 0) (0.12 0.12 0.01); spacing 0.004; \
spin (0 0 0);"
for how in 'fixed (x spin);' 'constrain { line (0 1 0); orientation fixed; }'
do
    solids "groups { guided { $how force (1 0 0); } }"
    fill "block { $block_ }"; control dem 0.1 "$motion"; riprapFoam >log 2>&1
    column "guided.${how%% *}" motion guidedCentreY 0.0609499 0.0609501      # 0.11 - g t^2/2
    column "guidedX.${how%% *}" motion guidedCentreX 0.1099999 0.1100001
done

# A spring and a mooring: static offset m g/k; restart knows the body's point
solids 'groups { guided { viscousDamping 20; springs { up { anchor (0.11 0.3 0); '\
'point (0.11 0.12 0); stiffness 100; damping 5; restLength 0.15; } } } }'
fill "block { $block_ }"; control dem 1.2 "$lines"; run spring
column springTension lines guided.upTension 1.95 1.97           # m g
column springForce lines guided.upFy 1.95 1.97
column springOffset motion guidedCentreY 0.12033 0.12043        # 0.3 - 0.15 - 0.01 - 0.2 9.81/100
says springLog 'spring +guided\.up: anchor \(0\.11 0\.3 0\), point .*stiffness 100 N/m'
solids 'groups { guided { viscousDamping 20; moorings { up { anchor (0.11 0.3 0); '\
'point (0.11 0.12 0); stiffness 100; length 0.15; } } } }'
rm -rf 0.* 1.* postProcessing; control dem 0.6 "$motion"; run mooring
control dem 1.2 "$motion"; rm -rf 0.6/uniform/riprap; run mooringRestart
column mooringOffset motion guidedCentreY 0.12033 0.12043
rm -rf 0.* 1.* postProcessing

# Water cut at a disk: as many particles go as its volume takes, and the rest follows it
bigger; control sphDem 0.01 ''
dictionary constant/sphProperties <<<'device cpu;'
solids ''
pond='water { set fluid; source box; box (0 0 0) (0.4 0.2 0.01); clip yes; }'
round="$wood source cylinder; p1 (0.2 0.1 -1); p2 (0.2 0.1 1); radius 0.05; spacing 0.01;"
for order in "$pond body { $round }" "body { $round } $pond"
do
    fill "$order" 0.01
    # pi 5^2 = 78.5
    says clipDisk 'water: cut at solids, '\
'79 particles of 0\.0079 m3 per metre for 0\.00785[0-9]* of the bodies in it'
    says clipLeft 'water: 721 particles'                  # 800 - 79
done
awk '/^\([0-9]/ {gsub(/[()]/, ""); r = sqrt(($1 - 0.2)^2 + ($2 - 0.1)^2);
        if (r > 0.0549 && r < 0.0552) ++n; if (r < 0.0549) ++in_}
    END {exit !(n >= 30 && n <= 38 && !in_)}' 0/lagrangian/fluid/positions && pass clipLayer \
    || fail clipLayer "no layer at half a spacing from the disk"
run clipRuns
says clipLog 'rigid body +group free, mass 3\.92699 kg per metre'
# Half under water: half of it goes
fill "$pond body { ${round//0.1 /0.2 } }" 0.01
# pi 5^2/2 = 39.27
says clipHalf 'water: cut at solids, (39|40) particles .* for 0\.003927[0-9]* of the bodies'
# A lattice that fits stays
fill "$pond body { $wood source box; box (0.1 0.1 0) (0.2 0.15 0.01); spacing 0.01; }" 0.01
says clipBox 'water: cut at solids, 50 particles of 0\.005 m3 per metre for 0\.005 of the bodies'
grep -q '(0.095 0.105 ' 0/lagrangian/fluid/positions && pass clipStays \
    || fail clipStays "a lattice that fits the box has been moved"
# Of particles as near to its left as to its right side some go from either: half the box stands in
# the water, with columns of particles on both its sides
fill "$pond body { $wood source box; box (0.145 0.15 0) (0.255 0.25 0.01); spacing 0.01; }" 0.01
says clipSides 'water: cut at solids, 55 particles'
awk '/^\([0-9]/ {gsub(/[()]/, ""); if ($1 < 0.2) ++left; else ++right}
    END {print left, right; exit !(right - left <= 1 && left - right <= 1)}' \
    0/lagrangian/fluid/positions >sides \
    && pass clipEven || fail clipEven "left and right: $(<sides)"
printf 'x,y,z\n0.2,0.1,0\n' >list.csv
fill "$pond body { set solids; material wood; source csv; file \"list.csv\"; radius 0.005; }" 0.01
says clipList 'water: cut at solids body, [0-9]+ particles .*without layers'
# A hollow ring of particles from a list, 28 of them: water thrown at it gets in between them, but
# not through its surface
awk 'BEGIN {print "x,y,z"; for (i = 0; i < 28; ++i) {a = 6.2831853*i/28;
        printf "%.9g,%.9g,0\n", 0.2 + 0.045*cos(a), 0.1 + 0.045*sin(a)}}' >ring.csv
shot='water { set fluid; source box; box (0.16 0.2 0) (0.24 0.3 0.01); velocity (0 -8 0); '\
'pressure zero; }'
list="$wood source csv; file \"ring.csv\"; radius 0.005;" round='surface { source cylinder; '\
'p1 (0.2 0.1 -1); p2 (0.2 0.1 1); radius 0.05; }'
control sphDem 0.06 ''; sed -i 's/writeInterval 0.06/writeInterval 0.03/' system/controlDict
solids 'groups { held { fixed all; } }'
throw()     # NAME GROUP SURFACE: how many particles are inside at the end
{
    fill "$shot ring { $list group $2; $3 }" 0.01
    cp log made; run "$1"
    wet=$(awk '/^\([0-9]/ {gsub(/[()]/, ""); n += ($1 - 0.2)^2 + ($2 - 0.1)^2 < 0.049^2}
        END {print n + 0}' 0.06/lagrangian/fluid/positions)
}
throw ringOpen held ''
((wet > 0)) && pass ringLeaks \
    || fail ringLeaks "no water is in the ring without a surface: this test says nothing"
says ringOpenLog 'impermeable +0 of 1 rigid bodies'
throw ringClosed held "$round"
((wet == 0)) && pass ringHolds || fail ringHolds "$wet particles of water are in the ring"
says ringLog 'impermeable +1 of 1 rigid bodies'
cp 0.06/lagrangian/fluid/positions fluid; rm -r 0.06; riprapFoam >log 2>&1
says ringContinues 'Continuing exactly from time 0.03'
cmp -s fluid 0.06/lagrangian/fluid/positions && pass ringRestart \
    || fail ringRestart "other positions"
cp made log
# rho pi R^2, m R^2/2
says ringMass 'one rigid body, mass 3\.92699 kg per metre, centre \(0\.2 0\.1 0\.005\), '\
'.* \(0 0 0\.00490874\) .* volume 0\.00785398 m3'
grep -q outline 0/uniform/lagrangian/solids/cloudProperties && pass ringShape \
    || fail ringShape "picDem is not told the shape"
solids ''; fill "$pond ring { $list density 800; $round }" 0.01
says ringClips 'water: cut at solids, 79 particles of 0\.0079 m3'
says ringDensity 'mass 6\.28319 kg per metre'
wrongRing()
{
    dictionary system/setParticlesDict <<<"spacing 0.01; regions ( $pond ring { $list $3 } );"
    refused "$1" "$2.*setParticlesDict" setParticles
}
wrongRing surfaceOutside 'Entry surface does not hold the particles of region ring: '\
'the centres of 28 of 28 are outside of it, that at .* by 0\.005' "${round/radius 0.05/radius 0.04}"
wrongRing surfaceFar 'Region ring: no particle of the list is within 0\.015 m of its entry '\
'surface at .* water would get in' "${round/radius 0.05/radius 0.08}"
wrongRing surfaceValue 'Entry surface must be a dictionary' 'surface "hull.stl";'
wrongRing surfaceEmpty "'source' not found" 'surface { }'
wrongRing surfaceWord 'Entry source has the unknown word csv; '\
'valid are .box cylinder sphere surface' 'surface { source csv; file "ring.csv"; }'
wrongRing surfaceEntry 'Unknown entry spacing' "${round/radius/spacing 0.01; radius}"
wrongRing surfaceFile 'Entry file: there is no .*nothing.stl.; constant/triSurface holds' \
    'surface { source surface; file "nothing.stl"; }'
octahedron constant/triSurface/open.stl 0
wrongRing surfaceOpen 'Entry file: the surface .*open.stl. is not closed' \
    'surface { source surface; file "open.stl"; }'
dictionary system/setParticlesDict \
    <<<"spacing 0.01; regions ( $pond ring { ${list/rigid yes;/} $round } );"
refused surfaceLoose 'Unknown entry surface' setParticles
dictionary system/setParticlesDict <<<"spacing 0.01; regions ( $pond ring { \
${list/source csv; file \"ring.csv\"; radius 0.005;/source box; box (0.1 0.1 0) (0.2 0.2 0.01); \
spacing 0.01;} \
$round } );"
refused surfaceOfBox 'Unknown entry surface' setParticles
sed 's/$/,0.1/; 1 s/0.1/mass/' ring.csv >heavy.csv
wrongRing surfaceMass 'the mass of its entry surface, and its list has a column mass' \
    "file \"heavy.csv\"; $round"
sed 's/$/,wood/; 1 s/wood/material/; 5 s/wood/lead/' ring.csv >mixed.csv
sed -i 's/wood { rho 500; E 1e7; nu 0.25; }/& lead { rho 11000; E 1e7; nu 0.25; }/' \
    constant/solidProperties
wrongRing surfaceMaterials 'its list has materials of different density' \
    "file \"mixed.csv\"; $round"
fill "$pond ring { $list file \"mixed.csv\"; mass 2; $round }" 0.01
says ringMixed 'one rigid body, mass 2 kg per metre'
solids ''
# A hinged flap in water turns about its hinge; guided alike by two ways in sphDem
solids 'groups { flap { constrain { hinge { point (0.2 0.15 0); } } } }'
fill "$pond flap { $wood group flap; source box; box (0.19 0.05 0) (0.21 0.15 0.01); \
spacing 0.01; }" 0.01
control sphDem 0.05 "$motion"; run flap
awk -v x="$(last motion flapCentreX)" -v y="$(last motion flapCentreY)" \
    'BEGIN {r = sqrt((x - 0.2)^2 + (y - 0.15)^2); exit !(r > 0.0499999 && r < 0.0500001)}' \
    && pass flapRadius ||
    fail flapRadius "the flap has left its hinge"
rm -f list
for how in 'fixed (x spin);' 'constrain { line (0 1 0); orientation fixed; }'
do
    solids "groups { guided { $how } }"
    fill "$pond float { $wood group guided; source box; box (0.15 0.15 0) (0.25 0.25 0.01); \
spacing 0.01; }" 0.01
    riprapFoam >log 2>&1 || fail heave "$(oneLine | grep -o 'FATAL.\{0,300\}')"
    last motion guidedCentreY >>list
done
awk 'NR == 1 {a = $1} {b = $1} END {d = a - b;
        exit !(NR == 2 && d < 1e-7 && d > -1e-7 && a != 0.2)}' list && pass heave \
    || fail heave "fixed and constrain give other motions: $(cat list)"

# The same in picDem: a flap on its hinge, and what moves up and down alone
bigger; dictionary constant/picProperties <<<'device cpu; precision double;'
rm constant/sphProperties
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-9; } }'
grid='water { set fluid; source box; box (0 0 0) (0.4 0.2 0.01); pressure zero; }'
sed -i 's/(4 4 1)/(40 40 1)/' system/blockMeshDict; rm -rf constant/polyMesh; blockMesh >log 2>&1
solids 'groups { flap { constrain { hinge { point (0.2 0.2 0); } } } }'
control picDem 0.05 "$motion"
fill "$grid flap { $wood group flap; source box; box (0.17 0.1 0) (0.23 0.2 0.01); spacing 0.01; \
spin (0 0 1); }" 0.005
run picFlap
awk -v x="$(last motion flapCentreX)" \
    -v y="$(last motion flapCentreY)" 'BEGIN {r = sqrt((x - 0.2)^2 + (y - 0.2)^2);
        exit !(r > 0.0499999 && r < 0.0500001 && x != 0.2)}' && pass picFlapRadius ||
    fail picFlapRadius "the flap has left its hinge, or does not move: $(last motion flapCentreX)"
rm -f list
for how in 'fixed (x spin);' 'constrain { line (0 1 0); orientation fixed; }'
do
    solids "groups { guided { $how } }"
    fill "$grid float { $wood group guided; source box; box (0.15 0.12 0) (0.25 0.22 0.01); \
spacing 0.01; }" 0.005
    riprapFoam >log 2>&1 || fail picHeave "$(oneLine | grep -o 'FATAL.\{0,300\}')"
    last motion guidedCentreY >>list
done
awk 'NR == 1 {a = $1} {b = $1} END {d = a - b;
        exit !(NR == 2 && d < 1e-7 && d > -1e-7 && a > 0.1701)}' list && pass picHeave \
    || fail picHeave "fixed and constrain give other motions: $(cat list)"
rm constant/picProperties; dictionary constant/sphProperties <<<'device cpu;'

# A body on the floor has no water under it, and one a spacing above has
solids ''
sed -i 's/walls { material wood; patches (); }/walls { material wood; }/' constant/solidProperties
control sphDem 0.01 ''
fill "$pond body { $wood source box; box (0.1 0 0) (0.2 0.05 0.01); spacing 0.01; }" 0.01
says standing 'Region body stands 0 m off a wall, less than the water.s spacing of 0\.01 m: '\
'there is no water in between'
fill "$pond body { $wood source box; box (0.1 0.01 0) (0.2 0.06 0.01); spacing 0.01; }" 0.01
quiet floats 'off a wall'

# What is refused
control dem 0.1 ''; solids ''
bad()
{
    dictionary system/setParticlesDict <<<"regions ( a { $3 } );"
    refused "$1" "$2" setParticles
}
bad massWord 'Entry mass is particle, but the body is rigid: it has the mass of its region' \
    "$box mass particle;"
bad massTwice 'Entries mass and density are both there' "$box mass 1; density 2;"
bad massZero 'Entry mass is 0: it must be positive' "$box mass 0;"
bad density 'Entry density is -1: it must be positive' "$box density -1;"
bad inertia2 'Entry inertia is -1: it must be positive' "$box inertia -1;"
bad loose 'Unknown entry density' "${box/rigid yes;/} density 500;"
bad fitted 'Entry packing is fitted, which is for one rigid body' \
    "${disk/rigid yes;/} spacing 0.005; packing fitted;"
bad oblique 'Entries p1 and p2: in this 2D case a cylinder must lie along the empty direction or '\
'across it' "$wood source cylinder; p1 (0.1 0.1 -1); p2 (0.2 0.1 1); radius 0.03; spacing 0.005;"
entries()   # NAME MESSAGE ENTRIES of the group a
{
    solids "groups { a { $3 } }"
    dictionary system/setParticlesDict <<<"regions ( a { $box group a; } );"
    refused "$1" "$2.*solidProperties" setParticles
}
entries nothing 'Entry constrain constrains nothing; '\
'valid are .line plane position axis orientation hinge' 'constrain { }'
entries hingeEntry 'Unknown entry centre; valid are .point axis.' \
    'constrain { hinge { point (0 0 0); centre (0 0 0); } }'
entries hingePoint "'point' not found" 'constrain { hinge { } }'
entries hingeAlone 'Entries hinge and line of constrain exclude each other' \
    'constrain { hinge { point (0 0 0); } line (1 0 0); }'
entries lineAndPlane 'Entries line and plane of constrain exclude' \
    'constrain { line (1 0 0); plane (0 1 0); }'
entries axisOut 'Entry axis is \(1 0 0\): bodies of this 2D case turn about its empty direction' \
    'constrain { axis (1 0 0); }'
entries lineOut 'Entry line is \(0 0 1\): it needs a length in the plane' \
    'constrain { line (0 0 1); }'
entries both 'Group a has both entries constrain and fixed' 'constrain { line (1 0 0); } fixed (y);'
entries orientation 'orientation has the unknown word none; valid are .fixed free.' \
    'constrain { orientation none; }'
entries constrainWord 'Entry constrain must be a dictionary' 'constrain hinge;'
entries springNumber 'Entry up is no dictionary' 'springs { up 3; }'
entries springStiffness 'Entry stiffness is 0: it must be positive' \
    'springs { up { anchor (0 0 0); point (0 0 0); stiffness 0; } }'
entries springEntry 'Unknown entry length; valid are .anchor point stiffness damping restLength.' \
    'springs { up { anchor (0 0 0); point (0 0 0); stiffness 1; length 1; } }'
entries mooringLength "'length' not found" \
    'moorings { up { anchor (0 0 0); point (0 0 0); stiffness 1; } }'
solids 'groups { a { constrain { line (1 0 0); } } }'
dictionary system/setParticlesDict <<<"regions ( a { set solids; material wood; group a; \
source box; box (0.05 0.02 0) (0.11 0.08 0.01); radius 0.005; } );"
rm -rf 0 0.*; setParticles >log 2>&1
refused looseGroup 'group a: 36 of its particles are of no rigid body' riprapFoam
exit 0
