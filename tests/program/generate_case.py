# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of generated profiles share: scenes of them, and the points of the CSV that the program writes."""

import pathlib
import tempfile
import unittest
from fractions import Fraction

from harness import run

TEETH = "teeth: {count: %d, wavelength: 60, amplitude: 5, left_end: valley%s}"
FAR = "block: {outline: [[0, 1000], [1, 1000], [1, 1001]]}"  # set down on any of them
WIDE = "block: {outline: [[40, 999], [60, 999], [60, 1001], [40, 1001]]}"


def scene(profile, block=FAR, base="place: rest", more=""):
    return f"topple: 1\nlength_unit: mm\n{block}\nbase: {{profile: {{{profile}}}, {base}}}\n{more}"


class GenerateCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, text, name="scene.yaml"):
        (self.path / name).write_text(text)
        return self.path / name

    def profile(self, made, **more):
        """Its CSV, and its points."""
        status, _, err = run("solve", self.write(scene(made, **more)), "--write-profile", self.path / "out.csv")
        self.assertEqual((status, err), (0, ""), made)
        text = (self.path / "out.csv").read_text()
        lines = text.splitlines()
        self.assertEqual(lines[0], "x,y")
        return text, [tuple(map(Fraction, line.split(","))) for line in lines[1:]]
