"""The OpenFOAM case of the examples, as the page says (Filters/IO/into-the-solver.md): run_case.py RANSMESH SURFACE FOLDER.

Some steps of simpleFoam on half a nose-cone with prisms: it must run, and know every patch by its type. Status 77: OpenFOAM
is not installed.
"""
import os
import re
import shutil
import subprocess
import sys

import numpy

SOURCE = os.environ["RANSMESHING_SOURCE_DIR"]
sys.path.insert(0, os.path.join(SOURCE, "Examples", "Validation"))

import openfoam  # noqa: E402

STEPS = 30


def shorten(path):
    with open(path, encoding="ascii") as file:
        text = file.read()
    with open(path, "w", encoding="ascii") as file:
        file.write(re.sub(r"endTime +\d+;", f"endTime {STEPS};", text))


def drags(folder):
    """The drag coefficient of each step."""
    return numpy.loadtxt(os.path.join(folder, "postProcessing", "forces", "0", "coefficient.dat"))[:, 1]


def main(ransmesh, surface, folder):
    if not openfoam.is_installed():
        print("skipped: OpenFOAM is not installed (Examples/Validation/install-solvers.sh)")
        return 77
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(os.path.join(SOURCE, "Examples", "OpenFOAM", "case"), folder)
    shorten(os.path.join(folder, "system", "controlDict"))
    subprocess.run([ransmesh, surface, "-o", os.path.join(folder, "constant", "polyMesh"), "--prisms", "--far-field", "5",
                    "--symmetry-plane", "y", "--side", "xmin=inlet", "xmax=outlet", "--reynolds", "1e6", "--length", "1",
                    "--y-plus", "1"], check=True)
    for program in ("checkMesh", "simpleFoam"):
        openfoam.run(folder, program)
    found = drags(folder)
    print(f"drag coefficients: {found[::5]}")
    change = abs(found[-1] - found[-6]) / abs(found[-1])
    return 0 if len(found) == STEPS and 0 < found[-1] < 1 and change < 0.2 else 1


sys.exit(main(*sys.argv[1:]))
