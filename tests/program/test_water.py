# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Water behind blocks at any tilt, by integration of its pressure along the face.

The truth is worked here in decimals of 50 digits and shares nothing with the program: pressure g (h - s cos a)
at the distance s from the heel, up to where it ends, by Simpson's rule, which is exact for these cubics; the
tilts of balance by a scan of 720 tilts and bisection. A level that stays over the heel reaches above the top of
its face beyond acos(h / face): its pressure is taken on as if the face went on (docs/loads.md), so that no angle,
no factor and no limit ends there. TOPPLE_ROUNDS multiplies the number of scenes."""

import json
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROUNDS, main, rounds, run

GAMMA, WATER = Decimal(26), Decimal("9.81")


def text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def simpson(of, end):
    """The integral from 0 to `end` of a polynomial of degree 3 or less."""
    return end / 6 * (of(Decimal(0)) + 4 * of(end / 2) + of(end))


class Block:
    """A block, mirrored where it is tilted towards the right, so that down-dip is -x, and its water."""

    def __init__(self, outline, toe, heel, height, uplift, level, mirrored=False):
        side = -1 if mirrored else 1
        outline = [(side * Fraction(x), Fraction(y)) for x, y in outline]
        outline = outline[::side]
        m = exact.block_moments(outline)
        gx, gy = exact.centroid(m)
        self.gx, self.gy, self.weight = exact.decimal(gx), exact.decimal(gy), GAMMA * exact.decimal(m[0])
        self.toe = exact.decimal(side * Fraction(toe[0]))
        self.heel = tuple(map(exact.decimal, (side * Fraction(heel[0]), heel[1])))
        self.height, self.uplift, self.level = exact.decimal(height), uplift, level

    def loads(self, degrees):
        """Each (name, force x, force y, moment about the origin), moments counter-clockwise."""
        s, c = exact.sin_cos(degrees)
        length = self.height / c if self.level else self.height  # along the face

        def pressure(at):
            return WATER * (length - at) * c

        force = simpson(pressure, length)
        arm = simpson(lambda at: at * pressure(at), length)
        yield "weight, normal", Decimal(0), -self.weight * c, -self.weight * c * self.gx
        yield "weight, parallel", -self.weight * s, Decimal(0), self.weight * s * self.gy
        yield "water", -force, Decimal(0), force * self.heel[1] + arm
        if self.uplift:
            width = self.heel[0] - self.toe
            head = pressure(Decimal(0))

            def below(at):  # from the toe, where it has fallen to nothing
                return head * at / width

            lift = simpson(below, width)
            yield "uplift", Decimal(0), lift, simpson(lambda at: at * below(at), width) + lift * self.toe

    def moments(self, degrees, pivot):
        return [(name, m - (pivot[0] * fy - pivot[1] * fx)) for name, fx, fy, m in self.loads(degrees)]

    def moment(self, degrees, pivot):
        return sum(m for _, m in self.moments(degrees, pivot))

    def factor(self, degrees, pivot):
        """What stabilises over what overturns, each load with its sign."""
        own = [m for _, m in self.moments(degrees, pivot)]
        return -sum(m for m in own if m < 0) / sum(m for m in own if m > 0)

    def slip(self, degrees, friction):
        """Force down-dip less friction on a flat base."""
        s, c = exact.sin_cos(friction)
        fx, fy = (sum(load[k] for load in self.loads(degrees)) for k in (1, 2))
        return -fx + fy * s / c


def zeros(of):
    """Rising zeros between 0 and 90 degrees."""
    tilts = [Decimal(k) / 8 for k in range(720)]
    values = [of(tilt) for tilt in tilts]
    found = []
    for low, high, at_low, at_high in zip(tilts, tilts[1:], values, values[1:]):
        if at_low > 0 or at_high <= 0:
            continue
        for _ in range(70):
            middle = (low + high) / 2
            if of(middle) <= 0:
                low = middle
            else:
                high = middle
        found.append(low)
    return found


class Water(unittest.TestCase):
    def setUp(self):
        exact.set_digits(50)
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        exact.set_digits(60)
        self.folder.cleanup()

    def solve(self, outline, water, friction, towards, tilt, digits=9):
        self.text = ("topple: 1\nlength_unit: m\nblock: {outline: %s, unit_weight_kn_m3: 26}\n"
                     "base: {mated: whole, beyond: {left: 0, right: 0}}\nfriction_angle_deg: %s\n"
                     "loads: {water: %s}\ntilt: {towards: %s, angle_deg: %s}\n"
                     % (text(outline), friction, water, towards, tilt))
        self.scene.write_text(self.text)
        return run("solve", "--json", "--digits", digits, self.scene)

    def holds(self, said, truth):
        slack = Decimal(10) ** -14 * max(abs(truth), 1)
        self.assertLessEqual(abs(Decimal(said["value"]) - truth), Decimal(said["error"]) + slack, self.text)

    def test_slabs(self):
        """On a flat base that ends at the toe the static limit is the lesser of the angles at which the slab
        topples and slides, below and above the overtopping alike; and what has a factor below 1 does not
        stand."""
        random.seed(71)
        beyond = 0
        count = rounds(34, 100) * ROUNDS
        for _ in range(count):
            b, h = Fraction(random.randint(10, 90), 10), Fraction(random.randint(20, 80), 10)
            height = h * random.choice([1, Fraction(1, 2), Fraction(random.randint(1, 999), 1000)])
            friction, tilt = random.randint(20, 85), random.randint(1, 89)
            uplift, level = random.random() < 0.3, random.random() < 0.8
            mirrored = random.random() < 0.5
            outline = [(0, 0), (b, 0), (b, h), (0, h)]
            ends = ((0, 0), (b, 0))[::-1 if mirrored else 1]
            truth = Block(outline, *ends, height, uplift, level, mirrored)
            toe = (truth.toe, Decimal(0))
            water = (f"{{height: {height}, uplift: {str(uplift).lower()}, stays_level: {str(level).lower()}}}")
            status, out, err = self.solve(outline, water, friction, "right" if mirrored else "left", tilt)
            self.assertEqual(status, 0, self.text + err)
            case = json.loads(out)["cases"][0]
            self.holds(case["toppling"]["fos"], truth.factor(tilt, toe))
            if truth.moment(0, toe) >= 0 or truth.slip(0, friction) >= 0:
                continue
            topples = zeros(lambda a: truth.moment(a, toe))
            slides = zeros(lambda a: truth.slip(a, friction))
            self.holds(case["toppling"]["critical_angle_deg"], topples[0])
            if slides:
                self.holds(case["sliding"]["critical_angle_deg"], slides[0])
            limit = min(topples[0], slides[0] if slides else 90)
            self.holds(case["limit"]["critical_angle_deg"], limit)
            if truth.factor(tilt, toe) < 1 or truth.slip(tilt, friction) > 0:
                self.assertNotEqual(case["mechanism"], "interlocked", self.text)
            if tilt < limit:
                self.assertEqual(case["mechanism"], "stands", self.text)
            if level and height > 0:
                s, c = exact.sin_cos(limit)
                over = c * exact.decimal(h) < exact.decimal(height)
                beyond += over
                self.assertEqual(Decimal(case["water_overtops_deg"]["value"]) < limit, over, self.text)
                if over:
                    report = run("solve", self.scene)[1]
                    self.assertIn("the water is above the top of its face", report)
        self.assertGreater(beyond, 15 * count // 100)

    def test_steps(self):
        """Blocks on a step, up or down: toe and heel at different heights, in both directions at once, which
        must say what each says alone."""
        random.seed(72)
        for _ in range(rounds(9, 25) * ROUNDS):
            b = [Fraction(random.randint(5, 30), 10) for _ in range(2)]
            step = Fraction(random.choice([-15, -7, 3, 8, 20]), 10)
            top = max(step, 0) + Fraction(random.randint(5, 40), 10)
            outline = [(0, 0), (b[0], 0), (b[0], step), (b[0] + b[1], step), (b[0] + b[1], top), (0, top)]
            height = min(top, top - step) * Fraction(random.randint(0, 10), 10)
            tilt, level, uplift = random.randint(1, 89), random.random() < 0.8, random.random() < 0.5
            water = (f"{{height: {height}, uplift: {str(uplift).lower()}, stays_level: {str(level).lower()}}}")
            status, out, err = self.solve(outline, water, 35, "both", tilt)
            self.assertIn(status, (0, 4), self.text + err)
            both = json.loads(out)["cases"]
            for case, towards in zip(both, ("left", "right")):
                mirrored = towards == "right"
                ends = (outline[0], outline[3])[::-1 if mirrored else 1]
                truth = Block(outline, *ends, height, uplift, level, mirrored)
                for pivot in case["pivots"]:
                    at = (Decimal(pivot["x_m"]["value"]) * (-1 if mirrored else 1), Decimal(pivot["y_m"]["value"]))
                    if pivot["fos"] is not None:
                        self.holds(pivot["fos"], truth.factor(tilt, at))
                    found = zeros(lambda a: truth.moment(a, at))
                    if truth.moment(0, at) < 0 and found:
                        self.holds(pivot["critical_angle_deg"], found[0])
                status, out, err = self.solve(outline, water, 35, towards, tilt)
                alone = json.loads(out)["cases"][0]
                for key in ("mechanism", "falls_backwards"):
                    self.assertEqual(alone[key], case[key], self.text)
                self.assertEqual(alone["limit"]["mechanism"], case["limit"]["mechanism"], self.text)
                self.assertEqual(alone["toppling"] is None, case["toppling"] is None)

    def test_heel_of_each_direction(self):
        """Water counts from the up-dip end of the contact: of a step that is the one end or the other.
        Above the crest it is refused; of both directions, where it is in one of them, and that is named."""
        outline = [(-4, 2), (-4, 1), (-3, 1), (-3, 0), (0, 0), (0, 2)]
        mirror = [(-x, y) for x, y in reversed(outline)]
        for points, names in ((outline, ("left", "right")), (mirror, ("right", "left"))):
            for level in ("true", "false"):
                for height, refused in ((1, False), ("1 + 1e-30", True), (2, True), ("2 + 1e-30", True)):
                    water = f"{{height: {height}, stays_level: {level}}}"
                    over = height == "2 + 1e-30"
                    for towards, fails in ((names[0], over), (names[1], refused), ("both", refused)):
                        status, out, err = self.solve(points, water, 30, towards, 5)
                        self.assertEqual(status, 3 if fails else 0, f"{self.text}{err}")
                        if fails and not over:
                            self.assertIn(f"tilted towards the {names[1]}", err)
                            self.assertIn("scene.yaml:6:", err)

    def test_upright(self):
        """At 90 degrees a level that stays never comes to the end of its face; 1e-9 below, it still does,
        and its pressure takes all stability. Without any water nothing is refused."""
        slab = [(0, 0), (3, 0), (3, 2), (0, 2)]
        status, out, err = self.solve(slab, "{height: 1, stays_level: true}", 30, "left", 90)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("scene.yaml:7:", err)
        self.assertIn("90°", err)
        for water in ("{height: 0, stays_level: true}", "{height: 1}"):
            status, _, err = self.solve(slab, water, 30, "left", 90)
            self.assertEqual(status, 0, err)
        status, out, err = self.solve(slab, "{height: 1, stays_level: true}", 30, "left", "90 - 1e-9")
        self.assertEqual(status, 0, err)
        self.assertLess(json.loads(out)["cases"][0]["toppling"]["fos"]["value"], 1e-15)


if __name__ == "__main__":
    main()
