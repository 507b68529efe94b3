# SPDX-License-Identifier: GPL-3.0-or-later
"""Picture of a case's solids by ParaView, off-screen

usage: [xvfb-run -a] pvbatch renderSolids.py CASE [field=NAME] [bonds] [box=X0,Y0,X1,Y1] [oblique] [water] [columns=N] [TIME ...]

Opens CASE/<name>.foam in ParaView's OpenFOAM reader, as a user would, draws each body of lagrangian/solids as a sphere of its radius, coloured by a field (default U,
its magnitude), at the given times (default: the last), and saves CASE/<name>-solids.png.
bonds: bodies in grey; over them the whole bonds of VTK/bonds as lines coloured by their tension, in a 2D case. box: the part to be seen. oblique: from the side and above. water:
the surface where half of a cell is water (alpha.water), and the tank's outline.
(pvbatch takes words that begin with - for its own.)
"""
import glob
import math
import os
import sys

from paraview import simple as pv

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from renderCase import grid, openCase                           # noqa: E402

cloud = 'lagrangian/solids'
labels = {'U': 'speed [m/s]', 'omega': 'spin [rad/s]', 'contacts': 'contacts', 'brokenBonds': 'broken bonds', 'radius': 'radius [m]'}


def plain(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0


def bar(view, scale, place):
    # its title would not be drawn in so low a picture: label() has it
    shown = pv.GetScalarBar(scale, view)
    shown.Title, shown.ComponentTitle = '', ''
    shown.LabelColor = [0, 0, 0]
    shown.LabelFontSize = 9
    shown.Orientation = 'Horizontal'
    shown.WindowLocation, shown.Position = 'Any Location', place
    shown.ScalarBarLength, shown.ScalarBarThickness = 0.3, 8
    shown.AutomaticLabelFormat, shown.LabelFormat, shown.RangeLabelFormat = 0, '%.3g', '%.3g'


def drawBodies(view, particles, field, scale, withBar):
    spheres = pv.Glyph(Input=particles, GlyphType='Sphere')
    spheres.GlyphMode = 'All Points'
    spheres.ScaleArray = ['POINTS', 'radius']
    spheres.ScaleFactor = 2
    spheres.OrientationArray = ['POINTS', 'No orientation array']
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 16
    shown = pv.Show(spheres, view)
    if field is None:
        shown.ColorArrayName = [None, '']
        shown.DiffuseColor = shown.AmbientColor = [0.93, 0.93, 0.90]
        return
    pv.ColorBy(shown, ('POINTS', field, 'Magnitude') if field in ('U', 'omega', 'force') else ('POINTS', field))
    shown.SetScalarBarVisibility(view, withBar)
    if withBar:
        bar(view, scale, [0.6, 0.55])


def wholeBonds(case, time):
    """Lines of bonds that hold, as tubes of a third of the smallest radius"""
    files = {float(os.path.basename(f)[6:-4]): f for f in glob.glob(os.path.join(case, 'VTK', 'bonds', 'bonds_*.vtp'))}
    if not files:
        sys.exit(f'{case}: no bonds in VTK/bonds')
    nearest = min(files, key=lambda t: abs(t - time))
    lines = pv.XMLPolyDataReader(FileName=[files[nearest]])
    return pv.Threshold(Input=lines, Scalars=['CELLS', 'broken'], ThresholdMethod='Between', LowerThreshold=0, UpperThreshold=0.5)


def drawBonds(view, bonds, scale, withBar, lift):
    # in front of the bodies, which are round
    raised = pv.Transform(Input=bonds)
    raised.Transform.Translate = [0, 0, lift]
    shown = pv.Show(raised, view)
    shown.SetRepresentationType('Wireframe')
    shown.LineWidth = 4
    pv.ColorBy(shown, ('CELLS', 'tension'))
    shown.SetScalarBarVisibility(view, withBar)
    if withBar:
        bar(view, scale, [0.33, 0.06])


def drawWater(view, tank):
    surface = pv.Contour(Input=pv.CellDatatoPointData(Input=tank), ContourBy=['POINTS', 'alpha.water'], Isosurfaces=[0.5])
    shown = pv.Show(surface, view)
    shown.ColorArrayName = [None, '']
    shown.DiffuseColor = shown.AmbientColor = [0.30, 0.55, 0.80]
    shown.Opacity, shown.Specular = 0.45, 0.4
    outline = pv.Show(pv.Outline(Input=tank), view)
    outline.DiffuseColor = outline.AmbientColor = [0.2, 0.2, 0.2]


def label(view, time, title):
    text = pv.Show(pv.Text(Text=f't = {time:.4g} s' + title), view)
    text.Color = [0, 0, 0]
    text.WindowLocation, text.FontSize = 'Upper Left Corner', 11


def aim(view, bounds, shape, oblique):
    centre = [0.5*(bounds[2*i] + bounds[2*i + 1]) for i in range(3)]
    size = [bounds[2*i + 1] - bounds[2*i] for i in range(3)]
    direction = (0.35, 0.45, 1) if oblique else (0, 0, 1)
    length = math.sqrt(sum(d*d for d in direction))
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + 3*max(size)*d/length for c, d in zip(centre, direction)]
    view.CameraViewUp = [0, 1, 0]
    # half of what the picture must hold, upwards and to the side
    n = [d/length for d in direction]
    up = [(i == 1) - n[1]*n[i] for i in range(3)]
    up = [u/math.sqrt(sum(v*v for v in up)) for u in up]
    side = [up[1]*n[2] - up[2]*n[1], up[2]*n[0] - up[0]*n[2], up[0]*n[1] - up[1]*n[0]]
    high, wide = (sum(abs(a)*s for a, s in zip(axis, size)) for axis in (up, side))
    view.CameraParallelScale = 0.53*max(high, wide*shape[1]/shape[0])


