"""Surfaces of a box between planes of constant x, y and z, in triangles of two a cell, with a patch for each part."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def even(start, end, size):
    """Points from start to end, about size apart."""
    return numpy.linspace(start, end, max(1, round((end - start) / size)) + 1)


class _Sides:
    def __init__(self, patch_of):
        self.patch_of = patch_of
        self.number = {}  # of points, by place
        self.names = ["fluid"]
        self.triangles = []
        self.patches = []

    def _number(self, point):
        return self.number.setdefault(tuple(numpy.round(point, 12)), len(self.number))

    def add(self, axis, value, first, second, is_high):
        """The lattice first x second in the plane where the axis has the value, turned outward."""
        for i in range(len(first) - 1):
            for j in range(len(second) - 1):
                corners = []
                for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                    point = numpy.empty(3)
                    point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = value, first[u], second[v]
                    corners.append(point)
                a, b, c, d = (self._number(p) for p in corners)
                # Diagonals alternate: each side is its own mirror image, on the whole.
                two = [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
                name = self.patch_of(sum(corners) / 4)
                if name not in self.names:
                    self.names.append(name)
                for triangle in two:
                    self.triangles.append(triangle if is_high else triangle[::-1])
                    self.patches.append(self.names.index(name))


def box(x, y, z, patch_of, types):
    """vtkPolyData of the box between the first and last of the coordinates x, y, z (arrays that rise).

    patch_of(point) names the patch of a face by its middle; types: the type of each patch.
    """
    axes = (x, y, z)
    sides = _Sides(patch_of)
    for axis in range(3):
        first, second = axes[(axis + 1) % 3], axes[(axis + 2) % 3]
        sides.add(axis, axes[axis][0], first, second, False)
        sides.add(axis, axes[axis][-1], first, second, True)
    surface = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.array(list(sides.number)), deep=True))
    surface.SetPoints(points)
    cells = vtkCellArray()
    ids = numpy.array(sides.triangles, dtype=numpy.int64)
    cells.SetData(numpy_to_vtkIdTypeArray(numpy.arange(0, ids.size + 1, 3, dtype=numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    surface.SetPolys(cells)
    patch_ids = numpy_to_vtk(numpy.array(sides.patches, dtype=numpy.int32), deep=True)
    patch_ids.SetName("PatchId")
    surface.GetCellData().AddArray(patch_ids)
    for name, values in (("PatchNames", sides.names),
                         ("PatchTypes", [types.get(n, "patch") for n in sides.names])):
        array = vtkStringArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        surface.GetFieldData().AddArray(array)
    return surface
