# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a drawing shows is what is read of it, or it is refused.

The story: transforms in CSS, an origin of a transform, a drawing within a drawing and a skew by 90° went by without a word,
so that the block was another than the one on the screen; shapes that nobody sees were blocks; texts and nulls were
coordinates of 0; millimetres were metres, because --unit said so."""

import json
import math
import pathlib
import tempfile
import unittest

from drawing_case import block, circle, dxf, insert, layer, light_polyline, line, polyline
from harness import is_readable, main, run

SQUARE = '<rect id="BLOCK" width="1" height="2"/>'
RING = [(0, 0), (1, 0), (1, 2), (0, 2)]


class Read(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def solve(self, text, name, *options):
        if not is_readable(pathlib.Path(name)):
            self.skipTest(f"Topple was built without what reads {name}")
        (self.folder / name).write_text(text)
        return run("solve", "--json", *(options or ("--unit", "m")), name, folder=self.folder)

    def taken(self, text, name, *options):
        """The area of the block, and the notes."""
        status, out, err = self.solve(text, name, *options)
        self.assertEqual((status, err), (0, ""), text)
        solution = json.loads(out)
        return (solution["cases"][0]["block"]["area_m2"]["value"],
                [(note["kind"], note["place"], note["text"]) for note in solution["notes"]])

    def refused(self, text, name, place, words, *options):
        status, out, err = self.solve(text, name, *options)
        self.assertEqual((status, out), (3, ""), f"{text}: {err}")
        self.assertIn(f"{name}{place}:", err)
        self.assertIn(words, err, text)


class Dxf(Read):
    OUTLINE = light_polyline("BLOCK", RING)

    def notes_of(self, text, area=2, within=1e-12):
        found, notes = self.taken(text, "d.dxf", "--unit", "m")
        self.assertAlmostEqual(found, area, delta=within)
        return [(kind, told) for kind, _, told in notes]

    def test_layers(self):
        """What is on a layer that is off or frozen is not shown, and not taken: a base, a second block, a hole; a note names them."""
        layers = layer("BLOCK") + layer("BASE", colour=-3) + layer("Hole", flags=1) + layer("OLD", flags=5)
        hidden = line("BASE", -1, 0.5, 3, 0.5) + circle("HOLE", 0.5, 1, 0.2) + polyline("OLD", [(5, 0), (6, 0), (6, 1)])
        notes = self.notes_of(dxf(self.OUTLINE + hidden, unit=6, layers=layers))
        self.assertEqual([kind for kind, _ in notes], ["note"])
        self.assertIn("3 of the drawing's objects are not shown and left out: 1 on layer 'BASE', which is off, 1 on layer 'Hole', which is "
                      "frozen, 1 on layer 'OLD', which is frozen; show what is meant", notes[0][1])
        self.notes_of(dxf(self.OUTLINE + circle("HOLE", 0.5, 1, 0.2), unit=6, layers=layers.replace(" 70\n1\n", " 70\n0\n")),
                      2 - math.pi * 0.04, 1e-4)  # of chords
        self.refused(dxf(light_polyline("BLOCK", RING) + line("BASE", 0, 0, 1, 0), unit=6, layers=layer("BLOCK", flags=1)), "d.dxf", "",
                     "what is not shown is left out (1 of its objects)", "--unit", "m")

    def test_invisible_objects(self):
        """Group 60 of an object, of a polyline with its vertices, of an insert with all of its block."""
        for ghost in (light_polyline("BLOCK", [(5, 0), (6, 0), (6, 1)], more=((60, 1),)),
                      polyline("BLOCK", [(5, 0), (6, 0), (6, 1)]).replace(" 66\n1\n", " 66\n1\n 60\n1\n", 1),
                      insert("BLOCK", "STONE", 5, 0, (60, 1))):
            notes = self.notes_of(dxf(self.OUTLINE + ghost, unit=6, blocks=block("STONE", light_polyline("0", RING))))
            self.assertEqual([told for _, told in notes], ["1 of the drawing's objects is not shown and left out: 1 invisible by its own; show what "
                                                           "is meant"])
        self.assertEqual(self.notes_of(dxf(light_polyline("BLOCK", RING, more=((60, 0),)), unit=6)), [])

    def test_inserted_blocks(self):
        """An insert on a frozen layer hides all of its block, one on a layer that is off what is on layer 0 there; what is on layer 0
        of a block is on the layer of the insert, whatever layer 0 is."""
        stone = block("STONE", light_polyline("0", RING))
        own = block("STONE", light_polyline("BLOCK", RING))
        for blocks, layers, on, taken in ((stone, layer("BLOCK") + layer("0", flags=1), "BLOCK", True), (stone, layer("BLOCK", colour=-7), "BLOCK", False),
                                          (stone, layer("BLOCK", flags=1), "BLOCK", False), (own, layer("X", colour=-7), "X", True),
                                          (own, layer("X", flags=1), "X", False), (own, layer("X") + layer("BLOCK", colour=-1), "X", False),
                                          (stone + block("PILE", insert("0", "STONE", 0, 0)), layer("BLOCK", colour=-1), "BLOCK", False)):
            what = "PILE" if "PILE" in blocks else "STONE"
            text = dxf(insert(on, what, 0, 0) + light_polyline("OTHER", [(5, 0), (6, 0), (6, 1), (5, 1)]), unit=6, blocks=blocks, layers=layers)
            notes = self.notes_of(text, 2 if taken else 1)  # without one the other closed outline is taken, with a note
            self.assertEqual(any("not shown and left out" in told for _, told in notes), not taken, (layers, notes))


class Svg(Read):
    def svg(self, body, attributes="", head=""):
        return f'{head}<svg xmlns="http://www.w3.org/2000/svg"{attributes}>\n{body}\n</svg>\n'

    def refuse(self, body, words, place=":2:1", **more):
        self.refused(self.svg(body, **more), "d.svg", place, words)

    def test_what_moves_by_css(self):
        for name in ("transform", "translate", "rotate", "scale", "offset-path", "zoom"):
            for body in (f'<g style="{name}: x(2,1)">{SQUARE}</g>', f'<g STYLE="" style="fill:red;{name.upper()}:1">{SQUARE}</g>'):
                self.refuse(body, f"'{name}'")
        for name in ("x", "width", "height", "d", "rx"):
            self.refuse(f'<rect style="{name}:3" id="BLOCK" width="1" height="2"/>', f"'{name}'")
        self.refuse(f"<style>.a {{ transform: scale(2) }}</style>\n<g class='b a'>{SQUARE}</g>", "'transform'", ":3:1")
        self.refuse(SQUARE.replace("/>", ' class="a"/>') + "\n<style>.a { scale: 2 }</style>", "'scale'")  # also before it
        self.assertEqual(self.taken(self.svg(f'<g style="transform:none;fill:red">{SQUARE}</g>'), "d.svg"), (2, []))

    def test_origins_frames_and_skews(self):
        turned = SQUARE.replace("/>", ' transform="rotate(10)" {}/>')
        for origin in ('transform-origin="1 1"', 'style="transform-origin: center"', 'transform-box="fill-box"'):
            self.refuse(turned.format(origin), "about another origin")
        self.taken(self.svg(turned.format('transform-origin="0 0"')), "d.svg")
        self.refuse(f'<svg x="10" viewBox="0 0 10 10">{SQUARE}</svg>', "an <svg> within the drawing")
        self.refuse(SQUARE, "stretches x and y", ":1:1", attributes=' viewBox="0 0 1 2" preserveAspectRatio="none"')
        self.assertEqual(self.taken(self.svg(f"<defs><svg>{SQUARE}</svg></defs>{SQUARE}"), "d.svg"), (2, []))
        for skew in ("skewX(90)", "skewY(-90)", "skewX(270)"):
            self.refuse(f'<g transform="{skew}">{SQUARE}</g>', "skewed by a quarter of a turn")
        self.assertAlmostEqual(self.taken(self.svg(f'<g transform="skewX(89)">{SQUARE}</g>'), "d.svg")[0], 2, delta=1e-12)

    def test_numbers_that_grow(self):
        self.refuse(f'<g transform="scale(1e308)scale(1e308)">{SQUARE}</g>', "beyond 1e308", ":2:41")
        self.refuse(f'<g transform="scale(1e200)"><circle id="BLOCK" transform="scale(1e200)" r="1"/></g>', "beyond 1e308",
                    ":2:29")

    def test_what_is_not_shown(self):
        """A shape that is hidden, in any of the ways of CSS, is not taken, and a note says so."""
        ghost = '<rect id="GHOST" x="5" width="3" height="3"/>'
        for body in (ghost.replace("/>", ' style="display: none"/>'), ghost.replace("/>", ' display="none"/>'),
                     ghost.replace("/>", ' style="fill:red; VISIBILITY:hidden;"/>'), f'<g visibility="collapse"><g>{ghost}</g></g>',
                     f'<g opacity="0.0"><g opacity="1">{ghost}</g></g>', f'<g style="opacity:0%">{ghost}</g>',
                     ghost.replace("/>", ' style="fill:none;stroke:none"/>'),
                     ghost.replace("/>", ' fill="none" stroke="red" stroke-width="0"/>'),
                     f'<g style="display:inline;display:none">{ghost}</g>',
                     f"<style>#GHOST {{ display: none }}</style>{ghost}", f"<style>rect.off {{ visibility: hidden }}</style>"
                     + ghost.replace("/>", ' class="a off"/>'),
                     f"<style>/* display: all */ .a, .b {{ opacity: 0 }} @font-face {{ src: url(x;y) }}</style><g class='b'>{ghost}</g>",
                     f"{ghost}<style><![CDATA[ rect {{ display: inline }} #GHOST {{ display: none }} ]]></style>",
                     f"<style>g {{ display: none !important }}</style><g style='display:inline'>{ghost}</g>"):
            area, notes = self.taken(self.svg(SQUARE + "\n" + body), "d.svg")
            self.assertEqual(area, 2, body)
            self.assertEqual([kind for kind, *_ in notes], ["note"], body)
            self.assertIn("1 of the drawing's shapes is not shown and left out, a rect 'GHOST'", notes[0][2])
            self.assertTrue(notes[0][1].startswith("d.svg:3:"), notes)
        for body in (f'<g visibility="hidden"><rect id="BLOCK" visibility="visible" width="1" height="2"/></g>',
                     f"<style>.off {{ display: none }} #BLOCK {{ display: inline }}</style>"
                     + SQUARE.replace("/>", ' class="off"/>'), f'<g style="fill:none">{SQUARE}</g>',
                     f"<style>.off {{ display: none }}</style>" + SQUARE.replace("/>", ' class="off" style="display:inline"/>')):
            self.assertEqual(self.taken(self.svg(body), "d.svg"), (2, []), body)

    def test_all_hidden(self):
        self.refused(self.svg(SQUARE.replace("/>", ' display="none"/>')), "d.svg", "", "not shown is left out (1 of its objects)")

    def test_page(self):
        """The page says how long a unit is on it: 'unit' that says otherwise is a caution, but for a drawing to a scale of 1, 10, 100."""
        for page, unit, cautions in ((' width="210mm" viewBox="0 0 210 297"', "mm", False), (' width="210mm" viewBox="0 0 210 297"', "m", False),
                                     (' width="793.7" height="1122.5"', "mm", True), (' width="210mm" viewBox="0 0 793.7 1122.5"', "mm", True),
                                     (' width="210mm" viewBox="0,0,21,29.7"', "cm", False), (' width="8.5in" viewBox="0 0 612 792"', "in", True),
                                     (' width="8.5in" viewBox="0 0 8.5 11"', "in", False), (' width="595pt" viewBox="0 0 595 842"', "mm", True),
                                     (' width="100%" viewBox="0 0 5 5"', "m", False), (' viewBox="0 0 5 5"', "m", False), ("", "mm", False),
                                     (' width="25.4mm" viewBox="0 0 1 1"', "in", False), (' width="10em"', "mm", False)):
            area, notes = self.taken(self.svg(SQUARE, attributes=page), "d.svg", "--unit", unit)
            told = [text for kind, _, text in notes if kind == "caution" and " on its page " in text]
            self.assertEqual(len(told), cautions, (page, unit, notes))
        self.assertIn("one unit of this drawing is 0.2646 mm on its page", self.taken(
            self.svg(SQUARE, attributes=' width="793.7"'), "d.svg", "--unit", "mm")[1][0][2])
        (self.folder / "scene.yaml").write_text("topple: 1\nlength_unit: m\ndrawing: {file: d.svg, reference: {id: bar, length: 2}}\n")
        self.solve(self.svg(SQUARE + '<path id="bar" d="M 0 9 h 1"/>', attributes=' width="793.7"'), "d.svg")
        status, out, _ = run("solve", "--json", "scene.yaml", folder=self.folder)
        self.assertEqual((status, json.loads(out)["notes"]), (0, []))

    def test_style_sheets_that_are_not_read(self):
        """What hides by a selector that is not told, by a condition or from another file is refused; what bears on no outline
        is not."""
        self.refuse(f"<style>\n g > rect {{ display: none }}</style>{SQUARE}", "elements, classes and ids alone", ":3:2")
        self.refuse(f"<style>rect:hover {{ opacity: 0 }}</style>{SQUARE}", "elements, classes and ids alone", ":2:8")
        self.refuse(f"<style>@media print {{ rect {{ display: none }} }}</style>{SQUARE}", "begins with '@'", ":2:8")
        self.refuse(f"<style>@import url(x.css);</style>{SQUARE}", "begins with '@'", ":2:8")
        self.refuse(f"<style media='print'>rect {{ display: none }}</style>{SQUARE}", "one medium")
        self.refuse(f"<style>rect {{ opacity: 0</style>{SQUARE}", "does not end", ":2:8")
        self.refuse(SQUARE, "in another file", ":1:1", head='<?xml-stylesheet href="a.css"?>')
        self.refuse(f'<g visibility="maybe">{SQUARE}</g>', "'visibility'")
        self.assertEqual(self.taken(self.svg(f"<style>g > rect, text {{ fill: red; font: 3px a }}</style>{SQUARE}"), "d.svg"),
                         (2, []))

    def test_clips(self):
        _, notes = self.taken(self.svg(f'<g clip-path="url(#c)">{SQUARE}</g>'), "d.svg")
        self.assertEqual([kind for kind, *_ in notes], ["caution"])
        self.assertIn("clip-path", notes[0][2])


class Geojson(Read):
    def polygon(self, ring, more="", head=""):
        return f'{{{head}"type": "Polygon", "coordinates": [{json.dumps(ring)}]{more}}}'

    def test_coordinates_are_numbers(self):
        for wrong in ("9", None, True, {"x": 1}, [1, 1]):
            for at in range(3):
                ring = [[0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 0, 0]]
                ring[1][at] = wrong
                self.refused(self.polygon(ring), "d.geojson", ":1", "coordinates are numbers")
        self.refused(self.polygon([[0, 0], "x", [1, 0], [1, 1]]), "d.geojson", ":1", "coordinates are numbers")

    def test_a_box_behind_the_coordinates(self):
        """Numbers beside the coordinates are none of them."""
        ring = [list(point) for point in RING + RING[:1]]
        for more in (', "bbox": [0, 0, 1, 2]', ', "note": ["a", null, {"b": [1, 2]}]'):
            self.assertEqual(self.taken(self.polygon(ring, more), "d.geojson"), (2, []))

    def test_degrees(self):
        ring = [list(point) for point in RING + RING[:1]]
        for name in ("urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"):
            head = f'"crs": {{"type": "name", "properties": {{"name": "{name}"}}}}, '
            self.refused(self.polygon(ring, head=head), "d.geojson", ":1", "degrees on the globe")
        head = '"crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}}, '
        self.assertEqual(self.taken(self.polygon(ring, head=head), "d.geojson"), (2, []))


class Units(Read):
    """A unit in the file and another that is given: neither is believed."""
    CSV = "x_mm,y_mm\n0,0\n1,0\n1,2\n0,2\n0,0\n"

    def test_headers(self):
        self.refused(self.CSV, "d.csv", "", "in mm, not m")
        self.refused("x,y\nmm,mm\n" + self.CSV.split("\n", 1)[1], "d.csv", "", "in mm, not m")
        self.assertEqual(self.taken(self.CSV, "d.csv", "--unit", "mm")[0], 2e-6)
        (self.folder / "d.csv").write_text(self.CSV)
        self.assertEqual(self.taken("topple: 1\ndrawing: {file: d.csv}\n", "s.yaml", "--digits", "9")[0], 2e-6)

    def test_of_drawings(self):
        drawing = dxf(light_polyline("BLOCK", RING), unit=4)
        self.refused(drawing, "d.dxf", "", "in mm, not m")
        self.taken(drawing, "d.dxf", "--unit", "mm")

    def test_columns_of_a_drawing(self):
        """By what they are called, as in a file of points."""
        rows = "".join(f"BLOCK,{y},{x}\n" for x, y in RING)
        area, notes = self.taken("layer,Elevation,Distance\n" + rows, "d.csv")
        self.assertEqual(area, 2)
        self.assertEqual([(kind, place) for kind, place, _ in notes][:1], [("note", "d.csv:1:1")])
        self.refused("layer,Northing,Easting\n" + rows, "d.csv", ":1:7", "a line of section is needed")
        self.refused("x,y,z\n0,0,0\n1,0,0\n1,2,1\n", "d.csv", ":4:5", "a line of section is needed")

    def test_elevation_and_distance(self):
        """By these names the block is 1.2 m wide and 4 m high, (0.6 / 2) / tan 15 = 1.120; with x and y exchanged it would
        slide first, at tan 35 / tan 15 = 2.613."""
        slab = "Elevation,Distance\n0,0\n0,1.2\n4,1.2\n4,0\n"
        sets = ("friction_angle_deg=35", "block.unit_weight_kn_m3=26", "tilt.towards=left", "tilt.angle_deg=15")
        status, out, err = self.solve(slab, "d.csv", "--unit", "m", *(word for s in sets for word in ("--set", s)))
        self.assertEqual((status, err), (0, ""))
        self.assertAlmostEqual(json.loads(out)["cases"][0]["governing_fos"]["fos"]["value"], 1.1196, delta=1e-4)


if __name__ == "__main__":
    main()
