"""A sweep is the same whoever computes it, whatever happens meanwhile, and wherever it is kept.

::

    cases     0 1 | 2 3 | 4 5 | ...            a batch: neighbouring cases, all values of the last key first
    clients   a plain loop = threads = processes = a cluster of dask
    cluster   worker 1  #### x                 killed in the middle: its batches go to others
              worker 2  ################
              worker 3        ##########       joins later
    stores    .zarr = .parquet = memory        each batch whole, once, and only what is missing after an interruption

Parameters: the strip of 100 nm at a tolerance of 1e-3, its modulus and the angle of the pull; a seta of two tips, its angle; and
the same seta pulled at a rate, the rate. The reference is a plain loop over the scenes, and the table of the command
``peel sweep``. Expected: the same bits everywhere but for
`solve_time`. Why: what a cluster has computed should not be doubted because a machine of it was lost.
"""

from __future__ import annotations

import csv
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import peelkit
from peelkit._sweep.columns import columns_of

xarray = pytest.importorskip("xarray")

SCENES = Path(__file__).parents[2] / "scenes"
MODULI = [1.0, 1.5, 2.0, 2.5, 3.0, 3.5]
ANGLES = [60, 75, 90]
VARIED = {"strip.youngs_modulus": MODULI, "drive.angle": ANGLES}


@pytest.fixture(scope="module")
def scene() -> peelkit.Scene:
    return peelkit.Scene.read(SCENES / "strip-100nm.toml").with_("accuracy.relative", 1e-3)


@pytest.fixture(scope="module")
def serial(scene: peelkit.Scene) -> Any:
    return peelkit.sweep(scene, VARIED, ThreadPoolExecutor(1), batch=1)


def assert_same(found: Any, reference: Any) -> None:
    xarray.testing.assert_identical(found.drop_vars("solve_time"), reference.drop_vars("solve_time"))


def test_every_case_is_the_run_of_its_scene(scene: peelkit.Scene, serial: Any) -> None:
    for modulus in MODULI:
        for angle in ANGLES:
            peel = scene.with_({"strip.youngs_modulus": modulus, "drive.angle": angle}).run()
            row = serial.sel({"strip.youngs_modulus": modulus, "drive.angle": angle})
            summary = peel.summary()
            assert row.peak_force == summary["peak"]["force_nN"]
            assert row.peak_force_error == summary["peak"]["error_nN"]
            assert row.snap_off_displacement == summary["snap_off"]["displacement_nm"]
            assert row.work == summary["snap_off"]["work_aJ"]
            assert row.work_to == "first jump"
            assert row.end == peel.end


def test_variables_have_units_and_error_bounds(serial: Any) -> None:
    assert serial.peak_force.dims == ("strip.youngs_modulus", "drive.angle")
    assert serial.peak_force.attrs == {"units": "nN", "long_name": "force at the peak"}
    assert serial["strip.youngs_modulus"].attrs["units"] == "GPa"
    assert serial["drive.angle"].attrs["units"] == "deg"
    assert all("units" in serial[name].attrs for name in serial.variables)
    assert bool((serial.peak_force_error < 1e-3 * serial.peak_force).all())


def test_threads_and_processes_give_the_same(scene: peelkit.Scene, serial: Any) -> None:
    assert_same(peelkit.sweep(scene, VARIED), serial)
    assert_same(peelkit.sweep(scene, VARIED, ThreadPoolExecutor(3), batch=5), serial)
    with ProcessPoolExecutor(2, get_context("spawn")) as processes:
        assert_same(peelkit.sweep(scene, VARIED, processes, batch=4), serial)


@dataclass(frozen=True)
class Kind:
    """What a scene describes, varied: the scene, what is set in it, the key, and its values in the unit of the key."""

    subject: str
    file: str
    values: dict[str, Any]
    key: str
    unit: str
    few: list[float]
    many: tuple[float, float]

    def scene(self) -> peelkit.Scene:
        return peelkit.Scene.read(SCENES / self.file).with_(self.values)


KINDS = [
    Kind("peel", "strip-100nm.toml", {"accuracy.relative": 1e-3}, "strip.length", "nm", [90, 100, 110.5], (90, 110)),
    Kind("seta", "seta.toml", {"seta.forks": 1}, "seta.shaft_angle", "deg", [0, 7.5, 30], (0, 30)),
    Kind("rate", "seta-at-a-rate.toml", {"seta.forks": 1}, "time.rate", "mm/s", [5, 10, 12.5], (5, 15)),
    Kind("rate", "strip-at-a-rate.toml", {"time.displacement": "2 nm"}, "strip.length", "nm", [90, 100], (90, 110)),
]
each_kind = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.file)


