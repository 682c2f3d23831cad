#!/usr/bin/env python3
"""Pictures of a mesh with layers around a body: python3 pictures.py MESH.vtu FOLDER

Needs a display: without one, run it under `xvfb-run -a`. The mesh is cut along the middle of its walls, at
right angles to y.
"""
import os
import sys

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkBoundingBox, vtkDataObject, vtkPlane
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCutter, vtkThreshold
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkDataSetMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401  draws the text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  draws the rest

SIZE = (1600, 1000)
BODY = (0.62, 0.66, 0.72)
FIELD = (0.93, 0.93, 0.90)
INK = (0.12, 0.14, 0.18)


def cells_between(source, array, low, high):
    threshold = vtkThreshold()
    threshold.SetInputDataObject(source)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, array)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(low)
    threshold.SetUpperThreshold(high)
    threshold.Update()
    return threshold.GetOutput()


def wall_triangles(mesh):
    """The boundary triangles of the patches of type wall."""
    types = mesh.GetFieldData().GetAbstractArray("PatchTypes")
    numbers = [i for i in range(1, types.GetNumberOfValues()) if types.GetValue(i) == "wall"]
    walls = vtkAppendFilter()
    for number in numbers:
        walls.AddInputData(cells_between(mesh, "PatchId", number, number))
    walls.Update()
    return walls.GetOutput()


def plane_across(y):
    plane = vtkPlane()
    plane.SetOrigin(0, y, 0)
    plane.SetNormal(0, 1, 0)
    return plane


def half_behind(cells, plane, with_cut_cells=False):
    """The whole cells beyond the plane, so that their shapes are seen."""
    extract = vtkExtractGeometry()
    extract.SetInputData(cells)
    extract.SetImplicitFunction(plane)
    extract.ExtractInsideOff()
    extract.SetExtractBoundaryCells(with_cut_cells)
    extract.Update()
    return extract.GetOutput()


def cut(tetrahedra, plane):
    cutter = vtkCutter()
    cutter.SetInputData(tetrahedra)
    cutter.SetCutFunction(plane)
    cutter.GenerateTrianglesOff()
    cutter.Update()
    return cutter.GetOutput()


def foremost(walls, plane):
    """The point of the walls, near the plane, where x is smallest."""
    cutter = vtkCutter()
    cutter.SetInputData(walls)
    cutter.SetCutFunction(plane)
    cutter.Update()
    points = cutter.GetOutput()
    return min((points.GetPoint(i) for i in range(points.GetNumberOfPoints())), key=lambda p: p[0])


def layers_thickness(mesh):
    """Of the layers that were asked for, where they are thickest."""
    def rows(name):
        array = mesh.GetFieldData().GetArray(name)
        return [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())]

    def thickness(first, growth, count):
        return first * (count if growth == 1 else (growth ** count - 1) / (growth - 1))

    return max(thickness(*row) for row in zip(*map(rows, ("LayersFirstHeight", "LayersGrowthRate",
                                                          "LayersNumber"))))


def layer_colors(count):
    """Colour 0 for the field, then from the wall outward."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(count + 1)
    table.SetRange(0, count)
    table.SetTableValue(0, *FIELD, 1)
    stops = [(0.16, 0.22, 0.50), (0.13, 0.48, 0.65), (0.25, 0.70, 0.58), (0.72, 0.83, 0.40),
             (0.98, 0.86, 0.42)]
    for layer in range(1, count + 1):
        place = (layer - 1) / max(1, count - 1) * (len(stops) - 1)
        low = min(int(place), len(stops) - 2)
        part = place - low
        mixed = [(1 - part) * a + part * b for a, b in zip(stops[low], stops[low + 1])]
        table.SetTableValue(layer, *mixed, 1)
    return table


def actor_of(data, color=None, table=None, edges=INK, line_width=1.0):
    surface = vtkGeometryFilter()
    surface.SetInputDataObject(data)
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    if table:
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("LayerId")
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*(color or FIELD))
    look.SetEdgeVisibility(edges is not None)
    look.SetEdgeColor(*(edges or INK))
    look.SetLineWidth(line_width)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.7)
    return actor


def legend(table):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.0f")
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.62, 0.03)
    bar.SetWidth(0.36)
    bar.SetHeight(0.12)
    bar.SetBarRatio(0.3)
    bar.SetUnconstrainedFontSize(True)
    bar.DrawBackgroundOn()
    bar.GetBackgroundProperty().SetColor(1, 1, 1)
    bar.DrawFrameOn()
    bar.GetFrameProperty().SetColor(*INK)
    title = vtkTextActor()
    title.SetInput("Layer (1 at the wall, 0 none)")
    title.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    title.SetPosition(0.635, 0.115)
    for text in (title.GetTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(*INK)
        text.SetFontSize(20)
        text.ShadowOff()
        text.ItalicOff()
        text.BoldOff()
    return [bar, title]


def draw_scene(actors, path, focus, direction, height, up=(0, 0, 1)):
    """A parallel view along `direction` of what lies around `focus`, `height` length units high."""
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddViewProp(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*focus)
    away = vtkBoundingBox(renderer.ComputeVisiblePropBounds()).GetDiagonalLength()  # all is before the camera
    camera.SetPosition(*(f - away * d for f, d in zip(focus, direction)))
    camera.SetViewUp(*up)
    camera.SetParallelScale(height / 2)
    renderer.ResetCameraClippingRange()
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()
    return path


def draw(mesh, folder):
    """Draws the three pictures into the folder; gives their paths."""
    count = int(mesh.GetCellData().GetArray("LayerId").GetRange()[1])
    walls = wall_triangles(mesh)
    tetrahedra = cells_between(mesh, "PatchId", 0, 0)
    table = layer_colors(count)
    xmin, xmax, ymin, ymax, zmin, zmax = walls.GetBounds()
    length = xmax - xmin
    middle = ((xmin + xmax) / 2, (ymin + ymax) / 2, (zmin + zmax) / 2)
    plane = plane_across(middle[1])

    # The body seen from within closes the cuts.
    section = [actor_of(cut(tetrahedra, plane), table=table, line_width=0.8), *legend(table),
               actor_of(half_behind(walls, plane, True), BODY, edges=None)]
    return [
        draw_scene([actor_of(walls, BODY), actor_of(half_behind(tetrahedra, plane), table=table, line_width=0.8),
                    *legend(table)],
                   os.path.join(folder, "surface.png"), middle, (0.45, 1, -0.35), 0.72 * length),
        draw_scene(section,
                   os.path.join(folder, "cut.png"), middle, (0, 1, 0), 0.85 * length),
        draw_scene(section,
                   os.path.join(folder, "close-up.png"), foremost(walls, plane), (0, 1, 0),
                   2.7 * layers_thickness(mesh)),
    ]


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(arguments[0])
    reader.Update()
    for path in draw(reader.GetOutput(), arguments[1]):
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
