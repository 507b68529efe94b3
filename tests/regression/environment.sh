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
variable()
{
    local name=$1
    shift
    env -u NVCC -u RIPRAP_CUDA_ARCH -u RIPRAP_CUDA_QUICK -u RIPRAP_CPU_ARCH "$@" \
        bash -c ". etc/bashrc; echo \"\$$name\""
}

silent() { local said; said=$(etc/bootstrap 2>&1) && [[ -z $said ]]; }
expect bootstrapNothingToDo "says nothing and does nothing when all is there" silent

unknown()
{
    local said
    said=$(etc/bootstrap --nonsense 2>&1)
    [[ $? == 1 && $said == *--paraview* ]]
}
expect bootstrapUnknownOption "an unknown option is an error that lists the valid ones" unknown

strict() { bash -euc '. etc/bashrc; [[ $- == *e* && $- == *u* ]]'; }
expect bashrcStrict "can be sourced under set -eu, which stays set" strict

twice()
{
    bash -c '. etc/bashrc; one=$PATH:$LD_LIBRARY_PATH; . etc/bashrc; '\
'[[ $one == "$PATH:$LD_LIBRARY_PATH" ]]'
}
expect bashrcTwice "sourced again, it changes nothing" twice

ownFolders()
{
    [[ $(variable RIPRAP_APPBIN) == "$root"/platforms/* && $(variable FOAM_APPBIN) != /usr/bin ]]
}
expect bashrcOwnFolders "nothing can be linked into /usr/bin" ownFolders

commands() { bash -c '. etc/bashrc; riprapRender -help' | grep -q -- '-film'; }
expect bashrcCommands "commands of bin are on the path" commands

# In a shell without OpenFOAM, and in one that has it: its own values, the user's or OpenFOAM's
bare=(env -i "HOME=$HOME" "PATH=/usr/bin:/bin" NVCC=)
usersFolders()
{
    local given found
    given=$("${bare[@]}" FOAM_USER_APPBIN=/mine/bin FOAM_USER_LIBBIN=/mine/lib \
        bash -c '. etc/bashrc; echo "$FOAM_USER_APPBIN $FOAM_USER_LIBBIN"')
    found=$("${bare[@]}" bash -c '. .deps/OpenFOAM-v*/etc/bashrc; . etc/bashrc; '\
'echo "$FOAM_USER_APPBIN $FOAM_USER_LIBBIN"')
    [[ $given == '/mine/bin /mine/lib' && $found != *"$root"* && $found == /*/bin\ /*/lib ]]
}
expect bashrcUsersFolders "FOAM_USER_APPBIN and FOAM_USER_LIBBIN stay the user's" usersFolders

forCpu() { [[ $(variable RIPRAP_OPTIONS NVCC=) != *cuda* && -z $(variable RIPRAP_NVCC NVCC=) ]]; }
expect buildForCpu "NVCC= builds for the CPU alone" forCpu

architectures()
{
    [[ $(variable RIPRAP_OPTIONS NVCC=nvcc "RIPRAP_CUDA_ARCH=80 90" RIPRAP_CPU_ARCH=) =~ \
        Opt(-v[0-9]+)?-cuda80-90$ ]]
}
expect buildArchitectures \
    "the build's name has the GPUs' architectures, and no -march when it is empty" architectures

# An OpenFOAM that is sourced already, made of folders alone: what it is decides. Built with two
# versions, nothing mixes
sourced()   # API VERSION [ABSENT]: of the folders META-INFO, wmake and src
{
    local folder said status name; folder=$(mktemp -d)
    mkdir -p "$folder"/{META-INFO,wmake,src/OpenFOAM}
    echo "api=$1" >"$folder/META-INFO/api-info"; ln -s /bin/true "$folder/wmake/wmake"
    for name in ${3:-}; do rm -r "${folder:?}/$name"; done
    said=$("${bare[@]}" WM_PROJECT_DIR="$folder" \
        WM_PROJECT_VERSION="$2" WM_OPTIONS=linux64GccDPInt32Opt RIPRAP_CPU_ARCH=x86-64-v3 \
        bash -c '. etc/bashrc; echo "status $? $RIPRAP_OPTIONS $RIPRAP_LAST"' 2>&1)
    [[ $said == *'status 0'* ]] || { "${bare[@]}" WM_PROJECT_DIR="$folder" WM_PROJECT_VERSION="$2" \
        etc/bootstrap >"$folder/boot" 2>&1; said+=" bootstrap $? $(wc -l <"$folder/boot") lines"; }
    rm -rf "$folder"
    echo "${said//$folder/FOLDER}"
}
twoVersions()
{
    local newer older; newer=$(sourced 2512 v2512) older=$(sourced 1912 v1912)
    [[ $newer == *"status 0 linux64GccDPInt32Opt-v2512-x86-64-v3 $root/platforms/last-v2512" \
        && $older == *"status 0 linux64GccDPInt32Opt-x86-64-v3 $root/platforms/last" ]]
}
expect buildVersions "a build's name has OpenFOAM's version, but for v1912, \
and each version has a last build of its own" twoVersions
otherFoam()
{
    local kind said
    for kind in '13 META-INFO|OpenFOAM 13 in FOLDER is openfoam.org' 'dev META-INFO|OpenFOAM dev '\
'in FOLDER is openfoam.org' 'v1806 META-INFO|OpenFOAM v1806 in FOLDER is too old' \
        'v2412 wmake|OpenFOAM v2412 in FOLDER has no wmake or no headers' \
        'v2412 src|OpenFOAM v2412 in FOLDER has no wmake or no headers'
    do
        said=$(sourced 2412 ${kind%%|*})
        [[ $said == "riprap: ${kind#*|}"*'status 1'*'bootstrap 1 1 lines' \
            && $(wc -l <<<"$said") == 2 ]] || { echo "$said"; return 1; }
    done
}
expect foamThatCannotServe "a sourced OpenFOAM of openfoam.org, an old one, \
and one without wmake or headers get one message each" otherFoam

# Links of all documents: files, and headings by the anchors that GitHub makes of them
broken=$(etc/checkDocs --links) && echo "PASS documentationLinks" \
    || echo "FAIL documentationLinks ${broken//$'\n'/; }"

# The manual: links, and no paragraph, sentence or cell that is too long to read
wrong=$(etc/checkDocs) && echo "PASS docs" || echo "FAIL docs ${wrong//$'\n'/; }"
cells()
{
    local f
    f=$(mktemp --suffix=.md)
    printf '%s\n' "$1" >"$f"
    etc/checkDocs "$f"
    local status=$?
    rm -f "$f"
    return $status
}
words() { local n=$1; printf 'word %.0s' $(seq "$n"); }
caught()
{
    local bad
    for bad in "$(words 36)" "$(for k in 1 2 3; do words 27; echo .; done)" "| $(words 26)|" \
        '[a](nothing)' '[a](#nothing)' '$a \, b$'
    do
        ! cells "$bad" || return 1
    done
    cells "$(words 35)." && cells "| $(words 25)|" && cells "    $(words 90)" && cells '[a](#b)

# B'
}
expect docsChecked \
    "etc/checkDocs finds what is too long, and broken links and formulas, and nothing else" caught

# Documents and sources that comments and documents name: from the root, from src, or by the bare
# name
named()
{
    python3 - <<'END'
import pathlib, re, subprocess, sys
files = subprocess.run(["git", "ls-files"], capture_output=True, text=True).stdout.split()
names = {pathlib.Path(f).name for f in files}
missing = set()
for path in files:
    if not re.search(r"(\.(hpp|H|C|cu|sh|py|md)|/All\w+)$", path): continue
    text = pathlib.Path(path).read_text(errors="replace")
    if not path.endswith(".md"):
        text = "\n".join(l for l in text.split("\n") if "#include" not in l)
    for word in re.findall(r"\bdocs/\w+\b(?![./\w])", text):
        if not pathlib.Path(word).exists() and not pathlib.Path(word + ".md").exists():
            missing.add(f"{path}: {word}")
    for word in re.findall(r"(?<![\w./${])(?:[a-z][A-Za-z0-9]*/)*[A-Za-z][A-Za-z0-9]*"
                           r"\.(?:md|hpp|H|cu|C)\b", text):
        # examples, members, what Allwmake writes
        if re.match(r"my[A-Z]|x\.|x[A-Z]|self\.|riprapBuild\.H", pathlib.Path(word).name): continue
        folders = pathlib.Path(path).parent, pathlib.Path("."), pathlib.Path("src")
        here = any((folder/word).exists() for folder in folders)
        if not here and not ("/" not in word and word in names): missing.add(f"{path}: {word}")
print("; ".join(sorted(missing)))
sys.exit(bool(missing) or not files)
END
}
missing=$(named) && echo "PASS namedFiles" || echo "FAIL namedFiles there is no$missing"

# check NAME COMMAND...: what it prints is the reason of a failure; its exit status 3 means that a
# program for it is not installed
check()
{
    local name=$1 said status; shift
    said=$("$@" 2>&1); status=$?
    case $status in
        0) echo "PASS $name";;
        3) echo "${said:-SKIP $name}";;
        *) echo "FAIL $name ${said//$'\n'/; }";;
    esac
}
check includes etc/checkLayering
check includesChecked etc/checkLayering --self-test
check sizes etc/checkSizes
check sizesCounted etc/checkSizes --self-test
check unitSources etc/unitSources -check
check python etc/checkPython

