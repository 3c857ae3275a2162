# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How one comes to a first scene: `topple examples` lists and writes those that come with the program, `topple new` begins
one from options or by five questions. What is written solves, and nothing that was there is lost."""

import json
import math
import os
import pathlib
import pty
import shutil
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, is_readable, main, reads, run, solve

EXAMPLES = ROOT / "examples"


def names():
    return [line for line in run("examples")[1].splitlines() if line and not line.startswith((" ", "'"))]


class Folder(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)

    def files(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*") if path.is_file())


class Examples(Folder):
    def test_list(self):
        """Every scene, study and list of claims of examples/ and the folders in it is listed, with its title."""
        status, out, err = run("examples")
        self.assertEqual((status, err), (0, ""))
        expected = [path.relative_to(EXAMPLES).with_suffix("") for path in [*EXAMPLES.glob("*.yaml"), *EXAMPLES.glob("*/*.yaml")]]
        self.assertEqual(sorted(names()), sorted(map(str, expected)))
        self.assertIn("boulder\n    A granite boulder on a rough foot\n", out)
        self.assertIn("Table 1\n    and Fig. 6\n", out)  # a sentence does not end in Fig.
        self.assertLessEqual(max(map(len, out.splitlines())), 80)

    def test_each_is_written_whole(self):
        """With all that it refers to: solved where it was written, a scene says what it says in its own folder."""
        count = 0
        for name in names():
            folder = self.folder / name.replace("/", "_")
            folder.mkdir()
            status, out, err = run("examples", name, folder=folder)
            self.assertEqual((status, err), (0, ""), name)
            written = folder / (name.split("/")[-1] + ".yaml")
            self.assertEqual(written.read_bytes(), (EXAMPLES / (name + ".yaml")).read_bytes())
            command = out.splitlines()[-1].split()[2]
            text = written.read_text(encoding="utf-8")
            self.assertEqual(command, "study" if "topple_study:" in text else "verify" if "topple_claims:" in text else
                             "tilt" if "\ntilt_test:" in text or "\nshaking:" in text else "solve")
            if command in ("solve", "tilt") and is_readable(EXAMPLES / (name + ".yaml")):
                count += 1
                ended = [run("solve", "--json", scene) for scene in (written, EXAMPLES / (name + ".yaml"))]
                self.assertEqual(ended[0][0], ended[1][0])
                self.assertIn(ended[0][0], (0, 1), name)  # 1: a required factor is not met
                here, there = (json.loads(out) for _, out, _ in ended)
                part = "bands" if "bands" in here else "cases"  # of a solid
                for one in here[part] + there[part]:
                    one.pop("effects", None)  # of many blocks there are none
                places = json.dumps(here[part]).replace(str(written), ""), json.dumps(there[part]).replace(
                    str(EXAMPLES / (name + ".yaml")), "")
                self.assertEqual(*places)
        self.assertGreater(count, 25)

    def test_what_a_study_needs(self):
        self.assertEqual(run("examples", "studies/slab_study", "-o", "own/first.yaml", folder=self.folder)[0], 0)
        self.assertEqual(self.files(), ["own/first.yaml", "own/slab.yaml"])
        self.assertEqual(run("study", "own/first.yaml", folder=self.folder)[0], 0)

    def test_nothing_is_overwritten(self):
        """A file in the way is kept, and nothing is written beside it; one of the same bytes is no obstacle."""
        for in_the_way in ("boulder.yaml", "boulder.csv"):
            (self.folder / in_the_way).write_text("mine")
            status, out, err = run("examples", "boulder", folder=self.folder)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(f"will not overwrite {in_the_way}: it already exists", err)
            self.assertEqual(self.files(), [in_the_way])
            self.assertEqual((self.folder / in_the_way).read_text(), "mine")
            (self.folder / in_the_way).unlink()
        shutil.copy(EXAMPLES / "boulder.csv", self.folder)
        status, out, _ = run("examples", "boulder", folder=self.folder)
        self.assertEqual(status, 0)
        self.assertIn("Left as it was: boulder.csv", out)

    def test_a_link_in_the_way(self):
        """One that leads nowhere is in the way too: what it leads to is not written."""
        (self.folder / "slab.yaml").symlink_to("elsewhere")
        self.assertEqual(run("examples", "slab", folder=self.folder)[0], 3)
        self.assertFalse((self.folder / "elsewhere").exists())

    def test_refused(self):
        for words, status, said in ((("slabb",), 3, "there is no example 'slabb'; 'topple examples' lists them"),
                                    (("../README.md",), 3, "there is no example"), (("-o", "x"), 2, "goes with the NAME"),
                                    (("slab", "boulder"), 2, "one example at a time"),
                                    (("slab", "-o", "/proc/none/x.yaml"), 5, "/proc/none")):
            got, out, err = run("examples", *words, folder=self.folder)
            self.assertEqual((got, out), (status, ""), err)
            self.assertIn(said, err)
        self.assertEqual(self.files(), [])

    def test_moved_program(self):
        """Installed, the examples lie in share/topple of the folder above the program; alone, it says where it looked."""
        program = self.folder / "bin" / "topple"
        program.parent.mkdir()
        shutil.copy(PROGRAM, program)
        done = subprocess.run([program, "examples"], capture_output=True, encoding="utf-8", check=False)
        if not done.stdout:
            self.assertEqual(done.returncode, 5)
            self.assertIn("share/topple/examples", done.stderr)
        own = self.folder / "share" / "topple" / "examples"
        own.mkdir(parents=True)
        (own / "mine.yaml").write_text("topple: 1\ntitle: \"Mine\x1b[31m\"\n")
        done = subprocess.run([program, "examples"], capture_output=True, encoding="utf-8", check=True)
        self.assertTrue(done.stdout.startswith("mine\n    Mine\\x1B[31m\n"), done.stdout)


class New(Folder):
    def begin(self, *words):
        return run("new", *words, folder=self.folder)

    def ask(self, *answers, words=()):
        """On a terminal, where each answer is a line; exit status and all that the terminal showed."""
        terminal, own = pty.openpty()
        with subprocess.Popen([PROGRAM, "new", *words], cwd=self.folder, stdin=own, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              encoding="utf-8") as program:
            os.close(own)
            os.write(terminal, "".join(answer + "\n" for answer in answers).encode() + b"\x04")
            shown = program.communicate(timeout=60)[0]
        os.close(terminal)
        return program.returncode, shown

    def test_slab(self):
        """Its verdict by hand: a slab of 2 by 4 topples at atan(2/4), and the tilt of 20 leaves the factor 0.5/tan 20."""
        status, out, err = self.begin("--slab", "2x4", "--friction", "35", "--tilt", "20", "--unit-weight", "26")
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(out, "Wrote scene.yaml\nNext: topple solve scene.yaml\n")
        for case in solve("scene.yaml", folder=self.folder)["cases"]:
            self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], math.degrees(math.atan(0.5)), 9)
            self.assertAlmostEqual(case["toppling"]["fos"]["value"], 0.5 / math.tan(math.radians(20)), 9)
            self.assertEqual(case["block"]["weight_n"]["value"], 8 * 26000)

    def test_what_is_not_known_is_not_assumed(self):
        """Without friction sliding is not judged, and no design factor is met; both sides are looked at."""
        self.begin("--slab", "1/2x3", "--unit", "ft", "--tilt", "2")
        cases = solve("scene.yaml", folder=self.folder)["cases"]
        self.assertEqual([case["towards"] for case in cases], ["left", "right"])
        self.assertNotIn("sliding", cases[0])
        self.assertEqual(run("solve", "--fail-below", "1.01", "scene.yaml", folder=self.folder)[0], 1)

    def test_outline_beside_the_scene_or_elsewhere(self):
        shutil.copy(EXAMPLES / "boulder.csv", self.folder / 'a "rock".csv')
        for output in ("one.yaml", "deep/two.yaml", str(self.folder / "three.yaml")):
            self.assertEqual(self.begin('a "rock".csv', "-o", output)[::2], (0, ""))
            self.assertGreater(solve(output, folder=self.folder)["cases"][0]["block"]["area_m2"]["value"], 1)

    def test_to_the_standard_output(self):
        status, out, err = self.begin("--slab", "2x4", "-o", "-", "--title", 'A "block": # {1}')
        self.assertEqual((status, err, self.files()), (0, "", []))
        (self.folder / "s.yaml").write_text(out)
        self.assertEqual(solve("s.yaml", folder=self.folder)["title"], 'A "block": # {1}')
        self.assertTrue(all("#" in line or ":" in line for line in out.splitlines()))

    def test_every_key_that_is_offered_is_one(self):
        """The scene with its offers taken, comment marks off, solves as well."""
        _, out, _ = self.begin("--slab", "2x4", "-o", "-")
        lines = []
        for line in out.splitlines():
            bare = line.strip()
            if bare.startswith("# ") and bare[2:].split(":")[0].strip() in (
                    "unit_weight_kn_m3", "thickness", "friction_angle_deg", "angle_deg", "loads", "water", "seismic"):
                line = line.replace("# ", "", 1)
            lines.append(line)
        text = "\n".join(lines)
        (self.folder / "s.yaml").write_text(text)
        (case, _) = solve("s.yaml", folder=self.folder)["cases"]
        self.assertIn("water", [effect["name"] for effect in case["effects"]], text)
        self.assertIn("sliding", case)
        shutil.copy(EXAMPLES / "boulder.csv", self.folder)
        _, out, _ = self.begin("boulder.csv", "-o", "-")
        (self.folder / "s.yaml").write_text(out.replace("# frame:", "frame:"))
        self.assertEqual(len(solve("s.yaml", folder=self.folder)["cases"]), 1)  # it tilts the way its base dips

    def test_questions(self):
        status, shown = self.ask("cm", "50 100", "26", "35", "20 left")
        self.assertEqual(status, 0, shown)
        (case,) = solve("scene.yaml", folder=self.folder)["cases"]
        (other,) = [own for own in solve(EXAMPLES / "slab.yaml")["cases"] if own["towards"] == "left"]
        self.assertEqual((case["towards"], case["toppling"]["critical_angle_deg"]), ("left", other["toppling"]["critical_angle_deg"]))

    def test_questions_are_asked_again(self):
        """A wrong answer is told what would be right; nothing at all is a default, where there is one."""
        status, shown = self.ask("yards", "", "wide", "2x4", "", "35,5", "35.5", "20 up", "")
        self.assertEqual(status, 0, shown)
        for said in ("the length unit is one of mm", "a block is its width and height", "no unit, no comma", "as 20 or 20 left"):
            self.assertIn(said, shown)
        text = (self.folder / "scene.yaml").read_text()
        self.assertIn("friction_angle_deg: 35.5", text)
        self.assertIn("towards: both", text)

    def test_answers_that_end(self):
        status, shown = self.ask("m", "2x4")
        self.assertEqual((status, self.files()), (3, []))
        self.assertIn("nothing is written", shown)

    DRAWINGS = {
        "section_arcs": ("section_arcs.dxf", "--friction=35", "--unit-weight=26", "--tilt=12"),
        "boulder_traced": ("boulder_traced.svg", "--friction=33", "--unit-weight=26.5", "--tilt=10", "--unit=m",
                           "--reference=scale_bar=1"),
        "block_with_seam": ("block_with_seam.geojson", "--friction=38", "--unit-weight=26", "--tilt=15", "--towards=left",
                            "--unit=m", "--part=SEAM=20"),
        "block_e_wkt": ("block_e_valley.wkt", "--friction=30", "--unit-weight=25.8", "--tilt=20", "--towards=left", "--unit=mm"),
    }

    def test_drawings(self):
        """Each drawing of examples/ has a scene written by hand beside it: one begun by options says the same of stability,
        to the last digit, and what became of the objects is told before. The drawing may lie elsewhere."""
        drawings = {name: given for name, given in self.DRAWINGS.items() if is_readable(EXAMPLES / given[0])}
        for name, (drawing, *options) in drawings.items():
            shutil.copy(EXAMPLES / drawing, self.folder)
            for file, output in ((drawing, name + ".yaml"), (EXAMPLES / drawing, "deep/" + name + ".yaml")):
                status, out, err = self.begin(str(file), *options, "-o", output)
                self.assertEqual((status, err), (0, ""), name)
                self.assertTrue(out.startswith("The drawing "), out)
                self.assertIn("  block\n", out)
                self.assertTrue(out.endswith(f"Wrote {output}\nNext: topple solve {output}\n"))
                begun, own = (solve(path, folder=self.folder)["cases"] for path in (output, EXAMPLES / (name + ".yaml")))
                self.assertEqual(len(begun), len(own))
                for one, other in zip(begun, own):
                    for key in ("towards", "pivots", "toppling", "mechanism"):
                        self.assertEqual(one[key], other[key], (name, key))
                    for key in ("kind", "critical_angle_deg"):
                        self.assertEqual(one["limit"].get(key), other["limit"].get(key), (name, key))
        self.assertIn("mated: true", (self.folder / "block_e_wkt.yaml").read_text())
        if "section_arcs" in drawings:
            self.assertNotIn("mated: true", (self.folder / "section_arcs.yaml").read_text())

    def test_layers_and_a_csv_with_names(self):
        """A CSV with a column of layers is a drawing, one of x and y alone an outline; layers go by other names where
        options say so. By hand: 2 by 3 topples at atan(2/3)."""
        (self.folder / "own.csv").write_text('layer,x,y\nrock A,0,0\nrock A,2,0\nrock A,2,3\nrock A,0,3\n'
                                             'rock A,0,0\nfloor,-1,0\nfloor,3,0\n')
        status, out, err = self.begin("own.csv", "--unit=m", "--block=rock A", "--base=floor", "-o", "one.yaml")
        self.assertEqual((status, err), (0, ""), out)
        for case in solve("one.yaml", folder=self.folder)["cases"]:
            self.assertAlmostEqual(case["toppling"]["critical_angle_deg"]["value"], math.degrees(math.atan(2 / 3)), 9)
            self.assertFalse(case["contact"]["mated"])
        shutil.copy(EXAMPLES / "boulder.csv", self.folder)
        self.assertEqual(self.begin("boulder.csv", "-o", "two.yaml")[1], "Wrote two.yaml\nNext: topple solve two.yaml\n")
        for words, status, said in ((("boulder.csv", "--base=floor"), 3, "and this is an outline"),
                                    (("own.csv", "--unit=m", "--block=floor"), 3, "own.csv"), (("--gap=1",), 2, "which drawing?"),
                                    (("own.csv", "--part=CLAY"), 2, "as CLAY=20"), (("own.csv", "--part==2"), 2, "as CLAY=20"),
                                    (("own.csv", "--reference=a=b"), 2, "as scale_bar=2"), (("own.csv", "--unit=m"), 3, "BLOCK")):
            got, out, err = self.begin(*words, "-o", "three.yaml")
            self.assertEqual((got, out), (status, ""), (words, err))
            self.assertIn(said, err, words)

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_a_drawing_asks(self):
        """On a terminal for what no drawing tells; an empty unit is that of the drawing."""
        shutil.copy(EXAMPLES / "section_arcs.dxf", self.folder)
        status, shown = self.ask("", "26", "35", "12 left", words=("section_arcs.dxf",))
        self.assertEqual(status, 0, shown)
        self.assertIn("4 of 4. Tilt of the base", shown)
        (case,) = solve("scene.yaml", folder=self.folder)["cases"]
        own = solve(EXAMPLES / "section_arcs.yaml")["cases"][0]
        self.assertEqual((case["towards"], case["limit"]["critical_angle_deg"]), (own["towards"], own["limit"]["critical_angle_deg"]))
        (self.folder / "scene.yaml").unlink()
        status, shown = self.ask("", "section_arcs.dxf", "", "", "")
        self.assertEqual(status, 0, shown)
        self.assertIn('file: "section_arcs.dxf"\n  # unit:', (self.folder / "scene.yaml").read_text())

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_every_key_offered_of_a_drawing_is_one(self):
        shutil.copy(EXAMPLES / "section_arcs.dxf", self.folder)
        _, out, _ = self.begin("section_arcs.dxf", "-o", "-")
        for marked, bare in (("  # unit: mm ", "  unit: m "), ("# block: ", "block: "), ("#   unit_w", "  unit_w"),
                             ("#   thickness", "  thickness"), ("# friction_angle", "friction_angle")):
            self.assertEqual(out.count(marked), 1, marked)
            out = out.replace(marked, bare)
        (self.folder / "s.yaml").write_text(out)
        cases = solve("s.yaml", folder=self.folder)["cases"]
        self.assertIn("sliding", cases[0])
        self.assertAlmostEqual(cases[0]["block"]["area_m2"]["value"], (2.4 * 2 + math.pi * 1.44 / 2), 6)

    def test_refused(self):
        (self.folder / "crossed.csv").write_text("0,0\n2,2\n2,0\n0,2\n")
        (self.folder / "there.yaml").write_text("mine")
        for words, status, said in (((), 2, "questions are asked only on a terminal"), (("--tilt", "3"), 2, "which block?"),
                                    (("--slab", "2*4"), 2, "as 2x4"), (("--slab", "2x4", "x.csv"), 2, "either a slab or"),
                                    (("--slab", "2x4", "--friction", "3O"), 2, "no unit, no comma, not '3O'"),
                                    (("--slab", "2x4", "--friction", "95"), 3, "scene.yaml:"), (("--slab", "0x4"), 3, "scene.yaml:"),
                                    (("none.csv",), 5, "none.csv"), (("crossed.csv",), 3, "crossed.csv"),
                                    (("--slab", "2x4", "-o", "there.yaml"), 3, "will not overwrite there.yaml"),
                                    (("--slab", "2x4", "--title", ""), 2, "--title"), (("--slab", "2x4", "--unit", "mi"), 2, "one of mm")):
            got, out, err = self.begin(*words)
            self.assertEqual((got, out), (status, ""), (words, err))
            self.assertIn(said, err, words)
        self.assertEqual(self.files(), ["crossed.csv", "there.yaml"])
        self.assertEqual((self.folder / "there.yaml").read_text(), "mine")


if __name__ == "__main__":
    main()
