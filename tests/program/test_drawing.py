# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Outlines and profiles from drawings (docs/drawing.md).

The story: an outline that is drawn must be the block that the same numbers give inline, whatever the format, to the
last byte of what is computed; arcs must stay arcs, with the areas of closed form; and what a drawing leaves open must
be asked for, never guessed."""

import json
import math
import pathlib
import tempfile
import unittest

from drawing_case import (arc, block, circle, dxf, entity, insert, light_polyline, line, polyline)
from harness import is_readable, main, run

RING = [("0", "0"), ("0.30", "0.05"), ("0.6", "0"), ("0.9", "0.05"), ("0.9", "1.25"), ("0", "1.2")]
HOLE = [("0.4", "0.5"), ("0.5", "0.5"), ("0.5", "0.6")]
BASE = [("-0.5", "0"), ("0", "0"), ("0.3", "0.05"), ("0.6", "0"), ("0.9", "0.05"), ("1.4", "0.05")]


def inline(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def blanks(points):
    return ", ".join(f"{x} {y}" for x, y in [*points])


def ring(points):
    return [*points, points[0]]


def geojson(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


def svg(body, head=""):
    return f'<?xml version="1.0"?>\n{head}<svg xmlns="http://www.w3.org/2000/svg">\n{body}\n</svg>\n'


def down(points):
    """As SVG writes them: y runs down."""
    return " ".join(f"{x},{y[1:] if y[0] == '-' else '-' + y}" for x, y in points)


class Drawing(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def write(self, name, text):
        if not is_readable(pathlib.Path(name)):
            self.skipTest(f"Topple was built without what reads {name}")
        data = text if isinstance(text, bytes) else text.encode()
        (self.folder / name).write_bytes(data)

    def solve(self, name, *options):
        status, out, err = run("solve", "--json", *options, name, folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)

    def area(self, text, *options, name="d.dxf"):
        """Area and centroid of a drawing's block, in metres."""
        self.write(name, text)
        solution = self.solve(name, "--digits", "14", *options)
        return [solution["cases"][0]["block"][key]["value"] for key in ("area_m2", "centroid_x_m", "centroid_y_m")]

    def refused(self, text, *words, name="d.dxf", options=()):
        self.write(name, text)
        status, out, err = run("solve", *options, name, folder=self.folder)
        self.assertEqual((status, out), (3, ""), err)
        self.assertEqual(err.count("\n"), 1, err)
        for word in words:
            self.assertIn(word, err)


