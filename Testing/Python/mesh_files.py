"""Meshes read back by readers that are not the project's own, all in one form, to be compared.

SU2 and UGRID have no such reader here: theirs are below, written from the formats' specifications.
"""
import ctypes
import ctypes.util
import itertools
import os
import shutil

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

KINDS = {4: "tetrahedron", 5: "pyramid", 6: "wedge", 8: "hexahedron"}  # by number of points
VTK_SIZES = {10: 4, 14: 5, 13: 6, 12: 8, 5: 3, 9: 4}


class Mesh:
    """points (n, 3); cells: {number of points: (n, k) array}; patches: {name: [face, ...]}, as arrays;
    regions: {name or number: keys of cells}, where a file tells of several."""

    def __init__(self, points, cells, patches, regions=None):
        self.points, self.cells, self.patches, self.regions = points, cells, patches, regions or {}

    def assert_same(self, other, exact=True):
        """The same points in the same order, the same cells and patches of the same faces, in any order."""
        if exact:
            assert np.array_equal(self.points, other.points), "points differ"
        else:
            assert np.allclose(self.points, other.points, rtol=1e-6, atol=1e-7)
        assert self.cells.keys() == other.cells.keys(), (self.cells.keys(), other.cells.keys())
        for size, cells in self.cells.items():
            assert np.array_equal(ordered(cells), ordered(other.cells[size])), KINDS[size]
        assert list(self.patches) == list(other.patches), (list(self.patches), list(other.patches))
        for name, faces in self.patches.items():
            assert set(map(key, faces)) == set(map(key, other.patches[name])), name
            assert len(faces) == len(other.patches[name]), name
            area, read = (sum(np.linalg.norm(mesh.area(f)) for f in mesh.patches[name]) for mesh in (self, other))
            assert np.isclose(area, read, rtol=1e-12 if exact else 1e-5), (name, area, read)

    def area(self, face):
        """Its area vector."""
        p = self.points[face]
        return np.cross(p[2] - p[0], p[-1] - p[1]) / 2 if len(face) == 4 else np.cross(p[1] - p[0], p[2] - p[0]) / 2

    def assert_first_faces_turn_inward(self):
        """The convention of CGNS, gmsh, SU2: the first face's normal points into the cell."""
        for size, cells in self.cells.items():
            p = self.points[cells]
            last = 2 if size in (4, 6) else 3
            base = 3 if size in (4, 6) else 4
            up = (p[:, base:] - p[:, :size - base]).sum(axis=1)
            volumes = np.einsum("ij,ij->i", np.cross(p[:, 1] - p[:, 0], p[:, last] - p[:, 0]), up)
            assert (volumes > 0).all(), KINDS[size]

    def assert_outward(self, sign=1):
        """The outer patches' normals point out of the mesh: the volume that they enclose is positive."""
        faces = [f for patch in self.patches.values() for f in patch]
        volume = sum(np.dot(self.points[f].mean(axis=0), self.area(f)) for f in faces) / 3
        assert volume * sign > 0, volume
        assert np.linalg.norm(sum(self.area(f) for f in faces)) < 1e-9 * abs(volume) ** (2 / 3)


def has(program):
    return shutil.which(program) is not None


def key(face):
    return tuple(sorted(int(p) for p in face))


def ordered(cells):
    cells = np.sort(np.asarray(cells), axis=1)
    return cells[np.lexsort(cells.T[::-1])]


def of_grid(grid):
    """The mesh that a vtkUnstructuredGrid of the data contract is."""
    ids = vtk_to_numpy(grid.GetCellData().GetArray("PatchId"))
    names = grid.GetFieldData().GetAbstractArray("PatchNames")
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    faces = {patch: [*rows_of(grid, (ids == patch) & (kinds == 5)), *rows_of(grid, (ids == patch) & (kinds == 9))]
             for patch in np.unique(ids[(kinds == 5) | (kinds == 9)])}
    return Mesh(vtk_to_numpy(grid.GetPoints().GetData()), volume_of(grid),
                {names.GetValue(int(patch)): of_patch for patch, of_patch in faces.items()})


