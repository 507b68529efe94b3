#!/bin/bash
# riprapFoam -dry-run takes the first steps with the guards of a run: what stops a run in them is
# its error too, with nothing written, for all solvers; a case that is well passes. Messages of
# guards name particle, place, figure and limit.
#
# SPDX-License-Identifier: GPL-3.0-or-later
set -uo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/etc/bashrc" || { echo "FAIL dryRun no environment"; exit 1; }
for program in blockMesh setParticles riprapFoam
do
    command -v $program >/dev/null || { echo "FAIL dryRun no $program"; exit 1; }
done
case=$(mktemp -d)
trap 'rm -rf "$case"' EXIT
cd "$case" || exit 1
suite=dryRun
. "$root/tests/regression/setParticlesCases"

control()   # SOLVER MORE
{
    dictionary system/controlDict <<<"application riprapFoam; solver $1; startFrom startTime; \
startTime 0; stopAt endTime; endTime 1;
deltaT 1e-3; adjustTimeStep yes; sampleInterval 0.01; writeControl adjustableRunTime; \
writeInterval 0.1; writeFormat ascii; writePrecision 12; ${2:-}"
}
fill() { rm -rf 0 VTK; setParticles >log 2>&1 || fail fill "$(oneLine)"; rm -rf VTK; }
files() { find . -type f ! -name log ! -name before ! -name after -exec cksum {} + | sort; }
# It ends with the guard's message and writes no file
stops()     # NAME MESSAGE
{
    files >before; refused "$1" "$2" riprapFoam -dry-run; files >after
    cmp -s before after && pass "$1.writesNothing" \
        || fail "$1.writesNothing" "$(diff before after | head -3 | tr '\n' ' ')"
}
passes()    # NAME STEPS: as many as a second allows
{
    files >before
    riprapFoam -dry-run >log 2>&1 && pass "$1" || fail "$1" "$(grep -m1 -A4 ERROR log)"
    files >after
    says "$1.says" "First steps, with all guards.* ($2) taken: no guard has stopped them"
    says "$1.time" 'Expected run time: '
    says "$1.device" 'device +.* \(asked for\) +threads +[1-9][0-9]* '\
'of the CPU \(.*OMP_NUM_THREADS.*\) +memory +[0-9.]+ [kMG]?B for the case.s arrays; '\
'the device has [0-9.]+ [GT]B, [0-9.]+ [MGT]B still free'
    cmp -s before after && pass "$1.writesNothing" \
        || fail "$1.writesNothing" "$(diff before after | head -3 | tr '\n' ' ')"
}

# sphDem
sph() { dictionary constant/sphProperties <<<"device cpu; $1"; }
tank2; control sphDem; sph ''
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.08 0.01); }'; fill
passes sph '[1-9][0-9]*'
# The table that the log ends with is foretold, and what costs much is named; function objects that
# write files do not
functions='functions { front { type frontPosition; '\
'libs ("libriprapFoam.so"); } twice { type waterLevel; libs ("libriprapFoam.so"); '\
'points ((0.01 0 0.005)); writeControl adjustableRunTime; writeInterval 0.25; }
late { type energyBalance; libs ("libriprapFoam.so"); timeStart 0.5; writeInterval 5; } '\
'mesh { type particlesToMesh; libs ("libriprapFoam.so"); } theirs { type systemCall; '\
'libs ("libutilityFunctionObjects.so"); writeCalls ("touch touched"); } }'
control sphDem "$functions"
passes forecast '[1-9][0-9]*'
table='Expected wall time \[s\], as the log will end start +[0-9.]+ +[0-9.]+ % '\
'solver +[0-9.]+ +[0-9.]+ % 100 times function objects +[0-9.]+ +[0-9.]+ % 100 times'
says forecast.table "$table front [0-9.]+ [0-9.]+ % 101 times twice [0-9.]+ [0-9.]+ % 5 times late \
[0-9.]+ [0-9.]+ % 11 times mesh [0-9.]+ [0-9.]+ % 101 times writing [0-9.]+ [0-9.]+ % 10 times \
waiting for writing [0-9.]+ [0-9.]+ % 10 times all +[0-9.]+ +100.0 % written meanwhile"
says forecast.files 'Files: 10 times [0-9.]+ [kM]?B, formatted but not on disk'
says forecast.others 'Not timed, since they may write: .theirs.'
quiet forecast.cheap 'Costs much: sampleInterval'
control sphDem "$functions"; sed -i 's/sampleInterval 0.01/sampleInterval 1e-5/' system/controlDict
passes costly '[1-9][0-9]*'
says costly.samples 'Costs much: sampleInterval 1e-05 s of system/controlDict is 0[0-9.]* steps; '\
'the solver is fastest where samples are farther apart'
says costly.object \
    "Costs much: function object mesh takes [0-9.]+ (% of|times) the solver.s time, [0-9.]+ ms a \
sample, as long as [0-9.]+ steps: sample less often by its writeInterval, or by sampleInterval"
control sphDem
sph 'guards { wild stop; densityDeviation 1e-5; }'
stops density 'Guard at time 0 s, particle step 0: particle [0-9]+ at \(.*\(nearest patch: '\
'[a-z]+\) has a density that deviates by .* guards/densityDeviation allows 1e-05'
says density \
    'Try first: a larger maxVelocity, where water is faster than [0-9.]+ m/s by right. A shorter'
