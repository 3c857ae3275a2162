# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""As many digits as are asked for, all of them certain. A slab of width x and height y topples at

    alpha = arctan(x / y)                                                    Eq. (3)

and Euler found arctan(1/2) + arctan(1/3) = 45 degrees: so the decimals of two slabs, twice and
three times as high as wide, must add up to 45, but for the last ones, where each is rounded."""

import sys
from fractions import Fraction

import topple


def solved(height, digits):
    """A slab of width 1 and this height: how it was solved, and the digits of its angle."""
    solution = topple.Scene("m", slab=(1, height)).solve(digits=digits)
    return solution, solution.case("left").governing_pivot.critical_angle_deg.digits


holds = True
for digits in (20, 70, 245, 857):
    (solution, one), (_, other) = solved(2, digits), solved(3, digits)
    unit = Fraction(1, 10 ** len(one.partition(".")[2]))  # of the last decimal
    rest = (45 - Fraction(one) - Fraction(other)) / unit
    print(f"{digits} digits, by numbers of {solution.bits} bits\n  {one:.66}\n  {other:.66}\n"
          f"  45 less both: {rest} of the last decimal")
    holds &= abs(rest) <= 1
print("Euler's identity holds." if holds else "Euler's identity does NOT hold.")
sys.exit(not holds)
