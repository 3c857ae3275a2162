# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Water that a scene gives by a level, a surface or a filled crack: its pressure on vertical, inclined and overhanging faces by the
columns of water over them; a drowned block by Archimedes, in rationals; the joint below it with each shape of uplift; water over
the top, ice; the same scene in a mirror, elsewhere, in other units, drawn along its slope or as it lies; and what is refused."""

import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, main, rounds, run, solve

HEAD = "topple: 1\nlength_unit: {unit}\nfriction_angle_deg: 35\n"
G = Fraction(981, 100)  # kN/m3
COS25 = "0.906307787036649963242552656754316983267712625175864680871298408"


def ring(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def area_and_centroid(points):
    """Of a polygon, counter-clockwise, by triangles with the origin."""
    area = x = y = Fraction(0)
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        cross = x0 * y1 - x1 * y0
        area, x, y = area + cross / 2, x + cross * (x0 + x1) / 6, y + cross * (y0 + y1) / 6
    return area, x / area, y / area


class WaterSite(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def case(self, text, unit="m", *options):
        self.path.write_text(HEAD.format(unit=unit) + text)
        self.solution = solve(self.path, *options)
        return self.solution["cases"][0]

    def drawn(self, points, water, unit="m", more=""):
        """A block as it lies, on the joint from its first vertex to its second."""
        return self.case(f"block: {{outline: {ring(points)}, unit_weight_kn_m3: 26}}\nframe: world\n"
                         f"base: {{between: [[{points[0][0]}, {points[0][1]}], [{points[1][0]}, {points[1][1]}]]}}\n"
                         f"loads:\n  water: {water}\n{more}", unit)

    def moment(self, case, *names):
        return sum(load["moment_nm"]["value"] for load in case["loads"] if load["name"] in names)

    def agrees(self, value, truth, what=None):
        self.assertAlmostEqual(value, float(truth), delta=1e-9 * max(1, abs(float(truth))), msg=what)

    def test_crack_filled_as_the_anchored_block(self):
        """examples/slope/anchored_block.yaml: a level 2 cos 25° over the heel, or a crack filled to 2 m along the face, is the water
        that the scene gives as a height of 2 m along that face; a horizontal level 2 m over the heel would push more, by
        1/cos² 25°."""
        scene = (ROOT / "examples/slope/anchored_block.yaml").read_text()
        passive = scene.replace("force_kn: 80", "force_kn: 80, passive: true")
        for form in (f"level: 2*{COS25}, faces: behind", "tension_crack: {height: 2}", f"tension_crack: {{level: 2*{COS25}}}"):
            for text, uplift, sliding, toppling in ((scene, "none", 12.467, None), (passive, "none", 2.503, 1.971),
                                                    (passive, "triangular", 2.397, 1.837)):
                self.path.write_text(text.replace("water: {height: 2}", f"water: {{{form}, uplift: {uplift}}}"))
                case = solve(self.path)["cases"][0]
                self.assertAlmostEqual(case["sliding"]["fos"]["value"], sliding, delta=5e-4)
                if toppling is not None:
                    self.assertAlmostEqual(case["toppling"]["fos"]["value"], toppling, delta=5e-4)
        self.path.write_text(scene.replace("height: 2", "level: 2, faces: behind, uplift: none"))
        self.agrees(self.moment(solve(self.path)["cases"][0], "water"),
                    float(G) * 2 ** 3 / 6 / math.cos(math.radians(25)) ** 2 * 1000)

    def test_faces_by_columns(self):
        """A face from the heel at (3, 0) to (3 + lean, 5): below a level h the push is g h²/2 at a third, and what stands over the
        face, or is missing below an overhang, is a triangle of water. The toe is the origin. Leaning back from the water the
        face is pressed down, leaning out over it up."""
        for lean in (Fraction(0), Fraction(-1), Fraction(-5, 2), Fraction(1), Fraction(2)):
            for h in (Fraction(1), Fraction(7, 2), Fraction(5)):
                case = self.drawn([(0, 0), (3, 0), (3 + lean, 5), (lean, 5)],
                                  f"{{level: {h}, faces: behind, uplift: none}}", more="tilt: {towards: left, angle_deg: 0}\n")
                out = lean * h / 5  # of the face at the level
                column, arm = G * h * out / 2, 3 + out / 3
                self.agrees(self.moment(case, "water"), 1000 * (G * h ** 3 / 6 + column * arm), (lean, h))
                free = G * h * h / 2, Fraction(26 * 15) - column
                self.agrees(case["sliding"]["fos"]["value"], float(free[1] / free[0]) * math.tan(math.radians(35)), (lean, h))

    def test_archimedes(self):
        """A drowned block, wet all round and full in the joint, is lifted by the weight of its volume of water at the centroid of
        its section, and pushed nowhere: it slides with tan φ / tan δ as if it were dry, whatever its form and its level."""
        rng = random.Random(33)
        for _ in range(rounds(12, 200)):
            up = rng.choice((Fraction(3, 4), Fraction(1, 5), Fraction(0), Fraction(-1, 2)))
            x0, y0 = rng.randint(-50, 50), rng.randint(-50, 900)
            right = Fraction(rng.randint(20, 40), 10)
            tops = [right + Fraction(rng.randint(-3, 12), 10), Fraction(rng.randint(4, 16), 10), Fraction(rng.randint(-12, 3), 10)]
            block = [(0, Fraction(0)), (right, right * up)] + [(x, Fraction(rng.randint(35, 70), 10)) for x in tops]
            block = [(x + x0, y + y0) for x, y in block]
            level = y0 + 7 + Fraction(rng.randint(0, 40), 10)
            left = up >= 0
            case = self.drawn(block, f"{{level: {level}, faces: both, uplift: full}}",
                              more="" if up else "tilt: {towards: left, angle_deg: 0}\n")
            area, x, _ = area_and_centroid(block)
            # moments turn about the governing pivot, the lower end of the joint
            foot = block[0] if left else block[1]
            arm = x - foot[0] if left else foot[0] - x
            self.agrees(self.moment(case, "water", "uplift"), 1000 * G * area * arm, self.path.read_text())
            if up:
                self.agrees(case["sliding"]["fos"]["value"], math.tan(math.radians(35)) / abs(float(up)))

    def test_uplift_shapes(self):
        """A joint of 4 m on level ground under water 3 m deep behind the block, none or 1 m before it: from one end's pressure to the
        other's, about the toe; a trapezoid from p to q has the moment (q/6 + p/3) L², q at the toe."""
        block = [(0, 0), (4, 0), (4, 6), (0, 6)]
        flat = "tilt: {towards: left, angle_deg: 0}\n"
        surface = "surface: [[-1, 1], [0, 1], [4, 3], [5, 3]]"
        for water, heel, toe in (("level: 3, faces: behind, uplift: none", 0, 0),
                                 ("level: 3, faces: behind, uplift: false", 0, 0),
                                 ("level: 3, faces: behind, uplift: triangular", 3, 0),
                                 ("level: 3, faces: behind, uplift: true", 3, 0),
                                 ("level: 3, faces: behind, uplift: full", 3, 3), ("level: 3, faces: behind", 3, 3),
                                 (surface + ", faces: behind, uplift: full", 3, 1),
                                 (surface + ", faces: both, uplift: triangular", 3, 1),
                                 (surface + ", faces: front, uplift: triangular", 0, 1),
                                 ("level: 1, faces: both, tension_crack: {level: 3}, uplift: full", 3, 1)):
            case = self.drawn(block, f"{{{water}}}", more=flat)
            self.agrees(self.moment(case, "uplift"), 1000 * G * 16 * (Fraction(heel, 3) + Fraction(toe, 6)), water)
            pushes = ("front" not in water) * 27 - ("both" in water or "front" in water) * 1
            self.agrees(self.moment(case, "water"), 1000 * G * Fraction(pushes, 6), water)

    def test_joint_wet_in_part(self):
        """A plane that dips by atan 3/4, 5 m long, below a level 2 m over its toe: the heel stands 1 m above the water, and the lower
        two thirds of the joint are wet, g·2 at the toe."""
        case = self.drawn([(0, 0), (4, 3), (1, 7), (-3, 4)], "{level: 2, faces: both, uplift: full}")
        wet = Fraction(10, 3)
        self.agrees(self.moment(case, "uplift"), 1000 * G * 2 * wet / 2 * wet / 3)

    def test_over_the_top(self):
        """A slab of 2 x 3 m, water 4 m deep behind it: the face has g·1 to g·4, the top g·1 that presses down at the middle."""
        case = self.drawn([(0, 0), (2, 0), (2, 3), (0, 3)], "{level: 4, faces: behind, uplift: none}",
                          more="tilt: {towards: left, angle_deg: 0}\n")
        face = G * (1 * Fraction(9, 2) + Fraction(27, 6))
        self.agrees(self.moment(case, "water"), 1000 * (face - G * 2 * 1))
        self.assertIn("stands above the top", run("solve", self.path)[1].replace("\n", " ").replace("         ", ""))

    def test_level_top_under_two_levels(self):
        """On a level top stands the water in front, which a crack behind passes nothing on to, whichever side is which: a block and its
        mirror image once had the water of the right side there."""
        told = []
        for towards in ("left", "right"):
            case = self.case("block: {outline: [[0, 0], [2, 0], [2, 3], [0, 3]], unit_weight_kn_m3: 26}\n"
                             f"tilt: {{towards: {towards}}}\nloads:\n  water: {{level: 5, tension_crack: {{height: 6}}, uplift: none, faces: both}}\n",
                             "m", "--outlines")
            top = [own for own in self.solution["outlines"]["pressures"] if own["y0_m"] == own["y1_m"] and own["first_kpa"] > 0]
            self.assertEqual(len(top), 1)
            for own in (top[0]["first_kpa"], top[0]["last_kpa"]):
                self.agrees(own, 2 * G)
            told.append([pivot["critical_angle_deg"]["value"] for pivot in case["pivots"]])
        for one, other in zip(told[0], told[1][::-1]):
            self.agrees(one, other)

    def test_bent_surface(self):
        """A surface that falls from 5 m at x = 4 to 3 m at x = 2 and on to 2 m at x = -1: on a back from (4, 0) to (2, 4) depths are
        linear, 5 at the heel, 0 where 5 - (4 - x) = 2 (4 - x), x = 7/3."""
        case = self.drawn([(0, 0), (4, 0), (2, 4), (0, 4)],
                          "{surface: [[-1, 2], [2, 3], [4, 5], [6, 5]], faces: behind, uplift: none}",
                          more="tilt: {towards: left, angle_deg: 0}\n")
        run_, rise = Fraction(5, 3), Fraction(10, 3)  # of the wet part, up and to the left
        # force g 5/2 times (rise to the left, run downwards), at a third from the heel
        push, down = G * Fraction(5, 2) * rise, G * Fraction(5, 2) * run_
        self.agrees(self.moment(case, "water"), 1000 * (push * rise / 3 - down * (4 - run_ / 3)))
        self.agrees(case["sliding"]["fos"]["value"], float((26 * 12 + down) / push) * math.tan(math.radians(35)))

    def test_ice(self):
        """Ice of 0.5 m and 60 kPa on a vertical back, from a level of 2 m down: 30 kN at 1.75 m; with water all round it acts from
        behind alone."""
        for faces in ("behind", "both"):
            case = self.drawn([(0, 0), (2, 0), (2, 3), (0, 3)],
                              f"{{level: 2, faces: {faces}, uplift: none, ice_kpa: 60, ice_thickness: 0.5}}",
                              more="tilt: {towards: left, angle_deg: 0}\n")
            self.agrees(self.moment(case, "ice"), 30000 * 1.75)

    def test_mirror_origin_units(self):
        """A leaning block in a sloping surface against its mirror image, far from the origin, and in millimetres."""
        block = [(0, 0), (4, 3), (Fraction(7, 2), 7), (-1, 5)]
        line = [(-3, 2), (2, 4), (8, Fraction(13, 2))]

        def found(change, unit="m"):
            points, surface = [change(*p) for p in block], [change(*p) for p in line]
            if points[0][0] > points[1][0]:
                points, surface = [points[k] for k in (1, 0, 3, 2)], surface[::-1]
            case = self.drawn(points, f"{{surface: {ring(surface)}, faces: both, uplift: full, tension_crack: {{height: 5"
                              f"{'000' if unit == 'mm' else ''}}}}}", unit)
            return case, [load["moment_nm"]["value"] for load in case["loads"]]

        one, moments = found(lambda x, y: (x, y))
        self.assertNotEqual(moments, [])
        for change, unit in ((lambda x, y: (-x, y), "m"), (lambda x, y: (x + 643000, y + 4521), "m"),
                             (lambda x, y: (1000 * x, 1000 * y), "mm")):
            other, again = found(change, unit)
            for key in ("sliding", "toppling"):
                self.agrees(other[key]["fos"]["value"], one[key]["fos"]["value"], key)
            self.agrees(other["governing_fos"]["fos"]["value"], one["governing_fos"]["fos"]["value"])
            for a, b in zip(again, moments):
                self.agrees(a, b)

    def test_slope_table_and_world(self):
        """Along a plane that dips by atan 7/24 and as it lies: the same block in the same surface; and on a table at that tilt. A
        level counts over the up-dip end of the joint on the first and the last, and is y where it lies."""
        cosine, sine, dip = Fraction(24, 25), Fraction(7, 25), math.degrees(math.atan2(7, 24))
        block, line = [(0, 0), (2, 0), (Fraction(5, 2), 4), (Fraction(1, 2), 5)], [(-4, 3), (1, 2), (8, 1)]

        def lying(points):
            return [(cosine * x - sine * y, sine * x + cosine * y) for x, y in points]

        heel = sine * 2
        for own, seen in ((f"surface: {ring(line)}", f"surface: {ring(lying(line))}"), ("level: 5/2", f"level: {heel} + 5/2"),
                          ("tension_crack: {height: 3, distance: 1/2}", "tension_crack: {height: 3, distance: 1/2}"),
                          ("level: 1, tension_crack: {level: 2}", f"level: {heel} + 1, tension_crack: {{level: {heel} + 2}}")):
            for more in ("faces: both, uplift: full", "faces: behind, uplift: triangular"):
                if own.startswith("tension") and "both" in more:
                    continue
                cases = [self.drawn(lying(block), f"{{{seen}, {more}}}")]
                for frame in (f"slope: {{dip_deg: {dip!r}, towards: left}}\n", f"tilt: {{towards: left, angle_deg: {dip!r}}}\n"):
                    cases.append(self.case(f"block: {{outline: {ring(block)}, unit_weight_kn_m3: 26}}\n{frame}"
                                           f"loads:\n  water: {{{own}, {more}}}\n"))
                for other in cases[1:]:
                    for key in ("sliding", "toppling", "governing_fos"):
                        self.agrees(other[key]["fos"]["value"], cases[0][key]["fos"]["value"], (own, more, key))
                    for a, b in zip(other["loads"], cases[0]["loads"]):
                        self.agrees(a["moment_nm"]["value"], b["moment_nm"]["value"], (own, more, a["name"]))

    def test_up_dip(self):
        """An earthquake up-dip: the push from behind is left out and the uplift stays; water in front pushes up-dip."""
        block = [(0, 0), (2, 0), (2, 4), (0, 4)]
        for faces, push in (("behind", 0), ("both", 1)):
            text = (f"block: {{outline: {ring(block)}, unit_weight_kn_m3: 26}}\nslope: {{dip_deg: 10, towards: left}}\n"
                    f"loads:\n  seismic: {{horizontal: 1.5, direction: up_dip}}\n"  # by which it fails sooner than at rest
                    f"  water: {{level: 2, faces: {faces}, uplift: triangular}}\n")
            case = self.case(text)
            names = {load["name"]: load["moment_nm"]["value"] for load in case["loads"]}
            self.assertGreater(names["uplift"], 0)
            c, s = math.cos(math.radians(10)), math.sin(math.radians(10))
            depth = 2 + 2 * s  # over the toe, below the same level
            height = depth / c
            # about the upper end: normal to the face at a third over the toe, along the slope
            self.agrees(names["water"], push * 1000 * 9.81 * depth * height / 2 * height / 3)

    def test_cautions(self):
        block = [(0, 0), (2, 0), (2, 3), (0, 3)]
        flat = "tilt: {towards: left, angle_deg: 0}\n"
        for water, said, not_said in (("level: 1", ["which faces the water wets", "how the water lifts"], []),
                                      ("tension_crack: {level: 1}", ["how the water lifts"], ["which faces"]),
                                      ("level: 1, faces: both, uplift: none", [], ["does not say"]),
                                      ("level: -1, faces: both, uplift: full", ["it does not act"], ["above the top"])):
            self.drawn(block, f"{{{water}}}", more=flat)
            report = " ".join(run("solve", self.path)[1].split())
            for text in said:
                self.assertIn(text, report, water)
            for text in not_said:
                self.assertNotIn(text, report, water)

    def test_filled_crack(self):
        """examples/slope/filled_crack.yaml: forces by hand in horizontal and vertical parts, about the toe (0, 0). On the back, from
        (4, 3) by 1 in 5 to the left, the water reaches (3.6, 5); ice of 0.3 m is centred at 4.85; in front the surface falls
        by 1 in 10 from 1 m over the toe, and the face by 1 in 6: it ends at y = 60/61."""
        self.path.write_text((ROOT / "examples/slope/filled_crack.yaml").read_text())
        case = solve(self.path)["cases"][0]
        g = float(G)
        at = (4 - 0.4 / 3, 3 + 2 / 3)
        behind = 2 * g * at[1] - 0.4 * g * at[0]  # leftwards above the toe overturns, downwards beside it holds
        y = 60 / 61
        front = g * y / 2 * (-(y / 3) - 1 / 6 * (y / 18))  # g at the toe, over a face from there to (-y/6, y)
        self.agrees(self.moment(case, "water"), 1000 * (behind + front))
        x, up = 4 - 1.85 / 5, 4.85
        self.agrees(self.moment(case, "ice"), 1000 * 50 * (0.3 * up - 0.06 * x))
        self.agrees(self.moment(case, "uplift"), 1000 * 25 * (g / 6 + 2 * g / 3))

    def test_level_varies(self):
        """The level of water at which the block slides, back from its factor; and tilts of a sweep wet the block as they lie."""
        block = "block: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\n"
        text = block + "slope: {dip_deg: 20, towards: left}\nloads:\n  water: {level: 5/2, faces: behind, uplift: full}\n"
        factor = self.case(text)["sliding"]["fos"]["value"]
        found = run("solve", "--find", "loads.water.level", "--for", f"sliding_fos={factor!r}", "--from", "1", "--to", "3",
                    self.path)
        self.assertIn("\n  2.5 ", found[1])
        alone = [self.case(text.replace("dip_deg: 20", f"dip_deg: {dip}"))["sliding"]["fos"]["value"] for dip in (15, 25)]
        self.case(text)
        for dip, fos in zip((15, 25), alone):
            varied = solve(self.path, "--set", f"slope.dip_deg={dip}")["cases"][0]
            self.assertEqual(varied["sliding"]["fos"]["value"], fos)

    def test_refused(self):
        """What is wrong is told with its place and what to do about it; nothing is computed."""
        head = "block: {slab: {width: 2, height: 3}, unit_weight_kn_m3: 26}\nframe: base\nloads:\n  water: "
        line = 6 + 1  # of the water
        for water, place, said in (
                ("{surface: [[-1, 1], [3, 2], [2, 3]]}", 38, "goes back here"),
                ("{surface: [[-1, 1], [-1, 2], [3, 3]]}", 30, "stands upright"),
                ("{surface: [[-1, 1], [1, 2]]}", 30, "let it reach past the right side"),
                ("{surface: [[1, 1], [3, 2]]}", 21, "let it reach past the left side"),
                ("{surface: [[1, 1]]}", 20, "two points at least"),
                ("{level: .nan}", 18, "not a finite number"), ("{level: 2 m}", 20, "does not continue a number"),
                ("{level: 1, height: 1}", 10, "give one of them"), ("{unit_weight_kn_m3: 10}", 10, "water needs 'height'"),
                ("{level: 1, faces: left}", 28, "behind (up-dip of the block), front or both"),
                ("{level: 1, uplift: half}", 29, "triangular"), ("{height: 1, uplift: full}", 10, "tension_crack"),
                ("{level: 1, stays_level: true}", 10, "leave it out"), ("{level: 1, ice_kpa: 3}", 10, "ice_thickness"),
                ("{tension_crack: {level: 1, height: 1}}", 10, "one of them"),
                ("{tension_crack: {height: 1}, faces: both}", 10, "say where it stands in front"),
                ("{level: 1, tension_crack: {level: 2}, faces: front}", 10, "faces: both"),
                ("{tension_crack: {level: 1, distance: 1}}", 10, "leave one of them out")):
            self.path.write_text(HEAD.format(unit="m") + head + water + "\ntilt: {towards: left, angle_deg: 0}\n")
            status, out, err = run("solve", self.path)
            self.assertEqual((status, out), (3, ""), water)
            self.assertIn(f"scene.yaml:{line}:{place}: ", err, water)
            self.assertIn(said, err, water)


if __name__ == "__main__":
    main()
