"""Rows (case, quantity, value, estimated error) from two meshes, their table, and the command line of a script."""

import argparse
import sys
import time

import tables

ROUNDING = 2e-12  # of the largest value of its kind in a case: Newton's last step


def rows(case, coarse, fine):
    """coarse, fine: {quantity: (value, size)} on two meshes. The error: three times their difference, and round-off
    of the size."""
    out = []
    for name, (value, size) in fine.items():
        error = 3.0 * abs(value - coarse[name][0]) + ROUNDING * max(abs(value), size)
        value = value if abs(value) > error else 0.0
        out.append({"case": case, "quantity": name, "value": f"{value:.13g}", "estimated_error": f"{error:.1e}"})
    return out


def mismatches(name, now, factor=3.0):
    """What differs from the committed table by more than the errors of both, a line each."""
    old = {(row["case"], row["quantity"]): row for row in tables.read(name)}
    for row in now:
        key = row["case"], row["quantity"]
        if key not in old:
            yield f"{key}: not in {name}"
            continue
        off = abs(float(row["value"]) - float(old[key]["value"]))
        most = factor * (float(row["estimated_error"]) + float(old[key]["estimated_error"]))
        if not off <= most:
            yield f"{key}: {old[key]['value']} in {name}, {row['value']} now, differs by {off:.1e}, errors {most:.1e}"


def run(description, table, remarks, cases, compute, quick, checks=()):
    """cases: {name: what it takes}; compute(name, case, quick) -> rows, and prints its self-checks; checks: functions
    that give faults."""
    ap = argparse.ArgumentParser(description=description)
    ap.add_argument(
        "--check", action="store_true", help="recompute and compare with the committed table; exit 1 on a mismatch"
    )
    ap.add_argument("--quick", action="store_true", help="with --check: some of the cases")
    ap.add_argument("--only", metavar="TEXT", default="", help="cases whose name contains TEXT; nothing is written")
    a = ap.parse_args()
    started = time.process_time()
    names = [name for name in cases if a.only in name and (not a.quick or name in quick)]
    found, faults = [], []
    for name in names:
        found += compute(name, cases[name], a.quick)
    if a.check or a.only or a.quick:
        faults += list(mismatches(table, found))
        print(f"{table}: {len(names)} cases recomputed, {len(found)} values")
    else:
        tables.write(table, remarks, found)
        print(f"wrote verification/{table}: {len(found)} values of {len(names)} cases")
    for check in () if a.only else checks:
        faults += check()
    print(*faults, sep="\n", end="\n" if faults else "")
    verdict = f"{len(faults)} CHECKS FAILED" if faults else "all checks passed"
    print(f"{time.process_time() - started:.0f} s of CPU, {verdict}")
    sys.exit(1 if faults else 0)
