# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The page's phrases in each language, of four tables of the same form: the program's, whose short phrases without numbers are
the words of its results, the page's own, words/phrases.csv, the titles of its examples, words/titles.csv, and the program's messages,
words/refusals.csv."""

import csv
import pathlib

OWN = pathlib.Path(__file__).resolve().parents[1] / "words" / "phrases.csv"
TITLES = OWN.with_name("titles.csv")
REFUSALS = OWN.with_name("refusals.csv")
PROGRAMS = OWN.parents[4] / "src" / "core" / "terms" / "phrases.csv"
ENGLISH = "en"
DECIMALS = "."  # the row of the sign before decimals
LENGTH_MAX = 50  # of a word of results; what is longer is a sentence of sheets


def table(path):
    """The rows of a table, by column."""
    with open(path, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def phrases():
    """{"codes": [...], "decimals": {code: sign}, "phrases": {code: {phrase: its translation}}, "refusals": {code: [[message,
    its translation]]}}"""
    programs = table(PROGRAMS)
    codes = list(programs[0])
    decimals = next(row for row in programs if row[ENGLISH] == DECIMALS)
    words = [row for row in programs if "%" not in row[ENGLISH] and 1 < len(row[ENGLISH]) <= LENGTH_MAX] + table(OWN) + table(TITLES)
    others = [code for code in codes if code != ENGLISH]
    return {"codes": codes, "decimals": decimals,
            "refusals": {code: [[row[ENGLISH], row[code]] for row in table(REFUSALS)] for code in others},
            "phrases": {code: {row[ENGLISH]: row[code] for row in words if row[code] != row[ENGLISH]} for code in others}}
