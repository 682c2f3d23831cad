"""The README's Python example runs; its C++ example is the project that the tests build and run. Links of all pages lead
somewhere."""
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


def anchors_of(page):
    """What the headings of a page are called in links, as GitHub makes these names."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


pages = [page for folder in ("Examples", "Filters", "Testing") for page in (SOURCE / folder).rglob("*.md")]
assert len(pages) > 15, pages
for page in [SOURCE / "README.md", *pages]:
    for target, anchor in re.findall(r"\]\((?!https?:)([^)#]*)(?:#([^)]*))?\)", page.read_text(encoding="utf-8")):
        linked = page.parent / target if target else page
        assert linked.exists(), f"{page} links {target}, which does not exist"
        assert not anchor or anchor in anchors_of(linked), f"{page} links {target}#{anchor}, which does not exist"
