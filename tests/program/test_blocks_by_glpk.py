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
        for k in range(rounds(6, 10000)):
            self.held_against(draw, draw.randint(60, 200) if k % 50 == 49 else draw.randint(20, 40))

    def test_wedged(self):
        """Walls that stand on ground of which some is blocks that friction wedges."""
        draw = random.Random(31)
        for _ in range(rounds(4, 300)):
            self.held_against(draw, draw.randint(8, 16), with_keys)


if __name__ == "__main__":
    main()
