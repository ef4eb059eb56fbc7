"""A computation leaves the interpreter to others: threads run beside it, and Ctrl-C stops it.

Reference: computations that take minutes together. Expected: another thread counts meanwhile; a signal ends the run with
KeyboardInterrupt; threads find the same as one alone.
"""

import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import peelkit

# again and again: no single computation need take long
LONG = """
import peelkit, sys
scene = peelkit.Scene(
    strip=dict(length="4 um", height="10 nm", youngs_modulus="2 GPa"),
    adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
    accuracy=dict(relative=1e-9),
    bounds=dict(time=3600.0, points=1_000_000),
)
print("ready", flush=True)
try:
    for _ in range(100_000):
        {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""

ANALYSES = {
    "run": "scene.run()",
    "test": "scene.test()",
    "path": "[point for point in scene.path(elements=400, step_tolerance=1e-6)]",
    "uncertainty": "peelkit.uncertainty(scene.with_({'accuracy.relative': 1e-6, 'uncertainty.inputs': "
    "[dict(key='strip.height', distribution='normal', deviation='0.5 nm')]}))",
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent otherwise there")
@pytest.mark.skipif(signal.getsignal(signal.SIGINT) is signal.SIG_IGN, reason="Ctrl-C is ignored, as by nohup")
@pytest.mark.parametrize("call", ANALYSES.values(), ids=ANALYSES)
def test_ctrl_c_stops_a_computation(call: str) -> None:
    program = LONG.format(call=call)
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "ready\n"
        # until it computes; where it does not yet, Python itself hears the signal at the same place
        try:
            child.wait(0.5)
        except subprocess.TimeoutExpired:
            child.send_signal(signal.SIGINT)
        out, _ = child.communicate(timeout=60)
    assert out == "interrupted\n"


def test_other_threads_run_meanwhile(strip: peelkit.Scene) -> None:
    """A thread of Python counts while another one computes, which it could not if the lock were held."""
    ended, counted = threading.Event(), 0

    def count() -> None:
        nonlocal counted
        while not ended.wait(1e-4):
            counted += 1

    counter = threading.Thread(target=count)
    counter.start()
    # as many runs as a busy machine needs to let the other thread count; with the lock held it would count once between two
    runs = 0
    while counted <= runs + 3 and runs < 1000:
        strip.run()
        runs += 1
    ended.set()
    counter.join()
    assert counted > runs + 3


def test_threads_find_the_same(strip: peelkit.Scene) -> None:
    scenes = [strip.with_("strip.length", length) for length in (60.0, 80.0, 100.0, 120.0)]
    alone = [scene.run() for scene in scenes]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda scene: scene.run(), scenes))
    for one, other in zip(alone, together):
        assert one.curve.force.tobytes() == other.curve.force.tobytes()
        assert one.peak == other.peak


def test_a_path_that_is_left_ends_its_thread(strip: peelkit.Scene) -> None:
    for _ in range(50):
        path = strip.path()
        next(path)
        del path
    threads = Path("/proc/self/task")
    if threads.exists():
        for _ in range(100):
            if len(list(threads.iterdir())) < 40:
                break
            threading.Event().wait(0.05)
        assert len(list(threads.iterdir())) < 40
