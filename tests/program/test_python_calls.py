# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Formulas, claims, charts and accuracy in Python: what the program prints, and formulas that can be called,
against fractions worked out here."""

import json
import math
import pickle
import tempfile
import unittest
import xml.dom.minidom
from fractions import Fraction

from harness import ROOT, main, run
from python_case import numpy, topple

BLOCK = ROOT / "examples" / "block_e_valley.yaml"
CLAIMS = ROOT / "examples" / "paper" / "claims.yaml"


def printed(*arguments):
    """What the program prints."""
    status, out, err = run(*arguments)
    if status > 1:
        raise AssertionError(err)
    return out


class Formulas(unittest.TestCase):
    def test_derivation(self):
        """The program's JSON, and the same in the records."""
        scene = topple.Scene.read(BLOCK)
        own = topple.derive(scene, elements=True, rounded=True, limit=True)
        told = json.loads(printed("derive", "--json", "--elements", "--rounded", "--limit", BLOCK))
        self.assertEqual(json.loads(own.to_json()), told)
        self.assertEqual(own.report(), printed("derive", "--elements", "--rounded", "--limit", BLOCK))
        self.assertEqual(list(own.symbols), told["symbols"])
        for pivot, mine in zip(told["pivots"], own.pivots, strict=True):
            self.assertEqual(pivot["tan_critical_angle"], {"numerator": mine.tangent.numerator,
                                                           "denominator": mine.tangent.denominator})
            self.assertEqual((pivot["towards"], pivot["kind"], pivot["governs"]),
                             (mine.towards.value, mine.kind.value, mine.governs))
            self.assertEqual(pivot["critical_angle_deg"]["value"], mine.critical_angle_deg.value)
            self.assertEqual("cot" in pivot["fos_elements"], mine.fos_cot is not None)
        left = topple.Direction.LEFT
        self.assertEqual(told["limit"][0]["conditions"], [str(c) for c in own.limit[left].conditions])
        self.assertEqual([check["condition"] for check in told["limit"][0]["checks"]],
                         [check.number for check in own.limit[left].checks])
        self.assertEqual(len(own.limit[left].reactions), 2)
        self.assertEqual(told["onset"][0]["same_as_limit"], own.onset[left].same_as_limit)
        self.assertEqual(told["rounded"][0]["corner_radius"]["numerator"], own.rounded[left].radius.numerator)
        self.assertEqual(len(own.elements[left]), 6)
        self.assertEqual(pickle.loads(pickle.dumps(own)), own)

    def test_called(self):
        """(A1.1) of the paper at its numbers, worked out here from the moments of three trapezia; exactly, in doubles, over
        an array, and at symbols that are no names of Python."""
        a, b, c = Fraction(30), Fraction(120), Fraction(5)
        points = [(0, 0), (a, c), (2 * a, 0), (3 * a, c), (3 * a, b + c), (0, b + c)]
        crosses = [(p, q, p[0] * q[1] - q[0] * p[1]) for p, q in zip(points, points[1:] + points[:1])]
        x, y = (sum((p[k] + q[k]) * cross for p, q, cross in crosses) for k in (0, 1))
        derivation = topple.derive(topple.Scene.read(BLOCK), limit=True)
        tangent = derivation.governing("left").tangent
        self.assertEqual(tangent(a=30, b=120, c=5), x / y)
        self.assertEqual(tangent({"a": a}, b=b, c=c), x / y)
        self.assertAlmostEqual(tangent(a=30.0, b=120.0, c=5.0), float(x / y), delta=1e-15)
        widths = numpy.linspace(10, 50, 5)
        self.assertEqual(list(tangent(a=widths, b=120, c=5)), [tangent(a=w, b=120, c=5) for w in widths])
        limit = derivation.limit[topple.Direction.LEFT]
        angle = limit.tangent({"tan(phi)": math.tan(math.radians(30))}, a=30, b=120, c=5)
        self.assertAlmostEqual(math.degrees(math.atan(angle)), limit.critical_angle_deg.value, delta=1e-12)
        self.assertRaises(KeyError, tangent, a=1, b=2)
        latex = topple.derive(topple.Scene.read(BLOCK), notation="latex").governing("left").tangent
        self.assertIn("\\frac", str(latex))
        self.assertRaises(ValueError, latex, a=30, b=120, c=5)

    def test_family(self):
        """One formula for every number of teeth, called for this one."""
        family = topple.derive_family(topple.Scene.read(BLOCK))
        self.assertEqual(json.loads(family.to_json()), json.loads(printed("derive", "--json", "--for-all=count", BLOCK)))
        self.assertEqual(family.report(), printed("derive", "--for-all=count", BLOCK))
        (odd,) = [f for f in family.formulas if f.towards is topple.Direction.LEFT and not f.even]
        self.assertEqual(odd.tangent(a=30, b=120, c=5, N=3),
                         topple.derive(topple.Scene.read(BLOCK)).governing("left").tangent(a=30, b=120, c=5))


