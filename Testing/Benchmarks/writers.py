#!/usr/bin/env python3
"""What writers of meshes for solvers take: writers.py [--measure-only] FOLDER MESH.vtu...

Each mesh is written in each format, by a process of its own, to FOLDER, then read back and compared: by VTK's readers
(OpenFOAM, CGNS), by gmsh's, by the tests' own (SU2, UGRID). Beside them VTK's own writers, for the rate. Printed are
the file's size, time, rate and processor rate, and the memory that was added at most, as a share of the mesh's own.
"""
import ctypes
import os
import shutil
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../Python"))
import mesh_files  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid  # noqa: E402
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter  # noqa: E402

from ransmeshing import vtkSolverMeshWriter  # noqa: E402

ASCII = 1
READERS = {"mesh.su2": mesh_files.read_su2, "mesh.ugrid": mesh_files.read_ugrid, "mesh.b8.ugrid": mesh_files.read_ugrid,
           "mesh.lb8.ugrid": mesh_files.read_ugrid, "mesh.cgns": mesh_files.read_cgns, "mesh.msh": mesh_files.read_gmsh,
           "case/constant/polyMesh": mesh_files.read_openfoam}


def read_mesh(path):
    """The mesh alone, without the arrays that solvers' files do not hold."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    read, mesh = reader.GetOutput(), vtkUnstructuredGrid()
    mesh.SetPoints(read.GetPoints())
    mesh.SetCells(read.GetCellTypesArray(), read.GetCells())
    for name in ("PatchId", "RegionId"):
        if read.GetCellData().HasArray(name):
            mesh.GetCellData().AddArray(read.GetCellData().GetArray(name))
    mesh.SetFieldData(read.GetFieldData())
    return mesh


def size_of(path):
    if os.path.isfile(path):
        return os.path.getsize(path)
    return sum(os.path.getsize(os.path.join(path, name)) for name in os.listdir(path))


def memory(key):
    with open("/proc/self/status", encoding="utf-8") as file:
        return next(int(line.split()[1]) * 1024 for line in file if line.startswith(key + ":"))


def in_a_process(work):
    """Runs it in a copy of this process, so that memory is counted from the mesh on."""
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        try:
            work()
            os._exit(0)
        except BaseException as error:  # of any kind: a copy must not go on
            print(repr(error), flush=True)
            os._exit(1)
    return os.waitpid(child, 0)[1] == 0


def measure(label, writer, mesh, path):
    def work():
        writer.SetInputData(mesh)
        writer.SetFileName(path)
        ctypes.CDLL(None).malloc_trim(0)  # what is free but not given back would be used again, and not be counted
        with open("/proc/self/clear_refs", "w", encoding="utf-8") as file:
            file.write("5")  # the peak is counted from here
        before, wall, cpu = memory("VmRSS"), time.time(), time.process_time()
        assert writer.Write() == 1
        wall, cpu = time.time() - wall, time.process_time() - cpu
        added = (memory("VmHWM") - before) / (mesh.GetActualMemorySize() * 1024)
        size = size_of(path) / 1e6
        print(f"{label:26}{size:9.1f} MB {wall:7.2f} s {size / wall:8.0f} MB/s  "
              f"processor {cpu:6.2f} s {size / cpu:7.0f}"
              f" MB/s  memory {added:6.3f}", flush=True)
    in_a_process(work)


def read_and_compare(mesh, name, path):
    def compare():
        reference, read = mesh_files.of_grid(mesh), READERS[name](path)
        assert len(read.patches) == len(reference.patches)
        reference.assert_same(read)
        print(f"{'':26}read back: the same {len(read.points)} points, {sum(map(len, read.cells.values()))} cells, "
              f"{len(read.patches)} patches")
    if not in_a_process(compare):
        print(f"{'':26}READ BACK: NOT THE SAME")


def run(folder, file, compared):
    mesh = read_mesh(file)
    print(f"{file}: {mesh.GetNumberOfPoints()} points, {mesh.GetNumberOfCells()} cells, "
          f"{mesh.GetActualMemorySize() / 1024:.0f} MiB")
    xml, raw, legacy = vtkXMLUnstructuredGridWriter(), vtkXMLUnstructuredGridWriter(), vtkUnstructuredGridWriter()
    xml.SetDataModeToBinary()
    raw.SetDataModeToAppended()
    raw.EncodeAppendedDataOff()
    raw.SetCompressorTypeToNone()
    legacy.SetFileTypeToBinary()
    measure("VTK .vtu, binary, zlib", xml, mesh, os.path.join(folder, "mesh.vtu"))
    measure("VTK .vtu, raw", raw, mesh, os.path.join(folder, "mesh.vtu"))
    measure("VTK .vtk, binary", legacy, mesh, os.path.join(folder, "mesh.vtk"))
    for name in READERS:
        path = os.path.join(folder, name)
        measure(name, vtkSolverMeshWriter.NewForFile(path), mesh, path)
        if compared:
            read_and_compare(mesh, name, path)
    for name in ("mesh.msh", "case/constant/polyMesh"):
        writer = vtkSolverMeshWriter.NewForFile(os.path.join(folder, name))
        writer.SetFileType(ASCII)
        measure(name + ", text", writer, mesh, os.path.join(folder, name))


def main():
    words = [word for word in sys.argv[1:] if word != "--measure-only"]
    if len(words) < 2:
        print(__doc__)
        return 2
    for file in words[1:]:
        folder = os.path.join(words[0], "written")
        os.makedirs(folder)
        try:
            run(folder, file, compared="--measure-only" not in sys.argv)
        finally:
            shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
