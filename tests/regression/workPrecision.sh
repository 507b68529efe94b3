#!/bin/bash
# benchmarks/workPrecision: the loader of rows, orders and limits on made and on the repository's
# rows; tables, page and advice are those of the rows; what is missing is found, run, recorded, and
# not run again. Only this last part runs a solver, for a second
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
python=${RIPRAP_PYTHON:-/usr/bin/python3}
export PYTHONDONTWRITEBYTECODE=1 RIPRAP_DIR=$root
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
pass() { echo "PASS workPrecision.$1"; }
fail() { echo "FAIL workPrecision.$1 $2"; }

if "$python" tests/python/testRows.py >"$folder/log" 2>&1
then
    pass rows
else
    fail rows "$(grep -E '^(FAIL|ERROR): |Error' "$folder/log" | paste -sd' ' -)"
fi

if said=$(benchmarks/workPrecision -check 2>&1)
then
    pass generated
else
    fail generated "${said//$'\n'/; }"
fi

# Tables of stability are those of the rows, and the tests that they name are there; in a copy with
# another row they are not
if said=$(benchmarks/runStabilityMaps -check 2>&1)
then
    pass stabilityPage
else
    fail stabilityPage "$said"
fi
other=$folder/other
mkdir -p "$other/docs" "$other/tests"
cp -r benchmarks "$other"; cp docs/stability.md "$other/docs"
cp -r tests/regression tests/unit tests/unitFoam "$other/tests"
sed -i 's/^limits,"chain",leapfrog,"largest '\
'dt \/ sqrt(m\/k)",1.0008/limits,"chain",leapfrog,"largest dt \/ sqrt(m\/k)",0.9/' \
    "$other/benchmarks/results/demStability.csv"
"$other/benchmarks/runStabilityMaps" -check >"$folder/log" 2>&1 \
    && fail stabilityRow "another row passes" || { grep -q 'not that of the rows' "$folder/log" \
    && pass stabilityRow || fail stabilityRow "$(tail -1 "$folder/log")"; }
sed -i 's/SymplecticIsStableToTwo/SymplecticIsStableToThree/' \
    "$other"/tests/unit/solvers/sph/soundWave.C
"$other/benchmarks/runStabilityMaps" -check >"$folder/log" 2>&1 \
    && fail stabilityTest "a test that is not there passes" ||
    { grep -q 'there is no test SoundWave.SymplecticIsStableToTwo' "$folder/log" \
    && pass stabilityTest || fail stabilityTest "$(tail -1 "$folder/log")"; }

refused()   # NAME MESSAGE OPTION...
{
    local name=$1 message=$2; shift 2
    said=$(benchmarks/workPrecision "$@" 2>&1) && { fail "$name" "is accepted"; return; }
    grep -qE -- "$message" <<<"$said" && [[ $said != *Traceback* ]] && pass "$name" \
        || fail "$name" "${said//$'\n'/; }"
}
refused noScene "no scene matches 'damBrake'; there are .*taylorGreen" -list -only damBrake
refused budget '-budget takes seconds above 0 and needs -quick or -full' -budget 5
refused both 'not allowed with argument' -quick -full

"$python" -c 'import matplotlib' 2>/dev/null \
    || { echo "SKIP workPrecision.list this python has no matplotlib"; exit 0; }
command -v riprapFoam >/dev/null || . etc/bashrc || { fail list "no environment"; exit 1; }

# A copy of the rows without one of a run that takes half a second: it is the one that is missing,
# and then it is not
copy=$folder/copy
mkdir -p "$copy"
cp -r benchmarks docs etc "$copy"
ln -s "$root/tutorials" "$copy/tutorials"
grep -v ',n16,' benchmarks/results/picTaylorGreen.csv >"$copy/benchmarks/results/picTaylorGreen.csv"
list() { RIPRAP_DIR=$copy "$copy/benchmarks/workPrecision" -list -only taylorGreen; }
before=$(list)
grep -q '^picTaylorGreen n16: about' <<<"$before" && pass missing \
    || fail missing "${before//$'\n'/; }"
command -v riprapFoam >/dev/null || { fail run "no riprapFoam"; exit 1; }
cp "$copy/benchmarks/results/taylorGreen.csv" "$folder/kept"
run=$root/tutorials/picDem/taylorGreen/runs/n16
[[ -e $run ]] || trap 'rm -rf "$folder" "$run"; rm -f "${run%/*}/log.workPrecision"; '\
'rmdir "${run%/*}" 2>/dev/null' EXIT
said=$(cd "$copy" && RIPRAP_RESULTS=$copy/benchmarks/results RIPRAP_DIR=$copy \
    benchmarks/workPrecision -quick -budget 3 -only taylorGreen 2>&1)
line=$(tail -1 "$copy/benchmarks/results/picTaylorGreen.csv")
grep -qE '\[ {20}\] 1/[0-9]+ picTaylorGreen n16: about .* left - took ' <<<"$said" \
    && grep -q '1 runs recorded in' <<<"$said" && pass progress || fail progress "${said//$'\n'/; }"
[[ $line == *,n16,picDem,* && $line == *'1 threads'* ]] && pass recorded || fail recorded "$line"
after=$(list)
grep -q 'picTaylorGreen n16' <<<"$after" && fail again "n16 is still missing" || pass again
cmp -s "$folder/kept" "$copy/benchmarks/results/taylorGreen.csv" && pass budget \
    || fail budget "runs beyond the budget were made"
