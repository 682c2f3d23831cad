"""No file of the project names a folder of somebody's machine, or leaves work undone in a comment.

    check-words.py SOURCE_DIR     prints each line that does; status 1 if there is one
"""
import pathlib
import re
import sys

# Written in pieces, so that this file does not find itself.
FOLDERS = "|".join(("wo" "rk", "fa" "rm", "ro" "ot", "ho" "me", "tm" "p", "opt/p" "v"))
MACHINE_PATH = re.compile(rf"(?<![\w.$}}>*)])/({FOLDERS})/[A-Za-z.]")
UNDONE = re.compile(r"\b(%s)\b" % "|".join(("TO" "DO", "FIX" "ME", "X" "XX", "HA" "CK")))
SKIPPED_FOLDERS = {".git", "build", "__pycache__"}
TEXT = {".h", ".cpp", ".cxx", ".py", ".cmake", ".txt", ".md", ".sh", ".json", ".xml", ".in",
        ".module", ".plugin", ""}


def files(root):
    for path in sorted(root.rglob("*")):
        folders = path.relative_to(root).parts[:-1]
        if path.is_file() and path.suffix in TEXT and not any(
                f in SKIPPED_FOLDERS or f.startswith("build") for f in folders):
            yield path


def main(root):
    faults = []
    for path in files(root):
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            if MACHINE_PATH.search(line) or UNDONE.search(line):
                faults.append(f"{path.relative_to(root)}:{number}: {line.strip()[:120]}")
    print("\n".join(faults) or "nothing found")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
