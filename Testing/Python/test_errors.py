"""What filters refuse is a VTK error that a script can catch, and no mesh comes out."""
import os
import sys

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkMeshQualityReport,
                         vtkRANSPointRemoval)

sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples/Python"))
import pipeline  # noqa: E402

vtkObject.GlobalWarningDisplayOn()


def refuses(algorithm, words):
    update = pipeline.raise_errors(algorithm)
    try:
        update()
    except pipeline.MeshingError as error:
        assert words in str(error), f"{algorithm.GetClassName()} said: {error}"
    else:
        raise AssertionError(f"{algorithm.GetClassName()} did not refuse: {words}")
    assert algorithm.GetOutputDataObject(0).GetNumberOfCells() == 0


def mesher_of(surface):
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputConnection(surface.GetOutputPort())
    mesher.FarFieldOn()
    return mesher


def ball(**angles):
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(10)
    sphere.SetEndTheta(angles.get("end_theta", 360))
    return sphere


def test_empty():
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputData(vtkPolyData())
    refuses(mesher, "empty")


def test_hole_is_shown():
    mesher = mesher_of(ball(end_theta=300))
    refuses(mesher, "not closed")
    problems = mesher.GetOutputDataObject(1)
    assert problems.GetNumberOfCells() > 0
    names = problems.GetFieldData().GetAbstractArray("ReasonNames")
    assert names.GetValue(int(problems.GetCellData().GetArray("Reason").GetTuple1(0))) == "open edge"


def test_worker_missing():
    mesher = mesher_of(ball())
    mesher.SetWorkerExecutable("/nowhere/worker")
    refuses(mesher, "/nowhere/worker")


def layer_filters():
    mesher = mesher_of(ball())
    for filter_class in (vtkRANSPointRemoval, vtkDirectionalEnrichment):
        algorithm = filter_class()
        algorithm.SetInputConnection(mesher.GetOutputPort())
        yield algorithm


def test_layers():
    for algorithm in layer_filters():
        refuses(algorithm, "first height")
    for algorithm in layer_filters():
        algorithm.SetFirstHeight(-1)
        refuses(algorithm, "first height")
    for algorithm in layer_filters():
        algorithm.SetFirstHeight(1e-3)
        algorithm.SetGrowthRate(0.5)
        refuses(algorithm, "growth")
    for algorithm in layer_filters():
        algorithm.SetFirstHeight(1e-3)
        algorithm.AddWallPatch("wing")
        refuses(algorithm, "wing")


def test_no_mesh():
    for filter_class in (vtkRANSPointRemoval, vtkDirectionalEnrichment, vtkMeshQualityReport):
        algorithm = filter_class()
        algorithm.SetInputData(vtkUnstructuredGrid())
        if hasattr(algorithm, "SetFirstHeight"):
            algorithm.SetFirstHeight(1e-3)
        refuses(algorithm, "tetrahedra")


def test_life_goes_on():
    sphere = ball(end_theta=300)
    mesher = mesher_of(sphere)
    refuses(mesher, "not closed")
    sphere.SetEndTheta(360)
    mesher.RemoveAllObservers()
    mesher.Update()
    assert mesher.GetOutput().GetNumberOfCells() > 100


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name, "passed")
