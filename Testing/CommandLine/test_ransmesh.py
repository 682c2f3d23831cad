"""The command line program: exit statuses, options and what it writes."""
import os
import re
import signal
import subprocess
import time
import unittest

import surfaces
from command_line import LAYERS, NOSECONE, RANSMESH, CommandLineTest

PAGE = os.path.join(os.path.dirname(__file__), "..", "..", "Examples", "Cxx", "ransmesh", "README.md")


class Usage(CommandLineTest):
    def wrong(self, message, *arguments):
        self.fails(2, message, *arguments)

    def test_wrong_usage_is_status_2(self):
        out = ["-o", self.mesh]
        self.wrong("no surface file", *out)
        self.wrong("no mesh file", NOSECONE, *LAYERS)
        self.wrong("--first-height is missing", NOSECONE, *out)
        self.wrong("no option --frist-height", NOSECONE, *out, "--frist-height", "1")
        self.wrong("-o needs a value", NOSECONE, "-o")
        self.wrong("-o writes .vtu, .su2, .cgns", NOSECONE, "-o", self.path("mesh.stl"), *LAYERS)
        self.wrong(".vtp files only", NOSECONE, *out, *LAYERS, "--problems", "p.stl")
        self.wrong("surfaces are read from", "body.step", *out, *LAYERS)
        self.wrong("surfaces are read from", NOSECONE, "--wake", "wake.step", *out, *LAYERS)
        self.wrong("--wake needs a value", NOSECONE, *out, *LAYERS, "--wake")
        self.wrong("needs a number", NOSECONE, *out, "--first-height", "thin")
        self.wrong("needs a number", NOSECONE, *out, "--first-height", "nan")
        self.wrong("must be above 0", NOSECONE, *out, "--first-height", "-1")
        self.wrong("must be above 0", NOSECONE, *out, *LAYERS, "--far-field", "0")
        self.wrong("must be at least 1", NOSECONE, *out, *LAYERS, "--growth", "0.9")
        self.wrong("whole number", NOSECONE, *out, "--first-height", "1", "--layers", "2.5")
        self.wrong("whole number", NOSECONE, *out, *LAYERS, "--threads", "0")
        self.wrong("give one of them", NOSECONE, *out, *LAYERS, "--thickness", "0.1")
        self.wrong("makes no layers", NOSECONE, *out, *LAYERS, "--isotropic-only")
        self.wrong("needs an axis and a place", NOSECONE, *out, *LAYERS, "--waterline", "w=1")
        self.wrong("needs a number", NOSECONE, *out, *LAYERS, "--ground", "z=low")
        self.wrong("give one of them", NOSECONE, *out, *LAYERS, "--far-field", "5", "--far-field-sphere", "5")
        self.wrong("--side needs SIDE=NAME", NOSECONE, *out, *LAYERS, "--far-field", "5", "--side", "left=a")
        self.wrong("give that, too", NOSECONE, *out, *LAYERS, "--side", "xmin=inlet")
        self.wrong("give that, too", NOSECONE, *out, *LAYERS, "--far-field-sphere", "5", "--margin", "xmin=3")
        self.wrong("--margin needs SIDE=M", NOSECONE, *out, *LAYERS, "--far-field", "5", "--margin", "left=3")
        self.wrong("--margin needs SIDE=M", NOSECONE, *out, *LAYERS, "--far-field", "5", "--margin", "xmin=0")
        self.wrong("--patch-type needs PATCH=TYPE", NOSECONE, *out, *LAYERS, "--patch-type", "body")
        self.wrong("between 0 and 180", NOSECONE, *out, *LAYERS, "--feature-angle", "181")
        self.wrong("between 1.1 and 10", NOSECONE, *out, *LAYERS, "--radius-edge-ratio", "1")
        self.wrong("between 0 and 18,", NOSECONE, *out, *LAYERS, "--dihedral-angle", "20")

    def test_wrong_layers_are_status_2(self):
        start = [NOSECONE, "-o", self.mesh, *LAYERS]
        self.wrong("above 0 and at most 0.5", *start, "--gap-fraction", "0.6")
        self.wrong("above 0 and at most 180", *start, "--normal-angle", "0")
        self.wrong("between 5 and 180", *start, "--fan-angle", "4")
        self.wrong("between 0 and 90", *start, "--surface-angle", "-1")
        self.wrong("must be above 0", *start, "--isotropic-fraction", "0")
        self.wrong("whole number", *start, "--constant-layers", "1.5")
        self.wrong("belongs to --prisms", *start, "--non-orthogonality", "80")
        self.wrong("PATCH=H:G:N", *start, "--patch-layers", "body")
        self.wrong("PATCH=H:G:N", *start, "--patch-layers", "body=1e-3:1.2:3:4")
        self.wrong("must be at least 1", *start, "--patch-layers", "body=1e-3:0.5")
        self.wrong("whole number", *start, "--patch-layers", "body=1e-3:1.2:x")
        self.wrong("give the number of layers", NOSECONE, "-o", self.mesh, "--thickness", "0.1", "--patch-layers",
                   "body=1e-3:1.2")
        self.wrong("makes no layers", NOSECONE, "-o", self.mesh, "--isotropic-only", "--patch-layers", "body=1e-3")
        self.wrong("makes no layers", NOSECONE, "-o", self.mesh, "--isotropic-only", "--fan-angle", "20")

    def test_help_and_version(self):
        for option in ("--help", "-h"):
            done = self.run_it(option)
            self.assertEqual(done.returncode, 0)
            self.assertIn("--first-height", done.stdout)
        self.assertRegex(self.run_it("--version").stdout, r"^ransmesh \d+\.\d+")

    def test_the_page_has_all_options(self):
        with open(PAGE, encoding="utf-8") as file:
            options = set(re.findall(r"(?<![-\w])--[a-z][a-z-]*", file.read()))
        told = set(re.findall(r"(?<![-\w])--[a-z][a-z-]*", self.run_it("--help").stdout))
        self.assertGreater(len(told), 50)
        self.assertEqual(options, told)


