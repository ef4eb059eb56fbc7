"""Whether two builds of the command write the same files.

    python3 tests/same_outputs.py write target/release/peel out/before      every command, each into a folder of its own
    python3 tests/same_outputs.py compare out/before out/after              what differs, and how; exit status 1 if anything does

What a run prints and its exit status are kept beside its files. Computing times and the version are masked, nothing else: all that is
compared is compared byte for byte. `--only WORD` writes the runs whose name contains the word.
"""

import argparse
import concurrent.futures
import difflib
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

STRIP = "scenes/strip-100nm.toml"

# Runs of the other commands, and of the flags of `run`. Every scene of scenes/ is run as it stands besides.
COMMANDS = {
    "run-states": f"run {STRIP} --states 3 --animate",
    "run-json": f"run {STRIP} --json",
    "run-observed": f"run {STRIP} --observed",
    "run-observed-soft": "run scenes/strip-soft.toml --observed",
    "run-at": f"run {STRIP} --at u='30 nm' --at P='0.04 nN' --at front='50 nm' --at end_rotation='30 deg'",
    "run-out-of-plane": f"run {STRIP} --out-of-plane --set strip.width='40 nm'",
    "run-branch": f"run {STRIP} --branch --set strip.width='40 nm'",
    "run-sensitivities": f"run {STRIP} --sensitivities",
    "run-cut-short": f"run {STRIP} --set bounds.points=20",
    "run-refused": f"run {STRIP} --set strip.height='-1 nm'",
    "run-units": "run scenes/tape.toml --units mm,N",
    "run-space-states": "run scenes/strip-sideways.toml --states 2 --set bounds.points=60",
    "run-seta-states": "run scenes/seta.toml --states 3",
    "run-seta-json": "run scenes/seta.toml --json --set seta.forks=2",
    "run-rate-json": "run scenes/strip-at-a-rate.toml --json",
    "sweep": f"sweep {STRIP} --vary strip.bending_stiffness_factor --from 1e-2 --to 1e2 --points 5 --log",
    "sweep-json": f"sweep {STRIP} --vary strip.height --values '5 nm,10 nm' --json",
    "sweep-plane": f"sweep {STRIP} --vary strip.length --values '50 nm,100 nm' --vary strip.height --values '5 nm,10 nm,20 nm'",
    "sweep-peak-only": f"sweep {STRIP} --vary drive.angle --values '30 deg,60 deg,90 deg' --peak-only",
    "sweep-follow": f"sweep {STRIP} --vary strip.bending_stiffness_factor --from 1 --to 10 --points 10 --log --follow snap-off",
    "sweep-seta": "sweep scenes/seta.toml --set seta.forks=2 --vary seta.shaft_angle --values '0 deg,30 deg'",
    "sweep-seta-plane": "sweep scenes/seta.toml --vary seta.forks --values '1,2' --vary seta.shaft_angle --values '0 deg,30 deg'",
    "sweep-rate": "sweep scenes/strip-at-a-rate.toml --vary time.rate --from '1 mm/s' --to '100 mm/s' --points 3 --log",
    "sweep-seta-rate": "sweep scenes/seta-at-a-rate.toml --vary time.rate --values '1 mm/s,10 mm/s'",
    "fit": "fit scenes/strip-fit.toml --data scenes/strip-fit.csv",
    "fit-json": "fit scenes/strip-fit.toml --data scenes/strip-fit.csv --json",
    "optimise": "optimise scenes/strip-optimised.toml",
    "optimise-height": "optimise scenes/strip-height-optimised.toml",
    "optimise-json": "optimise scenes/strip-optimised.toml --json",
    "uncertainty": "uncertainty scenes/strip-uncertain.toml --set uncertainty.samples=256",
    "uncertainty-json": "uncertainty scenes/strip-uncertain.toml --set uncertainty.samples=256 --json",
    "coarsen": "coarsen scenes/spatula.toml --set grip.horizontal=fixed",
    "coarsen-json": "coarsen scenes/spatula.toml --set grip.horizontal=fixed --json",
    "coarsen-rotation": "coarsen scenes/spatula.toml --tolerance 1e-2 --rotation='-0.1 rad,0.1 rad'",
    "keys": "keys",
    "keys-strip": "keys strip",
    "help-run": "run --help",
    "help-sweep": "sweep --help",
}

