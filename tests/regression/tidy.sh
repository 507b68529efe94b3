#!/bin/bash
# clang-tidy (etc/tidyCode) on this commit's share of the tree, and whether it would find something.
# Skipped where clang-tidy is not installed
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1

# verdict NAME STATUS SAID: by the exit status of etc/tidyCode
verdict()
{
    case $2 in
        0) echo "PASS $1";;
        3) echo "SKIP $1 ${3#SKIP tidy }";;
        *) echo "$3"; echo "FAIL $1 $(grep -m1 -E '(warning|error): ' <<<"$3" || head -1 <<<"$3")";;
    esac
}

# Files that say what is wrong with them, and one with nothing. In the tree, for its .clang-tidy
mkdir -p platforms/tests
copy=$(mktemp -d -p platforms/tests); trap 'rm -rf "$copy"' EXIT
echo '// SPDX-License-Identifier: GPL-3.0-or-later
int* none() { return 0; }' >"$copy/myNull.C"
echo '#include <vector>
int sum(std::vector<int> v) { int s = 0; for (int x : v) s += x; return s; }' >"$copy/myCopied.C"
echo '#include "core/missing.hpp"' >"$copy/myMissing.C"
echo 'int* none() { return nullptr; }' >"$copy/myRight.C"
said=$(etc/tidyCode "$copy"/*.C 2>&1); status=$?
if ((status == 1)) && [[ $said == *myNull.C:*use-nullptr* && $said == *myCopied.C:*value-param* \
    && $said == *myMissing.C:*"not found"* && $said != *myRight.C:* ]]
then
    status=0
elif ((status == 0)); then status=1 said="nothing is found in wrong files"
fi
verdict tidyFinds $status "$said"

# In as many turns as there are parts all units have been chosen
all=$(git ls-files -co --exclude-standard src applications tests benchmarks 2>/dev/null \
    | grep '\.C$' | grep -v 'Unit\.C$' | sort)
said=$(for turn in {1..36}; do etc/tidyCode -list "$turn" || exit; done); status=$?
if ((status == 0)) && [[ $(sort <<<"$said") != "$all" ]]
then
    status=1 said="36 turns do not reach each unit once"
elif ((status == 0)) && (($(etc/tidyCode -list | wc -l) > 3 + $(wc -l <<<"$all")/36 + 2))
then
    status=1 said="the share of a commit is too large"
fi
verdict tidyShare $status "$said"

said=$(etc/tidyCode -share 2>&1)
verdict tidy $? "$said"