class Options(CommandLineTest):
    def test_far_field_and_layers(self):
        report = self.report_of(NOSECONE, *LAYERS, "--far-field", "2")
        self.assertEqual(report["status"], "done")
        self.assertTrue(report["quality"]["Valid"])
        self.assertEqual(len(report["patches"]), 8)

    def test_prisms(self):
        prisms = self.report_of(NOSECONE, "--far-field", "2", *LAYERS, "--prisms")["quality"]["Prisms"]
        self.assertGreater(prisms["Wedges"], 1000)
        self.assertGreater(prisms["ShareOfLayers"], 0.95)
        self.assertEqual(prisms["Faults"], "")

    def test_faces_of_prisms_on_the_boundary(self):
        layers = ["--walls", "bottom", *LAYERS]
        triangles = {patch["name"]: patch for patch in self.report_of(self.box_obj(), *layers)["patches"]}
        self.assertEqual([patch["quadrilaterals"] for patch in triangles.values()], [0] * 6)
        prisms = {patch["name"]: patch for patch in self.report_of(self.box_obj(), *layers, "--prisms")["patches"]}
        self.assertEqual(prisms["bottom"], triangles["bottom"])
        left, before = prisms["left"], triangles["left"]
        self.assertGreater(left["quadrilaterals"], 10)
        self.assertEqual(2 * left["quadrilaterals"] + left["triangles"], before["triangles"])

    def test_isotropic_only(self):
        report = self.report_of(NOSECONE, "--isotropic-only", "--far-field", "2")
        self.assertNotIn("enrichment", report["seconds"])

    def cells(self, *arguments):
        return int(self.succeeds(NOSECONE, "--far-field", "2", *arguments).stdout.split()[-2])

    def test_sizes_and_layers_count(self):
        few = self.cells(*LAYERS)
        self.assertGreater(self.cells(*LAYERS, "--size", "0.3"), few)
        self.assertGreater(self.cells("--first-height", "1e-3", "--layers", "12"), few)
        self.assertGreater(self.cells("--first-height", "1e-3", "--thickness", "0.03", "--growth", "1.05"), few)
        self.assertLess(self.cells(*LAYERS, "--walls", "body"), few)
        self.assertEqual(self.cells(*LAYERS, "--walls", "bo*", "base"), few)
        self.assertEqual(self.cells(*LAYERS, "--walls", "bo*", "--walls", "base"), few)

    def asked(self, *arguments):
        """First height, growth and number of the layers of each wall."""
        report = self.report_of(NOSECONE, "--far-field", "2", *arguments)
        self.assertTrue(report["quality"]["Valid"])
        return {wall["Name"]: (wall["FirstHeightAsked"], wall["GrowthAsked"], wall["LayersAsked"])
                for patch, wall in report["quality"]["Walls"].items() if patch != "whole"}

    def test_layers_of_patches(self):
        asked = self.asked("--patch-layers", "bo*=1e-3:1.1:6", "--patch-layers", "base=2e-3", "--growth", "1.3",
                           "--layers", "3")
        self.assertEqual(asked, {"body": (1e-3, 1.1, 6), "base": (2e-3, 1.3, 3)})
        self.assertEqual(self.asked("--patch-layers", "body=1e-3:1.2:6"), {"body": (1e-3, 1.2, 6)})
        asked = self.asked(*LAYERS, "--walls", "base", "--patch-layers", "body=1e-3:1.1:5")
        self.assertEqual(asked, {"body": (1e-3, 1.1, 5), "base": (1e-3, 1.2, 6)})

    def test_where_layers_stand_and_end(self):
        for option, less, more, with_it in (
                ("--isotropic-fraction", "0.02", "0.7", []), ("--normal-angle", "170", "20", []),
                ("--fan-angle", "60", "10", ["--normal-angle", "20"]),
                # Room for the base's layers is made along the round body beside it.
                ("--surface-angle", "60", "0", ["--walls", "base", "--layers", "30"])):
            with self.subTest(option):
                few, many = [self.cells(*LAYERS, *with_it, option, value) for value in (less, more)]
                self.assertLess(few, many)
        growing = self.cells("--first-height", "1e-3", "--thickness", "0.05")
        self.assertGreater(self.cells("--first-height", "1e-3", "--thickness", "0.05", "--constant-layers", "20"), growing)
        inside = [self.box_obj(), "--walls", "bottom", "--first-height", "0.01", "--layers", "30", "--growth", "1.05"]
        low, high = [self.report_of(*inside, "--isotropic-fraction", "5", "--gap-fraction", part)["quality"]
                     for part in ("0.1", "0.5")]
        self.assertLess(low["Tetrahedra"], high["Tetrahedra"])
        prisms = [self.succeeds(NOSECONE, *LAYERS, "--prisms", "--non-orthogonality", angle).stdout
                  for angle in ("20", "90")]
        self.assertNotEqual(*prisms)

    def test_types_of_patches(self):
        patches = self.patches_of(NOSECONE, "--far-field", "2", *LAYERS, "--patch-type", "base=symmetry", "body=wall")
        self.assertEqual([patches["base"], patches["body"]], ["symmetry", "wall"])
        box = self.box_obj()
        self.assertEqual(self.patches_of(box, *LAYERS, "--patch-type", "*=patch", "bottom=wall")["bottom"], "wall")
        os.rename(self.mesh, self.path("there.vtu"))
        patches = self.patches_of(self.path("there.vtu"), *LAYERS, "--patch-type", "top=wall")
        self.assertEqual([patches["top"], patches["bottom"]], ["wall", "wall"])

    def test_edges_by_angle(self):
        points, sides = surfaces.box()
        box = self.file("box.stl", surfaces.stl_text(points, {"any": [t for side in sides.values() for t in side]}))
        sharp, round_ = [self.report_of(box, "--isotropic-only", "--surface-size", "0.2", "--feature-angle", angle)
                         for angle in ("80", "100")]
        self.assertNotEqual(sharp["quality"]["Points"], round_["quality"]["Points"])

    def test_margins_of_sides(self):
        even = self.cells("--isotropic-only")
        self.assertGreater(self.cells("--isotropic-only", "--margin", "xmax=8", "zmin=4"), even)

    def test_quality_of_tetrahedra(self):
        self.assertGreater(self.cells("--isotropic-only"),
                           self.cells("--isotropic-only", "--radius-edge-ratio", "2", "--dihedral-angle", "0"))

    def test_messages_name_options(self):
        out = ["-o", self.mesh, "--far-field", "2"]
        self.fails(1, "set GrowthRate (--growth)", NOSECONE, *out, "--first-height", "1e-3", "--growth", "11")
        self.fails(1, "give FirstHeight (--first-height) in", NOSECONE, *out, "--first-height", "1e-17")
        self.fails(1, "(SetPatchType, --patch-type)", NOSECONE, *out, *LAYERS, "--patch-type", "keel=wall")
        self.fails(1, "AddWallPatch (--walls), or", NOSECONE, *out, *LAYERS, "--patch-type", "*=symmetry")

    def test_wakes(self):
        points, triangles = surfaces.sheet((0.3, 0.3, 0.5), (0.4, 0, 0), (0, 0.4, 0), 4)
        wake = self.file("trail.stl", surfaces.stl_text(points, {"trail": triangles}))
        report = self.report_of(self.box_obj(), "--wake", wake, "--size", "0.2", "--walls", "trail",
                                "--first-height", "1e-3", "--layers", "5")
        self.assertTrue(report["quality"]["Valid"])
        patch = {p["name"]: p for p in report["patches"]}["trail"]
        self.assertEqual(patch["type"], "wake")
        points, triangles = surfaces.sheet((0.3, 0.3, 0.5), (0.9, 0, 0), (0, 0.4, 0), 4)
        wake = self.file("through.stl", surfaces.stl_text(points, {"through": triangles}))
        os.remove(self.mesh)
        self.fails(1, "the sheet 'through' cuts or touches", self.box_obj(), "--wake", wake, *LAYERS, "-o", self.mesh)

    def test_planes_and_sides(self):
        points, triangles = surfaces.sphere()
        ball = self.file("ball.obj", surfaces.obj_text(points, {"ball": triangles}))
        patches = self.patches_of(ball, "--far-field", "3", "--symmetry-plane", "y", "--waterline", "z=0.5",
                                  "--side", "xmin=inlet", "xmax=back:outlet", "--isotropic-only")
        self.assertEqual(patches["symmetry"], "symmetry")
        self.assertEqual(patches["waterline"], "symmetry")
        self.assertEqual(patches["inlet"], "inlet")
        self.assertEqual(patches["back"], "outlet")
        self.assertNotIn("farfield_ymin", patches)
        self.assertNotIn("farfield_zmax", patches)
        patches = self.patches_of(ball, "--far-field-sphere", "3", "--ground", "z=-0.9", *LAYERS)
        self.assertEqual(patches["farfield"], "farfield")
        self.assertEqual(patches["ground"], "wall")

    def test_meshes_that_are_there_already(self):
        points, triangles = surfaces.sphere()
        ball = self.file("ball.obj", surfaces.obj_text(points, {"ball": triangles}))
        patches = self.patches_of(ball, "--far-field", "3", "--isotropic-only")
        for name in ("there.vtu", "there.msh"):
            there = self.path(name)
            self.assertEqual(self.run_it(ball, "--far-field", "3", "--isotropic-only", "-o", there).returncode, 0)
            self.assertEqual(self.patches_of(there, *LAYERS), patches)
        for wrong in (["--far-field", "3"], ["--surface-size", "1"]):
            done = self.run_it(there, "-o", self.mesh, *LAYERS, *wrong)
            self.assertEqual(done.returncode, 2)
            self.assertIn("is a mesh already", done.stderr)
        done = self.run_it(self.file("bad.msh", "words"), "-o", self.mesh, *LAYERS)
        self.assertEqual(done.returncode, 1)
        self.assertIn("bad.msh is no mesh of gmsh", done.stderr)

    def test_surfaces_are_remeshed(self):
        kept = self.cells("--isotropic-only")
        self.assertGreater(self.cells("--isotropic-only", "--surface-size", "0.03"), 2 * kept)
        self.assertGreater(self.cells("--isotropic-only", "--surface-size", "*=0.03"), 2 * kept)
        self.assertGreater(self.cells("--isotropic-only", "--edges-per-circle", "60", "--surface-size", "0.2"), kept)
        os.remove(self.mesh)
        for wrong in ("0", "=1", "keel=-1"):
            self.fails(2, "--surface-size must be above 0", *LAYERS, "--surface-size", wrong, "-o", self.mesh)

    def test_sizes_are_refined(self):
        kept = self.cells("--isotropic-only")
        for place in (["--refine-box", "0", "0.3", "0", "0.3", "0", "0.3", "0.02"],
                      ["--refine-sphere", "0", "0", "0", "0.3", "0.02"],
                      ["--refine-line", "-0.2", "0", "0", "0.2", "0", "0", "0.1", "0.02"]):
            self.assertGreater(self.cells("--isotropic-only", *place), 2 * kept, place)

    def test_diagonals_are_swapped(self):
        # A box with a cap in one side: a point near the middle of that side's diagonal.
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (0.5, 0.49, 1)]
        corners = [(0, 2, 1), (0, 3, 2), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4),
                   (3, 4, 7), (4, 5, 8), (5, 6, 8), (4, 8, 6), (4, 6, 7)]
        box = self.file("cap.stl", surfaces.stl_text(points, {"box": corners}))
        self.assertIn("1 diagonal of surface triangles swapped", self.succeeds(box, "--isotropic-only").stderr)
        self.assertNotIn("swapped", self.succeeds(box, "--isotropic-only", "--swap-angle", "0").stderr)
        os.remove(self.mesh)
        self.fails(2, "--swap-angle must lie between 0 and 90", box, *LAYERS, "--swap-angle", "91", "-o", self.mesh)

    def test_quiet_and_threads(self):
        done = self.succeeds(NOSECONE, *LAYERS, "--far-field", "2", "--quiet", "--threads", "2")
        self.assertEqual(done.stdout + done.stderr, "")
        done = self.succeeds(NOSECONE, *LAYERS, "--far-field", "2", "--threads", "2")
        self.assertIn("no effect yet", done.stderr)

    def test_no_progress_off_a_terminal(self):
        self.assertNotIn("\r", self.succeeds(NOSECONE, *LAYERS, "--far-field", "2").stderr)

    def test_same_bits_twice(self):
        meshes = []
        for _ in range(2):
            self.succeeds(NOSECONE, *LAYERS, "--far-field", "2")
            with open(self.mesh, "rb") as file:
                meshes.append(file.read())
        self.assertEqual(*meshes)

    def test_failure_keeps_an_older_mesh(self):
        self.file("mesh.vtu", "older")
        done = self.run_it(NOSECONE, *LAYERS, "-o", self.mesh, "--walls", "wing")
        self.assertEqual(done.returncode, 1)
        with open(self.mesh, encoding="ascii") as file:
            self.assertEqual(file.read(), "older")


