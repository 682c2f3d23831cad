"""The package gives all filters, readers and writers, each with documentation on what a user sets."""
import ransmeshing

FILTERS = ("vtkIsotropicTetMesher", "vtkMeshAdoption", "vtkRANSPointRemoval", "vtkDirectionalEnrichment",
           "vtkPrismRecombination", "vtkMeshQualityReport")
SURFACE_FILTERS = ("vtkSurfaceCheck", "vtkSurfaceRepair", "vtkSurfaceRemesher", "vtkSurfaceWrap")
OTHERS = ("vtkGmshMeshReader", "vtkMeshToNamedBlocks", "vtkNamedBlocksToMesh", "vtkCGNSMeshWriter", "vtkGmshMeshWriter",
          "vtkOpenFOAMMeshWriter", "vtkSU2MeshWriter", "vtkUGRIDMeshWriter")
BASES = ("vtkDomainAlgorithm", "vtkRANSLayerAlgorithm", "vtkSolverMeshWriter", "vtkTextOrBinaryMeshWriter")

classes = {name for name in dir(ransmeshing) if name.startswith("vtk") and name != "vtkmodules"}
assert classes == {*FILTERS, *SURFACE_FILTERS, *OTHERS, *BASES}, classes

for name in FILTERS + SURFACE_FILTERS:
    kind = "vtkPolyDataAlgorithm" if name in SURFACE_FILTERS else "vtkUnstructuredGridAlgorithm"
    assert getattr(ransmeshing, name)().IsA(kind), name

for name in classes:
    cls = getattr(ransmeshing, name)
    assert len(cls.__doc__) > 150, f"{name} has no documentation"
    for attribute in vars(cls):
        if attribute.startswith(("Set", "Add")):
            text = getattr(cls, attribute).__doc__
            # The wrapper writes the signatures; what follows an empty line is ours.
            assert "\n\n" in text, f"{name}.{attribute} has no documentation"
