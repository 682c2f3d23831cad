"""Save Data by extension, and named blocks: SCRIPT PLUGIN FOLDER."""
import os
import sys

from paraview import simple
from paraview.servermanager import CreateProxy, Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
folder = os.path.join(sys.argv[2], "")

body = simple.XMLPolyDataReader(FileName=[os.environ["NOSECONE"]])
mesher = IsotropicTetMesher(Input=body, FarField=1, FarFieldMargins=[1, 1, 1, 1, 1, 1])
simple.UpdatePipeline(proxy=mesher)
mesh = Fetch(mesher)
names = mesh.GetFieldData().GetAbstractArray("PatchNames")
names = [names.GetValue(i) for i in range(1, names.GetNumberOfValues())]
tetrahedra = sum(mesh.GetCellType(c) == 10 for c in range(mesh.GetNumberOfCells()))

for file in ("mesh.su2", "mesh.b8.ugrid", "mesh.msh", "case.foam"):
    simple.SaveData(folder + file, proxy=mesher)
    assert os.path.exists(folder + file), file
simple.SaveData(folder + "text.msh", proxy=mesher, FileType="ASCII")
with open(folder + "text.msh", encoding="utf-8") as file:
    assert file.readline() == "$MeshFormat\n" and file.readline().startswith("2.2 0")
with open(folder + "mesh.mapbc", encoding="utf-8") as file:
    assert [line.split()[2] for line in file.readlines()[1:]] == names
with open(folder + "mesh.su2", encoding="utf-8") as file:
    assert [line.split()[1] for line in file if line.startswith("MARKER_TAG")] == names

# ParaView's own reader takes the case.
case = simple.OpenFOAMReader(FileName=folder + "case.foam")
case.MeshRegions = ["internalMesh"] + ["patch/" + name for name in names]
simple.UpdatePipeline(proxy=case)
read = Fetch(case)
assert read.GetBlock(0).GetNumberOfCells() == tetrahedra, (read.GetBlock(0).GetNumberOfCells(), tetrahedra)
assert read.GetNumberOfPoints() > mesh.GetNumberOfPoints()

# Beside ParaView's own writer of CGNS files, which leaves out boundary conditions.
writer = CreateProxy("writers", "RANSMeshingCGNSWriter")
writer.GetProperty("Input").SetInputConnection(0, mesher.SMProxy, 0)
writer.GetProperty("FileName").SetElement(0, folder + "mesh.cgns")
writer.UpdateVTKObjects()
writer.UpdatePipeline()
cgns = simple.CGNSSeriesReader(FileNames=[folder + "mesh.cgns"])
cgns.LoadPatches = 1
simple.UpdatePipeline(proxy=cgns)
back = NamedBlocksToMesh(Input=cgns)
simple.UpdatePipeline(proxy=back)
assert Fetch(back).GetNumberOfCells() == mesh.GetNumberOfCells()
assert Fetch(back).GetNumberOfPoints() == mesh.GetNumberOfPoints()

# The properties' defaults are the classes' own.
for name, properties in (("SU2MeshWriter", {}), ("UGRIDMeshWriter", {}), ("RANSMeshingCGNSWriter", {}),
                         ("GmshMeshWriter", {"FileType": 2}), ("OpenFOAMMeshWriter", {"FileType": 2})):
    proxy = CreateProxy("writers", name)
    lines = (line.strip().partition(":") for line in str(proxy.GetClientSideObject()).splitlines())
    own = {label: value for label, _, value in lines}
    for label, value in {**properties, "LeaveOutSheets": 0}.items():
        assert proxy.GetProperty(label).GetElement(0) == value == int(own[label]), (name, label)

blocks = MeshToNamedBlocks(Input=mesher)
simple.UpdatePipeline(proxy=blocks)
information = blocks.GetDataInformation().DataInformation.GetDataAssembly()
assert information.GetFirstNodeByPath("/Mesh/boundary/" + names[0]) >= 0
again = NamedBlocksToMesh(Input=blocks)
simple.UpdatePipeline(proxy=again)
assert Fetch(again).GetNumberOfCells() == mesh.GetNumberOfCells()
