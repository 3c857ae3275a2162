# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of mated bases share: scenes of an outline, solved, and where the contact ends."""

import pathlib
import tempfile
import unittest
from fractions import Fraction

from harness import run, solve

SEED = 5


class MatedCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, outline, base="", towards="right", more=""):
        points = ", ".join(f"[{x}, {y}]" for x, y in outline)
        self.path.write_text(f"topple: 1\nlength_unit: m\nblock: {{outline: [{points}]}}\n{base}\n{more}\n"
                             f"friction_angle_deg: 30\ntilt: {{towards: {towards}, angle_deg: 15}}\n", encoding="utf-8")

    def case(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"][0]

    def refused(self, *arguments, **options):
        self.write(*arguments, **options)
        status, out, err = run("solve", self.path)
        self.assertEqual((status, out), (3, ""))
        return err

    def ends(self, case):
        told = case["contact"]
        return [(told[side]["x_m"]["value"], told[side]["y_m"]["value"], told[side]["is"])
                for side in ("left_end", "right_end")]

    def boulder(self, r, count):
        """A convex polygon on the unit circle, of rational vertices."""
        turns = sorted({Fraction(r.randint(-40 * 64, 40 * 64), 64 * r.randint(1, 40)) for _ in range(count)})
        return [((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)) for t in turns]
