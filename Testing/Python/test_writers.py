"""Meshes for solvers: each format, read back by a reader that is not the project's."""
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import mesh_files
import writer_meshes
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from ransmeshing import vtkGmshMeshWriter, vtkOpenFOAMMeshWriter, vtkSolverMeshWriter

FILES = {"mesh.su2": mesh_files.read_su2, "mesh.ugrid": mesh_files.read_ugrid, "mesh.b8.ugrid": mesh_files.read_ugrid,
         "mesh.lb8.ugrid": mesh_files.read_ugrid, "mesh.cgns": mesh_files.read_cgns, "mesh.msh": mesh_files.read_gmsh,
         "case/constant/polyMesh": mesh_files.read_openfoam}
ASCII, BINARY = 1, 2

# Debian's OpenFOAM finds its settings by this.
os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")


class WriterTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, grid, name, leave_out_sheets=False, file_type=None):
        """Gives the path of what was written, or None, and the messages."""
        writer = vtkSolverMeshWriter.NewForFile(self.path(name))
        writer.SetInputData(grid)
        writer.SetLeaveOutSheets(leave_out_sheets)
        if file_type:
            writer.SetFileType(file_type)
        messages = []

        def keep(_caller, _event, text):
            messages.append(text)
        keep.CallDataType = "string0"
        writer.AddObserver("ErrorEvent", keep)
        writer.GetExecutive().AddObserver("ErrorEvent", keep)
        done = writer.Write()
        self.assertEqual(done, 0 if messages else 1)
        return (self.path(name) if done else None), " ".join(messages)

    def written(self, *arguments, **options):
        path, messages = self.write(*arguments, **options)
        self.assertEqual(messages, "")
        return path

    def refused(self, words, *arguments, **options):
        path, messages = self.write(*arguments, **options)
        self.assertIsNone(path)
        self.assertIn(words, messages)

    def make_case(self):
        os.makedirs(self.path("case/system"), exist_ok=True)
        for name, content in (("controlDict", "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;"
                               "writeControl timeStep; writeInterval 1;"),
                              ("fvSchemes", "gradSchemes{} divSchemes{} laplacianSchemes{} interpolationSchemes{}"
                               "snGradSchemes{} ddtSchemes{}"), ("fvSolution", "")):
            with open(self.path("case/system/" + name), "w", encoding="utf-8") as file:
                file.write("FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n%s\n" % (name, content))

    def check_mesh(self):
        """What OpenFOAM's own check says of case/constant/polyMesh."""
        self.make_case()
        done = subprocess.run(["checkMesh", "-allTopology", "-constant", "-case", self.path("case")], text=True,
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr)
        return done.stdout


class ReadBack(WriterTest):
    def compare(self, grid, formats=FILES):
        mesh = mesh_files.of_grid(grid)
        for name in formats:
            with self.subTest(name):
                read = FILES[name](self.written(grid, name))
                read.patches = {n.replace("_", " "): faces for n, faces in read.patches.items()}
                read.patches = {n: read.patches.get(n) or read.patches[n.replace("_", " ")] for n in mesh.patches}
                mesh.assert_same(read)
                read.assert_outward(-1 if name.endswith("ugrid") else 1)
                if "polyMesh" not in name:
                    read.assert_first_faces_turn_inward()

    def test_tetrahedra(self):
        self.compare(writer_meshes.ball())

    def test_prisms(self):
        self.compare(writer_meshes.ball(prisms=True))

    def test_prisms_and_hexahedra(self):
        grid = writer_meshes.room()
        self.assertEqual(set(mesh_files.of_grid(grid).cells), {4, 6, 8})
        self.compare(grid)

    def test_all_kinds_of_cells_and_patches_of_triangles_and_quadrilaterals(self):
        for turned in (False, True):
            self.compare(writer_meshes.all_kinds(turned))

    def test_text_is_as_exact_as_binary(self):
        grid = writer_meshes.ball(prisms=True)
        mesh = mesh_files.of_grid(grid)
        for name in ("mesh.msh", "case/constant/polyMesh"):
            read = FILES[name](self.written(grid, name, file_type=ASCII))
            read.patches = {n: read.patches[n] for n in mesh.patches}
            mesh.assert_same(read)

    def test_the_order_of_cells_and_the_kind_of_arrays_do_not_matter(self):
        for grid in (writer_meshes.all_kinds(), writer_meshes.ball(), writer_meshes.ball(prisms=True)):
            mesh, mixed = mesh_files.of_grid(grid), writer_meshes.shuffled(grid)
            for name in ("mesh.ugrid", "case/constant/polyMesh"):
                read = FILES[name](self.written(mixed, name))
                self.assertEqual([len(f) for f in read.patches.values()], [len(f) for f in mesh.patches.values()])
                read.patches = dict(zip(mesh.patches, read.patches.values()))
                mesh.assert_same(read)


