# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Where the rock ends and goes on, what rounding leaves, and ties: scenes with a story each.

A face that stood as an edge of the base's own held nothing where the base ended there; a sole that
overhangs its base passed without a caution; a tie of phi + i with 90 degrees lost the report."""

import math
import random
from fractions import Fraction

from contact_oracle import Contact, Rounded
from contact_scenes import SCENES, SEED, ContactTest, mirror, points_text
from harness import main, solve


class EndFaces(ContactTest):
    """Rock ends in upright faces, and they hold what hooks over them."""

    def block(self, r):
        """A block that lies between (0, 0) and a vertex to its right and hooks down to the left of its base,
        sometimes to the right as well; its faces against the rock are upright."""
        depth, reach = Fraction(r.randint(1, 6), r.randint(1, 2)), Fraction(r.randint(1, 4))
        lying = [(Fraction(0), Fraction(0)), (Fraction(r.randint(3, 8)), Fraction(r.randint(-2, 3)))]
        if r.random() < 0.4:
            lying.append((lying[1][0] + r.randint(2, 5), Fraction(r.randint(-2, 3))))
        tip = (Fraction(0) if r.random() < 0.8 else Fraction(-1, 4), -depth)  # on the face, or off it
        hook = [(-reach, tip[1] + Fraction(r.randint(0, 2), 2)), tip]
        x1, y1 = lying[-1]
        right = []
        if r.random() < 0.3:
            deep = Fraction(r.randint(1, 4))
            right = [(x1, y1 - deep), (x1 + 2, y1 - deep)]
        end = right[-1][0] if right else x1
        top = [(end, Fraction(12 + r.randint(0, 6))), (-reach - r.randint(0, 2), Fraction(12 + r.randint(0, 6)))]
        return hook + lying + right + top, lying

    def test_between_and_step(self):
        """A mated base between two vertices and the same rock as a profile whose ends are steps, upright:
        one contact, one limit, and that of all pairs of forces; mirrored too. Hook tips rounded at times."""
        r = random.Random(SEED + 7)
        held = 0
        for number in range(max(SCENES // 6, 10)):
            outline, lying = self.block(r)
            radius = r.choice((0, 0, Fraction(1, 4)))
            friction, model = r.choice((10, 20, 30, 45, 49.8)), r.choice(("paper", "exact"))
            corner = f"  rounded: {{model: {model}, corners: [{{at: [%s, %s], radius: {radius}}}]}}\n"
            rounded = Rounded(outline, {1: radius})
            if not rounded.fits():
                continue
            steps = [(lying[0][0], lying[0][1] - 40), *lying, (lying[-1][0], lying[-1][1] - 40)]
            contact, centroid = Contact(rounded, lying), rounded.centroid(model)
            found = []
            for mirrored in (False, True):
                turn = mirror if mirrored else list
                tip = turn([outline[1]])[0]
                between = turn([lying[0], lying[-1]])
                for base in (f"mated: true, between: {points_text(between)}, beyond: {{left: 0, right: 0}}",
                             f"profile: {points_text(turn(lying))}", f"profile: {points_text(turn(steps))}"):
                    found.append((mirrored, self.cases(
                        f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(turn(outline))}\n{corner % tip}"
                        f"base: {{{base}}}\nfriction_angle_deg: {friction}\ntilt: {{towards: both}}\n")))
            with self.subTest(seed=SEED, scene=number, outline=points_text(outline), lying=points_text(lying)):
                for towards, back in (("left", "right"), ("right", "left")):
                    for mirrored, cases in found:
                        case = cases[back if mirrored else towards]
                        self.assertEqual(case["contact"]["facets"], len(contact.facets))
                        self.assertEqual(case["contact"]["points"], len(contact.points) + len(contact.corners))
                        self.compare_limit(case, contact.cone_points(), centroid, Fraction(str(friction)), towards)
                        held += any(p["kind"] for p in case["pivots"]) and len(contact.facets) > len(lying) - 1
        self.assertGreater(held, SCENES // 6)

    def test_overhanging_face(self):
        """A base mated with the hook's inner face too: upright, leaning or overhanging. Below a face that
        overhangs the rock goes on upright, so that the tip sits in a notch of it."""
        r = random.Random(SEED + 9)
        for number in range(max(SCENES // 6, 10)):
            outline, lying = self.block(r)
            outline[1] = (r.choice((Fraction(0), Fraction(1, 2), Fraction(1), Fraction(-1, 4))), outline[1][1])
            under, radius = [outline[1], *lying], r.choice((0, Fraction(1, 4), Fraction(1, 2)))
            friction, model = r.choice((10, 20, 30, 45)), r.choice(("paper", "exact"))
            rounded = Rounded(outline, {1: radius})
            if not rounded.fits() or under[0][0] >= under[-1][0]:
                continue
            contact, centroid = Contact(rounded, under), rounded.centroid(model)
            for mirrored in (False, True):
                turn = mirror if mirrored else list
                x, y = turn([outline[1]])[0]
                text = (f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(turn(outline))}\n"
                        f"  rounded: {{model: {model}, corners: [{{at: [{x}, {y}], radius: {radius}}}]}}\n"
                        f"base: {{mated: true, between: {points_text(turn([under[0], under[-1]]))}}}\n"
                        f"friction_angle_deg: {friction}\ntilt: {{towards: both}}\n")
                with self.subTest(seed=SEED, scene=number, text=text):
                    cases = self.cases(text)
                    for towards, back in (("left", "right"), ("right", "left")):
                        case = cases[back if mirrored else towards]
                        self.compare_contact(case, contact)
                        self.compare_sliding(case, contact, centroid, friction, towards)
                        self.compare_limit(case, contact.cone_points(), centroid, friction, towards)
                        if not mirrored:
                            self.compare_pivots(case, contact, centroid, towards)

    def test_hook(self):
        """A hook that stopped at its base's end: "not even on level ground"; the face holds it up to
        13.722332369794 degrees, by all pairs of forces."""
        outline = [(-5, 5), (0, -4), (1, -8), (1, -5), (7, -2)]
        for turn, towards, ends in ((list, "left", (0, 5)), (mirror, "right", (5, 0))):
            between = turn([(1, -5), (7, -2)])
            for base in (f"mated: true, between: {points_text(between)}, beyond: {{left: {ends[0]}, right: {ends[1]}}}",
                         f"profile: {points_text(turn([(0, -20), (1, -20), (1, -5), (7, -2), (12, -2)]))}"):
                case = self.cases(f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(turn(outline))}\n"
                                  f"base: {{{base}}}\nfriction_angle_deg: 49.8\ntilt: {{towards: {towards}}}\n")[towards]
                self.near(case["limit"]["critical_angle_deg"], 13.722332369794, 1e-12)


class Corners(ContactTest):
    def scene(self, outline, corners, base, towards, model="exact"):
        return (f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(outline)}\n  rounded: {{model: {model}, "
                f"corners: [{corners}]}}\n  unit_weight_kn_m3: 26\nbase: {{{base}}}\nfriction_angle_deg: 10\n"
                f"tilt: {{towards: {towards}, angle_deg: 5}}\n")

    def test_rock_beyond(self):
        """Blocks whose rounded toe was held by rock that it does not touch: level ground 0.95 m away, the
        flank of a notch 0.14 m away. They slide as on a base that ends at the toe."""
        for turn, towards, end in ((list, "left", "left_end"), (mirror, "right", "right_end")):
            for model in ("paper", "exact"):
                for reach in (0, 5):
                    case = self.cases(self.scene(turn([(0, 0), (2, 1), (2, 5), (0, 5)]),
                                                 f"{{at: {end}, radius: 1/2}}",
                                                 f"mated: true, beyond: {{left: {reach}, right: {reach}}}",
                                                 towards, model))[towards]
                    self.near(case["limit"]["critical_angle_deg"], 10 - math.degrees(math.atan(Fraction(1, 2))))
                    self.assertEqual(case["mechanism"], "slides")
                    self.assertEqual(case["contact"]["points"], 0)
                notch = points_text(turn([(-1, 1), (0, 0), (2, 0)]))
                case = self.cases(self.scene(turn([(0, 0), (2, 0), (2, 4), (0, 4)]), f"{{at: {end}, radius: 1/10}}",
                                             f"profile: {notch}", towards, model))[towards]
                self.near(case["limit"]["critical_angle_deg"], 10, 1e-12)
                self.assertFalse(case["limit"]["base_matters"])

    def test_cohesion_of_what_is_left(self):
        """Cohesion acts on what rounding leaves of the contact: a square of side 2 on level ground, its toe
        rounded by 1/2, slides where W sin a = W cos a tan 10 + c 1.5."""
        self.path.write_text(self.scene([(0, 0), (2, 0), (2, 2), (0, 2)], "{at: left_end, radius: 1/2}",
                                        "mated: true", "left", "paper").replace(
                                            "tilt:", "loads: {cohesion_kpa: 4}\ntilt:"))
        case = solve(self.path)["cases"][0]
        weight, slope = 26 * 4, math.tan(math.radians(10))
        angle = math.degrees(math.asin(4 * 1.5 / weight / math.hypot(1, slope)) + math.atan(slope))
        self.near(case["sliding"]["critical_angle_deg"], angle, 1e-12)

    def test_tip_with_a_notch(self):
        """A notch from above that reaches into the tip which rounding takes off: no such block. Radius 7
        leaves the notch's bottom (1, 1) beyond the arc; 3 leaves it within."""
        outline = [(0, 0), (10, 0), (10, 10), (1, 1), (0, 10)]
        corner = "{at: [0, 0], radius: %s}"
        base = "mated: true, between: [[0, 0], [10, 0]]"
        refused = self.refused(self.scene(outline, corner % 7, base, "left"))
        self.assertIn("reaches across this arc", refused)
        self.assertIsNone(self.refused(self.scene(outline, corner % 3, base, "left")))

    def test_nothing_left(self):
        """A block that would stand on a rounded tip alone touches nothing."""
        refused = self.refused(self.scene([(0, 0), (2, 2), (0, 4), (-2, 2)], "{at: [0, 0], radius: 1/2}",
                                          "profile: [[-3, 1], [0, 0], [3, 1]]", "left"))
        self.assertIn("with only corners that are rounded off", refused)

    def test_rolling_off_the_rock(self):
        """A low slab rolls on its toe of radius 19 to a new rest, 19 t from where it began after a turn by t.
        On rock that ends sooner it goes over. By the arm of the weight, as in test_rounded.py."""
        scene = ("topple: 1\nlength_unit: mm\nblock:\n  slab: {width: 40, height: 30}\n  rounded: {model: paper, "
                 "corners: [{at: %s, radius: 19}]}\nbase: {profile: %s}\ntilt: {towards: %s, angle_deg: 10}\n")
        turn_deg = None
        for end, towards, turn in (("left_end", "left", list), ("right_end", "right", lambda b: [(40 - x, y) for x, y in b[::-1]])):
            self.path.write_text(scene % (end, points_text(turn([(-100, 0), (40, 0)])), towards))
            toppling = solve(self.path)["cases"][0]["toppling"]
            self.assertEqual(toppling["beyond"], "rolls back")
            turn_deg = toppling["rest_turn_deg"]["value"]
            rolled = 19 * math.radians(turn_deg)
            self.assertLess(rolled, 19)
            for share, beyond in ((Fraction(11, 10), "rolls back"), (Fraction(9, 10), "topples")):
                first = 19 - Fraction(round(rolled * 10**9), 10**9) * share
                self.path.write_text(scene % (end, points_text(turn([(first, 0), (40, 0)])), towards))
                self.assertEqual(solve(self.path)["cases"][0]["toppling"]["beyond"], beyond)


