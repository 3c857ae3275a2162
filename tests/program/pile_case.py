# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of many blocks, by the names and outlines of these."""

import fractions
import math

from harness import ROOT

EXAMPLE = ROOT / "examples" / "blocks" / "toppling_slope.yaml"


def box(left, low, right, high):
    return [(left, low), (right, low), (right, high), (left, high)]


def text_of(points):
    return "[" + ", ".join(f"[{x}, {y}]" for x, y in points) + "]"


class Pile:
    """Blocks by their names: outlines in rationals, of which those that are ground."""

    def __init__(self):
        self.blocks, self.joints = [], []

    def add(self, name, points, ground=False):
        self.blocks.append((name, points, ground))
        return self

    def moved(self, how):
        own = Pile()
        own.joints = self.joints
        own.blocks = [(name, [how(*p) for p in points], ground) for name, points, ground in self.blocks]
        return own

    def scene(self, friction, more="tilt: {towards: left}", unit="m", weight=25):
        lines = ["topple: 1", f"length_unit: {unit}", f"friction_angle_deg: {friction}", more,
                 f"block: {{unit_weight_kn_m3: {weight}}}", "blocks:"]
        for name, points, ground in self.blocks:
            lines.append(f"  - {{name: {name}, {'ground: true, ' if ground else ''}outline: {text_of(points)}}}")
        if self.joints:
            lines += ["joints:"] + [f"  - {{between: [{a}, {b}], friction_angle_deg: {phi}}}" for a, b, phi in self.joints]
        return "\n".join(lines) + "\n"


def turned(pile):
    """Counter-clockwise by the angle with the sine 7/25, which a tilt to the right by the same angle undoes."""
    sine, cosine = fractions.Fraction(7, 25), fractions.Fraction(24, 25)
    own = pile.moved(lambda x, y: tuple(float(v) for v in (cosine * exact(x) - sine * exact(y), sine * exact(x) + cosine * exact(y))))
    return own, math.degrees(math.asin(sine))


def exact(number):
    return fractions.Fraction(str(number)) if isinstance(number, float) else fractions.Fraction(number)


def degrees_of(tangent):
    """An angle as a decimal of which the tangent is right to 1e-15."""
    return f"{math.degrees(math.atan(tangent)):.17g}"


def wall(courses, bricks):
    """Ferris and Tin-Loi (2001): bricks 4 × 1.75, half bricks at the ends of each other course, the lowest among them."""
    own = Pile().add("ground", box(-4, -4, 4 * bricks + 4, 0), True)
    for c in range(courses):
        ends = [4 * k - (2 if c % 2 == 0 else 0) for k in range(bricks + (2 if c % 2 == 0 else 1))]
        for k, (left, right) in enumerate(zip(ends, ends[1:])):
            low = fractions.Fraction(7 * c, 4)
            own.add(f"b{c}.{k}", box(max(left, 0), low, min(right, 4 * bricks), low + fractions.Fraction(7, 4)))
    return own


def arch(count, thickness):
    """A semicircle of voussoirs of mean radius 1 on level ground, from the right springing on; joints are radial."""
    def corner(radius, k):
        if k in (0, count):
            return repr(radius if k == 0 else -radius), "0"
        return repr(radius * math.cos(math.pi * k / count)), repr(radius * math.sin(math.pi * k / count))

    own = Pile().add("ground", box(-2, -1, 2, 0), True)
    inner, outer = 1 - thickness / 2, 1 + thickness / 2
    for k in range(count):
        own.add(f"v{k}", [corner(inner, k), corner(outer, k), corner(outer, k + 1), corner(inner, k + 1)])
    return own
