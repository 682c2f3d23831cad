"""The proxies' defaults are the filters' own, every property is documented: SCRIPT PLUGIN FOLDER.

The C++ defaults are read from what a new object behind each proxy prints of itself.
"""
import sys
import xml.etree.ElementTree as ElementTree
import os

from paraview import simple

# Found from the input's bounds; in C++ there is no default.
FROM_BOUNDS = {("RANSPointRemoval", "FirstHeight")}
FILTERS = ("IsotropicTetMesher", "RANSPointRemoval", "DirectionalEnrichment", "PrismRecombination",
           "MeshQualityReport", "SurfaceCheck", "SurfaceRepair", "SurfaceRemesher", "SurfaceWrap", "MeshAdoption")


def plugin_xml():
    """The properties of each proxy by name, as the XML files say, with those of the base proxy."""
    folder = os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Wrapping/ParaView/Plugin")
    proxies = {}
    for file in ("RANSMeshingSurface.xml", "RANSMeshing.xml", "RANSMeshingLayers.xml", "RANSMeshingInput.xml"):
        for proxy in ElementTree.parse(os.path.join(folder, file)).iter("SourceProxy"):
            proxies[proxy.get("name")] = proxy
    for name in FILTERS:
        proxy = proxies[name]
        properties = {}
        for source in (proxies.get(proxy.get("base_proxyname")), proxy):
            if source is not None:
                properties.update({p.get("name"): p for p in source if p.tag.endswith("VectorProperty")})
        yield name, properties


def numbers(values):
    return [float(v) for v in values]


def cpp_defaults(name):
    """What a filter of this class prints of itself, by parameter."""
    proxy = simple.servermanager.CreateProxy("filters", name)
    lines = (line.strip().partition(":") for line in str(proxy.GetClientSideObject()).splitlines())
    return {parameter: value.strip().strip("()").replace(",", " ") for parameter, _, value in lines}


def compare(name, properties):
    defaults = cpp_defaults(name)
    compared = 0
    for label, xml in properties.items():
        # What fills a list of ticks is not shown itself.
        assert xml.find("Documentation") is not None or label == "WallPatchInfo", f"{name}.{label} is not documented"
        if xml.get("information_only"):
            continue
        command = xml.get("command")
        if not command.startswith("Set") or xml.get("repeat_command") or (name, label) in FROM_BOUNDS:
            continue
        own, stated = defaults[command[3:]], xml.get("default_values")
        if xml.tag == "StringVectorProperty":
            assert own == stated, (name, label, own, stated)
        else:
            assert numbers(own.split()) == numbers(stated.split()), (name, label, own, stated)
        compared += 1
    return compared


simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
for name, properties in plugin_xml():
    assert compare(name, properties) >= 1, name
