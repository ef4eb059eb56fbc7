"""Holds `peel run` against strip_variants.csv: the largest relative errors, and whether each error bound holds.

    cargo build --release && python3 verification/strip_error.py [--relative 1e-6] [--peel target/release/peel]

Standard library only. Exit status 1 where a bound is smaller than the error, less the last digit of the table, or a peel stops short.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
from decimal import Decimal

HERE = pathlib.Path(__file__).parent
SCENE = """
[strip]
length = "{length_nm} nm"
height = "{height_nm} nm"
width = "{width_nm} nm"
youngs_modulus = "{youngs_modulus_GPa} GPa"
poissons_ratio = {poissons_ratio}
shear_correction = {shear_correction}
bending_stiffness_factor = {bending_stiffness_factor}
[adhesion]
hamaker_constant = "{hamaker_constant_J} J"
equilibrium_distance = "{equilibrium_distance_nm} nm"
line_load = "{line_load}"
far_face = {far_face}
[grip]
rotation = "{grip_rotation}"
horizontal = "{grip_horizontal}"
[accuracy]
relative = {relative}
"""


def run(peel, row, relative):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as scene:
        scene.write(SCENE.format(**row, relative=relative))
        scene.flush()
        done = subprocess.run([peel, "run", scene.name, "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def numbers(summary):
    """Column of the table -> (value, error bound), as far as the peel has them."""
    folds = [p for p in summary["limit_points"] if p["kind"] == "displacement"]
    points = {"peak": summary["initiation_peak"], "lp1": folds[0] if folds else None, "lp2": folds[1] if len(folds) > 1 else None}
    found = {}
    for name, point in points.items():
        if point:
            found[f"{name}_displacement_nm"] = (point["displacement_nm"], point["error_nm"])
            found[f"{name}_force_nN"] = (point["force_nN"], point["error_nN"])
    return found


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--relative", default="1e-6")
    options.add_argument("--peel", default="target/release/peel")
    options = options.parse_args()
    lines = [l for l in (HERE / "strip_variants.csv").read_text().splitlines() if not l.startswith("#")]
    worst, compared, bad = (0.0, ""), 0, 0
    for row in csv.DictReader(lines):
        case = f"L = {row['length_nm']}, f = {row['bending_stiffness_factor']}, {row['line_load']}, far_face = {row['far_face']}, " \
            f"rotation {row['grip_rotation']}, horizontal {row['grip_horizontal']}"
        summary = run(options.peel, row, options.relative)
        if summary["end"] == "failed":
            bad += 1
            print(f"stopped short: {case}: {summary['reason']}")
        for column, (value, bound) in numbers(summary).items():
            if not row[column]:
                continue
            printed = Decimal(row[column])
            digit = float(Decimal(1).scaleb(printed.as_tuple().exponent))
            error = max(abs(value - float(printed)) - 0.5 * digit, 0.0)
            compared += 1
            worst = max(worst, (error / abs(float(printed)), f"{column}, {case}"))
            if error > bound:
                bad += 1
                print(f"bound {bound:.1e} below the error {error:.1e} of {column}: {case}")
    print(f"{compared} numbers compared at relative = {options.relative}; largest relative error {worst[0]:.1e} ({worst[1]})")
    print(f"{bad} bounds too small or peels stopped short")
    sys.exit(1 if bad else 0)


main()
