# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Charts: their numbers against the paper and against independent formulas, borders against closed
forms."""

import math
from decimal import Decimal
from fractions import Fraction

import exact
from chart_case import Chart, DEGREE, chart, lean, select, toe_of
from harness import ROOT, main

PAGE = " ".join((ROOT / "docs/chart.md").read_text(encoding="utf-8").replace("**", "").split())

TABLE_6 = [("0.5", "0.1", 20, "1.37", "1.53", "1.25"), ("0.75", "0.1", 25, "1.61", "1.78", "1.46"),
           ("1", "0.1", 30, "1.73", "1.92", "1.57"), ("0.5", "0.05", 20, "1.37", "1.44", "1.30"),
           ("0.75", "0.05", 25, "1.61", "1.69", "1.53"), ("1", "0.05", 30, "1.73", "1.82", "1.65")]


def tangent(slenderness, amplitude, axis, count=2):
    """tan of the critical angle of an exact block of mean height 1 (docs/paper.md): the weight's lever
    arms from its N slabs and N triangles, summed one by one."""
    if axis == "planar" or amplitude == 0:
        return Fraction(slenderness)
    ring = exact.teeth(count, Fraction(slenderness) / count, 1 - Fraction(amplitude) / 2,
                       Fraction(amplitude), axis)
    gx, gy = exact.centroid(exact.block_moments(ring))
    return (gx - ring[0][0]) / (gy - ring[0][1])


def formula(slenderness, amplitude, axis):
    sign = {"planar": 0, "peak": -1, "valley": 1}[axis]
    a = Fraction(amplitude)
    return Fraction(slenderness) / (1 + sign * a - (a * a / 12 if sign else 0))


class FactorOfSafety(Chart):
    def test_table_6(self):
        """Every row of Table 6 is on the chart, within the cut-off last digits that docs/paper.md lists;
        the value is that of Eqs. (15) to (17), mended, at 60 digits."""
        rows = select(chart("fos", "--amplitude", "0.05,0.1"), series="Table 6")
        self.assertEqual(len(rows), 18)
        for slenderness, amplitude, tilt, *printed in TABLE_6:
            sine, cosine = exact.sin_cos(tilt)
            for axis, value in zip(("planar", "peak", "valley"), printed):
                (row,) = select(rows, inverse_slenderness=slenderness, amplitude=amplitude, axis=axis)
                self.assertEqual((row["printed"], float(row["tilt_deg"])), (value, tilt))
                truth = exact.decimal(formula(float(slenderness), float(amplitude), axis)) * cosine / sine
                self.within(row, truth, "fos")
                self.assertLess(abs(Decimal(value) - truth), Decimal("0.01"), row)

    def test_curves(self):
        """The curves are the equations; FoS = 1 at the planar critical angle lies between neighbours."""
        rows = select(chart("fos"), series="curve")
        self.assertEqual({row["inverse_slenderness"] for row in rows}, {"0.5", "0.75", "1"})
        for row in rows[::23]:
            sine, cosine = exact.sin_cos(Fraction(float(row["tilt_deg"])))
            own = formula(float(row["inverse_slenderness"]), float(row["amplitude"]), row["axis"])
            self.within(row, exact.decimal(own) * cosine / sine, "fos")

    def test_exact_blocks(self):
        """With --sub-blocks the blocks are solved: at even N the equations are exact, at odd N not."""
        plain = select(chart("fos"), series="Table 6")
        for count, alike in ((2, True), (4, True), (3, False)):
            blocks = select(chart("fos", "--sub-blocks", count), series="Table 6")
            self.assertEqual(len(blocks), len(plain))
            for one, other in zip(plain, blocks):
                gap = abs(float(one["fos"]) - float(other["fos"]))
                self.assertEqual(gap <= 1e-12, alike or one["axis"] == "planar")
                sine, cosine = exact.sin_cos(Fraction(one["tilt_deg"]))
                own = tangent(float(one["inverse_slenderness"]), float(one["amplitude"]), one["axis"], count)
                self.within(other, exact.decimal(own) * cosine / sine, "fos")


class Ranges(Chart):
    def test_angles(self):
        """Every angle of the chart by rational moments and a 60-digit arctangent; both series are there,
        with N = 2 dx / lambda."""
        rows = chart("ranges")
        counts = {s: {r["sub_blocks"] for r in select(rows, series=s)} for s in ("N", "wavelength")}
        self.assertEqual(counts, {"N": set("2347"), "wavelength": {"2", "4", "10", "20"}})
        for row in rows:
            self.assertEqual(Fraction(row["wavelength_over_width"]), Fraction(2, int(row["sub_blocks"])))
        for row in [r for r in rows if r["mark"] == "Fig. 14" and r["series"] != "odd less even"]:
            slenderness = Fraction(float(Fraction(row["inverse_slenderness"])))
            amplitude = Fraction(float(row["amplitude_percent"]) / 100)
            self.assertIn(float(row["amplitude_percent"]), (1, 2, 5, 10))
            own = tangent(slenderness, amplitude, row["axis"], int(row["sub_blocks"]))
            angle = exact.degrees(exact.atan(exact.decimal(own)))
            self.assertLess(abs(Decimal(row["angle_deg"]) - angle), Decimal("1e-13"), row)

    def test_odd_less_even(self):
        """What an odd N adds: + about a peak, - about a valley, 0.051 degrees at most, as docs/chart.md has it."""
        every = [abs(float(row["angle_deg"])) for row in select(chart("ranges"), series="odd less even")]
        self.assertIn(f"{max(every):.3f}° at most", PAGE)
        rows = select(chart("ranges"), series="odd less even", mark="Fig. 14")
        self.assertEqual(len(rows), 4 * 2 * 2 * 4)
        for row in rows:
            slenderness, amplitude = Fraction(row["inverse_slenderness"]), float(row["amplitude_percent"]) / 100
            odd, even = (math.atan(tangent(slenderness, Fraction(amplitude), row["axis"], n)) / DEGREE
                         for n in (int(row["sub_blocks"]), 2))
            self.assertAlmostEqual(float(row["angle_deg"]), odd - even, delta=1e-12)
            self.assertEqual(float(row["angle_deg"]) > 0, row["axis"] == "peak")
            self.assertLess(abs(float(row["angle_deg"])), 0.052)


class Mechanisms(Chart):
    def test_table_7(self):
        """The four blocks stand in the table's ranges; the program agrees with the paper on all but one:
        block 2, wider than tan(phi + i), cannot topple at phi + i - 1 about a valley of A/y = 1 %."""
        rows = select(chart("mechanisms"), series="Table 7")
        self.assertEqual([(r["base"], r["block"]) for r in rows],
                         [(base, str(k)) for base in ("planar", "rough") for k in (1, 2, 3, 4)])
        low, high = math.tan(30 * DEGREE), math.tan(40 * DEGREE)
        for row in rows:
            x, wide = float(row["inverse_slenderness"]), row["block"] in "12"
            self.assertEqual(float(row["tilt_deg"]), 39 if row["block"] in "23" else 31)
            self.assertEqual((x > high, low < x < high), (wide, not wide))
            self.assertEqual(row["agrees"], "no" if (row["base"], row["block"]) == ("rough", "2") else "yes")
        judged = {(r["base"], r["block"]): r["program"] for r in rows}
        self.assertEqual([judged["rough", k] for k in "1234"],
                         ["stable", "stable", "topples, stable if peak", "stable, topples if valley"])
        self.assertEqual([r["from_rest"] for r in rows[:4]], ["slides"] * 4)
        self.assertEqual(judged["planar", "3"], "slides and topples")
        for row in rows:
            cells = " | ".join(row[key] for key in ("block", "base", "program", "from_rest", "paper"))
            self.assertIn(f"| {cells} |".replace("  ", " "), PAGE)
        beside = [f"{float(r['tilt_deg']):.2f}°" for r in select(chart("mechanisms"), series="certain to stand, valley")][6:8]
        self.assertIn(" and ".join(beside) + ", slipping and turning at once", PAGE)

    def test_block_2_topples_on_a_rougher_base(self):
        """Its verdict needs A/y of tan(40) / tan(39) - 1 = 3.6 % at least."""
        for amplitude, program in (("0.036", "stable"), ("0.04", "stable, topples if valley")):
            rows = select(chart("mechanisms", "--amplitude", amplitude), base="rough", block="2")
            self.assertEqual([r["program"] for r in rows], [program])

    def test_borders(self):
        """Toppling borders by the mended Eqs. (15) to (17), sliding at phi_b and phi_b + i."""
        rows = chart("mechanisms", "--friction", 28, "--roughness-angle", 7.5, "--amplitude", 0.03)
        for series, axis in (("topples", "planar"), ("topples about the peak", "peak"),
                             ("topples about the valley", "valley")):
            own = select(rows, series=series)
            self.assertGreater(len(own), 100)
            for row in own[::7]:
                tan = formula(float(row["inverse_slenderness"]), 0.03, axis)
                angle = exact.degrees(exact.atan(exact.decimal(tan)))
                self.assertLess(abs(Decimal(row["tilt_deg"]) - angle), Decimal("1e-12"))
        self.assertEqual({(r["base"], float(r["tilt_deg"])) for r in select(rows, series="slides")},
                         {("planar", 28), ("rough", 35.5)})


    def test_from_rest_on_a_plane(self):
        """A slab topples about a toe that holds up to the tilt where the force on it leans by phi, kappa being 1/4 for
        every rectangle; beyond it slides and topples at once; wider than tan(phi) it slides alone."""
        for friction in (30, 41.5, 12):
            rows = select(chart("mechanisms", "--friction", friction), base="planar")
            curve = select(rows, series="from rest: topples | slides and topples")
            self.assertGreater(len(curve), 100)
            for row in curve:
                delta = math.atan(float(row["inverse_slenderness"]))
                self.assertAlmostEqual(lean(delta, 0.25, float(row["tilt_deg"])), friction, delta=1e-12)
                self.assertLess(float(row["y_error"]), 1e-12)
            upright = select(rows, series="from rest: slides and topples | slides")
            self.assertEqual(len(upright), 2)
            for row in upright:
                self.assertAlmostEqual(float(row["inverse_slenderness"]), math.tan(friction * DEGREE), delta=1e-15)
                self.assertLess(float(row["x_error"]), 1e-15)
            self.assertAlmostEqual(float(upright[0]["tilt_deg"]), friction, delta=1e-12)

    def test_from_rest_on_teeth(self):
        """Exact sawtooth blocks: about a peak the toe's facet is climbed at i, about a valley left behind at i, so that
        the toe slips where the force on it leans by phi + i or phi - i."""
        rows = chart("mechanisms", "--friction", 28, "--roughness-angle", 12, "--amplitude", 0.01)
        width = 0.01 / math.tan(12 * DEGREE)
        for toe, holds in (("peak", 40), ("valley", 16)):
            own = select(rows, base="rough", series=f"from rest about the {toe}: topples | slides and topples")
            self.assertGreater(len(own), 1)
            for row in own:
                slenderness = float(row["inverse_slenderness"])
                count = round(slenderness / width)
                self.assertEqual(count % 2, 0)
                self.assertAlmostEqual(slenderness / count, width, delta=1e-15)
                ring = exact.teeth(count, Fraction(slenderness) / count, 1 - Fraction(0.01) / 2, Fraction(0.01), toe)
                self.assertAlmostEqual(lean(*toe_of(ring), float(row["tilt_deg"])), holds, delta=1e-10)

    def test_no_teeth_no_blocks(self):
        """Without an amplitude or an angle there are no sawtooth blocks that could begin to move."""
        for option in ("--amplitude", "--roughness-angle"):
            rows = chart("mechanisms", option, 0)
            self.assertEqual([r for r in select(rows, base="rough") if "rest" in r["series"]], [])

    def test_block_2_lets_go_about_a_valley(self):
        """What the formulas cannot see: sawtooth blocks narrower and wider than block 2 of Table 7, whose base ends with
        them at a valley, are not certain to stand at its 39 degrees, although neither phi + i nor the critical angle
        about the valley is reached there."""
        rows = chart("mechanisms")
        (block,) = select(rows, base="rough", series="Table 7", block="2")
        own = float(block["inverse_slenderness"])
        onset = {float(r["inverse_slenderness"]): float(r["tilt_deg"])
                 for r in select(rows, series="certain to stand, valley")}
        beside = [max(x for x in onset if x < own), min(x for x in onset if x > own)]
        for x in beside:
            self.assertLess(onset[x], 39)
        self.assertGreater(math.atan(formula(beside[1], 0.01, "valley")) / DEGREE, 41)
        self.assertEqual(block["program"], "stable")


if __name__ == "__main__":
    main()
