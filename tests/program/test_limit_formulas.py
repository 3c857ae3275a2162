# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Closed formulas of the static limit against all bases of its linear program in exact rationals, and
docs/limit.md against the program. Nothing here has a tolerance but printed digits."""

import itertools
import json
import math
import pathlib
import random
import re
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import exact
from harness import ROOT, main, run

BLOCKS = ["a_peak", "a_valley", "b_peak", "b_valley", "c", "d", "e_valley", "e_peak", "f", "g"]
SCENE = ("topple: 1\nlength_unit: mm\nparameters: {{a: {a}, b: {b}, c: {c}}}\nblock:\n"
         "  teeth: {{count: {n}, width: a, height: b, depth: c, left_end: {left}}}\n"
         "base: {{mated: true, beyond: {{left: {beyond}, right: 0}}}}\n"
         "friction_angle_deg: {phi}\ntilt: {{towards: left}}\n")


def value(formula, values):
    """A derived polynomial at rational values, by Python's own arithmetic."""
    text = re.sub(r"\d+", lambda n: f"Fraction({n.group()})", formula.replace("tan(phi)", "t"))
    text = text.replace("^Fraction", "**Fraction")
    return Fraction(eval(text, {"__builtins__": {}, "Fraction": Fraction}, values))


def joints(n, a, c, left):
    """The underside of a toothed block: its joints from left to right."""
    low_first = left == "valley"
    return [(a * k, Fraction(0) if (k % 2 == 0) == low_first else c) for k in range(n + 1)]


def cone_edges(chain, t, beyond):
    """(force x, force y, moment about the origin) of both cone edges at both ends of each facet; on a
    base that goes on, of the toe on the next flank as well."""
    facets = [(p, q, p) for p, q in zip(chain, chain[1:])] + \
             [(p, q, q) for p, q in zip(chain, chain[1:])]
    if beyond:
        (x0, y0), (x1, y1) = chain[:2]
        facets.append(((x0 - (x1 - x0), y1), (x0, y0), (x0, y0)))
    edges = []
    for (x0, y0), (x1, y1), (qx, qy) in facets:
        tx, ty = x1 - x0, y1 - y0
        for s in (t, -t):
            fx, fy = -ty + s * tx, tx + s * ty
            edges.append((fx, fy, qx * fy - qy * fx))
    return edges


def limit(edges, gx, gy):
    """tan of the limit: of all pairs of forces the one that balances the weight and whose twist no
    other force resists (the optimal basis); None where there is none."""
    columns = [(fx, fy, m - gx * fy + gy * fx) for fx, fy, m in edges]  # moments about the weight
    for (ax, ay, am), (bx, by, bm) in itertools.combinations(columns, 2):
        det = ay * bm - by * am
        if det == 0:
            continue
        fa, fb = bm / det, -am / det          # rows: normal force 1, moment 0
        if fa < 0 or fb < 0:
            continue
        tangent = fa * ax + fb * bx
        turn = (bx * ay - ax * by) / det      # dual: tangent * y + turn * m >= x for every force
        if all(tangent * y + turn * m >= x for x, y, m in columns):
            return tangent
    return None


