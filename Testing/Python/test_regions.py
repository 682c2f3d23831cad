"""Meshes of several regions: through the filters, into each format, and back by readers that are not the project's."""
import os
import subprocess
import sys

import mesh_files
import numpy as np
import writer_meshes
from test_writers import FILES, WriterTest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCubeSource

from ransmeshing import (vtkGmshMeshReader, vtkIsotropicTetMesher, vtkMeshAdoption, vtkMeshToNamedBlocks,
                         vtkNamedBlocksToMesh)

sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples/Python"))
import pipeline  # noqa: E402

TETRAHEDRON = 10
KUHN = ((0, 1, 3, 7), (0, 1, 7, 5), (0, 5, 7, 4), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7))


def regions_of(grid):
    """{number: keys of cells}"""
    kinds, points = mesh_files.cells_of(grid)
    numbers = vtk_to_numpy(grid.GetCellData().GetArray("RegionId"))
    assert (numbers[kinds < TETRAHEDRON] == 0).all()
    return {int(n): {mesh_files.key(points[c]) for c in np.flatnonzero(numbers == n)} for n in np.unique(numbers) if n}


def there_and_back(grid):
    """What remains of a mesh as named blocks."""
    to_blocks, to_mesh = vtkMeshToNamedBlocks(), vtkNamedBlocksToMesh()
    to_blocks.SetInputData(grid)
    to_mesh.SetInputConnection(to_blocks.GetOutputPort())
    pipeline.run([to_blocks, to_mesh])
    return to_blocks.GetOutput(), to_mesh.GetOutput()