def volume_of(grid):
    """{number of points: (n, k) array} of the volume cells."""
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    cells = {size: rows_of(grid, kinds == kind) for kind, size in VTK_SIZES.items() if kind >= 10}
    return {size: rows for size, rows in cells.items() if len(rows)}


def rows_of(grid, mask):
    """The points of the cells that the mask says, which have one size, a row a cell."""
    chosen = np.flatnonzero(mask)
    if not len(chosen):
        return np.empty((0, 0), int)
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    size = offsets[chosen[0] + 1] - offsets[chosen[0]]
    return vtk_to_numpy(grid.GetCells().GetConnectivityArray())[offsets[chosen][:, None] + np.arange(size)]


def cells_of(grid):
    """VTK's types, and the points of each cell."""
    kinds = vtk_to_numpy(grid.GetCellTypesArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    points = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return kinds, np.split(points, offsets[1:-1])


def read_su2(path):
    """https://su2code.github.io/docs_v7/Mesh-File/"""
    zone, = read_su2_zones(path)
    return zone


def read_su2_zones(path):
    """A mesh for each zone: https://su2code.github.io/docs_v7/Multizone/"""
    with open(path, encoding="utf-8") as file:
        lines = iter([line for line in file if not line.startswith("%")])

    def value(word):
        name, text = next(lines).split("=")
        assert name.strip() == word, (name, word)
        return text.strip()

    def element():
        words = next(lines).split()
        return [int(w) for w in words[1:1 + VTK_SIZES[int(words[0])]]]

    def zone():
        assert value("NDIME") == "3"
        cells = {}
        for _ in range(int(value("NELEM"))):
            cell = element()
            cells.setdefault(len(cell), []).append(cell)
        points = [[float(w) for w in next(lines).split()[:3]] for _ in range(int(value("NPOIN")))]
        patches = {}
        for _ in range(int(value("NMARK"))):
            name = value("MARKER_TAG")
            patches[name] = [element() for _ in range(int(value("MARKER_ELEMS")))]
        return Mesh(np.array(points), {k: np.array(v) for k, v in cells.items()}, patches)

    first = next(lines)
    zones = []
    if first.startswith("NZONE="):
        for number in range(1, int(first[6:]) + 1):
            assert value("IZONE") == str(number)
            zones.append(zone())
    else:
        lines = itertools.chain([first], lines)
        zones.append(zone())
    assert next(lines, None) is None
    return zones


def read_ugrid(path):
    """https://www.simcenter.msstate.edu/software/documentation/ug_io/3d_grid_file_type_ugrid.html"""
    order = ">" if path.endswith(".b8.ugrid") else "<" if path.endswith(".lb8.ugrid") else None
    with open(path, "rb") as file:
        content = file.read()
    words = content.split() if order is None else None
    at = 0

    def take(count, real=False):
        nonlocal at
        if words is not None:
            values = np.array(words[at:at + count], dtype=float if real else int)
            at += count
        else:
            values = np.frombuffer(content, order + ("f8" if real else "i4"), count, at)
            at += values.nbytes
        return values

    points, triangles, quads, *cells = take(7)
    coordinates = take(3 * points, real=True).reshape(-1, 3).astype(float)
    faces = list(take(3 * triangles).reshape(-1, 3) - 1) + list(take(4 * quads).reshape(-1, 4) - 1)
    numbers = take(triangles + quads)
    volume = {}
    for count, size in zip(cells, (4, 5, 6, 8)):
        if count:
            volume[size] = take(size * count).reshape(-1, size) - 1
    end = len(content) if words is None else len(words)
    volumes = None
    if at < end:  # optional: the number of tetrahedra in layers, and each cell's volume
        assert take(1)[0] == 0
        numbers_of_cells = iter(np.split(take(sum(cells)), np.cumsum(cells)[:-1]))
        volumes = {size: next(numbers_of_cells) for size in (4, 5, 6, 8)}
    assert at == end
    if 5 in volume:  # the base is 0 1 4 3, the tip 2; here: the base turned into the cell, then the tip
        volume[5] = volume[5][:, [1, 0, 3, 4, 2]]
    names = [name for _, _, name in read_mapbc(path[:path.index(".", path.rindex("/"))] + ".mapbc")]
    patches = {name: [f for f, n in zip(faces, numbers) if n == i + 1] for i, name in enumerate(names)}
    return Mesh(coordinates, volume, patches, regions_of(volume, volumes) if volumes else {})


def regions_of(cells, numbers):
    """{number: keys of cells} of arrays of the cells' numbers, both by the cells' number of points."""
    regions = {}
    for size, rows in cells.items():
        for row, number in zip(rows, numbers[size]):
            regions.setdefault(int(number), set()).add(key(row))
    return regions


def read_mapbc(path):
    with open(path, encoding="utf-8") as file:
        count, *lines = file.read().splitlines()
    assert int(count) == len(lines)
    return [(int(number), int(condition), name) for number, condition, name in map(str.split, lines)]


def read_gmsh(path):
    """By gmsh's own program interface. Physical volumes are regions, if there are several."""
    import gmsh
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        tags, points, _ = gmsh.model.mesh.getNodes()
        points = points.reshape(-1, 3)[np.argsort(tags)]
        cells, patches, regions = {}, {}, {}
        several = len(gmsh.model.getPhysicalGroups(3)) > 1
        for dimension, group in gmsh.model.getPhysicalGroups():
            name = gmsh.model.getPhysicalName(dimension, group)
            for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, group):
                for kind, _, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity)):
                    size = gmsh.model.mesh.getElementProperties(kind)[3]
                    nodes = nodes.reshape(-1, size).astype(int) - 1
                    if dimension == 3:
                        cells.setdefault(size, []).append(nodes)
                        if several:
                            regions.setdefault(name, set()).update(map(key, nodes))
                    else:
                        patches.setdefault(name, []).extend(nodes)
        return Mesh(points, {size: np.concatenate(rows) for size, rows in cells.items()}, patches, regions)
    finally:
        gmsh.finalize()


