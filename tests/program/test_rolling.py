# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Blocks on rounded corners beyond the paper: their limit, rolling to a new rest, ellipses, and roundings that are refused."""

import math
from fractions import Fraction

import exact
from harness import main, run, solve
from rounded_case import RoundedCase


class Rolling(RoundedCase):
    def test_limit(self):
        """Radius to 0: the sharp block, at first order by the moved axis; exact and paper differ at third
        order, the area of the tip times its distance from the axis."""
        self.write(3, 30, 120, 5, "peak", 0)
        sharp = solve(self.scene)["cases"][0]
        self.assertNotIn("rounded", sharp["pivots"][0])
        angles = {}
        for model in ("paper", "exact"):
            for r in (0.2, 0.1):
                self.write(3, 30, 120, 5, "peak", r, model)
                angles[model, r] = solve(self.scene)["cases"][0]["toppling"]["critical_angle_deg"]["value"]
        zero = sharp["toppling"]["critical_angle_deg"]["value"]
        first = (zero - angles["paper", 0.2]) / (zero - angles["paper", 0.1])
        third = ((angles["exact", 0.2] - angles["paper", 0.2])
                 / (angles["exact", 0.1] - angles["paper", 0.1]))
        self.assertAlmostEqual(first, 2, delta=0.01)
        self.assertAlmostEqual(third, 8, delta=0.05)

    def test_symmetric(self):
        """A block that is its own mirror image, both ends rounded: its centroid stands exactly over a
        joint, which balls can only enclose; both directions have the same answer."""
        self.scene.write_text(
            "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 4, width: 20, height: 158, depth: 7, left_end: "
            "valley}\n  rounded: {corners: [{at: left_end, radius: 5}, {at: right_end, radius: 5}]}\n"
            "friction_angle_deg: 30\ntilt: {towards: both, angle_deg: 10}\n")
        left, right = (case["toppling"]["critical_angle_deg"] for case in solve(self.scene)["cases"])
        self.assertLessEqual(abs(left["value"] - right["value"]), left["error"] + right["error"])

    def test_rolling(self):
        """A slab of width w and height h on a toe of radius r: at its critical angle the centre of
        curvature is r above the base and from the side, the centroid h / 2 above. A low slab on a toe
        of nearly half its width rolls back, a taller one topples."""
        for height, radius, beyond in ((30, 19, "rolls back"), (100, 19, "topples")):
            self.scene.write_text(
                f"topple: 1\nlength_unit: mm\nblock:\n  slab: {{width: 40, height: {height}}}\n  rounded: {{model:"
                f" paper, corners: [{{at: left_end, radius: {radius}}}]}}\ntilt: {{towards: left}}\n")
            toppling = solve(self.scene)["cases"][0]["toppling"]
            alpha = math.atan2(20 - radius, height / 2)
            self.assertAlmostEqual(toppling["critical_angle_deg"]["value"], math.degrees(alpha), delta=1e-12)
            centre, weight = (radius, radius), (20, height / 2)
            above = ((centre[0] - weight[0]) * math.sin(alpha) + (centre[1] - weight[1]) * math.cos(alpha)) > 0
            self.assertEqual(toppling["beyond"], "rolls back" if above else "topples")
            self.assertEqual(toppling["beyond"], beyond)

    def test_rest(self):
        """Beyond its critical angle a low slab rolls on its toe to a new rest. Where it is found by rolling
        the block in small steps in doubles: turned about the contact, which moves r a radian along the
        base, until the centroid stands over the contact; towards both sides alike. At a steeper tilt it
        topples."""
        width, height, radius = 40.0, 30.0, 19.0
        scene = ("topple: 1\nlength_unit: mm\nblock:\n  slab: {width: 40, height: 30}\n  rounded: {model: paper, "
                 "corners: [{at: %s, radius: 19}]}\ntilt: {towards: %s, angle_deg: %r}\n")
        for tilt, rests in ((5.0, True), (11.5, True), (14.0, False)):
            for end, towards in (("left_end", "left"), ("right_end", "right")):
                self.scene.write_text(scene % (end, towards, tilt))
                toppling = solve(self.scene)["cases"][0]["toppling"]
                self.assertEqual(toppling["beyond"], "rolls back" if rests else "topples")
                self.assertEqual("rest_turn_deg" in toppling, rests)
            a = math.radians(tilt)
            cx, cy, gx, gy = radius, radius, width / 2, height / 2

            def arm(t):
                """Horizontal distance of the centroid up-dip of the contact after a turn by t."""
                x = cx - radius * t + (gx - cx) * math.cos(t) - (gy - cy) * math.sin(t)
                y = cy + (gx - cx) * math.sin(t) + (gy - cy) * math.cos(t)
                return (x - (cx - radius * t)) * math.cos(a) - y * math.sin(a)

            turns = [k * math.pi / 2 / 4000 for k in range(4001)]
            place = next((k for k in range(4000) if arm(turns[k]) < 0 <= arm(turns[k + 1])), None)
            self.assertEqual(place is not None, rests)
            if rests:
                low, high = turns[place], turns[place + 1]
                for _ in range(60):
                    middle = (low + high) / 2
                    low, high = (middle, high) if arm(middle) < 0 else (low, middle)
                self.assertAlmostEqual(toppling["rest_turn_deg"]["value"], math.degrees(low), delta=1e-9)

    def test_roundings_that_meet(self):
        """Two roundings leave one point of the edge between them, level or inclined: a toe that rolls towards
        either side, water between the ends that the edge has without them, as just before they meet."""
        square = [(0, 0), (4, 3), (1, 7), (-3, 4)]
        water = "loads: {water: {height: 1, unit_weight_kn_m3: 10, uplift: true}}\n"

        def case(turn, towards, less, loads, base):
            ring, rock = ([(turn * x, y) for x, y in points] for points in (square, base))
            corners = [f"{{at: [{x}, {y}], radius: {radius} - {less}}}" for (x, y), radius in zip(ring, (2, 3))]
            self.scene.write_text(
                "topple: 1\nlength_unit: m\nblock:\n  outline: "
                f"{[list(p) for p in ring]}\n  unit_weight_kn_m3: 26\n  thickness: 1\n  rounded: {{model: exact, "
                f"corners: [{', '.join(corners)}]}}\nbase: {{profile: {[list(p) for p in rock][::turn]}}}\n"
                f"{loads}friction_angle_deg: 40\ntilt: {{towards: {towards}, angle_deg: 5}}\n")
            return solve(self.scene)["cases"][0]

        for base in ([(0, 0), (4, 3)], [(-4, -3), (4, 3)], [(0, 0), (8, 6)], [(0, 0), (4, 3), (8, 3)]):
            for loads in ("", water):
                for towards, mirrored in (("left", "right"), ("right", "left")):
                    at, other = case(1, towards, 0, loads, base), case(-1, mirrored, 0, loads, base)
                    near = case(1, towards, "1e-9", loads, base)
                    self.assertEqual((len(at["pivots"]), len(near["pivots"])), (1, 2))
                    self.assertEqual(at["pivots"][0]["kind"], other["pivots"][0]["kind"])
                    for told in (other, near):
                        self.assertEqual(at["toppling"].get("beyond"), told["toppling"].get("beyond"))
                        self.assertEqual(at["limit"]["base_beyond_toe"], told["limit"]["base_beyond_toe"])
                        self.assertAlmostEqual(at["toppling"]["critical_angle_deg"]["value"],
                                               told["toppling"]["critical_angle_deg"]["value"], delta=1e-6)
                        for own, its in zip(at.get("loads", []), told.get("loads", []), strict=True):
                            self.assertAlmostEqual(own["moment_nm"]["value"], its["moment_nm"]["value"],
                                                   delta=1e-6 * abs(own["moment_nm"]["value"]))

    def test_only_when_called_for(self):
        """No rounding in the scene, none in the account of effects; a radius of 0 changes no number."""
        self.write(3, 30, 120, 5, "peak", 0)
        zero = solve(self.scene)
        text = self.scene.read_text()
        self.scene.write_text("\n".join(l for l in text.splitlines() if "rounded" not in l) + "\n")
        none = solve(self.scene)
        self.assertNotIn("rounding", [e["name"] for e in none["cases"][0]["effects"]])
        for part in ("block", "pivots", "toppling", "mechanism"):
            self.assertEqual(zero["cases"][0][part], none["cases"][0][part])

    def refuse(self, rounded, message, options=(), outline="[[0, 0], [10, 0], [10, 10], [5, 2], [0, 10]]"):
        self.scene.write_text(f"topple: 1\nlength_unit: mm\nblock:\n  outline: {outline}\n  rounded: {rounded}\n"
                              "tilt: {towards: left}\n")
        status, out, err = run("solve", *options, self.scene)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(message, err)
        self.assertIn("scene.yaml:", err)

    def test_bad_corners(self):
        one = "{corners: [{at: %s, radius: %s}]}"
        self.refuse(one % ("[5, 2]", 1), "the corner at (5, 2) is reflex; only convex corners are rounded")
        self.refuse(one % ("[5, 3]", 1), "the outline has no such vertex to round")
        self.refuse(one % ("[0, 0]", -1), "radius must not be negative")
        self.refuse(one % ("[0, 0]", 11), "the radius at (0, 0) is too large: rounding it would take up more "
                                          "than the edge from vertex 5 (0, 10) to vertex 1 (0, 0)")
        self.refuse("{corners: [{at: [0, 0], radius: 6}, {at: [10, 0], radius: 6}]}",
                    "rounding it and the next corner would take up more than the edge from vertex 1 (0, 0)")
        self.refuse("{corners: [{at: [0, 0], radius: 1}, {at: left_end, radius: 1}]}", "rounded twice")
        self.refuse("{corners: [{at: middle, radius: 1}]}", "'at' must be left_end or right_end")
        self.refuse("{corners: [{at: left_end}]}", "'radius' is missing here")
        self.refuse("{model: round, corners: []}", "model must be exact")
        self.refuse("{radius: 3}", "unknown key")
        self.refuse("{model: exact}", "rounded needs a list")
        self.refuse(one % ("[0, 0]", 1), "leave out --elements", ("--elements",))
        status, _, err = run("derive", self.scene)
        self.assertEqual(status, 3)
        self.assertIn("derive with --rounded", err)

    def test_ellipse(self):
        """An ellipse on a flat: area, centroid and second moments against polygons inscribed with n
        chords, whose gap falls as 1 / n^2; a hemisphere-like cut of a circle in closed form: with the
        flat at the diameter less nothing the centroid is 4 r / (3 pi) over it, approached from below."""
        scene = "topple: 1\nlength_unit: m\nblock: {ellipse: {width: %r, height: %r, flat: %r}}\ntilt: {towards: left}\n"
        for width, height, flat in ((8, 3, 1.8), (2, 2, 0.1), (3, 7, 2.9)):
            self.scene.write_text(scene % (width, height, flat))
            case = solve(self.scene)["cases"][0]
            gaps = []
            beta = math.asin(flat / width)
            for n in (400, 800):
                turns = [-math.pi / 2 + beta + (2 * math.pi - 2 * beta) * k / n for k in range(n + 1)]
                ring = [(width / 2 * math.cos(t), height / 2 * (math.sin(t) + math.cos(beta))) for t in turns]
                m = exact.ring_moments([(Fraction(x), Fraction(y)) for x, y in ring])
                gy = m[2] / m[0]
                gaps.append([abs(case["block"]["area_m2"]["value"] - float(m[0])),
                             abs(case["block"]["centroid_y_m"]["value"] - float(gy)),
                             abs(case["block"]["second_moment_xx_m4"]["value"] - float(m[3])),
                             abs(case["block"]["second_moment_yy_m4"]["value"] - float(m[4] - gy * m[2]))])
            for coarse, fine in zip(*gaps):
                self.assertLess(fine, 1e-2)
                self.assertAlmostEqual(coarse / fine, 4, delta=0.2)
            angle = math.degrees(math.atan2(flat / 2, case["block"]["centroid_y_m"]["value"]))
            self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], angle, delta=1e-12)
        self.scene.write_text(scene % (2, 2, 1.999999999999))
        centroid = solve(self.scene)["cases"][0]["block"]["centroid_y_m"]["value"]
        self.assertAlmostEqual(centroid, 4 / (3 * math.pi), delta=2e-6)
        for wrong, message in (("{width: 2, height: 2, flat: 2}", "the flat must be narrower"),
                               ("{width: 2, height: 0, flat: 1}", "height must be above zero"),
                               ("{width: 2, height: 2}", "'flat' is missing here")):
            self.scene.write_text(f"topple: 1\nlength_unit: m\nblock: {{ellipse: {wrong}}}\n")
            status, out, err = run("solve", self.scene)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(message, err)


if __name__ == "__main__":
    main()
