"""A steady incompressible case for OpenFOAM's simpleFoam, written, run and read.

Schemes and solvers are those of Examples/OpenFOAM/case, which work on prisms with tetrahedra above them: no limiter on
gradients, wall distances by exactDistance (meshWave is wrong over tetrahedra), SIMPLEC.
"""
import os
import re
import shutil
import subprocess

import numpy

from ransmeshing import vtkOpenFOAMMeshWriter

ROOT = "/usr/share/openfoam"  # Debian's

SETTINGS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "OpenFOAM", "case", "system")

HEADER = "FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    object {name};\n}}\n"

CONTROL = """
application simpleFoam;
startFrom latestTime;
stopAt endTime;
endTime %(end)d;
deltaT 1;
writeControl timeStep;
writeInterval %(interval)d;
writeFormat ascii;
writePrecision 10;
"""


class SolverError(RuntimeError):
    """The solver is missing, or stopped with an error."""


def write_mesh(mesh, case):
    writer = vtkOpenFOAMMeshWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(case.polymesh())
    if not writer.Write():
        raise SolverError("the mesh cannot be written to " + case.polymesh())


def is_installed():
    return shutil.which("simpleFoam") is not None


def run(folder, *command):
    """Runs a program of OpenFOAM on a case; its output goes to log.<program>, which comes back."""
    environment = dict(os.environ, WM_PROJECT_DIR=ROOT)
    log = os.path.join(folder, "log." + command[0])
    try:
        with open(log, "w", encoding="utf-8") as file:
            status = subprocess.run([*command, "-case", folder], env=environment, stdout=file, stderr=subprocess.STDOUT,
                                    check=False).returncode
    except FileNotFoundError as error:
        raise SolverError(f"{command[0]} is not installed: apt-get install openfoam") from error
    with open(log, encoding="utf-8") as file:
        text = file.read()
    if status != 0:
        raise SolverError(f"{command[0]} failed, see {log}:\n" + "\n".join(text.splitlines()[-8:]))
    return text


class Case:
    """A case in a folder; its mesh is written to polymesh()."""

    def __init__(self, folder):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for part in ("0", "constant", "system"):
            os.makedirs(os.path.join(folder, part))

    def polymesh(self):
        return os.path.join(self.folder, "constant", "polyMesh")

    def _write(self, path, kind, text):
        with open(os.path.join(self.folder, path), "w", encoding="ascii") as file:
            file.write(HEADER.format(kind=kind, name=os.path.basename(path)) + text)

    def set_up(self, viscosity, model, fields, steps, interval, reference=""):
        """model: SpalartAllmaras or laminar. fields: of each field (dimensions, inner value, {patch: entries})."""
        kind = "laminar;" if model == "laminar" else f"RAS;\nRAS {{ RASModel {model}; turbulence on; }}"
        self._write("constant/turbulenceProperties", "dictionary", f"simulationType {kind}\n")
        self._write("constant/transportProperties", "dictionary",
                    f"transportModel Newtonian;\nnu {viscosity:.12g};\n")
        for name in ("fvSchemes", "fvSolution"):
            shutil.copy(os.path.join(SETTINGS, name), os.path.join(self.folder, "system"))
        with open(os.path.join(self.folder, "system", "fvSolution"), "a", encoding="ascii") as file:
            file.write(f"SIMPLE {{ {reference} }}\n")  # entries of a dictionary that is given twice are joined
        self._write("system/controlDict", "dictionary", CONTROL % {"end": steps, "interval": interval})
        for name, (dimensions, value, patches) in fields.items():
            entries = "\n".join(f'    {patch} {{ {entry} }}' for patch, entry in patches.items())
            self._write(f"0/{name}", "volVectorField" if "(" in value else "volScalarField",
                        f"dimensions {dimensions};\ninternalField uniform {value};\n"
                        f"boundaryField\n{{\n{entries}\n}}\n")

    def run(self, *command):
        """Runs a program of OpenFOAM on the case: see run."""
        return run(self.folder, *command)

    def on_patch(self, time, field, patch):
        """The field's values on the faces of a patch, at a time that was written."""
        with open(os.path.join(self.folder, str(time), field), encoding="ascii") as file:
            text = file.read()
        start = text.index("boundaryField")
        block = re.compile(rf"^\s*{re.escape(patch)}\s*\{{(.*?)^\s*\}}", re.M | re.S).search(text, start)[1]
        return _numbers(block[block.index("value"):])

    def inside(self, time, field):
        """The field's values in the cells."""
        with open(os.path.join(self.folder, str(time), field), encoding="ascii") as file:
            text = file.read()
        return _numbers(text[text.index("internalField"):text.index("boundaryField")])


def _numbers(text):
    body = re.search(r"nonuniform List<(\w+)>\s*\d+\s*\((.*?)\n\)", text, re.S)
    values = numpy.array(re.sub(r"[()]", " ", body[2]).split(), dtype=float)
    return values.reshape(-1, 3) if body[1] == "vector" else values
