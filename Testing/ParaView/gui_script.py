"""What `paraview --script` runs: the chain in the window, then FOLDER/done (or FOLDER/failed) is written."""
import os
import traceback

from paraview import simple

folder = os.environ["GUI_FOLDER"]


def build():
    simple.LoadPlugin(os.environ["PLUGIN"], remote=False, ns=globals())
    view = simple.GetActiveViewOrCreate("RenderView")
    surface = simple.OpenDataFile(os.environ["NOSECONE"])
    mesher = IsotropicTetMesher(registrationName="Isotropic mesh", Input=surface, FarField=1,
                                FarFieldMargins=[2] * 6)
    simple.UpdatePipeline(proxy=mesher)
    removal = RANSPointRemoval(registrationName="Room for layers", Input=mesher, FirstHeight=2e-5,
                               NumberOfLayers=30)
    enrichment = DirectionalEnrichment(registrationName="Layers", Input=removal)
    simple.UpdatePipeline(proxy=enrichment)
    # Without the boundary triangles, which coincide with the tetrahedra's outer faces.
    tetrahedra = MeshTetrahedra(registrationName="Tetrahedra", Input=enrichment[0])
    half = simple.Clip(registrationName="Half of them", Input=tetrahedra, Crinkleclip=1)
    half.ClipType.Origin, half.ClipType.Normal, half.Invert = [0, 0, 0], [0, -1, 0], 1
    display = simple.Show(half, view)
    display.Representation = "Surface With Edges"
    simple.ColorBy(display, ("CELLS", "LayerId"))
    display.EdgeColor = [0.15, 0.17, 0.2]
    # The field light, then from the wall outward.
    display.LookupTable.RGBPoints = [0, 0.93, 0.93, 0.9, 0.5, 0.93, 0.93, 0.9, 1, 0.16, 0.22, 0.5,
                                     15, 0.25, 0.7, 0.58, 30, 0.98, 0.86, 0.42]
    display.LookupTable.ColorSpace = "RGB"
    display.SetScalarBarVisibility(view, True)
    simple.SetActiveSource(removal)
    simple.Render(view)  # the first time the window chooses the camera
    view.CameraPosition, view.CameraFocalPoint = [0.1, -6, 1], [0.55, 0, -0.16]
    view.CameraViewUp, view.CameraParallelProjection, view.CameraParallelScale = [0, 0, 1], 1, 0.42
    simple.Render(view)


try:
    build()
    marker, text = "done", ""
except Exception:  # noqa: BLE001  whatever it is, the test is to tell it
    marker, text = "failed", traceback.format_exc()
with open(os.path.join(folder, marker), "w", encoding="utf-8") as file:
    file.write(text)
