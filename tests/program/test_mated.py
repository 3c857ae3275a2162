# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where the contact of a mated base ends: on the sole that a person would point at.

The lower chain from the leftmost to the rightmost vertex takes in the wall of a block that leans out, and half
of a boulder: "interlocked" for a block that topples at 9.46 degrees."""

import json
import math
import random
from fractions import Fraction

from harness import main, run
from mated_case import MatedCase, SEED


class Mated(MatedCase):
    def test_leaning_block(self):
        """A block that leans to the right rests on its sole, and topples where tan a = (2 - 3/2) / 3. All of
        its underside, wall included, holds it at every tilt; so does its mirror image."""
        outline = [(0, 0), (2, 0), (3, 6), (1, 6)]
        for turn, towards, side in ((1, "right", "right_end"), (-1, "left", "left_end")):
            leaning = [(turn * x, y) for x, y in outline]
            case = self.case(leaning, towards=towards)
            self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"],
                                   math.degrees(math.atan2(0.5, 3)), delta=1e-12)
            self.assertEqual(case["mechanism"], "topples")
            self.assertTrue(case["contact"]["cut_by_default"])
            self.assertEqual(case["contact"][side]["is"], "steeper than 45 degrees")
            named = sorted(((0, 0), (turn * 2, 0)))
            stated = self.case(leaning, f"base: {{mated: true, between: {[list(p) for p in named]}}}", towards)
            self.assertFalse(stated["contact"]["cut_by_default"])
            self.assertEqual(stated["limit"], case["limit"])
            whole = self.case(leaning, "base: {mated: whole}", towards)
            self.assertEqual(whole["mechanism"], "interlocked")
            self.assertTrue(whole["contact"]["steep"])
            self.assertAlmostEqual(whole["contact"]["steepest_deg"]["value"], math.degrees(math.atan2(6, 1)))
        self.write(outline)
        text = run("solve", self.path)[1]
        self.assertIn("from (0, 0), the left end of the underside,\n"
                      "         to (2, 0), where the block's side begins, steeper than 45°;", text)
        self.assertIn("'mated: whole' for all of", " ".join(text.split()))
        self.write(outline, "base: {mated: whole}")
        text = " ".join(run("solve", self.path)[1].split())
        self.assertIn("Caution: its steepest facet lies at 80.538° from the mean plane", text)
        self.assertIn("Caution: it extends over 100 % of the block's height", text)

    def test_boulders(self):
        """Random convex boulders: by trial of all vertices, the contact ends to the right in the outermost one
        from which no other vertex lies within 45 degrees of the mean plane, further out. Mirrored, and a
        million times as large, alike."""
        r = random.Random(SEED)
        seen = 0
        for _ in range(60):
            outline = self.boulder(r, r.randint(6, 30))
            if len(outline) < 5:
                continue
            right = [(x, y) for x, y in outline if all(v == (x, y) or v[0] <= x or v[1] - y > v[0] - x for v in outline)]
            left = [(x, y) for x, y in outline if all(v == (x, y) or v[0] >= x or v[1] - y > x - v[0] for v in outline)]
            expected = [min(left, key=lambda v: v[1]), min(right, key=lambda v: v[1])]  # below the equator
            for turn, scale in ((1, 1), (-1, 1), (1, 10**6)):
                turned = [(turn * scale * x, scale * y) for x, y in outline]
                ends = expected if turn == 1 else [(-x, y) for x, y in expected[::-1]]
                with self.subTest(outline=outline, turn=turn, scale=scale):
                    self.write(turned)
                    status, out, err = run("solve", "--json", self.path)
                    if expected[0] == expected[1]:
                        self.assertEqual(status, 3)
                        self.assertIn("steeper than 45° from the mean plane all over", err)
                        continue
                    told = self.ends(json.loads(out)["cases"][0])
                    for (x, y, _), (x0, y0) in zip(told, ends):
                        self.assertAlmostEqual(x / scale, float(x0), delta=1e-12)
                        self.assertAlmostEqual(y / scale, float(y0), delta=1e-12)
                    seen += 1
        self.assertGreater(seen, 60)

    def test_exactly_45(self):
        """45 degrees is not steeper than 45 degrees; a hair more is, however large or small the block."""
        for size in (Fraction(1, 10**200), 1, 10**200):
            for hair, end in ((0, (3, 1)), (Fraction(1, 10**100), (2, 0))):
                outline = [(0, 0), (2, 0), (3, 1 + hair), (3, 6), (0, 6)]
                case = self.case([(size * x, size * y) for x, y in outline])
                told = case["contact"]["right_end"]
                self.assertAlmostEqual(told["x_m"]["value"] / float(size), end[0], delta=1e-12)

    def test_steps_stay(self):
        """An upright step on the way is part of a stepped base; a wall at its end is not."""
        case = self.case([(0, 0), (4, 0), (4, 1), (8, 1), (9, 9), (0, 9)])
        self.assertEqual([end[:2] for end in self.ends(case)], [(0, 0), (8, 1)])
        self.assertEqual(case["contact"]["facets"], 3)
        self.assertTrue(case["contact"]["steep"])

    def test_undercut(self):
        """Beyond a toe the underside turns back over it and goes on above: the block overhangs its support. Where
        it comes down again beside the toe, the contact ends before what lies below it."""
        over = [(0, 0), (4, 0), (5, Fraction(1, 2)), (3, 1), (9, 2), (9, 9), (0, 9)]
        case = self.case(over)
        self.assertEqual(self.ends(case)[1], (5, 0.5, "overhang"))
        under = [(0, 0), (4, 0), (5, 1), (3, 2), (7, 2), (Fraction(9, 2), Fraction(1, 4)), (9, Fraction(1, 8)), (9, 9), (0, 9)]
        case = self.case(under)
        self.assertEqual(self.ends(case)[1], (4, 0, "overhang"))
        split = under[:2] + [(Fraction(22, 5), Fraction(2, 5))] + under[2:]  # inside an edge: no corner to end in
        self.assertEqual(self.ends(self.case(split))[1], (4, 0, "overhang"))

    def test_undercut_to_the_lowest_vertex(self):
        """The underside passes below its first edge beside the lowest vertex: no edge is left, split or not."""
        outline = [(0, 0), (4, 1), (2, Fraction(1, 4)), (9, 1), (9, 9), (0, 9)]
        for ring in (outline, outline[:1] + [(1, Fraction(1, 4))] + outline[1:]):
            for turn in (1, -1):
                self.assertIn("turns back over its base beside its lowest vertex", self.refused([(turn * x, y) for x, y in ring]))


if __name__ == "__main__":
    main()
