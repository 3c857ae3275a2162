# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Divisions of rationals are checked, or listed with the reason why they need not be.

FLINT ends the process where it divides by zero. The story: the sine of 1e-12 degrees, rounded to a fraction, is zero, and a slope of
that dip ended the program; so did an ellipse in a drawing that a transform makes a point. A division is a call of tp_divide, or a row
of tests/data/divisions.csv."""

import re
import unittest

from harness import ROOT, main, table

CALL = re.compile(r"\bfmpq_(?:div|inv)\(")


def arguments(text, at):
    """What stands between the parentheses from `at` on, by commas outside others."""
    parts, depth, start = [], 0, at
    for k in range(at, len(text)):
        if text[k] in "([{":
            depth += 1
        elif text[k] in ")]}" and depth > 0:
            depth -= 1
        elif text[k] in ",)" and depth == 0:
            parts.append(" ".join(text[start:k].split()))
            start = k + 1
            if text[k] == ")":
                return parts
    raise AssertionError(text[at:at + 80])


def divisions():
    found = set()
    for path in sorted((ROOT / "src").rglob("*.[ch]")):
        text = path.read_text(encoding="utf-8")
        for call in CALL.finditer(text):
            found.add((str(path.relative_to(ROOT / "src")), arguments(text, call.end())[-1]))
    return found - {("core/number/divide.c", "b")}


class Divisions(unittest.TestCase):
    def test_every_division_is_checked_or_listed(self):
        listed = {(row["file"], row["divisor"]): row["reason"] for row in table("divisions.csv")}
        found = divisions()
        self.assertEqual(sorted(found - listed.keys()), [], "call tp_divide (number/divide.h), or list why the divisor is not zero")
        self.assertEqual(sorted(listed.keys() - found), [], "the table lists divisions that are no more")
        for division, reason in listed.items():
            self.assertGreater(len(reason or ""), 2, division)

    def test_the_reader(self):
        self.assertEqual(arguments("fmpq_div(a, f(b, c), d[1] + 2)", 9), ["a", "f(b, c)", "d[1] + 2"])
        self.assertGreater(len(divisions()), 100)


if __name__ == "__main__":
    main()
