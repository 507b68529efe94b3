#!/bin/bash
# riprapRender and the charts' style: unit tests of their parts, and what is on pictures of made
# cases. No solver runs
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.."
python=${RIPRAP_PYTHON:-/usr/bin/python3}
"$python" -c 'import matplotlib' 2>/dev/null \
    || { echo "SKIP pictures this python has no matplotlib"; exit 0; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0
export PYTHONDONTWRITEBYTECODE=1 RIPRAP_PYTHON=$python
if "$python" tests/python/testPictures.py >"$folder/log" 2>&1
then
    echo "PASS pictures unit tests"
else
    echo "FAIL pictures unit tests: $(grep -E '^(FAIL|ERROR): ' "$folder/log" | paste -sd' ' -)"
    status=1
fi
sed 's/^/    /' "$folder/log"
mkdir "$folder/cases"
"$python" tests/python/checkPictures.py "$folder/cases" || status=1
exit $status
