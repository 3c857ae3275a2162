# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`place: all`: every resting pose of a block on its profile, and from which starting positions it comes to each.

Where a block was set down decided in which pose it was judged, and nobody saw the others. A brute force in small steps
(rest_oracle.py) comes to the same ends from everywhere; closed forms, and `place: rest` next to every border, agree."""

import json
import math
import pathlib
import random
import tempfile
import unittest

import rest_oracle
from harness import main, rounds, run
from rest_case import random_block, random_profile, text

SEED = 17
SCENES = rounds(3, 6)
SHIFTS = rounds(5, 10)  # of the brute force, in each scene


def value(number):
    return number["value"]


def touching(block, profile):
    """Which vertices of the block and points of the profile touch, of a block that the brute force left at rest."""
    rock = [(profile[0][0], -99.0), (profile[-1][0], -99.0)] + profile[::-1]
    near = rest_oracle.NEAR
    return (frozenset(k for k, p in enumerate(block) if rest_oracle.distance(p, rock) < near),
            frozenset(k for k, p in enumerate(profile) if rest_oracle.distance(p, block) < near))


class Poses(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def cases(self, block, profile, place="all", more="friction_angle_deg: 40\n", unit="m"):
        self.path.write_text(f"topple: 1\nlength_unit: {unit}\nblock: {{outline: {text(block)}}}\n"
                             f"base: {{profile: {text(profile)}, place: {place}}}\n{more}", encoding="utf-8")
        status, out, err = run("solve", "--json", self.path)
        return json.loads(out)["cases"] if status == 0 else (out + err)

    def drawn(self, draw, count):
        """Scenes whose block comes to rest as given, with the poses of their first case."""
        while count > 0:
            block, profile = random_block(draw), random_profile(draw)
            cases = self.cases(block, profile)
            if isinstance(cases, str):
                continue
            count -= 1
            yield block, profile, cases

    def test_they_fill_all_positions(self):
        """Basins lie side by side, from the first position over the profile to the last, and their shares are those
        of the poses that they lead to."""
        for block, profile, cases in self.drawn(random.Random(SEED), SCENES):
            poses = cases[0]["poses"]
            basins = poses["basins"]
            xs = [x for x, _ in block]
            self.assertAlmostEqual(value(poses["from_m"]), profile[0][0] - max(xs), delta=1e-12)
            self.assertAlmostEqual(value(poses["to_m"]), profile[-1][0] - min(xs), delta=1e-12)
            self.assertEqual((basins[0]["from_m"], basins[-1]["to_m"]), (poses["from_m"], poses["to_m"]))
            for one, other in zip(basins, basins[1:]):
                self.assertEqual(one["to_m"], other["from_m"])
                self.assertNotEqual((one["end"], one["pose"]), (other["end"], other["pose"]))
                self.assertLess(one["to_m"]["error"], 1e-11)
            self.assertAlmostEqual(sum(value(b["share"]) for b in basins), 1, delta=1e-10)
            for number, pose in enumerate(poses["poses"]):
                own = [k for k, b in enumerate(basins) if b["pose"] == number]
                self.assertEqual(len(own), pose["basins"])
                self.assertIn(pose["widest_basin"], own)
                self.assertAlmostEqual(sum(value(basins[k]["share"]) for k in own), value(pose["share"]), delta=1e-10)
            shares = [value(pose["share"]) for pose in poses["poses"]]
            self.assertEqual(shares, sorted(shares, reverse=True))
            given = next(b for b in basins if value(b["from_m"]) < 0 < value(b["to_m"]))
            self.assertEqual(given["pose"], poses["given"])

    def test_brute_force(self):
        """From random positions, none within 1e-3 of a border, the brute force comes to the end of their basin: with
        the same vertices and points in contact as from the position that tells of the pose, and there to its turn."""
        draw = random.Random(SEED + 1)
        compared = 0
        for block, profile, cases in self.drawn(draw, SCENES):
            poses = cases[0]["poses"]
            known = {}
            for _ in range(SHIFTS):
                shift = draw.uniform(value(poses["from_m"]), value(poses["to_m"]))
                basin = next(b for b in poses["basins"] if value(b["to_m"]) > shift)
                if min(abs(shift - value(basin[key])) for key in ("from_m", "to_m")) < 1e-3:
                    continue
                how, outline = self.brought_down([(x + shift, y) for x, y in block], profile)
                if how == "unclear":
                    continue
                compared += 1
                self.assertEqual(basin["end"].split(" to ")[0], {"rests": "comes", "beside": "rolls off"}.get(how, how),
                                 shift)
                if how != "rests":
                    continue
                number = basin["pose"]
                if number not in known:
                    known[number] = self.from_its_position(block, profile, poses["poses"][number])
                if known[number] is not None:
                    self.assertEqual(touching(outline, profile), known[number], shift)
        self.assertGreater(compared, SCENES * SHIFTS // 2)

    def brought_down(self, block, profile):
        """By the brute force, which does not see a last turn shorter than its step: then one point touches alone."""
        how, outline = rest_oracle.rest(block, profile)
        if how == "rests" and sum(map(len, touching(outline, profile))) < 2:
            return "unclear", outline
        return how, outline

    def from_its_position(self, block, profile, pose):
        start = [(x + value(pose["shift_m"]), y) for x, y in block]
        how, outline = self.brought_down(start, profile)
        if how == "unclear":
            return None
        self.assertEqual(how, "rests")
        x0, _ = rest_oracle.centroid(block)
        x1, y1 = rest_oracle.centroid(outline)
        self.assertAlmostEqual(value(pose["centroid_y_m"]), y1, delta=10 * rest_oracle.NEAR)
        self.assertAlmostEqual(value(pose["rest"]["moved_x_m"]), x1 - x0, delta=10 * rest_oracle.NEAR)
        contacts = rest_oracle.contacts(outline, profile, [(profile[0][0], -99.0), (profile[-1][0], -99.0)] + profile[::-1],
                                        rest_oracle.NEAR)
        self.assertAlmostEqual(value(pose["first_contact"]["x_m"]), contacts[0][0], delta=10 * rest_oracle.NEAR)
        self.assertAlmostEqual(value(pose["last_contact"]["x_m"]), contacts[-1][0], delta=10 * rest_oracle.NEAR)
        return touching(outline, profile)

    def test_borders(self):
        """Set down a hair to the left and to the right of a border, the block turns as its two basins say; not at all
        where one of them rolls off."""
        for block, profile, cases in self.drawn(random.Random(SEED + 2), 3):
            basins = cases[0]["poses"]["basins"]
            for left, right in zip(basins[:8], basins[1:]):
                for basin, key, side in ((left, "turned_to_deg", -1), (right, "turned_from_deg", 1)):
                    shift = value(left["to_m"]) + side * 1e-9
                    if value(basin["to_m"]) - value(basin["from_m"]) < 1e-8:
                        continue
                    ended = self.cases([(x + shift, y) for x, y in block], profile, place="rest")
                    if basin["end"] == "comes to rest":
                        self.assertAlmostEqual(value(ended[0]["rest"]["turned_deg"]), value(basin[key]), delta=1e-4)
                    else:
                        self.assertIn(basin["end"].split(" to ")[0], ended)

    def test_verdicts(self):
        """Each pose has the verdict that `place: rest` gives it from its position, and the least safe one is named."""
        more = "friction_angle_deg: 35\ntilt: {angle_deg: 4}\n"
        draw = random.Random(SEED + 3)
        ((block, profile, _),) = list(self.drawn(draw, 1))
        cases = self.cases(block, profile, more=more)
        for case in cases:
            poses = case["poses"]["poses"]
            for pose in poses[:6]:
                shift = value(pose["shift_m"])
                own = self.cases([(x + shift, y) for x, y in block], profile, place="rest", more=more)
                alone = next(c for c in own if c["towards"] == case["towards"])
                self.assertEqual(pose["mechanism"], alone["mechanism"])
                self.assertEqual(pose["first"], alone["first"]["mechanism"])
                for one, other in ((pose["critical_angle_deg"], alone["first"]["critical_angle_deg"]),
                                   (pose["fos"], alone["governing_fos"]["fos"])):
                    if one is None or other is None:
                        self.assertEqual(one, other)
                    else:
                        self.assertAlmostEqual(value(one), value(other), delta=1e-9 * (1 + abs(value(other))))
            angles = [value(pose["critical_angle_deg"]) for pose in poses if pose.get("critical_angle_deg")]
            self.assertEqual(value(poses[case["poses"]["least"]]["critical_angle_deg"]), min(angles))

    def test_the_present_pose(self):
        """Table and report of the pose that the block reaches as given show the same numbers. The table had those from the middle of the
        widest basin, where the block has slid along its facet: 36.103 degrees there, 34.273 in the report."""
        more, compared = "friction_angle_deg: 50\ntilt: {angle_deg: 4}\n", 0
        for block, profile, _ in self.drawn(random.Random(SEED + 5), rounds(4, 60)):
            for case in self.cases(block, profile, more=more):
                poses = case["poses"]
                if poses["given"] is None:
                    continue
                own = poses["poses"][poses["given"]]
                self.assertEqual(value(own["shift_m"]), 0)
                self.assertEqual((own["mechanism"], own["first"]), (case["mechanism"], case["first"]["mechanism"]))
                self.assertEqual(own["rest"]["turned_deg"], case["rest"]["turned_deg"])
                for one, other in ((own["critical_angle_deg"], case["first"]["critical_angle_deg"]), (own["fos"], case["governing_fos"]["fos"])):
                    self.assertEqual(one and value(one), other and value(other))
                compared += 1
        self.assertGreater(compared, 7)

    def test_a_bench(self):
        """A slab 1 m wide on a bench with an edge: where its centroid passes the ends of the bench, or a side of it
        does, are fractions."""
        block = [(0.0, 2.0), (1.0, 2.0), (1.0, 3.2), (0.0, 3.2)]
        profile = [(-2.0, 0.0), (2.0, 0.0), (4.0, -0.5), (6.0, 0.1)]
        poses = self.cases(block, profile)[0]["poses"]
        basins = poses["basins"]
        borders = [value(b["from_m"]) for b in basins] + [value(basins[-1]["to_m"])]
        flush = (4 - math.cos(math.atan2(0.5, 2)), 3 + math.cos(math.atan2(0.6, 2)))  # a lower corner in the notch
        expected = [-3, -2.5, -2, 1, 1.5, 2, *flush, 5, 5.5, 6]
        self.assertEqual(len(borders), len(expected))
        for own, truth in zip(borders, expected):
            self.assertAlmostEqual(own, truth, delta=1e-11)
        turned = [b["turned_from_deg"] and value(b["turned_from_deg"]) for b in basins]
        self.assertEqual(turned[:4], [None, 0, 0, 0])
        for own in turned[4:6]:
            self.assertAlmostEqual(own, -math.degrees(math.atan2(0.5, 2)), delta=1e-12)
        self.assertAlmostEqual(turned[-2], math.degrees(math.atan2(0.6, 2)), delta=1e-12)
        self.assertEqual([basins[0]["end"], basins[-1]["end"]], ["rolls off to the left", "rolls off to the right"])
        self.assertAlmostEqual(value(poses["poses"][0]["share"]), 1 / 3, delta=1e-11)

    def test_mirror_shift_unit(self):
        """The basins of a mirrored scene are mirrored, of a shifted one the same, of one in millimetres a thousandth as
        wide. Basins narrower than the spacing may be missed in the one and not in the other."""
        for block, profile, cases in self.drawn(random.Random(SEED + 4), 3):
            own = cases[0]["poses"]
            wide = 1.01 * value(own["spacing_m"])
            mirror = self.cases([(-x, y) for x, y in block[::-1]], [(-x, y) for x, y in profile[::-1]])[0]["poses"]
            shifted = self.cases([(x + 1024, y - 512) for x, y in block],
                                 [(x + 1024, y - 512) for x, y in profile])[0]["poses"]
            small = self.cases(block, profile, unit="mm")[0]["poses"]
            self.same(own["basins"], shifted["basins"], wide, lambda b: (value(b["from_m"]), value(b["to_m"])))
            self.same(own["basins"], small["basins"], wide, lambda b: (1e3 * value(b["from_m"]), 1e3 * value(b["to_m"])))
            self.same(own["basins"], mirror["basins"], wide, lambda b: (-value(b["to_m"]), -value(b["from_m"])))

    def same(self, own, other, wide, ends):
        """Every basin wider than that has its like: what it holds of the other's narrow ones, and of the borders of
        these, is left out."""
        others = [ends(b) for b in other]
        for basin in own:
            low, high = value(basin["from_m"]), value(basin["to_m"])
            if high - low < wide:
                continue
            near = min(others, key=lambda e: abs(e[0] - low) + abs(e[1] - high))
            self.assertLess(abs(near[0] - low) + abs(near[1] - high), 2 * wide)

    def test_one_wavelength_on(self):
        """On regular teeth the wide basins away from the ends come again a wavelength on."""
        teeth = [(float(k), 0.25 * (k % 2)) for k in range(-10, 11)]
        block = [(0.3, 3.0), (2.1, 2.5), (2.9, 4.0), (0.7, 4.5)]
        poses = self.cases(block, teeth)[0]["poses"]
        wide = [(value(b["from_m"]), value(b["to_m"]), value(b["turned_from_deg"])) for b in poses["basins"]
                if b["pose"] is not None and value(b["to_m"]) - value(b["from_m"]) > value(poses["spacing_m"])]
        inner = [w for w in wide if -7 < w[0] and w[1] < 2]
        self.assertGreater(len(inner), 8)
        for own in inner:
            on = min(wide, key=lambda w: abs(w[0] - own[0] - 2))
            for one, other in zip(on, (own[0] + 2, own[1] + 2, own[2])):
                self.assertAlmostEqual(one, other, delta=1e-8)

    def test_refused(self):
        block = [(0.0, 1.0), (2.0, 1.0), (1.0, 3.0)]
        self.assertIn("falls beside its base", self.cases([(x + 20, y) for x, y in block], [(-5.0, 0.0), (5.0, 0.0)]))
        self.assertIn("'all', to list all its resting poses", self.cases(block, [(-5.0, 0.0), (5.0, 0.0)], place="any"))
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                             "base: {mated: true, place: all}\n")
        self.assertIn("a mated base fits its block already", run("solve", self.path)[2])


if __name__ == "__main__":
    main()
