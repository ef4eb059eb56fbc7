"""How long Ctrl-C takes to end a computation: from the signal to the KeyboardInterrupt, in ms.

python python/benchmarks/interrupt.py
"""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable

import peelkit

TRIES = 8


def delay(call: Callable[[], object]) -> float:
    """From the signal to the exception, s."""
    sent = [0.0]

    def interrupt() -> None:
        # once it computes
        time.sleep(0.3)
        sent[0] = time.perf_counter()
        os.kill(os.getpid(), signal.SIGINT)

    other = threading.Thread(target=interrupt)
    other.start()
    try:
        call()
    except KeyboardInterrupt:
        return time.perf_counter() - sent[0]
    finally:
        other.join()
    raise RuntimeError("the computation ended before it was interrupted: take a longer strip")


def main() -> None:
    scene = peelkit.Scene(
        strip=dict(length="4 um", height="10 nm", youngs_modulus="2 GPa"),
        adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
        accuracy=dict(relative=1e-9),
        bounds=dict(time=3600.0, points=1_000_000),
    )
    height = dict(key="strip.height", distribution="normal", deviation="0.5 nm")
    sampled = scene.with_({"accuracy.relative": 1e-6, "uncertainty.inputs": [height]})
    calls: dict[str, Callable[[], object]] = {
        "run": scene.run,
        "test": scene.test,
        "uncertainty": lambda: peelkit.uncertainty(sampled),
    }
    for name, call in calls.items():
        print(f"{name:<12}", " ".join(f"{1e3 * delay(call):.0f}" for _ in range(TRIES)))


if __name__ == "__main__":
    main()
