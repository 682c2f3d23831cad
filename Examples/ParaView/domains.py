#!/usr/bin/env pvpython
"""Domains, in ParaView: pvpython domains.py PLUGIN CASE FILE FOLDER [PLACE]

CASE  half     FILE is a surface that reaches across y = PLACE, or half of one that ends there, open
      ship     FILE is a hull; its waterline is z = PLACE, its plane of symmetry y = 0
      car      FILE is a body that stands on the ground z = PLACE, a little within it
      adopted  FILE is a mesh of tetrahedra (.msh of gmsh, .vtu): it gets layers as it is

PLUGIN is RANSMeshing.so. Leaves CASE.vtu and CASE.png in FOLDER. PLACE is 0 unless given, in the unit of the
surface. Without a display, run it under `xvfb-run -a`.
"""
import os
import sys

from paraview.servermanager import Fetch
from paraview.simple import (CreateView, LoadPlugin, OpenDataFile, Render, ResetCamera, SaveData,
                             SaveScreenshot, Show, UpdatePipeline)


def half(file, place):
    return IsotropicTetMesher(Input=OpenDataFile(file), FarField=1, FarFieldMargins=[2] * 6,  # noqa: F821
                              SymmetryPlane="Across y", SymmetryPosition=place), "symmetry"


def ship(file, place):
    return IsotropicTetMesher(Input=OpenDataFile(file), FarField=1, FarFieldMargins=[2] * 6,  # noqa: F821
                              SymmetryPlane="Across y", WaterlinePlane="Across z",
                              WaterlinePosition=place), "waterline"


def car(file, place):
    mesher = IsotropicTetMesher(Input=OpenDataFile(file), FarField=1, FarFieldMargins=[2] * 6,  # noqa: F821
                                GroundPlane="Across z", GroundPosition=place)
    mesher.FarFieldSides = ["xmin", "inlet", "", "xmax", "outlet", ""]
    return mesher, "ground"


def adopted(file, _):
    return MeshAdoption(Input=OpenDataFile(file)), None  # noqa: F821


def patch_numbers(source):
    """The numbers of the patches by their names."""
    names = Fetch(source).GetFieldData().GetAbstractArray("PatchNames")
    return {names.GetValue(i): i for i in range(1, names.GetNumberOfValues())}


def size_of(source):
    low_high = source.GetDataInformation().GetBounds()
    return max(low_high[i + 1] - low_high[i] for i in (0, 2, 4))


def show_patches(view, mesh, numbers, colors):
    for number, color in zip(numbers, colors):
        patch = Threshold(Input=mesh, Scalars=["CELLS", "PatchId"], LowerThreshold=number,  # noqa: F821
                          UpperThreshold=number)
        display = Show(patch, view)
        display.Representation = "Surface With Edges"
        display.ColorArrayName = ["POINTS", ""]  # of one colour
        display.AmbientColor = display.DiffuseColor = color
        display.EdgeColor = [0.35 * c for c in color]


def save_picture(mesh, plane, path):
    """The walls and the planes, not the far field."""
    view = CreateView("RenderView")
    view.ViewSize = [1200, 800]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    numbers = patch_numbers(mesh)
    shown = [n for name, n in numbers.items() if not name.startswith("farfield") and name not in ("inlet", "outlet")]
    walls = [n for n in shown if n not in (numbers.get("symmetry"), numbers.get("waterline"), numbers.get("ground"))]
    show_patches(view, mesh, walls, [[0.55, 0.6, 0.75]] * len(walls))
    view.CameraPosition = [-3, -4, 3]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    view.CameraParallelProjection = 1
    ResetCamera(view)  # fills the picture with the walls
    view.CameraParallelScale *= 1.2 if plane else 0.7
    planes = [n for n in shown if n not in walls]
    show_patches(view, mesh, planes, [[0.75, 0.85, 0.75]] * len(planes))
    Render(view)
    SaveScreenshot(path, view)


def main(plugin, case, file, folder, place="0"):
    LoadPlugin(plugin, remote=False, ns=globals())
    mesh, plane = {"half": half, "ship": ship, "car": car, "adopted": adopted}[case](file, float(place))
    UpdatePipeline(proxy=mesh)
    removal = RANSPointRemoval(Input=mesh, FirstHeight=1e-5 * size_of(mesh), NumberOfLayers=15)  # noqa: F821
    enrichment = DirectionalEnrichment(Input=removal)  # noqa: F821
    report = MeshQualityReport(Input=enrichment, Boundary=enrichment[1])  # noqa: F821
    UpdatePipeline(proxy=report)
    report.UpdatePipelineInformation()
    print(report.SMProxy.GetProperty("ReportText").GetElement(0))
    SaveData(os.path.join(folder, case + ".vtu"), proxy=report, DataMode="Binary", CompressorType="ZLib")
    save_picture(report, plane, os.path.join(folder, case + ".png"))


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6):
        sys.exit(__doc__)
    main(*sys.argv[1:])
