#!/usr/bin/env pvpython
"""Surfaces as they come, in ParaView: pvpython surfaces.py PLUGIN CASE FILE FOLDER [VALUE]

CASE  check   FILE is a surface that is refused: what is wrong, in red; VALUE: the hole that is filled then, if it is given
      wrap    FILE is a surface beyond repair: wrapped by VALUE (alpha, else the filter's own) and meshed in a far field
      remesh  FILE is a surface with poor triangles: remeshed to edges of VALUE; before and after, and its layers
      inside  FILE is a body whose inside is meshed, too: two regions in a cut
      refine  FILE is a body: a box, a sphere and a line of small edges around it, in a cut
      flow    FILE is a body: layers from a velocity and y+, and what follows from them; VALUE: its length in metres

PLUGIN is RANSMeshing.so. Leaves CASE.png, and CASE.vtu where there is a mesh, in FOLDER. Without a display, run it under
`xvfb-run -a`.
"""
import os
import sys

from paraview.simple import (CreateView, GetColorTransferFunction, GetOpacityTransferFunction, LoadPlugin, OpenDataFile,
                             Render, ResetCamera, SaveData, SaveScreenshot, Show, Slice, UpdatePipeline)

GREY, RED, BLUE, GREEN = [0.75, 0.77, 0.8], [0.85, 0.1, 0.1], [0.55, 0.6, 0.75], [0.75, 0.85, 0.75]


def information(proxy, name):
    proxy.UpdatePropertyInformation()
    return proxy.SMProxy.GetProperty(name).GetElement(0)


def extent(source):
    """The largest extent of what a source gives, and its middle."""
    b = source.GetDataInformation().GetBounds()
    return max(b[i + 1] - b[i] for i in (0, 2, 4)), [0.5 * (b[i] + b[i + 1]) for i in (0, 2, 4)]


def new_view():
    view = CreateView("RenderView")
    view.ViewSize = [1200, 800]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraParallelProjection = 1
    return view


def show(view, source, color, opacity=1.0, edges=True):
    display = Show(source, view)
    display.Representation = "Surface With Edges" if edges else "Surface"
    display.ColorArrayName = ["CELLS", ""]
    display.AmbientColor = display.DiffuseColor = color
    display.EdgeColor = [0.35 * c for c in color]
    display.Opacity = opacity
    return display


def save(view, path, source=None, direction=(-3, -4, 2), zoom=1.0):
    """A picture of a view, filled by a source if there is one, else by all that is shown."""
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraPosition = list(direction)
    view.CameraViewUp = [0, 0, 1]
    ResetCamera(view)
    if source:
        size, middle = extent(source)
        view.CameraPosition = [m + size * d for m, d in zip(middle, direction)]
        view.CameraFocalPoint = middle
        view.CameraParallelScale = 0.5 * size
    view.CameraParallelScale /= zoom
    Render(view)
    SaveScreenshot(path, view)


def cut_through(view, mesh, body, colored_by=None):
    """The tetrahedra that a plane across y cuts, whole; coloured by a cell array if one is named."""
    tetrahedra = MeshTetrahedra(Input=mesh)  # noqa: F821
    cut = Slice(Input=tetrahedra, Crinkleslice=1)
    cut.SliceType.Normal = [0, 1, 0]
    cut.SliceType.Origin = extent(body)[1]
    display = show(view, cut, GREEN)
    if colored_by:
        display.ColorArrayName = ["CELLS", colored_by]
        table = GetColorTransferFunction(colored_by)
        table.RescaleTransferFunction(1, 2)
        GetOpacityTransferFunction(colored_by).RescaleTransferFunction(1, 2)
        display.LookupTable = table


def layered(mesh, first_height, layers=15):
    removal = RANSPointRemoval(Input=mesh, FirstHeight=first_height, NumberOfLayers=layers)  # noqa: F821
    return DirectionalEnrichment(Input=removal)  # noqa: F821


def check(surface, folder, value):
    faults = SurfaceCheck(Input=surface)  # noqa: F821
    UpdatePipeline(proxy=faults)
    faults.UpdatePipelineInformation()
    print(faults.SMProxy.GetProperty("ReportText").GetElement(0))
    view = new_view()
    show(view, surface, GREY, 0.3)
    show(view, faults, RED)
    save(view, os.path.join(folder, "check.png"), zoom=1.5)
    if not value:
        return None
    mesher = IsotropicTetMesher(Input=surface, LargestHole=value)  # noqa: F821
    return mesher


