# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What holds of a scene holds of its mirror image, of the scene elsewhere and in another unit: not only
of `solve` (tests/statics/test_random_effects.c) but of back-analysis, maps, tables and derived formulas. Scenes
are drawn from a seed with parameters that each command varies; TOPPLE_ROUNDS multiplies their number."""

import dataclasses
import json
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction as F

from harness import ROUNDS, main, rounds, run

SCENES = 8 * ROUNDS
FACTOR = {"m": F(1), "mm": F(1, 1000), "ft": F(381, 1250)}


@dataclasses.dataclass
class Scene:
    """A block on steps of its own, of a height that is a parameter; lengths in metres."""
    steps: list
    load: str  # none, seismic, water, anchor, cohesion
    corner: bool
    friction: int
    towards: str = "left"
    mirrored: bool = False
    shift: tuple = (F(0), F(0))
    unit: str = "m"

    def point(self, x, y, more=""):
        """[x, y], y being of the height h where `more` says so."""
        x = -x if self.mirrored else x
        scale = FACTOR[self.unit]
        return f"[{(x + self.shift[0]) / scale}, {(y + self.shift[1]) / scale}{more}]"

    def text(self):
        width = self.steps[-1][0]
        lower = [self.point(x, y) for x, y in self.steps]
        upper = [self.point(width, F(0), " + h"), self.point(F(0), F(0), " + h")]
        lines = ["topple: 1", f"length_unit: {self.unit}",
                 f"parameters: {{h: {3 / FACTOR[self.unit]}}}", "block:",
                 f"  outline: [{', '.join(lower + upper)}]",
                 f"  thickness: {1 / FACTOR[self.unit]}", "  unit_weight_kn_m3: 26"]
        if self.corner:
            end = "right_end" if self.mirrored else "left_end"
            lines += ["  rounded: {corners: [{at: " + end + f", radius: {F(1, 10) / FACTOR[self.unit]}" + "}]}"]
        lines += ["base: {mated: true}", f"friction_angle_deg: {self.friction}"]
        direction = 180 - 165 if self.mirrored else 165
        loads = {"seismic": "{seismic: {horizontal: 1/10}}",
                 "water": f"{{water: {{height: {F(1) / FACTOR[self.unit]}}}}}",
                 "anchor": "{anchors: [{at: " + self.point(F(0), F(0), " + h")
                           + f", direction_deg: {direction}, force_kn: 3" + "}]}",
                 "cohesion": "{cohesion_kpa: 2}"}
        if self.load in loads:
            lines.append("loads: " + loads[self.load])
        towards = self.towards if not self.mirrored else {"left": "right", "right": "left"}[self.towards]
        lines.append(f"tilt: {{towards: {towards}, angle_deg: 5}}")
        return "\n".join(lines) + "\n"


def draw():
    steps = [(F(0), F(random.randint(-2, 2), 16))]
    for _ in range(random.randint(1, 3)):
        steps.append((steps[-1][0] + F(random.randint(2, 8), 8), F(random.randint(-2, 2), 16)))
    return Scene(steps, random.choice(["none", "seismic", "water", "anchor", "cohesion"]),
                 random.random() < 0.3, random.choice([20, 35, 45, 60]),
                 random.choice(["left", "right"]))


def variants(scene):
    yield "mirrored", dataclasses.replace(scene, mirrored=True)
    yield "shifted", dataclasses.replace(scene, shift=(F(1, 3), F(-10, 7)))
    yield "far", dataclasses.replace(scene, shift=(F(10**9, 3), F(1, 7)))
    yield "unit", dataclasses.replace(scene, unit=random.choice(["mm", "ft"]))


def per_unit(argument, scene):
    """A number of metres, as 9@, in the scene's unit."""
    return str(float(int(argument[:-1] or 1) / FACTOR[scene.unit])) if argument.endswith("@") else argument


def topple(scene, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "scene.yaml")
        path.write_text(scene.text(), encoding="utf-8")
        status, out, err = run(*[str(path) if a == "SCENE" else a for a in arguments])
    return status, out, err


