# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets in other languages.

The story: the sheet goes to an authority that reads Spanish or German. What its first two pages say is in that language, every
number is the one of the English sheet, and a language is a column of a table in which no phrase is missing."""

import base64
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from harness import ROOT, main, run
from report_case import Page, words

sys.path.insert(0, str(ROOT / "src" / "core" / "terms"))
import make_phrases

WORD = re.compile(r"[^\W\d_]{3,}")
#: Keys and commands in quotes and brackets, files with their places, options, hashes.
QUOTED = re.compile(r"'[^']*'|\S*\.(?:yaml|csv|svg|wkt|geojson|dxf|md|obj|stl|ply|at2)\S*|--\S+|topple \w+|[a-z]+(?:[._][a-z]+)+|\$\$.*|SHA-256 \S+|"
                    r"\b[0-9a-f]{16,}\b|[0-9a-f]{6,}…")
#: Names of programs and units, and what stands in formulas.
SAME = {"Topple", "UTC", "SHA", "kPa", "MPa", "GPa", "PGA", "PGV", "JRC", "mm²", "cm²", "FoS", "FoSel", "Mover", "Mstab", "αslide", "min", "sin", "cos", "tan", "arctan", "POLYGON"}
#: Sentences that no example has: short scenes, all but their first two lines.
SCENES = {
    "stands, topples, slides, interlocked": """
block: {outline: [[0, 0], [2, 0.8], [1.2, 4], [-0.8, 3.2]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [2, 0.8]]}
tilt: {angle_deg: 2}
frame: world""",
    "slides": """
block: {outline: [[0, 0], [2, 1.6], [1.2, 2.6], [-0.8, 1]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [2, 1.6]]}
friction_angle_deg: 32
frame: base""",
    "locked": """
block: {outline: [[0, 0], [1, -0.9], [2, 1.7], [3, 0.9], [3, 9], [-1, 9]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [3, 0.9]]}
friction_angle_deg: 32
frame: base""",
    "moments alone": """
block: {slab: {width: 2, height: 2}}
tilt: {angle_deg: 10, towards: both}""",
    "crushed": """
block: {outline: [[0, 0], [2, 0.8], [1.2, 4], [-0.8, 3.2]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [2, 0.8]]}
friction: {law: barton, residual_angle_deg: 24, jrc: 8, jcs_mpa: 0.01}
frame: world""",
    "water and a bolt": """
block: {outline: [[0, 0], [2, 0.8], [1.4, 4], [-0.8, 3.2]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [2, 0.8]]}
friction_angle_deg: 32
loads: {water: {height: 1, uplift: true, stays_level: true}, seismic: {horizontal: 0.1, vertical: 0.05},
  anchors: [{at: [1, 2], direction_deg: 80, force_kn: 3}], cohesion_kpa: 4}
frame: base""",
    "earthquakes": """
block: {slab: {width: 1.2, height: 2.2}, unit_weight_kn_m3: 26}
friction_angle_deg: 35
slope: {dip_deg: 5, towards: left, dip_direction_deg: 135}
loads: {seismic: {horizontal: 0.2, vertical: 0.1}, water: {height: 1, uplift: true}}""",
    "no strength holds it": """
block: {slab: {width: 2, height: 3}, unit_weight_kn_m3: 26}
friction_angle_deg: 30
slope: {dip_deg: 40, towards: right}
loads: {seismic: {horizontal: 0.1, vertical: 0.1}}
required_fos: 1.3""",
    "units": """
block: {slab: {width: 2, height: 2}, unit_weight_kn_m3: 2600}
friction_angle_deg: 0.5
tilt: {angle_deg: 0.5, towards: both}
loads: {cohesion_kpa: 2000}""",
    "columns that fall": """
