# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Parts of the explorer's page that need no page, run by node: numbers are printed with certain digits alone, CSV and
formulas are read as Python reads them, a map told from few points is the map of all of them."""

import csv
import fractions
import io
import math
import random
import re
import unittest

from node_case import NODE, node
from page_case import ROOT, main
from harness import solve

PANELS = ROOT / "src" / "applications" / "explorer" / "panels"


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
class Parts(unittest.TestCase):
    def test_certain_digits(self):
        """Of 4000 numbers with bounds of all sizes, in two units: every truth that the bound allows rounds to what is
        printed, or value and bound are printed, and the bound then holds too."""
        draw = random.Random(20)
        given = []
        for _ in range(4000):
            value = draw.choice((0.0, draw.uniform(-100, 100), round(draw.uniform(-100, 100), draw.randrange(4)),
                                 draw.uniform(-1, 1) * 10.0 ** draw.randrange(-12, 9)))
            error = draw.choice((0.0, 10.0 ** draw.uniform(-18, 1), abs(value) * 2.0 ** -53))
            given.append([{"value": value, "error": error}, draw.randrange(7), draw.choice((1, 0.001, 0.3048))])
        texts = node(PANELS / "certain.js", "return given.map((each) => it.certainText(...each));", given)
        bounded = 0
        for (number, decimals, unit), text in zip(given, texts):
            value, error = (fractions.Fraction(number[key]) / fractions.Fraction(str(unit)) for key in ("value", "error"))
            if "±" in text:
                shown, bound = (fractions.Fraction(part.strip()) for part in text.split("±"))
                self.assertGreaterEqual(bound, error + abs(value - shown), (number, text))
                bounded += 1
                continue
            shown = fractions.Fraction(text)
            places = len(text.partition(".")[2])
            self.assertLessEqual(places, max(decimals, 12), text)
            half = fractions.Fraction(1, 2 * 10 ** (decimals if error == 0 and unit == 1 else places))
            for truth in (value - error, value, value + error):
                self.assertLessEqual(abs(shown - truth), half, (number, decimals, unit, text))
        self.assertGreater(bounded, 10)
        self.assertLess(bounded, 2000)

    def test_factors_are_rounded_to_the_safe_side(self):
        """No factor is printed above its proven lower end, and no upper bound below its own; both within the digit."""
        draw = random.Random(24)
        given = []
        for _ in range(4000):
            value = draw.choice((draw.uniform(0, 100), round(draw.uniform(0, 3), draw.randrange(5)), 1.0495407, 0.9999999))
            given.append({"value": value, "error": draw.choice((0.0, value * 2.0 ** -53, 10.0 ** draw.uniform(-9, -1)))})
        for function, side in (("fosText", -1), ("fosAtMostText", 1)):
            texts = node(PANELS / "certain.js", f"return given.map((each) => it.{function}(each));", given)
            for number, text in zip(given, texts):
                value, error = (fractions.Fraction(number[key]) for key in ("value", "error"))
                shown, place = fractions.Fraction(text), fractions.Fraction(1, 1000)
                while place < error:
                    place *= 10
                noise = max(error, value / 2 ** 53) if error <= place / 10 ** 9 else 0  # 0.3 is no double
                self.assertGreaterEqual(side * (shown - value) - error + 2 * noise, 0, (number, text))
                self.assertLessEqual(side * (shown - value) - error, place, (number, text))

    def test_bounds_are_rounded_up(self):
        draw = random.Random(21)
        given = [10.0 ** draw.uniform(-300, 5) for _ in range(1000)] + [1e-5, 9.5e-7, 1.0, 0.0]
        texts = node(PANELS / "certain.js", "return given.map((each) => it.boundText(each));", given)
        for bound, text in zip(given, texts):
            self.assertGreaterEqual(fractions.Fraction(text), fractions.Fraction(bound))
            self.assertLessEqual(float(text), 2.0001 * bound)

    def test_csv(self):
        """Fields with commas, quotes and empty ones, as Python's writer writes them."""
        draw = random.Random(22)
        rows = [["".join(draw.choice('ab,"1 .') for _ in range(draw.randrange(6))) for _ in range(5)] for _ in range(300)]
        out = io.StringIO()
        csv.writer(out, lineterminator="\n").writerows(rows)
        self.assertEqual(node(PANELS / "csv.js", "return it.readCsv(given);", out.getvalue()), rows)

    def test_formulas(self):
        """Random sums, products, quotients and powers have the value that Python's rationals give them."""
        draw = random.Random(23)
        names = {"a": 3, "b": 7, "c_1": 2}

        def formula(depth):
            if depth == 0:
                return draw.choice([*names, str(draw.randrange(1, 30))])
            one, other = formula(depth - 1), formula(depth - 1)
            return draw.choice((f"{one} + {other}", f"({one} - {other})", f"({one})*({other})", f"-({one})", f"({one})/({other})",
                                f"({one})^{draw.randrange(4)}", f"{one}*{other}"))

        given = [formula(draw.randrange(5)) for _ in range(500)]
        values = node(PANELS / "expression.js", "const names = new Map(given.names); return given.texts.map("
                      "(text) => String(it.valueOf(it.readExpression(text), names)));", {"texts": given, "names": [*names.items()]})
        told = 0
        for text, value in zip(given, values):
            exact = re.sub(r"\b(\d+)\b", r"F(\1)", text.replace("^", "**"))
            try:
                truth = eval(exact, {"F": fractions.Fraction, **{key: fractions.Fraction(n) for key, n in names.items()}})
            except ZeroDivisionError:
                continue
            self.assertTrue(math.isclose(float(value), truth, rel_tol=1e-9, abs_tol=1e-9), (text, value, truth))
            told += 1
        self.assertGreater(told, 400)

    def test_what_is_no_formula(self):
        given = ["", "a +", "(a", "a)", "2 b", "a**2", "<b>", "(" * 5000 + "a", "-" * 100000 + "a"]
        self.assertEqual(node(PANELS / "expression.js", "return given.map((text) => it.readExpression(text));", given),
                         [None] * len(given))

    def test_stretches_of_tilts(self):
        """The bar of the verdict: from level to upright without a gap, and in the middle of each stretch the native program's
        verdict at that tilt is what the bar says."""
        scenes = (("block_a_peak", "friction_angle_deg=60"), ("block_e_valley", "friction_angle_deg=30"), ("tilt_locked_stress", None),
                  ("block_on_clay", None), ("boulder", None), ("l_shaped_block", None), ("block_bonded", None))
        kinds = set()
        for name, setting in scenes:
            text = (ROOT / "examples" / f"{name}.yaml").read_text(encoding="utf-8")
            options = ["--set", setting] if setting else []
            cases = solve(f"examples/{name}.yaml", *options)["cases"]
            given = [{key: case[key] for key in ("onset", "limit")} for case in cases]
            for case, parts in zip(cases, node(PANELS / "window_gauge.js", "return given.map(it.stretches);", given)):
                self.assertEqual([parts[0]["from"], parts[-1]["to"]], [0, 90])
                for part, following in zip(parts, parts[1:]):
                    self.assertEqual(part["to"], following["from"])
                for part in parts if re.search(r"tilt:.* angle_deg", text) else ():
                    tilt = ["--set", f"tilt.angle_deg={(part['from'] + part['to']) / 2}"]
                    at = next(each for each in solve(f"examples/{name}.yaml", *options, *tilt)["cases"] if each["towards"] == case["towards"])
                    told = {"stands": "stands", "interlocked": "stands", "may move": "may-move"}.get(at["mechanism"], "moves")
                    self.assertEqual(part["kind"], told, (name, part, at["mechanism"]))
                    kinds.add(told)
        self.assertEqual(kinds, {"stands", "may-move", "moves"})

    def test_lesser_factor_governs(self):
        """Of many blocks the factor on what drives where it is certainly less, as the badge and the gallery say it; of a rock that of the
        rule, or its upper bound where it is not decided, and never that of its contacts or its wedge."""
        fos = lambda value: {"value": value, "error": 0.01}
        contacts = {"verdict": "stands", "fos": fos(9), "fos_mechanism": "slides"}
        solids = [{"contacts": contacts, "safety": {"fos": fos(2), "mechanism": "slides", "least": 1.99, "most": 2.01}},
                  {"contacts": contacts, "safety": {"fos": None, "fos_is": "undecided", "mechanism": "topples", "least": 1, "most": 6.5}},
                  {"wedge": {"verdict": "slides", "fos": fos(0.7)}, "safety": {"fos": fos(0.5), "mechanism": "slides"}}]
        blocks = [{"fos": fos(4.3), "fos_driving": fos(1.03)}, {"fos": fos(2), "fos_driving": fos(1.995)}, {"fos": None, "fos_driving": fos(3)}]
        body = "return [...given[0].map((own) => it.solutionOf('solid', JSON.stringify(own)).cases[0]), ...given[1]].map((one) => it.governingFactor(one).value);"
        found = node(PANELS.parent / "scene" / "solution.js", body, [solids, blocks])
        self.assertEqual(found, [2, 6.5, 0.5, 1.03, 2, 3])

    def test_map_of_few_points(self):
        """A plane of three regions with a curved border, a disc and a corner: every one of 201 × 201 points is right, and
        fewer than a tenth of them were asked for."""
        asked, wrong = node(PANELS / "map_grid.js", """
          const kind = (x, y) => (x * x + y * y < 0.1 ? 1 : Math.hypot(x - 0.7, y - 0.6) < 0.15 ? 4 : y > 0.3 + 0.5 * Math.sin(4 * x) ? 2 : 3);
          const grid = new it.MapGrid(201, 201);
          await grid.refine(async (rows, columns) => { rows.forEach((r) => columns.forEach((c) => grid.put(c, r, kind(c / 200, r / 200)))); return true; }, () => {});
          let wrong = 0;
          for (let r = 0; r <= 200; r++) for (let c = 0; c <= 200; c++) if (grid.kinds[r * 201 + c] !== kind(c / 200, r / 200)) wrong++;
          return [grid.count, wrong];""", None)
        self.assertEqual(wrong, 0)
        self.assertLess(asked, 4040)


if __name__ == "__main__":
    main()
