#!/usr/bin/env python3
"""A mesh with layers on a body and on both sides of its wake: python3 wake.py MESH.vtu [FIRST_HEIGHT]

The body is a wing of the section NACA 0012 with a sharp trailing edge, in a far field; the wake is a sheet that
begins at the trailing edge, with the wing's own points there, and ends in the fluid. Lengths are in chords.
"""
import math
import sys

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import pipeline

SPAN, CELLS_ALONG_SPAN, CELLS_ALONG_CHORD = 1.0, 16, 24
WAKE_LENGTH, CELLS_ALONG_WAKE = 2.0, 24


def surface_of(points, triangles):
    coordinates, polygons = vtkPoints(), vtkCellArray()
    coordinates.SetDataTypeToDouble()  # points that are to coincide must not be rounded
    for point in points:
        coordinates.InsertNextPoint(point)
    for triangle in triangles:
        polygons.InsertNextCell(3, triangle)
    surface = vtkPolyData()
    surface.SetPoints(coordinates)
    surface.SetPolys(polygons)
    return surface


def grid_triangles(cells_along_rows, rows, number):
    """Two triangles for each cell between neighbouring rows of points; number(row, i) is a point's number."""
    triangles = []
    for j in range(rows):
        for i in range(cells_along_rows):
            a, b, c, d = number(j, i), number(j, i + 1), number(j + 1, i + 1), number(j + 1, i)
            triangles += [(a, b, c), (a, c, d)]
    return triangles


def half_thickness(x):
    polynomial = 0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4
    return 0.6 * polynomial if 0 < x < 1 else 0.0


def wing():
    """From the trailing edge over the upper side to the nose, and back below; then the two tips."""
    n = CELLS_ALONG_CHORD
    chord = [0.5 * (1 - math.cos(math.pi * i / n)) for i in range(n + 1)]
    section = [(x, half_thickness(x)) for x in reversed(chord)] + [(x, -half_thickness(x)) for x in chord[1:-1]]
    around = len(section)
    points = [(x, SPAN * j / CELLS_ALONG_SPAN, z) for j in range(CELLS_ALONG_SPAN + 1) for x, z in section]
    triangles = grid_triangles(around, CELLS_ALONG_SPAN, lambda j, i: j * around + i % around)
    for row in (0, CELLS_ALONG_SPAN):
        upper = [row * around + n - i for i in range(n + 1)]
        lower = [upper[0]] + [row * around + n + i for i in range(1, n)] + [upper[n]]
        for i in range(n):
            pair = [(upper[i], upper[i + 1], lower[i + 1]), (upper[i], lower[i + 1], lower[i])]
            triangles += [t if row == 0 else t[::-1] for t in pair if len(set(t)) == 3]
    return surface_of(points, triangles)


def wake():
    points = [(1 + WAKE_LENGTH * j / CELLS_ALONG_WAKE, SPAN * i / CELLS_ALONG_SPAN, 0.0)
              for j in range(CELLS_ALONG_WAKE + 1) for i in range(CELLS_ALONG_SPAN + 1)]
    row = CELLS_ALONG_SPAN + 1
    return surface_of(points, grid_triangles(CELLS_ALONG_SPAN, CELLS_ALONG_WAKE, lambda j, i: j * row + i))


def make_chain(first_height):
    filters = pipeline.make_chain(None, first_height)
    mesher = filters[0]
    mesher.SetInputData(wing())
    mesher.AddSheetData(wake())  # of type wake; SetPatchType("wake", "wall") makes it a wall without thickness
    return filters


def main(arguments):
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    filters = make_chain(float(arguments[1]) if len(arguments) == 2 else 1e-5)
    try:
        pipeline.run(filters)
        print(filters[-1].GetReportText())
        pipeline.write(filters[-1].GetOutput(), arguments[0])
    except pipeline.MeshingError as error:
        print(f"wake.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
