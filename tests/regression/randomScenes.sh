#!/bin/bash
# The first of 50 random scenes with an empty sphProperties (tests/randomScenes; tests/Allverify
# runs all): none stops, nothing passes a wall
# or lies in a body, energy does not grow
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

"${RIPRAP_PYTHON:-python3}" tests/randomScenes/runScenes.py --seeds 1-10 --limit 300
