# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The roughness of profiles (docs/profile.md): numbers with a bound against rationals and closed forms."""

import csv
import io
import math
import unittest
from fractions import Fraction

import profile_case
from harness import main, run
from profile_case import BOUNDED, JOINT, ProfileCase, decimals, joint, measures, uneven


class AgainstRationals(ProfileCase):
    def check(self, found, points):
        truth = measures(points)
        for key in BOUNDED:
            self.bounded(found[key], truth[key], 9)
        if found["sampling"]["even"]:
            self.bounded(found["sf"], truth["sf"], 9)
        else:
            self.assertIsNone(found["sf"])
        self.near(found["effective_angle_deg"]["value"], math.degrees(math.atan(truth["mean_absolute_slope"])), 1e-12)

    def test_as_given(self):
        for seed in range(30):
            points = uneven(seed, 2 + seed * seed % 60)
            with self.subTest(seed):
                self.check(self.profile(decimals(points)), points)

    def test_the_example(self):
        self.check(self.profile(JOINT), joint())

    def test_detrended_by_least_squares(self):
        for seed in range(10):
            points = uneven(seed, 40)
            flat, slope = profile_case.detrended(points)
            found = self.profile(self.write(decimals(points)), "--detrend", "line")
            self.check(found, flat)
            self.near(found["trend_deg"]["value"], math.degrees(math.atan(slope)), 1e-12)
            again, none = profile_case.detrended(flat)
            self.assertEqual(none, 0)

    def test_detrended_by_its_ends(self):
        points = uneven(3, 40)
        (x0, y0), (x1, y1) = points[0], points[-1]
        ends = [(x, y - y0 - (x - x0) * (y1 - y0) / (x1 - x0)) for x, y in points]
        found = self.profile(decimals(points), "--detrend", "ends")
        self.check(found, ends)
        self.assertLess(abs(found["mean_slope"]["value"]), 1e-12)

    def test_resampled(self):
        for seed, step in ((1, "0.5"), (2, "0.125"), (3, "3")):
            points = uneven(seed, 50)
            found = self.profile(decimals(points), "--step", step)
            truth = profile_case.resampled(points, step)
            self.assertEqual(found["sampling"]["points"], len(truth))
            self.assertTrue(found["sampling"]["even"])
            self.check(found, truth)

    def test_spline(self):
        """Through points of a cubic the natural spline is not the cubic, but through those of a line it is the line,
        and through those of a sine it is nearer than the chords by orders."""
        line = [(k, Fraction(k, 4)) for k in range(20)]
        found = self.profile(decimals(line), "--step", "0.3", "--resample", "spline")
        self.near(found["z2"]["value"], 0.25, 1e-12)
        sine = [(Fraction(k, 10), math.sin(k / 10)) for k in range(1001)]
        truth = math.sqrt(0.5 + math.sin(200) / 400)  # of cos^2 from 0 to 100
        text = "".join(f"{float(x):.1f},{y:.12f}\n" for x, y in sine)
        chords = abs(self.profile(text)["z2"]["value"] - truth)
        spline = abs(self.profile(text, "--step", "0.01", "--resample", "spline")["z2"]["value"] - truth)
        self.assertLess(50 * spline, chords)

    def test_facing(self):
        """Share, angle and the steepest of the facets against a block that slides to either side."""
        for seed in range(10):
            points = uneven(seed, 30)
            found = self.profile(decimals(points))
            along = measures(points)["length_along"]
            for own, sign in zip(found["facing"], (-1, 1)):
                facing = [(dx, sign * dy) for dx, dy in profile_case.facets(points) if sign * dy > 0]
                self.assertEqual(own["towards"], "left" if sign < 0 else "right")
                self.assertEqual(own["facets"], len(facing))
                self.bounded(own["share"], sum(profile_case.root(dx * dx + dy * dy) for dx, dy in facing) / along, 9)
                rise, run_ = sum(dy for _, dy in facing), sum(dx for dx, _ in facing)
                self.near(own["angle_deg"]["value"], math.degrees(math.atan(rise / run_)), 1e-10)
                steepest = max(dy / dx for dx, dy in facing)
                self.near(own["steepest_deg"]["value"], math.degrees(math.atan(steepest)), 1e-10)

    def test_grasselli_is_least_squares(self):
        """No other exponent leaves less; and the measure is near the mean angle of facing facets, whose integral it
        stands for."""
        found = self.profile(JOINT)
        angles = [(math.hypot(dx, dy), math.degrees(math.atan(float(dy / dx)))) for dx, dy in profile_case.facets(joint())]
        for own, sign in zip(found["facing"], (-1, 1)):
            facing = [(length, sign * angle) for length, angle in angles if sign * angle > 0]
            steepest, total = max(angle for _, angle in facing), sum(length for length, _ in facing)
            grid = [(j + 0.5) / 200 for j in range(200)]
            shares = [sum(length for length, angle in facing if angle >= t * steepest) / total for t in grid]

            def left(exponent):
                return sum((s - (1 - t) ** exponent) ** 2 for s, t in zip(shares, grid))

            best = left(own["exponent"])
            self.assertLess(best, min(left(own["exponent"] - 1e-4), left(own["exponent"] + 1e-4)))
            self.near(own["fit_rms"], math.sqrt(best / 200) * own["share"]["value"], 1e-9)
            self.near(own["roughness_deg"], own["steepest_deg"]["value"] / (own["exponent"] + 1), 1e-12)
            mean = sum(length * angle for length, angle in facing) / total
            self.near(own["roughness_deg"], mean, 0.1 * mean)


