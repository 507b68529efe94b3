#!/bin/bash
# Tutorials that were copied: their scripts find riprap by the environment, and say so where there
# is none.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL copies no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL copies no $program"; exit 1; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
pass() { echo "PASS copies.$1"; }
fail() { echo "FAIL copies.$1 $2"; }

# Of every tutorial, at another depth than in the checkout
lost= silent=
for case in "$root"/tutorials/*/*/
do
    [[ -x $case/Allrun ]] || continue
    name=$(basename "$(dirname "$case")")-$(basename "$case")
    mkdir "$name"; cp "$case"/All* "$name"
    "$name/Allrun" -help 2>&1 | grep -q '^Usage: Allrun' || lost+=" $name/Allrun"
    "$name/Allclean" >log 2>&1 && [[ ! -s log ]] || lost+=" $name/Allclean"
    for script in "$name"/All{run,clean,verify}
    do
        (unset RIPRAP_DIR; "$script" -help) >log 2>&1 && silent+=" $script"
        grep -q 'RIPRAP_DIR: source etc/bashrc of riprap first' log || silent+=" $script"
    done
done
[[ -z $lost ]] && pass found || fail found "do not find riprap:$lost"
[[ -z $silent ]] && pass told || fail told "do not say what is missing:$silent"

# One of them runs; and one that takes another's files, which is copied alone
run()       # MODULE/CASE NAME OPTIONS...
{
    local of=$1 name=$2 copy=${1//\//-}; shift 2
    rm -rf "$copy"; cp -r "$root/tutorials/$of" "$copy"; rm -rf "$copy/runs"
    (cd / && "$folder/$copy/Allrun" -noPlot -name "$name" "$@") >log 2>&1
    [[ $(tail -3 "$copy/runs/$name/log.riprapFoam" 2>/dev/null) == *End* ]] && pass "run.$of" \
        || fail "run.$of" "$(tail -3 log | tr '\n' ' ')"
}
run dem/dryCollapse short -endTime 0.002
run picDem/dryCollapse short -endTime 0.002
# Verified: with the bounds of the checkout, and nothing written into it
before=$(cd "$root" && git status --short benchmarks/results docs/images 2>/dev/null)
dem-dryCollapse/Allverify -quick >log 2>&1
grep -q 'all within bounds' log && pass verify || fail verify "$(tail -3 log | tr '\n' ' ')"
[[ $(cd "$root" && git status --short benchmarks/results docs/images 2>/dev/null) == "$before" ]] \
    && pass unrecorded || fail unrecorded "a copy's results are in the checkout"
