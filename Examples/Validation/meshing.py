"""The pipeline from a surface to a mesh with layers."""
from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkMeshQualityReport,
                         vtkPrismRecombination, vtkRANSPointRemoval)


class MeshingError(RuntimeError):
    """A filter could not do its work."""


def _run(algorithm):
    errors = []
    observer = algorithm.AddObserver("ErrorEvent", lambda *_: errors.append(algorithm.GetClassName()))
    algorithm.Update()
    algorithm.RemoveObserver(observer)
    if errors or algorithm.GetOutput().GetNumberOfCells() == 0:
        raise MeshingError(f"{algorithm.GetClassName()} made no mesh; its message is above")
    return algorithm.GetOutput()


def make_mesh(surface, layers, size=0.0, prisms=False):
    """The mesh of the space that the surface bounds.

    layers: of each patch that gets them, by name: (first height, growth, number). size: the largest edge in the
    field, 0 for no limit. Prints the quality report's first lines.
    """
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputData(surface)
    mesher.SetMaximumEdgeLength(size)
    stages = [mesher]
    for stage in (vtkRANSPointRemoval(), vtkDirectionalEnrichment()):
        for name, (height, growth, number) in layers.items():
            stage.SetPatchLayers(name, height, growth, number)
        stages.append(stage)
    if prisms:
        stages.append(vtkPrismRecombination())
    stages.append(vtkMeshQualityReport())
    for before, after in zip(stages, stages[1:]):
        after.SetInputConnection(before.GetOutputPort())
    for stage in stages:
        mesh = _run(stage)
    if not stages[-1].GetValid():
        raise MeshingError(stages[-1].GetReportText())
    print("\n".join(stages[-1].GetReportText().splitlines()[:3]))
    return mesh
