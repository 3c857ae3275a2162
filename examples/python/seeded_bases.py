# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How much of the angle at which a block begins to move is chance? One block, set down on ten bases that
are equally rough: self-affine, of the same JRC, each by a seed of its own. JRC is put as the Z2
that it has by the regression of Tse and Cruden (1979),

    JRC = 32.2 + 32.47 log10 Z2,

so that every one of the bases must have, as it is measured, this root of the mean square slope,
but for the decimals that its heights are rounded to: a millionth of their RMS."""

import sys
import warnings

import topple

warnings.simplefilter("ignore", topple.Caution)  # of corners that all but touch
JRC, WANTED = 8, 10 ** ((8 - 32.2) / 32.47)
scene = topple.Scene("mm", outline=[(35, 20), (65, 20), (65, 60), (35, 60)], friction_angle_deg=35,
                     base_self_affine=(100, "0.5", "0.8", "jrc", JRC, 1), base_rest=True,
                     tilt_towards="left")
agree, angles = True, []
print("seed  turned by   moves from   first                Z2          wanted      bound")
for seed in range(1, 11):
    varied = scene.varied({"base.profile.self_affine.seed": seed})
    solution, z2 = varied.solve(), topple.profile_of_scene(varied).z2
    case = solution.case("left")
    angles.append(case.first_angle_deg.value)
    bound = z2.error + 1e-5 * WANTED
    print(f"{seed:3}   {solution.rest.turned_deg.value:7.3f}     {angles[-1]:7.3f}     "
          f" {str(case.first):20} {z2.value:.8f}  {WANTED:.8f}  {bound:.1e}")
    agree &= abs(z2.value - WANTED) <= bound
print(f"from {min(angles):.2f} to {max(angles):.2f} degrees")
print("The formulas agree." if agree else "The formulas do NOT agree.")
sys.exit(not agree)
