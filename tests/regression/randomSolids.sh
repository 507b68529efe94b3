#!/bin/bash
# Fifty random scenes of dem (tests/randomScenes): none stops, nothing is lost or passes a wall,
# energy does not grow, forces balance, restart to the bit
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

"${RIPRAP_PYTHON:-python3}" tests/randomScenes/runDemScenes.py --seeds 1-50 --limit 300