class ClosedForms(ProfileCase):
    def teeth(self, count, run_=10, rise=3):
        return [(k * run_, rise if k % 2 else 0) for k in range(count + 1)]

    def test_teeth(self):
        """Z2 = tan i, i of every facet, Rp = 1 / cos i, RMS height A / sqrt(12), C = 0."""
        found = self.profile(self.teeth(8))
        i = math.atan(0.3)
        self.near(found["z2"]["value"], 0.3, 1e-15)
        self.near(found["effective_angle_deg"]["value"], math.degrees(i), 1e-13)
        self.near(found["rp"]["value"], 1 / math.cos(i), 1e-14)
        self.near(found["rms_height"]["value"], 3 / math.sqrt(12), 1e-14)
        for own in found["facing"]:
            self.assertEqual((own["facets"], own["exponent"]), (4, 0))
            self.near(own["share"]["value"], 0.5, 1e-14)
            for key in ("angle_deg", "steepest_deg"):
                self.near(own[key]["value"], math.degrees(i), 1e-13)
            self.near(own["roughness_deg"], math.degrees(i), 1e-13)

    def test_facets_of_teeth(self):
        status, out, _ = run("profile", "--csv", self.write(self.teeth(4)))
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual((status, len(rows)), (0, 4))
        for k, row in enumerate(rows):
            self.assertEqual((float(row["x0"]), float(row["y1"])), (10 * k, 0 if k % 2 else 3))
            self.near(float(row["angle_deg"]), math.degrees(math.atan(-0.3 if k % 2 else 0.3)), 1e-13)
            self.assertEqual(row["faces"], "left" if k % 2 else "right")

    def sine(self, periods, per_period, amplitude=2.0, wavelength=16.0):
        step = wavelength / per_period
        return "".join(f"{k * step:.17g},{amplitude * math.sin(2 * math.pi * k / per_period):.17g}\n"
                       for k in range(periods * per_period + 1))

    def test_sine(self):
        """RMS height a / sqrt(2), Z2 = sqrt(2) pi a / wavelength, the autocorrelation's fall, the structure function
        2 a^2 sin^2(pi d / wavelength), the peak of the spectrum: all but for the chords, whose sagitta is
        (pi / points per period)^2 / 2 of the amplitude."""
        per, chords = 64, (math.pi / 64) ** 2
        found = self.profile(self.sine(64, per))
        self.near(found["rms_height"]["value"], 2 / math.sqrt(2), 2 * chords)
        self.near(found["z2"]["value"], math.sqrt(2) * math.pi * 2 / 16, chords)
        fall = 16 * math.acos(1 / math.e) / (2 * math.pi)
        self.near(found["correlation_length"]["value"], fall, 16 / per * 0.1)
        self.assertIsNone(found["correlation_length"]["low"])
        for lag in found["lags"]:
            truth = 8 * math.sin(math.pi * lag["distance"] / 16) ** 2
            self.near(lag["structure"], truth, 8 * 4 * lag["distance"] / 1024)  # of the pairs that are left
        bands = found["spectrum"]["bands"]
        peak = max(bands, key=lambda band: band["density"])
        self.near(math.log10(peak["frequency"] * 16), 0, 0.1)  # a band is a tenth of a decade wide

    def test_straight(self):
        """No roughness but its lean: the series have no exponent, the logarithm no number."""
        found = self.profile([(k, 0) for k in range(400)])
        self.assertEqual(found["z2"]["value"], 0)
        self.assertEqual([own["facets"] for own in found["facing"]], [0, 0])
        self.assertTrue(all(own["exponent"] is None for own in found["hurst"]))
        states = {own["equation"]: own["state"] for own in found["jrc"]["correlations"]}
        self.assertEqual(states["32.2 + 32.47 log10 Z2"], "no number")
        lean = self.profile([(k, k) for k in range(400)])
        self.near(lean["trend_deg"]["value"], 45, 1e-12)
        self.assertIn("leans", lean["notes"][0]["text"])
        flat = self.profile([(k, k) for k in range(400)], "--detrend", "line")
        self.assertLess(flat["z2"]["value"], 1e-12)


if __name__ == "__main__":
    main()
