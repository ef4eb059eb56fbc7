"""Scenes and results travel to other processes and come back the same.

Reference: the object that was sent. Expected: every bit of its numbers, also in a process of its own; states
of a result that was sent are computed again, and are the same.
"""

import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np

import peelkit


def run(scene: peelkit.Scene) -> peelkit.Peel:
    return scene.run()


def test_a_result_comes_back_from_another_process(strip: peelkit.Scene, peel: peelkit.Peel) -> None:
    scenes = [strip, strip.with_("strip.length", "60 nm")]
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        found = list(pool.map(run, scenes))
    assert [one.scene for one in found] == scenes
    assert found[0].peak == peel.peak and found[0].limit_points == peel.limit_points
    for name in peel.curve:
        assert found[0].curve[name].tobytes() == peel.curve[name].tobytes(), name


def test_a_stored_result_has_its_summary_and_computes_its_states(peel: peelkit.Peel) -> None:
    again: peelkit.Peel = pickle.loads(pickle.dumps(peel))
    assert again.summary() == peel.summary() and repr(again) == repr(peel)
    for state, same in zip(peel.states(3), again.states(3), strict=True):
        assert all(np.array_equal(state[name], same[name]) for name in state)
        kept = pickle.loads(pickle.dumps(state))
        assert kept.force == state.force and np.array_equal(kept.x, state.x)
    assert again._repr_svg_() == peel._repr_svg_()
    assert [one.value for one in again.sensitivities()] == [one.value for one in peel.sensitivities()]


def test_a_test_and_a_curve_are_stored(strip: peelkit.Scene) -> None:
    test = strip.test()
    again = pickle.loads(pickle.dumps(test))
    assert again.summary() == test.summary() and np.array_equal(again.force, test.force)
    curve = pickle.loads(pickle.dumps(strip.run().curve))
    assert list(curve) == list(strip.run().curve)


def test_a_scene_takes_its_tables_along(tmp_path: Path) -> None:
    (tmp_path / "beam.csv").write_text("s_nm,width_nm,height_nm\n0,1,8\n50,1,9\n100,1,10\n", encoding="utf-8")
    path = tmp_path / "beam.toml"
    path.write_text(
        'profile = { table = "beam.csv", youngs_modulus = "2 GPa" }\n'
        'adhesion = { hamaker_constant = "1e-19 J", equilibrium_distance = "0.4 nm" }\n',
        encoding="utf-8",
    )
    scene = peelkit.Scene.read(path)
    stored = pickle.dumps(scene)
    (tmp_path / "beam.csv").unlink()
    assert pickle.loads(stored) == scene


def test_a_result_of_another_version_is_refused(peel: peelkit.Peel) -> None:
    kept = peel._native.kept()
    for damaged in [b"\x050.0.0" + kept[6:], kept[:40], b""]:
        try:
            peelkit._native.Peel(peel.scene._native, damaged)
        except peelkit.PeelkitError as error:
            assert "cannot be read" in error.found and "Run the scene again" in error.remedy
        else:
            raise AssertionError("a damaged result was read")


def test_a_stored_result_is_read_by_a_new_interpreter(tmp_path: Path, peel: peelkit.Peel) -> None:
    path = tmp_path / "peel.pickle"
    path.write_bytes(pickle.dumps(peel))
    program = "import pickle, sys; print(pickle.load(open(sys.argv[1], 'rb')).peak.force.hex())"
    done = subprocess.run([sys.executable, "-c", program, path], capture_output=True, text=True, check=True)
    assert peel.peak is not None and done.stdout.strip() == peel.peak.force.hex()
