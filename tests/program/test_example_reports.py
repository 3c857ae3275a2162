# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""One command leads from each file in examples/ to a report: tests/data/example_reports.csv has a row for every file, with
the command and what there is to say of it.

The story: a reader opens the folder, takes any file, a drawing, a mesh, a photograph, a profile, a study, and wants the page to
sign. A file without a row fails, so does a row without a file, and a command whose page is not of that file: the page
names it by its SHA-256."""

import concurrent.futures
import hashlib
import os
import pathlib
import re
import shlex
import tempfile
import unittest

from harness import PROGRAM, ROOT, is_readable, main, reads, run, table
from report_case import Page, words

EXAMPLES = ROOT / "examples"
BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
ROWS = table("example_reports.csv")


class ExampleReports(unittest.TestCase):
    def test_every_file_has_a_row(self):
        """But those of the benchmark, which is for other programs."""
        files = {str(path.relative_to(EXAMPLES)) for path in EXAMPLES.rglob("*")
                 if path.is_file() and not {"__pycache__", "benchmark"} & set(path.parts)}
        names = [row["file"] for row in ROWS]
        self.assertEqual(sorted(names), sorted(files), "tests/data/example_reports.csv has a row for every file")
        self.assertEqual(len(names), len(set(names)))
        for row in ROWS:
            self.assertTrue(row["reason"], row)
            self.assertTrue(row["command"] or row["file"].endswith((".c", ".py")), f"{row['file']}: only programs have none")
            command = row["command"].split()
            self.assertTrue(not command or "{out}" in command or command[0] == "verify" or row["reason"].startswith("a solid:"), row)
            self.assertTrue(not command or row["file"] in command or row["reason"] not in ("a scene", "a study", "a tilt test"), row)

    def run_row(self, row):
        """What the command of a row made: its status, what it complained of, the report and the page's own scene."""
        with tempfile.TemporaryDirectory() as folder:
            out, scene = pathlib.Path(folder) / "report.html", pathlib.Path(folder) / "scene.yaml"
            command = [word.format(out=out, scene=scene) for word in shlex.split(row["command"])]
            status, printed, err = run(*command, folder=EXAMPLES)
            return status, err, out.read_text(encoding="utf-8") if out.exists() else printed

    def check_page(self, row, text):
        page = Page(text)
        headings = [words(heading) for heading in page.all("h1", "h2")]
        self.assertTrue(any("Signatures" in heading for heading in headings), headings)
        self.assertGreater(len(headings), 4)
        pictures = page.all("img")
        self.assertGreaterEqual(len(pictures), 1)
        for picture in pictures:
            self.assertTrue(picture.get("src").startswith("data:image/svg+xml;base64,"))
            self.assertGreater(len(picture.get("alt")), 20)
        self.assertIn(hashlib.sha256((EXAMPLES / row["file"]).read_bytes()).hexdigest(), text)

    @unittest.skipUnless(reads("dxf"), "Topple was built without dxflib")
    def test_short_lines_stand_in_columns(self):
        """A DXF has a word or a number a line: set in columns it is all there, in its order, and takes pages less, while the
        figure stands on the first one. Lines of any length and few lines are one column."""
        with tempfile.TemporaryDirectory() as folder:
            for kind in ("html", "pdf"):
                self.assertEqual(run("solve", "--quiet", "--report", f"{folder}/r.{kind}", "section_arcs.yaml", folder=EXAMPLES)[0], 0)
            page = Page((pathlib.Path(folder) / "r.html").read_text(encoding="utf-8"))
            classes = [pre.get("class") for pre in page.all("pre")]
            self.assertEqual(classes, [None, "narrow"])
            lines = "".join(page.all("pre")[1].itertext()).splitlines()
            self.assertEqual(lines, (EXAMPLES / "section_arcs.dxf").read_text().splitlines())
            pages = max(int(count) for count in re.findall(rb"/Count (\d+)", (pathlib.Path(folder) / "r.pdf").read_bytes()))
            self.assertLessEqual(pages, 7)  # ten, where each line is one of the page

    def test_one_command_each(self):
        rows = [row for row in ROWS if row["command"]]
        before = {path: path.read_bytes() for path in EXAMPLES.rglob("*") if path.is_file()}
        if not (BUILD / "libtopple-trace.so").exists():
            rows = [row for row in rows if not row["command"].startswith("trace ")]
        rows = [row for row in rows if is_readable(EXAMPLES / row["file"])]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for row, (status, err, text) in zip(rows, pool.map(self.run_row, rows)):
                with self.subTest(row["file"]):
                    if row["command"].startswith("verify "):  # a claim of the paper is refuted, which is what it shows
                        self.assertEqual((status, err), (1, ""))
                        self.assertTrue(text.startswith("# ") and "## All claims" in text)
                        continue
                    if row["reason"] == "many blocks":  # which have a page for a terminal and a figure
                        self.assertEqual((status, err), (0, ""))
                        self.assertIn("factor of safety", text)
                        continue
                    if row["reason"].startswith("a solid:"):
                        self.assertEqual((status, err), (0, ""))
                        self.assertRegex(text, "poses in which it can rest|Sliding between two joints")
                        continue
                    if row["reason"] == "a survey":  # of a page, not of a sheet; a block of it does not hold
                        self.assertEqual(status, 1)
                        self.assertGreater(len(Page(text).all("img")), 3)
                        continue
                    self.assertEqual((status, err), (0, ""))
                    self.check_page(row, text)
        after = {path: path.read_bytes() for path in EXAMPLES.rglob("*") if path.is_file() and "__pycache__" not in path.parts}
        self.assertEqual({path: before[path] for path in after}, after)


if __name__ == "__main__":
    main()
