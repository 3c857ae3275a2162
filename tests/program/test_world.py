# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Coordinates as a section lies on a slope: `frame: world`.

A section digitised as it lies was read as lying on a level base, and its factor of safety came out unbounded."""

import decimal
import math
import pathlib
import random
import re
import tempfile
import unittest
from fractions import Fraction

from harness import main, rounds, run, solve

SEED = 11
TURNS = [(Fraction(4, 5), Fraction(3, 5)), (Fraction(12, 13), Fraction(5, 13)), (Fraction(15, 17), Fraction(-8, 17)),
         (Fraction(40, 41), Fraction(9, 41)), (Fraction(24, 25), Fraction(-7, 25))]


def text(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


class World(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "scene.yaml"

    def write(self, block, base="", frame="", tilt="", more=""):
        lines = ["topple: 1", "length_unit: m", f"frame: {frame}" if frame else "", f"block: {{{block}}}",
                 f"base: {{{base}}}" if base else "", "friction_angle_deg: 32", f"tilt: {{{tilt}}}" if tilt else "", more]
        self.path.write_text("\n".join(line for line in lines if line) + "\n", encoding="utf-8")

    def cases(self, *arguments, **options):
        self.write(*arguments, **options)
        return solve(self.path)["cases"]

    def refused(self, *arguments, **options):
        self.write(*arguments, **options)
        status, out, err = run("solve", self.path)
        self.assertEqual((status, out), (3, ""))
        return err

    def degrees(self, sine, cosine):
        """To more digits than a double: a tilt that a scene can give."""
        with decimal.localcontext() as context:
            context.prec = 60
            tangent = decimal.Decimal(abs(sine).numerator * cosine.denominator) / (abs(sine).denominator * cosine.numerator)
            x, halvings = tangent, 0
            while x > decimal.Decimal("0.01"):
                x, halvings = x / (1 + (1 + x * x).sqrt()), halvings + 1
            total = sum((-1) ** k * x ** (2 * k + 1) / (2 * k + 1) for k in range(16))
            pi = 16 * self.arctan(5) - 4 * self.arctan(239)
            return +(total * 2 ** halvings * 180 / pi)

    def arctan(self, n):
        return sum(decimal.Decimal((-1) ** k) / ((2 * k + 1) * decimal.Decimal(n) ** (2 * k + 1)) for k in range(50))

    def same(self, one, other, where=""):
        """Two trees of results: numbers alike to their bounds and 1e-11, words alike."""
        if isinstance(one, dict) and set(one) >= {"value", "error"}:
            self.assertAlmostEqual(one["value"], other["value"], delta=1e-11 * max(1, abs(one["value"])), msg=where)
        elif isinstance(one, dict):
            of_place = {"steepen_by_deg", "steepen_to_deg", "steepen_is"}  # only of a block that lies as it lies
            self.assertEqual(set(one) - of_place, set(other) - of_place, where)
            for key in set(one) - of_place:
                if key not in ("seconds", "effects", "frame", "called_for_by", "level", "bits"):
                    self.same(one[key], other[key], f"{where}.{key}")
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), where)
            for k, pair in enumerate(zip(one, other)):
                self.same(*pair, f"{where}.{k}")
        else:
            self.assertEqual(one, other, where)

    def test_turned_scenes(self):
        """A scene along its mean plane at a tilt, and the same one turned by that tilt, exactly, as it then lies:
        one report. With holes, parts, rounded corners, arcs, profiles, and every load that has a direction."""
        r = random.Random(SEED)
        for number in range(rounds(14, 40)):
            c, s = r.choice(TURNS)
            x0, y0 = Fraction(r.randint(-9, 9)), Fraction(r.randint(-9, 9))
            place = lambda p: (x0 + c * p[0] - s * p[1], y0 + s * p[0] + c * p[1])
            same = lambda p: (x0 + p[0], y0 + p[1])
            w, h, d = Fraction(r.randint(8, 14)), Fraction(r.randint(4, 18)), Fraction(r.randint(1, 5), 5)
            under = [(Fraction(0), Fraction(0)), (w / 4, d), (w / 2, Fraction(0)), (3 * w / 4, d), (w, Fraction(0))]
            outline = under + [(w, h), (Fraction(0), h)]
            kind, towards = number % 5, "left" if s > 0 else "right"
            dip, more_tilt = self.degrees(s, c), r.choice((0, 0, 3))
            told = []
            for put, frame in ((same, "base"), (place, "world"), (place, "{mean_plane: %s}" % text([place(under[0]), place(under[4])]))):
                block = f"outline: {text(map(put, outline))}, unit_weight_kn_m3: 26"
                base, loads = f"between: {text(map(put, (under[0], under[4])))}, beyond: {{left: 0, right: 2}}", ""
                hole = [(w / 3, h / 2), (w / 2, h / 2), (w / 2, 3 * h / 4)]
                if kind == 1:
                    block += f", holes: [{text(map(put, hole))}]"
                    base = f"profile: {text(map(put, under))}"
                elif kind == 2:
                    block += f", parts: [{{outline: {text(map(put, hole))}, unit_weight_kn_m3: 20}}]"
                    angle = decimal.Decimal(200) + (dip if s > 0 else -dip) * (put is place)
                    loads = (f"loads: {{seismic: {{horizontal: 0.1, vertical: 0.05, direction: down_dip}}, water: {{height: 1, uplift: true}}, "
                             f"anchors: [{{at: [{put(hole[0])[0]}, {put(hole[0])[1]}], direction_deg: {angle}, force_kn: 30}}], "
                             f"cohesion_kpa: 3}}")
                elif kind == 3:
                    corner, other = put(outline[5]), put(under[4])
                    block += (f", rounded: {{corners: [{{at: [{corner[0]}, {corner[1]}], radius: 1}}, "
                              f"{{at: [{other[0]}, {other[1]}], radius: 1/10}}]}}")
                    from_, to = put((w, h / 2)), put((w, h))
                    loads = (f"loads: {{surcharges: [{{from: [{to[0]}, {to[1]}], to: [{from_[0]}, {from_[1]}], kpa: 5}}], "
                             f"pressures: [{{from: [{from_[0]}, {from_[1]}], to: [{to[0]}, {to[1]}], kpa: [4, 1]}}]}}")
                elif kind == 4:
                    start = put(outline[5])
                    block += f", arcs: [{{from: [{start[0]}, {start[1]}], bulge: 1/5}}]"
                tilt = (f"towards: {towards}, angle_deg: {dip + more_tilt}" if frame == "base" else
                        f"towards: {towards}, angle_deg: {more_tilt}")
                case = self.cases(block, base, frame, tilt, loads)[0]
                if frame != "base":
                    self.assertAlmostEqual(case["frame"]["dip_deg"]["value"], float(dip), delta=1e-12)
                    self.assertEqual(case["frame"]["dips_towards"], towards)
                told.append(case)
            with self.subTest(seed=SEED, scene=number, kind=kind):
                self.turn_places(told[0], lambda x, y: (x0 + c * (x - x0) - s * (y - y0), y0 + s * (x - x0) + c * (y - y0)))
                for case in told[1:]:
                    self.same(told[0], case)

    def turn_places(self, tree, turn):
        """Every point of the results: they have the coordinates of their scene."""
        for value in tree.values() if isinstance(tree, dict) else tree if isinstance(tree, list) else ():
            self.turn_places(value, turn)
        for x_key in [key for key in tree if key in ("x_m", "centroid_x_m", "centre_x_m", "driving_centre_x_m")] if isinstance(tree, dict) else ():
            y_key = x_key.replace("x_m", "y_m")
            if tree[x_key] is not None:
                x, y = turn(*(Fraction(tree[key]["value"]) for key in (x_key, y_key)))
                tree[x_key]["value"], tree[y_key]["value"] = float(x), float(y)

    #: A joint that dips, and the block on it, in the coordinates of a mine.
    JOINT = ["512345.2 6789012.7", "512346.1 6789012.9", "512347.3 6789013.9", "512348.4 6789014.1"]
    MINE = [*JOINT, "512347.0 6789018.35", "512344.1 6789016.6"]
    SHAKES = {"down_dip": 0.1, "up_dip": 1.5}  # up-dip more than what makes it no less safe at rest

    def in_mine(self, sign=1, east=0, north=0, along=None, **more):
        put = lambda p: (sign * (decimal.Decimal(p.split()[0]) + east), decimal.Decimal(p.split()[1]) + north)
        outline, joint = [put(p) for p in self.MINE][::sign], [put(p) for p in self.JOINT][::sign]
        self.write(f"outline: {text(outline)}, unit_weight_kn_m3: 26", f"between: {text((joint[0], joint[-1]))}",
                   "world", more=along or "loads: {seismic: {horizontal: %s, direction: %s}}" % (self.SHAKES[more["direction"]], more["direction"]))
        return outline, joint, solve(self.path)["cases"][0]

    def points_of(self, case):
        """All points that a case tells of, but those that a mirror may exchange: ends of facets that it slides on which bear a reaction, and
        the end of the contact that it is turned about."""
        found = []
        case["limit"]["reactions"], case["frame"]["turned_about"] = [], None
        self.turn_places(case, lambda x, y: found.append((float(x), float(y))) or (x, y))
        return found

    def test_coordinates_of_a_mine(self):
        """The points told are those of the drawing, to their last digit: the ends of the contact and all pivots are vertices of the
        joint, as doubles of the decimals given, of a block that is shaken either way, which is solved along its plane or level; the
        page and the sheet print them as they were given. A mirror and a shift of the scene mirror and shift every point."""
        for direction in ("down_dip", "up_dip"):
            outline, joint, case = self.in_mine(direction=direction)
            ends = [(case["contact"][end]["x_m"]["value"], case["contact"][end]["y_m"]["value"]) for end in ("left_end", "right_end")]
            self.assertEqual(ends, [(float(x), float(y)) for x, y in (joint[0], joint[-1])])
            self.assertEqual([(p["x_m"]["value"], p["y_m"]["value"]) for p in case["pivots"]], [(float(x), float(y)) for x, y in joint])
            gx, gy = self.polygon_centroid([(Fraction(x), Fraction(y)) for x, y in outline])
            for told, true in ((case["block"]["centroid_x_m"], gx), (case["block"]["centroid_y_m"], gy)):
                self.assertLessEqual(abs(Fraction(told["value"]) - true), Fraction(told["error"]))
            self.assertEqual((case["frame"]["turned_deg"]["value"] == 0), direction == "up_dip")
            _, page, _ = run("solve", "--report", self.path.with_suffix(".md"), self.path)
            sheet = self.path.with_suffix(".md").read_text(encoding="utf-8")
            for told in (page, re.sub(r"\\", "", sheet)):
                self.assertIn("from (512345.2, 6789012.7)", told)
                self.assertIn("to (512348.4, 6789014.1)", told)
            self.assertRegex(page, r"\n.  2 \w+ +512346.1  6789012.9 ")
            points = self.points_of(case)
            self.assertGreater(len(points), 8)
            for sign, east, north in ((-1, 0, 0), (1, -512340, decimal.Decimal("-6789010.5"))):
                _, _, other = self.in_mine(sign, east, north, direction=direction)
                back = [(sign * x - float(east), y - float(north)) for x, y in self.points_of(other)]
                self.assertEqual(*(sorted((round(x, 6), round(y, 6)) for x, y in told) for told in (points, back)))

    def test_shifted_in_a_mine(self):
        """A block that has moved along its joint touches it at points of the joint as it was drawn."""
        for shaken in ("", "\nloads: {seismic: {horizontal: 0.3, direction: up_dip}}"):
            _, joint, case = self.in_mine(along="joint: {shift: 0.2}" + shaken)
            for pivot in case["pivots"]:
                x, y = (Fraction(pivot[key]["value"]) for key in ("x_m", "y_m"))
                gaps = []
                for (x0, y0), (x1, y1) in zip(joint, joint[1:]):
                    u, v = Fraction(x1 - x0), Fraction(y1 - y0)
                    share = min(1, max(0, ((x - Fraction(x0)) * u + (y - Fraction(y0)) * v) / (u * u + v * v)))
                    gaps.append(math.hypot(x - Fraction(x0) - share * u, y - Fraction(y0) - share * v))
                self.assertLess(min(gaps), 1e-8)

    def polygon_centroid(self, points):
        pairs = list(zip(points, points[1:] + points[:1]))
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2
        return tuple(sum((a[i] + b[i]) * (a[0] * b[1] - b[0] * a[1]) for a, b in pairs) / (6 * area) for i in (0, 1))

    def mean_slope(self, contact):
        """Least squares across the line between the ends, by its formula, in fractions."""
        (x0, y0), (x1, y1) = contact[0], contact[-1]
        ex, ey = x1 - x0, y1 - y0
        turned = [(ex * (x - x0) + ey * (y - y0), ex * (y - y0) - ey * (x - x0)) for x, y in contact]
        total = first = second = square = mixed = Fraction(0)
        for (a0, b0), (a1, b1) in zip(turned, turned[1:]):
            step, middle = abs(a1 - a0), ((a0 + a1) / 2, (b0 + b1) / 2)
            total += step
            first += step * middle[0]
            second += step * middle[1]
            square += step * (a0 * a0 + 4 * middle[0] ** 2 + a1 * a1) / 6  # Simpson's rule is exact here
            mixed += step * (a0 * b0 + 4 * middle[0] * middle[1] + a1 * b1) / 6
        slope = (mixed - first * second / total) / (square - first * first / total)
        return ex - slope * ey, ey + slope * ex

    def test_gravity_in_page(self):
        """On rough slopes of any dip, from coordinates as they lie: the dip by least squares in fractions; the
        critical angle less the dip is the angle by which the page has to be turned until the centroid stands over
        the toe; the factor of safety is the ratio of the tangents. In mirror images too."""
        r = random.Random(SEED + 1)
        for number in range(rounds(14, 40)):
            dip = math.radians(r.uniform(-35, 35))
            count = r.randint(2, 8)
            rough = [(2.0 * k, r.uniform(-0.2, 0.2)) for k in range(count + 1)]
            body = rough + [(2.0 * count, r.uniform(4, 12)), (0.0, r.uniform(4, 12))]
            digits = lambda x: Fraction(round(x * 10**6), 10**6)
            page = [(digits(x * math.cos(dip) - y * math.sin(dip)), digits(x * math.sin(dip) + y * math.cos(dip)))
                    for x, y in body]
            contact = page[:count + 1]
            u, v = self.mean_slope(contact)
            for turn in (1, -1):
                outline = [(turn * x, y) for x, y in page]
                ends = [contact[0], contact[-1]] if turn == 1 else [(-x, y) for x, y in (contact[-1], contact[0])]
                case = self.cases(f"outline: {text(outline)}", f"between: {text(ends)}", "world")[0]
                angle = math.degrees(math.atan2(abs(v), u))
                with self.subTest(seed=SEED, scene=number, turn=turn, outline=text(outline)):
                    self.assertAlmostEqual(case["frame"]["dip_deg"]["value"], angle, delta=1e-9)
                    left = (v > 0) == (turn == 1)
                    self.assertEqual(case["towards"], "left" if left else "right")
                    gx, gy = self.polygon_centroid(outline)
                    for pivot, (x, y) in zip(case["pivots"], [(turn * x, y) for x, y in contact][::turn]):
                        lean = math.degrees(math.atan2((gx - x) * (1 if left else -1), gy - y))
                        critical = pivot["critical_angle_deg"]["value"]
                        self.assertAlmostEqual((critical - angle - lean + 180) % 360, 180, delta=1e-9)
                        if pivot["fos"] is not None and critical < 90:
                            self.assertAlmostEqual(pivot["fos"]["value"], math.tan(math.radians(critical)) /
                                                   math.tan(math.radians(angle)), delta=1e-7 * max(1, pivot["fos"]["value"]))

    def test_default_contact(self):
        """Without 'between' the sole is found on the slope as along it, and the mean plane with it."""
        for c, s in TURNS:
            outline = [(0, 0), (2, 0), (3, 7), (1, 7)]
            page = [(c * x - s * y, s * x + c * y) for x, y in outline]
            case = self.cases(f"outline: {text(page)}", frame="world")[0]
            self.assertAlmostEqual(case["frame"]["dip_deg"]["value"], math.degrees(math.atan2(abs(s), c)), delta=1e-12)
            self.assertEqual(case["contact"]["facets"], 1)
            self.assertAlmostEqual(case["contact"]["length_m"]["value"], 2, delta=1e-12)

    def test_bounds_in_page(self):
        """Bounds of 'between' are those of the coordinates given, not of the mean plane."""
        outline = [(0, 0), (4, 2), (6, 3), (5, 9), (-3, 6)]
        case = self.cases(f"outline: {text(outline)}", "between: {left_of: 5}", "world")[0]
        self.assertAlmostEqual(case["contact"]["length_m"]["value"], math.hypot(4, 2), delta=1e-12)

    def test_caution(self):
        """A contact inclined to x by more than 1 in 10, and nothing said of the frame: a caution, both ways."""
        for outline, inclined in (([(0, 0), (4, 2), (2, 7), (-2, 5)], True), ([(4, 0), (0, 2), (2, 7), (5, 5)], True),
                                  ([(0, 0), (40, 4), (40, 50), (0, 50)], False), ([(0, 0), (40, 5), (40, 50), (0, 50)], True)):
            self.write(f"outline: {text(outline)}")
            self.assertEqual("say 'frame: world'" in run("solve", self.path)[1], inclined)
            self.assertEqual(solve(self.path)["cases"][0]["frame"]["inclined"], inclined)
            for frame in ("base", "world"):
                self.write(f"outline: {text(outline)}", frame=frame)
                self.assertNotIn("say 'frame: world'", run("solve", self.path)[1])

    #: Blocks in their place, each of which has another part of the reports written.
    IN_PLACE = {
        "stands": ("outline: [[0, 0], [2, 0.8], [1.2, 4], [-0.8, 3.2]]", "between: [[0, 0], [2, 0.8]], beyond: {left: 3, right: 3}",
                   "tilt: {angle_deg: 2}"),
        "topples": ("outline: [[0, 0], [1, 0.7], [-2.5, 5.7], [-3.5, 5]]", "between: [[0, 0], [1, 0.7]]", ""),
        "slides": ("outline: [[0, 0], [2, 1.6], [1.2, 2.6], [-0.8, 1]]", "between: [[0, 0], [2, 1.6]]", ""),
        "locked": ("outline: [[0, 0], [1, -0.9], [2, 1.7], [3, 0.9], [3, 9], [-1, 9]]", "between: [[0, 0], [3, 0.9]]", ""),
        "wet": ("outline: [[0, 0], [2, 0.8], [1.4, 4], [-0.8, 3.2]]", "between: [[0, 0], [2, 0.8]]",
                "loads: {water: {height: 1, uplift: true, stays_level: true}, seismic: {horizontal: 0.1, vertical: 0.05}, "
                "anchors: [{at: [1, 2], direction_deg: 80, force_kn: 3}], cohesion_kpa: 4}"),
        "moments": ("outline: [[0, 0], [2, 0.8], [1.2, 4], [-0.8, 3.2]]", "between: [[0, 0], [2, 0.8]]", "# no friction: moments alone"),
        "crushed": ("outline: [[0, 0], [2, 0.8], [1.2, 4], [-0.8, 3.2]]", "between: [[0, 0], [2, 0.8]]",
                    "friction: {law: barton, residual_angle_deg: 24, jrc: 8, jcs_mpa: 0.01}"),
        "shifted": ("outline: [[0, 0], [0.9, 0.7], [1.8, 0.7], [2.7, 1.4], [1.2, 4], [-0.8, 3.2]]", "between: [[0, 0], [2.7, 1.4]], beyond: {left: 1, right: 1}",
                    "joint: {shift: 0.1}\nloads: {seismic: {horizontal: 0.1}}"),
        "poses": ("outline: [[0, 0.2], [1.5, 0.2], [1.5, 3], [0, 3]]", "profile: [[-6, -2.1], [-2, 0.1], [-1, 0], [0, 0.2], [1, 0], [3, 0.6], [7, 3]], place: all", ""),
    }
    #: Of a block on a table, or of one whose scene says how it is tilted.
    OF_TABLE = r"[Tt]ilted|[Tt]he table(?! of)\b|tilting table|[Ll]evel ground|scene's tilt|scene tilts|tilt test|no tilt;|[Tt]ilt angle|Tilt \(°\)|at a tilt of"

    def told_of(self, name):
        """All that is said of a scene, by the command that says it."""
        block, base, more = self.IN_PLACE[name]
        friction = "" if "friction:" in more else "friction_angle_deg: 32\n"
        self.path.write_text(f"topple: 1\nlength_unit: m\nframe: world\nblock: {{{block}, unit_weight_kn_m3: 26}}\nbase: {{{base}}}\n"
                             f"{friction}{more}\n", encoding="utf-8")
        study = self.path.with_name("study.yaml")
        varied = "block.unit_weight_kn_m3" if "friction:" in more else "friction_angle_deg"
        mean = 26 if "friction:" in more else 32
        study.write_text(f"topple_study: 1\nscene: {self.path.name}\nsamples: 20\nsampling: {{seed: 1}}\n"
                         f"vary: {{{varied}: {{normal: {{mean: {mean}, deviation: 2}}}}}}\ntilts: {{from: 10, to: 40, step: 10}}\n")
        elements = () if more[:4] not in ("", "tilt") or "place: all" in base else ("--elements",)
        told = {}
        for command in (("solve", *elements, "--fail-below", "90", self.path), ("solve", "--table", self.path), ("solve", "--csv", self.path),
                        ("solve", "--figure", self.path.with_suffix(".svg"), self.path), *((("accuracy", self.path),) if rounds(name in ("stands", "wet"), True) else ()),
                        ("solve", "--report", self.path.with_suffix(".md"), self.path), ("study", study),
                        ("study", "--report", study.with_suffix(".md"), *(("--figure", study.with_suffix(".svg")) if name == "stands" else ()), study)):
            status, out, err = run(*command)
            told[" ".join(map(str, command))] = (status, out + err)
        for axes in ((f"--x={varied}=20:40",), (f"--x={varied}=20:40", "--y=tilt.angle_deg=0:20", "--contours=critical_angle=27")):
            if name == "stands":
                picture = self.path.with_name(f"map_{len(axes)}.svg")
                told[f"chart map {len(axes)}"] = run("chart", "map", self.path, *axes, "-o", picture)[::2]
        told |= {path.name: (0, path.read_text(encoding="utf-8")) for path in self.path.parent.iterdir() if path.suffix in (".md", ".svg")}
        return told

    def test_no_table(self):
        """A block in its place: no report, page, sheet, study, map or complaint of it speaks of a table, or of a tilt that its
        scene had not; it tells the block as it lies, and by how much it may steepen."""
        said = ""
        for name in self.IN_PLACE:
            with self.subTest(name):
                told = self.told_of(name)
                self.assertIn("s it lies", told[f"solve --table {self.path}"][1] + told[f"scene.md"][1])
                for where, (status, text) in told.items():
                    self.assertNotRegex(" ".join(text.split()), self.OF_TABLE, where)
                    self.assertNotIn(status, (2, 5), where + text)
                    self.assertTrue(status == 0 or "map" not in where, text)
                said += " ".join(" ".join(text.split()) for _, text in told.values())
        for words in ("It may steepen by", "to a dip of", "Dip that it is steepened to (°)", "Steepened by (°)",
                      "as it lies, towards the left, the water"):
            self.assertIn(words, said)

    def test_figure(self):
        """A scene as it lies can be drawn, charted and searched as any other."""
        self.write("outline: [[0, 0], [4, 2], [2, 7], [-2, 5]], unit_weight_kn_m3: 26", "between: [[0, 0], [4, 2]]", "world",
                   more="loads: {seismic: {horizontal: 0.1}}")
        picture = self.path.with_suffix(".svg")
        status, _, err = run("solve", "--figure", picture, self.path)
        self.assertEqual((status, err), (0, ""))
        self.assertTrue(picture.read_text(encoding="utf-8").endswith("</svg>\n"))
        status, out, err = run("solve", "--find", "loads.seismic.horizontal", "--for", "fos=1", self.path)
        self.assertEqual((status, err), (0, ""))
        # about (0, 0) in the page: W (G_x - k G_y) = 0, with G = (1, 3.5)
        self.assertIn("0.285714", out)

    def test_refused(self):
        sloping = f"outline: {text([(0, 0), (4, 2), (2, 7), (-2, 5)])}"
        for expected, options in (("dips to the left as the coordinates lie", {"tilt": "towards: right"}),
                                  ("make more than 90°", {"tilt": "angle_deg: 80"}),
                                  ("must lie right", {"frame": "{mean_plane: [[1, 0], [0, 0]]}"}),
                                  ("named by two points", {"frame": "{mean_plane: [[1, 0]]}"}),
                                  ("frame must be 'base'", {"frame": "page"})):
            self.assertIn(expected, self.refused(sloping, **({"frame": "world"} | options)))
        self.assertIn("'frame: world' is for an outline", self.refused("slab: {width: 1, height: 2}", frame="world"))
        self.assertIn("crosses", self.refused(f"outline: {text([(0, 0), (4, 2), (-2, 5), (2, 7)])}", frame="world"))
        self.write(sloping, frame="world")
        self.assertIn("60 digits at most", run("solve", "--digits", "61", self.path)[2])
        self.assertEqual(run("solve", "--digits", "60", self.path)[0], 0)
        self.assertIn("leave out 'frame'", run("derive", self.path)[2])


if __name__ == "__main__":
    main()
