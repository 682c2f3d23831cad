"""The plugin loads, and every proxy of its XML files can be made: python SCRIPT PLUGIN FOLDER."""
import glob
import os
import sys
import xml.etree.ElementTree as ElementTree

from paraview import simple

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
here = os.path.dirname(os.path.abspath(__file__))
made = set()
for file in glob.glob(os.path.join(here, "..", "..", "Wrapping", "ParaView", "Plugin", "*.xml")):
    for group in ElementTree.parse(file).iter("ProxyGroup"):
        for described in group:
            if group.get("name").startswith("internal_"):
                continue  # what others have in common
            name = described.get("name")
            proxy = simple.servermanager.CreateProxy(group.get("name"), name)
            assert proxy is not None, name
            assert proxy.GetVTKClassName() == described.get("class"), name
            made.add(name)
assert {"IsotropicTetMesher", "RANSPointRemoval", "DirectionalEnrichment", "MeshQualityReport"} <= made, made
