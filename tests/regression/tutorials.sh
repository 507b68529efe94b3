#!/bin/bash
# Quick verification of every tutorial: one coarse run each against its own bounds
# (tests/regression/tolerances.csv, level quick)
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
status=0
for verify in tutorials/*/*/Allverify
do
    name="tutorial ${verify#tutorials/}"
    name=${name%/Allverify}
    if RIPRAP_RESULTS=$results "$verify" -quick >"$results/log" 2>&1
    then
        echo "PASS $name"
    else
        echo "FAIL $name $(grep -E 'OUT OF BOUNDS|FAILED|bound without|no bounds|rror:' \
            "$results/log" | head -1 | tr -s ' ')"
        status=1
    fi
    sed 's/^/    /' "$results/log"
done
exit $status
