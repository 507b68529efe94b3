#!/bin/bash
# Do sources for GPUs compile? Where there is nvcc but no build for GPUs: units of two solvers and
# one of what is left, in the least time and without a warning. Which follows from the number of the
# commit, so that all have their turn.
#
#   tests/regression/cudaUnits.sh [-all]        -all: every unit
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 2
. etc/bashrc || { echo "FAIL cudaUnits etc/bashrc"; exit 1; }
[[ -z $RIPRAP_NVCC ]] || { echo "SKIP cudaUnits this build compiles all of them"; exit 0; }

scratch=$(mktemp -d); trap 'rm -rf "$scratch"' EXIT
# The flags of such a build
unset NVCC RIPRAP_BUILD
export RIPRAP_CUDA_ARCH=90 RIPRAP_CUDA_QUICK=1 RIPRAP_WERROR=1
. etc/config 2>"$scratch/said" || { echo "FAIL cudaUnits $(head -1 "$scratch/said")"; exit 1; }
[[ -n $RIPRAP_NVCC ]] || { echo "SKIP cudaUnits there is no nvcc"; exit 0; }
flags=$(printf 'RIPRAP_DIR = %s\ninclude etc/wmake/cuda\nflags: ; @echo $(NVCC_FLAGS)\n' "$PWD" \
    | make -s -f - flags) || { echo "FAIL cudaUnits no flags"; exit 1; }

mapfile -t units < <(ls src/solvers/instantiate/*Gpu*.cu)
mapfile -t others < <(find src tests/unit -name '*.cu' -not -path '*/instantiate/*' | LC_ALL=C sort)
turn=0
if git rev-parse -q --verify HEAD >/dev/null 2>&1
then
    turn=$(git rev-list --count HEAD)
fi
if [[ ${1:-} == -all ]]
then
    chosen=("${units[@]}" "${others[@]}")
else
    # half of the list apart: of another solver
    n=${#units[@]}
    chosen=("${units[turn % n]}" "${units[(turn + n/2) % n]}" "${others[turn % ${#others[@]}]}")
fi

status=0
for unit in "${chosen[@]}"
do
    # shellcheck disable=SC2086
    if "$RIPRAP_NVCC" $flags "-I$(dirname "$unit")" -Itests/unit -c "$unit" -o "$scratch/o" \
        >"$scratch/said" 2>&1
    then
        echo "PASS cudaUnits $unit"
    else
        echo "FAIL cudaUnits $unit $(grep -m1 -E 'error|warning' "$scratch/said")"; status=1
    fi
done
exit $status