# The same by ruff and by pycodestyle with pyflakes: a file for each rule that must be refused, and
# others that must not
pythonRules()
{
    local folder rule verdict text said status=0; folder=$(mktemp -d)
    while IFS=$'\t' read -r rule verdict text
    do
        [[ $rule == '#'* ]] || printf '%b' "$text" >"$folder/$rule.$verdict.py"
    done <tests/regression/pythonRules.tsv
    said=$(etc/checkPython "$folder"/*.py 2>&1); status=$?
    ((status != 3)) || { echo "${said/SKIP python/SKIP pythonRules}"; rm -rf "$folder"; return 3; }
    for text in "$folder"/*.wrong.py
    do
        [[ $said == *${text##*/}:* ]] || { echo "${text##*/} is accepted"; status=2; }
    done
    ! grep -m1 'right\.py' <<<"$said" || status=2
    rm -rf "$folder"
    ((status == 1))
}
check pythonRules pythonRules
check whitespace etc/checkWhitespace

# etc/wrapLines breaks long lines of C++ and touches nothing else
wrapped()
{
    if ! command -v clang-format >/dev/null
    then
        echo "SKIP wrapLines clang-format is missing"
        return 3
    fi
    local folder cases=tests/regression/wrapLines status=0 pass
    folder=$(mktemp -d)
    cp $cases/long.txt "$folder/long.hpp"
    for pass in once again
    do
        etc/wrapLines "$folder/long.hpp" && diff $cases/short.txt "$folder/long.hpp" || status=1
    done
    printf '// %0120d\n' 0 >"$folder/word.hpp"
    etc/wrapLines "$folder/word.hpp" 2>/dev/null && { echo "a long word is not named"; status=1; }
    etc/checkWhitespace "$folder/word.hpp" >/dev/null &&
        { echo "a line of 123 columns is accepted"; status=1; }
    rm -rf "$folder"
    return $status
}
check wrapLines wrapped

