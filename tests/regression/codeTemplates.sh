#!/bin/bash
# The templates of etc/codeTemplates, put where docs/development.md says: header, table line and
# test. The tests of all laws, kernels and terms then try the new ones too, and a case runs with the
# kernel and the term. The unit tests try the others in all dimensions and precisions: the laws are
# one beside the new one here, cases of typed tests one dimension and precision.
#
# SPDX-License-Identifier: GPL-3.0-or-later
root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL codeTemplates no environment"; exit 1; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
pass() { echo "PASS codeTemplates.$1"; }
fail() { echo "FAIL codeTemplates.$1 $2"; }

# A law of contacts, in a copy of the folder of its like and of the table
mkdir -p "$work/dem/contact/normal" "$work/solvers/dem"
cp "$root"/etc/codeTemplates/contactLaw/hardeningSpring.hpp "$work/dem/contact/normal"
sed 's|^using NormalLaws = Models<|&HardeningSpring, |; '\
's|^#include "dem/contact/normal/hertz.hpp"|#include "dem/contact/normal/hardeningSpring.hpp"\n&|' \
    "$root/src/solvers/dem/demFamilies.hpp" >"$work/solvers/dem/demFamilies.hpp"
grep -q '^using NormalLaws = Models<HardeningSpring, ' "$work/solvers/dem/demFamilies.hpp" \
    || fail contactLawTable 'the table has no such line'
flags=(-std=c++17 -O0 -fopenmp ${RIPRAP_MARCH:+-march=$RIPRAP_MARCH} -Wall -Wextra -Wno-psabi
    -Werror -I"$work" -I"$root/src" -I"$root/tests/unit")
# The whole table compiles; with the linear spring alone beside the new law the tests take a third
# of the time
whole() { g++ "${flags[@]}" -c "$root/src/solvers/dem/demLaws.C" -o "$work/demLaws.o"; }
short()
{
    sed -i 's|^using NormalLaws = .*|using NormalLaws = Models<HardeningSpring, LinearSpring>;|' \
        "$work/solvers/dem/demFamilies.hpp"
    g++ "${flags[@]}" "$root"/etc/codeTemplates/contactLaw/hardeningSpringTest.C \
        "$root/tests/unit/dem/lawCards.C" "$root/src/solvers/dem/demLaws.C" -o "$work/laws" \
        -lgtest -lgtest_main -lpthread
}
if { whole && short; } >"$work/log" 2>&1
then pass contactLawBuilds
else fail contactLawBuilds "$(grep -m1 error "$work/log")"
fi
if env -u RIPRAP_DIR "$work/laws" >"$work/log" 2>&1
then pass contactLawRuns
else fail contactLawRuns "$(grep -m1 -A4 Failure "$work/log" | tr '\n' ' ')"
fi

# Typed tests take these cases alone
cases()         # CASES
{
    sed "s|^using AllCases = .*|using AllCases = testing::Types<$1>;|" \
        "$root/tests/unit/backendTest.hpp" >"$work/backendTest.hpp"
    grep -qF "Types<$1>;" "$work/backendTest.hpp" || fail cases 'AllCases is elsewhere'
}

# A kernel and a pair term, in copies of their folders and of the table
mkdir -p "$work/sph/kernels" "$work/sph/terms"
cp "$root"/etc/codeTemplates/kernel/gaussian.hpp "$work/sph/kernels"
cp "$root"/etc/codeTemplates/pairTerm/radialViscosity.hpp "$work/sph/terms"
sed 's|^using Kernels = Models<|&Gaussian, |; '\
's|^#include "sph/kernels/wendlandC2.hpp"|#include "sph/kernels/gaussian.hpp"\n&|
    s|using PairTerms = Models<|&RadialViscosity<R>, |; '\
's|^#include "sph/terms/xsph.hpp"|#include "sph/terms/radialViscosity.hpp"\n&|' \
    "$root/src/sph/models.hpp" >"$work/sph/models.hpp"
grep -q '^using Kernels = Models<Gaussian, ' "$work/sph/models.hpp" \
    || fail kernelTable 'the table has no such line'
grep -q 'using PairTerms = Models<RadialViscosity<R>, ' "$work/sph/models.hpp" \
    || fail pairTermTable 'the table has no such line'