def wrap(surface, folder, value):
    wrapped = SurfaceWrap(Input=surface, Alpha=value)  # noqa: F821
    UpdatePipeline(proxy=wrapped)
    print("Alpha", information(wrapped, "AlphaUsed"), "offset", information(wrapped, "OffsetUsed"))
    view = new_view()
    show(view, wrapped, BLUE)
    save(view, os.path.join(folder, "wrap.png"), zoom=1.5)
    return IsotropicTetMesher(Input=wrapped, FarField=1, FarFieldMargins=[2] * 6)  # noqa: F821


def remesh(surface, folder, value):
    size, _ = extent(surface)
    remeshed = SurfaceRemesher(Input=surface, EdgeLength=value or 0.03 * size, EdgesPerCircle=24)  # noqa: F821
    UpdatePipeline(proxy=remeshed)
    print("1 % of the angles below", information(remeshed, "LowAngle"), "degrees; deviation",
          information(remeshed, "Deviation"))
    for name, source in (("given", surface), ("remesh", remeshed)):
        view = new_view()
        show(view, source, BLUE)
        save(view, os.path.join(folder, name + ".png"), zoom=1.5)
    mesh = IsotropicTetMesher(Input=remeshed, FarField=1, FarFieldMargins=[2] * 6)  # noqa: F821
    UpdatePipeline(proxy=mesh)
    return layered(mesh, 1e-5 * size)


def inside(surface, folder, _):
    mesh = IsotropicTetMesher(Input=surface, FarField=1, FarFieldMargins=[1] * 6, KeptInsides=["*"])  # noqa: F821
    UpdatePipeline(proxy=mesh)
    view = new_view()
    cut_through(view, mesh, surface, "RegionId")
    save(view, os.path.join(folder, "inside.png"), surface, (0, -2, 0), 0.6)
    return mesh


def refine(surface, folder, _):
    size, (x, y, z) = extent(surface)
    small = 0.06 * size
    mesh = IsotropicTetMesher(Input=surface, FarField=1, FarFieldMargins=[2] * 6, MaximumEdgeLength=0.5 * size)  # noqa: F821
    behind = [x + 0.6 * size, x + 2 * size, y - 0.2 * size, y + 0.2 * size, z - 0.3 * size, z + 0.3 * size]
    mesh.RefinementBoxes = behind + [small]
    mesh.RefinementSpheres = [x, y, z + 1.2 * size, 0.4 * size, small]
    mesh.RefinementLines = [x - 1.5 * size, y, z - size, x + size, y, z - 1.5 * size, 0.1 * size, small]
    UpdatePipeline(proxy=mesh)
    view = new_view()
    cut_through(view, mesh, surface)
    save(view, os.path.join(folder, "refine.png"), mesh, (0, -2, 0), 1.2)
    return mesh


def flow(surface, folder, value):
    size, _ = extent(surface)
    mesh = IsotropicTetMesher(Input=surface, FarField=1, FarFieldMargins=[2] * 6)  # noqa: F821
    UpdatePipeline(proxy=mesh)
    removal = RANSPointRemoval(Input=mesh, Velocity=30, ReferenceLength=size, YPlus=30,  # noqa: F821
                               LengthUnit=(value or size) / size, NumberOfLayers=12)
    for name in ("ReynoldsNumber", "FirstHeight", "BoundaryLayerThickness", "SkinFriction"):
        print(name, information(removal, "Estimated" + name))
    mesh = DirectionalEnrichment(Input=removal)  # noqa: F821
    UpdatePipeline(proxy=mesh)
    view = new_view()
    cut_through(view, mesh, surface)
    save(view, os.path.join(folder, "flow.png"), surface, (0, -2, 0), 2)
    return mesh


def main(plugin, case, file, folder, value="0"):
    LoadPlugin(plugin, remote=False, ns=globals())
    surface = OpenDataFile(file)
    UpdatePipeline(proxy=surface)
    cases = {"check": check, "wrap": wrap, "remesh": remesh, "inside": inside, "refine": refine, "flow": flow}
    mesh = cases[case](surface, folder, float(value))
    if mesh is None:
        return
    report = MeshQualityReport(Input=mesh)  # noqa: F821
    UpdatePipeline(proxy=report)
    report.UpdatePipelineInformation()
    print(report.SMProxy.GetProperty("ReportText").GetElement(0))
    SaveData(os.path.join(folder, case + ".vtu"), proxy=report, DataMode="Binary", CompressorType="ZLib")


if __name__ == "__main__":
    if len(sys.argv) not in (5, 6):
        sys.exit(__doc__)
    main(*sys.argv[1:])
