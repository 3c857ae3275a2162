# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Back-analysis where the result stays at the wanted value, turns at it, ends at it or jumps over it.

The static limit of a slab of width w and height h on a flat base that ends at its toe is
min(phi, atan(w / h)): constant wherever w / h is above tan(phi). Ends of the stretches in closed form, in
decimals of 60 digits. TOPPLE_ROUNDS multiplies the number of scenes."""

import json
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROUNDS, main, rounds, run


def tan(degrees):
    s, c = exact.sin_cos(degrees)
    return s / c


class Find(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def find(self, width, height, target, low, high, friction="30", tilt=20):
        self.path.write_text(
            "topple: 1\nlength_unit: m\nparameters: {p: 1}\n"
            f"block: {{slab: {{width: {width}, height: {height}}}, unit_weight_kn_m3: 26}}\n"
            f"base: {{mated: true}}\nfriction_angle_deg: {friction}\n"
            f"tilt: {{towards: left, angle_deg: {tilt}}}\n")
        arguments = ("--find", "p", "--for", target, "--from", low, "--to", high, self.path)
        status, out, err = run("solve", "--json", *arguments)
        self.assertEqual(status, 0, err)
        found = json.loads(out)["find"]
        self.told = f"{self.path.read_text()}{found}"
        return found

    def report(self, target, low, high):
        """The page of the last scene, which tells the same."""
        return run("solve", "--find", "p", "--for", target, "--from", low, "--to", high, self.path)[1]

    def holds(self, said, truth, most_error):
        value, error = Decimal(said["value"]), Decimal(said["error"])
        self.assertLessEqual(abs(value - truth), error * (1 + Decimal("1e-9")), self.told)
        self.assertLessEqual(error, most_error, self.told)

    def test_one_end(self):
        """The limit of a slab is phi for every height up to w / tan(phi), for every width from h tan(phi), and
        the angle of its diagonal for every phi from that on."""
        random.seed(91)
        for friction, side in [(30, 1)] + [(random.randint(10, 70), random.randint(1, 50)) for _ in range(rounds(2, 8) * ROUNDS)]:
            edge = side / tan(friction)
            found = self.find(side, "p", f"limit_angle={friction}", 0.01 * float(edge), 3.3 * float(edge), friction)
            self.assertEqual((len(found["intervals"]), found["solutions"], found["touching"]), (1, [], []), self.told)
            self.assertEqual(found["intervals"][0]["from"]["value"], found["from"])
            self.holds(found["intervals"][0]["to"], edge, edge * Decimal("1e-12"))
            edge = side * tan(friction)
            found = self.find("p", side, f"limit_angle={friction}", 0.3 * float(edge), 7 * float(edge), friction)
            self.assertEqual((len(found["intervals"]), found["solutions"]), (1, []), self.told)
            self.holds(found["intervals"][0]["from"], edge, edge * Decimal("1e-12"))
            self.assertEqual(found["intervals"][0]["to"]["value"], found["to"])

    def test_two_ends(self):
        """Height w (1 + (p - c)^2 - s^2) / tan(phi): the limit is phi where |p - c| <= s, be it over many
        of the 512 points, over less than the room between two, or a single point (s = 0: it touches)."""
        random.seed(92)
        for spread in ("1/2", "1/10", "1/300", "1/1000", "1/100000"):
            for _ in range(rounds(1, 2) * ROUNDS):
                middle = random.randint(-100, 100)
                found = self.find(1, f"1 + (p - {middle} - 1/7)^2 - ({spread})^2", "limit_angle=45",
                                  middle - 1, middle + 1, friction=45)
                s = exact.decimal(Fraction(spread))
                about = Decimal(middle) + Decimal(1) / 7
                self.assertEqual((len(found["intervals"]), found["solutions"]), (1, []), self.told)
                own = found["intervals"][0]
                # numbers of 17 digits; what 30 digits tell of a curve that rises by 2 s d is far narrower
                most = Decimal("1e-13") * max(abs(about), 1)
                self.holds(own["from"], about - s, most)
                self.holds(own["to"], about + s, most)

    def test_near_is_not_at(self):
        """(p - 1/2)^2, ^4 and ^6 below 45 degrees: ever longer stretches that no bound tells from it, yet the
        result is 45 at one number alone. With an odd power it passes it: one solution."""
        for power in (2, 4, 6):
            found = self.find(f"1 - (p - 1/2)^{power}", 1, "critical_angle=45", 0.1, 1)
            self.assertEqual((found["intervals"], found["solutions"], len(found["touching"])), ([], [], 1), self.told)
            self.holds(found["touching"][0], Decimal("0.5"), Decimal("0.1"))
        for power in (3, 5):
            found = self.find(f"1 - (p - 1/2)^{power}", 1, "critical_angle=45", 0.1, 1)
            self.assertEqual((found["intervals"], len(found["solutions"]), found["touching"]), ([], 1, []), self.told)
            self.holds(found["solutions"][0], Decimal("0.5"), Decimal("0.1"))

    def test_everywhere(self):
        """What does not depend on the number has its value all over the range, or nowhere."""
        found = self.find(1, "p", "sliding_angle=30", 0.5, 5)
        self.assertEqual(len(found["intervals"]), 1)
        self.assertEqual((found["intervals"][0]["from"]["value"], found["intervals"][0]["to"]["value"]), (0.5, 5))
        self.assertNotIn("none in range", self.report("sliding_angle=30", 0.5, 5))
        found = self.find(1, "p", "sliding_angle=30.000001", 0.5, 5)
        self.assertEqual((found["intervals"], found["solutions"], found["touching"]), ([], [], []))
        self.assertIn("none in range", self.report("sliding_angle=30.000001", 0.5, 5))

    def test_factors(self):
        """By strength reduction a slab that cannot topple has the factor tan(phi) / tan(tilt) whatever its
        height: constant up to w / h = tan(tilt), beyond which no strength holds it."""
        wanted = tan(45) / tan(20)
        found = self.find(1, "p", f"limit_fos={float(wanted)!r}", 0.2, 4, friction=45)
        self.assertEqual((len(found["intervals"]), found["solutions"]), (1, []), self.told)
        # as far as bounds prove a factor next to where there is none
        self.assertAlmostEqual(found["intervals"][0]["to"]["value"], float(1 / tan(20)), delta=1e-9)
        self.assertEqual(found["intervals"][0]["from"]["value"], 0.2)

    def test_at_an_end_of_the_range(self):
        """A solution that is the first or the last number of the range."""
        for low, high in ((1, 3), (0.25, 1)):
            found = self.find("p", 1, "critical_angle=45", low, high)
            self.assertEqual((len(found["solutions"]), found["intervals"], found["touching"]), (1, [], []), self.told)
            self.holds(found["solutions"][0], Decimal(1), Decimal("1e-12"))

    def test_long_keys(self):
        """Keys that share any beginning are told apart: the one that is asked for is found, and one that is
        not there is no other."""
        for length in (100, 127, 128, 500):
            key = "q" * length
            self.path.write_text(
                f"topple: 1\nlength_unit: m\nparameters: {{{key}x: 9, {key}y: 2}}\n"
                f"block: {{slab: {{width: 1, height: {key}y}}}}\nbase: {{mated: true}}\ntilt: {{towards: left}}\n")
            for way in (f"{key}y", f"parameters.{key}y"):
                status, out, err = run("solve", "--json", "--find", way, "--for", "critical_angle=45", self.path)
                self.assertEqual(status, 0, err)
                self.assertAlmostEqual(json.loads(out)["find"]["solutions"][0]["value"], 1, places=9)
            for way in (f"{key}z", key, f"{key}yy"):
                status, out, err = run("solve", "--find", way, "--for", "critical_angle=45", self.path)
                self.assertEqual((status, out), (3, ""))
                self.assertIn("there is no 'qqq", err)

    def test_kinks(self):
        """At sqrt(3) the limit turns from 30 degrees to the diagonal's angle: below that it is passed once."""
        random.seed(93)
        for _ in range(rounds(3, 6) * ROUNDS):
            wanted = random.randint(1, 29)
            found = self.find(1, "p", f"limit_angle={wanted}", 0.1, 80)
            self.assertEqual((len(found["solutions"]), found["intervals"], found["touching"]), (1, [], []), self.told)
            edge = 1 / tan(wanted)
            self.holds(found["solutions"][0], edge, edge * Decimal("1e-11"))

    def test_steep(self):
        """atan(10^9 (p - 1/3) + 1) passes 45 degrees within 1e-9, which is no jump."""
        found = self.find("10^9*(p - 1/3) + 1", 1, "critical_angle=45", "0.3333333333", 0.5)
        self.assertEqual((len(found["solutions"]), found["intervals"]), (1, []), self.told)
        self.holds(found["solutions"][0], Decimal(1) / 3, Decimal("1e-12"))


if __name__ == "__main__":
    main()
