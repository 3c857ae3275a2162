#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Water below a level in an open gap before the first contact of a block.

The story: a boulder touches its base in two points, and behind the upper one a gap is open to the water. Its uplift was taken
along a line through the block, from the mouth of the gap to the toe: 0.58 kN m about the toe, where the gap at its full
pressure and the joint behind it give 2.95. The moment is integrated here from the outline at rest, which is turned by the
angle and moved by the distance that the report has."""

import json
import math
import pathlib
import tempfile
import unittest

from boulder_case import BASE, BOULDER
from harness import main, run
from pdf_words import words

TOE, HEEL = (0.31, 0.27), (1.28, 0.79)
GAMMA, LEVEL = 9.81, 1.2


def scene(water, mirrored=False):
    sign = -1 if mirrored else 1
    outline = [[sign * x, y] for x, y in BOULDER]
    base = [[sign * x, y] for x, y in BASE]
    if mirrored:
        outline, base = outline[::-1], base[::-1]
    return ("topple: 1\nlength_unit: m\nframe: world\n"
            f"block: {{outline: {outline}, unit_weight_kn_m3: 26.5}}\n"
            f"base: {{profile: {base}, place: rest}}\nfriction_angle_deg: 33\nloads: {{water: {water}}}\n")


def solved(text, *options):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "scene.yaml").write_text(text, encoding="utf-8")
        status, out, err = run("solve", *options, "scene.yaml", folder=folder)
    return status, out, err


def centroid(points):
    area = x = y = 0
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        cross = x0 * y1 - x1 * y0
        area, x, y = area + cross, x + (x0 + x1) * cross, y + (y0 + y1) * cross
    return x / (3 * area), y / (3 * area)


def at_rest(rest):
    """The outline where it rests."""
    turn, (cx, cy) = math.radians(rest["turned_deg"]["value"]), centroid(BOULDER)
    dx, dy = cx + rest["moved_x_m"]["value"], cy + rest["moved_y_m"]["value"]
    return [(dx + (x - cx) * math.cos(turn) - (y - cy) * math.sin(turn),
             dy + (x - cx) * math.sin(turn) + (y - cy) * math.cos(turn)) for x, y in BOULDER]


def moment(points, pressures, pieces=2000):
    """About the toe, counter-clockwise, of a pressure that is linear along each line of a chain with the block on its left,
    summed piece by piece."""
    total = 0
    for (x0, y0), (x1, y1), p0, p1 in zip(points, points[1:], pressures, pressures[1:]):
        for k in range(pieces):
            s = (k + 0.5) / pieces
            x, y, p = x0 + s * (x1 - x0), y0 + s * (y1 - y0), p0 + s * (p1 - p0)
            fx, fy = -p * (y1 - y0) / pieces, p * (x1 - x0) / pieces
            total += (x - TOE[0]) * fy - (y - TOE[1]) * fx
    return total


def depth(point):
    return GAMMA * max(0, LEVEL - point[1])


class UpliftGap(unittest.TestCase):
    def uplift(self, water):
        status, out, err = solved(scene(water), "--json")
        self.assertIn(status, (0, 1), err)
        case = json.loads(out)["cases"][0]
        loads = {load["name"]: load["moment_nm"]["value"] for load in case["loads"]}
        return loads["uplift"] / 1000, at_rest(case["rest"]), case, json.loads(out)

    def test_triangular(self):
        """Full in the gap, then falling to nothing at the toe."""
        found, outline, _, _ = self.uplift("{level: 1.2, faces: behind, uplift: triangular}")
        gap = [HEEL, outline[3], outline[4]]
        expected = moment([TOE, HEEL], [0, depth(HEEL)]) + moment(gap, [depth(p) for p in gap])
        self.assertAlmostEqual(found, expected, delta=2e-4)
        self.assertAlmostEqual(found, 2.95, delta=5e-3)

    def test_full(self):
        """With the toe blocked the gap in front of it, up to where the underside turns up, is as full as that behind."""
        found, outline, _, _ = self.uplift("{level: 1.2, faces: behind, uplift: full}")
        gap, front = [HEEL, outline[3], outline[4]], [outline[0], TOE]
        expected = moment([TOE, HEEL], [depth(TOE), depth(HEEL)]) + moment(gap, [depth(p) for p in gap]) + moment(
            front, [depth(p) for p in front])
        self.assertAlmostEqual(found, expected, delta=2e-4)

    def test_note(self):
        """Heel, toe, pressures and length stand in a note; so they do of a `height`, whose gap draws a caution."""
        notes = " ".join(note["text"] for note in self.uplift("{level: 1.2, faces: behind, uplift: triangular}")[3]["notes"])
        self.assertIn("uplift: heel (1.28, 0.79) m with 4.0221 kPa, toe (0.31, 0.27) m with 0 kPa, 1.1006 m long", notes)
        self.assertRegex(notes, r"in the open gap before its outermost contact, 0\.45\d* m long")
        status, out, err = solved(scene("{height: 0.3, uplift: true}"))
        self.assertIn(status, (0, 1), err)
        self.assertIn("begins with an open gap", " ".join(out.split()))
        self.assertRegex(" ".join(out.split()), r"uplift: heel \(.*\) m with [\d.]+ kPa, toe")

    def test_sheet_and_figure(self):
        """The sheet has the note of heel and toe and the moment of 2.95 kN m; the figure draws the pressures, and says that it does: without
        water it has neither their arrows nor their name."""
        with tempfile.TemporaryDirectory() as folder:
            told = {}
            for name, text in (("wet", scene("{level: 1.2, faces: behind, uplift: triangular}")),
                               ("dry", scene("{level: 1.2, faces: behind, uplift: triangular}").partition("loads:")[0])):
                (pathlib.Path(folder) / "scene.yaml").write_text(text, encoding="utf-8")
                for option in ("--figure=f.pdf", "--figure=f.svg", "--report=r.md"):
                    self.assertIn(run("solve", "--quiet", option, "scene.yaml", folder=folder)[0], (0, 1))
                sheet = (pathlib.Path(folder) / "r.md").read_text(encoding="utf-8")
                svg = (pathlib.Path(folder) / "f.svg").read_text(encoding="utf-8")
                told[name] = words(pathlib.Path(folder) / "f.pdf"), sheet, svg.count("<path")
        self.assertIn("water pressure", told["wet"][0])
        self.assertNotIn("water pressure", told["dry"][0])
        self.assertGreater(told["wet"][2], told["dry"][2] + 4)
        self.assertIn("uplift: heel (1.28, 0.79) m with 4.0221 kPa, toe (0.31, 0.27) m with 0 kPa, 1.1006 m long", told["wet"][1])
        (row,) = [line for line in told["wet"][1].splitlines() if line.startswith("| uplift |") and "overturns" in line]
        moment = float(row.split("|")[4].replace("\\", ""))
        self.assertAlmostEqual(moment, 2.95, delta=5e-3)

    def test_mirrored(self):
        """The mirror image has the same moment, to the other side."""
        water = "{level: 1.2, faces: behind, uplift: triangular}"
        own = self.uplift(water)[0]
        case = json.loads(solved(scene(water, mirrored=True), "--json")[1])["cases"][0]
        loads = {load["name"]: load["moment_nm"]["value"] for load in case["loads"]}
        self.assertEqual(case["towards"], "right")
        self.assertAlmostEqual(loads["uplift"] / 1000, own, places=9)


main()
