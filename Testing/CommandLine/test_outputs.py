"""The command line program: what it writes, and what is in the way of writing."""
import os
import resource
import subprocess
import unittest

from command_line import LAYERS, NOSECONE, RANSMESH, CommandLineTest

FORMATS = ("mesh.vtu", "mesh.su2", "mesh.b8.ugrid", "mesh.ugrid", "mesh.cgns", "mesh.msh", "case/constant/polyMesh")


class Outputs(CommandLineTest):
    def test_meshes_for_solvers(self):
        for name in FORMATS[1:]:
            before = set(os.listdir(self.folder))
            done = self.run_it(NOSECONE, "-o", self.path(name), *LAYERS, "--prisms", "--quiet")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            made = self.path(name)
            self.assertGreater(sum(os.path.getsize(os.path.join(made, f)) for f in os.listdir(made))
                               if os.path.isdir(made) else os.path.getsize(made), 50000)
            new = set(os.listdir(self.folder)) - before - {"mesh.mapbc"}
            self.assertEqual(new, {name.split("/")[0]})

    def test_what_cannot_be_held_or_written_is_told_before_the_work(self):
        self.fails(2, "cannot hold the faces of --wake", NOSECONE, "-o", self.path("mesh.su2"), "--wake", NOSECONE,
                   *LAYERS)
        self.file("file", "")
        self.fails(1, "cannot be written", NOSECONE, "-o", self.path("file/polyMesh"), *LAYERS)
        self.fails(1, "cannot be written", NOSECONE, "-o", self.path("none/mesh.cgns"), *LAYERS)


class BrokenOutputs(CommandLineTest):
    """Started from a mesh that is there: the disk is full for the result alone."""

    def setUp(self):
        super().setUp()
        self.succeeds(NOSECONE, "--far-field", "2", "--isotropic-only")
        self.start = self.path("start")
        os.rename(self.mesh, self.start + ".vtu")

    def listing(self):
        return sorted(os.path.join(at, name) for at, folders, files in os.walk(self.folder) for name in folders + files)

    def refused(self, name, message, **how):
        before = self.listing()
        command = [RANSMESH, self.start + ".vtu", *LAYERS, "-o", self.path(name)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=900, **how)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(message, done.stderr)
        self.assertIn(self.path(name.replace(".b8.ugrid", ".")), done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertEqual(self.listing(), before)

    def test_disk_full(self):
        os.makedirs(self.path("case/constant"))
        for name in FORMATS:
            with self.subTest(name):
                self.refused(name, "could not be written",
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))

    def test_folders_and_files_in_the_way(self):
        os.makedirs(self.path("case/constant"))
        for name in FORMATS:
            with self.subTest(name):
                if name.endswith("polyMesh"):
                    self.file(name, "precious")
                else:
                    os.mkdir(self.path(name))
                self.refused(name, "is a file" if name.endswith("polyMesh") else "is a folder")
        os.remove(self.path(FORMATS[-1]))
        os.mkdir(self.path(FORMATS[-1]))
        self.file(FORMATS[-1] + "/precious", "")
        self.refused(FORMATS[-1], "holds other things than a mesh")

    def test_no_permission(self):
        os.mkdir(self.path("shut"), 0o500)
        os.chmod(self.folder, 0o755)
        # Who is root may write anywhere.
        user = {"user": 65534, "group": 65534} if os.geteuid() == 0 else {}
        for name in FORMATS:
            with self.subTest(name):
                self.refused("shut/" + os.path.basename(name), "Permission denied", **user)


if __name__ == "__main__":
    unittest.main()
