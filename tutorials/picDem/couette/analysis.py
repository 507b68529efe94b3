# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane Couette flow from rest by PIC: profiles against the Fourier series"""
import os

from riprap import channels


def profile(y, t, nu):
    return channels.couette(y, t, nu, U=1.0)


channels.verify('picCouette', os.path.dirname(os.path.abspath(__file__)), profile, scale=1.0,
                title='plane Couette by PIC', runs=channels.onGrid())
