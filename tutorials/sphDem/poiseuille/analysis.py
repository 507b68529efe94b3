# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane Poiseuille flow from rest: profiles against the Fourier series"""
import os

from riprap import channels


def profile(y, t, nu):
    return channels.poiseuille(y, t, nu, F=0.8)


channels.verify('poiseuille', os.path.dirname(os.path.abspath(__file__)), profile, scale=0.8/0.1,
                title='plane Poiseuille')
