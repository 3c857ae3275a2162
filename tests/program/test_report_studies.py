# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Calculation sheets of studies and of tilt tests (docs/report.md).

The story: a probability is signed like a factor of safety. So its shares are those of the JSON, their intervals are
recomputed here by Wilson's formula from the counts that stand on the page, and the page names every file that the
study rests on. A tilt test says first that it is a simulation."""

import hashlib
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

import hostile
from harness import PROGRAM, ROOT, main, run
from report_case import Page, words

STUDY = "examples/studies/block_above_road_study.yaml"
TILT = "examples/tilt_block_e_valley.yaml"
EPOCH = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}
Z = 1.959963984540054


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        status, out, err = run("study", "--json", STUDY, "--report", cls.path / "s.html")
        if status != 0:
            raise AssertionError(err)
        cls.told, cls.page = json.loads(out), Page((cls.path / "s.html").read_text(encoding="utf-8"))

    def near(self, text, value):
        printed = float(text.strip("°"))
        decimals = len(text.strip("°").partition(".")[2])
        most = 1e-9 * abs(value)  # factors of safety are rounded down, all else to nearest
        self.assertLessEqual(printed - value, 0.5 * 10.0 ** -decimals + most, text)
        self.assertLessEqual(value - printed, 10.0 ** -decimals + most, text)

    def test_outcomes(self):
        """Counts, shares and intervals: those of JSON, and Wilson's of the counts."""
        table = self.page.tables("At the scene's tilt")[0]
        own = self.told["tilts"][0]
        expected = {o["outcome"]: o for o in own["outcomes"] if o["samples"] > 0}
        expected |= {"certain to stand": own["certain_to_stand"], "certain to move": own["certain_to_move"],
                     "open: neither is certain": own["neither"]}
        self.assertEqual([row[0] for row in table[1:]], list(expected))
        total = self.told["samples"]
        self.assertEqual(sum(int(row[1]) for row in table[-3:]), total)
        for label, count, share, low, high in table[1:]:
            self.assertEqual(int(count), expected[label]["samples"])
            for text, key in ((share, "share"), (low, "low"), (high, "high")):
                self.near(text, expected[label][key])
            p = int(count) / total
            middle, half = p + Z * Z / (2 * total), Z * math.sqrt(p * (1 - p) / total + Z * Z / (4 * total * total))
            self.near(low, max(0, (middle - half) / (1 + Z * Z / total)))
            self.near(high, (middle + half) / (1 + Z * Z / total))

    def test_tilts_and_quantiles(self):
        for row, own in zip(self.page.tables("By tilt")[0][1:], self.told["tilts"][1:], strict=True):
            self.near(row[0], own["tilt_deg"])
            for texts, key in ((row[1:4], "certain_to_stand"), (row[4:7], "certain_to_move")):
                for text, part in zip(texts, ("share", "low", "high")):
                    self.near(text, own[key][part])
        rows = self.page.tables("Quantiles")[0]
        told = [q for q in self.told["quantities"] if q["samples"] > 0]
        self.assertEqual(len(rows) - 1, len(told))
        for row, quantity in zip(rows[1:], told):
            for text, quantile in zip(row[1:], quantity["quantiles"], strict=True):
                if isinstance(quantile["value"], str):
                    self.assertEqual(text, quantile["value"])
                else:
                    self.near(text, quantile["value"])

    def test_formula_holds(self):
        """p = n / N with its numbers, and the interval's last line gives both ends."""
        lines = self.page.lines()
        values = [value for _, value in lines[0] if value is not None]
        self.assertEqual(len(values), 2)
        self.assertTrue(values[0].meets(values[1]))
        fraction = next(e for e in self.page.all("math")[2].iter("mfrac"))
        middle, half = (float(e.text) for e in fraction[0].iter("mn"))
        under = float(next(fraction[1].iter("mn")).text)
        moves = self.told["tilts"][0]["certain_to_move"]
        self.assertAlmostEqual((middle - half) / under, moves["low"], delta=1e-7)
        self.assertAlmostEqual((middle + half) / under, moves["high"], delta=1e-7)

    def test_names_all_files(self):
        """The study and its scene, each with its hash, and both shown."""
        told = [row[1] for row in self.page.tables("Program, date and input")[0] if row[0] == "its SHA-256"]
        files = [ROOT / STUDY, ROOT / "examples/studies/block_above_road.yaml"]
        self.assertEqual(told, [hashlib.sha256(path.read_bytes()).hexdigest() for path in files])
        self.assertEqual(len(self.page.all("img")), 2)
        self.assertGreaterEqual(len(self.page.all("pre")), 2)

    def test_same_bytes(self):
        """A rerun gives the same page, of every kind; also by other threads."""
        for command, name in (("study", "examples/studies/slab_study.yaml"), ("tilt", TILT)):
            for kind in ("html", "md", "pdf"):
                texts = []
                for k in (1, 2):
                    path = self.path / f"{command}{k}.{kind}"
                    more = ["--threads", str(k)] if command == "study" else []
                    subprocess.run([PROGRAM, command, name, "--report", path, *more], cwd=ROOT, check=True,
                                   capture_output=True, env=EPOCH)
                    texts.append(path.read_bytes())
                self.assertEqual(*texts, (command, kind))
                if kind == "pdf":
                    self.assertTrue(texts[0].startswith(b"%PDF-"))

    def test_tilt(self):
        """It says that it is a simulation before it says anything else; its numbers are those of JSON."""
        status, out, _ = run("tilt", "--json", TILT, "--report", self.path / "t.html")
        self.assertEqual(status, 0)
        page, told = Page((self.path / "t.html").read_text(encoding="utf-8")), json.loads(out)
        first = next(e for e in page.root.iter() if e.tag == "p")
        self.assertEqual(first.get("class"), "caution")
        self.assertIn("no proven bound", words(first))
        for table, case in zip(page.tables("Numbers of the test"), told["cases"], strict=True):
            facts = dict(table)
            for label, value in (("Stands at", case["critical_angle_deg"]["stands_at"]),
                                 ("Begins to move at", case["critical_angle_deg"]["lets_go_at"]),
                                 ("Statics, α_s", case["statics"]["onset_deg"]),
                                 ("Statics, α_w", case["statics"]["limit_deg"])):
                self.near(facts[label], value)
        self.assertEqual(len(page.all("img")), 2)  # frames, reactions; a path has no portrait of its motion

    def test_refused(self):
        for words_ in (["study", STUDY, "--report", "x.svg"], ["tilt", TILT, "--report", "x"]):
            status, out, err = run(*words_)
            self.assertEqual((status, out), (2, ""))
            self.assertIn("--report takes a file", err)


class Hostile(hostile.Case):
    def test_titles(self):
        """Of a study and a tilt test: the elements of a harmless page."""
        counts = {}
        study = ("topple_study: 1\ntitle: {0}\nscene: scene.yaml\nsamples: 16\nvary:\n"
                 "  friction_angle_deg: {{uniform: {{low: 20, high: 40}}}}\n")
        tilt = "tilt_test: {engine: path}\n"
        for title in ["x", *hostile.TEXTS[::5]]:
            self.scene(title)
            scene = (self.path / "scene.yaml").read_text(encoding="utf-8")
            (self.path / "tilt.yaml").write_text(scene + tilt, encoding="utf-8")
            (self.path / "study.yaml").write_text(study.format(hostile.yaml(title)), encoding="utf-8")
            for command in ("study", "tilt"):
                with self.subTest(title=title[:60], command=command):
                    self.run_bytes(command, f"{command}.yaml", "--report", "r.html")
                    page = Page(hostile.plain((self.path / "r.html").read_bytes(), self))
                    found = [e.tag for e in page.root.iter()]
                    self.assertEqual(found, counts.setdefault(command, found))


if __name__ == "__main__":
    main()
