# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading, checking, plotting and recording of riprap's runs (numpy and matplotlib only).

dictionaries  OpenFOAM dictionaries as nested Python dictionaries
tables        what function objects leave under postProcessing
clouds        particles of a time directory, ascii and binary
logs          what riprapFoam's log says of steps, time, device and memory
measures      norms, observed order, interpolation
fronts        dam-break fronts against experiments: one time shift for the gate
bounds        the tolerance table, checks, printed tables
records       one row a run in benchmarks/results
plotting      one style for all figures
study         what ties them together: a tutorial's analysis.py makes one Study and calls main()
"""
