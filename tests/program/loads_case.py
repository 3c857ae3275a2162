# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of loads share: slabs under loads, solved."""

import math
import pathlib
import tempfile
import unittest

from harness import solve

G = 26.0  # kN/m3


def slab(width, height, loads, tilt=None, towards="left", friction=None, extra=""):
    return ("topple: 1\nlength_unit: m\nblock:\n  slab: {width: %r, height: %r}\n  unit_weight_kn_m3: 26\n%s"
            "loads: %s\n%stilt: {towards: %s%s}\n"
            % (width, height, extra, loads, f"friction_angle_deg: {friction!r}\n" if friction else "",
               towards, f", angle_deg: {tilt!r}" if tilt is not None else ""))


def opening(q0, q1, pivot, side):
    """Of the facet from q0 to q1, as the block turns about the pivot towards the left (1) or right (-1)."""
    t = (q1[0] - q0[0], q1[1] - q0[1])
    ends = [max(0, side * ((q[0] - pivot[0]) * t[0] + (q[1] - pivot[1]) * t[1])) for q in (q0, q1)]
    return side * (ends[1] ** 2 - ends[0] ** 2) / (2 * (t[0] ** 2 + t[1] ** 2))


class LoadsCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def solve(self, *arguments, **options):
        self.scene.write_text(slab(*arguments, **options))
        return solve(self.scene)["cases"][0]

    def assert_angle(self, case, expected):
        """The critical angle within its bound, and 1e-10 degrees for the expected one's roundings."""
        found = case["toppling"]["critical_angle_deg"]
        self.assertLessEqual(abs(found["value"] - expected), found["error"] + 1e-10)

    def assert_fos(self, case, expected):
        self.assertAlmostEqual(case["toppling"]["fos"]["value"], expected, delta=1e-11 * abs(expected))

    def compare_bonds(self, points, ring, bond):
        outline = ", ".join(f"[{float(x)}, {float(y)}]" for x, y in ring)
        self.scene.write_text("topple: 1\nlength_unit: m\nblock: {unit_weight_kn_m3: 26, outline: [%s]}\n"
                              "base: {mated: whole}\nloads: {bond_kpa: %d}\ntilt: {towards: both}\n" % (outline, bond))
        cross = [a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1])]
        area = sum(cross) / 2
        centre = [sum((a[axis] + b[axis]) * c for a, b, c in zip(ring, ring[1:] + ring[:1], cross)) / (6 * area)
                  for axis in range(2)]
        compared = 0
        for case in solve(self.scene, "--pivots", "all")["cases"]:
            side = 1 if case["towards"] == "left" else -1
            for pivot in case["pivots"]:
                at = (pivot["x_m"]["value"], pivot["y_m"]["value"])
                p = min(points, key=lambda q: math.dist((float(q[0]), float(q[1])), at))
                held = bond * sum(opening(a, b, p, side) for a, b in zip(points, points[1:]))
                # 26 area ((y_G - y_P) sin a - side (x_G - x_P) cos a) = held
                up, along = 26 * area * (centre[1] - p[1]), 26 * area * (centre[0] - p[0]) * side
                size = math.hypot(up, along)
                if held > size:
                    self.assertIsNone(pivot["critical_angle_deg"])
                    continue
                expected = math.degrees(math.atan2(along, up) + math.asin(held / size))
                if not -90 < expected < 90:
                    continue
                found = pivot["critical_angle_deg"]
                self.assertLessEqual(abs(found["value"] - expected), found["error"] + 1e-10)
                compared += 1
        self.assertGreater(compared, len(points))
