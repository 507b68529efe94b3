#!/bin/bash
# Force and moment on parts of walls and on groups of solids, in all solvers: water at rest by
# closed forms, solids by their weight; the parts' sum; wrong entries.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL forces no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL forces no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=forces
. "$root/tests/regression/setParticlesCases"

library='type particleForces; libs ("libriprapFoam.so");'
control()   # SOLVER END FUNCTIONS
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom startTime; \
startTime 0; stopAt endTime; endTime $2;
deltaT 1e-5; adjustTimeStep yes; maxCo 0.5; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.05; writeFormat ascii; writePrecision 12;
functions { $3 }"
}
run() { rm -rf 0.* postProcessing; riprapFoam >log 2>&1; says "$1" '^End'; }
# Of force.dat or moment.dat: COLUMN 2 to 4 is the total, 5 to 7 the next, and so on
value()     # OBJECT FILE COLUMN [first]
{
    awk -v column="$3" -v first="${4:-}" '/^#/ { next } { gsub(/[()]/, " "); last = $column;
            if (first != "") exit } END { print last }' postProcessing/"$1"/0/"$2".dat
}
near()      # NAME OBJECT FILE COLUMN EXPECTED BOUND [first]
{
    local found
    found=$(value "$2" "$3" "$4" "${7:-}")
    if awk -v a="$found" -v b="$5" \
        -v bound="$6" 'BEGIN { exit !(a != "" && (a - b)^2 <= bound^2) }'; then pass "$1"
    else fail "$1" "is ${found:-not there}, expected $5 within $6"; fi
}
# The total of one is the sum of others, every component of every row
adds()      # NAME WHOLE PARTS...
{
    local name=$1 file whole=$2 bad=
    shift 2
    for file in force moment
    do
        bad+=$(for object in "$whole" "$@"
            do
                sed "s/^/$object /" postProcessing/"$object"/0/$file.dat
            done | awk -v whole="$whole" '$2 == "#" || /#/ { next }
            { gsub(/[()]/, " "); for (i = 3; i <= NF; ++i) { at = $2 " " i;
                sum[at] += $1 == whole ? -$i : $i; if ($i^2 > size[$2]) size[$2] = $i^2 } }
            END { for (at in sum) { split(at, k, " ");
                if (sum[at]^2 > 1e-18*size[k[1]]) print at, sum[at] }
                if (!length(sum)) print "no rows" }')
    done
    [[ -z $bad ]] && pass "$name" || fail "$name" "the parts do not sum to the whole: $bad"
}
parts="
all { $library patches (\".*\"); surfaces (\".*\"); }
sides { $library patches (left right); }
left { $library patches (left); }
right { $library patches (right); CofR (0.4 0 0.005); }
rightFromOrigin { $library patches (right); }
floor { $library patches (floor); CofR (0.2 0 7); }
floorFromOrigin { $library patches (floor); }
block { $library surfaces (block); CofR (0.203 0.094 0); }
blockFromOrigin { $library surfaces (block); }
body { $library bodies (gate); }
"
# Could move, and rests
motion='motion { gate { patches (block); solidBodyMotionFunction linearMotion; '\
'linearMotionCoeffs { velocity (0 0 0); } } }'

# Water 0.4 m wide and 0.2 m deep, and a block under it
block 0.4 0.3 0.01 '40 30 1' \
    "left { type wall; faces ((0 4 7 3)); } right { type wall; faces ((1 2 6 5)); }
floor { type wall; faces ((0 1 5 4)); } $open $flat"
dictionary system/setParticlesDict <<<'spacing 0.01; packing square; regions ( pool { set fluid; '\
'source box; box (0 0 -1) (0.4 0.2 1); pressure hydrostatic; clip yes; } );'

# SPH: the first row, of a lattice that is about to settle: 6 %
geometry 'block { type searchableBox; min (0.15 0.06 -1); max (0.25 0.12 1); }'
dictionary constant/sphProperties <<<"device cpu; maxVelocity 2; walls { $motion }"
control sphDem 0.02 "$parts wall { type wallForce; libs (\"libriprapFoam.so\"); }"
setParticles >log 2>&1
run sph; quiet logDefault 'Sum of force'
head -4 postProcessing/right/0/force.dat >header
grep -q '^# Force' header && grep -qE '^# CofR +: \(0.4 0 0.005\)' header \
    && grep -qE $'^# Time +\t\(total_x total_y total_z\)\t\(pressure_x pressure_y pressure_z\)'\
$'\t\(viscous_x viscous_y viscous_z\) *$' header \
    && pass header || fail header "$(cat header)"
near sphRight right force 2 196.2 12 first              # rho g H^2/2
near sphLeft left force 2 -196.2 12 first
near sphRightMoment right moment 4 -13.08 0.8 first       # about its foot, rho g H^3/6
near sphFloor floor force 3 -784.8 47 first             # rho g H W
near sphBlock block force 3 58.86 3.5 first               # rho g V
adds sphParts all left rightFromOrigin floorFromOrigin blockFromOrigin
adds sphBody body blockFromOrigin

# SPH with solids: a block of solid particles that is held under water, each with a cell of it
solids()    # GROUPS
{
    dictionary constant/solidProperties \
        <<<"materials { stone { rho 2500; E 1e8; nu 0.25; } } contact { normal linear; }
pairs { default { restitution 0.3; friction 0.5; \
stiffness 1e5; } } walls { material stone; } groups { $1 }"
}
groups="held { $library groups (held); \
CofR (0.2 0.09 0); } others { $library groups (free); } walls { $library patches (\".*\"); }"
rm -rf 0 constant/geometry
dictionary constant/sphProperties <<<'device cpu; maxVelocity 2;'
solids 'held { fixed all; }'
dictionary system/setParticlesDict <<<'spacing 0.01; packing square; regions ( pool { set fluid; '\
'source box; box (0 0 -1) (0.4 0.2 1); pressure hydrostatic; clip yes; }
block { set solids; material stone; group held; radius 0.005; mass cell; source box; '\
'box (0.15 0.06 0) (0.25 0.12 0.01); } );'
setParticles >log 2>&1
control sphDem 0.01 "$groups"
run sphSolids
near sphHeld held force 3 58.86 4 first                 # rho g V
near sphHeldMoment held moment 4 0 0.3 first            # about its middle
near sphOthers others force 3 0 0

# Particles in cells: edges of the block are between the planes of the grid, water is at rest
rm -rf 0 constant/sphProperties constant/solidProperties
geometry 'block { type searchableBox; min (0.153 0.0637 -1); max (0.2531 0.1233 1); }'
dictionary constant/picProperties <<<"device cpu; walls { $motion }"
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
dictionary system/setParticlesDict <<<'spacing 0.01; packing square; regions ( pool { set fluid; '\
'source box; box (0 0 -1) (0.4 0.2 1); pressure hydrostatic; clip yes; } );'
control picDem 0.02 "$parts"
setParticles >log 2>&1
run pic
near picRight right force 2 196.2 0.4                   # 0.2 %: the surface settles
near picRightMoment right moment 4 -13.08 0.06
near picFloor floor force 3 -784.8 1.6
near picFloorMoment floor moment 4 0 0.3
near picBlock block force 3 58.526 0.3                  # rho g V
near picBlockMoment block moment 4 0 0.06               # about its middle
adds picParts all left rightFromOrigin floorFromOrigin blockFromOrigin
adds picBody body blockFromOrigin

# A disk that is held in it
rm -rf 0 constant/geometry
dictionary constant/picProperties <<<'device cpu;'
solids 'held { fixed all; }'
printf 'x,y,z\n0.2,0.09,0.005\n' >constant/disk.csv
dictionary system/setParticlesDict <<<'spacing 0.01; packing square; regions ( pool { set fluid; '\
'source box; box (0 0 -1) (0.4 0.2 1); pressure hydrostatic; clip yes; }
disk { set solids; material stone; group held; radius 0.05; source csv; file "disk.csv"; } );'
mass="mass { type regionMass; libs (\"libriprapFoam.so\"); regions ( all { source box; \
box (0 0 0) (0.4 0.3 0.01); } low { source box; box (0 0 0) (0.4 0.1 0.01); } ); }"
control picDem 0.02 "$groups $mass"
cp constant/disk.csv .; setParticles >log 2>&1
run picSolids
near picHeld held force 3 77.05 1.5                     # rho g pi R^2, R = 5 cells
near picHeldMoment held moment 4 0 0.1
massOf()
{
    awk -v c="$1" '/^#/ { for (i = 2; i <= NF; ++i) if ($i == c) k = i - 1; next } { print $k;
            exit }' postProcessing/mass/0/regionMass.dat
}
is()
{
    awk -v a="$(massOf "$2")" \
        -v b="$3" -v bound="$4" 'BEGIN { exit !(a != "" && (a - b)^2 <= bound^2) }' && pass "$1" \
        || fail "$1" "$2 is $(massOf "$2"), expected $3"
}
is picMass allFluidMass 72.1 0.8                        # 80 - pi R^2 rho, cut in particles
is picSolid allSolidMass 19.635 1e-3
is picSolidFraction lowSolidFraction 0.19635 1e-4       # its centre is in the lower half
is picSolids allSolids 1 0

