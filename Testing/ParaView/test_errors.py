"""What cannot be meshed is an error that ParaView shows, with its triangles; the host lives on: SCRIPT PLUGIN FOLDER."""
import sys

from paraview import simple
from paraview.servermanager import Fetch
from paraview.vtk import vtkOutputWindow, vtkStringOutputWindow

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
window = vtkStringOutputWindow()
vtkOutputWindow.SetInstance(window)

# A sphere with a hole: what is wrong comes out of the second port.
sphere = simple.Sphere(EndTheta=300)
mesher = IsotropicTetMesher(Input=sphere, FarField=1)
simple.UpdatePipeline(proxy=mesher)
assert "not closed" in window.GetOutput(), window.GetOutput()
assert Fetch(mesher, idx=1).GetNumberOfCells() > 0
assert Fetch(mesher).GetNumberOfCells() == 0

# The surface mended, the same filter works.
sphere.EndTheta = 360
simple.UpdatePipeline(proxy=mesher)
assert Fetch(mesher, idx=1).GetNumberOfCells() == 0
assert Fetch(mesher).GetNumberOfCells() > 0

# No wall is left.
removal = RANSPointRemoval(Input=mesher, FirstHeight=1e-3)
removal.WallPatches = []
simple.UpdatePipeline(proxy=removal)
text = window.GetOutput()
assert "no patch is a viscous wall" in text, text
