# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a study tells besides its probabilities: the factor of safety by what governs it, worked out anew from the rows."""

import json
import math

from harness import main, run
from study_case import STUDIES, StudyCase

DEFINITIONS = ("moments", "shear strength", "shear strength with roughness", "strength reduction")


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
        self.assertRegex(page, r"\n  moments +901 +0 +1\.0")
        self.assertRegex(page, r"\n  strength reduction +99 +91 +0\.0")

    def test_just_beyond_toppling(self):
        """Why they are told apart: of a sample that has just toppled `solve` has a factor little below 1 by moments, and
        by strength reduction, which governs, one that only friction beyond any rock's would bring to 1."""
        _, page, rows = self.road()
        fallen = [row for row in rows if row["outcome"] == "topples"]
        row = max(fallen, key=lambda one: float(one["limit_deg"]))
        keys = ("friction_angle_deg", "block.unit_weight_kn_m3", "loads.water.height", "loads.seismic.horizontal")
        words = [word for key in keys for word in ("--set", f"{key}={row[key]}")]
        _, out, _ = run("solve", "--json", *words, STUDIES / "block_above_road.yaml")
        case = json.loads(out)["cases"][0]
        governing = case["governing_fos"]
        factors = {own["definition"]: own["fos"]["value"] for own in case["factors"]}
        self.assertTrue(0.98 < factors["moments"] < 1)
        self.assertLess(factors["strength reduction"], 0.1)
        self.assertEqual(governing["definition"], row["fos_definition"])
        self.assertIn("it leaps from 1 to far\nbelow", page)

    def test_one_definition_alone(self):
        """Without a second one there is nothing to tell apart."""
        self.write("samples: 20\nvary: {friction_angle_deg: {uniform: {low: 50, high: 60}}}\n")
        out = self.study("study.yaml")
        self.assertNotIn("What governs", out)


if __name__ == "__main__":
    main()