@each_kind
def test_the_table_of_the_command_is_the_same(kind: Kind, executable: Path, tmp_path: Path) -> None:
    values = ",".join(map(str, kind.few)) + f" {kind.unit}"
    command = [str(executable.resolve()), "sweep", str(SCENES / kind.file), "--vary", kind.key, "--values", values]
    sets = [word for key, value in kind.values.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([*command, *sets, "--out", "out"], cwd=tmp_path, check=True)
    with open(tmp_path / "out/sweep.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    scene, columns = kind.scene(), columns_of(kind.subject)
    found = peelkit.sweep(scene, {kind.key: [f"{value} {kind.unit}" for value in kind.few]})
    assert list(found.data_vars) == [column.name for column in columns]
    for column in columns:
        if column.name != "solve_time":
            expected = [row[column.source] if column.is_text else float(row[column.source] or "nan") for row in rows]
            np.testing.assert_array_equal(found[column.name], expected, column.name)


@each_kind
def test_every_kind_is_the_same_on_threads_and_processes(kind: Kind) -> None:
    varied = {kind.key: kind.few}
    reference = peelkit.sweep(kind.scene(), varied, ThreadPoolExecutor(1), batch=1)
    assert "failed" not in reference.end.values
    assert_same(peelkit.sweep(kind.scene(), varied, ThreadPoolExecutor(2), batch=2), reference)
    with ProcessPoolExecutor(2, get_context("spawn")) as processes:
        assert_same(peelkit.sweep(kind.scene(), varied, processes, batch=1), reference)


@pytest.mark.filterwarnings("default")
def test_every_kind_is_the_same_on_a_cluster() -> None:
    distributed = pytest.importorskip("distributed")
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        for kind in KINDS:
            varied = {kind.key: kind.few}
            found = peelkit.sweep(kind.scene(), varied, client, batch=1)
            assert_same(found, peelkit.sweep(kind.scene(), varied, ThreadPoolExecutor(1)))


def test_a_seta_or_a_rate_of_a_sweep_is_the_run_of_its_scene() -> None:
    seta, rate = KINDS[1], KINDS[2]
    row = peelkit.sweep(seta.scene(), {seta.key: [7.5]}).isel({seta.key: 0})
    pulled = seta.scene().with_(seta.key, 7.5).pull_off().summary()
    assert row.peak_force == pulled["peak"]["force_nN"] and row.peak_force_error > 0.0
    assert row.end == pulled["end"] == "detached" and row.peak_force.attrs["units"] == "nN"
    row = peelkit.sweep(rate.scene(), {rate.key: [12.5]}).isel({rate.key: 0})
    pulled_at = rate.scene().with_(rate.key, 12.5).pull_at_rate().summary()
    assert row.largest_force == pulled_at["largest_force"]["force_nN"]
    assert row.contact_lost == pulled_at["contact_lost_s"] and row.contact_lost.attrs["units"] == "s"


def test_values_are_numbers_texts_or_quantities(scene: peelkit.Scene) -> None:
    heights = peelkit.sweep(scene, {"strip.height": ["9 nm", 10.0]})
    assert list(heights["strip.height"].values) == [9.0, 10.0]
    # a text in another unit that the key takes is a number in the usual one, with the bits that the command reads
    others = peelkit.sweep(scene, {"strip.height": ["0.009 um", "10 nm"]})
    assert_same(others, heights)
    assert list(peelkit.sweep(scene, {"drive.angle": ["60 deg", "1.5 rad"]})["drive.angle"].values) == [
        60.0,
        pytest.approx(np.degrees(1.5), rel=1e-15),
    ]
    with pytest.raises(peelkit.SceneError, match="not a number with its unit"):
        peelkit.sweep(scene, {"strip.height": ["9 N"]})
    words = peelkit.sweep(scene, {"grip.rotation": ["free", "fixed"]})
    assert words.peak_force.sel({"grip.rotation": "free"}) != words.peak_force.sel({"grip.rotation": "fixed"})
    pint = pytest.importorskip("pint")
    quantities = pint.UnitRegistry().Quantity([9.0, 10.0], "nm")
    assert_same(peelkit.sweep(scene, {"strip.height": quantities}), heights)


def test_what_is_no_sweep_is_refused(scene: peelkit.Scene, tmp_path: Path) -> None:
    def refused(part: str, varied: dict[str, Any], **options: Any) -> None:
        with pytest.raises(peelkit.PeelkitError, match=part):
            peelkit.sweep(scene, varied, **options)

    refused("varies no key", {})
    refused("strip.lenght", {"strip.lenght": [1.0]})
    refused("no list of values", {"strip.length": "100 nm"})
    refused("no value", {"strip.length": []})
    refused("strip.height", {"strip.height": [10.0, -1.0]})
    refused("neither Zarr nor Parquet", {"strip.length": [100.0]}, store=tmp_path / "a.csv")
    refused("which runs no batches", {"strip.length": [100.0]}, client="here")
    with pytest.raises(peelkit.PeelkitError, match="no store of a sweep"):
        peelkit.read_sweep(tmp_path / "none.zarr")


def test_what_cannot_be_computed_is_a_row_with_its_end(scene: peelkit.Scene) -> None:
    cut = peelkit.sweep(scene.with_("bounds.points", 5), {"strip.length": [100.0]})
    assert cut.end.item() == "bound" and np.isnan(cut.snap_off_force) and cut.work_to.item() == "end of path"
    # of two keys one value may be right only beside another
    pairs = peelkit.sweep(scene, {"strip.height": [10.0, -1.0], "strip.length": [100.0]})
    assert list(pairs.end.values.ravel()) == ["pivoting", "refused"]
    assert np.isnan(pairs.peak_force.values[1, 0])


@pytest.mark.parametrize("suffix", ["zarr", "parquet"])
def test_a_store_gives_back_what_was_computed(scene: peelkit.Scene, serial: Any, tmp_path: Path, suffix: str) -> None:
    store = tmp_path / f"sweep.{suffix}"
    found = peelkit.sweep(scene, VARIED, store=store, batch=4)
    assert_same(found, serial)
    xarray.testing.assert_identical(peelkit.read_sweep(store), found)
    # nothing is computed again
    xarray.testing.assert_identical(peelkit.sweep(scene, VARIED, store=store), found)
    if suffix == "zarr":
        with xarray.open_zarr(store, chunks=None) as table:
            np.testing.assert_array_equal(table.peak_force, serial.peak_force.values.ravel())
            np.testing.assert_array_equal(table["drive.angle"], np.tile(ANGLES, len(MODULI)))
            assert table.peak_force.attrs["units"] == "nN"
    else:
        table = pytest.importorskip("pandas").read_parquet(store)
        np.testing.assert_array_equal(table.peak_force, serial.peak_force.values.ravel())
        np.testing.assert_array_equal(table.case, np.arange(len(table)))


class Interrupting(Executor):
    """Computes at once, and counts; interrupts as Ctrl-C does."""

    def __init__(self, at: int | None = None) -> None:
        self.at = at
        self.starts: list[int] = []
        self.inner = ThreadPoolExecutor(1)

    def submit(self, work: Any, batch: Any) -> Any:  # type: ignore[override]
        if len(self.starts) == self.at:
            raise KeyboardInterrupt
        self.starts.append(batch.start)
        future = self.inner.submit(work, batch)
        future.exception()
        return future


@pytest.mark.parametrize("suffix", ["zarr", "parquet"])
def test_an_interrupted_sweep_computes_what_is_missing(
    scene: peelkit.Scene, serial: Any, tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    store = tmp_path / f"sweep.{suffix}"
    first, second = Interrupting(at=6), Interrupting()
    with pytest.raises(KeyboardInterrupt):
        peelkit.sweep(scene, VARIED, first, store=store, batch=2)
    there = peelkit.read_sweep(store).end.values.ravel() != ""
    assert 0 < there.sum() < there.size
    assert_same(peelkit.sweep(scene, VARIED, second, store=store), serial)
    assert sorted(second.starts) == [start for start in range(0, there.size, 2) if not there[start]]


SWEPT = """
import sys, numpy, peelkit
scene, store, key, first, last = sys.argv[1:]
varied = {key: numpy.linspace(float(first), float(last), 200)}
peelkit.sweep(peelkit.Scene.from_toml(scene), varied, store=store, batch=2)
"""


@pytest.mark.parametrize("kind", KINDS[:3], ids=lambda kind: kind.file)
@pytest.mark.parametrize("suffix", ["zarr", "parquet"])
def test_a_killed_sweep_goes_on(kind: Kind, tmp_path: Path, suffix: str) -> None:
    """Killed at once, wherever it is, as often as it takes: what is there is whole, and what is missing is computed."""
    store, kills = tmp_path / f"sweep.{suffix}", 0
    scene = peelkit.Scene.from_toml(kind.scene().to_toml())
    started = "batch-*" if suffix == "parquet" else "newton_iterations/*"
    arguments = [scene.to_toml(), str(store), kind.key, *map(str, kind.many)]
    for _ in range(3):
        before = len(list(store.glob(started)))
        with subprocess.Popen([sys.executable, "-c", SWEPT, *arguments]) as child:
            while len(list(store.glob(started))) < before + 5 and child.poll() is None:
                time.sleep(0.001)
            kills += child.poll() is None
            child.kill()
    ends = peelkit.read_sweep(store).end.values
    assert kills > 0 and 0 < (ends != "").sum() < 200
    varied = {kind.key: np.linspace(*kind.many, 200)}
    assert_same(peelkit.sweep(scene, varied, store=store), peelkit.sweep(scene, varied))


@pytest.mark.parametrize("suffix", ["zarr", "parquet"])
def test_the_store_of_another_sweep_is_refused(scene: peelkit.Scene, tmp_path: Path, suffix: str) -> None:
    store = tmp_path / f"sweep.{suffix}"
    few = {"strip.length": [90.0, 100.0]}
    peelkit.sweep(scene, few, store=store)

    def refused(part: str, scene: peelkit.Scene, varied: dict[str, Any]) -> None:
        with pytest.raises(peelkit.PeelkitError, match=part):
            peelkit.sweep(scene, varied, store=store)

    refused("value 2 100.0 in it, and 101.0", scene, {"strip.length": [90.0, 101.0]})
    refused("2 values in it, and 3", scene, {"strip.length": [90.0, 100.0, 101.0]})
    refused("varies strip.length", scene, {"strip.height": [9.0, 10.0]})
    refused("angle", scene.with_("drive.angle", 80), few)
    (tmp_path / f"mine.{suffix}").mkdir()
    (tmp_path / f"mine.{suffix}" / "notes.txt").write_text("mine")
    with pytest.raises(peelkit.PeelkitError, match="no store of a sweep"):
        peelkit.sweep(scene, few, store=tmp_path / f"mine.{suffix}")
    assert (tmp_path / f"mine.{suffix}" / "notes.txt").read_text() == "mine"


def test_a_lost_process_is_said_and_what_was_done_is_kept(scene: peelkit.Scene, tmp_path: Path) -> None:
    store = tmp_path / "sweep.parquet"
    with ProcessPoolExecutor(1, get_context("spawn")) as processes:
        processes.submit(os.getpid).result()
        killer = threading.Thread(target=_kill_when, args=(store, 3, lambda: list(processes._processes or {})))
        killer.start()
        with pytest.raises(peelkit.PeelkitError, match="lost a worker"):
            peelkit.sweep(scene, {"strip.length": np.linspace(90, 110, 200)}, processes, store=store, batch=2)
        killer.join()
    assert 6 <= (peelkit.read_sweep(store).end != "").sum() < 200


def test_an_executor_that_is_broken_already_is_named(scene: peelkit.Scene) -> None:
    with ProcessPoolExecutor(1, get_context("spawn")) as processes:
        with pytest.raises(BrokenProcessPool):
            processes.submit(os._exit, 1).result()
        with pytest.raises(peelkit.PeelkitError, match="lost a worker"):
            peelkit.sweep(scene, {"strip.length": [90.0, 100.0]}, processes)


def _kill_when(store: Path, batches: int, pids: Callable[[], list[int]]) -> None:
    """Kills processes as soon as so many batches are in the store."""
    deadline = time.monotonic() + 120
    while len(list(store.glob("batch-*"))) < batches and time.monotonic() < deadline:
        time.sleep(0.005)
    for pid in pids():
        os.kill(pid, signal.SIGKILL)


@pytest.mark.filterwarnings("default")
def test_a_cluster_loses_a_worker_and_gains_one(scene: peelkit.Scene, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    varied = {"strip.length": np.linspace(90, 110, 150), "drive.angle": [80.0, 90.0]}
    reference = peelkit.sweep(scene, varied, ThreadPoolExecutor(1))
    store = tmp_path / "sweep.parquet"
    options = {"n_workers": 2, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        first = set(client.scheduler_info(n_workers=-1)["workers"])
        killed = [next(iter(cluster.workers.values())).pid]

        def disturb() -> None:
            _kill_when(store, 10, lambda: killed)
            cluster.scale(3)

        disturbance = threading.Thread(target=disturb)
        disturbance.start()
        found = peelkit.sweep(scene, varied, client, store=store, batch=3)
        disturbance.join()
        assert len(list(store.glob("batch-*"))) == 100
        assert not Path(f"/proc/{killed[0]}/stat").exists() or killed[0] not in [
            nanny.pid for nanny in cluster.workers.values()
        ]
        client.wait_for_workers(3, timeout=60)
        assert set(client.scheduler_info(n_workers=-1)["workers"]) - first
    assert_same(found, reference)
    cases = pytest.importorskip("pandas").read_parquet(store).case
    np.testing.assert_array_equal(np.sort(cases), np.arange(300))
