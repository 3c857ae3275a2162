# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Letterhead of a calculation sheet.

The story: a firm's sheet bears its name and logo, of whatever file it has. What stands there is text and a picture and nothing
else, a logo that cannot be used is named with its place before anything is solved, and the first page is one page of A4
for every example."""

import base64
import os
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import unittest
import zlib

from harness import PROGRAM, ROOT, main, run
from report_case import Page, words

SCENE = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 40\ntilt: {angle_deg: 10}\n"
KEYS = ("company", "project", "job", "author", "checker", "date")


def png(width, height):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    rows = b"".join(b"\0" + b"\x1d\x4e\x79" * width for _ in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


#: Heads of a JPEG alone: start, frame header of 3 x 2 dots, end.
JPEG = b"\xff\xd8\xff\xe0\0\x04ab" + b"\xff\xc0\0\x0b\x08\0\x02\0\x03\x01\x01\x11\0" + b"\xff\xda\0\x08\x01\x01\0\0\x3f\0" + b"\0" * 4 + b"\xff\xd9"
SVG = b'<?xml version="1.0"?>\n<!-- ours -->\n<svg xmlns="http://www.w3.org/2000/svg"><circle r="3"/></svg>\n'


class Letterhead(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def scene(self, report):
        path = self.path / "scene.yaml"
        path.write_text(SCENE + report, encoding="utf-8")
        return path

    def sheet(self, report, kind="html", *more):
        status, _, err = run("solve", "--report", self.path / f"r.{kind}", *more, self.scene(report))
        self.assertEqual((status, err), (0, ""))
        return (self.path / f"r.{kind}").read_bytes()

    def test_without_appendix(self):
        """Two pages, and on the second what must not be missed of the appendix: cautions and partial factors of cases."""
        cases = "loads: {seismic: {horizontal: 0.05}}\ncases:\n  - {name: a, required_fos: 1.5, tilt: {towards: left}}\n  - {name: b, partial_factors: DA1-2}\n"
        whole = self.sheet(cases, "md").decode()
        brief = self.sheet(cases + "report: {appendix: false}\n", "md").decode()
        front, found, _ = whole.partition("## Appendix")
        self.assertTrue(found)
        self.assertNotIn("## Appendix", brief)
        self.assertNotIn("## Account", brief)
        at = brief.index("## Cautions")
        self.assertGreater(at, brief.index("## Hand check"))
        self.assertIn("They stand below the hand check", brief[:at])
        self.assertIn("They stand at the head of the appendix", front)
        self.assertIn("the earthquake is considered down-dip only", brief[at:])
        self.assertIn("DA1-2: weight", brief[at:])

    def test_texts(self):
        """Each is there as text, the persons also beside their signatures."""
        report = "report:\n" + "".join(f"  {key}: '<b>{key}</b> & [x](y)'\n" for key in KEYS)
        page = Page(self.sheet(report).decode())
        self.assertEqual(words(page.all("header")[0]), "<b>company</b> & [x](y)")
        table = page.tables("Project and persons")[0]
        self.assertEqual(table[0], ["Project", "Job", "Prepared by", "Checked by", "Date"])
        self.assertEqual(table[1], [f"<b>{key}</b> & [x](y)" for key in KEYS[1:]])
        signatures = page.tables("Who has prepared")[0]
        self.assertEqual([row[1] for row in signatures[1:3]], [table[1][2], table[1][3]])
        told = self.sheet(report, "md").decode().split("## Input as read")[0]
        self.assertNotIn("<b>", told.replace("\\<", ""))
        self.assertTrue(self.sheet(report, "pdf").startswith(b"%PDF-"))
        self.assertEqual(Page(self.sheet("report: {job: 7}\n").decode()).tables("Project and persons")[0], [["Job"], ["7"]])

    def test_of_a_study_and_a_tilt_test(self):
        """Their sheets have it too, of the scene that they are of, and names beside the signatures."""
        (self.path / "logo.png").write_bytes(png(7, 3))
        scene = self.scene("report: {company: Example Geotechnics, job: 7, author: A. Author, logo: logo.png}\n")
        scene.write_text(scene.read_text(encoding="utf-8").replace("angle_deg: 10", "towards: left, angle_deg: 10")
                         + "tilt_test: {engine: path}\n", encoding="utf-8")
        study = self.path / "study.yaml"
        study.write_text("topple_study: 1\nscene: scene.yaml\nsamples: 64\nvary: {friction_angle_deg: {normal: {mean: 40, deviation: 2}}}\n", encoding="utf-8")
        for command in (("study", study), ("tilt", scene)):
            for kind in ("html", "md", "pdf"):
                status, _, err = run(command[0], "--report", self.path / f"r.{kind}", command[1])
                self.assertEqual(status, 0, err)
            page = Page((self.path / "r.html").read_text(encoding="utf-8"))
            self.assertEqual(words(page.all("header")[0]), "Example Geotechnics")
            self.assertTrue(page.all("header")[0].find("img").get("src").startswith("data:image/png;base64,"))
            self.assertEqual(page.tables("Project and persons")[0], [["Job", "Prepared by"], ["7", "A. Author"]])
            self.assertEqual(page.tables("Who has prepared")[0][1][1], "A. Author")
            self.assertEqual([words(h) for h in page.all("h3") if words(h).endswith("logo.png")], [])  # no text of a picture

    def test_logos(self):
        """A picture of each kind stands within the page, byte for byte; a PDF has PNG and JPEG, and says so of SVG."""
        for name, data, kind in (("a.png", png(7, 3), "png"), ("b.jpg", JPEG, "jpeg"), ("c.svg", SVG, "svg+xml")):
            (self.path / name).write_bytes(data)
            report = f"report: {{logo: {name}}}\n"
            page = Page(self.sheet(report).decode())
            source = page.all("header")[0].find("img").get("src")
            self.assertEqual(source, f"data:image/{kind};base64," + base64.b64encode(data).decode())
            self.assertIn(source, self.sheet(report, "md").decode())
            facts = page.tables("Program, date and input")[0]
            self.assertIn(str(self.path / name), [row[1] for row in facts])  # with its hash, and not as text
            self.assertEqual(len(page.all("pre")), 1)
            if kind == "svg+xml":
                status, _, err = run("solve", "--report", self.path / "s.pdf", self.path / "scene.yaml")
                self.assertEqual(status, 3)
                self.assertIn("scene.yaml:6:16: a PDF can have a PNG or a JPEG", err)
                self.assertFalse((self.path / "s.pdf").exists())
            else:
                self.assertIn(b"/Width 7" if kind == "png" else b"/DCTDecode", self.sheet(report, "pdf"))

    def test_refused(self):
        """With the place, before anything is solved, and nothing is written."""
        whole = png(4, 4)
        for name, data, why in (("cut.png", whole[:-6], "cut off"), ("text.png", b"hello", "none of PNG"), ("empty.png", b"", "none of PNG"),
                                ("large.png", whole + b"x" * (1 << 20), "larger than 1 MiB"), ("wide.png", png(5000, 1), "4096 dots"),
                                ("cut.jpg", JPEG[:-2], "cut off"), ("html.svg", b"<html><svg></svg></html>", "none of PNG"),
                                ("laughs.svg", b'<!DOCTYPE svg [<!ENTITY a "b">]><svg>&a;</svg>', "none of PNG")):
            with self.subTest(name):
                (self.path / name).write_bytes(data)
                status, out, err = run("solve", "--report", self.path / "n.html", self.scene(f"report: {{logo: {name}}}\n"))
                self.assertEqual((status, out), (3, ""))
                self.assertRegex(err, rf"scene\.yaml:6:16: the logo '.*{re.escape(name)}' cannot be used: .*{why}")
                self.assertFalse((self.path / "n.html").exists())
        status, _, err = run("solve", self.scene("report: {logo: nowhere.png}\n"))
        self.assertEqual(status, 5)
        self.assertRegex(err, r"scene\.yaml:6:16: the logo '.*nowhere\.png' cannot be read: No such file")
        for report, why in (("report: {logo: [a]}", "logo is the name"), ("report: {language: fr}", "known are: en, es, de"),
                            ("report: {decimal: dot}", "point or comma"), ("report: {company: [a]}", "must be text"),
                            (f"report: {{job: {'x' * 201}}}", "at most 200 bytes"), ("report: 7", "report")):
            status, _, err = run("solve", self.scene(report + "\n"))
            self.assertEqual(status, 3, report)
            self.assertRegex(err, rf"scene\.yaml:6:\d+: .*{why}")
        status, _, err = run("solve", "--language", "fr", "--report", "x.html", self.scene(""))
        self.assertEqual(status, 2)
        self.assertIn("--language takes one of en, es, de", err)
        self.assertEqual(run("solve", "--language", "es", self.scene(""))[0], 2)

    def test_a_logo_is_not_overwritten(self):
        (self.path / "logo.html").write_bytes(SVG)
        status, _, _ = run("solve", "--report", self.path / "logo.html", self.scene("report: {logo: logo.html}\n"))
        self.assertEqual(status, 3)
        self.assertEqual((self.path / "logo.html").read_bytes(), SVG)

    @unittest.skipIf(shutil.which("pdftotext") is None, "there is no pdftotext: install Debian's package poppler-utils")
    def test_first_page_is_one_page(self):
        """Of every example, with a letterhead and a title of two lines: signatures stand at the foot of page 1, the hand check
        begins on page 2, and the appendix on a page of its own."""
        seen = 0
        (self.path / "logo.png").write_bytes(png(60, 40))
        for path in sorted([*(ROOT / "examples").glob("*.yaml"), *(ROOT / "examples/slope").glob("*.yaml")]):
            text = path.read_text(encoding="utf-8")
            if not re.search(r"(?m)^(block|drawing):", text) or re.search(r"(?m)^  ?report:|^report:", text):
                continue
            copy = self.path / "examples"
            shutil.copytree(path.parent, copy, dirs_exist_ok=True)
            (copy / "logo.png").write_bytes(png(60, 40))
            (copy / path.name).write_text(re.sub(r"(?m)^title:.*$", "title: " + "A long title of a block above a road " * 3, text)
                                          + "\nreport: {company: Example Geotechnics, logo: logo.png, project: Road, author: A, checker: B}\n",
                                          encoding="utf-8")
            done = subprocess.run([PROGRAM, "solve", "--report", self.path / "p.pdf", copy / path.name], capture_output=True,
                                  env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}, check=False)
            if done.returncode not in (0, 1, 4):
                continue
            pages = subprocess.run(["pdftotext", "-layout", self.path / "p.pdf", "-"], capture_output=True, check=True,
                                   encoding="utf-8").stdout.split("\f")
            with self.subTest(path.name):
                self.assertIn("Approved by", pages[0])
                self.assertIn("Hand check", pages[1])
                self.assertNotIn("Hand check", pages[0])
                first = next(k for k, page in enumerate(pages) if page.strip().startswith("Appendix"))
                self.assertGreater(first, 1)
            seen += 1
        self.assertGreater(seen, 30)


if __name__ == "__main__":
    main()
