# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Back-analysis for the onset of motion: numbers of a scene at which it is a given tilt."""

import json
import pathlib
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, run
from onset_case import degrees_of


class Find(unittest.TestCase):
    """Back-analysis for the onset: a sole with one blunt tooth in its groove, of slope 1/2, its peak ends at (0, 1/2)
    and (2, 1/2). It slides out over the groove at phi + atan(1/2), and turns about a peak at atan of its arms, which
    the other flank can hold it back from where phi exceeds 90 - 2 atan(1/2) = 36.87 degrees."""

    TEXT = ("topple: 1\nlength_unit: m\nparameters: {p: 2, top: %s}\n"
            "block:\n  outline: [[0, 1/2], [1, 0], [2, 1/2], [2, top + 1/2], [0, top + 1/2]]\n  unit_weight_kn_m3: 9\n"
            "%sbase: {mated: true, between: [[0, 1/2], [2, 1/2]], beyond: {left: 0, right: 0}}\n"
            "friction_angle_deg: %s\ntilt: {towards: left, angle_deg: 10}\n")
    HEAVY = "  parts: [{outline: [[1/2, 2], [3/2, 2], [3/2, 5/2], [1/2, 5/2]], unit_weight_kn_m3: 23}]\n"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, top="p", parts="", friction="60"):
        self.path.write_text(self.TEXT % (top, parts, friction))

    def find(self, key, target, low, high):
        arguments = ("solve", "--json", "--find", key, "--for", target, "--from", low, "--to", high, self.path)
        status, out, err = run(*arguments)
        self.assertEqual(status, 0, err)
        return json.loads(out)["find"]

    def near(self, found, truths):
        self.assertEqual(len(found["solutions"]), len(truths), found)
        self.assertEqual((found["intervals"], found["touching"]), ([], []))
        for number, truth in zip(found["solutions"], truths):
            self.assertLessEqual(abs(Decimal(number["value"]) - Decimal(truth)), Decimal(number["error"]) + Decimal("1e-13"))
            self.assertLess(number["error"], 1e-9)

    def test_one_root(self):
        """Sliding: phi = 30 - atan(1/2). Toppling, with friction that would hold it far beyond: of H^2 - 1/12 =
        (2 H + 1/2) cot(40) the root; forces hold it at every height that is looked at, so the limit has none."""
        self.write()
        found = self.find("friction_angle_deg", "onset_angle=30", 1, 10)
        self.near(found, [30 - degrees_of(Fraction(1, 2))])
        sine, cosine = exact.sin_cos(40)
        cot = cosine / sine
        height = cot + (cot * cot + Decimal(1) / 12 + cot / 2).sqrt()
        self.near(self.find("p", "onset_angle=40", 1, 5), [height])
        self.assertEqual(self.find("p", "limit_angle=40", 1, 5)["solutions"], [])

    def test_several_roots(self):
        """The height comes back to 3 at 1, 2 and 4 of the parameter."""
        self.write("3 + (p - 1)*(p - 2)*(p - 4)/16")
        angle = degrees_of(Fraction(13, 2) / (9 - Fraction(1, 12)))
        found = self.find("p", f"onset_angle={float(angle)!r}", 0, 5)
        self.assertEqual(len(found["solutions"]), 3, found)
        for number, root in zip(found["solutions"], (1, 2, 4)):
            self.assertAlmostEqual(number["value"], root, delta=1e-12)

    def test_interval(self):
        """A heavy part puts its weight at 45 degrees above the peak: it topples at exactly 45 for every friction from
        tan(phi) = 1/3 on, with which it slides there."""
        self.write("2", self.HEAVY)
        found = self.find("friction_angle_deg", "onset_angle=45", 10, 80)
        (interval,) = found["intervals"]
        self.assertEqual((found["solutions"], found["touching"], interval["to"]["value"]), ([], [], 80))
        self.assertLessEqual(abs(Decimal(interval["from"]["value"]) - degrees_of(Fraction(1, 3))),
                             Decimal(interval["from"]["error"]) + Decimal("1e-13"))
        self.assertLess(interval["from"]["error"], 1e-9)
        self.assertEqual(self.find("friction_angle_deg", "limit_angle=45", 40, 80)["intervals"], [])

    def test_none(self):
        """No friction makes it topple later than its moments let it."""
        self.write("2", self.HEAVY)
        arguments = ("--find", "friction_angle_deg", "--for", "onset_angle=50", "--from", 10, "--to", 80, self.path)
        found = json.loads(run("solve", "--json", *arguments)[1])["find"]
        self.assertEqual((found["solutions"], found["intervals"], found["touching"]), ([], [], []))
        self.assertEqual(found["greatest"]["value"], 45)
        self.assertAlmostEqual(found["least"]["value"], 10 + float(degrees_of(Fraction(1, 2))), delta=1e-12)
        self.assertIn("none in range: onset_angle goes from 36.5650511771 to 45 there\n", run("solve", *arguments)[1])

    def test_what_it_cannot_depend_on(self):
        """It is a tilt: the scene's own does not enter. A heavier block turns the sooner, for its light cap: not at 45."""
        self.write("2", self.HEAVY)
        status, out, err = run("solve", "--find", "tilt.angle_deg", "--for", "onset_angle=45", self.path)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("onset_angle cannot depend on 'tilt.angle_deg': it is a tilt", err)
        out = run("solve", "--find", "block.unit_weight_kn_m3", "--for", "onset_angle=45", "--from", 23, "--to", 30, self.path)[1]
        self.assertIn("none in range", out)


if __name__ == "__main__":
    main()
