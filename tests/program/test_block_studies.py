# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies and sweeps of scenes of many blocks: each row is what `topple solve` says of the same numbers; of a slab and a column
on a slope shares, factors, reliability and design values are those of their closed forms; the same bytes by any number of threads,
in shards, and where a study goes on; and plain words for what is of one block alone."""

import csv
import io
import json
import math
import statistics
import unittest

from harness import ROOT, main, run
from study_case import StudyCase, counts, shown

COLUMNS = "columns: {width: 2, step: 0.2, rise: 1, fall: 1, below_crest: 3, above_crest: 2}\n"
ROW = ("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 36\nrequired_fos: 1\n"
       "block: {unit_weight_kn_m3: 25}\n" + COLUMNS + "joints: [{between: [column 1, column 2], friction_angle_deg: 20}]\n"
       "loads: {seismic: {horizontal: 0.02}}\n")
SLAB = ("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 35\nrequired_fos: 1.2\n"
        "block: {unit_weight_kn_m3: 25}\nblocks:\n"
        "  - {name: ground, ground: true, outline: [[-20, -1], [20, -1], [20, 0], [-20, 0]]}\n"
        "  - {name: slab, slab: {width: 4, height: 1}}\n")
VARY = """samples: 12
sampling: {chunk: 5}
vary:
  columns.width: {uniform: {low: 1.4, high: 1.9}}
  slope.dip_deg: {normal: {mean: 29, deviation: 2}}
  friction_angle_deg: {normal: {mean: 36, deviation: 3}}
  joints.1.friction_angle_deg: {uniform: {low: 0, high: 38}}
  loads.seismic.horizontal: {triangular: {low: 0, mode: 0.02, high: 0.1}}
