#!/bin/bash
# A run that is killed (SIGKILL) at any moment is continued from its latest whole time, to the bit.
# Times that are not whole are refused.
#
#   tests/regression/kills.sh [KILLS]       default 9, a third for each solver; 110: the long test
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
kills=${1:-9}
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL kills no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL kills no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=kills
. "$root/tests/regression/setParticlesCases"
. "$root/tests/regression/writtenCases"

makeSphDem()
{
    tank2
    control sphDem 0.03 0.001
    regions "$pool"
    walls ''
    echo 'device cpu;' >>constant/sphProperties
    setParticles >log 2>&1
}
makePicDem()
{
    tank2
    control picDem 0.1 0.004
    solids
    pressure
    dictionary constant/picProperties <<<'device cpu;'
    regions "$pool $ball"
    setParticles >log 2>&1
}
makeDem()
{
    tank2
    control dem 0.1 0.001
    solids
    echo 'device cpu;' >>constant/solidProperties
    dictionary system/setParticlesDict <<<"regions ( $ball );"
    setParticles >log 2>&1
}

final() { ls -d [0-9]* | sort -g | tail -1; }
# State and clouds of the last time, but for what counts steps of OpenFOAM
sums()
{
    (cd "$(final)" && find lagrangian uniform/riprap -type f ! -name 'manifest*' | sort \
        | xargs cksum)
}

seed=${RANDOM_SEED:-1}; RANDOM=$seed
killed()    # SOLVER
{
    local solver=$1 start took n same=0 tried=0 passed=0 pid status
    rm -rf 0.* 0/uniform/functionObjects
    start=$(date +%s%N)
    riprapFoam >log 2>&1 || { fail "$solver.run" "$(grep -A4 FATAL log | tr "\n" " ")"; return; }
    took=$((($(date +%s%N) - start)/1000000)); sums >../whole.sums
    for ((n = 0; n < (kills + 2)/3; ++n))
    do
        rm -rf 0.*
        riprapFoam >log 2>&1 & pid=$!
        sleep "$(awk -v r=$RANDOM -v t=$took 'BEGIN {print (0.1 + 0.85*r/32768)*t/1000}')"
        kill -9 $pid 2>/dev/null; wait $pid 2>/dev/null
        tried=$((tried + 1))
        timeout 120 riprapFoam >log 2>&1; status=$?
        grep -q 'is passed over' log && passed=$((passed + 1))
        if ((status == 0)) && sums | cmp -s - ../whole.sums
        then
            same=$((same + 1))
        else
            cp log "../$solver.$n.log"
            tail -5 log
        fi
    done
    echo "$solver: $tried killed after up to $took ms, $passed times passed over, \
$same continued exactly"
    ((same == tried)) && pass "$solver" \
        || fail "$solver" "$same of $tried continued exactly (RANDOM_SEED=$seed)"
}
for solver in sphDem picDem dem
do
    mkdir -p $solver; cd $solver || exit 1
    make${solver^} || { fail "$solver.case" "$(tail -3 log)"; cd ..; continue; }
    killed $solver
    cd ..
done

# Of each solver's last time one file is cut short or lost: refused when named, passed over by
# latestTime
named()
{
    sed -i "s/startFrom [a-zA-Z]*; startTime [0-9.]*/startFrom startTime; startTime $1/" \
        system/controlDict
}
latest()
{
    sed -i "s/startFrom [a-zA-Z]*; startTime [0-9.]*/startFrom latestTime; startTime 0/" \
        system/controlDict
}
cut()       # SOLVER FILE [BYTES]
{
    cd "$1" || return
    local last name; last=$(final); name=$1.$(basename "$2").${3:-0}
    if [[ -e $last/$2 ]]
    then
        cp -r "$last" aside
        truncate -s "${3:-0}" "$last/$2"
        named "$last"
        refused "$name" "Time $last is damaged .*$2 is cut short: ${3:-0} \
of [0-9]* bytes.*controlDict" riprapFoam
        latest
        riprapFoam -dry-run >log 2>&1
        says "$name.latest" "Time $last is passed over: .*$2 is cut short.*Continuing exactly"
        rm -r "$last"; mv aside "$last"
    else
        fail "$name" "no $last/$2"
    fi
    cd ..
}
cut sphDem lagrangian/fluid/U 300
cut sphDem uniform/lagrangian/fluid/cloudProperties
cut sphDem uniform/riprap/sphState 2000
cut picDem U 900
cut picDem uniform/riprap/picRun
cut picDem lagrangian/solids/omega
cut dem lagrangian/solids/force
cut dem lagrangian/solids/moment 100
cut dem uniform/lagrangian/solids/cloudProperties

cd picDem || exit 1
last=$(final)
cp -r "$last" aside; rm -r "$last/lagrangian/fluid"; named "$last"
refused dry "Time $last is damaged .*lagrangian/fluid/[A-Za-z]* is missing" riprapFoam
rm "$last/uniform/riprap/manifest"
refused dryOld 'The water is missing: [0-9]+ particles were written' riprapFoam
rm -r "$last"; mv aside "$last"
mv "$last/uniform/riprap/manifest" "$last/uniform/riprap/manifest.part"
refused unfinished "Time $last is not whole: \
the run that wrote it was stopped before the last file.*Remove the directory" riprapFoam
mv "$last/uniform/riprap/manifest.part" "$last/uniform/riprap/manifest"
# Another program's, and older, times have no manifest: as they stand
rm "$last/uniform/riprap/manifest"; latest
riprapFoam -dry-run >log 2>&1; says noManifest "from the fields|Continuing exactly"
quiet noManifest.quiet 'passed over'
# Emptied before there were manifests: one message, no crash
: >"$last/lagrangian/solids/omega"
refused emptyOld "The file is empty or cut short.*lagrangian/solids/omega" riprapFoam
# A folder of a function object's fields is no time to start from
mkdir 9; echo x >9/field
: >"$last/uniform/riprap/manifest.part"
riprapFoam -dry-run >log 2>&1; says noParticles \
    "Time 9 is passed over: it holds no particles.*Time $last is passed over: the run that wrote it"
rm -r 9

# A full disk, as a limit of a file's size: the run ends with an error, the next goes on from what
# was whole
rm -rf 0.*
(trap '' XFSZ; ulimit -f 4; timeout 60 riprapFoam 2>&1; echo "status $?") | cat >log
says full \
    'FOAM FATAL.*(is the disk full|not written to its end|error in IOstream .*0.004).*status 1'
riprapFoam >log 2>&1
says fullAgain 'Time 0[.0-9]* is passed over.* End'
# Changed on purpose: told, and not taken for the exact state
cd ../sphDem || exit 1
rm -rf 0.*; riprapFoam >log 2>&1
last=$(ls -d 0.* | sort -g | sed -n 3p); rm -rf $(ls -d 0.* | sort -g | tail -n +4)
sed -i '30s/.*/(0.5 0 0)/' "$last/lagrangian/fluid/U"
riprapFoam -dry-run >log 2>&1
says changed "Changed since riprapFoam wrote time $last: \(lagrangian/fluid/U\).*State in \
uniform/riprap is not used: the cloud has been changed since it was written \(U\)"
