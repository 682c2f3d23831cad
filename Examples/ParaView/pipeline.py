#!/usr/bin/env pvpython
"""From a surface to a mesh with boundary layers, in ParaView: pvpython pipeline.py PLUGIN SURFACE.vtp FOLDER

PLUGIN is RANSMeshing.so (nothing need be loaded where PV_PLUGIN_PATH names its folder). Leaves mesh.vtu and
layers.png in FOLDER. Runs in pvbatch too; without a display, run it under `xvfb-run -a`.
"""
import os
import sys

from paraview.servermanager import Fetch
from paraview.simple import (ColorBy, CreateView, GetScalarBar, LoadPlugin, OpenDataFile, Render, ResetCamera,
                             SaveData, SaveScreenshot, Show, UpdatePipeline)


def mesh_around(surface, first_height):
    """The chain of filters: the last two are the enrichment and the report."""
    mesher = IsotropicTetMesher(Input=surface, FarField=1, FarFieldMargins=[3] * 6)  # noqa: F821
    UpdatePipeline(proxy=mesher)  # so that the patches are known by name
    removal = RANSPointRemoval(Input=mesher, FirstHeight=first_height)  # noqa: F821
    print("walls:", *removal.WallPatches)  # those that are ticked; give a list of names to change them
    enrichment = DirectionalEnrichment(Input=removal)  # noqa: F821
    report = MeshQualityReport(Input=enrichment, Boundary=enrichment[1])  # noqa: F821
    return enrichment, report


def save_picture(enrichment, path):
    """The boundary, coloured by the layers that were achieved."""
    view = CreateView("RenderView")
    view.ViewSize = [1200, 800]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    names = Fetch(enrichment).GetFieldData().GetAbstractArray("PatchNames")
    last = max(i for i in range(1, names.GetNumberOfValues()) if not names.GetValue(i).startswith("farfield_"))
    body = Threshold(Input=enrichment[1], Scalars=["CELLS", "PatchId"], LowerThreshold=1,  # noqa: F821
                     UpperThreshold=last)  # the sides of the box follow
    display = Show(body, view)
    display.Representation = "Surface With Edges"
    ColorBy(display, ("POINTS", "LayersAchieved"))
    colors = display.LookupTable
    colors.ApplyPreset("Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(0, 25)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colors, view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.RangeLabelFormat = bar.LabelFormat = "%.0f"
    bar.AutomaticLabelFormat = 0
    view.CameraPosition = [-1.5, -3, 1]
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale *= 0.68
    Render(view)
    SaveScreenshot(path, view)


def main(plugin, surface, folder):
    LoadPlugin(plugin, remote=False, ns=globals())
    enrichment, report = mesh_around(OpenDataFile(surface), first_height=1e-5)
    UpdatePipeline(proxy=report)
    report.UpdatePipelineInformation()
    print(report.SMProxy.GetProperty("ReportText").GetElement(0))
    # Some ParaViews cannot read the writer's default, appended.
    SaveData(os.path.join(folder, "mesh.vtu"), proxy=report, DataMode="Binary",
             CompressorType="ZLib")
    save_picture(enrichment, os.path.join(folder, "layers.png"))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
