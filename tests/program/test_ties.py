# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Pivots that tie: the least safe governs, and a mirror image says the same of the other side.

Of several admissible pivots about which a block begins to move at the same tilt, or at none, or stands at none, the one
with the least factor of safety at the scene's tilt governs; of those alike in that too the one furthest down-dip.
Neither the order of the vertices nor the number of digits asked for may matter. The truth is the mirror image,
built here in exact rationals, and the list of pivots itself. TOPPLE_ROUNDS multiplies the number of scenes."""

import json
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, ROUNDS, main, run


def points(of):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in of) + "]"


def flipped(of):
    return [(-x, y) for x, y in reversed(of)]


class Scene:
    """A block on teeth that its base touches here and there, pressed on from above, and its mirror image."""

    def __init__(self):
        self.under = [(Fraction(0), Fraction(0))]
        high = True
        for _ in range(random.randint(2, 7)):
            x, _ = self.under[-1]
            self.under.append((x + Fraction(random.randint(2, 10), 4), Fraction(random.randint(1, 6), 3) if high else Fraction(0)))
            high = not high
        width = self.under[-1][0]
        self.top = Fraction(random.randint(10, 40), 4) + 2
        self.outline = self.under + [(width, self.top), (Fraction(0), self.top)]
        self.base = [(x, y - random.choice([0, 0, Fraction(1, 3)])) for x, y in self.under]
        k = random.randrange(len(self.base))
        self.base[k] = self.under[k]
        pressed = random.choice([0, 100, 26000])
        share = sorted(random.sample(range(9), 2))
        at = [width * Fraction(s, 8) for s in share]
        self.pressure = ((at[1], self.top), (at[0], self.top), pressed)
        self.anchor = (random.choice(self.outline), random.choice([0, 45, 90, 180, -90, -45]),
                       random.choice([0, 10, 5000]), random.choice(["true", "false"]))
        self.seismic = (random.choice([0, Fraction(1, 10), 2]), random.choice([0, Fraction(1, 5), -1]))
        self.tilt = random.choice([1, 20, 45, 89])

    def text(self, mirrored):
        outline, base = self.outline, self.base
        first, last, kpa = self.pressure
        (x, y), direction, force, passive = self.anchor
        if mirrored:
            outline, base = flipped(outline), flipped(base)
            first, last = (-last[0], last[1]), (-first[0], first[1])
            x, direction = -x, 180 - direction
        return ("topple: 1\nlength_unit: m\n"
                f"block: {{outline: {points(outline)}, unit_weight_kn_m3: 26}}\nbase: {{profile: {points(base)}}}\n"
                f"loads:\n  pressures: [{{from: {points([first])[1:-1]}, to: {points([last])[1:-1]}, kpa: {kpa}}}]\n"
                f"  anchors: [{{at: [{x}, {y}], direction_deg: {direction}, force_kn: {force}, passive: {passive}}}]\n"
                f"  seismic: {{horizontal: {self.seismic[0]}, vertical: {self.seismic[1]}}}\n"
                f"tilt: {{towards: both, angle_deg: {self.tilt}}}\n")


class Ties(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def solve(self, text, digits=9):
        self.text = text
        self.path.write_text(text)
        status, out, err = run("solve", "--json", "--digits", digits, self.path)
        self.assertIn(status, (0, 3, 4), text + err)
        return (json.loads(out)["cases"] if out else None), err

    def same(self, one, other):
        if one is None or other is None:
            self.assertEqual(one, other, self.text)
        else:
            slack = one["error"] + other["error"] + 1e-13 * abs(one["value"])
            self.assertLessEqual(abs(one["value"] - other["value"]), slack, self.text)

    def check_least(self, case):
        """The governing pivot against the list."""
        admissible = [p for p in case["pivots"] if p["admissible"]]
        if not admissible:
            self.assertIsNone(case["toppling"])
            return 0

        def angle(p):
            if p["critical_angle_deg"] is None:
                return {"never": 180.0, "always": -180.0}[p["critical_angle_is"]]
            return p["critical_angle_deg"]["value"]

        least = min(map(angle, admissible))
        tied = [p for p in admissible if abs(angle(p) - least) <= 1e-11]
        own = case["pivots"][case["toppling"]["pivot"]]
        self.assertIn(own, tied, self.text)

        def factor(p):
            return float("inf") if p["fos"] is None else p["fos"]["value"]

        least = min(map(factor, tied))
        self.assertLessEqual(factor(own), least + 1e-11 * abs(least), self.text)
        return len(tied) > 1

    def test_a_line_through_the_pivot(self):
        """An anchor at 45 degrees whose line passes through the toe overturns nothing. Through a sharp corner its
        moment is zero exactly, and there is nothing to say; through the tangent point of a rounded one, 0.1 m from
        the corner, it is a ball about zero that no bits part from it: zero up to its width, and the report says so. A nanometre off there
        is nothing to say either, nor without the anchor."""
        anchored = ("topple: 1\nlength_unit: m\n"
                    "block: {outline: [[0, 0], [2, 0], [2, 3], [0, 3]], ROUNDED, unit_weight_kn_m3: 26}\n"
                    "loads: {anchors: [{at: [1.1, HEIGHT], direction_deg: 225, force_kn: 10}]}\n"
                    "tilt: {towards: left, angle_deg: 10}\n")
        rounded, sharp = "rounded: {corners: [{at: [0, 0], radius: 0.1}]}", "thickness: 1"
        for corner, height, bits in ((rounded, "1", 160), (rounded, "1.000000001", None), (rounded, "0.999999999", None),
                                     (sharp, "1.1", None), (sharp, "1.100000001", None)):
            self.path.write_text(anchored.replace("HEIGHT", height).replace("ROUNDED", corner))
            found = json.loads(run("solve", "--json", self.path)[1])
            self.assertEqual(found.get("zero_bits"), bits, height)
            moment = {load["name"]: load["moment_nm"] for load in found["cases"][0]["loads"]}["anchor"]
            self.assertEqual(moment["value"] == 0, height in ("1", "1.1"), height)
            self.assertEqual(moment["error"] == 0, height == "1.1", height)
            self.assertLess(moment["error"], 1e-12, height)
            said = "A decision above takes as zero what 160 bits cannot distinguish from zero." in run("solve", self.path)[1]
            self.assertEqual(said, bits is not None, height)
        self.path.write_text("\n".join(line for line in anchored.replace("ROUNDED", sharp).splitlines()
                                       if not line.startswith("loads")))
        self.assertNotIn("zero_bits", json.loads(run("solve", "--json", self.path)[1]))

    def test_mirror_images(self):
        """Random teeth under random loads, strong ones among them, which keep a block on several pivots at
        every tilt or on none."""
        random.seed(81)
        ties = 0
        for _ in range(250 * ROUNDS):
            scene = Scene()
            one, refused = self.solve(scene.text(False))
            other, also_refused = self.solve(scene.text(True))
            self.assertEqual(one is None, other is None, refused + also_refused)
            if one is None:
                continue
            for case, image in zip(one, reversed(other)):
                ties += self.check_least(case)
                self.check_least(image)
                self.assertEqual(len(case["pivots"]), len(image["pivots"]))
                for p, q in zip(case["pivots"], reversed(image["pivots"])):
                    self.assertEqual((p["admissible"], p.get("critical_angle_is")),
                                     (q["admissible"], q.get("critical_angle_is")), self.text)
                    self.same(p["critical_angle_deg"], q["critical_angle_deg"])
                    self.same(p["fos"], q["fos"])
                self.assertEqual(case["mechanism"], image["mechanism"], self.text)
                if case["toppling"] is None:
                    self.assertIsNone(image["toppling"])
                    continue
                self.assertEqual(case["toppling"]["pivot"], len(case["pivots"]) - 1 - image["toppling"]["pivot"], self.text)
                self.assertEqual(case["toppling"]["tie"], image["toppling"]["tie"], self.text)
                self.same(case["toppling"]["fos"], image["toppling"]["fos"])
        self.assertGreater(ties, 10 * ROUNDS)

    def test_in_line_with_the_centroid(self):
        """Two admissible pivots in line with the centroid, as in tests/hard/pivots_tie.yaml: their angles tie
        exactly, by the weight alone and with whatever else acts in the centroid. Both factors are the same, so
        the pivot down-dip governs: at any number of digits, and in the mirror image."""
        lines = (ROOT / "tests" / "hard" / "pivots_tie.yaml").read_text().splitlines()
        plain = "\n".join(line for line in lines if not line.startswith(("#", "tilt"))) + "\n"
        image = plain
        for key in ("block:\n  outline: ", "parts: [{outline: ", "profile: "):
            start = image.index(key) + len(key)
            end = image.index("]]", start) + 2
            image = image[:start] + points(flipped([tuple(map(Fraction, map(str, p))) for p in json.loads(image[start:end])])) + image[end:]
        for loads in ("", "loads: {seismic: {horizontal: 0}}\n", "loads: {seismic: {horizontal: 1/7, vertical: -1/3}}\n"):
            for tilt in (10, 30, 60):
                for digits in (1, 9, 12, 30, 60):
                    for text, towards, down_dip in ((plain, "left", min), (image, "right", max)):
                        cases, err = self.solve(f"{text}{loads}tilt: {{towards: {towards}, angle_deg: {tilt}}}\n", digits)
                        self.assertEqual(err, "", self.text)
                        case = cases[0]
                        tied = [k for k, p in enumerate(case["pivots"]) if p["admissible"]]
                        self.assertEqual(len(tied), 2)
                        self.assertTrue(case["toppling"]["tie"], self.text)
                        self.assertEqual(case["toppling"]["pivot"], down_dip(tied), self.text)
                        self.check_least(case)

    def test_loads_of_nothing(self):
        """A cube on 45 degrees of friction slides and topples at 45 degrees, and by k_h at 45 - atan(k_h): loads
        of no size leave that tie what it is."""
        for loads in ("cohesion_kpa: 0", "bond_kpa: 0", "cohesion_kpa: 0, bond_kpa: 0", "seismic: {horizontal: 0}",
                      "water: {height: 0, stays_level: true, uplift: true}", "seismic: {horizontal: 1/7}, cohesion_kpa: 0",
                      "anchors: [{at: [0, 0], direction_deg: 30, force_kn: 0}], bond_kpa: 0"):
            for digits in (1, 9, 30):
                cases, err = self.solve(
                    "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 2}, unit_weight_kn_m3: 26}\n"
                    f"base: {{mated: true}}\nfriction_angle_deg: 45\nloads: {{{loads}}}\n"
                    "tilt: {towards: both, angle_deg: 20}\n", digits)
                for case in cases:
                    self.assertEqual(case["first"]["mechanism"], "slides and topples", self.text)
                    self.assertEqual({case["limit"]["mechanism"], case["limit"]["tied_with"]}, {"slides", "topples"})


if __name__ == "__main__":
    main()
