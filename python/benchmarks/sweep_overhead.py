"""What a sweep costs beside the computation of its scenes.

::

    a scene     with_(values)  +  run  +  row           in one thread, CPU time
    a batch     handed to a worker and taken back       of each client, with work that computes nothing
                kept in a store                         Zarr, Parquet
    a sweep     CPU time of all processes a case    against that of its path

Run as ``python benchmarks/sweep_overhead.py``. CPU times hardly depend on what else the machine does; wall clocks do.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import psutil
import xarray  # noqa: F401 - loaded before anything is measured

import peelkit
from peelkit._sweep.batch import Batch, compute_case, table
from peelkit._sweep.clients import computed
from peelkit._sweep.columns import refused_row, row_of
from peelkit._sweep.grid import Grid
from peelkit._sweep.store import Plan, open_store

SCENE = Path(__file__).parents[2] / "scenes/strip-100nm.toml"
WORKERS = 2
#: Cases of a batch that computes nothing.
CASES = 50


def nothing(batch):
    """Results of the size of a batch, at once."""
    return table([refused_row()] * len(batch.values))


def thread_time(work, times):
    """CPU seconds of this thread a call."""
    started = time.thread_time()
    for index in range(times):
        work(index)
    return (time.thread_time() - started) / times


@contextmanager
def client(name):
    """A client with two workers; no other one is there meanwhile, since idle workers take time as well."""
    if name == "threads":
        with ThreadPoolExecutor(WORKERS) as executor:
            yield executor
    elif name == "processes":
        with ProcessPoolExecutor(WORKERS, get_context("spawn")) as executor:
            yield executor
    else:
        import distributed

        options = {"n_workers": WORKERS, "threads_per_worker": 1, "processes": True, "dashboard_address": None}
        with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as dask:
            yield dask


def scenes(scene):
    """CPU milliseconds of the parts of a case."""
    peel = scene.run()
    parts = {
        "scene with values": thread_time(lambda i: scene.with_({"strip.length": 100.0 + i, "drive.angle": 90}), 500),
        "path": thread_time(lambda i: scene.with_({"strip.length": 100.0 + i}).run(), 30),
        "row": thread_time(lambda i: row_of(scene.with_({"strip.length": 100.0 + i})._native.run()), 30),
        "case": thread_time(lambda i: compute_case(scene, ("strip.length",), (100.0 + i,)), 30),
        "row again": thread_time(lambda i: row_of(peel._native), 300),
    }
    for name, seconds in parts.items():
        print(f"a scene    {name:24} {1e3 * seconds:9.3f} ms CPU")


def batches(scene, name, client, count):
    """Milliseconds of a batch that computes nothing; the workers have loaded the package before."""
    values = tuple((100.0 + i, 90) for i in range(CASES))
    text = scene.to_toml()
    for number in (20, count):
        many = (Batch(i * CASES, text, "a", ("strip.length", "drive.angle"), values) for i in range(number))
        wall, cpu = time.perf_counter(), time.process_time()
        assert sum(1 for _ in computed(client, nothing, many)) == number
        wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    print(
        f"a batch    {name:24} {1e3 * wall / number:9.3f} ms wall {1e3 * cpu / number:9.3f} ms CPU of the coordinator"
    )


def stores(scene, count):
    """Milliseconds to keep a batch."""
    lengths = np.linspace(90, 110, CASES * count)
    results = table([refused_row()] * CASES)
    for suffix in ("zarr", "parquet"):
        with tempfile.TemporaryDirectory() as folder:
            store = open_store(
                Path(folder) / f"a.{suffix}",
                Plan("", "a", Grid.of(scene, {"strip.length": lengths[:1], "strip.height": lengths}), CASES),
            )
            wall, cpu = time.perf_counter(), time.process_time()
            for index in range(count):
                store.keep(index, results)
            wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
            size = sum(file.stat().st_size for file in Path(folder).rglob("*") if file.is_file()) / count / CASES
        print(
            f"a batch    {suffix:24} {1e3 * wall / count:9.3f} ms wall {1e3 * cpu / count:9.3f} ms CPU, {size:.0f} bytes a case"
        )


def cpu_seconds():
    """Of this process and those that it has started."""
    children = psutil.Process().children(recursive=True)
    times = [process.cpu_times() for process in [psutil.Process(), *children] if process.is_running()]
    return sum(of.user + of.system for of in times)


def paths(scene, count):
    """CPU seconds of a path that is computed and dropped, on as many threads as a sweep has workers.

    All threads of the process count: a path uses some of its own.
    """
    natives = [scene.with_("strip.length", length)._native for length in np.linspace(90, 110, count)]
    started = time.process_time()
    with ThreadPoolExecutor(WORKERS) as executor:
        for _ in executor.map(lambda native: native.run() and None, natives):
            pass
    return (time.process_time() - started) / count


def sweep(scene, name, client, count):
    """The CPU time of a sweep in all of its processes against that of its paths, measured before and after."""
    lengths = np.linspace(90, 110, count)
    # the first one of a process loads packages
    started = time.perf_counter()
    peelkit.sweep(scene, {"strip.length": lengths[:4]}, client, batch=1)
    first = time.perf_counter() - started
    before = paths(scene, count)
    wall, cpu = time.perf_counter(), cpu_seconds()
    peelkit.sweep(scene, {"strip.length": lengths}, client)
    wall, cpu = time.perf_counter() - wall, (cpu_seconds() - cpu) / count
    path = (before + paths(scene, count)) / 2
    print(
        f"a sweep    {name:24} {1e3 * path:9.3f} ms CPU a path {1e3 * cpu:9.3f} ms CPU a case: "
        f"{100 * (cpu / path - 1):.1f} % more; "
        f"{count} cases in {wall:.1f} s; a first sweep of 4 {first:.2f} s"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", type=Path, default=SCENE)
    parser.add_argument("--cases", type=int, default=400, help="cases of a sweep")
    parser.add_argument("--batches", type=int, default=300, help="batches that compute nothing")
    arguments = parser.parse_args()
    scene = peelkit.Scene.read(arguments.scene)
    scenes(scene)
    stores(scene, 50)
    for name in ("threads", "processes", "dask"):
        with client(name) as workers:
            batches(scene, name, workers, arguments.batches)
            sweep(scene, name, workers, arguments.cases)


if __name__ == "__main__":
    main()
