# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The hard cases: each scene of tests/hard at every price against its truth.

A scene says in its comments why it is hard and how its truth is known, and gives formulas of it
(hard_case.py reads them, truth.py computes them exactly). At each level, and on the climb through
all of them, the truth lies within every bound, or the program says that it is undecided; nothing
else is let pass: no wrong verdict, no NaN, no signal. What comes out stands in docs/hard.md, which
this test compares. TOPPLE_HARD=all runs the big cases too (five minutes of CPU and 4 GB of memory,
for reports of 300 MB), TOPPLE_HARD=write does so and writes the page anew."""

import json
import math
import os
import pathlib
import re
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
import hard_case
from harness import ROOT, main, run
from truth import Enclosure, number, rounding

HARD = ROOT / "tests" / "hard"
PAGE = ROOT / "docs" / "hard.md"
MODE = os.environ.get("TOPPLE_HARD", "")
LEVELS = ("double", "compensated", "ball", "exact")
CLIMB = ()
WAYS = [CLIMB, *(("--level", level) for level in LEVELS), ("--digits", "40")]


def no_constant(text):
    raise AssertionError(f"{text} in the JSON")


def numbers(tree):
    """All computed numbers of a report."""
    if isinstance(tree, dict) and "error" in tree:
        yield tree
    elif isinstance(tree, (dict, list)):
        for part in tree.values() if isinstance(tree, dict) else tree:
            yield from numbers(part)


def at(tree, path):
    for key in path:
        tree = tree[int(key)] if isinstance(tree, list) else tree[key]
    return tree


class Hard(unittest.TestCase):
    outcomes = {}  # name: the page's words for it

    def setUp(self):
        exact.set_digits(150)

    def tearDown(self):
        exact.set_digits(60)

    def holds(self, said, truth, where):
        """A computed number holds the truth; any other word is the truth."""
        if isinstance(truth, Enclosure):
            value, error = (Decimal(said[key]) for key in ("value", "error"))
            self.assertLessEqual(value - error, truth.high, where)
            self.assertGreaterEqual(value + error, truth.low, where)
        elif isinstance(truth, list):
            self.assertEqual(len(said), len(truth), where)
            for one, other in zip(said, truth):
                self.holds(one, other, where)
        elif isinstance(said, dict):
            self.assertIsInstance(truth, (int, Fraction, Decimal), where)
            truth = number(truth)
            self.assertLessEqual(abs(Decimal(said["value"]) - truth), Decimal(said["error"]) + rounding() * abs(truth), where)
            if "digits" in said:
                digits = Decimal(said["digits"])
                self.assertLessEqual(abs(digits - truth), Decimal("0.5001").scaleb(digits.as_tuple().exponent), where)
        else:
            self.assertEqual(said, truth, where)

    def check(self, case, way, folder):
        """One run; its report, or None where nothing is decided."""
        status, out, err = run("solve", "--json", *way, *case.options, folder / case.path.name)
        where = f"{case.path.name} {' '.join(way)}: exit {status} {err}"
        if case.refusal:
            self.assertEqual((status, out), (3, ""), where)
            self.assertIn(f"{case.path.name}:{case.refusal}", err)
            return None
        self.assertIn(status, (0,) if way in (CLIMB, WAYS[4], WAYS[5]) and not case.undecided else (0, 4), where)
        if status == 4:
            self.assertIn("undecided", err, where)
        if out == "":
            self.assertEqual(status, 4, where)
            return None
        report = json.loads(out, parse_constant=no_constant)
        for said in numbers(report):
            self.assertGreaterEqual(said["error"], 0, where)
            # 1e400 is JSON, and an infinity when read
            self.assertTrue(math.isfinite(float(said["value"])) and math.isfinite(float(said["error"])), where)
        names = case.names()
        for path, formula in case.truths:
            truth = formula.value(names)
            for said in self.chosen(report, path):
                if status == 0 or said != "undecided":
                    self.holds(said, truth, f"{where} {'.'.join(path)} = {formula.text}")
        return report

    def chosen(self, report, path):
        """What the report says at a path, which begins with the direction if it is one's alone."""
        if path[0] in ("found", "touching"):
            return [report["find"]["solutions" if path[0] == "found" else "touching"]]
        cases = report["cases"]
        if path[0] in ("left", "right"):
            cases, path = [c for c in cases if c["towards"] == path[0]], path[1:]
        self.assertTrue(cases, path)
        return [at(c, path) for c in cases]

    def words(self, case, reports):
        """What came out, for the page."""
        if case.refusal:
            return "refused at its line and column"
        climbed = reports[CLIMB]
        if climbed is None:
            return "undecided at every price"
        said = []
        for c in climbed["cases"]:
            angle = (c.get("limit") or c["toppling"] or {}).get("critical_angle_deg")
            said.append(c["mechanism"] + (f" {angle['value']:.9g}°" if angle else ""))
        if "find" in climbed:
            found, touching = (", ".join("%.9g" % s["value"] for s in climbed["find"][key]) for key in ("solutions", "touching"))
            said = [f"found {found}" if found else f"may touch at {touching}" if touching else "found nothing"]
        return f"{' / '.join(dict.fromkeys(said))}; by {climbed['level']}"

    def run_case(self, path):
        case = hard_case.Case(path)
        if case.big and not MODE:
            self.skipTest("big; TOPPLE_HARD=all runs it")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            case.write(folder)
            reports = {way: self.check(case, way, folder) for way in (WAYS if not case.big else WAYS[:2])}
            if not case.refusal and not case.options and not case.big:
                status, out, err = run("solve", folder / path.name)
                self.assertIn(status, (0, 4) if case.undecided else (0,), err)
                self.assertIsNone(re.search(r"\b(nan|inf)\b", out))
        Hard.outcomes[path.stem] = (case, self.words(case, reports))

    def test_a_wrong_truth_is_seen(self):
        """A truth that is off by 1e-11 degrees, or one wrong word, fails at every price that decides."""
        case = hard_case.Case(HARD / "far_map_coordinates.yaml")
        for wrong in ("toppling.critical_angle_deg = atan2(2, 5) + 1e-11", 'mechanism = "topples"',
                      "toppling.fos = None", "toppling.critical_angle_deg = between(21.81, 21.82)"):
            case.truths = []
            case.direct(wrong)
            with tempfile.TemporaryDirectory() as name:
                case.write(pathlib.Path(name))
                with self.assertRaises(AssertionError, msg=wrong):
                    self.check(case, CLIMB, pathlib.Path(name))


