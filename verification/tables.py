"""Tables of verification/: written by a script, compared when it is run with --check.

A script computes rows (dicts) and calls run(). Without arguments it writes the table beside it; with --check it compares what
it computed with the committed table and exits 1 on a mismatch. Texts must agree exactly, numbers to the relative tolerance.
"""

import argparse
import csv
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def read(name):
    """Rows of verification/NAME as dicts of texts; lines that begin with # are remarks."""
    with open(HERE / name, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def text_of(value):
    """A number as the shortest text with 13 significant digits; None as an empty cell."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, str)):
        return str(value)
    return f"{float(value):.13g}"


def write(name, remarks, rows):
    """Writes verification/NAME: remarks, names of the columns, rows."""
    with open(HERE / name, "w", encoding="utf-8", newline="\n") as file:
        for remark in remarks:
            file.write(f"# {remark}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(rows[0])
        for row in rows:
            writer.writerow([text_of(value) for value in row.values()])


def differences(name, rows, relative, absolute):
    """What differs between the rows and the committed table, a line each."""
    committed = read(name)
    if len(committed) != len(rows):
        yield f"{name}: {len(committed)} rows are committed, {len(rows)} were computed"
    for number, (old, new) in enumerate(zip(committed, rows), 1):
        if list(old) != list(new):
            yield f"{name}: the columns differ: {list(old)} and {list(new)}"
            return
        for column, value in new.items():
            was, now = old[column], text_of(value)
            if was == now:
                continue
            try:
                a, b = float(was), float(now)
            except ValueError:
                a, b = 0.0, float("inf")
            if not abs(a - b) <= absolute + relative * max(abs(a), abs(b)):
                yield f"{name}, row {number}, {column}: committed {was!r}, computed {now!r}"


def run(description, tables, relative=1e-9, absolute=1e-14):
    """The command line of a script. tables: list of (file name, remarks, function that computes the rows)."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--check", action="store_true", help="compare with the committed tables; exit 1 on a mismatch")
    arguments = parser.parse_args()
    wrong = 0
    for name, remarks, compute in tables:
        rows = compute()
        if not arguments.check:
            write(name, remarks, rows)
            print(f"wrote verification/{name}: {len(rows)} rows")
            continue
        found = list(differences(name, rows, relative, absolute))
        wrong += len(found)
        print(*found, sep="\n", end="\n" if found else "")
        print(f"{name}: {len(rows)} rows recomputed, {len(found)} differences")
    sys.exit(1 if wrong else 0)
