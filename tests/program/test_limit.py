# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit of random contacts against brute force over all bases in exact whole numbers
(limit_oracle.py), with tan(phi) enclosed from below and above: the limit grows with it. Seeds are
fixed; TOPPLE_ROUNDS multiplies the number of rounds. Each test says which mechanisms its scenes must
come to, and how often at least: scenes that all end alike would compare little."""

import math
import random
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROUNDS, main
from limit_oracle import Limit, contacts, tangents
from limit_scenes import Scene, angle_of, dropped, friction, mated_polygon, mated_teeth, mirrored, tied, worn_profile

TIE = Decimal(10) ** -40  # degrees: what tan(phi) to 1e-42 leaves of ends that are one
MOST_POINTS = 12


class RandomContacts(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.seen = {}

    def tearDown(self):
        self.scene.folder.cleanup()

    def expected(self, outline, profile, angle, towards):
        """The oracle's answers with tan(phi) from below and above."""
        if towards == "right":
            outline, profile = mirrored(outline), mirrored(profile)
        points = contacts(outline, profile)
        if len(points) > MOST_POINTS:
            return None
        centroid = exact.centroid(exact.block_moments(outline))
        return [Limit(points, centroid, tangent) for tangent in tangents(angle)]

    def compare(self, limit, ends, towards):
        name = limit["mechanism"]
        self.assertNotEqual(name, "undecided")
        kinds = {end.kind for end in ends}
        self.assertEqual(len(kinds), 1)
        kind = kinds.pop()
        self.seen[name] = self.seen.get(name, 0) + 1
        if kind != "angle":
            self.assertEqual(name, "interlocked" if kind == "interlocked" else "holds nowhere")
            self.assertIsNone(limit["critical_angle_deg"])
            return
        found = limit["critical_angle_deg"]
        value, error = Decimal(found["value"]), Decimal(found["error"])
        self.assertGreaterEqual(value + error, angle_of(ends[0].most) - TIE)
        self.assertLessEqual(value - error, angle_of(ends[-1].most) + TIE)
        self.assertLessEqual(error, Decimal("1e-8"))
        self.compare_mechanism(limit, ends, towards)

    def compare_mechanism(self, limit, ends, towards):
        """The mechanism is one of the oracle's at the limit; a tie is told where it has two."""
        allowed = [m for end in ends for m in end.mechanisms.values()]
        tie = limit["tied_with"] is not None
        self.assertIn(tie, [len(end.mechanisms) > 1 for end in ends])
        if tie:
            self.seen["tie"] = self.seen.get("tie", 0) + 1
            self.assertIn(limit["tied_with"], [name for name, _ in allowed])
        for name, centre in allowed:
            if name == limit["mechanism"] and self.is_centre(limit, centre, towards):
                return
        self.fail(f"{limit} is none of {allowed}")

    def is_centre(self, limit, centre, towards):
        if centre is None:
            return limit["centre_x_m"] is None
        for key, own in (("centre_x_m", centre[0] if towards == "left" else -centre[0]),
                         ("centre_y_m", centre[1])):
            found = limit[key]
            if abs(Decimal(found["value"]) - exact.decimal(own)) > Decimal(found["error"]):
                return False
        return True

    def balance(self, case, outline, ends, towards):
        """The reactions at the limit: they balance the weight and its moment, each in the cone of a
        contact point."""
        limit = case["limit"]
        if limit["critical_angle_deg"] is None:
            return
        angle = math.radians(limit["critical_angle_deg"]["value"])
        gx, gy = (float(g) for g in exact.centroid(exact.block_moments(outline)))
        sums, slack = [0.0, 0.0, 0.0], [1e-13, 1e-13, 1e-13]
        side = 1 if towards == "left" else -1
        for r in limit["reactions"]:
            (x, dx), (y, dy), (fx, ex), (fy, ey) = ((r[k]["value"], r[k]["error"]) for k in
                                                    ("x_m", "y_m", "share_x", "share_y"))
            x, fx, g = side * x, side * fx, side * gx
            for k, (value, error) in enumerate(((fx, ex), (fy, ey),
                                                ((x - g) * fy - (y - gy) * fx,
                                                 (dx + dy) + abs(x - g) * ey + abs(y - gy) * ex))):
                sums[k] += value
                slack[k] += error + 1e-13 * (abs(x) + abs(y) + abs(gx) + abs(gy) + 1)
            tan = max(p / q for p, q in tangents(self.angle))
            self.assertTrue(any(
                abs(float(px) - x) + abs(float(py) - y) < 1e-9 * (abs(x) + abs(y) + 1)
                and abs(fx * tx + fy * ty) <= tan * (tx * fy - ty * fx) + 1e-9 * (1 + tan)
                * math.hypot(tx, ty) for (px, py), (tx, ty) in ends[0].points), (r, ends[0].points))
        self.assertLessEqual(abs(sums[0] - math.sin(angle)), slack[0])
        self.assertLessEqual(abs(sums[1] - math.cos(angle)), slack[1])
        self.assertLessEqual(abs(sums[2]), slack[2])

    def verdict(self, case, ends, tilt):
        """What statics rules out must not be said to stand; whether a motion can begin below that
        test_onset.py tells."""
        tan = exact.sin_cos(tilt)
        tan = Fraction(tan[0] / tan[1])
        margin = Fraction(1, 10**9)  # nearer to an end of the range is not judged here
        near = [end.holds(tan + off) for end in ends for off in (-margin, margin)]
        holds, fails = all(near), not any(near)
        if fails:
            self.assertNotIn(case["mechanism"], ("stands", "interlocked"))
        if holds:
            self.assertIn(case["mechanism"], ("stands", "interlocked", "may move"))

    def run_random(self, make, rounds, seed, draw_friction=friction, tilts=range(1, 61)):
        random.seed(seed)
        for _ in range(rounds * ROUNDS):
            block, base, outline, profile = make()
            self.angle = draw_friction()
            tilt = random.choice(tilts)
            ends = {towards: self.expected(outline, profile, self.angle, towards)
                    for towards in ("left", "right")}
            if ends["left"] is None:
                continue
            with self.subTest(scene=block, base=base, angle=self.angle):
                cases = None
                cases = self.scene.solve(block, base, self.angle, tilt=f", angle_deg: {tilt}")
            if cases is None:
                continue
            for towards, own in ends.items():
                with self.subTest(scene=self.scene.text, towards=towards):
                    self.compare(cases[towards]["limit"], own, towards)
                    self.balance(cases[towards], outline, own, towards)
                    self.verdict(cases[towards], own, tilt)

    def assert_seen(self, **least):
        """What the scenes came to, each so often at least, and nothing else."""
        seen = {name.replace(" ", "_"): count for name, count in self.seen.items()}
        self.assertEqual(set(seen), set(least))
        for name, count in least.items():
            self.assertGreaterEqual(seen[name], count, (name, seen))

    def test_teeth(self):
        self.run_random(mated_teeth, 60, 71)
        self.assert_seen(slides=10, topples=20, slides_and_topples=20, interlocked=20, holds_nowhere=2)

    def test_polygons(self):
        self.run_random(mated_polygon, 60, 72)
        self.assert_seen(slides=20, topples=5, slides_and_topples=8, interlocked=40)

    def test_worn_profiles(self):
        self.run_random(worn_profile, 60, 73)
        self.assert_seen(slides=6, topples=15, slides_and_topples=20, interlocked=15, holds_nowhere=15)

    def test_dropped(self):
        """Mostly on one point, where no friction keeps it from turning about that."""
        self.run_random(dropped, 60, 74)
        self.assert_seen(topples=40, holds_nowhere=25)

    def test_ties(self):
        """Not at a tilt of just the tie, where the factor is 1 by both and no bits decide it."""
        self.run_random(tied, 20, 75, lambda: 45, [k for k in range(1, 61) if k != 45])
        self.assert_seen(topples=1, tie=20, slides=1)


if __name__ == "__main__":
    main()
