# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A study that measures the base of each sample: teeth in closed form, where an even number of them lies on the angles of Eqs.
(15) and (16); generated bases as `topple profile` measures them; and of what no such angles are told."""

import csv
import io
import json
import math

from harness import main, run
from study_case import STUDIES, StudyCase, shown

TEETH = """topple: 1
length_unit: mm
parameters: {A: 5}
block:
  teeth: {count: 6, width: 50/3, height: 200-A/2, depth: A, left_end: END}
base: {mated: true}
friction_angle_deg: 60
tilt: {towards: left}
"""
ALL = "[amplitude, rms_height, z2, effective_angle_deg, jrc]"


def by_teeth(amplitude, sign, width=100, height=200):
    """Eq. (15) of a peak, sign 1, and (16) of a valley, sign -1."""
    share = amplitude / height
    return math.degrees(math.atan(width / height / (1 - sign * share - share**2 / 12)))


class Roughness(StudyCase):
    def measured(self, scene, text):
        (self.folder / "slab.yaml").write_text(scene)
        self.write(text)
        return self.summary("study.yaml", "--csv", "rows.csv", "--restart"), self.rows()

    def test_teeth(self):
        """Six teeth: Z2 is their slope, R = A / sqrt 12, i its angle; the critical angle is that of Eq. (15) about a peak
        and of Eq. (16) about a valley, so that all lie on a bound."""
        for end, column in (("peak", "peak_deg"), ("valley", "valley_deg")):
            summary, rows = self.measured(TEETH.replace("END", end),
                                          "vary: {A: {grid: {from: 1, to: 16, step: 3}}}\nroughness: " + ALL + "\n")
            for row in rows:
                depth = float(row["A_mm"])
                slope = depth / (50 / 3)
                truth = {"amplitude_mm": depth, "rms_height_mm": depth / math.sqrt(12), "z2": slope,
                         "effective_angle_deg": math.degrees(math.atan(slope)), "peak_deg": by_teeth(depth, 1),
                         "valley_deg": by_teeth(depth, -1)}
                for name, value in truth.items():
                    self.assertAlmostEqual(float(row[name]) / value, 1, 9, name)
                if row["moments_deg"]:
                    self.assertAlmostEqual(float(row["moments_deg"]), float(row[column]), 8)
            self.assertGreater(summary["bracketed"], 3)
            self.assertEqual(summary["within"], summary["bracketed"])
            self.assertEqual([own["name"] for own in summary["roughness"]],
                             ["amplitude", "rms_height", "z2", "effective_angle_deg", "jrc", "peak_deg", "valley_deg"])
            self.assertEqual([own["unit"] for own in summary["roughness"][:3]], ["mm", "mm", None])
            told = summary["roughness"][0]
            self.assertAlmostEqual(told["least"], 1, 12)
            self.assertAlmostEqual(told["greatest"], 16, 12)

    def test_as_profile_measures(self):
        """Of the example, a generated base by its seed: the rows have what `topple profile` says of it, and a merge of two
        shards the same as one run."""
        path, rows = STUDIES / "rough_base_study.yaml", self.folder / "rows.csv"
        page = run("study", path, "--csv", rows)[1]
        self.assertRegex(page, r"Critical angles between these two: \d+ of 100\n")
        scene = (STUDIES / "rough_base.yaml").read_text()
        for row in self.rows()[::37]:
            own = scene.replace("seed: 6", f"seed: {row['base.profile.self_affine.seed']}")
            (self.folder / "one.yaml").write_text(own.replace("jrc: 8", f"jrc: {row['base.profile.self_affine.jrc']}"))
            told = json.loads(run("profile", "--json", "one.yaml", folder=self.folder)[1])
            for column, key in (("z2", "z2"), ("rms_height_mm", "rms_height"), ("amplitude_mm", "amplitude")):
                self.assertEqual(float(row[column]), shown(told[key]))
            self.assertEqual(float(row["jrc"]), shown(told["jrc"]["median"]))
            self.assertAlmostEqual(float(row["peak_deg"]), by_teeth(float(row["amplitude_mm"]), 1), 7)
        for shard in (1, 2):
            run("study", path, "--shard", f"{shard}/2", "--csv", self.folder / f"{shard}.csv")
        _, merged, _ = run("study", path, "--merge", self.folder / "1.csv", self.folder / "2.csv", "--csv", self.folder / "m.csv")
        self.assertEqual(merged, page)
        self.assertEqual((self.folder / "m.csv").read_bytes(), rows.read_bytes())

    def test_blocks_that_are_no_columns(self):
        """A leaning side, a top that slopes, a base that ends before the block does, teeth deeper than half the height: no
        angles by equations that are not for them, and the rest all the same."""
        upright = "[[0, 0], [1, 0], [1, 2], [0, 2]]"
        for outline, base, told in ((upright, "", True), ("[[0, 0], [1, 0], [1.5, 2], [0, 2]]", "", False),
                                    ("[[0, 0], [1, 0], [1, 2], [0, 2.5]]", "", False),
                                    ("[[0, 0], [1, 0], [1, 2], [0.5, 2], [0.4, 1], [0, 2]]", "", False),
                                    ("[[0, 0], [0.5, 0], [1, 0.1], [1, 2], [0, 2]]", ", between: [[0, 0], [0.5, 0]]", False),
                                    ("[[0, 0], [0.5, 1.4], [1, 0], [1, 2], [0, 2]]", ", between: [[0, 0], [1, 0]]", False)):
            scene = (f"topple: 1\nlength_unit: m\nblock: {{outline: {outline}}}\nbase: {{mated: true{base}}}\n"
                     "friction_angle_deg: 30\ntilt: {towards: left}\n")
            summary, rows = self.measured(scene, "vary: {friction_angle_deg: {list: [30]}}\nroughness: [amplitude]\n")
            self.assertEqual(rows[0]["peak_deg"] != "", told, outline)
            self.assertNotEqual(rows[0]["amplitude_m"], "")
            self.assertEqual(summary["bracketed"], told)

    def test_figure(self):
        """Against A of one block the bounds are the curves of the paper, every point of which is worked out again."""
        (self.folder / "slab.yaml").write_text(TEETH.replace("END", "valley"))
        self.write("vary: {A: {list: [9, 3, 6]}}\nroughness: [amplitude]\n")
        self.study("study.yaml", "--scatter", "s.csv")
        rows = list(csv.DictReader(io.StringIO((self.folder / "s.csv").read_text())))
        for sign, name in ((1, "Eq. (15), peak"), (-1, "Eq. (16), valley")):
            points = [(float(row["x"]), float(row["y"])) for row in rows if row["of"] == name]
            self.assertEqual([round(x) for x, _ in points], [3, 6, 9])
            for x, y in points:
                self.assertAlmostEqual(y, by_teeth(x, sign), 8)
        self.study("study.yaml", "--scatter", "s.svg")
        self.assertIn("Eqs. (15), (16)", (self.folder / "s.svg").read_text())

    def test_refused(self):
        for words, says in (("z2", "roughness is a list of numbers"), ("[z3]", "did you mean 'z2'"), ("[z2, z2]", "stands here twice"),
                            ("[[z2]]", "a number of roughness is amplitude")):
            self.write(f"vary: {{friction_angle_deg: {{list: [30]}}}}\nroughness: {words}\n")
            self.assertRegex(self.study("study.yaml", status=3), r"study.yaml:4:\d+: .*" + says)


if __name__ == "__main__":
    main()
