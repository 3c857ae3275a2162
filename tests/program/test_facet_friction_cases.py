# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Facets with frictions of their own where the answer is known: closed forms of two frictions, scenes that say one
friction in two ways, mirrored, shifted and in other units, and what reports, notes, keys and refusals say."""

import json
import math
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, main, run, solve

HEAD = "topple: 1\nlength_unit: %s\n"
FEET = [(0, 0), (2, 1), (4, 0), (4, 3), (0, 3)]
LEVEL = [(-1, 0), (2, 0), (5, 0)]
WEDGE = [(0, 0), (2, 4), (0, 6), (-2, 6)]
NOTCH = [(-4, 12), (0, 0), (4, 8)]
BOX = [(0, 0), (2, 0), (2, 1), (0, 1)]
SPLIT = [(0, 0), (1, 0), (2, 0), (2, 1), (0, 1)]


def tan(degrees):
    return math.tan(math.radians(degrees))


def value(number):
    return number["value"]


def points(chain, factor=1, dx=0, dy=0):
    return [[x * factor + dx, y * factor + dy] for x, y in chain]


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name) / "scene.yaml"

    def write(self, outline, profile, friction, entries, tilt="", unit="m", more=""):
        base = f"base: {{profile: {points(profile)}}}\n" if profile else ""
        facets = f"friction: {{facets: [{entries}]}}\n" if entries else ""
        self.path.write_text(HEAD % unit + f"block: {{outline: {points(outline)}}}\n{base}"
                             f"friction_angle_deg: {friction}\n{facets}{more}tilt: {{towards: both{tilt}}}\n")

    def solve(self, *arguments, **options):
        self.write(*arguments, **options)
        return {case["towards"]: case for case in solve(self.path)["cases"]}

    def holds(self, number, truth):
        self.assertAlmostEqual(value(number), truth, delta=number["error"] + 1e-12 * max(1, abs(truth)))


class ClosedForms(Case):
    def test_two_feet(self):
        """Each foot bears what moments give it, so that the block slides where tan(tilt) is the mean of
        both tan(phi) by these shares: with the resultant at g_x - g_y tan(tilt) towards the left, and
        d = (mu_2 - mu_1) / L, tan(tilt) (1 + d g_y) = mu_1 + d g_x; and with both divided by F,
        F = (mu_1 + d g_x) / tan(tilt) - d g_y."""
        for left, right in ((30, 20), (10, 30), (0, 25), (15, 0)):
            cases = self.solve(FEET, LEVEL, left, f"{{facet: 2, angle_deg: {right}}}", ", angle_deg: 2")
            block = cases["left"]["block"]
            x, y, span = value(block["centroid_x_m"]), value(block["centroid_y_m"]), 4
            for side, first, last, gx in (("left", left, right, x), ("right", right, left, span - x)):
                d = (tan(last) - tan(first)) / span
                top, limit, onset = tan(first) + d * gx, cases[side]["limit"], cases[side]["onset"]
                self.holds(limit["critical_angle_deg"], math.degrees(math.atan(top / (1 + d * y))))
                self.holds(onset["critical_angle_deg"], value(limit["critical_angle_deg"]))
                self.assertEqual((limit["mechanism"], onset["mechanism"]), ("slides", "slides"))
                self.assertIsNone(limit["centre_x_m"])
                self.holds(limit["fos"], top / tan(2) - d * y)

    def test_motion_on_two_feet(self):
        """Beyond that tilt it slides with g (sin(tilt) - mu_1 n_1 - mu_2 n_2): n_1 and n_2 by their sum cos(tilt) and
        the moment about the centroid, of the friction too."""
        case = self.solve(FEET, LEVEL, 30, "{facet: 2, angle_deg: 20}", ", angle_deg: 28")["left"]
        x, y = (value(case["block"][f"centroid_{k}_m"]) for k in "xy")
        # n_1 (-x + y mu_1) + n_2 (4 - x + y mu_2) = 0
        first, second = -x + y * tan(30), 4 - x + y * tan(20)
        share = second / (second - first)
        cosine = math.cos(math.radians(28))
        held = cosine * (share * tan(30) + (1 - share) * tan(20))
        motion, = case["motions"]
        self.assertEqual(motion["mechanism"], "slides")
        self.holds(motion["acceleration_x_g"], held - math.sin(math.radians(28)))
        self.assertEqual([c["state"] for c in motion["contacts"]], ["slips down-dip"] * 2)

    def test_notch(self):
        """A wedge in a notch leaves it where the weight lies along an edge of the cone of the flank that
        it climbs: i of that flank and its own friction, towards either side, or never from 90 degrees
        on."""
        for left, right in ((12, 5), (0, 30), (10, 0)):
            cases = self.solve(WEDGE, NOTCH, 17,
                               f"{{facet: 1, angle_deg: {left}}}, {{x: [0, 4], angle_deg: {right}}}")
            for side, i, phi in (("left", math.degrees(math.atan(3)), left),
                                 ("right", math.degrees(math.atan(2)), right)):
                limit = cases[side]["limit"]
                if i + phi < 90:
                    self.holds(limit["critical_angle_deg"], i + phi)
                    self.assertEqual(limit["mechanism"], "slides")
                    self.holds(cases[side]["sliding"]["critical_angle_deg"], i + phi)
                    self.holds(cases[side]["sliding"]["friction_angle_deg"], phi)
                else:
                    self.assertEqual(limit["mechanism"], "interlocked")

    def test_split_sole(self):
        """A level sole in two pieces, 30 degrees under the left half and 20 under the right: at most all weight lies on
        the rougher half, up to its 30 degrees towards the left; at worst as much as can be lies on the smoother one,
        n_2 = 1 - tan(tilt) / 2 with its resultant at the split: tan(tilt) = mu_2 / (1 - (mu_1 - mu_2) / 2). The formula
        of sliding takes the smaller."""
        left = self.solve(SPLIT, None, 30, "{facet: 2, angle_deg: 20}", ", angle_deg: 21")["left"]
        self.holds(left["limit"]["critical_angle_deg"], 30)
        worst = tan(20) / (1 - (tan(30) - tan(20)) / 2)
        self.holds(left["onset"]["critical_angle_deg"], math.degrees(math.atan(worst)))
        self.assertEqual((left["limit"]["mechanism"], left["onset"]["mechanism"]), ("slides", "slides"))
        self.holds(left["sliding"]["critical_angle_deg"], 20)
        self.holds(left["sliding"]["fos_strength"], tan(20) / tan(21))
        self.assertEqual([value(p["x_m"]) for p in left["sliding"]["facet"]], [1, 2])

    def test_beside(self):
        """A box of 2 by 1 on 30 degrees, at whose toe another facet begins: a slide brings its corner onto that, so that its toe
        may slip by that friction, tan(tilt) = mu (1 - n) + mu' n with the share n of the weight that moments give the toe. On a
        frictionless facet it can slide from 14.16 degrees on; it was certain to stand up to 30. The limit stays 30. Towards the
        other side the corner leaves that facet. Across a gap, or at the end of the base, there is none beside."""
        level = [(-9, 0), (0, 0), (2, 0), (9, 0)]
        falling = [(-9, -4), (0, 0), (2, 0), (9, 0)]
        for base, facet, beside in ((level, 1, 0), (level, 1, 20), (level, 3, 20), (level, 1, 40), (falling, 1, 10),
                                    ([(2 - x, y) for x, y in falling[::-1]], 3, 10)):
            cases = self.solve(BOX, base, 30, f"{{facet: {facet}, angle_deg: {beside}}}")
            side, other = ("left", "right") if facet == 1 else ("right", "left")
            gap = (tan(30) - tan(beside)) / 2  # tan(tilt) = mu - 2 gap n, n = 1/2 + tan(tilt) / 4
            own = math.degrees(math.atan((tan(30) - gap) / (1 + gap / 2)))
            self.holds(cases[side]["onset"]["critical_angle_deg"], min(own, 30))
            self.holds(cases[other]["onset"]["critical_angle_deg"], 30)
            for case in cases.values():
                self.holds(case["limit"]["critical_angle_deg"], 30)
        for base, entries in ((level, "{facet: 1, angle_deg: 30}"), ([(-9, 0), (-0.001, 0), (9, 0)], "{facet: 1, angle_deg: 0}"),
                              ([(0, 0), (2, 0), (3, 0)], "{facet: 2, angle_deg: 0}")):
            self.holds(self.solve(BOX, base, 30, entries)["left"]["onset"]["critical_angle_deg"], 30)

    def test_beside_and_rounded(self):
        """The same with the corner at the other end rounded by r, which moves that end of the contact, and takes (1 - pi/4) r^2 off
        the area at (10 - 3 pi) / (12 - 3 pi) r from both sides. With x1 = 2 - r and the centroid g the corner over the vertex bears
        n = (x1 - g_x + g_y tan(tilt)) / x1, and tan(tilt) = mu - (mu - mu') n."""
        r, profile = 0.4, [(-9, 0), (0, 0), (2, 0), (9, 0)]
        gone, d = (1 - math.pi / 4) * r * r, (10 - 3 * math.pi) / (12 - 3 * math.pi) * r
        x, y, end = ((2 * 1 - gone * (2 - d)) / (2 - gone), (2 * 0.5 - gone * d) / (2 - gone), 2 - r)
        less = tan(30) - tan(10)
        own = math.degrees(math.atan((tan(30) - less * (end - x) / end) / (1 + less * y / end)))
        for facet, corner, side in ((1, 2, "left"), (3, 0, "right")):
            self.write(BOX, profile, 30, f"{{facet: {facet}, angle_deg: 10}}")
            text = self.path.read_text().replace("]]}\nbase", f"]], rounded: {{corners: [{{at: [{corner}, 0], radius: {r}}}]}}}}\nbase")
            self.path.write_text(text)
            cases = {case["towards"]: case for case in solve(self.path)["cases"]}
            self.holds(cases[side]["onset"]["critical_angle_deg"], own)
            self.holds(cases["right" if side == "left" else "left"]["onset"]["critical_angle_deg"], 30)

    def test_beside_under_the_block(self):
        """Where the base falls off below the sole its crest has either friction, however the block slips: it bears the share n =
        (1 + tan(tilt) / 2) / 1.5 of what presses the box on it towards the left, and (1 - tan(tilt) / 2) / 1.5 towards the
        right."""
        box = [(x - 0.5, y) for x, y in BOX]
        cases = self.solve(box, [(-9, -4), (0, 0), (9, 0)], 30, "{facet: 1, angle_deg: 8}")
        gap = (tan(30) - tan(8)) / 1.5
        for side, sign in (("left", 1), ("right", -1)):
            self.holds(cases[side]["onset"]["critical_angle_deg"], math.degrees(math.atan((tan(30) - gap) / (1 + sign * gap / 2))))
            self.holds(cases[side]["limit"]["critical_angle_deg"], 30)

    def test_motion_beside(self):
        """The page and JSON tell what slips there by its point, as it is no facet of the contact; a note says what facets that the
        block does not lie on do."""
        self.write(BOX, [(-9, 0), (0, 0), (9, 0)], 30, "{facet: 1, angle_deg: 0}", ", angle_deg: 20")
        document = solve(self.path)
        motion, = document["cases"][0]["motions"]
        self.assertEqual([(c["facet"], c["state"]) for c in motion["contacts"]],
                         [(0, "slips down-dip"), (0, "slips down-dip"), (None, "slips down-dip")])
        note, = [note for note in document["notes"] if "scene.yaml:6:21" in note["place"]]
        self.assertIn("begin where the contact ends", note["text"])
        page = run("solve", self.path)[1]
        self.assertIn("      pivot 1, on the facet beside it: slips down-dip\n", page)

    def test_at_the_very_angle(self):
        """The margin to a slide is a difference of rationals: at just the tilt the block no longer stands."""
        chain = [(0, 0), (2, 0), (2, 1), (0, 1)]
        for tilt, name in (("20", "slides"), ("19.999999999999999999999999999999", "stands")):
            case = self.solve(chain, None, 30, "{facet: 1, angle_deg: 20}", f", angle_deg: {tilt}")["left"]
            self.assertEqual(case["mechanism"], name)

    def test_with_a_bond(self):
        """Where the sole has one friction, what slides sooner by the forces along it slides; of two the
        forces along it would take the smaller, and the limit is that of contact forces."""
        for entries, sooner in (("", True), ("friction: {facets: [{facet: 2, angle_deg: 18}]}\n", False)):
            self.path.write_text(HEAD % "m" + f"block: {{outline: {points(SPLIT)}, unit_weight_kn_m3: 25}}\n"
                                 f"friction_angle_deg: 20\n{entries}loads: {{bond_kpa: 20}}\n"
                                 "tilt: {towards: left}\n")
            case, = solve(self.path)["cases"]
            self.assertEqual(case["limit"]["slides_sooner"], sooner)

    def test_under_loads(self):
        """An anchor across the sole does not turn with the tilt: W sin(tilt) = (W cos(tilt) + P)
        tan(phi) of the facet."""
        loads = "loads: {anchors: [{at: [1, 1], direction_deg: -90, force_kn: 10}]}\n"
        self.path.write_text(HEAD % "m" + "block: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 20}\n"
                             "friction_angle_deg: 35\nfriction: {facets: [{facet: 1, angle_deg: 20}]}\n" + loads +
                             "tilt: {towards: left, angle_deg: 10}\n")
        case, = solve(self.path)["cases"]
        truth = 20 + math.degrees(math.asin(10 / 40 * math.sin(math.radians(20))))
        self.holds(case["sliding"]["critical_angle_deg"], truth)
        self.holds(case["limit"]["critical_angle_deg"], truth)
        self.holds(case["sliding"]["fos"], (math.cos(math.radians(10)) + 0.25) * tan(20) / math.sin(math.radians(10)))


class Same(Case):
    """One friction, said in two ways."""

    @staticmethod
    def numbers(text):
        """Without the facets, what ran and where notes stand."""
        document = json.loads(text)
        document.pop("notes")
        for case in document["cases"]:
            case.pop("effects"), case.pop("friction_facets", None)
        return document

    def test_all_facets_as_the_scene(self):
        """To the last bit, on examples and on hard cases."""
        tried = 0
        paths = sorted(ROOT.glob("examples/*.yaml")) + sorted(ROOT.glob("tests/hard/limit_*.yaml"))
        for path in paths:
            text = path.read_text(encoding="utf-8")
            angle = re.search(r"^friction_angle_deg: (\S+)$", text, re.M)
            if angle is None or re.search(r"^(friction|frame|parameters):|csv|\$", text, re.M):
                continue
            self.path.write_text(text)
            status, plain, _ = run("solve", "--json", self.path)
            self.path.write_text(f"{text}\nfriction: {{facets: [{{x: [-1e9, 1e9], angle_deg: {angle[1]}}}]}}\n")
            own_status, own, error = run("solve", "--json", self.path)
            with self.subTest(path.name):
                self.assertEqual(own_status, status, error)
                if plain:
                    tried += 1
                    self.assertEqual(self.numbers(own), self.numbers(plain))
        self.assertGreater(tried, 20)

    def test_all_facets_another_friction(self):
        """All facets 25 degrees where the scene says 40: as if it said 25."""
        for outline, profile in ((FEET, LEVEL), (SPLIT, None), (WEDGE, NOTCH)):
            plain = self.solve(outline, profile, 25, "", ", angle_deg: 7")
            own = self.solve(outline, profile, 40, "{facet: [1, 2], angle_deg: 25}", ", angle_deg: 7")
            for side, case in plain.items():
                for part, key in (("limit", "critical_angle_deg"), ("onset", "critical_angle_deg"),
                                  ("sliding", "critical_angle_deg"), ("limit", "fos"), ("sliding", "fos_strength")):
                    a, b = case[part].get(key), own[side][part].get(key)
                    self.assertEqual(isinstance(a, dict), isinstance(b, dict))
                    if isinstance(a, dict):
                        self.assertLessEqual(abs(value(a) - value(b)), a["error"] + b["error"])
                for key in ("mechanism", "can_begin"):
                    self.assertEqual(case[key], own[side][key])

    def compared(self, one, other, turn=False):
        sides = {"left": "right", "right": "left"} if turn else {"left": "left", "right": "right"}
        for side, case in one.items():
            image = other[sides[side]]
            for part in ("limit", "onset", "sliding"):
                a, b = case[part]["critical_angle_deg"], image[part]["critical_angle_deg"]
                self.assertEqual(a is None, b is None)
                if a is not None:
                    self.assertLessEqual(abs(value(a) - value(b)), a["error"] + b["error"])
            self.assertEqual(case["mechanism"], image["mechanism"])
            self.assertEqual(case["limit"]["mechanism"], image["limit"]["mechanism"])

    def test_mirrored_shifted_scaled(self):
        entries = "{facet: 1, angle_deg: 20}, {facet: 2, angle_deg: 35}"
        one = self.solve(FEET, LEVEL, 30, entries, ", angle_deg: 22")

        def image(chain):
            return [(-x, y) for x, y in chain[::-1]]

        mirrored = "{facet: 2, angle_deg: 20}, {facet: 1, angle_deg: 35}"
        self.compared(one, self.solve(image(FEET), image(LEVEL), 30, mirrored, ", angle_deg: 22"),
                      turn=True)
        self.compared(one, self.solve([(x + 7, y - 3) for x, y in FEET], [(x + 7, y - 3) for x, y in LEVEL], 30,
                                      "{x: [6, 9], angle_deg: 20}, {x: [9, 12], angle_deg: 35}", ", angle_deg: 22"))
        self.compared(one, self.solve([(1000 * x, 1000 * y) for x, y in FEET], [(1000 * x, 1000 * y) for x, y in LEVEL],
                                      30, entries, ", angle_deg: 22", unit="mm"))

    def test_abscissas(self):
        """An upright facet lies between two abscissas from the first to before the second."""
        step = [(0, 0), (1, 0), (1, 1), (2, 1), (2, 3), (0, 3)]
        numbers = self.solve(step, step[:4], 30, "{facet: 1, angle_deg: 20}, {facet: [2, 3], angle_deg: 25}")
        between = self.solve(step, step[:4], 30, "{x: [0, 1], angle_deg: 20}, {x: [1, 2], angle_deg: 25}")
        for side, case in numbers.items():
            for own in (case, between[side]):
                own.pop("effects")
            self.assertEqual(case, between[side])

    def test_shifted_joint(self):
        """Facets of a block that was shifted along its mated base are those of the underside that it fitted,
        however far the base goes on."""
        text = (ROOT / "examples" / "block_e_shifted.yaml").read_text(encoding="utf-8")
        facets = ", ".join(f"{{facet: {k}, angle_deg: {10 + k}}}" for k in (1, 2, 3))
        touching = []
        for left in (0, 30, 60):
            own = text.replace("{left: 0, right: 0}", f"{{left: {left}, right: 0}}")
            self.path.write_text(f"{own}\nfriction: {{facets: [{facets}]}}\n")
            case, = solve(self.path)["cases"]
            touching.append([entry["touching"] for entry in case["friction_facets"]])
        self.assertEqual(touching, [touching[0]] * 3)
        self.assertGreater(sum(touching[0]), 0)

    def test_a_point_between_two_facets(self):
        """The block lies with its sole on crests of its base: each crest has the smaller friction of its
        two slopes."""
        block, base = [(0, 0), (6, 0), (6, 1), (0, 1)], [(-1, -2), (1, 0), (3, -1), (5, 0), (7, -2)]
        rough = self.solve(block, base, 40, "{facet: [1, 2], angle_deg: 30}, {facet: [3, 4], angle_deg: 20}")
        for entries in ("{facet: 1, angle_deg: 30}, {facet: 3, angle_deg: 20}",
                        "{facet: 2, angle_deg: 30}, {facet: 4, angle_deg: 20}",
                        "{facet: 1, angle_deg: 30}, {facet: 2, angle_deg: 35}, {facet: 4, angle_deg: 20}"):
            self.compared(rough, self.solve(block, base, 40, entries))


class Words(Case):
    def test_report(self):
        self.write(SPLIT, None, 30, "{facet: 2, angle_deg: 20}")
        status, out, _ = run("solve", self.path)
        self.assertEqual(status, 0)
        self.assertIn("Friction 30°, except on facets of the base, counted from the left:\n"
                      "         20° on facet 2\n", out)
        self.assertIn("φ + i = 20° + 0° = 20.000°.\n"
                      "  φ: the least of that facet and of all parallel to it.\n", out)
        self.assertLessEqual(max(len(line) for line in out.splitlines()), 80)

    def test_figure_and_map(self):
        """The figure says that the friction it names is not that of all facets; a map takes the key of a
        facet's friction."""
        self.write(FEET, LEVEL, 30, "{facet: 2, angle_deg: 20}")
        self.path.write_text(self.path.read_text().replace("towards: both", "towards: left"))
        drawing, chart = self.path.with_name("block.svg"), self.path.with_name("map.csv")
        self.assertEqual(run("solve", "--figure", drawing, self.path)[0], 0)
        self.assertTrue(drawing.exists())
        status, _, error = run("chart", "map", self.path, "--x", "friction.facets.1.angle_deg=5:40",
                               "--output", chart)
        self.assertEqual(status, 0, error)
        self.assertGreater(len(chart.read_text().splitlines()), 10)

    def test_untouched(self):
        """What the block does not touch is noted, with its place, and counts for nothing."""
        base = [(-3, -1), (-1, 0), (2, 0), (5, 0), (7, -1)]
        plain = self.solve(FEET, base, 30, "")
        entries = "{facet: 1, angle_deg: 5}, {facet: 4, angle_deg: 5}"
        cases = self.solve(FEET, base, 30, entries)
        for side, case in cases.items():
            self.assertEqual([f["touching"] for f in case["friction_facets"]], [0, 0])
            self.assertEqual(case["limit"], plain[side]["limit"])
        document = solve(self.path)
        notes = [note for note in document["notes"] if "touches none of these facets" in note["text"]]
        self.assertEqual(len(notes), 2)
        self.assertIn("scene.yaml:6:21", notes[0]["place"])
        self.assertIn("which the block does not touch", run("solve", self.path)[1])

    def test_many(self):
        """A page lists ten, JSON all of them."""
        count = 24
        sole = [(k, 0) for k in range(count + 1)]
        entries = ", ".join(f"{{facet: {k + 1}, angle_deg: {20 + k % 7}}}" for k in range(count))
        cases = self.solve(sole + [(count, 4), (0, 4)], None, 30, entries)
        self.assertEqual(len(cases["left"]["friction_facets"]), count)
        self.assertIn("and 14 more like these", run("solve", self.path)[1])

    def test_find(self):
        """The friction of one facet for a wanted limit: of the two feet, mu_2 from their closed form."""
        self.write(FEET, LEVEL, 30, "{facet: 2, angle_deg: 20}")
        self.path.write_text(self.path.read_text().replace("towards: both", "towards: left"))
        status, out, error = run("solve", "--json", "--find", "friction.facets.1.angle_deg", "--for", "limit_angle=25",
                                 "--from", "1", "--to", "40", self.path)
        self.assertEqual(status, 0, error)
        block = solve(self.path)["cases"][0]["block"]
        x, y = (value(block[f"centroid_{k}_m"]) / 4 for k in "xy")
        # tan(25) (1 + (mu - mu_1) y) = mu_1 + (mu - mu_1) x
        mu = tan(30) + (tan(30) - tan(25)) / (tan(25) * y - x)
        self.assertIn(f"{math.degrees(math.atan(mu)):.6f}", out)

    def test_derive(self):
        """Formulas of the limit know one friction; those of moments know none."""
        self.write(FEET, LEVEL, 30, "{facet: 2, angle_deg: 20}")
        status, out, error = run("derive", "--limit", self.path)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("scene.yaml:6:21: formulas of the limit take one friction angle for all facets", error)
        self.assertEqual(run("derive", self.path)[0], 0)


if __name__ == "__main__":
    main()