sph 'guards { wild stop; densityDeviation 1e-5; } forceCourant 0.5; walls { impermeable no; }'
stops remedies 'guards/densityDeviation allows 1e-05'
says remedies 'by right; forceCourant 0.25 \(is 0.5\); impermeable yes of the walls\. A shorter'
# Courant numbers set no fixed step
control sphDem 'adjustTimeStep no; deltaT 1e-5;'
stops remediesFixed 'guards/densityDeviation allows 1e-05'
says remediesFixed \
    'by right; adjustTimeStep yes, or a smaller deltaT; impermeable yes of the walls\. A shorter'
control sphDem
# Solids get impulses by themselves; where they do not, that is said
sph ''
dictionary constant/solidProperties <<<'contact { normal linear; } '\
'materials { wood { rho 300; } } walls { patches (); } '\
'pairs { default { restitution 0.5; friction 0; stiffness 1e5; } }'
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.04 0.01); } raft { set solids; '\
'rigid yes; material wood; source box; box (0.03 0.06 0) (0.06 0.08 0.01); radius 0.0025; }'; fill
sph 'guards { wild stop; densityDeviation 1e-5; }'
stops raft 'guards/densityDeviation allows 1e-05'
quiet raft.impulse 'fluidForce impulse of'
sph 'guards { wild stop; densityDeviation 1e-5; } couplingCoeffs { fluidForce held; }'
stops raftHeld 'guards/densityDeviation allows 1e-05'
says raftHeld 'by right; fluidForce impulse of couplingCoeffs \(is held\)\. A shorter'
rm constant/solidProperties; sph ''
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.08 0.01); }'; fill
sph 'guards { wild stop; speedRatio 1e-4; }'
stops speed 'Guard at time .* s, particle step [1-9][0-9]*: '\
'particle [0-9]+ at .* has the speed .* guards/speedRatio allows'
sph 'guards { escape stop; }'
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.1 0.01); velocity (0 3 0); '\
'pressure zero; }'; fill
stops escape 'particles of 400 have left the domain.*guards/escape'
sph 'walls { motion { wall { patches (right); solidBodyMotionFunction oscillatingLinearMotion; '\
'oscillatingLinearMotionCoeffs { amplitude (0.002 0 0); omega 500; } } } }'
regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.08 0.01); }'; fill
passes piston '[1-9][0-9]*'

