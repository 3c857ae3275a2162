# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit in cases that can be told in a sentence, each with its closed form."""

import json
import math

from harness import ROOT, main, run, solve, table
from limit_case import LimitCase

BLOCK_E = math.degrees(math.atan2(27 * 30 * 120 + 13 * 30 * 5, 9 * 120**2 + 18 * 120 * 5 + 6 * 25))


class Cases(LimitCase):
    def test_where_the_base_ends_decides(self):
        """Block E towards its valley at 30 degrees: on a base that ends at its toe it slides on the second
        facet and turns at 28.73; where the base goes on by a tooth the formula's 35.20 comes true. Either
        run tells of the other base."""
        short, long = (self.example("block_e_valley.yaml", "left", b)["limit"] for b in (0, "a"))
        self.assertEqual(short["mechanism"], "slides and topples")
        self.assertAlmostEqual(short["critical_angle_deg"]["value"], 28.7345528055, delta=5e-11)
        self.assertEqual(long["mechanism"], "topples")
        self.holds(long["critical_angle_deg"], BLOCK_E)
        self.assertEqual((short["base_beyond_toe"], long["base_beyond_toe"]), (False, True))
        for one, other in ((short, long), (long, short)):
            self.assertTrue(one["base_matters"])
            self.assertEqual(one["otherwise"]["mechanism"], other["mechanism"])
            self.holds(one["otherwise"]["critical_angle_deg"], other["critical_angle_deg"]["value"])

    def test_table_3(self):
        """Where the base goes on by a tooth, every block of Table 3 begins to move at the angle of its moments;
        towards a peak on either base."""
        rows = table("table3.csv")
        self.assertEqual(len(rows), 14)
        for row in rows:
            for beyond in ("a", "2*a") + (("0",) if row["axis"] == "Peak" else ()):
                with self.subTest(model=row["model"], axis=row["axis"], beyond=beyond):
                    case = self.example(row["scene"], row["towards"], beyond)
                    self.assertEqual(case["limit"]["mechanism"], "topples")
                    self.holds(case["limit"]["critical_angle_deg"],
                               case["toppling"]["critical_angle_deg"]["value"], 1e-9)

    def test_tie_of_sliding_and_toppling(self):
        """A square slab at 45 degrees of friction slides and topples at 45 degrees, exactly."""
        for towards in ("left", "right"):
            limit = self.limit("slab: {width: 7, height: 7}", "mated: true", 45, towards)
            self.assertEqual(limit["critical_angle_deg"], {"value": 45, "error": 0})
            self.assertEqual({limit["mechanism"], limit["tied_with"]}, {"slides", "topples"})

    def test_two_apexes(self):
        """A block on two apexes that straddle its centroid, on two of its base: nothing holds it, and the
        report says why. Blunted to a flat of 1e-30, it stands; and corners in notches are no such points."""
        base = "profile: [[-1, -1], [0, 0], [1/2, -1], [1, 0], [2, -1]]"
        sharp = "outline: [[0, 0], [1/2, 1], [1, 0], [1, 2], [0, 2]]"
        status, out, err = self.run_solve(sharp, base, 30)
        contact = json.loads(out)["cases"][0]["contact"]
        self.assertEqual((status, contact["points"], contact["corner_points"]), (0, 2, 2), err)
        text = run("solve", self.path)[1]
        self.assertIn("2 of the points are a corner on a corner, not counted as support", text)
        self.assertIn("its contacts of a corner on a corner are not counted as support", text)
        blunt = "profile: [[-1, -1], [0, 0], [1e-30, 0], [1/2, -1], [1 - 1e-30, 0], [1, 0], [2, -1]]"
        out = self.run_solve(
            "outline: [[0, 0], [1e-30, 0], [1/2, 1], [1 - 1e-30, 0], [1, 0], [1, 2], [0, 2]]", blunt, 30)[1]
        contact = json.loads(out)["cases"][0]["contact"]
        self.assertEqual((contact["facets"], contact["corner_points"]), (2, 0))
        self.holds(json.loads(out)["cases"][0]["limit"]["critical_angle_deg"], math.degrees(math.atan(9 / 22)))

    def test_redundant_vertices_change_nothing(self):
        """A vertex in the middle of a straight edge, of the block or of the base, over or under a corner of
        the other: the corner presses on the edge, with the vertex as without it."""
        peaks = "profile: [[-1, -3], [2, 0], [4, -3], [7, -3], [9, 0], [12, -3]]"
        plain = self.limit("outline: [[0, 0], [10, 0], [10, 8], [0, 8]]", peaks, 25)
        seamed = self.limit("outline: [[0, 0], [2, 0], [9, 0], [10, 0], [10, 8], [0, 8]]", peaks, 25)
        self.assertEqual(plain["critical_angle_deg"], seamed["critical_angle_deg"])
        feet = "outline: [[0, 0], [4, 3], [7, 3], [10, 0], [10, 8], [0, 8]]"
        plain = self.limit(feet, "profile: [[-5, 0], [15, 0]]", 25)
        seamed = self.limit(feet, "profile: [[-5, 0], [0, 0], [10, 0], [15, 0]]", 25)
        self.holds(plain["critical_angle_deg"], 25)
        self.assertEqual(plain["critical_angle_deg"], seamed["critical_angle_deg"])

    def test_straight_corners_at_the_toe(self):
        """Vertices on a straight edge of a block that stands on two corners of its base, and on a straight
        base below two corners of a block: what the base does past the toe matters no more than without
        them, towards either side."""
        corners = "profile: [[-1, -1], [1, 0], [2, -1], [3, 0], [5, -1]]"
        feet = "outline: [[1, 0], [2, 1], [3, 0], [4, 4], [0, 4]]"
        pairs = (("outline: [[0, 0], [4, 0], [4, 4], [0, 4]]", corners,
                  "outline: [[0, 0], [1, 0], [3, 0], [4, 0], [4, 4], [0, 4]]", corners),
                 (feet, "profile: [[0, 0], [4, 0]]", feet, "profile: [[0, 0], [1, 0], [3, 0], [4, 0]]"))
        for block, base, block_with, base_with in pairs:
            for towards in ("left", "right"):
                plain = self.limit(block, base, 30, towards)
                other = self.limit(block_with, base_with, 30, towards)
                self.assertFalse(plain["base_matters"])
                self.assertFalse(other["base_matters"])
                for key in ("mechanism", "critical_angle_deg", "base_beyond_toe"):
                    self.assertEqual(plain[key], other[key])

    def test_find_says_what_is_missing(self):
        """The friction for a limit, or its factor without a tilt, cannot be found: the message says so."""
        self.path.write_text("topple: 1\nlength_unit: m\nparameters: {w: 1}\n"
                             "block: {slab: {width: w, height: 2}}\ntilt: {towards: left}\n")
        for target, message in (("limit_angle=20", "limit_angle needs friction"),
                                ("sliding_fos=1", "sliding_fos needs friction"),
                                ("fos=1", "fos needs a tilt")):
            status, out, err = run("solve", "--find", "w", "--for", target, self.path)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(message, err)
        self.path.write_text(self.path.read_text().replace("tilt:", "friction_angle_deg: 40\ntilt:"))
        status, out, err = run("solve", "--find", "w", "--for", "limit_fos=1", self.path)
        self.assertIn("limit_fos needs a tilt", err)
        status, out, err = run("solve", "--find", "w", "--for", "limit_angle=20", self.path)
        self.assertEqual((status, err), (0, ""))
        self.assertIn(f"{2 * math.tan(math.radians(20)):.9f}"[:9], out)  # topples at atan(w / 2)

    def test_mirror(self):
        """Towards the left is the mirror image towards the right, to the last bits."""
        outline = [(0, 0), (10, 3), (20, 0), (35, 6), (50, 1), (50, 90), (0, 90)]
        twin = [(-x, y) for x, y in outline[::-1]]
        for friction in (0, 21, 45, 70):
            for beyond in ((0, 0), (5, 0), (0, 5)):
                sides = []
                for points, (left, right), towards in ((outline, beyond, "left"),
                                                       (twin, beyond[::-1], "right")):
                    text = ", ".join(f"[{x}, {y}]" for x, y in points)
                    sides.append(self.limit(f"outline: [{text}]", "mated: true, beyond: "
                                            f"{{left: {left}, right: {right}}}", friction, towards))
                one, other = sides
                for key in ("mechanism", "base_beyond_toe", "base_matters", "turns_up_dip"):
                    self.assertEqual(one[key], other[key])
                if one["critical_angle_deg"] is None:
                    continue
                self.holds(one["critical_angle_deg"], other["critical_angle_deg"]["value"], 1e-15)
                if one["centre_x_m"] is not None:
                    self.holds(one["centre_x_m"], -other["centre_x_m"]["value"], 1e-15)

    def test_size_and_place(self):
        """The same block in mm and in m, a million blocks away and 1e200 times smaller: one limit."""
        outline = [(0, 0), (10, 3), (20, 0), (35, 6), (50, 1), (50, 90), (0, 90)]
        variants = {"plain": ("mm", 1, 0), "m": ("m", "1e-3", 0), "feet": ("ft", 1, 0),
                    "tiny": ("mm", "1e-200", 0), "huge": ("km", "1e200", 0),
                    "far": ("mm", 1, 50 * 10**6), "beyond doubles": ("mm", 1, 10**30)}
        limits = {}
        for name, (unit, factor, away) in variants.items():
            text = ", ".join(f"[{x}*{factor} + {away}, {y}*{factor} - {away}]" for x, y in outline)
            limits[name] = self.limit(f"outline: [{text}]", "mated: true", 27, unit=unit)
        for name, limit in limits.items():
            with self.subTest(name):
                self.assertEqual(limit["mechanism"], limits["plain"]["mechanism"])
                self.holds(limit["critical_angle_deg"],
                           limits["plain"]["critical_angle_deg"]["value"], 1e-13)

    def test_two_thousand_teeth(self):
        """2000 teeth of 1 x 1/4 under a high and under a low block, on a base that goes on: the one topples
        at the angle of its moments, the other climbs the flanks at phi + i."""
        for height, name in ((6000, "topples"), (100, "slides")):
            case = self.solve(f"teeth: {{count: 2000, width: 1, height: {height}, depth: 1/4, "
                              "left_end: valley}", "mated: true, beyond: {left: 1, right: 0}", 30)
            self.assertEqual(case["limit"]["mechanism"], name)
            truth = (case["toppling"]["critical_angle_deg"]["value"] if name == "topples"
                     else 30 + math.degrees(math.atan(1 / 4)))
            self.holds(case["limit"]["critical_angle_deg"], truth)

    def test_worn_toe(self):
        """Block A with its toe rounded by 3.36 mm: it begins to move below the sharp corner (Table 3: 26.2 and 23.9).
        The rock past the toe does not touch what is rounded off, so that a base that goes on holds no more
        than one that ends. Towards its peak it goes at the angle of its moments about the moved axis."""
        text = (ROOT / "examples" / "block_a_worn.yaml").read_text(encoding="utf-8")
        for end, sharp in (("peak", 26.16), ("valley", 23.86)):
            for model in ("paper", "exact"):
                found = []
                for beyond in ("a", "0"):
                    self.path.write_text(text.replace("model: paper", f"model: {model}").replace(
                        "left: 0", f"left: {beyond}").replace("left_end: peak", f"left_end: {end}"))
                    case = solve(self.path)["cases"][0]
                    found.append((case["limit"]["mechanism"], case["limit"]["critical_angle_deg"]["value"]))
                    self.assertEqual(case["contact"]["points"], 0)
                    self.assertFalse(case["limit"]["base_matters"])
                self.assertEqual(found[0], found[1])
                moments = case["toppling"]["critical_angle_deg"]["value"]
                if end == "peak":
                    self.assertEqual(case["limit"]["mechanism"], "topples")
                    self.holds(case["limit"]["critical_angle_deg"], moments, 1e-9)
                else:
                    self.assertEqual(case["limit"]["mechanism"], "slides and topples")
                    self.assertLess(case["limit"]["critical_angle_deg"]["value"], moments)
                self.assertLess(case["limit"]["critical_angle_deg"]["value"], sharp - 1)
                self.assertGreater(case["limit"]["critical_angle_deg"]["value"], sharp - 5)


if __name__ == "__main__":
    main()
