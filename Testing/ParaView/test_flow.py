"""The first height from flow conditions, and what follows from them as information: SCRIPT PLUGIN FOLDER."""
import sys

from paraview import simple
from paraview.servermanager import Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())

cube = simple.Triangulate(Input=simple.Box())
mesher = IsotropicTetMesher(Input=cube, MaximumEdgeLength=0.3, FarField=1)
removal = RANSPointRemoval(Input=mesher, Velocity=50, ReferenceLength=1, NumberOfLayers=4)
removal.UpdatePropertyInformation()


def information(name):
    return removal.SMProxy.GetProperty(name).GetElement(0)


assert abs(information("EstimatedFirstHeight") / 7.4869996e-6 - 1) < 1e-6, information("EstimatedFirstHeight")
assert abs(information("EstimatedReynoldsNumber") - 3422935) < 1
assert abs(information("EstimatedBoundaryLayerThickness") - 0.01825248) < 1e-7
assert information("PlannedNumberOfLayers") == 4
simple.UpdatePipeline(proxy=removal)
heights = Fetch(removal).GetFieldData().GetArray("LayersFirstHeight")
assert abs(heights.GetRange()[1] / 7.4869996e-6 - 1) < 1e-6, heights.GetRange()
