# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Maps of a scene: borders of mechanisms against closed forms and against single solves."""

import json
import math
import re
import xml.etree.ElementTree
from decimal import Decimal
from fractions import Fraction

import exact
from chart_case import Chart, DEGREE, SLAB, chart, lean, select, toe_of
from harness import ROOT, main, rounds, run, solve


# Of angles, in place of the usual ten, which take more time than the borders.
ONE_CONTOUR = ("--contours", "critical_angle=27")
LEVELS = rounds((1, 1.5), (0.9, 1, 1.3, 1.5))  # of the factor


class Map(Chart):
    factors = {}

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
        heights = [float(r["block.slab.height"]) for r in border]  # one curve, whose points follow one another along it
        self.assertIn(heights, (sorted(heights), sorted(heights, reverse=True)))
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
        rows = chart("map", self.slab(), "--x", "block.slab.width=0.9:3", "--y", "friction_angle_deg=25:50")
        self.assertGreater(len(select(rows, series="limit")), 5)
        self.assertEqual(select(rows, series="certain to stand"), [])

    def tilted(self, tilt, x="block.slab.width=0.3:3", y="friction_angle_deg=10:50"):
        """The slab of 1 by 2 at a tilt."""
        text = SLAB.format(width=1, height=2, friction=30, title="A slab")
        self.scene.write_text(text.replace("left}", f"left, angle_deg: {tilt}}}"), encoding="utf-8")
        return self.scene, "--x", x, "--y", y

    def factor(self, levels, x, y):
        """A map that takes seconds, drawn once: one test reads the borders, another the contours."""
        if (x, y) not in self.factors:
            contours = "governing_fos=" + ",".join(map(str, levels))
            self.factors[x, y] = chart("map", *self.tilted(20, x=x, y=y), "--contours", contours)
        return self.factors[x, y]

    def factor_at_20(self):
        return self.factor(LEVELS, "block.slab.width=0.6:3", "friction_angle_deg=18:50")

    def factor_over_tilts(self):
        return self.factor((1, 1.3), "block.slab.width=0.8:1.6", "tilt.angle_deg=15:32")

    def drawn(self, *arguments):
        path = self.folder / "map.svg"
        self.assertEqual(run("chart", "map", *arguments, "-o", path), (0, "", ""))
        return "".join(xml.etree.ElementTree.fromstring(path.read_bytes()).itertext())

    def test_at_the_scenes_tilt(self):
        """At 20° a slab slides where phi < 20° and topples where dx/y < tan 20°; it stands beyond both, and the title says
        at which tilt. Without a tilt, or at any, the first motion stands there as before."""
        root = 2 * math.tan(20 * DEGREE)
        rows = select(self.factor_at_20(), series="border")
        for of, truth, name, error in (("stands | topples", root, "block.slab.width", "x_error"),
                                       ("stands | slides", 20, "friction_angle_deg", "y_error")):
            own = select(rows, of=of)
            self.assertGreater(len(own), 20, of)
            for row in own:
                self.assertLessEqual(abs(float(row[name]) - truth), float(row[error]) + 1e-13, row)
        for row in rows:
            if float(row["x_error"]) > 1e-9:  # the corner, where three meet
                continue
            both = min(float(row["friction_angle_deg"]) - 20, float(row["block.slab.width"]) - root)
            self.assertGreater(both if "stands" in row["of"] else -both, -1e-9, row)
        few = self.tilted(20, x="block.slab.width=1:3", y="friction_angle_deg=25:50")  # where it stands: no borders, little time
        for more, said in (((), True), (("--any-tilt",), False)):
            drawn = self.drawn(*few, *ONE_CONTOUR, *more)
            self.assertEqual(("A slab, at a tilt of 20°" in drawn, "stands" in drawn), (said, said))
        any_tilt = self.borders(*few, *ONE_CONTOUR, "--any-tilt")
        self.slab()
        self.assertEqual(any_tilt, self.borders(*few, *ONE_CONTOUR))
        self.assertEqual({r["of"] for r in any_tilt}, {"slides | topples"})

    def test_the_tilt_as_a_number(self):
        """Where an axis is the scene's own tilt, or a parameter that it is made of, no one tilt stands in the title."""
        self.assertNotIn("at a tilt", self.drawn(*self.tilted(20, x="block.slab.width=1:3", y="tilt.angle_deg=5:12"), *ONE_CONTOUR))
        for row in select(self.factor_over_tilts(), series="border"):
            tilt, own = float(row["tilt.angle_deg"]), math.atan(float(row["block.slab.width"]) / 2) / DEGREE
            if "stands" in row["of"]:
                error = float(row["y_error"]) + float(row["x_error"]) / DEGREE
                self.assertLessEqual(abs(tilt - min(own, 30)), error + 1e-12, row)

    def test_contours_of_the_factor(self):
        """The factor of a slab is the least of dx/(y tan alpha) and tan phi/tan alpha: each point of a contour lies on it
        within its error, also on 1, which a line of the grid follows, and both ways to fail have their part."""
        self.compare_contours(self.factor_at_20(), LEVELS)

    def test_contours_across_a_verdict(self):
        """With the tilt on an axis the factor of a slab passes 1 where the verdict changes, min(atan(dx/y), phi): the contour of 1
        lies there, on both ways to fail, and that of 1.3 below it; none is lost though the verdict leaps."""
        rows = self.factor_over_tilts()
        for level in (1, 1.3):
            parts, found = set(), select(rows, series="governing_fos", of=f"{level:.15g}")
            self.assertGreater(len(found), 40)
            for row in found:
                tangent = min(float(row["block.slab.width"]) / 2, math.tan(30 * DEGREE))
                error = float(row["y_error"]) + float(row["x_error"]) / DEGREE
                self.assertLessEqual(abs(float(row["tilt.angle_deg"]) - math.atan(tangent / level) / DEGREE), error + 1e-9, row)
                parts.add(tangent < math.tan(30 * DEGREE))
            self.assertEqual(parts, {True, False}, level)
        self.assertLessEqual({"stands | topples", "stands | slides"}, {row["of"] for row in select(rows, series="border")})

    def compare_contours(self, rows, levels):
        drive = math.tan(20 * DEGREE)
        self.assertEqual(select(rows, series="limit"), [])
        self.assertEqual({float(r["of"]) for r in select(rows, series="governing_fos")}, set(levels))
        for level in levels:
            parts = set()
            for row in select(rows, series="governing_fos", of=f"{level:.15g}"):
                width, friction = float(row["block.slab.width"]), float(row["friction_angle_deg"])
                topples, slides = width / 2 / drive, math.tan(friction * DEGREE) / drive
                parts.add(topples < slides)
                self.assertAlmostEqual(min(topples, slides), level, delta=1e-9)
                self.assertLess(float(row["x_error"]) + float(row["y_error"]), 1e-8)
                if topples < slides - 1e-6:
                    self.assertLessEqual(abs(width - 2 * level * drive), float(row["x_error"]) + 1e-15)
                elif slides < topples - 1e-6:
                    off = abs(friction - math.atan(level * drive) / DEGREE)
                    self.assertLessEqual(off, float(row["y_error"]) + 1e-14)
            self.assertEqual(parts, {True, False}, level)

    def test_contours_that_cannot_be(self):
        arguments = self.tilted(20)
        for status, said, given in ((2, "known are critical_angle and governing_fos", (*arguments, "--contours", "fos")),
                                    (3, "levels are above 0", (*arguments, "--contours", "governing_fos=0")),
                                    (3, "drop any tilt", (*arguments, "--contours", "governing_fos", "--any-tilt")),
                                    (3, "tilt.angle_deg", (*arguments[:3], "--contours", "governing_fos"))):
            found, out, err = run("chart", "map", *given)
            self.assertEqual((found, out), (status, ""), err)
            self.assertIn(said, err)
        self.slab()
        found, out, err = run("chart", "map", *arguments, "--contours", "governing_fos")
        self.assertEqual((found, out), (3, ""))
        self.assertIn("tilt: {angle_deg", err)

    def test_where_the_scene_has_no_answer(self):
        """A slab has no negative width: the map begins at 0, and a map of nothing says why."""
        rows = chart("map", self.slab(), "--x", "block.slab.width=-1:3")
        self.assertTrue(all(float(r["block.slab.width"]) > 0 for r in select(rows, series="limit")))
        status, out, err = run("chart", "map", self.scene, "--x", "block.slab.width=-3:-1")
        self.assertEqual((status, out), (3, ""))
        self.assertIn("nowhere in the map", err)
        self.assertIn("above zero", err.replace("positive", "above zero"))


if __name__ == "__main__":
    main()
