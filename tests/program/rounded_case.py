# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of rounded corners share: the blocks of the paper, rounded, and back-analysis."""

import json
import pathlib
import tempfile
import unittest

from harness import run

SCENE = ("topple: 1\nlength_unit: mm\nblock:\n  teeth: {{count: {n}, width: {a}, height: {b}, depth: {c}, "
         "left_end: {end}}}\n  rounded: {{model: {model}, corners: [{{at: left_end, radius: {r}}}]}}\n"
         "  unit_weight_kn_m3: 25.8\ntilt: {{towards: left}}\n")


class RoundedCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, n, a, b, c, end, r, model="paper"):
        self.scene.write_text(SCENE.format(n=n, a=a, b=b, c=c, end=end, r=r, model=model))

    def find(self, target, *more, scene=None):
        status, out, err = run("solve", "--json", "--find", "block.rounded.corners.1.radius", "--for",
                               target, *more, scene or self.scene)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)["find"]
