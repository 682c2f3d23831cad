"""What tests of the command line program stand on: runs of it in a folder of their own."""
import glob
import gzip
import json
import os
import shutil
import subprocess
import tempfile
import unittest

import surfaces

RANSMESH = os.environ["RANSMESH"]
NOSECONE = os.environ["NOSECONE"]
LAYERS = ["--first-height", "1e-3", "--layers", "6"]


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        self.mesh = self.path("mesh.vtu")

    def path(self, name):
        return os.path.join(self.folder, name)

    def file(self, name, content):
        if isinstance(content, str):
            content = content.encode()
        with (gzip.open if name.endswith(".gz") else open)(self.path(name), "wb") as file:
            file.write(content)
        return self.path(name)

    def run_it(self, *arguments):
        return subprocess.run([RANSMESH, *arguments], capture_output=True, text=True, timeout=900)

    def succeeds(self, *arguments):
        done = self.run_it(*arguments, "-o", self.mesh)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(os.path.getsize(self.mesh) > 1000)
        return done

    def fails(self, status, message, *arguments):
        """One line that holds the message; no mesh, and nothing half-written beside it."""
        done = self.run_it(*arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn(message, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertEqual(glob.glob(self.path("*.vtu")) + glob.glob(self.path(".*")), [])
        return done

    def report_of(self, *arguments):
        self.succeeds(*arguments, "--report", self.path("report.json"))
        return self.read_report()

    def read_report(self):
        with open(self.path("report.json"), encoding="utf-8") as file:
            return json.load(file)

    def box_obj(self, name="box.obj"):
        return self.file(name, surfaces.obj_text(*surfaces.box()))

    def patches_of(self, *arguments):
        return {patch["name"]: patch["type"] for patch in self.report_of(*arguments)["patches"]}
