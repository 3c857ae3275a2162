# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Figures of charts that are whole, the same again, or not there at all."""

import json
import os
import subprocess
import xml.etree.ElementTree

from chart_case import Chart, chart
from harness import PROGRAM, ROOT, main, rounds, run


class Figures(Chart):
    kinds = (["fos"], ["mechanisms"], ["ranges"])

    def all_kinds(self):
        self.slab(title="It's `id` \\\"{/Bold x}_2\"")
        line = ["map", self.scene, "--x", "block.slab.width=0.2:3"]
        plane = ["map", self.scene, "--x", "block.slab.width=-25:2", "--y", "friction_angle_deg=10:50"]  # few columns have a slab
        return (*self.kinds, line, plane)

    def test_whole_and_the_same_again(self):
        """Every kind in every format: well formed, and byte for byte the same on a rerun, which the short form asks of PDF
        and SVG of the first two kinds alone; the last kind, a map that takes a second, it draws once, as CSV and SVG."""
        for k, arguments in enumerate(self.all_kinds()):
            for ending in ("svg", "csv") if k == rounds(4, -1) else ("svg", "pdf", "png", "csv"):
                one, other = (self.folder / f"{k}-{turn}.{ending}" for turn in "ab")
                again = rounds(k < 2 and ending in ("svg", "pdf"), True)
                for path in (one, other)[:1 + again]:
                    self.assertEqual(run("chart", *arguments, "--output", path), (0, "", ""))
                data = one.read_bytes()
                if again:
                    self.assertEqual(data, other.read_bytes())
                if ending == "svg":
                    root = xml.etree.ElementTree.fromstring(data)
                    self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
                elif ending == "pdf":
                    self.assertTrue(data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"))
                    self.assertNotIn(b"CreationDate", data)
                elif ending == "png":
                    self.assertTrue(data.startswith(b"\x89PNG\r\n\x1a\n"))
                    self.assertIn(b"IEND", data[-12:])
                else:
                    self.assertEqual(data.decode(), run("chart", *arguments)[1])
        self.assertEqual([p for p in self.folder.iterdir() if p.name.endswith(".part")], [])

    def test_text_of_a_user(self):
        """Quotes, backticks and markup of a title are drawn, not carried out."""
        trap = self.folder / "trap"
        self.slab(title=f"\"it's `touch {trap}` {{/Bold x}}_2 \\\\n $(id) 'q' @x\"")
        path = self.folder / "map.svg"
        self.assertEqual(run("chart", "map", self.scene, "--x", "block.slab.width=0.2:3", "-o", path),
                         (0, "", ""))
        text = "".join(xml.etree.ElementTree.fromstring(path.read_bytes()).itertext())
        self.assertIn(f"it's `touch {trap}` {{/Bold x}}_2", text)
        self.assertFalse(trap.exists())

    def test_json(self):
        """The same numbers as JSON, each with its error."""
        for arguments in self.all_kinds():
            status, out, err = run("chart", "--json", *arguments)
            self.assertEqual((status, err), (0, ""))
            data, rows = json.loads(out), chart(*arguments)
            points = [p for s in data["series"] for p in s["points"]]
            self.assertEqual(len(points), len(rows))
            self.assertEqual([p["y"]["value"] for p in points], [float(r[data["y"]]) for r in rows])
            self.assertEqual([p["y"]["error"] for p in points], [float(r["y_error"]) for r in rows])


class Errors(Chart):
    def refuse(self, status, message, *arguments):
        done = run("chart", *arguments)
        self.assertEqual((done[0], done[1]), (status, ""), arguments)
        self.assertIn(message, done[2])

    def test_usage(self):
        self.slab()
        self.refuse(2, "not a kind of chart", "pie")
        self.refuse(2, "kind of chart is missing")
        self.refuse(2, "another kind", "ranges", "--friction", 3)
        self.refuse(2, "must rise", "fos", "--tilt", "60:10")
        self.refuse(2, "must rise", "map", self.scene, "--x", "block.slab.width=3:1")
        self.refuse(2, "longer than 127 bytes", "map", self.scene, "--x", "k" * 128 + "=1:3")
        self.refuse(2, "KEY=FROM:TO", "map", self.scene, "--x", "block.slab.width")
        self.refuse(2, "--x KEY=FROM:TO", "map", self.scene)
        self.refuse(2, "scene file is missing", "map")
        self.refuse(2, "must end in", "fos", "--output", self.folder / "a.gif")
        self.refuse(2, "not a list", "fos", "--amplitude", "0.1;0.2")
        self.refuse(2, "number", "mechanisms", "--friction", "steep")

    def test_input(self):
        self.slab()
        self.refuse(3, "did you mean 'width'?", "map", self.scene, "--x", "block.slab.widht=1:3")
        self.refuse(3, "list or a map", "map", self.scene, "--x", "block.slab=1:3")
        self.refuse(3, "both axes are tilt", "map", self.scene, "--x", "tilt=1:3")
        self.refuse(5, "cannot be opened", "map", self.folder / "none.yaml", "--x", "a=1:3")
        self.refuse(3, "between 0 and 0.5", "fos", "--amplitude", "0.7")
        self.refuse(3, "at most 80", "mechanisms", "--friction", 75)
        self.refuse(3, "whole", "fos", "--sub-blocks", 2.5)
        self.scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                              "tilt: {towards: left}\n")
        self.refuse(3, "friction_angle_deg", "map", self.scene, "--x", "block.slab.width=1:3")
        self.scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                              "friction_angle_deg: 30\n")
        self.refuse(3, "tilts both ways", "map", self.scene, "--x", "block.slab.width=1:3")

    def test_unwritable(self):
        self.refuse(5, "cannot be written", "fos", "--output", self.folder / "none" / "a.svg")
        self.refuse(5, "cannot be written", "fos", "--output", self.folder / "none" / "a.csv")
        (self.folder / "taken.svg").mkdir()
        self.refuse(5, "Is a directory", "fos", "--output", self.folder / "taken.svg")

    def run_with_path(self, path, output):
        return subprocess.run([PROGRAM, "chart", "fos", "--output", output], cwd=ROOT, check=False,
                              capture_output=True, encoding="utf-8", env={**os.environ, "PATH": str(path)})

    def test_without_gnuplot(self):
        """Status 5, what to install, and no file; CSV needs none."""
        tools = self.folder / "tools"
        tools.mkdir()
        done = self.run_with_path(tools, self.folder / "a.svg")
        self.assertEqual(done.returncode, 5)
        self.assertIn("apt-get install gnuplot-nox", done.stderr)
        self.assertEqual(self.run_with_path(tools, self.folder / "a.csv").returncode, 0)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.csv", "tools"])

    def test_gnuplot_fails(self):
        """A gnuplot that fails, or that leaves early, costs no file: what was there stays."""
        tools, figure = self.folder / "tools", self.folder / "a.svg"
        tools.mkdir()
        figure.write_text("as before")
        for script in ("cat >/dev/null; echo half; echo it broke >&2; exit 3", "exit 0", "kill -9 $$"):
            (tools / "gnuplot").write_text(f"#!/bin/sh\nPATH=/bin:/usr/bin\n{script}\n")
            (tools / "gnuplot").chmod(0o755)
            done = self.run_with_path(tools, figure)
            self.assertEqual(done.returncode, 5)
            self.assertIn("gnuplot failed", done.stderr)
            self.assertEqual(figure.read_text(), "as before")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.svg", "tools"])


if __name__ == "__main__":
    main()
