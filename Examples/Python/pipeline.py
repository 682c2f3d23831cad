#!/usr/bin/env python3
"""From a surface to a mesh with boundary layers: python3 pipeline.py SURFACE.vtp MESH.vtu [FIRST_HEIGHT]

SURFACE.vtp holds closed bodies; the mesh fills a box around them. Lengths are in the surface's unit.
"""
import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridWriter

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher, vtkMeshQualityReport,
                         vtkRANSPointRemoval)


class MeshingError(Exception):
    """What a filter said when it could not do its work."""


def raise_errors(algorithm):
    """Makes the filter's errors exceptions of Update(), which VTK's own are not."""
    errors = []

    def remember(caller, event, text):
        errors.append(text.split("): ", 1)[-1].strip())

    remember.CallDataType = "string0"
    for reporter in (algorithm, algorithm.GetExecutive()):
        reporter.AddObserver("ErrorEvent", remember)

    def update():
        algorithm.Update()
        if errors:
            raise MeshingError(errors[0])

    return update


def make_chain(surface, first_height, layers=25):
    """The four filters in a row; nothing runs before the last one is updated."""
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputConnection(surface)
    mesher.FarFieldOn()
    mesher.SetFarFieldMargins(3, 3, 3, 3, 3, 3)  # body lengths

    removal = vtkRANSPointRemoval()
    removal.SetInputConnection(mesher.GetOutputPort())
    removal.SetFirstHeight(first_height)
    removal.SetNumberOfLayers(layers)

    # Takes the layers that the removal made room for: they travel with the mesh.
    enrichment = vtkDirectionalEnrichment()
    enrichment.SetInputConnection(removal.GetOutputPort())

    report = vtkMeshQualityReport()
    report.SetInputConnection(0, enrichment.GetOutputPort(0))
    report.SetInputConnection(1, enrichment.GetOutputPort(1))
    return mesher, removal, enrichment, report


def run(filters):
    """Runs the filters one after the other, so that an error is told from its consequences."""
    for update in [raise_errors(algorithm) for algorithm in filters]:
        update()


def write(mesh, path):
    """Writes the mesh so that every ParaView can read it."""
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()  # some ParaViews cannot read the default, appended
    if writer.Write() != 1:
        raise MeshingError(f"{path} could not be written")


def main(arguments):
    if len(arguments) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(arguments[0])
    first_height = float(arguments[2]) if len(arguments) == 3 else 1e-5
    filters = make_chain(reader.GetOutputPort(), first_height)
    try:
        run(filters)
        report = filters[-1]
        print(report.GetReportText())
        write(report.GetOutput(), arguments[1])
    except MeshingError as error:
        print(f"pipeline.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
