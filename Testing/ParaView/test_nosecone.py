"""The chain on the nose-cone, with walls ticked by name and all output ports: SCRIPT PLUGIN FOLDER."""
import os
import sys

from paraview import simple
from paraview.servermanager import Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
folder = sys.argv[2]


def ticked(proxy):
    return list(proxy.WallPatches)


def cell_range(data, name):
    return data.GetCellData().GetArray(name).GetRange()


surface = simple.OpenDataFile(os.environ["NOSECONE"])
mesher = IsotropicTetMesher(Input=surface, FarField=1, FarFieldMargins=[2] * 6)
simple.UpdatePipeline(proxy=mesher)
assert Fetch(mesher, idx=1).GetNumberOfCells() == 0, "there are no problems"

# The patches are offered by name, the body's two ticked; the first height follows from the bounds.
removal = RANSPointRemoval(Input=mesher)
assert ticked(removal) == ["body", "base"], ticked(removal)
bounds = mesher.GetDataInformation().GetBounds()
extent = max(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])
assert abs(removal.FirstHeight - 1e-6 * extent) < 1e-9 * extent, removal.FirstHeight
removal.FirstHeight = 1e-4
removal.NumberOfLayers = 10

# What the removal was told, the enrichment uses.
enrichment = DirectionalEnrichment(Input=removal)
simple.UpdatePipeline(proxy=enrichment)
mesh, boundary = Fetch(enrichment), Fetch(enrichment, idx=1)
assert cell_range(mesh, "LayerId") == (0, 10), cell_range(mesh, "LayerId")
assert boundary.GetPointData().GetArray("LayersAchieved").GetRange() == (0, 10)
whole = mesh.GetNumberOfCells()

# Without the base there are fewer layers, and the ticks of the enrichment follow.
removal.WallPatches = ["body"]
simple.UpdatePipeline(proxy=enrichment)
assert Fetch(enrichment).GetNumberOfCells() < whole
enrichment.UpdatePipelineInformation()
information = enrichment.SMProxy.GetProperty("WallPatchInfo")
offered = [information.GetElement(i) for i in range(4)]
assert offered == ["body", "1", "base", "0"], offered

report = MeshQualityReport(Input=enrichment, Boundary=enrichment[1])
simple.UpdatePipeline(proxy=report)
report.UpdatePipelineInformation()
assert report.SMProxy.GetProperty("Valid").GetElement(0) == 1
assert "VALID" in report.SMProxy.GetProperty("ReportText").GetElement(0)
assert Fetch(report, idx=1).GetNumberOfRows() > 20
assert Fetch(report, idx=2).GetNumberOfRows() > 20

# The mesh, which shows its boundary twice, is not shown by itself; the boundary is, and can be taken out.
controller = simple.servermanager.vtkSMParaViewPipelineControllerWithRendering()
assert controller.GetPreferredViewType(enrichment.SMProxy, 0) == "None"
assert controller.GetPreferredViewType(enrichment.SMProxy, 1) is None
boundary_alone = MeshBoundary(Input=report)
simple.UpdatePipeline(proxy=boundary_alone)
assert Fetch(boundary_alone).GetNumberOfCells() == Fetch(enrichment, idx=1).GetNumberOfCells()
tetrahedra = MeshTetrahedra(Input=report)
simple.UpdatePipeline(proxy=tetrahedra)
assert Fetch(tetrahedra).GetNumberOfCells() == \
    Fetch(report).GetNumberOfCells() - Fetch(boundary_alone).GetNumberOfCells()

# What is written can be read again.
path = os.path.join(folder, "mesh.vtu")
simple.SaveData(path, proxy=report, DataMode="Binary")
again = Fetch(simple.OpenDataFile(path))
assert again.GetNumberOfCells() == Fetch(report).GetNumberOfCells()
