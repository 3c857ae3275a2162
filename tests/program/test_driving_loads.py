# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The factor on what drives many blocks (docs/blocks_in_contact.md, Two factors). Strength reduction alone said 4.3 of a column that topples
at 1.03 times its load, and a required factor of 1.3 was told to be met. Held against closed forms of one block, the factor by moments of
`topple solve` of one block, the tilt at which piles fall, and scenes whose loads are multiplied by hand."""

import csv
import json
import math
import random
import re

from governing_case import GoverningCase
from harness import main, rounds, run

GROUND = "{name: ground, ground: true, outline: [[-90, -9], [90, -9], [90, 0], [-90, 0]]}"


def scene_of(blocks, rest, friction=70):
    listed = "".join(f"  - {own}\n" for own in (GROUND, *blocks))
    return (f"topple: 1\nlength_unit: m\nfriction_angle_deg: {friction}\nblock: {{unit_weight_kn_m3: 25}}\nblocks:\n{listed}{rest}")


def column(width, height, lean=0, name="column", at=(0, 0)):
    corners = [(0, 0), (width, 0), (width + lean, height), (lean, height)]
    return f"{{name: {name}, outline: {[[x + at[0], y + at[1]] for x, y in corners]}}}"


def tilted(degrees, towards="left"):
    return f"tilt: {{towards: {towards}, angle_deg: {degrees}}}\n"


class DrivingLoads(GoverningCase):
    def solved(self, text, *options, status=(0,)):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertIn(done, status, err + text)
        return json.loads(out)

    def case(self, text, **wanted):
        return self.solved(text, **wanted)["cases"][0]

    def encloses(self, told, truth, where):
        """1e-6 of itself is the width to which limits are proven; the rest is the rounding of the truth."""
        self.assertLessEqual(abs(told["value"] - truth), told["error"] + 1e-11 * abs(truth), (told, truth, where))
        self.assertLessEqual(told["error"], 2e-6 * abs(truth), where)

    def test_a_column_that_topples(self):
        """The story: 1 m wide, 5 m high, rough, at 11 degrees, 0.31 before it topples. Both programs say 1.03, and that 1.3 is not met."""
        truth = 0.2 / math.tan(math.radians(11))
        own = self.case(scene_of([column(1, 5)], tilted(11) + "required_fos: 1.3\n", 40), status=(1,))
        self.assertEqual((own["meets_required"], own["fos_driving_mechanism"], own["verdict"]), ("not met", "topples", "stands"))
        self.encloses(own["fos_driving"], truth, "column")
        self.assertGreater(own["fos"]["value"], 4.3)
        one = self.solved("topple: 1\nlength_unit: m\nfriction_angle_deg: 40\nblock: {slab: {width: 1, height: 5}}\n" + tilted(11))
        self.encloses(own["fos_driving"], one["cases"][0]["governing_fos"]["fos"]["value"], "as one block")
        for required, meets, status in ((1.02, "met", 0), (1.03, "not met", 1)):
            own = self.case(scene_of([column(1, 5)], tilted(11) + f"required_fos: {required}\n", 40), status=(status,))
            self.assertEqual(own["meets_required"], meets)

    def test_what_no_strength_holds(self):
        """Past its toppling tilt the column has no factor by strength, which is proven of 1000 times as much: the factor on what drives
        governs, and passes 1 there without a leap. So it does with loads besides, and mirrored; where nothing drives it is none at all.
        With a little cohesion and tension 1000 times these hold it again."""
        for tilt, side in ((12, "left"), (18, "right")):
            for loads in ("", "loads: {forces: [{block: column, at: [0.5, 2], direction_deg: -90, force_kn: 1}]}\n"):
                text = scene_of([column(1, 5)], tilted(tilt, side) + loads + "required_fos: 0.5\n", 40)
                own = self.case(text, status=(1,))
                self.assertEqual((own["fos"], own["fos_is"], own["verdict"], own["meets_required"]), (None, "none", "collapses", "not met"))
                if not loads:
                    self.encloses(own["fos_driving"], 0.2 / math.tan(math.radians(tilt)), text)
                page = run("solve", self.scene(text))[1]
                self.assertRegex(page, r"factor of safety +0\.\d+, driving loads, topples\n")
                self.assertRegex(page, r"forces can hold, strength divided by +none: not held with 1000 times the strength\n")
        over = scene_of([column(2, 1, name="low"), column(3, 1, name="over", at=(1, 1))], "frame: world\ntilt: {towards: right}\n", 40)
        self.assertEqual(self.case(over)["fos_is"], "none")
        found = json.loads(run("solve", "--json", "--find", "tilt.angle_deg", "--for", "governing_fos=0.9", "--from", "5", "--to", "20",
                               self.scene(scene_of([column(1, 5)], tilted(10), 40)))[1])["find"]["solutions"]
        self.assertEqual(len(found), 1)
        self.assertAlmostEqual(found[0]["value"], math.degrees(math.atan(0.2 / 0.9)), delta=2e-5)
        held = self.case(scene_of([column(1, 5)], tilted(12) + "loads: {cohesion_kpa: 1, bond_kpa: 1}\n", 40))
        self.assertLess(held["fos"]["value"], 1)
        self.assertGreater(held["fos"]["value"], 1e-3)

    def test_leaning_columns_in_earthquakes(self):
        """By moments about the toe, and by friction, whichever is less: weight by its two components, the earthquake as a whole. The same
        in millimetres, far off, and of the mirror image."""
        draw = random.Random(5)
        for _ in range(rounds(12, 100)):
            width, height = draw.randint(1, 4), draw.randint(3, 9)
            lean, friction = draw.choice((-0.5, 0, 0.25)), draw.choice((25, 70))
            tilt, k, up = draw.choice((0, 3, 6)), draw.choice((0, 0.0625, 0.125)), draw.choice((0, 0.03125))
            sine, cosine, mu = math.sin(math.radians(tilt)), math.cos(math.radians(tilt)), math.tan(math.radians(friction))
            x, y = (width + lean) / 2, height / 2  # of the centroid, from the toe on the left
            along, off = sine + k * cosine - up * sine * (k > 0), k * sine + up * cosine * (k > 0)
            quake = f"loads: {{seismic: {{horizontal: {k}, vertical: {up}}}}}\n" if k else ""
            text = scene_of([column(width, height, lean)], tilted(tilt) + quake, friction)
            own = self.case(text, status=(0, 1))
            if not (k or tilt):
                self.assertEqual((own["fos_driving"], own["fos_driving_is"]), (None, "nothing drives"))
                continue
            truth = min(x * cosine / (y * along + x * off), mu * cosine / (along + mu * off))
            self.encloses(own["fos_driving"], truth, text)
            away = scene_of([column(width, height, lean, at=(40, 0))], tilted(tilt) + quake, friction)
            mirrored = scene_of([column(width, height, -lean)], tilted(tilt, "right") + quake, friction)
            for image in (away, mirrored):
                self.encloses(self.case(image, status=(0, 1))["fos_driving"], truth, image)

    def test_piles_by_their_tilt(self):
        """Weights alone: what drives times f is a tilt with f times the tangent, whatever blocks there are; and a negligible cohesion, which
        takes another way through the program, changes nothing."""
        draw = random.Random(6)
        for _ in range(rounds(6, 60)):
            blocks, level = [], 0
            for k in range(draw.randint(2, 4)):
                height = draw.choice((1, 2, 3))
                blocks.append(column(draw.choice((1, 1.5, 2)), height, name=f"b{k}", at=(draw.choice((0, 0.125, 0.25)), level)))
                level += height
            tilt = draw.choice((1, 2, 4))
            own = self.case(scene_of(blocks, tilted(tilt), draw.choice((20, 45))), status=(0, 1, 4))
            limit = own["critical_angle_deg"]
            if limit is None or limit["value"] <= 0:
                continue
            factor = math.tan(math.radians(limit["value"])) / math.tan(math.radians(tilt))
            self.assertLessEqual(abs(own["fos_driving"]["value"] - factor), own["fos_driving"]["error"] + 1e-11 * factor)
            for key in ("standing", "moving"):
                self.assertEqual(f"{key}_fos_driving" in own, f"{key}_angle_deg" in own)
                if f"{key}_angle_deg" in own:
                    angle = math.tan(math.radians(own[f"{key}_angle_deg"])) / math.tan(math.radians(tilt))
                    self.assertAlmostEqual(own[f"{key}_fos_driving"], angle, delta=1e-9 * angle)

    def test_cohesion_that_is_nothing(self):
        """The linear program of a measured scene against the resultant of one that is not."""
        for tilt, friction in ((3, 30), (6, 60)):
            blocks = [column(1, 3, name="a"), column(1.5, 2, name="b", at=(0, 3)), column(2, 1, name="c", at=(1, 0))]
            bare = self.case(scene_of(blocks, tilted(tilt), friction))
            bound = self.case(scene_of(blocks, tilted(tilt) + "loads: {cohesion_kpa: 1e-9}\n", friction), status=(0, 4))
            self.encloses(bound["fos_driving"], bare["fos_driving"]["value"], (tilt, friction))
            self.assertAlmostEqual(bound.get("standing_fos_driving", 1), bare.get("standing_fos_driving", 1), delta=0.01)

    def test_other_loads(self):
        """A column on level ground under one load each, by moments about its toe: a pressure and a force that push it, water behind it with
        its uplift, a surcharge on a slope, which counts by its components, a bolt, which rests where it is passive, else is taken from what drives."""
        width, height, gamma = 2, 6, 25
        weight, block = width * height * gamma, column(width, height)
        water, depth = 9.81, 3
        push, lever = water * depth ** 2 / 2, depth / 3
        sine, cosine = math.sin(math.radians(4)), math.cos(math.radians(4))
        cases = {
            "pressures: [{block: column, from: [2, 0], to: [2, 6], kpa: 3}]": weight / (3 * height * height / 2),
            "forces: [{block: column, at: [2, 4], direction_deg: 180, force_kn: 30}]": weight / (30 * 4),
            f"water: {{level: {depth}, faces: behind, uplift: none}}": weight / (push * lever),
            f"water: {{level: {depth}, faces: behind, uplift: full}}": weight / (push * lever + water * depth * width * width / 2),
        }
        for load, truth in cases.items():
            text = scene_of([block], tilted(0) + f"loads:\n  {load}\n", 80)
            self.encloses(self.case(text, status=(0, 1, 4))["fos_driving"], truth, text)
        loaded = scene_of([block], tilted(4) + "loads:\n  surcharges: [{block: column, from: [2, 6], to: [0, 6], kpa: 20}]\n", 80)
        truth = (weight + 40) * cosine / ((weight * height / 2 + 40 * height) * sine)
        self.encloses(self.case(loaded)["fos_driving"], truth, loaded)
        held = 5 * 9 / math.hypot(9, 6) * 5  # about the toe, above which its head is
        rests, drives = weight * cosine * width / 2, weight * sine * height / 2
        for passive, truth in (("true", (rests + held) / drives), ("false", rests / (drives - held))):
            bolted = scene_of([block], tilted(4) + f"loads:\n  anchors: [{{block: column, at: [0, 5], to: [9, -1], force_kn: 5, passive: {passive}}}]\n",
                              80)
            self.encloses(self.case(bolted)["fos_driving"], truth, bolted)

    def test_multiplied_by_hand(self):
        """Columns under a pressure that is multiplied in the scene: just below the factor forces hold them, just above none do."""
        blocks = [column(1, 3, name="a"), column(1, 4, name="b", at=(1, 0)), column(2, 1, name="c", at=(-2, 0))]
        scene = "loads:\n  pressures: [{{block: b, from: [2, 0], to: [2, 4], kpa: {}}}]\n"
        factor = self.case(scene_of(blocks, tilted(0) + scene.format(2), 30), status=(0, 4))["fos_driving"]["value"]
        for times, verdicts in ((0.9999, ("stands", "can be held", "may move")), (1.0001, ("collapses",))):
            text = scene_of(blocks, tilted(0) + scene.format(f"{2 * factor * times:.12f}"), 30)
            self.assertIn(self.case(text, status=(0, 1, 4))["verdict"], verdicts)

    def test_told_where_it_begins(self):
        """The factor is one of limit analysis; that a motion can begin at less stands beside it in the report, from one number on."""
        blocks = ["{name: slab, outline: [[0, 0], [1, 0], [1.4, 6], [0.4, 6]]}", "{name: wedge, outline: [[1, 0], [3, 0], [1.2, 3]]}"]
        path = self.scene(scene_of(blocks, "slope: {dip_deg: 6, towards: left}\nrequired_fos: 2.5\n", 35))
        status, out, err = run("solve", path)
        self.assertEqual(status, 1, err)
        told = dict(re.findall(r"^  (certain to stand|motion can begin), driving loads times +(?:up to )?([\d.]+)$", out, re.M))
        self.assertEqual(set(told), {"certain to stand", "motion can begin"})
        self.assertLessEqual(float(told["certain to stand"]), float(told["motion can begin"]))
        self.assertLess(float(told["motion can begin"]), 2.5)
        self.assertGreater(float(re.search(r"forces can hold, driving loads times +up to ([\d.]+) ", out)[1]), 2.5)

    def test_upright_scene(self):
        """Where no load points along x the scene's factor is of strength alone, and a caution says so where one is required."""
        own = self.solved(scene_of([column(1, 5)], "required_fos: 1.3\n"))
        self.assertEqual([case["fos_driving_is"] for case in own["cases"]], ["nothing drives"] * 2)
        self.assertTrue(any("strength alone" in note["text"] for note in own["notes"]), own["notes"])
        self.assertFalse(any("strength alone" in note["text"] for note in self.solved(scene_of([column(1, 5)], ""))["notes"]))

    def test_the_lesser_governs(self):
        """In sweeps, back-analysis and studies: the factor that governs is the lesser of both, and its definition is told."""
        path = self.scene(scene_of([column(1, 5)], tilted(8), 40))
        status, out, err = run("sweep", path, "--x", "tilt.angle_deg=8,11")
        self.assertEqual(status, 0, err)
        head, *rows = out.splitlines()
        at = head.split(",").index("fos_driving")
        for row, degrees in zip(rows, (8, 11)):
            self.assertAlmostEqual(float(row.split(",")[at]), 0.2 / math.tan(math.radians(degrees)), delta=1e-5)
        status, out, err = run("solve", "--find", "tilt.angle_deg", "--for", "governing_fos=1.3", "--from", "1", "--to", "11", path)
        self.assertEqual(status, 0, err)
        found = float(re.search(r"^ +([\d.]+)  \(within", out, re.M)[1])
        self.assertAlmostEqual(found, math.degrees(math.atan(0.2 / 1.3)), delta=2e-3)
        (self.folder / "study.yaml").write_text(f"topple_study: 1\nscene: {path}\nsamples: 60\nvary:\n"
                                                "  friction_angle_deg: {uniform: {low: 8.2, high: 14}}\n")
        status, out, err = run("study", self.folder / "study.yaml", "--rows", self.folder / "rows.csv")
        self.assertEqual(status, 0, err)
        definitions = set()
        for row in csv.DictReader((self.folder / "rows.csv").read_text().splitlines()):
            sliding = math.tan(math.radians(float(row["friction_angle_deg"]))) / math.tan(math.radians(8))
            toppling = 0.2 / math.tan(math.radians(8))
            self.assertAlmostEqual(float(row["fos"]), min(sliding, toppling), delta=2e-6)
            self.assertEqual(row["fos_definition"], "driving loads" if toppling < sliding - 1e-5 else "strength reduction")
            definitions.add(row["fos_definition"])
        self.assertEqual(len(definitions), 2)

    def test_the_lesser_is_read_first(self):
        """Who reads one line of the page reads the factor that governs: sliding of a smooth slab at 8 degrees, toppling of a slim one."""
        for friction, block in ((30, column(3, 1)), (40, column(1, 5))):
            status, out, err = run("solve", self.scene(scene_of([block], tilted(8), friction)))
            self.assertEqual(status, 0, err)
            values = [float(v) for v in re.findall(r"^ +(?:factor of safety|on driving loads|by strength reduction) +([\d.]+)", out, re.M)]
            self.assertEqual(len(values), 3, out)
            self.assertEqual(values[0], min(values[1:]), out)

    def test_the_less_safe_direction_is_told_first(self):
        """A pillar that leans to the right, in an earthquake that acts to either side: 2.0 to the right, 6.0 to the left, which stood first.
        Moments about its toes: 0.15 and 0.45 of its weight over 1.5 times 0.05 of it. Its mirror, and one that collapses to one side."""
        for sign, worst in ((1, "right"), (-1, "left")):
            corners = [(0, 0), (0.6 * sign, 0), (0.9 * sign, 3), (0.3 * sign, 3)]
            for shaking, words in ((0.05, "factor of safety 1.99999, driving loads, topples"), (0.2, "it collapses")):
                text = scene_of([f"{{name: pillar, outline: {[[*corner] for corner in corners]}}}"],
                                f"loads: {{seismic: {{horizontal: {shaking}}}}}\n", 35)
                _, out, err = run("solve", self.scene(text))
                self.assertIn(f"Governs  towards the {worst}: {words}\n", out, err)
                self.assertLess(out.index("Governs"), out.index("Towards the left"))


if __name__ == "__main__":
    main()
