# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Outlines with true arcs: closed forms, an ellipse that is a circle, polygons of many chords, and what
is refused."""

import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

import exact
from harness import main, run, solve

SCENE = ("topple: 1\nlength_unit: m\nblock:\n  outline: %s\n  arcs: %s\n  unit_weight_kn_m3: 26\nbase: %s\n"
         "tilt: {towards: left, angle_deg: 5}\n")
BOX = "[[-1, 0], [1, 0], [1, 2], [-1, 2]]"


class Arcs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def solve(self, outline, arcs, base="{mated: true}"):
        self.scene.write_text(SCENE % (outline, arcs, base))
        return solve(self.scene)["cases"][0]

    def assert_close(self, found, expected):
        self.assertLessEqual(abs(found["value"] - expected), found["error"] + 4e-15 * max(1, abs(expected)))

    def test_many_arcs_in_any_order(self):
        """Four hundred scallops along a box's top, arcs by their bulges, listed in an order by chance: the area of the box
        and of 400 segments of a circle, within the bound. One that is listed twice is refused, as is one that begins in no vertex."""
        count = 400
        tops = [(Fraction(k, 100), 1) for k in range(count + 1)]
        outline = "[[0, 0], [4, 0], " + ", ".join(f"[{float(x)}, {y}]" for x, y in reversed(tops)) + "]"
        arcs = [f"{{from: [{float(x)}, {y}], bulge: 0.25}}" for x, y in tops[1:]]
        random.Random(7).shuffle(arcs)
        turn, radius = 4 * math.atan(0.25), 0.01 * (1 + 0.25 ** 2) / (4 * 0.25)
        case = self.solve(outline, "[" + ", ".join(arcs) + "]")
        self.assert_close(case["block"]["area_m2"], 4 + count * radius ** 2 * (turn - math.sin(turn)) / 2)
        for wrong in (arcs + [arcs[17]], arcs[:-1] + ["{from: [2.005, 1], bulge: 1}"]):
            self.scene.write_text(SCENE % (outline, "[" + ", ".join(wrong) + "]", "{mated: true}"))
            status, _, err = run("solve", self.scene)
            self.assertEqual(status, 3)
            self.assertIn("an arc begins in no vertex of the outline, or two begin in the same", err)

    def test_vault(self):
        """A box of 2 by 2 under half a circle: area 4 + pi / 2, the half circle's centroid 4 / (3 pi) over its
        diameter; by a point, by its bulge of 1, from either end of the edge, written either way round."""
        half = math.pi / 2
        height = (4 * 1 + half * (2 + 4 / (3 * math.pi))) / (4 + half)
        clockwise = "[[-1, 0], [-1, 2], [1, 2], [1, 0]]"
        for outline, arcs in ((BOX, "[{from: [1, 2], through: [0, 3]}]"), (BOX, "[{from: [1, 2], bulge: 1}]"),
                              (clockwise, "[{from: [-1, 2], through: [0, 3]}]"),
                              (clockwise, "[{from: [-1, 2], bulge: 1}]")):
            case = self.solve(outline, arcs)
            self.assert_close(case["block"]["area_m2"], 4 + half)
            self.assert_close(case["block"]["centroid_y_m"], height)
            self.assert_close(case["toppling"]["critical_angle_deg"], math.degrees(math.atan2(1, height)))
            # about its own centre a half circle has pi / 8 along and across
            around = 8 * 4 / 12 + 4 * (height - 1) ** 2 - 4 * 4 / 12
            across = 4 * 4 / 12 + math.pi / 8
            self.assert_close(case["block"]["second_moment_xx_m4"], across)
            up = 2 + 4 / (3 * math.pi) - height
            own = math.pi / 8 - half * (4 / (3 * math.pi)) ** 2
            self.assert_close(case["block"]["second_moment_yy_m4"], around + own + half * up**2)

    def test_hollow(self):
        """A box of 4 by 2 with half a circle of radius 1 taken out of its top, and the side of the other box
        with a bulge of -0.3 by the segment's closed form: R = c (1 + b^2) / (4 b), area
        R^2 (t - sin t) / 2 with t = 4 atan b, centroid 4 R sin^3(t/2) / (3 (t - sin t)) from the centre. An
        arc whose ends are tangents of the sides leaves horns without a width: refused."""
        half = math.pi / 2
        wide = "[[-2, 0], [2, 0], [2, 2], [1, 2], [-1, 2], [-2, 2]]"
        for arcs in ("[{from: [1, 2], through: [0, 1]}]", "[{from: [1, 2], bulge: -1}]"):
            block = self.solve(wide, arcs)["block"]
            self.assert_close(block["area_m2"], 8 - half)
            self.assert_close(block["centroid_y_m"], (8 - half * (2 - 4 / (3 * math.pi))) / (8 - half))
            self.assert_close(block["second_moment_xx_m4"], 8 * 16 / 12 - math.pi / 8)
        self.scene.write_text(SCENE % (BOX, "[{from: [1, 2], bulge: -1}]", "{mated: true}"))
        self.assertIn("itself", run("solve", self.scene)[2])
        b, chord = 0.3, 2.0
        radius, t = chord * (1 + b * b) / (4 * b), 4 * math.atan(b)
        area = radius**2 * (t - math.sin(t)) / 2
        away = 4 * radius * math.sin(t / 2) ** 3 / (3 * (t - math.sin(t)))  # from the centre
        middle = 1 + radius * math.cos(t / 2) - away  # abscissa: the centre lies outside the right side
        block = self.solve(BOX, "[{from: [1, 0], bulge: -0.3}]", "{mated: true, between: [[-1, 0], [1, 0]]}")["block"]
        self.assert_close(block["area_m2"], 4 - area)
        self.assert_close(block["centroid_x_m"], -area * middle / (4 - area))

    def test_circle(self):
        """Two arcs of one circle on a flat are the ellipse of equal axes, which has its own closed form."""
        case = self.solve("[[-0.6, 0], [0.6, 0], [0, 1.8]]",
                          "[{from: [0.6, 0], through: [1, 0.8]}, {from: [0, 1.8], through: [-1, 0.8]}]",
                          "{mated: true, between: [[-0.6, 0], [0.6, 0]]}")
        self.scene.write_text("topple: 1\nlength_unit: m\nblock:\n  ellipse: {width: 2, height: 2, flat: 1.2}\n"
                              "  unit_weight_kn_m3: 26\ntilt: {towards: left, angle_deg: 5}\n")
        other = solve(self.scene)["cases"][0]
        for key in ("area_m2", "centroid_x_m", "centroid_y_m", "weight_n", "second_moment_xx_m4",
                    "second_moment_yy_m4"):
            one, two = case["block"][key], other["block"][key]
            self.assertLessEqual(abs(one["value"] - two["value"]), one["error"] + two["error"], key)
        one, two = (c["toppling"]["critical_angle_deg"] for c in (case, other))
        self.assertLessEqual(abs(one["value"] - two["value"]), one["error"] + two["error"])

    def test_random_bulges(self):
        """Random arcs on the sides and the top of a box against inscribed polygons: the gap falls as the
        square of the chords' angle."""
        random.seed(71)
        for _ in range(20):
            bulges = [Fraction(random.randint(1, 40), 100) for _ in range(3)]
            corners = [(4, 0), (4, 6), (0, 6), (0, 0)]
            arcs = ", ".join(f"{{from: [{x}, {y}], bulge: {b}}}" for (x, y), b in zip(corners, bulges))
            case = self.solve("[[0, 0], [4, 0], [4, 6], [0, 6]]", f"[{arcs}]",
                              "{mated: true, between: [[0, 0], [4, 0]]}")
            gaps = []
            for n in (60, 120):
                ring = [(Fraction(0), Fraction(0)), (Fraction(4), Fraction(0))]
                for (p, q), b in zip(zip(corners, corners[1:]), map(float, bulges)):
                    chord = math.hypot(q[0] - p[0], q[1] - p[1])
                    theta = 4 * math.atan(b)
                    r = chord / 2 / math.sin(theta / 2)
                    ux, uy = (q[0] - p[0]) / chord, (q[1] - p[1]) / chord
                    cx = (p[0] + q[0]) / 2 - uy * r * math.cos(theta / 2)
                    cy = (p[1] + q[1]) / 2 + ux * r * math.cos(theta / 2)
                    first = math.atan2(p[1] - cy, p[0] - cx)
                    ring += [(Fraction(cx + r * math.cos(first + theta * k / n)),
                              Fraction(cy + r * math.sin(first + theta * k / n))) for k in range(n + 1)]
                m = exact.ring_moments(ring)
                gaps.append((abs(float(m[0]) - case["block"]["area_m2"]["value"]),
                             abs(float(m[1] / m[0]) - case["block"]["centroid_x_m"]["value"]) + 1e-13))
            self.assertLess(gaps[1][0], 1e-2)
            self.assertAlmostEqual(gaps[0][0] / gaps[1][0], 4, delta=0.01)
            if gaps[1][1] > 1e-9:
                self.assertAlmostEqual(gaps[0][1] / gaps[1][1], 4, delta=0.1)

    def test_only_where_called_for(self):
        """Arcs are in the account of effects where there are some."""
        case = self.solve(BOX, "[{from: [1, 2], bulge: 0.2}]")
        self.assertIn("arcs", [e["name"] for e in case["effects"]])

    def test_wrong_arcs(self):
        wide = "[[0, 0], [4, 0], [4, 4], [3, 4], [3, 1], [1, 1], [1, 4], [0, 4]]"
        for outline, arcs, base, message in (
                (BOX, "[{from: [1, 2], through: [0, 2]}]", "{mated: true}", "this arc is straight"),
                (BOX, "[{from: [1, 2], bulge: 0}]", "{mated: true}", "a bulge of 0 is a straight edge"),
                (BOX, "[{from: [1, 2], bulge: -5}]", "{mated: true}", "turned inside out"),
                (BOX, "[{from: [-1, 0], bulge: -0.1}]", "{mated: true}", "touches its base on an arc"),
                (BOX, "[{from: [1, 2], bulge: -0.1}]\n  holes: [[[0, 0.5], [0.2, 0.5], [0, 0.7]]]", "{mated: true}",
                 "takes arcs outwards alone"),
                (BOX, "[{from: [1, 3], bulge: 1}]", "{mated: true}", "begins in no vertex"),
                (BOX, "[{from: [1, 2], bulge: 1, through: [0, 3]}]", "{mated: true}", "goes 'through' a point, or"),
                (BOX, "[{from: [1, 2]}]", "{mated: true}", "goes 'through' a point, or"),
                (BOX, "{from: [1, 2]}", "{mated: true}", "arcs are a list"),
                (BOX, "[{from: [-1, 0], bulge: 0.1}]", "{mated: true}", "touches its base on an arc"),
                (wide, "[{from: [3, 1], bulge: 1}, {from: [4, 4], bulge: 6}]", "{mated: true}", "itself"),
                (BOX, "[{from: [1, 2], bulge: 0.5}]\n  rounded: {corners: [{at: [1, 2], radius: 0.1}]}",
                 "{mated: true}", "a corner where an arc ends is not rounded"),
                (BOX, "[{from: [1, 2], bulge: 1}]\n  parts: [{outline: [[0, 0], [1, 0], [1, 1]], "
                      "unit_weight_kn_m3: 20}]", "{mated: true}", "a block with parts takes no arcs")):
            self.scene.write_text(SCENE % (outline, arcs, base))
            status, out, err = run("solve", self.scene)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(message, err)
            self.assertIn("scene.yaml:", err)
        self.scene.write_text(SCENE % (BOX, "[{from: [1, 2], bulge: 1}]", "{mated: true}"))
        self.assertIn("not for curves", run("derive", self.scene)[2])


if __name__ == "__main__":
    main()