class PatchTypes(WriterTest):
    def setUp(self):
        super().setUp()
        self.grid = writer_meshes.all_kinds()

    def test_su2(self):
        with open(self.written(self.grid, "mesh.su2"), encoding="utf-8") as file:
            content = file.read()
        self.assertIn("% body: wall\n", content)
        self.assertIn("% MARKER_HEATFLUX= ( body, 0.0 )\n", content)
        self.assertIn("MARKER_TAG= the_rest\n", content)

    def test_mapbc(self):
        self.written(self.grid, "mesh.b8.ugrid")
        self.assertEqual(mesh_files.read_mapbc(self.path("mesh.mapbc")),
                         [(1, 4000, "body"), (2, 7011, "roof"), (3, 0, "the_rest")])

    def test_gmsh(self):
        with open(self.written(self.grid, "mesh.msh", file_type=ASCII), encoding="utf-8") as file:
            content = file.read()
        self.assertIn('$PhysicalNames\n4\n2 1 "body"\n2 2 "roof"\n2 3 "the rest"\n3 1 "fluid"\n', content)
        self.assertIn("patch 2: inlet\n", content)

    def test_openfoam(self):
        with open(self.written(self.grid, "case/constant/polyMesh") + "/boundary", encoding="utf-8") as file:
            words = " ".join(file.read().split())
        self.assertIn("body { type wall; inGroups 1(wall); nFaces 2; startFace 3; }", words)
        self.assertIn("roof { type patch; inGroups 1(inlet); nFaces 4;", words)

    def test_names_that_formats_do_not_allow(self):
        names = self.grid.GetFieldData().GetAbstractArray("PatchNames")
        long = "a name, longer than thirty-two characters, "
        for i, name in enumerate(("3", 'wing "left"; {a}', long + "1"), 1):
            names.SetValue(i, name)
        names.SetValue(0, 'air "dry"')
        text = {}
        for file in ("mesh.su2", "case/constant/polyMesh", "mesh.msh", "mesh.cgns"):
            path = self.written(self.grid, file)
            with open(path + ("/boundary" if file.endswith("polyMesh") else ""), "rb") as content:
                text[file] = content.read().decode("latin-1")
        self.assertIn("MARKER_TAG= 3\nMARKER_ELEMS= 2\n", text["mesh.su2"])
        self.assertIn("MARKER_TAG= wing__left____a_\n", text["mesh.su2"])
        self.assertIn("    patch_3\n    {", text["case/constant/polyMesh"])
        self.assertIn('2 2 "wing _left_; {a}"\n', text["mesh.msh"])
        self.assertIn('3 1 "air _dry_"\n', text["mesh.msh"])
        self.assertEqual(list(mesh_files.read_cgns(self.path("mesh.cgns")).patches)[2], "a name_ longer than thirty-two c")
        names.SetValue(1, long + "2")
        self.written(self.grid, "mesh.cgns")
        self.assertEqual(sorted(mesh_files.read_cgns(self.path("mesh.cgns")).patches)[:2],
                         ["a name_ longer than thirty-two c", "a name_ longer than thirty-two_2"])
        if shutil.which("checkMesh"):
            self.check_mesh()

    def test_symmetry_is_a_plane_or_not(self):
        def kinds(faces):
            grid = writer_meshes.all_kinds()
            types = grid.GetFieldData().GetAbstractArray("PatchTypes")
            types.SetValue(faces, "symmetry")
            self.written(grid, "case/constant/polyMesh")
            with open(self.path("case/constant/polyMesh/boundary"), encoding="utf-8") as file:
                foam = file.read().split("type ")[faces].split(";")[0].strip()
            self.written(grid, "mesh.ugrid")
            return foam, mesh_files.read_mapbc(self.path("mesh.mapbc"))[faces - 1][1]
        self.assertEqual(kinds(2), ("symmetry", 3000))  # the pyramid's sides
        flat = writer_meshes.grid_of([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(10, range(4))],
                                     [("floor", "symmetry", [(0, 2, 1)]), ("west", "symmetry", [(0, 3, 2)]),
                                      ("slope", "symmetry", [(1, 2, 3)]), ("south", "farfield", [(0, 1, 3)])])
        self.written(flat, "mesh.ugrid")
        self.assertEqual([c for _, c, _ in mesh_files.read_mapbc(self.path("mesh.mapbc"))], [6663, 6661, 3000, 5000])
        with open(self.written(flat, "case/constant/polyMesh") + "/boundary", encoding="utf-8") as file:
            self.assertEqual(file.read().count("symmetryPlane;"), 3)

    @unittest.skipUnless(shutil.which("cgnscheck"), "cgnscheck (cgns-convert) is not there")
    def test_cgns(self):
        done = subprocess.run(["cgnscheck", "-v", self.written(self.grid, "mesh.cgns")], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("ERROR", done.stdout)
        self.assertIn("BCWallViscous", done.stdout)
        self.assertIn("BCInflow", done.stdout)


@unittest.skipUnless(shutil.which("checkMesh"), "OpenFOAM is not there")
class OpenFOAM(WriterTest):
    def test_check_mesh(self):
        for grid in (writer_meshes.ball(), writer_meshes.shuffled(writer_meshes.ball(prisms=True)), writer_meshes.room(),
                     writer_meshes.all_kinds()):
            for file_type in (BINARY, ASCII):
                self.written(grid, "case/constant/polyMesh", file_type=file_type)
                text = self.check_mesh()
                self.assertIn("Upper triangular ordering OK", text)
                for complaint in ("***", "Error", "negative", "wrongly oriented"):
                    self.assertNotIn(complaint, text)

    def test_a_case_by_its_marker(self):
        self.written(writer_meshes.all_kinds(), "case/mine.foam")
        self.assertEqual(os.path.getsize(self.path("case/mine.foam")), 0)
        self.assertIn("Number of regions: 1 (OK)", self.check_mesh())

    def test_a_wake_is_a_face_zone(self):
        grid = writer_meshes.wing_with_wake()
        faces = len(mesh_files.of_grid(grid).patches["wake"])
        self.written(grid, "case/constant/polyMesh")
        text = self.check_mesh()
        self.assertRegex(text, r"wake +%d " % faces)
        self.assertIn("Number of regions: 1 (OK)", text)
        self.assertNotIn("***", text)

    def test_a_wall_without_thickness_is_a_patch_of_both_sides(self):
        mesh = mesh_files.of_grid(writer_meshes.wing_with_wake())
        grid = vtkUnstructuredGrid()
        grid.DeepCopy(writer_meshes.wing_with_wake())
        number = list(mesh.patches).index("wake") + 1
        grid.GetFieldData().GetAbstractArray("PatchTypes").SetValue(number, "wall")
        self.written(grid, "case/constant/polyMesh")
        text = self.check_mesh()
        self.assertRegex(text, r"wake +%d " % (2 * len(mesh.patches["wake"])))
        self.assertNotIn("***", text)
        self.refused("without thickness", grid, "mesh.cgns")


class Benchmark(WriterTest):
    def test_the_program_that_measures_writers(self):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(writer_meshes.ball())
        writer.SetFileName(self.path("ball.vtu"))
        self.assertEqual(writer.Write(), 1)
        program = os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Testing/Benchmarks/writers.py")
        done = subprocess.run([sys.executable, "-B", program, self.folder, self.path("ball.vtu")], capture_output=True,
                              text=True, check=True)
        self.assertEqual(done.stdout.count("read back: the same"), len(FILES), done.stdout)
        self.assertNotIn("NOT", done.stdout)
        self.assertEqual(os.listdir(self.folder), ["ball.vtu"])


class Sheets(WriterTest):
    def test_where_they_can_be_held_and_where_not(self):
        grid = writer_meshes.wing_with_wake()
        mesh = mesh_files.of_grid(grid)
        read = mesh_files.read_gmsh(self.written(grid, "mesh.msh"))
        mesh.assert_same(read)
        self.written(grid, "mesh.cgns")
        del mesh.patches["wake"]
        mesh.assert_same(mesh_files.read_cgns(self.path("mesh.cgns")))  # whose patches are boundary conditions
        for name in ("mesh.su2", "mesh.b8.ugrid"):
            self.refused("cannot hold patches inside the mesh, and this mesh has: wake", grid, name)
            mesh.assert_same(FILES[name](self.written(grid, name, leave_out_sheets=True)))

    def test_with_prisms_on_both_sides(self):
        grid = writer_meshes.wing_with_wake_and_prisms()
        mesh = mesh_files.of_grid(grid)
        self.assertIn(6, mesh.cells)
        mesh.assert_same(mesh_files.read_gmsh(self.written(grid, "mesh.msh")))
        wake = mesh.patches.pop("wake")
        mesh.assert_same(mesh_files.read_cgns(self.written(grid, "mesh.cgns")))
        mesh.assert_same(mesh_files.read_openfoam(self.written(grid, "case/constant/polyMesh")))
        if shutil.which("checkMesh"):
            text = self.check_mesh()
            self.assertRegex(text, r"wake +%d " % len(wake))
            self.assertIn("Number of regions: 1 (OK)", text)


class Broken(WriterTest):
    def setUp(self):
        super().setUp()
        self.grid = writer_meshes.ball()

    def assert_nothing_left(self, before):
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_disk_full(self):
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        os.mkdir(self.path("case"))
        os.mkdir(self.path("case/constant"))
        for name in FILES:
            good = self.written(writer_meshes.all_kinds(), name)
            before = FILES[name](good)
            listing = sorted(os.listdir(os.path.dirname(good)))
            try:
                resource.setrlimit(resource.RLIMIT_FSIZE, (20000, limits[1]))
                self.refused(name.rsplit("/", 1)[-1] + ": could not be written", self.grid, name)
            finally:
                resource.setrlimit(resource.RLIMIT_FSIZE, limits)
            FILES[name](good).assert_same(before)
            self.assertEqual(sorted(os.listdir(os.path.dirname(good))), listing)

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_full_device(self):
        for name in ("mesh.su2", "mesh.msh", "mesh.b8.ugrid"):
            os.symlink("/dev/full", self.path(name))
            self.refused("No space left on device; make room", self.grid, name)
            self.assertTrue(os.path.exists("/dev/full"))

    def test_a_folder_in_the_way_and_a_missing_one(self):
        os.mkdir(self.path("full"))
        open(self.path("full/precious"), "w", encoding="utf-8").close()
        os.mkdir(self.path("full/polyMesh"))
        open(self.path("full/polyMesh/precious"), "w", encoding="utf-8").close()
        self.refused("holds other things than a mesh", self.grid, "full/polyMesh")
        open(self.path("polyMesh"), "w", encoding="utf-8").close()
        self.refused("is a file", self.grid, "polyMesh")
        before = sorted(os.listdir(self.folder))
        for name in ("mesh.su2", "mesh.ugrid", "mesh.cgns", "mesh.msh"):
            self.refused("make the folder first", self.grid, "none/" + name)
            os.mkdir(self.path(name))
            self.refused("is a folder", self.grid, name)
            os.rmdir(self.path(name))
        self.assert_nothing_left(before)

    def test_no_permission(self):
        os.mkdir(self.path("shut"), 0o500)
        os.chmod(self.folder, 0o755)
        user = os.geteuid()
        if user == 0:  # who may write anywhere
            os.seteuid(65534)
        try:
            for name in ("mesh.su2", "mesh.ugrid", "mesh.cgns", "mesh.msh", "polyMesh"):
                self.refused("that you may write to", self.grid, "shut/" + name)
        finally:
            os.seteuid(user)
        self.assertEqual(os.listdir(self.path("shut")), [])

    def test_meshes_that_are_none(self):
        empty = writer_meshes.grid_of([], [], [])
        self.refused("empty", empty, "mesh.su2")
        surface = writer_meshes.grid_of([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [("a", "wall", [(0, 1, 2)])])
        self.refused("no volume cells", surface, "mesh.su2")
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        bare = writer_meshes.grid_of(corners, [(10, range(4))], [])
        self.refused("no boundary faces", bare, "mesh.su2")
        line = writer_meshes.grid_of(corners, [(10, range(4)), (3, (0, 1))], [("a", "wall", [(0, 1, 2)])])
        self.refused("is of VTK type 3", line, "mesh.su2")
        outside = writer_meshes.grid_of(corners, [(10, (0, 1, 2, 7))], [("a", "wall", [(0, 1, 2)])])
        self.refused("a point number that there is no point for", outside, "mesh.su2")
        open_mesh = writer_meshes.grid_of(corners, [(10, range(4))], [("a", "wall", [(0, 2, 1)])])
        self.refused("not conforming", open_mesh, "polyMesh")
        stray = writer_meshes.grid_of(corners + [(2, 2, 2)], [(10, range(4))], [
            ("a", "wall", [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 4)])])
        self.refused("not conforming: 1 boundary faces are no cell's face", stray, "polyMesh")

    def test_names_of_files(self):
        self.assertIsNone(vtkSolverMeshWriter.NewForFile("mesh.stl"))
        self.assertIsNone(vtkSolverMeshWriter.NewForFile(None))
        self.assertIsInstance(vtkSolverMeshWriter.NewForFile("polyMesh"), vtkOpenFOAMMeshWriter)
        writer = vtkGmshMeshWriter()
        writer.SetInputData(self.grid)
        vtkObject.GlobalWarningDisplayOff()
        self.assertEqual(writer.Write(), 0)  # no name
        vtkObject.GlobalWarningDisplayOn()


if __name__ == "__main__":
    unittest.main()
