#!/bin/bash
# The templates of etc/codeTemplates, put where docs/development.md says: header, table line and test. The tests of all laws then try
# the new one too.
#
# SPDX-License-Identifier: GPL-3.0-or-later
root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL codeTemplates no environment"; exit 1; }
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
pass() { echo "PASS codeTemplates.$1"; }
fail() { echo "FAIL codeTemplates.$1 $2"; }

# A law of contacts, in a copy of the folder of its like and of the table
mkdir -p "$work/dem/contact/normal" "$work/solvers/dem"
cp "$root"/etc/codeTemplates/contactLaw/hardeningSpring.hpp "$work/dem/contact/normal"
sed 's|^using NormalLaws = Models<|&HardeningSpring, |; s|^#include "dem/contact/normal/hertz.hpp"|#include "dem/contact/normal/hardeningSpring.hpp"\n&|' \
    "$root/src/solvers/dem/demFamilies.hpp" >"$work/solvers/dem/demFamilies.hpp"
grep -q '^using NormalLaws = Models<HardeningSpring, ' "$work/solvers/dem/demFamilies.hpp" || fail contactLawTable 'the table has no such line'
flags=(-std=c++17 -O1 -fopenmp ${RIPRAP_MARCH:+-march=$RIPRAP_MARCH} -Wall -Wextra -Wno-psabi -Werror -I"$work" -I"$root/src" -I"$root/tests/unit")
if g++ "${flags[@]}" "$root"/etc/codeTemplates/contactLaw/hardeningSpringTest.C "$root/tests/unit/dem/lawCards.C" "$root/src/solvers/dem/demLaws.C" -o "$work/laws" -lgtest -lgtest_main -lpthread \
    >"$work/log" 2>&1
then pass contactLawBuilds
else fail contactLawBuilds "$(grep -m1 error "$work/log")"
fi
if env -u RIPRAP_DIR "$work/laws" >"$work/log" 2>&1
then pass contactLawRuns
else fail contactLawRuns "$(grep -m1 -A4 Failure "$work/log" | tr '\n' ' ')"
fi
