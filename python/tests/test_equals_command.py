"""Results are those of the command `peel`, bit for bit.

Reference: the command of the same build. JSON and CSV write every number with all of its digits, so equal
texts are equal bits. Parameters: a strip, one with another grip, a spatula and a strip in space. Expected:
equal summaries but for times and the command line, equal columns of curve.csv, states.csv and observed.csv.
"""

import csv
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Command, comparable

import peelkit

SCENES = ["strip.toml", "spatula.toml"]


def columns(path: Path) -> dict[str, list[str]]:
    with path.open(newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    return {name: list(cells) for name, cells in zip(header, zip(*rows))}


@pytest.mark.parametrize("name", SCENES)
def test_a_summary_is_that_of_the_command(
    name: str, root: Path, command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    path = f"scenes/{name}"
    summary = peelkit.Scene.read(path).run().summary()
    assert comparable(summary) == comparable(command("run", path, "--json"))


def test_replaced_keys_are_those_of_set(root: Path, command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    scene = peelkit.Scene.read("scenes/strip.toml").with_({"strip.length": "50 nm", "grip.rotation": "fixed"})
    found = command("run", "scenes/strip.toml", "--set", "strip.length=50 nm", "--set", "grip.rotation=fixed", "--json")
    assert comparable(scene.run().summary()) == comparable(found)


def test_arrays_are_the_columns_of_the_files(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    command("run", "scenes/strip.toml", "--states", 3, "--observed", "--json", "--out", tmp_path)
    scene = peelkit.Scene.read("scenes/strip.toml")
    peel = scene.run()
    table = peel.curve.to_pandas()
    written = columns(tmp_path / "curve.csv")
    # stability out of the plane is a column of the command that is empty unless it was asked for
    asked = [name for name in written if name != "negative_eigenvalues_out_of_plane"]
    assert list(table) == asked
    for name in asked:
        assert np.array_equal(table[name].to_numpy(), np.array([float(cell) for cell in written[name]])), name

    states = peel.states(3)
    written = columns(tmp_path / "states.csv")
    for name in states[0]:
        computed = np.concatenate([state[name] for state in states])
        assert np.array_equal(computed, np.array([float(cell) for cell in written[name]])), name

    test = scene.test()
    written = columns(tmp_path / "observed.csv")
    assert test.force.tolist() == [float(cell) for cell in written["force_nN"]]
    assert test.machine_displacement.tolist() == [float(cell) for cell in written["machine_displacement_nm"]]
    assert test.branch.tolist() == written["branch"]
    assert test.adheres.tolist() == written["adheres"]


def test_a_strip_in_space_has_the_columns_of_its_grip(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    # 1 nm of pull is enough to compare
    arguments = ["--set", "bounds.displacement=1 nm"]
    found = command("run", "scenes/strip-rolled.toml", *arguments, "--json", "--out", tmp_path)
    with pytest.warns(peelkit.ComputationWarning, match="the path goes on"):
        peel = peelkit.Scene.read("scenes/strip-rolled.toml").with_("bounds.displacement", 1.0).run()
    assert comparable(peel.summary()) == comparable(found)
    table, written = peel.curve.to_pandas(), columns(tmp_path / "curve.csv")
    assert [name for name in written if name != "negative_eigenvalues_out_of_plane"] == list(table)
    assert table["roll_deg"].tolist() == [float(cell) for cell in written["roll_deg"]]


def test_sensitivities_are_those_of_the_command(root: Path, command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    expected: list[dict[str, Any]] = command("run", "scenes/strip.toml", "--sensitivities", "--json")["sensitivities"]
    found = peelkit.Scene.read("scenes/strip.toml").sensitivities()
    assert [(one.of, one.key, one.value, one.error) for one in found] == [
        (one["of"], one["key"], one["d_ln_d_ln"], one["error"]) for one in expected
    ]


@pytest.mark.parametrize("branch", [False, True])
def test_what_leaves_the_plane_is_that_of_the_command(
    branch: bool, root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    path, option = "scenes/strip-100nm.toml", "--branch" if branch else "--out-of-plane"
    printed = command("run", path, "--set", "strip.width=40 nm", option, "--json", "--out", tmp_path / "command")
    found = peelkit.Scene.read(path).with_("strip.width", "40 nm").out_of_plane(branch=branch)
    assert comparable(found.summary()) == comparable(printed)
    assert found.stability is not None and found.end == printed["end"] and found.reason is None
    assert found.stability["first_loss"] == printed["out_of_plane"]["first_loss"]
    assert (found.branch is not None) == branch
    if found.branch is not None:
        assert found.branch["end"] == "back-in-plane" and "with its branch" in repr(found)
    saved = found.save(tmp_path / "python")
    assert ("branch.csv" in [file.name for file in saved]) == branch
    for file in saved:
        # these two name the command, and times
        if file.name not in ("parameters.toml", "summary.json"):
            assert file.read_bytes() == (tmp_path / "command" / file.name).read_bytes(), file


def test_what_cannot_leave_the_plane_is_refused(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)
    for name, part in [("strip-friction", "friction"), ("seta", r"\[seta\]"), ("strip-at-a-rate", r"\[time\]")]:
        with pytest.raises(peelkit.SceneError, match=part):
            peelkit.Scene.read(f"scenes/{name}.toml").out_of_plane()
    short = peelkit.Scene.read("scenes/strip-100nm.toml").with_("bounds.points", 5)
    with pytest.warns(peelkit.ComputationWarning, match="bounds.points = 5"):
        assert short.out_of_plane().end == "bound"
