# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Water stands in the whole joint below a block, open or closed, from its up-dip end to its down-dip end.

The ends are put by hand here, from the drawing of each scene; the pressure, which falls linearly from the head at the
up-dip end to nothing, is integrated over that length about the pivot of the account by Simpson's rule, exact for
these quadratics. A block on two bumps once had uplift between the bumps alone, half of what turns it."""

import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import main, run

WATER = Fraction(981, 100)


def moment_of(toe, heel, pivot, head_kpa, side):
    """Overturning about the pivot, kN m: the down-dip side is at -x, or at +x where `side` is -1."""
    length = abs(heel - toe)

    def at(share):  # of the way from the heel to the toe
        x = heel + share * (toe - heel)
        return head_kpa * (1 - share) * side * (x - pivot)

    return length * (at(Fraction(0)) + 4 * at(Fraction(1, 2)) + at(Fraction(1))) / 6


def chain(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def bumps(left, right, crests):
    """A base from left to right, half a metre below the sole but at its crests."""
    points = [(left, Fraction(-1, 2))]
    for x in crests:
        points += [(x - Fraction(1, 20), Fraction(-1, 2)), (x, 0), (x + Fraction(1, 20), Fraction(-1, 2))]
    return points + [(right, Fraction(-1, 2))]


class BaseJoint(unittest.TestCase):
    def case(self, block, base, height, towards="left", tilt=5, more="", level=False):
        text = ("topple: 1\nlength_unit: m\nblock: {outline: %s, unit_weight_kn_m3: 26}\nbase: %s\n"
                "friction_angle_deg: 35\nloads: {water: {height: %s, uplift: true%s}}\n%s"
                "tilt: {towards: %s, angle_deg: %s}\n"
                % (chain(block), base, height, ", stays_level: true" if level else "", more, towards, tilt))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text(text)
            status, out, err = run("solve", "--json", path)
        self.assertEqual(status, 0, err + text)
        return json.loads(out)["cases"][0]

    def holds(self, case, toe, heel, height, tilt=5, level=False):
        """The uplift of the account; the pivot may have been turned or lifted with the block."""
        load = next(load for load in case["loads"] if load["name"] == "uplift")["moment_nm"]
        pivot = Fraction(case["pivots"][case["toppling"]["pivot"]]["x_m"]["value"])
        head = WATER * Fraction(height) * (1 if level else Fraction(math.cos(math.radians(tilt))))
        truth = moment_of(Fraction(toe), Fraction(heel), pivot, head, 1 if toe < heel else -1)
        self.assertAlmostEqual(load["value"], float(1000 * truth), delta=1e-9 * 1000 * abs(heel - toe) + load["error"])
        return load["value"]

    def test_on_two_bumps(self):
        """The scene by hand: ½ · 9.81 · 1.5 · 2 · cos 5° = 14.66 kN, 1.3333 − 0.4 m from the toe: 13.68 kN m."""
        block = [(0, 0), (2, 0), (2, 4), (0, 4)]
        profile = bumps(-2, 4, [Fraction(2, 5), Fraction(8, 5)])
        for place in ("", ", place: rest"):
            case = self.case(block, "{profile: %s%s}" % (chain(profile), place), "1.5")
            self.assertAlmostEqual(self.holds(case, 0, 2, "1.5"), 13681.7, delta=0.05)

    def test_mated(self):
        """Closed all along: from end to end of the contact, as it was."""
        block = [(0, 0), (2, 0), (2, 4), (0, 4)]
        for towards, toe, heel in (("left", 0, 2), ("right", 2, 0)):
            self.holds(self.case(block, "{mated: true}", "1.5", towards), toe, heel, "1.5")
            self.holds(self.case(block, "{mated: true}", "1.5", towards, level=True), toe, heel, "1.5", level=True)

    def test_base_that_ends_under_the_block(self):
        """The rock ends at 1.7 m of a sole of 2 m: there the water comes out, or goes in."""
        block, end = [(0, 0), (2, 0), (2, 4), (0, 4)], Fraction(17, 10)
        base = "{profile: %s}" % chain(bumps(-2, end, [Fraction(2, 5), Fraction(8, 5)]))
        self.holds(self.case(block, base, "1.5"), 0, end, "1.5")
        self.holds(self.case(block, base, "1.5", "right"), end, 0, "1.5")

    def test_sole_that_rises(self):
        """A sole whose ends rise at 20° and at 60° from the part that touches: the first is sole, and the joint is
        open along it; the second is nearer upright than level, a face. The water stands on the joint's end."""
        block = [(0, Fraction(1, 2)), (1, 0), (3, 0), (Fraction(7, 2), 1), (Fraction(7, 2), 5), (0, 5)]
        base = "{profile: [[-3, 0], [6, 0]]}"
        self.holds(self.case(block, base, "1.5"), 0, 3, "1.5")
        case = self.case(block, base, "1.5", "right")
        self.holds(case, 3, 0, "1.5")
        face = next(load for load in case["loads"] if load["name"] == "water")["moment_nm"]["value"]
        push = float(WATER) * 1.5 ** 2 / 2 * math.cos(math.radians(5))
        self.assertAlmostEqual(face, 1000 * push * (0.5 + 0.5), delta=1e-6)  # a third of 1.5, over 0.5

    def test_shifted_joint(self):
        """A toothed block shifted by 0.5 m along its own joint rides up and touches on flanks alone; its sole goes
        from 0.5 to 4.5, its base from 0 to 4: the joint from 0.5 to 4."""
        teeth = [(0, 0), (1, Fraction(1, 5)), (2, 0), (3, Fraction(1, 5)), (4, 0), (4, 4), (0, 4)]
        half = Fraction(1, 2)
        for towards, toe, heel in (("left", half, 4), ("right", 4, half)):
            case = self.case(teeth, "{mated: true}", "1.5", towards, more="joint: {shift: 0.5}\n")
            self.holds(case, toe, heel, "1.5")

    def test_random(self):
        """Slabs on bumps and ledges, both directions, level or not."""
        draw = random.Random(1931)
        for _ in range(20):
            width = Fraction(draw.randint(20, 60), 10)
            crests = sorted(draw.sample(range(2, int(10 * width) - 1), draw.randint(2, 3)))
            crests = [Fraction(c, 10) for c in crests]
            if not crests[0] < width / 2 < crests[-1] or min(b - a for a, b in zip(crests, crests[1:])) < Fraction(1, 5):
                continue
            left = crests[0] - Fraction(draw.randint(1, 30), 10)
            right = crests[-1] + Fraction(draw.randint(1, 30), 10)
            height, level = Fraction(draw.randint(1, 9), 10), draw.random() < 0.5
            low, high = max(left, Fraction(0)), min(right, width)
            block = [(0, 0), (width, 0), (width, 2 * width), (0, 2 * width)]
            for towards, toe, heel in (("left", low, high), ("right", high, low)):
                case = self.case(block, "{profile: %s}" % chain(bumps(left, right, crests)), height, towards,
                                 level=level)
                self.holds(case, toe, heel, height, level=level)


if __name__ == "__main__":
    main()
