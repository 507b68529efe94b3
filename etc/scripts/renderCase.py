# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a case's particles by ParaView, off-screen

usage: [xvfb-run -a] pvbatch renderCase.py CASE [FIELD [TIME ...]]

Opens CASE/<name>.foam in ParaView's OpenFOAM reader, as a user would, with the cloud lagrangian/fluid
coloured by FIELD (default U, its magnitude) at the given times (default: the last), draws the tank's
outline around it and saves CASE/<name>-particles.png.
"""
import glob
import math
import os
import re
import sys

from paraview import servermanager
from paraview import simple as pv

cloud = 'lagrangian/fluid'
labels = {'U': 'speed [m/s]', 'p': 'p [Pa]', 'rho': 'rho [kg/m3]', 'h': 'h [m]'}


def openCase(foam, regions):
    """The reader with the given mesh regions; exits when the case does not have them"""
    reader = pv.OpenFOAMReader(FileName=foam)
    reader.SkipZeroTime = 0
    reader.UpdatePipelineInformation()
    there = list(reader.MeshRegions.Available)
    if not set(regions) <= set(there):
        sys.exit(f'{foam}: no {regions} among the regions {there}')
    reader.MeshRegions = regions
    return reader


def spacing(case):
    """Of the fluid, from setParticlesDict: the size of a disc"""
    with open(os.path.join(case, 'system', 'setParticlesDict')) as f:
        return float(re.search(r'^\s*spacing\s+([-+0-9.eE]+)\s*;', f.read(), re.M).group(1))


def draw(view, particles, tank, time, field, size, scale, withBar):
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    outline = pv.Show(pv.Outline(Input=tank), view)
    outline.DiffuseColor = outline.AmbientColor = [0.2, 0.2, 0.2]
    points = pv.Show(particles, view)
    points.SetRepresentationType('Point Gaussian')
    points.GaussianRadius = 0.5*size
    points.ShaderPreset = 'Sphere'
    pv.ColorBy(points, ('POINTS', field, 'Magnitude') if field == 'U' else ('POINTS', field))
    points.SetScalarBarVisibility(view, withBar)
    if withBar:
        bar = pv.GetScalarBar(scale, view)
        bar.Title, bar.ComponentTitle = labels.get(field, field), ''
        bar.TitleColor = bar.LabelColor = [0, 0, 0]
        bar.TitleFontSize = bar.LabelFontSize = 14
        bar.WindowLocation, bar.Position = 'Any Location', [0.5, 0.55]
        bar.ScalarBarLength, bar.ScalarBarThickness = 0.3, 12
        bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, '%.3g', '%.3g'
    text = pv.Show(pv.Text(Text=f't = {time:g} s'), view)
    text.Color = [0, 0, 0]
    text.WindowLocation, text.FontSize = 'Upper Center', 14


def aim(view, bounds, shape):
    """Look along -z; from above and the side in 3D"""
    centre = [0.5*(bounds[2*i] + bounds[2*i + 1]) for i in range(3)]
    size = [bounds[2*i + 1] - bounds[2*i] for i in range(3)]
    flat = size[2] < 0.05*max(size)
    direction = (0, 0, 1) if flat else (0.45, 0.35, 1)
    distance = 3*max(size)
    length = math.sqrt(sum(d*d for d in direction))
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + distance*d/length for c, d in zip(centre, direction)]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = 0.6*max(size[1], size[0]*shape[1]/shape[0])*(1 if flat else 1.25)


def crop(bounds, particles, times):
    """Of a 2D tank that is higher than wide, what lies above nearly all of the water is left out: there only drops fly"""
    if bounds[5] - bounds[4] >= 0.05*(bounds[1] - bounds[0]) or bounds[3] - bounds[2] <= bounds[1] - bounds[0]:
        return bounds
    heights = []
    for time in times:
        particles.UpdatePipeline(time)
        data = servermanager.Fetch(particles)
        blocks = [data] if data.IsA('vtkDataSet') else [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
        while any(b is not None and not b.IsA('vtkDataSet') for b in blocks):
            blocks = [c for b in blocks if b is not None
                      for c in ([b] if b.IsA('vtkDataSet') else [b.GetBlock(i) for i in range(b.GetNumberOfBlocks())])]
        y = sorted(b.GetPoint(i)[1] for b in blocks if b is not None for i in range(b.GetNumberOfPoints()))
        heights.append(y[int(0.99*len(y))])
    top = bounds[2] + 1.15*(max(heights) - bounds[2])
    return (*bounds[:3], min(bounds[3], max(top, bounds[2] + 0.6*(bounds[1] - bounds[0]))), *bounds[4:])


def main(case, field='U', *times):
    foam = glob.glob(os.path.join(case, '*.foam'))[0]
    particles, tank = openCase(foam, [cloud]), openCase(foam, ['internalMesh'])
    known = list(particles.TimestepValues)
    wanted = [min(known, key=lambda t: abs(t - float(w))) for w in times] or known[-1:]
    columns = min(3, len(wanted))
    rows = -(-len(wanted)//columns)
    tank.UpdatePipeline(wanted[-1])
    bounds = crop(tank.GetDataInformation().GetBounds(), particles, wanted)
    shape = (560, max(360, min(620, round(60 + 560*(bounds[3] - bounds[2])/(bounds[1] - bounds[0])))))
    scale = pv.GetColorTransferFunction(field)
    scale.ApplyPreset('Viridis (matplotlib)', True)
    layout = pv.CreateLayout('picture')
    layout.SetSize(shape[0]*columns, shape[1]*rows)
    cells = grid(layout, rows, columns)
    top = 0
    for time in wanted:
        particles.UpdatePipeline(time)
        data = particles.GetDataInformation().GetPointDataInformation().GetArrayInformation(field)
        if data is None:
            sys.exit(f'{foam}: no field {field} on {cloud}')
        top = max(top, data.GetComponentRange(-1 if data.GetNumberOfComponents() > 1 else 0)[1])
    scale.RescaleTransferFunction(0, top)
    for time, cell in zip(wanted, cells):
        view = pv.CreateView('RenderView')
        layout.AssignView(cell, view)
        draw(view, particles, tank, time, field, spacing(case), scale, cell == cells[0])
        aim(view, bounds, shape)
    scale.RescaleTransferFunction(0, top)
    picture = os.path.splitext(foam)[0] + '-particles.png'
    pv.SaveScreenshot(picture, layout, ImageResolution=[shape[0]*columns, shape[1]*rows])
    print(f'Wrote {picture}')


def grid(layout, rows, columns):
    """Split a layout into equal cells; their locations row by row"""
    cells, rest = [], 0
    lines = []
    for r in range(rows - 1):
        upper = layout.SplitVertical(rest, 1/(rows - r))
        lines.append(upper)
        rest = upper + 1
    for line in lines + [rest]:
        for c in range(columns - 1):
            left = layout.SplitHorizontal(line, 1/(columns - c))
            cells.append(left)
            line = left + 1
        cells.append(line)
    return cells


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
