# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets in other languages.

The story: the sheet goes to an authority that reads Spanish or German. What its first two pages say is in that language, every
number is the one of the English sheet, and a language is a column of a table in which no phrase is missing."""

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

#: Words that neither Spanish nor German has.
ENGLISH = re.compile(r"\b(?:the|of|and|is|with|which|from|that|this|its|it|for|by|are|where|below|above|not|up|than|any|or|each|does|dips|"
                     r"slides|topples|stands|governs|towards|weight|facet|never|always|blocked|length|area|given|left|right|end|friction|"
                     r"water|load|loads|bolts|force|against|sliding|toppling)\b", re.IGNORECASE)
#: Keys and commands in quotes and brackets, files with their places, options.
QUOTED = re.compile(r"'[^']*'|\S*\.(?:yaml|csv|svg|wkt|geojson|dxf|md)\S*|--\S+|topple \w+|[a-z]+_[a-z_]+")
EXAMPLES = ("block_e_valley", "block_seismic", "block_under_water", "block_bonded", "block_a_worn", "boulder", "slab", "vault",
            "partial_contact", "block_with_hole", "slope/anchored_block", "block_a_peak", "resting_poses")
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

    def sheet(self, scene, *more):
        status, _, err = run("solve", scene, "--report", self.path / "r.html", *more)
        self.assertIn(status, (0, 1), err)
        return Page((self.path / "r.html").read_text(encoding="utf-8"))

    def test_table(self):
        """Each phrase has every language, with the same arguments, and a table that lacks one is refused by the build."""
        codes, rows = make_phrases.table()
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
            english = front(self.sheet(scene))
            for code in ("es", "de"):
                same = {row["en"] for row in rows if row[code] == row["en"]}
                page = self.sheet(scene, "--language", code)
                self.assertEqual(page.all("html")[0].get("lang"), code)
                own = front(page)
                self.assertEqual([tag for tag, _ in own], [tag for tag, _ in english])
                for (_, one), (_, other) in zip(english, own):
                    with self.subTest(f"{name} {code}: {one[:60]}"):
                        self.assertEqual(numbers(one, False), numbers(other, True))
                        if re.search(r"[A-Za-z]{3}", COMMON.sub("", one)) and one not in same and "/" not in one:
                            self.assertNotEqual(one, other)
                            compared += 1
        self.assertGreater(compared, 500)

    def test_no_english_is_left(self):
        """Of all examples the whole sheet but what is from outside: files, titles, names of cases, keys in quotes. A sentence of which
        the table has no phrase has English words in it, which no other language has, and is found by them."""
        for scene in sorted([*(ROOT / "examples" / "slope").glob("*.yaml"), *(ROOT / f"examples/{name}.yaml" for name in EXAMPLES)]):
            outside = set(re.findall(r"(?m)^(?:title|  - name): (.*)$", scene.read_text(encoding="utf-8")))
            for code in ("es", "de"):
                page = self.sheet(scene, "--language", code)
                texts = {words(own) for own in page.all("p", "h2", "h3", "caption", "figcaption", "th", "td")}
                left = {text for text in texts if ENGLISH.search(QUOTED.sub("", text)) and not any(name in text for name in outside)}
                self.assertEqual(left, set(), f"{scene.name} {code}")

    @unittest.skipIf(shutil.which("pdftotext") is None, "there is no pdftotext: install Debian's package poppler-utils")
    def test_figure(self):
        """Heading, sides and legend of the sketch, as the PDF has them on its first page."""
        shaken = self.path / "shaken.yaml"
        shaken.write_text((ROOT / "examples/slope/anchored_block.yaml").read_text(encoding="utf-8")
                          + "  seismic: {horizontal: 0.05, vertical: 0.02}\n", encoding="utf-8")
        for scene in sorted([*(ROOT / "examples" / "slope").glob("*.yaml"), shaken, ROOT / "examples/block_e_valley.yaml", ROOT / "examples/boulder.yaml"]):
            outside = re.findall(r"(?m)^(?:title|  - name): (.*)$", scene.read_text(encoding="utf-8"))
            for code in ("es", "de"):
                status, _, err = run("solve", "--report", self.path / "f.pdf", "--language", code, scene)
                self.assertIn(status, (0, 1), err)
                text = subprocess.run(["pdftotext", "-l", "1", self.path / "f.pdf", "-"], capture_output=True, check=True, encoding="utf-8").stdout
                text = re.sub(r"\s+", " ", text)
                for name in sorted(outside, key=len, reverse=True):
                    text = text.replace(name, "")
                self.assertIsNone(ENGLISH.search(QUOTED.sub("", text)), f"{scene.name} {code}: {text}")

    def test_unknown_stays(self):
        """What no phrase has is told as it is: names with words of the table in them, and numbers with a comma."""
        scene = self.path / "scene.yaml"
        scene.write_text((ROOT / "examples/slope/design_cases.yaml").read_text(encoding="utf-8").replace("- name: static", "- name: the left end"),
                         encoding="utf-8")
        page = self.sheet(scene, "--language", "de")
        rows = page.tables("Lastfälle, der maßgebende zuerst")[0]
        self.assertEqual(rows[1][:2], ["the left end", "1,866"])

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
