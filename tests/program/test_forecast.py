# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What exceeds the budget of a command, 10 s or 1 GB, is reported before most of its work is done (docs/budgets.md): 80 slopes of 8 columns
took a minute without a word. The forecast is compared with one slope by itself; quick tables and studies have none, and it changes no row."""

import os
import pathlib
import re
import subprocess
import tempfile
import threading
import time
import unittest

from harness import PROGRAM, ROOT, main, run

COLUMNS = ROOT / "tests" / "data" / "factor_law" / "study_open.yaml"
SURVEY = ROOT / "examples" / "slope" / "survey_block.yaml"
SAID = (r"^the (\d+) remaining (rows|samples) will take about ([\d.]+) (seconds|minutes|hours)"
        r"(?: and ([\d.]+) GB of memory)?, judged by the first ones$")
UNITS = {"seconds": 1, "minutes": 60, "hours": 3600}


class Forecast(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple forecast ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def table(self, count, head="friction_angle_deg"):
        path = self.folder / "table.csv"
        path.write_text(f"name,{head}\n" + "".join(f"r{k},{37 + k / 1000}\n" for k in range(count)), encoding="utf-8")
        return path

    def first_words(self, *arguments):
        """What is said first on stderr; the run is ended then."""
        with open(self.folder / "out.txt", "wb") as out, \
                subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=out, stderr=subprocess.PIPE, encoding="utf-8") as process:
            most = threading.Timer(60, process.kill)
            most.start()
            line = process.stderr.readline()
            most.cancel()
            process.kill()
        return re.match(SAID, line) or self.fail(f"no forecast but {line!r}")

    def test_slopes_of_columns(self):
        began = time.monotonic()
        run("solve", COLUMNS)
        alone, threads = time.monotonic() - began, len(os.sched_getaffinity(0))
        study = self.folder / "study.yaml"
        count = 80 * max(2, threads)
        study.write_text(f"topple_study: 1\nscene: {COLUMNS}\nsamples: {count}\nvary: {{friction_angle_deg: {{uniform: {{low: 37, high: 39}}}}}}\n",
                         encoding="utf-8")
        for what, words in (("rows", ("solve", "--batch", "--csv", "--template", COLUMNS, self.table(count))), ("samples", ("study", study))):
            said = self.first_words(*words)
            left, seconds = int(said[1]), float(said[3]) * UNITS[said[4]]
            self.assertEqual(said[2], what)
            self.assertTrue(0.7 * count < left < count, said[0])
            truth = alone * left / threads  # as busy as the machine is; it tells seconds from minutes
            self.assertTrue(truth / 8 < seconds < truth * 8, (said[0], truth))

    def test_memory(self):
        """Each row keeps the text of its scene: 20000 with an outline of 3000 points, 105 kB each by `scene` of a row."""
        points = [[0, 0], [1, 0], [1, 1], *([round(1 - k / 3000, 6), 1 + k % 2 / 1000] for k in range(1, 3000)), [0, 1]]
        template = self.folder / "template.yaml"
        template.write_text(f"topple: 1\nlength_unit: m\nblock: {{unit_weight_kn_m3: 26, outline: {points}}}\nfriction_angle_deg: 35\n"
                            "base: {profile: [[0, 0], [1, 0]]}\nslope: {dip_deg: 25, towards: left}\n", encoding="utf-8")
        said = self.first_words("solve", "--batch", "--csv", "--template", template, self.table(20000, "friction"))
        self.assertAlmostEqual(float(said[5]), 2.1, delta=0.2)

    def test_quick(self):
        """Nothing is said of quick ones."""
        status, _, err = run("solve", "--batch", "--csv", "--template", SURVEY, self.table(300, "friction"))
        self.assertEqual((status, err), (0, ""))
        study = ROOT / "examples" / "studies" / "slab_study.yaml"
        self.assertEqual(run("study", study)[2], "")


if __name__ == "__main__":
    main()