class GoingOn(ContactTest):
    """What the report says of a base that goes on where the scene's ends below the block."""

    def limits(self, outline, base, friction, turn, towards):
        text = (f"topple: 1\nlength_unit: m\nblock: {{outline: {points_text(turn(outline))}}}\n"
                f"base: {{{base(turn)}}}\nfriction_angle_deg: {friction}\ntilt: {{towards: {towards}}}\n")
        return self.cases(text)[towards]["limit"]

    def test_overhanging_sole(self):
        """A sole that overhangs its base, level or inclined, the base ending at a vertex or inside an edge:
        `otherwise` is the limit of the block whose base goes on along the sole and then level."""
        r = random.Random(SEED + 11)
        mattered = 0
        for number in range(max(SCENES // 8, 10)):
            width, overhang = Fraction(r.randint(6, 14)), Fraction(r.randint(1, 5))
            slope = r.choice((Fraction(0), Fraction(0), Fraction(1, 2), Fraction(-1, 3), Fraction(3, 2)))
            on = lambda x: (x, slope * x)
            start, end = on(Fraction(0)), on(width)
            top = Fraction(max(0, slope * width)) + r.randint(4, 16)
            inner = r.random() < 0.5
            sole = [start, end] if inner else [start, on(overhang), end]
            outline = sole + [(width, top), (Fraction(0), top)]
            friction = r.choice((5, 20, 30, 40))
            foot = on(overhang)
            for turn, towards in ((list, "left"), (mirror, "right")):
                if inner:
                    base = lambda t: f"profile: {points_text(t([foot, end]))}"
                else:
                    base = lambda t: (f"mated: true, between: {points_text(t([foot, end]))}, "
                                      "beyond: {left: 0, right: 0}")
                level = [(start[0] - 3, start[1]), start, end]
                whole = lambda t: f"profile: {points_text(t(level))}"
                with self.subTest(scene=number, outline=points_text(outline), foot=foot, towards=towards):
                    own = self.limits(outline, base, friction, turn, towards)
                    other = self.limits(outline, whole, friction, turn, towards)
                    told = own["otherwise"]
                    self.assertFalse(own["base_beyond_toe"])
                    self.assertTrue(told["base_beyond_toe"])
                    self.assertEqual(told["mechanism"] == "interlocked", other["mechanism"] == "interlocked")
                    if other["critical_angle_deg"] is None:
                        self.assertIsNone(told["critical_angle_deg"])
                        continue
                    self.near(told["critical_angle_deg"], other["critical_angle_deg"]["value"])
                    differ = (own["critical_angle_deg"] is None or
                              abs(own["critical_angle_deg"]["value"] - other["critical_angle_deg"]["value"]) > 1e-9)
                    if differ:
                        self.assertTrue(own["base_matters"])
                    mattered += differ
        self.assertGreater(mattered, SCENES // 16)

    def test_square(self):
        """A square of 12 on the two thirds of its sole: 18.435 degrees; 40, the friction angle, on a base
        that goes on."""
        for turn, towards in ((list, "left"), (mirror, "right")):
            base = lambda t: f"mated: true, between: {points_text(t([(4, 0), (12, 0)]))}, beyond: {{left: 0, right: 0}}"
            own = self.limits([(0, 0), (4, 0), (12, 0), (12, 12), (0, 12)], base, 40, turn, towards)
            self.near(own["critical_angle_deg"], math.degrees(math.atan(Fraction(1, 3))))
            self.near(own["otherwise"]["critical_angle_deg"], 40)
            self.assertTrue(own["base_matters"])

    def test_leaning_side(self):
        """The side of a block that leans out over its toe is a face, not a sole: level ground past the toe
        changes nothing."""
        for turn, towards in ((list, "left"), (mirror, "right")):
            base = lambda t: f"mated: true, between: {points_text(t([(0, 0), (4, 0)]))}, beyond: {{left: 0, right: 0}}"
            own = self.limits([(0, 0), (4, 0), (2, 8), (-2, 8)], base, 30, turn, towards)
            self.assertFalse(own["base_matters"])


class Ties(ContactTest):
    def test_sliding_never_at_90(self):
        """phi + i = 90 degrees, on facets of 45 at phi = 45, under loads and tilts that tie too: Patton's
        formula never slides, and the report is whole. Cohesion must not lose the direction of a force
        that its factors cancel in."""
        loads = ("", "loads: {cohesion_kpa: 47}", "loads: {cohesion_kpa: 0}", "loads: {seismic: {horizontal: 0}}",
                 "loads: {bond_kpa: 3}")
        for outline, towards in (([(0, 4), (4, 0), (8, 0), (8, 20), (0, 20)], "left"),
                                 ([(0, 0), (4, 0), (8, 4), (8, 20), (0, 20)], "right"),
                                 ([(0, 4), (4, 0), (8, 4), (8, 30), (0, 30)], "left")):
            for load in loads:
                for tilt in ("", ", angle_deg: 45", ", angle_deg: 5"):
                    with self.subTest(outline=outline, load=load, tilt=tilt):
                        case = self.cases(
                            f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(outline)}\n"
                            f"  unit_weight_kn_m3: 26\nbase: {{mated: true}}\nfriction_angle_deg: 45\n{load}\n"
                            f"tilt: {{towards: {towards}{tilt}}}\n")[towards]
                        self.assertIsNone(case["sliding"]["critical_angle_deg"])

    def facets(self, case):
        return [case[part]["facet"] and [(p["x_m"]["value"], p["y_m"]["value"]) for p in case[part]["facet"]]
                for part in ("sliding", "limit") if "facet" in case[part]]

    def test_collinear_facets(self):
        """Of facets on one line the first from the toe is named, whatever the digits, the price, and the
        side."""
        for slope in (Fraction(0), Fraction(1, 8)):
            under = [(Fraction(x), slope * x) for x in (0, 5, 9, 14, 20)]
            outline = under + [(Fraction(20), Fraction(6)), (Fraction(0), Fraction(6))]
            for turn, towards in ((list, "left"), (mirror, "right")):
                self.path.write_text(
                    f"topple: 1\nlength_unit: m\nblock:\n  outline: {points_text(turn(outline))}\n"
                    "  unit_weight_kn_m3: 26\nbase: {mated: true}\nfriction_angle_deg: 25\n"
                    f"tilt: {{towards: {towards}}}\n")
                first = [tuple(map(float, p)) for p in turn(under[:2])]
                for options in (("--digits", 3), ("--digits", 12), ("--digits", 40), ("--digits", 120),
                                ("--level", "ball")):
                    case = solve(self.path, *options)["cases"][0]
                    self.assertEqual(case["limit"]["mechanism"], "slides")
                    self.assertEqual(self.facets(case), [first, first], options)


if __name__ == "__main__":
    main()
