# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which rounding of its toe explains the tilt alpha at which a block went over in the laboratory?
For their blocks A, B and E towards the peak Alejano et al. answer it by a formula: with tan i = c/a
the axis of toppling lies r up-dip of the sharp corner, and r belongs to a radius r_c,

    r = (27 a b + 14 a c - (9 b^2 - 3 c^2) tan alpha)
          / ((18 b + 9 c) (cos i + sin i tan alpha))                         (A2.4)
    r_c = r tan(45 deg + i / 2)                                              (A2.5)

`find` knows no formula: it varies the radius in the scene until the block topples at alpha, and
proves that it does, within the bound."""

import sys
from math import atan, cos, pi, radians, sin, tan

import topple

TESTS = [("A", 15, 94, 5, 23.5, 3.36), ("B", 14, 135, 5, 15, 4.49), ("E", 30, 120, 5, 37.4, 0.13)]


def radius_of(a, b, c, angle_deg):
    """The formula, in mm."""
    i, tangent = atan(c / a), tan(radians(angle_deg))
    moments = 27 * a * b + 14 * a * c - (9 * b**2 - 3 * c**2) * tangent
    return moments / ((18 * b + 9 * c) * (cos(i) + sin(i) * tangent)) * tan(pi / 4 + i / 2)


agree = True
print("block  went over   r_c found    formula      bound    Table 4, mm")
for block, a, b, c, angle_deg, table_4 in TESTS:
    scene = topple.Scene("mm", teeth=(3, a, b, c, "peak"), tilt_towards="left",
                         rounded_ends=[("left_end", 1)], rounding_keeps_mass=True)
    found = topple.find(scene, "block.rounded.corners.1.radius", "critical_angle", angle_deg)
    (radius,) = found.solutions
    formula = radius_of(a, b, c, angle_deg)
    bound = radius.error + 1e-12  # and of doubles in the formula
    print(f"{block}      {angle_deg:4.1f} deg    {radius:.8f}   {formula:.8f}   {bound:.1e}  "
          f"{table_4:.2f}")
    agree &= abs(radius.value - formula) <= bound
print("The formulas agree." if agree else "The formulas do NOT agree.")
sys.exit(not agree)
