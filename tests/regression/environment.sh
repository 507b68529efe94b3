#!/bin/bash
# Set-up: what etc/bootstrap, etc/bashrc and the Make files promise.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root" || exit 1

expect()    # NAME WHAT-IT-MEANS COMMAND...
{
    local name=$1 meaning=$2; shift 2
    if "$@" >/dev/null 2>&1; then echo "PASS $name"; else echo "FAIL $name not so: $meaning"; fi
}
# The value of a variable in a fresh shell that has sourced etc/bashrc, with the settings given
variable() { local name=$1; shift; env -u NVCC -u RIPRAP_CUDA_ARCH -u RIPRAP_CPU_ARCH "$@" bash -c ". etc/bashrc; echo \"\$$name\""; }

silent() { local said; said=$(etc/bootstrap 2>&1) && [[ -z $said ]]; }
expect bootstrapNothingToDo "says nothing and does nothing when all is there" silent

unknown() { local said; said=$(etc/bootstrap --nonsense 2>&1); [[ $? == 1 && $said == *--paraview* ]]; }
expect bootstrapUnknownOption "an unknown option is an error that lists the valid ones" unknown

strict() { bash -euc '. etc/bashrc; [[ $- == *e* && $- == *u* ]]'; }
expect bashrcStrict "can be sourced under set -eu, which stays set" strict

twice() { bash -c '. etc/bashrc; one=$PATH:$LD_LIBRARY_PATH; . etc/bashrc; [[ $one == "$PATH:$LD_LIBRARY_PATH" ]]'; }
expect bashrcTwice "sourced again, it changes nothing" twice

ownFolders() { [[ $(variable FOAM_USER_APPBIN) == "$root"/platforms/* && $(variable FOAM_APPBIN) != /usr/bin ]]; }
expect bashrcOwnFolders "nothing can be linked into /usr/bin" ownFolders

forCpu() { [[ $(variable RIPRAP_OPTIONS NVCC=) != *cuda* && -z $(variable RIPRAP_NVCC NVCC=) ]]; }
expect buildForCpu "NVCC= builds for the CPU alone" forCpu

architectures() { [[ $(variable RIPRAP_OPTIONS NVCC=nvcc "RIPRAP_CUDA_ARCH=80 90" RIPRAP_CPU_ARCH=) == *Opt-cuda80-90 ]]; }
expect buildArchitectures "the build's name has the GPUs' architectures, and no -march when it is empty" architectures

# In an empty folder of a copy: the refusal must leave nothing behind in src
refused()
{
    local folder said; folder=$(mktemp -d)
    mkdir "$folder/Make"; cp src/Make/options "$folder/Make/"; echo x.C >"$folder/Make/files"
    said=$(. etc/bashrc; cd "$folder" && wmake libso 2>&1); local status=$?
    rm -rf "$folder"
    [[ $status != 0 && $said == *Allwmake* ]]
}
expect plainWmakeRefused "plain wmake, which would mix builds, points to Allwmake" refused
