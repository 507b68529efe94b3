#!/bin/bash
# The first of 50 random scenes of picDem with bodies (tests/randomScenes; tests/Allverify runs
# all): none stops, nothing is lost or passes a wall, energy does not grow, momentum balances, runs
# repeat and continue to the bit
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

"${RIPRAP_PYTHON:-python3}" tests/randomScenes/runPicScenes.py --seeds 1-8 --end 0.25 --limit 300
