# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Formulas of the hard cases: a small language that is exact as long as it can be.

Numbers are rationals, read from their decimal text; + - * / ** of rationals are rational. Where a
root, a circular function or pi comes in, decimals at exact.py's digits go on. Also lists, names, and
the functions below. It shares no code with Topple: Python's parser, fractions and decimals."""

import ast
from decimal import Decimal, getcontext
from fractions import Fraction

import exact
import limit_oracle
import onset_oracle

EXACT = (int, Fraction)


def number(value):
    """A rational or a decimal as a decimal."""
    return exact.decimal(value) if isinstance(value, EXACT) else value


def sine_cosine(degrees):
    """Circular functions of an angle in degrees, which may be a decimal itself."""
    radians = number(degrees) * exact.PI / 180
    if abs(radians) < Decimal(10) ** (-getcontext().prec // 4):  # five powers on they are beyond the digits
        return radians - radians**3 / 6, 1 - radians**2 / 2
    return exact.sin_cos(Fraction(degrees))


def tan(degrees):
    if degrees in (0, 45):
        return Fraction(degrees, 45)
    sine, cosine = sine_cosine(degrees)
    return sine / cosine


def atan2(y, x):
    """The angle of the vector (x, y) in degrees, -180 to 180; exact for multiples of 45."""
    if y == 0 or x == 0 or abs(y) == abs(x):
        way = {(0, 1): 0, (1, 1): 45, (1, 0): 90, (1, -1): 135, (0, -1): 180,
               (-1, 1): -45, (-1, 0): -90, (-1, -1): -135}
        return Fraction(way[(y > 0) - (y < 0), (x > 0) - (x < 0)])
    if isinstance(y, EXACT) and isinstance(x, EXACT):
        return exact.atan2_degrees(y, x)
    return exact.atan2_degrees(Fraction(y), Fraction(x))


def asin(value):
    value = number(value)
    return exact.degrees(exact.atan(value / (1 - value * value).sqrt()))


def root(value):
    return number(value).sqrt()


def area(outline, *holes):
    return exact.block_moments(outline, holes)[0]


def centroid(outline, *holes):
    return list(exact.centroid(exact.block_moments(outline, holes)))


def mixed_centroid(outline, part, ratio):
    """Of a block with one part that is `ratio` times as heavy."""
    return list(exact.centroid(exact.block_moments(outline, (), [(part, ratio)])))


def critical(outline, pivot, towards="left"):
    """The angle of the moments about a pivot, of a block without holes."""
    x, y = centroid(outline)
    return atan2(x - pivot[0] if towards == "left" else pivot[0] - x, y - pivot[1])


def limit_tangent(outline, profile, friction, towards="left"):
    """The tangent of the static limit by all bases of its program: [low, high], equal where the
    friction is 0 or 45 degrees; None where it is interlocked."""
    if towards == "right":
        outline = [(-x, y) for x, y in reversed(outline)]
        profile = [(-x, y) for x, y in reversed(profile)]
    points = limit_oracle.contacts([tuple(p) for p in outline], [tuple(p) for p in profile])
    sides = [limit_oracle.Limit(points, centroid(outline), tangent)
             for tangent in limit_oracle.tangents(friction)]
    if any(side.most is None for side in sides):
        return None
    return [min(side.most for side in sides), max(side.most for side in sides)]


def limit_angle(outline, profile, friction, towards="left"):
    return angle_or_none(limit_tangent(outline, profile, friction, towards))


def onset_angle(outline, profile, friction, towards="left"):
    """The onset of motion by trial of all contact modes, at a friction of 0 or 45 degrees: the lower end
    of the window that holds level ground or else of the first above; None where there is none."""
    if towards == "right":
        outline = [(-x, y) for x, y in reversed(outline)]
        profile = [(-x, y) for x, y in reversed(profile)]
    points = limit_oracle.contacts([tuple(p) for p in outline], [tuple(p) for p in profile])
    middle = centroid(outline)
    tangent = {0: Fraction(0), 45: Fraction(1)}[friction]
    onset = onset_oracle.Onset(points, middle, onset_oracle.gyration(outline, middle), tangent)
    first = next((w for w in onset.windows if w[1] is None or w[1] >= 0), (None, None))
    return None if first[0] is None else atan2(first[0], 1)


def angle_or_none(tangents):
    """Of a pair of tangents that enclose one; None as it is."""
    if tangents is None:
        return None
    low, high = (atan2(t, 1) for t in tangents)
    return low if low == high else Enclosure(low, high)


class Enclosure:
    """Two numbers, the truth between them."""

    def __init__(self, low, high):
        self.low, self.high = number(low), number(high)


FUNCTIONS = {
    "tan": tan, "sin": lambda a: sine_cosine(a)[0], "cos": lambda a: sine_cosine(a)[1],
    "atan2": atan2, "atan": lambda t: atan2(t, 1), "asin": asin, "acos": lambda v: 90 - asin(v),
    "root": root, "log10": lambda v: number(v).log10(), "pi": lambda: exact.PI, "min": min, "max": max,
    "area": area, "centroid": centroid, "mixed_centroid": mixed_centroid, "critical": critical, "limit_angle": limit_angle,
    "onset_angle": onset_angle,
    "between": Enclosure,
}
OPERATORS = {
    ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: Fraction(a) / b if isinstance(a, EXACT) else a / b,
    ast.Pow: lambda a, b: a ** b,
}


class Formula:
    """One formula of a case; names are those of the case."""

    def __init__(self, text):
        self.text = text.strip()
        self.tree = ast.parse(self.text, mode="eval").body

    def value(self, names):
        return self.of(self.tree, names)

    def of(self, node, names):
        if isinstance(node, ast.Constant):
            if isinstance(node.value, (str, bool, type(None))):
                return node.value
            return Fraction(ast.get_source_segment(self.text, node))
        if isinstance(node, ast.Name):
            return names[node.id]
        if isinstance(node, (ast.List, ast.Tuple)):
            return [self.of(item, names) for item in node.elts]
        if isinstance(node, ast.Subscript):
            return self.of(node.value, names)[int(self.of(node.slice, names))]
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -self.of(node.operand, names)
        if isinstance(node, ast.Call):
            return FUNCTIONS[node.func.id](*(self.of(a, names) for a in node.args))
        if isinstance(node, ast.BinOp):
            return self.operate(node, self.of(node.left, names), self.of(node.right, names))
        raise ValueError(f"no part of a formula: {ast.dump(node)}")

    @staticmethod
    def operate(node, a, b):
        if isinstance(node.op, ast.Pow) and Fraction(b).denominator == 1:
            return a ** int(b)
        if isinstance(a, Decimal) != isinstance(b, Decimal):
            a, b = number(a), number(b)
        return OPERATORS[type(node.op)](a, b)


def read(text, names=None):
    return Formula(text).value(names or {})


def rounding():
    """What the decimals of a formula may have lost of their last digits, relative."""
    return Decimal(10) ** (20 - getcontext().prec)
