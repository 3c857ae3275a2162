# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where the contact of a mated base ends: on the sole that a person would point at.

The lower chain from the leftmost to the rightmost vertex takes in the wall of a block that leans out, and half
of a boulder: "interlocked" for a block that topples at 9.46 degrees."""

import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import main, run, solve

SEED = 5


class Mated(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, outline, base="", towards="right", more=""):
        points = ", ".join(f"[{x}, {y}]" for x, y in outline)
        self.path.write_text(f"topple: 1\nlength_unit: m\nblock: {{outline: [{points}]}}\n{base}\n{more}\n"
                             f"friction_angle_deg: 30\ntilt: {{towards: {towards}, angle_deg: 15}}\n", encoding="utf-8")

    def case(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"][0]

    def refused(self, *arguments, **options):
        self.write(*arguments, **options)
        status, out, err = run("solve", self.path)
        self.assertEqual((status, out), (3, ""))
        return err

    def ends(self, case):
        told = case["contact"]
        return [(told[side]["x_m"]["value"], told[side]["y_m"]["value"], told[side]["is"])
                for side in ("left_end", "right_end")]

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
        self.assertIn("'mated: whole' for all of", text)
        self.write(outline, "base: {mated: whole}")
        text = " ".join(run("solve", self.path)[1].split())
        self.assertIn("Caution: its steepest facet lies at 80.538° from the mean plane", text)
        self.assertIn("Caution: it reaches over 100 % of the block's height", text)

    def boulder(self, r, count):
        """A convex polygon on the unit circle, of rational vertices."""
        turns = sorted({Fraction(r.randint(-40 * 64, 40 * 64), 64 * r.randint(1, 40)) for _ in range(count)})
        return [((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)) for t in turns]

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

    def test_between_bounds(self):
        """The ends named by what lies within: below a height, left and right of an abscissa. The other end is the
        default's."""
        outline = [(-2, 3), (0, 0), (1, Fraction(1, 4)), (3, 0), (4, 1), (5, 5), (-2, 5)]
        for between, ends in (("{below: 1}", [(0, 0), (4, 1)]), ("{below: 0.5}", [(0, 0), (3, 0)]),
                              ("{right_of: 0.5}", [(1, 0.25), (4, 1)]), ("{left_of: 2}", [(0, 0), (1, 0.25)]),
                              ("{right_of: 0, left_of: 3}", [(0, 0), (3, 0)])):
            case = self.case(outline, f"base: {{mated: true, between: {between}}}")
            self.assertEqual([end[:2] for end in self.ends(case)], ends, between)
        self.assertIn("no edge of the underside lies within", self.refused(outline, "base: {between: {below: -1}}"))
        self.assertIn("drop one of them", self.refused(outline, "base: {mated: whole, between: {below: 1}}"))
        self.assertIn("mated must be true, false, or 'whole'", self.refused(outline, "base: {mated: all}"))
        self.assertIn("or what all its vertices lie within", self.refused(outline, "base: {between: 5}"))

    def test_rounded_ends(self):
        """A corner at the right end is that of the contact: of the block that leans out its sole's end, not its
        uppermost vertex. The sole is left to its tangent point, at r tan of half the turn, and no pivot lies off it."""
        leaning = [(0, 0), (2, 0), (3, 6), (1, 6)]
        points = ", ".join(f"[{x}, {y}]" for x, y in leaning)
        length = 0.3 * math.tan(math.atan2(6, 1) / 2)
        for base in ("", "base: {between: [[0, 0], [2, 0]]}", "base: {between: {below: 1}}"):
            self.path.write_text(f"topple: 1\nlength_unit: m\nblock: {{outline: [{points}], rounded: {{corners: [{{at: right_end, "
                                 f"radius: 0.3}}]}}}}\n{base}\nfriction_angle_deg: 30\ntilt: {{towards: left, angle_deg: 5}}\n")
            pivots = [(p["x_m"]["value"], p["y_m"]["value"]) for p in solve(self.path)["cases"][0]["pivots"]]
            self.assertEqual(len(pivots), 2)
            self.assertEqual(pivots[0], (0, 0))
            self.assertAlmostEqual(pivots[1][0], 2 - length, delta=1e-12)
            self.assertEqual(pivots[1][1], 0)

    def notes(self):
        return " ".join(note["text"] for note in json.loads(run("solve", "--json", self.path)[1])["notes"])

    def test_water_on_a_leaning_side(self):
        """Water is put on a face normal to the base: told where the side leans, and which way that errs."""
        for outline, towards, said in (([(0, 0), (4, 0), (6, 8), (0, 8)], "left", "leans out over it: what it pushes upwards"),
                                       ([(0, 0), (4, 0), (3, 8), (0, 8)], "left", "leans back from it: what it pushes downwards"),
                                       ([(0, 0), (4, 0), (4, 8), (-1, 8)], "right", "leans out over it: what it pushes upwards"),
                                       ([(0, 0), (4, 0), (4, 2), (5, 8), (0, 8)], "left", None),
                                       ([(0, 0), (4, 0), (4, 8), (0, 8)], "left", None)):
            points = ", ".join(f"[{x}, {y}]" for x, y in outline)
            self.path.write_text(f"topple: 1\nlength_unit: m\nblock: {{outline: [{points}], unit_weight_kn_m3: 26}}\n"
                                 f"loads: {{water: {{height: 2}}}}\ntilt: {{towards: {towards}, angle_deg: 5}}\n")
            self.assertEqual(said in self.notes() if said else "leans" not in self.notes(), True, (outline, said))

    def test_water_above_an_upright_end(self):
        """A contact that ends up-dip in an upright facet: the water is counted from the upper end of that, and told so."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [4, 0], [4, 1], [4, 8], [0, 8]], unit_weight_kn_m3: 26}\n"
                             "base: {profile: [[0, 0], [4, 0], [4, 1], [9, 1]]}\nloads: {water: {height: 2}}\n"
                             "tilt: {towards: left, angle_deg: 5}\n")
        self.assertIn("the contact ends up-dip in an upright facet", self.notes())
        self.path.write_text(self.path.read_text().replace("[4, 1], [9, 1]", "[9, 0]"))
        self.assertNotIn("upright facet", self.notes())

    def test_one_place(self):
        """On a ridge under a pull that does not turn: moments about the ridge cancel where 208 * 2 sin a = 10 * 2 cos 200,
        at a single tilt, and at 5 degrees they do not. That was undecided."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [2, 4], [0, 4]], unit_weight_kn_m3: 26}\n"
                             "base: {profile: [[-3, -1], [1, 0], [3, -1]]}\nfriction_angle_deg: 30\nloads: {anchors: [{at: [1, 2], "
                             "direction_deg: 200, force_kn: 10}]}\ntilt: {towards: left, angle_deg: 5}\n")
        status, out, err = run("solve", "--json", self.path)
        self.assertEqual((status, err), (0, ""))
        case = json.loads(out)["cases"][0]
        self.assertEqual(case["limit"]["mechanism"], "holds nowhere")
        self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"],
                               math.degrees(math.asin(10 * 2 * math.cos(math.radians(200)) / (208 * 2))), delta=1e-9)
        self.assertIn("in one place alone", self.notes())

    def test_upright_sole(self):
        """A contact without length along the mean plane has no weight per area of it."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [2, 4], [0, 4]], "
                             "unit_weight_kn_m3: 26}\nbase: {profile: [[2, -1], [2, 3], [4, 3]]}\ntilt: {towards: left}\n")
        text = run("solve", self.path)[1]
        self.assertIn("0 m along the mean plane", text)
        self.assertNotIn("out of range", text)


if __name__ == "__main__":
    main()
