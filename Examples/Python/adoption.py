#!/usr/bin/env python3
"""Layers on a mesh that is there already: python3 adoption.py MESH OUT.vtu FIRST_HEIGHT [WALL...]

MESH holds tetrahedra: .msh (gmsh's format 2.2 or 4.1; netgen exports it too) or .vtu (as meshio converts to). WALL...
are names of patches, with * and ?; else the patches of type wall get the layers. Lengths are in the mesh's unit.
"""
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from ransmeshing import (vtkDirectionalEnrichment, vtkGmshMeshReader, vtkMeshAdoption, vtkMeshQualityReport,
                         vtkRANSPointRemoval)

import pipeline


def make_chain(path, first_height, walls=(), layers=25):
    """The reader and the filters in a row; nothing runs before the last one is updated."""
    reader = vtkGmshMeshReader() if path.endswith(".msh") else vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)

    adoption = vtkMeshAdoption()  # in the place of vtkIsotropicTetMesher
    adoption.SetInputConnection(reader.GetOutputPort())

    removal = vtkRANSPointRemoval()
    removal.SetInputConnection(adoption.GetOutputPort())
    removal.SetFirstHeight(first_height)
    removal.SetNumberOfLayers(layers)
    for wall in walls:
        removal.AddWallPatch(wall)

    enrichment = vtkDirectionalEnrichment()
    enrichment.SetInputConnection(removal.GetOutputPort())

    report = vtkMeshQualityReport()
    report.SetInputConnection(0, enrichment.GetOutputPort(0))
    report.SetInputConnection(1, enrichment.GetOutputPort(1))
    return reader, adoption, removal, enrichment, report


def main(arguments):
    if len(arguments) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    filters = make_chain(arguments[0], float(arguments[2]), arguments[3:])
    try:
        pipeline.run(filters)
        print(filters[-1].GetReportText())
        pipeline.write(filters[-1].GetOutput(), arguments[1])
    except pipeline.MeshingError as error:
        print(f"adoption.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
