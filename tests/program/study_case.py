# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of studies share: a slab and a study of it in a folder of their own, run, with its summary and its rows."""

import csv
import io
import json
import pathlib
import tempfile
import unittest

from harness import ROOT, run

STUDIES = ROOT / "examples" / "studies"
# Of the block above a road: the columns of rows whose names have a unit, by their keys.
ROAD_COLUMNS = {"loads.water.height": "loads.water.height_m"}
SLAB = """topple: 1
length_unit: m
block:
  slab: {width: 2, height: HEIGHT}
base: {mated: true}
friction_angle_deg: FRICTION
tilt: {towards: left, angle_deg: TILT}
"""


def slab(height="2", friction="30", tilt="25"):
    return SLAB.replace("HEIGHT", height).replace("FRICTION", friction).replace("TILT", tilt)


class StudyCase(unittest.TestCase):
    def setUp(self):
        own = tempfile.TemporaryDirectory()
        self.addCleanup(own.cleanup)
        self.folder = pathlib.Path(own.name)
        (self.folder / "slab.yaml").write_text(slab())

    def write(self, text, name="study.yaml"):
        (self.folder / name).write_text("topple_study: 1\nscene: slab.yaml\n" + text)
        return name

    def study(self, *words, status=0):
        own, out, err = run("study", *words, folder=self.folder)
        self.assertEqual(own, status, err)
        return err if status else out

    def summary(self, *words):
        return json.loads(self.study("--json", *words))

    def rows(self, name="rows.csv"):
        return list(csv.DictReader(io.StringIO((self.folder / name).read_text())))


def shown(number):
    """What solve says, with the digits that a row has."""
    return float(f"{number['value']:.9e}")


def factor(case, definition):
    """The factor of safety of a case by a definition, as a row has it. Of several the one that counts, which stands last."""
    found = [own for own in case["factors"] if own["definition"] == definition]
    if not found or found[-1].get("fos_is") == "undecided":
        return ""
    if found[-1]["fos"] is not None:
        return shown(found[-1]["fos"])
    return float("-inf" if found[-1]["fos_is"].startswith("none") else "inf")


def counts(summary, tilt=0):
    return {own["outcome"]: own["samples"] for own in summary["tilts"][tilt]["outcomes"]}
