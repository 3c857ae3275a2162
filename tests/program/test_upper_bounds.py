# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Of blocks that forces can hold, of which no proof excludes a motion, a number is only an upper bound, and every output that shows it says so:
the sheet had "at least 0.0000", a batch "undecided" without its bound, a study quantiles without a word, a map contours named as a factor.
The numbers are those of `solve --json`, rounded up."""

import csv
import json
import math
import re

from governing_case import GoverningCase
from harness import ROOT, main, run

DATA = ROOT / "tests" / "data" / "factor_law"
OPEN = DATA / "study_open.yaml"  # eight columns: at most 1.10502, and no less is known
UPPER = {"en": "upper bound", "es": "cotas? superior", "de": "obere Schranke"}


def rounded_up(number, decimals):
    return f"{math.ceil(number * 10 ** decimals) / 10 ** decimals:.{decimals}f}"


class UpperBounds(GoverningCase):
    def test_sheet_and_batch(self):
        most, sheet = None, self.folder / "sheet.md"
        for language, words in UPPER.items():
            status, out, _ = run("solve", "--json", "--report", sheet, "--language", language, OPEN)
            self.assertEqual(status, 4)
            cases = json.loads(out)["cases"]
            self.assertEqual([case["governing_fos"]["fos_is"] for case in cases], ["undecided", "undecided"])
            self.assertNotIn("at_least", cases[0]["governing_fos"])
            most = cases[0]["governing_fos"]["at_most"]
            text, cell = sheet.read_text(encoding="utf-8"), rounded_up(most, 4).replace(".", "." if language == "en" else ",")
            self.assertRegex(text, re.escape(cell) + rf" \\?\({words}")
            self.assertNotRegex(text, r"0[.,]0000,")
        (self.folder / "table.csv").write_text("name,friction_angle_deg\nA,38.15\n", encoding="utf-8")
        table, rows = self.folder / "rows.md", self.folder / "rows.csv"
        out = run("solve", "--batch", "--template", OPEN, "--output", table, "--output", rows, self.folder / "table.csv")[1]
        cell = "at most " + rounded_up(most, 3)
        self.assertRegex(out, rf"\nA +undecided +{cell}  sliding")
        self.assertIn(f"| {cell} |", table.read_text(encoding="utf-8"))
        (row,) = csv.DictReader(rows.read_text(encoding="utf-8").splitlines())
        self.assertEqual((row["fos_is"], float(row["at_most"])), ("undecided", most))

    def study(self, scene, *options):
        (self.folder / "study.yaml").write_text(f"topple_study: 1\nscene: {scene}\nvary: {{friction_angle_deg: {{list: [38.15]}}}}\n", encoding="utf-8")
        status, out, err = run("study", self.folder / "study.yaml", *options)
        self.assertEqual(status, 0, err)
        return out

    def test_study(self):
        """Its quantiles are of upper bounds; of a slab that is decided only what forces can hold is one."""
        figure, sheet = self.folder / "study.svg", self.folder / "study.md"
        for language, words in UPPER.items():
            self.study(DATA / "fos_many.yaml", "--report", sheet, "--language", language)
            slab = len(re.findall(words, sheet.read_text(encoding="utf-8")))
            more = ("--figure", figure) if language == "en" else ("--json",) if language == "es" else ()
            out = self.study(OPEN, "--report", sheet, "--language", language, *more)
            self.assertEqual((slab, len(re.findall(words, sheet.read_text(encoding="utf-8")))), (1, 2), language)
            if language == "en":
                self.assertIn("Static limits and accelerations are upper bounds", out)
                self.assertIn("The factor of safety of an open sample is an upper bound", out)
                self.assertIn("Static limit (°), upper bound", figure.read_text(encoding="utf-8"))
            if language == "es":
                self.assertEqual(self.bounds(out), {"limit_deg", "fos", "critical_acceleration_g"})
        self.assertEqual(self.bounds(self.study(DATA / "fos_many.yaml", "--json")), {"limit_deg", "critical_acceleration_g"})

    def bounds(self, out):
        return {own["quantity"] for own in json.loads(out)["quantities"] if own.get("is_upper_bound")}

    def test_map(self):
        """In the legend, and in the name of the series of its table."""
        words = ("chart", "map", DATA / "fos_many.yaml", "--x", "friction_angle_deg=35:45", "--y", "tilt.angle_deg=5:25")
        for contours, legend, series in (("governing_fos=1.5", "upper bound of the factor of safety", "governing_fos_at_most"),
                                         ("critical_angle=30", "upper bound of the critical angle", "limit")):
            for ending in ("svg", "csv"):
                status, _, err = run(*words, "--contours", contours, "--output", self.folder / f"map.{ending}")
                self.assertEqual(status, 0, err)
            self.assertIn(legend, (self.folder / "map.svg").read_text(encoding="utf-8"))
            with open(self.folder / "map.csv", encoding="utf-8") as table:
                self.assertIn(series, {row["series"] for row in csv.DictReader(table)})

    def test_find(self):
        """What forces can hold is one, where it is found and where there is none; of the factor test_factor_law_blocks.py looks at it."""
        for target, beyond in (("limit_fos=1.8", 9), ("limit_angle=35", 70), ("critical_acceleration=0.4", 3)):
            for wanted in (target, f"{target.split('=')[0]}={beyond}"):
                find = ("solve", "--find", "friction_angle_deg", "--for", wanted, "--from", "30", "--to", "45", DATA / "fos_many.yaml")
                status, out, err = run(*find)
                self.assertEqual(status, 0, err)
                self.assertEqual("none in range" in out, wanted != target, out)
                self.assertIn("an upper bound", out)
            self.assertTrue(json.loads(run(*find, "--json")[1])["find"]["is_upper_bound"])


if __name__ == "__main__":
    main()
