#!/bin/bash
# What one to three processes do together (tests/ranks): the pressure with free bodies, particles
# that change their process, scenes of spheres.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL ranks no environment"; exit 1; }
command -v rankTests >/dev/null || { echo "FAIL ranks no rankTests: build tests/ranks"; exit 1; }
command -v mpirun >/dev/null || { echo "SKIP ranks no mpirun"; exit 0; }
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
export OMP_NUM_THREADS=1

for n in 1 2 3
do
    launch=(rankTests)
    ((n == 1)) \
        || launch=(mpirun -np $n --oversubscribe --mca mpi_yield_when_idle 1 rankTests -parallel)
    "${launch[@]}" >log 2>&1
    status=$?
    cat log
    ((status == 0)) || grep -q '^FAIL ' log || echo "FAIL ranks.$n exit status $status"
done