class Formats(Drawing):
    """One outline in every format, and inline: the same numbers, byte for byte."""

    def setUp(self):
        super().setUp()
        self.rest = "block: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 5}\n"
        self.write("inline.yaml", f"topple: 1\nlength_unit: m\nbase: {{profile: {inline(BASE)}}}\n"
                   + self.rest.replace("{unit", f"{{outline: {inline(RING)}, holes: [{inline(HOLE)}], unit"))
        self.expected = self.numbers("inline.yaml")

    def numbers(self, name):
        return json.dumps([{key: value for key, value in case.items() if key not in ("effects", "notes")}
                           for case in self.solve(name)["cases"]])

    def same(self, name, text, keys=""):
        self.write(name, text)
        self.write("drawn.yaml", f"topple: 1\nlength_unit: m\ndrawing: {{file: {name}{keys}}}\n" + self.rest)
        self.assertEqual(self.numbers("drawn.yaml"), self.expected)

    def dxf(self, **more):
        return dxf(light_polyline("Block", RING) + polyline("HOLE", HOLE)
                   + light_polyline("BASE", BASE[::-1], closed=False), **{"unit": 6, **more})

    def test_dxf(self):
        self.same("d.dxf", self.dxf())

    def test_lines_that_are_joined(self):
        """In any order and sense, one of them twice."""
        sides = [line("BLOCK", *a, *b) for a, b in zip(ring(RING)[1:], ring(RING))]
        mixed = sides[::2] + sides[1::2] + [line("BLOCK", *RING[1], *RING[2])]
        self.same("d.dxf", dxf("".join(mixed) + polyline("HOLE", HOLE) + light_polyline("BASE", BASE, False), unit=6))

    def test_gaps_within_what_is_stated(self):
        sides = [line("BLOCK", *a, *b) for a, b in zip(RING, ring(RING)[1:])]
        sides[2] = line("BLOCK", "0.601", "0", "0.9", "0.05")  # the line before it comes first and gives the point
        drawing = dxf("".join(sides) + polyline("HOLE", HOLE) + light_polyline("BASE", BASE, False), unit=6)
        self.refused(drawing, "open", "0.001", "gap")
        self.same("d.dxf", drawing, ", gap: 0.001")

    def test_inserted_blocks(self):
        """Moved, turned by a quarter, scaled by ten, on the layer of the insert."""
        turned = [(f"{float(y) * 10:g}", f"{-float(x) * 10 + 7:g}") for x, y in RING]
        entities = (insert("BLOCK", "rock", "0.7", "0", (41, "0.1"), (42, "0.1"), (50, "90"))
                    + polyline("HOLE", HOLE) + light_polyline("BASE", BASE, False))
        self.same("d.dxf", dxf(entities, unit=6, blocks=block("Rock", light_polyline("0", turned), 0, 0)))

    def test_windows_lines_utf16_and_commas(self):
        self.same("d.dxf", self.dxf().replace("\n", "\r\n"))
        self.same("d.dxf", b"\xff\xfe" + self.dxf().encode("utf-16-le"))
        self.same("d.dxf", self.dxf().replace("0.", "0,").replace("1.2", "1,2"))

    def test_svg(self):
        outline = down(RING)
        self.same("d.svg", svg(f'<polygon id="block" points="{outline}"/><g id="HOLE"><path d="M{down(HOLE)}z"/></g>'
                               f'<polyline id="BASE" points="{down(BASE)}"/>'), ", unit: m")
        moved = [(f"{float(x) * 50 + 10:g}", f"{float(y) * 50 - 5:g}") for x, y in RING]
        self.same("d.svg", svg('<g transform="scale(.02)"><path id="BLOCK" transform="translate(-10,-5)"'
                               f' d="M{down(moved)}Z"/></g>'
                               + f'<path id="HOLE" d="M{down(HOLE)}z"/><path id="BASE" d="M{down(BASE)}"/>'),
                  ", unit: m")

    def test_a_bar_of_known_length(self):
        """A bar of 3-4-5 scales by a rational number, which keeps all exact."""
        self.same("d.svg", svg('<line id="bar" x1="1" y1="2" x2="4" y2="6"/><g id="BLOCK" transform="scale(5)">'
                               f'<polygon points="{down(RING)}"/></g><polygon id="HOLE" transform="scale(5)"'
                               f' points="{down(HOLE)}"/><polyline transform="scale(5)" id="BASE"'
                               f' points="{down(BASE)}"/>'), ", reference: {id: bar, length: 1}")

    def test_geojson_wkt_csv(self):
        self.same("d.geojson", '{"type": "FeatureCollection", "features": [{"geometry": {"coordinates": ['
                  f'{geojson(ring(RING))}, {geojson(ring(HOLE))}], "type": "Polygon"}}, "type": "Feature", '
                  '"properties": {"layer": "BLOCK", "n": [1, {"layer": "x"}]}}, {"type": "Feature", "properties": '
                  '{"layer": "BASE"}, "geometry": {"type": "LineString", "coordinates": ' + geojson(BASE) + "}}]}",
                  ", unit: m")
        self.same("d.wkt", f"SRID=2056;POLYGON (({blanks(ring(RING))}), ({blanks(ring(HOLE))}));\r\n"
                  f"LINESTRING ({blanks(BASE)})", ", unit: m")
        rows = [("BLOCK", RING), ("HOLE", HOLE), ("BASE", BASE)]
        self.same("d.csv", "layer;x (m);y (m)\n" + "".join(f"{layer};{x};{y}\n" for layer, points in rows
                                                            for x, y in points), ", unit: m")

    def test_units_are_exact(self):
        """A drawing in millimetres or inches is the block in metres."""
        large = [[(f"{float(x) * 1000:g}", f"{float(y) * 1000:g}") for x, y in points]
                 for points in (RING, HOLE, BASE)]
        self.same("d.dxf", dxf(light_polyline("BLOCK", large[0]) + polyline("HOLE", large[1])
                               + light_polyline("BASE", large[2], False)))
        self.same("d.dxf", self.dxf(), ", unit: m")
        self.write("d.dxf", self.dxf(unit=1))
        self.refused("topple: 1\ndrawing: {file: d.dxf, unit: m}\n", "s.yaml:2:", "in in, not m", "$INSUNITS", name="s.yaml")


