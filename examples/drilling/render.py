#!/usr/bin/python3
"""Draws one frame of the drilling example: the rock cut open, the bit, the cuttings.

  ./render.py post/rock60000.vtp picture.png      (needs Debian's python3-vtk9)
"""
import sys
import vtk


def main(source, picture):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(source)
    reader.Update()
    data = reader.GetOutput()
    if data.GetNumberOfPoints() == 0:
        sys.exit("render.py: no particles in " + source)
    radius = data.GetPointData().GetArray("radius").GetValue(0)
    kind = data.GetPointData().GetArray("type")

    # half of the rock, all of the bit and of the cuttings
    keep = vtk.vtkPoints()
    colour = vtk.vtkUnsignedCharArray()
    colour.SetName("colour")
    colour.SetNumberOfComponents(3)
    speed = data.GetPointData().GetArray("v")
    for i in range(data.GetNumberOfPoints()):
        x = data.GetPoint(i)
        v = speed.GetTuple3(i)
        moving = v[2] > 0.1
        if kind.GetValue(i) == 1 and not moving and x[1] < 10 * radius:
            continue
        keep.InsertNextPoint(x)
        if kind.GetValue(i) > 1:
            colour.InsertNextTuple3(60, 70, 85)
        elif moving:
            colour.InsertNextTuple3(214, 120, 40)
        else:
            shade = 150 + 70 * ((i * 2654435761) % 97) / 97
            colour.InsertNextTuple3(int(shade), int(0.9 * shade), int(0.72 * shade))
    points = vtk.vtkPolyData()
    points.SetPoints(keep)
    points.GetPointData().SetScalars(colour)

    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    glyph = vtk.vtkGlyph3D()
    glyph.SetInputData(points)
    glyph.SetSourceConnection(sphere.GetOutputPort())
    glyph.SetColorModeToColorByScalar()
    glyph.SetScaleModeToDataScalingOff()
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(glyph.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetSpecular(0.2)

    scene = vtk.vtkRenderer()
    scene.AddActor(actor)
    scene.SetBackground(1, 1, 1)
    top = 2 * radius * 42
    camera = scene.GetActiveCamera()
    camera.SetFocalPoint(10 * radius, 10 * radius, 0.46 * top)
    camera.SetPosition(25 * radius, -125 * radius, 0.75 * top)
    camera.SetViewUp(0, 0, 1)
    scene.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(620, 900)
    window.AddRenderer(scene)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if len(sys.argv) != 3:
    sys.exit(__doc__)
main(sys.argv[1], sys.argv[2])
