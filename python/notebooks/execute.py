"""Run the notebooks, each in a fresh kernel, and make the gallery of the book from them.

python execute.py                   run all of them; name some to run these alone
python execute.py --check           the same, and the committed gallery is what the notebooks say
python execute.py --gallery DIR     the same, and write DIR/notebooks.md and DIR/notebooks/NAME.png; DIR is docs/tutorials

A notebook is in order if no cell and no slider fails, with every slider at both of its ends. The picture of
the gallery is that of the cell with the tag "gallery", its text is in the first cell.
"""

from __future__ import annotations

import argparse
import base64
import logging
import sys
import time
from pathlib import Path

import nbformat
from gallery import page, picture_of
from kernel import WatchedKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode

HERE = Path(__file__).resolve().parent
DOCS = HERE.parents[1] / "docs" / "tutorials"
# s; they take a few on an idle machine
LONGEST_CELL = 300
# of a picture in the book, bytes
LARGEST_PICTURE = 100_000

# what a slider would call: its function with each value at its ends, or with each of its options
MOVE_SLIDERS = """
for made in list(globals().values()):
    if type(made).__name__ == "function" and hasattr(made, "widget"):
        for slider in made.widget.children:
            if hasattr(slider, "_kwarg"):
                for value in slider.options if hasattr(slider, "options") else (slider.min, slider.max):
                    made(**{**made.widget.kwargs, slider._kwarg: value})
"""


def execute(path: Path) -> tuple[NotebookNode, str | None, float]:
    """Run a notebook: what became of it, why it failed or None, and the seconds it took."""
    notebook = nbformat.read(path, as_version=4)
    notebook.cells.append(nbformat.v4.new_code_cell(MOVE_SLIDERS))
    client = NotebookClient(
        notebook,
        timeout=LONGEST_CELL,
        kernel_name="python3",
        kernel_manager_class=WatchedKernelManager,
        resources={"metadata": {"path": str(path.parent)}},
        # a kernel has nothing to say but what stands in its cells
        extra_arguments=["--log-level=CRITICAL"],
    )
    begin = time.monotonic()
    try:
        client.execute()
        error = failed_slider(client)
    except CellExecutionError as failure:
        error = str(failure)
    except TimeoutError as failure:
        error = f"{failure}\nUse fewer runs, or a larger `accuracy.relative` of the scene."
    return notebook, error, time.monotonic() - begin


def failed_slider(client: NotebookClient) -> str | None:
    """What the function of a slider has raised: a widget shows it and the notebook goes on."""
    for state in client.widget_state.values():
        for output in state.get("outputs", ()):
            if output.get("output_type") == "error":
                return "a slider fails: " + "\n".join(output["traceback"])
    return None


def write_gallery(docs: Path, notebooks: dict[str, NotebookNode]) -> list[str]:
    """Write the page and its pictures; returns what is wrong with them."""
    (docs / "notebooks").mkdir(parents=True, exist_ok=True)
    (docs / "notebooks.md").write_text(page(notebooks), encoding="utf-8")
    wrong = []
    for name, notebook in notebooks.items():
        picture = base64.b64decode(picture_of(notebook))
        (docs / "notebooks" / f"{name}.png").write_bytes(picture)
        if len(picture) > LARGEST_PICTURE:
            wrong.append(f"{name}.png has {len(picture)} bytes, more than {LARGEST_PICTURE}: draw it smaller, or with fewer points")
    return wrong


def difference(notebooks: dict[str, NotebookNode]) -> list[str]:
    """What the committed gallery lacks."""
    wrong = [] if (DOCS / "notebooks.md").read_text(encoding="utf-8") == page(notebooks) else ["docs/tutorials/notebooks.md is another page"]
    wrong += [f"docs/tutorials/notebooks/{name}.png is missing" for name in notebooks if not (DOCS / "notebooks" / f"{name}.png").is_file()]
    again = "; write it again: python python/notebooks/execute.py --gallery docs/tutorials"
    return [line + again for line in wrong]


def main() -> int:
    """Run what the command line asks for; 0 where all is in order."""
    parser = argparse.ArgumentParser(description="Runs the notebooks.")
    parser.add_argument("names", nargs="*", help="notebooks, without .ipynb; all of them unless given")
    parser.add_argument("--check", action="store_true", help="compare the committed gallery as well, its texts")
    parser.add_argument("--gallery", metavar="DIR", type=Path, help="write DIR/notebooks.md and DIR/notebooks/NAME.png")
    asked = parser.parse_args()
    if asked.names and (asked.check or asked.gallery):
        parser.error("a gallery is made of all notebooks: leave out their names")
    paths = [HERE / f"{name}.ipynb" for name in asked.names] or sorted(HERE.glob("*.ipynb"))

    missing = [path.stem for path in paths if not path.is_file()]
    if missing:
        there = ", ".join(path.stem for path in sorted(HERE.glob("*.ipynb")))
        parser.error(f"no notebook is called {missing[0]!r}; there are {there}")
    # streams of a kernel that has ended
    logging.getLogger("tornado").setLevel(logging.ERROR)
    notebooks, wrong = {}, []
    for path in paths:
        notebook, error, seconds = execute(path)
        print(f"{path.stem:28} {'failed' if error else 'done':7} {seconds:5.1f} s", flush=True)
        notebooks[path.stem] = notebook
        if error:
            wrong.append(f"{path.name}: {error}")
    if asked.gallery and not wrong:
        wrong += write_gallery(asked.gallery, notebooks)
    if asked.check:
        wrong += difference(notebooks)
    print(*wrong, sep="\n", end="\n" if wrong else "", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
