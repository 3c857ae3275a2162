#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Samples told by doubles with proven bounds: every digit and word of theirs is that of `topple solve` on the same numbers, and
the study says how many they were."""

import json
import math
import re

from harness import main, run
from study_case import StudyCase, factor, shown

BLOCK = """topple: 1
length_unit: m
parameters: {top: 3.2, valley: -0.1, lean: 1.1}
block:
  outline: [[0, 0], [0.5, valley], [1, 0], [lean, 2.9], [0.4, top], [-0.1, 2.8]]
base: {mated: true, between: [[0, 0], [1, 0]], beyond: {left: 0, right: 0.5}}
friction_angle_deg: 30
tilt: {towards: TOWARDS, angle_deg: 15}
"""

# loads that turn with the tilt: an earthquake, water in the joint behind and below, a weight on the top
LOADED = """topple: 1
length_unit: m
block:
  outline: [[0, 0], [0.5, -0.05], [1.2, 0], [1.2, 2.4], [0, 2.4]]
  thickness: 2
  unit_weight_kn_m3: 26
base: {mated: true, between: [[0, 0], [1.2, 0]], beyond: {left: 0.5, right: 0.5}}
loads:
  seismic: {horizontal: 0.05, vertical: 0.02}
  water: {height: 0.6, uplift: true, unit_weight_kn_m3: 9.81}
  surcharges: [{from: [0.5, 2.4], to: [1.2, 2.4], kpa: 5}]
friction_angle_deg: 34
tilt: {towards: TOWARDS, angle_deg: 12}
"""

# loads that stay with the block as it is tilted: bolts, a pressure, a lining, beside an earthquake that turns
ANCHORED = """topple: 1
length_unit: m
block:
  outline: [[0, 0], [0.5, -0.05], [1.2, 0], [1.2, 2.4], [0, 2.4]]
  thickness: 2
  unit_weight_kn_m3: 26
base: {mated: true, between: [[0, 0], [1.2, 0]], beyond: {left: 0.5, right: 0.5}}
loads:
  seismic: {horizontal: 0.05, direction: down_dip}
  pressures: [{from: [1.2, 0], to: [1.2, 2.4], kpa: [3, 0]}]
  support_pressures: [{from: [0, 2.4], to: [0, 0], kpa: 1.5}]
  anchors:
  - {at: [0, 1.6], DIRECTION, force_kn: 8, passive: true}
  - {at: [0.2, 2.4], direction_deg: -45, force_kn: 6, spacing: 1.5}
