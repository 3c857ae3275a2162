# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Inputs that once ran for minutes or filled the memory: an answer, or a message that says what was too
dear and what would help. The limits here are generous: they tell an end from a hang, and memory that is
bounded from memory that is not."""

import json
import math
import os
import pathlib
import random
import resource
import subprocess
import tempfile
import time
import unittest
from fractions import Fraction

from harness import main

TOPPLE = os.environ["TOPPLE"]
SECONDS = 120  # a slow machine under a sanitizer; the budget is 5 s on a quiet one
BYTES = 1 << 30


def limited():
    """The address space of the program; a sanitizer's own is larger than any machine."""
    if "sanitize" not in TOPPLE:
        resource.setrlimit(resource.RLIMIT_AS, (2 * BYTES, 2 * BYTES))


def run(scene, *arguments):
    """Exit status, standard output and errors."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "scene.yaml")
        path.write_text(scene, encoding="utf-8")
        done = subprocess.run([TOPPLE, *arguments, str(path)], capture_output=True, text=True,
                              timeout=SECONDS, preexec_fn=limited, check=False)
    return done.returncode, done.stdout, done.stderr


def rough_slab(count, number):
    """`count` vertices below and above, each coordinate written by `number`."""
    lower = [(k + random.random() / 2, random.random()) for k in range(count // 2)]
    upper = [(count / 2 - k - random.random() / 2, 300 + random.random()) for k in range(count // 2)]
    outline = ", ".join(f"[{number(x)}, {number(y)}]" for x, y in lower + upper)
    return f"""topple: 1
length_unit: m
block:
  outline: [{outline}]
base: {{mated: true}}
friction_angle_deg: 30
tilt: {{towards: left, angle_deg: 5}}
"""


def coprime(value):
    """A fraction whose denominator of 15 digits has hardly a factor in common with another."""
    denominator = random.randrange(10**14, 10**15) | 1
    return f"{round(value * denominator)}/{denominator}"


class Coordinates(unittest.TestCase):
    """Exact coordinates share a denominator, whose digits grow with each vertex that brings its own."""

    def setUp(self):
        random.seed(12)

    def test_hundreds_of_coprime_denominators_are_solved(self):
        status, _, _ = run(rough_slab(300, coprime), "solve")
        self.assertEqual(status, 0)

    def test_thousands_are_refused_where_they_pass_the_budget(self):
        status, out, err = run(rough_slab(3000, coprime), "solve")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("common multiple", err)
        self.assertIn("round the fractions", err)

    def test_their_account_by_elements_is_refused_sooner(self):
        status, out, err = run(rough_slab(1000, coprime), "solve", "--elements")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("leave out --elements", err)

    def test_as_many_decimals_are_solved(self):
        status, _, _ = run(rough_slab(3000, lambda value: f"{value:.15f}"), "solve", "--elements")
        self.assertEqual(status, 0)


def row_of_slabs(count, hang):
    """Slabs of 1 m side by side on level ground that ends below the last but so many, tilted by 5 degrees."""
    return ("topple: 1\nlength_unit: m\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 5}\nblocks:\n"
            f"  - {{name: ground, ground: true, outline: [[-9, -1], [{count - hang}, -1], [{count - hang}, 0], [-9, 0]]}}\n"
            + "".join(f"  - {{name: b{k}, slab: {{width: 1, height: 1}}, at: [{k}, 0]}}\n" for k in range(count)))


class Rows(unittest.TestCase):
    """A thousand slabs at rest took 0.2 s; with ten that hang by their sides 8 s, with 500 more than 25. The ones that hang fall, as nothing
    presses them; those at rest slide at tan 30 / tan 5 = 6.6."""

    def test_slabs_that_hang(self):
        for count, hang, verdict in ((12, 0, "can be held"), (60, 7, "collapses"), (1010, 10, "collapses"), (1500, 500, "collapses")):
            begun = time.monotonic()
            status, out, err = run(row_of_slabs(count, hang), "solve", "--json")
            self.assertEqual(status, 0, err)
            own = json.loads(out)
            self.assertIn(own["cases"][0]["verdict"], (verdict, "stands" if hang == 0 else verdict), (count, hang))
            self.assertLess(time.monotonic() - begun, 60, (count, hang))  # 2 s on a quiet machine
            if hang == 0:
                factor = own["governing_fos"]
                truth = math.tan(math.radians(30)) / math.tan(math.radians(5))
                least, most = (factor.get("at_least", 0), factor.get("at_most", math.inf)) if factor["fos"] is None else (factor["fos"]["value"],) * 2
                self.assertLessEqual(least, truth + 1e-4)
                self.assertGreaterEqual(most, truth - 1e-4)


class Proofs(unittest.TestCase):
    """Limits whose proof climbed in vain: they end, at few digits and at many, and what is decided is true."""

    def limits(self, scene, digits):
        """Of each direction, where the report came; what is undecided is told."""
        status, out, err = run(scene, "solve", "--json", "--digits", str(digits))
        self.assertIn(status, (0, 4), err)
        self.assertEqual("undecided" in err, status == 4, err)
        return [case["limit"] for case in json.loads(out)["cases"]] if out else []

    def test_level_water_and_cohesion(self):
        """Half an ellipse on its flat b = 5, water of 26 kN/m3 that stays 1 m high, both ways alike. It slides
        where W sin a + 13 / cos a rises through W cos a tan 30 + 26 b; W = 26 A. The area is that of the
        part of the ellipse above the chord."""
        for digits in (9, 30):
            scene = """topple: 1
