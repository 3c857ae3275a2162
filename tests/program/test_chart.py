# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Charts: their numbers against the paper and against independent formulas, borders against closed
forms, figures that are whole, the same again, or not there at all."""

import csv
import io
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
from decimal import Decimal
from fractions import Fraction

import exact
from harness import PROGRAM, ROOT, main, run, solve

DEGREE = math.pi / 180
SLAB = ("topple: 1\ntitle: {title}\nlength_unit: m\nblock: {{slab: {{width: {width}, height: {height}}}}}\n"
        "friction_angle_deg: {friction}\ntilt: {{towards: left}}\n")
TABLE_6 = [("0.5", "0.1", 20, "1.37", "1.53", "1.25"), ("0.75", "0.1", 25, "1.61", "1.78", "1.46"),
           ("1", "0.1", 30, "1.73", "1.92", "1.57"), ("0.5", "0.05", 20, "1.37", "1.44", "1.30"),
           ("0.75", "0.05", 25, "1.61", "1.69", "1.53"), ("1", "0.05", 30, "1.73", "1.82", "1.65")]


def chart(*arguments):
    """The rows of the CSV that a chart prints."""
    status, out, err = run("chart", *arguments)
    if status != 0 or err:
        raise AssertionError(f"topple chart {arguments}: exit {status}: {err}")
    return list(csv.DictReader(io.StringIO(out)))


def select(rows, **keys):
    return [row for row in rows if all(row[k] == v for k, v in keys.items())]


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


def toe_of(ring):
    """What a toe that holds says of a block that turns about the first point of its outline: delta, the angle of the
    centroid from it, and kappa = k^2 / (k^2 + r^2), from exact moments."""
    a, sx, sy, xx, yy, _ = exact.ring_moments(ring)
    x, y = sx / a, sy / a
    square = (xx + yy) / a - x * x - y * y
    x, y = x - ring[0][0], y - ring[0][1]
    return math.atan2(x, y), float(square / (square + x * x + y * y))


def lean(delta, kappa, tilt):
    """How far from the base's normal the force on such a toe leans, degrees: it slips where that exceeds the friction
    angle and the inclination of the toe's facet, positive where the block climbs it."""
    return (delta + math.atan(kappa * math.tan(tilt * DEGREE - delta))) / DEGREE


class Chart(unittest.TestCase):
    def setUp(self):
        self.held = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.held.name)
        self.scene = self.folder / "scene.yaml"

    def tearDown(self):
        self.held.cleanup()

    def slab(self, width="1", height="2", friction="30", title="A slab"):
        self.scene.write_text(SLAB.format(width=width, height=height, friction=friction, title=title),
                              encoding="utf-8")
        return self.scene

    def within(self, row, truth, name):
        """A printed value lies within its printed error of the truth."""
        off = abs(Decimal(row[name]) - Decimal(truth))
        self.assertLessEqual(off, Decimal(row["y_error"]) + abs(Decimal(truth)) * Decimal("2e-16"), row)
        self.assertLess(Decimal(row["y_error"]), Decimal("1e-9"))


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
        """What an odd N adds: + about a peak, - about a valley, 0.05 degrees at most."""
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


