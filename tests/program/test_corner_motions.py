# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Salient corners of two blocks that meet in one point push each other as a motion begins (docs/blocks_in_contact.md): against a closed
form, and against all that contacts and corners can do, one program of GLPK for each."""

import json
import math
import random
import unittest
from fractions import Fraction

import modes_by_glpk as modes
from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import Pile, box, turned


def toe(polished, wide=2, high=1):
    """A box whose lower corner on the left is where a rough ground ends and another one begins."""
    pile = Pile().add("rough", box(0, -1, 10, 0), True).add("other", box(-10, -1, 0, 0), True).add("box", box(0, 0, wide, high))
    pile.joints = [("box", "other", polished)]
    return pile


def quarters(side=2, height=3):
    """Four blocks about one point, on ground: the two on top each touch the one below them and the other one's corner."""
    pile = Pile().add("g", box(-9, -1, 9, 0), True)
    for name, left, low in (("a", -side, 0), ("b", 0, 0), ("c", -side, height), ("d", 0, height)):
        pile.add(name, box(left, low, left + side, low + height))
    return pile


class CornerMotions(GoverningCase):
    def case(self, pile, friction, more, unit="m"):
        status, out, err = run("solve", "--json", self.scene(pile.scene(friction, more, unit=unit)))
        self.assertIn(status, (0, 1, 4), err)
        self.assertNotIn("acts nowhere", err + out)
        return json.loads(out)["cases"][0]

    def oracle(self, pile, friction):
        own = {frozenset(pair): angle for *pair, angle in pile.joints}
        blocks = [(name, [tuple(Fraction(v) for v in p) for p in points], ground) for name, points, ground in pile.blocks]
        def strength(i, j):
            return math.tan(math.radians(own.get(frozenset((blocks[i][0], blocks[j][0])), friction))), 0, 0
        return modes.Blocks(blocks, 25, strength)

    def test_toe(self):
        """The ground is rough below the box, and polished from its toe on down. All its weight may rest on the rough part, and there it
        stands up to φ: but as soon as it has begun to slide its toe is on the other corner, without friction, and the heel alone holds.
        With h the height and b the width, that is less than the slope where tan α > (1 − h/b tan α) / 2 tan φ."""
        tangent = math.tan(math.radians(30))
        begins = math.degrees(math.atan(tangent / 2 / (1 + tangent / 4)))
        for side, pile in (("left", toe(0)), ("right", toe(0).moved(lambda x, y: (-x, y)))):
            if side == "right":
                pile.blocks = [(name, points[::-1], ground) for name, points, ground in pile.blocks]
            own = self.case(pile, 30, f"tilt: {{towards: {side}, angle_deg: 20}}")
            self.assertEqual(own["verdict"], "may move")
            self.assertAlmostEqual(own["moving_angle_deg"], begins, delta=1e-3)
            own = self.case(pile, 30, f"tilt: {{towards: {side}, angle_deg: 5}}")
            self.assertEqual(own["verdict"], "stands")
            self.assertLessEqual(own["standing_angle_deg"], begins)
            self.assertAlmostEqual(own["standing_angle_deg"], begins, delta=1e-4)
            self.assertLessEqual(own["standing_fos"], own["moving_fos"])
            self.assertAlmostEqual(own["standing_fos"], own["moving_fos"], delta=1e-4)

    def test_one_friction(self):
        """Where both grounds are as rough the corner changes nothing: the box stands up to φ, as on a ground in one piece."""
        own = self.case(toe(30), 30, "tilt: {towards: left, angle_deg: 20}")
        whole = Pile().add("g", box(-10, -1, 10, 0), True).add("box", box(0, 0, 2, 1))
        one = self.case(whole, 30, "tilt: {towards: left, angle_deg: 20}")
        for key in ("verdict", "fos"):
            self.assertEqual(own[key], one[key])
        self.assertAlmostEqual(own["standing_fos"], one["standing_fos"], delta=1e-4)
        self.assertAlmostEqual(own["standing_angle_deg"], one["standing_angle_deg"], delta=1e-3)

    def test_quarters(self):
        """Four blocks about a point stand on level ground whatever their corners do, as without friction."""
        own = self.case(quarters(), 30, "tilt: {towards: left, angle_deg: 0}")
        self.assertEqual((own["verdict"], own["standing_fos"]), ("stands", 1000))

    def random_pile(self, draw):
        kind = draw.choice(("toe", "toe", "heel", "filled", "leaning"))
        quarter = [Fraction(draw.randint(2, 10), 4) for _ in range(6)]
        if kind in ("toe", "heel"):
            pile = toe(draw.choice((0, 10, 40)), quarter[0], quarter[1])
            if kind == "heel":  # the other ground begins at the upper end
                pile.blocks = [(n, [(quarter[0] - x, y) for x, y in reversed(p)], g) for n, p, g in pile.blocks]
        elif kind == "filled":  # a block fills a trench to its brim, another one stands on it with a corner at the brim
            deep = quarter[2]
            pile = Pile().add("g", box(0, -9, 9, -deep), True).add("brim", box(-9, -9, 0, 0), True)
            pile.add("fill", box(0, -deep, quarter[3], 0)).add("box", box(0, 0, quarter[0], quarter[1]))
            pile.joints = [("box", "brim", draw.choice((0, 20, 50)))]
        else:  # two that overhang towards each other, and touch by their upper corners
            low, high, top = quarter[0], quarter[0] + quarter[1], quarter[2]
            pile = Pile().add("g", box(-20, -1, 20, 0), True)
            pile.add("a", [(-low, 0), (0, 0), (quarter[3], top), (-high, top)])
            pile.add("b", [(2 * quarter[3], 0), (2 * quarter[3] + low, 0), (2 * quarter[3] + high, top), (quarter[3], top)])
        return pile

    @unittest.skipUnless(modes.glpk.IS_THERE, "GLPK is not installed")
    def test_all_modes(self):
        """Where no motion is said to begin none does, whatever contacts and corners do; a motion that is said to begin does. Mostly both
        are one number."""
        draw, narrow, standing, moving = random.Random(5), 0, 0, 0
        for _ in range(rounds(16, 300)):
            pile, friction = self.random_pile(draw), draw.choice((5, 15, 35, 55))
            angle, side = draw.choice((3, 10, 18)), draw.choice(("left", "right"))
            own = self.case(pile.moved(lambda x, y: (float(x), float(y))), friction, f"tilt: {{towards: {side}, angle_deg: {angle}}}")
            blocks = self.oracle(pile, friction)
            self.assertGreater(len(blocks.pairs), 0)
            sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
            gravity = (-sine if side == "left" else sine, -cosine)
            where = (pile.blocks, pile.joints, friction, angle, side, own["verdict"])
            if own["verdict"] == "may move":
                moving += 1
                self.assertTrue(blocks.can_move(gravity, 1), where)
            if own["verdict"] == "stands":
                standing += 1
                most = min(own["standing_fos"], 50)
                for divisor in (1, 1 + 0.9999 * (most - 1)):
                    self.assertFalse(blocks.can_move(gravity, divisor), (*where, divisor))
                if "moving_fos" in own:
                    self.assertTrue(blocks.can_move(gravity, own["moving_fos"] * (1 + 1e-3)), where)
                narrow += "moving_fos" not in own or own["moving_fos"] <= own["standing_fos"] * (1 + 2e-5)
        self.assertGreater(moving, 0)
        self.assertGreater(standing, 0)
        self.assertGreaterEqual(2 * narrow, standing)

    def test_images(self):
        """Renumbered, turned, in millimetres and in a mine's coordinates, and with the ground's edges in pieces, with a block far off: the
        same verdict and the same numbers."""
        own, more = toe(10), "tilt: {towards: left, angle_deg: 8}"
        shuffled, pieces, far = toe(10), toe(10), toe(10).add("far", box(5, 0, 7, 1))
        shuffled.blocks = own.blocks[::-1]
        pieces.blocks[0] = ("rough", [(0, -1), (10, -1), (10, 0), (1.5, 0), (0.25, 0), (0, 0)], True)
        pieces.blocks[1] = ("other", [(-10, -1), (0, -1), (0, -0.5), (0, 0), (-3, 0), (-10, 0)], True)
        cases = [self.case(own, 30, more), self.case(shuffled, 30, more), self.case(pieces, 30, more), self.case(far, 30, more),
                 self.case(own.moved(lambda x, y: (1000 * x, 1000 * y)), 30, more, "mm"),
                 self.case(own.moved(lambda x, y: (x + Fraction(5123452, 10), y + 6789012)), 30, more)]
        aslant, angle = turned(own)
        cases.append(self.case(aslant, 30, f"tilt: {{towards: right, angle_deg: {angle - 8}}}"))
        for other in cases:
            self.assertEqual(other["verdict"], "stands")
            self.assertAlmostEqual(other["standing_fos"], cases[0]["standing_fos"], delta=1e-4)
            self.assertAlmostEqual(other["moving_fos"], cases[0]["moving_fos"], delta=1e-4)


if __name__ == "__main__":
    main()