length_unit: m
block: {ellipse: {width: 10, height: 3, flat: 5}, unit_weight_kn_m3: 26}
base: {mated: true, beyond: {left: 0, right: 0}}
loads: {water: {height: 1, uplift: false, stays_level: true, unit_weight_kn_m3: 26}, cohesion_kpa: 26}
friction_angle_deg: 30
tilt: {towards: both, angle_deg: 0}
"""
            # half axes 5 and r, cut where the chord is 5: at y = -r sqrt(3)/2
            r = 1.5
            area = 5 * r * (math.pi - math.pi / 6 + math.sqrt(3) / 4)
            for limit in self.limits(scene, digits):
                self.assertEqual(limit["mechanism"], "slides")
                a = math.radians(limit["critical_angle_deg"]["value"])
                driving = 26 * area * math.sin(a) + 13 / math.cos(a)
                held = 26 * area * math.cos(a) * math.tan(math.pi / 6) + 26 * 5
                self.assertAlmostEqual(driving, held, delta=1e-9 * held)

    def test_water_without_friction(self):
        """Without friction any water pushes a slab off a level base: it is held at a single tilt up-dip, if
        at all, and never said to hold from level on."""
        for digits in (9, 30):
            for limit in self.limits("""topple: 1
length_unit: m
block: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}
base: {mated: true}
loads: {water: {height: 1/2, stays_level: true}}
friction_angle_deg: 0
tilt: {towards: both, angle_deg: 45}
""", digits):
                self.assertNotEqual(limit["mechanism"], "interlocked")
                if limit["critical_angle_deg"]:
                    self.assertLess(limit["critical_angle_deg"]["value"], 0)

    def test_long_fractions(self):
        """A sole that rises by 1e-30, an arc, a hole of numbers of a hundred digits, and shaking, water, an
        anchor and a bond, whose moments nearly cancel: minutes once, at 89 degrees."""
        tiny, top = Fraction(1, 10**30), Fraction(5, 2) + Fraction(1, 10**30)
        left, right = Fraction(13, 24), Fraction(13, 8) + Fraction(1, 10**100)
        low, high = top / 8, top * 7 / 8
        scene = f"""topple: 1
length_unit: m
block:
  outline: [[0, 0], [13/3, {tiny}], [13/3, {top}], [0, {top}]]
  arcs: [{{from: [13/3, {top}], bulge: 1/2}}]
  holes: [[[{left}, {low}], [{right}, {low}], [{right}, {high}], [{left}, {high}]]]
  unit_weight_kn_m3: 27
base: {{mated: true}}
loads:
  seismic: {{horizontal: -1/5, vertical: 3/2}}
  water: {{height: 1e-20, uplift: true, stays_level: true, unit_weight_kn_m3: 2700}}
  surcharges: [{{from: [0, {top}], to: [0, 0], kpa: 5}}]
  anchors: [{{at: [13/3, {tiny}], direction_deg: -30, force_kn: 90, passive: true}}]
  bond_kpa: 27
friction_angle_deg: 30
tilt: {{towards: both, angle_deg: 89}}
"""
        for digits in (9, 30):
            self.limits(scene, digits)

    def test_hundreds_of_collinear_facets(self):
        """A slab of 400 pieces of 1 m with cohesion slides where sin(a - phi) = c b cos(phi) / W, each piece
        as the whole."""
        under = ", ".join(f"[{k}, 0]" for k in range(401))
        for digits in (9, 30):
            for limit in self.limits(f"""topple: 1
length_unit: m
block: {{outline: [{under}, [400, 100], [0, 100]], unit_weight_kn_m3: 26}}
base: {{mated: true}}
loads: {{cohesion_kpa: 5}}
friction_angle_deg: 30
tilt: {{towards: both, angle_deg: 10}}
""", digits):
                angle = 30 + math.degrees(math.asin(5 * math.cos(math.pi / 6) / 2600))
                self.assertAlmostEqual(limit["critical_angle_deg"]["value"], angle, delta=1e-11)

    def test_onset_of_a_bowl(self):
        """An arc whose facets all bound the motions, undecided once from 10^4 facets on; and with cohesion and
        a bond of it, each motion took every facet. The finer the parabola y = x^2 / 4 is drawn, the nearer
        its onset comes to that of the arc: two steps apart by a quarter of the step before."""
        for loads, counts in (("", (4500, 9000, 18000)), ("{cohesion_kpa: 5, bond_kpa: 2}", (250, 500, 1000))):
            angles = []
            for count in counts:
                under = ", ".join(f"[{x}, {x * x / 4}]" for x in (Fraction(2 * k, count) - 1 for k in range(count + 1)))
                status, out, err = run(f"""topple: 1
length_unit: m
block: {{outline: [{under}, [1, 1], [-1, 1]], thickness: 1, unit_weight_kn_m3: 26}}
base: {{mated: true}}
{"loads: " + loads if loads else ""}
friction_angle_deg: 30
tilt: {{towards: left}}
""", "solve", "--json", "--pivots=governing")
                self.assertEqual(status, 0, err)
                onset = json.loads(out)["cases"][0]["onset"]
                self.assertEqual(onset["kind"], "angle")
                angles.append(onset["critical_angle_deg"]["value"])
            self.assertLess(abs(angles[2] - angles[1]), 0.75 * abs(angles[1] - angles[0]) + 1e-6)
            self.assertLess(abs(angles[2] - angles[1]), 0.1)


if __name__ == "__main__":
    main()
