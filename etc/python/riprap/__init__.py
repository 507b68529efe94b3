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
import importlib.util
import sys


def __getattr__(name):
    """riprap.plotting is read at its first use: matplotlib takes longer than most analyses, of
    which many draw nothing"""
    if name != 'plotting':
        raise AttributeError(f'module {__name__} has no attribute {name}')
    spec = importlib.util.find_spec(__name__ + '.plotting')
    spec.loader = importlib.util.LazyLoader(spec.loader)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = globals()[name] = module
    spec.loader.exec_module(module)
    return module
