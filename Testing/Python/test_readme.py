"""The README's Python example runs; its C++ example is the project that the tests build and run."""
import os
import re
import tempfile
from pathlib import Path

SOURCE = Path(os.environ["RANSMESHING_SOURCE_DIR"])
readme = (SOURCE / "README.md").read_text(encoding="utf-8")


def block(language):
    return re.search(rf"```{language}\n(.*?)```", readme, re.DOTALL)[1]


consumer = SOURCE / "Testing" / "Consumer"
assert block("cpp") == (consumer / "consumer.cxx").read_text()
assert (consumer / "CMakeLists.txt").read_text().endswith(block("cmake"))

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    exec(block("python"))
    assert os.path.getsize("mesh.vtu") > 1_000_000
    os.chdir("/")

for target in re.findall(r"\]\(([^)#]+)\)", readme):
    assert (SOURCE / target).exists(), f"README.md links {target}, which does not exist"
