# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The onset of motion: every window of tilts in which a motion can begin, against trial of every
contact mode (onset_oracle.py), with friction angles whose tangent is a short fraction to 45 digits.
TOPPLE_ROUNDS multiplies the number of rounds."""

import random
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROUNDS, main
from limit_scenes import Scene, dropped, mated_polygon, mated_teeth, worn_profile
from onset_case import degrees_of, onset_of, rough_tangent

TIE = Decimal(10) ** -35  # degrees: what tan(phi) to 1e-44 leaves


class Trial(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.seen = 0

    def tearDown(self):
        self.scene.folder.cleanup()

    def is_end(self, found, tangent):
        """Does the printed end, or null, hold the oracle's?"""
        if tangent is None or found is None:
            self.assertEqual(tangent, found)
            return
        self.assertLessEqual(abs(Decimal(found["value"]) - degrees_of(tangent)),
                             Decimal(found["error"]) + TIE)
        self.assertLessEqual(found["error"], 1e-8)

    def compare(self, case, truth):
        onset = case["onset"]
        self.assertNotEqual(onset["kind"], "undecided")
        self.assertEqual(len(onset["windows"]), len(truth.windows), (onset, truth.windows))
        for found, (low, high) in zip(onset["windows"], truth.windows):
            self.is_end(found["from_deg"], low)
            self.is_end(found["to_deg"], high)
        self.compare_first(onset, truth)
        limit = case["limit"]["critical_angle_deg"]
        if limit is not None and onset["critical_angle_deg"] is not None:
            angle = onset["critical_angle_deg"]
            self.assertLessEqual(angle["value"] - angle["error"], limit["value"] + limit["error"])

    def compare_first(self, onset, truth):
        """The window that holds level ground, or the first above it."""
        first = next((w for w in truth.windows if w[1] is None or w[1] >= 0), None)
        if first is None:
            self.assertEqual(onset["kind"], "never")
        elif first[0] is None:
            self.assertEqual(onset["kind"], "nowhere")
        else:
            self.assertEqual(onset["kind"], "angle")
            self.is_end(onset["critical_angle_deg"], first[0])
            self.assertIn(onset["mechanism"], truth.names(first[0]))

    def verdict(self, case, truth, tilt):
        """No block stands, or is interlocked, where a motion can begin."""
        sine, cosine = exact.sin_cos(tilt)
        tan = Fraction(sine / cosine)
        near = Fraction(1, 10**9)
        inside = any((low is None or low + near < tan) and (high is None or tan < high - near)
                     for low, high in truth.windows)
        outside = all((low is not None and tan < low - near) or (high is not None and tan > high + near)
                      for low, high in truth.windows)
        beginnings = {m["mechanism"] for m in case["motions"]}
        self.assertEqual(set(case["can_begin"]), beginnings)
        self.assertEqual(len(case["can_begin"]), len(beginnings))
        if inside:
            self.assertNotIn(case["mechanism"], ("stands", "interlocked"))
            self.assertIn(case["mechanism"], {"may move"} | beginnings)
        if outside:
            self.assertIn(case["mechanism"], ("stands", "interlocked"))

    def newton(self, case, truth, tilt, side):
        """A motion that begins is one of the trial's modes, and its forces and the weight give the
        centroid its acceleration."""
        sine, cosine = (float(x) for x in exact.sin_cos(tilt))
        names = truth.names(Fraction(exact.sin_cos(tilt)[0] / exact.sin_cos(tilt)[1]))
        if case["onset"]["windows"] and not case["motions"]:
            self.assertFalse(names)
        for motion in case["motions"]:
            self.assertIn(motion["mechanism"], names)
            shares = [c for c in motion["contacts"] if "share_x" in c]
            if len(shares) != len(motion["contacts"]):
                continue
            down = -sine if side == "left" else sine
            for own, key, share in ((down, "acceleration_x_g", "share_x"),
                                    (-cosine, "acceleration_y_g", "share_y")):
                force = own + sum(c[share]["value"] for c in shares)
                self.assertAlmostEqual(force, motion[key]["value"], delta=1e-9)
            self.seen += 1

    def solve(self, block, base, tangent, tilt):
        angle = degrees_of(tangent) if tangent not in (0, 1) else {0: 0, 1: 45}[tangent]
        return self.scene.solve(block, base, angle, tilt=f", angle_deg: {tilt}")

    def run_random(self, make, rounds, seed):
        random.seed(seed)
        done = 0
        while done < rounds * ROUNDS:
            block, base, outline, profile = make()
            tangent, tilt = rough_tangent(), random.randint(1, 60)
            truth = {side: onset_of(outline, profile, tangent, side) for side in ("left", "right")}
            if truth["left"] is None:
                continue
            done += 1
            cases = None
            with self.subTest(scene=block, base=base, tangent=tangent):
                cases = self.solve(block, base, tangent, tilt)
            for side in truth if cases else ():
                with self.subTest(scene=self.scene.text, side=side, tangent=tangent):
                    self.compare(cases[side], truth[side])
                    self.verdict(cases[side], truth[side], tilt)
                    self.newton(cases[side], truth[side], tilt, side)
        self.assertGreater(self.seen, rounds // 4)

    def test_polygons(self):
        self.run_random(mated_polygon, 25, 81)

    def test_teeth(self):
        self.run_random(mated_teeth, 10, 82)

    def test_worn_profiles(self):
        self.run_random(worn_profile, 25, 83)

    def test_dropped(self):
        self.run_random(dropped, 40, 84)


if __name__ == "__main__":
    main()
