"""One of the flows of Examples/Validation at its smallest size: flow.py NAME FOLDER. Status 77: no solver."""
import importlib
import os
import sys

sys.path.insert(0, os.path.join(os.environ["RANSMESHING_SOURCE_DIR"], "Examples", "Validation"))

import elements  # noqa: E402
import openfoam  # noqa: E402

SOLVER = {"turbulent_plate": openfoam, "laminar_plate": elements, "cavity": elements}


def main(name, folder):
    if not SOLVER[name].is_installed():
        print(f"skipped: the solver of {name} is not installed (Examples/Validation/install-solvers.sh)")
        return 77
    os.makedirs(folder, exist_ok=True)
    return importlib.import_module(name).run(folder, quick=True)


sys.exit(main(*sys.argv[1:]))