# What differs from run to run: computing times and versions.
COSTS = ("solve_s", "tip_s", "mesh_error_s", "equilibria_s")
MASKS = [
    (re.compile(rf'("(?:version|{"|".join(COSTS)})": )[^,\n]*'), r"\1-"),
    (re.compile(r"\b\d[\d.]* (?:ms|µs|s|min|h)\b"), "- s"),
]


def runs():
    found = {f"scene-{path.relative_to(ROOT / 'scenes').with_suffix('')}".replace("/", "-"): f"run {path.relative_to(ROOT)}"
             for path in sorted((ROOT / "scenes").rglob("*.toml"))}
    return found | COMMANDS


def write(peel, folder, only):
    peel, folder = pathlib.Path(peel).resolve(), pathlib.Path(folder).resolve()
    chosen = {name: words for name, words in runs().items() if only in name}

    def one(item):
        name, words = item
        arguments = shlex.split(words)
        at = folder / name
        at.mkdir(parents=True, exist_ok=True)
        if arguments[0] != "keys" and not {"--json", "--help"} & set(arguments):
            arguments += ["--out", "out", "--force"]
        for entry in ("scenes", "verification"):
            link = at / entry
            if not link.is_symlink():
                os.symlink(ROOT / entry, link)
        # the name as a user calls it, whatever the file of the build is called
        done = subprocess.run(["peel", *arguments], executable=peel, cwd=at, capture_output=True, check=False)
        (at / "printed").write_bytes(done.stdout)
        (at / "errors").write_bytes(done.stderr)
        (at / "status").write_text(f"{done.returncode}\n")
        return name, done.returncode

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for name, status in pool.map(one, chosen.items()):
            print(f"{name:36} {status}", flush=True)


def files(folder):
    return {path.relative_to(folder): path for path in sorted(pathlib.Path(folder).rglob("*"))
            if path.is_file() and not {"scenes", "verification"} & set(path.relative_to(folder).parts[1:2])}


def without_column(lines, head, split, join, is_cost):
    """The lines with the cells of a column of computing times masked, where one of the first few is a header that has such a column."""
    for at, line in enumerate(lines[:head]):
        places = [place for place, cell in enumerate(split(line)) if is_cost(cell)]
        if places:
            rows = [split(row) for row in lines[at:]]
            return lines[:at] + [join("-" if i in places else cell for i, cell in enumerate(row)) for row in rows]
    return lines


def of_printed(lines):
    """A printed table has a column "ms"; its cells are as wide as its header says, so that it is cut by places rather than words."""
    for at, line in enumerate(lines[:8]):
        if re.search(r" ms(  end)?$", line):
            end = line.rindex(" ms") + 3
            start = len(line[: end - 2].rstrip())
            return lines[:at] + [row[:start] + "-" + row[end:] for row in lines[at:]]
    return lines


def masked(path):
    content = path.read_bytes()
    try:
        text = content.decode()
    except UnicodeDecodeError:
        return content
    for mask, instead in MASKS:
        text = mask.sub(instead, text)
    lines = text.splitlines()
    if path.suffix == ".csv":
        lines = without_column(lines, 1, lambda line: line.split(","), ",".join, lambda cell: cell in COSTS)
    elif path.name == "printed":
        lines = of_printed(lines)
    return "\n".join(lines).encode()


def compare(before, after):
    old, new = files(before), files(after)
    differing = 0
    for name in sorted(old.keys() | new.keys()):
        if name not in old or name not in new:
            print(f"{name}: only {'before' if name in old else 'after'}")
            differing += 1
            continue
        one, other = masked(old[name]), masked(new[name])
        if one == other:
            continue
        differing += 1
        print(f"{name}: differs")
        try:
            lines = difflib.unified_diff(one.decode().splitlines(), other.decode().splitlines(), lineterm="", n=0)
            print("\n".join("    " + line[:200] for line in list(lines)[2:10]))
        except UnicodeDecodeError:
            pass
    print(f"{len(old.keys() | new.keys())} files compared, {differing} differ")
    return differing == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked = parser.add_subparsers(dest="asked", required=True)
    writes = asked.add_parser("write")
    writes.add_argument("peel")
    writes.add_argument("folder")
    writes.add_argument("--only", default="")
    compares = asked.add_parser("compare")
    compares.add_argument("before")
    compares.add_argument("after")
    given = parser.parse_args()
    if given.asked == "write":
        write(given.peel, given.folder, given.only)
    elif not compare(given.before, given.after):
        sys.exit(1)


if __name__ == "__main__":
    main()
