# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of the limit under loads share: scenes of an outline under loads, solved."""

import pathlib
import random
import tempfile
import unittest

from harness import solve

GAMMA = 26.0


class LimitLoadsCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, outline, friction, loads, towards="left", tilt=""):
        points = ", ".join(f"[{x!r}, {y!r}]" for x, y in outline)
        self.text = (f"topple: 1\nlength_unit: m\nblock:\n  outline: [{points}]\n"
                     f"  unit_weight_kn_m3: 26\nbase: {{mated: true, beyond: {{left: 0, right: 0}}}}\n"
                     f"loads: {{{loads}}}\nfriction_angle_deg: {friction!r}\n"
                     f"tilt: {{towards: {towards}{tilt}}}\n")
        self.path.write_text(self.text)

    def solve(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"][0]

    def random_scene(self):
        """A rough block, its loads as text, and as F_cos, F_sin, F_1 towards either side."""
        count = random.randint(1, 4)
        under = [(float(k), round(random.uniform(-0.3, 0.3), 2)) for k in range(count + 1)]
        height = round(random.uniform(0.5, 6), 2)
        left, right = (round(random.uniform(0, 0.5), 2) for _ in range(2))
        outline = under + [(count - right, height), (left, height)]
        strength = [random.choice([0, round(random.uniform(0, 30), 1)]) for _ in range(2)]
        shaking = [random.choice([0, round(random.uniform(-0.3, 0.3), 2)]) for _ in range(2)]
        anchors = [((outline[-1][0], height), random.randint(-180, 180), random.randint(1, 60))
                   for _ in range(random.choice([0, 0, 1, 2]))]
        loads = [f"cohesion_kpa: {strength[0]!r}, bond_kpa: {strength[1]!r}",
                 f"seismic: {{horizontal: {shaking[0]!r}, vertical: {shaking[1]!r}}}"]
        loads += ["anchors: [%s]" % ", ".join(
            f"{{at: [{x!r}, {y!r}], direction_deg: {d}, force_kn: {f}}}"
            for (x, y), d, f in anchors)] * (anchors != [])
        return under, outline, strength, shaking, anchors, ", ".join(loads)

    def compare(self, limit, base, forces):
        found = base.intervals(*forces)
        value = limit["critical_angle_deg"]
        level = [i for i in found if i[0] <= 0 <= i[1]]
        above, below = [i for i in found if i[0] > 0], [i for i in found if i[1] < 0]
        if not found:
            self.assertEqual(limit["mechanism"], "holds nowhere")
            return
        _, end = (level or above or below[-1:])[0]
        if end > 89.999:
            self.assertEqual(limit["mechanism"], "interlocked")
            return
        self.assertIsNotNone(value, (limit["mechanism"], found))
        self.assertLessEqual(abs(value["value"] - end), value["error"] + 1e-8)
        names = {name for name, _ in base.mechanisms(end, forces, 1e-8)}
        self.assertIn(limit["mechanism"], names)

    def limit(self, *arguments, **options):
        return self.solve(*arguments, **options)["limit"]
