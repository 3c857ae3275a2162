# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""No input ends the program, keeps it waiting, fills the memory or costs a file.

The story: a dip of 1e-12 degrees was divided by zero, and FLINT aborts; `column: /dev/zero:x` filled the memory, and a pipe that
nobody writes to kept the program waiting; --restart wrote over a table whose first column was called 'sample'; a cell of a worksheet
with a text of 1 MiB, referenced 2998 times, took 1.5 GB; and the path of a block that topples went on to where it had moved by 1e10 m."""

import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest
import zipfile

from harness import PROGRAM, ROOT, main, reads, rounds, run
from swept_case import FOLDER, swept

SLAB = ("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 25}\nfriction_angle_deg: 30\n"
        "slope: {dip_deg: 20, towards: left}\n")
EQUAL_AREA = ("topple: 1\nlength_unit: m\nslope: {{dip_deg: {slope}, towards: left}}\nfriction_angle_deg: 38\n"
              "columns: {{width: 70, equal_area: {{face_dip_deg: {face}, height: 60, upper_dip_deg: {upper}, base_dip_deg: {base}}}}}\n")
JOINTED = ("topple: 1\nlength_unit: m\nblock: {{unit_weight_kn_m3: 26}}\nfriction_angle_deg: 35\ntilt: {{towards: left}}\njointed_slope:\n"
           "  face: {{dip_deg: {face}, height: 4}}\n  upper: {{dip_deg: {upper}}}\n  behind: 4\n  joints:\n"
           "    - {{name: f, dip_deg: {joint}, towards: right, spacing: 4}}\n    - {{name: c, dip_deg: {other}, towards: left, spacing: 6}}\n"
           "  base: {{dip_deg: {base}}}\n")
WEDGE = ("topple: 1\nlength_unit: m\nsolid:\n  unit_weight_kn_m3: 25\n  wedge:\n    height: 30\n"
         "    a: {{dip_deg: {a}, dip_direction_deg: {da}, friction_angle_deg: 20, cohesion_kpa: 24}}\n"
         "    b: {{dip_deg: {b}, dip_direction_deg: {db}, friction_angle_deg: 30, cohesion_kpa: 48}}\n"
         "    face: {{dip_deg: {face}, dip_direction_deg: {df}}}\n    upper: {{dip_deg: {upper}, dip_direction_deg: {du}}}\n")
DEGREES = ((EQUAL_AREA, {"slope": "30", "face": "56.6", "upper": "4", "base": "35.8"}),
           (JOINTED, {"face": "60", "upper": "5", "joint": "70", "other": "20", "base": "30"}),
           (WEDGE, {"a": "45", "da": "105", "b": "70", "db": "235", "face": "65", "df": "185", "upper": "12", "du": "195"}),
           (SLAB.replace("{", "{{").replace("}", "}}").replace("20", "{dip}").replace("deg: 30", "deg: {friction}"), {"dip": "20", "friction": "30"}))


class Folder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def ended(self, *words, memory=None, seconds=60):
        """Exit status and stderr, with a limit of memory and of computing; who waits longer waits for ever."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            if memory is not None:
                resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.folder, timeout=10 * seconds, stdin=subprocess.DEVNULL,
                              capture_output=True, encoding="utf-8", preexec_fn=limit, check=False)
        return done.returncode, done.stderr

    def refused(self, saying, *words, **limits):
        status, err = self.ended(*words, **limits)
        self.assertEqual(status, 3, (words, err))
        self.assertRegex(err, saying)


