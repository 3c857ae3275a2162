# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of blocks on bases, and how what the program says of them is judged by contact_oracle.py and
limit_oracle.py. TOPPLE_CONTACT_SCENES sets how many scenes are drawn, TOPPLE_CONTACT_SEED where from."""

import math
import os
import pathlib
import tempfile
import unittest
from fractions import Fraction

import limit_oracle
from harness import rounds, run, solve

SCENES = int(os.environ.get("TOPPLE_CONTACT_SCENES", rounds(60, 1200)))
SEED = int(os.environ.get("TOPPLE_CONTACT_SEED", "1"))


def points_text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def mirror(points):
    return [(-x, y) for x, y in reversed(points)]


class ContactTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def cases(self, text):
        self.path.write_text(text)
        return {case["towards"]: case for case in solve(self.path)["cases"]}

    def refused(self, text):
        self.path.write_text(text)
        status, _, err = run("solve", "--json", self.path)
        return err if status == 3 else None

    def near(self, ball, truth, slack=1e-9):
        self.assertLessEqual(abs(ball["value"] - float(truth)), ball["error"] + slack * (1 + abs(float(truth))))

    def compare_contact(self, case, contact):
        told = case["contact"]
        self.assertEqual(told["facets"], len(contact.facets))
        self.assertEqual(told["points"], len(contact.points) + len(contact.corners))
        self.assertEqual(told["corner_points"], len(contact.corners))
        self.near(told["length_m"], contact.length())

    def compare_pivots(self, case, contact, centroid, towards):
        places = contact.places()
        told = sorted((p["x_m"]["value"], p["y_m"]["value"], p["admissible"], p["critical_angle_deg"]["value"])
                      for p in case["pivots"])
        sign = 1 if towards == "left" else -1
        truth = sorted((float(x), float(y), contact.admissible((x, y), towards),
                        math.degrees(math.atan2(sign * (centroid[0] - x), centroid[1] - y))) for x, y in places)
        self.assertEqual(len(told), len(truth))
        for one, other in zip(told, truth):
            self.assertEqual(one[2], other[2], (one, other))
            for a, b in zip(one, other):
                self.assertAlmostEqual(a, b, delta=1e-9 * (1 + abs(b)))

    def compare_sliding(self, case, contact, centroid, friction, towards):
        truth = contact.sliding(centroid, friction, towards)
        told = case["sliding"]["critical_angle_deg"] if "sliding" in case else None
        if truth in (None, "never"):
            self.assertIsNone(told)
        else:
            self.near(told, truth)

    def compare_limit(self, case, points, centroid, friction, towards):
        """Between the limits of tan(phi) from below and above; where these are not of one kind the scene
        is a tie, which rationals near the truth do not settle."""
        if towards == "right":
            points = [((-x, y), (tx, -ty)) for (x, y), (tx, ty) in points]
            centroid = (-centroid[0], centroid[1])
        limits = [limit_oracle.Limit(points, centroid, tan) for tan in limit_oracle.tangents(friction)]
        if len({l.kind for l in limits}) > 1:
            return False
        told = case["limit"]
        if limits[0].kind == "angle":
            for limit in limits:
                self.near(told["critical_angle_deg"], math.degrees(math.atan(limit.most)))
        else:
            self.assertIsNone(told["critical_angle_deg"])
            self.assertEqual(told["mechanism"] == "interlocked", limits[0].kind == "interlocked")
        return True
