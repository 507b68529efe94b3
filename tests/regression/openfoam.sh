#!/bin/bash
# Habits of OpenFOAM's programs that riprap's share: what the log's head says, lists, documentation,
# completion, function objects by #includeFunc, edits while a run goes on, file handlers. And a run
# whose time is not written fails.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL openfoam no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL openfoam no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=openfoam
. "$root/tests/regression/setParticlesCases"
. "$root/tests/regression/writtenCases"
set +e
export OMP_NUM_THREADS=1
site=$root/etc/site/etc/caseDicts/postProcessing/riprap

water()
{
    tank2
    control sphDem "${1:-0.006}" 0.001 "${2:-}"
    regions "$pool"
    echo 'device cpu;' >>constant/sphProperties
    setParticles >log 2>&1
}
# A library that comes before riprap's and OpenFOAM's
before() { echo "$2" >"$1.C" && g++ -shared -fPIC -o "$1.so" "$1.C" 2>log && echo "$case/$1.so"; }

# The head of a log: version, flags, GPU
version=$("$root/etc/version")
water || fail case "$(oneLine)"
mv log log.setParticles
riprapFoam >log.riprapFoam 2>&1
for program in setParticles riprapFoam
do
    cp log.$program log
    says version.$program "^riprap : $version, for OpenFOAM v$RIPRAP_FOAM( |\$)"
    says flags.$program "^Flags  : (g\\+\\+|clang) [0-9.]+.* -O3 .*-fopenmp"
    says gpu.$program "^GPU    : (none|sm_[0-9]+.*, CUDA [0-9.]+)( |\$)"
done
other=$(before other \
    'namespace Foam { namespace foamVersion { extern const int api; const int api = 1706; } }')
LD_PRELOAD=$other riprapFoam >log 2>&1; status=$?
says otherLibraries "riprap was built for OpenFOAM v$RIPRAP_FOAM, \
but the libraries that are loaded are those of v1706"
((status == 1)) && pass otherLibrariesStatus || fail otherLibrariesStatus "it is $status"

# The sources' version where there is no git: of the tarball, not of a repository around it
mkdir -p around/riprap/etc; cp "$root/etc/version" around/riprap/etc/; git init -q around
[[ $(around/riprap/etc/version) == unknown ]] && pass versionUnknown \
    || fail versionUnknown "it is $(around/riprap/etc/version)"
echo v9.8.7 >around/riprap/VERSION
[[ $(around/riprap/etc/version) == v9.8.7 ]] && pass versionOfTarball \
    || fail versionOfTarball "it is $(around/riprap/etc/version)"
rm -rf around

# What there is
(mkdir nowhere && cd nowhere && riprapFoam -listFunctionObjects) >log 2>&1; status=$?
says listFunctionObjects 'functionObjects.*energyBalance.*waterLevel'
((status == 0)) && pass listStatus || fail listStatus "it is $status"
for program in riprapFoam:docs/guide/running:applications/solvers/riprapFoam/riprapFoam.C \
    setParticles:docs/guide/setParticles:applications/utilities/setParticles/setParticles.C
do
    IFS=: read -r program page source <<<"$program"
    FOAM_DOC_BROWSER='echo the page is %f' $program -doc >log 2>&1
    says doc.$program "the page is $root/(platforms/docs/)?$page[.](md|html)"
    FOAM_DOC_BROWSER='echo the page is' $program -doc-source >log 2>&1
    says docSource.$program "the page is $root/$source"
done
RIPRAP_DIR=/nowhere riprapFoam -doc >log 2>&1 && fail docMissing "status 0" \
    || says docMissing 'No documentation: there is no file "/nowhere/docs/guide/running.md"'

# The Tab key, in a shell of its own
complete()      # NAME PROGRAM WORD WORD-BEFORE WANTED...
{
    local name=$1 found; shift
    found=$(bash --norc \
        -ic ". '$root/etc/bashrc'; complete -p $1 | grep -q _riprap_complete_ || exit 1
        COMP_LINE='$1 $2'; _riprap_complete_ $1 '$2' '$3'; echo \" \${COMPREPLY[*]} \"" 2>/dev/null)
    shift 3
    for wanted
    do
        [[ $found == *" $wanted "* ]] || { fail "$name" "no $wanted in '$found'"; return; }
    done
    pass "$name"
}
complete completeOptions riprapFoam - riprapFoam -dry-run -solver -postProcess -listFunctionObjects
complete completeOptionsOfSet setParticles -ch setParticles -checkWalls
complete completeSolvers riprapFoam '' -solver sphDem picDem dem
complete completeFunctions riprapFoam en -func energyBalance

