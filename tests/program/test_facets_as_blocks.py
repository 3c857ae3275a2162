# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A block on a base of three facets, each of a friction of its own, is a block on three that are ground with joints of these
frictions. The block ends at vertices of the base as often as not: where it does, what slips over the vertex comes onto the next
facet, and the onset of the one, which had the frictions of the facets alone on which the block lies, was up to 16 degrees above a
motion that the other proves. Two solvers that share nothing here: faces of a cone of twists, and modes excluded by branch and bound.
Mirrored, the one is the same to its bounds."""

import random
from fractions import Fraction

from governing_case import GoverningCase
from harness import main, rounds

WIDTH = 1e-4  # degrees; motions of many blocks are followed to 1e-5
LEAST = 0.01  # degrees: at less the two tell another story, of what moves as it lies


def written(points):
    return "[" + ", ".join(f"[{float(x)!r}, {float(y)!r}]" for x, y in points) + "]"


def draw():
    """The profile, the block and the friction angles: at either end the base goes on straight, falls off, or rises."""
    length, slope = random.randint(2, 6), random.choice([0, 0, 0, Fraction(1, 4), Fraction(-1, 4), Fraction(1, 2)])
    kinds = [random.choice(["straight", "falls", "rises"]) for _ in range(2)]
    bends = [{"straight": 0, "falls": random.choice([Fraction(1, 2), 1, 2]), "rises": -random.choice([Fraction(1, 2), 1])}[k]
             for k in kinds]
    profile = [(-3, -3 * (slope + bends[0])), (0, 0), (length, slope * length), (length + 3, slope * length + 3 * (slope - bends[1]))]
    left = random.choice([0, 0, Fraction(1, 2), 0 if kinds[0] == "rises" else -1])
    right = random.choice([length, length, length - Fraction(1, 2), length + (kinds[1] != "rises")])
    width, top = right - left, max(slope * left, slope * right) + random.randint(1, 6)
    lean = [random.choice([0, 0, Fraction(1, 4), Fraction(-1, 4) if kind != "rises" else 0]) * width for kind in kinds]
    block = [(left, slope * left), (right, slope * right), (right - lean[1], top), (left + lean[0], top)]
    return profile, block, [random.choice([5, 10, 15, 20, 25, 30, 35, 45, 60]) for _ in range(3)]


def mirrored(points):
    return [(-x, y) for x, y in points[::-1]]


def as_one(profile, block, angles):
    facets = ", ".join(f"{{facet: {k + 1}, angle_deg: {own}}}" for k, own in enumerate(angles))
    return (f"topple: 1\nlength_unit: m\nblock: {{outline: {written(block)}}}\nbase: {{profile: {written(profile)}}}\n"
            f"friction_angle_deg: 40\nfriction: {{facets: [{facets}]}}\ntilt: {{towards: both}}\n")


def as_many(profile, block, angles):
    low = min(y for _, y in profile) - 5
    ground = [f"  - {{name: g{k}, ground: true, outline: {written([(a[0], low), (b[0], low), b, a])}}}\n"
              for k, (a, b) in enumerate(zip(profile, profile[1:]))]
    joints = ", ".join(f"{{between: [g{k}, block], friction_angle_deg: {own}}}" for k, own in enumerate(angles))
    return ("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nblocks:\n" + "".join(ground) +
            f"  - {{name: block, outline: {written(block)}}}\njoints: [{joints}]\ntilt: {{towards: both, angle_deg: 0}}\n")


def onset(case):
    """The least tilt from level on at which a motion can begin."""
    return min((max(w["from_deg"]["value"] if w["from_deg"] else 0, 0) for w in case["onset"]["windows"]
                if w["to_deg"] is None or w["to_deg"]["value"] >= 0), default=90)


class FacetsAsBlocks(GoverningCase):
    def test_onsets(self):
        random.seed(191)
        count = rounds(60, 600)
        met = 0
        for _ in range(count):
            scene = draw()
            one = {c["towards"]: c for c in self.solve(as_one(*scene))}
            many = {c["towards"]: c for c in self.solve(as_many(*scene))}
            image = {c["towards"]: c for c in self.solve(as_one(mirrored(scene[0]), mirrored(scene[1]), scene[2][::-1]))}
            for side, other in (("left", "right"), ("right", "left")):
                told, with_many = onset(one[side]), many[side]
                self.assertAlmostEqual(told, onset(image[other]), delta=1e-9, msg=scene)
                if told < LEAST:
                    self.assertNotEqual(with_many["verdict"], "stands", scene)
                    continue
                stands, moves = with_many.get("standing_angle_deg"), with_many.get("moving_angle_deg")
                if stands is not None:
                    self.assertLessEqual(stands, told + WIDTH, (scene, side))
                if moves is not None:
                    self.assertGreaterEqual(moves, told - WIDTH, (scene, side))
                met += stands is not None and moves is not None and moves - stands < WIDTH
        self.assertGreater(met, count * 2 // 3)


if __name__ == "__main__":
    main()
