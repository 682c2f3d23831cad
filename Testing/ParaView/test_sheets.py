"""A sheet by the mesher's second input, put in and taken out again: SCRIPT PLUGIN FOLDER."""
import sys

from paraview import simple
from paraview.servermanager import Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())


def patch_names(mesh):
    names = mesh.GetFieldData().GetAbstractArray("PatchNames")
    return [names.GetValue(i) for i in range(1, names.GetNumberOfValues())]


cube = simple.Triangulate(Input=simple.Box())
sheet = simple.Triangulate(Input=simple.Plane(Origin=[-0.2, -0.2, 0], Point1=[0.2, -0.2, 0],
                                              Point2=[-0.2, 0.2, 0], XResolution=4, YResolution=4))
mesher = IsotropicTetMesher(Input=cube, MaximumEdgeLength=0.2)
simple.UpdatePipeline(proxy=mesher)
assert patch_names(Fetch(mesher)) == ["surface"], patch_names(Fetch(mesher))

mesher.Sheets = sheet
simple.UpdatePipeline(proxy=mesher)
assert patch_names(Fetch(mesher)) == ["surface", "wake"], patch_names(Fetch(mesher))

enrichment = DirectionalEnrichment(Input=mesher, FirstHeight=1e-4, NumberOfLayers=5)
simple.UpdatePipeline(proxy=enrichment)
assert Fetch(enrichment).GetCellData().GetArray("LayerId").GetRange() == (0, 5)

mesher.Sheets = []
simple.UpdatePipeline(proxy=mesher)
assert patch_names(Fetch(mesher)) == ["surface"], patch_names(Fetch(mesher))