class Numbers(Folder):
    def test_rounded_directions(self):
        """Dips that differ by less than directions are rounded: refused, with the number that they stand at."""
        self.write("flat.yaml", EQUAL_AREA.format(slope=30, face=56.6, upper=35.799999999, base=35.8))
        self.refused(r"flat.yaml:5:82: the ground behind the crest must be flatter .* by more than 2e-8°", "solve", "flat.yaml")
        self.write("steep.yaml", EQUAL_AREA.format(slope=30, face="35.8+1e-9", upper=4, base=35.8))
        self.refused(r"steep.yaml:5:49: the face must be steeper .* by more than 2e-8°", "solve", "steep.yaml")
        self.write("face.yaml", JOINTED.format(face="1e-12", upper=0, joint=70, other=20, base=30))
        self.refused(r"face.yaml:7:19: the face is level to within 1e-8°", "solve", "face.yaml")

    def test_every_degree(self):
        """Each angle next to zero, to a right angle and to each other angle of its scene."""
        for text, angles in DEGREES:
            for key in angles:
                others = [f"{other}{sign}1e-9" for other in {*angles.values()} for sign in "+-"]
                values = [f"{sign}1e-{digits}" for digits in (12, 20, 100, 300) for sign in ("", "-")] + ["0", "90-1e-13", "90+1e-13", *others]
                for value in values[::rounds(3, 1)]:
                    self.write("s.yaml", text.format(**{**angles, key: value}))
                    status, err = self.ended("solve", "s.yaml")
                    self.assertIn(status, (0, 1, 3, 4), (key, value, err))
                    self.assertEqual(status == 3, re.search(r"s.yaml:\d+:\d+: ", err) is not None, (key, value, err))

    def test_drawn_points(self):
        """A transform, or a block of a drawing, that makes a point of an ellipse: how far its chords may leave it was divided by zero."""
        arc = '<path id="a" d="M10 10 L50 10 A 5 9 20 0 1 50 40 C 1 1 2 2 10 40 Z"/>'
        scene = "topple: 1\ndrawing: {file: d.svg, unit: mm, block: a}\nblock: {unit_weight_kn_m3: 26}\nbase: {mated: true}\ntilt: {towards: left}\n"
        self.write("s.yaml", scene)
        if not reads("svg"):
            self.skipTest("built without SVG")
        for transform in ("scale(0)", "scale(0 1)", "scale(1 0)", "matrix(0 0 0 0 1 1)", "scale(1e-300)", "scale(1e300)"):
            self.write("d.svg", f'<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><g transform="{transform}">{arc}</g></svg>')
            status, err = self.ended("solve", "s.yaml")
            self.assertIn(status, (0, 3, 4), (transform, err))

    def test_swept(self):
        """Scenes of every kind with one number that no scene has: an answer, or a refusal with its place."""
        for path, text in swept(3, 100):
            self.write(path.name, text)
            if not (self.folder / "box.obj").exists():
                (self.folder / "box.obj").write_bytes((FOLDER / "box.obj").read_bytes())
            status, err = self.ended("solve", path.name, seconds=600)
            self.assertIn(status, (0, 1, 3, 4), (err, text))
            if status == 3:
                self.assertIn(f"{path.name}:", err, text)

    def test_swept_by_one_process(self):
        """The scenes of one block each, all given to one process: each has a row, or a message with its name."""
        names = []
        for path, text in swept(20, 400):
            if re.search(r"\n(blocks|columns|jointed_slope|solid|cases):", text):
                continue
            names.append(self.write(f"{path.stem}_{len(names)}.yaml", text.replace("topple: 1\n", f"topple: 1\ntitle: n{len(names)}\n", 1)))
        done = subprocess.run([PROGRAM, "solve", "--csv", *names], cwd=self.folder, timeout=3600, capture_output=True, encoding="utf-8", check=False)
        self.assertIn(done.returncode, (0, 1, 3, 4), done.stderr[-500:])
        told = {row.partition(",")[0] for row in done.stdout.splitlines()[1:]}
        answered = [name for k, name in enumerate(names) if f"n{k}" in told]
        refused = [name for name in names if f"topple: {name}:" in done.stderr]
        self.assertEqual({*answered, *refused}, {*names})
        self.assertGreater(len(answered), len(names) / 10)

    def test_path_ends_at_its_collapse(self):
        """Towards its collapse the springs of a block let it go without bound: the last moment was at 1e10 m, and films and figures
        showed nothing. Now each moment is of a block that has moved by less than a tenth of its size, and the tilts at which it
        collapses are what they were: 28.7346 and 23.1981 degrees (docs/tilt_path.md)."""
        for name, critical in (("e_valley", 28.734553), ("f", 23.198073)):
            text = (ROOT / "examples" / f"tilt_block_{name}.yaml").read_text(encoding="utf-8")
            for protocol in ("ramp", "steps"):
                self.write("s.yaml", text.replace("engine: path", f"engine: path\n  protocol: {protocol}"))
                for moments in (20, 1200):
                    status, out, err = run("tilt", "--json", f"--moments={moments}", "s.yaml", folder=self.folder)
                    self.assertEqual((status, err), (0, ""))
                    for case in json.loads(out)["cases"]:
                        self.assertLess(case["critical_angle_deg"]["stands_at"], critical + 1e-6)
                        self.assertGreater(case["critical_angle_deg"]["lets_go_at"], critical - 1e-6)
                        self.assertGreater(len(case["moments"]), 0)
                        self.assertGreater(case["moments"][-1]["angle_deg"], critical - 0.25)
                        for moment in case["moments"]:
                            size = 0.2  # m, more than the extent of the block
                            self.assertLess(abs(moment["moved_x_m"]) + abs(moment["moved_y_m"]), size / 10)
                            self.assertLess(abs(moment["turned_deg"]), 10)


