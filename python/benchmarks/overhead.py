"""What a call costs beside the run: the time of `Scene.run()` less that of the computation itself, of many runs.

    python python/benchmarks/overhead.py

The computation itself is timed inside, where the interpreter is released. The smallest of many differences is
what the call costs on an idle machine; the median is what it costs on this one.
"""

from __future__ import annotations

import statistics
import time

import peelkit

RUNS = 300


def main() -> None:
    # as short a run as there is: its noise hides the call least
    scene = peelkit.Scene(
        strip=dict(length="100 nm", height="10 nm", youngs_modulus="2 GPa"),
        adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
        accuracy=dict(relative=1e-3),
        bounds=dict(points=2),
    )
    calls: dict[str, list[float]] = {
        "run, beside the computation": [],
        "summary, first": [],
        "curve, first": [],
        "peak": [],
        "with_": [],
    }
    for _ in range(RUNS):
        begin = time.perf_counter()
        peel = scene.run()
        whole = time.perf_counter() - begin
        begin = time.perf_counter()
        summary = peel.summary()
        calls["summary, first"].append(time.perf_counter() - begin)
        calls["run, beside the computation"].append(whole - summary["timing"]["solve_s"])
        begin = time.perf_counter()
        peel.curve
        calls["curve, first"].append(time.perf_counter() - begin)
        begin = time.perf_counter()
        peel.peak
        calls["peak"].append(time.perf_counter() - begin)
        begin = time.perf_counter()
        scene.with_("strip.length", "90 nm")
        calls["with_"].append(time.perf_counter() - begin)
    print(f"{'µs of ' + str(RUNS) + ' calls':<30} {'smallest':>10} {'median':>10}")
    for name, times in calls.items():
        print(f"{name:<30} {1e6 * min(times):>10.1f} {1e6 * statistics.median(times):>10.1f}")


if __name__ == "__main__":
    main()