class Flow(CommandLineTest):
    AIR = ["--velocity", "50", "--length", "1", "--fluid", "air"]

    def test_the_first_height_follows(self):
        done = self.succeeds(NOSECONE, "--far-field", "2", *self.AIR, "--y-plus", "30", "--layers", "5", "--report",
                             self.path("report.json"))
        self.assertIn("Flow: Re 3.423e+06, Cf 0.003045 (schlichting), u_tau 1.951 m/s, first height 0.0002246",
                      done.stdout)
        flow = self.read_report()["flow"]
        self.assertAlmostEqual(flow["first_height"] / (30 * 7.4869996e-6), 1, 6)
        self.assertAlmostEqual(flow["boundary_layer_thickness"], 0.01825248, 7)
        self.assertEqual(flow["layers"], 5)
        self.assertTrue(self.read_report()["quality"]["Valid"])

    def test_layers_as_thick_as_the_boundary_layer(self):
        flow = self.report_of(NOSECONE, "--far-field", "2", "--reynolds", "1e6", "--length", "1", "--y-plus", "50",
                              "--thickness-from-flow", "--friction-law", "power-law")["flow"]
        self.assertAlmostEqual(flow["boundary_layer_thickness"], 0.37 * 1e6**-0.2, 6)
        self.assertLess(abs(flow["total_thickness"] / flow["boundary_layer_thickness"] - 1), 0.1)

    def test_wrong_usage(self):
        start = [NOSECONE, "-o", self.mesh]
        for message, arguments in (
                ("--length is missing", ["--velocity", "1"]),
                ("need --velocity or --reynolds", ["--y-plus", "1", "--first-height", "1"]),
                ("give one of them", [*self.AIR, "--first-height", "1e-4"]),
                ("one of air, water, custom", ["--velocity", "1", "--length", "1", "--fluid", "oil"]),
                ("one of schlichting", [*self.AIR, "--friction-law", "mine"]),
                ("both --density and --viscosity", ["--velocity", "1", "--length", "1", "--density", "900"]),
                ("leave out one", [*self.AIR, "--density", "900", "--viscosity", "1e-3"]),
                ("leave out --thickness", [*self.AIR, "--thickness-from-flow", "--layers", "3"])):
            with self.subTest(message):
                self.fails(2, message, *start, *arguments)
        self.fails(1, "too small for a turbulent", *start, "--far-field", "2", "--velocity", "1e-5", "--length", "1")


