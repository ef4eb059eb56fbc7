"""Holds builds of `peel` against each other, or one build under several settings of the machine: every number of summary.json.

    cargo build --release
    cargo build --release --features portable --target-dir target/portable
    RUSTFLAGS="-C target-cpu=native" cargo build --release --features portable --target-dir target/native
    python3 verification/repeat.py target/release/peel target/portable/release/peel target/native/release/peel \
        "env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-AVX512F,-FMA target/release/peel"

Each command runs the scenes of scenes/ and scenes/hard at 1e-6 and at 1e-9, and is held against the first. Told are how many numbers
differ in any bit, and, of those with an error bound, which differ by more than both bounds. The last command is of another kind: the C
library's sine and power of a processor without fused multiply-add. Standard library only. Exit status 1 where one is outside, or where
one run has a number that the other has not; bending-1e-6 is told and not counted: its plateau ripples by 1e-8 of the force, and at 1e-9
turning points come and go on it.
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys

SCENES = pathlib.Path(__file__).parent.parent / "scenes"
SLOW = {"hamaker-1e3", "r0-small", "unshearable"}                          # seconds each, two of them refusals
RIPPLES = "bending-1e-6"
ACCURACIES = ("1e-6", "1e-9")
BOUNDS = {"force_nN": "error_nN", "displacement_nm": "error_nm"}


def summary(command, scene, relative):
    words = shlex.split(command) + ["run", str(scene), "--set", f"accuracy.relative={relative}", "--json"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    found = json.loads(done.stdout)
    del found["timing"]
    return found


def numbers(found, path=""):
    """Path -> (value, error bound or none), whatever stands in the object."""
    items = found.items() if isinstance(found, dict) else enumerate(found)
    for key, value in items:
        if isinstance(value, (dict, list)):
            yield from numbers(value, f"{path}.{key}")
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            bound = found.get(BOUNDS.get(key)) if isinstance(found, dict) else None
            yield f"{path}.{key}"[1:], (value, bound)


class Held:
    """What came of one command against the first."""

    def __init__(self):
        self.count = self.differ = self.bounded = self.missing = 0
        self.share = 0.0
        self.outside = []

    def add(self, name, one, other):
        one, other = dict(numbers(one)), dict(numbers(other))
        if not name.startswith(RIPPLES):
            self.missing += len(one.keys() ^ other.keys())
        for key in one.keys() & other.keys():
            (value, bound), (twin, twin_bound) = one[key], other[key]
            self.count += 1
            self.differ += value != twin
            if bound is None:
                continue
            self.bounded += 1
            share = abs(value - twin) / (bound + twin_bound)
            self.share = max(self.share, share)
            if share > 1:
                self.outside.append(f"{name}, {key}: {value} +- {bound:.0e} and {twin} +- {twin_bound:.0e}")


options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
options.add_argument("commands", nargs="+", metavar="PEEL", help="a command, with its environment if need be; the first is the reference")
options.add_argument("--all", action="store_true", help=f"the slow scenes as well: {', '.join(sorted(SLOW))}")
options = options.parse_args()

scenes = [scene for scene in sorted(SCENES.rglob("*.toml")) if options.all or scene.stem not in SLOW]
held = {command: Held() for command in options.commands[1:]}
for scene in scenes:
    for relative in ACCURACIES:
        reference = summary(options.commands[0], scene, relative)
        for command, result in held.items():
            result.add(f"{scene.stem} at {relative}", reference, summary(command, scene, relative))
print(f"{len(scenes)} scenes at {' and '.join(ACCURACIES)}; reference: {options.commands[0]}")
for command, result in held.items():
    print(f"{command}: {result.differ} of {result.count} numbers differ; of {result.bounded} with a bound {len(result.outside)} by more than both, "
          f"at most by {result.share:.2g} of them; {result.missing} numbers in one run alone")
    for line in result.outside:
        print("   ", line)
sys.exit(any(result.missing or any(not line.startswith(RIPPLES) for line in result.outside) for result in held.values()))
