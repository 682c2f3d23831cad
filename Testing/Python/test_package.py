"""The package gives all filters, each with documentation on what a user sets."""
import ransmeshing

FILTERS = ("vtkIsotropicTetMesher", "vtkRANSPointRemoval", "vtkDirectionalEnrichment", "vtkPrismRecombination",
           "vtkMeshQualityReport")

SURFACE_FILTERS = ("vtkSurfaceCheck", "vtkSurfaceRepair", "vtkSurfaceRemesher", "vtkSurfaceWrap")

for name in FILTERS + SURFACE_FILTERS:
    cls = getattr(ransmeshing, name)
    kind = "vtkPolyDataAlgorithm" if name in SURFACE_FILTERS else "vtkUnstructuredGridAlgorithm"
    assert cls().IsA(kind), name
    assert len(cls.__doc__) > 200, f"{name} has no documentation"
    for attribute in vars(cls):
        if attribute.startswith(("Set", "Add")):
            text = getattr(cls, attribute).__doc__
            # The wrapper writes the signatures; what follows an empty line is ours.
            assert "\n\n" in text, f"{name}.{attribute} has no documentation"
