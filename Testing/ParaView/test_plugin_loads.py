"""The plugin loads, and every filter's proxy can be made: python SCRIPT PLUGIN FOLDER."""
import sys

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
for name in ("IsotropicTetMesher", "RANSPointRemoval", "DirectionalEnrichment",
             "MeshQualityReport"):
    proxy = simple.servermanager.CreateProxy("filters", name)
    assert proxy is not None, name
    assert proxy.GetVTKClassName() == "vtk" + name, name
