#!/bin/bash
# Random scenes with an empty sphProperties (tests/randomScenes): none stops, nothing passes a wall
# or lies in a body, energy does not grow
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."

"${RIPRAP_PYTHON:-python3}" tests/randomScenes/runScenes.py --limit 300
