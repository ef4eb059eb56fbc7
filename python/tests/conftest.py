"""Scenes that the tests share, and the command that results are compared with."""

import json
import os
import subprocess
from pathlib import Path
from typing import Any, Callable

import pytest

import peelkit

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def strip() -> peelkit.Scene:
    """The strip of the paper, 100 nm long and 10 nm high, of 2 GPa."""
    return peelkit.Scene(
        title="Strip",
        strip=dict(length="100 nm", height="10 nm", youngs_modulus="2 GPa"),
        adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
    )


@pytest.fixture(scope="session")
def peel(strip: peelkit.Scene) -> peelkit.Peel:
    return strip.run()


Command = Callable[..., dict[str, Any]]


@pytest.fixture(scope="session")
def executable() -> Path:
    """The command `peel` of this build."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    given = os.environ.get("PEELKIT_COMMAND")
    peel = ROOT / given if given else target / "release" / "peel"
    if not given and not peel.exists():
        pytest.skip(f"{peel} is missing: cargo build --release -p peelkit-cli makes it")
    return peel


@pytest.fixture(scope="session")
def command(executable: Path) -> Command:
    """What the command prints with --json, without what differs from run to run."""

    def run(*arguments: object) -> dict[str, Any]:
        words = [str(executable), *map(str, arguments)]
        done = subprocess.run(words, capture_output=True, text=True, encoding="utf-8", cwd=ROOT)
        assert done.stdout, done.stderr
        found: dict[str, Any] = json.loads(done.stdout)
        return found

    return run


# times and the command line alone differ from run to run
TIMES = {"command", "timing", "solve_s"}


def comparable(found: Any) -> Any:
    """What a command has found, without its times."""
    if isinstance(found, dict):
        return {key: comparable(value) for key, value in found.items() if key not in TIMES}
    if isinstance(found, list):
        return [comparable(value) for value in found]
    return found
