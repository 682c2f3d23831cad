"""The chain: walls by name, what each output holds, the same bits twice, and the example as a program."""
import os
import subprocess
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader

EXAMPLES = os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples/Python")
sys.path.insert(0, EXAMPLES)
import pipeline  # noqa: E402


def ball():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(14)
    return sphere


def chain():
    sphere = ball()
    filters = pipeline.make_chain(sphere.GetOutputPort(), first_height=1e-3, layers=8)
    pipeline.run(filters)
    return sphere, filters


def test_outputs():
    _, (mesher, removal, enrichment, report) = chain()
    mesh = enrichment.GetOutput()
    layers = vtk_to_numpy(mesh.GetCellData().GetArray("LayerId"))
    assert layers.max() == 8 and layers.min() == 0
    names = mesh.GetFieldData().GetAbstractArray("PatchNames")
    types = mesh.GetFieldData().GetAbstractArray("PatchTypes")
    assert types.GetValue(1) == "wall" and names.GetValue(2).startswith("farfield")
    boundary = enrichment.GetOutputDataObject(1)
    achieved = vtk_to_numpy(boundary.GetPointData().GetArray("LayersAchieved"))
    assert (achieved == 8).sum() == ball_points()
    assert enrichment.GetNumberOfInsertedPoints() == 8 * ball_points()
    assert removal.GetNumberOfRemovedPoints() <= removal.GetNumberOfMarkedPoints()
    assert mesher.GetOutputDataObject(1).GetNumberOfCells() == 0
    assert report.GetValid() and "VALID" in report.GetReportText()


def ball_points():
    sphere = ball()
    sphere.Update()
    return sphere.GetOutput().GetNumberOfPoints()


def test_walls_are_ticked():
    _, (_, removal, enrichment, _) = chain()
    selection = removal.GetWallPatchSelection()
    offered = {selection.GetArrayName(i): selection.GetArraySetting(i)
               for i in range(selection.GetNumberOfArrays())}
    wall = next(name for name, ticked in offered.items() if ticked)
    assert len(offered) == 7 and sum(offered.values()) == 1, offered
    # A side of the box gets layers too; the body loses them.
    selection.EnableArray("farfield_xmin")
    selection.DisableArray(wall)
    enrichment.Update()
    boundary = enrichment.GetOutputDataObject(1)
    patches = vtk_to_numpy(boundary.GetCellData().GetArray("PatchId"))
    achieved = vtk_to_numpy(boundary.GetPointData().GetArray("LayersAchieved"))
    points = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    names = enrichment.GetOutput().GetFieldData().GetAbstractArray("PatchNames")
    number = {names.GetValue(i): i for i in range(1, names.GetNumberOfValues())}
    assert achieved[points[patches == number["farfield_xmin"]]].max() > 0
    assert achieved[points[patches == number[wall]]].max() == 0


def test_twice_the_same():
    first, second = (chain()[1][3].GetOutput() for _ in range(2))
    for get in (lambda m: m.GetPoints().GetData(), lambda m: m.GetCells().GetConnectivityArray()):
        assert (vtk_to_numpy(get(first)) == vtk_to_numpy(get(second))).all()


def test_example():
    with tempfile.TemporaryDirectory() as folder:
        surface, mesh = os.path.join(folder, "ball.vtp"), os.path.join(folder, "mesh.vtu")
        writer = vtkXMLPolyDataWriter()
        sphere = ball()
        writer.SetInputConnection(sphere.GetOutputPort())
        writer.SetFileName(surface)
        writer.Write()
        program = [sys.executable, "-B", os.path.join(EXAMPLES, "pipeline.py")]
        done = subprocess.run([*program, surface, mesh, "1e-3"], capture_output=True, text=True, check=True)
        assert "VALID" in done.stdout
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(mesh)
        reader.Update()
        assert reader.GetOutput().GetNumberOfCells() > 1000
        assert subprocess.run(program, capture_output=True, check=False).returncode == 2
        missing = subprocess.run([*program, surface, mesh, "-1"], capture_output=True, text=True, check=False)
        assert missing.returncode == 1 and "first height" in missing.stderr, missing.stderr


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name, "passed")
