"""Files that the command line program reads, and what it says of those that it cannot use."""
import gzip
import os
import re
import struct
import unittest

import surfaces
from command_line import LAYERS, NOSECONE, CommandLineTest

# The mesher's own list: the program reads the same arrays.
MESHERS_ARRAYS = os.path.join(os.path.dirname(__file__), "..", "..", "Filters", "Core", "PatchNumbering.cxx")


class Inputs(CommandLineTest):
    """What cannot be read or written: status 1, one line that names the file."""

    def test_files(self):
        out = ["-o", self.mesh, *LAYERS]
        self.fails(1, "missing.stl: cannot be opened", self.path("missing.stl"), *out)
        os.mkdir(self.path("folder.stl"))
        self.fails(1, "is a folder", self.path("folder.stl"), *out)
        self.fails(1, "is no STL file", self.file("words.stl", "just words\n" * 3), *out)
        self.fails(1, "is no STL file", self.file("empty.stl", ""), *out)
        self.fails(1, "line 2: a face names vertex 9 of 1", self.file("bad.obj", "v 0 0 0\nf 1 1 9\n"), *out)
        self.fails(1, "line 1: a vertex needs three numbers", self.file("bad2.obj", "v 0 zero 0\n"), *out)
        self.fails(1, "bad.vtp: has no triangles", self.file("bad.vtp", "<VTKFile type='PolyData'>"), *out)
        self.fails(1, "bad.ply: ", self.file("bad.ply", "ply\n"), *out)
        packed = gzip.compress(surfaces.stl_text(*surfaces.box()).encode())
        with open(self.path("cut.stl.gz"), "wb") as file:
            file.write(packed[:len(packed) // 2])
        self.fails(1, "is damaged", self.path("cut.stl.gz"), *out)

    def test_unwritable(self):
        self.fails(1, "cannot be written", NOSECONE, *LAYERS, "-o", self.path("no/such/folder/mesh.vtu"))
        self.fails(1, "cannot be written", NOSECONE, *LAYERS, "-o", self.mesh, "--report",
                   self.path("no/report.json"))


class BadInputs(CommandLineTest):
    """Surfaces and options that cannot give a mesh: status 1, why and where."""

    def test_open_surface_keeps_its_problems(self):
        points, triangles = surfaces.sphere()
        hole = self.file("hole.obj", surfaces.obj_text(points, {"ball": triangles[3:]}))
        problems = self.path("problems.vtp")
        self.fails(1, "not closed", hole, "-o", self.mesh, *LAYERS, "--far-field", "2", "--problems", problems)
        self.assertGreater(os.path.getsize(problems), 500)

    def test_report_of_a_failure(self):
        points, triangles = surfaces.sphere()
        hole = self.file("hole.obj", surfaces.obj_text(points, {"ball": triangles[3:]}))
        self.fails(1, "not closed", hole, "-o", self.mesh, *LAYERS, "--report", self.path("report.json"))
        report = self.read_report()
        self.assertEqual(report["status"], "failed")
        self.assertIn("not closed", report["error"])
        self.assertGreater(report["problem_triangles"], 0)

    def test_self_intersection(self):
        points, triangles = surfaces.sphere()
        moved = [(x + 0.7, y + 0.01, z + 0.02) for x, y, z in points]
        both = {"a": triangles, "b": [tuple(v + len(points) for v in t) for t in triangles]}
        self.fails(1, "intersect", self.file("two.obj", surfaces.obj_text(points + moved, both)), "-o", self.mesh,
                   *LAYERS, "--far-field", "2", "--problems", self.path("problems.vtp"))
        self.assertTrue(os.path.exists(self.path("problems.vtp")))

    def test_numbers_that_are_none(self):
        points, triangles = surfaces.sphere()
        for bad in (float("nan"), 1e100):
            points[5] = (bad, 0.0, 0.0)
            self.fails(1, "ransmesh:", self.file("bad.obj", surfaces.obj_text(points, {"a": triangles})), "-o",
                       self.mesh, *LAYERS, "--far-field", "2")

    def test_walls(self):
        out = ["-o", self.mesh, *LAYERS, "--far-field", "2"]
        self.fails(1, "no patch is taken", NOSECONE, *out, "--walls", "wing*")
        self.fails(1, "first height", NOSECONE, "-o", self.mesh, "--far-field", "2", "--first-height", "1e6")


class Readers(CommandLineTest):
    """Every format, packed or not; what becomes a patch, and its name."""

    def patches(self, *paths):
        return list(self.patches_of(*paths, "--isotropic-only"))

    def test_solids_and_groups(self):
        points, sides = surfaces.box()
        for name, text in (("box.stl", surfaces.stl_text), ("box.stl.gz", surfaces.stl_text),
                           ("box.obj", surfaces.obj_text), ("box.OBJ.gz", surfaces.obj_text)):
            with self.subTest(name):
                self.assertEqual(self.patches(self.file(name, text(points, sides))), list(surfaces.BOX_SIDES))

    def test_one_patch_is_named_by_its_file(self):
        points, triangles = surfaces.sphere()
        for name, content in (("ball.ply", surfaces.ply_text(points, triangles)),
                              ("ball.ply.gz", surfaces.ply_text(points, triangles)),
                              ("ball.stl", surfaces.stl_text(points, {"made by x": triangles})),
                              ("ball.obj", surfaces.obj_text(points, {"g": triangles}))):
            with self.subTest(name):
                self.assertEqual(self.patches(self.file(name, content)), ["ball"])

    def test_binary_stl(self):
        points, triangles = surfaces.sphere()
        content = b"solid it is not".ljust(80) + struct.pack("<I", len(triangles))
        for triangle in triangles:
            values = [0.0] * 3 + [x for v in triangle for x in points[v]]
            content += struct.pack("<12fH", *values, 0)
        self.assertEqual(self.patches(self.file("ball.stl", content)), ["ball"])
        os.remove(self.mesh)
        self.fails(1, "ends before the last", self.file("cut.stl", b"x" * 80 + struct.pack("<I", 9)), "-o",
                   self.mesh, "--isotropic-only")

    def test_vtp(self):
        self.assertEqual(self.patches(NOSECONE), ["body", "base"])
        with open(NOSECONE, "rb") as file:
            packed = self.file("nose.vtp.gz", file.read())
        self.assertEqual(self.patches(packed), ["body", "base"])

    def test_numbers_of_other_tools_in_vtp(self):
        points, triangles = surfaces.sphere()
        halves = [3 if sum(points[v][2] for v in triangle) > 0 else 8 for triangle in triangles]
        with open(MESHERS_ARRAYS, encoding="utf-8") as file:
            arrays = re.findall(r'"([^"]+)"', re.search(r"ForeignArrays\[\] = \{(.*?)\}", file.read(), re.DOTALL)[1])
        self.assertGreater(len(arrays), 5)
        for array in arrays:
            with self.subTest(array):
                path = self.file("ball.vtp", surfaces.vtp_text(points, triangles, array, halves))
                self.assertEqual(sorted(self.patches(path)), ["ball_3", "ball_8"])
        path = self.file("ball.vtp", surfaces.vtp_text(points, triangles, "GroupIds", [5] * len(triangles)))
        self.assertEqual(self.patches(path), ["ball"])

    def test_several_files(self):
        points, sides = surfaces.box()
        paths = [self.file(f"{name}.stl", surfaces.stl_text(points, {"any": triangles}))
                 for name, triangles in sides.items()]
        self.assertEqual(self.patches(*paths), list(surfaces.BOX_SIDES))
        halves = [dict(list(sides.items())[:3]), dict(list(sides.items())[3:])]
        halves[1] = dict(zip(halves[0], halves[1].values()))  # the same names again
        paths = [self.file(f"half{i}.obj", surfaces.obj_text(points, half)) for i, half in enumerate(halves)]
        self.assertEqual(self.patches(*paths), ["left", "right", "front", "half1_left", "half1_right", "half1_front"])


if __name__ == "__main__":
    unittest.main()
