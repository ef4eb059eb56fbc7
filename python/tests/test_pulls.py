"""The pull-off of a seta, pulls at a rate and the law of a tip are those of the command `peel`, bit for bit.

Reference: the command of the same build. Parameters: the setae and the strip of `scenes/`, the first seta with two forks and the
table of a tip as coarse as 5e-2, which is enough to compare. Expected: equal summaries but for times and the command line, equal
columns of curve.csv, and the same files with the same contents.
"""

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Command, comparable
from test_equals_command import columns

import peelkit

SMALL = {"seta.forks": 2}


def small_seta(root: Path) -> peelkit.Scene:
    return peelkit.Scene.read("scenes/seta.toml").with_(SMALL)


def compared(
    found: peelkit.PullOff | peelkit.PullAtRate | peelkit.SolidPeel | peelkit.ArrayPull, printed: dict[str, Any], folder: Path
) -> None:
    """The result against what the command has printed and written."""
    assert comparable(found.summary()) == comparable(printed)
    table, written = found.curve.to_pandas(), columns(folder / "curve.csv")
    assert list(table) == list(written)
    for name, cells in written.items():
        assert np.array_equal(table[name].to_numpy(), np.array([float(cell) for cell in cells])), name


def test_a_seta_is_pulled_off_as_by_the_command(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    printed = command("run", "scenes/seta.toml", "--set", "seta.forks=2", "--json", "--out", tmp_path)
    found = small_seta(root).run()
    assert isinstance(found, peelkit.PullOff)
    compared(found, printed, tmp_path)
    assert found.tips == 4 and found.end == "detached" and found.events["tips_detached"] == 4
    assert found.peak_force == printed["peak"]["force_nN"] <= found.curve.force.max() * (1 + 1e-3)


@pytest.mark.parametrize("name", ["seta-at-a-rate.toml", "strip-at-a-rate.toml"])
def test_a_pull_at_a_rate_is_that_of_the_command(
    name: str, root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    printed = command("run", f"scenes/{name}", "--json", "--out", tmp_path)
    found = peelkit.Scene.read(f"scenes/{name}").pull_at_rate()
    compared(found, printed, tmp_path)
    assert found.largest_force == printed["largest_force"]["force_nN"] >= found.curve.force.max()
    assert found.over_equilibria is not None and found.over_equilibria > 1.0
    assert ("front" in found.curve) == (name == "strip-at-a-rate.toml")


def test_a_solid_is_peeled_as_by_the_command(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    short = {"path.until": "first-jump", "solid.along": "4 nm", "solid.through": 3}
    sets = [part for key, value in short.items() for part in ("--set", f"{key}={value}")]
    printed = command("run", "scenes/solid-strip.toml", *sets, "--json", "--out", tmp_path)
    found = peelkit.Scene.read("scenes/solid-strip.toml").with_(short).run()
    assert isinstance(found, peelkit.SolidPeel)
    compared(found, printed, tmp_path)
    assert found.peak is not None and found.peak["force_nN"] == printed["peak"]["force_nN"]
    assert len(found.limit_points) == len(printed["limit_points"])


@pytest.mark.parametrize("name", ["patch", "lamella"])
def test_an_array_is_pulled_as_by_the_command(
    name: str, root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    small = {"setae.rows": 12, "setae.columns": 5}
    sets = [part for key, value in small.items() for part in ("--set", f"{key}={value}")]
    printed = command("run", f"scenes/{name}.toml", *sets, "--json", "--out", tmp_path)
    scene = peelkit.Scene.read(f"scenes/{name}.toml").with_(small)
    found = scene.run()
    assert isinstance(found, peelkit.ArrayPull)
    compared(found, printed, tmp_path)
    for own, file in [(found.events, "events"), (found.rows, "rows")]:
        table, written = own.to_pandas(), columns(tmp_path / f"{file}.csv")
        assert list(table) == list(written)
        for column, cells in written.items():
            numbers = [{"true": 1.0, "false": 0.0}[cell] if cell in ("true", "false") else float(cell) for cell in cells]
            assert np.array_equal(table[column].to_numpy(), np.array(numbers)), column
    assert found.peak_force == printed["peak"]["load"] == found.force.max()
    again = pickle.loads(pickle.dumps(found))
    assert np.array_equal(again.events.load, found.events.load) and again.summary() == found.summary()
    with pytest.raises(peelkit.SceneError, match="no array of setae"):
        peelkit.Scene.read("scenes/strip-100nm.toml").pull_array()
    swept = peelkit.sweep(scene, {"setae.strength_scatter": [0.0, 0.2]})
    assert swept.largest_load.values[1] == printed["largest_load"]


def test_saved_files_are_those_of_the_command(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    scenes = {"seta": ("scenes/seta.toml", SMALL), "strip": ("scenes/strip-100nm.toml", {})}
    for name, (path, values) in scenes.items():
        sets = [word for key, value in values.items() for word in ("--set", f"{key}={value}")]
        command("run", path, *sets, "--json", "--out", tmp_path / name)
        found = peelkit.Scene.read(path).with_(values).run()
        saved = found.save(tmp_path / f"{name} of Python")
        assert sorted(file.name for file in saved) == sorted(file.name for file in (tmp_path / name).iterdir())
        for file in saved:
            # these two name the command, and times
            if file.name not in ("parameters.toml", "summary.json"):
                assert file.read_bytes() == (tmp_path / name / file.name).read_bytes(), file
        with pytest.raises(peelkit.PeelkitError, match="of Python") as refused:
            found.save(tmp_path / f"{name} of Python")
        assert "replace=True" in refused.value.remedy
        assert found.save(tmp_path / f"{name} of Python", replace=True) == saved


def test_the_law_of_a_tip_is_that_of_the_command(
    root: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    asked = ["--tolerance", "5e-2", "--rotation", "-0.1 rad,0.1 rad"]
    printed = command("coarsen", "scenes/spatula.toml", *asked, "--json", "--out", tmp_path / "command")
    law = peelkit.Scene.read("scenes/spatula.toml").coarsen(tolerance=5e-2, rotation=(-0.1, 0.1))
    assert comparable(law.summary()) == comparable(printed)
    for file in law.save(tmp_path / "python"):
        if file.name != "summary.json":
            assert file.read_bytes() == (tmp_path / "command" / file.name).read_bytes(), file
    with pytest.raises(peelkit.SceneError, match="pad of this scene slides"):
        peelkit.Scene.read("scenes/spatula.toml").coarsen(lateral=(-1.0, 1.0))


def test_what_is_of_a_beam_alone_is_refused_of_a_seta_and_of_a_rate(
    root: Path, monkeypatch: pytest.MonkeyPatch, strip: peelkit.Scene
) -> None:
    monkeypatch.chdir(root)
    for scene, table in [(small_seta(root), "seta"), (peelkit.Scene.read("scenes/strip-at-a-rate.toml"), "time")]:
        for of_a_beam in (scene.test, scene.path, scene.sensitivities, scene.coarsen, scene.out_of_plane):
            with pytest.raises(peelkit.SceneError, match=rf"\[{table}\]"):
                of_a_beam()
    with pytest.raises(peelkit.SceneError, match="no seta"):
        strip.pull_off()
    with pytest.raises(peelkit.SceneError, match="not pulled at a rate"):
        strip.pull_at_rate()


def test_a_pull_that_is_cut_warns_and_one_that_is_pickled_has_its_numbers(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(root)
    with pytest.warns(peelkit.ComputationWarning, match="the path goes on: bounds.points = 3"):
        cut = small_seta(root).with_("bounds.points", 3).pull_off()
    assert cut.end == "bound" and len(cut.curve.force) == 3
    again = pickle.loads(pickle.dumps(cut))
    assert again.summary() == cut.summary() and np.array_equal(again.curve.force, cut.curve.force)
    with pytest.raises(peelkit.PeelkitError, match="pickled"):
        again.save("nowhere")
