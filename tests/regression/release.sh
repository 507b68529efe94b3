#!/bin/bash
# What etc/release and etc/install make: sources, and programs that run in another folder on a
# machine that has nothing of them.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL release no environment"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
pass() { echo "PASS release.$1"; }
fail() { echo "FAIL release.$1 $(tr '\n' ' ' <<<"$2")"; }
# says NAME PATTERN COMMAND...: it fails, and all that it says is one line like the pattern
says()
{
    local name=$1 pattern=$2 said; shift 2
    said=$("$@" 2>&1) && { fail "$name" "no error: $said"; return; }
    [[ $said == $pattern && $(wc -l <<<"$said") == 1 ]] && pass "$name" || fail "$name" "$said"
}

# Sources: a clone of what is committed, with tags of its own
if [[ -e $root/.git ]]
then
    git clone -q --no-tags "file://$root" clone 2>log || { fail clone "$(<log)"; exit 1; }
    # with the scripts as they are now, and without the large part
    cp "$root"/etc/{release,version} clone/etc/
    git -C clone rm -rq docs benchmarks tutorials
    commit()
    {
        git -C clone add -A
        git -C clone -c user.name=test -c user.email=test@localhost commit -qam "$1" --allow-empty
    }
    commit test
    version=$(clone/etc/version)
    clone/etc/release --source one >log 2>&1 && clone/etc/release --source two >>log 2>&1 \
        || fail sources "$(<log)"
    name=riprap-$version
    if cmp one/"$name.tar.gz" two/"$name.tar.gz" >>log 2>&1
    then
        pass sourcesTwice
    else
        fail sourcesTwice "$(tail -1 log)"
    fi
    (cd one && sha256sum --quiet -c SHA256SUMS) >log 2>&1 && [[ $(wc -l <one/SHA256SUMS) == 1 ]] \
        && pass sums || fail sums "$(cat log one/SHA256SUMS)"
    if ! command -v xz >/dev/null; then echo "SKIP release.xz no xz"
    elif clone/etc/release --source --xz three >log 2>&1 && xz -dc three/"$name.tar.xz" \
        | cmp - <(gzip -dc one/"$name.tar.gz") >>log 2>&1; then pass xz
    else fail xz "$(tail -1 log)"; fi
    tar xzf one/"$name.tar.gz"
    lost=$(diff <(git -C clone ls-files | sort; echo VERSION) <(cd "$name" \
        && find . -type f -o -type l | sed 's,^\./,,' | sort) | grep '^[<>] ' \
    | grep -v '^[<>] VERSION')
    [[ -z $lost && -x $name/Allwmake ]] && pass sourcesWhole \
        || fail sourcesWhole "not the same files: $(head -3 <<<"$lost")"
    [[ $("$name/etc/version") == "$version" ]] && pass sourcesVersion \
        || fail sourcesVersion "$("$name/etc/version") in place of $version"
    says sourcesOfTarball '*from a git checkout only' "$name/etc/release" --source x
    echo >>"$PWD"/clone/README.md
    says sourcesChanged '*tracked files are changed*commit first' clone/etc/release --source x
    commit changed; git -C clone tag v9.8.7
    says tagWithoutChanges "*CHANGELOG.md has no heading '## v9.8.7'" clone/etc/release --source x
    sed -i '0,/^## v.*/s//## v9.8.7 (not released)/' "$PWD"/clone/CHANGELOG.md; commit heading
    git -C clone tag -f v9.8.7 >/dev/null
    says tagUnreleased '*CHANGELOG.md says that v9.8.7 is not released' clone/etc/release --source x
    sed -i 's/^## v9.8.7.*/## v9.8.7/' "$PWD"/clone/CHANGELOG.md; commit released
    git -C clone tag -f v9.8.7 >/dev/null
    says tagCitation '*CITATION.cff has another version than 9.8.7' clone/etc/release --source x
    sed -i 's/^version: .*/version: 9.8.7/' clone/CITATION.cff; commit cited
    git -C clone tag -f v9.8.7 >/dev/null
    clone/etc/release --source tagged >log 2>&1 && [[ -s tagged/riprap-9.8.7.tar.gz \
        && $(tar xzOf tagged/riprap-9.8.7.tar.gz riprap-9.8.7/VERSION) == v9.8.7 ]] && pass tag \
        || fail tag "$(<log)"
