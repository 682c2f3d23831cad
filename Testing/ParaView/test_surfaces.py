"""A broken surface in ParaView: checked, shown, repaired, wrapped, meshed: SCRIPT PLUGIN FOLDER.

Leaves surface-check.png: the triangles in question in red, on the surface.
"""
import os
import sys

from paraview import simple
from paraview.servermanager import Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())


def text_of(check):
    check.UpdatePipelineInformation()
    return check.SMProxy.GetProperty("ReportText").GetElement(0)


# Two balls that cross.
hull = simple.Sphere(ThetaResolution=32, PhiResolution=20)
fin = simple.Sphere(ThetaResolution=24, PhiResolution=16, Radius=0.3, Center=[0.55, 0.03, 0.05])
check = SurfaceCheck(Input=[hull, fin])
simple.UpdatePipeline(proxy=check)
problems = Fetch(check)
assert problems.GetNumberOfCells() > 20
assert "of 'surface_1' and 'surface_2' cross near (" in text_of(check), text_of(check)
assert check.SMProxy.GetProperty("Sound").GetElement(0) == 0
faults = Fetch(check, idx=1)
assert faults.GetNumberOfRows() == 1 and faults.GetValueByName(0, "Kind").ToString() == "intersection"
assert Fetch(check, idx=2).GetNumberOfRows() == 2

view = simple.CreateView("RenderView")
view.ViewSize = [1000, 700]
view.OrientationAxesVisibility = 0
for body in (hull, fin):
    shown = simple.Show(body, view)
    shown.Representation = "Surface With Edges"
    shown.Opacity = 0.25
red = simple.Show(check, view)
red.Representation = "Surface With Edges"
red.ColorArrayName = ["CELLS", ""]
red.DiffuseColor = red.AmbientColor = [0.85, 0.1, 0.1]
view.CameraPosition = [1.2, -2.4, 1.1]
view.CameraFocalPoint = [0.2, 0.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.ResetCamera()
simple.GetActiveCamera().Dolly(1.5)
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
picture = os.path.join(sys.argv[2], "surface-check.png")
simple.SaveScreenshot(picture, view)
assert os.path.getsize(picture) > 10000

# Wrapped, they are a body that can be meshed.
wrap = SurfaceWrap(Input=[hull, fin], Alpha=0.1)
mesher = IsotropicTetMesher(Input=wrap, FarField=1, FarFieldMargins=[1] * 6)
simple.UpdatePipeline(proxy=mesher)
assert Fetch(mesher).GetNumberOfCells() > 1000

# A ball with a gap: repaired, it is sound.
orange = simple.Sphere(EndTheta=350)
repair = SurfaceRepair(Input=orange, LargestHole=2)
sound = SurfaceCheck(Input=repair)
simple.UpdatePipeline(proxy=sound)
sound.UpdatePipelineInformation()
assert sound.SMProxy.GetProperty("Sound").GetElement(0) == 1, text_of(sound)
assert Fetch(repair, idx=1).GetNumberOfRows() == 1
