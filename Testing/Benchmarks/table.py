#!/usr/bin/python3
"""The table of cases: each through the chain and through a referee, as markdown.

    table.py --program build/bin/ransmesh-cases [options]

Every case of `ransmesh-cases list` and the real bodies of --geometry are meshed, one after the other. The
referee (--referee, or the environment variable RANSMESHING_REFEREE) is a program that takes a mesh and the
options --walls, --first-height, --layers, --growth, --json; without one the columns that it fills stay empty.
"""
import argparse
import fnmatch
import json
import os
import pathlib
import subprocess
import sys
import tempfile

# file, first height (1e-5 of the body's length), far field, walls; the goals are those of all of them.
REAL = (
    ("hifire4_flyer.stl.gz", 6e-5, True, ()),
    ("basic_finner.stl.gz", 1e-4, True, ()),
    ("wing_fuselage.obj.gz", 4.5e-3, True, ()),
    ("dlrf6_halfdomain.obj.gz", 1.2e-2, False, ("aircraft_*",)),
    ("asmo_halfdomain.obj.gz", 8e-6, False, ("defaultFaces0006", "defaultFaces0007", "defaultFaces0008",
                                            "defaultFaces0009")),
    ("motorBike_wrapped.obj.gz", 2e-5, True, ()),
    ("submarine_halfdomain.obj.gz", 4.3e-2, False, tuple(f"cadface_{i}" for i in range(1, 11))),
    ("elbow_90degree.obj.gz", 4.4e-4, False, ("bend*", "ring*", "fixed*")),
    ("aneurysm_capped.obj.gz", 6e-4, False, ("wall",)),
)
# Those whose triangles are needles once more, with surfaces of triangles of one size.
REMESHED = (("hifire4_flyer.stl.gz", 0.06), ("basic_finner.stl.gz", 0.1))
REAL_GOALS = {"inserted": 0.9999, "full": 0.98, "175": 0.002, "179": 0.0005}
COLUMNS = ("case", "h0", "inserted of requested", "of asked", "full columns (smooth points)", "> 175° (layers)", "> 179°",
           "wall copies", "full, or what gaps leave", "area with h0", "away from gaps",
           "growth off at 99 %", "valid", "left by removal", "seconds", "why columns stopped")


