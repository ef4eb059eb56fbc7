"""What the scripts have in common: cases in, a table out; with --check the committed table is held against them."""
import argparse
import sys
import time
from dataclasses import fields, replace

import tables

from .digits import LEVELS, good, off, printed, twice
from .law import Strip

DEFINING = {"length_nm": "length", "bending_stiffness_factor": "factor", "grip_rotation": "rotation", "line_load": "line_load",
            "far_face": "far_face", "height_nm": "height", "youngs_modulus_GPa": "young", "poissons_ratio": "poisson",
            "hamaker_constant_J": "hamaker", "equilibrium_distance_nm": "r0", "width_nm": "width",
            "grip_horizontal": "horizontal", "shear_correction": "shear_correction"}


class Suite:
    """A table: its name and remarks, the beams of its rows, its columns, and compute(strip, level, verbose) -> {column: number}.

    defining: the columns that define a beam and what they are called in it; what has no column is as in paper. Columns that
    neither define the beam nor are computed are an error; `digits_relative`, the fewest digits of a row, is added.
    """

    def __init__(self, table, remarks, cases, columns, compute, quick=(), defining=DEFINING, paper=Strip()):
        self.table, self.remarks, self.cases, self.columns, self.compute = table, remarks, cases, columns, compute
        self.quick = quick or cases[::8]
        self.defining, self.paper = defining, paper
        self.values = [column for column in columns if column not in defining]

    def row(self, strip, verbose):
        """A row, each number as the text of its good digits, and remarks."""
        found, remarks = twice(lambda level: self.compute(strip, level, verbose))
        row = {}
        for column in self.columns:
            value = getattr(strip, self.defining[column]) if column in self.defining else None
            row[column] = repr(value).removesuffix(".0") if isinstance(value, float) else value
            if column in found:
                row[column] = printed(*found[column])
        row["digits_relative"] = min(good(difference) for _, difference in found.values())
        return row, remarks

    def mismatches(self, strip, row, verbose):
        """What differs between a row of a table and the strip computed anew on the finer level, a line each."""
        now = self.compute(strip, LEVELS[1], verbose)
        for column in self.values:
            text = row.get(column)
            if not text:
                continue
            if now[column] is None:
                yield f"{column}: {text} in the table, not found now"
            elif (difference := off(text, now[column])) is not None:
                yield f"{column}: {text} in the table, {now[column]!r} now, differs by {difference:.1e}"

    def strip_of(self, row):
        """The beam of a row of a table."""
        def value(column, default):
            text = row[column]
            if isinstance(default, bool):
                return text == "true"
            # what is not given is empty, as a number that is None
            return text if isinstance(default, str) else float(text) if text else None

        names = {field.name for field in fields(self.paper)}
        return replace(self.paper, **{name: value(column, getattr(self.paper, name)) for column, name in self.defining.items()
                                      if column in row and name in names})

    def check(self, name, only, quick, verbose):
        """How many rows of a table do not agree."""
        rows = {self.strip_of(row): row for row in tables.read(name)}
        cases = self.quick if quick else self.cases if name == self.table else list(rows)
        cases = [strip for strip in cases if only in str(strip)]
        wrong = 0
        for strip in cases:
            found = list(self.mismatches(strip, rows[strip], verbose)) if strip in rows else ["not in the table"]
            wrong += bool(found)
            print(*(f"{strip}: {line}" for line in found), sep="\n", end="\n" if found else "", flush=True)
        print(f"{name}: {len(cases)} rows recomputed, {wrong} do not agree")
        return wrong

    def write(self, verbose):
        rows = []
        for strip in self.cases:
            row, remarks = self.row(strip, verbose)
            rows.append(row)
            print(f"{strip}: {row['digits_relative']} digits{''.join('; ' + remark for remark in remarks)}", flush=True)
        tables.write(self.table, self.remarks, rows)
        print(f"wrote verification/{self.table}: {len(rows)} rows")


def known(strip):
    """The row of strip_variants.csv of a strip that is in it."""
    suite = Suite("strip_variants.csv", (), (), (), None)
    return next(row for row in tables.read(suite.table) if suite.strip_of(row) == strip)


def run(description, suite, checks=(), long=()):
    """The command line of a script. checks: functions without arguments that print a line and return whether it holds; long: those that take
    seconds, which --quick leaves out."""
    ap = argparse.ArgumentParser(description=description)
    ap.add_argument("--check", action="store_true", help="recompute and compare with the committed table (1e-9 relative, or its last digit)")
    ap.add_argument("--quick", action="store_true", help="with --check: some of the rows, and no check of the solver that takes seconds")
    ap.add_argument("--only", metavar="TEXT", default="", help="with --check: rows whose description contains TEXT, and nothing else")
    ap.add_argument("--reference", metavar="CSV", default=suite.table, help="with --check: another table of such columns, strip.csv say")
    ap.add_argument("--verbose", action="store_true", help="print every point of every path")
    a = ap.parse_args()
    started = time.time()
    checks = () if a.only else checks if a.quick else (*checks, *long)
    wrong = sum(not check() for check in checks)
    if a.check:
        wrong += suite.check(a.reference, a.only, a.quick and suite.quick, a.verbose)
    else:
        suite.write(a.verbose)
    print(f"{time.time() - started:.0f} s, {'all checks passed' if not wrong else f'{wrong} CHECKS FAILED'}")
    sys.exit(1 if wrong else 0)