for file in sphModels termEffects
do
    g++ "${flags[@]}" -fPIC -c "$root/src/solvers/sph/$file.C" -o "$work/$file.o"
done >"$work/log" 2>&1
cases 'Case<3, Mixed>'
if g++ "${flags[@]}" \
    "$root"/etc/codeTemplates/kernel/gaussianTest.C \
    "$root"/etc/codeTemplates/pairTerm/radialViscosityTest.C \
    "$root"/tests/unit/sph/{sphCards,kernels,terms}.C "$work"/{sphModels,termEffects}.o \
    -L"$RIPRAP_LIBBIN" -Wl,-rpath,"$RIPRAP_LIBBIN" -lriprap \
    -o "$work/models" -lgtest -lgtest_main -lpthread >>"$work/log" 2>&1
then pass sphBuilds
else fail sphBuilds "$(grep -m1 error "$work/log")"
fi
if env -u RIPRAP_DIR "$work/models" >"$work/log" 2>&1
then pass sphRuns
else fail sphRuns "$(grep -m1 -A4 Failure "$work/log" | tr '\n' ' ')"
fi

# Programs take the models from here: what a rebuilt libriprap would have, for the CPU, 2D and mixed
# precision
g++ "${flags[@]}" -fPIC -shared "$root/src/solvers/instantiate/sphCpu2Mixed.C" \
    "$work"/{sphModels,termEffects}.o -o "$work/models.so" >"$work/log" 2>&1 \
    || { fail sphLibrary "$(grep -m1 error "$work/log")"; exit; }
models=(env LD_PRELOAD="$work/models.so")
mkdir "$work/case" && cd "$work/case" || exit 1
suite=codeTemplates
. "$root/tests/regression/setParticlesCases"
sph() { dictionary constant/sphProperties <<<"device cpu; walls { } $1"; }
wrong() { sph "$2"; refused "$1" "$3.*sphProperties" "${models[@]}" riprapFoam -dry-run; }
tank2
dictionary system/controlDict <<<'application riprapFoam; solver sphDem; startFrom startTime; '\
'startTime 0; stopAt endTime; endTime 0.005; deltaT 1e-3;
adjustTimeStep yes; writeControl adjustableRunTime; writeInterval 0.005; writeFormat ascii; '\
'timePrecision 9;'
regions 'tank { set fluid; source box; box (0 0 0) (0.2 0.1 0.01); }'
sph 'kernel gaussian; viscosity radial; radialViscosity { eta 0.02; }'
# 4 layers, where the other kernels have 3: the support is 3h
"${models[@]}" setParticles -checkWalls >log 2>&1
says layers '^Walls: 352 points'
says wallSum 'least (0\.99999|1)[0-9.]* .*most 1(\.00000[0-9]*)? '
"${models[@]}" riprapFoam -dry-run >log 2>&1
says dryKernel '^ *kernel +gaussian'
says dryTerm '^ *viscosity +radial, mu 0.001 Pa s, .*, eta 0.02$'
says dryOff '^ *off .*laminarViscosity artificialViscosity'
quiet dryOn '^ *(off|not used) .*radialViscosity'
"${models[@]}" riprapFoam >log 2>&1
says runs '^End'
[[ -s 0.005/lagrangian/fluid/positions ]] && pass written \
    || fail written "$(tail -n 3 log | tr '\n' ' ')"
sph 'viscosity laminar; radialViscosity { eta 0.02; }'
"${models[@]}" riprapFoam -dry-run >log 2>&1
says notChosen '^ *not used +\(radialViscosity\)'
wrong kernel 'kernel box;' 'kernel has the unknown word box; valid are .*gaussian'
wrong viscosity 'viscosity round;' 'viscosity has the unknown word round; '\
'valid are \(none radial laminar artificial laminarAndArtificial\)'
wrong entry 'radialViscosity { beta 1; }' 'Unknown entry beta; valid are \(eta\)'
wrong range 'viscosity radial; radialViscosity { eta -1; }' 'Entry eta is -1: it must be positive'

