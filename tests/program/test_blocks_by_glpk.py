# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Random walls of blocks against the simplex method in exact arithmetic: the limit is within the bracket that is told.
`./check --long` draws ten thousand."""

import fractions
import json
import math
import os
import random
import unittest

import block_forces_by_glpk as glpk
from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import Pile, box

Q = fractions.Fraction
ROUNDED = 1e-8  # glp_exact takes the numbers of a program to some 1e-9


def random_wall(draw, blocks):
    """Courses of their own heights, cut at points of their own, all of it sheared and scaled, some of the top course left out."""
    wide = draw.randint(6, 30)
    pile = Pile()
    low = Q(0)
    while len(pile.blocks) < blocks:
        high = low + Q(draw.randint(2, 9), 4)
        most = max(1, min(wide - 1, blocks // 3))
        cuts = sorted(draw.sample(range(1, wide), draw.randint(1, most)))
        for left, right in zip([0] + cuts, cuts + [wide]):
            pile.add(f"b{len(pile.blocks)}", box(Q(left), low, Q(right), high))
        low = high
    top = [b for b in pile.blocks if b[1][2][1] == low]
    for b in draw.sample(top, draw.randint(0, len(top) - 1)):
        pile.blocks.remove(b)
    pile.blocks.insert(0, ("ground", box(Q(-9), Q(-3), Q(wide + 9), Q(0)), True))
    lean, scale = Q(draw.randint(-6, 6), 16), Q(draw.choice((1, 3, 1000)), draw.choice((1, 8)))
    return pile.moved(lambda x, y: (scale * (x + lean * y), scale * y))


def with_keys(draw, pile):
    """Trenches in the ground, of parallel walls, each filled by a block: wedged there, it moves in no collapse."""
    (name, ground, _), *rest = pile.blocks
    low, high = min(x for x, y in ground if y == 0), max(x for x, y in ground if y == 0)
    cuts = sorted(draw.sample(range(1, 24), 2 * draw.randint(1, 3)))
    at = [low + (high - low) * Q(c, 24) for c in cuts]
    deep, lean = (high - low) * Q(draw.randint(1, 4), 32), Q(draw.randint(-4, 4), 8)
    top, keys = [], []
    for left, right in zip(at[::2], at[1::2]):
        key = [(left - lean * deep, -deep), (right - lean * deep, -deep), (right, Q(0)), (left, Q(0))]
        top += [key[3], key[0], key[1], key[2]]
        keys.append((f"key{len(keys)}", key, False))
    bottom = [p for p in ground if p[1] < 0]
    floor = min(y for _, y in bottom) - 4 * deep
    pile.blocks = [(name, [(low - deep, floor), (high + deep, floor), (high, Q(0)), *reversed(top), (low, Q(0))], True), *rest, *keys]
    return pile


def decimals(pile):
    """All numbers have a power of two below the line, and few digits."""
    return pile.moved(lambda x, y: (repr(float(x)), repr(float(y))))


@unittest.skipUnless(glpk.IS_THERE, "GLPK is not installed")
class BlocksByGlpk(GoverningCase):
    def held_against(self, draw, blocks, change=lambda draw, pile: pile):
        pile = change(draw, random_wall(draw, blocks))
        left, phi = draw.random() < 0.5, draw.choice((5, 15, 25, 33, 45))
        names = [b[0] for b in pile.blocks]
        pairs = [(i, j) for i, j, _, _ in glpk.contacts(pile.blocks) if draw.random() < 0.1]
        other = {frozenset(pair): draw.choice((2, 20, 40)) for pair in pairs}
        pile.joints = [(*(names[k] for k in pair), angle) for pair, angle in other.items()]
        own = decimals(pile)
        own.joints = pile.joints
        text = own.scene(phi, f"tilt: {{towards: {'left' if left else 'right'}}}")
        status, out, err = run("solve", "--json", self.scene(text))
        self.assertIn(status, (0, 1), (err, text))
        case = json.loads(out)["cases"][0]
        truth = glpk.greatest_load(pile.blocks, lambda i, j: math.tan(math.radians(other.get(frozenset((i, j)), phi))), left)
        self.check(case, truth, text)

    def check(self, case, truth, text):
        limit = case["critical_angle_deg"]
        if truth == "any":
            self.assertIsNone(limit, text)
            self.assertEqual(case["limit"], "interlocked", text)
        elif truth == "none" or truth < -1:
            self.assertEqual(case["verdict"], "collapses", text)
        else:
            self.assertIsNotNone(limit, (case, truth, text))
            angle = math.degrees(math.atan(truth))  # the entries of the exact program are rounded to 2**-53, which a pile magnifies
            self.assertLessEqual(abs(limit["value"] - angle), limit["error"] + 1e-8, (case, truth, text))
            self.assertLessEqual(limit["error"], 1e-4, text)

    def test_random_walls(self):
        """20 to 200 blocks, most of them few: exact simplex takes seconds of many."""
        draw = random.Random(int(os.environ.get("TOPPLE_RANDOM_SEED", "20")))
        for k in range(rounds(3, 10000)):
            self.held_against(draw, draw.randint(60, 200) if k % 50 == 49 else draw.randint(20, 40))

    def told(self, pile, phi, tilt, more=""):
        text = decimals(pile).scene(phi, f"tilt: {{towards: left, angle_deg: {tilt}}}\n{more}")
        status, out, err = run("solve", "--json", self.scene(text))
        self.assertIn(status, (0, 1, 4), (err, text))
        return json.loads(out)["cases"][0], text

    def limit(self, pile, tangent, left):
        own = glpk.greatest_load(pile.blocks, lambda i, j: tangent, left)
        return {"any": math.inf, "none": -math.inf}.get(own, own)

    def test_strength(self):
        """With strength divided by the factor less its bound the exact program holds the tilt, which is no more than its limit to the side,
        nor than that to the other, as walls lean; by the factor and its bound, it does not."""
        draw, numbers = random.Random(int(os.environ.get("TOPPLE_RANDOM_SEED", "41"))), 0
        for _ in range(rounds(5, 2000)):
            pile, phi, tilt = random_wall(draw, draw.randint(6, 20)), draw.choice((15, 25, 33)), draw.choice((4, 12, 20))
            case, text = self.told(pile, phi, tilt)
            if "fos_is" in case:
                continue
            numbers += 1
            side = math.tan(math.radians(tilt))
            for sign in (-1, 1):
                tangent = math.tan(math.radians(phi)) / (case["fos"]["value"] + sign * case["fos"]["error"])
                rest = min(self.limit(pile, tangent, True) - side, self.limit(pile, tangent, False) + side)
                self.assertGreaterEqual(-sign * rest, -ROUNDED, (case["fos"], rest, text))
        self.assertGreaterEqual(numbers, 3)

    def test_support(self):
        """Columns side by side, pushed at the toe: the least force that a factor needs, or that none is enough, or none is needed."""
        draw, numbers = random.Random(int(os.environ.get("TOPPLE_RANDOM_SEED", "43"))), 0
        for _ in range(rounds(8, 2000)):
            pile, at = Pile().add("g", box(Q(-9), Q(-3), Q(99), Q(0)), True), Q(0)
            for k in range(draw.randint(1, 7)):
                wide = Q(draw.randint(2, 6), 2)
                pile.add(f"c{k}", box(at, Q(0), at + wide, Q(draw.randint(2, 14 - k), 2) + k))
                at += wide
            phi, tilt, asked = draw.choice((30, 38, 45)), draw.choice((10, 18, 26)), draw.choice((1, 1.25, 1.5))
            point = (Q(0), pile.blocks[1][1][2][1])
            case, text = self.told(pile, phi, tilt, f"support: {{block: c0, at: [0, {float(point[1])!r}], fos: {asked}, direction_deg: 0}}")
            tangent, side = math.tan(math.radians(phi)) / asked, math.tan(math.radians(tilt))
            own = glpk.least_support(pile.blocks, lambda i, j, t=tangent: t, -side, 1, point, (1, 0))
            support = case["support"]
            if "force_is" in support:
                self.assertEqual({"not needed": 0, "none": "none"}.get(support["force_is"]), own, text)
                continue
            numbers += 1
            truth = own * 25000 * math.cos(math.radians(tilt))  # weights across x are cos of all
            weights = 25000 * float(sum(glpk.area_and_centroid(points)[0] for _, points, ground in pile.blocks if not ground))
            self.assertLessEqual(abs(support["force_n_m"]["value"] - truth), support["force_n_m"]["error"] + ROUNDED * weights, text)
        self.assertGreaterEqual(numbers, 3)

    def test_wedged(self):
        """Walls that stand on ground of which some is blocks that friction wedges."""
        draw = random.Random(31)
        for _ in range(rounds(2, 300)):
            self.held_against(draw, draw.randint(8, 16), with_keys)


if __name__ == "__main__":
    main()
