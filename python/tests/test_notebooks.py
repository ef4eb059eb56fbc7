"""The notebooks as they are committed: without outputs, and as the gallery of the book shows them.

What is in them is run by ``python/notebooks/execute.py --check``.
"""

from pathlib import Path
from typing import Any

import nbformat
import pytest

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))


def read(path: Path) -> Any:
    notebook = nbformat.read(path, as_version=4)  # type: ignore[no-untyped-call]
    nbformat.validate(notebook)
    return notebook


def test_there_are_seven() -> None:
    assert len(NOTEBOOKS) == 7


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_committed_without_outputs(path: Path) -> None:
    # a picture in a notebook makes every change of it unreadable, and shows what an older version has drawn
    for cell in read(path).cells:
        if cell.cell_type == "code":
            assert not cell.outputs, f"{path.name}: clear the outputs before a commit"
            assert cell.execution_count is None, f"{path.name}: clear the execution counts before a commit"


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_has_what_a_lesson_has(path: Path) -> None:
    notebook = read(path)
    text = "\n".join(cell.source for cell in notebook.cells)
    assert text.count("@interact(") >= 1
    assert "## Exercises" in text and text.count("<summary>Hint</summary>") >= 4
    assert "assert" in notebook.cells[-1].source


def test_gallery_is_that_of_the_notebooks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "python" / "notebooks"))
    import gallery  # type: ignore[import-not-found]

    page = (ROOT / "docs" / "tutorials" / "notebooks.md").read_text(encoding="utf-8")
    assert page == gallery.page({path.stem: read(path) for path in NOTEBOOKS}), "python python/notebooks/execute.py --gallery docs/tutorials"
    pictures = sorted((ROOT / "docs" / "tutorials" / "notebooks").glob("*.png"))
    assert [picture.stem for picture in pictures] == [path.stem for path in NOTEBOOKS]
    assert all(picture.stat().st_size <= 100_000 for picture in pictures)