class PointNumbers:
    """Finds points in others that are equal to them, bit for bit."""

    def __init__(self, reference):
        self.rows = self.as_rows(reference)
        self.order = np.argsort(self.rows, kind="stable")

    @staticmethod
    def as_rows(points):
        return np.ascontiguousarray(points).view("V24").ravel()

    def of(self, points):
        wanted = self.as_rows(points)
        found = np.searchsorted(self.rows, wanted, sorter=self.order).clip(max=len(self.order) - 1)
        rows = self.order[found]
        assert (self.rows[rows] == wanted).all(), "a patch has a point that the volume has not"
        return rows


def of_blocks(volume, surfaces):
    """A mesh of data sets: a volume, and surfaces by name whose points lie on its points."""
    points = vtk_to_numpy(volume.GetPoints().GetData()).astype(float)
    numbers, patches = PointNumbers(points), {}
    for name, surface in surfaces:
        faces = faces_of(surface)
        used, places = np.unique(np.concatenate(faces), return_inverse=True)  # readers leave all the mesh's points there
        of_mesh = numbers.of(vtk_to_numpy(surface.GetPoints().GetData())[used].astype(float))[places]
        patches[name] = np.split(of_mesh, np.cumsum([len(face) for face in faces])[:-1])
    return Mesh(points, volume_of(volume), patches)


def faces_of(surface):
    """The points of each face, of a vtkPolyData or a vtkUnstructuredGrid."""
    cells = surface.GetPolys() if surface.IsA("vtkPolyData") else surface.GetCells()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    return np.split(vtk_to_numpy(cells.GetConnectivityArray()), offsets[1:-1])


