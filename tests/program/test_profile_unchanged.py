# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The roughness of profiles (docs/profile.md): what does not change under a mirror, another unit, a shift, a scale;
and profiles that are turned onto their mean plane first."""

import math
import random
import unittest
from fractions import Fraction

import profile_case
from harness import main, run
from profile_case import BOUNDED, JOINT, ProfileCase, decimals, exactly, joint, measures, uneven


class Unchanged(ProfileCase):
    def numbers(self, found):
        return {key: found[key]["value"] for key in BOUNDED}

    def test_mirrored(self):
        """Directions change places, and nothing else."""
        points = uneven(5, 60)
        one, other = self.profile(decimals(points)), self.profile(decimals(points), "--mirror")
        by_hand = self.profile(decimals([(-x, y) for x, y in reversed(points)]))
        for found in (other, by_hand):
            for key in BOUNDED:
                sign = -1 if key == "mean_slope" else 1
                self.near(found[key]["value"], sign * one[key]["value"], 1e-10)
            for a, b in zip(one["facing"], reversed(found["facing"])):
                self.assertEqual(a["facets"], b["facets"])
                for key in ("share", "angle_deg", "steepest_deg"):
                    self.near(a[key]["value"], b[key]["value"], 1e-9)
                self.near(a["roughness_deg"], b["roughness_deg"], 1e-6)
        self.assertTrue(other["sampling"]["mirrored"])

    def test_units(self):
        """The same profile in mm and in m: the same JRC and angles, lengths a thousandth."""
        points = joint()
        metres = "".join(f"{float(x) / 1000:.7f},{float(y) / 1000:.7f}\n" for x, y in points)
        one, other = self.profile(JOINT), self.profile(metres, "--unit", "m")
        self.assertEqual(other["length_unit"], "m")
        for key in ("length", "length_along", "amplitude", "rms_height"):
            self.near(other[key]["value"] * 1000, one[key]["value"], 1e-9)
        for a, b in zip(one["jrc"]["correlations"], other["jrc"]["correlations"]):
            self.assertEqual(a["state"], b["state"], a["equation"])
            self.near(a["jrc"]["value"], b["jrc"]["value"], 1e-6)
        self.near(one["correlation_length"]["value"], 1000 * other["correlation_length"]["value"], 1e-6)
        for a, b in zip(one["hurst"], other["hurst"]):
            self.near(a["exponent"]["value"], b["exponent"]["value"], 1e-9)

    def test_scaled(self):
        one, other = self.profile(JOINT), self.profile(JOINT, "--scale", "10")
        for key in BOUNDED:
            factor = 10 if key in ("length", "length_along", "amplitude", "rms_height") else 1
            self.near(other[key]["value"], factor * one[key]["value"], 1e-10)
        self.assertEqual(other["sampling"]["scale"], 10)

    def test_shifted(self):
        """A billion away the numbers are the same but for their last place, and the bounds as narrow."""
        points = uneven(8, 50)
        far = [(x + 10**9, y - 10**9) for x, y in points]
        one, other = self.profile(decimals(points)), self.profile("".join(
            f"{x.numerator / x.denominator:.3f},{y.numerator / y.denominator:.3f}\n" for x, y in far))
        for key in BOUNDED:
            self.near(one[key]["value"], other[key]["value"], one[key]["error"] + other[key]["error"])
            self.near(one[key]["error"], other[key]["error"], 1e-6 * one[key]["error"])


class Turned(ProfileCase):
    """A profile that was scanned as it lies in the field leans; its roughness is that about its mean plane."""

    @staticmethod
    def mean_plane(points):
        """The slope of the line of least squares across the line between both ends, in the frame of the points."""
        (x0, y0), (x1, y1) = points[0], points[-1]
        ex, ey = x1 - x0, y1 - y0
        own = [(ex * (x - x0) + ey * (y - y0), ex * (y - y0) - ey * (x - x0)) for x, y in points]
        weight = [(abs(c - a), a, b, c, d) for (a, b), (c, d) in zip(own, own[1:])]
        length = sum(w for w, *_ in weight)
        a_, b_ = (sum(w * (p[i] + p[i + 2]) / 2 for w, *p in weight) for i in (0, 1))
        aa = sum(w * (a * a + a * c + c * c) / 3 for w, a, _, c, _ in weight)
        ab = sum(w * (2 * a * b + a * d + c * b + 2 * c * d) / 6 for w, a, b, c, d in weight)
        m = (ab - a_ * b_ / length) / (aa - a_ * a_ / length)
        return (ey + m * ex) / (ex - m * ey)

    @staticmethod
    def turned(points, slope):
        """By the angle whose tangent that is, to some 50 digits."""
        h = profile_case.root(1 + slope * slope)
        cos, sin = Fraction(1) / Fraction(h), Fraction(slope) / Fraction(h)
        return [(cos * x + sin * y, cos * y - sin * x) for x, y in points]

    def test_turned(self):
        for seed in range(8):
            draw = random.Random(seed)
            flat = [(k + Fraction(draw.randint(0, 500), 1000), Fraction(draw.randint(-500, 500), 1000)) for k in range(40)]
            steep = [(Fraction(3, 5) * x - Fraction(4, 5) * y, Fraction(4, 5) * x + Fraction(3, 5) * y)
                     for x, y in flat]
            for points in (flat, steep):
                points = exactly([f"{float(v):.6f}" for v in point] for point in points)
                found = self.profile("".join(f"{float(x):.6f},{float(y):.6f}\n" for x, y in points), "--detrend", "turn")
                slope = self.mean_plane(points)
                self.near(found["trend_deg"]["value"], math.degrees(math.atan(slope)), 1e-10)
                truth = measures(self.turned(points, slope))
                for key in BOUNDED:
                    value, error = found[key]["value"], found[key]["error"]
                    # the direction is of doubles: off by some 1e-14, with sums of 40 points
                    self.near(value, float(truth[key]), error + 1e-11 * (1 + abs(value)))
                self.assertEqual(found["sampling"]["detrend"], "turn")

    def test_overhangs(self):
        """Teeth on a slope of 60 degrees overhang, and have no height at each x, until they are turned: then their
        numbers are those of teeth."""
        cos, sin = math.cos(math.radians(60)), math.sin(math.radians(60))
        teeth = [(10 * k, 7 if k % 2 else 0) for k in range(41)]
        path = self.write("".join(f"{cos * x - sin * y:.12f},{sin * x + cos * y:.12f}\n" for x, y in teeth))
        self.refused(path, "the profile folds back: point 2 lies left of point 1")
        found = self.profile(path, "--detrend", "turn")
        self.near(found["trend_deg"]["value"], 60, 1e-9)
        self.near(found["z2"]["value"], 0.7, 1e-9)
        self.near(found["length"]["value"], 400, 1e-8)
        sampled = self.profile(path, "--detrend", "turn", "--step", "0.5", "--mirror")
        self.assertTrue(sampled["sampling"]["even"])
        status, out, _ = run("profile", "--detrend", "turn", path)
        self.assertEqual(status, 0)
        self.assertIn("turned onto its mean plane, by 60°", out)

    def test_refused(self):
        self.refused(self.write("0,0\n5,1\n4,3\n20,0\n"), "turned onto its mean plane, by", "--detrend", "turn")
        self.refused(self.write("0,0\n-5,1\n"), "no mean plane that runs from left to right", "--detrend", "turn")
        self.refused(self.write("0,0\n1,1\n0,0\n"), "no mean plane", "--detrend", "turn")


if __name__ == "__main__":
    main()
