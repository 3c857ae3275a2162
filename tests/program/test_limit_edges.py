# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit at the edge of what there is: no friction, upright tables, notches that interlock, centroids beyond
the contact; each with its closed form."""

import json
import math

from harness import main, solve
from limit_case import LimitCase


class Edges(LimitCase):
    def test_no_friction_on_a_plane(self):
        """Without friction a slab slides as soon as the table tilts."""
        for base in ("mated: true", "mated: true, beyond: {left: 2, right: 2}"):
            limit = self.limit("slab: {width: 3, height: 9}", base, 0)
            self.assertEqual(limit["critical_angle_deg"], {"value": 0, "error": 0})
            self.assertEqual((limit["mechanism"], limit["tied_with"]), ("slides", None))

    def test_no_friction_on_teeth(self):
        """Without friction, on one tooth (1, c) up and down: the normals (-c, 1) and (c, 1) meet the weight,
        which leans by the tilt, until one of them takes it all: tan a = c down the far flank, unless the
        block topples before. Of height h it is so low that it does not."""
        for c in (1, 2):
            limit = self.limit(f"outline: [[0, 0], [10, {10 * c}], [20, 0], [20, {10 * c + 1}], "
                               f"[0, {10 * c + 1}]]", "mated: true", 0)
            self.assertLessEqual(limit["critical_angle_deg"]["value"], math.degrees(math.atan(c)) + 1e-9)
            self.assertIn(limit["mechanism"], ("slides", "slides and topples", "topples"))

    def test_balanced_on_a_point(self):
        """A rhombus on its tip: level it is held, if only just; and no tilt holds it where its centroid is
        off the tip by more than friction leans."""
        tip = "outline: [[0, 0], [2, 3], [0, 6], [-2, 3]]"
        base = "profile: [[-5, 0], [5, 0]]"
        for friction in (1, 30, 45):
            with self.subTest(friction=friction):
                for towards in ("left", "right"):
                    limit = self.limit(tip, base, friction, towards)
                    self.assertEqual(limit["critical_angle_deg"], {"value": 0, "error": 0})
                    self.assertEqual(limit["mechanism"], "topples")
        limit = self.limit("outline: [[0, 0], [3, 3], [1, 6], [-1, 3]]", base, 30)
        self.assertEqual(limit["mechanism"], "topples")
        area = ((3 * 6 - 1 * 3) + (1 * 3 + 1 * 6)) / 2
        gx = ((3 * 6 - 1 * 3) * 4 + (1 * 3 + 1 * 6) * 0) / 6 / area
        gy = ((3 * 6 - 1 * 3) * 9 + (1 * 3 + 1 * 6) * 9) / 6 / area
        self.holds(limit["critical_angle_deg"], math.degrees(math.atan2(gx, gy)))
        status, out, err = self.run_solve(tip, base, 0)  # one force alone, no mechanism: no wrong one either
        case = json.loads(out)["cases"][0]
        self.assertEqual((status, case["limit"]["mechanism"], case["mechanism"]), (4, "undecided", "undecided"))
        self.assertIn("undecided at 5120 bits: the limit by contact forces", err)
        for friction in (0, 5):
            limit = self.limit("outline: [[0, 0], [3, 3], [1, 6], [-1, 3]]", base, friction)
            self.assertEqual(limit["mechanism"], "holds nowhere")

    def test_corner_on_corner(self):
        """Two corners that touch press on nothing: no forces hold the block, and the program says so."""
        case = self.solve("outline: [[0, 0], [3, 3], [0, 6], [-3, 3]]",
                          "profile: [[-5, -5], [0, 0], [5, -5]]", 40)
        self.assertEqual(case["limit"]["mechanism"], "holds nowhere")
        self.assertNotIn(case["mechanism"], ("stands", "interlocked"))

    def test_strength_on_an_upright_table(self):
        """Teeth of slope 2/3 under 18 degrees of friction, the table upright: the block slides along a flank,
        and would hold on to it with an angle of friction of 90 degrees less the slope."""
        block = "outline: [[0, 4], [6, 0], [12, 4], [18, 0], [18, 6], [0, 6]]"
        limit = self.solve(block, "mated: true", 18, "left, angle_deg: 90")["limit"]
        self.assertEqual(limit["mechanism"], "slides")
        self.holds(limit["fos"], math.tan(math.radians(18)) / 1.5)

    def test_interlocked_in_a_notch(self):
        """A foot in a steep notch with much friction: forces of either flank hold it upright and beyond."""
        case = self.solve("outline: [[0, 0], [1, 10], [8, 10], [8, 14], [-7, 14], [-7, 10], [-1, 10]]",
                          "profile: [[-9, 10], [-1, 10], [0, 0], [1, 10], [9, 10]]", 80)
        self.assertEqual((case["limit"]["mechanism"], case["mechanism"]), ("interlocked",) * 2)
        self.assertIsNone(case["limit"]["critical_angle_deg"])

    def test_wall_at_the_height_of_the_centroid(self):
        """A slab against a wall just as high as its centroid: upright, friction of the wall's top corner
        holds it alone. It is interlocked, and that is decided though the margin is nil."""
        limit = self.limit("outline: [[0, 0], [3, 0], [3, 2], [0, 2]]", "profile: [[-2, 1], [0, 1], [0, 0], [9, 0]]",
                           30)
        self.assertEqual(limit["mechanism"], "interlocked")

    def test_centroid_outside_the_contact(self):
        """An overhang down-dip, its centroid 2 before the foot's end and 3 high: it holds from -atan(2/3)
        down, about that end; towards the other side it begins to move up-dip at tilts below 33.69."""
        overhang = ("outline: [[0, 0], [1, 0], [1, 6], [-5, 6], [-5, 0], [-1, 0]]", "profile: [[0, 0], [1, 0]]")
        case = self.solve(*overhang, 60)
        gx, gy = case["block"]["centroid_x_m"]["value"], case["block"]["centroid_y_m"]["value"]
        self.assertEqual((gx, gy), (-2, 3))
        self.holds(case["limit"]["critical_angle_deg"], -math.degrees(math.atan(2 / 3)))
        self.assertEqual((case["limit"]["mechanism"], case["limit"]["centre_x_m"]["value"]), ("topples", 0))
        self.assertFalse(case["falls_backwards"])
        back = self.solve(*overhang, 60, "right")
        self.assertTrue(back["falls_backwards"])
        self.assertEqual(back["mechanism"], "topples")
        self.holds(back["limit"]["holds_from_deg"], math.degrees(math.atan(2 / 3)))
        self.assertEqual(self.limit(*overhang, 20)["mechanism"], "holds nowhere")

    def test_never_stands_by_formula(self):
        """A wedge on one steep facet that rises down-dip slides up-dip off it below i - phi, though angles
        alone would let it stand."""
        case = self.solve("outline: [[1, 4], [-4, 4], [1, -5]]", "mated: whole", 3.8)
        self.assertEqual((case["mechanism"], case["falls_backwards"]), ("slides", True))
        self.holds(case["limit"]["holds_from_deg"], math.degrees(math.atan2(9, 5)) - 3.8)
        self.holds(case["limit"]["critical_angle_deg"], math.degrees(math.atan2(9, 5)) + 3.8)

    def test_a_tilt_of_just_the_friction(self):
        """A low slab on a table tilted by just phi: no margin, and no doubt either."""
        self.path.write_text("topple: 1\nlength_unit: m\nblock:\n  slab: {width: 3, height: 1}\n"
                             "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 30}\n")
        case = solve(self.path)["cases"][0]
        self.assertEqual(case["first"]["margin_deg"], {"value": 0, "error": 0})
        self.assertEqual(case["mechanism"], "slides")

    def test_a_tilt_of_just_a_decimal_friction(self):
        """33.3 degrees is no binary number; the margin of 33.3 against 33.3 is zero all the same, for a
        slab by contact forces and by Patton, and 33.2999999 stands."""
        block = "slab: {width: 4, height: 1}"
        for tilt, mechanism in (("33.3", "slides"), ("33.2999999", "stands")):
            self.path.write_text(f"topple: 1\nlength_unit: m\nblock: {{{block}}}\n"
                                 f"friction_angle_deg: 33.3\ntilt: {{towards: left, angle_deg: {tilt}}}\n")
            (case,) = solve(self.path)["cases"]
            self.assertEqual(case["mechanism"], mechanism)
        self.path.write_text(self.path.read_text().replace("33.2999999", "33.3"))
        self.assertEqual(solve(self.path)["cases"][0]["first"]["margin_deg"],
                         {"value": 0, "error": 0})


if __name__ == "__main__":
    main()