def read_openfoam(folder):
    """By VTK's reader, which keeps points in single precision: in double they are read here.
    folder: a case's constant/polyMesh."""
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
    case = os.path.dirname(os.path.dirname(folder))
    marker = os.path.join(case, "case.foam")
    open(marker, "w", encoding="utf-8").close()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(marker)
    reader.UpdateInformation()
    reader.EnableAllPatchArrays()
    reader.SetReadZones(os.path.exists(os.path.join(folder, "cellZones")))
    reader.Update()
    blocks = named_blocks(reader.GetOutput())
    zones = {name.split("/")[-1]: block for name, block in blocks.items() if name.startswith("zones/cellZones/")}
    surfaces = [(name.split("/")[-1], block) for name, block in blocks.items()
                if name != "internalMesh" and not name.startswith("zones/")]
    mesh = of_blocks(blocks["internalMesh"], surfaces)
    points = foam_points(os.path.join(folder, "points"))
    assert np.allclose(points, mesh.points, rtol=1e-6, atol=1e-7)
    mesh.points = points
    mesh.regions = {name: set(map(key, cells_of(block)[1])) for name, block in zones.items()}
    return mesh


def foam_points(path):
    with open(path, "rb") as file:
        header, content = file.read().split(b"}\n", 1)
    count, content = content.split(b"(", 1)
    if b"format      binary" in header:
        return np.frombuffer(content, float, 3 * int(count)).reshape(-1, 3)
    words = content.replace(b"(", b" ").replace(b")", b" ").split()
    return np.array(words, dtype=float).reshape(int(count), 3)


def read_cgns(path):
    """By VTK's reader."""
    from vtkmodules.vtkIOCGNSReader import vtkCGNSReader
    reader = vtkCGNSReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    reader.LoadBndPatchOn()
    reader.EnableAllBases()
    reader.EnableAllFamilies()
    reader.Update()
    blocks = named_blocks(reader.GetOutput())
    volume, *surfaces = blocks.items()
    return of_blocks(volume[1], [(name.split("/")[-1], block) for name, block in surfaces])


def cgns_regions(path):
    """{name: keys of cells} of the sub-regions of a file's zone, by libcgns itself."""
    cgns = ctypes.CDLL(ctypes.util.find_library("cgns"))
    sizes = {10: 4, 12: 5, 14: 6, 17: 8}  # corners by CGNS's number of the shape

    def call(name, *arguments):
        assert getattr(cgns, name)(*arguments) == 0, name

    def number():
        return ctypes.c_int()

    file, count, names = number(), number(), [ctypes.create_string_buffer(66) for _ in range(2)]
    call("cg_open", path.encode(), 0, ctypes.byref(file))
    elements = {}
    call("cg_nsections", file, 1, 1, ctypes.byref(count))
    for section in range(1, count.value + 1):
        kind, first, last, rest = number(), number(), number(), [number(), number()]
        call("cg_section_read", file, 1, 1, section, names[0], *map(ctypes.byref, (kind, first, last, *rest)))
        if kind.value in sizes:
            rows = np.empty((last.value - first.value + 1, sizes[kind.value]), np.int32)
            call("cg_elements_read", file, 1, 1, section, rows.ctypes.data_as(ctypes.c_void_p), None)
            elements.update(zip(range(first.value, last.value + 1), map(key, rows - 1)))
    call("cg_nsubregs", file, 1, 1, ctypes.byref(count))
    regions = {}
    for region in range(1, count.value + 1):
        about, ends = [number() for _ in range(6)], (ctypes.c_int * 2)()
        call("cg_subreg_info", file, 1, 1, region, names[0], *map(ctypes.byref, about))
        call("cg_subreg_ptset_read", file, 1, 1, region, ends)
        call("cg_goto", file, 1, b"Zone_t", 1, b"ZoneSubRegion_t", region, b"end")
        call("cg_famname_read", names[1])
        assert about[0].value == 3 and names[0].value == names[1].value
        regions[names[1].value.decode()] = {elements[e] for e in range(ends[0], ends[1] + 1)}
    call("cg_close", file)
    return regions


def named_blocks(tree, prefix=""):
    """{path/of/names: data set} of a vtkMultiBlockDataSet."""
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
    blocks = {}
    for i in range(tree.GetNumberOfBlocks()):
        block = tree.GetBlock(i)
        name = prefix + (tree.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) or str(i))
        if isinstance(block, vtkMultiBlockDataSet):
            blocks.update(named_blocks(block, name + "/"))
        elif block:
            blocks[name] = block
    return blocks
