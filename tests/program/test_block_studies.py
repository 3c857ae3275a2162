# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies, sweeps, tables, surveys, maps and back-analyses of scenes of many blocks: each row is what `topple solve` says of the same numbers; of a slab and a column
on a slope shares, factors, reliability and design values are those of their closed forms; the same bytes by any number of threads,
in shards, and where a study goes on; and plain words for what is of one block alone."""

import csv
import io
import json
import math
import pathlib
import re
import statistics
import tempfile
import unittest

from harness import ROOT, main, run
from study_case import StudyCase, counts, shown

COLUMNS = "columns: {width: 2, step: 0.2, rise: 1, fall: 1, below_crest: 3, above_crest: 2}\n"
ROW = ("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 36\nrequired_fos: 1\n"
       "block: {unit_weight_kn_m3: 25}\n" + COLUMNS + "joints: [{between: [column 1, column 2], friction_angle_deg: 20}]\n"
       "loads: {seismic: {horizontal: 0.02}}\n")
FEW = ROW.replace("required_fos: 1\n", "").replace("below_crest: 3, above_crest: 2", "below_crest: 1, above_crest: 0")  # two columns
SLAB = ("topple: 1\nlength_unit: m\nslope: {dip_deg: 30, towards: left}\nfriction_angle_deg: 35\nrequired_fos: 1.2\n"
        "block: {unit_weight_kn_m3: 25}\nblocks:\n"
        "  - {name: ground, ground: true, outline: [[-20, -1], [20, -1], [20, 0], [-20, 0]]}\n"
        "  - {name: slab, slab: {width: 4, height: 1}}\n")
VARY = """samples: 6
sampling: {chunk: 4}
vary:
  columns.width: {uniform: {low: 1.4, high: 1.9}}
  slope.dip_deg: {normal: {mean: 29, deviation: 2}}
  friction_angle_deg: {normal: {mean: 34.5, deviation: 3.5}}
  joints.1.friction_angle_deg: {uniform: {low: 0, high: 38}}
  loads.seismic.horizontal: {triangular: {low: 0, mode: 0.02, high: 0.1}}
