# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Forces at the limit on the second page of a sheet, and the factors by strength and on driving loads.

The story: a reviewer adds up the forces at the limit with a pocket calculator, and what is left is less than the last printed
digit; the program says that they cancel within a bound, and the bound is kept by rationals. The loads among these forces are
put together here from the formulas of docs/loads.md, which share no code with Topple. The reduced strength is put into the scene,
and its block is then at its limit at the very tilt."""

import json
import math
import pathlib
import re
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, main, run, solve
from report_case import Page, words

HEAD = "topple: 1\nlength_unit: m\n"
L, T, GAMMA = 6, 3, 26
SLAB = f"block: {{outline: [[0, 0], [{L}, 0], [{L}, {T}], [0, {T}]], unit_weight_kn_m3: {GAMMA}}}\nfriction_angle_deg: 38\n"
SCENES = {
    "weight alone": SLAB + "tilt: {towards: left, angle_deg: 20}\n",
    "to the right": SLAB + "tilt: {towards: right, angle_deg: 20}\n",
    "water": SLAB + "tilt: {towards: left, angle_deg: 20}\nloads: {water: {height: 1.5, uplift: true}}\n",
    "cohesion": SLAB + "tilt: {towards: right, angle_deg: 30}\nloads: {cohesion_kpa: 20}\n",
    "anchor": SLAB + "tilt: {towards: left, angle_deg: 30}\nloads: {anchors: [{at: [4, 3], direction_deg: -60, force_kn: 80}]}\n",
    "earthquake": SLAB + "tilt: {towards: left, angle_deg: 20}\nloads: {seismic: {horizontal: 0.1, vertical: 0.05}}\n",
    "bond": "block: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 40\n"
            "tilt: {towards: left, angle_deg: 12}\nloads: {bond_kpa: 8}\n",
    "no weight": "block: {teeth: {count: 3, width: 0.3, height: 1.2, depth: 0.05, left_end: valley}}\nfriction_angle_deg: 30\n"
                 "tilt: {towards: left, angle_deg: 20}\n",
    "toppling": "block: {outline: [[0, 0], [1, 0], [1.3, 3], [0.3, 3]], unit_weight_kn_m3: 26}\nfriction_angle_deg: 40\n"
                "slope: {dip_deg: 10, towards: right}\n",
}


def exact(number):
    return Fraction(number["value"]), Fraction(number["error"])


def printed(text):
    """A printed number and what its last digit leaves open; of a bound the bound."""
    bound = re.fullmatch(r"0 ± (\S+)", text)
    if bound:
        return 0.0, float(bound.group(1))
    return float(text), 0.5 * 10.0**-len(text.partition(".")[2])


class Balance(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def scene(self, text):
        path = self.path / "scene.yaml"
        path.write_text(HEAD + text, encoding="utf-8")
        return path

    def sheet(self, path, *more):
        status, _, err = run("solve", "--report", self.path / "r.html", *more, path)
        self.assertIn(status, (0, 1), err)
        return Page((self.path / "r.html").read_text(encoding="utf-8"))

    def test_sums_are_zero(self):
        """Applied, used up and reactions cancel by rationals, within the sum of their bounds; the sum that is told holds 0."""
        seen = 0
        for name, text in SCENES.items():
            for case in solve(self.scene(text))["cases"]:
                limit = case["limit"]
                own, block = limit["balance"], case["block"]
                for key in ("share_x", "share_y", "moment_m"):
                    value, error = exact(own["sum"][key])
                    self.assertLessEqual(abs(value), error, name)
                    self.assertLess(error, 1e-9)
                sums = {key: [Fraction(0), Fraction(0)] for key in ("share_x", "share_y", "moment_m")}
                parts = [own["applied"], own["strength"]]
                for r in limit["reactions"]:
                    along = exact(r["x_m"])[0] - exact(block["centroid_x_m"])[0]
                    up = exact(r["y_m"])[0] - exact(block["centroid_y_m"])[0]
                    x, y = exact(r["share_x"])[0], exact(r["share_y"])[0]
                    reach = sum(exact(block[k])[1] for k in ("centroid_x_m", "centroid_y_m")) + exact(r["x_m"])[1] + exact(r["y_m"])[1]
                    error = (reach * (abs(x) + abs(y)) + (abs(along) + abs(up)) * (exact(r["share_x"])[1] + exact(r["share_y"])[1])) * 2
                    parts.append({"share_x": r["share_x"], "share_y": r["share_y"], "moment_m": (along * y - up * x, error)})
                for part in parts:
                    for key, total in sums.items():
                        value, error = part[key] if isinstance(part[key], tuple) else exact(part[key])
                        total[0] += value
                        total[1] += error
                for key, (value, error) in sums.items():
                    self.assertLessEqual(abs(value), error, f"{name}: {key}")
                seen += 1
        self.assertGreaterEqual(seen, len(SCENES))

    def test_loads_by_hand(self):
        """Weight, earthquake, water and anchor at the limit by docs/loads.md, over the weight, about the centroid."""
        weight = GAMMA * L * T
        for name in ("weight alone", "water", "anchor", "earthquake"):
            case = solve(self.scene(SCENES[name]))["cases"][0]
            a = math.radians(case["limit"]["critical_angle_deg"]["value"])
            sine, cosine = math.sin(a), math.cos(a)
            forces = [(-sine, -cosine, L / 2, T / 2)]
            if name == "earthquake":
                forces.append((-0.1 * cosine + 0.05 * sine, 0.1 * sine + 0.05 * cosine, L / 2, T / 2))
            if name == "water":
                push, lift = 9.81 * 1.5**2 * cosine / 2 / weight, 9.81 * 1.5 * L * cosine / 2 / weight
                forces += [(-push, 0, L, 0.5), (0, lift, 2 * L / 3, 0)]
            if name == "anchor":
                forces.append((80 * math.cos(math.radians(-60)) / weight, 80 * math.sin(math.radians(-60)) / weight, 4, 3))
            own = case["limit"]["balance"]["applied"]
            self.assertAlmostEqual(own["share_x"]["value"], sum(f[0] for f in forces), 12, name)
            self.assertAlmostEqual(own["share_y"]["value"], sum(f[1] for f in forces), 12, name)
            moment = sum((f[2] - L / 2) * f[1] - (f[3] - T / 2) * f[0] for f in forces)
            self.assertAlmostEqual(own["moment_m"]["value"], moment, 11, name)

    def test_sheet_adds_up(self):
        """The table of the sheet from its printed digits: each column comes to 0 within them, the weight is vertical, and what is
        told of the sums is below a millionth of the weight."""
        for name, text in SCENES.items():
            page = self.sheet(self.scene(text))
            for table in page.tables("Forces at the limit and their sums"):
                weight = abs(printed(table[1][2])[0])
                self.assertEqual(table[1][0], "weight")
                self.assertEqual((printed(table[1][1])[0], printed(table[1][3])[0]), (0, 0), name)
                for column in (1, 2, 3):
                    rows = [printed(row[column]) for row in table[1:-1]]
                    self.assertLessEqual(abs(sum(v for v, _ in rows)), 1.01 * sum(e for _, e in rows) + 1e-5 * weight, f"{name}: {table}")
                    self.assertLess(printed(table[-1][column])[1], 1e-6 * weight + 1e-12)
                self.assertTrue(table[-1][0].startswith("ΣH"))
            self.assertGreaterEqual(len(page.tables("Forces at the limit and their sums")), 1, name)

    def test_reduced_strength(self):
        """φ_F and c_F of the sheet, put into the scene, bring its limit to the tilt of the scene, by solving anew."""
        for name in ("weight alone", "water", "cohesion", "anchor", "earthquake", "toppling"):
            text = SCENES[name]
            page = self.sheet(self.scene(text))
            equations = [" ".join(side for side, _ in line) for line in page.lines()]
            angle = next(re.search(r"([\d.]+) ?°$", e) for e in equations if e.startswith("φF"))
            settings = [f"--set=friction_angle_deg={angle.group(1)}"]
            if name == "cohesion":
                reduced = next(re.search(r"([\d.]+) ?kPa", e) for e in equations if e.startswith("cF"))
                settings.append(f"--set=loads.cohesion_kpa={reduced.group(1)}")
            status, out, err = run("solve", "--json", *settings, self.scene(text))
            self.assertEqual((status, err), (0, ""))
            case = json.loads(out)["cases"][0]
            tilt = case["tilt_angle_deg"]["value"]
            self.assertAlmostEqual(case["onset"]["critical_angle_deg"]["value"], tilt, delta=0.01, msg=name)

    def test_on_driving_loads(self):
        """Block E begins to slide and topple at 28.735°: the factor on driving loads is the quotient of tangents that stands on the sheet
        and in JSON."""
        scene = ROOT / "examples" / "block_e_valley.yaml"
        case = solve(scene)["cases"][0]
        end, tilt = case["tilt_of_factor_deg"]["value"], case["tilt_angle_deg"]["value"]
        self.assertAlmostEqual(end, case["onset"]["critical_angle_deg"]["value"], 9)
        factor = next(own for own in case["factors"] if own["definition"] == "driving loads")
        self.assertAlmostEqual(factor["fos"]["value"], math.tan(math.radians(end)) / math.tan(math.radians(tilt)), 9)
        page = self.sheet(scene)
        told = [line for line in page.lines() if any("αs" in side for side, _ in line)]
        values = [line[-1][1] for line in told]
        self.assertTrue(any(abs((value.low + value.high) / 2 - factor["fos"]["value"]) < 0.001 for value in values), told)

    def test_design_strength(self):
        """With partial factors the strength that is reduced is the design one: φ_d = arctan(tan φ / 1.25), c_d = c / 1.25."""
        page = self.sheet(ROOT / "examples" / "slope" / "eurocode_slope.yaml")
        equations = [" ".join(side for side, _ in line) for line in page.lines()]
        design = next(float(re.search(r"([\d.]+) ?°$", e).group(1)) for e in equations if e.startswith("φd"))
        self.assertAlmostEqual(design, math.degrees(math.atan(math.tan(math.radians(25)) / 1.25)), 3)
        reduced = next(float(re.search(r"([\d.]+) ?kPa", e).group(1)) for e in equations if e.startswith("cF"))
        status, out, _ = run("solve", "--json", ROOT / "examples" / "slope" / "eurocode_slope.yaml")
        self.assertEqual(status, 1)
        fos = json.loads(out)["load_cases"][0]["fos"]["value"]
        self.assertAlmostEqual(reduced, 2 / 1.25 / fos, 5)


if __name__ == "__main__":
    main()
