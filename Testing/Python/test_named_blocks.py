"""A mesh as named blocks, and back; and a mesh of what VTK's CGNS reader gives."""
import os
import tempfile

import mesh_files
import numpy as np
import writer_meshes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection
from vtkmodules.vtkIOCGNSReader import vtkCGNSReader

from ransmeshing import vtkCGNSMeshWriter, vtkMeshToNamedBlocks, vtkNamedBlocksToMesh


def blocks_of(grid):
    to_blocks = vtkMeshToNamedBlocks()
    to_blocks.SetInputData(grid)
    to_blocks.Update()
    return to_blocks.GetOutput()


def mesh_of(blocks):
    to_mesh = vtkNamedBlocksToMesh()
    to_mesh.SetInputData(blocks)
    to_mesh.Update()
    return to_mesh.GetOutput()


def message_for(algorithm, data):
    messages = []

    def keep(_caller, _event, text):
        messages.append(text)
    keep.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", keep)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    algorithm.SetInputData(data)
    algorithm.Update()
    return " ".join(messages)


def assert_same_grid(grid, back):
    for data, other in ((grid.GetPoints().GetData(), back.GetPoints().GetData()),
                        (grid.GetCells().GetConnectivityArray(), back.GetCells().GetConnectivityArray()),
                        (grid.GetCellTypesArray(), back.GetCellTypesArray())):
        assert np.array_equal(vtk_to_numpy(data), vtk_to_numpy(other))
    for of_grid, of_back in ((grid.GetCellData(), back.GetCellData()), (grid.GetPointData(), back.GetPointData())):
        assert of_grid.GetNumberOfArrays() == of_back.GetNumberOfArrays()
        for i in range(of_grid.GetNumberOfArrays()):
            array = of_grid.GetArray(i)
            assert np.array_equal(vtk_to_numpy(array), vtk_to_numpy(of_back.GetArray(array.GetName()))), array.GetName()
    for i in range(grid.GetFieldData().GetNumberOfArrays()):
        array = grid.GetFieldData().GetAbstractArray(i)
        other = back.GetFieldData().GetAbstractArray(array.GetName())
        assert all(array.GetVariantValue(v) == other.GetVariantValue(v) for v in range(array.GetNumberOfValues()))


def test_there_and_back():
    for grid in (writer_meshes.ball(), writer_meshes.room(), writer_meshes.all_kinds(), writer_meshes.wing_with_wake(),
                 writer_meshes.wing_with_wake_and_prisms()):
        assert_same_grid(grid, mesh_of(blocks_of(grid)))


def test_blocks_have_names_paths_and_types():
    grid = writer_meshes.all_kinds()
    blocks = blocks_of(grid)
    names = [blocks.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
             for i in range(blocks.GetNumberOfPartitionedDataSets())]
    assert names == ["fluid", "body", "roof", "the rest"], names
    assembly = blocks.GetDataAssembly()
    for number, (path, kind) in enumerate((("/Mesh/volume/fluid", None), ("/Mesh/boundary/body", "wall"),
                                           ("/Mesh/boundary/roof", "inlet"), ("/Mesh/boundary/the_rest", "patch"))):
        node = assembly.GetFirstNodeByPath(path)
        assert node >= 0 and list(assembly.GetDataSetIndices(node)) == [number], path
        assert assembly.GetAttributeOrDefault(node, "label", "") == names[number]
        assert assembly.GetAttributeOrDefault(node, "type", "none") == (kind or "none")
    mesh = mesh_files.of_grid(grid)
    for number, name in enumerate(names[1:], 1):
        block = blocks.GetPartition(number, 0)
        assert block.GetNumberOfCells() == len(mesh.patches[name])
        assert block.GetFieldData().GetAbstractArray("PatchType").GetNumberOfValues() == 1


def test_a_mesh_read_from_a_cgns_file():
    grid = writer_meshes.room()
    with tempfile.TemporaryDirectory() as folder:
        writer = vtkCGNSMeshWriter()
        writer.SetInputData(grid)
        writer.SetFileName(os.path.join(folder, "mesh.cgns"))
        assert writer.Write() == 1
        reader = vtkCGNSReader()
        reader.SetFileName(writer.GetFileName())
        reader.UpdateInformation()
        reader.LoadBndPatchOn()
        reader.EnableAllBases()
        reader.EnableAllFamilies()
        reader.Update()
    mesh_files.of_grid(grid).assert_same(mesh_files.of_grid(mesh_of(reader.GetOutput())))


def test_several_volumes_become_one():
    """The cube beside its pyramid: two blocks with points of their own."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    cube = writer_meshes.grid_of(corners, [(12, range(8))], [])
    pyramid = writer_meshes.grid_of(corners[4:] + [(0.5, 0.5, 2)], [(14, range(5))], [])
    floor = writer_meshes.grid_of(corners[:4], [], [("floor", "wall", [(0, 3, 2, 1)])])
    blocks = vtkMultiBlockDataSet()
    for i, (name, block) in enumerate((("floor", floor), ("cube", cube), ("pyramid", pyramid))):
        blocks.SetBlock(i, block)
        blocks.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name)
    mesh = mesh_of(blocks)
    assert mesh.GetNumberOfPoints() == 9 and mesh.GetNumberOfCells() == 3
    assert list(mesh_files.of_grid(mesh).patches) == ["floor"]


def test_what_is_missing_or_wrong_is_told():
    blocks = blocks_of(writer_meshes.all_kinds())
    volume, faces = blocks.GetPartition(0, 0), blocks.GetPartition(1, 0)

    def message(*parts):
        collection = vtkPartitionedDataSetCollection()
        for i, part in enumerate(parts):
            collection.SetNumberOfPartitionedDataSets(i + 1)
            collection.SetPartition(i, 0, part)
            collection.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), "part %d" % i)
        return message_for(vtkNamedBlocksToMesh(), collection)

    assert "no block holds volume cells" in message(faces)
    assert "no block holds boundary faces" in message(volume)
    assert "block 'part 0' holds other cells" in message(writer_meshes.all_kinds(), faces)
    moved = faces.NewInstance()
    moved.DeepCopy(faces)
    moved.GetPoints().SetPoint(0, 5, 5, 5)
    assert "block 'part 1' has a point at (5, 5, 5)" in message(volume, moved)
    moved.GetPointData().RemoveArray("MeshPointId")
    moved.GetPoints().SetPoint(0, *faces.GetPoint(0))
    assert message(volume, moved) == ""
    assert "empty" in message_for(vtkMeshToNamedBlocks(), writer_meshes.grid_of([], [], []))


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name, "passed")
