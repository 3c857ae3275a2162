# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Outlines as people export them: spreadsheets, GIS, total stations.

The story: decimal commas were told to be too many columns, a second header line no number, quotes no number, a point
digitised twice was refused, and of `id,x,y` the id was taken for x. Each dialect must give the very block that the same
vertices give inline; what cannot be told apart from something else must be refused with words of its own."""

import csv
import io
import json
import pathlib
import random
import tempfile
import unittest

from harness import main, run

RING = [(0, 0), (1.5, -0.25), (3, 0.125), (2.75, 4.5), (0.25, 4)]
SCENE = ("topple: 1\nlength_unit: m\nblock: {{outline: {}, unit_weight_kn_m3: 26}}\nbase: {{mated: true}}\n"
         "friction_angle_deg: 30\ntilt: {{towards: left, angle_deg: 5}}\n")
PROFILE = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [2, 3], [0, 3]]}\nbase: {profile: o.csv}\n")


def rows(separator=",", ring=RING, form="{}"):
    return "".join(separator.join(form.format(c) for c in point) + "\n" for point in ring)


class Csv(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)
        self.inline = self.solve(SCENE.format([list(point) for point in RING]))[0]

    def tearDown(self):
        self.holder.cleanup()

    def solve(self, scene):
        """The numbers of the block and its cases, and the notes."""
        (self.folder / "scene.yaml").write_text(scene)
        status, out, err = run("solve", "--json", "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        solution = json.loads(out)
        for case in solution["cases"]:
            del case["effects"]
        return solution["cases"], [(note["kind"], note["place"], note["text"]) for note in solution["notes"]]

    def csv(self, text, scene=SCENE.format("o.csv")):
        (self.folder / "o.csv").write_bytes(text.encode() if isinstance(text, str) else text)
        return self.solve(scene)

    def same(self, text, notes=()):
        cases, said = self.csv(text)
        self.assertEqual(cases, self.inline)
        self.assertEqual(said, [("note", *note) for note in notes])

    def refuse(self, text, place, words):
        (self.folder / "o.csv").write_text(text)
        (self.folder / "scene.yaml").write_text(SCENE.format("o.csv"))
        status, out, err = run("solve", "scene.yaml", folder=self.folder)
        self.assertEqual((status, out), (3, ""), text)
        self.assertIn(f"topple: o.csv:{place}: ", err)
        self.assertIn(words, err)

    def test_dialects(self):
        for separator in (",", ";", "\t", " ", ", ", " ; ", "\t\t", "  "):
            self.same(rows(separator))
            self.same("x" + separator + "y\n" + rows(separator))
        self.same(rows(",", form='"{}"'))
        self.same('"x","y"\n' + rows(";", form='" {} "'))
        self.same(rows(",").replace("\n", ",,\r\n"))  # columns left empty by a spreadsheet
        self.same("﻿" + rows())
        self.same("\t".join(("0,", "0")) + "\n" + "".join(f"{x}\t,\t{y}\t# a tab beside a comma\n" for x, y in RING[1:]))
        self.same("# survey, 2024\n\n" + rows().replace("4\n", "4 # the top\n"))

    def test_two_header_lines(self):
        """A title and names, names and units, either alone; a third one is a point that is not a number."""
        for head in ("Block 7\nx,y\n", "x,y\nm,m\n", "x,y\n[m],[m]\n", '"x","y"\n"(m)","(m)"\n', "Profile 3\n", "Block E\n",
                     "distance,elevation\nm,m\n", "Survey of May, 2024, by hand\nx,y\n", "Survey of May; by hand\n\n", "x (m), y (m)\n"):
            self.same(head + rows())
        self.same("x (m) y (m)\n" + rows(" "))
        self.same("x y\n" + rows(", "))
        self.refuse("x,y\nm,m\na,b\n" + rows(), "3:1", "this entry is not a number")
        self.refuse("o,0\n" + rows(), "1:1", "this entry is not a number")  # a letter o: no header
        self.refuse("0,0\nx,y\n" + rows(), "2:1", "this entry is not a number")

    def test_columns_by_name(self):
        """What a header names x and y is read wherever it stands, and a note says which columns these are."""
        def columns(head, order):
            lines = [",".join(order.format(k=k, x=x, y=y).split()) for k, (x, y) in enumerate(RING)]
            return head + "\n" + "\n".join(lines) + "\n"

        def note(x, y, of):
            return [("o.csv:1:1", f"columns {x} and {y} of {of} are read as x and y, as the header names them")]

        self.same(columns("id,x,y", "{k} {x} {y}"), note(2, 3, 3))
        self.same(columns("ID,X,Y", "P{k} {x} {y}"), note(2, 3, 3))
        self.same(columns('"id","X (m)","Y (m)"', "{k} {x} {y}"), note(2, 3, 3))
        self.same(columns("x,y,z", "{x} {y} 7"), note(1, 2, 3))
        self.same(columns("z,y_m,code,x_m", "1e9 {y} a/b/c {x}"), note(4, 2, 4))
        self.same(columns("y,x", "{y} {x}"), note(2, 1, 2))
        self.same(columns("x,elevation", "{x} {y}"))
        self.same("id;x;y\n" + rows(";", [(k, *p) for k, p in enumerate(RING)]), note(2, 3, 3))
        self.same('name,x,y\n' + "".join(f'"P, {k} #1",{x},{y}\n' for k, (x, y) in enumerate(RING)), note(2, 3, 3))
        self.refuse(columns("id,x", "{k} {x}"), "1:4", "a column x, but none y")
        self.refuse(columns("id,y,z", "{k} {y} 1"), "1:4", "a column y, but none x")
        self.refuse(columns("x,y,x", "{x} {y} 1"), "1:5", "two columns x")
        self.refuse(columns("id,name,code", "{k} {x} {y}"), "1:1", "the header names no column that is known: call them")
        self.refuse(columns("id,x,y", "{k} {x}"), "2:4", "a number is missing")
        self.refuse(columns("id,x,y", "{k} {x} {y} 9"), "2:7", "more columns than the header names")

    def test_columns_by_what_they_are_called(self):
        """Elevations are y wherever they stand, distances x, in any case, with units in the names; the columns of a plan are
        no section, and depths no heights."""
        def columns(head, order):
            return head + "\n" + "\n".join(",".join(order.format(k=k, x=x, y=y, d=-y).split())
                                          for k, (x, y) in enumerate(RING)) + "\n"

        for head in ("Distance,Elevation", "CHAINAGE (m),RL (m)", "x,z", "X [m],Z [m]", "station_m,reduced level_m",
                     "Distance along the section (m),Elevation (m AHD)", "Offset,Height", "distance,y", "x_m,Elev"):
            self.same(columns(head, "{x} {y}"))
        for head, words in (("Elevation,Distance", ("distance", "elevation")), ("Z,X", ("x", "z")),
                            ("RL_m,Chainage_m", ("chainage", "rl")), ("Ground level (m);Distance (m)", ("distance", "ground level"))):
            self.same(columns(head, "{y} {x}") if ";" not in head else columns(head, "{y} {x}").replace(",", ";"),
                      [("o.csv:1:1", f"columns 2 ('{words[0]}') and 1 ('{words[1]}') of 2 are read as x and y, as the header names "
                        "them")])
        self.same(columns("Easting,Northing,Chainage,Elevation", "7 {k} {x} {y}"),
                  [("o.csv:1:1", "columns 3 ('chainage') and 4 ('elevation') of 4 are read as x and y, as the header names them")])
        kinds = self.csv(columns("Northing,Elevation", "{x} {y}"))[1]
        self.assertEqual([kind for kind, *_ in kinds], ["caution"])
        plan = "a line of section is needed"
        for head in ("Easting,Northing", "Northing,Easting", "E,N", "x (easting),y (northing)", "East_m,North_m"):
            self.refuse(columns(head, "{x} {y}"), "1:1", plan)
        self.refuse(columns("id,Easting,Northing,RL", "{k} {x} {y} 1"), "1:4", plan)
        self.refuse(columns("x,y,z", "{x} {y} {k}"), "3:11", plan)
        self.refuse(columns("x,y,elevation", "{x} {y} {k}"), "3:11", plan)
        self.refuse(columns("Distance,Depth", "{x} {d}"), "1:10", "depths run downwards")
        self.refuse(columns("Longitude,Latitude", "{x} {y}"), "1:1", "degrees on the globe")
        self.refuse(columns("distance,id", "{x} {y}"), "1:1", "a column distance, but none of heights")
        self.refuse(columns("id,elevation", "{x} {y}"), "1:4", "a column elevation, but none of distances along the section")
        self.refuse(columns("distance,chainage,elevation", "{x} {x} {y}"), "1:10", "two columns alike, 'distance' and 'chainage'")
        self.refuse(columns("x,distance,elevation", "{x} {x} {y}"), "1:3", "two columns along the section")
        self.refuse(columns("first,second", "{x} {y}"), "1:1", "a title begins with '#'")
        self.same("# first, second\n" + rows())

    def test_units_of_columns(self):
        """A unit in the header must be the scene's, and be one of Topple's; a second line may say it."""
        for head, unit in (("x_mm,y_mm", "mm"), ("X (mm),Y", "mm"), ("x,y\nmm,mm", "mm"), ("distance [ft],elevation", "ft"),
                           ("x,y_inches", "in"), ("x (feet),y (feet)", "ft")):
            self.refuse(head + "\n" + rows(), "1:1", f"lengths are in {unit}, the scene's length_unit is m")
        self.same("x_metres,y_m\n" + rows())
        self.refuse("x (m),y (ft)\n" + rows(), "1:7", "in units that differ")
        self.refuse("x_px,y_px\n" + rows(), "1:1", "lengths are in px, the scene's length_unit is m")
        self.refuse("x (yd),y (yd)\n" + rows(), "1:1", "a unit that no lengths are taken in")
        (self.folder / "o.csv").write_text("x_mm,y_mm\n" + rows())
        status, _, err = run("profile", "--unit", "m", "o.csv", folder=self.folder)
        self.assertEqual(status, 3, err)
        self.assertIn("lengths are in mm", err)

    def test_columns_of_a_written_file(self):
        """Files as Python's csv module writes them, columns in any order and quoted in any way."""
        random.seed(5)
        for _ in range(40):
            names = random.sample(["x", "y", "id", "remark, long", 'he said "no"', "code"], 6)
            names = [name for name in names if name in "xy" or random.random() < 0.6]
            file = io.StringIO()
            writer = csv.DictWriter(file, names, delimiter=random.choice(",;\t"), extrasaction="ignore",
                                    quoting=random.choice([csv.QUOTE_ALL, csv.QUOTE_MINIMAL, csv.QUOTE_NONNUMERIC]))
            writer.writeheader()
            for k, (x, y) in enumerate(RING):
                writer.writerow({"x": x, "y": y, "id": k, "remark, long": "a, b; c", 'he said "no"': "no. 1", "code": -k})
            with self.subTest(file.getvalue()):
                self.assertEqual(self.csv(file.getvalue())[0], self.inline)

    def test_decimal_commas(self):
        """Never read as two numbers: refused by name, at the comma, however the columns are separated."""
        for separator in (";", "\t", " ", " ; "):
            text = rows(separator).replace(".", ",")
            self.refuse(text, "2:2", "a comma within a number; write decimals with a point, 1.5 for 1,5")
            self.refuse("x" + separator + "y\n" + text, "3:2", "a comma within a number")
        self.refuse('"0","0"\n"1,5","-0,25"\n', "2:3", "a comma within a number")
        self.refuse("0;0\n1,5;2\n", "2:2", "a comma within a number")
        self.refuse("0;0\n2;1,5\n", "2:4", "a comma within a number")
        self.refuse("0 0\n1.5 2,000.5\n", "2:6", "a comma within a number")
        self.refuse("0,0\n1,5,2,5\n", "2:5", "decimals take a point, not a comma")
        self.refuse("x,y\n0,0\n1,5,2,5\n", "3:5", "decimals take a point, not a comma")
        self.refuse("0;0\n3,7\n1;1\n", "2:1", "separated by ';' so far, here by ','; if this is a decimal comma")
        self.refuse("x;y\n3,7\n1;1\n", "2:1", "separated by ';' so far, here by ','")

    def test_repeated_points(self):
        """A point that was digitised twice or thrice in a row counts once, and a note says where; points that come again
        later do not, and a ring may be closed by its first point besides."""
        twice = RING[:2] + [RING[1]] + RING[2:]
        self.same(rows(ring=twice), [("o.csv:3:1", "a point that repeats the one before it is left out")])
        many = [point for point in RING for _ in range(3)] + [RING[0], RING[0]]
        self.same("x,y\n" + rows(ring=many),
                  [("o.csv:3:1", "points that repeat the one before them are left out, 11 in all")])
        self.same("0,0\n15e-1,-0.250\n1.50,-.25\n3,125e-3\n2.75,4.5\n0.25,4\n",
                  [("o.csv:3:1", "a point that repeats the one before it is left out")])
        self.refuse(rows(ring=RING[:3] + [RING[1]] + RING[3:]), "1:1", "the outline touches itself")

    def test_fields_are_data(self):
        """`3/2` is no number of a file: it was taken for a quotient, as `30/120` was. Ranges and formulas are none either. A
        profile that the program wrote has quotients where decimals have no end, and says so in its first line."""
        for field, saying in (("3/2", "this entry is two numbers, and nothing is calculated in a field"), ("2-1", "this entry is a range"),
                              ("2*1", "this entry is not a number"), ("(2)", "this entry is not a number")):
            self.refuse(f"x,y\n0,0\n{field},-0.25\n3,0.125\n2.75,4.5\n", "3:1", saying)
        self.same("# coordinates are exact fractions\n0,0\n3/2,-1/4\n3,1/8\n11/4,9/2\n1/4,4\n")
        scene = ("topple: 1\nlength_unit: m\nblock: {outline: [[0, 0], [2, 0], [2, 3], [0, 3]]}\nfriction_angle_deg: 30\n"
                 "tilt: {towards: left}\nbase: {profile: [[-1, 0], [5/3, 0], [7/3, -1/7]]}\n")
        (self.folder / "thirds.yaml").write_text(scene)
        status, _, err = run("solve", "thirds.yaml", "--write-profile", "written.csv", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual((self.folder / "written.csv").read_text(), "# coordinates are exact fractions\nx,y\n-1,0\n5/3,0\n7/3,-1/7\n")
        again = scene.replace("[[-1, 0], [5/3, 0], [7/3, -1/7]]", "written.csv")
        self.assertEqual(self.solve(again), self.solve(scene))

    def test_repeated_points_of_a_profile(self):
        level, _ = self.csv("-1,0\n1,0\n3,0\n", PROFILE)
        again, notes = self.csv("-1,0\n-1,0\n1,0\n1,0\n3,0\n", PROFILE)
        self.assertEqual([case["pivots"] for case in level], [case["pivots"] for case in again])
        self.assertEqual(len(notes), 1)

    def test_closed_inline(self):
        """A last vertex that is the first one is dropped inline as it is in files; also of holes and parts, and from
        formulas, unless only these parameters close the ring."""
        closed = [list(point) for point in RING + RING[:1]]
        self.assertEqual(self.solve(SCENE.format(closed)), (self.inline, []))
        self.assertEqual(self.solve(SCENE.format(closed[::-1]))[0][0]["block"], self.inline[0]["block"])
        hole = [[1, 1], [2, 1], [2, 2]]
        scene = SCENE.replace("unit_weight", "holes: [{}], unit_weight")
        self.assertEqual(self.solve(scene.format(closed, hole + hole[:1])), self.solve(scene.format(closed[:-1], hole)))

        def derive(last):
            (self.folder / "scene.yaml").write_text(
                f"topple: 1\nlength_unit: m\nparameters: {{a: 2, h: 5}}\n"
                f"block: {{outline: [[0, 0], [a, 0], [a, h], [0, h]{last}]}}\nbase: {{mated: true}}\ntilt: {{towards: left}}\n")
            return run("derive", "scene.yaml", folder=self.folder)
        self.assertEqual(derive(""), derive(", [a - a, 0]"))
        status, out, err = derive(", [0, h - 5]")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("scene.yaml:4:51: this vertex closes the outline for the parameters as they are", err)

    def test_quotes(self):
        self.refuse('0,0\n"1,0\n1,1\n', "2:1", "this quote is not closed")
        self.refuse('0,0\n"\n1,1\n', "2:1", "this quote is not closed")
        self.refuse("0,0\n1,1" + "," * 70 + "9\n", "2:5", "more than two columns")
        self.refuse("0,0\n" + "," * 70 + "9\n", "2:3", "more than two columns")
        self.same(",,\n" + rows().replace("\n", "\n;;\n"))


if __name__ == "__main__":
    main()
