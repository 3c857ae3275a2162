# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A block that lies on a slope, `slope: {dip_deg, towards}`: as the same block on a table at that tilt; as the same section drawn
as it lies, `frame: world`, under every load; in an earthquake both ways, by moments worked out by hand; and in a mirror."""

import cmath
import json
import math
import pathlib
import random
import tempfile
import unittest

from harness import ROOT, main, run, solve
from svg import Drawing

EXAMPLES = ROOT / "examples"
HEAD = "topple: 1\nlength_unit: m\nfriction_angle_deg: 38\n"
#: Direction of the slope of the drawing as it lies: a dip whose cosine and sine are rational.
COSINE, SINE, SLOPE_DEG = 24 / 25, 7 / 25, math.degrees(math.atan2(7, 24))
BLOCK = (0.84, 0.925, 0.975)  # its tint, as src/presentation/figure/view.c has it
LEANING = [(0, 0), (2, 0), (2.5, 4), (0.5, 5)]


def ring(points):
    return "[" + ", ".join(f"[{x!r}, {y!r}]" for x, y in points) + "]"


def lying(points):
    """In horizontal and vertical coordinates, where the plane dips to the left: exact decimals."""
    return [(round(COSINE * x - SINE * y, 9), round(SINE * x + COSINE * y, 9)) for x, y in points]


def mirrored(points):
    return [(-x, y) for x, y in reversed(points)]


def factor_by_hand(width, height, dip_deg, across, up, up_dip):
    """Of a slab about its lower or its upper end: the moment of the weight, whose two components count apart, over what
    overturns; k_h and k_v act at the centroid."""
    dip = math.radians(dip_deg)
    along, normal = (-math.sin(dip), -math.cos(dip)) if not up_dip else (math.sin(dip), -math.cos(dip))
    if up_dip:  # about the upper end only the vertical distance counts: results are in horizontal coordinates
        arm = width / 2 * math.cos(dip) + height / 2 * math.sin(dip)
        rise = height / 2 * math.cos(dip) - width / 2 * math.sin(dip)
        return arm / (across * rise + up * arm)
    overturning = -along * height / 2
    for force_along, force_normal in ((-across * math.cos(dip), across * math.sin(dip)), (up * math.sin(dip), up * math.cos(dip))):
        overturning += force_normal * width / 2 - force_along * height / 2
    return -normal * width / 2 / overturning


class Slope(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, text):
        path = self.folder / "scene.yaml"
        path.write_text(HEAD + text)
        return path

    def found(self, text):
        """The governing case, with the earthquakes."""
        told = solve(self.write(text))
        return told["cases"][0] | {"earthquakes": told.get("earthquakes")}

    def refused(self, text):
        status, out, error = run("solve", self.write(text))
        self.assertEqual((status, out), (3, ""), error)
        return error

    def test_as_on_a_table(self):
        """Where nothing shakes it: to the last digit."""
        for block in ("slab: {width: 1.2, height: 4}", "teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}",
                      f"outline: {ring(LEANING)}", "ellipse: {width: 8, height: 3, flat: 0.6}"):
            for base in ("", "base: {beyond: {left: 3, right: 1}}\n"):
                text = f"block: {{{block}}}\n{base}"
                slope = self.found(text + "slope: {dip_deg: 11.5, towards: left}\n")
                table = self.found(text + "tilt: {angle_deg: 11.5, towards: left}\n")
                for name in ("critical_angle_deg", "pivots", "limit", "governing_fos", "mechanism"):
                    self.assertEqual(slope.get(name), table.get(name), (block, name))
                self.assertEqual((slope["frame"]["is"], slope["frame"]["dip_deg"]["value"]), ("slope", 11.5))

    def test_may_steepen(self):
        """A flat slab slides where the slope is as steep as φ, a column topples where its diagonal is upright: by how much either may
        steepen, and to which dip, as the report says it. Where there is no such number a word says why."""
        for block, dip, end in (("slab: {width: 4, height: 1}", 11.5, 38), ("slab: {width: 1, height: 4}", 10, math.degrees(math.atan(1 / 4)))):
            scene = f"block: {{{block}}}\nslope: {{dip_deg: {dip}, towards: left}}\n"
            first = self.found(scene)["first"]
            self.assertAlmostEqual(first["steepen_to_deg"]["value"], end, 11)
            self.assertAlmostEqual(first["steepen_by_deg"]["value"], end - dip, 11)
            self.assertNotIn("steepen_is", first)
            _, out, _ = run("solve", self.write(scene))
            self.assertIn(f"It may steepen by {end - dip:.3f}°, to a dip of {end:.3f}°", out)
        slide = self.found("block: {slab: {width: 4, height: 1}}\nslope: {dip_deg: 40, towards: left}\n")["first"]
        self.assertEqual((slide["steepen_by_deg"], slide["steepen_to_deg"], slide["steepen_is"]), (None, None, "does not stand as it lies"))
        teeth = "block: {teeth: {count: 2, width: 10, height: 10, depth: 30, left_end: valley}}\n"
        locked = self.found(teeth + "slope: {dip_deg: 10, towards: left}\n")
        self.assertEqual((locked["mechanism"], locked["first"]["steepen_is"]), ("interlocked", "certain to stand at every dip"))
        self.assertEqual((locked["first"]["margin_deg"], locked["first"]["margin_is"]), (None, "certain to stand at every tilt"))

    def test_why_there_is_no_margin(self):
        """Without friction a slab stands at no tilt, and its margin says so; on a table nothing is said of a slope."""
        for text, why in (("friction_angle_deg: 0\ntilt: {towards: left, angle_deg: 5}\n", "certain to stand at no tilt"),
                          ("friction_angle_deg: 30\n", "no tilt given")):
            path = self.folder / "scene.yaml"
            path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 4, height: 1}}\n" + text)
            first = solve(path)["cases"][0]["first"]
            self.assertEqual((first["margin_deg"], first["margin_is"]), (None, why))
            self.assertNotIn("steepen_by_deg", first)

    def test_as_drawn_where_it_lies(self):
        """Loads at points of the section, water, and an earthquake both ways: the same as in the frame of the world. The dip there
        is atan(7/24), here it is that in doubles: apart by less than 1e-14 of a degree."""
        loads = ("seismic: {{horizontal: 0.12, vertical: 0.04}}, water: {{height: 1, uplift: true}}, "
                 "anchors: [{{at: {at}, direction_deg: {way}, force_kn: 12}}], "
                 "pressures: [{{from: {a}, to: {b}, kpa: [3, 5]}}]")
        plane = {"at": [(1, 1)], "a": [LEANING[1]], "b": [(2.25, 2)]}
        for base in ("{mated: true, beyond: {left: 2, right: 1}}", "profile"):
            text, bases = {}, {}
            for kind, turn, way in (("slope", list, -40), ("world", lying, SLOPE_DEG - 40)):
                at = {name: ring(turn(points))[1:-1] for name, points in plane.items()}
                bases[kind] = (f"{{profile: {ring(turn([(-3, 0), (2.5, 0)]))}}}" if base == "profile" else base)
                text[kind] = (f"block: {{outline: {ring(turn(LEANING))}, unit_weight_kn_m3: 26}}\nbase: {bases[kind]}\n"
                              f"loads: {{{loads.format(way=repr(way), **at)}}}\n")
            slope = self.found(text["slope"] + f"slope: {{dip_deg: {SLOPE_DEG!r}, towards: left}}\n")
            world = self.found(text["world"] + "frame: world\n")
            ways = [[(one["towards"], one["vertical"], one["mechanism"], one["fos"]["value"]) for one in case["earthquakes"]]
                    for case in (slope, world)]
            self.assertEqual(len(ways[0]), 4)
            for one, other in zip(*ways):
                self.assertEqual(one[:3], other[:3])
                self.assertAlmostEqual(one[3], other[3], delta=1e-9)

    def test_earthquake_by_hand(self):
        """A slab about the lower end and about the upper one, with k_v and without."""
        random.seed(33)
        for _ in range(12):
            width, height = random.randint(40, 90) / 100, random.randint(100, 300) / 100
            dip, across, up = random.randint(2, 6), random.randint(15, 40) / 100, random.randint(1, 9) / 100
            case = self.found(f"block: {{slab: {{width: {width}, height: {height}}}, unit_weight_kn_m3: 26}}\n"
                              f"slope: {{dip_deg: {dip}, towards: left}}\n"
                              f"loads: {{seismic: {{horizontal: {across}, vertical: {up}}}}}\n")
            for one in case["earthquakes"]:
                expected = factor_by_hand(width, height, dip, across, up if one["vertical"] else 0, one["towards"] == "right")
                if one["fos"]["value"] < 1 or expected < 1.2:  # else sliding may govern
                    self.assertAlmostEqual(one["fos"]["value"], expected, delta=1e-9 * expected)
            self.assertEqual(len(case["earthquakes"]), 4)

    def test_mirror(self):
        text = "block: {{outline: {}, unit_weight_kn_m3: 26}}\nslope: {{dip_deg: 9, towards: {}}}\nloads: {{seismic: {{horizontal: 0.2}}}}\n"
        one = self.found(text.format(ring(LEANING), "left"))
        other = self.found(text.format(ring(mirrored(LEANING)), "right"))
        for way, mirror in zip(one["earthquakes"], other["earthquakes"], strict=True):
            bound = way["fos"]["error"] + mirror["fos"]["error"]
            self.assertLessEqual(abs(way["fos"]["value"] - mirror["fos"]["value"]), bound)
        self.assertEqual({one["towards"], other["towards"]}, {"left", "right"})

    def test_tilt_is_added(self):
        text = "block: {slab: {width: 1, height: 3}}\n"
        one = self.found(text + "slope: {dip_deg: 9, towards: right}\ntilt: {angle_deg: 4}\n")
        other = self.found(text + "slope: {dip_deg: 13, towards: right}\n")
        self.assertEqual(one["governing_fos"], other["governing_fos"])

    def test_anchored_block(self):
        """examples/slope/anchored_block.yaml, with hand sums by limit equilibrium: 1.2 x 4 m at 25°, water to 2 m in the crack
        behind it, 80 kN inclined by 15° below the horizontal at two thirds of its height."""
        scene = (EXAMPLES / "slope" / "anchored_block.yaml").read_text()
        passive = scene.replace("force_kn: 80", "force_kn: 80, passive: true")
        for text, sliding, toppling in ((scene, 12.467, None), (passive, 2.503, 1.971),
                                        (passive.replace("height: 2", "height: 2, uplift: true"), 2.397, 1.837)):
            path = self.folder / "scene.yaml"
            path.write_text(text)
            case = solve(path)["cases"][0]
            self.assertAlmostEqual(case["sliding"]["fos"]["value"], sliding, delta=5e-4)
            if toppling is not None:
                self.assertAlmostEqual(case["toppling"]["fos"]["value"], toppling, delta=5e-4)
        for text, force in ((scene, 31.886), (passive, 41.452)):
            path.write_text(text)
            found = json.loads(run("solve", "--json", "--find", "loads.anchors.1.force_kn", "--for", "fos=1.3", path)[1])
            self.assertAlmostEqual(found["find"]["solutions"][0]["value"], force, delta=5e-4)

    def test_report_names_place_and_azimuth(self):
        text = "block: {slab: {width: 1, height: 3}}\nslope: {dip_deg: 9, towards: left, "
        for azimuth, shown in (("strike_deg: 330", "60.0°"), ("dip_direction_deg: 135", "135.0°")):
            report = run("solve", self.write(text + azimuth + "}\n"))[1]
            self.assertIn("Slope    dips by 9.000° towards the left, azimuth " + shown, report)
            self.assertNotIn("table", report)
            self.assertNotIn("tilted", report.lower())
            self.assertIn("  Stands as it lies, at 9°: no motion can begin.\n  It may steepen by 9.435°, to a dip of 18.435°", report)

    def test_anchored_block_read_by_an_engineer(self):
        """What matters on site comes first: it stands, and by how much the slope may steepen, 53.367° less 25°. That the anchor
        would pull it over where the slope was nearly level comes last."""
        report = run("solve", EXAMPLES / "slope" / "anchored_block.yaml")[1]
        self.assertIn("  Stands as it lies, at 25°: no motion can begin.\n"
                      "  It may steepen by 28.367°, to a dip of 53.367°: there it\n  topples about pivot 1, the flat end at (0, 0).\n"
                      "  (Laid flatter, to 3.190° or less, it could begin to topple.)\n", report)
        for words in ("turned back", "where its mean plane is level", "Motions can begin"):
            self.assertNotIn(words, report)

    def test_what_does_not_stand(self):
        """A slab 1 m wide and 4 m high on 20° topples: its width is passed at atan(1/4) = 14.036°, 5.964° flatter."""
        report = run("solve", self.write("block: {slab: {width: 1, height: 4}}\nslope: {dip_deg: 20, towards: left}\n"))[1]
        self.assertIn("  Does not stand as it lies, at 20°: it can begin to topple.\n"
                      "  Certain to stand only if it lay flatter by 5.964°, at a dip below 14.036°.\n", report)

    def test_figure_as_it_lies(self):
        """The block is turned by its dip, not by its limit, whichever way it dips; under an earthquake up-dip, too."""
        for towards, sign in (("left", 1), ("right", -1)):
            for loads in ("", "loads: {seismic: {horizontal: 0.4}}\n"):
                path = self.write("block: {slab: {width: 1.5, height: 3}, unit_weight_kn_m3: 26}\nslope: {dip_deg: 9, towards: %s, dip_direction_deg: 10}\n%s"
                                  % (towards, loads))
                picture = self.folder / "figure.svg"
                self.assertEqual(run("solve", "--figure", picture, path)[0], 0)
                block = Drawing(picture.read_text()).areas[BLOCK][0][0]
                corners = [complex(x, -y) for x, y in block]
                sides = [b - a for a, b in zip(corners, corners[1:] + corners[:1])]
                base = min((side for side in sides if abs(abs(side) - min(map(abs, sides))) < 0.01), key=lambda s: -s.real)
                self.assertAlmostEqual(math.degrees(cmath.phase(base)), sign * 9, delta=0.1)

    def test_dip_can_be_varied(self):
        """A slab of friction 38° with a width of 1 and a height of 1 slides where the dip is 38°."""
        path = self.write("block: {slab: {width: 1, height: 1}}\nslope: {dip_deg: 20, towards: left}\n")
        found = json.loads(run("solve", "--json", "--find", "slope.dip_deg", "--for", "governing_fos=1", path)[1])
        self.assertAlmostEqual(found["find"]["solutions"][0]["value"], 38, delta=1e-9)

    def test_bad_input(self):
        block = "block: {slab: {width: 1, height: 3}}\n"
        for text, message in (("slope: {towards: left}\n", "'dip_deg' is missing here"),
                              ("slope: {dip_deg: 9}\n", "'towards' is missing here"),
                              ("slope: {dip_deg: 91, towards: left}\n", "dip_deg"),
                              ("slope: {dip_deg: 9, towards: both}\n", "towards must be left or right"),
                              ("slope: {dip_deg: 9, towards: left, strike_deg: 400}\n", "[0, 360]"),
                              ("slope: {dip_deg: 9, towards: left, strike_deg: 1, dip_direction_deg: 91}\n", "not both"),
                              ("frame: base\nslope: {dip_deg: 9, towards: left}\n", "'frame' or 'slope'"),
                              ("slope: {dip_deg: 80, towards: left}\ntilt: {angle_deg: 11}\n", "more than 90°"),
                              ("slope: {dip_deg: 9, towards: left}\ntilt: {towards: right}\n", "dips to the left")):
            error = self.refused(block + text)
            self.assertIn(message, error)
            self.assertRegex(error, r"scene\.yaml:\d+:\d+: ")


main()
