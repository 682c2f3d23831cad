"""Meshes for the tests of writers."""
import functools
import os
import random
import sys

import mesh_files
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkMeshQualityReport, vtkPrismRecombination,
                         vtkRANSPointRemoval)

sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples/Python"))
import pipeline  # noqa: E402
import wake  # noqa: E402


def grid_of(points, cells, patches):
    """points; cells: (VTK type, points); patches: (name, type, faces), a face being its points."""
    grid, coordinates = vtkUnstructuredGrid(), vtkPoints()
    coordinates.SetDataTypeToDouble()
    for point in points:
        coordinates.InsertNextPoint(point)
    grid.SetPoints(coordinates)
    numbers, names, types = vtkIntArray(), vtkStringArray(), vtkStringArray()
    for array, name in ((numbers, "PatchId"), (names, "PatchNames"), (types, "PatchTypes")):
        array.SetName(name)
    names.InsertNextValue("fluid")
    types.InsertNextValue("fluid")
    for kind, corners in cells:
        grid.InsertNextCell(kind, len(corners), corners)
        numbers.InsertNextValue(0)
    for number, (name, kind, faces) in enumerate(patches, 1):
        names.InsertNextValue(name)
        types.InsertNextValue(kind)
        for face in faces:
            grid.InsertNextCell(5 if len(face) == 3 else 9, len(face), face)
            numbers.InsertNextValue(number)
    grid.GetCellData().AddArray(numbers)
    grid.GetFieldData().AddArray(names)
    grid.GetFieldData().AddArray(types)
    return grid


def shuffled(grid):
    """The same cells in a random order, boundary faces among them, with 32-bit connectivity."""
    order = list(range(grid.GetNumberOfCells()))
    random.Random(1).shuffle(order)
    kinds, points = mesh_files.cells_of(grid)
    cells, ids, mixed = vtkCellArray(), vtkIntArray(), vtkUnstructuredGrid()
    cells.Use32BitStorage()
    ids.SetName("PatchId")
    for c in order:
        cells.InsertNextCell(len(points[c]), [int(p) for p in points[c]])
        ids.InsertNextValue(int(grid.GetCellData().GetArray("PatchId").GetTuple1(c)))
    mixed.SetPoints(grid.GetPoints())
    mixed.SetCells([int(kinds[c]) for c in order], cells)
    mixed.GetCellData().AddArray(ids)
    mixed.SetFieldData(grid.GetFieldData())
    return mixed


def all_kinds(turned=False):
    """A cube with a pyramid on it, a wedge beside it and a tetrahedron on that. turned: the wedge is numbered the
    other way round, against VTK's documentation, which must change nothing."""
    points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1),
              (1 / 3, 0.5, 2), (2, 0, 0.5), (2, 1, 0.5), (1.5, -1, 0.1)]
    wedge = (1, 5, 9, 2, 6, 10) if turned else (1, 9, 5, 2, 10, 6)
    cells = [(12, range(8)), (14, (4, 5, 6, 7, 8)), (13, wedge), (10, (1, 9, 5, 11))]
    patches = [
        ("body", "wall", [(0, 3, 2, 1), (1, 2, 10, 9)]),
        ("roof", "inlet", [(4, 5, 8), (5, 6, 8), (6, 7, 8), (7, 4, 8)]),
        ("the rest", "patch", [(0, 1, 5, 4), (2, 3, 7, 6), (0, 4, 7, 3), (5, 9, 10, 6), (2, 6, 10), (1, 9, 11), (9, 5, 11),
                               (5, 1, 11)]),
    ]
    return grid_of(points, cells, patches)


def two_regions():
    """The cells of all_kinds, the wedge and the tetrahedron being a region of their own, behind a quadrilateral."""
    both = all_kinds()
    kinds, points = mesh_files.cells_of(both)
    ids = [int(both.GetCellData().GetArray("PatchId").GetTuple1(c)) for c in range(both.GetNumberOfCells())]
    names = both.GetFieldData().GetAbstractArray("PatchNames")
    kinds_of = both.GetFieldData().GetAbstractArray("PatchTypes")
    patches = [(names.GetValue(i), kinds_of.GetValue(i), [list(map(int, p)) for p, of in zip(points, ids) if of == i])
               for i in (1, 2, 3)]
    grid = grid_of([both.GetPoint(i) for i in range(both.GetNumberOfPoints())],
                   [(int(k), list(map(int, p))) for k, p, of in zip(kinds, points, ids) if of == 0],
                   [*patches, ("between", "interface", [(1, 2, 6, 5)])])
    add_regions(grid, [3, 3, 7, 7], {3: "air", 7: "solid part"})
    return grid


def add_regions(grid, of_cells, names):
    """RegionId of the cells of the volume, which come first, and RegionNames."""
    regions, array = vtkIntArray(), vtkStringArray()
    regions.SetName("RegionId")
    array.SetName("RegionNames")
    for number in [*of_cells, *[0] * (grid.GetNumberOfCells() - len(of_cells))]:
        regions.InsertNextValue(int(number))
    for number in range(max(names) + 1):
        array.InsertNextValue(names.get(number, ""))
    grid.GetCellData().AddArray(regions)
    grid.GetFieldData().AddArray(array)


@functools.cache
def ball(prisms=False):
    """A ball in a box, with layers on it."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(10)
    filters = pipeline.make_chain(sphere.GetOutputPort(), first_height=1e-3, layers=5)
    pipeline.run(filters)
    enrichment = filters[2]
    if not prisms:
        return enrichment.GetOutput()
    recombination = vtkPrismRecombination()
    recombination.SetInputConnection(enrichment.GetOutputPort())
    recombination.Update()
    return recombination.GetOutput()


def layers_on(mesher, walls):
    """The filters behind one that makes a mesh, to prisms and the report; they have run."""
    stages = [mesher, vtkRANSPointRemoval(), vtkDirectionalEnrichment(), vtkPrismRecombination(), vtkMeshQualityReport()]
    for stage in stages[1:3]:
        for wall in walls:
            stage.SetPatchLayers(wall, 2e-3, 1.3, 6)
    for before, after in zip(stages, stages[1:]):
        after.SetInputConnection(before.GetOutputPort())
    pipeline.run(stages)
    assert stages[-1].GetValid(), stages[-1].GetReportText()
    return stages


@functools.cache
def room():
    """The inside of a cube with prisms on its walls, and hexahedra along its edges."""
    cube, mesher = vtkCubeSource(), vtkIsotropicTetMesher()
    mesher.SetInputConnection(cube.GetOutputPort())
    mesher.SetSurfaceEdgeLength(0.2)
    return layers_on(mesher, ["*"])[3].GetOutput()


@functools.cache
def wing_with_wake():
    """An isotropic mesh with a sheet in it."""
    mesher = wake.make_chain(1e-4)[0]
    pipeline.run([mesher])
    return mesher.GetOutput()


@functools.cache
def wing_with_wake_and_prisms():
    """Prisms on the wing and on both sides of the sheet."""
    return layers_on(wake.make_chain(1e-4)[0], ["surface", "wake"])[3].GetOutput()
