# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of the governing factor of safety share: slabs, scenes of two apexes, and how they are solved."""

import json
import pathlib
import tempfile
import unittest

from harness import run

APEXES = """topple: 1
length_unit: m
block: {outline: [[0, 0], [1, 1], [2, 0], [2, 4], [0, 4]]}
base: {profile: [[-1, -1], [0, 0], [1, -1], [2, 0], [3, -1]]}
friction_angle_deg: 38
tilt: {towards: left, angle_deg: 5}
"""


def slab(width, height, friction, tilt, towards="left"):
    friction = "" if friction is None else f"friction_angle_deg: {friction}\n"
    angle = "" if tilt is None else f", angle_deg: {tilt}"
    return ("topple: 1\nlength_unit: m\n"
            f"block: {{slab: {{width: {width}, height: {height}}}, unit_weight_kn_m3: 25}}\n"
            f"base: {{mated: true, beyond: {{left: 1, right: 1}}}}\n{friction}tilt: {{towards: {towards}{angle}}}\n")


class GoverningCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple governing ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def scene(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def solve(self, text, *options, status=0):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertEqual(done, status, err)
        return json.loads(out)["cases"]

    def near(self, number, truth):
        self.assertLessEqual(abs(number["value"] - truth), number["error"] + 1e-12 * abs(truth))

    def by(self, case, definition):
        *_, factor = [f for f in case["factors"] if f["definition"] == definition]  # one that counts stands last
        return factor