friction_angle_deg: 36
tilt: {towards: left, angle_deg: 12}
"""

# bonds and an earthquake: the moments about its toe are in closed form (test_rows_are_shaken)
BONDED = LOADED[:LOADED.index("loads:")] + """loads: {seismic: {horizontal: 0.05, direction: down_dip}, cohesion_kpa: 5, bond_kpa: 3}
friction_angle_deg: 34
tilt: {towards: left, angle_deg: 12}
"""


def toppling_of_bonded(horizontal, bond):
    """Its factor by moments about the toe, in the origin: the weight by its two components, the earthquake, the bond of each facet."""
    outline = [(0, 0), (0.5, -0.05), (1.2, 0), (1.2, 2.4), (0, 2.4)]
    area = x = y = joint = 0
    for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
        twice = x0 * y1 - x1 * y0
        area, x, y = area + twice / 2, x + (x0 + x1) * twice / 6, y + (y0 + y1) * twice / 6
    for (x0, y0), (x1, y1) in zip(outline[:2], outline[1:3]):
        length = math.hypot(x1 - x0, y1 - y0)
        joint += x0 * (x1 - x0) + y0 * (y1 - y0) + length * length / 2
    weight, sine, cosine = 2 * 26 * area, math.sin(math.radians(12)), math.cos(math.radians(12))
    x, y = x / area, y / area
    return (weight * cosine * x + 2 * bond * joint) / (weight * sine * y + horizontal * weight * (cosine * y + sine * x))


# valley, peak and the flank between them, three times over: facets in parallel
TEETH = """topple: 1
length_unit: mm
block: {teeth: {count: 3, width: 30, height: 120, depth: 5, left_end: valley}}
base: {mated: true, beyond: {left: 0, right: 0}}
friction_angle_deg: 30
tilt: {towards: left, angle_deg: 20}
"""


class Filter(StudyCase):
    def check(self, scene, vary, tilts, samples=3000, step=150, least=0.95):
        """All rows told, all but few by doubles, and every so many the same as one solve at each tilt."""
        (self.folder / "scene.yaml").write_text(scene)
        (self.folder / "study.yaml").write_text(f"topple_study: 1\nscene: scene.yaml\nsamples: {samples}\nvary:\n{vary}"
                                                f"tilts_deg: {tilts}\n")
        summary = self.summary("study.yaml", "--rows", "rows.csv", "--restart")
        rows = self.rows()
        self.assertEqual(summary["open"], 0)
        self.assertGreaterEqual(summary["by_doubles"], least * samples)
        keys = [line.split(":")[0].strip() for line in vary.splitlines()]
        columns = list(rows[0])[1:1 + len(keys)]  # with the unit of what is a length
        for row in rows[::step]:
            settings = [word for key, column in zip(keys, columns) for word in ("--set", f"{key}={row[column]}")]
            own = self.solve(settings)
            self.assertEqual((float(row["fos_moments"]), float(row["fos_sliding"])),
                             (factor(own, "moments"), factor(own, "shear strength")))
            for tilt in tilts:
                case = self.solve([*settings, "--set", f"tilt.angle_deg={tilt}"])
                fos = case["governing_fos"]["fos"]  # null where nothing overturns
                self.assertEqual(row[f"outcome_at_{tilt}_deg"], case["mechanism"])
                self.assertEqual(float(row[f"fos_at_{tilt}_deg"]), shown(fos) if fos else float("inf"))
            self.compare(row, own)
        return summary

    def solve(self, settings):
        status, out, err = run("solve", "--json", "scene.yaml", *settings, folder=self.folder)
        self.assertEqual(status, 0, err)
        return json.loads(out)["cases"][0]

    def compare(self, row, case):
        """What does not depend on the tilt."""
        pivot = case["pivots"][case["toppling"]["pivot"]]
        self.assertEqual(float(row["moments_deg"]), shown(case["toppling"]["critical_angle_deg"]))
        self.assertEqual((float(row["pivot_x_m"]), float(row["pivot_y_m"])), (shown(pivot["x_m"]), shown(pivot["y_m"])))
        self.assertEqual(float(row["onset_deg"]), shown(case["onset"]["critical_angle_deg"]))
        self.assertEqual(float(row["limit_deg"]), shown(case["limit"]["critical_angle_deg"]))
        self.assertEqual((row["limit_mechanism"], row["first"], row["status"]),
                         (case["limit"]["mechanism"], case["first"]["mechanism"], "certain"))

    def test_rows_are_shaken(self):
        """The story: whether a sample is without its earthquake was not set where it was made, so that up to a third of the rows of a long
        study were those of the block at rest, other ones in each run, and certain. All are in closed form."""
        (self.folder / "scene.yaml").write_text(BONDED)
        (self.folder / "study.yaml").write_text(
            "topple_study: 1\nscene: scene.yaml\nsamples: 12000\nsampling: {chunk: 1000}\nvary:\n"
            "  friction_angle_deg: {normal: {mean: 34, deviation: 2}}\n  loads.bond_kpa: {uniform: {low: 1, high: 5}}\n"
            "  loads.seismic.horizontal: {triangular: {low: 0, mode: 0.02, high: 0.12}}\n")
        summary = self.summary("study.yaml", "--rows", "rows.csv", "--restart")
        self.assertGreater(summary["by_doubles"], 0.95 * 12000)
        wrong = [row for row in self.rows() if not math.isclose(
            float(row["fos_moments"]), toppling_of_bonded(float(row["loads.seismic.horizontal"]), float(row["loads.bond_kpa"])), rel_tol=1e-8)]
        self.assertEqual(len(wrong), 0, wrong[:1])

    def test_a_block_whose_vertices_vary(self):
        """Six vertices of which three move, on a valley, either way."""
        for towards in ("left", "right"):
            self.check(BLOCK.replace("TOWARDS", towards),
                       "  parameters.top: {normal: {mean: 3.2, deviation: 0.05}}\n"
                       "  parameters.valley: {normal: {mean: -0.1, deviation: 0.01}}\n"
                       "  parameters.lean: {uniform: {low: 1.02, high: 1.2}}\n"
                       "  friction_angle_deg: {normal: {mean: 30, deviation: 3}}\n", [0, 5, 14, 19, 26])

    def test_map_coordinates(self):
        """The same block at x = 500 000, y = 4 600 000, as a GIS has it: as many samples by doubles, and rows alike but for where
        the pivot is. All samples left the filter, as differences were as coarse as coordinates are far away."""
        vary = ("  parameters.top: {normal: {mean: 3.2, deviation: 0.05}}\n"
                "  parameters.valley: {normal: {mean: -0.1, deviation: 0.01}}\n"
                "  parameters.lean: {uniform: {low: 1.02, high: 1.2}}\n"
                "  friction_angle_deg: {normal: {mean: 30, deviation: 3}}\n")
        home = BLOCK.replace("TOWARDS", "left")
        away = re.sub(r"\[(-?[\d.]+|lean), (-?[\d.]+|top|valley)\]", r"[500000 + \1, 4600000 + \2]", home)
        self.assertEqual(away.count("4600000"), 8)
        at_home, rows = self.check(home, vary, [0, 14]), self.rows()
        self.assertEqual(self.check(away, vary, [0, 14])["by_doubles"], at_home["by_doubles"])
        where = ("pivot_x_m", "pivot_y_m", "seconds")
        kept = [k for k, key in enumerate(rows[0]) if key not in where]  # by place: keys of sums have no unit
        for one, other in zip(rows, self.rows(), strict=True):
            self.assertEqual([list(one.values())[k] for k in kept], [list(other.values())[k] for k in kept])

    def test_a_slab_that_varies(self):
        """Width, height and friction: it slides, or it topples."""
        self.check("topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 3}}\nbase: {mated: true}\n"
                   "friction_angle_deg: 30\ntilt: {towards: left, angle_deg: 25}\n",
                   "  block.slab.height: {uniform: {low: 1, high: 6}}\n"
                   "  block.slab.width: {normal: {mean: 2, deviation: 0.1}}\n"
                   "  friction_angle_deg: {normal: {mean: 30, deviation: 3}}\n", [0, 10, 22, 31])

    def test_teeth_whose_friction_varies(self):
        self.check(TEETH, "  friction_angle_deg: {uniform: {low: 12, high: 45}}\n", [8, 20, 29, 36], least=0.4)

    def test_loads_that_vary(self):
        for towards in ("left", "right"):
            self.check(LOADED.replace("TOWARDS", towards),
                       "  friction_angle_deg: {normal: {mean: 34, deviation: 3}}\n"
                       "  block.unit_weight_kn_m3: {uniform: {low: 25, high: 27}}\n"
                       "  loads.water.height: {uniform: {low: 0, high: 1.4}}\n"
                       "  loads.water.unit_weight_kn_m3: {uniform: {low: 9.8, high: 10.5}}\n"
                       "  loads.seismic.horizontal: {normal: {mean: 0.05, deviation: 0.05}}\n"
                       "  loads.seismic.vertical: {uniform: {low: -0.05, high: 0.05}}\n", [0, 6, 12, 18, 24])

    def test_loads_that_stay_with_the_block(self):
        self.check(ANCHORED.replace("DIRECTION", "dip_deg: 15"),
                   "  friction_angle_deg: {normal: {mean: 36, deviation: 3}}\n"
                   "  block.unit_weight_kn_m3: {uniform: {low: 25, high: 27}}\n"
                   "  loads.anchors.1.force_kn: {uniform: {low: 2, high: 14}}\n"
                   "  loads.seismic.horizontal: {normal: {mean: 0.05, deviation: 0.05}}\n", [0, 6, 18, 30], samples=400, step=40)

    def test_cohesion_and_bonds(self):
        """On a valley, in metres and in feet, and of a block whose outline varies, too."""
        vary = ("  friction_angle_deg: {normal: {mean: 34, deviation: 3}}\n"
                "  loads.cohesion_kpa: {uniform: {low: 1, high: 8}}\n"
                "  loads.bond_kpa: {uniform: {low: 0.5, high: 6}}\n")
        for towards, unit in (("left", "m"), ("right", "ft")):
            glued = BLOCK.replace("TOWARDS", towards).replace("length_unit: m", f"length_unit: {unit}")
            glued = glued.replace("base:", "  unit_weight_kn_m3: 26\nbase:")
            glued += "loads: {cohesion_kpa: 4, bond_kpa: 3, seismic: {horizontal: 0.03}}\n"
            self.check(glued, vary + "  loads.seismic.horizontal: {uniform: {low: 0, high: 0.1}}\n", [0, 8, 19], samples=300,
                       step=50, least=0.8)
            self.check(glued, vary + "  parameters.top: {uniform: {low: 3.1, high: 3.3}}\n", [0, 12], samples=200, step=50,
                       least=0.8)

    def test_loads_that_stay_on_a_slope(self):
        """Not those that another dip or thickness changes: a bolt that dips, one without a spacing, water of a level."""
        on_slope = ANCHORED.replace("tilt: {towards: left, angle_deg: 12}\n", "slope: {dip_deg: 15, towards: left}\n")
        pull, bolt = "direction_deg: 5", "dip_deg: 15"
        wet = (LOADED.replace("tilt: {towards: TOWARDS, angle_deg: 12}", "slope: {dip_deg: 12, towards: left}")
               .replace("vertical: 0.02", "direction: down_dip")
               .replace("{height: 0.6, uplift: true, unit_weight_kn_m3: 9.81}", "{level: 0.6, faces: behind, uplift: full}"))
        friction, dip, thickness = {"friction_angle_deg": (30, 42)}, {"slope.dip_deg": (8, 30)}, {"block.thickness": (1, 3)}
        for text, vary, told in ((on_slope.replace("DIRECTION", pull), friction | dip, True),
                                 (on_slope.replace("DIRECTION", bolt), friction, True),
                                 (on_slope.replace("DIRECTION", bolt), friction | dip, False),
                                 (on_slope.replace("DIRECTION", pull), friction | thickness, False),
                                 (on_slope.replace("DIRECTION", f"{pull}, spacing: 2"), friction | thickness, True),
                                 (wet, friction, True), (wet, dip, False)):
            (self.folder / "scene.yaml").write_text(text)
            share = self.check_slope(vary, samples=200, step=20)
            self.assertTrue(share >= 0.95 if told else share == 0, (text, vary, share))

    def check_slope(self, vary, samples=400, step=40):
        """Rows of a scene on a slope, each of so many the same as one solve."""
        (self.folder / "study.yaml").write_text(f"topple_study: 1\nscene: scene.yaml\nsamples: {samples}\nvary:\n" + "".join(
            f"  {key}: {{uniform: {{low: {low}, high: {high}}}}}\n" for key, (low, high) in vary.items()))
        summary = self.summary("study.yaml", "--rows", "rows.csv", "--restart")
        rows = self.rows()
        columns = list(rows[0])[1:1 + len(vary)]
        for row in rows[::step] if summary["by_doubles"] > 0 else []:
            case = self.solve([word for key, column in zip(vary, columns) for word in ("--set", f"{key}={row[column]}")])
            fos = case["governing_fos"]["fos"]
            self.assertEqual((row["outcome"], float(row["fos"])), (case["mechanism"], shown(fos) if fos else float("inf")))
            self.compare(row, case)
        return summary["by_doubles"] / samples

    def test_a_block_on_a_slope_that_varies_with_it(self):
        for towards in ("left", "right"):
            (self.folder / "scene.yaml").write_text(
                BLOCK.replace("tilt: {towards: TOWARDS, angle_deg: 15}", f"slope: {{dip_deg: 15, towards: {towards}}}"))
            told = self.check_slope({"slope.dip_deg": (5, 35), "friction_angle_deg": (25, 40), "parameters.top": (3.1, 3.3),
                                     "parameters.valley": (-0.12, -0.08)})
            self.assertGreaterEqual(told, 0.95)

    def test_a_slope_whose_dip_varies(self):
        """The dip is the tilt, either way; an earthquake that may act both ways leaves all samples to the solve."""
        vary = {"slope.dip_deg": (5, 40), "friction_angle_deg": (28, 40), "loads.water.height": (0, 1.4),
                "loads.seismic.horizontal": (-0.02, 0.1)}
        text = LOADED.replace("tilt: {towards: TOWARDS, angle_deg: 12}\n", "slope: {dip_deg: 15, towards: TOWARDS}\n")
        text = text.replace("vertical: 0.02", "direction: DIRECTION")
        for towards, direction, least in (("left", "down_dip", 0.95), ("right", "down_dip", 0.95), ("left", "both", 0)):
            (self.folder / "scene.yaml").write_text(text.replace("TOWARDS", towards).replace("DIRECTION", direction))
            told = self.check_slope(vary)
            self.assertTrue(told >= least if least > 0 else told == 0, told)

    def test_a_block_in_the_frame_of_the_world(self):
        """Turned by a slope of 3 in 16 to either side, with what holds and shakes it; a tilt that is added to the dip is solved."""
        points = [(0, 0), (0.5, -0.06), (1.2, 0), (1.2, 2.4), (0, 2.4)]
        for side in (1, -1):
            turned = [(x - side * y * 3 / 16, y + side * x * 3 / 16) for x, y in points]
            ends = f"[[{turned[0][0]}, {turned[0][1]}], [{turned[2][0]}, {turned[2][1]}]]"
            text = ("topple: 1\nlength_unit: m\nframe: world\nblock:\n  outline: "
                    f"[{', '.join(f'[{x}, {y}]' for x, y in turned)}]\n  unit_weight_kn_m3: 26\n"
                    f"base: {{mated: true, between: {ends}, beyond: {{left: 0, right: 0}}}}\nloads:\n"
                    "  seismic: {horizontal: 0.05, direction: down_dip}\n"
                    f"  anchors: [{{at: [{turned[4][0]}, {turned[4][1]}], direction_deg: {270 - 80 * side}, force_kn: 4}}]\n"
                    f"  surcharges: [{{from: [{turned[3][0]}, {turned[3][1]}], to: [{turned[4][0]}, {turned[4][1]}], kpa: 3}}]\n"
                    "  cohesion_kpa: 2\nfriction_angle_deg: 36\n")
            vary = {"friction_angle_deg": (25, 42), "loads.seismic.horizontal": (0, 0.2), "loads.anchors.1.force_kn": (2, 8),
                    "loads.cohesion_kpa": (1, 4)}
            for extra, also, least in (("", {}, 0.9), ("tilt: {angle_deg: 3}\n", {}, 0.9),
                                       ("tilt: {angle_deg: 3}\n", {"tilt.angle_deg": (1, 9)}, 0)):
                (self.folder / "scene.yaml").write_text(text + extra)
                told = self.check_slope(vary | also, samples=200)
                self.assertTrue(told >= least if least > 0 else told == 0, (extra, also, told))

    def test_a_unit_weight_beside_that_of_a_part_moves_the_centroid(self):
        """No row may be that of another unit weight: with a lighter part in it the block has another centroid."""
        (self.folder / "parts.yaml").write_text(
            "topple: 1\nlength_unit: m\nblock:\n  outline: [[0, 0], [1, 0], [1, 3], [0, 3]]\n  unit_weight_kn_m3: 26\n"
            "  parts: [{outline: [[0.1, 0.1], [0.5, 0.1], [0.5, 2], [0.1, 2]], unit_weight_kn_m3: 10}]\n"
            "base: {mated: true}\nfriction_angle_deg: 30\ntilt: {towards: left, angle_deg: 10}\n")
        (self.folder / "study.yaml").write_text("topple_study: 1\nscene: parts.yaml\nvary:\n"
                                                "  block.unit_weight_kn_m3: {list: [20, 26, 40]}\n")
        self.summary("study.yaml", "--rows", "rows.csv")
        for row, weight in zip(self.rows(), (20, 26, 40)):
            status, out, err = run("solve", "--json", "parts.yaml", "--set", f"block.unit_weight_kn_m3={weight}",
                                   folder=self.folder)
            self.assertEqual(status, 0, err)
            self.compare(row, json.loads(out)["cases"][0])

    def test_ties_climb(self):
        """A cube at 45 degrees of friction slides as soon as it topples: that no double tells, and the ladder does."""
        (self.folder / "slab.yaml").write_text("topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 1}}\n"
                                               "base: {mated: true}\nfriction_angle_deg: 45\n"
                                               "tilt: {towards: left, angle_deg: 20}\n")
        self.write("vary:\n  friction_angle_deg: {list: [44, 45, 46]}\n")
        summary = self.summary("study.yaml", "--rows", "rows.csv")
        self.assertEqual((summary["samples"], summary["by_doubles"]), (3, 2))
        self.assertEqual([row["first"] for row in self.rows()], ["slides", "slides and topples", "topples"])

    def test_rows_that_were_read_are_told_again(self):
        """Merged or gone on with, a study says the same of what told it."""
        self.write("samples: 300\nsampling: {chunk: 50}\nvary:\n  friction_angle_deg: {normal: {mean: 30, deviation: 2}}\n")
        whole = self.study("study.yaml")
        self.assertRegex(whole, r"\n29\d samples solved in doubles with proven bounds, \d in higher precision\.\n")
        for part in ("1/2", "2/2"):
            self.study("study.yaml", "--shard", part, "--rows", f"part{part[0]}.csv")
        self.assertEqual(self.study("study.yaml", "--merge", "part1.csv", "part2.csv"), whole)


if __name__ == "__main__":
    main()
