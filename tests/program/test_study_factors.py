# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The factors of safety by moments and of shear strength in rows of studies, beside the one that governs: each row solved again by
itself has the same, and the table of a sweep is empty where a row has no number."""

import csv
import io
import json
import math

from harness import main, run
from study_case import StudyCase, factor, slab

HEAD = "topple: 1\nlength_unit: m\n"
# what stands in front of it keeps it from sliding, and contact forces from turning about some pivots
STEP = HEAD + """block: {outline: [[0, 0], [4, 0], [4, 1], [13, 1], [13, 11], [0, 11]], unit_weight_kn_m3: 26}
base: {mated: true, beyond: {left: 0, right: 0}}
friction_angle_deg: 10
tilt: {towards: right, angle_deg: 60}
"""
LOADED = HEAD + """block: {slab: {width: 2, height: 3}, unit_weight_kn_m3: 25}
base: {mated: true}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 20}
loads: {water: {height: 1}, seismic: {horizontal: 0.05}, cohesion_kpa: 3}
"""
# a sole of 60 degrees, which overhangs beyond a tilt of 30
STEEP = HEAD + """block: {outline: [[0, 0], [1, 1.75], [1, 4], [0, 4]]}
base: {mated: whole}
friction_angle_deg: 50
tilt: {towards: left, angle_deg: 40}
"""
COLUMNS = {"fos_moments": "moments", "fos_sliding": "shear strength"}


class Beside(StudyCase):
    def compare(self, scene, **lists):
        """The two columns of every row, each as a number, 'inf', '-inf' or nothing."""
        (self.folder / "slab.yaml").write_text(scene)
        self.write("vary:\n" + "".join(f"  {key}: {{list: {values}}}\n" for key, values in lists.items()))
        self.study("study.yaml", "--rows", "rows.csv", "--restart")
        axes = [word for name, key in zip("xy", lists) for word in (f"--{name}", f"{key}={','.join(map(str, lists[key]))}")]
        swept = list(csv.DictReader(io.StringIO(run("sweep", "slab.yaml", *axes, folder=self.folder)[1])))
        rows = self.rows()
        self.assertEqual(len(rows), len(swept))
        for row in rows:
            (other,) = [own for own in swept if all(own[key] == row[key] for key in lists)]
            settings = [word for key in lists for word in ("--set", f"{key}={row[key]}")]
            status, out, err = run("solve", "--json", "slab.yaml", *settings, folder=self.folder)
            self.assertEqual(status, 0, err)
            case = json.loads(out)["cases"][0]
            for column, definition in COLUMNS.items():
                told = row[column] and float(row[column])
                self.assertEqual(told, factor(case, definition), (row, column))
                self.assertEqual(other[column] == "", told == "" or math.isinf(told))
        return [tuple(row[column] for column in COLUMNS) for row in rows], rows

    def test_ways_that_do_not_count(self):
        """Blocked and excluded ways have their factors all the same: at 60° both are below 1 and the block stands."""
        told, rows = self.compare(STEP, **{"tilt.angle_deg": [0, 5, 20, 40, 60], "friction_angle_deg": [10, 35, 60]})
        self.assertEqual(told[:3], [("inf", "inf")] * 3)
        self.assertTrue(all(float(own) < 1 for own in told[-3]))
        self.assertEqual((rows[-3]["outcome"], float(rows[-3]["fos"]) > 1), ("stands", True))

    def test_under_loads(self):
        told, _ = self.compare(LOADED, **{"tilt.angle_deg": [5, 20, 35], "friction_angle_deg": [20, 45]})
        self.assertTrue(all(math.isfinite(float(own)) for pair in told for own in pair))

    def test_none(self):
        """Without friction there is none of sliding, and without a tilt neither; where a sole overhangs no strength holds it."""
        plain = slab(tilt="25").replace("friction_angle_deg: 30\n", "")
        told, _ = self.compare(plain, **{"tilt.angle_deg": [10, 25]})
        self.assertEqual([(own[0] != "", own[1]) for own in told], [(True, "")] * 2)
        told, _ = self.compare(slab().replace(", angle_deg: 25", ""), friction_angle_deg=[20, 30])
        self.assertEqual(told, [("", "")] * 2)
        told, _ = self.compare(STEEP, **{"tilt.angle_deg": [10, 40]})
        self.assertEqual((math.isfinite(float(told[0][1])), told[1][1]), (True, "-inf"))


if __name__ == "__main__":
    main()
