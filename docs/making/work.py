"""Work through pages of the documentation as a reader would; keep what that draws for the site.

python docs/making/work.py tutorial
"""

import os
import shutil
import sys

from snippets import ROOT, Reader

MADE = ROOT / "docs" / "made"
KEPT = {".png": MADE / "pictures", ".gif": MADE / "pictures", ".html": MADE / "extra" / "live"}
"""Where files go, by their ending; the last one is copied into the site as it is."""


def work(name: str) -> None:
    """Run the snippets of docs/NAME.md in a folder of their own."""
    folder = ROOT / "build" / "docs" / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "models").symlink_to(ROOT / "models")
    os.chdir(folder)
    Reader().read(ROOT / "docs" / f"{name}.md")
    for file in folder.iterdir():
        if place := KEPT.get(file.suffix):
            place.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, place / file.name)


if __name__ == "__main__":
    for page in sys.argv[1:]:
        work(page)
