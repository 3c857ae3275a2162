# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A tilt test that is interrupted (ctrl-C) tells what it knows by then and ends by the signal; how far it is stands on stderr
where that is a terminal, and nothing of it anywhere else."""

import csv
import json
import os
import pathlib
import pty
import re
import signal
import subprocess
import tempfile
import time
import unittest

from harness import PROGRAM, main

SLAB = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 4}, unit_weight_kn_m3: 25}\n" \
       "base: {profile: [[-20, 0], [20, 0]]}\nfriction_angle_deg: 70\ntilt: {towards: left}\n"
# some minutes, were it not interrupted
LONG = SLAB + "tilt_test: {engine: dynamics, method: springs, normal_stiffness_gpa_m: 10, shear_stiffness_gpa_m: 1,\n" \
              "            protocol: steps, tolerance_deg: 1e-7, duration_s: 40}\n"
SHAKEN = SLAB + "tilt_test: {duration_s: 30}\nshaking: {horizontal: {full_sine: {peak_g: 0.5, frequency_hz: 1}}}\n"


class Interrupted(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def start(self, text, *options):
        """Begun with its stderr on a terminal of ours, which is returned as well."""
        (self.folder / "scene.yaml").write_text(text)
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)
        with open(self.folder / "out", "wb") as out:
            # a test that is run without a terminal may hand down that a signal is ignored
            process = subprocess.Popen(  # pylint: disable=consider-using-with
                [PROGRAM, "tilt", "--json", *options, self.folder / "scene.yaml"], stdout=out, stderr=theirs,
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        os.close(theirs)
        return process, ours

    def read(self, terminal, until, seconds=120):
        """What comes on the terminal up to some words, or its end."""
        text, began = "", time.monotonic()
        while time.monotonic() - began < seconds:
            try:
                got = os.read(terminal, 4096)
            except OSError:  # the other side is closed
                return text
            if not got:
                return text
            text += got.decode()
            if until is not None and re.search(until, text):
                return text
        self.fail(f"nothing more came after {text!r}")

    def test_brackets(self):
        """Progress tells the bracket after each run; after ctrl-C the bracket by then is told, and that it was interrupted."""
        process, terminal = self.start(LONG)
        told = self.read(terminal, r"2 runs, stands at [0-9.]+, begins to move at [0-9.]+ degrees")
        self.assertIn("1 runs, stands at", told)
        process.send_signal(signal.SIGINT)
        rest = self.read(terminal, None)
        self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assertIn("the test is interrupted", rest)
        own = json.loads((self.folder / "out").read_text())["cases"][0]
        self.assertEqual(own["end"], "interrupted")
        angle = own["critical_angle_deg"]
        self.assertFalse(angle["converged"])
        self.assertTrue(angle["stands_at"] is not None or angle["lets_go_at"] is not None)

    def test_spectrum(self):
        """The frequencies that were done by then are on the chart, each as it would be; the words say how many."""
        path = self.folder / "spectrum.csv"
        process, terminal = self.start(SHAKEN, "--spectrum", path, "--frequencies", "0.5:8:100")
        self.read(terminal, r"2 of 100")
        process.send_signal(signal.SIGINT)
        rest = self.read(terminal, None)
        self.assertEqual(process.wait(60), -signal.SIGINT)
        done = int(re.search(r"the overturning spectrum was interrupted after (\d+) of 100 frequencies", rest)[1])
        self.assertGreaterEqual(done, 2)
        with open(path, encoding="utf-8") as table:
            rows = [row for row in csv.DictReader(table)
                    if row["panel_of"] == "frequency" and row["edge"] == "least found that overturns"]
        self.assertEqual(len(rows), done)
        self.assertEqual({row["runs_decided"] for row in rows}, {"all"})
        self.assertEqual(json.loads((self.folder / "out").read_text())["cases"][0]["end"], "overturned")


if __name__ == "__main__":
    main()
