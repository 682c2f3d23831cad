"""The kernel includes no VTK and no TetGen, and its folders only what lies below them.

    check-layers.py SOURCE_DIR     prints each include that breaks a rule; status 1 if there is one, 2 if the folder
                                   is not that of the project
"""
import pathlib
import re
import sys

BELOW = {"Support": set()}
BELOW["Geometry"] = {"Support"}
BELOW["Mesh"] = BELOW["Geometry"] | {"Geometry"}
BELOW["Triangles"] = BELOW["Prisms"] = BELOW["Mesh"] | {"Mesh"}
BELOW["Boundary"] = BELOW["Surface"] = BELOW["Remeshing"] = BELOW["Domain"] = BELOW["Triangles"] | {"Triangles"}
BELOW["Layers"] = BELOW["Improvement"] = BELOW["Boundary"] | {"Boundary"}
BELOW["Insertion"] = BELOW["Removal"] = BELOW["Quality"] = BELOW["Layers"] | {"Layers", "Improvement"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
PUBLIC_HEADER = re.compile(r"^vtk\w+\.h$")


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1], match[2]


def kernel_fault(folder, quote, name):
    if name.startswith("vtk") or name.startswith("tetgen"):
        return "the kernel must not know VTK or TetGen"
    if quote != '"':
        return None
    target = name.split("/")[0]
    if "/" not in name or target not in BELOW:
        return 'kernel headers are included as "Folder/Name.h"'
    if target != folder and target not in BELOW[folder]:
        return f"{folder} must not know {target}"
    return None


def module_fault(path, name):
    if PUBLIC_HEADER.match(path.name) and name.split("/")[0] in BELOW:
        return "a public VTK header must not include the kernel"
    return None


def main(root):
    faults = []
    kernel = root / "Filters" / "Kernel"
    if not kernel.is_dir():
        print(f"{root} has no folder Filters/Kernel: give the project's own")
        return 2
    for path in sorted([*(root / "Filters").rglob("*.h"), *(root / "Filters").rglob("*.c*")]):
        if path.suffix not in (".h", ".cpp", ".cxx"):
            continue
        for number, quote, name in includes(path):
            if kernel in path.parents:
                fault = kernel_fault(path.relative_to(kernel).parts[0], quote, name)
            else:
                fault = module_fault(path, name)
            if fault:
                faults.append(f"{path.relative_to(root)}:{number}: includes {name}: {fault}")
    print("\n".join(faults) or "every include keeps the rules")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
