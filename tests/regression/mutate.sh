#!/bin/bash
# 150 mutations of the tutorials' dictionaries (tests/mutate): each ends with one clear message, or
# runs
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."
. etc/bashrc || { echo "FAIL mutate no environment"; exit 1; }

log=$(mktemp)
trap 'rm -f "$log"' EXIT
if tests/mutate/run --sample 150 --seed 1 --limit 120 >"$log" 2>&1
then
    echo "PASS mutate $(tail -1 "$log")"
else
    echo "FAIL mutate $(tail -1 "$log")"
fi
cat "$log"
