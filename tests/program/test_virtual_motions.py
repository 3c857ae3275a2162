# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Walls and rows of columns whose modes are too many for a search: a virtual motion excludes every motion.

The story: a dry-stone wall of 20 blocks, for which 1.2 is required, was `can be held` and undecided, as was every row of
columns on steps from six columns on. Motions that are proven bound the factors from above."""

import tempfile
import unittest
from pathlib import Path

from harness import main, solve

COURSES = [(84, 36), (456, 684), (756, 324), (408, 612), (672, 288), (36, 54), (588, 252), (312, 468), (504, 216), (264, 396)]


def metres(number):
    """A width of the wall: in centimetres where it has two digits."""
    return number / (100 if number < 100 else 1000)


def wall(towards="left"):
    """Ten courses of two blocks, each course set back by 6 cm, shaken by a fifth of its weight."""
    sign = 1 if towards == "left" else -1
    lines = []
    for k, widths in enumerate(COURSES):
        at = 0.06 * k
        for width in map(metres, widths):
            x, y = sorted((sign * at, sign * (at + width))), (0.25 * k, 0.25 * (k + 1))
            corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
            lines.append(f"  - {{outline: {[[round(float(c), 6) for c in corner] for corner in corners]}}}\n")
            at += width
    return ("topple: 1\nlength_unit: m\nfriction_angle_deg: 32\nblock: {unit_weight_kn_m3: 22}\nblocks:\n"
            "  - {ground: true, outline: [[-3, -0.5], [3, -0.5], [3, 0], [-3, 0]]}\n" + "".join(lines) +
            f"tilt: {{towards: {towards}}}\nloads: {{seismic: {{horizontal: 0.2}}}}\nrequired_fos: 1.2\n")


def row(count, towards="left", scale=1, unit="m"):
    """Columns on steps of a quarter of their width, the middle one the highest, tilted by 10 degrees."""
    sign = 1 if towards == "left" else -1
    steps, columns = [], []
    for k in range(count):
        low, high = k / 4, k / 4 + 3 * (1 - abs(k - count / 2) / count)
        steps += [(k, low), (k + 1, low)]
        columns.append([(k, low), (k + 1, low), (k + 1, high), (k, high)])
    ground = [(-3, -2), (count + 3, -2), (count + 3, count / 4), (count, count / 4), *reversed(steps), (-3, 0)]
    text = [[[round(sign * x * scale, 6), round(y * scale, 6)] for x, y in outline] for outline in [ground, *columns]]
    if sign < 0:
        text = [outline[::-1] for outline in text]
    lines = "".join(f"  - {{outline: {outline}}}\n" for outline in text[1:])
    return (f"topple: 1\nlength_unit: {unit}\nfriction_angle_deg: 35\nblock: {{unit_weight_kn_m3: 25}}\nblocks:\n"
            f"  - {{ground: true, outline: {text[0]}}}\n{lines}tilt: {{towards: {towards}, angle_deg: 10}}\nrequired_fos: 1.2\n")


class Standing(unittest.TestCase):
    def check(self, scene, strength, driving):
        """At least these numbers are proven, and never more than what a motion was proven for."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.yaml"
            path.write_text(scene, encoding="utf-8")
            case, = solve(path)["cases"]
        self.assertEqual((case["verdict"], case["meets_required"]), ("stands", "met"))
        for key, least in (("fos_by_strength", strength), ("fos_by_driving", driving)):
            self.assertGreaterEqual(case[key]["at_least"], least)
            self.assertLessEqual(case[key]["at_least"], case[key]["at_most"])
        self.assertEqual(case["governing_fos"]["at_least"], min(case[k]["at_least"] for k in ("fos_by_strength", "fos_by_driving")))
        return case

    def test_wall(self):
        """Strength over 3.124 no forces hold; driving loads times 2.884 a motion can begin."""
        case = self.check(wall(), 3, 1.3)
        self.assertAlmostEqual(case["fos"]["value"], 3.124, delta=1e-3)

    def test_row(self):
        """To either side, in metres and millimetres: how far proofs reach may differ, as roundings do."""
        for scene in (row(12), row(12, "right", scale=1000, unit="mm")):
            self.check(scene, 3.5, 1.5)


if __name__ == "__main__":
    main()
