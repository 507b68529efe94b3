#!/bin/bash
# Which GPUs a build is for (etc/cudaChoice), with an nvcc and an nvidia-smi that only answer
# questions.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# A toolkit: nvcc that knows these architectures, and its static run-time; beside it one without the
# run-time
toolkit()   # FOLDER
{
    mkdir -p "$1/bin" "$1/lib64"
    cat >"$1/bin/nvcc" <<'NVCC'
#!/bin/bash
[[ $1 == --list-gpu-arch ]] && printf 'compute_%s\n' 75 80 90 100
exit 0
NVCC
    chmod +x "$1/bin/nvcc"
}
toolkit "$folder/cuda"; touch "$folder/cuda/lib64/libcudart_static.a"
toolkit "$folder/half"
mkdir "$folder/gpu"
smi()
{
    printf '#!/bin/bash\ncat <<END\n%s\nEND\nexit %s\n' "$1" "${2:-0}" >"$folder/gpu/nvidia-smi"
    chmod +x "$folder/gpu/nvidia-smi"
}

# A checkout without builds: what etc/config decides on its own
mkdir -p "$folder/tree/etc"
cp "$root"/etc/{config,cudaChoice} "$folder/tree/etc/"
mkdir -p "$folder/foam/META-INFO"
echo api=1912 >"$folder/foam/META-INFO/api-info"

# decided PATH [VARIABLE=VALUE]...: what is said, then status, architectures, compiler and name of
# the build
decided()
{
    local path=$1; shift
    env -i "PATH=$path:/usr/bin:/bin" HOME=/ WM_OPTIONS=linux WM_PROJECT_DIR="$folder/foam" \
        RIPRAP_DIR="$folder/tree" RIPRAP_CPU_ARCH= RIPRAP_BUILD=1 "$@" \
        bash -c '. "$RIPRAP_DIR/etc/config"; '\
'echo "status $? for [$RIPRAP_GPU] by [${RIPRAP_NVCC##*/}] as $RIPRAP_OPTIONS"' 2>&1
}
wanted()    # NAME MEANING PATTERN LINES DECIDED
{
    if [[ $5 == $3 && $(wc -l <<<"$5") == "$4" ]]
    then
        echo "PASS cudaChoice.$1"
    else
        echo "FAIL cudaChoice.$1 not so: $2: ${5//$'\n'/; }"
    fi
}
nvcc=$folder/cuda/bin gpu=$folder/cuda/bin:$folder/gpu
alone='status 0 for [[]] by [[]] as linux'
# /usr/local/cuda is looked at as well: where one is installed a machine without nvcc cannot be
# played
[[ -e /usr/local/cuda/bin/nvcc ]] \
    || wanted nothing "no nvcc: the CPU alone, without a word" "$alone" 1 "$(decided "$folder/gpu")"

smi 'NVIDIA-SMI has failed because it could not communicate with the NVIDIA driver. Code 999' 9
wanted noGpu "nvcc without a GPU: the CPU alone, and how it is had for GPUs" \
    "*no GPU*RIPRAP_CUDA_ARCH=90 ./Allwmake*$alone" 2 "$(decided "$nvcc")"
wanted brokenDriver "numbers of an error are no architecture" "*no GPU*$alone" 2 "$(decided "$gpu")"
wanted askedArchitecture "RIPRAP_CUDA_ARCH is built without a GPU" \
    'status 0 for [[]90[]] by [[]nvcc[]] as linux-cuda90' 1 "$(decided "$nvcc" RIPRAP_CUDA_ARCH=90)"
wanted quick "kernels that are not optimised have a build of their own" \
    'status 0 for [[]90[]] by [[]nvcc[]] as linux-cuda90-quick' 1 \
    "$(decided "$nvcc" RIPRAP_CUDA_ARCH=90 RIPRAP_CUDA_QUICK=1)"
wanted quickCpu "of the CPU alone there is no other" "$alone" 1 \
    "$(decided "$nvcc" NVCC= RIPRAP_CUDA_QUICK=1)"
wanted askedSeveral "several architectures, each once" 'status 0 for [[]80 90[]] by [[]nvcc[]] as '\
'linux-cuda80-90' 1 "$(decided "$nvcc" 'RIPRAP_CUDA_ARCH=90 80 90')"
wanted askedCompiler "NVCC names a compiler: asked for" 'status 0 for [[]80 90[]] by [[]nvcc[]] '\
'as linux-cuda80-90' 1 "$(decided /usr/bin "NVCC=$nvcc/nvcc")"
wanted emptyCompiler "NVCC= is the CPU alone, whatever else is asked" "$alone" 1 \
    "$(decided "$gpu" NVCC= RIPRAP_CUDA_ARCH=90)"
wanted noCompiler "NVCC names nothing that is there" \
    '*NVCC=/nowhere/nvcc*no such program*status 1 for*' 2 "$(decided "$nvcc" NVCC=/nowhere/nvcc)"
for wrong in 9.0 sm_90 9 '90 x' '90,80' 90a
do
    wanted "wrong.${wrong// /_}" "an error with the form that is valid" \
        "riprap: RIPRAP_CUDA_ARCH='$wrong'*numbers as 90*status 1 for [[]] by*" 2 \
        "$(decided "$gpu" "RIPRAP_CUDA_ARCH=$wrong")"
done
wanted unknown "an architecture that nvcc does not know: those it knows" \
    "*knows no 70, but 75 80 90 100*status 1 for [[]] by*" 2 "$(decided "$gpu" RIPRAP_CUDA_ARCH=70)"
