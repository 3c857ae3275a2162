# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`place: rest`: a block that does not fit its base is set down on it.

Of 63 exact resting poses that were rounded to twelve decimals the program refused all: a measured block could not be put
on a measured profile. The pose is found exactly now; a brute force in small steps (rest_oracle.py) finds the same."""

import math
import pathlib
import random
import tempfile
import unittest

import rest_oracle
from harness import main, rounds, run, solve
from rest_case import random_block, random_profile, text

SEED = 16
SCENES = rounds(48, 160)


class Rest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, block, profile, more="", unit="m"):
        self.path.write_text(f"topple: 1\nlength_unit: {unit}\nblock: {{outline: {text(block)}}}\n"
                             f"base: {{profile: {text(profile)}, place: rest}}\nfriction_angle_deg: 40\n{more}",
                             encoding="utf-8")

    def rested(self, block, profile, **options):
        self.write(block, profile, **options)
        return solve(self.path)["cases"][0]

    def refused(self, block, profile, **options):
        self.write(block, profile, **options)
        status, out, err = run("solve", self.path)
        self.assertIn(status, (3, 4))
        self.assertEqual(out, "")
        return err

    def test_brute_force(self):
        """The same pose within what the steps leave, ten times what the oracle takes for touching; and the same end of
        those that do not rest."""
        draw = random.Random(SEED)
        seen = {}
        for number in range(SCENES):
            block, profile = random_block(draw), random_profile(draw)
            how, outline = rest_oracle.rest(block, profile)
            seen[how] = seen.get(how, 0) + 1
            if how == "unclear":
                continue
            with self.subTest(number=number, block=block, profile=profile):
                if how == "rests":
                    case = self.rested(block, profile)
                    x0, y0 = rest_oracle.centroid(block)
                    x1, y1 = rest_oracle.centroid(outline)
                    self.assertAlmostEqual(case["rest"]["moved_x_m"]["value"], x1 - x0, delta=10 * rest_oracle.NEAR)
                    self.assertAlmostEqual(case["rest"]["moved_y_m"]["value"], y1 - y0, delta=10 * rest_oracle.NEAR)
                    self.assertAlmostEqual(case["block"]["centroid_x_m"]["value"], x1, delta=10 * rest_oracle.NEAR)
                    self.assertGreater(case["contact"]["points"] + case["contact"]["facets"], 0)
                else:
                    self.assertIn({"beside": "beside its base", "rolls off": "rolls off its base"}[how],
                                  self.refused(block, profile))
        self.assertGreater(seen["rests"], SCENES // 2)
        self.assertLess(seen.get("unclear", 0), SCENES // 10)

    def test_it_rolls_off(self):
        """From a narrow base most blocks fall, to either side."""
        draw = random.Random(SEED + 3)
        left = 0
        count = rounds(8, 20)
        for number in range(count):
            shift = draw.choice([-1.5, 1.5])
            block = [(x + shift, y) for x, y in random_block(draw)]
            profile = [(-1.0, 0.0), (0.0, 0.2), (1.0, 0.0)]
            with self.subTest(number=number, block=block):
                how, _ = rest_oracle.rest(block, profile)
                if how in ("rolls off", "beside"):
                    left += 1
                    self.assertIn({"beside": "beside its base", "rolls off": "rolls off its base"}[how],
                                  self.refused(block, profile))
        self.assertGreater(left, 2 * count // 5)

    def test_mirror_shift_unit(self):
        """A mirrored scene rests mirrored, a shifted one shifted, one in millimetres the same."""
        draw = random.Random(SEED + 1)
        done = 0
        while done < rounds(6, 25):
            block, profile = random_block(draw), random_profile(draw)
            if rest_oracle.rest(block, profile)[0] != "rests":
                continue
            done += 1
            with self.subTest(block=block, profile=profile):
                own = self.rested(block, profile)["rest"]
                mirror = self.rested([(-x, y) for x, y in block[::-1]], [(-x, y) for x, y in profile[::-1]])["rest"]
                shifted = self.rested([(x + 1024, y - 512) for x, y in block],
                                      [(x + 1024, y - 512) for x, y in profile])["rest"]
                small = self.rested(block, profile, unit="mm")["rest"]
                self.near(own, mirror, -1, "turned_deg", "moved_x_m")
                self.near(own, mirror, 1, "moved_y_m")
                self.near(own, shifted, 1, "turned_deg", "moved_x_m", "moved_y_m", "margin_left_m", tolerance=1e-9)
                self.near(own, small, 1, "turned_deg")
                self.near(own, small, 1e-3, "moved_x_m", "moved_y_m", "margin_right_m")

    def test_far_scales(self):
        """In lengths whose products no double holds a block rests as in metres; it rolled off its base once."""
        draw = random.Random(SEED + 5)
        for number in range(rounds(3, 8)):
            block, profile = random_block(draw), [(-20.0, 0.0)] + random_profile(draw) + [(20.0, 0.0)]
            own = self.rested(block, profile)["rest"]
            for power in ("e150", "e-150", "e290", "e-290"):
                with self.subTest(number=number, power=power):
                    scaled = [[(float(f"{x}{power}"), float(f"{y}{power}")) for x, y in line]
                              for line in (block, profile)]
                    rest = self.rested(*scaled)["rest"]
                    self.assertEqual(rest["turns"], own["turns"])
                    self.near(own, rest, 1, "turned_deg")

    def near(self, own, other, factor, *keys, tolerance=0.0):
        for key in keys:
            bound = own[key]["error"] + other[key]["error"] + tolerance + 1e-15 * abs(own[key]["value"])
            self.assertLessEqual(abs(other[key]["value"] - factor * own[key]["value"]), bound, key)

    def test_one_wavelength_on(self):
        """A block moved by a whole wavelength of a regular base rests as before."""
        teeth = [(float(k), 0.25 * (k % 2)) for k in range(-12, 13)]
        block = [(0.3, 3.0), (2.1, 2.5), (2.9, 4.0), (0.7, 4.5)]
        own = self.rested(block, teeth)
        moved = self.rested([(x + 2, y) for x, y in block], teeth)
        self.near(own["rest"], moved["rest"], 1, "turned_deg", "moved_x_m", "moved_y_m")
        self.near(own["toppling"], moved["toppling"], 1, "critical_angle_deg")

    def test_energy_is_least(self):
        """At rest no small turn about a point of contact lets the centroid down without an overlap."""
        draw = random.Random(SEED + 2)
        done = 0
        while done < rounds(5, 20):
            block, profile = random_block(draw), random_profile(draw)
            how, _ = rest_oracle.rest(block, profile)
            if how != "rests":
                continue
            done += 1
            with self.subTest(block=block, profile=profile):
                self.check_energy(block, profile)

    def check_energy(self, block, profile):
        r = self.rested(block, profile)["rest"]
        x, y = rest_oracle.centroid(block)
        placed = [(px + r["moved_x_m"]["value"], py + r["moved_y_m"]["value"]) for px, py in
                  rest_oracle.turned(block, (x, y), math.radians(r["turned_deg"]["value"]))]
        g = rest_oracle.centroid(placed)
        bottom = [(profile[-1][0], -99.0), (profile[0][0], -99.0)]
        rock = profile + bottom
        self.assertLess(rest_oracle.deepest(placed, rock), 1e-12)
        points = rest_oracle.contacts(placed, profile, rock, 1e-11)
        self.assertGreaterEqual(len(points), 2)
        for about in points:
            way = -1 if g[0] > about[0] else 1
            self.assertGreater(rest_oracle.deepest(rest_oracle.turned(placed, about, way * 1e-5), rock), 1e-9)

    def test_fine_profile(self):
        """A block of many vertices on a profile of many points, most of which the search passes over: nothing overlaps
        at rest, and no small turn lets the centroid down."""
        draw = random.Random(SEED + 4)
        for points in rounds((300, 1000), (300, 1000, 1000, 3000)):
            block = [(round(3 * (1 + 0.1 * draw.random()) * math.cos(2 * math.pi * k / 50), 4),
                      round(5 + 2 * (1 + 0.1 * draw.random()) * math.sin(2 * math.pi * k / 50), 4)) for k in range(50)]
            height, profile = 0.0, []
            for k in range(points):
                height = 0.9 * height + draw.uniform(-0.1, 0.1)
                profile.append((round(-10 + 20 * k / points, 5), round(height, 5)))
            with self.subTest(points=points):
                self.check_energy(block, profile)

    def test_flat_on_flat(self):
        """A face comes to lie on a level base along all of its length, at whatever angle it began: exactly, though the
        sines of the turn are no fractions."""
        block = [(0.0, 1.0), (2.0, 1.7), (1.3, 3.0), (-0.4, 2.2)]
        case = self.rested(block, [(-9.0, 0.0), (9.0, 0.0)])
        self.assertEqual((case["contact"]["facets"], case["contact"]["points"]), (1, 0))
        self.assertAlmostEqual(case["contact"]["length_m"]["value"], math.hypot(2, 0.7), delta=1e-15)
        self.assertAlmostEqual(case["rest"]["turned_deg"]["value"], -math.degrees(math.atan2(0.7, 2)), delta=1e-14)
        self.assertEqual(case["rest"]["turns"], 1)

    def test_shift(self):
        """`shift` says over which part of the profile the block is set down: as its coordinates moved there by hand do."""
        draw = random.Random(SEED + 7)
        done = 0
        while done < rounds(5, 20):
            block, profile, shift = random_block(draw), random_profile(draw), round(draw.uniform(-3, 3), 3)
            moved = [(round(x + shift, 3), y) for x, y in block]
            if rest_oracle.rest(moved, profile)[0] != "rests":
                continue
            done += 1
            with self.subTest(block=block, profile=profile, shift=shift):
                by_hand = self.rested(moved, profile)
                self.write(block, profile)
                self.path.write_text(self.path.read_text().replace("place: rest", f"place: rest, shift: {shift}"))
                own = solve(self.path)["cases"][0]
                along = own["rest"].pop("moved_x_m")["value"], by_hand["rest"].pop("moved_x_m")["value"]
                self.assertAlmostEqual(along[0], along[1] + shift, delta=1e-9)
                for key in by_hand:
                    if key != "effects":
                        self.assertEqual(own[key], by_hand[key], key)

    def test_shift_refused(self):
        block, ground = [(0.0, 1.0), (2.0, 1.0), (1.0, 3.0)], [(-5.0, 0.0), (5.0, 0.0)]
        self.write(block, ground)
        text_of_it = self.path.read_text()
        for base, says in (("place: all, shift: 1", "takes all shifts"), ("shift: 1", "set down again by 'place: rest'"),
                           ("place: as_given, shift: 1", "set down again by 'place: rest'"),
                           ("place: rest, shift: 20", "falls beside its base"), ("place: rest, shift: a", "'a'")):
            self.path.write_text(text_of_it.replace("place: rest", base))
            status, out, err = run("solve", self.path)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(says, err)
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\nbase: {mated: true, shift: 1}\n")
        self.assertIn("'joint: {shift: …}'", run("solve", self.path)[2])

    def test_as_it_was(self):
        """`as_given` is as without the key, and a block that rests already stays where it is."""
        block, profile = [(0.0, 0.0), (2.0, 0.0), (2.0, 3.0), (0.0, 3.0)], [(-5.0, 0.0), (5.0, 0.0)]
        case = self.rested(block, profile)
        self.assertEqual((case["rest"]["turns"], case["rest"]["moved_y_m"]["value"]), (0, 0))
        text_of_it = self.path.read_text(encoding="utf-8")
        self.path.write_text(text_of_it.replace("place: rest", "place: as_given"), encoding="utf-8")
        given = solve(self.path)["cases"][0]
        self.path.write_text(text_of_it.replace(", place: rest", ""), encoding="utf-8")
        unsaid = solve(self.path)["cases"][0]
        self.assertNotIn("rest", given)
        self.assertEqual(given["toppling"], unsaid["toppling"])
        self.assertEqual(given["toppling"], case["toppling"])

    def test_loads_go_with_the_block(self):
        """Set down by hand, where it comes to rest without turning, it bears the same loads."""
        profile = [(-5.0, 0.0), (5.0, 0.0)]
        loads = ("loads: {{seismic: {{horizontal: 0.1}}, surcharges: [{{from: [2, {0}], to: [0, {0}], kpa: 3}}], "
                 "anchors: [{{at: [2, {1}], direction_deg: 200, force_kn: 5}}]}}\ntilt: {{angle_deg: 5}}\n")
        high = [(0.0, 1.5), (2.0, 1.5), (2.0, 4.5), (0.0, 4.5)]
        low = [(x, y - 1.5) for x, y in high]
        weight = "unit_weight_kn_m3: 25"
        self.write(high, profile, more=loads.format("4.5", "2.5"))
        self.path.write_text(self.path.read_text().replace("]]}\nbase", f"]], {weight}}}\nbase"))
        rested = solve(self.path)["cases"]
        self.write(low, profile, more=loads.format("3", "1"))
        self.path.write_text(self.path.read_text().replace("]]}\nbase", f"]], {weight}}}\nbase")
                             .replace(", place: rest", ""))
        given = solve(self.path)["cases"]
        for own, other in zip(rested, given):
            for key in ("toppling", "limit", "onset", "governing_fos"):
                self.assertEqual(own.get(key), other.get(key), key)

    def test_refused(self):
        block = [(0.0, 1.0), (2.0, 1.0), (1.0, 3.0)]
        ground = [(-5.0, 0.0), (5.0, 0.0)]
        self.assertIn("falls beside its base", self.refused([(x + 20, y) for x, y in block], ground))
        self.assertIn("rolls off its base", self.refused([(x + 4.5, y) for x, y in block], ground))
        # it turns about the end of the ground until its bottom lies against that, upright, and falls down along it
        self.assertIn("after 1 turn, turned by -90° in all with its centroid in (5.66666667, -0.5) m, it goes over (5, -1.5) m",
                      self.refused([(x + 4.5, y) for x, y in block], ground))
        self.assertIn("balances on (1, 0)", self.refused([(1.0, 1.0), (2.0, 3.0), (0.0, 3.0)], ground))
        self.write(block, ground, more="block_is: wrong\n")
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                             "base: {mated: true, place: rest}\n")
        self.assertIn("a mated base fits its block already", run("solve", self.path)[2])
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {ellipse: {width: 1, height: 2, flat: 0.5}}\n"
                             "base: {profile: [[0, 0], [1, 0]], place: rest}\n")
        self.assertIn("is for straight edges", run("solve", self.path)[2])
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                             "base: {profile: [[0, 0], [1, 0]], place: down}\n")
        self.assertIn("place must be 'rest'", run("solve", self.path)[2])
        self.write(block, ground)
        self.assertIn("60 digits at most", run("solve", "--digits", "61", self.path)[2])


if __name__ == "__main__":
    main()
