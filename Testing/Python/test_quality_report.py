"""The quality report from Python: text, JSON, tables, arrays; its angles against a computation of their own."""
import json
import os
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_TETRA
from vtkmodules.vtkFiltersSources import vtkSphereSource

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkMeshQualityReport,
                         vtkRANSPointRemoval)


def chain():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputConnection(sphere.GetOutputPort())
    mesher.FarFieldOn()
    removal = vtkRANSPointRemoval()
    removal.SetInputConnection(mesher.GetOutputPort())
    removal.SetFirstHeight(1e-4)
    removal.SetNumberOfLayers(12)
    enrichment = vtkDirectionalEnrichment()
    enrichment.SetInputConnection(removal.GetOutputPort())
    report = vtkMeshQualityReport()
    report.SetInputConnection(0, enrichment.GetOutputPort(0))
    report.SetInputConnection(1, enrichment.GetOutputPort(1))
    report.Update()
    return report


def largest_dihedrals(points, tets):
    """By the faces' unit normals: another way than the kernel's."""
    normals = []
    for i, j, k in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
        n = np.cross(points[tets[:, j]] - points[tets[:, i]], points[tets[:, k]] - points[tets[:, i]])
        normals.append(n / np.linalg.norm(n, axis=1)[:, None])
    cosines = [-(normals[i] * normals[j]).sum(axis=1) for i in range(4) for j in range(i)]
    return np.degrees(np.arccos(np.clip(np.min(cosines, axis=0), -1, 1)))


def check_arrays(mesh, figures):
    types = vtk_to_numpy(mesh.GetCellTypesArray())
    connectivity = vtk_to_numpy(mesh.GetCells().GetConnectivityArray())
    count = np.count_nonzero(types == VTK_TETRA)
    tets = connectivity[:4 * count].reshape(-1, 4)
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    angles = vtk_to_numpy(mesh.GetCellData().GetArray("LargestDihedral"))[:count]
    assert np.allclose(angles, largest_dihedrals(points, tets), atol=1e-5)
    assert np.isclose(angles.max(), figures["Shapes"]["whole"]["LargestDihedral"]["p100"])
    assert np.isclose(np.median(angles), figures["Shapes"]["whole"]["LargestDihedral"]["p50"])
    volume = vtk_to_numpy(mesh.GetCellData().GetArray("Volume"))
    assert np.isclose(volume.sum(), figures["Volume"])
    assert not volume[count:].any()


def check_tables(report, figures):
    summary = report.GetOutputDataObject(1)
    names = [summary.GetColumnByName("Quantity").GetValue(i) for i in range(summary.GetNumberOfRows())]
    values = vtk_to_numpy(summary.GetColumnByName("Value"))
    assert values[names.index("Valid")] == 1
    assert values[names.index("Tetrahedra")] == figures["Tetrahedra"]
    histograms = report.GetOutputDataObject(2)
    first = vtk_to_numpy(histograms.GetColumnByName("Histogram")) == 0
    assert vtk_to_numpy(histograms.GetColumnByName("Count"))[first].sum() == figures["Tetrahedra"]


report = chain()
figures = json.loads(report.GetReportJson())
assert report.GetValid() and figures["Valid"]
walls = figures["Walls"]["whole"]
assert walls["MeanLayers"] > 11 and walls["ShareOfAreaWithFirstHeight"] > 0.99, walls
assert sum(walls["ColumnsByLayers"]) == walls["SmoothWallPoints"]
assert "Mesh: VALID" in report.GetReportText()
check_arrays(report.GetOutput(), figures)
check_tables(report, figures)
with tempfile.TemporaryDirectory() as folder:
    file = os.path.join(folder, "report.json")
    assert report.WriteJson(file)
    with open(file, encoding="utf-8") as stream:
        assert json.load(stream) == figures
