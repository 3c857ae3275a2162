# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Every example against the reviewed table tests/data/examples.csv, and the report of each."""

import math
import re
import unittest
from decimal import Decimal

from harness import ROOT, example_scenes, is_readable, main, run, solve, table


def find(case, key):
    """The value of a dotted key; `toppling.kind` is the kind of the governing pivot."""
    if key == "toppling.kind":
        return case["pivots"][case["toppling"]["pivot"]]["kind"]
    for part in key.split("."):
        case = case[part]
    return case


def elements(path):
    """The option, where the scene has an account by elements: not with loads, rounded corners, curves."""
    text = path.read_text(encoding="utf-8")
    return [] if re.search("loads:|rounded:|ellipse:|arcs:|drawing:", text) else ["--elements"]


class Examples(unittest.TestCase):
    def test_table(self):
        """Each row: a word or a count exactly, a number within its bound and half a last digit."""
        solutions = {}
        for row in table("examples.csv"):
            scene = row["scene"]
            if not is_readable(ROOT / "examples" / scene):
                continue
            if scene not in solutions:
                solutions[scene] = solve("examples/" + scene)["cases"]
            case = next(c for c in solutions[scene] if c["towards"] == row["towards"])
            found, expected = find(case, row["key"]), row["expected"]
            with self.subTest(scene=scene, key=row["key"]):
                if isinstance(found, dict):
                    digits = Decimal(expected)
                    half = Decimal(10) ** (digits.adjusted() - 14) / 2 if digits else Decimal(0)
                    away = abs(Decimal(found["value"]) - digits)
                    self.assertLessEqual(away, Decimal(found["error"]) + half)
                else:
                    self.assertEqual(str(found), expected)

    def test_every_example_is_in_the_table(self):
        scenes = {path.name for path in (ROOT / "examples").glob("*.yaml")}
        self.assertEqual(scenes, {row["scene"] for row in table("examples.csv")})

    def test_bounds(self):
        """Every computed number of every example is certain to 1e-9 of its size; what is zero on a symmetric
        block, the centroid and the mixed second moment, or in a motion, to 1e-9 of what it could be."""
        def walk(node, sizes, key=None):
            if isinstance(node, dict) and set(node) == {"value", "error"}:
                self.assertLessEqual(node["error"], max(abs(node["value"]), sizes.get(key, 0)) * 1e-9)
            elif isinstance(node, dict):
                if "second_moment_xx_m4" in node:
                    xx, yy = (node[f"second_moment_{axis}_m4"]["value"] for axis in ("xx", "yy"))
                    sizes = {"second_moment_xy_m4": math.sqrt(xx * yy)} | dict.fromkeys(
                        ("centroid_x_m", "centroid_y_m"), math.sqrt(node["area_m2"]["value"]))
                if "motions" in node:  # places: to that of the block's size
                    sizes = dict.fromkeys(("centre_x_m", "centre_y_m", "x_m", "y_m"), math.sqrt(node["block"]["area_m2"]["value"]))
                if "applied" in node:  # forces that cancel
                    sizes = dict.fromkeys(("share_x", "share_y", "moment_m"), 1)
                if "acceleration_x_g" in node:
                    sizes = dict.fromkeys(("acceleration_x_g", "acceleration_y_g", "angular_g_per_m", "centre_x_m",
                                           "centre_y_m", "share_x", "share_y"), 1)
                for child in node:
                    walk(node[child], sizes, child)
            elif isinstance(node, list):
                for child in node:
                    walk(child, sizes)

        for path in example_scenes():
            walk(solve(path, *elements(path)), {})

    def test_reports_fit_a_terminal(self):
        """The report is at most 80 columns wide, marks one governing pivot a case, and names the
        mechanism."""
        for path in example_scenes():
            status, out, err = run("solve", *elements(path), path)
            self.assertEqual((status, err), (0, ""))
            self.assertLessEqual(max(map(len, out.splitlines())), 80, path.name)
            cases = out.count("\nTilted towards the ") + out.count("\nAs it lies, towards the ")
            self.assertEqual(out.count("  governs\n"), cases, path.name)
            self.assertNotIn("uncertain", out)

    def test_readme(self):
        """README, of 120 lines at most, shows the scene as it stands in examples/ and its answer as it is printed."""
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        scene = (ROOT / "examples/block_e_valley.yaml").read_text(encoding="utf-8")
        self.assertIn(scene.split("\n", 1)[1], readme)
        report = run("solve", "examples/block_e_valley.yaml")[1]
        answer = report[report.index("Tilted towards"): report.index("  Pivot  ")].rstrip()
        self.assertIn(answer + "\n", readme)
        self.assertLessEqual(len(readme.splitlines()), 120)

    def test_account_of_elements(self):
        """Appendix A on block E about its valley: three slabs of weight a b and three triangles of
        a c / 2, arms as in (A1.5) and (A1.6); the sums give the factor of safety."""
        case = solve("examples/block_e_valley.yaml", "--elements")["cases"][0]
        account = case["elements"]["account"]
        self.assertEqual([e["kind"] for e in account], ["slab"] * 3 + ["triangle"] * 3)
        arms = [(15, 65), (45, 65), (75, 65), (10, 10 / 3), (50, 10 / 3), (70, 10 / 3)]
        for element, (x, y), area in zip(account, arms, [3600] * 3 + [75] * 3):
            self.assertAlmostEqual(element["normal_arm_m"]["value"], x / 1000, delta=1e-16)
            self.assertAlmostEqual(element["parallel_arm_m"]["value"], y / 1000, delta=1e-16)
            self.assertAlmostEqual(element["weight"]["value"], area * 1e-6 * 0.02 * 25800, delta=1e-14)
        fos = (case["elements"]["stabilising"]["value"] / case["elements"]["overturning"]["value"])
        self.assertAlmostEqual(fos, case["toppling"]["fos_elements"]["value"], delta=1e-14)


if __name__ == "__main__":
    main()
