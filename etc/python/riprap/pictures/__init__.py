# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and films of runs: what bin/riprapRender does

foamFiles  mesh, fields on it, surfaces in files, gravity
shapes     surfaces as triangles, their sections, poses of rigid bodies
motions    OpenFOAM's solidBodyMotionFunctions
surface    particles as a smooth field, whose level is the water's surface
scene      a case and what there is to see of it at a time
camera     up, right, eye; what fits
flat       a 2D scene on axes of matplotlib
points     a 3D scene on axes of matplotlib, where there is no ParaView
panels     a 3D scene by ParaView's VTK, in a process of its own
vtkPanels  that process
sheet      panels, titles and colour bar on one sheet; films
options    the command line
"""


class PictureError(Exception):
    """What a user did wrong, in one line"""
