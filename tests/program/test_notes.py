# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Notes and cautions: what a report says beside its numbers about what the scene gives.

The story: a unit weight of 2600, the density in kg/m³, and a block of 2.5 km, millimetres read as
metres, went through without a word."""

import json
import pathlib
import re
import tempfile
import unittest

from harness import ROOT, example_scenes, main, run

SLAB = ("topple: 1\nlength_unit: {unit}\nblock: {{slab: {{width: {width}, height: {height}}}{more}}}\n"
        "base: {{mated: true}}\n")


#: What solve says of a base that shakes.
SHAKING = "the shaking of the base is not included in these results: 'topple tilt' simulates it"
UPLIFT = {"block_under_water.yaml": "heel (2, 0) m with 27.99 kPa, toe (0, 0) m with 0 kPa, 2 m long",
          "filled_crack.yaml": "heel (642314, 1207) m with 19.62 kPa, toe (642310, 1204) m with 9.81 kPa, 5 m long"}
TURNED_TO_REST = {"boulder_on_rough_ground.yaml": "-9.76", "scanned_boulder.yaml": "-11.82"}  # the degrees


class Notes(unittest.TestCase):
    def notes(self, text):
        """The notes in JSON; the page has the same words, on lines of 80 columns."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(text)
            status, out, err = run("solve", "--json", "scene.yaml", folder=folder)
            self.assertEqual((status, err), (0, ""))
            notes = json.loads(out)["notes"]
            page = run("solve", "scene.yaml", folder=folder)[1]
        at = re.search("^(Note|Caution) ", page, re.M)
        for line in page[at.start():].split("\n\n")[0].splitlines() if at else ():
            self.assertLessEqual(len(line), 80)
        words = " ".join(page.split())
        for note in notes:
            self.assertIn(f"{note['kind'].capitalize()} {note['text']} ({note['place']})", words)
        self.assertEqual(sum(line.startswith(("Note ", "Caution ")) for line in page.splitlines()), len(notes))
        return notes

    def slab(self, width="1", height="2", unit="m", more=""):
        return self.notes(SLAB.format(width=width, height=height, unit=unit, more=more))

    def test_unit_weights(self):
        """Density in kg/m³ or t/m³, or newtons or meganewtons, in place of kN/m³: the caution says what the number
        would be. 2600 x 9.81 / 1000 = 25.5. Rocks from pumice to galena pass in silence."""
        for given, unit, meant in (("2600", "kg/m³", "25.5"), ("2.6", "t/m³", "25.5"), ("26000", "N/m³", "26"),
                                   ("0.026", "MN/m³", "26")):
            notes = self.slab(more=f", unit_weight_kn_m3: {given}")
            self.assertEqual([(note["kind"], note["place"]) for note in notes], [("caution", "scene.yaml:3:57")])
            self.assertIn(f"{given} kN/m³ is far from any rock", notes[0]["text"])
            self.assertIn(f"if it is in {unit}, write {meant}", notes[0]["text"])
        for given in ("1e-20", "300", "1e20"):  # no unit makes a rock of it
            notes = self.slab(more=f", unit_weight_kn_m3: {given}")
            self.assertNotIn("if it is in", notes[0]["text"])
        for given in ("5", "25.8", "80"):
            self.assertEqual(self.slab(more=f", unit_weight_kn_m3: {given}"), [])

    def test_places_in_a_deep_folder(self):
        """Places of more than 255 bytes had lost the beginning of their path: that of a note, of what called for an
        effect, and of a load."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name, *("a folder of a long name, numbered " + str(k) for k in range(10)))
            folder.mkdir(parents=True)
            path = folder / "scene.yaml"
            self.assertGreater(len(str(path)), 340)
            path.write_text(SLAB.format(width=1, height=2, unit="m", more=", unit_weight_kn_m3: 2600")
                            + "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 20}\n"
                            "loads: {seismic: {horizontal: 0.1}}\n")
            out = json.loads(run("solve", "--json", path)[1])
            page = run("solve", path)[1]
            table = run("solve", "--table", path)[1]
            effects = run("solve", "--verbose", path)[1]
        places = [note["place"] for note in out["notes"]]
        places += [effect["called_for_by"] for effect in out["cases"][0]["effects"]]
        places += [load["called_for_by"] for load in out["cases"][0]["loads"]]
        self.assertGreater(len(places), 9)
        for place in places:
            self.assertTrue(place.startswith(f"{path}:"), place)
            self.assertRegex(place[len(str(path)):], r"^:\d+:\d+$")
        self.assertIn(f"({path}:3:57)", re.sub(r"\n +", " ", page))
        self.assertIn(f"for {path}:3:", effects)
        self.assertIn("scene.yaml:3:57", table)
        self.assertNotIn("…", page + effects + table)

    def test_unit_weights_of_parts(self):
        text = ("topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [2, 0], [2, 3], [0, 3]]\n  unit_weight_kn_m3: 26\n"
                "  parts: [{outline: [[0, 0], [1, 0], [1, 1]], unit_weight_kn_m3: 2700}]\nbase: {mated: true}\n")
        self.assertEqual([note["place"] for note in self.notes(text)], ["scene.yaml:6:66"])

    def test_lengths(self):
        """Beyond 300 m or below a centimetre, in every unit and form of outline; the bounds themselves pass."""
        for height, unit, said in (("2500", "m", "2.5 km"), ("301", "m", "301 m"), ("2.5", "km", "2.5 km"),
                                   ("9.9", "mm", "9.9 mm"), ("0.39", "in", "9.906 mm"), ("985", "ft", "300.2 m")):
            notes = self.slab(width=f"{height} / 2", height=height, unit=unit)
            self.assertEqual([(note["kind"], note["place"]) for note in notes], [("caution", "scene.yaml:3:8")])
            self.assertIn(f"the block measures {said}", notes[0]["text"])
            self.assertIn(f"'length_unit: {unit}'", notes[0]["text"])
        for height, unit in (("300", "m"), ("10", "mm"), ("0.3", "km"), ("1", "cm")):
            self.assertEqual(self.slab(width=f"{height} / 2", height=height, unit=unit), [])
        for block in ("outline: [[0, 0], [999, 0], [999, 1]]", "ellipse: {width: 999, height: 20, flat: 1}",
                      "teeth: {count: 333, width: 3, height: 2, depth: 1, left_end: valley}"):
            notes = self.notes(f"topple: 1\nlength_unit: m\nblock: {{{block}}}\nbase: {{mated: true}}\n")
            self.assertIn("the block measures 999 m", notes[0]["text"])
        notes = self.slab(more=", thickness: 2000")
        self.assertIn("the block's thickness is 2 km", notes[0]["text"])
        self.assertEqual(notes[0]["place"], "scene.yaml:3:49")

    def test_back_analysis(self):
        """A number that is found for a weight in kg/m³ bears the caution too, in text and in JSON."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(
                SLAB.format(width=1, height=2, unit="m", more=", unit_weight_kn_m3: 2600") + "tilt: {towards: left}\n")
            words = ("--find", "block.slab.width", "--for", "critical_angle=45", "scene.yaml")
            out = run("solve", *words, folder=folder)[1]
            notes = json.loads(run("solve", "--json", *words, folder=folder)[1])["notes"]
            self.assertIn("\n  2  (within", out)
            self.assertIn("Caution  2600 kN/m³ is far from any rock", out)
            self.assertEqual(len(notes), 1)

    def test_arcs_reach_beyond_their_ends(self):
        """A circle of 3.14 m on a flat of a nanometre is not small."""
        status, out, _ = run("solve", "--json", ROOT / "tests" / "hard" / "arc_of_all_but_1e_9.yaml")
        self.assertEqual((status, json.loads(out)["notes"]), (0, []))

    HEAVY = ("topple: 1\nlength_unit: m\ntitle: A *heavy* slab\nparameters: {b: 1}\n"
             "block: {slab: {width: b, height: 2}, unit_weight_kn_m3: 2600}\nbase: {mated: true}\n")

    def test_derivations(self):
        """Formulas come from the same scene: its caution is told behind them, as a comment in LaTeX and C, and in
        JSON as a note; a scene that calls for none has none."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(self.HEAVY)
            words = "2600 kN/m³ is far from any rock"
            (note,) = json.loads(run("derive", "--json", "scene.yaml", folder=folder)[1])["notes"]
            self.assertEqual((note["kind"], note["place"]), ("caution", "scene.yaml:5:57"))
            self.assertIn(words, note["text"])
            text = run("derive", "scene.yaml", folder=folder)[1]
            self.assertIn(f"Caution {note['text']} (scene.yaml:5:57)", " ".join(text.split()))
            self.assertGreater(text.index("Caution"), text.rindex("tan(alpha_crit) ="))
            for words, begin, end in ((["--latex"], "% caution: ", "(scene.yaml:5:57)"),
                                      (["--c"], "/* caution: ", "(scene.yaml:5:57) */")):
                last = run("derive", *words, "scene.yaml", folder=folder)[1].splitlines()[-1]
                self.assertTrue(last.startswith(begin) and last.endswith(end), last)
            (pathlib.Path(folder) / "scene.yaml").write_text(self.HEAVY.replace("2600", "26"))
            self.assertEqual(json.loads(run("derive", "--json", "scene.yaml", folder=folder)[1])["notes"], [])
            self.assertNotIn("Caution", run("derive", "scene.yaml", folder=folder)[1])

    def test_tables(self):
        """Below the table, by the name of the scene; not in CSV, which is for other programs."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "scene.yaml").write_text(self.HEAVY)
            plain = run("solve", "--table", ROOT / "examples" / "slab.yaml", folder=folder)[1]
            out = run("solve", "--table", ROOT / "examples" / "slab.yaml", "scene.yaml", folder=folder)[1]
            self.assertTrue(out.startswith(plain))
            self.assertNotIn("caution", plain)
            table, below = out.split("\n\n")
            self.assertTrue(all(line.startswith("|") for line in table.splitlines()))
            self.assertEqual(below.count("\n"), 1)
            self.assertTrue(below.startswith("- A \\*heavy\\* slab, caution: 2600 kN/m³ is far from any rock"), below)
            self.assertTrue(below.endswith("(scene.yaml:5:57)\n"), below)
            self.assertNotIn("far from", run("solve", "--csv", "scene.yaml", folder=folder)[1])

    def test_figures(self):
        """One line below the legend says that the report has cautions: the page is higher by it."""
        heights = []
        with tempfile.TemporaryDirectory() as folder:
            for weight in ("26", "2600"):
                (pathlib.Path(folder) / "scene.yaml").write_text(self.HEAVY.replace("2600", weight))
                status, _, err = run("solve", "--figure", "figure.svg", "scene.yaml", folder=folder)
                self.assertEqual((status, err), (0, ""))
                text = (pathlib.Path(folder) / "figure.svg").read_text(encoding="utf-8")
                heights.append(float(re.search(r'<svg[^>]* height="([0-9.]+)', text).group(1)))
        self.assertTrue(8 < heights[1] - heights[0] < 25, heights)

    def test_examples_have_none(self):
        for scene in example_scenes():
            with self.subTest(scene.name):
                notes = [note["text"] for note in json.loads(run("solve", "--json", scene)[1])["notes"]]
                shakes = "\nshaking:" in scene.read_text(encoding="utf-8")
                if "{mesh:" in scene.read_text(encoding="utf-8"):
                    notes = [note for note in notes if not note.startswith("the section of this mesh has ")]
                if scene.name == "hollow_block.yaml":
                    self.assertIn("cavities, which the block has for holes", notes.pop())
                if scene.name == "boulder.yaml":
                    self.assertIn("with the sole as it is drawn; with 46 of its facets, on asperities", notes.pop())
                    self.assertIn("towards the left", notes.pop())
                if scene.name == "filled_crack.yaml":
                    self.assertIn("the pressures of the water are taken as the block lies", notes.pop())
                if scene.name == "boulder_traced.yaml":
                    self.assertTrue(notes.pop().startswith("curves of the outline are chords, which leave them by"))
                if scene.name in UPLIFT:
                    self.assertEqual(notes.pop(), f"uplift: {UPLIFT[scene.name]}")
                if scene.name in TURNED_TO_REST:
                    self.assertEqual(notes.pop(), f"'place: rest' turned the block by {TURNED_TO_REST[scene.name]}°, and all results "
                                     "are of that pose: if it was surveyed in its place, check outline and profile, or say "
                                     "'contact: {within: …}' instead")
                self.assertEqual(notes, [SHAKING] if shakes else [])


if __name__ == "__main__":
    main()