def rangeOf(source, time, association, name):
    source.UpdatePipeline(time)
    information = source.GetDataInformation()
    information = information.GetPointDataInformation() if association == 'POINTS' else information.GetCellDataInformation()
    array = information.GetArrayInformation(name)
    if array is None:
        sys.exit(f'no field {name} on {cloud}')
    return array.GetComponentRange(-1 if array.GetNumberOfComponents() > 1 else 0)


class Options:
    """What was asked for"""

    def __init__(self, words):
        if not words:
            sys.exit(__doc__)
        self.case, self.times = words[0], []
        self.field, self.bonds, self.box, self.oblique, self.water, self.columns = 'U', False, None, False, False, 2
        for word in words[1:]:
            name, _, value = word.partition('=')
            if name in ('bonds', 'oblique', 'water') and not value:
                setattr(self, name, True)
            elif name == 'field' and value:
                self.field = value
            elif name == 'box' and value.count(',') == 3:
                self.box = [float(v) for v in value.split(',')]
            elif name == 'columns' and value.isdigit():
                self.columns = int(value)
            else:
                try:
                    self.times.append(float(word))
                except ValueError:
                    sys.exit(f"renderSolids.py: '{word}' is no time and none of field=NAME, bonds, box=X0,Y0,X1,Y1, oblique, water, columns=N")


def main():
    o = Options(sys.argv[1:])
    foam = glob.glob(os.path.join(o.case, '*.foam'))[0]
    particles = openCase(foam, [cloud])
    known = list(particles.TimestepValues)
    wanted = [min(known, key=lambda t: abs(t - w)) for w in o.times] or known[-1:]
    particles.UpdatePipeline(wanted[-1])
    tank = openCase(foam, ['internalMesh'])
    tank.UpdatePipeline(wanted[-1])
    bounds = list(tank.GetDataInformation().GetBounds())
    if o.box:
        bounds[:4] = o.box[0], o.box[2], o.box[1], o.box[3]
    columns = min(o.columns, len(wanted))
    rows = -(-len(wanted)//columns)
    aspect = (bounds[3] - bounds[2])/(bounds[1] - bounds[0])
    width = 1200//columns
    shape = (width, int(width*min(max(aspect, 0.25), 1.4)) + 40)
    if o.bonds:
        sources = [wholeBonds(o.case, t) for t in wanted]
        scale = pv.GetColorTransferFunction('tension')
        ranges = [rangeOf(s, t, 'CELLS', 'tension') for s, t in zip(sources, wanted)]
        top = 0.5*max(max(abs(a), abs(b)) for a, b in ranges)      # few bonds carry much: show the others
        low, preset, title = -top, 'Cool to Warm (Extended)', 'tension [N]'
    else:
        scale = pv.GetColorTransferFunction(o.field)
        low, preset, title = 0, 'Viridis (matplotlib)', labels.get(o.field, o.field)
        top = max(rangeOf(particles, t, 'POINTS', o.field)[1] for t in wanted)
    scale.ApplyPreset(preset, True)
    layout = pv.CreateLayout('picture')
    layout.SetSize(shape[0]*columns, shape[1]*rows)
    for i, (time, cell) in enumerate(zip(wanted, grid(layout, rows, columns))):
        view = pv.CreateView('RenderView')
        layout.AssignView(cell, view)
        view.ViewTime = time
        plain(view)
        drawBodies(view, particles, None if o.bonds else o.field, scale, i == 0)
        if o.water:
            drawWater(view, tank)
        if o.bonds:
            drawBonds(view, sources[i], scale, i == 0, bounds[5] - bounds[4] + 0.05*(bounds[1] - bounds[0]))
        label(view, time, '' if i else ';  colour: ' + title)
        aim(view, bounds, shape, o.oblique)
    scale.RescaleTransferFunction(low, top)
    picture = os.path.splitext(foam)[0] + '-solids.png'
    pv.SaveScreenshot(picture, layout, ImageResolution=[shape[0]*columns, shape[1]*rows])
    print(f'Wrote {picture}')


if __name__ == '__main__':
    main()
