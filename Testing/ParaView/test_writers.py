"""Save Data in each format, of tetrahedra and of prisms, read back; and named blocks: SCRIPT PLUGIN FOLDER."""
import os
import sys

from paraview import simple
from paraview.servermanager import CreateProxy, Fetch

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())
sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Testing", "Python"))
import mesh_files  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid  # noqa: E402

folder = os.path.join(sys.argv[2], "")
FILES = {"mesh.su2": mesh_files.read_su2, "mesh.ugrid": mesh_files.read_ugrid, "mesh.b8.ugrid": mesh_files.read_ugrid,
         "mesh.lb8.ugrid": mesh_files.read_ugrid}


def fetched(proxy):
    """What the proxy's algorithm made, as a copy that stays."""
    simple.UpdatePipeline(proxy=proxy)
    grid = vtkUnstructuredGrid()
    grid.ShallowCopy(Fetch(proxy))
    return grid


def save_cgns(name, source):
    """Beside ParaView's own writer of CGNS files, which leaves out boundary conditions and is the one of SaveData."""
    writer = CreateProxy("writers", "RANSMeshingCGNSWriter")
    writer.GetProperty("Input").SetInputConnection(0, source.SMProxy, 0)
    writer.GetProperty("FileName").SetElement(0, name)
    writer.UpdateVTKObjects()
    writer.UpdatePipeline()


def check_formats(source):
    grid = fetched(source)
    mesh = mesh_files.of_grid(grid)
    for file, read in FILES.items():
        simple.SaveData(folder + file, proxy=source)
        mesh.assert_same(read(folder + file))

    for file, options in (("mesh.msh", {}), ("text.msh", {"FileType": "ASCII"})):
        simple.SaveData(folder + file, proxy=source, **options)
        with open(folder + file, "rb") as content:
            assert content.readline() == b"$MeshFormat\n"
            assert content.readline().startswith(b"2.2 0" if options else b"2.2 1")
        mesh.assert_same(mesh_files.read_gmsh(folder + file))

    # ParaView's own reader takes the case.
    simple.SaveData(folder + "case.foam", proxy=source)
    case = simple.OpenFOAMReader(FileName=folder + "case.foam")
    case.MeshRegions = ["internalMesh"] + ["patch/" + name for name in mesh.patches]
    simple.UpdatePipeline(proxy=case)
    blocks = mesh_files.named_blocks(Fetch(case))
    cells = mesh_files.volume_of(blocks.pop("internalMesh"))
    assert {size: len(rows) for size, rows in cells.items()} == {size: len(rows) for size, rows in mesh.cells.items()}
    assert ({name.split("/")[-1]: block.GetNumberOfCells() for name, block in blocks.items()} ==
            {name: len(faces) for name, faces in mesh.patches.items()})

    save_cgns(folder + "mesh.cgns", source)
    cgns = simple.CGNSSeriesReader(FileNames=[folder + "mesh.cgns"])
    cgns.LoadPatches = 1
    mesh.assert_same(mesh_files.of_grid(fetched(NamedBlocksToMesh(Input=cgns))))


def check_named_blocks(source):
    grid = fetched(source)
    blocks = MeshToNamedBlocks(Input=source)
    simple.UpdatePipeline(proxy=blocks)
    assembly = blocks.GetDataInformation().DataInformation.GetDataAssembly()
    mesh = mesh_files.of_grid(grid)
    for name in mesh.patches:
        assert assembly.GetFirstNodeByPath("/Mesh/boundary/" + name) >= 0, name
    mesh.assert_same(mesh_files.of_grid(fetched(NamedBlocksToMesh(Input=blocks))))


def check_defaults():
    """The properties' defaults are the classes' own."""
    for name, properties in (("SU2MeshWriter", {}), ("UGRIDMeshWriter", {}), ("RANSMeshingCGNSWriter", {}),
                             ("GmshMeshWriter", {"FileType": 2}), ("OpenFOAMMeshWriter", {"FileType": 2})):
        proxy = CreateProxy("writers", name)
        lines = (line.strip().partition(":") for line in str(proxy.GetClientSideObject()).splitlines())
        own = {label: value for label, _, value in lines}
        for label, value in {**properties, "LeaveOutSheets": 0}.items():
            assert proxy.GetProperty(label).GetElement(0) == value == int(own[label]), (name, label)


body = simple.XMLPolyDataReader(FileName=[os.environ["NOSECONE"]])
mesher = IsotropicTetMesher(Input=body, FarField=1, FarFieldMargins=[1, 1, 1, 1, 1, 1])
removal = RANSPointRemoval(Input=mesher, FirstHeight=1e-3, NumberOfLayers=5)
prisms = PrismRecombination(Input=DirectionalEnrichment(Input=removal))
assert set(mesh_files.of_grid(fetched(prisms)).cells) >= {4, 6}
for made in (mesher, prisms):
    check_formats(made)
    check_named_blocks(made)
check_defaults()
