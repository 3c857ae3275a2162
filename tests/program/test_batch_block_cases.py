# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A batch over many blocks with load cases: each row is of the worst case, and names it.

Two cases that rank equally ended the program by a null pointer, since the row of many blocks never named its case. A slab at the dip α
on a floor of the friction φ has the factor tan φ / tan α, by strength reduction and by driving loads alike, so that the case which
governs follows by hand."""

import csv
import io
import itertools
import json
import math
import pathlib
import tempfile
import unittest

from harness import PROGRAM, main, run

SCENE = """topple: 1
length_unit: m
friction_angle_deg: 35
block: {unit_weight_kn_m3: 25}
blocks:
  - {name: ground, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}
  - {name: low, slab: {width: 2, height: 1}}
tilt: {towards: left, angle_deg: 10}
cases:
"""
ALPHA = math.radians(10)


def factor(friction):
    return math.tan(math.radians(friction)) / math.tan(ALPHA)


def case(name, friction=None, required=None):
    parts = [f"name: {name}"]
    if friction is not None:
        parts.append(f"friction_angle_deg: {friction}")
    if required is not None:
        parts.append(f"required_fos: {required}")
    return "  - {" + ", ".join(parts) + "}\n"


def expected(cases):
    """Name, standing and factor of the worst: what fails first, then what lacks its factor, then by required over factor, then by name."""
    told = []
    for name, friction, required in cases:
        own = factor(friction if friction is not None else 35)
        standing = "fails" if own < 1 else "below required" if required and own < required else "holds"
        told.append((("fails", "below required", "holds").index(standing), -(required or 1) / own, name, standing, own))
    return min(told)[2:]


class BatchBlockCases(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def batch(self, cases, *words, table="name,friction\nA,\n", status=(0, 1)):
        template, survey = self.folder / "template.yaml", self.folder / "survey.csv"
        template.write_text(SCENE + "".join(case(*own) for own in cases), encoding="utf-8")
        survey.write_text(table, encoding="utf-8")
        got, out, err = run("solve", "--batch", survey, "--template", template, *words)
        self.assertIn(got, status, err)
        return out

    def row(self, cases, **more):
        return list(csv.DictReader(io.StringIO(self.batch(cases, "--csv", **more))))[0]

    def test_equal_ranks(self):
        """The table of the defect: both cases are met, and the one that requires more governs; equal ones go by their names."""
        for cases, governs in (((("static", None, 1.5), ("b", None, 1.4)), "static"),
                               ((("b", None, 1.4), ("static", None, 1.5)), "static"),
                               ((("static", None, 1.5), ("b", None, 1.5)), "b"),
                               ((("static",), ("b",)), "b")):
            row = self.row(cases, table="name,friction\nA,35\n")
            self.assertEqual((row["load_case"], row["standing"]), (governs, "holds"))
            self.assertAlmostEqual(float(row["fos"]), factor(35), delta=float(row["fos_error"]) + 1e-12)

    def test_worst_case(self):
        """All pairs of cases that fail, lack what they require, or hold, in both orders: the row is that of the worse one."""
        kinds = [("slips", 8, None), ("slips_farther", 6, 1.1), ("short", 20, 2.5), ("shorter", 18, 2.5), ("holds", 35, 1.5),
                 ("holds_less", 30, 1.5), ("bare", 32, None)]
        for pair in itertools.permutations(kinds, 2):
            name, standing, own = expected(pair)
            row = self.row(pair)
            self.assertEqual((row["load_case"], row["standing"]), (name, standing), pair)
            self.assertAlmostEqual(float(row["fos"]), own, delta=float(row["fos_error"]) + 1e-12)

    def test_every_form_names_the_case(self):
        """Text, JSON, Markdown, a page with figures, a worksheet: of the case that a column names, too."""
        cases = (("static", None, 1.5), ("b", None, 1.4))
        for table, name in (("name,friction\nA,35\n", "static"), ("name,case\nA,b\n", "b")):
            page, figures = self.folder / "page.html", self.folder / "figures"
            words = ["--output", page, "--figures", figures]
            if (pathlib.Path(PROGRAM).parent / "libtopple-xlsx.so").exists():
                words += ["--output", self.folder / "book.xlsx"]
            self.assertRegex(self.batch(cases, *words, table=table), rf"\bA  +holds .* {name}\n")
            self.assertIn(f"case {name}", page.read_text(encoding="utf-8"))
            self.assertEqual(len(list(figures.iterdir())), 1)
            self.assertEqual(json.loads(self.batch(cases, "--json", table=table))["rows"][0]["load_case"], name)
            self.assertIn(f"| {name} |", self.batch(cases, "--table", table=table))


if __name__ == "__main__":
    main()
