"""The gallery of the book: a page with the question and the picture of every notebook."""

from __future__ import annotations

from nbformat import NotebookNode

INTRODUCTION = """\
# Notebooks

Seven notebooks for a course, each with a short story, an equation, pictures, sliders that compute a peel while they move, and exercises with hints. They use the [Python package](../reference/python.md); [how to start them](../../python/notebooks/README.md);
nobody has to know Rust. The last cell of each asserts what its text says, and all of them run with the checks of the project.

```sh
pip install "./python[notebooks]"
jupyter lab python/notebooks
```

[Exercises](exercises.md) has ten scenes for the command `peel`, [Seven programs](programs.md) ask the same questions in Rust. The strips are those of the paper. Their peaks are those of the beam model, as
[Your own material](../how-to/scenes/material.md#two-lengths-decide) explains.

This page is made from the notebooks by `python python/notebooks/execute.py --gallery docs/tutorials`.
"""


def page(notebooks: dict[str, NotebookNode]) -> str:
    """The page of the gallery, of executed or other notebooks by their names."""
    return "\n".join([INTRODUCTION, *(section(name, notebook) for name, notebook in notebooks.items())])


def section(name: str, notebook: NotebookNode) -> str:
    """What stands in the gallery of one notebook."""
    title, question, seen = first_cell(notebook)
    return f"""\
## {title}

![{title}](notebooks/{name}.png)

{question}

{seen}

[`python/notebooks/{name}.ipynb`](../../python/notebooks/{name}.ipynb)
"""


def first_cell(notebook: NotebookNode) -> tuple[str, str, str]:
    """Title, question and what the picture shows: the three paragraphs of the first cell."""
    paragraphs = notebook.cells[0].source.split("\n\n")
    if len(paragraphs) != 3:
        raise ValueError(f"the first cell of a notebook has a title, a question and what one sees, not {len(paragraphs)} paragraphs")
    title, question, seen = paragraphs
    if not (title.startswith("# ") and question.startswith("**Question.**") and seen.startswith("**What one sees.**")):
        raise ValueError("the first cell of a notebook begins with '# ', its paragraphs with '**Question.**' and '**What one sees.**'")
    return title.removeprefix("# "), question, seen


def picture_of(notebook: NotebookNode) -> str:
    """The picture of the cell with the tag "gallery", PNG in base64."""
    cells = [cell for cell in notebook.cells if "gallery" in cell.metadata.get("tags", ())]
    pictures = [output.data["image/png"] for cell in cells for output in cell.outputs if "image/png" in output.get("data", ())]
    if len(pictures) != 1:
        raise ValueError(f"one cell with the tag 'gallery' draws one picture, here are {len(pictures)}: {notebook.cells[0].source[:40]!r}")
    return pictures[0]
