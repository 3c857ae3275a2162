# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a study tells besides its probabilities: the answer and what it rests on, the factor of safety by what governs it, worked out anew from the rows, and
design values beside closed forms."""

import json
import math
import statistics

from harness import main, run
from study_case import STUDIES, StudyCase, slab

DEFINITIONS = ("moments", "shear strength", "shear strength with roughness", "strength reduction", "driving loads")


def quantile(values, probability):
    """Between order statistics, (n - 1) p from the first."""
    values = sorted(values)
    at = (len(values) - 1) * probability
    low = math.floor(at)
    return values[low] + (at - low) * (values[min(low + 1, len(values) - 1)] - values[low])


class Told(StudyCase):
    def road(self, *words):
        """The block above a road: its summary, page and rows."""
        path = STUDIES / "block_above_road_study.yaml"
        rows = self.folder / "rows.csv"
        status, out, err = run("study", "--json", path, "--csv", rows, *words)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out), run("study", path)[1], self.rows()


class Head(Told):
    def test_what_a_report_quotes(self):
        """The answer stands first, and below it by what each number varies, all its parameters, and what is correlated: as
        the study file has it, so that the page can be judged without the file."""
        summary, page, _ = self.road()
        moves = summary["tilts"][0]["certain_to_move"]
        low, share, high = (f"{100 * moves[key]:.2f}" for key in ("low", "share", "high"))
        stands = f"{100 * summary['tilts'][0]['certain_to_stand']['share']:.2f}"
        answer = f"\nAt 22° certain to move: {share} % ({low} to {high} %), to stand: {stands} %\n"
        self.assertIn(answer, page)
        self.assertLess(page.index(answer), page.index("Variables"))
        for law in ("    normal: mean 36, deviation 3, between 25 and 50\n", "    uniform: 25.6 to 26.8\n",
                    "    beta: a 1.2, b 3, 0 to 2.5\n", "    triangular: 0 to 0.15, mode 0.02\n",
                    "  Correlated\n    friction_angle_deg, loads.water.height: -0.3\n"):
            self.assertIn(law, page)
        self.assertEqual(summary["correlations"], [{"one": "friction_angle_deg", "other": "loads.water.height", "value": -0.3}])
        self.assertEqual(summary["variables"][0]["law"], "mean 36, deviation 3, between 25 and 50")

    def test_other_laws(self):
        (self.folder / "t.csv").write_text("phi\n28\n30\n33\n")
        for law, told in (("empirical: 't.csv:phi'", "empirical: 3 numbers"), ("column: 't.csv:phi'", "column: 3 numbers"),
                          ("list: [30, 40]", "list: 2 numbers"), ("grid: {from: 30, to: 32, step: 1}", "grid: 3 numbers"),
                          ("lognormal: {mean: 30, deviation: 2}, truncated: [20, .inf]", "lognormal: mean 30, deviation 2, above 20"),
                          ("normal: {mean: 30, deviation: 2}, truncated: [-.inf, 40]", "normal: mean 30, deviation 2, below 40")):
            drawn = law.split(":")[0] in ("empirical", "lognormal", "normal")
            self.write(("samples: 5\n" if drawn else "") + f"vary: {{friction_angle_deg: {{{law}}}}}\n")
            self.assertIn(f"\n    {told}\n", self.study("study.yaml"))


class Factors(Told):
    def test_by_what_governs(self):
        """Counts, shares below 1 and quantiles of each definition; all samples have one, and a factor is below 1 exactly
        where the block moves, whatever governs."""
        summary, page, rows = self.road()
        self.assertEqual([own["definition"] for own in summary["governing_factors"]], list(DEFINITIONS))
        self.assertEqual(sum(own["governs"]["samples"] for own in summary["governing_factors"]), len(rows))
        for own in summary["governing_factors"]:
            factors = [float(row["fos"]) for row in rows if row["fos_definition"] == own["definition"]]
            self.assertEqual((own["governs"]["samples"], own["samples"]), (len(factors), len(factors)))
            self.assertEqual(own["governs"]["share"], len(factors) / len(rows))
            self.assertEqual(own["below_1"], sum(factor < 1 for factor in factors))
            for told in own["quantiles"]:
                self.assertAlmostEqual(told["value"], quantile(factors, told["probability"]), 12)
        below = sum(own["below_1"] for own in summary["governing_factors"])
        self.assertEqual(below, summary["tilts"][0]["certain_to_move"]["samples"])
        self.assertRegex(page, r"\n  moments +985 +86 +0\.9")
        self.assertRegex(page, r"\n  strength reduction +3 +3 +0\.9")
        self.assertRegex(page, r"\n  driving loads +12 +2 +0\.8")

    def test_just_beyond_toppling(self):
        """Of a sample that has just toppled the governing factor is little below 1, by moments, and no strength would
        hold it; friction beyond any rock's, which jams it, once made that 0.03."""
        _, _, rows = self.road()
        fallen = [row for row in rows if row["outcome"] == "topples"]
        row = max(fallen, key=lambda one: float(one["limit_deg"]))
        keys = ("friction_angle_deg", "block.unit_weight_kn_m3", "loads.water.height", "loads.seismic.horizontal")
        words = [word for key in keys for word in ("--set", f"{key}={row.get(key, row.get(key + '_m'))}")]
        _, out, _ = run("solve", "--json", *words, STUDIES / "block_above_road.yaml")
        case = json.loads(out)["cases"][0]
        governing = case["governing_fos"]
        self.assertEqual((governing["definition"], row["fos_definition"]), ("moments", "moments"))
        self.assertTrue(0.98 < governing["fos"]["value"] < 1)
        self.assertEqual([own["fos"] for own in case["factors"] if own["definition"] == "strength reduction"], [None])

    def test_one_definition_alone(self):
        """Without a second one there is nothing to tell apart."""
        self.write("samples: 20\nvary: {friction_angle_deg: {uniform: {low: 50, high: 60}}}\n")
        out = self.study("study.yaml")
        self.assertNotIn("What governs", out)


