# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Bonds of `blocks:`, against a formula and against trial of every contact mode in whole numbers (onset_strength_oracle.py).

The story. A slab on 3 degrees with friction 20, 1 kPa of cohesion and a bond of 5 kPa had a factor of 7.642. By hand it is 7.508: the
bond pulled, the sole pressed against that pull, and friction on this pressure was counted as strength. A bond pulls no more than it
has to; it holds what opens, and does not press what slides."""

import json
import math
import random
from fractions import Fraction

import exact
from governing_case import GoverningCase
from harness import ROUNDS, main, rounds, run
from limit_oracle import contacts
from limit_scenes import dropped, mated_polygon, mated_teeth, mirrored, text_of, worn_profile
from onset_case import degrees_of, rough_tangent
from onset_oracle import gyration
from onset_strength_oracle import StrongOnset, facets

GAMMA = 26
MOST_POINTS = 6


class Blocks(GoverningCase):
    def case_of(self, outline, profile, friction, loads, tilt, side, others=""):
        """The case of one block on ground below a profile; None where the scene is refused."""
        floor = min(y for _, y in profile) - 100
        ground = [(profile[0][0], floor), (profile[-1][0], floor), *reversed(profile)]
        self.text = (f"topple: 1\nlength_unit: m\nblock: {{unit_weight_kn_m3: {GAMMA}}}\nblocks:\n"
                     f"  - {{name: ground, ground: true, outline: {text_of(ground)}}}\n  - {{name: block, outline: {text_of(outline)}}}\n{others}"
                     f"friction_angle_deg: {friction}\nloads: {loads}\nrequired_fos: 1\ntilt: {{towards: {side}, angle_deg: {tilt}}}\n")
        self.own = self.solved(self.text)
        return None if self.own is None else self.own["cases"][0]

    def solved(self, text):
        status, out, _ = run("solve", "--json", self.scene(text), timeout=120)
        return json.loads(out) if status in (0, 1, 4) else None


class ByHand(Blocks):
    """(W cos a tan(phi) + c L) / (W sin a), whatever the bond: on what drives, and by strength."""

    def by_hand(self, weight, length, friction, cohesion, tilt):
        a = math.radians(tilt)
        return (weight * math.cos(a) * math.tan(math.radians(friction)) + cohesion * length) / (weight * math.sin(a))

    def same(self, case, truth):
        for number in (case["fos_by_driving"], case["fos_by_strength"]):
            self.assertLessEqual(number["at_least"], truth)
            self.assertGreaterEqual(number["at_most"], truth)
            self.assertLess(number["at_most"] - number["at_least"], 1e-5 * truth)

    def test_a_slab_that_slides(self):
        outline = [(0, 0), (1.4, 0), (2.4, 1), (0, 1)]
        for side, own in (("right", outline), ("left", mirrored(outline))):
            profile = [(0, 0), (1.4, 0)] if side == "right" else [(-1.4, 0), (0, 0)]
            for bond in (0, 5, 50):
                case = self.case_of(own, profile, 20, f"{{cohesion_kpa: 1, bond_kpa: {bond}}}", 3, side)
                self.same(case, self.by_hand(1.9 * GAMMA, 1.4, 20, 1, 3))

    def test_on_pieces_of_one_line(self):
        """Ground that is in two pieces, one of them longer: the same joint."""
        outline = [(0, 0), (4, 0), (4, 1), (0, 1)]
        profile = [(0, 0), (1, 0), (4, 0)]
        case = self.case_of(outline, profile, 25, "{cohesion_kpa: 2, bond_kpa: 9}", 10, "left")
        self.same(case, self.by_hand(4 * GAMMA, 4, 25, 2, 10))

    def test_two_that_are_stacked(self):
        """Two bonded slabs: the lower joint bears twice the weight on the same length, with the same bond; it gives way where its
        cohesion is less than twice that of the joint above."""
        lower, upper = [(0, 0), (6, 0), (6, 1), (0, 1)], [(0, 1), (6, 1), (6, 2), (0, 2)]
        above = f"  - {{name: upper, outline: {text_of(upper)}}}\n"
        case = self.case_of(lower, [(0, 0), (6, 0)], 20, "{cohesion_kpa: 3, bond_kpa: 4}", 8, "right", above)
        self.same(case, self.by_hand(12 * GAMMA, 6, 20, 3, 8))


class Trial(Blocks):
    """Up to the number that is proven to stand no mode can begin, with any pull that the rules allow; at that which is proven to move
    one can."""

    def draw(self):
        while True:
            _, _, outline, profile = random.choice([mated_polygon, mated_teeth, worn_profile, dropped])()
            points, ends = contacts(outline, profile), facets(outline, profile)
            met = set(outline) & set(profile) - {end for p, q, _ in ends for end in (p, q)}
            if points and ends and len(points) <= MOST_POINTS and not met:  # corners that meet have no direction under `blocks:`
                break
        tangent = rough_tangent() or Fraction(1, 2)
        area = exact.ring_moments(outline)[0]
        stress = GAMMA * area / sum(abs(q[0] - p[0]) + abs(q[1] - p[1]) for p, q, _ in ends)
        shear, bond = (Fraction(round(float(stress * share), 4)).limit_denominator(10000)
                       for share in (Fraction(random.choice([0, random.randint(1, 60)]), 100), Fraction(random.randint(1, 40), 100)))
        return outline, profile, tangent, shear, max(bond, Fraction(1, 1000))

    def trial(self, outline, profile, tangent, shear, bond, over=1.0, size=1.0):
        """Strength over a number; loads of a size."""
        over, size = Fraction(over), Fraction(size)
        centroid, area = exact.centroid(exact.block_moments(outline)), exact.ring_moments(outline)[0]
        per = GAMMA * area * over * size
        return StrongOnset(contacts(outline, profile), centroid, gyration(outline, centroid), tangent / over, facets(outline, profile),
                           shear / per, bond / per)

    def begins(self, drawn, tilt, multiple, divisor, law="touching"):
        a = math.radians(tilt)
        across, along = math.cos(a), multiple * math.sin(a)
        return self.trial(*drawn, divisor, math.hypot(across, along)).can_begin(Fraction(math.tan(math.atan2(along, across) / 2)), law)

    def compare(self, case, drawn, tilt):
        near = 1e-5
        for key, begins in (("fos_by_strength", lambda x: self.begins(drawn, tilt, 1, x)),
                            ("fos_by_driving", lambda x: self.begins(drawn, tilt, x, 1))):
            bounds = case[key]
            least, most = bounds.get("at_least"), bounds.get("at_most")
            if least is not None and least > 1 and case["verdict"] == "stands":
                for x in (min(least, 50) * (1 - near), 1 + (min(least, 50) - 1) * random.random()):
                    self.assertIsNone(begins(x), (key, x))
                self.stood += 1
            moving = case.get("moving_fos" if key == "fos_by_strength" else "moving_fos_driving")
            if moving is not None and moving > 1.001:
                self.assertIsNotNone(begins(moving * (1 + near)), (key, moving))
                self.moved += 1

    def test_random_blocks(self):
        random.seed(59)
        self.stood = self.moved = 0
        for _ in range(rounds(4, 60) * ROUNDS):
            outline, profile, tangent, shear, bond = self.draw()
            tilt, angle = random.randint(1, 40), degrees_of(tangent) if tangent != 1 else 45
            for side in ("left", "right"):
                with self.subTest(side=side):
                    case = self.case_of(outline, profile, angle, f"{{cohesion_kpa: {shear}, bond_kpa: {bond}}}", tilt, side)
                    if case is None:
                        continue
                    drawn = outline, profile, tangent, shear, bond
                    if side == "right":
                        drawn = mirrored(outline), mirrored(profile), tangent, shear, bond
                    try:
                        self.compare(case, drawn, tilt)
                    except AssertionError as error:
                        raise AssertionError(f"{error}\n{self.text}{drawn}") from error
        self.assertGreater(min(self.stood, self.moved), rounds(1, 20), (self.stood, self.moved))


if __name__ == "__main__":
    main()
