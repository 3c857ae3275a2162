# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The onset of motion: the values of docs/mechanics.md section 6a, and closed forms."""

import json
import math
import random
import re
import unittest
from fractions import Fraction

import exact
from harness import ROOT, main, run
from onset_case import degrees_of
from test_limit import Scene, mated_polygon, mated_teeth


class Known(unittest.TestCase):
    """Values of mechanics section 6a, and closed forms."""

    def setUp(self):
        self.scene = Scene()

    def tearDown(self):
        self.scene.folder.cleanup()

    def close(self, number, value, places=3):
        self.assertAlmostEqual(number["value"], value, places=places)
        self.assertLess(number["error"], 1e-9)

    def test_block_a_at_60_degrees(self):
        """Its weight has passed the toe, and friction on the other flanks could pull it back: forces
        hold it up to 30.251 degrees, but nothing need have put them there."""
        teeth = "teeth: {count: 3, width: 15, height: 94, depth: 5, left_end: peak}"
        base = "mated: true, beyond: {left: 0, right: 0}"
        for tilt, verdict in ((26, "stands"), (28, "may move"), (31, "topples")):
            case = self.scene.solve(teeth, base, 60, tilt=f", angle_deg: {tilt}", unit="mm")["left"]
            self.close(case["onset"]["critical_angle_deg"], 26.215)
            self.close(case["limit"]["critical_angle_deg"], 30.251)
            self.assertTrue(case["onset"]["below_limit"])
            self.assertEqual(case["onset"]["mechanism"], "topples")
            self.assertEqual(case["mechanism"], verdict)
            self.assertEqual(case["limit"]["mechanism"], "slides and topples")

    def test_table_of_the_page(self):
        """docs/onset.md: both angles of the paper's blocks at 30 and 60 degrees of friction; they differ above 90 less 2 i."""
        rows = re.findall(r"^\| ([a-g] .*) \|$", (ROOT / "docs/onset.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual(len(rows), 10)
        for row in (row.split(" | ") for row in rows):
            path = f"examples/block_{row[0].replace(' towards its ', '_')}.yaml"
            a, c = map(float, re.search(r"\{a: (\S+), b: \S+, c: (\S+)\}", (ROOT / path).read_text(encoding="utf-8")).groups())
            self.assertEqual(row[3], f"{90 - 2 * math.degrees(math.atan(c / a)):.1f}°")
            said = []
            for friction in (30, 60):
                case = json.loads(run("solve", "--json", "--set", f"friction_angle_deg={friction}", path)[1])["cases"][0]
                said += [f"{one['critical_angle_deg']['value']:.3f}°" + (f" {one['mechanism']}" if friction == 60 else "")
                         for one in (case["onset"], case["limit"])]
            self.assertEqual(row[1:3] + row[4:], said, path)

    def test_an_irregular_block(self):
        outline = ("outline: [[0, 1.123], [0.588, 0.901], [1.536, -0.465], [0.967, 4.599], "
                   "[-0.569, 4.599]]")
        case = self.scene.solve(outline, "profile: [[0, 1.123], [0.588, 0.901], [1.536, -0.465]]",
                                "61.36")["left"]
        self.close(case["onset"]["critical_angle_deg"], 19.453)
        self.close(case["limit"]["critical_angle_deg"], 25.091)
        self.assertEqual(case["onset"]["mechanism"], "topples")

    def test_where_the_toe_begins_to_slip(self):
        """Block A about its peak, 83.07 degrees; a slab of 1 on 3 by the closed form of the dynamic
        border, 57.7366: below it turns about a toe that sticks, above about one that slips."""
        cases = (("teeth: {count: 3, width: 15, height: 94, depth: 5, left_end: peak}", 83.06, 83.08),
                 ("slab: {width: 1, height: 3}", 57.736, 57.737))
        for block, below, above in cases:
            for tilt, mechanism, state in ((below, "topples", "sticks"),
                                           (above, "slides and topples", "slips down-dip")):
                case = self.scene.solve(block, "mated: true, beyond: {left: 0, right: 0}", 30,
                                        tilt=f", angle_deg: {tilt}")["left"]
                self.assertEqual([m["mechanism"] for m in case["motions"]], [mechanism])
                self.assertEqual([c["state"] for c in case["motions"][0]["contacts"]], [state])

    def test_a_slab_that_slides(self):
        """It slides at its friction angle with (sin - tan(phi) cos) of gravity, and leaves its base
        nowhere below upright."""
        case = self.scene.solve("slab: {width: 3, height: 1}",
                                "mated: true, beyond: {left: 1, right: 1}", 20,
                                tilt=", angle_deg: 35")["left"]
        self.close(case["onset"]["critical_angle_deg"], 20, 9)
        self.assertEqual(case["onset"]["mechanism"], "slides")
        sine, cosine = (float(x) for x in exact.sin_cos(35))
        motion, = case["motions"]
        self.assertEqual(motion["mechanism"], "slides")
        self.close(motion["acceleration_x_g"], -(sine - cosine * 0.36397023426620234), 9)
        self.close(motion["acceleration_y_g"], 0, 9)
        self.close(motion["angular_g_per_m"], 0, 9)

    def test_ties(self):
        """A cube on 45 degrees of friction slides and topples at 45 degrees, exactly. Under an earthquake of half its
        weight both begin at atan(1/3), by other sums: that they are one is not proven, and said to be so. Friction a
        hair above 45 degrees, and there is no tie."""
        cube = ("slab: {width: 2, height: 2}", "mated: true, beyond: {left: 1, right: 1}")
        onset = self.scene.solve(*cube, 45)["left"]["onset"]
        self.assertEqual((onset["mechanism"], onset["tied_with"], onset["tie_is"]), ("slides", "topples", "exact"))
        quake = self.scene.solve(*cube, 45, "loads: {seismic: {horizontal: 0.5}}\n")["left"]["onset"]
        self.close(quake["critical_angle_deg"], float(degrees_of(Fraction(1, 3))), 12)
        self.assertEqual({quake["mechanism"], quake["tied_with"]}, {"slides", "topples"})
        self.assertRegex(quake["tie_is"], r"^not distinguished by [1-9]\d* bits$")
        for friction in ("45.000000001", "44.999999999"):
            onset = self.scene.solve(*cube, friction)["left"]["onset"]
            self.assertNotIn("tied_with", onset)
            self.assertNotIn("tie_is", onset)

    def test_wedged_between_upright_flanks(self):
        """Pegs that no tilt up to 90 degrees turns out of their holes: nothing can begin."""
        case = self.scene.solve(
            "outline: [[0, 0], [1, 0], [1, -1], [2, -1], [2, 0], [3, 0], [3, 2], [0, 2]]",
            "profile: [[-1, 0], [1, 0], [1, -1], [2, -1], [2, 0], [4, 0]]", 30,
            tilt=", angle_deg: 80")["left"]
        self.assertEqual(case["onset"]["kind"], "never")
        self.assertEqual(case["onset"]["windows"], [])
        self.assertEqual(case["mechanism"], "interlocked")
        self.assertEqual(case["motions"], [])

    def test_a_bond_alone_holds_all_turns_alike(self):
        """Motions side by side, about a corner and slipping beside it, begin at one tilt, and what a bond holds is the same in
        both: that is known by what they are made of, and no number is taken for zero at the last precision."""
        scene = self.scene.folder.name + "/bonded.yaml"
        with open(scene, "w") as file:
            file.write("topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [1.4, 0.03], [2.6, 0], [2.6, 3], [0.2, 4.4]]\n"
                       "  unit_weight_kn_m3: 26\nbase: {mated: true, between: [[0, 0], [2.6, 0]], beyond: {left: 1, right: 1}}\n"
                       "loads: {bond_kpa: 20}\nfriction_angle_deg: 36\ntilt: {towards: left, angle_deg: 22}\n")
        status, out, err = run("solve", scene)
        self.assertEqual(status, 0, err)
        self.assertNotIn("takes as zero", out)

    def test_cohesion_and_bonds(self):
        """A slab turns about its toe against all of its bond, and slides against all of its cohesion:
        its onset is its static limit. On any base it never lies above that."""
        flat = "mated: true, beyond: {left: 1, right: 1}"
        for more in ("loads: {cohesion_kpa: 8}\n", "loads: {bond_kpa: 10, cohesion_kpa: 2}\n"):
            for block in ("slab: {width: 2, height: 6}", "slab: {width: 6, height: 2}"):
                case = self.scene.solve(block, flat, 20, more)["left"]
                onset, limit = (case[k]["critical_angle_deg"] for k in ("onset", "limit"))
                if limit is not None and not case["limit"]["slides_sooner"]:
                    self.assertLess(abs(onset["value"] - limit["value"]),
                                    onset["error"] + limit["error"])
        random.seed(91)
        compared = 0
        for _ in range(40):
            block, base, outline, _ = random.choice([mated_polygon, mated_teeth])()
            size = float(max(abs(x) + abs(y) for x, y in outline))
            more = (f"loads: {{cohesion_kpa: {size * random.random():.3f}, "
                    f"bond_kpa: {random.choice([0, size * random.random() / 5]):.3f}}}\n")
            try:
                cases = self.scene.solve(block, base, random.randint(5, 60), more)
            except AssertionError as error:
                if "undecided" in str(error) and "the limit by contact forces" in str(error):
                    continue  # then there is nothing to compare with
                raise
            for case in cases.values():
                onset, limit = (case[k]["critical_angle_deg"] for k in ("onset", "limit"))
                if limit is None or case["onset"]["kind"] == "nowhere":
                    continue
                compared += 1
                self.assertLessEqual(onset["value"] - onset["error"], limit["value"] + limit["error"],
                                     self.scene.text)
        self.assertGreater(compared, 20)


if __name__ == "__main__":
    main()
