# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Roughness of a digitised sole is no strength, and a caution says how much of it is in the factor.

A slab 4 m by 1.2 m with friction of 30° at 29° slides, on its mean plane, with tan 30° / tan 29° = 1.042. Its sole
digitised with ± 2 cm climbs over its own errors. The numbers of the caution are the governing factor the scene and
that of a second scene, with the sole drawn level."""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import main, run

SAID = re.compile(r"towards the (left|right) (?:([0-9.]+) governs|it holds up to ([0-9.]+)°|(nothing moves it)) with the sole "
                  r"as it is drawn; with ([0-9]+) of its facets, on asperities whose sides are shorter than ([0-9.]+) (m|mm), "
                  r"half of the contact, levelled into the mean plane it slides (?:with a factor of|at) ([0-9.]+)")
LEVEL = [(0, 0), (4, 0)]


def rough(draw, step, deviation=0.02):
    count = round(4 / step)
    return [(round(k * step, 3), round(draw.uniform(-deviation, deviation), 4)) for k in range(count + 1)]


class RoughSole(unittest.TestCase):
    def solve(self, sole, tilt="{towards: left, angle_deg: 29}", base="{mated: true}", more="friction_angle_deg: 30\n"):
        outline = ", ".join(f"[{x}, {y}]" for x, y in sole + [(4, 1.2), (0, 1.2)])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "slab.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {outline: [%s], unit_weight_kn_m3: 26}\nbase: %s\n%stilt: %s\n"
                            % (outline, base, more, tilt))
            status, out, err = run("solve", "--json", path)
        self.assertEqual((status, err), (0, ""))
        found = json.loads(out)
        said = [SAID.search(note["text"]) for note in found["notes"] if "as it is drawn" in note["text"]]
        self.assertNotIn(None, said)
        return found["cases"][0], [match.groups() for match in said]

    def test_digitised_soles(self):
        """Both numbers, for soles with points 0.2 to 0.4 m apart, and the level one as the closed form has it."""
        draw = random.Random(12)
        told = 0
        for step in (0.2, 0.25, 0.4) * 4:
            case, said = self.solve(rough(draw, step))
            governs = case["governing_fos"]["fos"]
            flat = math.tan(math.radians(30)) / math.tan(math.radians(29))
            if governs["value"] < 1.005 * flat:
                self.assertEqual(said, [])
                continue
            told += 1
            side, drawn, _, _, facets, length, _, level = said[0]
            self.assertEqual((side, length, float(level)), ("left", "2", round(flat, 3)))
            self.assertEqual(int(facets), round(4 / step))
            self.assertAlmostEqual(float(drawn), governs["value"], delta=6e-4)
            self.assertTrue(1.1 < governs["value"] < 1.5)  # docs/limit.md
        self.assertGreater(told, 8)

    def test_under_loads(self):
        """Water behind the slab: the level number is that of the level slab under the same water."""
        sole = rough(random.Random(5), 0.25)
        sole[0], sole[-1] = (0, 0), (4, 0)
        loads = "friction_angle_deg: 30\nloads: {water: {height: 0.3}}\n"
        _, said = self.solve(sole, more=loads, tilt="{towards: left, angle_deg: 20}")
        level, none = self.solve(LEVEL, more=loads, tilt="{towards: left, angle_deg: 20}")
        self.assertEqual(none, [])
        # the level slab weighs 124.8 kN, the digitised one some other tenths of a percent
        self.assertAlmostEqual(float(said[0][7]), level["sliding"]["fos"]["value"], delta=0.01)

    def test_without_a_tilt(self):
        """Angles in place of factors: the level sole slides at 30°."""
        case, said = self.solve(rough(random.Random(5), 0.25), tilt="{towards: left}")
        self.assertEqual(float(said[0][7]), 30)
        self.assertAlmostEqual(float(said[0][2]), case["limit"]["critical_angle_deg"]["value"], delta=6e-4)

    def test_long_waves_and_stated_teeth_are_none(self):
        """A level sole, one step from end to end, two teeth whose sides are half of the contact each, and a slab that
        topples before its level sole would slide: no caution. Teeth that the scene states as such: none either."""
        for sole in (LEVEL, [(0, 0), (4, 0.3)], [(0, 0), (2, 0.3), (4, 0)]):
            self.assertEqual(self.solve(sole, tilt="{towards: left, angle_deg: 10}")[1], [], sole)
        self.assertEqual(self.solve(rough(random.Random(5), 0.25), more="friction_angle_deg: 85\n")[1], [])
        status, out, _ = run("solve", "--json", "examples/block_e_valley.yaml")
        self.assertEqual(status, 0)
        self.assertNotIn("as it is drawn", out)


if __name__ == "__main__":
    main()
