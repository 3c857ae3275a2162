# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Random blocks: every number against exact rationals, every angle unchanged by what must not change
it, contact and admissibility against brute force. Seeds are fixed; TOPPLE_ROUNDS multiplies the
number of rounds."""

import math
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROUNDS, main, solve


def star(count, radius, centre=(0, 0), places=3):
    """A star-shaped polygon with `count` vertices at rising angles, on a decimal grid."""
    while True:
        angles = sorted(random.uniform(0, 2 * math.pi) for _ in range(count))
        gaps = [b - a for a, b in zip(angles, angles[1:] + [angles[0] + 2 * math.pi])]
        if max(gaps) < math.pi * 0.95 and min(gaps) > 1e-4:
            break
    grid = 10**places
    ring = []
    for angle in angles:
        r = radius * random.uniform(0.6, 1)
        ring.append((Fraction(round((centre[0] + r * math.cos(angle)) * grid), grid),
                     Fraction(round((centre[1] + r * math.sin(angle)) * grid), grid)))
    return ring


def text_of(ring):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in ring) + "]"


def lower_chain(ring):
    """From the leftmost to the rightmost vertex, counter-clockwise."""
    if sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1])) < 0:
        ring = ring[::-1]
    first = ring.index(min(ring))
    last = ring.index(min(ring, key=lambda p: (-p[0], p[1])))
    return [ring[(first + k) % len(ring)] for k in range((last - first) % len(ring) + 1)]


def opens(pivot, chain, towards):
    """Brute force: turn the contact by a small rational rotation about the pivot and see whether an
    end of a facet goes through the facet's line."""
    t = Fraction(1, 10**12) * (1 if towards == "left" else -1)
    cosine, sine = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for (x0, y0), (x1, y1) in zip(chain, chain[1:]):
        for x, y in ((x0, y0), (x1, y1)):
            dx, dy = x - pivot[0], y - pivot[1]
            mx, my = cosine * dx - sine * dy - dx, sine * dx + cosine * dy - dy
            if (x1 - x0) * my - (y1 - y0) * mx < 0:
                return False
    return True


