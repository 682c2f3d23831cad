"""The chain on an OBJ file with groups, without a far field: SCRIPT PLUGIN FOLDER."""
import math
import os
import sys

from paraview import simple
from paraview.servermanager import Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())


def write_pipe(path, around=24, along=30, rings=4, length=4.0):
    """A pipe along x of radius 1, groups wall, inlet and outlet."""
    points, groups = [], {"wall": [], "inlet": [], "outlet": []}

    def ring(x, radius, shift=0.0):
        first = len(points) + 1
        for i in range(around):
            angle = 2 * math.pi * (i + shift) / around
            points.append((x, radius * math.cos(angle), radius * math.sin(angle)))
        return first

    def strip(low, high, group):
        for i in range(around):
            j = (i + 1) % around
            groups[group] += [(low + i, low + j, high + i), (low + j, high + j, high + i)]

    def cap(edge, x, group):
        last = edge
        for k in range(rings - 1, 0, -1):
            inner = ring(x, k / rings)
            strip(last, inner, group)
            last = inner
        points.append((x, 0.0, 0.0))
        groups[group].extend((last + i, last + (i + 1) % around, len(points)) for i in range(around))

    rows = [ring(length * i / along, 1.0) for i in range(along + 1)]
    for low, high in zip(rows, rows[1:]):
        strip(low, high, "wall")
    cap(rows[0], 0.0, "inlet")
    cap(rows[-1], length, "outlet")
    with open(path, "w", encoding="ascii") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points)
        for group, triangles in groups.items():
            file.write(f"g {group}\n")
            file.writelines(f"f {a} {b} {c}\n" for a, b, c in triangles)


path = os.path.join(sys.argv[2], "pipe.obj")
write_pipe(path)
surface = simple.OpenDataFile(path)
mesher = IsotropicTetMesher(Input=surface)
simple.UpdatePipeline(proxy=mesher)
mesh = Fetch(mesher)
assert mesh.GetNumberOfCells() > 1000, mesh.GetNumberOfCells()
names = mesh.GetFieldData().GetAbstractArray("PatchNames")
names = [names.GetValue(i) for i in range(names.GetNumberOfValues())]
assert len(names) == 4, f"each group is a patch: {names}"

# ParaView's reader keeps the groups but not their names: the ends are unticked by number.
removal = RANSPointRemoval(Input=mesher, FirstHeight=1e-3, NumberOfLayers=8)
removal.WallPatches = [names[1]]
enrichment = DirectionalEnrichment(Input=removal)
simple.UpdatePipeline(proxy=enrichment)
boundary = Fetch(enrichment, idx=1)
assert boundary.GetPointData().GetArray("LayersAchieved").GetRange()[1] == 8
report = MeshQualityReport(Input=enrichment)
simple.UpdatePipeline(proxy=report)
report.UpdatePipelineInformation()
assert report.SMProxy.GetProperty("Valid").GetElement(0) == 1
