# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Blocks that only just stand, and that only just fall: told apart as exactly as the scene is given.

Where doubles with their bounds leave it open, few blocks are solved in rationals. A stack of bricks that leans out by all that it can stands in
equilibrium, by 1e-30 of a brick less it has that much to spare, by as much more it falls; its limit is that of the moments of all above each
joint about the edge below, in fractions. Boxes of whole numbers are in such ties one time in twenty, and are held against forces in fractions. An arch as thin as can be has one line of thrust alone, through the crown's extrados, the intrados at
the haunch and the extrados at the springing, which tells its thickness and the friction that it needs."""

import collections
import fractions
import math
import random
from decimal import Decimal

from forces_in_fractions import held
from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import Pile, arch, box, degrees_of

Q = fractions.Fraction


def stack(count, more):
    """Bricks of a length that all overhangs, 1/(2k) of it, divide; the topmost leans out by so much more. Decimals are exact."""
    long = math.lcm(*range(2, 2 * count + 1, 2))
    edges, at = [Q(0)], Q(0)
    for k in range(count, 0, -1):
        at += Q(long, 2 * k) + (more if k == 1 else 0)
        edges.append(at)
    bricks = [box(edge - long, k, edge, k + 1) for k, edge in enumerate(edges[1:])]
    return bricks, edges


def limit_of_stack(bricks, edges):
    """tan of the tilt at which all above some joint turns about the edge below it; friction is more than that."""
    least = None
    for k, edge in enumerate(edges[:-1]):
        above = bricks[k:]
        centre = sum((left + right) / 2 for (left, _), (right, _), *_ in above) / len(above)
        own = (edge - centre) / Q(len(above), 2)
        least = own if least is None else min(least, own)
    return least


def decimal(number):
    """Of a denominator of 10^40, exactly."""
    whole = number * 10 ** 40
    assert whole.denominator == 1
    sign, digits = "-" if whole < 0 else "", str(abs(whole.numerator)).rjust(41, "0")
    return f"{sign}{digits[:-40]}.{digits[-40:]}"


def pile_of(bricks, *, mirrored=False, shift=(0, 0), reversed_order=False, split=False):
    sign = -1 if mirrored else 1

    def place(points):
        own = [(sign * (Q(x) + shift[0]), Q(y) + shift[1]) for x, y in points]
        return [(decimal(x), decimal(y)) for x, y in (own[::-1] if mirrored else own)]

    ground = [(-99999, -1), (0, -1), (0, 0), *([(Q(-1, 8), 0), (-3, 0)] if split else []), (-99999, 0)]
    blocks = [("ground", place(ground), True)] + [(f"b{k}", place(b)) for k, b in enumerate(bricks)]
    pile = Pile()
    for block in blocks[::-1] if reversed_order else blocks:
        pile.add(*block)
    return pile


def half_arch(count, thickness):
    """Thrusts of the crown between which a line lies within the joints of half an arch, and its weight: from extrados and intrados of every joint."""
    own = arch(count, thickness).blocks[1:]
    voussoirs = [[(float(x), float(y)) for x, y in points] for _, points, _ in own[:count // 2]]
    inner, outer = zip(*((v[0], v[1]) for v in voussoirs))
    top = voussoirs[-1][2][1]
    least, most, weight, moment = 0, math.inf, 0, 0
    for (ix, iy), (ox, oy), v in reversed(list(zip(inner, outer, voussoirs))):
        for (ax, ay), (bx, by) in zip(v, v[1:] + v[:1]):
            cross = ax * by - bx * ay
            weight += cross / 2
            moment += (ax + bx) * cross / 6
        least = max(least, (weight * ix - moment) / (top - iy))
        most = min(most, (weight * ox - moment) / (top - oy)) if top > oy else most
    return least, most, weight


def least_thickness(count):
    low, high = 0.05, 0.3
    for _ in range(60):
        middle = (low + high) / 2
        least, most, _ = half_arch(count, middle)
        low, high = (low, middle) if least <= most else (middle, high)
    return high


def random_boxes(draw):
    """On ground that ends at 0, and some on more ground at the right: even widths, so that many lie with their middle above an edge."""
    boxes = [(Q(-50), Q(-1), Q(0), Q(0))]
    if draw.random() < 0.5:
        boxes.append((Q(draw.randint(1, 6)), Q(-1), Q(50), Q(0)))
    ground = range(len(boxes))
    for k in range(draw.randint(2, 6)):
        below = []
        while not below:
            wide, left, high = 2 * draw.randint(1, 3), Q(draw.randint(-4, 2 if k else -1)), draw.randint(1, 3)
            below = [top for l, _, r, top in boxes if l < left + wide and r > left]
        boxes.append((left, max(below), left + wide, max(below) + high))
    return boxes, ground


class BlockTies(GoverningCase):
    def test_overhangs(self):
        """To 1e-30 of what it can, and at it, whichever way it is looked at; equilibrium as it lies is enough to stand. And at 1e-8, which
        doubles tell."""
        images = ({}, {"mirrored": True}, {"shift": (12345678, Q(7, 8))}, {"reversed_order": True}, {"split": True},
                  {"mirrored": True, "shift": (-3, 10 ** 9), "reversed_order": True, "split": True})
        for count in (2, 5, 8):
            for more in (Q(1, 10 ** 30), Q(0), -Q(1, 10 ** 30), Q(1, 10 ** 8), -Q(1, 10 ** 8)):
                bricks, edges = stack(count, more)
                truth = limit_of_stack(bricks, edges)
                self.assertEqual((truth > 0) - (truth < 0), (more < 0) - (more > 0))
                for how in images if count == 5 else images[-1:]:
                    towards = "left" if how.get("mirrored") else "right"
                    pile = pile_of(bricks, **how)
                    for unit in ("m", "mm") if not how else ("m",):
                        (own,) = self.solve(pile.scene(30, f"tilt: {{towards: {towards}}}", unit=unit))
                        self.assertEqual(own["verdict"], "collapses" if more > 0 else "stands", (count, more, how))
                        limit = own["critical_angle_deg"]
                        known = math.degrees(math.atan(truth))
                        self.assertLessEqual(abs(limit["value"] - known), limit["error"] + 1e-15 * abs(known))
                        if abs(more) < Q(1, 10 ** 20):
                            self.assertLessEqual(limit["error"], 1e-12 * abs(known))
                            self.assertEqual(own["fos"] is None, more > 0)  # none with any strength

    def test_report(self):
        """What stands at its limit is not told to be unproven beyond it."""
        out = run("solve", self.scene(pile_of(stack(3, Q(0))[0]).scene(30, "tilt: {towards: right}")))[1]
        self.assertIn("certain to stand at tilts             of 0° alone: no forces hold more\n", out)
        self.assertIn("greatest tilt that forces can hold    0.0000°\n", out)

    def test_whole_numbers(self):
        """Random boxes, a few of them in equilibrium by nothing to spare: told as fractions tell it, with tan φ at either end of what it is
        enclosed by. What normal forces hold stands."""
        low, high = (Q(Decimal(3).sqrt()) / 3 + Q(e, 10 ** 20) for e in (-1, 1))
        draw, seen = random.Random(1), collections.Counter()
        for _ in range(rounds(80, 3000)):
            boxes, ground = random_boxes(draw)
            names = [f"b{k}" for k in range(len(boxes))]
            pile = Pile()
            for name, own in zip(names, boxes):
                pile.add(name, [(float(x), float(y)) for x, y in box(*own)], names.index(name) in ground)
            (own,) = self.solve(pile.scene(30, "tilt: {towards: right}"))
            holds = held(boxes, ground, low)
            self.assertEqual(holds, held(boxes, ground, high))
            self.assertEqual(own["verdict"] == "collapses", not holds, (own["verdict"], boxes))
            self.assertNotEqual(own["verdict"], "undecided")
            if holds and held(boxes, ground, 0):
                self.assertEqual(own["verdict"], "stands", boxes)
            limit = own["critical_angle_deg"]
            seen["tie"] += holds and abs(limit["value"]) <= limit["error"]
            seen[holds] += 1
        self.assertGreater(min(seen.values()), 2, seen)

    def test_cohesive_overhangs(self):
        """Cohesion holds nothing that turns about an edge."""
        for more, verdict in ((Q(1, 10 ** 30), "collapses"), (Q(0), "stands"), (-Q(1, 10 ** 30), "stands")):
            text = pile_of(stack(5, more)[0]).scene(30, "tilt: {towards: right}\nloads: {cohesion_kpa: 10}")
            (own,) = self.solve(text)
            self.assertEqual(own["verdict"], verdict)

    def test_thinnest_arch(self):
        """Of 12 voussoirs it stands by 1e-12 of its thickness and falls by as much; of 12 and of 60, near their least thickness, friction is told
        to the millionth."""
        thin = least_thickness(12)
        for more, verdicts in ((1e-12, ("can be held", "stands")), (-1e-12, ("collapses",))):
            self.assertIn(self.solve(arch(12, thin + more).scene(35))[0]["verdict"], verdicts)
        for count in (12, 60):
            thickness = least_thickness(count) + 1e-6
            least, most, weight = half_arch(count, thickness)
            self.assertLess(least, most)
            told = self.solve(arch(count, thickness).scene(degrees_of(0.5)))[0]["fos"]
            self.assertLessEqual(abs(told["value"] - 0.5 / (least / weight)), told["error"] + 1e-8)
            self.assertLessEqual(told["error"], 4e-6 * told["value"])

    def test_thickness_of_section_10(self):
        """0.107478 by 400 voussoirs, and no less by more; friction of the thinnest comes to 1 - (2/π)(1 + t²/12)/(1 + t/2), where the line
        of thrust leaves the springing."""
        thin = least_thickness(400)
        self.assertLess(abs(thin - 0.107478), 5e-7)
        least, _, weight = half_arch(400, thin)
        self.assertLess(abs(least / weight - (1 - 2 / math.pi * (1 + thin ** 2 / 12) / (1 + thin / 2))), 1e-5)


if __name__ == "__main__":
    main()