else
    echo "SKIP release.sources not a git checkout"
fi

says unknownOption "*unknown option '--nothing'*" "$root/etc/release" --nothing
says bothAlone '*--source or --binary*' "$root/etc/release" --source --binary
says installNowhere '*no folder given*' "$root/etc/install" --foam
says installSmall '*--small goes with --foam*' "$root/etc/install" --small x
mkdir full; touch full/file
says installFull '*full is not empty' "$root/etc/install" full
says installNotBuilt '*not built*run ./Allwmake' env NVCC= RIPRAP_CPU_ARCH=x86-64-v2 \
    "$root/etc/install" x
says installNative '*RIPRAP_CPU_ARCH=native is for this processor alone*' env NVCC= \
    RIPRAP_CPU_ARCH=native "$root/etc/install" --foam x

# Programs, packed, unpacked and moved: a shell that knows nothing of OpenFOAM
"$root/etc/release" --binary --no-build packed >log 2>&1 \
    || { fail binary "$(tail -3 log)"; exit 1; }
tar xzf packed/*.tar.gz
mkdir else; mv riprap-*-linux-* else/moved
moved=$folder/else/moved
rm -rf packed
bare() { env -i PATH=/usr/bin:/bin "$@"; }
others=$(bare LD_LIBRARY_PATH="$moved/lib" ldd "$moved"/libexec/* "$moved"/lib/*.so \
    | awk '/=> not found/ {print $1, "not found"} /=> \// {print $3}' | sort -u |
    grep -vE "^$moved/lib/|/(ld-linux[^/]*|libc|libm|libdl|libpthread|librt|libresolv|libutil)\.so")
[[ -z $others ]] && pass whole || fail whole "loads from elsewhere, or does not find: $others"
grep -q '^openfoam .* openfoam$\|^OpenFOAM' "$moved/licences/README" \
    && grep -q '^libstdc++6 ' "$moved/licences/README" && [[ -s $moved/LICENSE ]] \
    && pass licences ||
    fail licences "$(<"$moved/licences/README")"
[[ $(bare "$moved/etc/version") == "$("$root/etc/version")" ]] && pass binaryVersion \
    || fail binaryVersion "$(bare "$moved/etc/version")"

options=(-spacing 0.006 -endTime 0.01 -set "system/controlDict:writeInterval 0.01" -name short)
(cd else && bare moved/bin/riprapCase sphDem/damBreak3D "${options[@]}" -noPlot) >log 2>&1 \
    && [[ $(tail -1 log) == *': done in '* ]] && pass moved || fail moved "$(tail -5 log)"
# The same by the checkout, in every bit
"$root/bin/riprapCase" sphDem/damBreak3D -to own "${options[@]}" -noPlot >log 2>&1 \
    || fail own "$(tail -3 log)"
for file in 0.01/lagrangian/fluid/positions postProcessing/front/0/frontPosition.dat
do
    a=else/damBreak3D/runs/short/$file b=own/runs/short/$file
    [[ -e $a || -e $b ]] || { fail same "no $file: $(find own -name '*.dat' | head -3)"; continue; }
    cmp "$a" "$b" >log 2>&1 && pass "same.${file##*/}" || fail "same.${file##*/}" "$(<log)"
done

# Whatever else is sourced: another OpenFOAM's place, libraries
(cd else && bare WM_PROJECT_DIR=/nowhere FOAM_ETC=/nowhere WM_PROJECT_ETC=/nowhere \
    LD_LIBRARY_PATH=/nowhere moved/bin/setParticles -help) >log 2>&1 && pass sourced \
    || fail sourced "$(tail -3 log)"

# Through a link in a folder of PATH, and from a shell that has sourced its bashrc: a tutorial
# copied by hand
mkdir links; ln -s "$moved/bin/blockMesh" links/
bare PATH="$folder/links:/usr/bin:/bin" blockMesh -help >log 2>&1 && pass linked \
    || fail linked "$(tail -3 log)"
cp -r "$moved/tutorials/dem/dryCollapse" hand
bare bash -c ". $moved/etc/bashrc && hand/Allrun -noPlot -endTime 0.002 -name short" >log 2>&1 \
    && [[ $(tail -3 hand/runs/short/log.riprapFoam) == *End* ]] && pass hand \
    || fail hand "$(tail -3 log)"

# Without Python: one line, and the run goes on; a case that needs it says so
(cd else && bare RIPRAP_PYTHON=/nowhere/python3 moved/bin/riprapCase sphDem/damBreak3D \
    -to plain -spacing 0.006 -endTime 0.0025 -set "system/controlDict:writeInterval 0.0025" \
    -name short) >log 2>&1 &&
    [[ $(grep -c 'No plots: /nowhere/python3 has no numpy and matplotlib' log) == 1 \
    && $(tail -1 log) == *': done in '* ]] && pass noPython || fail noPython "$(<log)"
bare RIPRAP_PYTHON=/nowhere/python3 "$moved/bin/riprapCase" dem/impacts -to impacts \
    -noPlot >log 2>&1
[[ $? == 1 && $(<log) == *'makeParticles needs Python with numpy and matplotlib, '\
'which /nowhere/python3 is not'* ]] && pass needsPython || fail needsPython "$(<log)"

says caseUnknown "riprapCase: no tutorial 'damBreak3D'; \
there is: picDem/damBreak3D sphDem/damBreak3D" "$moved/bin/riprapCase" damBreak3D
says caseNowhere "riprapCase: no tutorial 'x/y'; riprapCase -list shows those there are" \
    "$moved/bin/riprapCase" x/y
says caseThere '*damBreak3D is there already*-to FOLDER' env \
    -C else moved/bin/riprapCase sphDem/damBreak3D
says caseBlank '*no folder with a blank*' "$moved/bin/riprapCase" sphDem/damBreak3D -to 'a b'
says caseInside '*would lie in the tutorial itself*' "$moved/bin/riprapCase" sphDem/damBreak3D \
    -to "$moved/tutorials/sphDem/damBreak3D/run"
says caseOptionFirst '*first a tutorial*' "$moved/bin/riprapCase" -spacing 1 sphDem/damBreak3D
[[ $("$moved/bin/riprapCase" -list | wc -l) == \
    "$(find "$root"/tutorials -mindepth 3 -maxdepth 3 -name Allrun | wc -l)" ]] \
    && pass list || fail list "$("$moved/bin/riprapCase" -list | wc -l) tutorials"

# An older C library, and an installation that was cut
sed -i.bak "s/^builtGlibc=.*/builtGlibc='2.999'/" "$moved/etc/built"
says oldLibrary 'riprapFoam: this system has glibc 2.*; this riprap needs 2.999*' \
    "$moved/bin/riprapFoam" -help
mv "$moved/etc/built.bak" "$moved/etc/built"
rm "$moved/libexec/checkMesh"
says cut 'checkMesh: no */libexec/checkMesh' "$moved/bin/checkMesh" -help
rm -r "$moved/openfoam"
says noFoam 'riprapFoam: no OpenFOAM in *' "$moved/bin/riprapFoam" -help

# Without OpenFOAM's function objects and most of its programs: all that a tutorial calls is there
"$root/etc/install" --foam --small small >log 2>&1 && [[ ! -e small/bin/snappyHexMesh \
    && ! -e small/lib/libfieldFunctionObjects.so ]] &&
    bare RIPRAP_PYTHON=/nowhere small/bin/riprapCase sphDem/damBreak3D \
        -to smallCase -spacing 0.006 -endTime 0.0025 -noPlot >log 2>&1 && pass small \
    || fail small "$(tail -3 log)"

# Beside the OpenFOAM of this machine, without one inside
"$root/etc/install" beside >log 2>&1 && [[ ! -e beside/openfoam ]] \
    && bare RIPRAP_PYTHON=/nowhere beside/bin/riprapCase sphDem/damBreak3D -to besideCase \
    -spacing 0.006 -endTime 0.0025 -noPlot >log 2>&1 && pass beside || fail beside "$(tail -3 log)"
