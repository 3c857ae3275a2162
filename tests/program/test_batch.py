# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""`topple solve --batch`: a table of blocks that were surveyed. Each row's numbers are those of its scene solved alone, byte by
byte, whatever the order of the rows and the number of threads; slabs are what closed forms say; a row that is wrong says where
and what to do, and costs itself alone; the worst comes first."""

import base64
import csv
import html.parser
import io
import json
import math
import pathlib
import random
import re
import tempfile
import unittest
import xml.etree.ElementTree as ET
import zipfile

from harness import PROGRAM, ROOT, main, run

SLOPE = ROOT / "examples" / "slope"
SCENE = """topple: 1
length_unit: {unit}
block: {{slab: {{width: {width}, height: {height}}}, unit_weight_kn_m3: 26}}
slope: {{dip_deg: {dip}, towards: right}}
friction_angle_deg: {friction}
loads: {{water: {{height: {water}}}, seismic: {{horizontal: {shaking}}}, cohesion_kpa: {cohesion}}}
required_fos: {required}
"""
TEMPLATE = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 1}, unit_weight_kn_m3: 26}\nrequired_fos: 1.2\n"
#: Columns of the table that `solve --csv` has too, under the same names.
SHARED = ("verdict", "fos", "fos_error", "fos_mechanism")


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def simplest(value):
    return float(value) if value else math.nan


MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
WORKBOOK = (f'<workbook xmlns="{MAIN}" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets>'
            '<sheet name="A" sheetId="1" r:id="rId7"/><sheet name="B" sheetId="2" r:id="rId1"/></sheets></workbook>')
RELATIONS = ('<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
             '<Relationship Id="rId1" Target="worksheets/other.xml"/><Relationship Id="rId7" Target="worksheets/blocks.xml"/>'
             "</Relationships>")
STYLES = (f'<styleSheet xmlns="{MAIN}"><numFmts><numFmt numFmtId="164" formatCode="dd/mm/yyyy"/>'
          '<numFmt numFmtId="165" formatCode="0.0&quot; days&quot;"/></numFmts><cellXfs><xf numFmtId="0"/><xf numFmtId="14"/>'
          '<xf numFmtId="164"/><xf numFmtId="165"/></cellXfs></styleSheet>')


class Page(html.parser.HTMLParser):
    """The cells of a page, and its elements."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.texts = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.elements.append(tag)

    def handle_data(self, data):
        self.texts.append(data)


