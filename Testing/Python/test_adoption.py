"""Meshes of other programs, by the example; of gmsh and netgen themselves, where they are installed."""
import importlib.util
import os
import subprocess
import sys
import tempfile

SOURCE = os.environ["RANSMESHING_SOURCE_DIR"]
MESHES = os.path.join(SOURCE, "Testing/Filters/Meshes")
sys.path.insert(0, os.path.join(SOURCE, "Examples/Python"))
import adoption  # noqa: E402
import pipeline  # noqa: E402


def enriched(path, walls=()):
    filters = adoption.make_chain(path, 1e-3, walls, layers=10)
    pipeline.run(filters)
    assert filters[-1].GetValid()
    return filters[-1].GetOutput()


def names_of(mesh):
    names = mesh.GetFieldData().GetAbstractArray("PatchNames")
    return [names.GetValue(i) for i in range(1, names.GetNumberOfValues())]


def test_files_of_gmsh_and_netgen():
    for name in ("ball-22.msh", "ball-41-binary.msh"):
        assert names_of(enriched(os.path.join(MESHES, name))) == ["ball wall", "inlet", "outlet", "symmetry sides"]
    assert len(names_of(enriched(os.path.join(MESHES, "ball-netgen.msh"), ["patch_7"]))) == 7


def test_example():
    program = [sys.executable, "-B", os.path.join(SOURCE, "Examples/Python/adoption.py")]
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.vtu")
        mesh = os.path.join(MESHES, "ball-41.msh")
        done = subprocess.run([*program, mesh, out, "1e-3"], capture_output=True, text=True, check=True)
        assert "VALID" in done.stdout and os.path.getsize(out) > 1000
        # What the chain wrote is a mesh like any other.
        assert names_of(enriched(out)) == ["ball wall", "inlet", "outlet", "symmetry sides"]
        missing = subprocess.run([*program, out + ".msh", out, "1e-3"], capture_output=True, text=True, check=False)
        assert missing.returncode == 1 and "cannot be opened" in missing.stderr, missing.stderr


def make_by_netgen(path):
    subprocess.run([sys.executable, os.path.join(MESHES, "ball.py"), path], check=True, capture_output=True)


def make_by_gmsh(path):
    subprocess.run(["gmsh", os.path.join(MESHES, "ball.geo"), "-3", "-v", "1", "-o", path], check=True)


def test_programs_themselves():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.msh")
        if importlib.util.find_spec("netgen"):
            make_by_netgen(path)
            assert len(names_of(enriched(path, ["patch_7"]))) == 7
        else:
            print("skipped: netgen is not installed (python3-netgen)")
        try:
            make_by_gmsh(path)
        except FileNotFoundError:
            print("skipped: gmsh is not installed")
            return
        assert "ball wall" in names_of(enriched(path))


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name, "passed")