class Claims(unittest.TestCase):
    def test_paper(self):
        own = topple.verify(CLAIMS)
        told = json.loads(printed("verify", "--json", CLAIMS))
        self.assertEqual(json.loads(own.to_json()), told)
        for claim, mine in zip(told["claims"], own.claims, strict=True):
            self.assertEqual((claim["id"], claim["where"], claim["verdict"], claim["mend"]),
                             (mine.id, mine.where, mine.verdict.value, mine.mend))
        self.assertEqual(sum(own.tally.values()), len(own.claims))
        self.assertEqual(own.tally[topple.Verdict.REFUTED], sum(c.verdict is topple.Verdict.REFUTED for c in own.claims))
        self.assertTrue(own.objects)
        self.assertEqual(own.report(), printed("verify", CLAIMS))
        text = topple.verify_text(CLAIMS.read_text(encoding="utf-8"), str(CLAIMS))
        self.assertEqual(text, own)
        self.assertEqual(text.markdown(), own.markdown())
        with self.assertRaisesRegex(topple.BadInput, "^claims:1"):
            topple.verify_text("nonsense: 1\n")


class Charts(unittest.TestCase):
    def test_tables(self):
        """Each kind with its options is the program's table."""
        for chart, options in (
                (topple.chart_fos(inverse_slenderness=[0.2, 0.4], amplitude=[0.1], tilt_deg=(1, 60)),
                 ("fos", "--inverse-slenderness=0.2,0.4", "--amplitude=0.1", "--tilt=1:60")),
                (topple.chart_mechanisms(friction_deg=35), ("mechanisms", "--friction=35")),
                (topple.chart_ranges(), ("ranges",))):
            self.assertEqual(json.loads(chart.to_json()), json.loads(printed("chart", *options, "--json")))
            self.assertEqual(chart.csv(), printed("chart", *options))
        self.assertRaises(topple.BadInput, topple.chart_fos, amplitude=[2])
        self.assertRaises(topple.BadInput, topple.chart_fos, amplitude=[0.1] * 7)

    def test_files(self):
        chart = topple.chart_ranges()
        with tempfile.TemporaryDirectory() as folder:
            chart.write(f"{folder}/own.csv")
            self.assertEqual(open(f"{folder}/own.csv", encoding="utf-8").read(), chart.csv())
        with self.assertRaisesRegex(topple.BadInput, r"\.svg, \.pdf, \.png or \.csv"):
            chart.write("own.txt")
        try:
            drawn = chart._repr_svg_()
        except topple.DependencyFailed as error:
            self.skipTest(str(error))  # no gnuplot
        self.assertEqual(xml.dom.minidom.parseString(drawn).documentElement.tagName, "svg")


class Accuracy(unittest.TestCase):
    def test_runs(self):
        own = topple.accuracy_of_scene(topple.Scene.read(BLOCK))
        told, mine = json.loads(printed("accuracy", "--json", BLOCK)), json.loads(own.to_json())
        for key in ("method", "level", "bits", "vertices", "true_error"):
            self.assertEqual([run[key] for run in told["runs"]], [run[key] for run in mine["runs"]])
        for one, record in zip(mine["runs"], own.runs, strict=True):
            self.assertEqual((one["method"], one["level"], one["bound"]), (record.method.value, record.level.value,
                                                                           record.bound))
        self.assertEqual([v["angle_deg"]["value"] for v in mine["values"]], [v.angle_deg.value for v in own.values])
        self.assertEqual(len(own.sources), 1)
        self.assertIn("method", own.chart().csv())
        self.assertEqual({run.vertices for run in topple.accuracy_sweep(10, 100).runs}, {10, 100})


if __name__ == "__main__":
    main()
