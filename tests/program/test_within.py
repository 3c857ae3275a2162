# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`contact: {within: …}`, and the near misses that are named without it.

Blocks that rest exactly on a profile, written with twelve, six or three digits, lost contacts in silence or were
refused. Now that is said, and by how much; and on request all that lies so near touches again. Distances are computed
here anew, over all pairs, in fractions."""

import math
import pathlib
import random
import re
import tempfile
import unittest
from fractions import Fraction

import rest_oracle
import test_rest
from harness import main, run, solve

SEED = 1616
SCENES = 40


def distance(point, a, b):
    """From a point to a piece of a line, in doubles of exact fractions."""
    ex, ey = b[0] - a[0], b[1] - a[1]
    rx, ry = point[0] - a[0], point[1] - a[1]
    share = max(Fraction(0), min(Fraction(1), (rx * ex + ry * ey) / (ex * ex + ey * ey)))
    return math.sqrt((rx - share * ex) ** 2 + (ry - share * ey) ** 2)


def exact(points):
    return [(Fraction(str(x)), Fraction(str(y))) for x, y in points]


def text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def rounded(points, digits):
    return [tuple(f"{float(v):.{digits}f}" for v in point) for point in points]


def mated(draw):
    """A profile and a block whose underside is a part of it; both of few digits."""
    count = draw.randint(3, 8)
    xs = [Fraction(k) + Fraction(draw.randint(-200, 200), 1000) for k in range(count + 4)]
    profile = [(x, Fraction(draw.randint(-300, 300), 1000)) for x in xs]
    under = profile[2:-2]
    return under + [(under[-1][0], Fraction(4)), (under[0][0], Fraction(4))], profile


def resting(draw):
    """A block on two or three of its corners, each in the middle of an edge of the profile, by thirds and sevenths."""
    profile = [(Fraction(2 * k), Fraction(draw.randint(-300, 300), 1000)) for k in range(7)]
    under = []
    for k in range(1, 5):
        (x0, y0), (x1, y1) = profile[k], profile[k + 1]
        share = Fraction(draw.randint(2, 5), 7)
        under.append((x0 + share * (x1 - x0), y0 + share * (y1 - y0)))
        under.append((x1, max(y1, y0, profile[min(k + 2, 6)][1]) + Fraction(1, 3) + Fraction(1, 2)))
    under.pop()
    return under + [(under[-1][0] + 1, Fraction(5)), (under[0][0] - 1, Fraction(5))], profile


class Within(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, block, profile, within=None, more="", unit="m"):
        contact = "" if within is None else f"contact: {{within: {within}}}\n"
        self.path.write_text(f"topple: 1\nlength_unit: {unit}\nblock: {{outline: {text(block)}}}\n"
                             f"base: {{profile: {text(profile)}}}\nfriction_angle_deg: 40\n{contact}{more}",
                             encoding="utf-8")

    def cases(self, block, profile, **options):
        self.write(block, profile, **options)
        return solve(self.path)["cases"]

    def test_rounded_poses(self):
        """The moved block is the exact one within twice what was rounded, and so are its angles, within what an arm of
        1 turns by that, 60 degrees a unit, and some ten of these for how it presses; the verdict is the same."""
        draw = random.Random(SEED)
        for number in range(SCENES):
            block, profile = draw.choice([mated, resting])(draw)
            truth = self.cases(block, profile)
            for digits in (12, 6, 3):
                step = 10.0 ** -digits
                with self.subTest(number=number, digits=digits):
                    found = self.cases(rounded(block, digits), profile, within=f"{2 * step:.{digits}f}")
                    for own, other in zip(truth, found):
                        self.assertEqual(own["mechanism"], other["mechanism"])
                        self.assertLessEqual(other["within"]["farthest_m"]["value"], step)
                        self.assertLessEqual(other["within"]["overlap_removed_m"]["value"], step)
                        self.assertEqual(own["contact"]["facets"], other["contact"]["facets"])
                        self.assertEqual(own["contact"]["points"], other["contact"]["points"])
                        for key in ("toppling", "limit"):
                            a, b = (case[key]["critical_angle_deg"]["value"] for case in (own, other))
                            self.assertAlmostEqual(a, b, delta=600 * step + 1e-7)

    def test_poses_of_last_digits(self):
        """Poses that a search in small steps left within 1e-5 of rest, against those that `place: rest` finds."""
        draw = random.Random(SEED + 3)
        seen = 0
        for number in range(SCENES):
            block, profile = test_rest.random_block(draw), test_rest.random_profile(draw)
            how, outline = rest_oracle.rest(block, profile)
            if how != "rests":
                continue
            with self.subTest(number=number, block=block, profile=profile):
                self.write(block, profile, more="")
                self.path.write_text(self.path.read_text().replace("]]}\nfriction", "]], place: rest}\nfriction"))
                truth = solve(self.path)["cases"]
                found = self.cases(outline, profile, within="0.0002")
                seen += 1
                for own, other in zip(truth, found):
                    self.assertEqual(own["contact"]["facets"], other["contact"]["facets"])
                    self.assertEqual(own["contact"]["corner_points"], other["contact"]["corner_points"])
                    self.assertEqual(len(own["pivots"]), len(other["pivots"]))
                    self.assertAlmostEqual(own["toppling"]["critical_angle_deg"]["value"],
                                           other["toppling"]["critical_angle_deg"]["value"], delta=600 * 2e-4)
        self.assertGreater(seen, SCENES // 2)

    def test_near_misses(self):
        """Of a block of which some corners are lifted: how many miss nearly and the largest gap, over all pairs."""
        draw = random.Random(SEED + 1)
        named = 0
        for number in range(SCENES):
            block, profile = mated(draw)
            block = [(x, y + Fraction(draw.choice([0, 0, 1, 3, 8, 40]), 10000) if y < 3 else y) for x, y in block]
            size = max(max(p[axis] for p in block) - min(p[axis] for p in block) for axis in range(2))
            misses = []
            for own, other, closed in ((block, profile, False), (profile, block, True)):
                edges = list(zip(other, other[1:] + other[:1]))[:None if closed else -1]
                if closed:
                    edges = [(a, b) for a, b in edges if b[0] >= a[0]]
                for k, point in enumerate(own):
                    gap = min(distance(point, a, b) for a, b in edges)
                    ends = [own[j % len(own)] for j in (k - 1, k + 1) if closed is False or 0 <= j < len(own)]
                    shorter = min(math.dist(point, end) for end in ends)
                    if 0 < gap <= min(float(size) / 1000, shorter / 100):
                        misses.append(gap)
            with self.subTest(number=number, block=block):
                self.write(block, profile)
                status, out, err = run("solve", self.path)
                flat = " ".join(out.split()) + " ".join(err.split())
                if status != 0:
                    self.assertRegex(flat, r"does not touch its base anywhere: at the nearest|cuts into the block")
                    continue
                found = re.search(r"lies (\S+) m (?:above|below|beside) the (?:base|block)"
                                  r"(?:, the largest of (\d+) such gaps)?, and does not touch", flat)
                if not misses:
                    self.assertIsNone(found)
                    continue
                named += 1
                self.assertAlmostEqual(float(found[1]), max(misses), delta=0.06 * max(misses))
                self.assertEqual(int(found[2] or 1), len(misses))
        self.assertGreater(named, SCENES // 4)

    def test_gap_left(self):
        """A notch of the block over a flat base, its depth and the tooth's of the base under a flat block."""
        block = [(0, "0.001"), (1, 0), (2, "0.25"), (3, 0), (4, "-0.001"), (4, 6), (0, 6)]
        case = self.cases(block, [(-1, 0), (5, 0)], within="0.002")[0]["within"]
        self.assertEqual((case["moved"], case["taken"]), (2, 0))
        for key, truth in (("farthest_m", 0.001), ("gap_left_m", 0.25), ("overlap_removed_m", 0.001)):
            self.assertLessEqual(abs(case[key]["value"] - truth), case[key]["error"] + 1e-17, key)
        block = [(0, 0), (4, 0), (4, 6), (0, 6)]
        profile = [(-1, 0), (1, "0.001"), (2, "-0.5"), (3, "-0.002"), (5, 0)]
        case = self.cases(block, profile, within="0.003")[0]["within"]
        self.assertEqual(case["taken"], 2)
        self.assertLessEqual(abs(case["gap_left_m"]["value"] - 0.5), case["gap_left_m"]["error"] + 2e-3)
        self.assertAlmostEqual(case["overlap_removed_m"]["value"], 0.001, delta=1e-12)

    def test_mirror_shift_unit(self):
        draw = random.Random(SEED + 2)
        for number in range(10):
            block, profile = draw.choice([mated, resting])(draw)
            block, profile = rounded(block, 3), [(str(float(x)), str(float(y))) for x, y in profile]
            own = self.cases(block, profile, within="0.002")
            b, p = exact(block), exact(profile)
            mirror = self.cases([(-x, y) for x, y in b[::-1]], [(-x, y) for x, y in p[::-1]], within="0.002")
            shifted = self.cases([(x + 1024, y - 512) for x, y in b], [(x + 1024, y - 512) for x, y in p], within="0.002")
            small = self.cases(block, profile, within="0.002", unit="mm")
            with self.subTest(number=number, block=block):
                self.assertEqual(own[0]["mechanism"], mirror[1]["mechanism"])
                self.assertEqual(own[0]["mechanism"], small[0]["mechanism"])
                for key in ("moved", "taken"):
                    self.assertEqual({own[0]["within"][key]}, {c["within"][key] for c in (mirror[0], shifted[0], small[0])})
                for key in ("farthest_m", "gap_left_m", "overlap_removed_m"):
                    value = own[0]["within"][key]["value"]
                    self.assertAlmostEqual(value, mirror[0]["within"][key]["value"], delta=1e-12)
                    self.assertAlmostEqual(value, shifted[0]["within"][key]["value"], delta=1e-10)
                    self.assertAlmostEqual(value / 1000, small[0]["within"][key]["value"], delta=1e-15)
                angle = own[0]["toppling"]["critical_angle_deg"]["value"]
                for other in (mirror[1], shifted[0], small[0]):
                    self.assertAlmostEqual(angle, other["toppling"]["critical_angle_deg"]["value"], delta=1e-7)

    def test_what_lies_on_the_outline_goes_along(self):
        """A pressure on a side whose lower end moves, from one third of it to its upper end."""
        more = "loads: {{pressures: [{{from: [4, {0}], to: [4, 6], kpa: [1, 2]}}]}}\ntilt: {{angle_deg: 5}}\n"
        weight = lambda: self.path.write_text(self.path.read_text().replace("]]}\nbase", "]], unit_weight_kn_m3: 25}\nbase"))
        self.write([(0, 0), (4, "0.003"), (4, 6), (0, 6)], [(-1, 0), (5, 0)], within="0.01", more=more.format("2.002"))
        weight()
        moved = solve(self.path)["cases"]
        self.write([(0, 0), (4, 0), (4, 6), (0, 6)], [(-1, 0), (5, 0)], more=more.format("2"))
        weight()
        for own, other in zip(moved, solve(self.path)["cases"]):
            for key in ("toppling", "limit", "governing_fos"):
                self.assertEqual(own.get(key), other.get(key), key)

    def refused(self, block, profile, within):
        self.write(block, profile, within=within)
        status, out, err = run("solve", self.path)
        self.assertEqual((status, out), (3, ""))
        return err

    def test_refused(self):
        square = [(0, 0), (4, 0), (4, 6), (0, 6)]
        self.assertIn("corners could not be distinguished", self.refused(square, [(-1, 0), (1, 0), ("1.1", 0), (5, 0)], "0.2"))
        self.assertIn("of the outline", self.refused([(0, 0), ("0.1", 0)] + square[1:], [(-1, 0), (5, 0)], "0.2"))
        self.assertIn("moved there: ", self.refused(square, [(-1, 0), (2, 1), (5, 0)], "0.2"))
        self.assertIn("does not touch its base anywhere: at the nearest", self.refused(square, [(-1, -1), (5, -1)], "0.2"))
        self.assertIn("within must be above zero", self.refused(square, [(-1, 0), (5, 0)], "0"))
        head = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\ncontact: "
        for rest, message in (("{within: 0.1}\n", "a mated base touches its block already"),
                              ("{}\n", "within"), ("{near: 1}\n", "unknown key 'near' in contact")):
            self.path.write_text(head + rest)
            self.assertIn(message, run("solve", self.path)[2])


if __name__ == "__main__":
    main()
