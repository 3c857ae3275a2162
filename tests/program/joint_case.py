# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of blocks shifted along their mated base share: scenes of them, regular teeth, undersides drawn at random,
and their gaps, in the numbers that they are given."""

import pathlib
import tempfile
import unittest
from fractions import Fraction

from harness import run, solve

SEED = 1613
A, B, C = Fraction(30), Fraction(120), Fraction(5)


def text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def top_at(chain, x):
    """Of a chain from left to right over x: None beside it."""
    for (x0, y0), (x1, y1) in zip(chain, chain[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return None


def gaps_of(under, base, closure):
    """Largest and mean gap, length above the base, shares of the underside closed exactly, and within the closure."""
    low, high = max(under[0][0], base[0][0]), min(under[-1][0], base[-1][0])
    xs = sorted({x for x, _ in under + base if low <= x <= high} | {low, high})
    largest = area = touching = closed = 0
    for x0, x1 in zip(xs, xs[1:]):
        g0, g1 = (top_at(under, x) - top_at(base, x) for x in (x0, x1))
        largest = max(largest, g0, g1)
        area += (g0 + g1) / 2 * (x1 - x0)
        touching += (x1 - x0) * (g0 == 0 and g1 == 0)
        small, great = sorted((g0, g1))
        closed += (x1 - x0) * (1 if great <= closure else 0 if small >= closure else (closure - small) / (great - small))
    width = under[-1][0] - under[0][0]
    return largest, area / (high - low), high - low, touching / width, closed / width


def underside(draw):
    """Some vertices from left to right, their slopes below 45 degrees, all of three decimals."""
    points = [(Fraction(0), Fraction(0))]
    for _ in range(draw.randint(2, 7)):
        x, y = points[-1]
        step = Fraction(draw.randint(400, 1500), 1000)
        points.append((x + step, y + step * Fraction(draw.randint(-600, 600), 1000)))
    return points


class JointCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, block, base="{mated: true}", joint=None, more="", unit="mm"):
        joint = "" if joint is None else f"joint: {joint}\n"
        self.path.write_text(f"topple: 1\nlength_unit: {unit}\nblock: {{{block}}}\nbase: {base}\n{joint}"
                             f"friction_angle_deg: 40\n{more}", encoding="utf-8")

    def case(self, block, *args, **options):
        self.write(block, *args, **options)
        return solve(self.path)["cases"][0]

    def refused(self, why, block, *args, status=3, **options):
        self.write(block, *args, **options)
        ended, out, err = run("solve", self.path)
        self.assertEqual((ended, out), (status, ""), err)
        self.assertIn(why, err)

    def teeth(self, count=4, **options):
        left = f"teeth: {{count: {count}, width: {A}, height: {B}, depth: {C}, left_end: valley}}"
        return self.case(left, f"{{beyond: {{left: {2 * A}, right: {2 * A}}}}}", **options)

    def same(self, number, truth, metre=Fraction(1, 1000)):
        """Within its bound, and half a last digit of a double."""
        away = abs(Fraction(number["value"]) - Fraction(truth) * metre)
        self.assertLessEqual(away, Fraction(number["error"]) + abs(Fraction(truth) * metre) / 2 ** 53)

    def numbers(self, case):
        joint = case["joint"]
        return (joint["largest_gap_m"], joint["mean_gap_m"], joint["above_base_m"], case["contact"]["contact_ratio"],
                joint["matching"])
