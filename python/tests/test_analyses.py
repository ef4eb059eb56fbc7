"""Optimisation, fit and uncertainty are those of the command, bit for bit.

Reference: the command of the same build. Parameters: small settings of each analysis. Expected: equal
summaries but for times.
"""

from pathlib import Path

import numpy as np
import pytest
from conftest import Command, comparable

import peelkit


@pytest.fixture
def in_root(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(root)


STRIP = "scenes/strip.toml"


def written(tmp_path: Path, scene: peelkit.Scene) -> Path:
    path = tmp_path / "scene.toml"
    path.write_text(scene.to_toml(), encoding="utf-8")
    return path


def test_an_optimum(in_root: None, command: Command, tmp_path: Path) -> None:
    scene = peelkit.Scene.read(STRIP).with_(
        {
            "optimise.objective": "initiation_peak.force_nN",
            "optimise.parameters": [{"key": "strip.height", "from": "5 nm", "to": "12 nm"}],
            "optimise.starts": 1,
            "optimise.neighbours": 4,
        }
    )
    path = written(tmp_path, scene)
    found = peelkit.optimise(peelkit.Scene.read(path))
    assert comparable(found.summary()) == comparable(command("optimise", path, "--json"))
    assert found.scene is not None and found.gain >= 1.0
    peak = found.scene.run().initiation_peak
    assert peak is not None and found.error is not None
    assert peak.force == pytest.approx(found.objective, rel=1e-6)


def test_a_fit_of_several_curves(in_root: None, command: Command, tmp_path: Path) -> None:
    """The curves that a scene names are fitted together, as the command does, each with its own zero."""
    curve = {"data": str(Path("scenes/strip-fit.csv").absolute())}
    scene = peelkit.Scene.read("scenes/strip-fit.toml").with_("fit.curves", [curve, curve])
    path = written(tmp_path, scene)
    found = peelkit.fit(peelkit.Scene.read(path))
    assert found.parameters["fit.displacement_zero[2]"] == pytest.approx(1.3, rel=0.02)
    assert comparable(found.summary()) == comparable(command("fit", path, "--json"))
    with pytest.raises(TypeError, match="`data` is missing"):
        peelkit.fit(scene, force=[1.0])


def test_a_fit(in_root: None, command: Command, tmp_path: Path) -> None:
    """A curve of the model itself gives back the modulus that it was computed with."""
    given = peelkit.Scene.read(STRIP)
    curve = given.run().curve
    stable = slice(1, int(np.argmax(curve.negative_eigenvalues > 0)))
    u, p = curve.displacement[stable], curve.force[stable]
    scene = given.with_(
        {"strip.youngs_modulus": "1.7 GPa", "fit.parameters": ["strip.youngs_modulus from 1 GPa to 5 GPa"]}
    )
    data = tmp_path / "curve.csv"
    rows = "".join(f"{a!r},{b!r},0.001\n" for a, b in zip(u.tolist(), p.tolist()))
    data.write_text(f"displacement_nm,force_nN,force_error_nN\n{rows}", encoding="utf-8")
    path = written(tmp_path, scene)
    scene = peelkit.Scene.read(path)
    found = peelkit.fit(scene, data)
    assert comparable(found.summary()) == comparable(command("fit", path, "--data", data, "--json"))
    assert found.parameters["strip.youngs_modulus"] == pytest.approx(2.0, rel=1e-3)
    of_arrays = peelkit.fit(scene, u, p, 0.001)
    assert of_arrays.parameters == found.parameters
    assert found.standard_errors == of_arrays.standard_errors and found.scene == of_arrays.scene


def test_an_uncertainty(in_root: None, command: Command, tmp_path: Path) -> None:
    inputs = [dict(key="strip.height", distribution="normal", deviation="0.5 nm")]
    scene = peelkit.Scene.read(STRIP).with_(
        {"uncertainty.inputs": inputs, "uncertainty.samples": 120, "accuracy.relative": 1e-4}
    )
    path = written(tmp_path, scene)
    found = peelkit.uncertainty(peelkit.Scene.read(path))
    assert comparable(found.summary()) == comparable(command("uncertainty", path, "--json"))
