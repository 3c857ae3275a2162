# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`joint: {shift: …}`: what it costs a block to be displaced along the base that it fits.

A mated base holds a block in full contact; displaced by some millimetres it rides up on what is left. On regular teeth
all of that is a formula: after one wavelength nothing has changed, after half of one the crests stand on crests. On
other undersides the lift, the gaps and the contact ratio are computed here anew, in fractions where the block does not
turn, and in doubles, in the pose that is reported, where it does."""

import math
import random
from fractions import Fraction

import rest_oracle
from harness import main, run, solve
from joint_case import A, B, C, SEED, JointCase, gaps_of, text, top_at, underside

SCENES = 60


class Joint(JointCase):
    def test_teeth(self):
        """d the distance from the nearest fit, a whole number of wavelengths away: the block lies c d/a higher; of each
        wavelength one flank touches, over a - d, the other gapes by 2 c d/a, and what lies between is closed to a
        closure of e over its share of that: (1 - d/a)/2 + e/(2c) of all, while e is less than the largest gap."""
        closure = Fraction(3, 10)
        for count in (4, 6):
            for shift in (0, 5, -5, 12, Fraction(-47, 3), 30, -30, 41, 60, -60):
                shift = Fraction(shift)
                d = min(shift % (2 * A), -shift % (2 * A))
                with self.subTest(count=count, shift=shift):
                    case = self.teeth(count, joint=f"{{shift: {shift}, closure: {closure}}}")
                    joint, contact = case["joint"], case["contact"]
                    self.assertEqual(case["rest"]["turns"], 0)
                    self.same(joint["shift_m"], shift)
                    self.same(case["rest"]["moved_y_m"], C * d / A)
                    self.same(case["rest"]["moved_x_m"], 0)
                    self.same(joint["largest_gap_m"], 2 * C * d / A)
                    self.same(joint["mean_gap_m"], C * d / A)
                    self.same(joint["above_base_m"], count * A)
                    self.same(contact["contact_ratio"], 1 if d == 0 else (1 - d / A) / 2, 1)
                    self.same(joint["matching"], 1 if d == 0 else (1 - d / A) / 2 + closure / (2 * C), 1)
                    self.assertFalse(contact["mated"])

    def test_no_shift(self):
        """Where it was, and one wavelength on, the block is what it is on its mated base."""
        block = f"teeth: {{count: 4, width: {A}, height: {B}, depth: {C}, left_end: valley}}"
        mated = self.case(block, f"{{beyond: {{left: {2 * A}, right: {2 * A}}}}}")
        for shift in (0, 60, -60):
            with self.subTest(shift=shift):
                base = f"{{beyond: {{left: {2 * A + shift}, right: {2 * A - shift}}}}}"
                case = self.case(block, base, joint=f"{{shift: {-shift}}}")
                for key in ("toppling", "sliding", "limit"):
                    self.assertAlmostEqual(case[key]["critical_angle_deg"]["value"],
                                           mated[key]["critical_angle_deg"]["value"], delta=1e-12)
                self.assertEqual(case["mechanism"], mated["mechanism"])
                self.assertEqual(case["contact"]["facets"], mated["contact"]["facets"])

    def test_slab(self):
        """On a level base that ends where the block did: what hangs over touches nothing, and is not closed."""
        for shift in (Fraction(1), Fraction(-7, 3)):
            case = self.case("slab: {width: 10, height: 5}", joint=f"{{shift: {shift}, closure: 1}}")
            self.same(case["contact"]["contact_ratio"], 1 - abs(shift) / 10, 1)
            self.same(case["joint"]["matching"], 1 - abs(shift) / 10, 1)
            self.same(case["joint"]["above_base_m"], 10 - abs(shift))
            self.assertFalse(case["contact"]["beyond_stated"])

    def test_step(self):
        """A step of 1 across the sole: to the right the block climbs it, and rests on what lies over it; to the left it
        stays level, with the step's face open."""
        block = "outline: [[0, 0], [4, 0], [4, 1], [8, 1], [8, 5], [0, 5]]"
        climbs = self.case(block, joint="{shift: 1, closure: 0.5}")
        for number, truth in zip(self.numbers(climbs), (1, Fraction(6, 7), 7, Fraction(1, 8), Fraction(1, 8))):
            self.same(number, truth, 1 if truth == Fraction(1, 8) else Fraction(1, 1000))
        self.same(climbs["rest"]["moved_y_m"], 1)
        stays = self.case(block, joint="{shift: -1, closure: 0.5}")
        for number, truth in zip(self.numbers(stays), (1, Fraction(1, 7), 7, Fraction(3, 4), Fraction(3, 4))):
            self.same(number, truth, 1 if truth == Fraction(3, 4) else Fraction(1, 1000))
        self.same(stays["rest"]["moved_y_m"], 0)

    def test_random(self):
        """Undersides drawn at random, on level ground beyond them: the block lies on its base as it must, and lift, gaps
        and ratios are those of that pose. The same scene written out with its profile, shifted by hand, rests alike."""
        draw = random.Random(SEED)
        seen = {True: 0, False: 0}
        closure = Fraction(1, 20)
        for number in range(SCENES):
            under = underside(draw)
            shift = Fraction(draw.randint(-900, 900), 1000)
            (x0, y0), (x1, y1) = under[0], under[-1]
            ring = under + [(x1, Fraction(4)), (x0, Fraction(4))]
            base = [(x0 - 2, y0)] + under + [(x1 + 2, y1)]
            beyond = "{beyond: {left: 2, right: 2}}"
            self.write(f"outline: {text(ring)}", beyond, joint=f"{{shift: {shift}, closure: {closure}}}", unit="m")
            ended, _, err = run("solve", self.path)
            if ended != 0:
                self.assertIn("rolls off its base", err)
                continue
            with self.subTest(number=number, under=under, shift=shift):
                case = solve(self.path)["cases"][0]
                block = [(x + shift, y) for x, y in ring]
                hand = self.case(f"outline: {text(block)}", f"{{profile: {text(base)}, place: rest}}", unit="m")
                self.assertEqual(case["rest"], hand["rest"])
                self.assertEqual(case["toppling"], hand["toppling"])
                straight = case["rest"]["turns"] == 0
                seen[straight] += 1
                if straight:
                    lift = self.lift(block[:len(under)], base)
                    self.same(case["rest"]["moved_y_m"], lift, 1)
                    truth = gaps_of([(x, y + lift) for x, y in block[:len(under)]], base, closure)
                    for own, other in zip(self.numbers(case), truth):
                        self.same(own, other, 1)
                else:
                    self.lies(case, block, len(under), [(float(x), float(y)) for x, y in base], float(closure))
        self.assertGreater(min(seen.values()), 5, seen)

    def lift(self, under, base):
        """The least by which nothing overlaps."""
        return max([top_at(base, x) - y for x, y in under] +
                   [y - top_at(under, x) for x, y in base if under[0][0] <= x <= under[-1][0]])

    def lies(self, case, block, count, base, closure):
        """Turned and moved as is said, the block touches its base on both sides of its weight and overlaps nowhere."""
        block = [(float(x), float(y)) for x, y in block]
        rest, centre = case["rest"], rest_oracle.centroid(block)
        moved = [rest[key]["value"] for key in ("moved_x_m", "moved_y_m")]
        under = [(x + moved[0], y + moved[1])
                 for x, y in rest_oracle.turned(block, centre, math.radians(rest["turned_deg"]["value"]))][:count]
        self.assertAlmostEqual(self.lift(under, base), 0, delta=1e-11)
        touching = [x for x, y in under if abs(y - top_at(base, x)) < 1e-10]
        touching += [x for x, y in base if under[0][0] <= x <= under[-1][0] and abs(y - top_at(under, x)) < 1e-10]
        self.assertLess(min(touching), centre[0] + moved[0])
        self.assertGreater(max(touching), centre[0] + moved[0])
        truth = gaps_of(under, base, closure)
        for k, own in enumerate(self.numbers(case)):
            if k != 3:  # doubles do not tell what touches
                self.assertAlmostEqual(own["value"], truth[k], delta=1e-10)

    def test_mirror_unit_place(self):
        """A mirrored block shifted the other way; metres for millimetres; and elsewhere."""
        draw = random.Random(SEED + 1)
        for number in range(12):
            under = underside(draw)
            roof = [(under[-1][0], Fraction(5)), (under[0][0], Fraction(5))]
            ring = under + roof
            beyond = "{beyond: {left: 3, right: 3}}"
            with self.subTest(number=number, ring=ring):
                joint = "{{shift: {}, closure: 0.05}}"
                own = self.case(f"outline: {text(ring)}", beyond, joint=joint.format(0.3))
                mirror = self.case(f"outline: {text([(-x, y) for x, y in ring[::-1]])}", beyond, joint=joint.format(-0.3))
                metres = self.case(f"outline: {text(ring)}", beyond, joint=joint.format(0.3), unit="m")
                away = self.case(f"outline: {text([(x + 1024, y - 512) for x, y in ring])}", beyond,
                                 joint=joint.format(0.3))
                for k, number in enumerate(self.numbers(own)):
                    for other, factor in ((mirror, 1), (metres, 1000 if k < 3 else 1), (away, 1)):
                        self.assertAlmostEqual(factor * number["value"], self.numbers(other)[k]["value"],
                                               delta=1e-12 * factor)
                self.assertAlmostEqual(own["rest"]["turned_deg"]["value"], -mirror["rest"]["turned_deg"]["value"],
                                       delta=1e-12)

    def test_frame_of_the_world(self):
        """A block as it lies on a slope of 3 in 4, and the same along its mean plane: shifted along that alike."""
        under = [(Fraction(x), Fraction(y)) for x, y in ((0, 0), (10, 2), (20, 0), (30, 2), (40, 0))]
        ring = under + [(Fraction(40), Fraction(30)), (Fraction(0), Fraction(30))]
        turned = [((4 * x - 3 * y) / 5, (3 * x + 4 * y) / 5) for x, y in ring]
        ends = f"mated: true, beyond: {{left: 20, right: 20}}, between: {text([ring[0], ring[4]])}"
        turned_ends = f"mated: true, beyond: {{left: 20, right: 20}}, between: {text([turned[0], turned[4]])}"
        joint = "{shift: 3, closure: 0.1}"
        level = self.case(f"outline: {text(ring)}", f"{{{ends}}}", joint=joint)
        world = self.case(f"outline: {text(turned)}", f"{{{turned_ends}}}", joint=joint, more="frame: world\n")
        for own, other in zip(self.numbers(level), self.numbers(world)):
            self.assertAlmostEqual(own["value"], other["value"], delta=1e-12)
        self.assertAlmostEqual(level["toppling"]["critical_angle_deg"]["value"],
                               world["toppling"]["critical_angle_deg"]["value"], delta=1e-10)
        self.assertEqual(world["frame"]["is"], "world")

    def test_friction_of_facets(self):
        """Facets are counted from the left end of the underside that was mated, whatever the base has beyond it."""
        points = [(k * 30, 5 * (k % 2)) for k in range(5)]
        ring = points + [(120, 120), (0, 120)]
        base = [(-60, 0)] + points + [(180, 0)]
        law = "friction: {{facets: [{{facet: {}, angle_deg: 12}}]}}\n"
        own = self.case(f"outline: {text(ring)}", "{beyond: {left: 60, right: 60}}", joint="{shift: 5}",
                        more=law.format(3))
        hand = self.case(f"outline: {text([(x + 5, y) for x, y in ring])}", f"{{profile: {text(base)}, place: rest}}",
                         more=law.format(4))
        plain = self.case(f"outline: {text(ring)}", "{beyond: {left: 60, right: 60}}", joint="{shift: 5}")
        self.assertEqual(own["limit"]["critical_angle_deg"], hand["limit"]["critical_angle_deg"])
        self.assertNotEqual(own["limit"]["critical_angle_deg"], plain["limit"]["critical_angle_deg"])

    def test_refused(self):
        slab = "slab: {width: 10, height: 5}"
        profile = "{profile: [[-1, 0], [11, 0]]}"
        self.refused("along the mated base that it fits", slab, profile, joint="{shift: 1}")
        self.refused("needs one of 'shift'", slab, joint="{}")
        self.refused("needs one of 'shift'", slab, joint="{closure: 1}")
        self.refused("needs one of 'shift'", slab, joint="{shift: 1, matching: 0.5, closure: 1}")
        self.refused("needs a 'closure'", slab, joint="{matching: 0.5}")
        self.refused("matching must lie in [0, 1]", slab, joint="{matching: 1.5, closure: 1}")
        self.refused("closure must be above zero", slab, joint="{shift: 1, closure: 0}")
        self.refused("'towards' belongs to 'matching'", slab, joint="{shift: 1, towards: left}")
        self.refused("towards must be left or right", slab, joint="{matching: 1, closure: 1, towards: up}")
        self.refused("unknown key 'by' in joint", slab, joint="{by: 1}")
        self.refused("'contact: {within: …}' would move it", slab, joint="{shift: 1}", more="contact: {within: 0.1}\n")
        self.refused("leave out 'place: as_given'", slab, "{mated: true, place: as_given}", joint="{shift: 1}")
        self.refused("'place: all' asks for all other", slab, "{mated: true, place: all}", joint="{shift: 1}")
        self.refused("no part of the block stands over its base", slab, joint="{shift: 10.5}")
        self.refused("rolls off its base", slab, joint="{shift: 6}")
        self.refused("straight edges", slab + ", rounded: {corners: [{at: left_end, radius: 1}]}", joint="{shift: 1}")
        self.refused("straight edges", "ellipse: {width: 10, height: 6, flat: 2}", joint="{shift: 1}")
        self.refused("closures long", slab, joint="{matching: 0.5, closure: 11}")
        self.refused("closures long", slab, joint="{matching: 0.5, closure: 1e-13}")
        self.refused("still matches", slab, joint="{matching: 0.2, closure: 0.1}")
        hook = "outline: [[0, 0], [4, 0], [4, 1], [3, 2], [6, 2], [6, 5], [0, 5]]"
        self.refused("turns back over the block", hook, "{mated: true, between: [[0, 0], [6, 2]]}", joint="{shift: 1}")
        self.write(slab, joint="{shift: 1}")
        self.assertIn("has no formula", run("derive", self.path)[2])
        self.assertIn("60 digits", run("solve", "--digits", "61", self.path)[2])

    def test_rest_is_meant(self):
        """'place: rest' says what a shift does anyway."""
        slab = "slab: {width: 10, height: 5}"
        own = self.case(slab, joint="{shift: 1}")
        said = self.case(slab, "{mated: true, place: rest}", joint="{shift: 1}")
        self.assertEqual(own["contact"], said["contact"])


if __name__ == "__main__":
    main()
