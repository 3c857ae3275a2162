# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The rows of a study: those of a sample beside `topple solve`, and the same bytes by any number of threads, in shards,
after kills, on a disk that was full, and where the study stops by itself."""

import fractions
import hashlib
import json
import random
import re
import resource
import signal
import subprocess
import time

from harness import PROGRAM, main, run
from study_case import ROAD_COLUMNS, STUDIES, StudyCase, factor, shown


class Rows(StudyCase):
    def test_rows_are_what_solve_says(self):
        """Every 50th sample, its numbers put into the scene file: every number and word, at each tilt."""
        folder = self.folder
        (folder / "road.yaml").write_text((STUDIES / "block_above_road.yaml").read_text())
        text = (STUDIES / "block_above_road_study.yaml").read_text()
        (folder / "study.yaml").write_text(text.replace("block_above_road.yaml", "road.yaml"))
        self.study("study.yaml", "--csv", "rows.csv")
        rows = self.rows()
        self.assertEqual([int(row["sample"]) for row in rows], list(range(1000)))
        for row in rows[::50]:
            scene = (folder / "road.yaml").read_text()
            for key, old in (("friction_angle_deg", "friction_angle_deg: 36"), ("block.unit_weight_kn_m3", "kn_m3: 26.2"),
                             ("loads.water.height", "height: 0.8"), ("loads.seismic.horizontal", "horizontal: 0.04")):
                self.assertEqual(scene.count(old), 1)
                scene = scene.replace(old, f"{old.split(':')[0]}: {row[ROAD_COLUMNS.get(key, key)]}")
            for tilt, outcome, fos in (("22", "outcome", "fos"), ("26", "outcome_at_26_deg", "fos_at_26_deg")):
                (folder / "one.yaml").write_text(scene.replace("angle_deg: 22", f"angle_deg: {tilt}"))
                one = json.loads(run("solve", "--json", "one.yaml", folder=folder)[1])["cases"][0]
                if outcome == "outcome":
                    self.assertEqual((float(row["fos_moments"]), float(row["fos_sliding"])),
                                     (factor(one, "moments"), factor(one, "shear strength")))
                self.assertEqual(row[outcome], one["mechanism"])
                self.assertEqual(float(row[fos]), shown(one["governing_fos"]["fos"]))
            pivot = one["pivots"][one["toppling"]["pivot"]]
            self.assertEqual(float(row["moments_deg"]), shown(one["toppling"]["critical_angle_deg"]))
            self.assertEqual(float(row["pivot_x_m"]), shown(pivot["x_m"]))
            self.assertEqual(float(row["onset_deg"]), shown(one["onset"]["critical_angle_deg"]))
            self.assertEqual(float(row["limit_deg"]), shown(one["limit"]["critical_angle_deg"]))
            self.assertEqual((row["limit_mechanism"], row["first"], row["status"]),
                             (one["limit"]["mechanism"], one["first"]["mechanism"], "certain"))

    def test_every_thousandth(self):
        """Of 8000 samples of each way to draw, with numbers that make no scene among them: `solve --set` with the numbers of
        the row says the same of it, number by number, or refuses it in the same words."""
        number = {"inf": float("inf"), "-inf": float("-inf")}
        invalid = 0
        for method in ("monte_carlo", "latin_hypercube", "sobol"):
            self.write(f"samples: 8000\nsampling: {{method: {method}, seed: 5}}\nvary:\n"
                       "  friction_angle_deg: {lognormal: {mean: 30, deviation: 6}}\n"
                       "  block.slab.width: {normal: {mean: 1, deviation: 0.6}}\n"
                       "  block.slab.height: {uniform: {low: 1, high: 4}}\n")
            self.study("study.yaml", "--rows", "rows.csv", "--restart")
            rows = self.rows()
            for row in rows[::1000] + [next(row for row in rows if row["status"] == "invalid")]:
                words = [word for key, column in (("friction_angle_deg", "friction_angle_deg"), ("block.slab.width", "block.slab.width_m"),
                                                  ("block.slab.height", "block.slab.height_m"))
                         for word in ("--set", f"{key}={row[column]}")]
                status, out, err = run("solve", "--json", "slab.yaml", *words, folder=self.folder)
                if row["status"] == "invalid":
                    said = row["why"].split(": ", 1)[1]  # behind the place in the file, which for a setting is its key
                    self.assertIn("must be above zero", said)
                    self.assertEqual((status, err.split(": ", 2)[2]), (3, said + "\n"))
                    invalid += 1
                    continue
                one = json.loads(out)["cases"][0]
                pivot = one["pivots"][one["toppling"]["pivot"]]
                governing = one["governing_fos"]
                for column, said in (("moments_deg", one["toppling"]["critical_angle_deg"]), ("pivot_x_m", pivot["x_m"]),
                                     ("pivot_y_m", pivot["y_m"]), ("onset_deg", one["onset"]["critical_angle_deg"]),
                                     ("limit_deg", one["limit"]["critical_angle_deg"]), ("fos", governing["fos"])):
                    self.assertEqual(number.get(row[column]) or float(row[column]), shown(said), (row, column))
                self.assertEqual((float(row["fos_moments"]), float(row["fos_sliding"])),
                                 (factor(one, "moments"), factor(one, "shear strength")), row)
                self.assertEqual([row[column] for column in ("outcome", "fos_mechanism", "fos_definition", "first",
                                                             "limit_mechanism", "status")],
                                 [one["mechanism"], governing["mechanism"], governing["definition"], one["first"]["mechanism"],
                                  one["limit"]["mechanism"], "certain"])
        self.assertGreaterEqual(invalid, 3)

    def test_position_and_seed(self):
        """Where a boulder lies on a bench, and by which seed that is made: every 50th sample with its coordinates moved by hand
        onto the points of that bench, which are written as CSV."""
        study = STUDIES / "block_on_rough_base_study.yaml"
        self.study(study, "--rows", "rows.csv")
        text = (STUDIES / "block_on_rough_base.yaml").read_text()
        rule = [line for line in text.splitlines(keepends=True) if "self_affine" in line or "profile:" in line or "shift:" in line]
        (outline,) = [line for line in text.splitlines() if "outline" in line]
        points = json.loads(outline.split(":", 1)[1])
        rows = self.rows()
        self.assertEqual(len(rows), 400)
        for row in rows[::50]:
            run("solve", STUDIES / "block_on_rough_base.yaml", "--set", f"base.profile.self_affine.seed={row['base.profile.self_affine.seed']}",
                "--write-profile", "bench.csv", folder=self.folder)
            shift = fractions.Fraction(row["base.shift_m"])
            moved = ", ".join(f"[{fractions.Fraction(str(x)) + shift}, {y}]" for x, y in points)
            scene = text.replace(outline, f"  outline: [{moved}]").replace("angle_deg: 35", f"angle_deg: {row['friction_angle_deg']}")
            for line in rule:
                scene = scene.replace(line, "  profile: bench.csv\n" if "profile:" in line else "")
            (self.folder / "one.yaml").write_text(scene)
            one = json.loads(run("solve", "--json", "one.yaml", folder=self.folder)[1])["cases"][0]
            self.assertEqual((row["outcome"], row["limit_mechanism"]), (one["mechanism"], one["limit"]["mechanism"]))
            self.assertEqual(float(row["limit_deg"]), shown(one["limit"]["critical_angle_deg"]))
            self.assertEqual(float(row["moments_deg"]), shown(one["toppling"]["critical_angle_deg"]))

    def test_header(self):
        """Every column says its unit: a length that of the scene, of a parameter too where it is lengths alone; the
        summary has them apart, and the axes of the scatter say them once."""
        (self.folder / "slab.yaml").write_text(
            "topple: 1\nlength_unit: cm\nparameters: {w: 200, both: 30, n: 25}\nblock: {slab: {width: w, height: both}, "
            "unit_weight_kn_m3: 25}\nbase: {mated: true}\nfriction_angle_deg: both\ntilt: {towards: left, angle_deg: n}\n"
            "loads: {seismic: {horizontal: 0.1}, cohesion_kpa: 0}\n")
        units = {"w": ("w_cm", "cm"), "both": ("both", None), "n": ("n", None),
                 "block.unit_weight_kn_m3": ("block.unit_weight_kn_m3", "kN/m3"), "loads.cohesion_kpa":
                 ("loads.cohesion_kpa", "kPa"), "loads.seismic.horizontal": ("loads.seismic.horizontal", None)}
        keys = list(units)
        self.write("vary:\n" + "".join(f"  {key}: {{list: [{20 + k}]}}\n" for k, key in enumerate(keys)))
        summary = self.summary("study.yaml", "--csv", "rows.csv", "--scatter", "scatter.svg")
        self.assertEqual([own["unit"] for own in summary["variables"]], [units[key][1] for key in keys])
        header = (self.folder / "rows.csv").read_text().splitlines()[0].split(",")
        self.assertEqual(header, ["sample", *(units[key][0] for key in keys), "outcome", "fos", "fos_mechanism",
                                  "fos_definition", "fos_moments", "fos_sliding", "first",
                                  "moments_deg", "pivot_x_m", "pivot_y_m", "onset_deg", "limit_deg", "limit_mechanism",
                                  "status", "why"])
        drawn = (self.folder / "scatter.svg").read_text()
        self.assertIn(">w (cm)<", drawn)
        self.assertIn(">loads.cohesion_kpa<", drawn)

    def test_any_layout_gives_the_same_bytes(self):
        """1, 2 and 7 threads; 1, 2, 3 and 5 shards in any order, merged; more shards than chunks."""
        self.write("samples: 230\nsampling: {chunk: 20}\nvary:\n  friction_angle_deg: {normal: {mean: 30, deviation: 2}}\n"
                   "  block.slab.height: {list: [1, 2]}\ntilts_deg: [28, 30]\n")
        whole = self.study("study.yaml", "--csv", "rows.csv", "--threads", "1")
        rows = (self.folder / "rows.csv").read_bytes()
        for threads in (2, 7):
            self.assertEqual(self.study("study.yaml", "--csv", f"{threads}.csv", "--threads", threads), whole)
            self.assertEqual((self.folder / f"{threads}.csv").read_bytes(), rows)
        rng = random.Random(1)
        for shards in (2, 3, 5, 40):
            names = [f"part{shards}_{k}.csv" for k in range(1, shards + 1)]
            for k, name in enumerate(names, 1):
                self.study("study.yaml", "--shard", f"{k}/{shards}", "--csv", name)
            rng.shuffle(names)
            self.assertEqual(self.study("study.yaml", "--merge", *names, "--csv", f"merged{shards}.csv"), whole)
            self.assertEqual((self.folder / f"merged{shards}.csv").read_bytes(), rows)
            self.assertEqual(self.study("study.yaml", "--merge", *names), whole)

    def test_killed(self):
        """50 times at random: nothing is lost, nothing counted twice."""
        self.write("samples: 3000\nsampling: {chunk: 10}\nvary:\n  friction_angle_deg: {normal: {mean: 30, deviation: 2}}\n"
                   "  block.slab.height: {uniform: {low: 1, high: 4}}\n")
        began = time.monotonic()
        whole = self.study("study.yaml", "--csv", "rows.csv", "--threads", "2")
        seconds = time.monotonic() - began
        rng, kills = random.Random(3), 0
        killed, rows = self.folder / "killed.csv", self.folder / "rows.csv"
        while kills < 50:
            with subprocess.Popen([PROGRAM, "study", "study.yaml", "--csv", "killed.csv"], cwd=self.folder,
                                  stdout=subprocess.DEVNULL) as process:
                time.sleep(rng.uniform(0, seconds / 25))
                process.send_signal(signal.SIGKILL if kills % 3 else signal.SIGTERM)
            kills += process.returncode != 0
            if process.returncode == 0:  # it was through before: once more from the beginning
                self.assertEqual(killed.read_bytes(), rows.read_bytes())
                killed.unlink()
                (self.folder / "killed.csv.progress").unlink()
        self.assertEqual(self.study("study.yaml", "--csv", "killed.csv"), whole)
        self.assertEqual((self.folder / "killed.csv").read_bytes(), (self.folder / "rows.csv").read_bytes())
        self.assertEqual(self.study("study.yaml", "--csv", "killed.csv"), whole)  # it is all there
        with open(self.folder / "killed.csv", "ab") as rows:
            rows.write(b"17,half a ro")
        self.assertEqual(self.study("study.yaml", "--csv", "killed.csv"), whole)

    def test_interrupted(self):
        """Ctrl-C: what is known is told, and the program ends by the signal."""
        self.write("samples: 1000000\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n")
        with subprocess.Popen([PROGRAM, "study", "study.yaml", "--csv", "rows.csv"], cwd=self.folder,
                              stdout=subprocess.PIPE, encoding="utf-8",
                              preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as process:
            progress = self.folder / "rows.csv.progress"
            while not progress.exists() or "chunks: 0\n" in progress.read_text():
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            out = process.stdout.read()
        self.assertEqual(process.returncode, -signal.SIGINT)
        samples = len(self.rows())
        self.assertIn(f"{samples} of 1000000 samples, Latin hypercube, seed 1; interrupted", out)

    def test_disk_full(self):
        """Rows that cannot be written: status 5, or the signal of the system; then it goes on."""
        self.write("samples: 500\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n")
        whole = self.study("study.yaml", "--csv", "rows.csv")
        self.assertIn("cannot be written", self.study("study.yaml", "--csv", "/dev/full", status=5))
        self.assertIn("cannot be written", self.study("study.yaml", "--csv", "none/rows.csv", status=5))

        def little_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))

        done = subprocess.run([PROGRAM, "study", "study.yaml", "--csv", "full.csv"], cwd=self.folder,
                              capture_output=True, encoding="utf-8", preexec_fn=little_room)
        self.assertEqual((done.returncode, done.stdout), (5, ""))
        self.assertIn("continues from them", done.stderr)
        self.assertEqual(self.study("study.yaml", "--csv", "full.csv"), whole)
        self.assertEqual((self.folder / "full.csv").read_bytes(), (self.folder / "rows.csv").read_bytes())

    def test_ended_at_once(self):
        """With the header, or some of it, and no word of progress: as a run leaves it that was killed, or found the disk full,
        before its first chunk. It begins; by one byte more it is a file of somebody else."""
        self.write("samples: 100\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n")
        whole = self.study("study.yaml", "--rows", "rows.csv")
        rows = (self.folder / "rows.csv").read_bytes()
        header = rows[:rows.index(b"\n") + 1]
        for begun in (b"", header[:1], header[:30], header):
            (self.folder / "begun.csv").write_bytes(begun)
            self.assertEqual(self.study("study.yaml", "--rows", "begun.csv"), whole)
            self.assertEqual((self.folder / "begun.csv").read_bytes(), rows)
            (self.folder / "begun.csv.progress").unlink()
        for other in (header + b"0", b"x", header[:-1] + b"x\n", header[1:]):
            (self.folder / "begun.csv").write_bytes(other)
            self.assertIn("not the rows of a study", self.study("study.yaml", "--rows", "begun.csv", status=3))
            self.assertEqual((self.folder / "begun.csv").read_bytes(), other)

    def test_ended_as_it_began_anew(self):
        """Of a run that was killed before its first chunk the next one takes the rows back and writes the header again. Killed
        between the two it leaves less than its progress says, and the study begins all the same."""
        self.write("samples: 100\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n")
        whole = self.study("study.yaml", "--rows", "rows.csv")
        rows = (self.folder / "rows.csv").read_bytes()
        header = rows[:rows.index(b"\n") + 1]
        said = (self.folder / "rows.csv.progress").read_text()
        for key, value in (("chunks", 0), ("bytes", len(header)), ("sha256", hashlib.sha256(bytes(8) + header).hexdigest())):
            said = re.sub(rf"(?m)^{key}: .*$", f"{key}: {value}", said)
        (counts,) = re.findall(r"(?m)^counts: \[(.*)\]$", said)
        said = said.replace(counts, ",".join("0" for _ in counts.split(",")))
        for begun in (b"", header[:30], header):
            (self.folder / "begun.csv").write_bytes(begun)
            (self.folder / "begun.csv.progress").write_text(said)
            self.assertEqual(self.study("study.yaml", "--rows", "begun.csv"), whole)
            self.assertEqual((self.folder / "begun.csv").read_bytes(), rows)

    def test_until(self):
        """It stops at the end of a chunk, where one run and merged shards stop alike."""
        text = "samples: 5000\nvary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n"
        self.write(text + "until: {half_width: 0.04}\n")
        whole = self.summary("study.yaml", "--csv", "rows.csv")
        self.assertEqual((whole["end"], whole["samples"] % 100), ("certain", 0))
        for own in whole["tilts"][0]["outcomes"]:
            self.assertLessEqual(own["high"] - own["low"], 0.08)
        # Wilson's half-width at a share of a half, about z / (2 sqrt(n + z^2)): 597 samples
        self.assertEqual(whole["samples"], 600)
        for k in (1, 2):
            self.study("study.yaml", "--csv", f"{k}.csv", "--shard", f"{k}/2")
        self.assertEqual(self.summary("study.yaml", "--merge", "1.csv", "2.csv", "--csv", "merged.csv"), whole)
        self.assertEqual((self.folder / "merged.csv").read_bytes(), (self.folder / "rows.csv").read_bytes())


if __name__ == "__main__":
    main()
