"""OpenFOAM's checkMesh on meshes with prisms: check_mesh.py FOLDER. Status 77: it is not installed.

It must find nothing but the aspect ratio, no face less orthogonal than 70 degrees, and no topological error.
"""
import os
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource

sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples", "Validation"))

import check_files  # noqa: E402
import meshing  # noqa: E402
import openfoam  # noqa: E402
import slab  # noqa: E402

from ransmeshing import (vtkDirectionalEnrichment, vtkIsotropicTetMesher,  # noqa: E402
                         vtkPrismRecombination, vtkRANSPointRemoval)

WEDGE = 13  # VTK's number


def plate():
    line = slab.even(0, 1, 0.1)
    surface = slab.box(line, line, slab.even(0, 0.5, 0.1), lambda p: "wall" if p[2] < 1e-9 else
                       "lid" if p[2] > 0.5 - 1e-9 else f"side_{p[0] < 1e-9}_{p[0] > 1 - 1e-9}_{p[1] < 0.5}",
                       {"wall": "wall", "lid": "farfield"})
    return meshing.make_mesh(surface, {"wall": (1e-4, 1.2, 20)}, prisms=True)


def sphere():
    solid, finer = vtkPlatonicSolidSource(), vtkLinearSubdivisionFilter()
    solid.SetSolidTypeToIcosahedron()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(3)
    finer.Update()
    points = vtk_to_numpy(finer.GetOutput().GetPoints().GetData())
    points /= numpy.linalg.norm(points, axis=1)[:, None]
    mesher = vtkIsotropicTetMesher()
    mesher.SetInputData(finer.GetOutput())
    mesher.FarFieldOn()
    stages = [mesher, vtkRANSPointRemoval(), vtkDirectionalEnrichment(), vtkPrismRecombination()]
    stages[1].SetFirstHeight(1e-4)
    for before, after in zip(stages, stages[1:]):
        after.SetInputConnection(before.GetOutputPort())
    stages[-1].Update()
    return stages[-1].GetOutput()


def check(name, mesh, folder):
    """Has checkMesh nothing to say against the mesh but the aspect ratio?"""
    topology, negative, others, angle = check_files.complaints_of(mesh, os.path.join(folder, name))
    complaints = [*topology, *negative, *(line for line in others if "aspect ratio" not in line)]
    wedges = int((vtk_to_numpy(mesh.GetCellTypesArray()) == WEDGE).sum())
    print(f"{name}: {wedges} wedges, non-orthogonality {angle:.1f}; {complaints or 'no complaints'}")
    return not complaints and angle <= 70 and wedges > 0


def main(folder):
    if not openfoam.is_installed():
        print("skipped: OpenFOAM is not installed (Examples/Validation/install-solvers.sh)")
        return 77
    results = [check(name, make(), folder) for name, make in (("plate", plate), ("sphere", sphere))]
    return 0 if all(results) else 1


sys.exit(main(sys.argv[1]))