# Function objects by #includeFunc: each file is of the type that it is called after, and is taken
# as it stands or after an entry is made
functions()
{
    dictionary system/controlDict.functions <<<"functions { $1 }"
    grep -q controlDict.functions system/controlDict \
        || echo '#include "controlDict.functions"' >>system/controlDict
}
mkdir -p solids; (cd solids && tank2 && control dem 0.002 0.001 && solids \
    && echo 'device cpu;' >>constant/solidProperties \
    && dictionary system/setParticlesDict <<<"regions ( $ball );" && setParticles >log 2>&1)
mkdir -p grid; (cd grid && tank2 && control picDem 0.008 0.004 && solids && pressure \
    && dictionary constant/picProperties <<<'device cpu;' && regions "$pool $ball" \
    && setParticles >log 2>&1)
for file in "$site"/*
do
    name=${file##*/} entries= folder=.
    grep -qE "^type +$name;" "$file" || { fail "include.$name" "its type is another"; continue; }
    case $name in
        waterLevel) entries='waterLevel { points ((0.05 0 0.005)); }';;
        regionMass) entries='regionMass { regions ( all { source box; box (0 0 0) (1 1 1); } ); }';;
        particleProbes) entries='particleProbes { probeLocations ((0.05 0.02 0.005)); }';;
        particleDisplacement) entries='particleDisplacement { points ((0.15 0.06 0.005)); }' \
            folder=solids;;
        groupMotion|solidEnergies|solidWallForce|springForces|brokenBonds|contactChains)
            folder=solids;;
        momentumBalance) folder=grid;;
    esac
    (cd $folder && rm -rf 0.* postProcessing && functions "#includeFunc $name
        $entries" \
        && riprapFoam >log 2>&1; status=$?; cp log "$case/log" 2>/dev/null; exit $status); status=$?
    if ((status)); then fail "include.$name" "$(oneLine | tail -c 400)"
    elif [[ $name == springForces ]]; then pass "include.$name"        # without springs no table
    elif [[ $name != particlesToMesh && ! -d $folder/postProcessing/$name ]]
    then fail "include.$name" "no postProcessing/$name"
    elif [[ $name == particlesToMesh && ! -e 0.006/alpha.water ]]
    then fail "include.$name" "no field alpha.water"
    else pass "include.$name"
    fi
done
tables=$(ls "$site" | sort); types=$(grep -rhoE '^ *TypeName\("[a-zA-Z]+"\)' \
    "$root"/src/riprapFoam/functionObjects/*/*.H | cut -d'"' -f2 | grep -v FunctionObject | sort)
[[ $tables == "$types" ]] && pass includeAll \
    || fail includeAll "files: ${tables//$'\n'/ }; function objects: ${types//$'\n'/ }"
functions '#includeFunc noSuchThing'
refused includeMissing 'Function object noSuchThing has no file: '\
'neither system/noSuchThing nor one below caseDicts/postProcessing in' riprapFoam
functions '#includeFunc energyBalance'
mkdir -p mine/etc
WM_PROJECT_SITE=$PWD/mine refused includeOwnSite 'Function object energyBalance has no '\
'file.*where WM_PROJECT_SITE is not set to a folder of yours' riprapFoam
[[ $(WM_PROJECT_SITE=$PWD/mine bash -c ". '$root/etc/bashrc'; echo \$WM_PROJECT_SITE") == \
    "$PWD/mine" ]] && pass siteIsTheUsers || fail siteIsTheUsers "etc/bashrc has changed it"
functions ''
riprapFoam -postProcess -latestTime -func energyBalance >log 2>&1 \
    && [[ -e postProcessing/energyBalance/0.006/energyBalance.dat ]] && pass postProcessFunc \
    || fail postProcessFunc "$(oneLine | tail -c 400)"
refused postProcessFuncMissing 'Function object noSuchThing has no file' riprapFoam -postProcess \
    -latestTime -func noSuchThing

# Collated files: the same in a case that is not decomposed
functions ''
rm -rf 0.* other; riprapFoam >log 2>&1; mkdir other; mv 0.* other/
riprapFoam -fileHandler collated >log 2>&1; status=$?
says collatedTaken 'fileHandler .*collated'
((status == 0)) && [[ -e other/0.006/lagrangian/fluid/positions ]] \
    && (for t in other/0.*; do diff -r "$t" "${t#other/}" || exit 1; done) >diff.log 2>&1 \
    && pass collated || fail collated "status $status: $(head -3 diff.log)"

# Edits while a run goes on: it is told by its log when it has begun
await()
{
    local i
    for ((i = 0; i < 600; ++i)); do grep -qE "$1" log 2>/dev/null && return 0; sleep 0.1; done
    return 1
}
rm -rf edits; mkdir edits; cd edits || exit 1
water 1000 'runTimeModifiable yes; purgeWrite 2;'
functions ''
timeout 120 riprapFoam -opt-switch fileModificationSkew=0 >log 2>&1 & run=$!
await '^Time = 0.003' || fail editBegun "$(oneLine | tail -c 300)"
sleep 1.1; functions '#includeFunc energyBalance'
await 'functions|Re-reading|Reading object controlDict'
for ((i = 0; i < 300; ++i))
do
    [[ -e $(ls postProcessing/energyBalance/*/energyBalance.dat 2>/dev/null | head -1) ]] && break
    sleep 0.1