class Map(Chart):
    def borders(self, *arguments):
        return select(chart("map", *arguments), series="border")

    def test_slab(self):
        """A slab topples at atan(dx/y) and slides at phi: the border is at dx/y = tan phi."""
        for friction, height in (("30", 2), ("17.3", 0.7), ("51", 11)):
            truth = height * math.tan(float(friction) * DEGREE)
            rows = self.borders(self.slab(height=height, friction=friction), "--x",
                                f"block.slab.width={truth / 3}:{truth * 2.7}")
            self.assertEqual({r["of"] for r in rows}, {"slides | topples"})
            for row in rows:
                self.assertAlmostEqual(float(row["block.slab.width"]) / truth, 1, delta=1e-12)
                self.assertLess(float(row["x_error"]) / truth, 1e-15)

    def test_limit_and_formulas(self):
        """Below the border it topples at atan(dx/y), above it slides at phi, and both formulas go on."""
        rows = chart("map", self.slab(), "--x", "block.slab.width=0.2:3")
        for row in select(rows, series="limit"):
            topples = math.atan(float(row["block.slab.width"]) / 2) / DEGREE
            self.assertEqual(row["of"], "topples" if topples < 30 else "slides")
            self.assertAlmostEqual(float(row["tilt_deg"]), min(topples, 30), delta=1e-12)
        for row in select(rows, series="moment equilibrium"):
            topples = math.atan(float(row["block.slab.width"]) / 2) / DEGREE
            self.assertAlmostEqual(float(row["tilt_deg"]), topples, delta=1e-12)
        self.assertEqual({float(r["tilt_deg"]) for r in select(rows, series="sliding")}, {30})

    def test_window_of_history(self):
        """Block A towards its peak passes its toe at atan of the arms, 26.215°, at any friction; the limit leaves that
        tilt where friction on the flank behind the toe begins to hold it. There the window opens, and stays open
        where the limit alone says interlocked."""
        peak = ROOT / "examples" / "block_a_peak.yaml"
        rows = chart("map", peak, "--x", "friction_angle_deg=20:80")
        limit = {r["friction_angle_deg"]: float(r["tilt_deg"]) for r in select(rows, series="limit")}
        onset = {r["friction_angle_deg"]: float(r["tilt_deg"]) for r in select(rows, series="certain to stand")}
        pivot = solve(peak)["cases"][0]["toppling"]["critical_angle_deg"]["value"]
        self.assertGreater(len(onset), 50)
        for friction, tilt in onset.items():
            self.assertAlmostEqual(tilt, pivot, delta=1e-9)
            self.assertGreater(limit.get(friction, 90), tilt)
        for friction, tilt in limit.items():
            if friction not in onset:
                self.assertAlmostEqual(tilt, pivot, delta=1e-6)
        self.assertGreater(max(map(float, onset)), max(map(float, limit)))
        borders = {r["of"]: float(r["friction_angle_deg"]) for r in select(rows, series="border")}
        self.assertEqual(set(borders), {"topples | slides and topples", "slides and topples | may move"})
        # two cones on opposite flanks of slope 1/3 see each other: 90° less their inclination
        self.assertAlmostEqual(borders["slides and topples | may move"], 90 - math.atan(1 / 3) / DEGREE, delta=1e-9)

    def test_under_an_earthquake(self):
        """A horizontal coefficient of k_h turns gravity by atan k_h: the borders between motions lie lower by that."""
        text = SLAB.format(width=1, height=2, friction=35, title="A slab")
        self.scene.write_text(text.replace("height: 2}}", "height: 2}, unit_weight_kn_m3: 25}") +
                              "loads: {seismic: {horizontal: 0.1}}\n", encoding="utf-8")
        turned = math.atan(0.1) / DEGREE
        rows = select(chart("map", self.scene, "--x", "block.slab.width=0.3:3"), series="motion",
                      of="topples | slides and topples")
        self.assertGreater(len(rows), 50)
        for row in rows:
            delta = math.atan(float(row["block.slab.width"]) / 2)
            self.assertAlmostEqual(lean(delta, 0.25, float(row["tilt_deg"]) + turned), 35, delta=1e-9)

    def test_axes_carry_quantity_symbol_and_unit(self):
        """Also where a parameter stands for the quantity; one that stands for several lengths has their unit, one that
        is a part of expressions alone is called by its name."""
        self.scene.write_text(
            "topple: 1\nlength_unit: cm\nparameters: {w: 50, h: 120, e: 1, phi: 30, q: 2, s: 1}\n"
            "block: {outline: [[0, 0], [w, 0], [w, h], [0, 100 + 5*e]], unit_weight_kn_m3: 25}\nfriction_angle_deg: phi\n"
            "loads: {surcharges: [{from: [w, h], to: [0, 100 + 5*e], kpa: q}], anchors: [{at: [0, 50], "
            "direction_deg: 10, force_kn: s}]}\ntilt: {towards: left}\n", encoding="utf-8")
        path = self.folder / "map.svg"
        for key, label in (("w", "Parameter w (cm)"), ("e", "Parameter e"), ("parameters.phi", "Friction angle phi (°)"),
                           ("q", "Surcharge 1 q (kPa)"), ("s", "Force of anchor 1 s (kN)"),
                           ("loads.anchors.1.at.2", "loads.anchors.1.at.2 (cm)"),
                           ("loads.anchors.1.force_kn", "Force of anchor 1 T (kN)"),
                           ("block.outline.1.1", "block.outline.1.1 (cm)")):
            ends = "0:30" if key.startswith("block") else "5:60" if label.startswith(("Friction", "Par")) else "1:40"
            self.assertEqual(run("chart", "map", self.scene, "--x", f"{key}={ends}", "-o", path), (0, "", ""), key)
            drawn = [re.sub(r"\s+", " ", "".join(t.itertext())).strip()
                     for t in xml.etree.ElementTree.fromstring(path.read_bytes()).iter()
                     if t.tag.endswith("}text")]
            self.assertIn(label, drawn)

    def test_axes_change_places(self):
        """The same map with the tilt on the x axis."""
        self.slab()
        upright = chart("map", self.scene, "--x", "block.slab.width=0.2:3")
        lying = chart("map", self.scene, "--x", "tilt=0:90", "--y", "block.slab.width=0.2:3")
        self.assertEqual([(r["block.slab.width"], r["tilt_deg"]) for r in upright],
                         [(r["block.slab.width"], r["tilt_deg"]) for r in lying])

    def test_dynamic_border(self):
        """From rest a block on a plane slides and topples at once where phi < delta + atan(kappa
        tan(alpha - delta)): for slabs kappa = 1/4, for a triangle from its own moments. For delta > phi
        it slides alone, whatever the tilt."""
        rows = chart("map", self.slab(friction="35"), "--x", "block.slab.width=0.2:3")
        curve = select(rows, series="motion", of="topples | slides and topples")
        self.assertGreater(len(curve), 50)
        for row in curve:
            delta = math.atan(float(row["block.slab.width"]) / 2)
            self.assertAlmostEqual(lean(delta, 0.25, float(row["tilt_deg"])), 35, delta=1e-9)
        upright = select(rows, series="motion", of="slides and topples | slides")
        self.assertEqual([float(r["tilt_deg"]) for r in upright[1:]], [90])
        for row in upright:
            self.assertAlmostEqual(float(row["block.slab.width"]), 2 * math.tan(35 * DEGREE), delta=1e-14)
        self.assertAlmostEqual(float(upright[0]["tilt_deg"]), 35, delta=1e-12)
        self.assertEqual(len(select(rows, series="motion")), len(curve) + len(upright))
        self.scene.write_text("topple: 1\nlength_unit: m\nparameters: {h: 3}\nblock: {outline: [[0, 0], [1, 0], "
                              "[0.2, h]]}\nfriction_angle_deg: 40\ntilt: {towards: left}\n")
        rows = select(chart("map", self.scene, "--x", "h=1:5"), series="motion", of="topples | slides and topples")
        self.assertGreater(len(rows), 50)
        for row in rows:
            ring = [(Fraction(0), Fraction(0)), (Fraction(1), Fraction(0)), (Fraction(1, 5), Fraction(float(row["h"])))]
            self.assertAlmostEqual(lean(*toe_of(ring), float(row["tilt_deg"])), 40, delta=1e-9)

    def test_motions_of_any_block(self):
        """Block E towards its valley against friction: `solve` finds, a hair below and above each border, the motions
        that the border says, from accelerations and forces at that tilt; at high tilts two of them at once. Where
        it begins to topple about its toe, the force on that leans by phi less the inclination of the facet there."""
        scene = ROOT / "examples/block_e_valley.yaml"
        text = scene.read_text(encoding="utf-8")
        rows = select(chart("map", scene, "--x", "friction_angle_deg=20:80"), series="motion")
        self.assertEqual({r["of"] for r in rows},
                         {"topples | slides and topples", "topples | topples, or slides and topples",
                          "topples, or slides and topples | slides and topples"})
        ring = exact.teeth(3, 30, 120, 5, "valley")
        last = select(rows, of="topples | slides and topples")
        for row in last:
            self.assertAlmostEqual(lean(*toe_of(ring), float(row["tilt_deg"])),
                                   float(row["friction_angle_deg"]) - math.atan(5 / 30) / DEGREE, delta=1e-9)
        within = [r for r in rows if 35.3 < float(r["tilt_deg"]) < 89.9][::9]
        self.assertEqual({r["of"] for r in within}, {r["of"] for r in rows})
        for row in within:
            seen = []
            for off in ("-1e-9", "1e-9"):
                held = text.replace("friction_angle_deg: 30", f"friction_angle_deg: {row['friction_angle_deg']}")
                tilt = Decimal(row["tilt_deg"]) + Decimal(off)
                self.scene.write_text(held.replace("angle_deg: 20", f"angle_deg: {tilt}"), encoding="utf-8")
                own = {motion["mechanism"] for motion in solve(self.scene)["cases"][0]["motions"]}
                seen.append(", or ".join(sorted(own, key=len)))
            self.assertEqual(seen, row["of"].split(" | "))

    def test_block_a_turns_about_a_toe_that_holds(self):
        """At 30° of friction up to 83.07° (docs/onset.md), by the force on the toe, whose facet it climbs."""
        rows = select(chart("map", ROOT / "examples/block_a_peak.yaml", "--x", "friction_angle_deg=20:40"),
                      series="motion")
        self.assertEqual({r["of"] for r in rows}, {"topples | slides and topples"})
        (at_30,) = select(rows, friction_angle_deg="30")
        self.assertAlmostEqual(float(at_30["tilt_deg"]), 83.07, delta=0.005)

    def test_regions_are_of_motions(self):
        """The regions beyond the limit are called by what begins there: a slim slab at a high tilt slides and topples at
        once, although its limit is one of toppling."""
        path = self.folder / "map.svg"
        self.assertEqual(run("chart", "map", self.slab(friction="35"), "--x", "block.slab.width=0.2:3", "-o", path),
                         (0, "", ""))
        text = [t for t in xml.etree.ElementTree.fromstring(path.read_bytes()).itertext() if t.strip()]
        self.assertLessEqual({"topples", "slides", "slides and topples", "stable"}, set(text))

    def test_no_motions_under_cohesion(self):
        """Under cohesion a motion that begins loses it, and with a friction that depends on the stress it changes with
        the tilt: neither has borders of motions, and the limit's mechanism names the regions."""
        plain = SLAB.format(width=1, height=2, friction=30, title="A slab")
        barton = "friction: {law: barton, residual_angle_deg: 25, jcs_mpa: 50, jrc: 8}\n"
        for text in (plain + "loads: {cohesion_kpa: 1}\n", plain.replace("friction_angle_deg: 30\n", barton)):
            self.scene.write_text(text.replace(
                "height: 2}}", "height: 2}, unit_weight_kn_m3: 25}"), encoding="utf-8")
            rows = chart("map", self.scene, "--x", "block.slab.width=0.2:3")
            self.assertEqual(select(rows, series="motion"), [])
            ends = {r["tilt_deg"] for r in select(rows, series="border")}
            self.assertIn("90", ends)

    def test_patton_by_name(self):
        """Sliding is Patton's where the scene gives his law, and sliding along a facet elsewhere."""
        plain = SLAB.format(width=1, height=2, friction=30, title="A slab")
        law = "friction: {law: patton, basic_angle_deg: 30, roughness_angle_deg: 0}\n"
        for text, series, legend in ((plain, "sliding", "sliding along a facet"),
                                     (plain.replace("friction_angle_deg: 30\n", law), "Patton's sliding",
                                      "Patton's sliding")):
            self.scene.write_text(text, encoding="utf-8")
            arguments = ("map", self.scene, "--x", "block.slab.width=0.2:3")
            names = {r["series"] for r in chart(*arguments)}
            self.assertEqual({n for n in names if "sliding" in n}, {series})
            path = self.folder / "map.svg"
            self.assertEqual(run("chart", *arguments, "-o", path), (0, "", ""))
            drawn = "".join(xml.etree.ElementTree.fromstring(path.read_bytes()).itertext())
            self.assertIn(legend, drawn)
            self.assertEqual("Patton" in drawn, "Patton" in legend)

    def test_border_parts_mechanisms(self):
        """Block E towards its valley: a double below and above each border the solver's own verdicts
        differ, as the border says."""
        text = (ROOT / "examples/block_e_valley.yaml").read_text(encoding="utf-8")
        text = text.replace("friction_angle_deg: 30", "friction_angle_deg: 53")
        self.scene.write_text(text, encoding="utf-8")
        rows = self.borders(self.scene, "--x", "c=1:20")
        self.assertEqual(len(rows), 1)
        for root, names in {(float(r["c"]), r["of"]) for r in rows}:
            seen = set()
            for factor in (1 - 1e-12, 1 + 1e-12):
                self.scene.write_text(text.replace("c: 5}", f"c: {root * factor!r}}}"), encoding="utf-8")
                out = json.loads(run("solve", "--json", self.scene)[1])
                seen.add(out["cases"][0]["limit"]["mechanism"])
            self.assertEqual(seen, set(names.split(" | ")))

    def test_two_scalars(self):
        """Over width and height of a slab the border is the line width = height tan phi, and a contour
        of 20 degrees the line width = height tan 20."""
        rows = chart("map", self.slab(), "--x", "block.slab.width=0.3:3", "--y", "block.slab.height=0.5:4")
        border = select(rows, series="border")
        self.assertGreater(len(border), 30)
        for row in border:
            ratio = float(row["block.slab.width"]) / float(row["block.slab.height"])
            self.assertAlmostEqual(ratio / math.tan(30 * DEGREE), 1, delta=1e-12)
        contour = select(rows, series="limit", of="20")
        self.assertGreater(len(contour), 20)
        for row in contour:
            ratio = float(row["block.slab.width"]) / float(row["block.slab.height"])
            self.assertAlmostEqual(ratio / math.tan(20 * DEGREE), 1, delta=1e-9)
            width, height = (Fraction(float(row[f"block.slab.{k}"])) for k in ("width", "height"))
            off = abs(float(width - height * Fraction(math.tan(20 * DEGREE))))
            self.assertLessEqual(off, float(row["x_error"]) + float(row["y_error"]) + 1e-15)
            self.assertLess(float(row["x_error"]) + float(row["y_error"]), 1e-8)

    def test_certain_to_stand_over_two_scalars(self):
        """Deep teeth and a high friction: the limit of block E rises to 90° and vanishes, while it is certain to stand up
        to some 35° alone. Contours say so, and `solve` finds that onset at their points; a slab has none."""
        scene = ROOT / "examples/block_e_valley.yaml"
        text = scene.read_text(encoding="utf-8")
        rows = chart("map", scene, "--x", "c=18:25", "--y", "friction_angle_deg=42:60")
        self.assertGreater(max(float(r["of"]) for r in select(rows, series="limit")), 79)
        stands = select(rows, series="certain to stand")
        self.assertGreater(len(stands), 50)
        self.assertLess(max(float(r["of"]) for r in stands), 40)
        for row in stands[::len(stands) // 6]:
            self.scene.write_text(text.replace("c: 5", f"c: {row['c']}").replace(
                "friction_angle_deg: 30", f"friction_angle_deg: {row['friction_angle_deg']}"), encoding="utf-8")
            own = solve(self.scene)["cases"][0]["onset"]
            self.assertTrue(own["below_limit"])
            self.assertAlmostEqual(own["critical_angle_deg"]["value"], float(row["of"]), delta=1e-7)
        rows = chart("map", self.slab(), "--x", "block.slab.width=0.3:3", "--y", "friction_angle_deg=10:50")
        self.assertEqual(select(rows, series="certain to stand"), [])

    def test_curve_is_one(self):
        """A traced border comes as one curve: its points follow one another along it."""
        rows = select(chart("map", self.slab(), "--x", "block.slab.width=0.3:3", "--y",
                            "block.slab.height=0.5:4"), series="border")
        heights = [float(r["block.slab.height"]) for r in rows]
        self.assertIn(heights, (sorted(heights), sorted(heights, reverse=True)))

    def test_where_the_scene_has_no_answer(self):
        """A slab has no negative width: the map begins at 0, and a map of nothing says why."""
        rows = chart("map", self.slab(), "--x", "block.slab.width=-1:3")
        self.assertTrue(all(float(r["block.slab.width"]) > 0 for r in select(rows, series="limit")))
        status, out, err = run("chart", "map", self.scene, "--x", "block.slab.width=-3:-1")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("nowhere in the map", err)
        self.assertIn("above zero", err.replace("positive", "above zero"))


class Figures(Chart):
    kinds = (["fos"], ["mechanisms"], ["ranges"])

    def all_kinds(self):
        self.slab(title="It's `id` \\\"{/Bold x}_2\"")
        line = ["map", self.scene, "--x", "block.slab.width=0.2:3"]
        return (*self.kinds, line, [*line, "--y", "friction_angle_deg=10:50"])

    def test_whole_and_the_same_again(self):
        """Every kind in every format: well formed, and byte for byte the same on a rerun."""
        for k, arguments in enumerate(self.all_kinds()):
            for ending in ("svg", "pdf", "png", "csv"):
                one, other = (self.folder / f"{k}-{turn}.{ending}" for turn in "ab")
                for path in (one, other):
                    self.assertEqual(run("chart", *arguments, "--output", path), (0, "", ""))
                data = one.read_bytes()
                self.assertEqual(data, other.read_bytes())
                if ending == "svg":
                    root = xml.etree.ElementTree.fromstring(data)
                    self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
                elif ending == "pdf":
                    self.assertTrue(data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"))
                    self.assertNotIn(b"CreationDate", data)
                elif ending == "png":
                    self.assertTrue(data.startswith(b"\x89PNG\r\n\x1a\n"))
                    self.assertIn(b"IEND", data[-12:])
                else:
                    self.assertEqual(data.decode(), run("chart", *arguments)[1])
        self.assertEqual([p for p in self.folder.iterdir() if p.name.endswith(".part")], [])

    def test_text_of_a_user(self):
        """Quotes, backticks and markup of a title are drawn, not carried out."""
        trap = self.folder / "trap"
        self.slab(title=f"\"it's `touch {trap}` {{/Bold x}}_2 \\\\n $(id) 'q' @x\"")
        path = self.folder / "map.svg"
        self.assertEqual(run("chart", "map", self.scene, "--x", "block.slab.width=0.2:3", "-o", path),
                         (0, "", ""))
        text = "".join(xml.etree.ElementTree.fromstring(path.read_bytes()).itertext())
        self.assertIn(f"it's `touch {trap}` {{/Bold x}}_2", text)
        self.assertFalse(trap.exists())

    def test_json(self):
        """The same numbers as JSON, each with its error."""
        for arguments in self.all_kinds():
            status, out, err = run("chart", "--json", *arguments)
            self.assertEqual((status, err), (0, ""))
            data, rows = json.loads(out), chart(*arguments)
            points = [p for s in data["series"] for p in s["points"]]
            self.assertEqual(len(points), len(rows))
            self.assertEqual([p["y"]["value"] for p in points], [float(r[data["y"]]) for r in rows])
            self.assertEqual([p["y"]["error"] for p in points], [float(r["y_error"]) for r in rows])


class Errors(Chart):
    def refuse(self, status, message, *arguments):
        done = run("chart", *arguments)
        self.assertEqual((done[0], done[1]), (status, ""), arguments)
        self.assertIn(message, done[2])

    def test_usage(self):
        self.slab()
        self.refuse(2, "no kind of chart", "pie")
        self.refuse(2, "kind of chart is missing")
        self.refuse(2, "another kind", "ranges", "--friction", 3)
        self.refuse(2, "must rise", "fos", "--tilt", "60:10")
        self.refuse(2, "must rise", "map", self.scene, "--x", "block.slab.width=3:1")
        self.refuse(2, "longer than 127 bytes", "map", self.scene, "--x", "k" * 128 + "=1:3")
        self.refuse(2, "KEY=FROM:TO", "map", self.scene, "--x", "block.slab.width")
        self.refuse(2, "--x KEY=FROM:TO", "map", self.scene)
        self.refuse(2, "scene file is missing", "map")
        self.refuse(2, "must end in", "fos", "--output", self.folder / "a.gif")
        self.refuse(2, "no list", "fos", "--amplitude", "0.1;0.2")
        self.refuse(2, "number", "mechanisms", "--friction", "steep")

    def test_input(self):
        self.slab()
        self.refuse(3, "did you mean 'width'?", "map", self.scene, "--x", "block.slab.widht=1:3")
        self.refuse(3, "list or a map", "map", self.scene, "--x", "block.slab=1:3")
        self.refuse(3, "both axes are tilt", "map", self.scene, "--x", "tilt=1:3")
        self.refuse(3, "cannot be opened", "map", self.folder / "none.yaml", "--x", "a=1:3")
        self.refuse(3, "between 0 and 0.5", "fos", "--amplitude", "0.7")
        self.refuse(3, "at most 80", "mechanisms", "--friction", 75)
        self.refuse(3, "whole", "fos", "--sub-blocks", 2.5)
        self.scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                              "tilt: {towards: left}\n")
        self.refuse(3, "friction_angle_deg", "map", self.scene, "--x", "block.slab.width=1:3")
        self.scene.write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 2}}\n"
                              "friction_angle_deg: 30\n")
        self.refuse(3, "tilts both ways", "map", self.scene, "--x", "block.slab.width=1:3")

    def test_unwritable(self):
        self.refuse(5, "cannot be written", "fos", "--output", self.folder / "none" / "a.svg")
        self.refuse(5, "cannot be written", "fos", "--output", self.folder / "none" / "a.csv")
        (self.folder / "taken.svg").mkdir()
        self.refuse(5, "Is a directory", "fos", "--output", self.folder / "taken.svg")

    def run_with_path(self, path, output):
        return subprocess.run([PROGRAM, "chart", "fos", "--output", output], cwd=ROOT, check=False,
                              capture_output=True, encoding="utf-8", env={**os.environ, "PATH": str(path)})

    def test_without_gnuplot(self):
        """Status 5, what to install, and no file; CSV needs none."""
        tools = self.folder / "tools"
        tools.mkdir()
        done = self.run_with_path(tools, self.folder / "a.svg")
        self.assertEqual(done.returncode, 5)
        self.assertIn("apt-get install gnuplot-nox", done.stderr)
        self.assertEqual(self.run_with_path(tools, self.folder / "a.csv").returncode, 0)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.csv", "tools"])

    def test_gnuplot_fails(self):
        """A gnuplot that fails, or that leaves early, costs no file: what was there stays."""
        tools, figure = self.folder / "tools", self.folder / "a.svg"
        tools.mkdir()
        figure.write_text("as before")
        for script in ("cat >/dev/null; echo half; echo it broke >&2; exit 3", "exit 0", "kill -9 $$"):
            (tools / "gnuplot").write_text(f"#!/bin/sh\nPATH=/bin:/usr/bin\n{script}\n")
            (tools / "gnuplot").chmod(0o755)
            done = self.run_with_path(tools, figure)
            self.assertEqual(done.returncode, 5)
            self.assertIn("gnuplot failed", done.stderr)
            self.assertEqual(figure.read_text(), "as before")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.svg", "tools"])


if __name__ == "__main__":
    main()
