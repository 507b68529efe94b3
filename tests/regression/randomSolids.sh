#!/bin/bash
# The first of 50 random scenes of dem (tests/randomScenes; tests/Allverify runs all): none stops,
# nothing is lost or passes a wall, energy does not grow, forces balance, restart to the bit
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

"${RIPRAP_PYTHON:-python3}" tests/randomScenes/runDemScenes.py --seeds 1-10 --limit 300
