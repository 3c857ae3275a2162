# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The paper's tables and formulas against `topple solve`, and both against independent rationals.

Printed numbers must be the rounding of the computed ones (half a unit of the last digit). The
closed forms of Appendix A are evaluated at 60 digits by exact.py; a computed number must hold the
truth within its own bound, and to 1e-13 relative."""

import pathlib
import random
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import main, rounds, solve, table

# tan of the critical angle as printed in Fig. 8: (N, left end) -> (numerator, denominator) in a, b, c
FIG_8 = {
    (2, "valley"): lambda a, b, c: ((6 * a * b + 3 * a * c), (3 * b * b + 6 * b * c + 2 * c * c)),
    (2, "peak"): lambda a, b, c: ((6 * a * b + 3 * a * c), (3 * b * b - c * c)),
    (3, "valley"): lambda a, b, c: ((27 * a * b + 13 * a * c), (9 * b * b + 18 * b * c + 6 * c * c)),
    (3, "peak"): lambda a, b, c: ((27 * a * b + 14 * a * c), (9 * b * b - 3 * c * c)),
    (4, "valley"): lambda a, b, c: ((12 * a * b + 6 * a * c), (3 * b * b + 6 * b * c + 2 * c * c)),
    (4, "peak"): lambda a, b, c: ((12 * a * b + 6 * a * c), (3 * b * b - c * c)),
}


def elements_of_appendix_a(count, a, b, c, left_end):
    """Arms and weights as Appendix A writes them: N slabs a x b, N triangles, about the left toe."""
    pivot_y = Fraction(0) if left_end == "valley" else c
    elements = [(a * b, k * a + a / 2, c + b / 2 - pivot_y) for k in range(count)]
    for k in range(count):
        falls_to_left = (k % 2 == 0) == (left_end == "valley")  # the valley is the left joint
        arm = k * a + (a / 3 if falls_to_left else 2 * a / 3)
        elements.append((a * c / 2, arm, 2 * c / 3 - pivot_y))
    return elements


def solve_teeth(folder, count, a, b, c, left_end, tilt=None):
    scene = pathlib.Path(folder) / "teeth.yaml"
    angle = "" if tilt is None else f", angle_deg: {tilt}"
    scene.write_text(
        f"topple: 1\nlength_unit: mm\nblock:\n  teeth: {{count: {count}, width: {a}, height: {b}, "
        f"depth: {c}, left_end: {left_end}}}\nbase: {{mated: true, beyond: {{left: 0, right: 0}}}}\n"
        f"tilt: {{towards: left{angle}}}\n")
    return solve(scene)["cases"][0]


def case_of(row):
    cases = solve("examples/" + row["scene"])["cases"]
    return next(c for c in cases if c["towards"] == row.get("towards", c["towards"]))


class Paper(unittest.TestCase):
    def agrees(self, number, truth):
        """The truth lies within the bound, and the number within 1e-13 of it."""
        away = abs(Decimal(number["value"]) - truth)
        self.assertLessEqual(away, Decimal(number["error"]))
        self.assertLessEqual(away, abs(truth) * Decimal("1e-13"))

    def rounds_to(self, number, printed):
        digits = len(printed.partition(".")[2])
        self.assertEqual(f"{number['value']:.{digits}f}", printed)

    def test_table_1(self):
        """All columns: (N, a, b, c), and (dx, y, A, lambda) by conversion, and the other way."""
        for row in table("table1.csv"):
            teeth = case_of(row)["teeth"]
            self.assertEqual(teeth["count"], int(row["N"]))
            for key, column in (("width_m", "a"), ("height_m", "b"), ("depth_m", "c"),
                                ("block_width_m", "dx"), ("mean_height_m", "y"),
                                ("amplitude_m", "A"), ("wavelength_m", "lambda")):
                self.agrees(teeth[key], exact.decimal(Fraction(row[column]) / 1000))
            ends = {teeth["left_end"], teeth["right_end"]}
            self.assertEqual("-".join(sorted(ends)).capitalize(), row["type"])
            with tempfile.TemporaryDirectory() as folder:
                scene = pathlib.Path(folder) / "general.yaml"
                scene.write_text(
                    "topple: 1\nlength_unit: mm\nblock:\n  teeth: {block_width: %s, mean_height: %s, "
                    "amplitude: %s, wavelength: %s, left_end: peak}\n"
                    % (row["dx"], row["y"], row["A"], row["lambda"]))
                back = solve(scene)["cases"][0]["teeth"]
            self.assertEqual(back["count"], int(row["N"]))
            for key in ("width_m", "height_m", "depth_m", "block_width_m", "mean_height_m"):
                self.assertEqual(back[key], teeth[key])

    def test_table_3(self):
        """alpha_ana of every row; i and alpha_slide to the last printed digit, which the paper cuts
        off for block B (19.65 is printed 19.6)."""
        for row in table("table3.csv"):
            case = case_of(row)
            self.rounds_to(case["toppling"]["critical_angle_deg"], row["alpha_ana"])
            kind = case["pivots"][case["toppling"]["pivot"]]["kind"]
            self.assertEqual(kind, row["axis"].lower())
            self.assertLess(abs(abs(case["sliding"]["facet_angle_deg"]["value"]) - float(row["i"])),
                            0.1)
            slide = case["sliding"]["critical_angle_deg"]["value"]
            self.assertLess(abs(slide - float(row["alpha_slide"])), 0.1, row)

    def test_tables_4_and_5(self):
        """Two decimals of alpha_ana."""
        for row in table("table4.csv"):
            angle = case_of(row)["toppling"]["critical_angle_deg"]
            self.rounds_to(angle, row["alpha_ana"])
            self.rounds_to(angle, row["table5"])

    def test_closed_forms_of_the_blocks(self):
        """Fig. 8 for blocks A to G, in every direction of Table 3, at 60 digits."""
        models = {row["model"]: row for row in table("table1.csv")}
        for row in table("table3.csv"):
            m = models[row["model"]]
            n, a, b, c = (Fraction(m[k]) for k in ("N", "a", "b", "c"))
            top, bottom = FIG_8[(int(n), row["axis"].lower())](a, b, c)
            self.agrees(case_of(row)["toppling"]["critical_angle_deg"],
                        exact.degrees(exact.atan(exact.decimal(top / bottom))))

    def test_closed_forms_of_random_teeth(self):
        """Random (N, a, b, c), 1000 under `./check --long`: Fig. 8 where it has a formula, the sums of Appendix A over slabs
        and triangles for every N; the factor of safety in both forms at a random tilt."""
        random.seed(1000)
        count = rounds(250, 1000)
        with tempfile.TemporaryDirectory() as folder:
            for k in range(count):
                n = 2 + k % 3 if k < 0.4 * count else random.randint(1, 40)
                a, b = (Fraction(random.randint(1, 10**6), 1000) for _ in "ab")
                c = min(a, b) * Fraction(random.randint(1, 999), 1000)  # flatter than 45 degrees
                tilt = Fraction(random.randint(1, 899), 10)
                end = random.choice(["valley", "peak"])
                case = solve_teeth(folder, n, a, b, c, end, tilt)
                pivot = case["pivots"][0]
                elements = elements_of_appendix_a(n, a, b, c, end)
                x_moment = sum(w * x for w, x, _ in elements)
                y_moment = sum(w * y for w, _, y in elements)
                if (n, end) in FIG_8:
                    top, bottom = FIG_8[(n, end)](a, b, c)
                    self.assertEqual(top * y_moment, bottom * x_moment)
                truth = exact.atan2_degrees(x_moment, y_moment)
                self.agrees(pivot["critical_angle_deg"], truth)
                self.assertEqual(case["toppling"]["pivot"], 0)
                sine, cosine = exact.sin_cos(tilt)
                if y_moment > 0:
                    self.agrees(pivot["fos"], exact.decimal(x_moment / y_moment) * cosine / sine)
                stabilising = sum(exact.decimal(w * x) * cosine for w, x, _ in elements)
                stabilising += sum(exact.decimal(-w * y) * sine for w, _, y in elements if y < 0)
                overturning = sum(exact.decimal(w * y) * sine for w, _, y in elements if y > 0)
                if overturning > 0:
                    self.agrees(pivot["fos_elements"], stabilising / overturning)

    def test_equation_a1_3(self):
        """The paper's own elements form for three teeth about the peak: c^2/(3 b^2) + (27 a b +
        14 a c) cot(alpha) / (9 b^2), for block E at 20 degrees, within the bound."""
        case = next(c for c in solve("examples/block_e_peak.yaml")["cases"])
        a, b, c = Fraction(30), Fraction(120), Fraction(5)
        sine, cosine = exact.sin_cos(20)
        truth = exact.decimal(c * c / (3 * b * b)) + exact.decimal(
            (27 * a * b + 14 * a * c) / (9 * b * b)) * cosine / sine
        self.agrees(case["toppling"]["fos_elements"], truth)

    def test_equations_2_and_3(self):
        """A slab: tan(critical angle) = dx / y, FoS = cot(alpha) dx / y, at random dx, y, alpha."""
        random.seed(23)
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "slab.yaml"
            for _ in range(50):
                dx, y = random.randint(1, 10**6), random.randint(1, 10**6)
                tilt = Fraction(random.randint(1, 899), 10)
                scene.write_text(f"topple: 1\nlength_unit: in\nblock: {{slab: {{width: {dx}/7, height: "
                                 f"{y}/7}}}}\ntilt: {{angle_deg: {tilt}}}\n")
                sine, cosine = exact.sin_cos(tilt)
                for case in solve(scene)["cases"]:
                    toppling = case["toppling"]
                    self.agrees(toppling["critical_angle_deg"], exact.atan2_degrees(dx, y))
                    fos = exact.decimal(Fraction(dx, y)) * cosine / sine
                    self.agrees(toppling["fos"], fos)
                    self.agrees(toppling["fos_elements"], fos)


if __name__ == "__main__":
    main()
