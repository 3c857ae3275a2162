# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""An earthquake shakes a block that lies on a slope both ways: down-dip and up-dip, with its vertical part and without.
The worst governs what every output says; a mirror image says the same; moments by hand agree."""

import csv
import json
import math
import re
import pathlib
import tempfile
import unittest
from fractions import Fraction as F

from harness import main, run, solve

HEAD = "topple: 1\nlength_unit: m\n"
#: On a joint that dips by 0.1°, and leans to the right: it stands to the left and topples to the right.
OUTLINE = [(F(0), F(0)), (F(2), F(4, 1000)), (F(34, 10), F(4)), (F(14, 10), F(4))]
JOINT = OUTLINE[:2]


def text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def centroid(ring):
    """Exact, by triangles from the origin."""
    area = x = y = F(0)
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        cross = ax * by - bx * ay
        area, x, y = area + cross, x + cross * (ax + bx), y + cross * (ay + by)
    return x / (3 * area), y / (3 * area)


def factor(toe, towards, k, v=F(0)):
    """Of OUTLINE about `toe`, moments of weight and earthquake by hand: the weight holds, k_h and k_v drive."""
    x, y = centroid(OUTLINE)
    arm = (toe[0] - x) if towards == "right" else (x - toe[0])
    return float(arm / (k * (y - toe[1]) + v * arm))


def sliding(dip, k, tangent):
    """On driving loads of a block on a plane: its weight across the base resists by friction; its weight along the base and all of
    the earthquake, which lifts it, too, drive."""
    sine, cosine = math.sin(dip), math.cos(dip)
    return cosine * tangent / (sine + k * cosine + k * sine * tangent)


#: Down-dip, on the joint of atan(0.004 / 2).
DOWN_DIP = sliding(math.atan(0.002), 0.2, math.tan(math.radians(40)))


def mirrored(points):
    return [(-x, y) for x, y in points][::-1]


class Earthquake(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, seismic, outline=tuple(OUTLINE), joint=tuple(JOINT), more="", frame="world"):
        self.path.write_text(HEAD + f"frame: {frame}\nblock: {{outline: {text(outline)}, unit_weight_kn_m3: 26}}\n"
                             f"base: {{mated: true, between: {text(joint)}, beyond: {{left: 3, right: 3}}}}\n"
                             f"friction_angle_deg: 40\nloads: {{seismic: {{{seismic}}}}}\n{more}")
        return self.path

    def found(self, *arguments, **options):
        return solve(self.write(*arguments, **options))

    def test_by_hand(self):
        """0.300 / 0.399 to the right, up-dip, which governs; alone the scene said more than 4 and nothing else."""
        own = self.found("horizontal: 0.2")
        case = own["cases"][0]
        self.assertEqual((len(own["cases"]), case["towards"], case["mechanism"], case["frame"]["level"]),
                         (1, "right", "topples", True))
        meant = factor(JOINT[1], "right", F(1, 5))
        self.assertAlmostEqual(meant, 0.300 / 0.399, delta=0.001)
        self.assertAlmostEqual(case["governing_fos"]["fos"]["value"], meant, delta=1e-12)
        self.assertEqual([(q["towards"], q["direction"], q["mechanism"]) for q in own["earthquakes"]],
                         [("right", "up_dip", "topples"), ("left", "down_dip", "stands")])
        self.assertAlmostEqual(own["earthquakes"][1]["fos"]["value"], DOWN_DIP, delta=1e-9)

    def test_vertical_part(self):
        """Each way with the vertical part and without it; upwards it lessens what holds."""
        own = self.found("horizontal: 0.1, vertical: 0.1")
        self.assertEqual(sorted((q["direction"], q["vertical"]) for q in own["earthquakes"]),
                         [("down_dip", False), ("down_dip", True), ("up_dip", False), ("up_dip", True)])
        for q in own["earthquakes"]:
            if q["direction"] == "up_dip":
                meant = factor(JOINT[1], "right", F(1, 10), F(1, 10) * q["vertical"])
                self.assertAlmostEqual(q["fos"]["value"], meant, delta=1e-12)
        factors = [q["fos"]["value"] for q in own["earthquakes"]]
        self.assertEqual(own["cases"][0]["governing_fos"]["fos"]["value"], min(factors))

    def test_direction(self):
        """One way alone, as it is asked for; a word that is none, and a table, are refused."""
        down, up = (self.found(f"horizontal: 0.2, direction: {way}") for way in ("down_dip", "up_dip"))
        self.assertEqual([("earthquakes" in own, own["cases"][0]["towards"]) for own in (down, up)],
                         [(False, "left"), (False, "right")])
        both = self.found("horizontal: 0.2, direction: both")
        self.assertEqual(both["earthquakes"], self.found("horizontal: 0.2")["earthquakes"])
        self.assertEqual([q["fos"] for q in both["earthquakes"]], [own["cases"][0]["governing_fos"]["fos"] for own in (up, down)])
        for seismic, frame, words in (("horizontal: 0.2, direction: up", "world", "direction must be both, down_dip or up_dip"),
                                      ("horizontal: 0.2, direction: up_dip", "base", "where the block lies on a slope")):
            status, out, err = run("solve", self.write(seismic, frame=frame))
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(words, err)

    def test_mirror_image(self):
        """The same numbers, left for right."""
        for seismic in ("horizontal: 0.2", "horizontal: 0.1, vertical: 0.05"):
            own, other = self.found(seismic), self.found(seismic, mirrored(OUTLINE), mirrored(JOINT))
            for q, r in zip(own["earthquakes"], other["earthquakes"], strict=True):
                self.assertNotEqual(q["towards"], r["towards"])
                self.assertEqual([q[key] for key in ("direction", "vertical", "mechanism")],
                                 [r[key] for key in ("direction", "vertical", "mechanism")])
                self.assertAlmostEqual(q["fos"]["value"], r["fos"]["value"], delta=1e-9)

    def test_slope(self):
        """A square of sides 1 on 20° slides up-dip where k_h cos 20° - sin 20° outdoes tan phi (cos 20° + k_h sin 20°), and
        down-dip long before: the governing factor is that one, the other is the closed form too."""
        a, k, tan = math.radians(20), 0.3, math.tan(math.radians(40))
        c, s = math.cos(a), math.sin(a)
        ring = [(0, 0), (c, s), (c - s / 2, s + c / 2), (-s / 2, c / 2)]
        own = self.found(f"horizontal: {k}", ring, ring[:2])
        meant = {"down_dip": sliding(a, k, tan), "up_dip": None}
        first = own["earthquakes"][0]
        self.assertEqual(first["direction"], "down_dip")
        self.assertAlmostEqual(first["fos"]["value"], meant["down_dip"], delta=1e-6)
        own = self.found("horizontal: 2.5, direction: up_dip", ring, ring[:2])["cases"][0]
        self.assertAlmostEqual(own["sliding"]["fos"]["value"], (c + 2.5 * s) * tan / (2.5 * c - s), delta=1e-6)

    def test_teeth_beyond_the_block(self):
        """Teeth go on along the slope past the block: up-dip they hold as the same base by its points does."""
        head = "topple: 1\nlength_unit: mm\nfriction_angle_deg: 30\nloads: {seismic: {horizontal: 1/10}}\n" \
               "slope: {dip_deg: 10, towards: left}\n"
        teeth = "block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}, thickness: 20, " \
                "unit_weight_kn_m3: 25.8}\nbase: {mated: true, beyond: {left: 20, right: 20}}\n"
        ring = text([(0, 0), (30, 5), (60, 0), (90, 5), (90, 125), (0, 125)])
        points = f"block: {{outline: {ring}, thickness: 20, unit_weight_kn_m3: 25.8}}\n" \
                 f"base: {{profile: {text([(-20, '10/3'), (0, 0), (30, 5), (60, 0), (90, 5), (110, '5/3')])}}}\n"
        found = []
        for scene in (teeth, points):
            path = self.path.with_name("teeth.yaml")
            path.write_text(head + scene)
            found.append([(own["direction"], own["mechanism"], own["fos"]["value"]) for own in solve(path)["earthquakes"]])
        self.assertEqual([own[:2] for own in found[0]], [own[:2] for own in found[1]])
        self.assertEqual({own[0] for own in found[0]}, {"up_dip", "down_dip"})
        for one, other in zip(*found):
            self.assertAlmostEqual(one[2], other[2], delta=1e-12 * one[2])

    def boulder(self, block, base, towards, more=""):
        self.path.write_text(HEAD + f"block: {{{block}, unit_weight_kn_m3: 26}}\nbase: {{{base}}}\nfriction_angle_deg: 35\n"
                             f"slope: {{dip_deg: 11, towards: {towards}}}\nloads: {{seismic: {{horizontal: 0.1, vertical: 0.04{more}}}}}\n")
        return solve(self.path)

    def test_ellipse(self):
        """A boulder is shaken up-dip, too, where it is turned: about the upper end of its flat by hand, with its area and centroid by
        Simpson's rule over its width at each height; its mirror image to the last digits; and as the polygon of many corners on it, in all
        that is told of area, moments, angles and motions."""
        w, h, flat, dip = 8.0, 3.0, 0.6, math.radians(11)
        low = -math.cos(math.asin(flat / w))
        ends, steps = (math.asin(low), math.pi / 2), 400
        weights = [1, *([4, 2] * (steps // 2))[:-1], 1]
        angles = [ends[0] + (ends[1] - ends[0]) * k / steps for k in range(steps + 1)]  # y = h/2 sin t, width w cos t, dy = h/2 cos t dt
        each = [own * w * h / 2 * math.cos(t) ** 2 for own, t in zip(weights, angles)]
        area = math.fsum(each) * (ends[1] - ends[0]) / steps / 3
        rise = math.fsum(own * h / 2 * (math.sin(t) - low) for own, t in zip(each, angles)) / math.fsum(each)
        arm = flat / 2 * math.cos(dip) + rise * math.sin(dip)
        by_hand = arm / (0.1 * (rise * math.cos(dip) - flat / 2 * math.sin(dip)) + 0.04 * arm)
        beyond = "mated: true, beyond: {left: 3, right: 2}"
        told = self.boulder(f"ellipse: {{width: {w}, height: {h}, flat: {flat}}}", beyond, "left", ", direction: up_dip")["cases"][0]
        self.assertAlmostEqual(told["block"]["area_m2"]["value"], area, delta=1e-9 * area)
        self.assertAlmostEqual(told["block"]["centroid_y_m"]["value"], rise, delta=1e-9)
        self.assertAlmostEqual(told["block"]["centroid_x_m"]["value"], 0, delta=1e-12)
        self.assertEqual([p["x_m"]["value"] for p in told["pivots"]], [-0.3, 0.3])
        # at rest it rolls down-dip about the lower end sooner, and that state counts in addition to every earthquake
        at_rest = (flat / 2) / (rise * math.tan(dip))
        self.assertAlmostEqual(told["governing_fos"]["fos"]["value"], at_rest, delta=1e-9 * at_rest)
        for towards, sign in (("left", 1), ("right", -1)):
            both = self.boulder(f"ellipse: {{width: {w}, height: {h}, flat: {flat}}}", f"mated: true, beyond: {{left: {3 if sign > 0 else 2}, "
                                f"right: {2 if sign > 0 else 3}}}", towards)
            quakes = [(own["direction"], own["vertical"], own["mechanism"], own["fos"]["value"]) for own in both["earthquakes"]]
            if sign > 0:
                first = quakes
            self.assertEqual([own[:3] for own in quakes], [own[:3] for own in first])
            for one, other in zip(quakes, first):
                self.assertAlmostEqual(one[3], other[3], delta=1e-12 * one[3])
        self.assertEqual({own[0] for own in first}, {"up_dip", "down_dip"})
        (up_dip,) = [fos for direction, vertical, _, fos in first if direction == "up_dip" and vertical]
        self.assertAlmostEqual(up_dip, by_hand, delta=1e-9 * by_hand)
        self.assertNotIn("down-dip only", run("solve", self.path)[1])
        count, cut = 800, math.asin(flat / w)
        turn = [cut - math.pi / 2 + (2 * math.pi - 2 * cut) * k / count for k in range(count + 1)]
        ring = [(f"{w / 2 * math.cos(t):.12f}", f"{h / 2 * (math.sin(t) - low):.12f}") for t in turn]
        ring[0], ring[-1] = ("0.3", "0"), ("-0.3", "0")
        other = self.boulder(f"outline: {text(ring)}", beyond + ", between: [[-0.3, 0], [0.3, 0]]", "left", ", direction: up_dip")["cases"][0]
        near = lambda one, two, what: self.assertAlmostEqual(one["value"], two["value"], delta=4e-5 * max(1, abs(one["value"])), msg=what)
        for key in ("area_m2", "weight_n", "second_moment_xx_m4", "second_moment_yy_m4", "second_moment_xy_m4", "centroid_y_m"):
            near(told["block"][key], other["block"][key], key)
        near(told["limit"]["critical_angle_deg"], other["limit"]["critical_angle_deg"], "limit")
        near(told["onset"]["critical_angle_deg"], other["onset"]["critical_angle_deg"], "onset")
        for one, two in zip(told["factors"], other["factors"], strict=True):
            self.assertEqual((one["mechanism"], one["definition"], one["fos"] is None), (two["mechanism"], two["definition"], two["fos"] is None))
            if one["fos"] is not None:
                near(one["fos"], two["fos"], one["definition"])

    def test_a_block_that_fails_down_dip_anyway(self):
        """Shaken up-dip it topples down-dip still, and has no factor there; the shaking that drives it governs: moments about
        the toe of a slab w by h on 30°, w cos β against h sin β + k (w sin β + h cos β)."""
        path = self.path.with_name("anyway.yaml")
        path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\n"
                        "base: {mated: true}\nfriction_angle_deg: 45\nslope: {dip_deg: 30, towards: right}\n"
                        "loads: {seismic: {horizontal: 0.02}}\n")
        own = solve(path)
        self.assertEqual([(e["direction"], e["mechanism"]) for e in own["earthquakes"]],
                         [("down_dip", "topples"), ("up_dip", "topples")])
        c, s, k = math.cos(math.radians(30)), math.sin(math.radians(30)), 0.02
        self.assertAlmostEqual(own["cases"][0]["governing_fos"]["fos"]["value"], 2 * c / (4 * s + k * (2 * s + 4 * c)),
                               delta=1e-9)
        self.assertEqual(own["cases"][0]["towards"], "right")

    def test_tilted_further(self):
        """A tilt is added to the dip, and the earthquake up-dip is of the block as it lies then: on a level joint turned to
        10° by coordinates, or by a tilt of 4° on 6°."""
        for dip, tilt in ((10, 0), (6, 4)):
            c, s = math.cos(math.radians(dip)), math.sin(math.radians(dip))
            ring = [(0, 0), (c, s), (c - 2 * s, s + 2 * c), (-2 * s, 2 * c)]
            own = self.found("horizontal: 0.9, direction: up_dip", ring, ring[:2], f"tilt: {{angle_deg: {tilt}}}\n")["cases"][0]
            c, s = math.cos(math.radians(10)), math.sin(math.radians(10))
            # about the upper end: weight and earthquake at half the width and at the height 1
            holds, drives = 0.5 * c + 1.0 * s, 0.9 * (1.0 * c - 0.5 * s)
            self.assertAlmostEqual(own["governing_fos"]["fos"]["value"], holds / drives, delta=1e-6)

    def test_against_the_shaking(self):
        """1.2 x 4 m at 30 degrees: about the lower edge even 0.1 g up-dip holds with 0.6 cos 30 + 0.1 (2 cos 30 + 0.6 sin 30) = 0.723
        against 2 sin 30 = 1, so it topples down-dip though shaken up-dip, and no factor is told of that."""
        self.path = self.path.with_name("slender.yaml")
        self.path.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1.2, height: 4}, unit_weight_kn_m3: 26}\n"
                             "slope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 25\nloads: {seismic: {horizontal: 0.1}}\n")
        out = run("solve", self.path)[1]
        self.assertIn("Seismic  shaken to the left, down-dip: topples, FoS 0.431;\n", out)
        self.assertIn("shaken to the right, up-dip: topples down-dip all the same.\n", out)

    def test_every_output(self):
        """Report, figure, sheet, --fail-below, sweep and study are of the one that governs; what is not looked at is told."""
        status, out, _ = run("solve", self.write("horizontal: 0.2"))
        self.assertEqual(status, 0)
        self.assertIn("to the right, up-dip: topples, FoS 0.751;\n", out)
        self.assertIn("The first of them governs", out)
        self.assertIn(f"to the left, down-dip: stands, FoS {DOWN_DIP:.3f}", out)
        self.assertEqual(run("solve", "--fail-below", "1.1", self.path)[0], 1)
        status, out, _ = run("sweep", "--json", "--x", "loads.seismic.horizontal=0.1:0.3:0.1", self.path)
        factors = [point["cases"][0]["fos"]["value"] for point in json.loads(out)["points"]]
        for k, fos in zip((1, 2, 3), factors, strict=True):
            self.assertAlmostEqual(fos, factor(JOINT[1], "right", F(k, 10)), delta=1e-9)

    def test_every_other_output(self):
        """Sheet, table, study and map: the factor about the right end, 0.30009 / 0.2 / 1.99723 = 0.751, and 1 where the earthquake
        is 0.30009 / 1.99723 = 0.15025."""
        x, y = centroid(OUTLINE)
        arm, rise = JOINT[1][0] - x, y - JOINT[1][1]
        self.write("horizontal: 0.2")
        folder = self.path.parent
        table = next(csv.DictReader(run("solve", "--csv", self.path)[1].splitlines()))
        self.assertEqual((table["towards"], table["verdict"]), ("right", "topples"))
        self.assertAlmostEqual(float(table["fos"]), float(arm / (F(1, 5) * rise)), delta=1e-9)
        self.assertEqual(run("solve", "--report", folder / "sheet.md", self.path)[0], 0)
        sheet = re.sub(r"\(data:[^)]*\)", "", (folder / "sheet.md").read_text(encoding="utf-8"))
        self.assertRegex(sheet[:sheet.index("## Signatures")], r"up-dip\*\* \| \*\*0\.751\*\* \| \*\*toppling")
        self.assertIn(f"to the left, down-dip: stands, FoS {DOWN_DIP:.3f}", sheet)
        study = folder / "study.yaml"
        study.write_text("topple_study: 1\nscene: %s\nvary: {friction_angle_deg: {uniform: {low: 39, high: 41}}}\nsamples: 5\n"
                         "sampling: {seed: 1}\n" % self.path.name, encoding="utf-8")
        status, out, error = run("study", "--rows", folder / "rows.csv", study)
        self.assertEqual((status, error), (0, ""))
        rows = list(csv.DictReader(line for line in (folder / "rows.csv").read_text().splitlines() if not line.startswith("#")))
        self.assertEqual(len(rows), 5)
        for row in rows:
            self.assertAlmostEqual(float(row["fos"]), float(arm / (F(1, 5) * rise)), delta=1e-9)
        status, out, _ = run("chart", "map", self.path, "--x", "loads.seismic.horizontal=0.1:0.2", "--y", "friction_angle_deg=30:40",
                             "--contours", "governing_fos=1", "--json")
        line = next(series for series in json.loads(out)["series"] if series["series"] == "governing_fos")
        for point in line["points"]:
            self.assertAlmostEqual(point["x"]["value"], float(arm / rise), delta=1e-9)

    def wet(self, water, *arguments):
        text = self.write(*arguments).read_text(encoding="utf-8")
        self.path.write_text(text.replace("loads: {", f"loads: {{water: {{{water}}}, ", 1), encoding="utf-8")
        return solve(self.path)

    def test_water_by_hand(self):
        """Up-dip with water: the push, which holds the block back, is left out, and its uplift drives, a third of the joint
        from the upper end; without uplift it is as if dry. Down-dip both act. The note says so, whichever governs."""
        x, y = centroid(OUTLINE)
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(OUTLINE, OUTLINE[1:] + OUTLINE[:1])) / 2
        weight, (x1, y1) = 26 * float(area), map(float, JOINT[1])
        drives, holds = 0.2 * weight * (float(y) - y1), weight * (x1 - float(x))
        for water, moment in (("height: 1, uplift: true", 9.81 * math.hypot(x1, y1) / 3), ("height: 1", 0),
                              ("height: 1, uplift: true, stays_level: true", 9.81 * math.hypot(x1, y1) ** 2 / 6)):
            own = self.wet(water, "horizontal: 0.2")
            self.assertEqual([q["direction"] for q in own["earthquakes"]], ["up_dip", "down_dip"])
            self.assertAlmostEqual(own["earthquakes"][0]["fos"]["value"], holds / (drives + moment), delta=1e-9)
            self.assertIn("under the earthquake up-dip the push of the water", " ".join(q["text"] for q in own["notes"]))
            dry = self.found("horizontal: 0.2")["earthquakes"][1]["fos"]["value"]
            self.assertLess(own["earthquakes"][1]["fos"]["value"], dry)
        c, s = math.cos(math.radians(20)), math.sin(math.radians(20))
        ring = [(0, 0), (2 * c, 2 * s), (2 * (c - s), 2 * (s + c)), (-2 * s, 2 * c)]
        own = self.wet("height: 1, uplift: true", "horizontal: 0.1", ring, ring[:2])
        self.assertEqual(own["earthquakes"][0]["direction"], "down_dip")
        self.assertIn("under the earthquake up-dip the push of the water", " ".join(q["text"] for q in own["notes"]))
        self.wet("height: 1, uplift: true", "horizontal: 0.2, direction: up_dip")
        for height, status in ((3.99, 0), (4.01, 3)):
            self.path.write_text(self.path.read_text(encoding="utf-8").replace("height: 1,", f"height: {height},"), encoding="utf-8")
            self.assertEqual(run("solve", self.path)[0], status)
            self.path.write_text(self.path.read_text(encoding="utf-8").replace(f"height: {height},", "height: 1,"), encoding="utf-8")

    def test_water_on_slopes(self):
        """A slab of the height 1 that slides or topples up-dip: weight, earthquake and uplift along and normal to the slope; the angle by
        which it would have to be turned until it slides by bisection, as uplift goes with the cosine of the dip there is then. On a
        mated base and on a profile, mirrored too. It is no less safe at rest, which beyond 45° it always is."""
        for dip, level, wide, friction, k in ((20, False, 1, 40, 2.5), (20, True, 1, 40, 2.5), (30, False, 8, 75, 12)):
            tan, weight = math.tan(math.radians(friction)), 26 * wide
            a = math.radians(dip)
            c, s = math.cos(a), math.sin(a)
            ring = [(0, 0), (wide * c, wide * s), (wide * c - s, wide * s + c), (-s, c)]
            ring = [(round(x, 12), round(y, 12)) for x, y in ring]

            def excess(turn):
                there = a - turn
                uplift = 9.81 * 0.5 / 2 * wide * (1 if level else math.cos(there))
                along = weight * (k * math.cos(there) - math.sin(there))
                return along, (weight * (math.cos(there) + k * math.sin(there)) - uplift) * tan

            def turning(turn):
                there = a - turn
                uplift = 9.81 * 0.5 / 2 * wide * (1 if level else math.cos(there))
                normal = weight * (math.cos(there) + k * math.sin(there))
                return weight * (k * math.cos(there) - math.sin(there)) / 2 + uplift * wide / 3, normal * wide / 2

            def passes(balance):
                low, high = -math.pi / 2, math.pi / 2
                while high - low > 1e-13:
                    middle = (low + high) / 2
                    low, high = (middle, high) if balance(middle)[0] < balance(middle)[1] else (low, middle)
                return math.degrees(high)

            along, resists = excess(0)
            water = f"height: 0.5, uplift: true, stays_level: {str(level).lower()}"
            for turned in (list, mirrored):
                self.wet(water, f"horizontal: {k}, direction: up_dip", turned(ring), sorted(turned(ring[:2])))
                self.path.write_text(self.path.read_text(encoding="utf-8").replace("friction_angle_deg: 40", f"friction_angle_deg: {friction}"),
                                     encoding="utf-8")
                own = solve(self.path)
                bare = self.path.read_text(encoding="utf-8")
                ends = sorted(turned([(-3 * c, -3 * s), ((wide + 3) * c, (wide + 3) * s)]))
                joint = text(sorted(turned(ring[:2])))
                plane = f"frame: {{mean_plane: {joint}}}"
                profile = [ends[0], *sorted(turned(ring[:2])), ends[1]]
                self.path.write_text(bare.replace("frame: world", plane)
                                     .replace(f"mated: true, between: {joint}, beyond: {{left: 3, right: 3}}", f"profile: {text(profile)}"),
                                     encoding="utf-8")
                for case in (own["cases"][0], solve(self.path)["cases"][0]):
                    self.assertAlmostEqual(case["sliding"]["fos"]["value"], resists / along, delta=1e-6)
                    self.assertAlmostEqual(case["sliding"]["critical_angle_deg"]["value"], passes(excess), delta=1e-6)
                    self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], passes(turning), delta=1e-6)
                    least = min(passes(excess), passes(turning))  # one facet: the two have nothing to do with each other
                    self.assertAlmostEqual(case["limit"]["critical_angle_deg"]["value"], least, delta=1e-6)

    def test_shifted_joint(self):
        """A block shifted along its teeth by half a flank lies half a tooth higher: shaken both ways there it is as the block
        that is given so on the same profile, dry and with water."""
        c, s = F(12, 13), F(5, 13)
        under = [(F(0), F(0)), (F(1), F(1, 2)), (F(2), F(0)), (F(3), F(1, 2)), (F(4), F(0))]
        body = under + [(F(4), F(3)), (F(0), F(3))]

        def page(points, mirror):
            put = [(c * x - s * y, s * x + c * y) for x, y in points]
            return mirrored(put) if mirror else put

        for mirror in (False, True):
            for way in ("both", "up_dip"):
                for water in ("", "water: {height: 1, uplift: true}, "):
                    told = []
                    shifted = [(x + F(1, 2), y + F(1, 4)) for x, y in body]
                    ends = text(page([under[0], under[4]], mirror))
                    for outline, base in ((body, f"base: {{between: {ends}, beyond: {{left: 0, right: 0}}}}\njoint: {{shift: {'-' * mirror}0.5}}"),
                                          (shifted, f"base: {{profile: {text(page(under, mirror))}}}")):
                        self.path.write_text(HEAD + f"frame: {{mean_plane: {ends}}}\nblock: {{outline: {text(page(outline, mirror))}, "
                                             f"unit_weight_kn_m3: 26}}\n{base}\nfriction_angle_deg: 40\n"
                                             f"loads: {{{water}seismic: {{horizontal: 0.45, direction: {way}}}}}\n", encoding="utf-8")
                        told.append(solve(self.path))
                    one, other = told
                    if way == "both":
                        self.assertEqual({q["direction"] for q in one["earthquakes"]}, {"up_dip", "down_dip"})
                    cases = [(own["cases"][0], [q["fos"]["value"] for q in own.get("earthquakes", [])]) for own in told]
                    self.assertEqual(cases[0][0]["mechanism"], cases[1][0]["mechanism"])
                    self.assertEqual(cases[0][0]["towards"], cases[1][0]["towards"])
                    for pair in zip(cases[0][1], cases[1][1], strict=True):
                        self.assertAlmostEqual(*pair, delta=1e-9)
                    for key in ("governing_fos", "sliding", "onset"):
                        values = [case[key]["fos"] and case[key]["fos"]["value"] for case, _ in cases]
                        self.assertAlmostEqual(*values, delta=1e-9)
                    self.assertAlmostEqual(one["cases"][0]["joint"]["shift_m"]["value"], (1 - 2 * mirror) * 0.5, delta=1e-12)
                    self.assertAlmostEqual(one["cases"][0]["joint"]["largest_gap_m"]["value"], 0.5, delta=1e-12)

    def test_table(self):
        """Tilted one way on a table, one side alone is looked at: a caution, unless that is said to be meant."""
        slab = HEAD + "block: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 40\n"
        for seismic, towards, caution in (("", "left", True), (", direction: down_dip", "left", False), ("", "both", False)):
            self.path.write_text(slab + f"loads: {{seismic: {{horizontal: 0.1{seismic}}}}}\ntilt: {{towards: {towards}, angle_deg: 3}}\n")
            self.assertEqual("shakes both ways" in " ".join(run("solve", self.path)[1].split()), caution, (seismic, towards))


if __name__ == "__main__":
    main()