# Of tests that may not be skipped a skipped one has failed, and one that has not run
required()
{
    local file said; file=$(mktemp)
    printf '%s\n' 'PASS a' 'SKIP ab none' 'SKIP b no program' >"$file"
    said=$(tests/required "$file" a b c) && [[ $said == "FAIL b skipped"*"no program" ]] &&
        said=$(tests/required -all "$file" a b c) && [[ $said == "FAIL c has not run"* ]] &&
        [[ $(cut -d' ' -f1,2 "$file" | paste -sd,) == "PASS a,SKIP ab,FAIL b,FAIL c" ]]
    local status=$?
    rm -f "$file"
    return $status
}
expect requiredTests "a test in RIPRAP_REQUIRED that is skipped has failed" required

check licences etc/checkLicences
noLicence()
{
    local folder said; folder=$(mktemp -d)
    git -C "$folder" init -q
    mkdir "$folder/src"; echo 'int x;' >"$folder/src/bad.C"
    echo '// SPDX-License-Identifier: GPL-3.0-or-later' >"$folder/src/good.C"
    echo 1 >"$folder/data.csv"
    said=$(etc/checkLicences "$folder"); local status=$?
    rm -rf "$folder"
    [[ $status == 1 && $said == *src/bad* && $said != *src/good* && $said != *data* ]]
}
expect licencesChecked "etc/checkLicences finds a source without licence line, and nothing else" \
    noLicence
if command -v reuse >/dev/null
then
    check licencesReuse reuse lint
else
    echo "SKIP licencesReuse reuse is not installed"
fi

subjects()
{
    local file status=0; file=$(mktemp)
    message() { printf '%b' "$1" >"$file"; etc/gitHooks/commit-msg "$file" 2>/dev/null; }
    message "$(printf 'x%.0s' {1..72})\n\nWhy.\n" && ! message "$(printf 'x%.0s' {1..73})\n" \
        && ! message 'What\nWhy.\n' && ! message '# only a comment\n' || status=1
    rm -f "$file"
    return $status
}
expect commitSubjects "etc/gitHooks/commit-msg takes subjects of 72 characters and no more" subjects

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
