# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Hostile titles, names of files, lines of a scene and settings on calculation sheets.

The story: a page that is opened from a disk may run what stands in it. A title that closed an element became a script in
no version of Topple; here each hostile string of hostile.py goes into each place of the page, which a strict reader of
HTML then finds to have the elements of a harmless one."""

import os
import re
import subprocess
import unittest

import hostile
from harness import PROGRAM, main
from hostile import SCENE
from report_case import Page, words


class Sheets(hostile.Case):
    def sheet(self, scene, kind="html", *more):
        self.run_bytes("solve", "--report", f"r.{kind}", *more, scene)
        return (self.path / f"r.{kind}").read_bytes()

    def elements(self, page):
        """All elements with their attributes, but for what a picture is and lines of a file."""
        return [(e.tag, sorted((k, v) for k, v in e.attrib.items() if k != "src")) for e in page.root.iter()
                if e.tag not in ("mn", "mo", "mi")]

    def test_titles(self):
        """The elements of a harmless page, and the title as text where it can be seen."""
        expected = self.elements(Page(self.sheet(self.scene("x")).decode()))
        for title in hostile.TEXTS:
            with self.subTest(title=title[:60]):
                text = hostile.plain(self.sheet(self.scene(title)), self)
                page = Page(text)
                self.assertEqual(self.elements(page), expected)
                heading = words(page.all("h1")[0])
                if title.strip() and not any(map(hostile.unseen, title)):
                    self.assertEqual(heading, " ".join(title.split()).replace("▶", ""))
                self.assertTrue(heading)

    def test_titles_in_markdown(self):
        """Tables keep their columns; nothing is HTML or a link but the picture and equations of the program."""
        for title in hostile.TEXTS[::2]:
            with self.subTest(title=title[:60]):
                text = hostile.plain(self.sheet(self.scene(title), "md"), self)
                first = text.split("\n\n")[0].strip()
                self.assertNotRegex(first[2:].replace("\\<", ""), r"<|(?<!\\)\]\(|(?<!\\)!\[|(?<!\\)\$|://")
                self.assertEqual(text.count("\n## Verdict"), 1)
                rest = "".join(line for line in text.splitlines() if not line.startswith("    "))
                self.assertEqual(len(re.findall(r"(?<!\\)\]\(", rest)), 1)

    def test_titles_in_pdf(self):
        """It is drawn, and read by a reader of PDF where there is one."""
        for title in hostile.TEXTS[::9]:
            with self.subTest(title=title[:60]):
                self.assertTrue(self.sheet(self.scene(title), "pdf").startswith(b"%PDF-"))

    def test_names_of_files(self):
        """A name stands in a fact, a heading and places of the effects: as text."""
        expected = None
        for name in (b"x.yaml", b"<img src=x onerror=alert(1)>.yaml", b"\"'><script>.yaml", b"a\nb<td>.yaml",
                     b"a\x1b[31m.yaml", b"\xff\xfe.yaml", b"\xe2\x80\xae.yaml", b"&lt;b&gt;.yaml"):
            path = os.path.join(os.fsencode(self.path), name)
            with open(path, "wb") as file:
                file.write(SCENE.format(title="x").encode())
            with self.subTest(name=name):
                self.run_bytes("solve", "--report", "r.html", b"./" + name)
                page = Page(hostile.plain((self.path / "r.html").read_bytes(), self))
                expected = expected or self.elements(page)
                self.assertEqual(self.elements(page), expected)

    def test_lines_of_the_scene(self):
        """Comments and keys of the file are shown line by line, as text."""
        for text in hostile.TEXTS:
            lines = "".join(f"# {line}\n" for line in text.splitlines() if line.isprintable()) or "# x\n"
            (self.path / "scene.yaml").write_text(lines + SCENE.format(title="x"), encoding="utf-8")
            with self.subTest(text=text[:60]):
                page = Page(hostile.plain(self.sheet("scene.yaml"), self))
                self.assertEqual(len(page.all("pre")), 1)
                shown = "".join(page.all("pre")[0].itertext()).splitlines()
                self.assertEqual(len(shown), (lines + SCENE).count("\n"))

    def test_settings(self):
        """What was set on the command line stands in the page as it was given."""
        page = Page(self.sheet(self.scene("x"), "html", "--set", "a=15*2").decode())
        self.assertIn(["Set", "a = 15*2 = 30 mm"], page.tables("Input, and quantities")[0])

    def test_date(self):
        """SOURCE_DATE_EPOCH is quoted plainly where it is wrong."""
        for text in hostile.TEXTS:
            if "\0" in text or not text:
                continue
            done = subprocess.run([PROGRAM, "solve", "--report", "r.html", self.scene("x")], cwd=self.path,
                                  capture_output=True, env={**os.environ, "SOURCE_DATE_EPOCH": text})
            self.assertEqual(done.returncode, 3)
            hostile.one_line(done.stderr, self)


if __name__ == "__main__":
    main()
