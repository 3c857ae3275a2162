#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The support of columns in a row: the force to design for comes first, and what is optimistic says so.

The story: the classic slope of Goodman and Bray at tan(phi) 0.65 needs 2012.9 kN/m on its toe (Wyllie and Mah 2004, section
9.4). `support` printed 236.86 kN/m, the least force of limit analysis, without a caution, and with 260 kN/m acting a motion
can begin. Their method refused scenes in which the force acts."""

import json
import pathlib
import tempfile
import unittest

from harness import main, run

SLOPE = """topple: 1
length_unit: m
slope: {dip_deg: 30, towards: left}
friction_angle_deg: 33.023867556
block: {unit_weight_kn_m3: 25}
columns: {width: 10, step: 1, rise: 5, fall: 5, below_crest: 9, above_crest: 6}
"""
ASKS = "support: {block: column 1, at: [0, 4], fos: 1}\n"


def acts(force_kn, block="column 1"):
    return f"loads: {{forces: [{{block: {block}, at: [0, 4], direction_deg: -30, force_kn: {force_kn}}}]}}\n"


def solved(*parts, options=("--json",)):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "scene.yaml").write_text(SLOPE + "".join(parts), encoding="utf-8")
        status, out, err = run("solve", *options, "scene.yaml", folder=folder, timeout=600)
    if status not in (0, 1, 4):
        raise AssertionError(err)
    return json.loads(out)["cases"][0] if "--json" in options else " ".join(out.split())


class ColumnSupport(unittest.TestCase):
    def test_design_value_first(self):
        """Text and Markdown have the published force first, and label the other one."""
        text = solved(ASKS, options=())
        design = "support for a factor of 1 2012.9 kN/m, by Goodman and Bray"
        optimistic = "optimistic: forces can hold with 236.86 kN/m, but a motion may begin"
        self.assertIn(design, text)
        self.assertIn(optimistic, text)
        self.assertLess(text.index(design), text.index(optimistic))
        self.assertIn("2012.9 kN/m, by Goodman and Bray (optimistic: 236.86 kN/m)", solved(ASKS, options=("--table",)))
        support = solved(ASKS)["support"]
        self.assertAlmostEqual(support["goodman_bray_n_m"] / 1000, 2012.9, delta=0.05)
        self.assertAlmostEqual(support["force_n_m"]["value"] / 1000, 236.86, delta=0.005)

    def test_force_at_the_toe(self):
        """With a force that acts the toe lacks so much less, and with the design value its factor is 1."""
        lacks = solved()["goodman_bray"]["support_n_m"]
        self.assertAlmostEqual(lacks / 1000, 2012.9, delta=0.05)
        acted = solved(acts(260))["goodman_bray"]
        self.assertAlmostEqual(acted["support_n_m"], lacks - 260e3, delta=1e-3)
        self.assertAlmostEqual(solved(acts(lacks / 1000))["goodman_bray"]["fos"], 1, delta=1e-6)

    def test_force_elsewhere(self):
        """On another column the method knows no force, and says so."""
        case = solved(acts(1, "column 3").replace("[0, 4]", "[21, 8]"), options=())
        self.assertIn("it knows no loads besides weights, an earthquake and forces on the toe", case)


main()
