# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Profiles for tests, and their roughness by routes that share no code with Topple: rationals and decimals of 50
digits for what has a bound, plain sums of cosines for spectra, an exact fractional Brownian motion for exponents."""

import cmath
import decimal
import json
import math
import pathlib
import random
import tempfile
import unittest
from fractions import Fraction

from harness import ROOT, run

BOUNDED = ("length", "length_along", "amplitude", "rms_height", "mean_slope", "mean_absolute_slope", "z2", "rp")
JOINT = ROOT / "examples" / "joint_profile.csv"

decimal.getcontext().prec = 50


def root(value):
    """The square root of a rational, to 50 digits."""
    return (decimal.Decimal(value.numerator) / decimal.Decimal(value.denominator)).sqrt()


def as_decimal(value):
    if isinstance(value, Fraction):
        return decimal.Decimal(value.numerator) / decimal.Decimal(value.denominator)
    return decimal.Decimal(value)


def exactly(points):
    """Points of decimal texts or whole numbers as rationals."""
    return [(Fraction(x), Fraction(y)) for x, y in points]


def facets(points):
    """(dx, dy) from point to point."""
    return [(q[0] - p[0], q[1] - p[1]) for p, q in zip(points, points[1:])]


def detrended(points):
    """Less the line of least squares through the whole chain, by the normal equations of its pieces: integrals of 1, x,
    x^2, y and x y over each, by Simpson's rule, which is exact for what is at most quadratic."""
    moments = [Fraction(0)] * 5
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        xm, ym = (x0 + x1) / 2, (y0 + y1) / 2
        for k, f in enumerate((lambda x, y: 1, lambda x, y: x, lambda x, y: x * x, lambda x, y: y, lambda x, y: x * y)):
            moments[k] += (x1 - x0) * (f(x0, y0) + 4 * f(xm, ym) + f(x1, y1)) / 6
    one, x, xx, y, xy = moments
    slope = (xy * one - x * y) / (xx * one - x * x)
    level = (y - slope * x) / one
    return [(px, py - level - slope * px) for px, py in points], slope


def resampled(points, step):
    """On the straight pieces, from the first point on as far as whole steps go."""
    step, out, k = Fraction(step), [], 0
    origin = points[0][0]
    for j in range(int((points[-1][0] - origin) / step) + 1):
        x = origin + j * step
        while k + 2 < len(points) and points[k + 1][0] <= x:
            k += 1
        (x0, y0), (x1, y1) = points[k], points[k + 1]
        out.append((x, y0 + (x - x0) * (y1 - y0) / (x1 - x0)))
    return out


def measures(points):
    """What has a bound, exactly or to 50 digits."""
    own = facets(points)
    length = points[-1][0] - points[0][0]
    along = sum(root(dx * dx + dy * dy) for dx, dy in own)
    mean = sum((q[0] - p[0]) * (p[1] + q[1]) / 2 for p, q in zip(points, points[1:])) / length
    square = Fraction(0)
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        a, b = y0 - mean, y1 - mean
        square += (x1 - x0) * (a * a + a * b + b * b) / 3
    heights = [y for _, y in points]
    return {"length": length, "length_along": along, "amplitude": max(heights) - min(heights),
            "rms_height": root(square / length), "mean_slope": (points[-1][1] - points[0][1]) / length,
            "mean_absolute_slope": sum(abs(dy) for _, dy in own) / length,
            "z2": root(sum(dy * dy / dx for dx, dy in own) / length), "rp": along / as_decimal(length),
            "sf": sum(dy * dy * dx for dx, dy in own) / length}


def fractional(seed, count, hurst):
    """Heights of an exact fractional Brownian motion, by circulant embedding of its increments (Davies and Harte
    1987): 2 * count - 2 a power of two."""
    draw = random.Random(seed)
    size = 2 * (count - 1)
    row = [(abs(k + 1) ** (2 * hurst) - 2 * abs(k) ** (2 * hurst) + abs(k - 1) ** (2 * hurst)) / 2
           for k in (min(k, size - k) for k in range(size))]
    weights = [value.real for value in fourier(row)]
    noise = [complex(draw.gauss(0, 1), draw.gauss(0, 1)) * math.sqrt(max(w, 0) / size) for w in weights]
    steps = [value.real for value in fourier(noise)][:count - 1]
    heights = [0.0]
    for own in steps:
        heights.append(heights[-1] + own)
    return heights


def fourier(values):
    """The discrete transform of a power of two of values, by halves."""
    if len(values) == 1:
        return list(values)
    even, odd = fourier(values[::2]), fourier(values[1::2])
    turned = [cmath.exp(-2j * cmath.pi * k / len(values)) * odd[k] for k in range(len(odd))]
    return [e + t for e, t in zip(even, turned)] + [e - t for e, t in zip(even, turned)]


def text_of(points):
    return "".join(f"{x},{y}\n" for x, y in points)


def joint():
    lines = [line.split(",") for line in JOINT.read_text(encoding="utf-8").splitlines() if line[0].isdigit()]
    return exactly(lines)


def uneven(seed, count):
    """Decimal texts of points at uneven distances, far from the origin."""
    draw, points = random.Random(seed), []
    x = Fraction(draw.randint(-10**6, 10**6), 1000)
    for _ in range(count):
        points.append((x, Fraction(draw.randint(-5000, 5000), 1000)))
        x += Fraction(draw.randint(1, 3000), 1000)
    return points


def decimals(points):
    return "".join(f"{float(x):.3f},{float(y):.3f}\n" for x, y in points)


class ProfileCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, points, name="profile.csv"):
        path = self.folder / name
        path.write_text(points if isinstance(points, str) else text_of(points), encoding="utf-8")
        return path

    def profile(self, points, *options):
        """The JSON of points, of a text, or of a file."""
        path = points if isinstance(points, pathlib.Path) else self.write(points)
        status, out, err = run("profile", "--json", *options, path)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)

    def refused(self, points, says, *options):
        path = points if isinstance(points, pathlib.Path) else self.write(points)
        status, out, err = run("profile", *options, path)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(says, err)

    def bounded(self, number, truth, digits=12):
        """The truth lies within the bound, and the bound is worth so many digits of the number, or of 1 where it is
        0."""
        away = abs(decimal.Decimal(number["value"]) - as_decimal(truth))
        self.assertLessEqual(away, decimal.Decimal(number["error"]), (number, truth))
        self.assertLessEqual(number["error"], 10.0 ** -digits * (abs(number["value"]) or 1), number)

    def near(self, value, truth, tolerance):
        self.assertLessEqual(abs(value - truth), tolerance, (value, truth))