class LimitFormulas(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = pathlib.Path(self.folder.name) / "scene.yaml"

    def tearDown(self):
        self.folder.cleanup()

    def derive(self, **scene):
        self.scene.write_text(SCENE.format(**{"a": 30, "b": 120, "c": 5, "beyond": 0, **scene}))
        status, out, err = run("derive", "--limit", "--json", self.scene)
        self.assertEqual((status, err), (0, ""))
        (found,) = json.loads(out)["limit"]
        return found

    def test_holds_where_it_says(self):
        """Blocks of 1 to 4 sub-blocks, both ends, both kinds of base: at 40 random parameters each the
        formula equals the optimum over all bases wherever its conditions hold; and they do hold at
        some of them, and fail at others."""
        random.seed(5)
        held = failed = 0
        cases = itertools.product((1, 2, 3, 4), ("valley", "peak"), (0, 30), ("20", "35"))
        for n, left, beyond, phi in cases:
            b = 60 * n
            found = self.derive(n=n, left=left, beyond=beyond, phi=phi, b=b)
            tangent = found["tan_critical_angle"]
            self.assertTrue(found["parameters_above_zero"])
            for _ in range(40):
                values = {"a": Fraction(random.randint(20, 40)),
                          "b": Fraction(random.randint(b // 2, 2 * b)),
                          "c": Fraction(random.randint(1, 15)),
                          "t": Fraction(random.randint(1, 150), 100)}
                a, b_own, c, t = (values[k] for k in "abct")
                if not all(value(f, values) >= 0 for f in found["conditions"]):
                    failed += 1
                    continue
                held += 1
                outline = exact.teeth(n, a, b_own, c, left)
                gx, gy = exact.centroid(exact.block_moments(outline))
                best = limit(cone_edges(joints(n, a, c, left), t, beyond > 0), gx, gy)
                formula = value(tangent["numerator"], values) / value(tangent["denominator"], values)
                self.assertEqual(formula, best, (n, left, beyond, phi, values))
        self.assertGreater(min(held, failed), 200, (held, failed))

    def test_conditions_are_met_on_both_sides(self):
        """Every check that is reported, done again: inside all conditions hold and the formula is the
        solver's limit within its bound; outside its condition fails and the solver finds what the
        report says. Most conditions have one, and most bound the formula for good."""
        random.seed(7)
        beyond, conditions = [], 0
        for n, left, phi in itertools.product((1, 2, 3), ("valley", "peak"), ("20", "60")):
            scene = {"n": n, "left": left, "phi": phi, "a": 30, "b": 60 * n, "c": random.choice((5, 12)), "beyond": 0}
            found = self.derive(**scene)
            if found["tan_critical_angle"] is None:
                continue
            conditions += len(found["conditions"])
            for check in found["checks"]:
                for side in ("inside", "outside"):
                    changed = {"friction_angle_deg": "phi"}
                    at = {**scene, **{changed.get(k, k): v for k, v in check[side].items()}}
                    signs, agrees, limit = self.look(found, at)
                    if side == "inside":
                        self.assertTrue(all(sign > 0 for sign in signs), (scene, check))
                        self.assertTrue(agrees, (scene, check, limit))
                    else:
                        self.assertLess(signs[check["condition"]], 0, (scene, check))
                        self.assertEqual(check["beyond"], "same" if agrees else
                                         "none" if limit["critical_angle_deg"] is None else "other", (scene, check))
                        beyond.append(check["beyond"])
        self.assertGreater(len(beyond), 0.4 * conditions)
        self.assertGreater(beyond.count("other"), 0.5 * len(beyond))

    def look(self, found, scene):
        """Signs of the conditions at the values of a scene; whether the formula gives the solver's
        limit there; and that limit."""
        values = {key: Fraction(str(scene[key])) for key in "abc"}
        sine, cosine = exact.sin_cos(Decimal(str(scene["phi"])))
        values["t"] = Fraction(sine / cosine)
        signs = [value(f, values) for f in found["conditions"]]
        tangent = value(found["tan_critical_angle"]["numerator"], values) / value(
            found["tan_critical_angle"]["denominator"], values)
        self.scene.write_text(SCENE.format(**scene))
        status, out, err = run("solve", "--json", "--digits=15", self.scene)
        self.assertEqual((status, err), (0, ""))
        limit = json.loads(out)["cases"][0]["limit"]
        solved = limit["critical_angle_deg"]
        angle = exact.degrees(exact.atan(exact.decimal(tangent)))
        agrees = solved is not None and abs(angle - Decimal(str(solved["value"]))) <= Decimal(
            str(solved["error"])) + Decimal("1e-14") * abs(angle)
        return signs, agrees, limit

    def test_unchecked(self):
        """--unchecked leaves the checks out, and nothing else."""
        found = self.derive(n=3, left="valley", phi=30)
        status, out, _ = run("derive", "--limit", "--json", "--unchecked", self.scene)
        self.assertEqual(status, 0)
        (other,) = json.loads(out)["limit"]
        self.assertNotIn("checks", other)
        self.assertGreater(len(found.pop("checks")), 2)
        self.assertEqual(found, other)
        text = run("derive", "--limit", self.scene)[1]
        self.assertIn("solved at friction_angle_deg = 4.83", text)
        self.assertNotIn("solved at", run("derive", "--limit", "--unchecked", self.scene)[1])

    def test_page_gathers_the_terms(self):
        """The formulas of docs/limit.md for blocks E and F are the derived ones."""
        def e_formula(a, b, c, t):
            own = 9 * (2 * b + c) * (a * a + c * c)
            top = own * (a * t + c) + 2 * a * a * c * (9 * b + 4 * c) * (1 + t * t)
            return top / (own * (a - c * t) + 6 * a * c * (3 * b * b - c * c) * (1 + t * t))

        def f_formula(a, b, c, t):
            own = 3 * (2 * b + c) * (a * a + c * c)
            return own * (a * t + c) / (own * (a - c * t) + 2 * a * c * (3 * b * b - c * c) * (1 + t * t))

        random.seed(6)
        for n, formula, phi in ((3, e_formula, 30), (2, f_formula, 30)):
            tangent = self.derive(n=n, left="valley", phi=phi)["tan_critical_angle"]
            for _ in range(50):  # more points than either side's degrees allow to agree by chance
                values = {k: Fraction(random.randint(1, 10**6), random.randint(1, 10**6)) for k in "abct"}
                derived = value(tangent["numerator"], values) / value(tangent["denominator"], values)
                self.assertEqual(derived, formula(*(values[k] for k in "abct")))

    def test_three_forces_meet(self):
        """Block E by hand: from the base's normal the force at the toe leans by phi - i, that at the
        first peak by phi + i; the weight passes where they meet. At one rational point in floats,
        whose rounding is far below 1e-12."""
        phi, i = math.radians(30), math.atan2(5, 30)
        y = (30 - 5 * math.tan(phi + i)) / (math.tan(phi - i) - math.tan(phi + i))
        x = y * math.tan(phi - i)
        gx, gy = (float(g) for g in exact.centroid(exact.block_moments(
            exact.teeth(3, Fraction(30), Fraction(120), Fraction(5), "valley"))))
        found = self.derive(n=3, left="valley", phi=30)
        self.assertAlmostEqual(math.degrees(math.atan2(gx - x, gy - y)),
                               found["critical_angle_deg"]["value"], delta=1e-12)
        self.assertAlmostEqual(found["critical_angle_deg"]["value"], 28.73, delta=0.005)

    def test_interlocked_and_refused(self):
        """No formula where forces hold at any tilt; friction must be given, and 'phi' left free."""
        found = self.derive(n=2, left="valley", phi=20, a=10, b=100, c=30)
        self.assertEqual((found["mechanism"], found["tan_critical_angle"]), ("interlocked", None))
        text = SCENE.format(n=2, left="valley", phi=20, a=10, b=100, c=30, beyond=0)
        for old, new, message in (("friction_angle_deg: 20\n", "", "the static limit needs friction"),
                                  ("c: 30}", "c: 30, phi: 1}", "the name 'phi' for themselves")):
            self.scene.write_text(text.replace(old, new))
            status, out, err = run("derive", "--limit", self.scene)
            self.assertEqual((status, out), (3, ""))
            self.assertIn(message, err)


class Page(unittest.TestCase):
    page = (ROOT / "docs" / "limit.md").read_text(encoding="utf-8")

    def test_table_3(self):
        """The table of the paper's blocks is the program's."""
        scenes = [f"examples/block_{name}.yaml" for name in BLOCKS]
        self.assertIn(run("solve", "--table", *scenes)[1], self.page)

    def test_friction_rows(self):
        """Blocks E and F for the friction that the paper measured."""
        for phi in range(24, 32):
            cells = []
            with tempfile.TemporaryDirectory() as folder:
                for name in ("e_valley", "f"):
                    text = (ROOT / f"examples/block_{name}.yaml").read_text(encoding="utf-8")
                    scene = pathlib.Path(folder) / "scene.yaml"
                    scene.write_text(text.replace("friction_angle_deg: 30", f"friction_angle_deg: {phi}"))
                    row = run("solve", "--table", scene)[1].splitlines()[2]
                    cells.append(row.split("|")[11].strip())
            self.assertIn(f"| {phi}° | {cells[0]} | {cells[1]} |\n", self.page)

    def test_table_refuses(self):
        """--table prints the rows of the scenes that are right where one is wrong, and goes alone."""
        status, out, err = run("solve", "--table", "examples/slab.yaml", "tests/bad/zero_area.yaml")
        self.assertEqual((status, out), (3, run("solve", "--table", "examples/slab.yaml")[1]))
        self.assertIn("zero_area.yaml", err)
        self.assertEqual(run("solve", "--table", "--json", "examples/slab.yaml")[0], 2)
        self.assertEqual(run("solve", "examples/slab.yaml", "examples/slab.yaml")[0], 2)


if __name__ == "__main__":
    main()
