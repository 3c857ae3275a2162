# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies: probabilities of slabs beside closed forms, by every method of sampling; what varies, varies as it was said; no
sample is dropped; and the summary fits a terminal.

The draws themselves are tested in tests/probability/test_draws*.c and tests/probability/test_copula.c. A Latin hypercube of one variable has one
sample in each of n equal strata, so a count below a number x is n P(X < x) to within one: closed forms are met to 1/n."""

import json
import math
import os
import re
import statistics

from harness import ROOT, main, rounds, run
from study_case import STUDIES, StudyCase, counts, slab


class Probabilities(StudyCase):
    def test_sliding_under_normal_friction(self):
        """A slab slides where the tilt is above its friction angle."""
        summary = json.loads(run("study", "--json", STUDIES / "slab_study.yaml")[1])
        law, n = statistics.NormalDist(30, 2), summary["samples"]
        for k, tilt in enumerate((28, 25, 30, 33)):
            self.assertEqual(summary["tilts"][k]["tilt_deg"], tilt)
            self.assertLessEqual(abs(counts(summary, k)["slides"] - n * law.cdf(tilt)), 1)
            self.assertEqual(counts(summary, k)["slides"] + counts(summary, k)["stands"], n)
        own = summary["tilts"][0]["certain_to_move"]
        self.assertTrue(own["low"] < own["share"] < own["high"])

    def test_toppling_of_a_slab_of_random_height(self):
        """It topples where tan(tilt) is above width over height; friction is out of the way."""
        (self.folder / "slab.yaml").write_text(slab(friction="80", tilt="20"))
        self.write("samples: 500\nvary: {block.slab.height: {uniform: {low: 2, high: 10}}}\ntilts_deg: [15, 30, 40]\n")
        summary = self.summary("study.yaml")
        for k, tilt in enumerate((20, 15, 30, 40)):
            probability = (10 - 2 / math.tan(math.radians(tilt))) / 8
            self.assertLessEqual(abs(counts(summary, k)["topples"] - 500 * probability), 1)
        median = [own for own in summary["quantities"][0]["quantiles"] if own["probability"] == 0.5][0]
        self.assertTrue(median["low"] < math.degrees(math.atan(2 / 6)) < median["high"])
        self.assertEqual(summary["variables"][0]["rank_correlations"][0]["value"], -1)

    def test_methods(self):
        """By Monte Carlo and Sobol' points the same probability, within 4 deviations, and 4 / n log n."""
        for method, away in (("monte_carlo", 4 * math.sqrt(0.25 / 2000)), ("sobol", 4 * math.log(2000) / 2000)):
            self.write(f"samples: 2000\nsampling: {{method: {method}, seed: 5}}\n"
                       "vary: {friction_angle_deg: {normal: {mean: 25, deviation: 2}}}\n")
            summary = self.summary("study.yaml")
            self.assertLess(abs(counts(summary)["slides"] / 2000 - 0.5), away, method)
            self.assertEqual(summary["method"], method)

    def test_sobol_indices(self):
        """The critical angle of a slab depends on width and height alone: log tan of it is the difference of their logs,
        so for a narrow spread of both their shares are those of the squares of their relative spreads."""
        self.write("samples: 16\nsensitivity: {samples: 1500}\nvary:\n  block.slab.width: {uniform: {low: 1.98, high: 2.02}}\n"
                   "  block.slab.height: {uniform: {low: 1.96, high: 2.04}}\n  friction_angle_deg: {uniform: {low: 20, high: 30}}\n")
        summary = self.summary("study.yaml")
        self.assertEqual(summary["sensitivity_samples"], 1500)
        for own, share in zip(summary["variables"], (0.2, 0.8, 0)):
            index = own["sobol_indices"][0]
            self.assertEqual(index["quantity"], "moments_deg")
            for order in ("first", "total"):
                half = (index[f"{order}_high"] - index[f"{order}_low"]) / 2
                self.assertLess(abs(index[order] - share), 2 * half + 0.002, own["key"])
        self.assertEqual(summary["variables"][0]["sobol_indices"][2]["quantity"], "limit_deg")
        self.assertAlmostEqual(summary["variables"][2]["sobol_indices"][2]["total"], 1, delta=0.01)
        self.assertIn("Sobol' indices, moments", self.study("study.yaml", "--threads", "1"))
        self.assertEqual(self.study("study.yaml", "--threads", "7"), self.study("study.yaml", "--threads", "1"))

    def test_reliability_of_first_order(self):
        """A slab slides at 25 degrees where its friction, normal with mean 30 and deviation 2, is below: beta is 2.5, and so
        it is by the samples. It topples where its height, lognormal, is above width over tan(tilt)."""
        self.write("samples: 2000\nvary: {friction_angle_deg: {normal: {mean: 30, deviation: 2}}}\n"
                   "reliability: {quantity: limit_deg, importance: {samples: 400}, subset: {samples: 400}}\n")
        summary = self.summary("study.yaml")
        own = summary["reliability"]
        for rare in (own["importance"], own["subset"]):
            self.assertTrue(rare["low"] <= statistics.NormalDist().cdf(-2.5) <= rare["high"] < 0.02)
        self.assertTrue(own["converged"])
        self.assertAlmostEqual(own["beta"], 2.5, delta=1e-6)
        self.assertAlmostEqual(own["probability"], statistics.NormalDist().cdf(-2.5), delta=1e-7)
        self.assertAlmostEqual(summary["variables"][0]["design_value"], 25, delta=1e-5)
        moves = summary["tilts"][0]["certain_to_move"]
        self.assertTrue(moves["low"] <= own["probability"] <= moves["high"])
        (self.folder / "slab.yaml").write_text(slab(friction="80"))
        self.write("samples: 100\nreliability: {quantity: moments_deg}\nvary:\n"
                   "  block.slab.height: {lognormal: {mean: 3, deviation: 0.3}}\n  friction_angle_deg: {uniform: {low: 79, high: 80}}\n")
        summary = self.summary("study.yaml")
        spread = math.sqrt(math.log(1.01))
        beta = (math.log(2 / math.tan(math.radians(25))) - math.log(3) + spread**2 / 2) / spread
        self.assertAlmostEqual(summary["reliability"]["beta"], beta, delta=1e-6)
        self.assertAlmostEqual(summary["variables"][0]["importance"], 1, delta=1e-6)
        self.assertIn("index beta", self.study("study.yaml"))

    def test_reliability_on_a_slope(self):
        """The dip of a slope is the tilt that a factor needs: it was asked for a `tilt` as well, which doubles the dip. On 20 degrees with a
        friction of mean 35 and deviation 3 the factor tan(phi) / tan(20) is 1 at 20 degrees: beta is 5, on a table as on a slope."""
        lies = ("tilt: {towards: left, angle_deg: 20}", "slope: {dip_deg: 20, towards: left}", "slope: {dip_deg: 20, towards: right}")
        for where in lies:
            (self.folder / "slab.yaml").write_text(slab(height="1", friction="35").replace("tilt: {towards: left, angle_deg: 25}", where))
            self.write("samples: 20\nvary: {friction_angle_deg: {normal: {mean: 35, deviation: 3}}}\nreliability: {quantity: fos}\n")
            summary = self.summary("study.yaml")
            self.assertAlmostEqual(summary["reliability"]["beta"], 5, delta=1e-5)
            self.assertAlmostEqual(summary["variables"][0]["design_value"], 20, delta=1e-4)
        (self.folder / "slab.yaml").write_text(slab(height="1", friction="35").replace("tilt: {towards: left, angle_deg: 25}", "tilt: {towards: left}"))
        self.assertIn("tilt", self.study("study.yaml", status=3))

    def test_two_ways_to_fail(self):
        """A slab that slides below 22 degrees of friction and topples below a width of 2 tan(22) has two design points, 3.5
        deviations away each, and fails by either; one that bends has two beside a saddle. Sampled around all, the intervals hold
        the truth for most seeds. Where nothing can fail there is no number, and the page says so."""
        normal = statistics.NormalDist()
        (self.folder / "slab.yaml").write_text(
            "topple: 1\nlength_unit: m\nparameters: {x1: 0, x2: 0}\nblock: {slab: {width: 1+x2, height: 2}}\nbase: {mated: true}\n"
            "friction_angle_deg: 30+x1\ntilt: {towards: left, angle_deg: 22}\n")
        text = ("samples: 8\nsampling: {seed: SEED}\nvary:\n  x1: {normal: {mean: 0, deviation: 2.2857}}\n"
                "  x2: {normal: {mean: 0, deviation: 0.0548485}}\nreliability: {quantity: limit_deg, importance: {samples: 500}}\n")
        betas = [8 / 2.2857, (1 - 2 * math.tan(math.radians(22))) / 0.0548485]
        slides, topples = (normal.cdf(-beta) for beta in betas)
        held = 0
        seeds = rounds(4, 10)
        for seed in range(1, 1 + seeds):
            self.write(text.replace("SEED", str(seed)))
            own = self.summary("study.yaml")["reliability"]
            self.assertEqual(len(own["design_points"]), 2)
            for point, beta in zip(own["design_points"], sorted(betas)):
                self.assertAlmostEqual(point["beta"], beta, delta=1e-5)
            held += own["importance"]["low"] <= slides + topples - slides * topples <= own["importance"]["high"]
        self.assertGreaterEqual(held, 4 * seeds // 5)
        self.assertIn("another design point: beta 3.5000", self.study("study.yaml"))
        (self.folder / "slab.yaml").write_text(
            "topple: 1\nlength_unit: m\nparameters: {x1: 0, x2: 0}\nblock: {slab: {width: 40, height: 2}}\nbase: {mated: true}\n"
            "friction_angle_deg: 30+x1-0.3*x2^2\ntilt: {towards: left, angle_deg: 26.5}\n")
        truth = sum(normal.cdf(0.3 * (k / 100)**2 - 3.5) * normal.pdf(k / 100) / 100 for k in range(-900, 901))
        held = 0
        seeds = rounds(2, 4)
        for seed in range(1, 1 + seeds):
            self.write(f"samples: 8\nsampling: {{seed: {seed}}}\nvary: {{x1: {{normal: {{mean: 0, deviation: 1}}}}, "
                       "x2: {normal: {mean: 0, deviation: 1}}}\nreliability: {quantity: limit_deg, importance: {samples: 1000}}\n")
            own = self.summary("study.yaml")["reliability"]
            held += own["importance"]["low"] <= truth <= own["importance"]["high"]
        self.assertGreaterEqual(held, seeds // 2)
        square = (3.5 - 1 / 0.6) / 0.3  # of x2 at the points nearest to the means
        self.assertAlmostEqual(own["beta"], math.hypot(3.5 - 0.3 * square, math.sqrt(square)), delta=1e-4)
        (self.folder / "slab.yaml").write_text(slab().replace("block:", "block:\n  unit_weight_kn_m3: 26"))
        self.write("samples: 20\nvary: {block.unit_weight_kn_m3: {uniform: {low: 20, high: 30}}}\n"
                   "reliability: {quantity: limit_deg, importance: {samples: 20}}\n")
        summary = self.summary("study.yaml")
        self.assertEqual([summary["reliability"][key] for key in ("converged", "beta", "probability", "design_points")],
                         [False, None, None, []])
        self.assertEqual([summary["variables"][0][key] for key in ("design_value", "importance")], [None, None])
        self.assertIn("no sample fails", summary["reliability"]["importance"]["why"])
        page = self.study("study.yaml")
        self.assertIn("no design point: the result does not change", page)
        self.assertNotIn("index beta", page)

    def test_correlation(self):
        """Two numbers by a Gaussian copula: their rank correlation is 6 / pi asin(r / 2)."""
        self.write("samples: 4000\nvary:\n  friction_angle_deg: {normal: {mean: 30, deviation: 2}}\n"
                   "  block.slab.height: {uniform: {low: 1, high: 2}}\n"
                   "correlations: [[friction_angle_deg, block.slab.height, -0.6]]\n")
        self.study("study.yaml", "--csv", "rows.csv")
        ranks = []
        for key in ("friction_angle_deg", "block.slab.height_m"):
            values = [float(row[key]) for row in self.rows()]
            order = sorted(range(len(values)), key=values.__getitem__)
            ranks.append([0] * len(values))
            for k, at in enumerate(order):
                ranks[-1][at] = k
        wanted = 6 / math.pi * math.asin(-0.3)
        self.assertLess(abs(statistics.correlation(*ranks) - wanted), 4 * (1 - wanted**2) / math.sqrt(4000))

    def test_lists_are_crossed(self):
        """The first list varies slowest, columns go together, and each combination has its samples."""
        (self.folder / "table.csv").write_text("# tests\nname;width;phi\na;1;20\nb;2;21.5\n")
        self.write("vary:\n  block.slab.height: {list: [1, 3/2]}\n  block.slab.width: {column: 'table.csv:width'}\n"
                   "  tilt.angle_deg: {grid: {from: 0.1, to: 0.3, step: 0.1}}\n  friction_angle_deg: {column: 'table.csv:phi'}\n")
        summary = self.summary("study.yaml", "--csv", "rows.csv")
        self.assertEqual((summary["samples"], summary["method"]), (12, "none"))
        self.assertEqual([tuple(row.values())[1:5] for row in self.rows()],
                         [(height, width, tilt, phi) for height in ("1", "1.5") for tilt in ("0.1", "0.2", "0.3")
                          for width, phi in (("1", "20"), ("2", "21.5"))])
        self.write("samples: 50\nvary:\n  block.slab.height: {list: [1, 2]}\n"
                   "  friction_angle_deg: {uniform: {low: 20, high: 30}}\n")
        self.study("study.yaml", "--csv", "drawn.csv")
        rows = self.rows("drawn.csv")
        self.assertEqual([row["block.slab.height_m"] for row in rows], ["1", "2"] * 50)
        for height in ("1", "2"):  # a Latin hypercube each
            drawn = sorted(float(row["friction_angle_deg"]) for row in rows if row["block.slab.height_m"] == height)
            self.assertEqual([int((phi - 20) * 5) for phi in drawn], list(range(50)))
        self.assertEqual(len({row["friction_angle_deg"] for row in rows}), 100)

    def test_empirical(self):
        """Drawn from a column: between its least and its largest, with its quantiles."""
        (self.folder / "tests.csv").write_text("phi_deg\n" + "".join(f"{20 + k * k / 10}\n" for k in range(11)))
        self.write("samples: 100\nvary: {friction_angle_deg: {empirical: 'tests.csv:phi_deg'}}\n")
        self.study("study.yaml", "--csv", "rows.csv")
        drawn = sorted(float(row["friction_angle_deg"]) for row in self.rows())
        self.assertTrue(20 <= drawn[0] and drawn[-1] <= 30)
        self.assertEqual(sum(phi < 22.5 for phi in drawn), 50)

    def test_nothing_is_dropped(self):
        """A block that history may hold, and numbers of which there is no scene, are counted."""
        (self.folder / "slab.yaml").write_text(
            "topple: 1\nlength_unit: mm\nblock:\n  teeth: {count: 3, width: 15, height: 94, depth: 5, left_end: peak}\n"
            "base: {mated: true}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 20}\n")
        self.write("vary:\n  friction_angle_deg: {grid: {from: -10, to: 60, step: 10}}\n"
                   "  tilt.angle_deg: {grid: {from: 0, to: 90, step: 5}}\n")
        summary = self.summary("study.yaml", "--csv", "rows.csv")
        found = counts(summary)
        self.assertEqual(sum(found.values()), 8 * 19)
        self.assertEqual(found["invalid"], 19)
        self.assertGreater(found["may move"], 0)
        self.assertEqual(len(summary["invalid"]), 5)
        self.assertIn("friction_angle_deg=-10 tilt.angle_deg=0", summary["invalid"][0]["settings"])
        bad = self.rows()[0]
        self.assertEqual((bad["outcome"], bad["status"], bad["limit_deg"]), ("invalid", "invalid", ""))
        self.assertIn("friction_angle_deg", bad["why"])
        self.assertIn("Invalid sample 0\n  friction_angle_deg=-10 tilt.angle_deg=0\n", self.study("study.yaml"))

    def test_seed_of_a_profile(self):
        """The seed of a generated base varies as any number does."""
        scene = (ROOT / "docs" / "generate.md").read_text(encoding="utf-8").split("```yaml\n")[1].split("```")[0]
        (self.folder / "slab.yaml").write_text(scene + "tilt: {towards: left}\n")
        self.write("vary: {base.profile.self_affine.seed: {list: [6, 7, 8, 9]}}\n")
        self.study("study.yaml", "--csv", "rows.csv")
        self.assertEqual(len({row["moments_deg"] for row in self.rows()}), 4)


class Summary(StudyCase):
    def test_it_fits_a_terminal(self):
        for path in sorted(STUDIES.glob("*_study.yaml")):
            status, out, err = run("study", path.name, folder=STUDIES)
            self.assertEqual((status, err), (0, ""))
            self.assertLessEqual(max(map(len, out.splitlines())), 80, path.name)
            self.assertIsNone(re.search(r"\bnan\b|\binf\b", out))

    def test_at_every_tilt(self):
        """An infinite number is said in words: a slab that friction holds at any tilt below its own."""
        (self.folder / "slab.yaml").write_text(slab(height="0.01", friction="89"))
        self.write("vary: {tilt.angle_deg: {list: [0, 10, 20, 30]}}\n")
        out = self.study("study.yaml")
        self.assertIn("always", out)
        self.assertIn("At the scene's tilt, which varies\n", out)
        self.assertEqual(os.listdir(self.folder).count("rows.csv"), 0)


if __name__ == "__main__":
    main()
