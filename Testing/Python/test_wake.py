"""Wakes: the second input of the mesher, and the example."""
import os
import subprocess
import sys
import tempfile

from vtkmodules.util.numpy_support import vtk_to_numpy

EXAMPLES = os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples/Python")
sys.path.insert(0, EXAMPLES)
import pipeline  # noqa: E402
import wake  # noqa: E402


def patches_of(mesh):
    names, types = (mesh.GetFieldData().GetAbstractArray(n) for n in ("PatchNames", "PatchTypes"))
    return {names.GetValue(i): (i, types.GetValue(i)) for i in range(1, names.GetNumberOfValues())}


def test_layers_on_both_sides():
    filters = wake.make_chain(1e-4)
    pipeline.run(filters)
    mesher, _, enrichment, report = filters
    number, kind = patches_of(enrichment.GetOutput())["wake"]
    assert kind == "wake"
    cells = wake.CELLS_ALONG_SPAN * wake.CELLS_ALONG_WAKE
    in_mesh = vtk_to_numpy(mesher.GetOutput().GetCellData().GetArray("PatchId"))
    assert (in_mesh == number).sum() == 2 * cells
    boundary = enrichment.GetOutputDataObject(1)
    of_triangles = vtk_to_numpy(boundary.GetCellData().GetArray("PatchId"))
    points = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray()).reshape(-1, 3)[of_triangles == number]
    assert len(points) >= 4 * cells  # both sides; more where edges were divided
    achieved = vtk_to_numpy(boundary.GetPointData().GetArray("LayersAchieved"))[points]
    assert (achieved == 25).mean() > 0.8, (achieved == 25).mean()
    assert report.GetValid() and "wake sheet" in report.GetReportText()


def test_sheets_can_be_taken_away():
    mesher = wake.make_chain(1e-4)[0]
    assert mesher.GetNumberOfInputConnections(1) == 1
    mesher.RemoveAllSheets()
    mesher.Update()
    assert "wake" not in patches_of(mesher.GetOutput())


def test_what_is_wrong_is_told():
    mesher = wake.make_chain(1e-4)[0]
    mesher.RemoveAllSheets()
    sheet = wake.wake()
    sheet.GetPoints().SetPoint(wake.CELLS_ALONG_SPAN * 3 // 2, 0.5, 0.5, 0)  # inside the wing
    mesher.AddSheetData(sheet)
    try:
        pipeline.run([mesher])
    except pipeline.MeshingError as error:
        assert "the sheet 'wake' cuts or touches" in str(error), error
    else:
        raise AssertionError("no error")
    assert mesher.GetOutputDataObject(1).GetNumberOfCells() > 0


def test_example():
    with tempfile.TemporaryDirectory() as folder:
        program = [sys.executable, "-B", os.path.join(EXAMPLES, "wake.py")]
        done = subprocess.run([*program, os.path.join(folder, "mesh.vtu"), "1e-4"], capture_output=True, text=True,
                              check=True)
        assert "VALID" in done.stdout
        assert subprocess.run(program, capture_output=True, check=False).returncode == 2


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name, "passed")