done
[[ -n $(ls postProcessing/energyBalance/*/energyBalance.dat 2>/dev/null) ]] && pass editFunctions \
    || fail editFunctions "no table of the function object that was added"
sleep 1.1
sed -i 's/endTime 1000/endTime 0.001/; s/stopAt endTime/stopAt writeNow/' system/controlDict
wait $run; status=$?
((status == 0)) && says editStop '^End' || fail editStop "status $status: $(oneLine | tail -c 300)"
cd .. || exit 1

# fvSolution is read again as well; of what is read once the run says that it goes on with what it
# was
cd grid || exit 1
rm -rf 0.* postProcessing; functions ''
sed -i 's/endTime 0.008/endTime 1000/; s/writeInterval 0.004/runTimeModifiable yes; purgeWrite 2; '\
'&/' system/controlDict
timeout 120 riprapFoam -opt-switch fileModificationSkew=0 >log 2>&1 & run=$!
await '^Time = 0.008' || fail editSolverBegun "$(oneLine | tail -c 300)"
sleep 1.1; sed -i 's/solver cudaPCG/solver coupledPCG; preconditioner DIC/' system/fvSolution
echo '// edited' >>constant/solidProperties; sed -i 's/maxCo 0.5/maxCo 0.6/' system/controlDict
await 'DICcoupledPCG:  Solving for p' \
    && says editSolver 'The pressure is solved by the edited entries of system/fvSolution' \
    || fail editSolver "no other solver solves for p"
await 'Of \(maxCo\) the run goes on' && pass editEntryReadOnce \
    || fail editEntryReadOnce "the run does not say that maxCo is read once"
await 'constant/solidProperties has been edited. It is read once' && pass editFileReadOnce \
    || fail editFileReadOnce "the run does not say that the file is read once"
sleep 1.1; sed -i 's/preconditioner DIC/preconditioner ditto/' system/fvSolution
wait $run; status=$?
((status == 1)) && says editWrong 'ditto' \
    || fail editWrong "status $status: $(oneLine | tail -c 300)"
cd .. || exit 1

# A time that is not written to its end, for whatever reason, ends the run. Here functions that
# write are replaced by others that do nothing
rm -rf 0.*; functions ''
none=$(before none 'extern "C" void _ZNK4Foam10fluidCloud10writeStateEb(const void*, bool) {}')
LD_PRELOAD=$none refused stateNotWritten 'Time 0.001 has been written without its file '\
'uniform/riprap/sph(Run|State): no run could go on from it' riprapFoam
rm -rf 0.*
none=$(before none 'extern "C" bool _ZNK4Foam10sceneCloud7writeAsERKNS_14IOstreamOptionEb(const '\
'void*, const void*, bool) { return true; }')
LD_PRELOAD=$none refused cloudNotWritten \
    'Time 0.001 has been written without its file lagrangian/fluid/positions' riprapFoam
rm -rf 0.*
none=$(before none 'extern "C" bool _ZNK4Foam8caseTime7writeAsERKNS_14IOstreamOptionEb(const '\
'void*, const void*, bool) { return true; }')
LD_PRELOAD=$none refused timeNotWritten \
    'Time 0.001 was due to be written, but OpenFOAM v[0-9]+ has not asked for its files' riprapFoam
