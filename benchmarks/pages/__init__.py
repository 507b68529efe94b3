# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that benchmarks/workPrecision makes of the rows"""
