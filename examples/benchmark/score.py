# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Holds answers of any program against the brackets of the benchmark.

    python3 score.py RESULTS.csv

RESULTS.csv has the columns case, quantity and value; a value is a number in the unit of its quantity, `never`, or empty where
the program gave none. Prints each answer that lies outside its bracket, by how much, and a table of the groups."""

import csv
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
STEPS = (0.01, 0.1, 1.0)  # degrees outside a bracket, or hundredths of its value where it is no angle


def is_of_motion(quantity):
    """Is it one that simulations are asked for?"""
    return quantity.startswith("moves_") or quantity == "moved_s" or quantity.endswith("_from_g")


def outside(bracket, value):
    """By how much a value lies outside: 0 within, above 0 where it is too large and so, of a limit, on the unsafe side; None
    where only one of the two is `never`."""
    if value == "never":
        return 0.0 if bracket.get("never") else None
    value = float(value)
    if bracket.get("never") and "low" not in bracket:
        return None
    if bracket.get("never") and value >= bracket["low"]:
        return 0.0
    return min(0.0, value - bracket["low"]) or max(0.0, value - bracket["high"])


def judged(quantity, bracket, value):
    by = outside(bracket, value)
    if by and not quantity.endswith("_deg"):
        by *= 100 / max(abs(bracket["low"]), abs(bracket["high"]))
    return by


def scores(results, manifest, answers):
    """(case, quantity, outside) of every answer that is asked and given, in the order of the manifest."""
    given = {(row["case"], row["quantity"]): row["value"].strip() for row in results}
    for name in manifest:
        for quantity, bracket in answers[name].items():
            value = given.get((name, quantity), "")
            if value:
                yield name, quantity, judged(quantity, bracket, value)


def tally(found, manifest):
    """Of each group and quantity: [inside, within each of STEPS, worse, largest], over its answers."""
    table = {}
    for name, quantity, by in found:
        row = table.setdefault((manifest[name]["group"], quantity), [0] * (len(STEPS) + 2) + [0.0])
        size = float("inf") if by is None else abs(by)
        place = 0 if size == 0 else next((k for k, step in enumerate(STEPS, 1) if size <= step), len(STEPS) + 1)
        row[place] += 1
        if size > abs(row[-1]):
            row[-1] = size if by is None else by
    return table


def load():
    return (json.loads((HERE / f"{what}.json").read_text()) for what in ("manifest", "answers"))


def main(path):
    manifest, answers = load()
    with open(path, encoding="utf-8", newline="") as file:
        found = list(scores(csv.DictReader(line for line in file if not line.startswith("#")), manifest, answers))
    for name, quantity, by in found:
        if by != 0:
            print(f"{name} {quantity}: {'never, or not' if by is None else f'{by:+.6g}'} outside")
    print("group,quantity,inside," + ",".join(f"within {step:g}" for step in STEPS) + ",worse,largest")
    for (group, quantity), row in tally(found, manifest).items():
        print(",".join([group, quantity, *map(str, row[:-1]), f"{row[-1]:+.4g}"]))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
