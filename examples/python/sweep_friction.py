# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""One scene, solved for one friction angle phi after another: block E of Alejano et al. towards its
peak. It has to climb the flanks of its teeth to slide, and turns about its peak to topple; what
comes first as the table is tilted is found from contact forces, and must be the lesser of

    sliding    alpha = phi + i,  tan i = c / a                               Eqs. (6), (7)
    toppling   tan alpha = (27 a b + 14 a c) / (9 b^2 - 3 c^2)               (A1.4)
"""

import sys

import numpy as np

import topple

a, b, c = 30.0, 120.0, 5.0
friction = np.arange(0.0, 61.0, 4.0)
slides = friction + np.degrees(np.arctan2(c, a))
topples = np.degrees(np.arctan((27 * a * b + 14 * a * c) / (9 * b**2 - 3 * c**2)))
formula = np.minimum(slides, topples)

scene = topple.Scene("mm", teeth=(3, a, b, c, "peak"), tilt_towards="left")
first, angle, bound = [], np.empty_like(friction), np.empty_like(friction)
for k, phi in enumerate(friction):
    scene.set_friction_angle_deg(phi)
    case = scene.solve().case("left")
    first.append(str(case.first))
    angle[k] = case.first_angle_deg.value
    bound[k] = case.first_angle_deg.error + 1e-14 * formula[k]  # and of doubles in the formula

print(" phi   first     at degrees    formula       bound")
for row in zip(friction, first, angle, formula, bound):
    print("{:4.0f}   {:8}  {:.8f}   {:.8f}   {:.1e}".format(*row))
agree = np.all(np.abs(angle - formula) <= bound)
agree &= np.all(np.where(slides < topples, "slides", "topples") == first)
print("The formulas agree." if agree else "The formulas do NOT agree.")
sys.exit(not agree)
