#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""No printed factor of safety is above the true one, and no printed utilisation below.

The story: a wedge with a factor of 1.0495407 was printed as 1.05, above "the required factor of 1.05 is not met". Random
slabs on planes, whose factors are tan a / tan b in closed form, with the decimals of Python; and that wedge."""

import decimal
import math
import pathlib
import random
import re
import tempfile
import unittest

from harness import main, rounds, run

WEDGE = """topple: 1
length_unit: m
solid:
  unit_weight_kn_m3: 26
  wedge:
    height: 22
    a: {dip_deg: 48, dip_direction_deg: 110, friction_angle_deg: 30, cohesion_kpa: 10}
    b: {dip_deg: 62, dip_direction_deg: 232, friction_angle_deg: 26, cohesion_kpa: 15}
    face: {dip_deg: 68, dip_direction_deg: 180}
    upper: {dip_deg: 8, dip_direction_deg: 185}
    water: {unit_weight_kn_m3: 9.81}
loads: {anchors: [{force_kn: 1500, azimuth_deg: 350, dip_deg: 10}]}
required_fos: 1.05
"""


def solved(text, *options):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "scene.yaml").write_text(text, encoding="utf-8")
        return run("solve", *options, "scene.yaml", folder=folder)[1]


class RoundedDown(unittest.TestCase):
    def test_wedge(self):
        """Its first lines and its table: 1.049, and never 1.05 but for what is required."""
        out = solved(WEDGE)
        self.assertIn("factor of safety 1.049", out)
        self.assertIn("1.0495407", out)
        self.assertNotIn("1.05", out.replace("required factor of safety 1.05", "").replace("gives 1.05", ""))

    def test_slabs(self):
        """The least of tan(phi) / tan(dip) and of width / height / tan(dip), cut to three decimals; required over it, the
        other way."""
        drawn = random.Random(7)
        for _ in range(rounds(25, 400)):
            width, height, phi, dip = (drawn.randint(10, 99) / 10, drawn.randint(10, 99) / 10, drawn.randint(200, 500) / 10,
                                       drawn.randint(50, 300) / 10)
            required = drawn.choice((1.1, 1.3, 1.5))
            fos = min(math.tan(math.radians(phi)), width / height) / math.tan(math.radians(dip))
            out = solved(f"topple: 1\nlength_unit: m\nblock: {{slab: {{width: {width}, height: {height}}}}}\n"
                         f"base: {{mated: true, beyond: {{left: 1, right: 1}}}}\nfriction_angle_deg: {phi}\n"
                         f"tilt: {{towards: left, angle_deg: {dip}}}\nrequired_fos: {required}\n")
            printed = decimal.Decimal(re.search(r"FoS (\d+\.\d+) against", out)[1])
            cut = decimal.Decimal(fos).quantize(decimal.Decimal("0.001"), decimal.ROUND_FLOOR)
            self.assertEqual(printed, cut, (width, height, phi, dip, fos))
            needed = re.search(r"required/FoS (\d+\.\d+)", out)
            self.assertGreaterEqual(float(needed[1]) + 1e-12, required / fos)
            self.assertLess(float(needed[1]) - required / fos, 1.001e-3)


main()