def built_cases(program):
    """Name and goals of each case that the program knows."""
    listing = subprocess.run([program, "list"], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        goals = dict(zip(("inserted", "full", "175", "179"),
                         (float(part.split()[-1]) for part in line.split("goals:")[1].split(","))))
        yield line.split()[0], goals


def all_rows(args):
    """(name, options of the program, goals) of each row wanted."""
    rows = []
    for name, goals in built_cases(args.program):
        heights = args.heights if "thick" not in name else [None]
        for h0 in heights:
            options = [name] + (["--h0", str(h0)] if h0 else []) + (["--size", str(args.size)] if args.size else [])
            rows.append((name, options, goals))
    for file, h0, far_field, walls in REAL if args.geometry else ():
        options = [str(pathlib.Path(args.geometry) / file), "--h0", str(h0)]
        options += ["--far-field"] if far_field else []
        options += ["--walls", *walls] if walls else []
        rows.append((file.split(".")[0], options, REAL_GOALS))
        rows += [(file.split(".")[0] + "-remeshed", options + ["--size", str(size)], REAL_GOALS)
                 for name, size in REMESHED if name == file]
    return [row for row in rows if any(fnmatch.fnmatch(row[0], p) for p in args.cases or ["*"])]


def judge(referee, name, mesh, result):
    """The referee's report, or nothing."""
    report = mesh.with_suffix(".judged.json")
    command = ["/usr/bin/python3", referee, str(mesh), "--walls", ",".join(map(str, result["walls"])),
               "--first-height", repr(result["first_height"]), "--layers", str(result["layers"]),
               "--growth", repr(result["growth"]), "--json", str(report)]
    if "rhomb" in name:  # columns lean along the corner's own, by 30 degrees
        command += ["--cone", "35"]
    if result["sheets"]:
        command += ["--internal", ",".join(map(str, result["sheets"]))]
    subprocess.run(command, capture_output=True, check=False)
    return json.loads(report.read_text()) if report.exists() else {}


def share(part, whole):
    return part / whole if whole else 0.0


def percent(value, goal=None, most=False):
    """The share in percent, bold where it misses its goal."""
    if value is None:
        return ""
    text = f"{100 * value:.4f}".rstrip("0").rstrip(".") + " %"
    missed = goal is not None and (value > goal if most else value < goal)
    return f"**{text}**" if missed else text


def full_columns(name, result, layers):
    """Of the columns at smooth wall points by the referee; where gaps or lower neighbours limit them, of those limits;
    with sheets, walls of their own layers, and in cones whose columns lie in the outlet, more than 20 degrees from the
    normal, of all columns."""
    leans = name in ("cone-inside30", "cone-inside45", "cone-inside60")
    limits = any(word in name for word in ("-gap", "-floor", "floor-", "-mirror"))
    if not limits and not leans and not result["sheets"] and not result["walls_of_their_own"]:
        return layers.get("share_of_columns_full")
    limited = ("none", "gap", "isotropic size reached") + ("transition",) * bool(result["walls_of_their_own"])
    return share(sum(result["stop_reasons"].get(reason, 0) for reason in limited), result["columns"])


def left_by_removal(result):
    """Of the points marked those that stayed, without those that the surface's shape needs."""
    left = result["marked"] - result["removed"] - result["of_shape"]
    text = f"{left} of {result['marked']}"
    shape = f", shape {result['of_shape']}" if result["of_shape"] else ""
    return (f"**{text}**" if left > 0.001 * result["marked"] else text) + shape


def row_of(name, result, judged, goals):
    layers = judged.get("layers", {})
    tets = result["layer_tetrahedra"]
    valid = result["valid"] and judged.get("valid", True)
    faults = result["faults"] or ", ".join(k for k, v in judged.get("faults", {}).items() if v)
    reasons = ", ".join(f"{k} {v}" for k, v in result["stop_reasons"].items() if k != "none")
    return (name, f"{result['first_height']:g}",
            percent(share(result["inserted"], result["requested"]), goals["inserted"]),
            percent(share(result["inserted"], result["asked"])),
            percent(full_columns(name, result, layers), goals["full"]),
            percent(share(result["over_175"], tets), goals["175"], True),
            percent(share(result["over_179"], tets), goals["179"], True),
            percent(result["copies_of_wall_faces"]),
            percent(result["columns_with_their_layers"]),
            percent(result["area_with_first_height"]),
            percent(result["area_away_from_gaps"], 0.999),
            percent(result["growth_off"], 0.05, True),
            ("yes" if judged else "by the kernel") if valid else f"**no: {faults}**",
            left_by_removal(result),
            " + ".join(f"{s:.1f}" for s in result["seconds"]), reasons)


def run_row(args, folder, name, options, goals):
    mesh = pathlib.Path(folder) / f"{name}.vtu"
    program = subprocess.run([args.program, *options, "-o", str(mesh)], capture_output=True, text=True,
                             timeout=args.timeout, check=False)
    if not program.stdout.strip():
        return (name, "", f"**failed: {program.stderr.strip()[:300] or program.returncode}**") + ("",) * (len(COLUMNS) - 3)
    result = json.loads(program.stdout)
    judged = judge(args.referee, name, mesh, result) if args.referee else {}
    if not args.keep:
        mesh.unlink()
    return row_of(name, result, judged, goals)


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ap.add_argument("cases", nargs="*", help="names or patterns; none: all")
    ap.add_argument("--program", required=True)
    ap.add_argument("--referee", default=os.environ.get("RANSMESHING_REFEREE", ""))
    ap.add_argument("--geometry", default="", help="folder of the real bodies")
    ap.add_argument("--heights", type=float, nargs="*", default=[1e-5, 1e-7])
    ap.add_argument("--size", type=float, help="edge length of the surfaces, instead of each case's own")
    ap.add_argument("--timeout", type=float, default=900)
    ap.add_argument("--keep", help="folder in which the meshes stay")
    args = ap.parse_args()
    if not args.referee or not os.path.exists(args.referee):
        print("no referee: its columns are left empty", file=sys.stderr)
        args.referee = ""
    print("| " + " | ".join(COLUMNS) + " |\n|" + "---|" * len(COLUMNS), flush=True)
    with tempfile.TemporaryDirectory() as temporary:
        for name, options, goals in all_rows(args):
            try:
                row = run_row(args, args.keep or temporary, name, options, goals)
            except subprocess.TimeoutExpired:
                row = (name, "", f"**not done in {args.timeout:g} s**") + ("",) * (len(COLUMNS) - 3)
            print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
