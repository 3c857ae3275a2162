# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The onset of motion: every window of tilts in which a motion can begin, against trial of every
contact mode (onset_oracle.py), with friction angles whose tangent is a short fraction to 45 digits;
and the values of mechanics section 6a. TOPPLE_ROUNDS multiplies the number of rounds."""

import json
import os
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, run
from limit_oracle import contacts
from onset_oracle import Onset, gyration
from test_limit import Scene, mated_polygon, mated_teeth, dropped, mirrored, worn_profile

ROUNDS = int(os.environ.get("TOPPLE_ROUNDS", "1"))
TIE = Decimal(10) ** -35  # degrees: what tan(phi) to 1e-44 leaves
MOST_POINTS = 7


def degrees_of(tangent):
    return exact.degrees(exact.atan(exact.decimal(tangent)))


def onset_of(outline, profile, tangent, towards="left"):
    if towards == "right":
        outline, profile = mirrored(outline), mirrored(profile)
    points = contacts(outline, profile)
    if len(points) > MOST_POINTS or not points:
        return None
    centroid = exact.centroid(exact.block_moments(outline))
    return Onset(points, centroid, gyration(outline, centroid), tangent)


def rough_tangent():
    return random.choice([Fraction(0), Fraction(1), Fraction(random.randint(1, 30), 10),
                          Fraction(random.randint(1, 40), random.randint(1, 12))])


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
        self.assertRegex(quake["tie_is"], r"^not told apart by [1-9]\d* bits$")
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


class Trial(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.seen = 0

    def tearDown(self):
        self.scene.folder.cleanup()

    def is_end(self, found, tangent):
        """Does the printed end, or null, hold the oracle's?"""
        if tangent is None or found is None:
            self.assertEqual(tangent, found)
            return
        self.assertLessEqual(abs(Decimal(found["value"]) - degrees_of(tangent)),
                             Decimal(found["error"]) + TIE)
        self.assertLessEqual(found["error"], 1e-8)

    def compare(self, case, truth):
        onset = case["onset"]
        self.assertNotEqual(onset["kind"], "undecided")
        self.assertEqual(len(onset["windows"]), len(truth.windows), (onset, truth.windows))
        for found, (low, high) in zip(onset["windows"], truth.windows):
            self.is_end(found["from_deg"], low)
            self.is_end(found["to_deg"], high)
        self.compare_first(onset, truth)
        limit = case["limit"]["critical_angle_deg"]
        if limit is not None and onset["critical_angle_deg"] is not None:
            angle = onset["critical_angle_deg"]
            self.assertLessEqual(angle["value"] - angle["error"], limit["value"] + limit["error"])

    def compare_first(self, onset, truth):
        """The window that holds level ground, or the first above it."""
        first = next((w for w in truth.windows if w[1] is None or w[1] >= 0), None)
        if first is None:
            self.assertEqual(onset["kind"], "never")
        elif first[0] is None:
            self.assertEqual(onset["kind"], "nowhere")
        else:
            self.assertEqual(onset["kind"], "angle")
            self.is_end(onset["critical_angle_deg"], first[0])
            self.assertIn(onset["mechanism"], truth.names(first[0]))

    def verdict(self, case, truth, tilt):
        """No block stands, or is interlocked, where a motion can begin."""
        sine, cosine = exact.sin_cos(tilt)
        tan = Fraction(sine / cosine)
        near = Fraction(1, 10**9)
        inside = any((low is None or low + near < tan) and (high is None or tan < high - near)
                     for low, high in truth.windows)
        outside = all((low is not None and tan < low - near) or (high is not None and tan > high + near)
                      for low, high in truth.windows)
        beginnings = {m["mechanism"] for m in case["motions"]}
        self.assertEqual(set(case["can_begin"]), beginnings)
        self.assertEqual(len(case["can_begin"]), len(beginnings))
        if inside:
            self.assertNotIn(case["mechanism"], ("stands", "interlocked"))
            self.assertIn(case["mechanism"], {"may move"} | beginnings)
        if outside:
            self.assertIn(case["mechanism"], ("stands", "interlocked"))

    def newton(self, case, truth, tilt, side):
        """A motion that begins is one of the trial's modes, and its forces and the weight give the
        centroid its acceleration."""
        sine, cosine = (float(x) for x in exact.sin_cos(tilt))
        names = truth.names(Fraction(exact.sin_cos(tilt)[0] / exact.sin_cos(tilt)[1]))
        if case["onset"]["windows"] and not case["motions"]:
            self.assertFalse(names)
        for motion in case["motions"]:
            self.assertIn(motion["mechanism"], names)
            shares = [c for c in motion["contacts"] if "share_x" in c]
            if len(shares) != len(motion["contacts"]):
                continue
            down = -sine if side == "left" else sine
            for own, key, share in ((down, "acceleration_x_g", "share_x"),
                                    (-cosine, "acceleration_y_g", "share_y")):
                force = own + sum(c[share]["value"] for c in shares)
                self.assertAlmostEqual(force, motion[key]["value"], delta=1e-9)
            self.seen += 1

    def solve(self, block, base, tangent, tilt):
        angle = degrees_of(tangent) if tangent not in (0, 1) else {0: 0, 1: 45}[tangent]
        return self.scene.solve(block, base, angle, tilt=f", angle_deg: {tilt}")

    def run_random(self, make, rounds, seed):
        random.seed(seed)
        done = 0
        while done < rounds * ROUNDS:
            block, base, outline, profile = make()
            tangent, tilt = rough_tangent(), random.randint(1, 60)
            truth = {side: onset_of(outline, profile, tangent, side) for side in ("left", "right")}
            if truth["left"] is None:
                continue
            done += 1
            cases = None
            with self.subTest(scene=block, base=base, tangent=tangent):
                cases = self.solve(block, base, tangent, tilt)
            for side in truth if cases else ():
                with self.subTest(scene=self.scene.text, side=side, tangent=tangent):
                    self.compare(cases[side], truth[side])
                    self.verdict(cases[side], truth[side], tilt)
                    self.newton(cases[side], truth[side], tilt, side)
        self.assertGreater(self.seen, rounds // 4)

    def test_polygons(self):
        self.run_random(mated_polygon, 25, 81)

    def test_teeth(self):
        self.run_random(mated_teeth, 10, 82)

    def test_worn_profiles(self):
        self.run_random(worn_profile, 25, 83)

    def test_dropped(self):
        self.run_random(dropped, 40, 84)


if __name__ == "__main__":
    main()