class Curves(Drawing):
    """Areas of closed form: arcs are exact, other curves within their tolerance."""

    def test_an_arc_of_angles(self):
        area, x, y = self.area(dxf(line("BLOCK", 0, 0, 4, 0) + line("BLOCK", 4, 0, 4, 3) + arc("BLOCK", 2, 3, 2, 0, 180)
                                   + line("BLOCK", 0, 3, 0, 0), unit=6))
        top, height = math.pi * 2, 3 + 4 * 2 / (3 * math.pi)
        self.assertAlmostEqual(area, 12 + top, delta=1e-13)
        self.assertAlmostEqual(x, 2, delta=1e-13)
        self.assertAlmostEqual(y, (12 * 1.5 + top * height) / (12 + top), delta=1e-13)

    def test_an_arc_of_any_angle(self):
        """Its ends are computed, and the lines that it meets have them to ten digits."""
        ends = [(f"{10 * math.cos(math.radians(a)):.10f}", f"{10 * math.sin(math.radians(a)):.10f}") for a in (37, 101)]
        area, _, _ = self.area(dxf(arc("BLOCK", 0, 0, 10, 37, 101) + line("BLOCK", *ends[0], 0, 0)
                                   + line("BLOCK", 0, 0, *ends[1]), unit=6), "--set", "drawing.gap=0")
        self.assertAlmostEqual(area, 50 * math.radians(64), delta=1e-7)

    def test_bulges_and_mirrors(self):
        """A quarter of a disk cut out, and the same extruded the other way with x mirrored."""
        quarter = math.tan(math.pi / 8)
        points = [(0, 0), (6, 0), (6, 2, f"{quarter:.17f}"), (4, 4), (0, 4)]
        self.assertAlmostEqual(self.area(dxf(light_polyline("BLOCK", points), unit=6))[0], 24 - 2 + math.pi - 2, delta=1e-13)
        mirrored = [(-p[0], *p[1:]) for p in points]
        mirrored = [(*p[:2], *(f"-{b}" for b in p[2:])) for p in mirrored]
        self.assertAlmostEqual(self.area(dxf(light_polyline("BLOCK", mirrored, more=[(210, 0), (220, 0), (230, -1)]),
                                             unit=6))[0], 24 - 2 + math.pi - 2, delta=1e-13)

    def test_a_circle_of_two_bulges(self):
        text = dxf(light_polyline("BLOCK", [(-3, 5, 1), (3, 5, 1)]), unit=6)
        self.write("d.dxf", text)
        self.write("s.yaml", "topple: 1\ndrawing: {file: d.dxf}\nbase: {mated: true, between: {below: 3}}\n")
        status, _, err = run("solve", "s.yaml", folder=self.folder)
        self.assertEqual(status, 3)  # a disk stands on an arc: the geometry is read, and refused for that
        self.assertIn("arc", err)

    def test_a_round_hole(self):
        """Chords inside a circle of radius r leave it by t: n of them, of r (1 - cos(pi/n)) <= t."""
        text = dxf(light_polyline("BLOCK", [(0, 0), (8, 0), (8, 8), (0, 8)]) + circle("HOLE", 4, 4, 2), unit=6)
        area, x, y = self.area(text, "--set", "drawing.tolerance=0.001")
        lack = area - (64 - 4 * math.pi)
        self.assertTrue(0 < lack < 2 * math.pi * 2 * 0.001, lack)
        self.assertAlmostEqual(x, 4, delta=1e-4)
        finer = self.area(text, "--set", "drawing.tolerance=0.00001")[0] - (64 - 4 * math.pi)
        self.assertTrue(0 < finer < 2 * math.pi * 2 * 0.00001, finer)

    def test_ellipse_and_spline(self):
        """pi a b; a Bezier arch of height h and width w over its chord has 3/5 of w h (control points above its ends)."""
        text = dxf(entity("ELLIPSE", "BLOCK", (10, 0), (20, 5), (11, 6), (21, 0), (40, "0.5"), (41, 0),
                          (42, "6.283185307179586")), unit=6)
        lack = math.pi * 18 - self.area(text, "--set", "drawing.tolerance=0.0001")[0]
        self.assertTrue(0 < lack < 30 * 0.0001, lack)
        knots = [(40, k) for k in (0, 0, 0, 0, 1, 1, 1, 1)]
        control = [pair for x, y in ((10, 0), (10, 8), (0, 8), (0, 0)) for pair in ((10, x), (20, y))]
        text = dxf(line("BLOCK", 0, 0, 10, 0) + entity("SPLINE", "BLOCK", (70, 8), (71, 3), (72, 8), (73, 4), *knots,
                                                       *control), unit=6)
        self.assertAlmostEqual(self.area(text, "--set", "drawing.tolerance=0.0001")[0], 0.6 * 80, delta=30 * 0.0001)

    def test_knots_and_weights(self):
        """A half circle as a rational quadratic spline of two spans, whose area is that of the half disk."""
        half = f"{math.sqrt(0.5):.17f}"
        knots = [(40, k) for k in (0, 0, 0, 1, 1, 2, 2, 2)]
        control = [pair for x, y in ((5, 0), (5, 5), (0, 5), (-5, 5), (-5, 0)) for pair in ((10, x), (20, y))]
        weights = [(41, w) for w in (1, half, 1, half, 1)]
        text = dxf(line("BLOCK", -5, 0, 5, 0) + entity("SPLINE", "BLOCK", (70, 12), (71, 2), (72, 8), (73, 5), *knots,
                                                       *weights, *control), unit=6)
        self.assertAlmostEqual(self.area(text, "--set", "drawing.tolerance=0.0001")[0], 12.5 * math.pi, delta=20 * 0.0001)

    def test_svg_curves(self):
        arch = svg('<path id="BLOCK" d="M0 0H10C10-8 0-8 0 0z"/>')
        self.assertAlmostEqual(self.area(arch, "--unit", "m", name="d.svg")[0], 48, delta=0.03)
        round_top = svg('<path id="BLOCK" d="M0 0h4v-3a2 2 0 0 0-4 0z"/>')
        self.assertAlmostEqual(self.area(round_top, "--unit", "m", name="d.svg")[0], 12 + 2 * math.pi, delta=1e-13)
        squeezed = svg('<path id="BLOCK" transform="scale(1,2)" d="M0 0h4v-3a2 2 0 0 0-4 0z"/>')
        self.assertAlmostEqual(self.area(squeezed, "--unit", "m", name="d.svg")[0], 24 + 4 * math.pi, delta=0.01)
        oval = svg('<path id="BLOCK" d="M0 0h4v-3a2 4 0 1 0-4 0z"/>')
        self.assertAlmostEqual(self.area(oval, "--unit", "m", name="d.svg")[0], 12 + 4 * math.pi, delta=0.01)
        quadratic = svg('<path id="BLOCK" d="M0 0L10 0Q5-6 0 0z"/>')  # two thirds of the triangle
        self.assertAlmostEqual(self.area(quadratic, "--unit", "m", name="d.svg")[0], 20, delta=0.02)
        rounded = svg('<rect id="BLOCK" x="1" y="-5" width="6" height="5" rx="1"/>')
        self.write("d.svg", rounded)
        self.write("s.yaml", "topple: 1\ndrawing: {file: d.svg, unit: m}\nbase: {mated: true, between: [[2, 0], [6, 0]]}\n")
        area = self.solve("s.yaml", "--digits", "14")["cases"][0]["block"]["area_m2"]["value"]
        self.assertAlmostEqual(area, 30 - (4 - math.pi), delta=1e-13)


