# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where the contact of a mated base ends when the scene says it, at hooks, slots and rounded ends, and what depends on it."""

import json
import math
import random
from fractions import Fraction

from harness import main, run, solve
from mated_case import MatedCase, SEED


class MatedEnds(MatedCase):
    def hooked(self, r):
        """A simple polygon of random vertices on a small grid, counter-clockwise, no corner of it straight: crossings
        of a closed path through them are undone one by one, which leaves hooks and slots. None where it has spikes."""
        points = list(dict.fromkeys((r.randint(0, 9), r.randint(0, 9)) for _ in range(r.randint(6, 11))))
        count = len(points)

        def side(a, b, c):
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

        def meet(a, b, c, d):
            within = all(max(min(a[k], b[k]), min(c[k], d[k])) <= min(max(a[k], b[k]), max(c[k], d[k])) for k in (0, 1))
            return within and side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0

        for _ in range(300):
            found = next(((i, j) for i in range(count - 2) for j in range(i + 2, count - (i == 0))
                          if meet(points[i], points[i + 1], points[j], points[(j + 1) % count])), None)
            if found is None:
                break
            points[found[0] + 1:found[1] + 1] = points[found[0] + 1:found[1] + 1][::-1]
        else:
            return None
        if any(side(points[k - 2], points[k - 1], points[k]) == 0 for k in range(count)):
            return None
        area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1]))
        return points if area > 0 else points[::-1]

    def right_end(self, outline):
        """By trial of all corners, from the words of docs/scene.md: the vertex where the contact ends, or None where
        it is all steeper than 45 degrees."""
        left, right = min(outline), min(outline, key=lambda v: (-v[0], v[1]))
        start = outline.index(left)
        chain = (outline[start:] + outline[:start])[:(outline.index(right) - start) % len(outline) + 1]
        first, last = min(chain, key=lambda v: (v[0] + v[1], v[0])), max(chain, key=lambda v: (v[0] - v[1], v[0]))
        if first == last:
            return None
        chain = chain[chain.index(first):chain.index(last) + 1]
        lowest = min(chain, key=lambda v: (v[1], -v[0]))
        out = chain[chain.index(lowest):]
        back = next((k for k in range(len(out) - 1) if out[k + 1][0] < out[k][0]), None)
        if back is None:
            return last
        sole = list(zip(out[:back], out[1:back + 1]))

        def hangs(x, y):
            """Is the block below, but for the sole itself?"""
            for a, b in zip(outline, outline[1:] + outline[:1]):
                if (a, b) not in sole and a[0] != b[0] and min(a[0], b[0]) <= x <= max(a[0], b[0]):
                    if a[1] + Fraction((b[1] - a[1]) * (x - a[0]), b[0] - a[0]) < y:
                        return True
            return False

        return next((v for v in out[back:0:-1] if not hangs(*v)), lowest)

    def test_hooks_and_slots(self):
        """Random blocks with hooks: their contact ends in the last corner below which nothing of them hangs, which
        trial of all corners finds; of a mirror image and with vertices on its edges in the same. It is refused where
        that leaves nothing, never because the face in which the rock ends cuts the block."""
        r = random.Random(SEED)
        seen = 0
        for _ in range(200):
            outline = self.hooked(r)
            if outline is None:
                continue
            mirrored = [(-x, y) for x, y in outline[::-1]]
            right = self.right_end(outline)
            left = right and (-self.right_end(mirrored)[0], self.right_end(mirrored)[1])
            parts = [Fraction(r.randint(1, 4), 5) for _ in outline]
            split = [v for a, b, t in zip(outline, outline[1:] + outline[:1], parts)
                     for v in (a, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))]
            for block, ends in ((outline, (left, right)), (split, (left, right)),
                                ([(-x, y) for x, y in split], right and ((-right[0], right[1]), (-left[0], left[1])))):
                with self.subTest(outline=block):
                    self.write(block)
                    status, out, err = run("solve", "--json", self.path)
                    if right is None or left == right:
                        self.assertEqual(status, 3, err)
                        self.assertIn("all over" if right is None else "turns back over its base beside", err)
                        continue
                    self.assertIn(status, (0, 4), err)  # 4: its ends are told, its mechanism may tie
                    told = self.ends(json.loads(out)["cases"][0])
                    self.assertEqual([x for x, _, _ in told], [x for x, _ in ends])
                    seen += told[1][2] == "overhang"
        self.assertGreater(seen, 10)

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
        for outline, towards, said in (([(0, 0), (4, 0), (6, 8), (0, 8)], "left", "leans out over it: its upwards push"),
                                       ([(0, 0), (4, 0), (3, 8), (0, 8)], "left", "leans back from it: its downwards push"),
                                       ([(0, 0), (4, 0), (4, 8), (-1, 8)], "right", "leans out over it: its upwards push"),
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
        self.assertIn("in one place only", self.notes())

    def test_upright_sole(self):
        """A contact without length along the mean plane has no weight per area of it."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [2, 4], [0, 4]], "
                             "unit_weight_kn_m3: 26}\nbase: {profile: [[2, -1], [2, 3], [4, 3]]}\ntilt: {towards: left}\n")
        text = run("solve", self.path)[1]
        self.assertIn("0 m along the mean plane", text)
        self.assertNotIn("out of range", text)


if __name__ == "__main__":
    main()
