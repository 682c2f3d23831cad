"""What the examples have in common: a command line, cases one after another, figures that are kept."""
import json
import os
import re
import sys
import time


def main(documentation, run):
    """Ends the program with the status that run(folder, quick) gives; of the arguments FOLDER [--quick]."""
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--quick"]):
        print(documentation, file=sys.stderr)
        sys.exit(2)
    os.makedirs(sys.argv[1], exist_ok=True)
    sys.exit(run(sys.argv[1], bool(sys.argv[2:])))


def run_cases(folder, cases, compute, describe):
    """Computes and describes each of {name: arguments}; leaves figures.json in the folder.

    compute(path, *arguments), the path being for files of that case: figures (a dict), then what a curve consists of.
    Gives {name: figures} and the curves, (name, ...) each.
    """
    results, curves = {}, []
    for name, arguments in cases.items():
        print(f"-- {name}", flush=True)
        start = time.time()
        path = os.path.join(folder, re.sub("[ ,=]+", "-", name))
        figures, *curve = compute(path, *arguments)
        results[name] = {**figures, "seconds": time.time() - start}
        curves.append((name, *curve))
        print(f"{describe(figures)}; {results[name]['seconds']:.0f} s", flush=True)
    with open(os.path.join(folder, "figures.json"), "w", encoding="utf-8") as file:
        json.dump(results, file, indent=2)
    return results, curves