def numbers(value):
    """Every {value, error} in a result, in order, as (value, error)."""
    if isinstance(value, dict):
        if set(value) >= {"value", "error"}:
            return [(value["value"], value["error"])]
        return [n for v in value.values() for n in numbers(v)]
    if isinstance(value, list):
        return [n for v in value for n in numbers(v)]
    return []


class Symmetry(unittest.TestCase):
    def setUp(self):
        random.seed(2012)
        self.scenes = [draw() for _ in range(SCENES)]

    def same(self, one, other, scale, story, slack=0):
        """Two lists of bounded numbers, the other `scale` times as large, to `slack` of their size."""
        self.assertEqual(len(one), len(other), story)
        for (a, e), (b, f) in zip(one, other):
            room = scale * e + f + (4e-16 + slack) * abs(b)  # and the rounding of this comparison
            self.assertLessEqual(abs(scale * a - b), room, story)

    def each(self, arguments, of, scales=lambda scene: 1.0, slack=0, every=1):
        """`of` takes the numbers out of a JSON result; they grow by `scales` of the variant. Of some `every` so many scenes."""
        compared = 0
        for scene in self.scenes[::every]:
            unit = lambda s: [per_unit(a, s) for a in arguments]
            status, out, err = topple(scene, *unit(scene))
            for name, variant in variants(scene):
                story = f"{name}\n{scene.text()}\n{variant.text()}"
                other_status, other, other_err = topple(variant, *unit(variant))
                self.assertEqual(status, other_status, story + err + other_err)
                if status == 0:
                    self.same(of(json.loads(out)), of(json.loads(other)), scales(variant), story, slack)
                    compared += len(of(json.loads(out)))
        self.assertGreater(compared, SCENES)

    def test_back_analysis_of_friction(self):
        """The friction that explains a limit."""
        self.each(["solve", "--json", "--find", "friction_angle_deg", "--for", "limit_angle=12", "SCENE"],
                  lambda r: numbers(r["find"]["solutions"]), every=rounds(2, 1))

    def test_back_analysis_of_a_length(self):
        """The height at which the block topples at 20 degrees, in the scene's unit."""
        self.each(["solve", "--json", "--find", "h", "--for", "critical_angle=20", "--from", "@",
                   "--to", "9@", "SCENE"],
                  lambda r: numbers(r["find"]["solutions"]), lambda s: float(1 / FACTOR[s.unit]), every=rounds(2, 1))

    def test_map(self):
        """The map along the friction angle: every border. Where two meet is bracketed between neighbouring doubles,
        which may be others for the mirror image: there a curve ends some 2^-52 of x sooner or later."""
        self.each(["chart", "map", "--json", "--x", "friction_angle_deg=10:50", "SCENE"],
                  lambda r: numbers([[p["y"] for p in s["points"]] for s in r["series"]]), slack=1e-13, every=rounds(2, 1))

    def test_table(self):
        """Every angle and mechanism of its row; names of sides are mirrored."""
        for scene in self.scenes:
            row = topple(scene, "solve", "--table", "SCENE")[1].splitlines()[-1].split("|")
            for name, variant in variants(scene):
                other = topple(variant, "solve", "--table", "SCENE")[1].splitlines()[-1].split("|")
                self.assertEqual(row[3:], other[3:], f"{name}\n{scene.text()}")

    def test_derived_formula(self):
        """tan of each critical angle, in h: the same polynomials, in the other order where mirrored,
        and with h in its unit the same number."""
        for scene in self.scenes:
            plain = dataclasses.replace(scene, load="none", corner=False)
            one = json.loads(topple(plain, "derive", "--json", "SCENE")[1])["pivots"]
            for name, variant in variants(plain):
                other = json.loads(topple(variant, "derive", "--json", "SCENE")[1])["pivots"]
                other = other[::-1] if variant.mirrored else other
                story = f"{name}\n{plain.text()}"
                self.assertEqual([p["kind"] for p in one], [p["kind"] for p in other], story)
                if name in ("mirrored",):
                    self.assertEqual([p["tan_critical_angle"] for p in one],
                                     [p["tan_critical_angle"] for p in other], story)
                self.same(numbers([p["critical_angle_deg"] for p in one]),
                          numbers([p["critical_angle_deg"] for p in other]), 1.0, story)


if __name__ == "__main__":
    main()