def page(outcomes):
    """docs/hard.md of what came out."""
    lines = [(ROOT / "tests" / "hard" / "page.md").read_text(encoding="utf-8").rstrip("\n"), "",
             "| case | why it is hard | what comes out |", "| --- | --- | --- |"]
    for stem, (case, words) in sorted(outcomes.items()):
        lines.append(f"| `{stem}` | {case.story} | {words} |")
    return "\n".join(lines) + "\n"


def add_cases():
    """One test a scene of tests/hard, named after it, and at last the page."""
    for path in sorted(HARD.glob("*.yaml")):
        setattr(Hard, f"test_{path.stem}", lambda self, path=path: self.run_case(path))

    def check_page(self):
        """docs/hard.md tells of every case what comes out today, of the big ones if they ran."""
        fresh = page(Hard.outcomes)
        if MODE == "write":
            PAGE.write_text(fresh, encoding="utf-8")
        skipped = {p.stem for p in HARD.glob("*.yaml")} - set(Hard.outcomes)
        lines = [line for line in PAGE.read_text(encoding="utf-8").splitlines(keepends=True)
                 if not any(line.startswith(f"| `{stem}` |") for stem in skipped)]
        self.assertEqual("".join(lines), fresh, "TOPPLE_HARD=write writes it anew")

    setattr(Hard, "test_~page", check_page)  # after all others


add_cases()

if __name__ == "__main__":
    main()
