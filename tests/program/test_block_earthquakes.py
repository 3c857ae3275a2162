# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Many blocks in an earthquake (docs/blocks_in_contact.md, The scene). Its upward part was always counted, as where weights alone act that is
the worse: but blocks that cohesion or bolts hold weigh less then, and a slab of 1.78 had 2.13. And where forces hold blocks only as they
are shaken to one side, the numbers of that side read as if they stood: a block that falls over by itself had a factor of 8.3. Held
against closed forms of a slab and a leaning block, and against `topple solve` of one block."""

import json
import math
import random
import re

from governing_case import GoverningCase
from harness import main, rounds, run

GROUND = "{name: ground, ground: true, outline: [[-30, -2], [30, -2], [30, 0], [-30, 0]]}"
LEANING = [[0, 0], [1, 0], [2.5, 3], [1.5, 3]]


def many(outline, rest, friction, ground=GROUND):
    return (f"topple: 1\nlength_unit: m\nfriction_angle_deg: {friction}\nblock: {{unit_weight_kn_m3: 25}}\nblocks:\n  - {ground}\n"
            f"  - {{name: b, outline: {outline}}}\n{rest}")


def alone(outline, rest, friction):
    return (f"topple: 1\nlength_unit: m\nfriction_angle_deg: {friction}\nblock: {{unit_weight_kn_m3: 25, outline: {outline}}}\n"
            f"base: {{mated: true, beyond: {{left: 26, right: 26}}}}\n{rest}")


class BlockEarthquakes(GoverningCase):
    def solved(self, text, *options):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertIn(done, (0, 1), err + text)
        return json.loads(out)

    def encloses(self, told, truth, where):
        self.assertLessEqual(abs(told["value"] - truth), told["error"] + 1e-11 * abs(truth), (told, truth, where))

    def cautions(self, own):
        return [n["text"] for n in own["notes"] if n["kind"] == "caution"]

    def test_vertical_part_of_what_cohesion_holds(self):
        """A flat slab on a slope slides: c L + N tan φ over T, with and without the vertical part, up or down, and the less counts. On a
        table it acts as it is given. Both as `topple solve` of the one block says, and every number is the less of two scenes."""
        draw = random.Random(4)
        for _ in range(rounds(5, 60)):
            dip, friction, cohesion = draw.choice((35, 50, 65)), draw.choice((20, 30)), draw.choice((20, 40))
            across, up = draw.choice((0.05, 0.125)), draw.choice((0.25, 0.125, -0.25))
            sine, cosine, mu = math.sin(math.radians(dip)), math.cos(math.radians(dip)), math.tan(math.radians(friction))

            def factor(share):
                along = (1 - share) * sine + across * cosine
                return (cohesion / 25 + mu * ((1 - share) * cosine - across * sine)) / along

            slab = [[0, 0], [9, 0], [9, 1], [0, 1]]
            for frame, shares in ((f"slope: {{dip_deg: {dip}, towards: left}}", (0, up)), (f"tilt: {{towards: left, angle_deg: {dip}}}", (up,))):
                def rest(vertical):
                    way = ", direction: down_dip" if "slope" in frame else ""
                    return (f"{frame}\nloads: {{cohesion_kpa: {cohesion}, seismic: {{horizontal: {across}, vertical: {vertical}{way}}}}}\n"
                            "support: {block: b, at: [0, 0.5], fos: 3}\n")

                text = many(slab, rest(up), friction)
                own = self.solved(text)["cases"][0]
                self.encloses(own["fos"], min(map(factor, shares)), text)
                self.assertEqual(own.get("without_vertical", False), len(shares) == 2 and factor(0) < factor(up), text)
                tables = [rest(v).replace("slope: {dip_deg", "tilt: {angle_deg").replace(", direction: down_dip", "") for v in shares]
                ones = [self.solved(alone(slab, table.split("support")[0], friction))["cases"][0]["limit"]["fos"]["value"] for table in tables]
                self.encloses(own["fos"], min(ones), text)
                cases = [self.solved(many(slab, table, friction))["cases"][0] for table in tables]
                for key in ("fos", "fos_driving", "critical_angle_deg", "critical_acceleration_g", "standing_fos", "moving_fos",
                            "standing_fos_driving", "moving_angle_deg"):
                    values = [c[key] if c.get(key) is None or isinstance(c[key], float) else c[key]["value"] for c in cases if key in c]
                    value = own.get(key) if own.get(key) is None or isinstance(own[key], float) else own[key]["value"]
                    if len(values) == len(shares) and None not in values:
                        self.assertAlmostEqual(value, min(values), delta=1e-6 * abs(value), msg=(key, text))
                forces = [c["support"]["force_n_m"]["value"] if c["support"].get("force_n_m") else 0 for c in cases]
                held = own["support"]["force_n_m"]["value"] if own["support"].get("force_n_m") else 0
                self.assertAlmostEqual(held, max(forces), delta=1e-5 * max(1, held), msg=text)

    def test_vertical_part_of_what_a_bolt_holds(self):
        """A bolt along a steep plane holds with a force of its own: the lighter block has a factor above 1, the one that is not lifted
        slides. They collapse then, and not the other way round."""
        slab, dip, up, mu = [[0, 0], [4, 0], [4, 1], [0, 1]], 70, 0.0625, math.tan(math.radians(20))
        sine, cosine = math.sin(math.radians(dip)), math.cos(math.radians(dip))
        across = 0.05
        least = [100 * ((1 - v) * (sine - mu * cosine) + across * (cosine + mu * sine)) for v in (0, up)]
        self.assertGreater(least[0], least[1])
        for force, verdict in (((least[0] + least[1]) / 2, "collapses"), (least[0] + 1, "stands")):
            rest = (f"slope: {{dip_deg: {dip}, towards: left}}\nloads:\n  seismic: {{horizontal: {across}, vertical: {up}, direction: down_dip}}\n"
                    f"  forces: [{{block: b, at: [0, 0.5], direction_deg: 0, force_kn: {force!r}}}]\n")
            own = self.solved(many(slab, rest, 20))["cases"][0]
            self.assertEqual(own["verdict"], verdict, rest)
            self.assertTrue(own["without_vertical"])
            # and the forces that are told balance the weight without the part that lifts
            normal = sum(f["normal_n_m"] for f in own["forces"])
            self.assertAlmostEqual(normal, 1e5 * (cosine - across * sine), delta=2)
            page = run("solve", self.scene(many(slab, rest, 20)))[1]
            self.assertIn("without the vertical part", page)

    def test_weights_alone(self):
        """Of weights alone the direction decides: an upward part counts, a downward one does not, but on a table."""
        def tangent(rest):
            return self.solved(many([[0, 0], [2, 0], [2, 3], [0, 3]], rest, 50))["cases"][0]["fos"]["value"]

        def truth(up):
            return math.tan(math.radians(50)) / (0.125 / (1 - up))

        slope = "slope: {dip_deg: 0, towards: left}\nloads: {seismic: {horizontal: 0.125, vertical: UP}}\n"
        table = "tilt: {towards: left, angle_deg: 0}\nloads: {seismic: {horizontal: 0.125, vertical: UP}}\n"
        for rest, up, counts in ((slope, 0.25, 0.25), (slope, -0.25, 0), (table, 0.25, 0.25), (table, -0.25, -0.25)):
            told = tangent(rest.replace("UP", str(up)))
            self.assertAlmostEqual(told, truth(counts), delta=2e-6 * told)
        # The critical acceleration is with that part: tan φ (1 - k_v), or the arm of the toe over that of the centroid times as much.
        own = self.solved(many([[0, 0], [2, 0], [2, 3], [0, 3]], slope.replace("UP", "0.25"), 50))["cases"][0]
        self.encloses(own["critical_acceleration_g"], 0.75 * 2 / 3, slope)

    def test_held_farther_alone(self):
        """A block that leans over its base to the right falls over by itself: x / y of its centroid is the tangent that holds it upright over
        the left end, (x − 1) / y that over the right one. Between both it is held, of so much tilt or earthquake to the left. With less
        it collapses, no factor is told at all, and no critical acceleration, as it has none; the greatest tilt is told not to be as
        they lie. In the mirror, in millimetres, far off, and with a bolt as well."""
        x, y, friction = 1.25, 1.5, 40
        least, most = (x - 1) / y, x / y
        bolt = "  anchors: [{block: b, at: [1, 1], to: [1.25, -1], into: ground, force_kn: 0.0001}]\n"
        for share, more in ((0, ""), (0.1, ""), (0.1, bolt), (0.3, ""), (0.3, bolt)):
            held = share > least
            rest = "tilt: {towards: left}\n" + ("loads:\n" if share or more else "") + (f"  seismic: {{horizontal: {share}}}\n" if share else "") + more
            text = many(LEANING, rest, friction)
            own = self.solved(text)
            case = own["cases"][0]
            self.assertAlmostEqual(case["critical_angle_deg"]["value"], math.degrees(math.atan(most) - math.atan(share)), delta=2e-3)
            page = run("solve", self.scene(text))[1]
            self.assertEqual("but not as they lie" in page, not held, page)
            self.assertEqual(any("without it no forces do" in c for c in self.cautions(own)), held, text)
            self.assertEqual(case["verdict"] == "collapses", not held, text)
            self.assertNotIn("critical_acceleration_g", case)  # without the earthquake it falls, held or not
            self.assertNotIn("critical horizontal acceleration", page)
            if held:
                self.assertEqual(case["static_verdict"], "collapses")
                continue
            self.assertIsNone(case["fos"])
            self.assertEqual(case["fos_is"], "none", text)
            self.assertIsNone(case["fos_driving"])
            self.assertEqual(case["fos_driving_is"], "nothing drives" if share == 0 else "not held without", text)
            run("solve", "--report", self.folder / "sheet.md", self.scene(text))
            sheet = (self.folder / "sheet.md").read_text()
            self.assertIn("| as they lie |", sheet)  # a motion can begin; it was told that none is proven
            self.assertIn("As they lie none hold the blocks.", sheet)

            mirrored = many([[-a, b] for a, b in reversed(LEANING)], rest.replace("left", "right").replace("[1, 1]", "[-1, 1]").replace("1.25, -1", "-1.25, -1"), friction)
            other = self.solved(mirrored)["cases"][0]
            self.assertEqual([other.get(k) for k in ("verdict", "fos_is", "fos_driving_is")], [case.get(k) for k in ("verdict", "fos_is", "fos_driving_is")])

    def test_both_sides_of_it(self):
        """At its place it is shaken both ways: of two sides that collapse alike none governs, else the one to which it falls does, and no
        table or row has a factor above 1 for either."""
        text = many(LEANING, "frame: world\nloads: {seismic: {horizontal: 0.1}}\n", 40)
        page = run("solve", self.scene(text))[1]
        self.assertEqual(page.count("COLLAPSES: no forces"), 2)
        self.assertEqual(len(re.findall(r"^  factor of safety +none: a motion can begin at every smaller multiple too$", page, re.M)), 2)
        self.assertNotIn("Governs", page)
        rows = run("solve", "--csv", self.scene(text))[1].splitlines()
        heads = rows[0].split(",")
        for row in rows[1:]:
            told = dict(zip(heads, row.split(",")))
            self.assertEqual((told["verdict"], told["fos"], told["fos_driving"], told["critical_acceleration_g"]), ("collapses", "", "", ""))
        # 0.3 g hold it on one side, and on the other it collapses: so it does not meet a factor.
        text = text.replace("0.1", "0.3") + "required_fos: 1.1\n"
        done, out, err = run("solve", "--json", self.scene(text))
        self.assertEqual(done, 1, err)
        own = json.loads(out)
        self.assertEqual([(c["verdict"], c["meets_required"]) for c in own["cases"]], [("stands", "not met"), ("collapses", "not met")])
        self.assertEqual(own["governs_towards"], "right")
        self.assertIn("Governs  towards the right: it collapses\n", run("solve", self.scene(text))[1])

    def test_what_stands_has_a_factor_of_one(self):
        """At a friction of 89 degrees the search of this scene comes to no end where an edge has a corner more: the factor of blocks that
        stood was told to be above 0.956."""
        blocks = ("[[0.25, 0.09375], [1, 0.375], [1, 2.4375]]", "[[0.125, 2.796875], [0, 2.75], [0, 0.34375]]",
                  "[[0, 0.34375], [0, 0.171875], [0, 0], [0.25, 0.09375], [1, 2.4375], [1, 3.125], [0.125, 2.796875]]",
                  "[[1, 0.375], [2, 0.75], [2, 3.75], [2, 6.75], [1, 6.375]]")
        ground = "{name: ground, ground: true, outline: [[-6, -7.25], [8, -7.25], [8, 3], [2, 0.75], [1, 0.375], [0.5, 0.1875], [0, 0], [-6, -2.25]]}"
        text = many(blocks[0], "".join(f"  - {{name: b{k}, outline: {own}}}\n" for k, own in enumerate(blocks[1:])) + "frame: world\n"
                    "joints: [{between: [b, b1], friction_angle_deg: 10}]\nloads: {seismic: {horizontal: 0.2}}\n", 89, ground)
        own = self.solved(text)["cases"][1]
        self.assertEqual((own["towards"], own["verdict"]), ("right", "stands"))
        self.assertGreaterEqual(own["fos"]["value"], 1)
        # Nor is one certain to stand under 0.99999 times its loads alone: what is certain as it lies is certain of 1.
        self.assertGreaterEqual(own["standing_fos_driving"], 1)
        self.assertNotRegex(run("solve", self.scene(text))[1], r"certain to stand[^\n]*up to 0\.")
        exact = many([[0, 0], [2, 0], [2, 2], [0, 2]], "tilt: {towards: left, angle_deg: 44.99999}\nrequired_fos: 1\n", 60)
        own = self.solved(exact)["cases"][0]
        self.assertEqual((own["verdict"], own["meets_required"]), ("stands", "met"))

    def test_more_than_is_looked_for(self):
        """A block against a step of ground bears any earthquake towards that: up to 1000 times it is proven, and more; no digits stand behind."""
        step = "{name: ground, ground: true, outline: [[-9, -2], [9, -2], [9, 0], [0, 0], [0, 4], [-9, 4]]}"
        page = run("solve", self.scene(many([[0, 0], [4, 0], [4, 3], [0, 3]], "frame: world\nloads: {seismic: {horizontal: 0.1}}\n", 30, step)))[1]
        left = page.split("Towards the right")[0]
        self.assertRegex(left, r"forces can hold, driving loads times +above 1000\n")
        self.assertRegex(left, r"certain to stand, driving loads times +up to 1000, and more\n")
        glued = run("solve", self.scene(many([[0, 0], [4, 0], [4, 3], [0, 3]], "tilt: {towards: left, angle_deg: 40}\n"
                                             "loads: {cohesion_kpa: 1e6, bond_kpa: 1e6}\n", 30)))[1]
        self.assertEqual(glued.count("above 1000"), 5, glued)
        self.assertNotIn("(governs)", glued)  # neither is known to be the lesser

    def test_one_side_is_told(self):
        """On a table one side is looked at, which a caution tells as of one block; `direction` is of a slope."""
        block = [[0, 0], [2, 0], [2, 1], [0, 1]]
        for rest, told in (("tilt: {towards: left}", True), ("tilt: {towards: both}", False), ("frame: world", False),
                           ("slope: {dip_deg: 3, towards: left}", False)):
            own = self.solved(many(block, rest + "\nloads: {seismic: {horizontal: 0.1}}\n", 30))
            self.assertEqual(any("shakes both ways" in c for c in self.cautions(own)), told, rest)
        meant = self.solved(many(block, "tilt: {towards: left}\nloads: {seismic: {horizontal: 0.1, direction: down_dip}}\n", 30))
        self.assertEqual(self.cautions(meant), [])
        for rest, direction, words in (("tilt: {towards: left}", "up_dip", "on a table"), ("frame: world", "down_dip", "with y up"),
                                       ("tilt: {towards: left, angle_deg: 2}", "both", "on a table")):
            done, _, err = run("solve", self.scene(many(block, f"{rest}\nloads: {{seismic: {{horizontal: 0.1, direction: {direction}}}}}\n", 30)))
            self.assertEqual(done, 3, err)
            self.assertIn("scene.yaml:9:18", err)
            self.assertIn(words, err)


if __name__ == "__main__":
    main()