"""


def moves(row):
    return row["outcome"] in ("slides", "topples", "slides and topples")


class BlockStudies(StudyCase):
    def setUp(self):
        super().setUp()
        (self.folder / "row.yaml").write_text(ROW)
        (self.folder / "slab.yaml").write_text(SLAB)

    def solved(self, scene, settings):
        """The case of the least factor that solve tells of, and whether the factor required is met."""
        words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        status, out, err = run("solve", "--json", *words, self.folder / scene)
        self.assertIn(status, (0, 1, 4), err)
        return min(json.loads(out)["cases"], key=lambda own: own["fos"]["value"]), status

    def of_row(self, text):
        (self.folder / "study.yaml").write_text("topple_study: 1\nscene: row.yaml\n" + text)
        return "study.yaml"

    def test_rows_are_solves(self):
        """An earthquake acts both ways, and the direction of the least factor is told."""
        summary = self.summary(self.of_row(VARY), "--rows", "rows.csv")
        keys = [own["key"] for own in summary["variables"]]
        below = 0
        for row in self.rows():
            case, status = self.solved("row.yaml", {key: row[f"{key}_m" if key.endswith("width") else key] for key in keys})
            self.assertEqual(float(row["fos"]), shown(case["fos"]))
            self.assertEqual(float(row["limit_deg"]), shown(case["critical_angle_deg"]))
            self.assertAlmostEqual(float(row["fos_goodman_bray"]), case["goodman_bray"]["fos"], delta=1e-9)
            self.assertEqual(moves(row), case["verdict"] == "collapses")
            self.assertEqual(row["outcome"] == "may move", case["verdict"] in ("can be held", "may move"))
            self.assertEqual(row["meets_required"] == "not met", status == 1)
            own = case.get("critical_acceleration_g")
            self.assertEqual(float(row["critical_acceleration_g"]), shown(own) if own else -math.inf)
            below += status == 1
        tilt = summary["tilts"][0]
        self.assertEqual(tilt["certain_to_move"]["samples"], sum(map(moves, self.rows())))
        self.assertEqual(summary["below_required"]["samples"], below)
        self.assertTrue(0 < tilt["certain_to_move"]["samples"] < below < 12)
        self.assertEqual([own["quantity"] for own in summary["quantities"]],
                         ["moments_deg", "onset_deg", "limit_deg", "fos", "fos_goodman_bray", "critical_acceleration_g"])
        self.assertEqual([own["samples"] for own in summary["quantities"]], [0, 0, 12, 12, 12, 12])

    def test_slab(self):
        """It slides where tan(phi) < tan(dip), with the factor tan(phi)/tan(dip): of 64 strata of the friction those below 30° do."""
        self.write("samples: 64\nvary: {friction_angle_deg: {uniform: {low: 22, high: 38}}}\n"
                   "reliability: {quantity: fos}\n"
                   "design_values: [{of: friction_angle_deg, probability: 0.25, quantity: fos}]\n")
        summary = self.summary("study.yaml", "--rows", "rows.csv")
        self.assertEqual(counts(summary)["slides"], 32)
        self.assertEqual(counts(summary)["stands"], 32)
        for row in self.rows():
            friction = float(row["friction_angle_deg"])
            factor = math.tan(math.radians(friction)) / math.tan(math.radians(30))
            self.assertAlmostEqual(float(row["fos"]), factor, delta=2e-6 * factor)
            self.assertAlmostEqual(float(row["limit_deg"]), friction, delta=1e-4)
            acceleration = math.tan(math.radians(friction - 30))
            self.assertAlmostEqual(float(row["critical_acceleration_g"]), acceleration if acceleration > 0 else -math.inf, delta=2e-6)
            self.assertEqual((row["collapse"], row["fos_goodman_bray"]), ("slides", ""))
        needed = math.degrees(math.atan(1.2 * math.tan(math.radians(30))))
        self.assertAlmostEqual(summary["below_required"]["samples"], 64 * (needed - 22) / 16, delta=1)
        own = summary["reliability"]
        self.assertAlmostEqual(own["probability"], statistics.NormalDist().cdf(-own["beta"]), delta=1e-9)
        self.assertAlmostEqual(own["probability"], 0.5, delta=1e-4)
        self.assertAlmostEqual(summary["design_values"][0]["value"], 26, delta=16 / 64)

    def test_column_at_tilts(self):
        """A column tips at atan(width/height) before it slides; on the table, and at other tilts."""
        (self.folder / "slab.yaml").write_text(SLAB.replace("slope: {dip_deg: 30, towards: left}", "tilt: {towards: right, angle_deg: 10}")
                                               .replace("width: 4, height: 1", "width: 1, height: 4"))
        self.write("vary: {blocks.2.slab.width: {list: [0.5, 1, 2, -1]}}\ntilts_deg: [5, 20]\n")
        self.study("study.yaml", "--rows", "rows.csv")
        *rows, bad = self.rows()
        for row in rows:
            critical = math.degrees(math.atan(float(row["blocks.2.slab.width_m"]) / 4))
            self.assertAlmostEqual(float(row["limit_deg"]), critical, delta=1e-4)
            for column, tilt in (("outcome", 10), ("outcome_at_5_deg", 5), ("outcome_at_20_deg", 20)):
                self.assertEqual(row[column], "topples" if critical < tilt else "stands")
        self.assertEqual((bad["outcome"], bad["status"]), ("invalid", "invalid"))
        self.assertIn("width must be above zero", bad["why"])

    def test_same_bytes(self):
        """By threads, by shards, and where a study goes on, all of it is read back."""
        name = self.of_row(VARY)
        whole = self.summary(name, "--rows", "one.csv", "--threads", "1"), (self.folder / "one.csv").read_bytes()
        self.assertEqual((self.summary(name, "--rows", "three.csv", "--threads", "3"), (self.folder / "three.csv").read_bytes()), whole)
        for part in "12":
            self.study(name, "--shard", f"{part}/2", "--rows", f"part{part}.csv")
        self.assertEqual((self.summary(name, "--merge", "part2.csv", "part1.csv", "--rows", "all.csv"),
                          (self.folder / "all.csv").read_bytes()), whole)
        self.assertEqual(self.summary(name, "--rows", "one.csv"), whole[0])
        (self.folder / "one.csv.progress").unlink()
        self.assertIn("restart", self.study(name, "--rows", "one.csv", status=3))

    def test_refused(self):
        for text, words in (("roughness: [z2]", "this scene has many"),
                            ("reliability: {quantity: moments_deg}", "limit_deg, fos, fos_goodman_bray or critical_acceleration_g"),
                            ("reliability: {quantity: critical_acceleration_g}", "with the earthquake in the scene")):
            self.write("samples: 4\nvary: {friction_angle_deg: {uniform: {low: 22, high: 38}}}\n" + text + "\n")
            self.assertIn(words, self.study("study.yaml", status=3))
        self.write("samples: 4\nvary: {blocks.3.slab.width: {uniform: {low: 22, high: 38}}}\n")
        self.assertIn("there is no '3' here", self.study("study.yaml", status=3))


class BlockSweeps(unittest.TestCase):
    EXAMPLE = ROOT / "examples" / "blocks" / "toppling_slope.yaml"

    def test_rows_are_solves(self):
        """Byte by byte those of --csv, and the numbers of --json; of a point that makes no scene its message."""
        status, out, err = run("sweep", self.EXAMPLE, "--x", "friction_angle_deg=36,95,33", "--y", "slope.dip_deg=29,30")
        self.assertEqual(status, 3, err)
        head, *rows = out.splitlines()
        for k, row in enumerate(rows):
            settings = f"friction_angle_deg={(36, 95, 33)[k % 3]}", f"slope.dip_deg={(29, 30)[k // 3]}"
            status, one, err = run("solve", "--csv", self.EXAMPLE, "--set", settings[0], "--set", settings[1])
            if k % 3 == 1:
                self.assertEqual(status, 3)
                self.assertIn("the input is wrong,,", row)
                continue
            own, swept = ([*csv.reader(io.StringIO(text))] for text in (one, f"{head}\n{row}\n"))
            self.assertEqual(own[1][own[0].index("towards"):], swept[1][swept[0].index("towards"):-1])
            case = json.loads(run("solve", "--json", self.EXAMPLE, "--set", settings[0], "--set", settings[1])[1])["cases"][0]
            told = dict(zip(swept[0], swept[1]))
            self.assertEqual(told["verdict"], case["verdict"])
            for column, number in (("fos", case["fos"]["value"]), ("fos_goodman_bray", case["goodman_bray"]["fos"]),
                                   ("limit_deg", case["critical_angle_deg"]["value"]), ("limit_error", case["critical_angle_deg"]["error"])):
                self.assertEqual(float(told[column]), number)
        self.assertEqual(run("sweep", self.EXAMPLE, "--threads", "1", "--x", "friction_angle_deg=36,95,33", "--y", "slope.dip_deg=29,30")[1], out)


if __name__ == "__main__":
    main()