class Files(Folder):
    def test_devices_and_pipes(self):
        """What is no regular file is refused at once, wherever a path may be named, and without waiting for who opens the other end."""
        os.mkfifo(self.folder / "pipe")
        for name in ("record.csv", "record.at2", "points.csv", "mesh.obj", "drawing.wkt", "drawing.csv", "table.csv"):
            (self.folder / name).symlink_to("/dev/zero")
            (self.folder / f"piped_{name}").symlink_to("pipe")
        self.write("s.yaml", SLAB)
        study = "topple_study: 1\nscene: s.yaml\nvary: {{friction_angle_deg: {{column: '{}:x'}}}}\n"
        for kind in ("", "piped_"):
            for ending in ("csv", "at2"):
                self.write("shaken.yaml", SLAB.replace("slope: {dip_deg: 20, towards: left}", "tilt: {towards: left, angle_deg: 5}")
                           + f"shaking: {{horizontal: {{record: {{file: {kind}record.{ending}}}}}}}\n")
                self.refused("is not a regular file", "solve", "shaken.yaml")
            self.write("points.yaml", SLAB.replace("slab: {width: 1, height: 2}", f"outline: {kind}points.csv"))
            self.refused("is not a regular file", "solve", "points.yaml")
            self.write("mesh.yaml", f"topple: 1\nlength_unit: m\nsolid: {{file: {kind}mesh.obj, unit: m, bands: [0.01]}}\n")
            self.refused("is not a regular file", "solve", "mesh.yaml")
            for ending in ("wkt", "csv"):
                self.write("drawn.yaml", f"topple: 1\ndrawing: {{file: {kind}drawing.{ending}, unit: m}}\n")
                self.refused("is not a regular file", "solve", "drawn.yaml")
            for path in (f"{kind}table.csv",):
                self.refused("is not a regular file", "solve", "--batch", path)
                self.write("study.yaml", study.format(path))
                self.refused("is not a regular file", "study", "study.yaml", memory=1 << 30)
                self.write("study.yaml", study.format("s.yaml").replace("scene: s.yaml", f"scene: {path}"))
                self.refused("is not a regular file", "study", "study.yaml")
        self.write("study.yaml", study.format("/dev/zero"))
        self.refused("is not a regular file but a device", "study", "study.yaml", memory=1 << 30)
        for path in ("pipe", "/dev/zero", "/dev/stdin"):  # which is /dev/null here
            for command in ("solve", "study", "verify", "derive", "profile", "tilt"):
                self.refused("is not a regular file", command, path)
        table = self.write("blocks.csv", "name,width,height\na,1,2\n")
        self.assertNotEqual(self.ended("solve", "--batch", table, "--template", "pipe")[0], 0)

    def test_own_pipes(self):
        """Standard input and what a shell makes of <(…) are read as they were."""
        self.write("s.yaml", SLAB)
        straight = run("solve", "s.yaml", folder=self.folder)[1]
        for words in (f"cat s.yaml | {PROGRAM} solve /dev/stdin", f"{PROGRAM} solve /dev/stdin < s.yaml", f"{PROGRAM} solve <(cat s.yaml)",
                      f"{PROGRAM} solve <(sleep 0.3; cat s.yaml)"):
            done = subprocess.run(["bash", "-c", words], cwd=self.folder, timeout=600, capture_output=True, encoding="utf-8", check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), words)
            self.assertEqual(re.sub(r"[\d.]+ m?s", "", done.stdout), re.sub(r"[\d.]+ m?s", "", straight))

    def test_lines_have_a_bound(self):
        """A table without an end of line is no table: refused before it fills the memory."""
        self.write("s.yaml", SLAB)
        with open(self.folder / "long.csv", "wb") as file:
            file.truncate(1 << 31)  # a hole of zeros
        self.write("study.yaml", "topple_study: 1\nscene: s.yaml\nvary: {friction_angle_deg: {column: 'long.csv:x'}}\n")
        self.refused("long.csv:1:1: a line of more than 65535 bytes", "study", "study.yaml", memory=1 << 30)

    def test_restart_spares_tables_of_others(self):
        self.write("s.yaml", SLAB)
        self.write("study.yaml", "topple_study: 1\nscene: s.yaml\nsamples: 10\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 3}}}\n")
        for text in ("sample,my precious lab data\n1,2\n", "sample,", "sample,friction_angle_deg\n"):
            self.write("sample_lab.csv", text)
            self.refused("sample_lab.csv: this file is there, and is not the rows of a study", "study", "--restart", "--rows", "sample_lab.csv",
                         "study.yaml")
            self.assertEqual((self.folder / "sample_lab.csv").read_text(encoding="utf-8"), text)
        self.assertEqual(self.ended("study", "--rows", "rows.csv", "study.yaml"), (0, ""))
        rows = (self.folder / "rows.csv").read_bytes()
        self.assertEqual(self.ended("study", "--restart", "--rows", "rows.csv", "study.yaml"), (0, ""))
        (self.folder / "rows.csv.progress").unlink()
        self.assertEqual(self.ended("study", "--restart", "--rows", "rows.csv", "study.yaml"), (0, ""))
        self.assertEqual((self.folder / "rows.csv").read_bytes(), rows)

    def book(self, name, shared, cells):
        """A workbook with one text that cells share."""
        main_space = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
        relations = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
        row = "".join(f'<row r="{k + 1}"><c r="A{k + 1}" t="s"><v>0</v></c></row>' for k in range(cells))
        with zipfile.ZipFile(self.folder / name, "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr("xl/workbook.xml", f'<workbook {main_space} xmlns:r="{relations}"><sheets><sheet name="a" sheetId="1" r:id="r1"/></sheets></workbook>')
            file.writestr("xl/_rels/workbook.xml.rels", '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
                          f'<Relationship Id="r1" Type="{relations}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>')
            file.writestr("xl/worksheets/sheet1.xml", f"<worksheet {main_space}><sheetData>{row}</sheetData></worksheet>")
            file.writestr("xl/sharedStrings.xml", f"<sst {main_space}><si><t>{shared}</t></si></sst>")
        return name

    def test_cells_of_worksheets(self):
        """A spreadsheet holds 32 767 characters in a cell: a text of 1 MiB that 2998 cells share is none, and is refused with 256 MB."""
        status, err = self.ended("solve", "--batch", self.book("one.xlsx", "name", 1))
        if "built without" in err or "does not load" in err:
            self.skipTest("built without .xlsx")
        self.refused("a cell of more than 32 767 characters", "solve", "--batch", self.book("bomb.xlsx", "a" * (1 << 20), 2998), memory=1 << 28, seconds=10)
        self.refused("a cell of more than 32 767 characters", "solve", "--batch", self.book("long.xlsx", "ä" * 32768, 2))
        self.refused("no column is called so|name is too long", "solve", "--batch", self.book("longest.xlsx", "ä" * 32767, 2))
        self.refused("more than 256 MiB of text", "solve", "--batch", self.book("many.xlsx", "a" * 32000, 9000), seconds=30)


if __name__ == "__main__":
    main()
