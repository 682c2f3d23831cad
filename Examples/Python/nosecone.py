#!/usr/bin/env python3
"""The quick start: python3 nosecone.py FOLDER, with the surface that nosecone-surface wrote there.

Meshes the space around FOLDER/nosecone.vtp and leaves in FOLDER the mesh (mesh.vtu), its boundary with
what the layers achieved (boundary.vtp), the report (report.txt, report.json) and three pictures (.png).
"""
import os
import sys

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import pictures
import pipeline

FIRST_HEIGHT = 2e-5  # body lengths
LAYERS = 32


def write_boundary(boundary, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(boundary)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()
    writer.Write()


def main(folder):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, "nosecone.vtp"))
    filters = pipeline.make_chain(reader.GetOutputPort(), FIRST_HEIGHT, LAYERS)
    pipeline.run(filters)
    enrichment, report = filters[2:]
    mesh = report.GetOutput()
    pipeline.write(mesh, os.path.join(folder, "mesh.vtu"))
    write_boundary(enrichment.GetOutputDataObject(1), os.path.join(folder, "boundary.vtp"))
    with open(os.path.join(folder, "report.txt"), "w", encoding="utf-8") as file:
        file.write(report.GetReportText())
    report.WriteJson(os.path.join(folder, "report.json"))
    print(report.GetReportText())
    for path in pictures.draw(mesh, folder):
        print(path)
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    sys.exit(main(sys.argv[1]))
