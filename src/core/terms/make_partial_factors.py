#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The C of the named sets of partial factors, from partial_factors.csv, where each value stands once with its source.

    make_partial_factors.py HEADER

A row says of a set what a factor acts on, its symbol and its value as printed in the source, and how it acts: `times` what it
acts on, `over` it (the value is a divisor), or `share` of it (a resistance factor of LRFD, of which the divisor is the inverse).
Of each set all of FACTORS are there. The header has TP_PARTIAL_FACTOR_SETS(ROW), a row for each set: its name, whether it judges
toppling alone, and numerator and denominator of each factor in the order of tp_partial_factor."""

import csv
import fractions
import pathlib
import sys

TABLE = pathlib.Path(__file__).with_name("partial_factors.csv")
#: In the order of tp_partial_factor.
FACTORS = ["permanent_unfavourable", "permanent_favourable", "water_unfavourable", "water_favourable", "variable_unfavourable",
           "variable_favourable", "earthquake", "friction", "cohesion", "anchor", "resistance"]


def sets():
    """By their names, the factors of each, as divisors where they divide."""
    found = {}
    for row in csv.DictReader(line for line in TABLE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")):
        value = fractions.Fraction(row["value"])
        found.setdefault(row["set"], {})[row["on"]] = 1 / value if row["acts"] == "share" else value
    return found


def write(header):
    rows = []
    for name, own in sets().items():
        values = ", ".join(f"{{{own[factor].numerator}, {own[factor].denominator}}}" for factor in FACTORS)
        rows.append(f'  ROW("{name}", {"true" if own.get("toppling_alone") else "false"}, {values})')
    text = "/* Made by core/terms/make_partial_factors.py of partial_factors.csv; not to be edited. */\n\n"
    text += "#ifndef TP_PARTIAL_FACTORS_TABLE_H\n#define TP_PARTIAL_FACTORS_TABLE_H\n\n"
    text += "#define TP_PARTIAL_FACTOR_SETS(ROW) \\\n" + " \\\n".join(rows) + "\n\n#endif\n"
    pathlib.Path(header).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_partial_factors.py HEADER")
    write(sys.argv[1])