# A transfer, in a copy of the table. Two units of the library know what the table names: made anew
# for 2D, they stand before the library's own, in tests and in runs
mkdir -p "$work/pic/transfer/schemes" "$work/solvers/pic/transfer"
cp "$root"/etc/codeTemplates/transfer/filteredFlip.hpp "$work/pic/transfer/schemes"
sed 's|^using Transfers = Models<|&FilteredFlip, |; '\
's|^#include "pic/transfer/schemes/flip.hpp"|#include "pic/transfer/schemes/filteredFlip.hpp"\n&|' \
    "$root/src/solvers/pic/transfer/picFamilies.hpp" >"$work/solvers/pic/transfer/picFamilies.hpp"
grep -q '^using Transfers = Models<FilteredFlip, ' "$work/solvers/pic/transfer/picFamilies.hpp" \
    || fail transferTable 'the table has no such line'
if g++ "${flags[@]}" -fPIC \
    -shared "$root"/src/solvers/pic/transfer/{picTransfers,gridToParticlesCpu2}.C \
    -o "$work/libtransfers.so" >"$work/log" 2>&1
then pass transferLibrary
else fail transferLibrary "$(grep -m1 error "$work/log")"
fi
cases 'Case<2, Mixed>'
if g++ "${flags[@]}" \
    "$root"/etc/codeTemplates/transfer/filteredFlipTest.C \
    "$root"/tests/unit/pic/{transfer/transferCards,picRows,transfer/picSchemes}.C \
    "$root"/tests/unit/solvers/pic/picSchemeScenes.C \
    -o "$work/transfers" \
    "$work/libtransfers.so" -L"$RIPRAP_LIBBIN" -lriprap -lgtest -lgtest_main \
    -lpthread >"$work/log" 2>&1
then pass transferBuilds
else fail transferBuilds "$(grep -m1 error "$work/log")"
fi
if env -u RIPRAP_DIR LD_LIBRARY_PATH="$work:$LD_LIBRARY_PATH" "$work/transfers" \
    --gtest_filter='-*3Mixed*:*3Double*' >"$work/log" 2>&1 && grep -q PASSED "$work/log"
then pass transferRuns
else fail transferRuns "$(grep -m1 -A4 Failure "$work/log" | tr '\n' ' ')"
fi

# Cases with it
mkdir "$work/picCase"; cd "$work/picCase" || exit 1
suite=codeTemplates.transfer
. "$root/tests/regression/setParticlesCases"
run=(env LD_PRELOAD="$work/libtransfers.so" riprapFoam)
control()       # ENTRIES, the last of which count
{
    dictionary system/controlDict <<<"application riprapFoam; solver picDem; startFrom latestTime; \
startTime 0; stopAt endTime; endTime 0.1;
deltaT 1e-3; adjustTimeStep yes; maxCo 0.5; writeControl adjustableRunTime; writeInterval 0.05; \
writeFormat ascii; writePrecision 12; $1"
}
pic() { dictionary constant/picProperties <<<"device cpu; $1"; }
tank2; control ''; pic ''
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
dictionary system/setParticlesDict <<<'spacing 0.005; regions ( pool { set fluid; source box; '\
'box (0 0 -1) (0.1 0.08 1); velocity (0 0 0); pressure hydrostatic; } );'
setParticles >log 2>&1
pic 'transfer filteredFlip; filterTime 0.002;'
"${run[@]}" >log 2>&1; says run '^End'
says log 'transfer[ :]+filteredFlip, filterTime 0.002 s, affine'
mkdir whole; cp -r 0.1 whole; rm -rf 0.05 0.1
control 'endTime 0.05;'; "${run[@]}" >log 2>&1
control ''; "${run[@]}" >log 2>&1
for file in p U lagrangian/fluid/positions lagrangian/fluid/U uniform/riprap/picState
do
    cmp -s "0.1/$file" "whole/0.1/$file" && pass "restart.$file" \
        || fail "restart.$file" "0.1/$file is not what one run writes"
done
rm -rf 0.05 0.1
kilobytes() { sed -n 's/^ *fluid: \([0-9.]*\) kB$/\1/p' log; }
pic 'transfer flip;'; "${run[@]}" -dry-run >log 2>&1; without=$(kilobytes)
pic 'transfer filteredFlip; filterTime 0.002;'; "${run[@]}" -dry-run >log 2>&1
says dryRun 'transfer[ :]+filteredFlip, filterTime 0.002 s, affine'
says dryRunStep 'Time step of the particles: 0.002 s, limit: transfer'
# two reals and their spares, of each particle
awk -v a="${without:-0}" -v b="$(kilobytes)" -v n="$(sed -n 's/^ *fluid: \([0-9]*\)$/\1/p' log)" \
    'BEGIN { each = n ? 1000*(b - a)/n : 0; exit !(a > 0 && each > 15 && each < 17) }' &&
    pass dryRunMemory || fail dryRunMemory "kB of the fluid: $without with flip, $(kilobytes)"