class Refused(Drawing):
    """What a drawing leaves open is said, with the place and the mend."""

    def test_dxf(self):
        good = dxf(light_polyline("BLOCK", RING), unit=6)
        self.refused(dxf(light_polyline("BLOCK", RING), unit=None), "unit", "--unit mm")
        self.refused(dxf(light_polyline("BLOCK", RING), unit=3), "unit")
        self.refused(dxf(light_polyline("BLOCK", RING), version="AC1006"), "d.dxf:8:1", "R12")
        self.refused("AutoCAD Binary DXF\r\n\x1a\x00" + good, "binary", "ASCII")
        self.refused("AC1027" + good, "DWG")
        self.refused(good[:-12], "EOF")
        self.refused(good.replace("LWPOLYLINE\n", "LWPOLYLINE\nx\n"), "d.dxf:", "code of a group")
        self.refused(dxf(light_polyline("BLOCK", RING, closed=False), unit=6), "open", "1.2", "gap")
        self.refused(dxf(light_polyline("BLOCK", RING) * 2, unit=6), "second outline")
        self.refused(dxf("", unit=6), "no lines")
        self.refused(dxf(light_polyline("ROCK", RING) * 2, unit=6), "'ROCK' (2 closed, 0 open)", "block: LAYER")
        self.refused(dxf(light_polyline("BLOCK", RING) + light_polyline("BASE", RING), unit=6), "base", "open line")
        self.refused(dxf(light_polyline("BLOCK", RING, more=[(210, 1), (220, 0), (230, 0)]), unit=6), "plane")
        self.refused(dxf(light_polyline("BLOCK", RING) + circle("PART", 1, 1, 1), unit=6), "PART", "unit_weight_kn_m3")
        self.refused(dxf(light_polyline("BLOCK", [], closed=False), unit=6), "fewer than two points")
        star = "".join(line("BLOCK", 0, 0, x, y) for x, y in ((1, 0), (0, 1), (1, 1)))
        self.refused(dxf(star, unit=6), "more than two ends")
        self.refused(dxf(light_polyline("BLOCK", [("0", "0"), ("1", "0"), ("1", "nan")]), unit=6), "number")

    def test_blocks_without_end(self):
        """A block that inserts itself twice would be for ever."""
        self.refused(dxf(insert("0", "A", 0, 0), unit=6, blocks=block("A", insert("0", "A", 0, 0) * 2)), "16 deep")

    def test_svg(self):
        body = f'<polygon id="BLOCK" points="{down(RING)}"/>'
        self.write("secret.txt", "1")
        for head in ('<!DOCTYPE svg [<!ENTITY x SYSTEM "secret.txt">]>',
                     '<!DOCTYPE svg [<!ENTITY a "0"><!ENTITY b "&a;&a;">]>'):
            self.refused(svg(body, head), "document type", name="d.svg", options=("--unit", "m"))
        public = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "secret.txt">'
        self.refused(svg('<path id="BLOCK" d="M0 0 &x; 1 1z"/>', public), "entities", name="d.svg",
                     options=("--unit", "m"))
        self.area(svg(body, public), "--unit", "m", name="d.svg")  # of the public type alone nothing is fetched
        self.refused(svg(body), "--unit mm", name="d.svg")
        self.refused(svg(body)[:-8], "XML", name="d.svg", options=("--unit", "m"))
        self.refused(svg('<path id="BLOCK" d="M0 0 L1 x"/>'), "path", name="d.svg", options=("--unit", "m"))
        self.refused(svg('<rect id="BLOCK" width="3cm" height="4"/>'), "unit", name="d.svg", options=("--unit", "m"))
        self.refused("<html/>", "not an SVG", name="d.svg", options=("--unit", "m"))

    def test_geojson_wkt_csv(self):
        unit = ("--unit", "m")
        self.refused('{"type": "Polygon", "coordinates": [[[0, 0, 1], [1, 0, 2], [1, 1, 3]]]}', "z", name="d.geojson",
                     options=unit)
        self.refused('{"type": "Polygon", "coordinates": [[[0, 0], [1, ', "d.geojson:1:", name="d.geojson",
                     options=unit)
        self.refused("CURVEPOLYGON (CIRCULARSTRING (0 0, 1 1, 2 0, 1 -1, 0 0))", "curves", "DXF", name="d.wkt",
                     options=unit)
        self.refused("POLYGON ((0 0, 1,5 0, 1 1, 0 0))", "d.wkt:1:", "point", name="d.wkt", options=unit)
        self.refused("POLYGON Z ((0 0 1, 1 0 2, 1 1 1, 0 0 1))", "z", name="d.wkt", options=unit)
        self.refused("layer;x;y\nBLOCK;0,5;1\n", "d.csv:2:", "comma", name="d.csv", options=unit)
        self.refused("1,2\n3,4\n", "columns x and y", name="d.csv", options=unit)

    def test_beside_a_scene(self):
        self.write("d.dxf", dxf(light_polyline("BLOCK", RING) + light_polyline("BASE", BASE, False), unit=6))
        for keys, word in (("block: {slab: {width: 1, height: 2}}", "outline"), ("base: {mated: true}", "mated"),
                           ("length_unit: parsec", "length_unit")):
            self.refused(f"topple: 1\ndrawing: {{file: d.dxf}}\n{keys}\n", word, name="s.yaml")
        self.refused("topple: 1\ndrawing: {file: d.dxf, layer: x}\n", "layer", name="s.yaml")
        self.refused("topple: 1\ndrawing: {file: d.dxf, hole: CAVE}\n", "CAVE", name="s.yaml")
        self.refused("topple: 1\ndrawing: {file: d.txt}\n", ".dxf", name="s.yaml")


