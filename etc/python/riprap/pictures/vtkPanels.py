# SPDX-License-Identifier: GPL-3.0-or-later
"""3D scenes by VTK, off-screen: a program of its own, for ParaView's pvbatch or any python with VTK

usage: vtkPanels.py FOLDER

FOLDER/job.json: sizes, camera and colours; FOLDER/frame<n>.npz: what is seen. Writes
FOLDER/frame<n>.png, without text.
"""
import json
import os
import sys

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the factories of rendering)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkImageData, vtkPlane, vtkPlaneCollection,
                                           vtkPolyData)
from vtkmodules.vtkFiltersCore import (vtkClipPolyData, vtkFeatureEdges, vtkFlyingEdges3D,
                                       vtkGlyph3D, vtkPolyDataNormals, vtkTubeFilter,
                                       vtkWindowedSincPolyDataFilter)
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLightKit, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkWindowToImageFilter)


def main(folder):
    with open(os.path.join(folder, 'job.json')) as f:
        job = json.load(f)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)           # pictures are drawn larger than they are shown
    window.SetSize(*job['size'])
    for k in range(job['frames']):
        with np.load(os.path.join(folder, f'frame{k}.npz')) as data:
            renderer = scene(job, data)
        window.AddRenderer(renderer)
        window.Render()
        save(window, os.path.join(folder, f'frame{k}.png'))
        window.RemoveRenderer(renderer)


def save(window, path):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetCompressionLevel(1)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def scene(job, data):
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.85)
    lights.SetKeyLightAngle(52, -24)
    lights.SetFillLightAngle(5, 55)
    lights.SetKeyToFillRatio(1.9)
    lights.SetKeyToHeadRatio(2.6)
    lights.SetKeyToBackRatio(3.5)
    lights.SetKeyLightWarmth(0.52)
    lights.SetFillLightWarmth(0.5)
    lights.SetBackLightWarmth(0.5)
    lights.SetHeadLightWarmth(0.5)
    lights.AddLightsToRenderer(renderer)
    look = job['camera']
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*look['focus'])
    camera.SetPosition(*look['eye'])
    camera.SetViewUp(*look['up'])
    camera.SetViewAngle(look['angle'])
    for k in range(int(data['meshes'])):
        mesh(renderer, job, data, k)
    if 'water' in data:
        water(renderer, job, data)
    if 'ballPositions' in data:
        balls(renderer, job, data['ballPositions'], data['ballRadii'], data['ballColours'], 0.25)
    if 'dropPositions' in data:
        balls(renderer, job, data['dropPositions'], data['dropRadii'], data['dropColours'], 0.6)
    for k in range(int(data['blends'])):
        surface = contour(data[f'blend{k}'], data[f'blendPlace{k}'], job['level'])
        shown = actor(surface, data[f'blendColour{k}'])
        renderer.AddActor(shown)
    if 'bonds' in data:
        bonds(renderer, job, data)
    if job['translucent']:
        renderer.UseDepthPeelingOn()
        renderer.SetMaximumNumberOfPeels(4)
        renderer.SetOcclusionRatio(0.02)
    renderer.ResetCameraClippingRange()
    if job['shade']:
        renderer.UseSSAOOn()
        renderer.SetSSAORadius(0.06*job['length'])
        renderer.SetSSAOBias(0.002*job['length'])
        renderer.SetSSAOKernelSize(32)
        renderer.SSAOBlurOn()
    return renderer


def polydata(points, triangles):
    made = vtkPolyData()
    where = vtkPoints()
    where.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float64), deep=1))
    made.SetPoints(where)
    cells = vtkCellArray()
    flat = np.column_stack([np.full(len(triangles), triangles.shape[1]),
                            triangles]).astype(np.int64).ravel()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(flat, deep=1))
    (made.SetPolys if triangles.shape[1] > 2 else made.SetLines)(cells)
    return made


def cut(data, planes):
    """What is on the inner side of planes (point, normal)"""
    for point, normal in planes:
        plane = vtkPlane()
        plane.SetOrigin(*point)
        plane.SetNormal(*normal)
        clip = vtkClipPolyData()
        clip.SetInputData(data)
        clip.SetClipFunction(plane)
        data = result(clip)
    return data


def cutClosed(data, planes):
    """The same of a closed surface, which stays closed; of an open one its faces"""
    rim = vtkFeatureEdges()
    rim.SetInputData(data)
    rim.FeatureEdgesOff()
    rim.ManifoldEdgesOff()
    rim.NonManifoldEdgesOff()
    if result(rim).GetNumberOfCells():
        return cut(data, planes)
    all_ = vtkPlaneCollection()
    for point, normal in planes:
        plane = vtkPlane()
        plane.SetOrigin(*point)
        plane.SetNormal(*normal)
        all_.AddItem(plane)
    clip = vtkClipClosedSurface()
    clip.SetInputData(data)
    clip.SetClippingPlanes(all_)
    clip.SetTolerance(1e-9)
    return result(clip)


def result(algorithm):
    """Its data: a port alone does not keep the algorithm alive"""
    algorithm.Update()
    return algorithm.GetOutput()


def actor(data, colour, specular=0.15, power=25, normals=None, opacity=1.0):
    """normals: the angle [degrees] up to which edges are rounded off by the light"""
    if normals is not None:
        smooth = vtkPolyDataNormals()
        smooth.SetInputData(data)
        smooth.SetFeatureAngle(normals)
        smooth.SplittingOn()
        smooth.ConsistencyOff()
        data = result(smooth)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    made = vtkActor()
    made.SetMapper(mapper)
    look = made.GetProperty()
    look.SetColor(*colour[:3])
    look.SetOpacity(opacity)
    look.SetAmbient(0.12)
    look.SetDiffuse(0.88)
    look.SetSpecular(specular)
    look.SetSpecularPower(power)
    return made


