# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Shapefile and GeoPackage (docs/drawing.md): a section that was drawn in a GIS.

The story: the block that lies in such a file is the one that the same decimals give inline, to the last byte of what is
computed, in the unit of its coordinate reference system; and what is no section, because it lies in degrees, in space, in
arcs or in a file that was cut off, is refused with what to do. The files are made byte by byte (gis_case.py)."""

import json
import os
import pathlib
import sqlite3
import struct
import tempfile
import unittest
from fractions import Fraction

from gis_case import (SWISS, WORLD, arc_string, collection, in_units, line_string, polygon, read_lines, ring,
                      write_geopackage, write_shapefile)
from harness import PROGRAM, main, run

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
HAS_GDAL = (BUILD / "libtopple-gis.so").exists()

RING = [("600000.1", "0.7"), ("600000.4", "0.75"), ("600000.7", "0.7"), ("600001", "0.75"), ("600001", "1.9"), ("600000.1", "1.85")]
HOLE = [("600000.5", "1.2"), ("600000.6", "1.2"), ("600000.6", "1.3")]
BASE = [("599999.5", "0.7"), *RING[:4], ("600002.3", "0.75")]


def numbers(points):
    return [(float(x), float(y)) for x, y in points]


def inline(points, factor="", shift=0):
    return "[" + ", ".join(f"[{x}{factor}, {y}{factor}]" for x, y in points) + "]"


class Gis(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)
        self.shp, self.gpkg = self.folder / "section.shp", self.folder / "section.gpkg"

    def solve(self, name, *options):
        status, out, err = run("solve", "--json", *options, name, folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return json.dumps([{key: value for key, value in case.items() if key not in ("effects", "notes")}
                           for case in json.loads(out)["cases"]])

    def scene(self, head, block="", base=""):
        rest = f"block: {{unit_weight_kn_m3: 26{block}}}\n{base}friction_angle_deg: 30\ntilt: {{towards: left}}\n"
        (self.folder / "scene.yaml").write_text("topple: 1\n" + head + rest)
        return self.solve("scene.yaml")

    def inline(self, unit="m", factor="", hole=True):
        return self.scene(f"length_unit: {unit}\n", f", outline: {inline(RING, factor)}"
                          + (f", holes: [{inline(HOLE, factor)}]" if hole else ""),
                          f"base: {{profile: {inline(BASE, factor)}}}\n")

    def lines(self, points=RING, base=BASE, hole=HOLE, **more):
        """Block, hole and base as lines, in one file, told apart by the attribute "layer"."""
        closed = [("BLOCK", points), ("hole", hole)]
        write_shapefile(self.shp, 3, [((layer, ""), [[*numbers(p), numbers(p)[0]]]) for layer, p in closed]
                        + [(("Base", "ground"), [numbers(base)])], **more)

    def refused(self, name, *words, options=(), exit_status=3):
        status, out, err = run("solve", *options, name, folder=self.folder)
        self.assertEqual((status, out), (exit_status, ""), err)
        self.assertEqual(err.count("\n"), 1, err)
        for word in words:
            self.assertIn(word, err)
        return err


@unittest.skipUnless(HAS_GDAL, "Topple was built without GDAL")
class Read(Gis):
    def test_shapefile_of_lines(self):
        self.lines()
        self.assertEqual(self.scene("drawing: {file: section.shp}\n"), self.inline())

    def test_the_bytes_are_these_decimals(self):
        """Read back by another route, each double is named by the decimal that stands inline."""
        self.lines()
        told = [[(f"{x:.15g}", f"{y:.15g}") for x, y in line] for line in read_lines(self.shp)]
        self.assertEqual(told, [[*RING, RING[0]], [*HOLE, HOLE[0]], BASE])

    def test_all_digits_of_a_double(self):
        """The shortest decimal that reads back as the same, of 16 digits here."""
        x = 1 / 3 + 600000
        write_shapefile(self.shp, 5, [(("", ""), [ring([(600000, 0), (x, 0), (x, 1), (600000, 1)], True)])])
        told = json.loads(self.solve("section.shp"))[0]["block"]["area_m2"]
        truth = Fraction(repr(x)) - 600000  # 0.3333333334, which the double is not, by 3e-11
        self.assertLessEqual(abs(Fraction(told["value"]) - truth), Fraction(told["error"]))
        self.assertLess(told["error"], 1e-14)

    def test_polygons_with_holes(self):
        """A polygon alone is the block, its inner ring a hole; the file's name is the layer of the others."""
        rings = [ring(numbers(RING), True), ring(numbers(HOLE), False)]
        write_shapefile(self.shp, 5, [(("", "rock"), rings)])
        for keys in ("", ", block: rock", ", block: SECTION"):
            own = self.scene(f"drawing: {{file: section.shp{keys}}}\n", base=f"base: {{profile: {inline(BASE)}}}\n")
            self.assertEqual(own, self.inline(), keys)

    def test_geopackage(self):
        """Layers by their names, or by an attribute; parts of multi-geometries each are one."""
        rings = [ring(numbers(p), False) for p in (RING, HOLE)]
        whole = self.inline()
        for shape_of in (polygon(rings), collection(6, [polygon(rings)]), collection(7, [polygon(rings)])):
            write_geopackage(self.gpkg, [("Block", 2056, [(None, None, shape_of), (None, None, None)]),
                                         ("lines", 2056, [("base", None, line_string(numbers(BASE)))]),
                                         ("map", 4326, [("frame", None, line_string([(7.0, 46.0), (8.0, 46.0)]))])])
            self.assertEqual(self.scene("drawing: {file: section.gpkg}\n"), whole)
        pieces = [line_string(numbers(BASE[:3])), line_string(numbers(BASE[2:]))]
        write_geopackage(self.gpkg, [("BLOCK", 2056, [("", "", polygon(rings))]),
                                     ("base", 2056, [("", "", collection(5, pieces))])])
        self.assertEqual(self.scene("drawing: {file: section.gpkg}\n"), whole)

    def test_a_second_reader(self):
        """The same file by sqlite3 and the bytes of its WKB, which make the scene."""
        write_geopackage(self.gpkg, [("BLOCK", 2056, [("", "", polygon([ring(numbers(RING), False)]))])])
        base = sqlite3.connect(self.gpkg)
        blob = base.execute('SELECT geom FROM "BLOCK"').fetchone()[0]
        base.close()
        count = struct.unpack_from("<I", blob, 8 + 9)[0]
        points = list(struct.iter_unpack("<2d", blob[8 + 13:8 + 13 + 16 * count]))
        scene = self.scene("length_unit: m\n", f", outline: {inline([(repr(x), repr(y)) for x, y in points])}")
        self.assertEqual(self.solve("section.gpkg", "--set", "block.unit_weight_kn_m3=26", "--set", "tilt.towards=left",
                                    "--set", "friction_angle_deg=30"), scene)

    def test_units(self):
        """Of the file's system, exactly: the international foot, the US survey foot (1200/3937 m) as metres."""
        self.lines(projection=in_units("Foot", 0.3048))
        self.assertEqual(self.scene("drawing: {file: section.shp}\n"), self.inline("ft"))
        for metres in (0.3048006096012192, 0.304800609601219, 0.3048006096):
            self.lines(projection=in_units("Foot_US", metres))
            self.assertEqual(self.scene("drawing: {file: section.shp}\n"), self.inline("m", "*1200/3937"))
        _, out, _ = run("solve", "--verbose", "section.shp", folder=self.folder)
        self.assertIn("US survey feet", " ".join(out.split()))
        self.lines(projection=in_units("Yard", 0.9144))
        self.refused("section.shp", "feature 1 of the layer 'section'", "none of m, ft")
        self.lines(projection=None)
        self.refused("section.shp", "does not say what the unit of its lengths is", "--unit mm")
        self.assertEqual(self.scene("drawing: {file: section.shp, unit: m}\n"), self.inline())
        write_geopackage(self.gpkg, [("BLOCK", -1, [("", "", polygon([ring(numbers(RING), False)]))])])
        self.refused("section.gpkg", "does not say what the unit of its lengths is")

    def test_in_every_command(self):
        self.lines()
        status, out, err = run("solve", "--verbose", "section.shp", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertRegex(out, r"LineString +\S* *\S+ +.*base")
        status, out, err = run("profile", "--json", "section.shp", folder=self.folder)
        self.assertEqual((status, err, json.loads(out)["length_unit"]), (0, "", "m"))

    def test_text_from_outside(self):
        """The name of a layer or an attribute is made plain."""
        write_shapefile(self.shp, 3, [(("\x1b[31mred", "<b>"), [numbers(RING[:3])]), (("\x1b[31mred", ""), [numbers(RING[2:5])])])
        self.assertNotIn("\x1b", self.refused("section.shp"))


@unittest.skipUnless(HAS_GDAL, "Topple was built without GDAL")
class Refused(Gis):
    def test_degrees(self):
        self.lines(projection=WORLD)
        self.refused("section.shp", "degrees of longitude and latitude", "-t_srs")
        self.refused("section.shp", "degrees of longitude and latitude", options=("--unit", "m"))
        write_geopackage(self.gpkg, [("BLOCK", 4326, [("", "", polygon([ring(numbers(RING), False)]))]),
                                     ("other", 2056, [("", "", line_string(numbers(BASE)))])])
        self.refused("section.gpkg", "degrees of longitude and latitude")

    def test_two_units(self):
        write_geopackage(self.gpkg, [("BLOCK", 1, [("", "", polygon([ring(numbers(RING), False)]))]),
                                     ("base", 2, [("", "", line_string(numbers(BASE)))])],
                         systems=((1, SWISS), (2, in_units("Foot", 0.3048).replace("LV03", "FT"))))
        self.refused("section.gpkg", "feature 1 of the layer 'base'", "another unit of length")

    def test_heights(self):
        """One height all along is none; a line in space is no section."""
        features = [(("BLOCK", ""), [[*numbers(RING), numbers(RING)[0]]], [5.0] * 7), (("hole", ""), [[*numbers(HOLE),
                    numbers(HOLE)[0]]], [2.0] * 4), (("base", ""), [numbers(BASE)], [0.0] * 6)]
        write_shapefile(self.shp, 13, features)
        self.assertEqual(self.scene("drawing: {file: section.shp}\n"), self.inline())
        features[0] = (*features[0][:2], [5.0] * 6 + [5.5])
        write_shapefile(self.shp, 13, features)
        self.refused("section.shp", "a z that changes along it")

    def test_arcs(self):
        half = arc_string([(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)])
        closed = collection(9, [half, line_string([(2.0, 0.0), (0.0, 0.0)])])
        for shape_of in (collection(10, [closed]), closed):
            write_geopackage(self.gpkg, [("BLOCK", 2056, [("", "", shape_of)])])
            self.refused("section.gpkg", "has arcs", "CONVERT_TO_LINEAR")

    def test_cut_off(self):
        self.lines()
        whole, index = self.shp.read_bytes(), self.shp.with_suffix(".shx").read_bytes()
        for length in (0, 3, 99, 100, 108, 150, len(whole) // 2, len(whole) - 1):
            self.shp.write_bytes(whole[:length])
            self.refused("section.shp", "section.shp: ")
        self.shp.write_bytes(whole)
        for length in (0, 50, 104):
            self.shp.with_suffix(".shx").write_bytes(index[:length])
            status, _, err = run("solve", "section.shp", folder=self.folder)
            self.assertEqual(status, 3, (length, err))
        self.shp.with_suffix(".shx").unlink()
        self.refused("section.shp", ".shx")
        write_geopackage(self.gpkg, [("BLOCK", 2056, [("", "", polygon([ring(numbers(RING), False)]))])])
        whole = self.gpkg.read_bytes()
        for length in (0, 15, 100, 512, len(whole) // 2):
            self.gpkg.write_bytes(whole[:length])
            self.refused("section.gpkg", "section.gpkg: ")

    def test_lying_counts(self):
        """A record that says that it has more points than the file."""
        self.lines()
        data = bytearray(self.shp.read_bytes())
        struct.pack_into("<i", data, 100 + 8 + 4 + 32 + 4, 2**31 - 1)
        self.shp.write_bytes(data)
        self.refused("section.shp", "section.shp: ")
        self.lines(points=[("0", "0"), ("1", "0"), ("nan", "1")])
        self.refused("section.shp", "a coordinate that is not a number")

    def test_nothing_there(self):
        write_shapefile(self.shp, 5, [])
        self.refused("section.shp")
        write_shapefile(self.shp, 5, [(("", ""), [])])
        self.refused("section.shp")
        write_geopackage(self.gpkg, [("BLOCK", 2056, [])])
        self.refused("section.gpkg")

    def test_no_other_format_and_no_network(self):
        """What GDAL could read besides stays unread, whatever its name."""
        (self.folder / "section.shp").write_text('{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}')
        self.refused("section.shp")
        for name, exit_status in (("/vsicurl/http://127.0.0.1:9/a.shp", 5), ("/vsizip/a.zip/a.gpkg", 5), (".", 3)):
            (self.folder / "scene.yaml").write_text(f"topple: 1\nlength_unit: m\ndrawing: {{file: {name}}}\n")
            self.refused("scene.yaml", exit_status=exit_status)


class Absent(Gis):
    @unittest.skipIf(HAS_GDAL, "Topple was built with GDAL")
    def test_what_to_install(self):
        self.lines()
        self.refused("section.shp", "'./run --with gis'", "GeoJSON")


if __name__ == "__main__":
    main()