pic 'transfer flip; filterTime 0.002; picPart 0.1;'; "${run[@]}" -dry-run >log 2>&1
says unused 'not used[ :]+\(picPart filterTime\)|not used[ :]+\(filterTime picPart\)'
pic 'transfer apicFlip;'; refused word \
    'transfer has the unknown word apicFlip; valid are .*filteredFlip.*flip.*apic' "${run[@]}"
pic 'transfer filteredFlip;'; refused missing 'filterTime' "${run[@]}"
pic 'transfer filteredFlip; filterTime 0;'
refused zero 'Entry filterTime is 0: it must be positive' "${run[@]}"
pic 'transfer flip; filterTime -1;'
refused unusedRange 'Entry filterTime is -1: it must be positive' "${run[@]}"
pic 'transfer filteredFlip; filterTime 0.1; spline linear;'; refused spline \
    'filteredFlip does not go with splines linear; valid are .quadratic cubic.' "${run[@]}"
pic 'transfer filteredFlip; filterTime 0.002;'; control 'adjustTimeStep no; deltaT 0.01;'
refused fixedStep 'Entry deltaT is 0.01: transfer filteredFlip bears steps of at most 0.002 s' \
    "${run[@]}"

# Libraries of a user's own: a function object and a solver module
export FOAM_USER_LIBBIN=$work/user/lib
mkdir -p "$FOAM_USER_LIBBIN"
export LD_LIBRARY_PATH=$FOAM_USER_LIBBIN:$LD_LIBRARY_PATH
library()       # FOLDER: builds a copy of a template
{
    cp -r "$root/etc/codeTemplates/$1" "$work/user"
    if (cd "$work/user/$1" && RIPRAP_WERROR=1 WM_OPTIONS=$RIPRAP_OPTIONS wmake libso) >"$work/log" \
        2>&1
    then pass builds
    else fail builds "$(grep -m1 error "$work/log")"
    fi
}
suite=codeTemplates.functionObject
pass() { echo "PASS $suite.$1"; }
fail() { echo "FAIL $suite.$1 $2"; }
library functionObject
mkdir "$work/centreCase"; cd "$work/centreCase" || exit 1
tank2
centre='centre { type fluidCentre; libs ("libfluidCentre.so"); }'
control "endTime 0.05; functions { $centre }"; pic ''
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-10; relTol 0; } }'
dictionary system/setParticlesDict <<<'spacing 0.005; regions ( pool { set fluid; source box; '\
'box (0 0 -1) (0.1 0.08 1); velocity (0.1 0.2 0); } );'
setParticles >log 2>&1
riprapFoam >log 2>&1
says runs '^End'
table=postProcessing/centre/0/fluidCentre.dat
# the block's centre, 80 particles a cell's row, and its velocity
row()
{
    awk -v "t=$1" '!/^#/ && $1 == t { print $2, $3, $4, $6, $7; found = 1 } END { exit !found }' \
        "$table"
}
row 0 | awk \
    'function off(a, b) { return (a - b)^2 > 1e-10 }
    { exit $1 < 300 || off($2, 0.05) || off($3, 0.04) || off($4, 0.1) || off($5, 0.2) }' \
    && pass start || fail start "$(row 0)"
row 0.05 | awk '{ exit !($2 > 0.05 && $2 < 0.07) }' && pass moves || fail moves "$(row 0.05)"
with() { rm -rf 0.05 postProcessing; control "endTime 0.05; functions { ${centre%\}} $1 } }"; }
with 'box (0 0 -1) (0.05 0.08 1);'
riprapFoam >log 2>&1
row 0 | awk '{ exit !(($2 - 0.025)^2 < 1e-10) }' && pass box || fail box "$(row 0)"
with 'box (0 0 -1) (0.05 -0.08 1);'
refused wrongBox 'Entry box is .*controlDict' riprapFoam
with 'bok (0 0 -1) (0.05 0.08 1);'
refused wrongEntry 'bok.*valid are .*box' riprapFoam

