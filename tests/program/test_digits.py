# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Digits as asked, and the costliest arithmetic allowed: `solve --digits N --level LEVEL`.

The truth comes from Python's fractions and decimals at more digits than are asked for; the static
limit, which has no formula here, is put to the laws that it must obey."""

import json
import pathlib
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROOT, example_scenes, main, run, solve

BLOCK_E = "examples/block_e_valley.yaml"
MANY = (16, 50, 300, 1000)
LEVELS = ("double", "compensated", "ball", "exact")


def tangent(degrees):
    sine, cosine = exact.sin_cos(degrees)
    return sine / cosine


class Digits(unittest.TestCase):
    def tearDown(self):
        exact.set_digits(60)

    def rounds_to(self, number, truth):
        """Are the printed digits the truth, rounded? As many as asked, or a few less."""
        digits = Decimal(number["digits"])
        self.assertLess(abs(digits - truth), Decimal(10) ** digits.as_tuple().exponent * Decimal("0.5001"))

    def test_block_e(self):
        """Centroid, critical angle and factor of safety of block E, from rationals, to 1000 digits."""
        outline = exact.teeth(3, Fraction(30), Fraction(120), Fraction(5), "valley")
        moments = exact.block_moments(outline)
        for digits in MANY:
            exact.set_digits(digits + 20)
            s = solve(BLOCK_E, "--digits", digits)["cases"][0]
            angle = s["toppling"]["critical_angle_deg"]
            self.assertEqual(len(angle["digits"]), digits + 1)
            self.rounds_to(angle, exact.critical_angle(moments, (0, 0)))
            self.rounds_to(s["toppling"]["fos"], exact.factor_of_safety(moments, (0, 0), 20))
            self.rounds_to(s["block"]["centroid_x_m"], exact.decimal(exact.centroid(moments)[0] / 1000))

    def test_limit_balances(self):
        """At the static limit of block E, to 300 digits, the two reactions and the weight balance in
        force and in moment, and each lies on the edge of its cone: 30 degrees off the facet's normal."""
        exact.set_digits(320)
        s = solve(BLOCK_E, "--digits", 300)["cases"][0]
        read = lambda number: Decimal(number["digits"])
        sine, cosine = exact.sin_cos(Fraction(s["limit"]["critical_angle_deg"]["digits"]))
        x, y = read(s["block"]["centroid_x_m"]), read(s["block"]["centroid_y_m"])
        sums = [-sine, -cosine, -x * cosine + y * sine]
        for r in s["limit"]["reactions"]:
            fx, fy, rx, ry = (read(r[key]) for key in ("share_x", "share_y", "x_m", "y_m"))
            sums = [a + b for a, b in zip(sums, (fx, fy, rx * fy - ry * fx))]
            slope = Fraction(5, 30) * (1 if rx == 0 else -1)  # the facets that bear: toe and second
            off = abs((fx + exact.decimal(slope) * fy) / (fy - exact.decimal(slope) * fx))
            self.assertLess(abs(off - tangent(30)), Decimal(10) ** -295)
        for total in sums:
            self.assertLess(abs(total), Decimal(10) ** -297)

    def test_strength_reduction(self):
        """The factor of safety by strength reduction, to 200 digits: with tan 30 over it as friction
        the static limit is the scene's tilt, 20 degrees."""
        exact.set_digits(230)
        factor = Decimal(solve(BLOCK_E, "--digits", 200)["cases"][0]["limit"]["fos"]["digits"])
        reduced = exact.degrees(exact.atan(tangent(30) / factor))
        text = (ROOT / BLOCK_E).read_text(encoding="utf-8").replace("friction_angle_deg: 30", f"friction_angle_deg: {reduced}")
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "reduced.yaml"
            scene.write_text(text, encoding="utf-8")
            limit = solve(scene, "--digits", 200)["cases"][0]["limit"]["critical_angle_deg"]
        self.assertLess(abs(Decimal(limit["digits"]) - 20), Decimal(10) ** -196)

    def test_limits_under_loads(self):
        """Every tilt at which a loaded block begins to move has the digits asked for: the first is the critical angle."""
        pivot = solve("examples/block_seismic.yaml", "--digits", 50)["cases"][0]["pivots"][0]
        self.assertEqual(pivot["limits_deg"][0]["digits"], pivot["critical_angle_deg"]["digits"])
        self.assertEqual(len(pivot["limits_deg"][0]["digits"]), 51)

    def test_barton(self):
        """Barton's law at the static limit, to 100 digits: the friction angle reported is that of Eq. (8)
        at the mean stress at the tilt reported, and with that angle given the limit is that tilt."""
        exact.set_digits(120)
        scene = ("topple: 1\nlength_unit: m\nblock: {teeth: {count: 5, width: 0.2, height: 1, depth: 0.05, "
                 "left_end: valley}, thickness: 1, unit_weight_kn_m3: 26}\nbase: {mated: true, beyond: {left: 0, right: 0}}\n"
                 "tilt: {towards: left, angle_deg: 12}\n")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "barton.yaml"
            path.write_text(scene + "friction: {law: barton, residual_angle_deg: 28, jrc: 8, jcs_mpa: 60}\n", encoding="utf-8")
            limit = solve(path, "--digits", 100)["cases"][0]["limit"]
            tilt, friction = (Decimal(limit[key]["digits"]) for key in ("critical_angle_deg", "friction_angle_deg"))
            stress = Decimal("26.65") * exact.sin_cos(Fraction(str(tilt)))[1]  # kPa, of the mean plane
            law = 28 + 8 * (60000 / stress).log10()
            self.assertLess(abs(friction - law), Decimal(10) ** -97)
            path.write_text(scene + f"friction_angle_deg: {friction}\n", encoding="utf-8")
            given = solve(path, "--digits", 100)["cases"][0]["limit"]["critical_angle_deg"]
            self.assertLess(abs(Decimal(given["digits"]) - tilt), Decimal(10) ** -97)

    def test_more_digits_begin_alike(self):
        """For every example the numbers to 40 digits, to 20 and those of doubles are one truth."""
        def pairs(a, b, path=""):
            if isinstance(a, dict) and "error" in a:
                yield path, a, b
            elif isinstance(a, (dict, list)):
                for key in a.keys() if isinstance(a, dict) else range(len(a)):
                    if key not in ("effects", "reactions"):  # times; a tie may be held by other forces
                        yield from pairs(a[key], b[key], f"{path}.{key}")

        for scene in example_scenes():
            few, many, forty = (solve(scene, "--digits", n)["cases"] for n in (6, 20, 40))
            for key, a, b in pairs(few, many):
                with self.subTest(scene=scene.name, key=key):
                    self.assertLessEqual(abs(Decimal(a["value"]) - Decimal(b["value"])), Decimal(a["error"]) + Decimal(b["error"]))
            for key, a, b in pairs(many, forty):
                with self.subTest(scene=scene.name, key=key):
                    zero = any(word in key for word in ("centroid", "moment_xy", ".balance."))  # known to digits of the block's size
                    self.assertTrue(zero or ("digits" in a) == ("digits" in b))
                    if "digits" in a and "digits" in b:
                        unit = Decimal(10) ** Decimal(a["digits"]).as_tuple().exponent
                        self.assertLessEqual(abs(Decimal(a["digits"]) - Decimal(b["digits"])), unit)

    def test_report(self):
        """The page lists the chief numbers where more digits are asked for than it shows."""
        self.assertNotIn("digits\n", run("solve", BLOCK_E)[1])
        page, angle = run("solve", "--digits", 30, BLOCK_E)[1], solve(BLOCK_E, "--digits", 30)["cases"][0]["toppling"]
        self.assertIn("To 30 digits", page)
        self.assertIn(f"critical angle           {angle['critical_angle_deg']['digits']}°\n", page)
        self.assertIn("critical angle           35.20078434973°", run("solve", "--digits", 13, BLOCK_E)[1])


