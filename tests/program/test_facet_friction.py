# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Facets with frictions of their own: the limit, the onset and the factor by strength reduction of random contacts
against brute force in whole numbers (limit_oracle.py, onset_oracle.py), whose points find their friction by the outline
and the profile alone (facet_scenes.py). TOPPLE_ROUNDS multiplies the number of rounds."""

import math
import random
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from facet_scenes import angle_text, besides, draw_tangents, friction_text, pieces, rough_contacts, whole_tangent
from harness import ROUNDS, main, rounds
from limit_oracle import Limit, dot
from limit_scenes import Scene, dropped, mated_polygon, mated_teeth, mirrored, worn_profile
from onset_case import degrees_of, rough_tangent
from onset_oracle import Onset, gyration

TIE = Decimal(10) ** -35  # degrees: what tan(phi) to 1e-44 leaves
MOST_POINTS = 12
FARTHEST = 1e30  # m: turns about farther points are slides but for the last digits of the friction angles
MOST_OF_ONSET = 7


class OwnLimit(Limit):
    """A turn by which all that resists it slips along one direction is told as the slide it is."""

    def mechanism(self, twist):
        name, centre = super().mechanism(twist)
        resisting = {t for k, (_, t) in enumerate(self.points)
                     if any(dot(twist, column) == 0 for column in self.columns_of[k])}
        return ("slides", None) if name == "slides and topples" and len(resisting) == 1 else (name, centre)

    def __init__(self, points, centroid, tangents):
        self.columns_of = []
        for ((x, y), (tx, ty)), (p, q) in zip(points, tangents):
            forces = [(-ty * q + side * tx * p, tx * q + side * ty * p) for side in (1, -1)]
            self.columns_of.append([(fx, fy, x * fy - y * fx) for fx, fy in forces])
        super().__init__(points, centroid, tangents)


class Drawn:
    """A random scene, and its oracles by side."""

    def __init__(self, make):
        while True:
            self.block, self.base, self.outline, self.profile = make()
            self.scene, self.tangents, self.entries = draw_tangents(self.block, self.base, self.profile, make,
                                                                    rough_tangent)
            self.count = len(rough_contacts(self.outline, self.profile, self.tangents))
            self.has_beside = False
            if self.entries and 0 < self.count <= MOST_POINTS:
                return

    def contact(self, side):
        outline, profile, tangents = self.outline, self.profile, self.tangents
        if side == "right":
            outline, profile, tangents = mirrored(outline), mirrored(profile), tangents[::-1]
        own = rough_contacts(outline, profile, tangents)
        beside = besides(outline, profile, tangents)
        return outline, exact.centroid(exact.block_moments(outline)), own, beside

    def limit(self, side, factor=1):
        _, centroid, own, _ = self.contact(side)
        return OwnLimit([(p, t) for p, t, _ in own], centroid, [whole_tangent(tangent / factor) for _, _, tangent in own])

    def onset(self, side):
        outline, centroid, own, beside = self.contact(side)
        every = [(*contact, 0) for contact in own] + beside
        self.has_beside = self.has_beside or len(beside) > 0
        return Onset([(p, t) for p, t, _, _ in every], centroid, gyration(outline, centroid),
                     [tangent for _, _, tangent, _ in every], [sense for _, _, _, sense in every])


class Random(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.addCleanup(self.scene.folder.cleanup)
        self.seen = {}

    def is_angle(self, found, tangent):
        """Does the printed number hold the oracle's, whose tangent is given?"""
        self.assertLessEqual(abs(Decimal(found["value"]) - degrees_of(tangent)), Decimal(found["error"]) + TIE)
        self.assertLessEqual(found["error"], 1e-8)

    def compare_limit(self, limit, truth):
        name = limit["mechanism"]
        self.seen[name] = self.seen.get(name, 0) + 1
        if truth.kind != "angle":
            self.assertEqual(name, "interlocked" if truth.kind == "interlocked" else "holds nowhere")
            return
        self.is_angle(limit["critical_angle_deg"], truth.most)
        if limit["centre_x_m"] is not None and abs(limit["centre_x_m"]["value"]) > FARTHEST:
            name = "slides"
        self.assertIn(name, {own for own, _ in truth.mechanisms.values()})

    def compare_onset(self, onset, truth):
        self.assertEqual(len(onset["windows"]), len(truth.windows), (onset, truth.windows))
        for found, ends in zip(onset["windows"], truth.windows):
            for key, tangent in zip(("from_deg", "to_deg"), ends):
                self.assertEqual(found[key] is None, tangent is None)
                if tangent is not None:
                    self.is_angle(found[key], tangent)

    def compare_factor(self, fos, drawn, side, tilt):
        """Held with the strength divided by a little less than the factor, not by a little more."""
        if not isinstance(fos, dict) or fos["value"] > 1e6:
            return
        tangent = Fraction(math.tan(math.radians(tilt)))
        factor, slack = Fraction(fos["value"]), Fraction(fos["error"]) + Fraction(fos["value"]) / 10**9
        self.assertTrue(drawn.limit(side, factor - slack).holds(tangent))
        self.assertFalse(drawn.limit(side, factor + slack).holds(tangent))
        self.seen["factor"] = self.seen.get("factor", 0) + 1

    def run_random(self, make, count, seed, **least):
        """So many scenes, a third of them but in the long rounds; `least` of all that came."""
        random.seed(seed)
        part = rounds(3, 1)
        for _ in range(count // part * ROUNDS):
            drawn, tilt = Drawn(make), random.randint(1, 60)
            cases = None
            with self.subTest(block=drawn.block, base=drawn.base, entries=drawn.entries):
                cases = self.scene.solve(drawn.block, drawn.base, angle_text(drawn.scene),
                                         friction_text(drawn.entries), f", angle_deg: {tilt}")
            for side in cases or ():
                with self.subTest(scene=self.scene.text, side=side):
                    self.compare_limit(cases[side]["limit"], drawn.limit(side))
                    self.compare_factor(cases[side]["limit"]["fos"], drawn, side, tilt)
                    if drawn.count <= MOST_OF_ONSET:
                        self.compare_onset(cases[side]["onset"], drawn.onset(side))
                        self.seen["onset"] = self.seen.get("onset", 0) + 1
                        self.seen["beside"] = self.seen.get("beside", 0) + drawn.has_beside
        for name, expected in least.items():
            self.assertGreaterEqual(self.seen.get(name.replace("_", " "), 0), expected // part, self.seen)

    def test_teeth(self):
        self.run_random(mated_teeth, 25, 171, topples=5, slides_and_topples=5, factor=5, onset=5, beside=3)

    def test_polygons(self):
        self.run_random(mated_polygon, 25, 172, slides=5, slides_and_topples=3, factor=5, onset=5, beside=3)

    def test_worn_profiles(self):
        self.run_random(worn_profile, 25, 173, topples=3, slides_and_topples=5, factor=3, onset=5)

    def test_pieces(self):
        """Of one slope, whose facets all slip at once."""
        self.run_random(pieces, 40, 175, slides=10, topples=10, factor=20, onset=20)

    def test_dropped(self):
        self.run_random(dropped, 25, 174, topples=8, onset=10)


if __name__ == "__main__":
    main()
