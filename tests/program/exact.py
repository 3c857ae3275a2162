# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""An independent route to Topple's numbers: rationals of Python's fractions, functions of its
decimal at 60 digits or as many as asked. Written from the mechanics, sharing no code and no library with Topple."""

from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 60
GUARD = Decimal(10) ** -58


def set_digits(digits):
    """Compute with so many digits from here on."""
    global GUARD, PI
    getcontext().prec = digits
    GUARD = Decimal(10) ** (2 - digits)
    PI = 4 * atan(Decimal(1))


def decimal(value):
    value = Fraction(value)
    return Decimal(value.numerator) / Decimal(value.denominator)


def atan(x):
    """Arctangent by Euler's halving and the Taylor series."""
    x = Decimal(x)
    halvings = 0
    while abs(x) > Decimal("0.05"):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    term, total, k = x, x, 1
    while abs(term) > GUARD:
        term *= -x * x
        k += 2
        total += term / k
    return total * 2**halvings


PI = 4 * atan(Decimal(1))


def degrees(radians):
    return radians * 180 / PI


def sin_cos(angle_degrees):
    """Sine and cosine of an angle in degrees by Taylor's series."""
    x = decimal(angle_degrees) * PI / 180
    sine, cosine, term, k = Decimal(0), Decimal(0), Decimal(1), 0
    while abs(term) > GUARD:
        part = term if k % 4 < 2 else -term
        if k % 2:
            sine += part
        else:
            cosine += part
        k += 1
        term = term * x / k
    return sine, cosine


def atan2_degrees(y, x):
    """Angle of the vector (x, y) of rationals, in (-180, 180]."""
    y, x = Fraction(y), Fraction(x)
    if x == 0:
        return Decimal(90 if y > 0 else -90)
    angle = degrees(atan(decimal(y / x)))
    if x > 0:
        return angle
    return angle + 180 if y >= 0 else angle - 180


def ring_moments(ring):
    """Area, int x, int y, int x^2, int y^2, int x y over a ring, counter-clockwise or not, by fans
    of triangles from its first vertex."""
    sums = [Fraction(0)] * 6
    (x0, y0) = ring[0]
    for (x1, y1), (x2, y2) in zip(ring[1:], ring[2:]):
        twice = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        xs, ys = (x0, x1, x2), (y0, y1, y2)
        sx, sy = sum(xs), sum(ys)
        parts = (Fraction(twice, 2), twice * sx / 6, twice * sy / 6,
                 twice * (sx * sx + sum(x * x for x in xs)) / 24,
                 twice * (sy * sy + sum(y * y for y in ys)) / 24,
                 twice * (sx * sy + sum(x * y for x, y in zip(xs, ys))) / 24)
        sums = [a + b for a, b in zip(sums, parts)]
    return sums if sums[0] > 0 else [-s for s in sums]


def block_moments(outline, holes=(), parts=()):
    """Moments of outline less holes, weighted by density: parts are (ring, density / block's)."""
    sums = ring_moments(outline)
    for hole in holes:
        sums = [a - b for a, b in zip(sums, ring_moments(hole))]
    for ring, ratio in parts:
        sums = [a + (Fraction(ratio) - 1) * b for a, b in zip(sums, ring_moments(ring))]
    return sums


def centroid(moments):
    return moments[1] / moments[0], moments[2] / moments[0]


def critical_angle(moments, pivot, towards="left"):
    """atan2 of the lever arms of the weight about a pivot (docs/mechanics.md section 3)."""
    gx, gy = centroid(moments)
    arm = gx - pivot[0] if towards == "left" else pivot[0] - gx
    return atan2_degrees(arm, gy - pivot[1])


def factor_of_safety(moments, pivot, tilt, towards="left"):
    """Resultant form, Eq. (2)."""
    gx, gy = centroid(moments)
    arm = gx - pivot[0] if towards == "left" else pivot[0] - gx
    sine, cosine = sin_cos(tilt)
    return decimal(arm / (gy - pivot[1])) * cosine / sine


def teeth(count, a, b, c, left_end):
    """Outline of a toothed block."""
    low_first = left_end == "valley"
    under = [(Fraction(k) * a, Fraction(0) if (k % 2 == 0) == low_first else Fraction(c))
             for k in range(count + 1)]
    top = Fraction(b) + Fraction(c)
    return under + [(Fraction(count) * a, top), (Fraction(0), top)]
