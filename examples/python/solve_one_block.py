# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""One block in an array, solved. It is block E of Alejano et al., three teeth of width a = 30,
height b = 120 and depth c = 5 mm; its left end is a valley, its right end a peak. Moments of its
weight let it topple at the angle alpha, and at a lesser tilt give it a factor of safety:

    towards the valley   tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2)    (A1.8)
    towards the peak     tan alpha = (27 a b + 14 a c) / (9 b^2 - 3 c^2)             (A1.4)
    both                 FoS = tan alpha / tan tilt                                  Eq. (2)

What contact forces can hold up to, the limit, may be less: see docs/limit.md."""

import math
import sys

import numpy as np

import topple

a, b, c, tilt = 30.0, 120.0, 5.0, 20.0
outline = np.array([[0, 0], [a, c], [2 * a, 0], [3 * a, c], [3 * a, b + c], [0, b + c]])
tangents = {"valley": (27 * a * b + 13 * a * c) / (9 * b**2 + 18 * b * c + 6 * c**2),
            "peak": (27 * a * b + 14 * a * c) / (9 * b**2 - 3 * c**2)}


def agrees(number, formula):
    """Is the truth where the formula, which doubles round by 1e-14 of it at most, says?"""
    return abs(number.value - formula) <= number.error + 1e-14 * formula


solution = topple.Scene("mm", outline=outline, friction_angle_deg=30, tilt_angle_deg=tilt).solve()
agree = True
print("towards   topples at   formula      bound    FoS      at 20 deg  by forces at")
for case, (toe, tangent) in zip(solution.cases, tangents.items()):
    angle, fos = case.governing_pivot.critical_angle_deg, case.governing_pivot.fos.value
    formula = math.degrees(math.atan(tangent))
    print(f"{toe:8}  {angle:.7f}   {formula:.7f}   {angle.error:.1e}  {fos:.5f}  "
          f"{case.mechanism:9}  {case.limit.critical_angle_deg:.7f}")
    agree &= agrees(angle, formula) and agrees(fos, tangent / math.tan(math.radians(tilt)))
print("The formulas agree." if agree else "The formulas do NOT agree.")
sys.exit(not agree)
