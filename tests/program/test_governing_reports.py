# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The governing factor of safety in table, CSV, JSON and words, and what a script asks by --fail-below."""

import csv
import io
import json
import math
import random
from fractions import Fraction

from governing_case import APEXES, GoverningCase, slab
from harness import ROOT, example_scenes, main, rounded_down, run


class GoverningReports(GoverningCase):
    def test_table_and_csv(self):
        """The same factor and verdict in each; a scene that is wrong costs its own row alone."""
        scenes = [self.scene(slab(k, 7, 33, 20), f"{k}.yaml") for k in range(1, 6)]
        cases = [json.loads(run("solve", "--json", scene)[1])["cases"][0] for scene in scenes]
        wrong = self.scene("topple: 1\n", "wrong.yaml")
        status, out, err = run("solve", "--csv", *scenes[:2], wrong, *scenes[2:])
        self.assertEqual(status, 3)
        self.assertIn("wrong.yaml", err)
        rows = list(csv.DictReader(io.StringIO(out)))
        self.assertEqual(len(rows), 5)
        for row, case in zip(rows, cases):
            governing = case["governing_fos"]
            self.assertEqual(float(row["fos"]), governing["fos"]["value"])
            self.assertEqual(float(row["fos_error"]), governing["fos"]["error"])
            self.assertEqual((row["fos_mechanism"], row["fos_definition"]), (governing["mechanism"], governing["definition"]))
            self.assertEqual((row["verdict"], float(row["tilt_deg"])), (case["mechanism"], 20))
            self.assertEqual(float(row["limit_deg"]), case["limit"]["critical_angle_deg"]["value"])
        status, out, _ = run("solve", "--table", wrong, *scenes)
        self.assertEqual((status, len(out.splitlines())), (3, 7))
        for line, case in zip(out.splitlines()[2:], cases):
            cells = [cell.strip() for cell in line.split("|")]
            self.assertEqual(cells[3:6], ["20.000°", case["mechanism"], rounded_down(case["governing_fos"]["fos"]["value"])])
        self.assertEqual(run("solve", "--table", wrong)[:2], (3, ""))

    def test_the_less_safe_direction_is_told_first(self):
        """A block that leans to the right, tilted to both sides: who reads the first factor alone read that towards the left, 5.0, of a
        block with 1.7. Its mirror says the same of the left; of a block that is its own mirror nothing governs."""
        for sign, worst, apex in ((1, "right", 1), (-1, "left", 1), (1, None, 0)):
            corners = [(0, 0), (sign * 2, 0), (sign * (2 + apex), 6), (sign * apex, 6)]
            text = (f"topple: 1\nlength_unit: m\nblock: {{outline: {[[*corner] for corner in corners]}}}\nfriction_angle_deg: 40\n"
                    f"base: {{profile: [[-9, 0], [9, 0]]}}\ntilt: {{towards: both, angle_deg: 5}}\n")
            scene = self.scene(text)
            status, out, err = run("solve", scene)
            self.assertEqual(status, 0, err)
            factors = {case["towards"]: case["governing_fos"]["fos"]["value"] for case in json.loads(run("solve", "--json", scene)[1])["cases"]}
            told = [line for line in out.splitlines() if line.startswith("Governs")]
            if worst is None:
                self.assertEqual(told, [])
                continue
            self.assertEqual(min(factors, key=factors.get), worst)
            self.assertEqual(told, [f"Governs  towards the {worst}: FoS {factors[worst]:.3f} against toppling about the toe (moments)"])
            self.assertLess(out.index("Governs"), out.index("Tilted towards"))

    def test_utilisation(self):
        """The share of the resistance that is used: a slab of width b and height h at the tilt α uses h tan α / b of its moment
        (Eq. 2), as a rational at tan α = 3/4, and the bound holds it. Where the factor is an upper bound alone, as without
        friction, none is told."""
        tilt = math.degrees(math.atan2(3, 4))
        for b, h in ((3, 2), (8, 5), (2, 7)):
            text = slab(b, h, 80, repr(tilt))
            own = json.loads(run("solve", "--json", self.scene(text))[1])["cases"][0]["governing_fos"]
            if h * 3 > b * 4:  # it topples: the factor is below 1
                self.assertGreater(own["utilisation"]["value"], 1)
            told, truth = own["utilisation"], Fraction(3 * h, 4 * b)
            # the tilt is the double next to atan(3/4): off by 1e-14 degrees at most, of which tan makes 3e-16
            self.assertLessEqual(abs(Fraction(told["value"]) - truth), Fraction(told["error"]) + truth * Fraction(1, 10**15))
            self.assertLess(told["error"], 1e-12)
        free = json.loads(run("solve", "--json", self.scene(slab(3, 2, None, 20)))[1])["cases"][0]["governing_fos"]
        self.assertNotIn("utilisation", free)

    def test_fail_below(self):
        """Exit status 1 where the factor is certainly below, or there is none to compare; 0 only where it is certainly
        as much and the block stands."""
        good = slab(2, 3, 45, 20)  # 1.83 by moments, 2.75 by shear strength
        for design, status in ((1.3, 0), (1.83, 0), (1.84, 1), (3, 1)):
            done, out, err = run("solve", f"--fail-below={design}", self.scene(good))
            self.assertEqual((done, err == ""), (status, status == 0))
            self.assertIn("FoS 1.831", out)
        self.assertIn("its governing factor is below", err)
        for text, why in ((slab(2, 3, 45, None), "gives no tilt"), (slab(2, 3, None, 20), "sliding is not judged"),
                          (slab(2, 3, 15, 20), "not certain to stand"), (APEXES, "factor is below|not certain")):
            status, _, err = run("solve", "--fail-below", "0.1", self.scene(text))
            self.assertEqual(status, 1, text)
            self.assertRegex(err, why)
        scenes = [self.scene(good, "good.yaml"), self.scene(slab(2, 3, 15, 20), "bad.yaml")]
        self.assertEqual(run("solve", "--csv", "--fail-below", "1.3", scenes[0])[0], 0)
        status, out, err = run("solve", "--csv", "--fail-below", "1.3", *scenes)
        self.assertEqual((status, len(out.splitlines())), (1, 3))
        self.assertNotIn("good.yaml", err)
        for words in (["--fail-below", "0"], ["--fail-below", "-1"], ["--fail-below", "nan"], ["--fail-below", "x"],
                      ["--fail-below", "1.3", "--find", "friction_angle_deg", "--for", "fos=1"]):
            self.assertEqual(run("solve", *words, self.scene(good))[0], 2, words)

    def test_required_fos(self):
        """A scene says which factor it requires: page, sheet, JSON and exit status tell whether it is met, as --fail-below does,
        which comes before it; without a tilt or friction it is not met."""
        for required, status, words, met in (("1.3", 0, "the required 1.3 is met", "met"),
                                             ("1.84", 1, "the required 1.84 is not met", "not met"),
                                             ("3/2 + 0.5", 1, "the required 2 is not met", "not met")):
            scene = self.scene(slab(2, 3, 45, 20) + f"required_fos: {required}\n")
            done, out, err = run("solve", scene)
            self.assertEqual((done, err == ""), (status, status == 0))
            self.assertIn(words, out)
            case = json.loads(run("solve", "--json", scene)[1])["cases"][0]
            self.assertEqual(case["governing_fos"]["meets_required"], met)
            self.assertEqual(case["governing_fos"]["required_fos"]["value"], float(Fraction(3, 2) + Fraction(1, 2)) if "/" in required else float(required))
            sheet = self.folder / "sheet.md"
            self.assertEqual(run("solve", "--report", sheet, scene)[0], status)
            self.assertIn(words, sheet.read_text(encoding="utf-8"))
            self.assertEqual(run("solve", "--fail-below", "1.5", scene)[0], 0)
            self.assertEqual(run("solve", "--csv", scene)[0], status)
        for text in (slab(2, 3, 45, None), slab(2, 3, None, 20), slab(2, 3, 15, 20)):
            self.assertEqual(run("solve", self.scene(text + "required_fos: 0.1\n"))[0], 1, text)
        self.assertEqual(run("solve", self.scene(slab(2, 3, 45, 20) + "required_fos: 0\n"))[0], 3)

    def test_fail_below_at_the_factor(self):
        """A slab as wide as high at 45 degrees has exactly 1 by moments: it does not pass as more, and what its bound
        leaves open is undecided rather than passed."""
        for design, allowed in ((1, (1, 4)), (1.0000000001, (1,)), (0.9999999999, (1,))):
            status, _, _ = run("solve", f"--fail-below={design}", self.scene(slab(1, 1, 60, 45)))
            self.assertIn(status, allowed)

    def test_pivots_of_json(self):
        """Ten teeth: all pivots. Four hundred: those that can govern or hold the block, with their index; all of them
        on demand."""
        def scene(count):
            return ("topple: 1\nlength_unit: m\nblock: {teeth: {count: %d, width: 1, height: 900, depth: 1/4, left_end: "
                    "valley}}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n" % count)
        (few,), (many,) = self.solve(scene(10)), self.solve(scene(400))
        (all_of_many,) = self.solve(scene(400), "--pivots=all")
        (few_of_few,) = self.solve(scene(10), "--pivots=governing")
        self.assertEqual((few["pivots_listed"], len(few["pivots"])), ("all", few["pivot_count"]))
        self.assertEqual([p["index"] for p in few["pivots"]], list(range(few["pivot_count"])))
        self.assertEqual((many["pivots_listed"], many["pivot_count"]), ("governing", 401))
        self.assertEqual(len(all_of_many["pivots"]), 401)
        for case, listed in ((all_of_many, many), (few, few_of_few)):
            self.assertLess(len(listed["pivots"]), 20)
            indices = [p["index"] for p in listed["pivots"]]
            self.assertIn(listed["toppling"]["pivot"], indices)
            self.assertEqual(listed["pivots"], [case["pivots"][k] for k in indices])
            self.assertTrue({k for k, p in enumerate(case["pivots"]) if p["admissible"]} <= set(indices))
        self.assertEqual(run("solve", "--pivots=some", "--json", self.scene(scene(3)))[0], 2)
        self.assertEqual(run("solve", "--pivots=all", self.scene(scene(3)))[0], 2)

    def test_pivots_that_are_not_asked_for(self):
        """Random rough undersides, half of them under an earthquake: the pivots that can govern or hold the block are
        the same whether the others get numbers or not, and those that bear the limit's reactions are among them."""
        draw = random.Random(14)
        bearing = 0
        for round_number in range(40):
            count = draw.randint(20, 60)
            under = [(k, Fraction(draw.randint(0, 6), 12)) for k in range(count)]
            outline = ", ".join(f"[{x}, {y}]" for x, y in under + [(count - 1, 30), (0, 30)])
            text = (f"topple: 1\nlength_unit: m\nblock: {{outline: [{outline}], unit_weight_kn_m3: 26}}\n"
                    "base: {mated: true, beyond: {left: 1, right: 1}}\n"
                    f"friction_angle_deg: {draw.randint(15, 45)}\ntilt: {{towards: both, angle_deg: {draw.randint(0, 40)}}}\n")
            if round_number % 2:
                text += "loads: {seismic: {horizontal: 0.1}}\n"
            few, every = self.solve(text, "--pivots=governing"), self.solve(text, "--pivots=all")
            for some, whole in zip(few, every):
                self.assertEqual(some["mechanism"], whole["mechanism"], text)
                listed = {p["index"]: p for p in some["pivots"]}
                self.assertLessEqual({k for k, p in enumerate(whole["pivots"]) if p["admissible"]}, set(listed), text)
                for k, pivot in listed.items():
                    for key in ("critical_angle_deg", "fos"):
                        a, b = pivot[key], whole["pivots"][k][key]
                        self.assertEqual(a is None, b is None, text)
                        if a is not None:
                            self.assertLessEqual(abs(a["value"] - b["value"]), a["error"] + b["error"], text)
                for force in some["limit"].get("reactions", []):
                    at = [k for k, p in enumerate(whole["pivots"])
                          if all(abs(p[c]["value"] - force[c]["value"]) <= 1e-9 for c in ("x_m", "y_m"))]
                    bearing += len(at) and not whole["pivots"][at[0]]["admissible"]
                    self.assertLessEqual(set(at), set(listed), text)
        self.assertGreater(bearing, 10)

    def test_no_negative_factor_on_a_blocked_pivot(self):
        for path in example_scenes():
            for case in json.loads(run("solve", "--json", path)[1])["cases"]:
                for pivot in case["pivots"]:
                    if not pivot["admissible"] and pivot["fos"] is not None:
                        self.assertGreaterEqual(pivot["fos"]["value"], 0, path.name)

    def test_words(self):
        """An angle that is subtracted is; what is no less safe is no caution; Patton's is what Patton's law gives."""
        f = run("solve", "examples/block_f.yaml")[1]
        self.assertIn("φ − i = 30° − 9.462° = 20.538°", f)
        for text in (f, run("solve", "examples/slab.yaml")[1]):
            self.assertNotIn("Patton", text)
        law = slab(2, 3, 45, 20).replace("friction_angle_deg: 45",
                                         "friction: {law: patton, basic_angle_deg: 30, roughness_angle_deg: 10}")
        self.assertIn("by Patton's law (Eq. 6)", run("solve", self.scene(law))[1])
        e_valley = run("solve", "examples/block_e_valley.yaml")[1]
        self.assertIn("friction is exhausted there at φ − 9.462° = 20.538°", e_valley)
        self.assertNotIn("Caution", e_valley)  # on the other kind of base it would be safer
        goes_on = (ROOT / "examples/block_e_valley.yaml").read_text(encoding="utf-8")
        goes_on = goes_on.replace("beyond: {left: 0, right: 0}", "beyond: {left: 60, right: 60}")
        self.assertIn("Caution: on a base that ends at the toe\n", run("solve", self.scene(goes_on))[1])

    def test_what_ran(self):
        """One line by default, all of it on demand."""
        plain, told = run("solve", "examples/slab.yaml")[1], run("solve", "--verbose", "examples/slab.yaml")[1]
        self.assertNotIn("Effects computed", plain)
        self.assertIn("(--verbose: details).", plain)
        listed = told[told.index("\nEffects computed\n"):]
        for effect in ("moments", "toppling", "sliding", "limit"):
            self.assertRegex(listed, rf"\n  {effect} +[0-9.]+ ms   for ")


if __name__ == "__main__":
    main()
