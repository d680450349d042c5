#!/usr/bin/python3
"""Reads .vtp files, or all frames of .pvd collections, with VTK's own reader; prints what is in them.

Usage: vtk_readback.py FILE...    Exit status 1: a file cannot be read or is inconsistent.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree

from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

messages = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(messages)


def fail(path, why):
    print(f"{path}: {why}", file=sys.stderr)
    sys.exit(1)


def describe(kind, data, expected, path):
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if array is None:
            fail(path, f"{kind} array {k} is not numeric")
        if array.GetNumberOfTuples() != expected:
            fail(path, f"{kind} array {array.GetName()} has {array.GetNumberOfTuples()} "
                       f"tuples, expected {expected}")
        ranges = []
        for c in range(array.GetNumberOfComponents()):
            low, high = array.GetRange(c) if expected else (0, 0)
            ranges.append(f"{low:.9g}..{high:.9g}")
        print(f"  {kind} {array.GetName()} {array.GetDataTypeAsString()} " + " ".join(ranges))


def read(path):
    if not os.path.exists(path):
        fail(path, "no such file")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    if messages.GetOutput() or reader.GetErrorCode():
        fail(path, "VTK says: " + messages.GetOutput())
    poly = reader.GetOutput()
    points = poly.GetNumberOfPoints()
    cells = poly.GetNumberOfCells()
    print(f"{path}: {points} points, {poly.GetNumberOfVerts()} vertices, "
          f"{poly.GetNumberOfLines()} lines")
    if points:
        bounds = poly.GetBounds()
        print("  bounds " + " ".join(f"{bounds[2 * d]:.9g}..{bounds[2 * d + 1]:.9g}"
                                     for d in range(3)))
    describe("point", poly.GetPointData(), points, path)
    describe("cell", poly.GetCellData(), cells, path)
    for k in range(cells):
        ids = poly.GetCell(k).GetPointIds()
        for j in range(ids.GetNumberOfIds()):
            if not 0 <= ids.GetId(j) < points:
                fail(path, f"cell {k} refers to point {ids.GetId(j)}")


def frames(path):
    if not path.endswith(".pvd"):
        return [path]
    try:
        sets = ElementTree.parse(path).getroot().findall("./Collection/DataSet")
    except (OSError, ElementTree.ParseError) as error:
        fail(path, error)
    times = [float(s.get("timestep")) for s in sets]
    if times != sorted(times):
        fail(path, "times do not grow")
    print(f"{path}: {len(times)} frames")
    return [os.path.join(os.path.dirname(path), s.get("file")) for s in sets]


if len(sys.argv) < 2:
    sys.exit(__doc__)
for name in sys.argv[1:]:
    for frame in frames(name):
        read(frame)
