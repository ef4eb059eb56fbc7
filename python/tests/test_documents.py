"""The Python of the book and of the docstrings is run, and prints what stands there.

Reference: `docs/reference/python.md`, whose blocks are one session, and the examples of the modules.
"""

import ast
import doctest
import importlib
import pkgutil
import re
from pathlib import Path

import matplotlib
import pytest

import peelkit

matplotlib.use("Agg")


def blocks(text: str) -> str:
    parts = text.split("```")[1::2]
    return "\n".join(part.removeprefix("python\n") for part in parts if part.startswith("python\n"))


def test_the_chapter_prints_what_it_shows(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    session = blocks((root / "docs/reference/python.md").read_text(encoding="utf-8"))
    chapter = doctest.DocTestParser().get_doctest(session, {}, "python.md", "docs/reference/python.md", 0)
    assert len(chapter.examples) > 30
    printed: list[str] = []
    failures = doctest.DocTestRunner().run(chapter, out=printed.append)
    assert failures.failed == 0, "".join(printed)


def test_the_page_of_the_package_runs(root: Path) -> None:
    code = blocks((root / "python/README.md").read_text(encoding="utf-8"))
    assert "scene.run()" in code
    exec(compile(code, "python/README.md", "exec"), {})


@pytest.mark.parametrize(
    "module", ["", *(f".{name}" for _, name, _ in pkgutil.iter_modules(peelkit.__path__) if name != "_native")]
)
def test_docstrings_print_what_they_show(module: str) -> None:
    assert doctest.testmod(importlib.import_module(f"peelkit{module}")).failed == 0


def test_what_is_public_is_documented() -> None:
    for name in peelkit.__all__:
        item = getattr(peelkit, name)
        if callable(item):
            assert item.__doc__, name
            members = (
                (member for key, member in vars(item).items() if not key.startswith("_"))
                if isinstance(item, type)
                else ()
            )
            for member in members:
                documented = getattr(member, "__doc__", None) or not (callable(member) or isinstance(member, property))
                assert documented, (name, member)


RAISED = {"SceneError", "PeelkitError", "ComputationError", "TypeError", "warn"}


def messages(code: str) -> list[str]:
    """What is raised or warned of, without the numbers and names in it: its longest part."""
    found = []
    for call in (node for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Call) and node.args):
        name = getattr(call.func, "id", getattr(call.func, "attr", None))
        message = call.args[0]
        parts = message.values if isinstance(message, ast.JoinedStr) else [message]
        texts = [part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)]
        if name in RAISED and texts:
            found.append(max(texts, key=len))
    return found


def test_every_message_is_in_the_chapter_on_trouble(root: Path) -> None:
    def plain(text: str) -> str:
        return re.sub(r"\s+", " ", text.replace("`", ""))

    pages = [root / "docs/reference/troubleshooting.md", *(root / "docs/reference/troubleshooting").glob("*.md")]
    chapter = plain(" ".join(page.read_text(encoding="utf-8") for page in pages))
    code = [path.read_text(encoding="utf-8") for path in sorted((root / "python/peelkit").rglob("*.py"))]
    all_messages = [message for text in code for message in messages(text)]
    assert len(all_messages) > 12
    # what follows a colon or a semicolon explains
    missing = [one for one in all_messages if not re.split("[:;]", plain(one))[0].strip(" ,.") in chapter]
    assert not missing
