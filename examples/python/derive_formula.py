# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A formula derived, and evaluated where it was not derived. The scene is block E of Alejano et al.
towards its valley, with a, b and c as parameters; what comes out about its toe,

    tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2),                (A1.8)

holds for other values, too: it is called with arrays of them, and the blocks that have them are
solved in numbers."""

import sys

import numpy as np

import topple

scene = topple.Scene.from_text("""
    topple: 1
    length_unit: mm
    parameters: {a: 30, b: 120, c: 5}
    block: {teeth: {count: 3, width: a, height: b, depth: c, left_end: valley}}
    tilt: {towards: left}""")
tangent = topple.derive(scene).governing("left").tan_critical_angle
print("tan alpha =", tangent)

a, b, c = np.array([[30, 120, 5], [15, 94, 5], [15, 144, 5], [7.5, 20, 0.125]]).T
formula = np.degrees(np.arctan(tangent(a=a, b=b, c=c)))
printed = np.degrees(np.arctan((27 * a * b + 13 * a * c) / (9 * b**2 + 18 * b * c + 6 * c**2)))
agree = str(tangent) == "(27*a*b + 13*a*c)/(9*b^2 + 18*b*c + 6*c^2)"
print("    a     b     c    formula       solved        bound")
for k, block in enumerate(zip(a, b, c)):
    solution = topple.Scene("mm", teeth=(3, *block, "valley"), tilt_towards="left").solve()
    angle = solution.case("left").governing_pivot.critical_angle_deg
    bound = angle.error + 1e-14 * angle.value  # and what doubles round the formulas by
    print("{:5g} {:5g} {:5g}".format(*block), f"  {formula[k]:.8f}   {angle:.8f}   {bound:.1e}")
    agree &= max(abs(angle.value - formula[k]), abs(angle.value - printed[k])) <= bound
print("The formula agrees." if agree else "The formula does NOT agree.")
sys.exit(not agree)
