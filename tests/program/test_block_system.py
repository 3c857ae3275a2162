# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of many blocks (docs/blocks_in_contact.md) against closed forms, published walls and slopes, the same blocks as a scene of
one, and their images: mirrored, renumbered, in another unit, far away, turned by 3-4-5."""

import decimal as decimals
import fractions
import json
import math
import random
import subprocess
import time

from governing_case import GoverningCase
from harness import PROGRAM, main, rounds, run
from pile_case import EXAMPLE, Pile, arch, box, degrees_of, text_of, wall


def decimal(number):
    """In all digits."""
    with decimals.localcontext() as context:
        context.prec = 60
        return str(decimals.Decimal(number.numerator) / decimals.Decimal(number.denominator))


class BlockSystem(GoverningCase):
    def json(self, text, *options, status=0):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertEqual(done, status, err)
        return json.loads(out)

    def case(self, text, *options):
        return self.json(text, *options)["cases"][0]

    def tangent(self, pile, friction, **more):
        own = self.case(pile.scene(friction, **more))["critical_angle_deg"]
        return math.tan(math.radians(own["value"])), math.radians(own["error"]) * 3

    def encloses(self, told, truth, digits):
        """The truth is known to so many digits, and the bracket is as narrow as is promised."""
        self.assertLessEqual(abs(told["value"] - truth), told["error"] + digits)
        self.assertLessEqual(told["error"], 2e-6 * max(1, abs(told["value"])))

    def test_slope_of_goodman_and_bray(self):
        """The free limit is at tan φ 0.659599 ± 5e-7 where the slope dips 30° (an exact program of 2026): the factor of safety is tan φ
        over that, and 1 at that friction; a motion can begin as they lie, so that no required factor is met, the least either. Goodman and
        Bray's factor, 1 at 38.15°, is held against it too."""
        needed = 0.659599
        own = json.loads(run("solve", "--json", EXAMPLE)[1])["cases"]
        self.assertEqual([c["towards"] for c in own], ["left"])
        self.assertEqual(own[0]["verdict"], "may move")
        self.encloses(own[0]["fos"], math.tan(math.radians(38.15)) / needed, 1e-6)
        for tangent, verdict in ((needed - 2e-6, "collapses"), (needed + 2e-6, "can be held")):
            one = json.loads(run("solve", "--json", EXAMPLE, "--set", f"friction_angle_deg={degrees_of(tangent)}")[1])["cases"][0]
            self.assertIn(one["verdict"], (verdict, "may move") if verdict == "can be held" else (verdict,))
            self.encloses(one["fos"], tangent / needed, 1e-6)
        self.assertLess(own[0]["governing_fos"]["at_most"], 0.83)
        for required in ("0.5", "0.8", "0.9", "1.2"):
            status, _, err = run("solve", "--fail-below", required, EXAMPLE)
            self.assertEqual(status, 1, required)
            self.assertIn(f"the required factor of safety {required} is not met", err)

    def test_forces_balance(self):
        """The forces that are told hold every column: with its weight, at a dip of 30°, they sum to nothing, and so do their
        moments, to 1e-5 of the weight: they are of strength divided by the factor, of which the bracket is 1e-6 wide."""
        own = json.loads(run("solve", "--json", EXAMPLE)[1])
        case, blocks = own["cases"][0], {b["name"]: b for b in own["blocks"]}
        sine, cosine = 0.5, math.sqrt(0.75)
        sums = {name: [-b["weight_n_m"]["value"] * sine, -b["weight_n_m"]["value"] * cosine, 0] for name, b in blocks.items()}
        for contact, force in zip(own["contacts"], case["forces"]):
            dx = contact["to_x_m"]["value"] - contact["from_x_m"]["value"]
            dy = contact["to_y_m"]["value"] - contact["from_y_m"]["value"]
            if contact["corner"]:
                continue
            size = math.hypot(dx, dy)
            # Ends run along the first block's edge, or against it: the first block lies on the side to which it is pushed.
            for name, sign in ((contact["first"], 1), (contact["second"], -1)):
                b = blocks[name]
                x = sign * (force["shear_n_m"] * dx - force["normal_n_m"] * dy) / size
                y = sign * (force["shear_n_m"] * dy + force["normal_n_m"] * dx) / size
                sums[name][0] += x
                sums[name][1] += y
                sums[name][2] += ((force["x_m"] - b["centroid_x_m"]["value"]) * y
                                  - (force["y_m"] - b["centroid_y_m"]["value"]) * x)
        for name, b in blocks.items():
            if not b["ground"]:
                for part, arm in zip(sums[name], (1, 1, 40)):
                    self.assertLessEqual(abs(part), 1e-5 * arm * b["weight_n_m"]["value"], (name, sums[name]))

    def test_published_walls(self):
        """33 and 55 blocks, 83 and 141 contacts: 0.64286 and 0.58000, to the five digits that are printed."""
        for courses, known, contacts in ((6, 0.64286, 83), (10, 0.58, 141)):
            own = self.json(wall(courses, 5).scene(degrees_of(0.65)))
            self.assertEqual(len(own["contacts"]), contacts)
            self.encloses(own["cases"][0]["critical_angle_deg"], math.degrees(math.atan(known)), 3e-4)

    def test_arches(self):
        """A semicircular arch of mean radius 1 that stands on its own (section 10 of the mathematics, an exact program of 2026): of 400
        voussoirs it needs the thickness 0.107478, whatever the friction; of thickness 0.200637 it needs tan φ 0.309215; with 60
        its hinges are off by up to half a voussoir, which counts squared."""
        for thickness, verdict in ((0.1074775, "collapses"), (0.1074785, "can be held")):
            self.assertEqual(self.case(arch(400, thickness).scene(45))["verdict"], verdict)
        own = self.case(arch(60, 0.200637).scene(degrees_of(0.35)))
        self.encloses(own["fos"], 0.35 / 0.309215, (math.pi / 60) ** 2)

    def test_slope_without_risers(self):
        """Goodman and Bray's slope whose steps stand a billionth of a metre off the columns, so that risers bear nothing: tan φ 0.660516, by the
        exact program of 2026, where it needs 0.659599 with them."""
        ground = [(-10, -20), (170, -20), (170, 15)]
        for k in range(15, 0, -1):
            ground += [(f"{10 * k}.000000001", k), (f"{10 * k}.000000001", k - 1)]
        pile = Pile().add("g", [*ground, (-10, 0)], True)
        for k, height in enumerate([4 * n for n in range(1, 11)] + [40 - 6 * n for n in range(1, 7)]):
            pile.add(f"c{k}", box(10 * k, k, 10 * k + 10, k + height))
        own = self.case(pile.scene(38.15, "slope: {dip_deg: 30, towards: left}"))
        self.encloses(own["fos"], math.tan(math.radians(38.15)) / 0.660516, 1e-6)

    def test_pinched_brick(self):
        """A brick that hangs between two blocks on level ground: μ = 1/√(1 + 2W/w) holds it, by friction that its own thrust makes; but
        it can fall all the same."""
        pile = Pile().add("ground", box(-9, -1, 9, 0), True).add("left", box(-4, 0, 0, 2)).add("right", box(1, 0, 5, 2))
        pile.add("brick", box(0, fractions.Fraction(1, 2), 1, fractions.Fraction(3, 2)))
        own = self.case(pile.scene(degrees_of(0.5)))
        self.assertEqual(own["verdict"], "may move")
        self.encloses(own["fos"], 0.5 * math.sqrt(1 + 2 * 8), 1e-9)

    def test_wedged_block(self):
        """A block that fills a trench between two parallel walls moves in no collapse, as friction may wedge it: the others have their own
        limit all the same, a box on the ground beside it tan φ / tan α, and one that has to slide over its top as well."""
        for lean in (0, 0.25, -0.5):
            ground = [(-9, -9), (9, -9), (9, 0), (-2, 0), (-2 - 2 * lean, -2), (-4 - 2 * lean, -2), (-4, 0), (-9, 0)]
            key = [(-4 - 2 * lean, -2), (-2 - 2 * lean, -2), (-2, 0), (-4, 0)]
            for left in (0, -3):
                pile = Pile().add("g", ground, True).add("key", key).add("a", box(left, 0, left + 2, 1))
                own = self.case(pile.scene(30, "tilt: {towards: left, angle_deg: 10}"))
                self.encloses(own["fos"], math.tan(math.radians(30)) / math.tan(math.radians(10)), 1e-9)
                self.encloses(own["critical_angle_deg"], 30, 1e-7)
                self.assertEqual([m["mechanism"] for m in own["motions"] if m["block"] == "key"], ["stands"])

    def test_wedged_columns(self):
        """Columns between the risers of steps that their joints run along are wedged likewise; the first block slides on its tread, which
        dips 22°: tan φ / tan 22°, and φ − 22° more."""
        text = """topple: 1
length_unit: m
block: {unit_weight_kn_m3: 26}
friction_angle_deg: PHI
tilt: {towards: left}
jointed_slope:
  face: {dip_deg: 68, height: 8}
  joints:
    - {name: f, dip_deg: 68, towards: right, spacing: 3.16}
    - {name: c, dip_deg: 20, towards: left, spacing: 3.57, offset: 1}
  base: {dip_deg: 20, steps: f}
"""
        for phi, verdict in ((19, "collapses"), (25, "can be held")):
            own = self.case(text.replace("PHI", str(phi)))
            self.assertEqual(own["verdict"], verdict)
            self.encloses(own["fos"], math.tan(math.radians(phi)) / math.tan(math.radians(22)), 1e-8)
            self.encloses(own["critical_angle_deg"], phi - 22, 1e-7)

    def test_joint_of_its_own(self):
        """A block 2 × 1 below a column 1 × 5, μ 0.6: tan of the limit 0.25517241 = 37/145 with a frictionless joint between them,
        0.26530612 = 13/49 with 0.3 there."""
        for joint, known in ((0, fractions.Fraction(37, 145)), (0.3, fractions.Fraction(13, 49))):
            own = Pile().add("ground", box(-9, -1, 9, 0), True).add("low", box(0, 0, 2, 1)).add("column", box(2, 0, 3, 5))
            own.joints = [("low", "column", degrees_of(joint))]
            tangent, within = self.tangent(own, degrees_of(0.6))
            self.assertLessEqual(abs(tangent - known), within + 1e-9)

    def test_as_a_scene_of_one(self):
        """Random blocks of straight edges on a level base: the limit is that of `topple solve` of the one block, on a base that
        extends past it, and the factor of safety is that by strength reduction."""
        draw = random.Random(3)
        for _ in range(rounds(9, 60)):
            width, height, lean = draw.randint(2, 9), draw.randint(3, 12), draw.randint(-2, 3)
            outline = [(0, 0), (width, 0), (width + lean, height), (lean + draw.randint(0, 1), height)]
            if 2 * lean >= width:
                continue
            friction, tilt = draw.choice((20, 35, 50)), draw.choice((3, 7))
            loads = draw.choice(("", "loads: {cohesion_kpa: 6, bond_kpa: 4}\n", "loads: {seismic: {horizontal: 0.05}}\n"))
            one = self.json(f"topple: 1\nlength_unit: m\nblock: {{outline: {text_of(outline)}, unit_weight_kn_m3: 25}}\n"
                            f"base: {{beyond: {{left: 50, right: 50}}}}\nfriction_angle_deg: {friction}\n"
                            f"tilt: {{towards: left, angle_deg: {tilt}}}\n{loads}")["cases"][0]["limit"]
            many = self.case(Pile().add("g", box(-50, -1, 60, 0), True).add("b", outline)
                             .scene(friction, f"tilt: {{towards: left, angle_deg: {tilt}}}\n{loads}"))
            for told, truth in ((many["critical_angle_deg"], one["critical_angle_deg"]), (many["fos"], one["fos"])):
                where = (outline, friction, tilt, loads, many, one)
                self.assertEqual(told is None, truth is None, where)
                if told is not None:
                    self.assertLessEqual(abs(told["value"] - truth["value"]), told["error"] + truth["error"], where)

    def test_images(self):
        """Mirrored, renumbered, in millimetres, in a mine's coordinates, turned by 3-4-5 with gravity, with the ground cut in two and
        with a block far away that nothing touches but the ground: brackets of limit and factor overlap."""
        pile = wall(3, 3)
        tilt = "tilt: {towards: left, angle_deg: 10}"
        shuffled = Pile()
        shuffled.blocks = random.Random(1).sample(pile.blocks, len(pile.blocks))
        split = Pile().add("g1", box(-4, -4, 5, 0), True).add("g2", box(5, -4, 16, 0), True)
        split.blocks += pile.blocks[1:]
        far = Pile()
        far.blocks = pile.blocks + [("far", box(1000, 0, 1001, fractions.Fraction(1, 10))), ("more", box(990, -1, 1010, 0), True)]
        far.blocks = [(b + (False,))[:3] for b in far.blocks]
        texts = {"own": pile.scene(35, tilt), "mirrored": pile.moved(lambda x, y: (-x, y)).scene(35, tilt.replace("left", "right")),
                 "renumbered": shuffled.scene(35, tilt),
                 "in mm": pile.moved(lambda x, y: (1000 * x, 1000 * y)).scene(35, tilt, unit="mm"),
                 "in a mine": pile.moved(lambda x, y: (x + fractions.Fraction(5123452, 10), y + 6789012)).scene(35, tilt),
                 "split": split.scene(35, tilt), "far": far.scene(35, tilt)}
        own = {name: self.case(text) for name, text in texts.items()}
        for name, one in own.items():
            for key in ("critical_angle_deg", "fos"):
                a, b = own["own"][key], one[key]
                self.assertLessEqual(abs(a["value"] - b["value"]), a["error"] + b["error"], (name, key))
        for name in ("mirrored", "in a mine", "in mm"):
            for a, b in zip(own["own"]["motions"], own[name]["motions"]):
                self.assertEqual(a["mechanism"], b["mechanism"], name)

    def test_places_far_from_the_origin(self):
        """In a mine's coordinates the report tells where forces act, as JSON does, and not to five digits: six or seven stand before the point."""
        far = wall(2, 2).moved(lambda x, y: (x + fractions.Fraction(5123452, 10), y + 6789012))
        text = far.scene(35, "tilt: {towards: left, angle_deg: 10}")
        lines = run("solve", self.scene(text))[1].split("between", 1)[1].splitlines()[1:]
        told = [tuple(float(v) for v in line.split()[-2:]) for line in lines if line.strip()]
        truth = [(force["x_m"], force["y_m"]) for force in self.case(text)["forces"]]
        self.assertEqual(len(told), len(truth))
        for own, other in zip(told, truth):
            self.assertLess(math.dist(own, other), 6e-3)  # nine digits of JSON

    def test_shaken(self):
        """k_h turns the resultant by atan(k_h): the critical tilt is less by that, and the critical acceleration is tan of what is left
        at the tilt."""
        pile = Pile().add("g", box(-9, -1, 9, 0), True).add("b", box(0, 0, 2, 4))
        tilt = "tilt: {towards: left, angle_deg: 10}"
        still = self.case(pile.scene(40, tilt))
        shaken = self.case(pile.scene(40, tilt + "\nloads: {seismic: {horizontal: 0.2}}"))
        limit = math.degrees(math.atan(0.5))
        self.encloses(still["critical_angle_deg"], limit, 1e-9)
        self.encloses(shaken["critical_angle_deg"], limit - math.degrees(math.atan(0.2)), 1e-9)
        for own in (still, shaken):
            self.encloses(own["critical_acceleration_g"], math.tan(math.radians(limit - 10)), 1e-9)
        self.assertEqual([still["verdict"], shaken["verdict"]], ["stands", "stands"])
        more = self.case(pile.scene(40, tilt + "\nloads: {seismic: {horizontal: 0.4}}"))
        self.assertEqual([more["verdict"], more["motions"][1]["mechanism"]], ["collapses", "topples"])
        slope = "slope: {dip_deg: 5, towards: left}\nloads: {seismic: {horizontal: 0.1}}"
        self.assertEqual([c["towards"] for c in self.json(pile.scene(40, slope))["cases"]], ["left", "right"])

    def test_cohesion(self):
        """A slab of the length L and the height h on a plane that dips α: (c L + W cos α tan φ) / (W sin α) by strength reduction where
        it slides; the dip that it can have and the acceleration by the same sum. A tower with a bond σ at its foot topples,
        and turns about its toe against σ b²/2."""
        length, height, alpha, phi, c, gamma = 8, 1.5, 40, 25, 12, 25
        weight, t = gamma * length * height, math.tan(math.radians(phi))
        pile = Pile().add("g", box(-9, -1, 19, 0), True).add("b", box(0, 0, length, height))
        own = self.case(pile.scene(phi, f"slope: {{dip_deg: {alpha}, towards: left}}\nloads: {{cohesion_kpa: {c}}}"))
        sine, cosine = math.sin(math.radians(alpha)), math.cos(math.radians(alpha))
        self.encloses(own["fos"], (c * length + weight * cosine * t) / (weight * sine), 1e-9)
        self.encloses(own["critical_acceleration_g"], (c * length / weight + cosine * t - sine) / (cosine + sine * t), 1e-9)
        dip = math.radians(own["critical_angle_deg"]["value"])
        self.assertAlmostEqual(c * length + weight * math.cos(dip) * t, weight * math.sin(dip), delta=1e-5 * weight)
        force = own["forces"][0]
        self.assertAlmostEqual(force["normal_n_m"], 1000 * weight * cosine, delta=weight)
        self.assertAlmostEqual(abs(force["shear_n_m"]), 1000 * weight * sine, delta=weight)
        self.assertEqual(own["motions"][1]["mechanism"], "slides")
        tower = Pile().add("g", box(-9, -1, 9, 0), True).add("b", box(0, 0, 1, 6))
        sigma, tilt = 20, "tilt: {towards: left, angle_deg: 12}"
        for cohesion in (200, 5):
            own = self.case(tower.scene(45, f"{tilt}\nloads: {{cohesion_kpa: {cohesion}, bond_kpa: {sigma}}}"))
            limit = math.radians(own["critical_angle_deg"]["value"])
            self.assertAlmostEqual(150 * (3 * math.sin(limit) - 0.5 * math.cos(limit)), sigma / 2, delta=1e-3)
            self.assertEqual(own["motions"][1]["mechanism"], "topples")
        # With a joint of its own between two columns: one that is bonded to a lower one is held by it.
        pair = Pile().add("g", box(-9, -1, 9, 0), True).add("low", box(0, 0, 2, 2)).add("high", box(2, 0, 3, 6))
        text = pair.scene(35, "tilt: {towards: right, angle_deg: 5}")
        alone = self.case(text)["critical_angle_deg"]["value"]
        bonded = self.case(text + "joints: [{between: [high, low], cohesion_kpa: 100, tension_kpa: 60}]\n")
        self.assertGreater(bonded["critical_angle_deg"]["value"], alone + 2)
        self.assertGreater(alone, math.degrees(math.atan(1 / 6)))  # that of the high one by itself

    def test_images_of_cohesion(self):
        """Mirrored, in millimetres and in a mine's coordinates, cohesive walls have one limit and one factor."""
        pile, own = wall(3, 3), {}
        loads = "\nloads: {cohesion_kpa: 3, bond_kpa: 2, seismic: {horizontal: 0.05}}"
        for name, how, side, unit in (("own", lambda x, y: (x, y), "left", "m"), ("mirrored", lambda x, y: (-x, y), "right", "m"),
                                      ("in mm", lambda x, y: (1000 * x, 1000 * y), "left", "mm"),
                                      ("in a mine", lambda x, y: (x + 512345, y + 6789012), "left", "m")):
            own[name] = self.case(pile.moved(how).scene(35, f"tilt: {{towards: {side}, angle_deg: 20}}{loads}", unit=unit))
            for key in ("critical_angle_deg", "critical_acceleration_g", "fos"):
                a, b = own["own"][key], own[name][key]
                self.assertLessEqual(abs(a["value"] - b["value"]), a["error"] + b["error"], (name, key))

    def test_on_corners(self):
        """A block that rests on two points, 4 apart and alike to both sides: it topples where its centroid, at 24·3 − 3·4/9 over 21 by
        the box less the notch, is past the lower one, and slides at tan φ. So it does on two blocks, one below each point."""
        points = [(0, 0), (1, 1), (3, 1), (4, 0), (4, 6), (0, 6)]
        height = (72 - fractions.Fraction(4, 3)) / 21
        for friction, known in ((60, 2 / height), (25, math.tan(math.radians(25)))):
            one = Pile().add("g", box(-9, -1, 9, 0), True).add("b", points)
            two = Pile().add("g", box(-9, -3, 9, -2), True).add("l", box(-3, -2, 2, 0)).add("r", box(2, -2, 7, 0)).add("b", points)
            for pile in (one, two):
                tangent, within = self.tangent(pile, friction)
                self.assertLessEqual(abs(tangent - known), within + 1e-9)

    def test_what_is_refused(self):
        """Bad input is told by the names of blocks and the place, before anything is solved."""
        ground, block = ("g", box(-9, -1, 9, 0), True), ("b", box(0, 0, 2, 4), False)
        tower = box(1, 1, 3, 3)
        for blocks, joints, more, told in (
                ([ground, block, ("c", tower, False)], [], "", "blocks 'b' and 'c' overlap"),
                ([ground, block, ("c", box(4, 1, 5, 2), False)], [], "", "block 'c' touches no other"),
                ([ground, block, ("c", box(4, 1, 5, 2), False), ("d", box(5, 1, 6, 2), False)], [], "", "'c' and those that it touches touch no ground"),
                ([ground, block, ("c", box(2, 4, 3, 5), False), ("d", box(2, 5, 3, 6), False)], [], "", "but for corners of both alone"),
                ([block, ("c", box(2, 0, 4, 4), False)], [], "", "no block is ground"),
                ([ground], [], "", "all blocks are ground"),
                ([ground, block, ("b", box(3, 0, 4, 4), False)], [("g", "b", 20)], "", "two blocks are named 'b'"),
                ([ground, block], [("g", "x", 20)], "", "no block is named 'x'"),
                ([ground, block], [("g", "b", 20), ("b", "g", 30)], "", "given twice"),
                ([ground, block], [], "base: {mated: true}", "'base' is of a scene of one block"),
                ([ground, ("b", [(0, 0), (2, 4), (2, 0), (0, 4)], False)], [], "", "crosses")):
            own = Pile()
            own.blocks, own.joints = blocks, joints
            status, out, err = run("solve", self.scene(own.scene(30, more)))
            self.assertEqual((status, out), (3, ""), told)
            self.assertIn(told, err)
            self.assertRegex(err, r"\.yaml:\d+:\d+: ")
        for command in ("tilt", "derive"):
            status, out, err = run(command, EXAMPLE)
            self.assertEqual((status, out), (3, ""))
            self.assertIn("many blocks", err)
        status, out, err = run("solve", "--elements", EXAMPLE)
        self.assertEqual(status, 3)
        self.assertIn("--elements", err)

    def test_cost_is_told(self):
        """Of 5000 blocks and more, what they cost is said before the work, which takes half a minute: the first line is there long
        before that. Of fewer nothing is said, nor with --quiet."""
        scene = self.scene(wall(71, 71).scene(35, "tilt: {towards: left, angle_deg: 15}"))
        began = time.monotonic()
        with subprocess.Popen([PROGRAM, "solve", scene], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as running:
            line = running.stderr.readline()
            running.kill()
        self.assertLess(time.monotonic() - began, 10)
        self.assertRegex(line, r"^5078 blocks: limits and factors of so many take some 9 seconds of one core and up to 0\.13 GB of memory$")
        self.assertEqual(run("solve", self.scene(wall(3, 3).scene(35)))[2], "")

    def test_gaps_are_gaps(self):
        """Contact is exact: of two columns 1e-12 apart on the ground neither touches the other, and a block as much above the ground touches
        nothing, in a mine's coordinates too; as much of an overlap is refused by both names. Closed, with a T-junction and a corner on a
        face, all touch."""
        for x, y in ((0, 0), (5123452, 6789012)):
            for gap, edges in (("0", 3), ("1e-12", 2), ("1e-30", 2)):
                apart = fractions.Fraction(gap)
                pile = Pile().add("g", box(x - 9, y - 1, x + 9, y), True).add("a", box(x, y, x + 2, y + 3))
                beside = [(decimal(px + apart), decimal(py)) for px, py in box(x + 2, y, x + 4, y + 1)]
                own = self.json(pile.add("b", beside).scene(30))
                self.assertEqual(len([c for c in own["contacts"] if not c["corner"]]), edges, gap)
            above = Pile().add("g", box(x - 9, y - 1, x + 9, y), True).add("a", [(decimal(px), decimal(py + fractions.Fraction(1, 10**12)))
                                                                                for px, py in box(x, y, x + 2, y + 3)])
            self.assertIn("block 'a' touches no other", run("solve", self.scene(above.scene(30)))[2])
            within = Pile().add("g", box(x - 9, y - 1, x + 9, y), True).add("a", [(decimal(px), decimal(py - fractions.Fraction(1, 10**12)))
                                                                                 for px, py in box(x, y, x + 2, y + 3)])
            self.assertIn("blocks 'g' and 'a' overlap", run("solve", self.scene(within.scene(30)))[2])

    def test_bad_input(self):
        """What cannot be solved is told at its line and column, with both names where two blocks are at fault, and before work begins: ten
        million blocks by a small spacing take no more than a moment."""
        top = "topple: 1\nlength_unit: m\nfriction_angle_deg: 35\nblock: {unit_weight_kn_m3: 26}\ntilt: {towards: left}\n"
        ground = "blocks:\n  - {name: g, ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n"
        slope = ("jointed_slope:\n  face: {dip_deg: 65, height: 20}\n  joints:\n    - {dip_deg: 70, towards: right, spacing: WIDE}\n"
                 "    - {dip_deg: 20, towards: left, spacing: WIDE}\n  base: {dip_deg: 30}\n")
        for text, place, told in (
                (ground + "  - {name: a, slab: {width: 2, height: 1}}\n  - {name: b, slab: {width: 2, height: 1}, at: [1, 0.5]}\n", "9:5",
                 "blocks 'a' and 'b' overlap"),
                (ground + "  - {name: a, slab: {width: 2, height: 1}, at: [0, 0.001]}\n", "8:5", "block 'a' touches no other"),
                (ground, "7:5", "all blocks are ground"),
                ("jointed_slope: {face: {dip_deg: 65, height: 20}, behind: 20, joints: [{dip_deg: 0, spacing: 4}], base: {dip_deg: 0}}\n", "6:16",
                 "this slope has no blocks"),
                (slope.replace("WIDE", "0.0113"), "9:46", "up to 1e+07 pieces, and 100000 are the most")):
            began = time.monotonic()
            status, out, err = run("solve", self.scene(top + text))
            self.assertEqual((status, out), (3, ""), told)
            self.assertIn(f".yaml:{place}: ", err)
            self.assertIn(told, err)
            self.assertLess(time.monotonic() - began, 10)


if __name__ == "__main__":
    main()
