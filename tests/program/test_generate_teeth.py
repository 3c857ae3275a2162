# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Teeth made by rule, and the noise and wear of any profile: regular teeth tell of a block what its mated base does, and
give the formulas of the paper; scatter and noise keep their ranges, and wear takes off what it should, at every point of
the CSV that the program writes."""

import json
import math
import random
from fractions import Fraction

from generate_case import TEETH, WIDE, GenerateCase, scene
from harness import main, run, solve

NARROW = "block: {outline: [[20, 90], [40, 90], [40, 92], [20, 92]]}"


def height(points, x):
    """Of a profile without upright steps."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    raise ValueError(x)


class Teeth(GenerateCase):
    def test_teeth_as_mated(self):
        """Regular teeth are the base of the paper's blocks: everything that is told of the block is
        that of a mated base."""
        block = ("block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}, "
                 "unit_weight_kn_m3: 25.8}\nfriction_angle_deg: 30\ntilt: {angle_deg: 20}\n")
        own = solve(self.write(scene(TEETH % (7, ", start: [-60, 0]"), block=block, base="place: as_given")))
        mated = solve(self.write(f"topple: 1\nlength_unit: mm\n{block}"
                                 "base: {mated: true, beyond: {left: 60, right: 60}}\n"))
        for mine, other in zip(own["cases"], mated["cases"], strict=True):
            for key in ("pivots", "toppling", "sliding", "limit", "onset", "governing_fos", "mechanism"):
                self.assertEqual(mine[key], other[key], key)

    def test_teeth_in_formulas(self):
        """(A1.1) and its like come out of the generated base as of the mated one; a symbol in its rule is refused."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {a: 30, b: 120, c: 5}\n"
                "block: {teeth: {count: 3, width: a, height: b, depth: c, left_end: valley}}\nbase: {%s}\n")
        formulas = [run("derive", self.write(text % base))[1]
                    for base in ("profile: {" + TEETH % (3, "") + "}", "mated: true")]
        self.assertIn("tan(alpha_crit) = (27*a*b + 13*a*c)/(9*b^2 + 18*b*c + 6*c^2)", formulas[0])
        self.assertEqual(*formulas)
        symbol = text % ("profile: {" + (TEETH % (3, "")).replace("60", "2*a") + "}")
        status, _, err = run("derive", self.write(symbol))
        self.assertEqual(status, 3)
        self.assertIn(":5:48: derive takes a profile made by rule by its numbers, and 'a' stands for any", err)
        self.assertEqual(run("solve", self.path / "scene.yaml")[0], 0)

    def test_scattered_teeth(self):
        """Every tooth within its ranges, as far as both ends of them in 400 teeth; valleys at one height."""
        scattered = ", seed: 11, skew: 0.25, scatter: {wavelength: 0.2, amplitude: 0.5, skew: 0.25}"
        _, points = self.profile(TEETH % (800, scattered), block=WIDE)
        self.assertEqual({y for _, y in points[::2]}, {0})
        widths, skews = [], []
        for (x0, _), (x1, _), (x2, _) in zip(points[::2], points[1::2], points[2::2]):
            widths.append(float(x2 - x0) / 60)
            skews.append(float((x1 - x0) - (x2 - x1)) / float(x2 - x0))
        heights = [float(y) / 5 for _, y in points[1::2]]
        for values, middle, scatter in ((widths, 1, 0.2), (skews, 0.25, 0.25), (heights, 1, 0.5)):
            self.assertEqual(len(values), 400)
            self.assertLess(max(abs(v - middle) for v in values), scatter * 1.0001)
            for end in (-1, 1):
                self.assertGreater(max(end * (v - middle) for v in values), 0.97 * scatter)  # 1 in 10^2.6 misses
            self.assertAlmostEqual(math.fsum(values) / 400, middle, delta=4 * scatter / math.sqrt(1200))
        only, _ = self.profile(TEETH % (800, ", seed: 11, scatter: {amplitude: 0.5}"), block=WIDE)
        self.assertIn("\n30,", only)

    def test_found(self):
        """A number within the rule is found as others are: the slope of one facet at which a wedge
        on it topples at 35 degrees, solved anew at what was found."""
        text = ("topple: 1\nlength_unit: mm\nparameters: {h: %s}\n"
                "block: {outline: [[0, h], [40, 0], [40, 80], [0, 80]]}\n"
                "tilt: {towards: left}\n"
                "base: {profile: {teeth: {count: 1, wavelength: 80, amplitude: h, left_end: peak}}}\n")
        status, out, err = run("solve", "--json", self.write(text % 5), "--find", "h", "--for", "critical_angle=35",
                               "--from", 1, "--to", 60)
        self.assertEqual((status, err), (0, ""))
        found = json.loads(out)["find"]["solutions"]
        self.assertGreater(len(found), 0)
        case = solve(self.write(text % found[0]["value"]))["cases"][0]
        self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], 35, delta=1e-7)

    def test_noise(self):
        """Points move along y alone, by six deviations at most, with their standard deviation and mean."""
        line = [(Fraction(k, 4), Fraction(k % 7, 8)) for k in range(3000)]
        self.write("\n".join(f"{float(x)},{float(y)}" for x, y in line), "line.csv")
        _, points = self.profile("measured: line.csv, noise: {deviation: 0.05, seed: 2}", block=WIDE)
        self.assertEqual([x for x, _ in points], [x for x, _ in line])
        moved = [float(b - a) for (_, a), (_, b) in zip(line, points)]
        self.assertLess(max(map(abs, moved)), 6 * 0.05)
        self.assertAlmostEqual(math.fsum(moved) / 3000, 0, delta=4 * 0.05 / math.sqrt(3000))
        deviation = math.sqrt(math.fsum(m * m for m in moved) / 3000)
        self.assertAlmostEqual(deviation, 0.05, delta=4 * 0.05 / math.sqrt(6000))

    def test_wear(self):
        """Cut: the lower of the profile and the level, everywhere. Abraded: above the mean in
        proportion. Rounded: never above what was there, lower than it by at most the depth, and at a
        tip by the depth, or by all that half of its edges allow."""
        draw = random.Random(5)
        for _ in range(4):
            line = [(Fraction(k), Fraction(draw.randint(0, 4000), 1000)) for k in range(60)]
            self.write("\n".join(f"{x},{float(y)}" for x, y in line), "line.csv")
            top = max(y for _, y in line)
            worn = {how: self.profile(f"measured: line.csv, worn: {{{how}: 0.7}}", block=NARROW)[1]
                    for how in ("cut", "abraded", "rounded")}
            mean = sum(y for _, y in line) / len(line)
            depth = Fraction(7, 10)
            for k in range(1, 590):
                x = Fraction(k, 10) + Fraction(1, 37)
                before = height(line, x)
                self.assertAlmostEqual(height(worn["cut"], x), min(before, top - depth), delta=1e-5)
                after = height(worn["rounded"], x)
                self.assertLess(after, before + Fraction(1, 10 ** 6))
                self.assertGreater(after, before - depth - Fraction(1, 10 ** 6))
            for (x, y), (_, after) in zip(line, worn["abraded"], strict=True):
                left = y if y <= mean else mean + (y - mean) * (1 - depth / (top - mean))
                self.assertAlmostEqual(after, left, delta=1e-6)
            for (x, y), a, b in zip(line[1:-1], line, line[2:]):
                blunt = min(depth, (2 * y - a[1] - b[1]) / 8)
                self.assertAlmostEqual(height(worn["rounded"], x), y - max(blunt, 0), delta=1e-5)


if __name__ == "__main__":
    main()