class Level(unittest.TestCase):
    def test_level_is_kept(self):
        """What a level certifies it certifies as that level or a cheaper one; else it says so, exit 4."""
        for scene in example_scenes():
            for level in LEVELS:
                status, out, err = run("solve", "--json", "--level", level, scene)
                with self.subTest(scene=scene.name, level=level):
                    self.assertIn(status, (0, 4) if level != "exact" else (0,))
                    if status == 0:
                        self.assertLessEqual(LEVELS.index(json.loads(out)["level"]), LEVELS.index(level))
                    else:
                        self.assertEqual(out, "")
                        self.assertRegex(err, f"undecided at [0-9]+ bits of level {level}: a number is not certain to 9 digits")

    def test_digits_beyond_a_level(self):
        self.assertEqual(run("solve", "--level", "double", "--digits", 15, BLOCK_E)[0], 4)
        self.assertEqual(run("solve", "--level", "compensated", "--digits", 100, BLOCK_E)[0], 4)
        self.assertEqual(run("solve", "--level", "ball", "--digits", 300, BLOCK_E)[0], 0)
        self.assertEqual(solve(BLOCK_E, "--digits", 3)["level"], "double")

    def test_usage(self):
        for wrong in (("--digits", "0"), ("--digits", "1001"), ("--digits", "2.5"), ("--digits", "many"),
                      ("--level", "quad"), ("--level", "")):
            status, out, err = run("solve", *wrong, BLOCK_E)
            self.assertEqual((status, out), (2, ""))
            self.assertIn(wrong[0], err + "--digits" * ("not a number" in err))


if __name__ == "__main__":
    main()
