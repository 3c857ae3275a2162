# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Loads whose line passes through the pivot, exactly: they turn nothing, wherever the origin lies.

The line of each is put through the toe by hand; the account has to show a moment of 0 with an error of 0, and the
scene the same answers in every frame: shifted by whole numbers, by fractions, by a million, as its mirror image, in
other units. Once such a block had a report with its toe at (0, 0) and none, exit status 4, with its toe at (1, 1)."""

import json
import math
import pathlib
import tempfile
import unittest
from fractions import Fraction

from harness import main, run

SQUARE = [(0, 0), (4, 0), (4, 5), (0, 5)]
NOTCHED = [(0, 0), (4, 0), (4, 3), (3, 4), (0, 4)]  # the line normal to the cut corner's middle passes the toe
LEANING = [(0, 0), (3, 0), (Fraction(22, 5), 5), (Fraction(7, 5), 5)]  # centroid at x = 2.2
OVERHANGING = [(0, 0), (4, 0), (4, 5), (-1, 5), (-1, 4), (0, 3)]

#: Frames: a shift, a mirror image, metres per unit of length.
FRAMES = [(0, 0, False, 1, "m"), (1, 1, False, 1, "m"), (Fraction(1, 3), Fraction(-2, 7), False, 1, "m"),
          (10 ** 6, -10 ** 6 - Fraction(1, 9), False, 1, "m"), (0, 0, True, 1, "m"), (5, Fraction(1, 10), True, 1, "m"),
          (2, 3, False, Fraction(1, 1000), "mm"), (-7, 1, True, Fraction(3048, 10000), "ft")]


class Frame:
    def __init__(self, dx, dy, mirrored, metres, unit):
        self.dx, self.dy, self.mirrored, self.metres, self.unit = dx, dy, mirrored, metres, unit

    def point(self, x, y):
        x, y = (Fraction(x) + self.dx) / self.metres, (Fraction(y) + self.dy) / self.metres
        return f"[{-x if self.mirrored else x}, {y}]"

    def chain(self, points):
        points = points[::-1] if self.mirrored else points
        return "[" + ", ".join(self.point(x, y) for x, y in points) + "]"

    def line(self, begin, end):
        """A pressure runs counter-clockwise, in a mirror image too."""
        begin, end = (end, begin) if self.mirrored else (begin, end)
        return f"from: {self.point(*begin)}, to: {self.point(*end)}"

    def direction(self, degrees):
        return 180 - Fraction(degrees) if self.mirrored else degrees

    def towards(self):
        return "right" if self.mirrored else "left"


def anchor(at, direction):
    return lambda f: "{anchors: [{at: %s, direction_deg: %s, force_kn: 7/3}]}" % (f.point(*at), f.direction(direction))


def pressure(begin, end):
    return lambda f: "{pressures: [{%s, kpa: 11/7}]}" % f.line(begin, end)


def surcharge(begin, end):
    return lambda f: "{surcharges: [{%s, kpa: 11/7}]}" % f.line(begin, end)


def seismic(across, up):
    return lambda f: "{seismic: {horizontal: %s, vertical: %s}}" % (across, up)


#: name, outline, profile (None: mated), loads, tilt, the load whose moment about pivot vanishes.
SCENES = [
    ("anchor at the toe", SQUARE, None, anchor((0, 0), -60), 0, "anchor"),
    ("anchor at the toe", SQUARE, None, anchor((0, 0), "100/3"), 10, "anchor"),
    ("anchor along the face that ends in the toe", SQUARE, None, anchor((0, 3), -90), 0, "anchor"),
    ("anchor along the base", SQUARE, None, anchor((3, 0), 180), 0, "anchor"),
    ("anchor askew towards the toe", SQUARE, None, anchor((2, 2), 225), 0, "anchor"),
    ("anchor askew towards the toe, tilted", SQUARE, None, anchor((3, 3), 585), 7, "anchor"),
    ("pressure towards the toe", NOTCHED, None, pressure((4, 3), (3, 4)), 0, "pressure"),
    ("pressure towards the toe, tilted", NOTCHED, None, pressure((4, 3), (3, 4)), 9, "pressure"),
    ("surcharge over the toe", OVERHANGING, None, surcharge((1, 5), (-1, 5)), 0, "surcharge"),
    ("earthquake towards the toe", SQUARE, None, seismic("1/5", "-1/4"), 0, "seismic"),
    ("earthquake towards the toe at 45 degrees", SQUARE, None, seismic("1/50", "9/50"), 45, "seismic"),
    ("uplift at the toe", LEANING, [(-2, -1), (Fraction(19, 10), -1), (2, 0), (Fraction(21, 10), -1),
                                     (Fraction(26, 10), -1), (Fraction(27, 10), 0), (Fraction(28, 10), -1), (5, -1)],
     lambda f: "{water: {height: %s, uplift: true}}" % (Fraction(3, 10) / f.metres), 0, "uplift"),
    ("no load, the centroid over the middle", SQUARE, None, anchor((4, 5), 90), 0, "weight, parallel"),
]


def answers(case):
    """What must be the same in every frame: angles, factors, words, moments."""
    def value(bounded):
        return None if bounded is None else bounded["value"]
    found = [case["mechanism"], case["first"]["mechanism"], case["governing_fos"]["mechanism"], value(case["governing_fos"]["fos"]),
             value(case["toppling"]["fos"]), value(case["toppling"].get("critical_angle_deg")),
             value(case["sliding"]["fos"]), value(case["sliding"].get("critical_angle_deg")),
             value(case["limit"].get("critical_angle_deg")), value(case["onset"].get("critical_angle_deg"))]
    for load in case["loads"]:
        found += [load["name"], load["side"], load["moment_nm"]["value"]]
    return found


def run_json(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.yaml"
        path.write_text(text)
        status, out, err = run("solve", "--json", path)
    assert status == 0, err + text
    return json.loads(out)


class ZeroArms(unittest.TestCase):
    def solve(self, scene, frame):
        _, outline, profile, loads, tilt, _ = scene
        base = "{mated: true}" if profile is None else "{profile: %s}" % frame.chain(profile)
        text = ("topple: 1\nlength_unit: %s\nblock: {outline: %s, unit_weight_kn_m3: 25, thickness: %s}\nbase: %s\n"
                "loads: %s\nfriction_angle_deg: 40\ntilt: {towards: %s, angle_deg: %s}\n"
                % (frame.unit, frame.chain(outline), 1 / Fraction(frame.metres), base, loads(frame), frame.towards(), tilt))
        found = run_json(text)
        if "uplift" not in loads(frame):  # there a mode of motion ties, on which no moment rests
            self.assertNotIn("zero_bits", found, "exactly, not by the width of a ball: " + text)
        return found["cases"][0]

    def alike(self, one, other):
        self.assertEqual(len(one), len(other))
        for a, b in zip(one, other):
            if isinstance(a, (int, float)) and isinstance(b, (int, float)):
                self.assertAlmostEqual(a, b, delta=1e-9 * max(1, abs(a)))
            else:
                self.assertEqual(a, b)

    def test_every_frame(self):
        for scene in SCENES:
            first = None
            for frame in FRAMES:
                with self.subTest(scene=scene[0], frame=frame):
                    case = self.solve(scene, Frame(*frame))
                    loads = {load["name"]: load["moment_nm"] for load in case["loads"]}
                    self.assertEqual(loads[scene[5]], {"value": 0, "error": 0})
                    first = first or answers(case)
                    self.alike(first, answers(case))

    def test_driving_loads_through_the_toe_never_overturn(self):
        """An earthquake whose line passes through the toe, multiplied by any number, leaves the moment about it; and
        it never slides, as the share of it along the base is at most 4/5 of that across, below tan 40 degrees."""
        for frame in FRAMES:
            case = self.solve(SCENES[9], Frame(*frame))
            self.assertEqual(case["onset"]["fos_driving_is"], "unbounded: no driving action")

    def test_a_push_at_45_degrees_drives_whatever_rounding_leaves_of_it(self):
        """Its parts down-dip and off the base cancel. Once it drove at 11/7 kPa and rested at 1 kPa. By hand:
        lambda p = W tan(phi) / (1 - tan(phi)), as lambda p both presses and pushes by a metre of each."""
        across = 25 * 15.5 * math.tan(math.radians(40))
        for kpa in ("1", "11/7", "3/8"):
            load = "{pressures: [{from: [4, 3], to: [3, 4], kpa: %s}]}" % kpa
            one = self.solve(("", NOTCHED, None, lambda f, load=load: load, 0, "pressure"), Frame(*FRAMES[0]))
            expected = across / (1 - math.tan(math.radians(40))) / float(Fraction(kpa))
            self.assertAlmostEqual(one["onset"]["fos_driving"]["value"], expected, delta=1e-9 * expected)
            many = run_json("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nloads: %s\nblocks:\n"
                            "  - {name: ground, ground: true, outline: [[-9, -1], [4, -1], [4, 0], [0, 0], [-9, 0]]}\n"
                            "  - {name: rock, outline: [[0, 0], [4, 0], [4, 3], [3, 4], [0, 4]], unit_weight_kn_m3: 25}\n"
                            % load)
            left = next(c for c in many["cases"] if c["towards"] == "left")
            self.assertEqual(left["fos_driving_is"], "at least this")  # 1000, where its search ends


if __name__ == "__main__":
    main()
