# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where Barton's law ends: contacts that have no area, and stresses above the strength of the joint wall.

On points there is no normal stress, and no number of bits finds one: the scene is refused by name, and the width of
the contact that it may state instead is what the law is asked at. Above JCS the law's logarithm is below 0; what is
left of a joint whose asperities are crushed is its residual friction, so the angle is no less than that, with a
caution. Friction angles are worked here in floats from Eq. (8)."""

import json
import math
import pathlib
import random
import tempfile
import unittest

import rest_case
from harness import main, run

POINTS = "[[0, 0], [1, 0.2], [2, 0], [2, 2], [0, 2]]"
AREA, GAMMA = 3.8, 26.0
LAW = "{law: barton, residual_angle_deg: 28, jrc: 8, jcs_mpa: %s}"


def scene(outline, friction, profile="[[-1, 0], [3, 0]]", more="", tilt=10):
    return ("topple: 1\nlength_unit: m\nblock: {outline: %s, unit_weight_kn_m3: 26}\nbase: {profile: %s}\n"
            "friction: %s\n%stilt: {towards: left, angle_deg: %s}\n" % (outline, profile, friction, more, tilt))


class Barton(unittest.TestCase):
    def solve(self, text, *options):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text(text)
            return run("solve", *options, path)

    def case(self, text):
        status, out, err = self.solve(text, "--json")
        self.assertEqual((status, err), (0, ""), text)
        found = json.loads(out)
        return found["cases"][0], " ".join(note["text"] for note in found.get("notes", []) if note["kind"] == "caution")

    def refused(self, text, *said):
        status, out, err = self.solve(text)
        self.assertEqual((status, out), (3, ""), err)
        for words in said:
            self.assertIn(words, err)

    def test_points_are_refused_by_name(self):
        """Two feet: the line and column of the law, and the key that would help."""
        self.refused(scene(POINTS, LAW % 120), "scene.yaml:5:45:", "'contact: {width: …}' in m", "friction_angle_deg")

    def test_rests_are_refused_or_told(self):
        """Of 16 blocks that come to rest on rough profiles none is left undecided: those that touch in points are
        refused, and have an answer once a width is stated."""
        draw = random.Random(7)
        refused = 0
        for _ in range(16):
            block, profile = rest_case.random_block(draw), rest_case.random_profile(draw)
            text = scene(rest_case.text(block), LAW % 120, rest_case.text(profile) + ", place: rest", tilt=0)
            status, _, err = self.solve(text)
            if status == 0:
                continue
            self.assertEqual(status, 3, err + text)
            if "finds no mean normal stress" not in err:
                continue  # it comes to no rest
            refused += 1
            status, _, err = self.solve(text + "contact: {width: 0.01}\n")
            self.assertEqual(status, 0, err + text)
        self.assertGreater(refused, 5)

    def test_a_stated_width(self):
        """The stress is the weight over the width that is stated; the friction is found where it slides, at
        W cos(alpha) over that width, in metres or in millimetres."""
        for width in (0.001, 0.05, 1.5):
            case, _ = self.case(scene(POINTS, LAW % 120, more="contact: {width: %r}\n" % width))
            angle = 40.0
            for _ in range(200):
                stress = AREA * GAMMA / width * math.cos(math.radians(angle))
                angle = 28 + 8 * max(0.0, math.log10(120000 / stress))
            found = case["sliding"]["critical_angle_deg"]
            self.assertAlmostEqual(found["value"], angle, delta=1e-9)
            at_tilt = 28 + 8 * max(0.0, math.log10(120000 / (AREA * GAMMA / width * math.cos(math.radians(10)))))
            self.assertAlmostEqual(case["sliding"]["fos_strength"]["value"],
                                   math.tan(math.radians(at_tilt)) / math.tan(math.radians(10)), delta=1e-9)
        one = self.case(scene(POINTS, LAW % 120, more="contact: {width: 0.05}\n"))[0]["sliding"]["critical_angle_deg"]
        feet = "[[0, 0], [1000, 200], [2000, 0], [2000, 2000], [0, 2000]]"
        other = scene(feet, LAW % 120, "[[-1000, 0], [3000, 0]]", "contact: {width: 50}\n").replace(
            "length_unit: m", "length_unit: mm")
        self.assertAlmostEqual(self.case(other)[0]["sliding"]["critical_angle_deg"]["value"], one["value"], delta=1e-9)

    def test_a_width_beyond_what_touches(self):
        """A slab of 2 m stated to be 3 m wide: less stress, more friction, and a caution."""
        slab = "[[0, 0], [2, 0], [2, 2], [0, 2]]"
        _, said = self.case(scene(slab, LAW % 120, more="contact: {width: 3}\n"))
        self.assertIn("stated to be 3 m wide but touches over 2", said)
        _, said = self.case(scene(slab, LAW % 120, more="contact: {width: 1}\n"))
        self.assertNotIn("touches on", said)

    def test_a_width_without_the_law(self):
        """Friction that does not depend on stress has no use for it."""
        self.refused(scene(POINTS, LAW % 120, more="contact: {width: 1}\n").replace(
            "friction: " + LAW % 120, "friction_angle_deg: 30"), "scene.yaml:6:18:", "is for the law barton")
        self.refused(scene(POINTS, LAW % 120, more="contact: {width: 0}\n"), "above zero")
        self.refused(scene(POINTS, LAW % 120, more="contact: {}\n"), "contact")

    def test_above_the_strength_of_the_wall(self):
        """On a foot of 1e-8 m the stress is ten million MPa: the friction is the residual angle, exactly, no less,
        and the caution tells both stresses. Under a pressure that presses it just above JCS at its tilt likewise."""
        foot = "[[0, 0], [0.00000001, 0], [1, 0.2], [2, 0], [2, 2], [0, 2]]"
        case, said = self.case(scene(foot, LAW % 5))
        for part in ("sliding", "limit"):
            self.assertEqual(case[part]["friction_angle_deg"], {"value": 28, "error": 0}, part)
        self.assertAlmostEqual(case["sliding"]["fos_strength"]["value"],
                               math.tan(math.radians(28)) / math.tan(math.radians(10)), delta=1e-12)
        self.assertIn("mean normal stress on the contact is 9.88e+06 MPa and exceeds JCS, 5 MPa", said)
        self.assertIn("the residual angle, 28°", said)
        slab = "[[0, 0], [2, 0], [2, 2], [0, 2]]"
        pressed = "loads: {pressures: [{from: [2, 2], to: [0, 2], kpa: %s}]}\n"
        for kpa, crushed in ((5000, True), (4900, False)):  # and some 50 kPa of the weight
            case, said = self.case(scene(slab, LAW % 5, more=pressed % kpa))
            friction = 28 + 8 * max(0.0, math.log10(5000 / (kpa + 52 * math.cos(math.radians(10)))))
            weight = 104 * math.sin(math.radians(10))
            normal = 104 * math.cos(math.radians(10)) + 2 * kpa
            factor = {f["definition"]: f["fos"] for f in case["factors"]}["shear strength"]
            self.assertAlmostEqual(factor["value"], normal * math.tan(math.radians(friction)) / weight, delta=1e-6)
            self.assertEqual("exceeds JCS, 5 MPa" in said, crushed, said)

    def test_never_below_the_residual_angle(self):
        """By widths from a hair to the whole sole: friction falls towards the residual angle and stays there, and
        no roughness angle puts it below (Eq. 10 makes of one at a stress above JCS a JRC below 0)."""
        before = 71.0
        for width in (2, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6):
            more = "contact: {width: %s}\n" % f"{width:.6f}"
            case, _ = self.case(scene(POINTS, LAW % 5, more=more))
            found = case["sliding"]["friction_angle_deg"]["value"]
            self.assertLessEqual(found, before)
            self.assertGreaterEqual(found, 28)
            before = found
        self.assertEqual(before, 28)
        law = "{law: barton, residual_angle_deg: 28, roughness_angle_deg: 9, jcs_mpa: 5}"
        case, _ = self.case(scene(POINTS, law, more="contact: {width: 0.001}\n"))
        self.assertEqual(case["sliding"]["friction_angle_deg"], {"value": 28, "error": 0})


if __name__ == "__main__":
    main()