# dem: one that goes farther in a step than its radius is refused; a thin skin costs time alone
control dem
dictionary system/setParticlesDict <<<'regions ( two { set solids; material glass; radius 0.005; '\
'spacing 0.01; packing square; source box; box (0 0 0) (0.02 0.01 0.01); velocity (1 0 0); } );'
glass()
{
    dictionary constant/solidProperties \
        <<<"device cpu; materials { glass { rho 2500; E 1e7; nu 0.25; } } contact { normal linear; \
} pairs { default { restitution 0.9; friction 0; stiffness 1e5; } } walls { material glass; } $1"
}
glass ''; fill
passes dem '[1-9][0-9]*'
control dem 'functions { chains { type contactChains; '\
'libs ("libriprapFoam.so"); } heap { type groupMotion; libs ("libriprapFoam.so"); } }'
passes demForecast '[1-9][0-9]*'
says demForecast.table 'chains [0-9.]+ [0-9.]+ % 101 times heap [0-9.]+ [0-9.]+ % 101 times writing'
control dem
glass 'skin 1e-4;'
passes thinSkin '[1-9][0-9]*'
sed -i 's/velocity (1 0 0)/velocity (30 0 0)/' system/setParticlesDict; fill
stops tooFast 'Guard at time .* particle [01] at .*\(nearest patch: '\
'[a-z]+\) goes [0-9.e-]+ m in a step of [0-9.e-]+ s, at 30 m/s, and its radius is 0.005 m'
[[ $(grep -oE 'particle [01]' log | wc -l) == 1 ]] && pass tooFastOnce \
    || fail tooFastOnce 'the particle is named more than once'
control dem 'adjustTimeStep no; deltaT 1e-2;'; glass ''
refused hardStop 'the time step of 0.01 s is above [0-9.e-]+ s, 0.5 sqrt.m/k. '\
'of contact glass-glass .*allowLargeStep' riprapFoam -dry-run

# picDem
rm -f constant/sphProperties constant/solidProperties
control picDem
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }'
pic() { dictionary constant/picProperties <<<"device cpu; $1"; }
pic ''; regions 'tank { set fluid; source box; box (0 0 0) (0.1 0.05 0.01); }'; fill
passes pic '[0-9]+'
says pic.table \
    'solver [0-9.]+ [0-9.]+ % 100 times fields [0-9.]+ [0-9.]+ % 10 times function objects'
# Steps become shorter as the water becomes faster: sqrt(2 g 0.05 m) = 0.99 m/s goes half a cell in
# 2 0.005/(v + sqrt(v2 + 4 g 0.005)) s
time='; its time step: 0.0048[0-9]+ s Particle steps to time 1: 139 with this step, '\
'about 20[78] at that speed Expected run time: [0-9.]+ to [0-9.]+ s'
says pic.speed "Speed that may be reached: 0.99[0-9]* m/s, \
estimated by the water.s fall to the lowest place of the mesh with its velocities$time"
geometry 'gate { type searchableBox; min (0.12 0.02 -1); max (0.14 0.2 1); }'
pic 'walls { motion { lift { patches (gate); solidBodyMotionFunction linearMotion; '\
'linearMotionCoeffs { velocity (0 2 0); } } } }'
riprapFoam -dry-run >log 2>&1; says pic.speedOfGate 'Speed that may be reached: 2.23[0-9]* m/s, '\
'estimated by .* velocities and 2 m/s of what is moved'
rm constant/geometry
block 0.2 0.1 0.01 '20 10 1' "left { type patch; faces ((0 4 7 3)); } right { type wall; \
faces ((1 2 6 5)); } $lower $open $flat"
control picDem
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }'
pic 'openings { left { type velocity; velocity table ((0 (0 0 0)) (1 (3 0 0))); } }'; fill
riprapFoam -dry-run >log 2>&1
says pic.speedOfOpening 'Speed that may be reached: 3 m/s, estimated by velocities of openings'
pic 'openings { left { type flowRate; flowRate table ((0 0) (1 0.002)); } }'
# 0.002 m3/s over 0.1 x 0.01 m2
riprapFoam -dry-run >log 2>&1
says pic.speedOfFlow 'Speed that may be reached: 2 m/s, estimated by velocities of openings'
rm constant/sphProperties; tank2; rm constant/sphProperties
dictionary system/fvSolution <<<'solvers { p { solver cudaPCG; tolerance 1e-8; relTol 0; } }'
pic ''
control picDem 'adjustTimeStep no; deltaT 1e-3;'; fill
riprapFoam -dry-run >log 2>&1; says pic.fixedStep \
    '1000 with this step, about 1000 at that speed Expected run time: [0-9.]+ s, without output'
control picDem 'adjustTimeStep no; deltaT 0.5;'
stops courant 'Guard at time .* s, particle step [0-9]+: '\
'particle [0-9]+ at .* would go [0-9.]+ cells in a step; guards/Courant allows 5'