class Told(Drawing):
    def test_a_drawing_as_a_scene(self):
        """With numbers that the scene has not, as if they stood there."""
        self.write("d.dxf", dxf(light_polyline("BLOCK", RING), unit=6))
        set_numbers = ("friction_angle_deg=30", "block.unit_weight_kn_m3=2*13", "tilt.angle_deg=5")
        own = self.solve("d.dxf", *(word for s in set_numbers for word in ("--set", s)))
        self.write("s.yaml", "topple: 1\ndrawing: {file: d.dxf}\nfriction_angle_deg: 30\ntilt: {angle_deg: 5}\n"
                   "block: {unit_weight_kn_m3: 26}\n")
        scene = self.solve("s.yaml")
        for case, other in zip(own["cases"], scene["cases"]):
            for key in ("block", "pivots", "toppling", "limit", "onset", "mechanism"):
                self.assertEqual(case[key], other[key], key)

    def test_which_object_became_what(self):
        self.write("d.dxf", dxf(light_polyline("BLOCK", RING) + circle("HOLE", "0.4", "0.6", "0.1")
                                + line("\x1b[31mframe", 0, 0, 9, 9), unit=6))
        status, out, err = run("solve", "--verbose", "d.dxf", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        told = {parts[1]: parts[-1] for parts in (row.split() for row in out.splitlines()) if parts[:1] and
                parts[0].isdigit() and len(parts) > 4 and parts[-2] in ("closed", "open")}
        self.assertEqual(told, {"LWPOLYLINE": "block", "CIRCLE": "hole"})
        self.assertIn("not used", out)
        self.assertNotIn("\x1b", out)

    def test_lengths_keep_their_digits(self):
        """Three hundred digits are three hundred, far from the origin."""
        far = "4" * 280
        self.write("d.dxf", dxf(light_polyline("BLOCK", [(far, "0"), (far[:-1] + "5", "0"), (far[:-1] + "5", "2"),
                                                         (far, "2")]), unit=6))
        self.assertEqual(self.solve("d.dxf")["cases"][0]["block"]["area_m2"]["value"], 2)


if __name__ == "__main__":
    main()
