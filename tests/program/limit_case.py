# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the cases of the static limit share: scenes, solved, and bounds on their limits."""

import pathlib
import tempfile
import unittest

from harness import ROOT, run, solve


class LimitCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def run_solve(self, *arguments, **options):
        self.write(*arguments, **options)
        return run("solve", "--json", self.path)

    def solve(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"][0]

    def write(self, block, base, friction, towards="left", more="", unit="m"):
        self.path.write_text(f"topple: 1\nlength_unit: {unit}\nblock:\n  {block}\n"
                             f"  unit_weight_kn_m3: 26\nbase: {{{base}}}\n"
                             f"friction_angle_deg: {friction}\n{more}tilt: {{towards: {towards}}}\n")

    def limit(self, *arguments, **options):
        return self.solve(*arguments, **options)["limit"]

    def example(self, name, towards, beyond):
        text = (ROOT / "examples" / name).read_text(encoding="utf-8")
        self.assertIn("beyond: {left: 0, right: 0}", text)
        self.path.write_text(text.replace("beyond: {left: 0, right: 0}",
                                          f"beyond: {{left: {beyond}, right: {beyond}}}"))
        return next(c for c in solve(self.path)["cases"] if c["towards"] == towards)

    def holds(self, number, truth, slack=1e-13):
        """The truth lies in the bound, widened by the rounding of the truth's own doubles."""
        self.assertLessEqual(abs(number["value"] - truth), number["error"] + slack * max(1, abs(truth)))
