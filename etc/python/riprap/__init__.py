# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading, checking, plotting and recording of riprap's runs (numpy and matplotlib only; rows,
convergence and advice need neither).

dictionaries  OpenFOAM dictionaries as nested Python dictionaries
tables        what function objects leave under postProcessing
clouds        particles of a time directory, ascii and binary
logs          what riprapFoam's log says of steps, time, device and memory
measures      norms, observed order, interpolation
fronts        dam-break fronts against experiments: one time shift for the gate
bounds        the tolerance table, checks, printed tables
records       one row a run in benchmarks/results
rows          all rows of benchmarks/results in one form, with their yardsticks: series, orders,
              limits, fronts
convergence   observed order, Richardson's limit and its uncertainty
advice        which solver, spacing and device reach an error, from the rows of other scenes
plotting      one style for all figures
study         what ties them together: a tutorial's analysis.py makes one Study and calls main()
"""