def mesh(renderer, job, data, k):
    kind = str(data[f'meshKind{k}'])
    source = polydata(data[f'meshPoints{k}'], data[f'meshTriangles{k}'])
    if kind == 'obstacle':
        source = cutClosed(source, data['bounds'])
    elif kind == 'hollow':
        source = cut(source, data['bounds'])
    elif kind != 'body':
        source = cut(source, job['planes'])
    colour = data[f'meshColour{k}']
    if kind in ('wall', 'hollow'):
        shown = actor(source, colour, specular=0.0, normals=20)
        # the mesh's faces look outwards: those towards the eye would hide the scene
        shown.GetProperty().FrontfaceCullingOn()
        shown.GetProperty().SetAmbient(0.45)
        shown.GetProperty().SetDiffuse(0.55)
        renderer.AddActor(shown)
    elif kind != 'open':
        renderer.AddActor(actor(source, colour, normals=32))
    if kind in ('wall', 'open'):
        edges = vtkFeatureEdges()
        edges.SetInputData(source)
        edges.SetFeatureAngle(20)
        edges.ManifoldEdgesOff()
        edges.NonManifoldEdgesOff()
        edges.ColoringOff()
        lines = actor(result(edges), job['ink'])
        lines.GetProperty().SetLineWidth(job['line'])
        lines.GetProperty().LightingOff()
        lines.GetProperty().SetOpacity(0.55)
        renderer.AddActor(lines)


def contour(f, place, level, value=None):
    """place: least corner and the three cells' sides"""
    image = vtkImageData()
    image.SetDimensions(*f.shape)
    image.SetOrigin(*place[:3])
    image.SetSpacing(*place[3:])
    scalars = numpy_to_vtk(np.ascontiguousarray(f.ravel(order='F'), dtype=np.float32), deep=1)
    scalars.SetName('f')
    image.GetPointData().SetScalars(scalars)
    if value is not None:
        more = numpy_to_vtk(np.ascontiguousarray(value.ravel(order='F'), dtype=np.float32), deep=1)
        more.SetName('value')
        image.GetPointData().AddArray(more)
    surface = vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, level)
    surface.SetInterpolateAttributes(value is not None)
    surface.ComputeNormalsOff()
    surface.ComputeGradientsOff()
    smooth = vtkWindowedSincPolyDataFilter()
    smooth.SetInputConnection(surface.GetOutputPort())
    smooth.SetNumberOfIterations(12)
    smooth.SetPassBand(0.12)
    smooth.NormalizeCoordinatesOn()
    smooth.BoundarySmoothingOff()
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(smooth.GetOutputPort())
    normals.SetFeatureAngle(60)
    normals.SplittingOn()
    return result(normals)


def water(renderer, job, data):
    surface = contour(data['water'], data['waterPlace'], job['level'],
                      data['waterValue'] if 'waterValue' in data else None)
    shown = actor(surface, job['plainWater'], specular=0.45, power=40, opacity=job['opacity'])
    if 'waterValue' in data:
        table = vtkLookupTable()
        table.SetNumberOfTableValues(256)
        for i, colour in enumerate(job['map']):
            table.SetTableValue(i, *colour[:3], 1.0)
        table.SetRange(*job['range'])
        mapper = shown.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray('value')
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
    renderer.AddActor(shown)


def balls(renderer, job, positions, radii, colours, specular):
    source = vtkPolyData()
    where = vtkPoints()
    where.SetData(numpy_to_vtk(np.ascontiguousarray(positions, dtype=np.float64), deep=1))
    source.SetPoints(where)
    size = numpy_to_vtk(np.ascontiguousarray(radii, dtype=np.float64), deep=1)
    size.SetName('radius')
    colour = numpy_to_vtk(np.ascontiguousarray(colours, dtype=np.uint8), deep=1)
    colour.SetName('colour')
    source.GetPointData().AddArray(colour)
    source.GetPointData().SetScalars(size)
    around = (32 if len(positions) < 2000 else 16 if len(positions) < 20000 else 10
              if len(positions) < 100000 else 6)
    sphere = vtkSphereSource()
    sphere.SetRadius(1.0)
    sphere.SetThetaResolution(around)
    sphere.SetPhiResolution(max(around//2 + 1, 4))
    glyph = vtkGlyph3D()
    glyph.SetInputData(source)
    glyph.SetSourceConnection(sphere.GetOutputPort())
    glyph.SetScaleModeToScaleByScalar()
    glyph.SetScaleFactor(1.0)
    glyph.SetColorModeToColorByScale()
    shown = actor(result(glyph), (1, 1, 1), specular=specular, power=30)
    mapper = shown.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray('colour')
    mapper.SetColorModeToDirectScalars()
    renderer.AddActor(shown)


def bonds(renderer, job, data):
    source = polydata(data['bonds'], np.arange(len(data['bonds'])).reshape(-1, 2))
    colour = numpy_to_vtk(np.ascontiguousarray(data['bondColours'], dtype=np.uint8), deep=1)
    colour.SetName('colour')
    source.GetCellData().AddArray(colour)
    tube = vtkTubeFilter()
    tube.SetInputData(source)
    tube.SetRadius(float(data['bondRadius']))
    tube.SetNumberOfSides(8)
    shown = actor(result(tube), (1, 1, 1))
    mapper = shown.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray('colour')
    mapper.SetColorModeToDirectScalars()
    renderer.AddActor(shown)


if __name__ == '__main__':
    main(sys.argv[1])
