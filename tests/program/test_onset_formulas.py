# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Closed formulas of the onset of motion against the certified solver, which finds it in numbers by
all modes: inside the conditions both agree within the proven bound, outside they come to differ."""

import ctypes
import itertools
import json
import math
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import compiled, main, rounds, run

TEETH = ("topple: 1\nlength_unit: mm\nparameters: {{a: {a}, b: {b}, c: {c}}}\nblock:\n"
         "  teeth: {{count: {n}, width: a, height: b, depth: c, left_end: {left}}}\n"
         "base: {{mated: true, beyond: {{left: {beyond}, right: 0}}}}\n"
         "friction_angle_deg: {phi}\ntilt: {{towards: {towards}}}\n")
# An irregular foot of three facets; p moves a corner, q leans the block.
FOOT = ("topple: 1\nlength_unit: m\nparameters: {{h: {h}, p: {p}, q: {q}}}\nblock: {{outline: "
        "[[0, {y0}], [{x1}, p], [{x2}, {y2}], [2, {y3}], [2 + q, h], [q, h]]}}\n"
        "base: {{mated: true}}\nfriction_angle_deg: {phi}\ntilt: {{towards: {towards}}}\n")


def tangent(degrees):
    sine, cosine = exact.sin_cos(Decimal(degrees))
    return sine / cosine


def evaluate(formula, values):
    return eval(formula.replace("tan(phi)", "t").replace("^", "**"), {"__builtins__": {}}, values)


class OnsetFormulas(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"
        exact.set_digits(60)

    def tearDown(self):
        self.folder.cleanup()

    def derive(self, text):
        self.scene.write_text(text)
        status, out, err = run("derive", "--limit", "--json", self.scene)
        self.assertEqual((status, err), (0, ""))
        found = json.loads(out)
        return found["onset"][0], found["limit"][0] if "limit" in found else None

    def solved(self, text):
        self.scene.write_text(text)
        status, out, _ = run("solve", "--json", self.scene)
        return json.loads(out)["cases"][0]["onset"] if status == 0 else None

    def agrees(self, found, onset, values):
        """Does the formula give the solver's tilt, within its bound?"""
        if onset is None or onset["critical_angle_deg"] is None:
            return False
        top, below = (evaluate(found["tan_critical_angle"][key], values) for key in ("numerator", "denominator"))
        angle = exact.degrees(exact.atan(Decimal(top) / Decimal(below)))
        solved = onset["critical_angle_deg"]
        return abs(angle - Decimal(solved["value"])) <= Decimal(solved["error"]) + Decimal("1e-40")

    def sample(self, found, form, keys, fixed, spread, rounds):
        """(inside and agreeing, outside and agreeing, outside and not) of random values."""
        counts = [0, 0, 0]
        for _ in range(rounds):
            values = {key: Decimal(random.randint(*spread(key))) / 1000 for key in keys}
            phi = Decimal(random.randint(int(fixed["phi"]) * 1000 - 9000, int(fixed["phi"]) * 1000 + 9000)) / 1000
            if found["parameters_above_zero"] and min(values.values()) <= 0:
                continue
            onset = self.solved(form.format(**{**fixed, **values, "phi": phi}))
            numbers = {**values, "t": tangent(phi)}
            inside = all(evaluate(f, numbers) > 0 for f in found["conditions"])
            agrees = self.agrees(found, onset, numbers)
            if inside:
                self.assertTrue(agrees, (fixed, values, phi, found["tan_critical_angle"], onset))
            counts[0 if inside else 1 if agrees else 2] += 1
        return counts

    def test_holds_where_it_says_for_teeth(self):
        """Teeth of both ends, both kinds of base, both directions, from little friction to a lot."""
        random.seed(21)
        sums, other = [0, 0, 0], 0
        for n, left, beyond, phi in itertools.product((1, 2, 3), ("valley", "peak"), (0, 30), (20, 60, 75)):
            fixed = {"a": 30, "b": random.choice((20, 60 * n)), "c": random.choice((5, 12)), "n": n, "left": left,
                     "beyond": beyond, "phi": phi, "towards": random.choice(("left", "right"))}
            found, _ = self.derive(TEETH.format(**fixed))
            if found["tan_critical_angle"] is None:
                self.assertIn("level ground", found["why"])
                continue
            other += not found["same_as_limit"]
            counts = self.sample(found, TEETH, "abc", fixed, lambda key: (
                int(fixed[key]) * 700, int(fixed[key]) * 1400), 6)
            sums = [a + b for a, b in zip(sums, counts)]
        self.assertGreater(sums[0], 80, sums)
        self.assertGreater(sums[2], 10, sums)
        self.assertGreater(other, 5)

    def test_holds_where_it_says_for_irregular_feet(self):
        """Feet of three facets in p and q of any sign: overhanging, jammed, sliding."""
        random.seed(22)
        sums, kinds = [0, 0, 0], set()
        count = rounds(12, 45)
        for _ in range(count):
            fixed = {"h": random.randint(15, 60) / 10, "p": random.randint(-6, 12) / 10 + 0.003,
                     "q": random.choice((0, 0.3, -0.4)), "x1": random.randint(2, 9) / 10,
                     "x2": random.randint(11, 18) / 10, "phi": random.choice((10, 25, 40, 55, 65, 75)),
                     "towards": random.choice(("left", "right")),
                     **{f"y{k}": random.randint(-6, 12) / 10 + k / 1000 for k in (0, 2, 3)}}
            text = FOOT.format(**fixed)
            self.scene.write_text(text)
            if run("derive", "--limit", self.scene)[0] != 0:
                continue  # no block
            found, _ = self.derive(text)
            if found["tan_critical_angle"] is None:
                kinds.add(found["why"])
                continue
            kinds.add(found["mechanism"])
            counts = self.sample(found, FOOT, "hpq", fixed, lambda key: (
                int(fixed[key] * 1000) - 150, int(fixed[key] * 1000) + 150), 5)
            sums = [a + b for a, b in zip(sums, counts)]
        self.assertGreater(sums[0], 4 * count // 3, sums)
        self.assertGreater(sums[2], count // 9, sums)
        self.assertGreater(len(kinds), rounds(1, 3), kinds)

    def test_conditions_are_met_on_both_sides(self):
        """Checks that are reported, done again in numbers; beyond some the formula goes on, as the
        conditions are only enough, and the report says so."""
        seen = set()
        for n, left, phi in itertools.product((1, 3), ("valley", "peak"), (30, 60)):
            scene = {"a": 30, "b": 120, "c": 5, "n": n, "left": left, "beyond": 0, "phi": phi, "towards": "left"}
            found, _ = self.derive(TEETH.format(**scene))
            for check in found["checks"]:
                for side in ("inside", "outside"):
                    at = {**scene, **{"phi" if k == "friction_angle_deg" else k: v for k, v in check[side].items()}}
                    onset = self.solved(TEETH.format(**at))
                    numbers = {**{k: Decimal(str(at[k])) for k in "abc"}, "t": tangent(str(at["phi"]))}
                    agrees = self.agrees(found, onset, numbers)
                    own = evaluate(found["conditions"][check["condition"]], numbers)
                    if side == "inside":
                        self.assertTrue(agrees and own > 0, (scene, check))
                    else:
                        self.assertLess(own, 0)
                        self.assertEqual(agrees, check["beyond"] == "same", (scene, check, onset))
                        seen.add(check["beyond"])
        self.assertLessEqual({"same", "other"}, seen)

    def test_block_a_passes_its_peak(self):
        """Block A towards its peak at 60 degrees of friction: it begins to topple where its weight
        passes the peak, tan = x/y from there, by exact moments; the limit is a formula in tan(phi).
        At 75 degrees forces hold it at every tilt, and the onset is the same formula."""
        outline = exact.teeth(3, Fraction(15), Fraction(94), Fraction(5), "peak")
        gx, gy = exact.centroid(exact.block_moments(outline))
        for phi, interlocked in ((60, False), (75, True)):
            found, limit = self.derive(TEETH.format(a=15, b=94, c=5, n=3, left="peak", beyond=0, phi=phi,
                                                    towards="left"))
            self.assertEqual(found["tan_critical_angle"],
                             {"numerator": "27*a*b + 14*a*c", "denominator": "9*b^2 - 3*c^2"})
            self.assertEqual((found["mechanism"], found["below_limit"], found["same_as_limit"]), ("topples", True, False))
            self.assertEqual(limit["tan_critical_angle"] is None, interlocked)
            values = {"a": Fraction(15), "b": Fraction(94), "c": Fraction(5)}
            formula = evaluate("27*a*b + 14*a*c", values) / evaluate("9*b^2 - 3*c^2", values)
            self.assertEqual(formula, gx / (gy - 5))
            self.assertEqual([row["against_slip"] for row in found["balance"]], [True, False])
            self.assertNotIn("tan(phi)", found["tan_critical_angle"]["numerator"])

    def test_one_formula_serves_for_both(self):
        """Below 90 degrees less twice the inclination of the teeth onset and limit are one."""
        for n, left in ((3, "peak"), (3, "valley"), (2, "valley")):
            found, limit = self.derive(TEETH.format(a=30, b=120, c=5, n=n, left=left, beyond=0, phi=30, towards="left"))
            self.assertEqual((found["same_as_limit"], found["below_limit"]), (True, False))
            self.assertEqual(found["tan_critical_angle"], limit["tan_critical_angle"])

    def test_mirror(self):
        """Block E tilted to the other side, mirrored: the same formula and conditions."""
        one, _ = self.derive(TEETH.format(a=30, b=120, c=5, n=3, left="valley", beyond=0, phi=60, towards="left"))
        other, _ = self.derive(TEETH.format(a=30, b=120, c=5, n=3, left="peak", beyond=0, phi=60, towards="right"))
        self.assertEqual(one["tan_critical_angle"], other["tan_critical_angle"])
        self.assertEqual(set(one["conditions"]), set(other["conditions"]))

    def test_c(self):
        """The C of it compiles without warnings; its formula and its conditions hold at the scene's
        values, and no longer where friction is as low as 1 degree."""
        self.scene.write_text(TEETH.format(a=30, b=120, c=5, n=3, left="valley", beyond=0, phi=30, towards="left"))
        status, out, _ = run("derive", "--c", "--limit", self.scene)
        self.assertEqual(status, 0)
        c = compiled(out, self.scene)
        c.tan_onset_left.restype = ctypes.c_double
        at = [ctypes.c_double(v) for v in (math.radians(30), 30, 120, 5)]
        self.assertAlmostEqual(math.degrees(math.atan(c.tan_onset_left(*at))), 28.735, delta=5e-4)
        self.assertEqual(c.is_onset_left(*at), 1)
        self.assertEqual(c.is_onset_left(ctypes.c_double(math.radians(1)), *at[1:]), 0)

    def test_text_and_latex(self):
        scene = TEETH.format(a=15, b=94, c=5, n=3, left="peak", beyond=0, phi=60, towards="left")
        self.scene.write_text(scene)
        text, latex = run("derive", "--limit", self.scene)[1], run("derive", "--limit", "--latex", self.scene)[1]
        self.assertIn("Onset of motion: topples, towards the left, 26.215 degrees at the scene's values, below the limit\n"
                      "  tan(alpha_s) = (27*a*b + 14*a*c)/(9*b^2 - 3*c^2)\n", text)
        self.assertIn("\\tan\\alpha_{\\mathrm{s}} = \\frac{27 a b + 14 a c}{9 b^{2} - 3 c^{2}}", latex)
        self.scene.write_text(scene.replace("deg: 60", "deg: 30"))
        self.assertIn("the formula of the limit serves for both", run("derive", "--limit", self.scene)[1])

    def test_says_why_not(self):
        """No formula: no motion begins at any tilt; one begins on level ground; the contact's end is
        a tie. The rest of the derivation is printed all the same."""
        never = TEETH.format(a=10, b=20, c=30, n=2, left="valley", beyond=30, phi=75, towards="left")
        level = TEETH.format(a=30, b=20, c=12, n=1, left="peak", beyond=0, phi=5, towards="left")
        tie = FOOT.format(h=5, p=0.6, q=0, x1=0.6, x2=1.4, y0=1.2, y2=0.5, y3=0.7, phi=25, towards="left")
        for text, why in ((never, "no motion can begin at any tilt"), (level, "on level ground"), (tie, "45 degrees")):
            found, _ = self.derive(text)
            self.assertIsNone(found["tan_critical_angle"], why)
            self.assertIn(why, found["why"])
            out = run("derive", "--limit", self.scene)[1]
            self.assertIn("Onset of motion: no formula, towards the left:", out)
            self.assertIn("Pivot", out)


if __name__ == "__main__":
    main()
