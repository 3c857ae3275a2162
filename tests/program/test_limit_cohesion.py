# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The limit with cohesion on facets that all but lie in one line, against every twist at 130 digits
(limit_twists.py): kinks from 1e-3 down to 1e-14 of the block's size, shifted by thirds and sevenths,
towards either side. A number beyond its bound by anything is a failure; so is a wrong mechanism.
TOPPLE_RANDOM_SCENES says how many scenes."""

import json
import os
import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, rounds, run
from limit_twists import Contact, wrench

SCENES = int(os.environ.get("TOPPLE_RANDOM_SCENES", rounds(300, 3000)))
SEED = int(os.environ.get("TOPPLE_RANDOM_SEED", "120"))
GAMMA = 26


def mirrored(points):
    return [(-x, y) for x, y in points[::-1]]


class Scene:
    """A block on a nearly flat underside, everything rational."""

    def __init__(self, draw):
        count = draw.randint(1, 4)
        width = Fraction(draw.randint(5, 300), draw.choice([1, 3, 7, 10]))
        size = Fraction(draw.randint(1, 99), 10) * Fraction(1, 10 ** draw.randint(3, 14)) * width
        xs = sorted({Fraction(0), width, *(width * Fraction(draw.randint(1, 16), 20)
                                           for _ in range(count - 1))})
        under = [(x, size * draw.randint(-9, 9) / 10) for x in xs]
        height = width * Fraction(draw.randint(2, 60), 20)
        top = draw.choice([[(width, height), (Fraction(0), height)], [(Fraction(0), height)],
                           [(width * 2 / 3, height), (width / 5, height)]])
        dx, dy = (draw.choice([Fraction(0), Fraction(1, 3), Fraction(-22, 7), Fraction(10**6, 3)])
                  for _ in range(2))
        under, outline = ([(x + dx, y + dy) for x, y in points] for points in (under, under + top))
        self.under, self.outline = under, outline
        self.area, sx, sy = exact.ring_moments(outline)[:3]
        self.centroid = sx / self.area, sy / self.area
        stress = GAMMA * self.area / width
        self.cohesion = round(stress * Fraction(draw.choice([0, draw.randint(1, 300)]), 200), 6)
        self.bond = round(stress * Fraction(draw.choice([0, 0, draw.randint(1, 100)]), 200), 6)
        self.friction = draw.choice([20, 30, 45, 60, 74, draw.randint(1, 80)])
        self.anchor = draw.choice([None, None, (outline[-1], draw.choice([0, 90, 180, -90]),
                                                round(GAMMA * self.area * draw.randint(1, 60) / 100, 3))])
        self.towards = draw.choice(["left", "right"])

    def text(self, tilt=None):
        points = ", ".join(f"[{x}, {y}]" for x, y in self.outline)
        loads = [f"cohesion_kpa: {self.cohesion}, bond_kpa: {self.bond}"]
        if self.anchor:
            (x, y), direction, force = self.anchor
            loads.append(f"anchors: [{{at: [{x}, {y}], direction_deg: {direction}, force_kn: {force}}}]")
        return (f"topple: 1\nlength_unit: m\nblock:\n  outline: [{points}]\n"
                f"  unit_weight_kn_m3: {GAMMA}\nbase: {{mated: true, beyond: {{left: 0, right: 0}}}}\n"
                f"loads: {{{', '.join(loads)}}}\nfriction_angle_deg: {self.friction}\n"
                f"tilt: {{towards: {self.towards}{'' if tilt is None else f', angle_deg: {tilt}'}}}\n")

    def truth(self, towards, divisor=Decimal(1), weight=None):
        """As Contact.limit has it."""
        under, (gx, gy) = self.under, self.centroid
        sign = 1 if towards == "left" else -1
        if sign < 0:
            under, gx = mirrored(under), -gx
        weight = weight or GAMMA * self.area
        fixed = (Fraction(0),) * 3
        if self.anchor:
            (x, y), direction, force = self.anchor
            along = {0: (1, 0), 90: (0, 1), 180: (-1, 0), -90: (0, -1)}[direction]
            fixed = wrench((sign * x, y), (sign * along[0] * force, along[1] * force))
        loads = (wrench((gx, gy), (0, -weight)), wrench((gx, gy), (-weight, 0)), fixed)
        loads = tuple(tuple(exact.decimal(x) for x in part) for part in loads)
        facets = list(zip(under, under[1:]))
        return Contact(facets, self.friction, self.cohesion, self.bond, divisor).limit(loads)


class LimitWithCohesion(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def solve(self, text, *options):
        self.path.write_text(text)
        _, out, err = run("solve", "--json", *options, self.path)
        self.assertTrue(out, err)
        return json.loads(out)["cases"][0]["limit"]

    def compare(self, limit, truth):
        """True where the limit is decided."""
        if limit["mechanism"] == "undecided":
            return False
        if truth is None:  # level ground does not hold
            value = limit["critical_angle_deg"]
            self.assertTrue(value is None or value["value"] != 0)
            return True
        degrees, names = truth
        if degrees is None:
            self.assertEqual(limit["mechanism"], "interlocked")
            return True
        value = limit["critical_angle_deg"]
        self.assertIsNotNone(value, limit["mechanism"])
        off = abs(Decimal(value["value"]) - degrees)
        self.assertLessEqual(off, Decimal(value["error"]), (degrees, names))
        self.assertLess(value["error"], 1e-7)
        self.assertIn(limit["mechanism"], names)
        return True

    def test_shear_beyond_its_bound(self):
        """A sliver on two facets 1e-13 apart: where the shear of one had to bear more than its cohesion, a
        limit that is too high by 4e-10 degrees was certified at every number of digits. The truth is
        that of limit_twists.py, once more at 30 digits of the program's own."""
        heights = Fraction(-1, 500000000000), Fraction(7, 2)
        for shift in (Fraction(0), Fraction(1, 3)):
            points = [(shift, Fraction(0)), (shift + Fraction(45, 2), heights[0]),
                      (shift + Fraction(47, 2), heights[0]), (shift, heights[1])]
            scene = Scene(random.Random(0))
            scene.under, scene.outline, scene.towards = points[:3], points, "right"
            scene.cohesion, scene.bond, scene.friction, scene.anchor = 2600, 0, 74, None
            scene.area, sx, sy = exact.ring_moments(points)[:3]
            scene.centroid = sx / scene.area, sy / scene.area
            text = scene.text().replace(f"unit_weight_kn_m3: {GAMMA}", "unit_weight_kn_m3: 1")
            truth = scene.truth("right", weight=scene.area)
            self.assertEqual(round(truth[0], 17), Decimal("85.74115387784511194"))
            self.assertTrue(self.compare(self.solve(text), truth))
            _, out, err = run("solve", "--digits=30", self.path)
            self.assertIn(str(round(truth[0], 27)), out, err)

    def test_ten_thousand_facets(self):
        """A flat base in 10^4 pieces is one plane: it slides where sin(a - phi) = c b cos(phi) / W. It
        ends; a pivot for each piece would take an hour."""
        count, friction, cohesion = 10**4, 30, 5
        under = ", ".join(f"[{k}, 0]" for k in range(count + 1))
        height = count // 3
        text = (f"topple: 1\nlength_unit: m\nblock:\n  outline: [{under}, [{count}, {height}], "
                f"[0, {height}]]\n  unit_weight_kn_m3: {GAMMA}\nbase: {{mated: true}}\n"
                f"loads: {{cohesion_kpa: {cohesion}}}\nfriction_angle_deg: {friction}\n"
                "tilt: {towards: left}\n")
        limit = self.solve(text)
        sine = Decimal(cohesion) / (GAMMA * height) * exact.sin_cos(friction)[1]
        truth = friction + exact.degrees(exact.atan(sine / (1 - sine * sine).sqrt()))
        self.assertEqual(limit["mechanism"], "slides")
        value = limit["critical_angle_deg"]
        self.assertLessEqual(abs(Decimal(value["value"]) - truth), Decimal(value["error"]))

    def test_proofs_end(self):
        """Level water, tiny heights and long fractions: answered or undecided, with what is open, at any
        number of bits within seconds (a minute here, for a busy machine)."""
        tiny, long = "1/1000000000000000000000000000000", "2500000000000000000000000000001/1" + 30 * "0"
        scenes = [
            (f"outline: [[0, 0], [13/3, {tiny}], [13/3, {long}], [0, {long}]]",
             "seismic: {horizontal: -1/5, vertical: 3/2}, water: {height: 1/100000000000000000000, uplift: "
             "true, stays_level: true, unit_weight_kn_m3: 2700}, bond_kpa: 27", 30, 89),
            ("ellipse: {width: 10, height: 3, flat: 5}",
             "water: {height: 1, uplift: false, stays_level: true, unit_weight_kn_m3: 26}, cohesion_kpa: 26",
             30, 0),
            ("slab: {width: 2, height: 4}", "water: {height: 1/2, stays_level: true}", 0, 45)]
        for block, loads, friction, tilt in scenes:
            for digits in (9, 30):
                self.path.write_text(
                    f"topple: 1\nlength_unit: m\nblock: {{{block}, unit_weight_kn_m3: 26}}\n"
                    f"base: {{mated: true}}\nloads: {{{loads}}}\nfriction_angle_deg: {friction}\n"
                    f"tilt: {{towards: both, angle_deg: {tilt}}}\n")
                status, _, err = run("solve", f"--digits={digits}", self.path, timeout=60)
                self.assertIn(status, (0, 4), err)
                self.assertEqual("undecided" in err, status == 4, err)

    def test_random(self):
        """The limit as tilted on, and that of tilting back, from which forces hold."""
        decided, known, backs = 0, 0, 0
        for seed in range(SEED, SEED + SCENES):
            scene = Scene(random.Random(seed))
            with self.subTest(seed=seed, scene=scene.text()):
                limit = self.solve(scene.text())
                decided += self.compare(limit, scene.truth(scene.towards))
                back = scene.truth("right" if scene.towards == "left" else "left")
                value = limit["holds_from_deg"]
                if back == (None, None):
                    self.assertIsNone(value)
                elif back is not None:
                    backs += 1
                    if value is None:
                        continue
                    known += 1
                    off = abs(Decimal(value["value"]) + back[0])
                    self.assertLessEqual(off, Decimal(value["error"]))
        self.assertGreaterEqual(decided, 0.99 * SCENES)
        self.assertGreaterEqual(known, 0.99 * backs)


    def test_strength_reduction(self):
        """Divided by the least factor within its bound the strength holds the block at the tilt, divided
        by the greatest it does not."""
        numbers = 0
        for seed in range(SEED, SEED + SCENES // 5):
            draw = random.Random(-seed)
            scene = Scene(draw)
            truth = scene.truth(scene.towards)
            if truth is None or truth[0] is None:
                continue
            tilt = round(Fraction(truth[0]) * draw.randint(1, 99) / 100, 3)
            with self.subTest(seed=seed, scene=scene.text(tilt)):
                fos = self.solve(scene.text(tilt))["fos"]
                if fos is None:
                    continue
                numbers += 1
                for side in (-1, 1):
                    factor = Decimal(fos["value"]) + side * Decimal(fos["error"])
                    limit = scene.truth(scene.towards, factor)
                    if limit is None:  # the anchor throws it up-dip from level ground
                        continue
                    holds = limit[0] is None or limit[0] >= exact.decimal(tilt)
                    self.assertEqual(holds, side < 0)
        self.assertGreater(numbers, SCENES // 20)


if __name__ == "__main__":
    main()