class DesignValues(StudyCase):
    def test_of_friction_alone(self):
        """A slab slides at its friction angle: the design value is the quantile. A Latin hypercube has a sample in each of
        n equal strata, so that the count at the value is n p to within one; the interval ends where Wilson's would."""
        path = STUDIES / "slab_study.yaml"
        own = json.loads(run("study", "--json", path)[1])["design_values"][0]
        law, n = statistics.NormalDist(30, 2), 200
        self.assertLessEqual(abs(law.cdf(own["value"]) - 0.05), 1 / n)
        for end, root in (("low", 1), ("high", -1)):
            count = n * law.cdf(own[end])  # within 1, at which Wilson's interval has 0.05 for an end
            spread = 1.959963984540054
            share = lambda k: (k / n + spread**2 / 2 / n + root * spread * math.sqrt(
                k / n * (1 - k / n) / n + spread**2 / 4 / n**2)) / (1 + spread**2 / n)
            self.assertTrue(share(max(count - 1, 0)) <= 0.05 <= share(count + 1), end)
        self.assertEqual((own["safe"], own["scene_value"], own["quantity"]), ("low", 30, "onset_deg"))
        self.assertEqual(own["quantity_value"], own["value"])

    def test_where_more_is_worse(self):
        """A slab of random height h topples at atan(w / h): the design height is the quantile from above."""
        (self.folder / "slab.yaml").write_text(slab(friction="80", tilt="20"))
        self.write("samples: 500\nvary: {block.slab.height: {uniform: {low: 2, high: 10}}}\n"
                   "design_values: [{of: block.slab.height, probability: 0.1, quantity: moments_deg}]\n")
        own = self.summary("study.yaml")["design_values"][0]
        self.assertLessEqual(abs((10 - own["value"]) / 8 - 0.1), 1 / 500)
        self.assertAlmostEqual(own["quantity_value"], math.degrees(math.atan(2 / own["value"])), 8)
        self.assertEqual(own["safe"], "high")

    def test_for_all_that_varies(self):
        """Under an earthquake k a slab slides at phi - atan k, so that friction alone has to stand for both: with k0 of the
        scene x is where P(phi - atan k <= x - atan k0) is the probability wanted. By quadrature over k, against n samples of
        which a share scatters by sqrt(p (1 - p) / n) at most; 4 of that. `solve` with it has what is told."""
        text = slab(height="0.5").replace("0.5}", "0.5}\n  unit_weight_kn_m3: 26").replace("friction", "loads: {seismic: {horizontal: 0.05}}\nfriction")
        (self.folder / "slab.yaml").write_text(text)
        n, p, k0 = 2000, 0.05, 0.05
        self.write(f"samples: {n}\nvary:\n  friction_angle_deg: {{normal: {{mean: 30, deviation: 2}}}}\n"
                   "  loads.seismic.horizontal: {uniform: {low: 0, high: 0.2}}\n"
                   f"design_values: [{{of: friction_angle_deg, probability: {p}, from: 15, to: 30}},\n"
                   f"  {{of: friction_angle_deg, probability: {p}, quantity: fos, from: 15, to: 30}}]\n")
        angle, factor = self.summary("study.yaml", "--csv", "rows.csv")["design_values"]
        law, steps = statistics.NormalDist(30, 2), 1000
        least = angle["value"] - math.degrees(math.atan(k0))
        share = sum(law.cdf(least + math.degrees(math.atan(0.2 * (j + 0.5) / steps))) for j in range(steps)) / steps
        self.assertLess(abs(share - p), 4 * math.sqrt(p * (1 - p) / n))
        self.assertGreater(law.inv_cdf(p) - angle["value"], 1)  # not the quantile of friction by itself
        rows = self.rows()
        for own, column in ((angle, "onset_deg"), (factor, "fos")):
            below = sum(float(row[column]) <= own["quantity_value"] for row in rows)
            self.assertLessEqual(abs(below - n * p), 1)
            _, out, _ = run("solve", "--json", "--set", f"friction_angle_deg={own['value']!r}", "slab.yaml", folder=self.folder)
            case = json.loads(out)["cases"][0]
            one = case["onset"]["critical_angle_deg"] if column == "onset_deg" else case["governing_fos"]["fos"]
            self.assertAlmostEqual(one["value"], own["quantity_value"], 9)

    def test_without_an_answer(self):
        """Friction that a block does not depend on has no design value, and the page says why; nor has one where all
        samples have the same number, or an end of the range makes no scene."""
        (self.folder / "slab.yaml").write_text(slab(friction="80"))
        self.write("samples: 50\nvary: {friction_angle_deg: {uniform: {low: 70, high: 80}},\n"
                   "  block.slab.height: {uniform: {low: 2, high: 4}}}\n"
                   "design_values:\n- {of: friction_angle_deg, probability: 0.1}\n"
                   "- {of: block.slab.height, probability: 0.1, from: -1, to: 4}\n")
        one, other = self.summary("study.yaml")["design_values"]
        self.assertFalse(one["known"] or other["known"])
        self.assertIn("not between them", one["why"])
        self.assertIn("at -1 the scene has no such number: ", other["why"])
        self.assertIn("friction_angle_deg             no solution for 10 %:\n", self.study("study.yaml"))


if __name__ == "__main__":
    main()