class RandomBlocks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def solve_text(self, block, base="mated: whole, beyond: {left: 0, right: 0}", tilt="",
                   unit="m"):
        self.scene.write_text(f"topple: 1\nlength_unit: {unit}\nblock:\n{block}base: {{{base}}}\n"
                              f"friction_angle_deg: 33\ntilt: {{towards: both{tilt}}}\n")
        return solve(self.scene)["cases"]

    def holds(self, number, truth):
        self.assertLessEqual(abs(Decimal(number["value"]) - truth), Decimal(number["error"]))

    def test_against_exact_rationals(self):
        """3 to 500 vertices, holes and parts: area, centroid, second moments, all pivots' angles and
        factors of safety hold the truth within their bound."""
        random.seed(11)
        for k in range(60 * ROUNDS):
            count = (3, 4, 7, 20, 100, 500)[k % 6]
            outline = star(count, 10)
            holes = [star(random.randint(3, 9), 0.4, (x, 0)) for x in (-0.9, 0.9)[: k % 3]]
            parts = [(star(5, 0.4, (0, 1)), Fraction(random.randint(5, 40)))][: k % 2]
            if count == 3:
                holes, parts = [], []
            block = f"  outline: {text_of(outline)}\n  unit_weight_kn_m3: 26\n"
            block += f"  holes: [{', '.join(map(text_of, holes))}]\n"
            block += "  parts: [%s]\n" % ", ".join(
                f"{{outline: {text_of(r)}, unit_weight_kn_m3: {w}}}" for r, w in parts)
            m = exact.block_moments(outline, holes, [(r, w / 26) for r, w in parts])
            area = exact.block_moments(outline, holes)[0]
            for case in self.solve_text(block, tilt=", angle_deg: 7"):
                result = case["block"]
                gx, gy = exact.centroid(m)
                self.holds(result["area_m2"], exact.decimal(area))
                self.holds(result["weight_n"], exact.decimal(m[0] * 26000))
                self.holds(result["centroid_x_m"], exact.decimal(gx))
                self.holds(result["centroid_y_m"], exact.decimal(gy))
                scale = area / m[0]
                self.holds(result["second_moment_xx_m4"], exact.decimal((m[3] - m[0] * gx**2) * scale))
                self.holds(result["second_moment_yy_m4"], exact.decimal((m[4] - m[0] * gy**2) * scale))
                self.holds(result["second_moment_xy_m4"], exact.decimal((m[5] - m[0] * gx * gy) * scale))
                chain = lower_chain(outline)
                self.assertEqual(len(case["pivots"]), len(chain))
                for pivot, vertex in zip(case["pivots"], chain):
                    self.holds(pivot["x_m"], exact.decimal(vertex[0]))
                    self.holds(pivot["critical_angle_deg"],
                               exact.critical_angle(m, vertex, case["towards"]))
                    if gy > vertex[1]:  # of a blocked pivot none below zero is printed
                        factor = exact.factor_of_safety(m, vertex, 7, case["towards"])
                        if pivot["admissible"] or factor >= 0:
                            self.holds(pivot["fos"], factor)
                        else:
                            self.assertIsNone(pivot["fos"])

    def test_admissible_pivots(self):
        """First-order admissibility against a small finite rotation in rationals, and the governing
        pivot against the least exact angle."""
        random.seed(12)
        admissible = 0
        for _ in range(80 * ROUNDS):
            flat = Fraction(random.choice([1, 2, 5, 10]), 10)
            outline = [(x, y * flat) for x, y in star(random.randint(4, 30), 10)]
            chain, m = lower_chain(outline), exact.block_moments(outline)
            for case in self.solve_text(f"  outline: {text_of(outline)}\n"):
                towards, found = case["towards"], []
                for pivot, vertex in zip(case["pivots"], chain):
                    expected = opens(vertex, chain, towards)
                    self.assertEqual(pivot["admissible"], expected)
                    if expected:
                        found.append(exact.critical_angle(m, vertex, towards))
                admissible += len(found)
                if found:
                    self.holds(case["toppling"]["critical_angle_deg"], min(found))
                else:
                    self.assertIsNone(case["toppling"])
        self.assertGreater(admissible, 40)

    def angles(self, cases):
        return {c["towards"]: [(p["critical_angle_deg"], p["admissible"]) for p in c["pivots"]]
                for c in cases}

    def same(self, one, other):
        self.assertEqual(len(one), len(other))
        for (a, admissible), (b, twin) in zip(one, other):
            self.assertLessEqual(abs(Decimal(a["value"]) - Decimal(b["value"])),
                                 Decimal(a["error"]) + Decimal(b["error"]))
            self.assertEqual(admissible, twin)

    def test_invariance(self):
        """Moving the block far away, scaling it, another unit, mirroring, renumbering and reversing
        its vertices leaves every angle unchanged within the two bounds."""
        random.seed(13)
        for k in range(15 * ROUNDS):
            outline = star((3, 5, 12, 60, 200)[k % 5], 10)
            plain = self.angles(self.solve_text(f"  outline: {text_of(outline)}\n"))
            turn = random.randrange(len(outline))
            far = (Fraction(500000) + Fraction(1, 3), Fraction(4700000))
            factor = Fraction(random.randint(1, 10**6), random.randint(1, 10**6))
            variants = {
                "moved": [(x + far[0], y + far[1]) for x, y in outline],
                "moved beyond doubles": [(x + 10**17, y - 10**17) for x, y in outline],
                "scaled": [(x * factor, y * factor) for x, y in outline],
                "tiny": [(x / 10**200, y / 10**200) for x, y in outline],
                "renumbered": outline[turn:] + outline[:turn],
                "reversed": outline[::-1],
            }
            for name, ring in variants.items():
                with self.subTest(name):
                    cases = self.angles(self.solve_text(f"  outline: {text_of(ring)}\n"))
                    self.same(plain["left"], cases["left"])
                    self.same(plain["right"], cases["right"])
            in_feet = self.angles(self.solve_text(f"  outline: {text_of(outline)}\n", unit="ft"))
            self.same(plain["left"], in_feet["left"])
            mirrored = [(-x, y) for x, y in outline]
            twin = self.angles(self.solve_text(f"  outline: {text_of(mirrored)}\n"))
            self.same(plain["left"], twin["right"][::-1])
            self.same(plain["right"], twin["left"][::-1])

    def rough_block(self, count):
        xs = sorted(random.sample(range(1, 1000), count - 1))
        under = [(Fraction(x, 10), Fraction(random.randint(0, 50), 10)) for x in [0, *xs, 1000]]
        return under, under + [(Fraction(100), Fraction(150)), (Fraction(0), Fraction(150))]

    def test_mated_and_given_profile_agree(self):
        """A base given point by point as the counterpart of the underside has the facets, pivots and
        angles of the mated one: two algorithms, one answer."""
        random.seed(14)
        for _ in range(30 * ROUNDS):
            under, outline = self.rough_block(random.randint(1, 40))
            block = f"  outline: {text_of(outline)}\n"
            mated = self.solve_text(block)
            given = self.solve_text(block, base=f"profile: {text_of(under)}")
            for one, other in zip(mated, given):
                self.assertEqual(one["pivots"], other["pivots"])
                self.assertEqual(one["toppling"], other["toppling"])
                self.assertEqual(one["sliding"], other["sliding"])
                for key in ("facets", "points", "length_m"):
                    self.assertEqual(one["contact"][key], other["contact"][key])

    def test_partial_contact(self):
        """Where profile points are lowered, the facets beside them open: those left are counted by
        hand, with their exact length along the mean plane and the pivots at their ends."""
        random.seed(15)
        for _ in range(40 * ROUNDS):
            under, outline = self.rough_block(random.randint(3, 40))
            lowered = [random.random() < 0.4 for _ in under]
            lowered[0] = lowered[1] = False
            profile = [(x, y - 1) if low else (x, y) for (x, y), low in zip(under, lowered)]
            kept = [k for k in range(len(under) - 1) if not lowered[k] and not lowered[k + 1]]
            cases = self.solve_text(f"  outline: {text_of(outline)}\n",
                                    base=f"profile: {text_of(profile)}")
            contact = cases[0]["contact"]
            self.assertEqual(contact["facets"], len(kept))
            length = sum(under[k + 1][0] - under[k][0] for k in kept)
            self.holds(contact["nominal_length_m"], exact.decimal(length))
            touching = [p for p, low in zip(under, lowered) if not low]
            self.assertEqual([p["x_m"]["value"] for p in cases[0]["pivots"]],
                             [float(x) for x, _ in touching])

    def test_facets_within_edges(self):
        """Edges that overlap only in part: a level block on a profile whose level pieces begin and
        end elsewhere; the facets are the intersections of intervals, counted by hand."""
        random.seed(16)
        for _ in range(30 * ROUNDS):
            cuts = sorted(random.sample(range(-20, 121), 2 * random.randint(1, 6)))
            profile, expected = [(Fraction(-30), Fraction(-1))], []
            for left, right in zip(cuts[::2], cuts[1::2]):
                profile += [(Fraction(left), Fraction(-1)), (Fraction(left), Fraction(0)),
                            (Fraction(right), Fraction(0)), (Fraction(right), Fraction(-1))]
                low, high = max(left, 0), min(right, 100)
                if low < high:
                    expected.append((low, high))
            profile.append((Fraction(130), Fraction(-1)))
            if not expected:
                continue
            cases = self.solve_text("  slab: {width: 100, height: 70}\n",
                                    base=f"profile: {text_of(profile)}")
            self.assertEqual(cases[0]["contact"]["facets"], len(expected))
            ends = {x for interval in expected for x in interval}
            pivots = {p["x_m"]["value"] for p in cases[0]["pivots"]}
            self.assertTrue(ends <= pivots)
            self.assertTrue(all(p["kind"] == "flat end" for p in cases[0]["pivots"]
                                if p["x_m"]["value"] in ends))


if __name__ == "__main__":
    main()
