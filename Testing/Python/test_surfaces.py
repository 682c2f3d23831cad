"""Surfaces before they are meshed: check, repair and wrap, with what they tell."""
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource

from ransmeshing import vtkIsotropicTetMesher, vtkSurfaceCheck, vtkSurfaceRepair, vtkSurfaceWrap

vtkObject.GlobalWarningDisplayOff()


def ball(centre=0.0, radius=1.0, end_theta=360.0):
    sphere = vtkSphereSource()
    sphere.SetOutputPointsPrecision(1)
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(10)
    sphere.SetEndTheta(end_theta)
    sphere.SetCenter(centre, 0.01, 0.02)
    sphere.SetRadius(radius)
    sphere.Update()
    return sphere.GetOutput()


def blocks(**named):
    data = vtkMultiBlockDataSet()
    for i, (name, surface) in enumerate(named.items()):
        data.SetBlock(i, surface)
        data.GetMetaData(i).Set(data.NAME(), name)
    return data


def run(algorithm, surface):
    algorithm.SetInputDataObject(surface)
    algorithm.Update()
    return algorithm


def rows(table):
    names = [table.GetColumnName(c) for c in range(table.GetNumberOfColumns())]
    return [{n: table.GetValueByName(r, n).ToString() for n in names} for r in range(table.GetNumberOfRows())]


def reasons(problems):
    names = problems.GetFieldData().GetAbstractArray("ReasonNames")
    array = problems.GetCellData().GetArray("Reason")
    return {names.GetValue(int(array.GetTuple1(i))) for i in range(array.GetNumberOfTuples())}


def test_sound():
    check = run(vtkSurfaceCheck(), blocks(shell=ball(radius=2), core=ball()))
    assert check.GetSound() and "nothing is wrong" in check.GetReportText(), check.GetReportText()
    assert check.GetOutput().GetNumberOfCells() == 0
    shell, core = rows(check.GetOutputDataObject(2))
    assert (shell["EnclosedBy"], core["EnclosedBy"]) == ("-1", "0"), (shell, core)
    assert (shell["Patches"], core["Patches"]) == ("shell", "core")
    assert 3.5 < float(core["Volume"]) < 4.2 and core["OpenEdges"] == "0"


def test_crossing():
    check = run(vtkSurfaceCheck(), blocks(hull=ball(), fin=ball(centre=0.9)))
    assert not check.GetSound()
    assert "triangles of 'hull' and 'fin' cross near (" in check.GetReportText(), check.GetReportText()
    problems = check.GetOutput()
    assert reasons(problems) == {"intersection"}
    partner = problems.GetCellData().GetArray("PartnerId")
    patch = problems.GetCellData().GetArray("PatchId")
    for i in range(problems.GetNumberOfCells()):
        other = int(partner.GetTuple1(i))
        assert patch.GetTuple1(i) != patch.GetTuple1(other)
    (row,) = rows(check.GetOutputDataObject(1))
    assert row["Kind"] == "intersection" and row["Patches"] == "'hull' and 'fin'", row
    assert 0 < float(row["X"]) < 0.9 and int(row["Triangles"]) == problems.GetNumberOfCells()
    check.IntersectionsOff()
    check.Update()
    assert check.GetSound()


def test_repair_is_told_and_enough():
    open_ball = ball(end_theta=350)
    check = run(vtkSurfaceCheck(), open_ball)
    assert reasons(check.GetOutput()) == {"open edge"}
    repair = vtkSurfaceRepair()
    repair.SetLargestHole(3)
    run(repair, open_ball)
    (row,) = rows(repair.GetOutputDataObject(1))
    assert row["Repair"].startswith("1 hole filled by") and row["Count"] == "1", row
    assert run(vtkSurfaceCheck(), repair.GetOutput()).GetSound()
    mesher = vtkIsotropicTetMesher()
    assert run(mesher, open_ball).GetOutput().GetNumberOfCells() == 0
    mesher.SetLargestHole(3)
    mesher.Update()
    assert mesher.GetOutput().GetNumberOfCells() > 0


def test_wrap_keeps_names():
    wrap = vtkSurfaceWrap()
    wrap.SetAlpha(0.2)
    run(wrap, blocks(hull=ball(), fin=ball(centre=0.9)))
    assert abs(wrap.GetOffsetUsed() - 0.2 / 30) < 1e-12
    field = wrap.GetOutput().GetFieldData()
    assert field.GetArray("WrapOffset").GetTuple1(0) == wrap.GetOffsetUsed()
    names = field.GetAbstractArray("PatchNames")
    assert [names.GetValue(i) for i in range(1, 3)] == ["hull", "fin"]
    assert wrap.GetOutput().GetCellData().GetArray("PatchId").GetRange() == (1, 2)
    assert run(vtkSurfaceCheck(), wrap.GetOutput()).GetSound()
    wrap.SetAlpha(1e-6)
    wrap.Update()
    assert wrap.GetOutput().GetNumberOfCells() == 0, "too many triangles are refused"


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