class Batch(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, text, name="survey.csv", encoding="utf-8"):
        path = self.folder / name
        path.write_text(text, encoding=encoding)
        return path

    def batch(self, table, *words, status=0):
        got, out, err = run("solve", "--batch", "--csv", table, *words)
        self.assertEqual(got, status, err)
        return {row["name"]: row for row in rows(out)}, err

    def refused(self, text, *sayings, words=()):
        got, out, err = run("solve", "--batch", self.write(text), *words)
        self.assertEqual((got, out), (3, ""), err)
        for saying in sayings:
            self.assertIn(saying, err)

    def test_rows_are_scenes(self):
        """Thirty blocks at random: the row is what `solve --csv` says of a scene file with its numbers, and with the rows in
        another order, or by another number of threads, the table is the same."""
        random.seed(33)
        table, scenes = [], {}
        for k in range(30):
            own = {"width": random.randint(2, 40) / 10, "height": random.randint(2, 40) / 10, "dip": random.randint(2, 50),
                   "friction": random.randint(20, 50), "water": random.choice((0, 0.1, 0.2)), "shaking": random.choice((0, 0.1)),
                   "cohesion": random.choice((0, 5)), "required": random.choice((1.1, 1.3, 1.5))}
            scenes[f"B{k}"] = own
            table.append(",".join([f"B{k}", *map(str, own.values())]))
        head = "name,width (m),height (m),dip (deg),friction (deg),water (m),k_h,cohesion (kPa),required_fos,unit weight (kN/m3)\n"
        table = [row + ",26" for row in table]
        status, text, _ = run("solve", "--batch", "--csv", self.write(head + "\n".join(table) + "\n"))
        found = rows(text)
        self.assertIn(status, (0, 1))
        self.assertEqual(len(found), 30)
        for row in found:
            alone = rows(run("solve", "--csv", self.write(SCENE.format(unit="m", **scenes[row["name"]]), "alone.yaml"))[1])
            self.assertEqual(len(alone), 1)
            for key in SHARED:
                self.assertEqual(row[key], alone[0][key], (row["name"], key))
        random.shuffle(table)
        shuffled = self.write(head + "\n".join(table) + "\n")
        for threads in (1, 2, 5):
            again = rows(run("solve", "--batch", "--csv", shuffled, "--threads", threads)[1])
            self.assertEqual([{**row, "line": ""} for row in again], [{**row, "line": ""} for row in found])

    def test_closed_forms(self):
        """Slabs without loads: the lesser of tan φ / tan β and w cos β / (h sin β), or below 1 the one that fails first; margin
        the lesser of φ and atan(w/h), less β. In feet, in centimetres with a scene in metres, and by fractions they are the same."""
        cases = [(1, 2, 20, 30), (3, 1, 25, 40), (1, 1, 30, 35), (2, 3, 10, 50)]
        for unit, scale in (("m", 1), ("ft", 0.3048), ("cm", 100)):
            text = f"name,width ({unit}),height ({unit}),dip (deg),friction (deg)\n"
            text += "".join(f"{k},{w * scale!r},{h * scale!r},{b},{p}\n" for k, (w, h, b, p) in enumerate(cases))
            template = ["--template", self.write(TEMPLATE.replace("required_fos: 1.2\n", ""), "t.yaml")] if unit == "cm" else []
            found, _ = self.batch(self.write(text), *template)
            for k, (w, h, b, p) in enumerate(cases):
                tan = math.tan(math.radians(b))
                row = found[str(k)]
                self.assertAlmostEqual(float(row["fos"]), min(math.tan(math.radians(p)) / tan, w / h / tan), delta=1e-9)
                self.assertAlmostEqual(float(row["margin_deg"]), min(p, math.degrees(math.atan2(w, h))) - b, delta=1e-9)
                self.assertEqual(float(row["dip_deg"]), b)

    def test_worst_first(self):
        """What fails, what was not solved, what holds; each by the factor over that required; ties by name."""
        head = "name,width (m),height (m),dip (deg),friction (deg),required_fos\n"
        blocks = ["holds_well,3,1,10,40,1.3", "b_tie,3,1,20,40,1.3", "a_tie,3,1,20,40,1.3", "topples,1,3,25,40,1", "wrong,1,x,25,40,1",
                  "short,3,1,30,40,1.5", "flat,3,1,0,40,1.3"]
        found, err = self.batch(self.write(head + "\n".join(blocks) + "\n"), status=3)
        self.assertEqual(list(found), ["topples", "short", "wrong", "a_tie", "b_tie", "holds_well", "flat"])
        self.assertEqual([row["standing"] for row in found.values()],
                         ["fails", "below required", "not solved"] + ["holds"] * 4)
        self.assertEqual((found["flat"]["fos"], found["flat"]["fos_is"]), ("", "unbounded"))
        self.assertIn("2 of 7 blocks do not have the factor of safety that is required", err)

    def test_without_a_requirement(self):
        """A block that slides fails, and the exit status is 0: no factor was asked for."""
        found, _ = self.batch(self.write("name;width_m;height_m;dip;phi\nslides;3;1;30;20\n"))
        self.assertEqual((found["slides"]["standing"], found["slides"]["verdict"]), ("fails", "slides"))

    def test_load_cases(self):
        """A block over a scene with load cases is told of by the case that governs: of all of them, each solved alone by
        `--case`, the one of the greatest required/FoS among those that miss it, else among all. A column names one case."""
        cases = ("cases:\n- {name: static, required_fos: 1.5}\n- {name: wet, required_fos: 1.3, loads: {water: {height: 0.4, "
                 "uplift: true}}}\n- {name: shaken, required_fos: 1.1, loads: {seismic: {horizontal: 0.12}}}\n"
                 "- {name: weak, set: {friction_angle_deg: 27}}\n- {name: code, partial_factors: DA1-2}\n")
        text = TEMPLATE + "friction_angle_deg: 35\n" + cases
        template = self.write(text, "template.yaml")
        names = ["static", "wet", "shaken", "weak", "code"]
        random.seed(7)
        blocks = {f"B{k}": (random.randint(5, 40) / 10, random.randint(5, 25) / 10, random.randint(8, 30)) for k in range(12)}
        head = "name,width (m),height (m),dip (deg),case\n"
        all_cases = self.write(head + "".join(f"{name},{w},{h},{dip},\n" for name, (w, h, dip) in blocks.items()))
        status, out, err = run("solve", "--batch", "--csv", all_cases, "--template", template)
        self.assertIn(status, (0, 1), err)
        found = {row["name"]: row for row in rows(out)}
        self.assertGreater(len({row["load_case"] for row in found.values()}), 2, "several cases govern")
        for name, (w, h, dip) in blocks.items():
            own = text.replace("width: 1, height: 1", f"width: {w}, height: {h}")
            own = own.replace("cases:", f"slope: {{dip_deg: {dip}, towards: right}}\ncases:")
            alone = {}
            for case in names:
                got = rows(run("solve", "--csv", "--case", case, self.write(own, "alone.yaml"))[1])[0]
                alone[case] = got
                one = self.write(head + f"{name},{w},{h},{dip},{case}\n", "one.csv")
                single = rows(run("solve", "--batch", "--csv", one, "--template", template)[1])[0]
                self.assertEqual([single[key] for key in SHARED], [got[key] for key in SHARED], (name, case))
                self.assertEqual(single["load_case"], case)
            needs = {case: (float(got["fos"]) < float(got["required_fos"] or 1), float(got["required_fos"] or 1) / float(got["fos"]))
                     for case, got in alone.items()}
            governing = max(needs, key=needs.get)
            row = found[name]
            self.assertEqual(row["load_case"], governing, (name, needs))
            self.assertEqual([row[key] for key in SHARED], [alone[governing][key] for key in SHARED])
            moves = float(row["fos"]) < 1 and governing != "code"
            self.assertEqual(row["standing"], "fails" if moves else "below required" if needs[governing][0] else "holds")
            self.assertAlmostEqual(float(row["design_utilisation"]), needs[governing][1], delta=1e-9)
        printed = run("solve", "--batch", all_cases, "--template", template)[1]
        self.assertIn("required/FoS  case", printed)
        page = self.folder / "page.html"
        run("solve", "--batch", all_cases, "--template", template, "--output", page, "--figures", self.folder / "drawn")
        self.assertEqual(len(list((self.folder / "drawn").iterdir())), len(blocks))
        self.assertIn(", case ", page.read_text(encoding="utf-8"))

    def test_load_cases_that_are_wrong(self):
        """A case that the scene does not have, a case where it has none, and one that cannot be solved name themselves."""
        bad = TEMPLATE + "friction_angle_deg: 35\ncases:\n- {name: dry}\n- {name: wet, loads: {water: {height: -1}}}\n"
        template = self.write(bad, "template.yaml")
        table = self.write("name,width (m),height (m),dip (deg),case\na,3,1,20,dry\nb,3,1,20,damp\nc,3,1,20,\n")
        found, err = self.batch(table, "--template", template, status=3)
        self.assertEqual((found["a"]["standing"], found["a"]["load_case"]), ("holds", "dry"))
        self.assertIn("survey.csv:3: block 'b': ", err)
        self.assertIn("no case 'damp'; its cases are dry, wet", err)
        self.assertRegex(err, r"survey\.csv:4: block 'c': case 'wet': .*template\.yaml:8:\d+: .*height")
        found, err = self.batch(self.write("name,width (m),height (m),dip (deg),friction (deg),case\na,3,1,20,35,wet\n"), status=3)
        self.assertIn("the scene has no cases, so none of the name 'wet'", err)

    def test_template_and_outlines(self):
        """Cells go over a scene; an outline takes the place of its slab; a row's own scene that of all. Empty cells leave the
        number of the scene."""
        self.write("0,0\n2,0\n2,1\n0,1\n", "two_by_one.csv")
        self.write("topple: 1\nlength_unit: m\nblock: {slab: {width: 4, height: 1}}\nslope: {dip_deg: 5, towards: left}\n"
                   "friction_angle_deg: 20\n", "other.yaml")
        template = self.write(TEMPLATE + "friction_angle_deg: 35\nslope: {dip_deg: 25, towards: left}\n", "template.yaml")
        table = self.write("name,outline,scene,width,dip (deg)\ntwo,two_by_one.csv,,,\nwide,,,2,\nown,,other.yaml,,12\n")
        found, _ = self.batch(table, "--template", template)
        self.assertEqual(found["two"]["fos"], found["wide"]["fos"])
        self.assertEqual(found["two"]["required_fos"], "1.2")
        self.assertEqual((found["own"]["required_fos"], found["own"]["dip_deg"]), ("", "12"))
        elsewhere = self.folder / "elsewhere"
        elsewhere.mkdir()
        moved = elsewhere / "template.yaml"
        moved.write_text(template.read_text(encoding="utf-8"), encoding="utf-8")
        self.assertEqual(self.batch(table, "--template", moved)[0], found)

    def test_drawing(self):
        """A drawing gives the block; its unit is told by a key."""
        (self.folder / "block.wkt").write_text("POLYGON ((0 0, 2000 0, 2000 1000, 0 1000, 0 0))\n", encoding="utf-8")
        table = self.write("name,outline,drawing.unit,dip,towards,friction\na,block.wkt,mm,20,left,40\n")
        found, _ = self.batch(table)
        self.assertAlmostEqual(float(found["a"]["fos"]), math.tan(math.radians(40)) / math.tan(math.radians(20)), delta=1e-9)

    def test_rows_that_are_wrong(self):
        """Each says file, line and cell, block and column, and what to do."""
        head = "name,width (m),height (m),dip (deg),friction (deg),outline,scene\n"
        cases = [("n,-1,2,20,30,,", "column 'width (m)'"), ("n,1,,20,30,,", "height"), ("n,1,2,95,30,,", "column 'dip (deg)'"),
                 ("n,1,2,20,30°,,", "column 'friction (deg)'"), ("n,1,2,20,,,", "give a column friction"),
                 ("n,1,2,,30,,", "give a column dip"), ("n,,,20,30,gone.csv,", "gone.csv"), ("n,1,2,20,30,,gone.yaml", "gone.yaml"),
                 ("n,1,2,20,30,,gone.dxf", "column outline"), ('n,"1,5",2,20,30,,', "comma for its decimal point"),
                 ("n,1,2,20,30,,,more", "stands below no name")]
        text = head + "good,3,1,20,40,,\n" + "".join(row.replace("n,", f"n{k},", 1) + "\n" for k, (row, _) in enumerate(cases))
        found, err = self.batch(self.write(text), status=3)
        self.assertEqual(found["good"]["standing"], "holds")
        for k, (row, saying) in enumerate(cases):
            own = found[f"n{k}"]
            self.assertEqual(own["standing"], "not solved", row)
            self.assertRegex(own["remark"], f"survey.csv:{k + 3}(:\\d)?: block 'n{k}': ")
            self.assertIn(saying, own["remark"], row)
            self.assertIn(own["remark"], err)

    def test_faults_once(self):
        """Text in columns of numbers is told with its place and what stands there; what is wrong with many rows alike is told once,
        with their lines; all that is wrong with a row is."""
        head = "name,width (m),height (m),dip (deg),friction (deg),loads.cohesion_kpa\n"
        table = self.write(head + "a,1,n/a,20,35,\nb,1,2,20,35,\nc,1,?,20,35,\nd,x,ca. 3,95,-1,\ne,1,n/a,20,35,\nf,1,2 m,,,\n")
        status, out, err = run("solve", "--batch", "--json", table)
        self.assertEqual(status, 3, err)
        told = json.loads(out)
        said = [(own["line"], own["column"], own["rows"]) for own in told["faults"]]
        self.assertEqual(said, [(2, 3, 5), (5, 2, 1), (5, 4, 1), (5, 5, 1), (7, 0, 1), (7, 0, 1)])
        first = told["faults"][0]["text"]
        self.assertIn("survey.csv:2:3: block 'a': column 'height (m)': 'n/a' is not a number; write digits alone", first)
        self.assertTrue(first.endswith("; likewise in lines 4 ('?'), 5 ('ca. 3'), 6 and 7 ('2 m')"), first)
        self.assertEqual([line.split(": ", 1)[1] for line in err.splitlines()], [own["text"] for own in told["faults"]])
        remarks = {row["name"]: row["remark"] for row in told["rows"] if "remark" in row}
        for part in ("column 'width (m)': 'x' is not", "; column 'height (m)': 'ca. 3' is not", "; column 'dip (deg)': '95' is out of range: dip_deg must lie",
                     "; column 'friction (deg)': '-1' is out of range: friction_angle_deg must lie"):
            self.assertIn(part, remarks["d"])
        for part in ("'2 m' is not a number", "give a column dip (deg)", "give a column friction (deg)"):
            self.assertIn(part, remarks["f"])
        light = self.write(head + "a,1,2,20,35,5\n", "light.csv")
        self.assertIn("give its 'unit_weight_kn_m3', in a column 'unit weight (kN/m3)'", run("solve", "--batch", light)[2])
        heavy = self.write(head.replace("name", "name,unit weight (kN/m3)") + "a,26,1,2,20,35,5\n", "heavy.csv")
        self.assertEqual(run("solve", "--batch", heavy)[0], 0)
        page = self.folder / "faults.html"
        run("solve", "--batch", table, "--output", page)
        self.assertEqual(page.read_text(encoding="utf-8").count("is not a number"), 2)
        many = self.write(head + "".join(f"n{k},1,no {k},20,35,\n" for k in range(40)), "many.csv")
        err = run("solve", "--batch", many)[2]
        self.assertEqual(err.count("is not a number"), 1)
        self.assertIn("12 ('no 10') and 29 more", err)

    def test_fields_are_data(self):
        """`30/120` is a dip and its direction: evaluated, it was a dip of 0.25 degrees, at which every block holds. Nothing is
        calculated in a table: no quotient, range, formula or parameter, in columns of numbers and of words alike."""
        template = self.write("topple: 1\nlength_unit: m\nparameters: {h: 2, phi: 35}\nblock: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\n"
                              "slope: {dip_deg: 20, towards: left}\nfriction_angle_deg: phi\n", "template.yaml")
        for head, cell, saying in (("dip", "30/120", "is two numbers"), ("slope.dip_deg", "45/310", "is two numbers"),
                                   ("friction", "35/2", "is two numbers"), ("friction", "35-28", "is a range"), ("phi", "35 - 28", "is a range"),
                                   ("phi", "28..35", "is a range"), ("phi", "28 to 35", "is a range"), ("phi", "28\u201335", "is a range"),
                                   ("width", "2*h", "names a parameter"), ("width", "h", "names a parameter"), ("width", "1/3", "is two numbers"),
                                   ("width", "(3)", "is not a number"), ("width", "2^2", "is not a number"), ("width", "1+1", "is not a number"),
                                   ("parameters.h", "3*2", "is not a number"), ("required_fos", "3/2", "is two numbers"),
                                   ("columns.width", "3*2", "is a formula"), ("columns.width", "h", "is a formula"),
                                   ("columns.width", "2*h", "is a formula"), ("cases.1.friction_angle_deg", "30/2", "is two numbers")):
            table = self.write(f"name,{head}\nC,{cell}\n")
            found, err = self.batch(table, "--template", template, status=3)
            self.assertEqual(found["C"]["standing"], "not solved", (head, cell))
            self.assertIn(f"survey.csv:2:2: block 'C': column '{head}': '{cell}' {saying}", err)
            self.assertEqual("name the column 'dip/dip direction'" in err, "dip" in head)
        found, _ = self.batch(self.write("name,width,height,dip\nC,2e0,+1.0,30\n"), "--template", template)
        self.assertAlmostEqual(float(found["C"]["fos"]), math.tan(math.radians(35)) / math.tan(math.radians(30)), delta=1e-9)

    def test_dip_and_direction(self):
        """A column that declares both has both: of 30/120 and 45/310 at 35 degrees of friction the factors are
        tan 35/tan 30 = 1.213 and tan 35/tan 45 = 0.700."""
        template = self.write("topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 1}, unit_weight_kn_m3: 26}\n"
                              "slope: {dip_deg: 20, towards: left}\nfriction_angle_deg: 35\n", "template.yaml")
        tangent = math.tan(math.radians(35))
        for head, *cells in (("dip/dip direction", "30/120", "45/310"), ("Dip/DipDir", "30 / 120", "045/310"), ("dip / dip_direction (deg)", "30/120", "45/310"),
                             ("Dip/Dip-Dir (\u00b0/\u00b0)", "30.0/120", "45/0"), ("dip direction/dip", "120/30", "310/45"), ("DipDir/Dip", "120/30", "005/45")):
            found, _ = self.batch(self.write(f"name,width,height,{head}\nC,2,1,{cells[0]}\nD,2,1,{cells[1]}\n"), "--template", template)
            for name, dip, standing in (("C", 30, "holds"), ("D", 45, "fails")):
                self.assertEqual(found[name]["standing"], standing, head)
                self.assertEqual(float(found[name]["dip_deg"]), dip)
                self.assertAlmostEqual(float(found[name]["fos"]), tangent / math.tan(math.radians(dip)), delta=1e-9)
        for cell, saying in (("30", "as 30/120"), ("35-28", "as 30/120"), ("30/", "as 30/120"), ("30/120/2", "as 30/120"), ("95/120", "dip_deg must lie"),
                             ("30/400", "dip_direction_deg must lie")):
            _, err = self.batch(self.write(f"name,dip/dip direction\nC,{cell}\n"), "--template", template, status=3)
            self.assertIn("survey.csv:2:2: block 'C': column 'dip/dip direction': ", err)
            self.assertIn(saying, err)
        for other in ("dip", "slope.dip_direction_deg", "dip direction"):
            self.refused(f"name,dip/dip direction,{other}\nC,30/120,30\n", "an earlier column says the same")
            self.refused(f"name,{other},dip/dip direction\nC,30,30/120\n", "an earlier column says the same")

    def test_tables_that_are_wrong(self):
        """A head that is wrong is refused before work begins."""
        self.refused("", "the table is empty")
        self.refused("name,width (m)\n", "no row below it")
        self.refused("name,widht (m)\na,1\n", "survey.csv:1: column 2, 'widht (m)'", "did you mean 'width'")
        self.refused("name,width (kPa)\na,1\n", "its unit is mm, cm, m, km, in or ft")
        self.refused("name,friction (rad)\na,1\n", "it is given in deg")
        self.refused("name,k_h (m)\na,1\n", "without a unit")
        self.refused("name,width (m),block.slab.width\na,1,2\n", "an earlier column says the same")
        self.refused('name,width (m)\n"a,1\n', "a quote that is not closed")
        self.refused('name,width (m)\n"a"b,1\n', "behind the closing quote")
        self.refused(",".join(["notes"] * 300) + "\na\n", "256 cells")
        got, _, err = run("solve", "--batch", self.folder / "gone.csv")
        self.assertEqual(got, 5, err)

    def test_unit_is_asked_for(self):
        found, _ = self.batch(self.write("name,width,height,dip,friction\na,1,2,20,30\n"), status=3)
        self.assertIn("write it in the head, as height (m)", found["a"]["remark"])

    def test_encodings(self):
        """UTF-16 as spreadsheets save it, tabs, quotes with separators and line ends in them, comments."""
        text = 'name\twidth (m)\theight (m)\tdip (deg)\tfriction (deg)\n# a comment\n"Bl\u00f6ck\t""7""\nupper"\t3\t1\t20\t40\n'
        found, _ = self.batch(self.write(text, encoding="utf-16"))
        self.assertEqual(len(found), 1)
        self.assertIn("Bl\u00f6ck", next(iter(found)))

    def test_written(self):
        """Files appear, each as its kind; the page escapes what comes from outside and asks for no other file; none of them
        takes the place of the table, and none appears where another option is wrong."""
        table = self.write('name,width (m),height (m),dip (deg),friction (deg)\n"<script>alert(1)</script>",3,1,20,40\n=1+1,1,3,25,40\n')
        names = [self.folder / f"out.{ending}" for ending in ("csv", "json", "md", "html")]
        words = [word for name in names for word in ("--output", name)]
        status, out, err = run("solve", "--batch", table, *words, "--figures", self.folder / "drawn")
        self.assertEqual(status, 0, err)
        self.assertIn("2 blocks: 1 fails, 1 holds.", out)
        page = names[3].read_text(encoding="utf-8")
        parsed = Page(page)
        self.assertNotIn("script", parsed.elements)
        self.assertEqual(parsed.elements.count("img"), 2)
        self.assertLess(len(page), 50000)
        drawn = [base64.b64decode(own).decode() for own in re.findall(r'src="data:image/svg\+xml;base64,([^"]*)"', page)]
        texts = ["".join(ET.fromstring(own).itertext()) for own in drawn]
        for part in ("<script>alert(1)</script>", "FoS 2.305 against sliding", "flat end"):
            self.assertIn(part, texts[1])
        self.assertIn("<script>alert(1)</script>", "".join(parsed.texts))
        self.assertNotIn("http://", page.replace("http://www.w3.org", ""))
        self.assertEqual(json.loads(names[1].read_text(encoding="utf-8"))["failing"], 1)
        found = rows(names[0].read_text(encoding="utf-8"))
        self.assertEqual(found[0]["name"], "'=1+1")
        self.assertEqual(sorted(path.name for path in (self.folder / "drawn").iterdir()),
                         ["2__script_alert_1___script_.svg", "3__1_1.svg"])
        status, _, err = run("solve", "--batch", table, "--output", table)
        self.assertEqual(status, 3, err)
        for wrong in (["--output", "x.txt"], ["--figure", "x.svg"], ["--set", "a=1"], ["--csv", "--json"], ["--threads", "0"]):
            self.assertEqual(run("solve", "--batch", table, *wrong)[0], 2, wrong)
        self.assertEqual(run("solve", "--output", "x.csv", SLOPE / "anchored_block.yaml")[0], 2)

    def workbook(self, cells, strings="", name="survey.xlsx", **parts):
        """A workbook of these cells of its first sheet; parts in place of its own, by their names without folder and ending."""
        path = self.folder / name
        own = {"xl/workbook.xml": WORKBOOK, "xl/_rels/workbook.xml.rels": RELATIONS, "xl/styles.xml": STYLES,
               "xl/sharedStrings.xml": f'<sst xmlns="{MAIN}">{strings}</sst>',
               "xl/worksheets/blocks.xml": f'<worksheet xmlns="{MAIN}"><sheetData>{cells}</sheetData></worksheet>'}
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            for part, text in own.items():
                text = parts.get(pathlib.PurePath(part).name.split(".")[0], text)
                if text is not None:
                    file.writestr(part, text)
        return path

    HEADS = "".join(f'<c r="{column}2" t="s"><v>{k}</v></c>' for k, column in enumerate("ABCDEFG"))
    STRINGS = "".join(f"<si><t>{name}</t></si>" for name in
                      ("name", "width (m)", "height (m)", "dip (deg)", "friction (deg)", "date", "notes"))

    def test_worksheets(self):
        """Shared, rich and inline texts, the saved value of a formula, doubles as spreadsheets store them, dates, cells that are
        missing: the same table as in CSV, each row at the number of its row in the sheet."""
        if not (pathlib.Path(PROGRAM).parent / "libtopple-xlsx.so").exists():
            self.skipTest("built without libzip and libxlsxwriter")
        strings = self.STRINGS + "<si><r><t>B</t></r><r><t>1</t></r><rPh><t>no</t></rPh></si>"
        cells = (f'<row r="2">{self.HEADS}</row><row r="4"><c r="A4" t="s"><v>7</v></c><c r="B4"><v>1.1000000000000001</v></c>'
                 '<c r="C4"><f>1+1</f><v>2</v></c><c r="D4"><v>20</v></c><c r="E4"><v>30</v></c><c r="F4" s="2"><v>46351</v></c>'
                 '<c r="G4" t="inlineStr"><is><t>=1+1 &amp; "more"</t></is></c></row>'
                 '<row r="6"><c r="A6" t="str"><v>late</v></c><c r="B6"><v>3</v></c><c r="C6"><v>1</v></c><c r="D6"><v>20</v></c>'
                 '<c r="E6" s="1"><v>45000</v></c></row>'
                 '<row r="7"><c r="A7" t="str"><v>days</v></c><c r="B7" s="3"><v>3</v></c><c r="C7"><v>1</v></c><c r="D7"><v>20</v></c>'
                 '<c r="E7"><v>40</v></c></row>')
        found, _ = self.batch(self.workbook(cells, strings), status=3)
        of_csv, _ = self.batch(self.write("name,width (m),height (m),dip,friction\n\n\nB1,1.1,2,20,30\n"))
        self.assertEqual(found["B1"], of_csv["B1"])
        self.assertEqual(found["B1"]["line"], "4")
        self.assertEqual(found["days"]["standing"], "holds")
        self.assertIn("survey.xlsx:6:5: block 'late': column 'friction (deg)'", found["late"]["remark"])
        self.assertIn("March", found["late"]["remark"])

    def test_hostile_workbooks(self):
        """A bomb, an entity, a document type, a text that there is not, parts that are missing or no XML: said, and nothing more."""
        if not (pathlib.Path(PROGRAM).parent / "libtopple-xlsx.so").exists():
            self.skipTest("built without libzip and libxlsxwriter")
        row = f'<row r="2">{self.HEADS}</row>'
        for k, (make, saying) in enumerate([
                (dict(cells=row, strings=" " * (100 << 20)), "unpacks to more"),
                (dict(cells=row, blocks='<!DOCTYPE a [<!ENTITY b SYSTEM "file:///etc/passwd">]><a>&b;</a>'), "document type"),
                (dict(cells='<row r="1"><c r="A1" t="s"><v>9</v></c></row>'), "text is not among"),
                (dict(cells=row, blocks=None), "is missing"), (dict(cells=row, blocks="<a>"), "is no XML"),
                (dict(cells=row, workbook="<a/>"), "has no worksheet"),
                (dict(cells='<row r="2"/><row r="1"/>'), "out of order"),
                (dict(cells='<row r="9999999"/>'), "a million rows"),
                (dict(cells='<row r="1"><c r="ZZZ1"><v>1</v></c></row>'), "256 cells")]):
            path = self.workbook(name=f"wrong{k}.xlsx", **make)
            status, out, err = run("solve", "--batch", path)
            self.assertEqual((status, out), (3, ""), err)
            self.assertIn(saying, err)
            self.assertIn(path.name, err)
        no_zip = self.write("no workbook", "no.xlsx")
        self.assertIn("no .xlsx workbook", run("solve", "--batch", no_zip)[2])
        self.assertEqual(run("solve", "--batch", self.folder / "gone.xlsx")[0], 5)

    def test_worksheet_written(self):
        """Names that look like formulas are texts; numbers are those of the CSV; the same bytes each time."""
        if not (pathlib.Path(PROGRAM).parent / "libtopple-xlsx.so").exists():
            self.skipTest("built without libzip and libxlsxwriter")
        table = self.write("name,width (m),height (m),dip (deg),friction (deg)\n=1+1,3,1,20,40\n@x,1,3,25,40\n")
        paths = [self.folder / "one.xlsx", self.folder / "two.xlsx"]
        for path in paths:
            status, _, err = run("solve", "--batch", table, "--output", path)
            self.assertEqual(status, 0, err)
        self.assertEqual(paths[0].read_bytes(), paths[1].read_bytes())
        with zipfile.ZipFile(paths[0]) as file:
            sheet = ET.fromstring(file.read("xl/worksheets/sheet1.xml"))
            shared = ["".join(own.itertext()) for own in ET.fromstring(file.read("xl/sharedStrings.xml"))]
        self.assertEqual(list(sheet.iter(f"{{{MAIN}}}f")), [])
        cells = {own.get("r"): own for own in sheet.iter(f"{{{MAIN}}}c")}
        self.assertEqual([shared[int(cells[place][0].text)] for place in ("A2", "A3")], ["@x", "=1+1"])
        found, _ = self.batch(table)
        fos, written = float(found["'=1+1"]["fos"]), float(cells["C3"][0].text)
        self.assertTrue(0 <= fos - written < 1e-6, (fos, written))  # a factor of safety is rounded down
        self.assertEqual(run("solve", "--batch", table, "--output", self.folder / "missing" / "x.xlsx")[0], 5)

    def test_example(self):
        """What docs/batch.md shows."""
        status, out, err = run("solve", "--batch", "examples/slope/survey.csv", "--template", "examples/slope/survey_block.yaml",
                               folder=ROOT)
        self.assertEqual(status, 1, err)
        shown = (ROOT / "docs" / "batch.md").read_text(encoding="utf-8")
        self.assertIn(out.rstrip("\n"), shown)


if __name__ == "__main__":
    main()