"""


def governing(own):
    """The factor of safety; where proofs leave it open its upper bound."""
    return own["governing_fos"]["fos"] or {"value": own["governing_fos"]["at_most"], "error": 0}


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
        system = json.loads(out)
        case = next(own for own in system["cases"] if own["towards"] == system["governs_towards"])
        return {**case, "governing_fos": system["governing_fos"]}, status

    def of_row(self, text):
        (self.folder / "study.yaml").write_text("topple_study: 1\nscene: row.yaml\n" + text)
        return "study.yaml"

    def test_rows_are_solves(self):
        """An earthquake acts both ways, and the direction of the least factor is told. Of seven columns: of six and less, motions with less
        strength are looked for in each study, so that a factor that is required makes no difference."""
        columns = ROW.replace("below_crest: 3", "below_crest: 4")
        (self.folder / "row.yaml").write_text(columns)
        summary = self.summary(self.of_row(VARY), "--rows", "rows.csv")
        keys = [own["key"] for own in summary["variables"]]
        below = 0
        for row in self.rows():
            case, status = self.solved("row.yaml", {key: row[f"{key}_m" if key.endswith("width") else key] for key in keys})
            self.assertEqual(float(row["fos"]), shown(governing(case)))
            self.assertEqual(float(row["limit_deg"]), shown(case["critical_angle_deg"]))
            self.assertAlmostEqual(float(row["fos_goodman_bray"]), case["goodman_bray"]["fos"], delta=1e-9)
            self.assertEqual(moves(row), case["verdict"] == "collapses")
            self.assertEqual(row["outcome"] == "may move", case["verdict"] in ("can be held", "may move"))
            self.assertEqual(row["meets_required"] == "not met", status == 1)
            own = case.get("critical_acceleration_g")  # none of what may move at rest
            self.assertEqual(float(row["critical_acceleration_g"]), shown(own) if own else -math.inf)
            below += status == 1
        tilt = summary["tilts"][0]
        self.assertEqual(tilt["certain_to_move"]["samples"], sum(map(moves, self.rows())))
        self.assertEqual(summary["below_required"]["samples"], below)
        # where no factor is required, motions with less strength are not looked for: of what may move the factor is 1 at most
        rows = self.rows()
        (self.folder / "row.yaml").write_text(columns.replace("required_fos: 1\n", ""))
        self.summary("study.yaml", "--rows", "rows.csv", "--restart")
        for row, other in zip(rows, self.rows(), strict=True):
            for key in ("outcome", "limit_deg", "fos_goodman_bray", "critical_acceleration_g", "collapse"):
                self.assertEqual(row[key], other[key], key)
            self.assertLessEqual(float(row["fos"]), float(other["fos"]))
            if row["outcome"] == "may move" and float(row["fos"]) < 1:
                self.assertEqual(other["fos"], "1")
            elif row["outcome"] != "may move":
                self.assertEqual(other["fos"], row["fos"])

        self.assertTrue(0 < tilt["certain_to_move"]["samples"] < below < 6)
        self.assertEqual([own["quantity"] for own in summary["quantities"]],
                         ["moments_deg", "onset_deg", "limit_deg", "fos", "fos_goodman_bray", "critical_acceleration_g", "support_n_m"])
        self.assertEqual([own["samples"] for own in summary["quantities"]], [0, 0, 6, 6, 6, 6, 0])

    def test_what_does_not_matter(self):
        """By their unit weight columns have the same limits and factors, but for digits beyond those that are certain: it orders
        none of them."""
        (self.folder / "row.yaml").write_text(FEW.replace("loads: {seismic: {horizontal: 0.02}}\n", ""))
        summary = self.summary(self.of_row("samples: 20\nvary: {block.unit_weight_kn_m3: {uniform: {low: 20, high: 30}}}\n"))
        self.assertEqual(summary["variables"][0]["rank_correlations"], [])

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
        """A column tips at atan(width/height) before it slides; on the table, and at other tilts. One that no strength holds is certain
        too, by the factor on what drives: it was undecided."""
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
            self.assertEqual(row["status"], "certain")
            factor = math.tan(math.radians(critical)) / math.tan(math.radians(10))  # on what drives: strength alone holds none or all
            self.assertAlmostEqual(float(row["fos"]), factor, delta=2e-6 * factor)
        self.assertEqual((bad["outcome"], bad["status"]), ("invalid", "invalid"))
        self.assertIn("width must be above zero", bad["why"])

    def test_support(self):
        """The slab of 100 kN on 30° needs for a factor F the horizontal force W tan(30° - atan(tan(phi)/F)), nothing where that is
        below zero; pushed down the slope no force is enough where it slides. Not asked for, it has no column."""
        frictions = [20, 25, 31, 34, 40]
        for more, enough in (("", True), (", direction_deg: 180", False)):
            (self.folder / "slab.yaml").write_text(SLAB + f"support: {{block: slab, at: [0, 0.5], fos: 1.2{more}}}\n")
            self.write(f"vary: {{friction_angle_deg: {{list: {frictions}}}}}\n")
            summary = self.summary("study.yaml", "--rows", "rows.csv", "--restart")
            for row, friction in zip(self.rows(), frictions, strict=True):
                needed = 1e5 * math.tan(math.radians(30) - math.atan(math.tan(math.radians(friction)) / 1.2))
                told = float(row["support_n_m"])
                self.assertEqual(row["status"], "certain")
                if needed < 0 or not enough:
                    self.assertEqual(told, 0 if needed < 0 else math.inf)
                else:
                    self.assertAlmostEqual(told, needed, delta=2e-6 * needed)
            self.assertEqual(summary["quantities"][-1]["samples"], 5)
            self.assertIn("support kN/m", self.study("study.yaml"))
            self.assertEqual("beyond: no such support" in self.study("study.yaml"), not enough)
            status, out, err = run("sweep", self.folder / "slab.yaml", "--x", "friction_angle_deg=20,40")
            self.assertEqual(status, 0, err)
            self.assertEqual([row["support_is"] for row in csv.DictReader(io.StringIO(out))], ["" if enough else "none", "not needed"])
            for asks in ("reliability: {quantity: support_n_m}",
                         "design_values: [{of: friction_angle_deg, probability: 0.5, quantity: support_n_m}]"):
                self.write("samples: 4\nvary: {friction_angle_deg: {uniform: {low: 22, high: 38}}}\n" + asks + "\n")
                self.assertIn("with the support as one of the scene's loads: forces", self.study("study.yaml", status=3))
        (self.folder / "slab.yaml").write_text(SLAB)
        self.write("samples: 4\nvary: {friction_angle_deg: {uniform: {low: 22, high: 38}}}\nreliability: {quantity: support_n_m}\n")
        self.assertIn("a quantity is limit_deg", self.study("study.yaml", status=3))

    def test_same_bytes(self):
        """By threads, by shards, and where a study goes on, all of it is read back."""
        (self.folder / "row.yaml").write_text(FEW)
        name = self.of_row(VARY.replace("samples: 6", "samples: 12"))
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
        for text, words in (("roughness: [z2]", "of one block in a section, and this scene has none"),
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
        status, out, err = run("sweep", self.EXAMPLE, "--x", "friction_angle_deg=36,95", "--y", "slope.dip_deg=29,30")
        self.assertEqual(status, 3, err)
        head, *rows = out.splitlines()
        for k, row in enumerate(rows):
            settings = f"friction_angle_deg={(36, 95)[k % 2]}", f"slope.dip_deg={(29, 30)[k // 2]}"
            status, one, err = run("solve", "--csv", self.EXAMPLE, "--set", settings[0], "--set", settings[1])
            if k % 2 == 1:
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
        self.assertEqual(run("sweep", self.EXAMPLE, "--threads", "1", "--x", "friction_angle_deg=36,95", "--y", "slope.dip_deg=29,30")[1], out)

    def test_numbers_of_a_slope(self):
        """Spacing, dip and scatter of a jointed slope, and a sample of it, vary like any number: the rows are those of the scene with the
        number written into it."""
        text = (ROOT / "examples" / "blocks" / "jointed_slope.yaml").read_text(encoding="utf-8").replace("height: 20", "height: 5")
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "slope.yaml"
            for key, old, new in (("joints.1.spacing", "spacing: 3,", "spacing: 2,"), ("joints.1.dip_deg", "dip_deg: 70", "dip_deg: 75"),
                                  ("joints.1.scatter.spacing", "{spacing: 0.3", "{spacing: 0.1"), ("seed", "seed: 3", "seed: 8")):
                scene.write_text(text, encoding="utf-8")
                value = new.rpartition(" ")[2].strip("{},")
                status, out, err = run("sweep", scene, "--x", f"jointed_slope.{key}={value}")
                self.assertEqual(status, 0, err)
                scene.write_text(text.replace(old, new, 1), encoding="utf-8")
                (told,), (truth,) = ([*csv.DictReader(io.StringIO(rows))] for rows in (out, run("solve", "--csv", scene)[1]))
                for column in ("verdict", "fos", "limit_deg", "critical_acceleration_g", "collapse"):
                    self.assertEqual(told[column], truth[column], (key, column))

    def test_tables(self):
        """Of several scenes of many blocks the rows of each, in their order, in CSV and in Markdown; not with one of a single block."""
        scenes = [ROOT / "examples" / "blocks" / name for name in ("toppling_slope.yaml", "wet_columns.yaml")]
        rows = [run("solve", "--csv", scene)[1].splitlines() for scene in scenes]
        self.assertEqual(run("solve", "--csv", *scenes)[1].splitlines(), [rows[0][0], *rows[0][1:], *rows[1][1:]])
        status, out, err = run("solve", "--table", *scenes, "--set", "friction_angle_deg=37")
        self.assertEqual((status, err), (0, ""))
        table = [[cell.strip() for cell in line.split("|")[1:-1]] for line in out.splitlines() if line.startswith("|")]
        self.assertEqual([row[0] for row in table[2:]], ["The slope of Goodman and Bray (1976)", "Columns on a wet slope"])
        self.assertAlmostEqual(float(table[2][7]), math.tan(math.radians(37)) / 0.785544, delta=1e-4)
        self.assertIn("set: friction\\_angle\\_deg = 37", out)
        status, out, err = run("solve", "--csv", scenes[0], ROOT / "examples" / "slab.yaml")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("make two of them", err)


class BlockBatches(StudyCase):
    def test_rows_are_solves(self):
        """A table over a scene of columns: each row what a solve with its numbers says, the worst first, with the factor by Goodman
        and Bray; a figure each."""
        (self.folder / "row.yaml").write_text(ROW[:ROW.index("joints")])
        rows = {"A": (36, 2), "B": (30, 1.5), "C": (25, 1.5)}
        table = self.folder / "table.csv"
        table.write_text("name,friction_angle_deg,columns.width\n" + "".join(f"{name},{phi},{width}\n" for name, (phi, width) in rows.items()))
        status, out, err = run("solve", "--batch", "--csv", "--template", self.folder / "row.yaml", "--figures", self.folder / "figures", table)
        self.assertEqual(status, 1, err)
        told = [*csv.DictReader(io.StringIO(out))]
        # B and C fail, with proven upper bounds alone: 0.72 is worse than 0.89
        self.assertEqual([row["name"] for row in told], ["C", "B", "A"])
        for row in told:
            phi, width = rows[row["name"]]
            case = json.loads(run("solve", "--json", "--set", f"friction_angle_deg={phi}", "--set", f"columns.width={width}",
                                  self.folder / "row.yaml")[1])["cases"][0]
            safety = case["governing_fos"]
            self.assertEqual((row["fos"] and float(row["fos"]), row["fos_is"]), (safety["fos"]["value"] if safety["fos"] else "", safety.get("fos_is", "")))
            self.assertEqual([float(row[key]) if row[key] else None for key in ("at_least", "at_most")],
                             [safety.get(key) for key in ("at_least", "at_most")])
            self.assertNotIn("0.00000", row["remark"])  # nothing is proven from below
            self.assertEqual(row["meets_required"], case["meets_required"])
            self.assertEqual(row["standing"], {"collapses": "fails", "may move": "fails", "can be held": "undecided", "stands": "holds"}[case["verdict"]])
            by_columns = float(re.search(r"by Goodman and Bray the factor is ([\d.]+)", row["remark"])[1].rstrip("."))
            self.assertTrue(0 <= case["goodman_bray"]["fos"] - by_columns < 1e-4, row["remark"])  # rounded down
        self.assertEqual(len([*(self.folder / "figures").iterdir()]), 3)

    def test_stands(self):
        """The slab with friction for more than the factor required holds, with less it is below, with less still it fails."""
        (self.folder / "slab.yaml").write_text(SLAB)
        (self.folder / "table.csv").write_text("name,friction_angle_deg\nA,40\nB,33\nC,20\n")
        out = run("solve", "--batch", "--csv", "--template", self.folder / "slab.yaml", self.folder / "table.csv")[1]
        self.assertEqual([(row["name"], row["standing"], row["verdict"]) for row in csv.DictReader(io.StringIO(out))],
                         [("C", "fails", "slides"), ("B", "below required", "stands"), ("A", "holds", "stands")])


class BlockMaps(StudyCase):
    def test_slab(self):
        """Over friction and dip it slides where these are the same, and has the factor tan(phi)/tan(dip) along the contours."""
        (self.folder / "slab.yaml").write_text(SLAB)
        file = self.folder / "map.csv"
        words = ("--x", "friction_angle_deg=25.3:45", "--y", "slope.dip_deg=20:37", self.folder / "slab.yaml", "--output", file)
        status, _, err = run("chart", "map", "--contours", "governing_fos=1.2,1.4", *words)
        self.assertEqual((status, err), (0, ""))
        seen = set()
        for row in csv.DictReader(io.StringIO(file.read_text())):
            seen.add((row["series"], row["of"]))
            friction, dip, *errors = (float(row[key]) for key in ("friction_angle_deg", "slope.dip_deg", "x_error", "y_error"))
            wanted = 1 if row["series"] == "border" else float(row["of"])
            factor = math.tan(math.radians(friction)) / math.tan(math.radians(dip))
            self.assertLess(max(errors), 1e-3)
            self.assertAlmostEqual(factor, wanted, delta=2e-6 * wanted + 0.1 * sum(errors))
        self.assertEqual(seen, {("border", "slides | can be held"), ("governing_fos_at_most", "1.2"), ("governing_fos_at_most", "1.4")})
        for more, message in ((("--y", "tilt=0:60"), "over two numbers of the scene"), (("--any-tilt",), "as they lie; drop any tilt")):
            status, _, err = run("chart", "map", *words, *more)
            self.assertEqual(status, 3)
            self.assertIn(message, err)


class BlockFinds(StudyCase):
    """Which number of a scene of many blocks gives a wanted result: of a slab and a column closed forms, of columns those that a
    solve with the number confirms."""

    def find(self, text, *words, status=0):
        (self.folder / "own.yaml").write_text(text)
        ended, out, err = run("solve", "--find", *words, self.folder / "own.yaml", "--json")
        self.assertEqual(ended, status, err)
        return json.loads(out)["find"] if status == 0 else err

    def holds(self, found, truth):
        self.assertEqual(len(found["solutions"]), 1, found)
        own = found["solutions"][0]
        self.assertLessEqual(abs(own["value"] - truth), own["error"] * (1 + 1e-9), found)
        self.assertLessEqual(own["error"], 1e-4 * abs(truth))

    def test_slab(self):
        """It has the factor tan(phi)/tan(30°), and slides where it dips phi; a horizontal force W tan(30° - phi') holds it, with phi' that of
        the strength divided by the factor."""
        degree = math.radians(1)
        found = self.find(SLAB, "friction_angle_deg", "--for", "fos=1.2", "--from", "20", "--to", "50")
        self.holds(found, math.atan(1.2 * math.tan(30 * degree)) / degree)
        self.assertEqual(found["blocks"][0]["verdict"], "stands")
        self.assertAlmostEqual(found["blocks"][0]["standing_fos"], 1.2, delta=1e-4)
        found = self.find(SLAB, "friction_angle_deg", "--for", "limit_angle=41", "--to", "60")
        self.holds(found, 41)
        found = self.find(SLAB, "friction_angle_deg", "--for", "critical_acceleration=0.1", "--to", "60")
        self.holds(found, 30 + math.atan(0.1) / degree)
        push = SLAB + "loads: {forces: [{block: slab, at: [0, 0.5], direction_deg: -30, force_kn: 10}]}\n"
        needed = 100 * math.tan(30 * degree - math.atan(math.tan(35 * degree) / 1.5))
        found = self.find(push, "loads.forces.1.force_kn", "--for", "limit_fos=1.5", "--to", "100")
        self.holds(found, needed)
        self.assertTrue(needed < found["design"] < needed * 1.001 + 0.1)
        self.assertGreater(found["design_result"]["value"], 1.5)
        # The factor of safety is less than that by strength: 1.5 times W sin(30°) is held by (W cos(30°)) tan(35°) and by the force,
        # which rests, acts along the horizontal into the slope, and so along the base by cos(30°) and across it by sin(30°).
        tangent = math.tan(35 * degree)
        resting = (1.5 * math.sin(30 * degree) - tangent * math.cos(30 * degree)) / (math.cos(30 * degree) + tangent * math.sin(30 * degree))
        found = self.find(push, "loads.forces.1.force_kn", "--for", "fos=1.5", "--to", "100")
        self.holds(found, 100 * resting)
        self.assertEqual(found["blocks"][0]["governing_fos"]["definition"], "driving loads")
        self.assertNotIn("is_upper_bound", found["blocks"][0])
        self.assertTrue(100 * resting < found["design"] < 100 * resting * 1.001 + 0.1)

    def test_column(self):
        """A column of height 4 that does not slide tips at 30° where it is 4 tan(30°) wide."""
        text = SLAB.replace("width: 4, height: 1", "width: w, height: 4").replace("length_unit: m\n", "length_unit: m\nparameters: {w: 3}\n")
        found = self.find(text.replace("35", "50"), "w", "--for", "limit_angle=30", "--from", "1", "--to", "4")
        self.holds(found, 4 * math.tan(math.radians(30)))

    def test_columns(self):
        """Of six columns a solve with the number found has the result that was asked for, by either method; the page says what the factor
        of safety is there, that a motion can begin, and the factor by the other method."""
        columns = ROW[:ROW.index("joints")]
        for target, key in (("fos_goodman_bray", "goodman_bray"), ("limit_fos", "fos")):
            found = self.find(columns, "friction_angle_deg", "--for", f"{target}=1.2", "--from", "32", "--to", "42")
            own = found["solutions"][0]
            status, out, _ = run("solve", "--json", "--set", f"friction_angle_deg={own['value']!r}", self.folder / "own.yaml")
            case = json.loads(out)["cases"][0]
            told = case["goodman_bray"]["fos"] if key == "goodman_bray" else case["fos"]["value"]
            self.assertAlmostEqual(told, 1.2, delta=5e-6)
            self.assertEqual(found["blocks"][0]["verdict"], case["verdict"])
            self.assertAlmostEqual(found["blocks"][0]["fos_goodman_bray"], case["goodman_bray"]["fos"], delta=1e-9)
            self.assertEqual("moving_fos" in found["blocks"][0], case.get("moving_fos", math.inf) < case["fos"]["value"])
        page = run("solve", "--find", "friction_angle_deg", "--for", "limit_fos=1.2", "--from", "34", "--to", "35", self.folder / "own.yaml")[1]
        self.assertIn("limit_fos is an upper bound: up to it forces can hold the blocks", page)
        self.assertIn("this is an upper bound: no smaller factor is proven there", page)
        self.assertIn("the blocks stand there: no motion can begin, nor with strength divided by 1.1", page)
        self.assertIn("by Goodman and Bray the factor there is 1.1999", page)  # rounded down

    def test_none_and_refused(self):
        found = self.find(SLAB, "friction_angle_deg", "--for", "fos=3", "--from", "31", "--to", "40")
        self.assertEqual(found["solutions"], [])
        self.assertAlmostEqual(found["greatest"]["value"], math.tan(math.radians(40)) / math.tan(math.radians(30)), delta=3e-6)
        for words, message in ((("--for", "critical_angle=30"), "of many blocks there are fos"),
                               (("--for", "fos=1.2", "--least-force"), "gives the least force along a direction"),
                               (("--for", "fos=1.2", "--from", "40", "--to", "31"), "the range is reversed")):
            self.assertIn(message, self.find(SLAB, "friction_angle_deg", *words, status=3))
        status, out, err = run("solve", "--find", "friction_angle_deg", "--for", "critical_acceleration=0.1",
                               ROOT / "examples" / "slab_left.yaml")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("is of scenes of many blocks", err)


if __name__ == "__main__":
    main()
