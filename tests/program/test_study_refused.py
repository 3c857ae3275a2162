# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a study refuses: files of others, which stay as they are; what a study file cannot say, where it says it; and what
the command line cannot."""

import fcntl
import json

from harness import main, run
from study_case import StudyCase, slab


class Refused(StudyCase):
    def test_files_of_others(self):
        text = "samples: 300\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n"
        self.write(text)
        for k in (1, 2):
            self.study("study.yaml", "--csv", f"{k}.csv", "--shard", f"{k}/2")

        def refused(says, *words):
            before = {path: path.read_bytes() for path in self.folder.iterdir()}
            self.assertIn(says, self.study(*words, status=3))
            self.assertEqual({path: path.read_bytes() for path in self.folder.iterdir()}, before)

        (self.folder / "mine.csv").write_text("precious\n")
        refused("is not the rows of a study", "study.yaml", "--csv", "mine.csv")
        refused("a file that the study reads", "study.yaml", "--csv", "slab.yaml", "--restart")
        refused("a file that the study reads", "study.yaml", "--csv", "study.yaml", "--restart")
        refused("shard 1 of 2", "study.yaml", "--csv", "1.csv")
        refused("shard 1 is given twice", "study.yaml", "--merge", "1.csv", "1.csv")
        refused("give those of all shards", "study.yaml", "--merge", "1.csv")
        refused("there is no 'mine.csv.progress' beside it", "study.yaml", "--merge", "1.csv", "mine.csv")
        refused("this is a shard", "study.yaml", "--merge", "1.csv", "2.csv", "--csv", "1.csv", "--restart")
        self.write(text.replace("mean: 30", "mean: 31"), "other.yaml")
        refused("another study", "other.yaml", "--merge", "1.csv", "2.csv")
        whole = self.study("study.yaml", "--csv", "rows.csv")
        refused("are there already", "study.yaml", "--merge", "1.csv", "2.csv", "--csv", "rows.csv")
        (self.folder / "slab.yaml").write_text(slab(height="2.5"))
        refused("the scene of these rows, or a file that it names, has changed since", "study.yaml", "--csv", "rows.csv")
        (self.folder / "slab.yaml").write_text(slab())
        self.assertEqual(self.study("study.yaml", "--csv", "rows.csv"), whole)
        progress = self.folder / "1.csv.progress"
        told = progress.read_text()
        for wrong in ("shard: 0", "shard: 3", "shard: 99999999999999999999", "shard: -1"):
            progress.write_text(told.replace("shard: 1", wrong, 1))
            refused("this is not a progress file of a study", "study.yaml", "--merge", "1.csv", "2.csv")
        progress.write_text(told)
        rows = (self.folder / "rows.csv").read_text()
        (self.folder / "rows.csv").write_text(rows.replace("stands", "standz", 1))
        refused("was changed since", "study.yaml", "--csv", "rows.csv")
        (self.folder / "rows.csv").write_text(rows.replace("\n7,", "\n8,", 1))
        refused("out of order", "study.yaml", "--csv", "rows.csv")
        (self.folder / "rows.csv").write_text(rows[:1000])
        refused("missing", "study.yaml", "--csv", "rows.csv")
        self.assertEqual(self.study("study.yaml", "--csv", "rows.csv", "--restart"), whole)
        with open(self.folder / "rows.csv", "rb") as rows:
            fcntl.flock(rows, fcntl.LOCK_EX)
            refused("another run is writing", "study.yaml", "--csv", "rows.csv")

    def test_what_changed(self):
        """Under rows to go on with: the study, its scene, a file of numbers; told which. Comments count: nobody is to guess."""
        (self.folder / "t.csv").write_text("phi\n28\n30\n32\n")
        self.write("samples: 10\nvary: {friction_angle_deg: {empirical: 't.csv:phi'}}\n")
        whole = self.study("study.yaml", "--rows", "rows.csv")
        for name, says in (("study.yaml", "another study, or the study has changed since"), ("slab.yaml", "the scene of these rows"),
                           ("t.csv", "a file of numbers that the study of these rows names has changed since")):
            text = (self.folder / name).read_text()
            (self.folder / name).write_text(text + "\n" if name == "t.csv" else text + "# a word\n")
            self.assertIn(says, self.study("study.yaml", "--rows", "rows.csv", status=3))
            (self.folder / name).write_text(text)
        self.assertEqual(self.study("study.yaml", "--rows", "rows.csv"), whole)

    def test_studies(self):
        """What is wrong, where, and what to do."""
        (self.folder / "t.csv").write_text("phi,x\n1,2\n3\n")
        vary = "samples: 10\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n"
        for text, says in (
                ("vary: {frictoin_angle_deg: {list: [1]}}", r"study.yaml:3:\d+: slab.yaml:\d+:\d+: there is no 'frictoin_angle_deg'"
                 r".*did you mean 'friction_angle_deg'"),
                ("vary: {block.slab.height: {nromal: {mean: 1, deviation: 1}}}", r"study.yaml:3:\d+: .*did you mean 'normal'"),
                ("vary: {block.slab.height: {normal: {mean: 1}}}", r"study.yaml:3:\d+: 'deviation' is missing"),
                ("vary: {block.slab.height: {normal: {mean: 1, deviation: -1}}}", r"study.yaml:3:\d+: .*deviation"),
                ("vary: {block.slab.height: {triangular: {low: 1, mode: 5, high: 3}}}", r"study.yaml:3:\d+: .*mode"),
                ("vary: {block.slab.height: {uniform: {low: 1, high: 3}, truncated: [4, 5]}}", r"study.yaml:3:\d+: .*truncat"),
                ("vary: {block.slab.height: {list: [1], truncated: [4, 5]}}", r"study.yaml:3:\d+: a list is not a distribution"),
                ("vary: {block.slab.height: {list: [1], grid: {from: 1, to: 2, step: 1}}}", "varies by 'list' already"),
                ("vary: {block.slab.height: {truncated: [1, 2]}}", "give the distribution of 'block.slab.height'"),
                ("vary: {block.slab.height: {list: [1, a]}}", r"study.yaml:3:\d+: .*'a'"),
                ("vary: {block.slab.height: {list: 5}}", "list: "),
                ("vary: {block.slab.height: {grid: {from: 1, to: 2, step: -1}}}", "from 'from' to 'to'"),
                ("vary: {block.slab.height: {column: t.csv}}", "its column"),
                ("vary: {block.slab.height: {column: 't.csv:phii'}}", r"t.csv:1:1: no column of the first line, which has 2, is called "
                 "'phii'; write its name letter by letter as that line does$"),
                ("vary: {block.slab.height: {column: 't.csv:x'}}", r"t.csv:3:1: the row ends before"),
                ("vary: {block.slab.height: {list: [1]}, block.slab: {list: [1]}}", "a single number"),
                ("vary: {topple: {list: [1]}}", "not a number of the scene"),
                ("vary: {}", "'vary' is a map"),
                ("samples: 10\nvary: {block.slab.height: {list: [1]}}", "leave 'samples' out"),
                (vary.replace("samples: 10\n", ""), "'samples' is missing"),
                (vary.replace("10", "0"), "a whole number from 1"),
                (vary.replace("10", "ten"), r"study.yaml:3:10: unknown name 'ten'; a number stands here"),
                (vary + "sampling: {method: latin}", "did you mean 'latin_hypercube'"),
                (vary + "sampling: {sede: 1}", "did you mean 'seed'"),
                (vary + "tilts_deg: [10, 10]", "rises"),
                (vary + "tilts_deg: [95]", "between 0 and 90"),
                (vary + "until: {half_width: 0.5}", "between 0 and 0.5"),
                (vary + "until: {}", "half_width"),
                (vary + "correlations: [[friction_angle_deg, friction_angle, 0.5]]", "did you mean 'friction_angle_deg'"),
                (vary + "correlations: [[friction_angle_deg, friction_angle_deg, 0.5]]", "correlation 1 with itself"),
                (vary + "sensitivity: {}", "'samples' is missing"),
                (vary + "sensitivity: {samples: 1}", "a whole number from 16"),
                (vary + "reliability: {quantity: limt_deg}", "did you mean 'limit_deg'"),
                (vary + "reliability: {quantity: fos, subset: {samples: 105}}", "a multiple of 10"),
                (vary + "reliability: {quantity: fos, importance: {}}", "'samples' is missing"),
                (vary + "reliability: {}", "'quantity' is missing"),
                ("vary: {block.slab.height: {list: [1]}}\nreliability: {quantity: fos}", "varies by a list"),
                (vary + "design_values: {of: a}", "design_values is a list of up to 20"),
                (vary + "design_values: [{probability: 0.1}]", "'of' names the number"),
                (vary + "design_values: [{of: friction_angle, probability: 0.1}]", "does not vary.*did you mean 'friction_angle_deg'"),
                (vary + "design_values: [{of: friction_angle_deg}]", "'probability' is missing"),
                (vary + "design_values: [{of: friction_angle_deg, probability: 1}]", "lies between 0 and 1"),
                (vary + "design_values: [{of: friction_angle_deg, probability: 0.01}]", "10 samples are too few .*; take 100 at"),
                (vary + "design_values: [{of: friction_angle_deg, probability: 0.1, quantity: onset}]", "did you mean 'onset_deg'"),
                (vary + "design_values: [{of: friction_angle_deg, probability: 0.1, from: 3}]", "'from' and 'to' go together"),
                (vary + "design_values: [{of: friction_angle_deg, probability: 0.1, from: 3, to: 3}]", "must be above 'from'"),
                (vary + "seed: 1", r"study.yaml:5:1: unknown key 'seed'"),
                ("samples: 10\nvary: {tilt.angle_deg: {uniform: {low: 1, high: 2}}}\ntilts_deg: [1]", "the tilt varies already"),
                ("samples: 10\nvary:\n  a: {uniform: {low: 1, high: 2}}\n  parameters.a: {list: [1]}", "there is no 'a'"),
                ("samples: 10\nvary:\n  block.slab.width: {uniform: {low: 1, high: 2}}\n"
                 "  block.slab.height: {uniform: {low: 1, high: 2}}\n  friction_angle_deg: {uniform: {low: 1, high: 2}}\n"
                 "correlations: [[block.slab.width, block.slab.height, 0.9], [block.slab.height, friction_angle_deg, 0.9], "
                 "[block.slab.width, friction_angle_deg, -0.9]]", r"study.yaml:8:\d+: the correlation of"),
        ):
            with self.subTest(text):
                self.write(text + "\n")
                err = self.study("study.yaml", status=3)
                self.assertRegex(err, says)
                self.assertEqual(err.count("\n"), 1)
        (self.folder / "slab.yaml").write_text(slab().replace("towards: left, ", ""))
        self.write(vary)
        self.assertIn("tilts both ways", self.study("study.yaml", status=3))
        (self.folder / "slab.yaml").write_text(slab().replace(", angle_deg: 25", ""))
        self.write(vary + "tilts_deg: [1]\n")
        self.assertIn("needs one of its own", self.study("study.yaml", status=3))
        self.write(vary + "design_values: [{of: friction_angle_deg, probability: 0.1, quantity: fos}]\n")
        self.assertIn("the scene has none: 'tilt: ", self.study("study.yaml", status=3))
        # a slope is its tilt: reliability asked for another one, with which the dip counted twice
        (self.folder / "slab.yaml").write_text(
            "topple: 1\nlength_unit: m\nslope: {dip_deg: 25, towards: left}\nfriction_angle_deg: 28\n"
            "block: {slab: {width: 2, height: 3}}\nbase: {mated: true, beyond: {left: 1, right: 1}}\n")
        for quantity in ("fos", "limit_deg"):
            self.write("vary: {friction_angle_deg: {normal: {mean: 28, deviation: 2}}}\nsamples: 16\n"
                       f"reliability: {{quantity: {quantity}}}\n")
            found = json.loads(self.study("study.yaml", "--json"))["reliability"]
            self.assertAlmostEqual(found["beta"], (28 - 25) / 2, delta=1e-4)

    def test_words(self):
        for words in (["study"], ["study", "a", "b"], ["study", "a", "--merge"], ["study", "a", "--shard", "3/2", "--csv", "x"],
                      ["study", "a", "--shard", "1/2"], ["study", "a", "--threads", "0"], ["study", "a", "--threads", "2x"],
                      ["study", "a", "--restart"]):
            status, out, err = run(*words)
            self.assertEqual((status, out), (2, ""), words)
            self.assertIn("help", err)


if __name__ == "__main__":
    main()