columns: {width: 2, step: 1, rise: 4, fall: 1, below_crest: 3, above_crest: 1}
block: {unit_weight_kn_m3: 25}
friction_angle_deg: 20
slope: {dip_deg: 32, towards: right}
loads: {seismic: {horizontal: 0.1}, cohesion_kpa: 1, bond_kpa: 0.5}
joints: [{between: [column 1, column 2], friction_angle_deg: 10, cohesion_kpa: 0, tension_kpa: 0}]
required_fos: 1.3""",
    "columns without weight": """
columns: {width: 2, heights: [4, 5]}
friction_angle_deg: 20
tilt: {angle_deg: 3, towards: left}""",
    "windows": """
block: {outline: [[0, 0], [1, 0.7], [-2.5, 5.7], [-3.5, 5]], unit_weight_kn_m3: 26}
base: {between: [[0, 0], [1, 0.7]]}
friction_angle_deg: 32
frame: base""",
}
EXAMPLES = ("block_e_valley", "block_seismic", "block_under_water", "block_bonded", "block_a_worn", "boulder", "slab", "vault",
            "partial_contact", "block_with_hole", "slope/anchored_block", "block_a_peak", "resting_poses", "blocks/toppling_slope",
            "solids/wedge", "solids/shaken_wedge")
#: Symbols, units and names that no language changes.
COMMON = re.compile(r"\b(?:FoS|Moment|mm|cm|m|kN|N|G|A|W|P|C|Eq|A1|ft|in|α_s|α_w|k_v)\b")


def front(page):
    """The texts of pages 1 and 2 of a sheet, but for the title, the signatures' blanks and its pictures."""
    found, breaks = [], 0
    for element in page.root.iter():
        breaks += element.tag == "hr"
        if breaks == 2:
            break
        if element.tag in ("p", "h2", "h3", "caption", "th", "td", "figcaption") and words(element):
            found.append((element.tag, words(element)))
    return found


def numbers(text, comma):
    if comma:
        text = re.sub(r"(\d); ", r"\1, ", re.sub(r"(?<![A-Za-z])(\d+),(\d)", r"\1.\2", text))
    return re.findall(r"\d+(?:\.\d+)?", text)


