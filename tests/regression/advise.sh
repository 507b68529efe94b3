#!/bin/bash
# riprapFoam -advise and riprapAdvise: unit tests and the score on held-out scenes; a case of a dam
# break is read and gets a proposal that rests on its dry run, with nothing written; where the
# dictionaries do not tell it says so; wrong words get one message
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL advise no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam riprapAdvise
do
    command -v $program >/dev/null || { echo "FAIL advise no $program"; exit 1; }
done
python=${RIPRAP_PYTHON:-python3}
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=advise
. "$root/tests/regression/setParticlesCases"

if PYTHONDONTWRITEBYTECODE=1 "$python" "$root/tests/python/testAdvice.py" >log 2>&1
then
    pass units
else
    fail units "$(grep -E '^(FAIL|ERROR): |Error' log | paste -sd' ' -)"
fi
grep -E '^\.*by ' log | sed 's/^\.*/    /'

export OMP_NUM_THREADS=1
tank2
dictionary system/controlDict <<<"application riprapFoam; solver sphDem; startFrom startTime; \
startTime 0; stopAt endTime; endTime 0.2;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.1; writeFormat ascii; writePrecision 12;"
dictionary constant/sphProperties <<<"device cpu;"
regions 'column { set fluid; source box; box (0 0 0) (0.05 0.08 0.01); }'
setParticles >log 2>&1 || fail fill "$(oneLine)"
files() { find . -type f ! -name log ! -name before ! -name after -exec cksum {} + | sort; }
files >before
riprapFoam -advise 2% >log 2>&1 && pass sph || fail sph "$(oneLine)"
says sph.case 'Case: sphDem, 2D, [0-9]+ particles [0-9.]+ mm apart, .* for 0.2 s by the dry run'
says sph.flow 'Taken for: dam break \(gravity, and water that does not reach from wall to wall\)'
says sph.length 'Length that matters: 0.05 m, [0-9]+ spacings'
says sph.proposed 'Proposed: solver picDem, spacing [0-9.]+ mm \([0-9]+ over the length\), cells '\
'of twice that, precision mixed, device auto expected error [0-9.]+ %, from [0-9.]+ to [0-9.]+ %'
says sph.rests 'rests on damBreak;'
says sph.unknown 'Not known: sphDem: no scene of this kind \(dam break\) has rows of it'
says sph.trust 'each scene foretold from the others, '\
'[0-9]+ of [0-9]+ errors and [0-9]+ of [0-9]+ costs are within a factor of 2'
files >after
cmp -s before after && pass sph.writesNothing \
    || fail sph.writesNothing "$(diff before after | head -3 | tr '\n' ' ')"

# The own error is asked for again: the case itself. A quarter of it needs a finer spacing and costs
# more, as by hand from the dry run
riprapFoam -dry-run >dry 2>&1 || fail dry "$(tail -3 dry)"
riprapAdvise 2% -measured 2% -log dry >log 2>&1 && pass measured || fail measured "$(oneLine)"
spacing=$(foamDictionary system/setParticlesDict -entry spacing -value)
says measured.same \
    "Proposed: solver sphDem, spacing $(awk -v h="$spacing" 'BEGIN { printf "%.3g", 1000*h }') mm"
cost()
{
    sed -nE 's/.*expected cost ([0-9.]+) (s|min|h) for.*/\1 \2/p' "$1" \
        | awk '{ print $1*($2 == "min" ? 60 : $2 == "h" ? 3600 : 1); exit }'
}
solver=$(sed -nE 's/^ +solver +([0-9.]+).*/\1/p' dry)
awk -v a="$(cost log)" -v b="$solver" 'BEGIN { exit !(b > 0 && a > 0.9*b && a < 1.1*b) }' \
    && pass measured.cost || fail measured.cost "$(cost log) s, the dry run has $solver s"
riprapAdvise 0.5% -measured 2% -log dry >finer 2>&1
awk -v a="$(cost finer)" -v b="$(cost log)" 'BEGIN { exit !(a > 20*b && a < 1000*b) }' \
    && pass measured.finer || fail measured.finer "$(cost finer) s against $(cost log) s"

# What is not told by the dictionaries is asked for
dictionary constant/sphProperties \
    <<<"device cpu; walls { motion { wall { patches (right); solidBodyMotionFunction \
oscillatingLinearMotion; oscillatingLinearMotionCoeffs { amplitude (0.002 0 0); omega 500; } } } }"
refusedWith()   # NAME MESSAGE OPTION...
{
    local name=$1 message=$2; shift 2
    riprapFoam "$@" >log 2>&1 && { fail "$name" 'was accepted'; return; }
    says "$name" "$message"
}
refusedWith length 'riprapAdvise: not known: the length that matters in waves. '\
'Give the wavelength by -length METRES, or the error of this spacing by -measured' -advise 2%
refusedWith noShare "riprapAdvise: the error '2' is no share: give one as 2% or 0.02" -advise 2
refusedWith both 'Options -advise and -dry-run exclude each other' -advise 2% -dry-run
refusedWith solver 'Options -advise and -solver exclude each other' -advise 2% -solver picDem
echo 'walls no;' >>constant/sphProperties
refusedWith case 'riprapAdvise: riprapFoam -dry-run refuses the case: .*walls' -advise 2%
