# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes of riprap's tutorials by OpenFOAM's interFoam and interIsoFoam (volume of fluid)"""