class Languages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)
        rows = make_phrases.table()[1]
        cls.of_language = {code: {word for row in rows for word in WORD.findall(row[code])} for code in ("es", "de")}

    def sheet(self, scene, *more):
        status, _, err = run("solve", scene, "--report", self.path / "r.html", *more)
        self.assertIn(status, (0, 1), err)
        return Page((self.path / "r.html").read_text(encoding="utf-8"))

    def test_table(self):
        """Each phrase has every language, with the same arguments, and a table that lacks one is refused by the build."""
        codes, rows = make_phrases.table()
        longest = max(rows, key=lambda row: len(make_phrases.arguments(row["en"])))
        self.assertLessEqual(len(make_phrases.arguments(longest["en"])), 8, longest["en"])  # ARGUMENTS of translate.c: more never match
        self.assertEqual(codes, ["en", "es", "de"])
        self.assertGreater(len(rows), 100)
        self.assertEqual(make_phrases.arguments("%2$s of %1$zu"), ["zu", "s"])
        for wrong in ("%1$s of %s", "%1$s of %1$s", "%2$s"):
            with self.assertRaises(ValueError):
                make_phrases.arguments(wrong)

    def test_pages_are_translated(self):
        """No text of both pages is English but what has no words, or is from outside; every number is the same."""
        _, rows = make_phrases.table()
        compared = 0
        for name in EXAMPLES:
            scene = f"examples/{name}.yaml"
            english, names = front(self.sheet(scene)), self.outside(ROOT / scene)
            for code in ("es", "de"):
                same = {row["en"] for row in rows if row[code] == row["en"]}
                page = self.sheet(scene, "--language", code)
                self.assertEqual(page.all("html")[0].get("lang"), code)
                own = front(page)
                self.assertEqual([tag for tag, _ in own], [tag for tag, _ in english])
                for (_, one), (_, other) in zip(english, own):
                    with self.subTest(f"{name} {code}: {one[:60]}"):
                        self.assertEqual(numbers(one, False), numbers(other, True))
                        if re.search(r"[A-Za-z]{3}", COMMON.sub("", one)) and one not in same | names and "/" not in one:
                            self.assertNotEqual(one, other)
                            compared += 1
        self.assertGreater(compared, 500)

    def own_words(self, line, outside):
        """Those of a line that are not from outside: titles, names of cases, files, keys in quotes."""
        for name in sorted(outside, key=len, reverse=True):
            line = line.replace(name, "")
        return set(WORD.findall(QUOTED.sub("", line))) - SAME

    def lines(self, scene, code, command="solve"):
        """Of a whole sheet, but for the files at its end; with the words of its charts."""
        status, _, err = run(command, scene, "--report", self.path / "r.md", "--language", code)
        self.assertIn(status, (0, 1), err)
        text = (self.path / "r.md").read_text(encoding="utf-8")
        charts = (base64.b64decode(own).decode() for own in re.findall(r"\(data:image/svg\+xml;base64,([^)]*)\)", text))
        labels = [re.sub(r"<[^>]*>", "", own) for chart in charts for own in re.findall(r"(?s)<text.*?</text>", chart)]
        text = re.sub(r"\(data:[^)]*\)", "", text) + "\n" + "\n".join(labels)
        text = re.sub(r"\\(.)", r"\1", text)
        return [line for line in text.splitlines() if not line.startswith("    ")]

    def left_in_english(self, english, told, code, outside):
        """Lines with a word that the English sheet has too, and no phrase of the language."""
        of_english = self.own_words("\n".join(english), outside) - self.of_language[code]
        return {line for line in told if any(word in line for word in of_english) and self.own_words(line, outside) & of_english}

    def outside(self, scene):
        text = scene.read_text(encoding="utf-8")
        columns = {"ground", *(f"column {k}" for k in range(1, 20))} if re.search("(?m)^(?:columns|jointed_slope):", text) else set()
        return {str(ROOT)} | columns | set(re.findall(r"(?m)^(?:title|  - name): (.*)$", text)) | set(re.findall(r"\{name: ([^,}]*)", text))

    def test_no_english_is_left(self):
        """Of all examples, and of scenes whose sentences no example has, the whole sheet."""
        scenes = [own for folder in ("", "slope", "blocks", "solids") for own in (ROOT / "examples" / folder).glob("*.yaml")
                  if own.name not in ("balanced_rock_study.yaml", "scanned_rock.yaml")]
        for name, text in SCENES.items():
            scenes.append(self.path / f"{re.sub('[^a-z]', '_', name)}.yaml")
            scenes[-1].write_text("topple: 1\nlength_unit: m" + text + "\n", encoding="utf-8")
        for scene in sorted(scenes):
            english = self.lines(scene, "en")
            for code in ("es", "de"):
                told = self.lines(scene, code)
                left = self.left_in_english(english, told, code, self.outside(scene))
                self.assertEqual(left, set(), f"{scene.name} {code}")
                if code == "de":  # "dort kippt er um den Kipppunkt 1": the subject behind its verb
                    self.assertNotRegex("\n".join(told), r"Kipppunkt \d+(?:, \w[\w ]* bei \([^)]*\))? er\b|\bum \([^)]*\) er\b", scene.name)

    def test_studies_and_tilt_tests(self):
        """Their sheets, with what their charts say; decimals of the axes, too."""
        told = [("study", ROOT / f"examples/studies/{name}_study.yaml") for name in ("slab", "rough_base")]
        told += [("tilt", ROOT / f"examples/{name}.yaml") for name in ("tilt_locked_stress", "shaken_boulder")]
        told.append(("study", self.path / "rare.yaml"))
        told[-1][1].write_text(f"topple_study: 1\nscene: {ROOT}/examples/studies/slab.yaml\nsamples: 16\n"
                               "vary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}, block.slab.width: {uniform: {low: 1, high: 2}}}\n"
                               "sensitivity: {samples: 16}\nreliability: {quantity: limit_deg, subset: {samples: 100}}\n", encoding="utf-8")
        for command, scene in told:
            outside = self.outside(scene) | self.outside(ROOT / "examples/studies/slab.yaml")
            english = self.lines(scene, "en", command)
            for code in ("es", "de"):
                own = self.lines(scene, code, command)
                self.assertEqual(self.left_in_english(english, own, code, outside), set(), f"{scene.name} {code}")
                self.assertEqual(len(own), len(english))
                points = [line for line in own if re.search(r"(?<![\d.])\d+\.\d+(?![\d.])", QUOTED.sub("", line))]
                self.assertEqual(points, [], f"{scene.name} {code}")

    @unittest.skipIf(shutil.which("pdftotext") is None, "there is no pdftotext: install Debian's package poppler-utils")
    def test_figure(self):
        """Heading, sides and legend of the sketch, as the PDF has them on its first page."""
        shaken = self.path / "shaken.yaml"
        shaken.write_text((ROOT / "examples/slope/anchored_block.yaml").read_text(encoding="utf-8")
                          + "  seismic: {horizontal: 0.05, vertical: 0.02}\n", encoding="utf-8")
        for scene in sorted([*(ROOT / "examples" / "slope").glob("*.yaml"), *(ROOT / "examples" / "blocks").glob("[jw]*.yaml"), shaken, ROOT / "examples/block_e_wkt.yaml", ROOT / "examples/boulder.yaml"]):
            texts = {}
            for code in ("en", "es", "de"):
                status, _, err = run("solve", "--report", self.path / "f.pdf", "--language", code, scene)
                self.assertIn(status, (0, 1), err)
                told = subprocess.run(["pdftotext", "-layout", "-l", "1", self.path / "f.pdf", "-"], capture_output=True, check=True, encoding="utf-8")
                texts[code] = told.stdout.splitlines()
            for code in ("es", "de"):
                left = self.left_in_english(texts["en"], texts[code], code, self.outside(scene))
                self.assertEqual(left, set(), f"{scene.name} {code}")
                points = [line for line in texts[code] if re.search(r"\d\.\d", re.sub(r"Topple \S+", "", QUOTED.sub("", line)))]
                self.assertEqual(points, [], f"{scene.name} {code}")

    def test_unknown_stays(self):
        """What no phrase has is told as it is: names with words of the table in them, and numbers with a comma."""
        scene = self.path / "scene.yaml"
        scene.write_text((ROOT / "examples/slope/design_cases.yaml").read_text(encoding="utf-8").replace("- name: wet", "- name: the left end"),
                         encoding="utf-8")
        page = self.sheet(scene, "--language", "de")
        rows = page.tables("Lastfälle, der maßgebende zuerst")[0]
        self.assertEqual(rows[1][:2], ["the left end", "1,596"])

    def test_decimals(self):
        """A comma in Spanish and German, in equations too, unless the scene wants a point, and the other way round."""
        scene = self.path / "scene.yaml"
        text = (ROOT / "examples/block_e_valley.yaml").read_text(encoding="utf-8").replace("title:", "title: 'Version 1.5: a block'\n#")
        for report, comma in (("{language: es}", True), ("{language: es, decimal: point}", False), ("{decimal: comma}", True), ("{}", False)):
            scene.write_text(text + f"report: {report}\n", encoding="utf-8")
            page = self.sheet(scene)
            self.assertEqual(words(page.all("h1")[0]), "Version 1.5: a block")  # from outside: as it is
            facts = dict(page.tables("Inputs" if "es" not in report else "Datos de entrada")[0])
            section = facts.get("Section") or facts.get("Sección")
            self.assertIn("(44,966; 63,741)" if comma else "(44.966, 63.741)", section)
            equations = " ".join(words(element) for element in page.all("mn"))
            self.assertEqual(bool(re.search(r"\d,\d", equations)), comma)
            self.assertEqual(bool(re.search(r"\d\.\d", equations)), not comma)


if __name__ == "__main__":
    main()
