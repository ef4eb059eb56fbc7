"""Where batches are computed: threads of this process, an executor of `concurrent.futures`, or a cluster of dask."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from itertools import islice
from typing import TYPE_CHECKING, Any

from ..errors import PeelkitError
from .batch import Batch, Table

if TYPE_CHECKING:
    from distributed import Client

__all__ = ["computed", "workers"]

#: Batches that wait at each core, so that no core waits for one.
WAITING = 2
#: From one look at the cores of a cluster to the next, s: workers come and go.
LOOK = 1.0

Work = Callable[[Batch], Table]


def computed(client: Executor | Client | None, work: Work, batches: Iterator[Batch]) -> Iterator[tuple[Batch, Table]]:
    """Every batch with its results, in the order in which they are done; each once.

    Raises
    ------
    PeelkitError
        Where the client is none, or has lost its workers.
    """
    if client is None:
        return _on_threads(work, batches)
    if isinstance(client, Executor):
        return _on_executor(client, work, batches)
    if _is_dask(client):
        return _on_dask(client, work, batches)
    raise PeelkitError(
        f"client is a {type(client).__name__}, which runs no batches",
        "Give None for all cores, an executor of concurrent.futures, or a dask.distributed.Client.",
    )


def workers(client: Executor | Client | None) -> int:
    """How many batches are computed at a time."""
    if client is not None and not isinstance(client, Executor) and _is_dask(client):
        cores: dict[str, int] = client.ncores()
        return max(1, sum(cores.values()))
    known: int | None = getattr(client, "_max_workers", None)
    return known or os.cpu_count() or 1


def _is_dask(client: Any) -> bool:
    return any(base.__module__.split(".")[0] == "distributed" for base in type(client).__mro__)


def _on_threads(work: Work, batches: Iterator[Batch]) -> Iterator[tuple[Batch, Table]]:
    """Runs release the interpreter, so threads use all cores."""
    with ThreadPoolExecutor(os.cpu_count()) as executor:
        yield from _on_executor(executor, work, batches)


def _on_executor(executor: Executor, work: Work, batches: Iterator[Batch]) -> Iterator[tuple[Batch, Table]]:
    running: dict[Future[Table], Batch] = {}
    window = (1 + WAITING) * workers(executor)
    try:
        while True:
            for batch in islice(batches, window - len(running)):
                with _workers_are_there():
                    running[executor.submit(work, batch)] = batch
            if not running:
                return
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                with _workers_are_there():
                    found = future.result()
                yield running.pop(future), found
    finally:
        # after an error or Ctrl-C nothing more is begun
        for future in running:
            future.cancel()


@contextmanager
def _workers_are_there() -> Iterator[None]:
    """Says what to do where an executor has lost a worker: where it is given a batch or asked for one."""
    from concurrent.futures import BrokenExecutor

    try:
        yield
    except BrokenExecutor as error:
        raise PeelkitError(
            f"the executor has lost a worker: {error}",
            "Give a new executor; with store=... the sweep goes on where it stopped.",
        ) from error


def _on_dask(client: Client, work: Work, batches: Iterator[Batch]) -> Iterator[tuple[Batch, Table]]:
    """Batches of a worker that is lost are computed by another one: dask sees to that."""
    from distributed import KilledWorker, as_completed

    running: dict[Any, tuple[Batch, Any]] = {}
    done = as_completed(with_results=True)
    window, looked = 0, float("-inf")
    try:
        while True:
            if time.monotonic() - looked > LOOK:
                window, looked = (1 + WAITING) * workers(client), time.monotonic()
            for batch in islice(batches, max(0, window - len(running))):
                # a key of its own: what another sweep has left on the cluster is another result
                future = client.submit(work, batch, pure=False)
                running[future.key] = (batch, future)
                done.add(future)
            if not running:
                return
            try:
                future, found = next(done)
            except KilledWorker as error:
                raise PeelkitError(
                    f"the cluster has lost every worker that began a batch: {error}",
                    "Look into the logs of the workers: memory, most likely. With store=... the sweep goes on where it stopped.",
                ) from error
            batch, _ = running.pop(future.key)
            future.release()
            yield batch, found
    finally:
        for _, future in running.values():
            future.cancel()
