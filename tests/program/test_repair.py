# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Outlines that cross themselves by less than the last digit of their coordinates, as rounding leaves them.

The story: an outline of a survey with vertices close beside other edges, rounded to three decimals, was refused for a
crossing of a fifth of a millimetre, with nothing said of how small it is. It is offered a repair now, which is made where the
scene asks for it, and reports each vertex that it moves. By brute force over all pairs of edges, in exact rationals: what is
refused does meet itself, what the notes say of a repaired one is a simple polygon, no vertex is a whole digit from
where it was given, and the area is that of the moved vertices. TOPPLE_ROUNDS multiplies the number of scenes."""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest
from fractions import Fraction

import exact
from harness import ROUNDS, main, run

MOVED = re.compile(r"repaired: vertex (\d+) of (.+) is moved from \((\S+), (\S+)\) to \((\S+), (\S+)\)$")


def turn_of(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def turn(p, q, r):
    value = turn_of(p, q, r)
    return (value > 0) - (value < 0)


def on(p, q, r):
    """Is r, which is collinear with them, between p and q?"""
    return min(p[0], q[0]) <= r[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= r[1] <= max(p[1], q[1])


def meet(p, q, r, s):
    a, b, c, d = turn(p, q, r), turn(p, q, s), turn(r, s, p), turn(r, s, q)
    if a * b < 0 and c * d < 0:
        return True
    return any(side == 0 and on(*edge) for side, edge in ((a, (p, q, r)), (b, (p, q, s)), (c, (r, s, p)), (d, (r, s, q))))


def is_simple(ring):
    count = len(ring)
    edges = [(ring[k], ring[(k + 1) % count]) for k in range(count)]
    return not any(meet(*edges[i], *edges[k]) for i in range(count) for k in range(i + 2, count) if (i, k) != (0, count - 1))


def comb(decimals, angle, tips):
    """A block whose notches from above end a hair above its bottom edge, turned by an angle, rounded: numbers as text."""
    ring = [(0, 0), (40, 0), (40, 30)]
    for k in range(tips):
        x = 40 - 40 * (k + 0.5) / tips
        ring += [(x + 2, 30), (x + random.uniform(-1, 1), random.uniform(1e-7, 3e-7)), (x - 2, 29)]
    ring.append((0, 30))
    c, s = math.cos(angle), math.sin(angle)
    return [tuple(f"{value:.{decimals}f}" for value in (c * x - s * y, s * x + c * y)) for x, y in ring]


def last_digit(ring):
    """The largest power of ten of which all coordinates are multiples."""
    return max(digit for digit in (Fraction(10)**k for k in range(-8, 5))
               if all((c / digit).denominator == 1 for point in ring for c in point))


class Repair(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def run_scene(self, block, command="solve", *words):
        (pathlib.Path(self.folder.name) / "scene.yaml").write_text(
            f"topple: 1\nlength_unit: m\nblock: {{{block}}}\nbase: {{mated: true}}\ntilt: {{towards: left}}\n")
        return run(command, *words, "scene.yaml", folder=self.folder.name)

    def solve(self, block):
        status, out, err = self.run_scene(block, "solve", "--json")
        self.assertEqual((status, err), (0, ""))
        solution = json.loads(out)
        return solution["cases"][0]["block"], [note["text"] for note in solution["notes"]]

    def refuse(self, block):
        status, out, err = self.run_scene(block)
        self.assertEqual((status, out), (3, ""))
        return err

    def moved(self, ring, notes, digit, name="the outline"):
        """The ring as the notes say that it is now, with what must hold of them."""
        now = list(ring)
        moves = [found.groups() for found in map(MOVED.match, notes) if found and found[2] == name]
        for number, _, *numbers in moves:
            x, y, new_x, new_y = map(Fraction, numbers)
            k = int(number) - 1
            self.assertEqual(ring[k], (x, y))
            self.assertLess((new_x - x) ** 2 + (new_y - y) ** 2, digit**2)
            now[k] = new_x, new_y
        self.assertGreater(len(moves), 0)
        most = max(math.hypot(*(float(a - b) for a, b in zip(p, q))) for p, q in zip(ring, now))
        self.assertIn(f"repaired: edges of {name} met by less than its last digit, {float(digit):g}; {len(moves)} ", notes[0])
        said = float(re.search(r"moved, by (\S+) at most", notes[0])[1])
        self.assertLessEqual(most, said * (1 + 1e-15))
        self.assertLess(said, 1.11 * most)
        return now

    def test_rounded_outlines(self):
        random.seed(31)
        crossed = 0
        for k in range(60 * ROUNDS):
            decimals = random.randint(0, 4)
            text = comb(decimals, random.uniform(-0.4, 0.4) if k % 5 else 0, random.randint(1, 4))
            if decimals == 0:
                text = [tuple(c + "00" for c in point) for point in text]  # whole hundreds: the last digit is 100
            ring = [tuple(map(Fraction, point)) for point in text]
            digit = last_digit(ring)
            outline = "outline: [" + ", ".join(f"[{x}, {y}]" for x, y in text) + "]"
            with self.subTest(outline=outline):
                if is_simple(ring):
                    self.assertEqual(self.solve(outline + ", repair: true")[1],
                                     self.solve(outline)[1])
                    continue
                err = self.refuse(outline)
                self.assertRegex(err, r"the outline (crosses|touches) itself: ")
                if min(max(axis) - min(axis) for axis in zip(*ring)) < 100 * digit:
                    self.assertNotIn("repair", err)
                    continue
                deepest = max((-turn_of(ring[0], ring[1], point) / math.dist(*(map(float, p) for p in ring[:2])) for point in ring))
                if "repair" not in err:
                    self.assertGreater(deepest, 0.95 * digit)
                    continue
                self.assertLess(deepest, digit)
                crossed += 1
                self.assertIn(f"; by less than its last digit, {float(digit):g}: 'repair: true' in the block moves ", err)
                block, notes = self.solve(outline + ", repair: true")
                now = self.moved(ring, notes, digit)
                self.assertTrue(is_simple(now))
                area = exact.block_moments(now)[0]
                self.assertLessEqual(abs(Fraction(block["area_m2"]["value"]) - abs(area)), Fraction(block["area_m2"]["error"]))
        self.assertGreater(crossed, 15 * ROUNDS)

    def test_holes_and_csv(self):
        """Each ring has its own last digit, numbers and places."""
        random.seed(7)
        text = None
        while text is None or is_simple([tuple(map(Fraction, point)) for point in text]):
            text = comb(2, 0.3, 2)
        (pathlib.Path(self.folder.name) / "hole.csv").write_text("x,y\n" + "".join(f"{x},{y}\n" for x, y in text))
        block = "outline: [[-50, -50], [100, -50], [100, 100], [-50, 100]], holes: [hole.csv]"
        self.assertIn("hole 1", self.refuse(block))
        solved, notes = self.solve(block + ", repair: true")
        now = self.moved([tuple(map(Fraction, point)) for point in text], notes, Fraction(1, 100), "hole 1")
        self.assertTrue(is_simple(now))
        area = 150 * 150 - abs(exact.block_moments(now)[0])
        self.assertLessEqual(abs(Fraction(solved["area_m2"]["value"]) - area), Fraction(solved["area_m2"]["error"]))

    def test_what_is_no_slip(self):
        """Crossings by a digit or more, fractions without a last digit, and rings as
        small as their last digit are refused as before, with and without `repair`."""
        for outline in ("[[0, 0], [3.333, 0.777], [3.4, 3], [1.7, 0.393], [1.2, 2], [0, 2.5]]",
                        "[[0, 0], [100/3, 1], [100/3, 30], [50/3, 1/2 - 1/10^9], [1, 30]]",
                        "[[0, 0], [2, 0], [0, 1], [2, 1]]", "[[0, 0], [300, 0], [0, 100], [200, 100]]"):
            for repair in ("", ", repair: false", ", repair: true"):
                err = self.refuse(f"outline: {outline}{repair}")
                self.assertRegex(err, r"the outline (crosses|touches) itself: ")
                self.assertIn("; reorder or move the vertices\n", err)

    def test_what_repair_takes(self):
        good = "outline: [[0, 0], [3.333, 0.777], [3.4, 3], [1.7, 0.396], [1.2, 2], [0, 2.5]]"
        self.assertEqual(self.run_scene(good + ", repair: true")[0], 0)
        self.assertIn("repair must be true or false", self.refuse(good + ", repair: 1"))
        self.assertIn("an outline with arcs cannot be repaired",
                      self.refuse(good + ", repair: true, arcs: [{from: [0, 2.5], bulge: 0.1}]"))
        status, out, err = self.run_scene(good + ", repair: true", "derive")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("formulas are derived for the outline as it is given; leave out 'repair'", err)
        self.assertEqual(self.solve("slab: {width: 1, height: 2}, repair: true")[1], [])


if __name__ == "__main__":
    main()
