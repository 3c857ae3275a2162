# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which motion of many blocks can begin (docs/blocks_in_contact.md): against closed forms, against the onset of one block, and every
motion that is told against Newton's and Coulomb's laws in rationals."""

import json
import math
import random
from fractions import Fraction

from beginning_oracle import Beginning
from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import EXAMPLE, Pile, arch, box, text_of, turned, wall


def tilted(angle, side="left"):
    return f"tilt: {{towards: {side}, angle_deg: {angle}}}"


def decimals(pile):
    return pile.moved(lambda x, y: (float(x), float(y)))


def on_ground():
    return Pile().add("g", box(-50, -1, 60, 0), True)


class BlockMotions(GoverningCase):
    def case(self, pile, friction, more="tilt: {towards: left}", status=0, options=()):
        """Solved; a motion that is told is one."""
        done, out, err = run("solve", "--json", *options, self.scene(pile.scene(friction, more)))
        self.assertEqual(done, status, err)
        solved = json.loads(out)
        own = solved["cases"][0]
        if "start" in own:
            self.assertEqual(Beginning(pile, friction, solved["contacts"], own).holds(), "", (pile.blocks, friction, more))
        return own

    def test_level_ground(self):
        """Boxes on level ground stand, whatever the friction, and without any."""
        stack = on_ground().add("a", box(0, 0, 2, 1)).add("b", box(0, 1, 2, 2)).add("c", box(1, 2, 2, 3))
        for pile in (on_ground().add("a", box(0, 0, 2, 1)), stack, wall(3, 3)):
            for friction in (30, 0):
                own = self.case(pile, friction)
                self.assertEqual(own["verdict"], "stands")
                self.assertEqual((own["standing_fos"], own["standing_fos_is"]), (1000, "at least this"))
                self.assertNotIn("moving_fos", own)
        self.assertEqual(self.case(stack, 30, "required_fos: 2")["meets_required"], "met")
        over = on_ground().add("a", box(0, 0, 2, 1)).add("b", box(1, 1, 4, 2))
        self.assertEqual(self.case(over, 30)["verdict"], "collapses")

    def test_many_without_friction(self):
        """177 bricks in a wall need none, wherever it lies; nor a block in a notch, that pushes aside. Tilted by a hair they need some, and
        then so many are not decided; page and sheet say that motions were not looked for."""
        own = wall(13, 13)
        for pile in (own, own.moved(lambda x, y: (Fraction(x) / 8 - 10**6, Fraction(y) / 8 + 999)), own.moved(lambda x, y: (x, 3 * y))):
            self.assertEqual(self.case(decimals(pile), 0)["standing_fos_is"], "at least this")
        self.assertEqual(self.case(own, 30, tilted(1e-9))["verdict"], "can be held")
        text = self.scene(own.scene(30, tilted(1e-9)))
        self.assertIn("not examined: that is done for up to\n  48 free blocks.", run("solve", "--report", self.folder / "sheet.md", text)[1])
        sheet = (self.folder / "sheet.md").read_text()
        self.assertIn("| not examined |", sheet)
        self.assertIn("Up to which factor no motion can begin was not examined: that is done for up to 48 free blocks.", sheet)
        notch = Pile().add("g", [(-9, -5), (9, -5), (9, 2), (2, 2), (0, 0), (-1, 2), (-9, 2)], True).add("wedge", [(0, 0), (2, 2), (0.5, 4), (-1, 2)])
        self.assertEqual(self.case(notch, 0)["verdict"], "stands")

    def test_tilted_walls(self):
        """Bricks in bond, tilted: two courses and a lower one of three bricks stand, proven nearly as far as forces can hold them; so do four
        blocks about a point, of which the corners meet; and five in two courses, as they lie, which was not decided."""
        quarters = on_ground().add("a", box(-2, 0, 0, 3)).add("b", box(0, 0, 2, 3)).add("c", box(-2, 3, 0, 6)).add("d", box(0, 3, 2, 6))
        for pile, friction, share in ((wall(2, 1), 35, 0.99), (wall(1, 2), 35, 0.99), (quarters, 30, 0)):
            for side, sign in (("left", 1), ("right", -1)):
                own = self.case(pile.moved(lambda x, y, s=sign: (s * x, y)), friction, tilted(2, side))
                self.assertEqual(own["verdict"], "stands")
                self.assertGreaterEqual(own["standing_fos"], share * own["fos"]["value"])
                self.assertLessEqual(own["standing_fos"], own["fos"]["value"] + own["fos"]["error"])
        self.assertEqual(self.case(wall(2, 2), 35, tilted(2))["verdict"], "stands")

    def both_ways(self, pile, friction, angle):
        """Tilted to the left; its mirror image with its blocks in the other order, to the right."""
        image = Pile()
        for name, points, ground in pile.blocks[::-1]:
            image.add(name, [(-x, y) for x, y in points[::-1]], ground)
        return [self.case(own, friction, tilted(angle, side)) for own, side in ((pile, "left"), (image, "right"))]

    def test_rows(self):
        """Bricks side by side on a slope of 2°, φ = 35°: what a brick may do is divided at each joint, and what is refuted at one is learned
        for all. Four stood as they lie, and five were not decided. Now it is told how far four stand, all the way, as what one step of that
        has proven is known in the next; and by a virtual motion how far seven do. Whichever side they go to, and in whichever order they are listed, the search is
        the same one, so that as much is told where its work is spent."""
        for count, known in ((4, 20), (5, 2)):
            row = on_ground()
            for k in range(count):
                row.add(f"b{k}", box(2 * k, 0, 2 * k + 2, 1))
            both = self.both_ways(row, 35, 2)
            for own in both:
                self.assertEqual(own["verdict"], "stands")
                self.assertGreaterEqual(own["standing_fos"], known)
                self.assertLessEqual(own["standing_fos"], math.tan(math.radians(35)) / math.tan(math.radians(2)))
            for key in ("standing_fos", "standing_angle_deg"):
                self.assertAlmostEqual(both[1][key], both[0][key], delta=1e-4 * both[0][key])
        for k in (5, 6):
            row.add(f"b{k}", box(2 * k, 0, 2 * k + 2, 1))
        for own in self.both_ways(row, 35, 2):
            self.assertGreaterEqual(own["standing_fos"], 15)
            self.assertLessEqual(own["standing_fos"], math.tan(math.radians(35)) / math.tan(math.radians(2)))
            self.assertGreaterEqual(own["standing_angle_deg"], 30)

    def test_wedged(self):
        """Blocks that lean on each other, of which three or four may stay wedged while one moves: of what each contact does forces hold each
        other without any load, so that no acceleration is resisted by none of them; but by none at the one that moves. These were not
        decided, or proven in another order alone; now they stand up to the limit of forces."""
        pile, at = Pile().add("g", [(-61.25, -5), (58.75, -5), (60, 0), (-60, 0)], True), 0
        for k, (width, high) in enumerate(((2.5, 1.5), (0.5, 3), (2, 1.5), (0.5, 0.5), (0.5, 2.5))):
            pile.add(f"b{k}", [(at, 0), (at + width, 0), (at + width + high / 4, high), (at + high / 4, high)])
            at += width
        pile.blocks = [(name, [(-x, y) for x, y in points[::-1]], ground) for name, points, ground in pile.blocks]
        for own in self.both_ways(pile, 50, 10):
            self.assertEqual(own["verdict"], "stands")
            self.assertGreater(own["standing_fos"], 0.999 * own["fos"]["value"])
            self.assertLessEqual(own["standing_fos"], own["fos"]["value"] + own["fos"]["error"])

    def test_arches(self):
        """Voussoirs of an arch: seven were certain to stand with their strength divided by 1.08, and at no tilt; nine not at all. Now both stand
        up to the tilt that forces can hold, and fifteen as they lie, whichever way they lean."""
        for count in (7, 9):
            own = arch(count, 0.3).moved(lambda x, y: (round(float(x), 6), round(float(y), 6)))
            for case in self.both_ways(own, 35, 0):
                self.assertEqual(case["verdict"], "stands")
                self.assertGreater(case["standing_fos"], 1.75)
                self.assertLess(case["standing_fos"], case["fos"]["value"])
                self.assertGreater(case["standing_angle_deg"], 0.999 * case["critical_angle_deg"]["value"])
                self.assertLess(case["standing_angle_deg"], case["critical_angle_deg"]["value"])
        own = arch(15, 0.3).moved(lambda x, y: (round(float(x), 6), round(float(y), 6)))
        self.assertEqual(self.case(own, 35, tilted(0))["verdict"], "stands")

    def test_slopes(self):
        """One box, and two on each other: it stands up to tan φ / tan α, and to φ where it does not topple before. The required factor is
        met on one side of that, and not on the other."""
        one = on_ground().add("a", box(0, 0, 2, 1))
        for pile in (one, on_ground().add("a", box(0, 0, 2, 1)).add("b", box(0, 1, 2, 2))):
            own = self.case(pile, 30, tilted(10))
            self.assertEqual(own["verdict"], "stands")
            known = math.tan(math.radians(30)) / math.tan(math.radians(10))
            self.assertLessEqual(own["standing_fos"], known)
            self.assertGreaterEqual(own["standing_fos"], known * (1 - 2e-5))
            self.assertLessEqual(own["standing_angle_deg"], 30)
            self.assertGreaterEqual(own["standing_angle_deg"], 29.99)
        for required, meets in ((3.27, "met"), (3.28, "not met")):
            self.assertEqual(self.case(one, 30, tilted(10) + f"\nrequired_fos: {required}", status=meets != "met")["meets_required"], meets)
        slab = self.case(on_ground().add("a", box(0, 0, 1, 3)), 30, tilted(10, "right"))
        self.assertAlmostEqual(slab["standing_angle_deg"], math.degrees(math.atan(1 / 3)), delta=1e-4)
        self.assertAlmostEqual(slab["moving_angle_deg"], math.degrees(math.atan(1 / 3)), delta=1e-4)

    def test_pinched_brick(self):
        """A brick w between two others W is held by wedging above tan φ = 1 / √(1 + 2 W / w), and falls at every friction."""
        for friction in (20, 40, 60):
            pile = Pile().add("g", box(-9, -1, 9, 0), True).add("l", box(-4, 0, -1, 3)).add("r", box(1, 0, 4, 3)).add("m", box(-1, 1, 1, 2))
            own = self.case(pile, friction)
            self.assertEqual(own["verdict"], "may move")
            self.assertEqual(own["start"]["motions"][3]["mechanism"], "slides")
            self.assertAlmostEqual(own["fos"]["value"], math.tan(math.radians(friction)) * math.sqrt(1 + 2 * 9 / 2), delta=1e-5)
            self.assertEqual((round(own["moving_fos"], 9), own["moving_fos_is"]), (0.001, "at most this"))
            self.assertEqual(own["moving_angle_deg"], 0)
            self.assertEqual(self.case(pile, friction, "required_fos: 1.01", status=1)["meets_required"], "not met")

    def test_among_many(self):
        """The brick falls as well where 24 boxes more stand by it, and lie about it in any order."""
        for turn in (1, -1):
            pile = Pile()
            blocks = [("g", box(-99, -1, 99, 0), True), ("l", box(-4, 0, -1, 3), False), ("r", box(1, 0, 4, 3), False), ("m", box(-1, 1, 1, 2), False)]
            for own in (blocks + [(f"b{k}", box(3 * k + 6, 0, 3 * k + 8, 1 + k % 3), False) for k in range(24)])[::turn]:
                pile.add(*own)
            own = self.case(pile, 40)
            self.assertEqual((own["verdict"], round(own["moving_fos"], 9)), ("may move", 0.001))
            self.assertEqual([m["block"] for m in own["start"]["motions"] if m["mechanism"] != "stands"], ["m"])

    def test_among_very_many(self):
        """Of more than 48 blocks no motion was looked for, so that a brick which falls was said to be held. Now one is, and proven. Up
        to which factor none can begin is still not examined."""
        pile = Pile()
        pile.add("g", box(-99, -1, 299, 0), True).add("l", box(-4, 0, -1, 3)).add("r", box(1, 0, 4, 3)).add("m", box(-1, 1, 1, 2))
        for k in range(60):
            pile.add(f"b{k}", box(3 * k + 6, 0, 3 * k + 8, 1 + k % 3))
        own = self.case(pile, 40)
        self.assertEqual((own["verdict"], own["moving_fos"], own["motions_sought"]), ("may move", 1, "too many blocks"))
        self.assertEqual([m["block"] for m in own["start"]["motions"] if m["mechanism"] != "stands"], ["m"])
        self.assertEqual(self.case(pile, 40, "required_fos: 1.01", status=1)["meets_required"], "not met")

    def test_many_columns(self):
        """A hundred columns: the estimate is below the limit by forces, and a motion is proven within a tenth of it."""
        heights = [40 * min((k + 0.5) / 62.5, (100 - k - 0.5) / 37.5) + 2 for k in range(100)]
        text = ("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 60\nblock: {unit_weight_kn_m3: 25}\n"
                f"columns: {{width: 1.6, step: 0.16, heights: {heights}}}\n")
        done, out, err = run("solve", "--json", self.scene(text))
        self.assertEqual(done, 0, err)
        own = json.loads(out)["cases"][0]
        self.assertEqual(own["verdict"], "can be held")
        self.assertLess(own["undilated_fos"], 0.9 * own["fos"]["value"])
        self.assertLessEqual(own["undilated_fos_spread"], 0.05 * own["undilated_fos"])
        self.assertLess(own["moving_fos"], 1.1 * own["undilated_fos"])
        page = run("solve", self.scene(text))[1]
        self.assertIn(f"estimate, joints that do not dilate   {math.floor(100 * own['undilated_fos']) / 100:.2f}, strength reduction, not proven\n", page)

    def test_as_a_scene_of_one(self):
        """Random blocks on random profiles of one to three facets, as one block on its base and as two blocks: what is certain of the one
        is not denied of the other, and both sides enclose the onset by strength, which they mostly narrow to 2e-5."""
        draw, narrow, standing = random.Random(7), 0, 0
        for _ in range(rounds(12, 300)):
            profile, x = [(0, draw.randint(-10, 10) / 5)], 0
            for _ in range(draw.randint(1, 3)):
                x += draw.randint(3, 10)
                profile.append((x / 5, draw.randint(-12, 12) / 5))
            top = max(y for _, y in profile) + draw.randint(4, 20) / 5
            left, right = draw.randint(-6, 6) / 5, x / 5 + draw.randint(-6, 6) / 5
            if left >= right:
                continue
            outline = [*profile, (right, top), (left, top)]
            friction, tilt = draw.choice((20, 40, 50, 60, 70)), tilted(draw.choice((0, 3, 8, 15, 25)), draw.choice(("left", "right")))
            status, out, _ = run("solve", "--json", self.scene(
                f"topple: 1\nlength_unit: m\nblock: {{outline: {text_of(outline)}, unit_weight_kn_m3: 25}}\n"
                f"base: {{profile: {text_of(profile)}}}\nfriction_angle_deg: {friction}\n{tilt}\n"))
            if status != 0:
                continue
            one = json.loads(out)["cases"][0]
            ground = [(profile[0][0], -20), (profile[-1][0], -20), *reversed(profile)]
            own = self.case(Pile().add("g", ground, True).add("b", outline), friction, tilt)
            where = (outline, friction, tilt)
            if own["verdict"] == "stands":
                self.assertIn(one["mechanism"], ("stands", "interlocked"), where)
            if own["verdict"] == "may move":
                self.assertNotIn(one["mechanism"], ("stands", "interlocked"), where)
            if own["verdict"] == "stands" and one["onset"]["fos"] and one["onset"]["windows"] and "moving_fos" in own:
                onset = one["onset"]["fos"]["value"]
                if one["governing_fos"]["fos"]["value"] == onset and own["fos"]["value"] >= onset * (1 - 1e-6):
                    self.assertGreaterEqual(own["moving_fos"], onset * (1 - 1e-9), where)
                    standing += 1
                    narrow += own["moving_fos"] <= own["standing_fos"] * (1 + 2e-5)
        self.assertGreaterEqual(2 * narrow, standing)

    def test_images(self):
        """Mirrored, renumbered, in a mine's coordinates, with edges cut in pieces, beside a block that stands far off, and in millimetres:
        nothing is certain to stand where in another image a motion can begin; and what is certain to stand is as much."""
        def cut(points):
            """Edges of the ground, and where both blocks touch, by way of more points."""
            more = [(2.5, 0), (0.5, 0), (2, 0.25), (2, 0.75)]
            return [p for a, b in zip(points, points[1:] + points[:1])
                    for p in [a, *sorted((q for q in more if (b[0] - a[0]) * (q[1] - a[1]) == (b[1] - a[1]) * (q[0] - a[0])
                                          and 0 < math.dist(q, a) < math.dist(a, b) > math.dist(q, b)), key=lambda q: math.dist(q, a))]]

        pile = on_ground().add("low", box(0, 0, 2, 1)).add("column", box(2, 0, 3, 5))
        shuffled, in_pieces, beside = Pile(), Pile(), Pile()
        shuffled.blocks = pile.blocks[::-1]
        in_pieces.blocks = [(name, cut(points), ground) for name, points, ground in pile.blocks]
        self.assertEqual([len(points) for _, points, _ in in_pieces.blocks], [6, 7, 7])
        beside.blocks = [*pile.blocks, ("far", box(20, 0, 28, 1), False)]
        own = [self.case(pile, 30, tilted(5)), self.case(pile.moved(lambda x, y: (-x, y)), 30, tilted(5, "right")),
               self.case(shuffled, 30, tilted(5)), self.case(in_pieces, 30, tilted(5)), self.case(beside, 30, tilted(5)),
               self.case(pile.moved(lambda x, y: (x + Fraction(5123452, 10), y + 6789012)), 30, tilted(5))]
        done = run("solve", "--json", self.scene(pile.moved(lambda x, y: (1000 * x, 1000 * y)).scene(30, tilted(5), unit="mm")))
        own.append(json.loads(done[1])["cases"][0])
        for other in own:
            self.assertEqual(other["verdict"], own[0]["verdict"])
            for key in ("standing_fos", "standing_angle_deg"):
                self.assertAlmostEqual(other[key], own[0][key], delta=1e-3 * own[0][key], msg=key)
            self.assertGreater(other["moving_angle_deg"], max(one["standing_angle_deg"] for one in own))
        aslant, angle = turned(pile)
        other = self.case(aslant, 30, tilted(angle - 5, "right"))
        self.assertEqual(other["verdict"], own[0]["verdict"])
        self.assertAlmostEqual(other["standing_fos"], own[0]["standing_fos"], delta=1e-3 * own[0]["standing_fos"])

    def test_columns(self):
        """Goodman and Bray's slope can be held up to a divisor of 1.19, theirs is 1, and a motion can begin at 0.83; a shorter one of six
        columns is held against the laws in rationals, the whole one in a long check."""
        own = json.loads(run("solve", "--json", EXAMPLE)[1])["cases"][0]
        self.assertEqual(own["verdict"], "may move")
        self.assertLess(own["moving_fos"], 0.83)
        self.assertLess(own["moving_angle_deg"], 29)
        self.assertEqual(run("solve", "--fail-below", "1", EXAMPLE)[0], 1)
        for count, crest in ((6, 4),) if rounds(0, 1) == 0 else ((6, 4), (16, 10)):
            ground = [(-10, 0), (-10, -20), (10 * count + 10, -20), (10 * count + 10, count - 1)]
            for n in range(count - 1, 0, -1):
                ground += [(10 * n, n), (10 * n, n - 1)]
            pile = Pile().add("g", ground, True)
            for n in range(1, count + 1):
                height = 4 * n if n <= crest else 4 * crest - 6 * (n - crest)
                pile.add(f"c{n}", box(10 * n - 10, n - 1, 10 * n, n - 1 + height))
            self.case(pile, 38.15, "slope: {dip_deg: 30, towards: left}")

    def test_cohesion(self):
        """A motion begins where a box overcomes all of the cohesion along its base, however many pieces that has, and a slab all of the tension
        as it topples; none does before (test_cohesive_motions.py)."""
        loads = "\nloads: {cohesion_kpa: 5}"
        self.assertEqual(self.case(on_ground().add("a", box(0, 0, 2, 1)), 30, tilted(0) + loads)["verdict"], "stands")
        sine, cosine = math.sin(math.radians(10)), math.cos(math.radians(10))
        known = (5 * 2 + 50 * cosine * math.tan(math.radians(30))) / (50 * sine)
        split = Pile().add("g", [(-50, -1), (60, -1), (60, 0), (1, 0), (-50, 0)], True)
        for pile in (on_ground(), split):
            own = self.told(pile.add("a", box(0, 0, 2, 1)), tilted(10) + loads)
            self.assertEqual(own["verdict"], "stands")
            self.assertNotIn("motions_sought", own)
            self.assertGreaterEqual(own["moving_fos"], known)
            self.assertAlmostEqual(own["moving_fos"], known, delta=2e-5)
        own = self.told(on_ground().add("a", box(0, 0, 1, 3)), tilted(10) + "\nloads: {cohesion_kpa: 100, bond_kpa: 10}")
        angle = math.radians(own["moving_angle_deg"])
        self.assertAlmostEqual(75 * (1.5 * math.sin(angle) - 0.5 * math.cos(angle)), 10 * 0.5, delta=1e-4)

    def told(self, pile, more):
        return json.loads(run("solve", "--json", self.scene(pile.scene(30, more)))[1])["cases"][0]


if __name__ == "__main__":
    main()
