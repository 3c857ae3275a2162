# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A pressure or a surcharge acts on all edges that its line covers.

A straight face may be given in several edges, with vertices on the way: the load is the same as on one edge. Where
'contact: {within: …}' makes points of the profile vertices of an edge, each of the edges that it becomes takes the
part of the load over it. Both were refused. Moments are worked here in rationals, edge by edge, as p (r × n) dl."""

import json
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import main, run


def text(points):
    return "[" + ", ".join(f"[{Fraction(x)}, {Fraction(y)}]" for x, y in points) + "]"


def moment_of(begin, end, first, last, pivot):
    """Of a pressure that goes from `first` to `last`, on the left of its line: the integral over the line of p times
    (x - X) dx + (y - Y) dy, overturning about the pivot, towards the left."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]

    def at(share):
        x, y = begin[0] + share * dx - pivot[0], begin[1] + share * dy - pivot[1]
        return (first + share * (last - first)) * (x * dx + y * dy)

    return (at(Fraction(0)) + 4 * at(Fraction(1, 2)) + at(Fraction(1))) / 6


class PressureEdges(unittest.TestCase):
    def run_scene(self, outline, base, loads, more="", tilt=10):
        scene = ("topple: 1\nlength_unit: m\nblock: {outline: %s, unit_weight_kn_m3: 26}\nbase: %s\n%s"
                 "loads: %s\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: %s}\n"
                 % (text(outline), base, more, loads, tilt))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "scene.yaml"
            path.write_text(scene)
            return run("solve", "--json", path)

    def case(self, *arguments, **options):
        status, out, err = self.run_scene(*arguments, **options)
        self.assertEqual(status, 0, err)
        return json.loads(out)["cases"][0]

    def moments(self, case, name):
        return [load["moment_nm"]["value"] for load in case["loads"] if load["name"] == name]

    def test_collinear_vertices(self):
        """On a face of one edge and of several, in any order round the block: the same load and the same answers."""
        plain = [(0, 0), (4, 0), (4, 6), (0, 6)]
        for load in ("{pressures: [{from: [4, 1], to: [4, 5], kpa: [5, 8]}]}",
                     "{surcharges: [{from: [1, 6], to: [7/2, 6], kpa: 5}]}",
                     "{surcharges: [{from: [7/2, 6], to: [1, 6], kpa: 5}]}"):
            one = self.case(plain, "{mated: true}", load)
            for outline in ([(0, 0), (4, 0), (4, 3), (4, 6), (2, 6), (0, 6)],
                            [(4, 2), (4, 3), (4, 4), (4, 6), (3, 6), (2, 6), (1, 6), (0, 6), (0, 0), (4, 0)]):
                other = self.case(outline, "{mated: true}", load)
                self.assertEqual([m["moment_nm"] for m in one["loads"][2:]], [m["moment_nm"] for m in other["loads"][2:]])
                for part in ("toppling", "sliding", "limit"):
                    self.assertAlmostEqual(one[part]["critical_angle_deg"]["value"],
                                           other[part]["critical_angle_deg"]["value"], delta=1e-9)
        case = self.case([(0, 0), (4, 0), (4, 3), (4, 6), (0, 6)], "{mated: true}",
                         "{pressures: [{from: [4, 1], to: [4, 5], kpa: 5}]}")
        self.assertEqual(self.moments(case, "pressure"), [60000])  # 5 kPa on 4 m, 3 m over the toe

    def test_refused(self):
        """Past a corner, past the end of the face, over a gap between two faces in line, or the wrong way."""
        straight = [(0, 0), (4, 0), (4, 3), (4, 6), (0, 6)]
        slotted = [(0, 0), (4, 0), (4, 2), (3, 2), (3, 4), (4, 4), (4, 6), (0, 6)]
        for outline, line, said in ((straight, "from: [4, 1], to: [4, 7]", "does not act on an edge"),
                                    (straight, "from: [4, 5], to: [3, 6]", "does not act on an edge"),
                                    (slotted, "from: [4, 1], to: [4, 5]", "does not act on an edge"),
                                    (straight, "from: [4, 5], to: [4, 1]", "would pull"),
                                    (straight, "from: [4, 3], to: [4, 3]", "would pull")):
            status, out, err = self.run_scene(outline, "{mated: true}", "{pressures: [{%s, kpa: 5}]}" % line)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(said, err)

    def test_within_on_the_sole(self):
        """A crest of 1 mm at the middle of the sole becomes its vertex: 5 kPa from 1 m to 3 m act on the two edges
        that rise to it."""
        square = [(0, 0), (4, 0), (4, 6), (0, 6)]
        base = "{profile: [[-2, -1], [0, 0], [2, 0.001], [4, 0], [6, -1]]}"
        load = "{pressures: [{from: [1, 0], to: [3, 0], kpa: [%s, %s]}]}"
        crest, at_one, at_three = (Fraction(2), Fraction(1, 1000)), (Fraction(1), Fraction(1, 2000)), (
            Fraction(3), Fraction(1, 2000))
        for first, last in ((5, 5), (0, 8), (6, 1)):
            case = self.case(square, base, load % (first, last), more="contact: {within: 0.01}\n")
            middle = Fraction(first + last, 2)
            pivot = (Fraction(0), Fraction(0))
            truth = [moment_of(at_one, crest, Fraction(first), middle, pivot),
                     moment_of(crest, at_three, middle, Fraction(last), pivot)]
            for found, expected in zip(self.moments(case, "pressure"), truth, strict=True):
                self.assertAlmostEqual(found, float(1000 * expected), delta=1e-7)

    def test_within_at_random(self):
        """Soles over profiles that nearly touch them in up to six points. Together the parts push up as much as the
        load on the flat sole would, and turn as much to 1 part in 100; a surcharge below the block acts likewise."""
        draw = random.Random(12)
        split = 0
        for _ in range(12):
            width, height = draw.randint(3, 6), draw.randint(3, 8)
            square = [(0, 0), (width, 0), (width, height), (0, height)]
            inner = sorted(draw.sample(range(1, 10 * width), draw.randint(1, 6)))
            profile = [(-2, -1), (0, 0)] + [(Fraction(x, 10), Fraction(draw.randint(-4, 4), 1000)) for x in inner]
            profile += [(width, 0), (width + 2, -1)]
            low = Fraction(draw.randint(0, 10), 10)
            high = width - Fraction(draw.randint(0, 10), 10)
            load = "{pressures: [{from: [%s, 0], to: [%s, 0], kpa: 5}]}" % (low, high)
            status, out, err = self.run_scene(square, "{profile: %s}" % text(profile), load,
                                              more="contact: {within: 0.01}\n")
            if "does not act on an edge" in err:
                self.fail(err)
            if status != 0:
                continue  # the moved outline may cross itself where two points are close
            case = json.loads(out)["cases"][0]
            found = self.moments(case, "pressure")
            pivot = case["pivots"][case["toppling"]["pivot"]]["x_m"]["value"]
            truth = float(moment_of((low, 0), (high, 0), 5, 5, (Fraction(pivot), 0)))
            self.assertAlmostEqual(sum(found), 1000 * truth, delta=10 * abs(truth) + 50)
            split += len(found) > 1
        self.assertGreater(split, 4)


if __name__ == "__main__":
    main()