class Interrupts(CommandLineTest):
    def interrupt(self, number):
        """Interrupts the program while TetGen works on a large mesh; gives what it left in its folder."""
        command = [RANSMESH, NOSECONE, *LAYERS, "--far-field", "2", "--size", "0.02", "-o", self.mesh]
        program = subprocess.Popen(command, stderr=subprocess.PIPE, text=True,
                                   env=dict(os.environ, TMPDIR=self.folder))
        for _ in range(600):
            if os.listdir(self.folder):
                break
            time.sleep(0.05)
        time.sleep(0.5)
        program.send_signal(number)
        _, errors = program.communicate(timeout=900)
        self.assertEqual(program.returncode, 1, errors)
        self.assertIn("stopped on request", errors)
        self.assertEqual(os.listdir(self.folder), [])

    def test_interrupts_leave_nothing(self):
        self.interrupt(signal.SIGINT)
        self.interrupt(signal.SIGTERM)


class Report(CommandLineTest):
    def test_content(self):
        report = self.report_of(self.box_obj(), "--walls", "bottom", *LAYERS)
        self.assertEqual(report["request"]["walls"], ["bottom"])
        self.assertEqual(report["request"]["arguments"][1:3], ["--walls", "bottom"])
        self.assertEqual(report["request"]["layers"], 6)
        self.assertEqual(sorted(report["seconds"]),
                         ["enrichment", "isotropic mesh", "quality report", "removal of points"])
        names = [patch["name"] for patch in report["patches"]]
        self.assertEqual(names, list(surfaces.BOX_SIDES))
        self.assertTrue(all(patch["triangles"] > 0 for patch in report["patches"]))


if __name__ == "__main__":
    unittest.main()
