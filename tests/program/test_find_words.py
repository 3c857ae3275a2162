# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Back-analysis: its range, and what it says where there is nothing to find.

The story: --to alone was refused although the help says what --from is then; a factor against toppling for a
friction angle was looked for, and none found, where moments do not know of friction; a range given the wrong way
round was asked for again; and with the default range 500 of 512 points lay where the scene has no answer."""

import json
import pathlib
import re
import tempfile
import unittest

from harness import main, run

SCENE = """topple: 1
length_unit: m
parameters: {{p: {own}, q: 2*p, lost: 1}}
block: {{slab: {{width: {width}, height: {height}}}, thickness: {thickness}, unit_weight_kn_m3: 26}}
base: {{mated: true}}
loads: {{cohesion_kpa: {cohesion}}}
friction_angle_deg: {friction}
tilt: {{towards: left, angle_deg: {tilt}}}
"""


class FindWords(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def write(self, own=1, width=1, height=2, thickness=1, cohesion=0, friction=30, tilt=20):
        self.path.write_text(SCENE.format(own=own, width=width, height=height, thickness=thickness, cohesion=cohesion,
                                          friction=friction, tilt=tilt))

    def find(self, key, target, *more):
        status, out, err = run("solve", "--json", "--find", key, "--for", target, *more, self.path)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)["find"]

    def refuse(self, key, target, *more):
        status, out, err = run("solve", "--find", key, "--for", target, *more, "scene.yaml", folder=self.folder.name)
        self.assertEqual((status, out), (3, ""), err)
        return err

    def test_one_end_alone(self):
        """--to alone begins at 0, --from alone ends at ten times the number; below 0 the other way round."""
        self.write(own=5, height="p")
        for more, ends in (((), (0, 50)), (("--to", 7), (0, 7)), (("--from", 0.5), (0.5, 50)), (("--from", 0.25, "--to", 3), (0.25, 3))):
            found = self.find("p", "critical_angle=45", *more)
            self.assertAlmostEqual(found["from"], ends[0], delta=1e-12)  # none at a height of 0
            self.assertEqual(found["to"], ends[1])
            self.assertAlmostEqual(found["solutions"][0]["value"], 1, delta=1e-12)
        self.write(own=-5, height="-p")
        for more, ends in (((), (-50, 0)), (("--to", -0.5), (-50, -0.5)), (("--from", -7), (-7, 0))):
            found = self.find("p", "critical_angle=45", *more)
            self.assertEqual(found["from"], ends[0])
            self.assertAlmostEqual(found["to"], ends[1], delta=1e-12)
            self.assertAlmostEqual(found["solutions"][0]["value"], -1, delta=1e-12)
        said = re.sub(r"\s+", " ", run("solve", "--help")[1])
        self.assertIn("(default 0, or ten times its present value if that is below 0)", said)

    def test_reversed(self):
        """Each end of a range that is reversed is named, and where it came from."""
        self.write(own=5, height="p")
        err = self.refuse("p", "critical_angle=45", "--from", 7, "--to", 2)
        self.assertIn("scene.yaml:3:17: the range is reversed: it begins at 7 and ends at 2; ", err)
        err = self.refuse("p", "critical_angle=45", "--to", -2)
        self.assertIn("begins at 0 (where no --from is given) and ends at -2;", err)
        err = self.refuse("p", "critical_angle=45", "--from", 51)
        self.assertIn("begins at 51 and ends at 50 (where no --to is given);", err)
        self.assertIn("this one has no width: both its ends are 3", self.refuse("p", "critical_angle=45", "--from", 3, "--to", 3))

    def test_what_cannot_depend(self):
        """Moments about a pivot on friction and cohesion, angles on the scene's tilt, anything on a parameter that
        nothing names; by way of parameters too, and as soon as the number does more than that it is looked for."""
        for way, text in (("friction_angle_deg", {}), ("loads.cohesion_kpa", {}), ("p", {"friction": "20 + p"}),
                          ("p", {"cohesion": "q"}), ("p", {"friction": "20 + q", "cohesion": "p"})):
            self.write(**text)
            for target in ("fos", "critical_angle"):
                self.assertIn(f"{target} cannot depend on '{way}': it is a balance of moments", self.refuse(way, f"{target}=2"))
            self.assertEqual(len(self.find(way, "sliding_fos=1.6", "--from", 0.01, "--to", 50)["solutions"]), 1)
        for way, text in (("tilt.angle_deg", {}), ("p", {"tilt": "p"}), ("p", {"tilt": "q + 1"})):
            self.write(**text)
            for target in ("sliding_angle", "critical_angle", "limit_angle"):
                self.assertIn(f"{target} cannot depend on '{way}': it is a tilt", self.refuse(way, f"{target}=15"))
            self.assertEqual(len(self.find(way, "fos=2", "--from", 1, "--to", 50)["solutions"]), 1)
        self.write(tilt="p", friction="p + 20")
        self.assertIn("critical_angle cannot depend", self.refuse("p", "critical_angle=15"))
        self.assertEqual(len(self.find("p", "sliding_angle=31", "--to", 50)["solutions"]), 1)
        self.write(friction="20 + p", height="3 - q")
        self.assertEqual(len(self.find("p", "critical_angle=45", "--to", 1.4)["solutions"]), 1)
        self.write()
        self.assertIn("nothing in the scene depends on 'lost': no number names it", self.refuse("lost", "fos=1"))

    def test_what_it_was_instead(self):
        """Where none is found, the least and the greatest result that were met: atan(1 / p) from 2 to 4."""
        self.write(height="p")
        found = self.find("p", "critical_angle=50", "--from", 2, "--to", 4)
        self.assertAlmostEqual(found["least"]["value"], 14.036243467926479, delta=1e-11)
        self.assertAlmostEqual(found["greatest"]["value"], 26.56505117707799, delta=1e-11)
        out = run("solve", "--find", "p", "--for", "critical_angle=50", "--from", 2, "--to", 4, self.path)[1]
        self.assertIn("none in range: critical_angle goes from 14.0362434679 to 26.5650511771 there", out)
        out = run("solve", "--find", "block.thickness", "--for", "critical_angle=50", self.path)[1]
        self.assertIn("none in range: critical_angle is 45 at every point examined", out)

    def test_the_default_range_is_as_precise(self):
        """A slab of width 1 and height 1 + (p - r)(p - s)(p - t), which has three solutions within 0.006, on a
        domain, 0 < p < 1 by its thickness, that is a ninth of the default range: found as in a range that is given,
        and the ends of the domain to as many digits."""
        roots = (0.2, 0.203, 0.206)
        height = "1 + " + "*".join(f"(p - {root})" for root in roots)
        self.write(own=0.9, height=height, thickness="p*(1 - p)")
        given = self.find("p", "critical_angle=45", "--from", 0, "--to", 1)
        default = self.find("p", "critical_angle=45")
        for found in (given, default):
            self.assertEqual(len(found["solutions"]), 3, found)
            for own, root in zip(found["solutions"], roots):
                self.assertLessEqual(abs(own["value"] - root), own["error"] + 1e-16)
                self.assertLess(own["error"], 1e-9)
            self.assertLess(found["from"], 1e-13)
            self.assertLess(1 - found["to"], 1e-13)
            self.assertLess(found["to"], 1)


if __name__ == "__main__":
    main()
