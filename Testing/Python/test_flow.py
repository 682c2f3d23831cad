"""The first height from flow conditions: the figures, and that the layers have it."""
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkRANSLayerAlgorithm,
                         vtkRANSPointRemoval)

FIRST_HEIGHT = 7.4869996e-6  # air, 50 m/s, y+ 1 at 1 m, by Schlichting's law


def give_flow(layers):
    layers.SetVelocity(50)
    layers.SetReferenceLength(1)
    layers.SetFluid(vtkRANSLayerAlgorithm.AIR)


def test_figures():
    layers = vtkRANSPointRemoval()
    give_flow(layers)
    assert abs(layers.GetEstimatedFirstHeight() / FIRST_HEIGHT - 1) < 1e-6
    layers.SetYPlus(30)
    assert abs(layers.GetEstimatedFirstHeight() / FIRST_HEIGHT - 30) < 1e-4
    layers.SetVelocity(0)
    assert layers.GetEstimatedFirstHeight() == 0


def test_the_chain_has_the_first_height():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(10)
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputConnection(sphere.GetOutputPort())
    mesher.FarFieldOn()
    removal = vtkRANSPointRemoval()
    removal.SetInputConnection(mesher.GetOutputPort())
    give_flow(removal)
    removal.SetNumberOfLayers(4)
    enrichment = vtkDirectionalEnrichment()
    enrichment.SetInputConnection(removal.GetOutputPort())
    enrichment.Update()
    asked = vtk_to_numpy(enrichment.GetOutputDataObject(1).GetPointData().GetArray("FirstHeightAsked"))
    assert abs(asked.max() / FIRST_HEIGHT - 1) < 1e-6


if __name__ == "__main__":
    test_figures()
    test_the_chain_has_the_first_height()