suite=codeTemplates.solverModule
library solverModule
mkdir "$work/drifterCase"; cd "$work/drifterCase" || exit 1
tank2
drifter() { dictionary constant/drifterProperties <<<"$1"; }
steps()
{
    control "solver drifters; startFrom latestTime; adjustTimeStep no; endTime 0.4; deltaT $1; \
writeInterval 0.2; writePrecision 17;"
}
steps 0.01
drifter 'flow (0.1 0 0); relaxationTime 0.05;'
mkdir -p 0/lagrangian/drifters
cloud()         # FILE CLASS VALUES
{
    printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n2\n(\n%s\n)\n' "$2" "$1" \
        "$3" >"0/lagrangian/drifters/$1"
}
cloud positions 'Cloud<passiveParticle>' $'(0.02 0.06 0.005) 0\n(0.01 0.07 0.005) 0'
cloud U vectorField $'(0 0.5 0)\n(0.2 0.5 0)'
dictionary constant/g <<<'dimensions [0 1 -2 0 0 0 0]; value (0 -1 0);'
riprapFoam >log 2>&1
says runs '^End'
# w = u + tau g, x = x0 + w t + tau (v0 - w)(1 - exp(-t/tau)), v = w + (v0 - w) exp(-t/tau)
exact()
{
    awk -v t="$1" 'BEGIN { tau = 0.05; k = exp(-t/tau); split("0.02 0.01", x);
            split("0.06 0.07", y); split("0 0.2", u)
        for (i = 1; i < 3; ++i) printf "%.9f %.9f %.9f %.9f\n",
            x[i] + 0.1*t + tau*(u[i] - 0.1)*(1 - k), y[i] - 0.05*t + tau*0.55*(1 - k),
            0.1 + (u[i] - 0.1)*k, -0.05 + 0.55*k }'
}
vectors() { grep -oE '\([-0-9.e+]+ [-0-9.e+]+ [-0-9.e+]+\)' "$1" | tr -d '()'; }
written()
{
    paste -d ' ' <(vectors "$1/positions") <(vectors "$1/U") \
        | awk '{ printf "%.9f %.9f %.9f %.9f\n", $1, $2, $4, $5 }'
}
[[ $(written 0.4/lagrangian/drifters) == "$(exact 0.4)" ]] && pass closedForm \
    || fail closedForm "$(written 0.4/lagrangian/drifters) instead of $(exact 0.4)"
mv 0.4 whole; steps 0.01
riprapFoam >log 2>&1
cmp -s 0.4/lagrangian/drifters/positions whole/lagrangian/drifters/positions && pass restart \
    || fail restart "0.4/lagrangian/drifters/positions is not what one run writes"
rm -rf 0.2 0.4; steps 0.08
riprapFoam >log 2>&1
[[ $(written 0.4/lagrangian/drifters) == "$(exact 0.4)" ]] && pass largeSteps \
    || fail largeSteps "$(written 0.4/lagrangian/drifters)"
rm -rf 0.2 0.4
riprapFoam -dry-run >log 2>&1
says dryRun '^Particle steps to time 0.4: 5$'
[[ ! -d 0.4 ]] && pass dryRunWritesNothing || fail dryRunWritesNothing 0.4
drifter 'flow (2 0 0); relaxationTime 0.05;'
refused leaves 'particle [01] at .* has left the mesh' riprapFoam
[[ ! -d 0.4 ]] && pass nothingAfterGuard || fail nothingAfterGuard 0.4
drifter 'flow (0.1 0 0); relaxationTime -1;'
refused wrongTime 'Entry relaxationTime is -1: it must be positive.*drifterProperties' riprapFoam
drifter 'flow (0.1 0 0); relaxationTime 1; drag 2;'
refused wrongEntry 'Unknown entry drag; valid are .*relaxationTime' riprapFoam
# It has not said that several processes can share it
if command -v mpirun >/dev/null
then
    drifter 'flow (0.1 0 0); relaxationTime 1;'
    FOAM_SIGFPE=false decomposePar >log 2>&1
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    refused severalProcesses 'Entry solver is drifters, which runs on one process' \
        mpirun -np 2 --oversubscribe riprapFoam -parallel
else
    echo "SKIP $suite.severalProcesses no mpirun"
fi