wanted incomplete "a toolkit without the static run-time: the CPU alone, said" \
    "*libcudart_static.a*$alone" 2 "$(decided "$folder/half/bin" RIPRAP_CUDA_ARCH=90)"

smi 9.0
wanted here "the architecture of the GPU at hand, without a word" \
    'status 0 for [[]90[]] by [[]nvcc[]] as linux-cuda90' 1 "$(decided "$gpu")"
wanted notHere "what is asked, not what is here" \
    'status 0 for [[]80[]] by [[]nvcc[]] as linux-cuda80' 1 "$(decided "$gpu" RIPRAP_CUDA_ARCH=80)"
smi $'9.0\n8.0\n9.0\n9.0'
wanted severalHere "of several GPUs each architecture once" \
    'status 0 for [[]80 90[]] by [[]nvcc[]] as linux-cuda80-90' 1 "$(decided "$gpu")"
smi 12.0
wanted newer "a GPU newer than nvcc: PTX of the newest it knows" '*sm_120, newer than*built for '\
'100*status 0 for [[]100[]] by [[]nvcc[]] as linux-cuda100' 2 "$(decided "$gpu")"
smi 6.1
wanted older "a GPU that nvcc has dropped: the CPU alone, said" \
    "*sm_61, which*no longer knows*$alone" 2 "$(decided "$gpu")"
smi '[N/A]'
wanted noAnswer "a driver that does not say: the CPU alone, said" "*no GPU*$alone" 2 \
    "$(decided "$gpu")"

# A last build is taken where nothing is said, but for a build
mkdir "$folder/tree/platforms"
printf '%s\n' RIPRAP_OPTIONS=linux-cuda90 RIPRAP_NVCC=nvcc RIPRAP_CUDA_LIB= RIPRAP_GPU=90 \
    RIPRAP_MARCH= >"$folder/tree/platforms/last"
last=$(env -i "PATH=$nvcc:/usr/bin:/bin" WM_OPTIONS=linux \
    WM_PROJECT_DIR="$folder/foam" RIPRAP_DIR="$folder/tree" bash -c '. "$RIPRAP_DIR/etc/config"; '\
'echo "status $? for [$RIPRAP_GPU] by [$RIPRAP_NVCC] as $RIPRAP_OPTIONS"' 2>&1)
wanted last "without a word the last build is taken" \
    'status 0 for [[]90[]] by [[]nvcc[]] as linux-cuda90' 1 "$last"

# The time is told before a first build begins, in proportion to architectures and jobs, and not of
# a later one
told()      # JOBS [VARIABLE=VALUE]...: Allwmake up to where it would compile
{
    local jobs=$1 copy=$folder/checkout; shift
    if [[ ! -d $copy ]]
    then
        mkdir -p "$copy"
        cp -r "$root"/{Allwmake,etc} "$copy/"
        ln -s "$root/.deps" "$copy/.deps"
        # wmake takes the first folder for a failure: nothing is compiled
        mkdir -p "$copy/src/Make"; printf 'xNone.C\nLIB = none\n' >"$copy/src/Make/files"
        echo '$(error nothing is to be compiled)' >"$copy/src/Make/options"
    fi
    (cd "$copy" && env -u NVCC -u RIPRAP_CUDA_ARCH -u RIPRAP_CUDA_QUICK \
        -u RIPRAP_CPU_ARCH RIPRAP_BOOTSTRAP=no "$@" ./Allwmake -j "$jobs" 2>&1)
}
said=$(told 2 NVCC= RIPRAP_CPU_ARCH=)
minutes() { sed -n 's/^riprap: a first build, about \([0-9]*\) minutes with.*/\1/p' <<<"$1"; }
one=$(minutes "$said")
two=$(minutes "$(told 2 NVCC="$nvcc/nvcc" RIPRAP_CUDA_ARCH='80 90' RIPRAP_CPU_ARCH=)")
four=$(minutes "$(told 4 NVCC= RIPRAP_CPU_ARCH=)")
if [[ -n $one && -n $two && -n $four ]] && ((two == one + 24 && four*2 >= one && four < one))
then echo "PASS cudaChoice.time"
else
    echo "FAIL cudaChoice.time minutes told of a first build with 2 jobs, with two architectures, \
with 4 jobs: '$one' '$two' '$four': $(tail -3 <<<"$said" | tr '\n' ' ')"
fi
options=$(sed -n 's/^RIPRAP_OPTIONS //p' <<<"$(cd "$folder/checkout" \
    && env NVCC= RIPRAP_CPU_ARCH= bash -c '. etc/bashrc; echo "RIPRAP_OPTIONS $RIPRAP_OPTIONS"')")
touch "$folder/checkout/platforms/$options/lib/libriprap.so"
later=$(told 2 NVCC= RIPRAP_CPU_ARCH=)
[[ -z $(minutes "$later") && $later == *'[1/1] src'* ]] && echo "PASS cudaChoice.timeOnce" \
    || echo "FAIL cudaChoice.timeOnce a later build: ${later//$'\n'/; }"
wrong=$(RIPRAP_BOOTSTRAP=maybe "$root/Allwmake" 2>&1)
[[ $? == 2 && $wrong == *'RIPRAP_BOOTSTRAP=maybe: yes or no'* ]] \
    && echo "PASS cudaChoice.bootstrapWord" || echo "FAIL cudaChoice.bootstrapWord $wrong"
