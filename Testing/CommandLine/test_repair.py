"""Faulty surfaces on the command line: what is said of them, and the options that help."""
import csv
import os
import re
import unittest

import surfaces
from command_line import NOSECONE, CommandLineTest

GEOMETRY = os.environ.get("RANSMESHING_GEOMETRY", "")
ISOTROPIC = ["--isotropic-only"]


class Repairs(CommandLineTest):
    def ball(self, leave_out=0, gap=0.0):
        """A ball without some of its triangles, its upper half raised by a gap."""
        points, triangles = surfaces.sphere(rings=8, around=12)
        if gap:
            upper = {v: len(points) + i for i, v in enumerate(v for v, p in enumerate(points) if p[2] > -1e-9)}
            points = points + [(points[v][0], points[v][1], points[v][2] + gap) for v in upper]
            middle = [sum(points[v][2] for v in t) for t in triangles]
            triangles = [tuple(upper[v] for v in t) if z > 0 else t for t, z in zip(triangles, middle)]
        return self.file("ball.obj", surfaces.obj_text(points, {"ball": triangles[leave_out:]}))

    def refusal(self, *arguments):
        return self.fails(1, "Remedy: ", *arguments, *ISOTROPIC, "-o", self.mesh).stderr

    def remedy(self, text):
        return re.search(r"\(ransmesh (--[-a-z]+) ([-+.e0-9]+)\)", text).groups()

    def test_holes(self):
        ball = self.ball(leave_out=1)
        text = self.refusal(ball)
        self.assertIn("3 open edges", text)
        option, size = self.remedy(text)
        self.assertEqual(option, "--fill-holes")
        done = self.succeeds(ball, *ISOTROPIC, option, size)
        self.assertIn("Mended: 1 hole filled by 1 triangle", done.stderr)

    def test_gaps(self):
        wide = self.ball(gap=1e-3)
        text = self.refusal(wide)
        self.assertIn("24 open edges", text)
        option, size = self.remedy(text)
        self.assertEqual(option, "--weld")
        self.assertLess(float(size), 1.2e-3)
        self.assertIn("12 points of open edges welded", self.succeeds(wide, *ISOTROPIC, option, size).stderr)
        os.remove(self.mesh)
        narrow = self.ball(gap=1e-8)
        self.assertIn("12 points of open edges welded", self.succeeds(narrow, *ISOTROPIC).stderr)
        os.remove(self.mesh)
        self.assertIn("24 open edges", self.refusal(narrow, "--no-repair"))

    def test_wrap(self):
        points, triangles = surfaces.sphere()
        moved = [(x + 0.7, y + 0.01, z + 0.02) for x, y, z in points]
        both = {"hull": triangles, "fin": [tuple(v + len(points) for v in t) for t in triangles]}
        file = self.file("two.obj", surfaces.obj_text(points + moved, both))
        text = self.refusal(file, "--far-field", "1")
        self.assertRegex(text, r"\d+ triangles of 'hull' and 'fin' cross near \(")
        self.assertEqual(self.remedy(text)[0], "--wrap")
        report = self.report_of(file, *ISOTROPIC, "--far-field", "1", "--wrap", "0.2:0.01")
        names = [patch["name"] for patch in report["patches"] if not patch["name"].startswith("farfield")]
        self.assertEqual(names, ["hull", "fin"])
        self.assertRegex(" ".join(report["warnings"]), r"triangles lies 0\.01 outside")

    def test_limits(self):
        limits = ["--far-field", "2", *ISOTROPIC, "-o", self.mesh, "--memory-limit", "40"]
        self.fails(1, "limit of 40 MB", NOSECONE, *limits)
        self.fails(1, "time limit", NOSECONE, "--far-field", "2", "--size", "0.05", *ISOTROPIC, "-o", self.mesh,
                   "--time-limit", "1e-6")

    def test_wrong_usage(self):
        out = ["-o", self.mesh, *ISOTROPIC]
        self.fails(2, "ALPHA or ALPHA:OFFSET", NOSECONE, *out, "--wrap", "0")
        self.fails(2, "needs a number", NOSECONE, *out, "--wrap", "0.1:thin")
        self.fails(2, "must not be negative", NOSECONE, *out, "--weld", "-1")
        self.fails(2, "leave out one of them", NOSECONE, *out, "--no-repair", "--fill-holes", "1")


@unittest.skipUnless(os.path.exists(os.path.join(GEOMETRY, "CATALOG.tsv")), "the collection of bodies is not there")
class Catalogue(CommandLineTest):
    """The broken bodies of the collection: the counts are the catalogue's, and the remedy works."""

    def row(self, name):
        with open(os.path.join(GEOMETRY, "CATALOG.tsv"), encoding="utf-8") as file:
            return next(r for r in csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE) if r["file"] == name)

    def diagnosis(self, name, *arguments):
        text = self.fails(1, "Cannot mesh", os.path.join(GEOMETRY, name), *ISOTROPIC, "-o", self.mesh,
                          *arguments).stderr
        row = self.row(name)
        for column, pattern in (
                ("open_edges", r"(\d+) open edge"), ("nonmanifold_edges", r"(\d+) non-manifold edge"),
                ("nonmanifold_verts", r"(\d+) non-manifold point"), ("duplicate_faces", r"(\d+) duplicate triangle"),
                ("degenerate_faces", r"(\d+) degenerate triangle"), ("misoriented_edges", r"(\d+) misoriented edge"),
                ("self_intersecting_pairs", r"(\d+) pairs? of triangles cuts?")):
            found = re.search(pattern, text)
            self.assertEqual(int(found[1]) if found else 0, int(row[column]), (name, column, text))
        return re.search(r"\(ransmesh (--[-a-z]+) ([-+.e0-9]+)\)", text).groups()

    def mesh_by(self, name, *arguments):
        report = self.report_of(os.path.join(GEOMETRY, name), *ISOTROPIC, *arguments)
        self.assertTrue(report["quality"]["Valid"])
        return [patch["name"] for patch in report["patches"]]

    def test_wigley(self):
        far = ("--far-field", "2")
        option = self.diagnosis("wigley_raw_broken.stl.gz", *far)
        self.assertEqual(option[0], "--fill-holes")
        self.mesh_by("wigley_raw_broken.stl.gz", *far, *option)

    def test_aneurysm(self):
        option = self.diagnosis("aneurysm_open.stl.gz")
        self.assertEqual(option[0], "--fill-holes")
        names = self.mesh_by("aneurysm_open.stl.gz", *option)
        self.assertEqual(names, ["aneurysm_open", "hole_1", "hole_2", "hole_3"])

    def test_motorbike(self):
        option, alpha = self.diagnosis("motorBike.obj.gz", "--far-field", "2")
        self.assertEqual(option, "--wrap")
        if os.environ.get("RANSMESHING_SLOW_CHECKS") != "ON":
            alpha = "0.1"  # a mesh in seconds
        self.assertGreater(len(self.mesh_by("motorBike.obj.gz", "--far-field", "2", option, alpha)), 30)


if __name__ == "__main__":
    unittest.main()
