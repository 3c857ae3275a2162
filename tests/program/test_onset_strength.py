# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The onset of motion under cohesion and bonds: its tilt against trial of every contact mode in whole numbers
(onset_strength_oracle.py), below it and just above; and Newton's law for the motions at the scene's tilt, with what they
overcome. TOPPLE_ROUNDS multiplies the number of rounds."""

import math
import random
import unittest
from fractions import Fraction

import exact
from harness import ROUNDS, main, rounds
from limit_oracle import contacts
from limit_scenes import Scene, dropped, mated_polygon, mated_teeth, mirrored, text_of, worn_profile
from onset_case import degrees_of, rough_tangent
from onset_oracle import gyration
from onset_strength_oracle import StrongOnset, facets

MOST_POINTS = 6
GAMMA = 26


def half_tangent(degrees):
    return Fraction(math.tan(math.radians(degrees) / 2))


def value(number):
    return number["value"]


class Strength(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.addCleanup(self.scene.folder.cleanup)


class Known(Strength):
    FLAT = "mated: true, beyond: {left: 1, right: 1}"

    def solve(self, width, height, friction, loads, tilt, side="left"):
        return self.scene.solve(f"slab: {{width: {width}, height: {height}}}", self.FLAT, friction, f"loads: {loads}\n",
                                f", angle_deg: {tilt}")[side]

    def test_a_slab_that_slides(self):
        """It is driven by sin(tilt), and held by friction and by all of its cohesion; a bond does not delay it, and
        what of it pulls is not known, so that the acceleration is the greatest of a range."""
        for loads, fixed in (("{cohesion_kpa: 8}", True), ("{cohesion_kpa: 8, bond_kpa: 3}", False)):
            for side, sense in (("left", -1), ("right", 1)):
                case = self.solve(6, 2, 20, loads, 40, side)
                self.assertEqual((case["mechanism"], case["can_begin"]), ("slides", ["slides"]))
                motion, = case["motions"]
                held = 8 * 6 / (GAMMA * 12)
                driven = math.sin(math.radians(40)) - math.cos(math.radians(40)) * math.tan(math.radians(20)) - held
                self.assertAlmostEqual(value(motion["acceleration_x_g"]), sense * driven, delta=1e-12)
                self.assertEqual(motion["accelerations_fixed"], fixed)
                self.assertAlmostEqual(value(motion["overcomes"]["cohesion"]["share_x"]), -sense * held, delta=1e-12)
                self.assertAlmostEqual(value(motion["overcomes"]["cohesion"]["moment_m"]), -sense * held, delta=1e-12)
                self.assertEqual(value(motion["overcomes"]["bond"]["share_y"]), 0)

    def test_a_slab_that_topples(self):
        """About a toe that sticks: the weight's moment less that of the bond, which pulls in full at the middle of the
        sole, over the inertia about the toe."""
        for side, sense in (("left", 1), ("right", -1)):
            case = self.solve(2, 6, 60, "{cohesion_kpa: 8, bond_kpa: 10}", 40, side)
            motion, = case["motions"]
            self.assertEqual((motion["mechanism"], motion["accelerations_fixed"]), ("topples", True))
            a, bond = math.radians(40), 10 * 2 / (GAMMA * 12)
            angular = (3 * math.sin(a) - math.cos(a) - bond) / ((4 + 36) / 12 + 1 + 9)
            self.assertAlmostEqual(value(motion["angular_g_per_m"]), sense * angular, delta=1e-12)
            self.assertAlmostEqual(value(motion["overcomes"]["bond"]["share_y"]), -bond, delta=1e-12)
            self.assertEqual(value(motion["overcomes"]["cohesion"]["share_x"]), 0)
            contact, = motion["contacts"]
            self.assertEqual(contact["state"], "sticks")

    def test_a_bond_that_cannot_balance_a_slide(self):
        """A tall slab would slide only with its sole pulled by a quarter of its weight: its bond bears 0.064 of it."""
        case = self.solve(2, 6, 20, "{cohesion_kpa: 8, bond_kpa: 10}", 40)
        self.assertEqual(case["can_begin"], ["slides and topples"])

    def test_slides_sooner_than_the_limit(self):
        """A bond that could press the slab together holds it longer than its friction and cohesion do: between the
        onset and the tilt at which it slides for certain there is nothing for history to decide."""
        case = self.solve(6, 2, 20, "{cohesion_kpa: 8, bond_kpa: 3}", 10)
        self.assertLess(value(case["onset"]["critical_angle_deg"]), value(case["limit"]["critical_angle_deg"]) - 0.1)
        self.assertAlmostEqual(value(case["onset"]["critical_angle_deg"]), value(case["sliding"]["critical_angle_deg"]),
                               delta=1e-9)
        self.assertFalse(case["onset"]["below_limit"])


class Trial(Strength):
    def draw(self):
        """A block with cohesion and bond, some share of what its weight presses with, and its trial by side."""
        while True:
            block, base, outline, profile = random.choice([mated_polygon, mated_teeth, worn_profile, dropped])()
            points, ends = contacts(outline, profile), facets(outline, profile)
            if points and ends and len(points) <= MOST_POINTS:
                break
        tangent = rough_tangent()
        area = exact.ring_moments(outline)[0]
        stress = GAMMA * area / sum(abs(q[0] - p[0]) + abs(q[1] - p[1]) for p, q, _ in ends)
        shear, bond = (Fraction(round(float(stress * share), 4)).limit_denominator(10000)
                       for share in (Fraction(random.choice([0, random.randint(1, 60)]), 100),
                                     Fraction(random.choice([0, 0, random.randint(1, 40)]), 100)))
        self.tilt = random.randint(1, 60)
        angle = degrees_of(tangent) if tangent not in (0, 1) else {0: 0, 1: 45}[tangent]
        try:
            cases = self.scene.solve(block, base, angle, f"loads: {{cohesion_kpa: {shear or 1}, bond_kpa: {bond}}}\n",
                                     f", angle_deg: {self.tilt}")
        except AssertionError as error:
            if "undecided" not in str(error) or "the limit by contact forces" not in str(error):
                raise
            cases = {}  # then there is nothing to compare with
        for side, case in cases.items():
            own, under = (outline, profile) if side == "left" else (mirrored(outline), mirrored(profile))
            centroid = exact.centroid(exact.block_moments(own))
            yield side, case, lambda own=own, under=under, centroid=centroid: StrongOnset(
                contacts(own, under), centroid, gyration(own, centroid), tangent, facets(own, under),
                (shear or 1) / (GAMMA * area), bond / (GAMMA * area))

    def below(self, case, trial):
        """No mode can begin below the onset, whatever force the law allows; just above some mode can, or the onset is
        the limit."""
        onset, limit = case["onset"], case["limit"]["critical_angle_deg"]
        if onset["kind"] == "nowhere":
            return
        end = value(onset["critical_angle_deg"]) if onset["kind"] == "angle" else 89.9
        if end <= 0:
            return
        for tilt in (end - 1e-6, end * random.random(), end * random.random()):
            self.assertIsNone(trial.can_begin(half_tangent(tilt)), tilt)
        if onset["kind"] == "angle" and (limit is None or abs(value(limit) - end) > 1e-9):
            self.above += 1
            self.assertIsNotNone(trial.can_begin(half_tangent(end + 1e-6), "found"), end)

    def newton(self, case, side):
        a = math.radians(self.tilt)
        down = -math.sin(a) if side == "left" else math.sin(a)
        for motion in case.get("motions") or ():
            if not all("share_x" in c for c in motion["contacts"]):
                continue
            forces = motion["contacts"] + list(motion["overcomes"].values())
            for own, key, share in ((down, "acceleration_x_g", "share_x"), (-math.cos(a), "acceleration_y_g", "share_y")):
                self.assertAlmostEqual(own + sum(value(f[share]) for f in forces), value(motion[key]), delta=1e-9)
            self.turning(case, motion)
            self.obeyed += 1

    def turning(self, case, motion):
        """About the centroid; where the contact is the centre of rotation its place is known."""
        if motion["mechanism"] != "topples" or len(motion["contacts"]) != 1:
            return
        block, contact = case["block"], motion["contacts"][0]
        x, y = (value(motion[f"centre_{k}_m"]) - value(block[f"centroid_{k}_m"]) for k in "xy")
        moment = x * value(contact["share_y"]) - y * value(contact["share_x"])
        moment += sum(value(f["moment_m"]) for f in motion["overcomes"].values())
        gyration = (value(block["second_moment_xx_m4"]) + value(block["second_moment_yy_m4"])) / value(block["area_m2"])
        self.assertAlmostEqual(moment / gyration, value(motion["angular_g_per_m"]), delta=1e-9 * max(1, abs(moment)))
        self.turned += 1

    def test_random_blocks(self):
        random.seed(85)
        self.above = self.obeyed = self.turned = 0
        for _ in range(rounds(12, 32) * ROUNDS):
            for side, case, make in self.draw():
                with self.subTest(scene=self.scene.text, side=side):
                    self.assertNotEqual(case["onset"]["kind"], "undecided")
                    for window in case["onset"]["windows"]:
                        if window["from_deg"] and window["to_deg"]:
                            self.assertLessEqual(value(window["from_deg"]), value(window["to_deg"]))
                    self.below(case, make())
                    self.newton(case, side)
        self.assertGreater(min(self.above, self.obeyed, self.turned), rounds(0, 3), (self.above, self.obeyed, self.turned))

    def test_a_toe_that_only_cohesion_holds(self):
        """Without friction the toe sticks by its cohesion, and the block turns about it where its moments let it, at
        16.085 degrees: it was said to stand up to the limit, 16.820."""
        case = self.scene.solve("outline: [[0, 3], [10, 1], [13, 2], [14, 1], [16, 3], [19, 70], [3, 70]]",
                                "profile: [[-5, 4], [0, 3], [10, 1], [13, 0], [14, 1], [16, 3]]", 0,
                                "loads: {cohesion_kpa: 389.675}\n", ", angle_deg: 16.5")["left"]
        self.assertEqual((case["mechanism"], case["can_begin"]), ("may move", ["topples"]))
        onset, moments = (case[key]["critical_angle_deg"] for key in ("onset", "toppling"))
        self.assertAlmostEqual(value(onset), value(moments), delta=1e-9)
        self.assertAlmostEqual(value(case["limit"]["critical_angle_deg"]), 16.820, delta=1e-3)

    def test_what_the_rules_leave_out(self):
        """Were facets that open still sheared by up to their cohesion, this block could begin to turn about a toe that
        slips a quarter of a degree sooner than by the rules: docs/onset.md says so."""
        outline = [(0, 0), (74, 2), (99, 3), (175, 2), (216, 0), (250, 1), (250, 121), (0, 121)]
        profile = [(-5, -6), (0, -2), (74, 2), (99, 3), (175, 2), (216, 0), (250, 1)]
        outline, profile = ([(Fraction(x), Fraction(y)) for x, y in points] for points in (outline, profile))
        case = self.scene.solve("outline: [[0, 0], [74, 2], [99, 3], [175, 2], [216, 0], [250, 1], [250, 121], [0, 121]]",
                                "profile: [[-5, -6], [0, -2], [74, 2], [99, 3], [175, 2], [216, 0], [250, 1]]",
                                degrees_of(Fraction(5, 6)), "loads: {cohesion_kpa: 557.7093}\n")["left"]
        self.assertAlmostEqual(value(case["onset"]["critical_angle_deg"]), 40.932, delta=1e-3)
        centroid, area = exact.centroid(exact.block_moments(outline)), exact.ring_moments(outline)[0]
        trial = StrongOnset(contacts(outline, profile), centroid, gyration(outline, centroid), Fraction(5, 6),
                            facets(outline, profile), Fraction(5577093, 10000) / (GAMMA * area), Fraction(0))
        self.assertIsNone(trial.can_begin(half_tangent(40.93)))
        self.assertIsNotNone(trial.can_begin(half_tangent(40.67), "parting"))

    def test_windows_of_steep_teeth(self):
        """Flanks at 88 degrees with a bond: planes of different pulls went for one, a window ended before it began, and
        the block was said to slide at 1.6 degrees."""
        cases = self.scene.solve("teeth: {count: 3, width: 2, height: 121, depth: 35, left_end: valley}",
                                 "mated: whole, beyond: {left: 0, right: 1}", degrees_of(Fraction(17, 11)),
                                 "loads: {bond_kpa: 75.913}\n")
        for case in cases.values():
            for window in case["onset"]["windows"]:
                if window["from_deg"] and window["to_deg"]:
                    self.assertLessEqual(value(window["from_deg"]), value(window["to_deg"]))


class RoughArch(Strength):
    """A serrated arch, or a profile scanned at thousands of points, bounds the motions in which the whole contact opens
    by more than two dozen planes: the factor was left undecided there."""

    def solve(self, outline, friction, tilt):
        return self.scene.solve(f"outline: {text_of(outline)}", "mated: true", friction, "", f", angle_deg: {tilt}")["left"]

    def test_the_factor_divides_the_strength(self):
        """Solves with the friction divided by a little less than the factor, and a little more, stand and do not; where
        the factor is unbounded they stand at next to no friction."""
        sole = [(100 * k, (900 - k * k) * Fraction(10 if k % 2 else 9, 10)) for k in range(-30, 31)]
        outline = [*((x, float(y)) for x, y in sole), (3000, 6000), (-3000, 6000)]
        case = self.solve(outline, 5, 29)
        factor = value(case["onset"]["fos"])
        self.assertAlmostEqual(factor, 1.065, delta=1e-3)
        for divisor, mechanism in ((factor * (1 - 1e-7), "stands"), (factor * (1 + 1e-7), "may move")):
            friction = math.degrees(math.atan(math.tan(math.radians(5)) / divisor))
            self.assertEqual(self.solve(outline, f"{friction:.17g}", 29)["mechanism"], mechanism)
        case = self.solve(outline, 5, 20)
        self.assertEqual((case["mechanism"], case["onset"]["fos_is"]), ("stands", "unbounded: no driving action"))
        self.assertEqual(self.solve(outline, "0.0001", 20)["mechanism"], "stands")

    def test_a_scanned_profile(self):
        random.seed(4)
        sole = [(k, random.randint(0, 1500) / 1000) for k in range(12001)]
        case = self.solve([*sole, (12000, 8000), (0, 8000)], 30, 10)
        self.assertEqual((case["mechanism"], case["onset"]["fos_is"]), ("stands", "unbounded: no driving action"))


if __name__ == "__main__":
    main()
