#!/usr/bin/env python3
"""OpenFOAM's checkMesh on meshes with layers, as tetrahedra and with prisms: check_files.py FOLDER MESH.vtu...

A row of a table for each mesh: the share of the layers that became prisms; what checkMesh -allTopology says of the
topology, and what it says of volumes and of the faces' orientation; what else plain checkMesh complains of, of the
prisms. Status 1 where there is a topological error, a negative volume or a face that is turned the wrong way.
"""
import os
import re
import shutil
import sys

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Validation"))

import openfoam  # noqa: E402

from ransmeshing import vtkPrismRecombination  # noqa: E402

NEGATIVE = re.compile(r"negative|wrong|oriented|incorrect", re.I)


def complaints_of(mesh, folder):
    """Lines of checkMesh: topological errors; negative volumes and faces turned wrongly; others. And the angle."""
    case = openfoam.Case(folder)
    try:
        openfoam.write_mesh(mesh, case)
        case.set_up(1, "laminar", {}, 1, 1)
        text = case.run("checkMesh", "-allTopology")
        start, end = text.index("Checking topology"), text.index("Checking geometry")
        # Regions that lie apart are no error; the remark on them has one star.
        topology = [line.strip() for line in text[start:end].splitlines() if "***" in line]
        geometry = [line.strip(" *") for line in text[end:].splitlines() if "***" in line]
        angle = float(re.search(r"non-orthogonality Max: ([\d.]+)", text)[1])
        negative = [line for line in geometry if NEGATIVE.search(line)]
        return topology, negative, [line for line in geometry if line not in negative], angle
    finally:
        shutil.rmtree(folder)


def check(path, folder):
    reader, prisms = vtkXMLUnstructuredGridReader(), vtkPrismRecombination()
    reader.SetFileName(path)
    prisms.SetInputConnection(reader.GetOutputPort())
    prisms.Update()
    name = os.path.splitext(os.path.basename(path))[0]
    tets = complaints_of(reader.GetOutput(), os.path.join(folder, name + "-tets"))
    wedges = complaints_of(prisms.GetOutput(), os.path.join(folder, name + "-prisms"))
    bad = [*tets[0], *tets[1], *wedges[0], *wedges[1]]
    print(f"| {name} | {reader.GetOutput().GetNumberOfCells()} | {100 * prisms.GetShareOfLayers():.2f} % | "
          f"{'; '.join(bad) or 'none'} | {'; '.join(wedges[2]) or 'none'} | {wedges[3]:.1f} |", flush=True)
    return not bad


def main(folder, *meshes):
    os.makedirs(folder, exist_ok=True)
    print("| mesh | cells and faces | prisms | errors, of tetrahedra and prisms | else, of prisms | "
          "non-orthogonality |\n|---|---|---|---|---|---|", flush=True)
    return 0 if all([check(mesh, folder) for mesh in meshes]) else 1


if __name__ == "__main__":
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    sys.exit(main(*sys.argv[1:]))
