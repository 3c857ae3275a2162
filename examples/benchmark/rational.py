# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Rational sines, cosines and tangents of angles in degrees."""

from fractions import Fraction


def pi(digits=40):
    """By Machin's formula, a rational within 10^-digits."""
    def arctangent(n):
        total, term, k, least = Fraction(0), Fraction(1, n), 1, Fraction(1, 10**(digits + 3))
        while term > least:
            total += term / k if k % 4 == 1 else -term / k
            term /= n * n
            k += 2
        return total
    return 4 * (4 * arctangent(5) - arctangent(239))


PI = pi()


def trigonometry(degrees):
    """Sine and cosine of an angle in degrees within 1e-30, by Taylor's series."""
    angle = Fraction(degrees) * PI / 180
    angle = Fraction(round(angle * 10**40), 10**40)
    sine, cosine, term, k = Fraction(0), Fraction(0), Fraction(1), 0
    while abs(term) > Fraction(1, 10**35):
        sine, cosine = ((sine, cosine + term), (sine + term, cosine), (sine, cosine - term), (sine - term, cosine))[k % 4]
        k += 1
        term = Fraction(round(term * angle / k * 10**40), 10**40)
    return sine, cosine


def rational_tilt(degrees):
    """Exact sine and cosine of a tilt within 1e-18 degrees of this one."""
    sine, cosine = trigonometry(Fraction(degrees))
    t = Fraction(round(sine / (1 + cosine) * 10**20), 10**20)
    return 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)


def frictions(degrees):
    """Rationals just below and just above the tangent of the friction angle."""
    sine, cosine = trigonometry(Fraction(degrees))
    middle = Fraction(round(sine / cosine * 10**20), 10**20)
    return middle - Fraction(1, 10**19), middle + Fraction(1, 10**19)