def assert_regions_by_place(grid, number_at):
    """Each cell is of the region that number_at tells for the middle of its corners."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    for size, rows in mesh_files.volume_of(grid).items():
        kind = {4: 10, 5: 14, 6: 13, 8: 12}[size]
        numbers = vtk_to_numpy(grid.GetCellData().GetArray("RegionId"))[vtk_to_numpy(grid.GetCellTypesArray()) == kind]
        assert np.array_equal(numbers, number_at(points[rows].mean(axis=1))), size


class Divided:
    """A box of 12 x 6 x 6 cells, cut into tetrahedra, of two regions beyond and before x = 1; no triangles between."""

    def __init__(self):
        shape = (13, 7, 7)
        axes = [np.linspace(0, end, n) for end, n in zip((2, 1, 1), shape)]
        points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
        number = np.arange(len(points)).reshape(shape)
        cells = []
        for i, j, k in np.ndindex(*(n - 1 for n in shape)):
            corners = number[i:i + 2, j:j + 2, k:k + 2].transpose(2, 1, 0).ravel()
            cells += [(TETRAHEDRON, corners[list(tet)].tolist()) for tet in KUHN]
        self.grid = writer_meshes.grid_of(points, cells, [])
        middles = points[[c for _, c in cells]].mean(axis=1)
        writer_meshes.add_regions(self.grid, self.number_at(middles), {5: "water", 2: "air"})

    @staticmethod
    def number_at(middles):
        return np.where(middles[:, 0] < 1, 5, 2)

    def adoption(self):
        adoption = vtkMeshAdoption()
        adoption.SetInputData(self.grid)
        return adoption


class Filters(WriterTest):
    def test_domains_apart(self):
        mesher = vtkIsotropicTetMesher()
        for middle in (0, 3):
            cube = vtkCubeSource()
            cube.SetCenter(middle, 0, 0)
            mesher.AddInputConnection(cube.GetOutputPort())
        mesher.SetSurfaceEdgeLength(0.2)
        stages = writer_meshes.layers_on(mesher, ["surface_*"])
        first = int(mesher.GetOutput().GetPoint(mesher.GetOutput().GetCell(0).GetPointId(0))[0] > 1.5)
        for stage in stages:
            assert_regions_by_place(stage.GetOutput(), lambda m: np.where((m[:, 0] > 1.5) == first, 1, 2))
        self.assertRegex(stages[-1].GetReportText(), r"(?s)region +tetrahedra +volume.* 1 fluid_1 .* 2 fluid_2 ")
        for name in FILES:
            self.written(stages[3].GetOutput(), name)

    def test_regions_that_come_without_triangles_between_get_some_and_stay(self):
        mesh = Divided()
        adoption = mesh.adoption()
        pipeline.run([adoption])
        names = adoption.GetOutput().GetFieldData().GetAbstractArray("PatchNames")
        walls = [names.GetValue(i) for i in range(1, names.GetNumberOfValues())]
        self.assertIn("air_to_water", walls)
        walls.remove("air_to_water")
        for stage in writer_meshes.layers_on(adoption, walls[:1]):
            assert_regions_by_place(stage.GetOutput(), mesh.number_at)
            _, back = there_and_back(stage.GetOutput())
            mesh_files.of_grid(stage.GetOutput()).assert_same(mesh_files.of_grid(back))
            assert_regions_by_place(back, mesh.number_at)
        self.assertIn("2 air ", stage.GetReportText())
        self.assertIn("5 water ", stage.GetReportText())


class Formats(WriterTest):
    def setUp(self):
        super().setUp()
        self.grid = writer_meshes.two_regions()
        self.mesh = mesh_files.of_grid(self.grid)
        self.regions = regions_of(self.grid)

    def test_gmsh(self):
        for file_type in (1, 2):
            read = mesh_files.read_gmsh(self.written(self.grid, "mesh.msh", file_type=file_type))
            self.mesh.assert_same(read)
            self.assertEqual(read.regions, {"air": self.regions[3], "solid part": self.regions[7]})
        reader = vtkGmshMeshReader()
        reader.SetFileName(self.path("mesh.msh"))
        reader.Update()
        self.assertEqual(regions_of(reader.GetOutput()), self.regions)
        self.assertEqual(reader.GetOutput().GetFieldData().GetAbstractArray("RegionNames").GetValue(7), "solid part")

    def test_openfoam(self):
        read = mesh_files.read_openfoam(self.written(self.grid, "case/constant/polyMesh"))
        self.assertEqual(read.regions, {"air": self.regions[3], "solid_part": self.regions[7]})
        if mesh_files.has("checkMesh"):
            text = self.check_mesh()
            self.assertRegex(text, r"(?s)cellZone.*air +2 .*solid_part +2 ")
            self.assertNotIn("***", text)

    def test_openfoam_divides_the_mesh_by_them(self):
        if not mesh_files.has("splitMeshRegions"):
            self.skipTest("OpenFOAM is not there")
        self.written(self.grid, "case/constant/polyMesh")
        self.make_case()
        done = subprocess.run(["splitMeshRegions", "-cellZonesOnly", "-overwrite", "-case", self.path("case")], text=True,
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr)
        for region, other in (("air", "solid_part"), ("solid_part", "air")):
            with open(self.path(f"case/constant/{region}/polyMesh/boundary"), encoding="utf-8") as file:
                self.assertIn(f"{region}_to_{other}", file.read())

    def test_cgns(self):
        path = self.written(self.grid, "mesh.cgns")
        self.assertEqual(mesh_files.cgns_regions(path), {"air": self.regions[3], "solid part": self.regions[7]})
        del self.mesh.patches["between"]
        self.mesh.assert_same(mesh_files.read_cgns(path))
        if mesh_files.has("cgnscheck"):
            done = subprocess.run(["cgnscheck", "-v", path], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertNotIn("ERROR", done.stdout)

    def test_su2_has_zones(self):
        path = self.written(self.grid, "mesh.su2")
        zones = mesh_files.read_su2_zones(path)
        outer = {"body", "roof", "the_rest"}
        self.assertEqual([set(zone.patches) for zone in zones],
                         [outer | {"between_air"}, {"body", "the_rest", "between_solid_part"}])
        for zone, number in zip(zones, (3, 7)):
            places = {tuple(p): i for i, p in enumerate(self.mesh.points)}
            numbers = np.array([places[tuple(p)] for p in zone.points])
            self.assertEqual({mesh_files.key(numbers[row]) for rows in zone.cells.values() for row in rows},
                             self.regions[number])
            zone.assert_outward()  # so each zone is closed, too
            zone.assert_first_faces_turn_inward()
        with open(path, encoding="utf-8") as file:
            self.assertIn("% MARKER_ZONE_INTERFACE= ( between_air, between_solid_part )\nNZONE= 2\nIZONE= 1\n% Zone air\n",
                          file.read())

    def test_su2_cannot_hold_what_divides_nothing(self):
        writer_meshes.add_regions(self.grid, [3, 3, 3, 3], {3: "all"})
        self.refused("cannot hold patches inside the mesh, and this mesh has: between", self.grid, "mesh.su2")
        writer_meshes.add_regions(self.grid, [3, 3, 7, 7], {3: "air"})
        self.assertEqual(len(mesh_files.read_su2_zones(self.written(self.grid, "mesh.su2", leave_out_sheets=True))), 2)

    def test_ugrid_has_numbers(self):
        for name in ("mesh.ugrid", "mesh.b8.ugrid", "mesh.lb8.ugrid"):
            self.refused("cannot hold patches inside the mesh, and this mesh has: between", self.grid, name)
            read = mesh_files.read_ugrid(self.written(self.grid, name, leave_out_sheets=True))
            self.assertEqual(read.regions, self.regions)

    def test_named_blocks(self):
        blocks, mesh = there_and_back(self.grid)
        assembly = blocks.GetDataAssembly()
        for number, path in enumerate(("/Mesh/volume/air", "/Mesh/volume/solid_part", "/Mesh/boundary/body")):
            self.assertEqual(list(assembly.GetDataSetIndices(assembly.GetFirstNodeByPath(path))), [number])
        self.assertEqual(regions_of(mesh), self.regions)
        for i in range(blocks.GetNumberOfPartitionedDataSets()):
            blocks.GetPartition(i, 0).GetCellData().RemoveArray("RegionId")
        blocks.GetFieldData().RemoveArray("RegionNames")
        again = vtkNamedBlocksToMesh()
        again.SetInputData(blocks)
        again.Update()
        self.assertEqual(list(regions_of(again.GetOutput()).values()), list(self.regions.values()))
        self.assertEqual(again.GetOutput().GetFieldData().GetAbstractArray("RegionNames").GetValue(2), "solid part")


if __name__ == "__main__":
    import unittest
    unittest.main()
