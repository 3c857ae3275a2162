# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""That no motion of blocks begins whose joints have cohesion and tensile strength (docs/blocks_in_contact.md): against closed forms, and
against all that contacts can do, one program of GLPK for each."""

import json
import math
import random
import unittest
from fractions import Fraction

import modes_by_glpk as modes
from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import Pile, box, turned


def on_ground():
    return Pile().add("g", box(-50, -1, 60, 0), True)


def tilted(angle, side, cohesion, bond):
    return f"tilt: {{towards: {side}, angle_deg: {angle}}}\nloads: {{cohesion_kpa: {cohesion}, bond_kpa: {bond}}}"


class CohesiveMotions(GoverningCase):
    def case(self, pile, friction, more, unit="m"):
        status, out, err = run("solve", "--json", self.scene(pile.scene(friction, more, unit=unit)))
        self.assertIn(status, (0, 1, 4), err)
        return json.loads(out)["cases"][0]

    def test_slides(self):
        """A box on a slope, and two on each other, stand by cohesion although the slope is steeper than φ, up to
        (c L + W cos α tan φ) / (W sin α) of the lower joint; so do they where the base is cut into pieces."""
        sine, cosine = math.sin(math.radians(40)), math.cos(math.radians(40))
        split = Pile().add("g", [(-50, -1), (60, -1), (60, 0), (1.5, 0), (1, 0), (-50, 0)], True)
        for pile, area in ((on_ground(), 2), (on_ground().add("b", box(0, 1, 2, 2)), 4), (split, 2)):
            own = self.case(pile.add("a", box(0, 0, 2, 1)), 20, tilted(40, "left", 30, 0))
            known = (30 * 2 + 25 * area * cosine * math.tan(math.radians(20))) / (25 * area * sine)
            self.assertEqual(own["verdict"], "stands")
            self.assertNotIn("motions_sought", own)
            self.assertLessEqual(own["standing_fos"], known)
            self.assertGreaterEqual(own["standing_fos"], known * (1 - 5e-5))
            self.assertGreaterEqual(own["moving_fos"], known)

    def test_topples(self):
        """A slab stands by the tension of its base, as a pull at the middle, up to σ b²/2 over what overturns it. It slides
        sooner where there is little friction. The tension pulls at the heel then, as far as it has to; it presses nothing."""
        sine, cosine = math.sin(math.radians(25)), math.cos(math.radians(25))
        known = 40 * 0.5 / (75 * (1.5 * sine - 0.5 * cosine))
        for side, pile in (("left", on_ground()), ("right", on_ground())):
            own = self.case(pile.add("a", box(0, 0, 1, 3)), 40, tilted(25, side, 200, 40))
            self.assertEqual(own["verdict"], "stands")
            self.assertLessEqual(own["standing_fos"], known)
            self.assertGreaterEqual(own["standing_fos"], known * (1 - 2e-5))
        own = self.case(on_ground().add("a", box(0, 0, 1, 3)), 18, tilted(25, "left", 20, 40))
        pull = 75 * (1.5 * sine - 0.5 * cosine)  # at the heel, about the toe
        known = (20 + (75 * cosine + pull) * math.tan(math.radians(18))) / (75 * sine)
        self.assertLess(known * pull, 40)
        self.assertLessEqual(own["standing_fos"], known)
        self.assertGreaterEqual(own["standing_fos"], known * (1 - 5e-5))

    def random_pile(self, draw):
        """One block or two beside or above each other, on level ground or on a step."""
        wide, high = draw.randint(2, 8), draw.randint(2, 12)
        pile = on_ground().add("a", box(0, 0, Fraction(wide, 4), Fraction(high, 4)))
        kind = draw.choice(("one", "above", "beside"))
        if kind == "above":
            left = draw.randint(0, wide - 1)
            pile.add("b", box(Fraction(left, 4), Fraction(high, 4), Fraction(left + draw.randint(1, 6), 4), Fraction(high + draw.randint(1, 8), 4)))
        elif kind == "beside":
            pile.add("b", box(Fraction(wide, 4), 0, Fraction(wide + draw.randint(1, 6), 4), Fraction(draw.randint(1, 12), 4)))
        return pile

    @unittest.skipUnless(modes.glpk.IS_THERE, "GLPK is not installed")
    def test_all_modes(self):
        """Where no motion is said to begin none does, whatever contacts do: as the blocks lie, and with strength over numbers up to the one
        that is given; a motion that is said to begin does. Mostly both are one number."""
        draw, narrow, standing = random.Random(11), 0, 0
        for _ in range(rounds(14, 150)):
            pile = self.random_pile(draw)
            friction, cohesion, bond = draw.choice((0, 15, 35, 55)), draw.choice((0, 1, 10, 40)), draw.choice((0, 1, 10))
            angle, side = draw.choice((0, 7, 20, 35)), draw.choice(("left", "right"))
            own = self.case(pile.moved(lambda x, y: (float(x), float(y))), friction, tilted(angle, side, cohesion, bond))
            strength = (math.tan(math.radians(friction)), cohesion, bond)
            blocks = modes.Blocks([b if len(b) == 3 else (*b, False) for b in pile.blocks], 25, lambda i, j, s=strength: s)
            sine, cosine = math.sin(math.radians(angle)), math.cos(math.radians(angle))
            gravity = (-sine if side == "left" else sine, -cosine)
            where = (pile.blocks, friction, cohesion, bond, angle, side, own["verdict"])
            if own["verdict"] in ("may move", "collapses"):
                self.assertTrue(blocks.can_move(gravity, 1), where)
            if own["verdict"] == "stands":
                standing += 1
                most = min(own["standing_fos"], 50)
                for divisor in (1, 1 + (most - 1) / 3, 1 + 0.9999 * (most - 1)):
                    self.assertFalse(blocks.can_move(gravity, divisor), (*where, divisor))
                if "moving_fos" in own:
                    self.assertTrue(blocks.can_move(gravity, own["moving_fos"] * (1 + 1e-3)), where)
                narrow += "moving_fos" not in own or own["moving_fos"] <= own["standing_fos"] * (1 + 2e-5)
        self.assertGreater(standing, 0)
        self.assertGreaterEqual(2 * narrow, standing)

    def test_images(self):
        """Mirrored, turned, renumbered, in millimetres and in a mine's coordinates, and with
        the ground's edge in pieces: the same verdict and the same number."""
        own = on_ground().add("low", box(0, 0, 2, 1)).add("column", box(2, 0, 3, 5))
        pieces = Pile().add("g", [(-50, -1), (60, -1), (60, 0), (2.5, 0), (0.5, 0), (-50, 0)], True)
        pieces.blocks += own.blocks[1:]
        shuffled = Pile()
        shuffled.blocks = own.blocks[::-1]
        more = tilted(12, "left", 20, 8)
        cases = [self.case(own, 30, more), self.case(own.moved(lambda x, y: (-x, y)), 30, more.replace("left", "right")),
                 self.case(shuffled, 30, more), self.case(pieces, 30, more),
                 self.case(own.moved(lambda x, y: (1000 * x, 1000 * y)), 30, more, "mm"),
                 self.case(own.moved(lambda x, y: (x + Fraction(5123452, 10), y + 6789012)), 30, more)]
        aslant, angle = turned(own)
        cases.append(self.case(aslant, 30, tilted(angle - 12, "right", 20, 8)))
        self.assertEqual(cases[0]["verdict"], "stands")
        for other in cases:
            self.assertEqual(other["verdict"], "stands")
            self.assertAlmostEqual(other["standing_fos"], cases[0]["standing_fos"], delta=1e-3 * cases[0]["standing_fos"])


if __name__ == "__main__":
    main()
