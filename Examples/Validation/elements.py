"""A mesh of VTK handed to finite_elements.py, and what comes back."""
import json
import os
import subprocess
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkProbeFilter, vtkThreshold

TETRAHEDRON, TRIANGLE = 10, 5


class SolverError(RuntimeError):
    """The solver is missing, or stopped with an error."""


def is_installed():
    return subprocess.run([sys.executable, "-c", "import dolfin"], capture_output=True, check=False).returncode == 0


def cells_of(mesh, kind, size):
    numbers = numpy.nonzero(vtk_to_numpy(mesh.GetCellTypesArray()) == kind)[0]
    offsets = vtk_to_numpy(mesh.GetCells().GetOffsetsArray())
    points = vtk_to_numpy(mesh.GetCells().GetConnectivityArray())
    return numbers, points[offsets[numbers][:, None] + numpy.arange(size)]


def patch_number(mesh, name):
    names = mesh.GetFieldData().GetAbstractArray("PatchNames")
    return next(i for i in range(names.GetNumberOfValues()) if names.GetValue(i) == name)


def solve(path, mesh, conditions, viscosities, start_velocity=0.0, point_pressure=False):
    """Velocity and pressure at the points. conditions: (patch's name, component or "p", value); the last one wins."""
    _, tetrahedra = cells_of(mesh, TETRAHEDRON, 4)
    numbers, triangles = cells_of(mesh, TRIANGLE, 3)
    patches = vtk_to_numpy(mesh.GetCellData().GetArray("PatchId"))[numbers]
    given = [{"patch": patch_number(mesh, patch), "component": component, "value": value}
             for patch, component, value in conditions]
    numpy.savez(path + ".npz", points=vtk_to_numpy(mesh.GetPoints().GetData()), tetrahedra=tetrahedra,
                triangles=triangles, patch=patches, viscosities=viscosities, conditions=json.dumps(given),
                start_velocity=start_velocity, point_pressure=point_pressure)
    program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "finite_elements.py")
    environment = dict(os.environ, OMP_NUM_THREADS="2")
    done = subprocess.run([sys.executable, program, path + ".npz", path + "-result.npz"], env=environment, check=False)
    if done.returncode != 0:
        raise SolverError("the finite elements failed; the message is above")
    result = numpy.load(path + "-result.npz")
    return result["velocity"], result["pressure"]


def sampler(mesh, values, of_cells=False):
    """A function from points to the values there, linear in between. values: at the mesh's points, or of its cells."""
    fluid = vtkThreshold()  # the cells of the fluid alone
    copy = vtkUnstructuredGrid()
    copy.ShallowCopy(mesh)
    array = numpy_to_vtk(numpy.ascontiguousarray(_padded(values, mesh) if of_cells else values), deep=True)
    array.SetName("value")
    (copy.GetCellData() if of_cells else copy.GetPointData()).AddArray(array)
    fluid.SetInputData(copy)
    fluid.SetInputArrayToProcess(0, 0, 0, 1, "PatchId")
    fluid.SetThresholdFunction(vtkThreshold.THRESHOLD_LOWER)
    fluid.SetLowerThreshold(0)
    source = fluid
    if of_cells:
        source = vtkCellDataToPointData()
        source.SetInputConnection(fluid.GetOutputPort())
    source.Update()
    grid = source.GetOutput()

    def sample(points):
        probe, places = vtkProbeFilter(), vtkPoints()
        for point in points:
            places.InsertNextPoint([min(max(x, 1e-9), 1 - 1e-9) for x in point[:2]] + [point[2]])
        targets = vtkPolyData()
        targets.SetPoints(places)
        probe.SetInputData(targets)
        probe.SetSourceData(grid)
        probe.Update()
        return vtk_to_numpy(probe.GetOutput().GetPointData().GetArray("value"))

    return sample


def _padded(values, mesh):
    """Values of the cells of the fluid, which come first, and nothing for the boundary."""
    padded = numpy.zeros((mesh.GetNumberOfCells(), values.shape[1]))
    padded[:len(values)] = values
    return padded