# Solids alone: a layer on the floor, and two stones on a shelf
rm -rf 0 constant/picProperties constant/fluidProperties
solids 'free { viscousDamping 20; } kept { viscousDamping 20; }'
geometry 'shelf { type searchableBox; min (0.3 -0.1 -1); max (0.5 0.05 1); }'
dictionary system/setParticlesDict <<<'regions ( heap { set solids; material stone; radius 0.01; '\
'packing layers; source box; box (0 0 0) (0.2 0.06 0.01); }
two { set solids; material stone; group kept; radius 0.01; source box; '\
'box (0.33 0.05 0) (0.37 0.07 0.01); } );'
setParticles >log 2>&1
read -r heap two < <(grep -oE '(heap|two): [0-9]+ particles.*mass [0-9.e-]+' log \
    | awk '{ printf "%s ", 9.81*$NF }')
control dem 0.3 "
all { $library patches (\".*\"); surfaces (\".*\"); }
floor { $library patches (floor); }
sides { $library patches (left right); }
shelf { $library surfaces (shelf); CofR (0.35 0.05 0); }
shelfFromOrigin { $library surfaces (shelf); }
kept { $library groups (kept); }
free { $library groups (free); }
shelfInTime { $library surfaces (shelf); CofR (0.35 0.05 0); average 0.025; impulse yes; }
table { type solidWallForce; libs (\"libriprapFoam.so\"); }
tableMean { type solidWallForce; libs (\"libriprapFoam.so\"); average 0.025; } $mass"
run dem
is demMass allSolidMass "$(awk -v a="$heap" -v b="$two" 'BEGIN { print (a + b)/9.81 }')" 1e-3
heavy=$(awk -v a="$heap" -v b="$two" 'BEGIN { print -a - b }')
near demAll all force 3 "$heavy" 2
near demShelf shelf force 3 "-$two" 0.05
near demShelfNormal shelf force 6 "-$two" 0.05
near demShelfTangential shelf force 9 0 0.05
near demShelfMoment shelf moment 4 0 0.002              # about the middle between them
near demKept kept force 3 "$two" 0.05
adds demParts all floor sides shelfFromOrigin
near demFree free force 3 "$heap" 2
# The same as the table of walls has; what it tells about the origin
near demTable shelf force 3 "$(awk '/^#/ { for (i = 2; i <= NF; ++i) if ($i == "shelfFy") k = i - 1;
        next } { last = $k } END { print last }' postProcessing/table/0/solidWallForce.dat)" 1e-8

# Means and impulse against the rows that they come from, linear in between; a continued run has
# them, too
inTime()    # NAME
{
    [[ $(cat postProcessing/shelfInTime/*/impulse.dat | grep -vc '#') -ge 31 ]] \
        || { fail "$1" "rows are missing"; return; }
    for kind in force:forceMean moment:momentMean
    do
        sort -sug <(cat postProcessing/shelf/*/${kind%:*}.dat | grep -v '#') >rows
        cat postProcessing/shelfInTime/*/${kind#*:}.dat | grep -v '#' >means
        tr -d '()' <rows >a; tr -d '()' <means >b
        awk 'NR == FNR { t[++n] = $1; for (i = 2; i <= NF; ++i) v[n, i] = $i; next }
            { begin = $1 - 0.025; if (begin < t[1]) begin = t[1]
              for (i = 2; i <= NF; ++i) { sum = 0
                for (k = 2; k <= n && t[k] <= $1 + 1e-9; ++k) { if (t[k] <= begin + 1e-9) continue
                    from = t[k - 1] > begin ? t[k - 1] : begin
                    share = (from - t[k - 1])/(t[k] - t[k - 1])
                    f = v[k - 1, i] + share*(v[k, i] - v[k - 1, i])
                    sum += 0.5*(f + v[k, i])*(t[k] - from) }
                mean = $1 > begin + 1e-9 ? sum/($1 - begin) : v[1, i]; d = mean - $i
                if (d*d > 1e-14*(1 + mean*mean)) { print $1, i, mean, $i; exit } } }' a b >differs
        [[ -s differs ]] \
            && { fail "$1" "${kind#*:} at, column, by hand, table: $(cat differs)"; return; }
    done
    sort -sug <(cat postProcessing/shelf/*/force.dat | grep -v '#') | tr -d '()' >a
    cat postProcessing/shelfInTime/*/impulse.dat | grep -v '#' | tr -d '()' >b
    awk 'NR == FNR { n = $1 "";
            for (i = 2; i <= NF; ++i) { if (FNR > 1) sum[i] += 0.5*($i + last[i])*($1 - t);
            last[i] = $i; all[n, i] = sum[i] + 0 } t = $1; next }
        { for (i = 2; i <= NF; ++i) { d = all[$1 "", i] - $i;
            if (d*d > 1e-14) { print $1, i, all[$1 "", i], $i; exit } } }' a b >differs
    [[ -s differs ]] && fail "$1" "impulse at, column, by hand, table: $(cat differs)" || pass "$1"
}
inTime demInTime
near demImpulse shelfInTime impulse 3 "$(awk -v w="$two" 'BEGIN { print -0.3*w }')" 0.3
meanOf()
{
    awk -v c="shelf$1" '/^#/ { for (i = 2; i <= NF; ++i) if ($i == c) k = i - 1; next }
            { last = $k } END { print last }' postProcessing/tableMean/*/solidWallForceMean.dat
}
near demTableMean shelfInTime forceMean 3 "$(meanOf Fy)" 1e-8
mv postProcessing whole; rm -rf 0.2* 0.3*
sed -i 's/startFrom startTime/startFrom latestTime/' system/controlDict; riprapFoam >log 2>&1
cp -r whole/shelf whole/shelfInTime .
for o in shelf shelfInTime
do
    for f in "$o"/0/*; do awk '/^#/ || $1 < 0.1501' "$f" >part; mv part "$f"; done
    cp -r "$o" postProcessing/
done
inTime demInTimeGoesOn

# What is wrong is said, with the words that are valid
wrong()     # NAME ENTRIES MESSAGE
{
    control dem 0.3 "wrong { $library $2 }"
    refused "$1" "$3.*controlDict.functions.wrong" riprapFoam
}
wrong nothing '' 'does not say of which parts .*Valid are patches \(left right floor\), '\
'surfaces \(shelf\), planes \(\), bodies \(\), groups \(.*kept.*\)'
wrong patch 'patches (flor);' \
    'Entry patches of function object wrong: flor selects none; valid are \(left right floor\)'
wrong openPatch 'patches (upper);' \
    'Entry patches .*: upper selects none; valid are \(left right floor\)'
wrong patterns 'patches ("f.*" "x.*");' 'Entry patches .*x\.\*.* selects none; valid are'
wrong noPatches 'patches ();' 'Entry patches .* is empty; valid are \(left right floor\)'
wrong surface 'surfaces (floor);' 'Entry surfaces .*: floor selects none; valid are \(shelf\)'
wrong plane 'planes (slope);' 'Entry planes .*: slope selects none; valid are \(\)'
wrong body 'bodies (lid);' 'Entry bodies .*: lid selects none; valid are \(\)'
wrong group 'groups (stones);' 'Entry groups .*: stones selects none; valid are \(.*kept'
wrong centre 'patches (floor); CofR (0 0);' 'Wrong token type'
wrong average 'patches (floor); average -1;' \
    'Entry average of function object wrong is -1: it must not be negative'
wrong foreign 'patches (floor); rhoInf 1000;' 'Unknown entry rhoInf; valid are .*CofR'
control dem 0.3 "all { $library patches (floor); }"
postProcess >log 2>&1
says noScene 'needs a running particle scene'
