# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A million blocks in one array. Each has the form of block E of Alejano et al. with a width a, a
height b and a depth c of its teeth of its own; towards its valley it topples at

    tan alpha = (27 a b + 13 a c) / (9 b^2 + 18 b c + 6 c^2)                 (A1.8)

One call finds all angles, on every processor, each with its bound; the formula checks every one."""

import sys

import numpy as np

import topple

COUNT = 1_000_000


def spread(root, least, greatest):
    """Numbers that fill a range evenly: the fractions of the multiples of a root."""
    return least + (greatest - least) * np.modf(np.arange(COUNT) * np.sqrt(root))[0]


a, b, c, zero = spread(2, 10, 40), spread(3, 80, 250), spread(5, 1, 8), np.zeros(COUNT)
outlines = np.empty((COUNT, 6, 2))
outlines[..., 0] = np.transpose([zero, a, 2 * a, 3 * a, 3 * a, zero])
outlines[..., 1] = np.transpose([zero, c, zero, c, b + c, b + c])
formula = np.degrees(np.arctan((27 * a * b + 13 * a * c) / (9 * b**2 + 18 * b * c + 6 * c**2)))

found = topple.critical_angles(outlines, "left")
bound = found.error_deg + 1e-14 * formula  # and of doubles in the rest
agree = np.abs(found.angle_deg - formula) <= bound
print(f"{found.summary.done:7} blocks, {found.summary.climbed} of them by more than doubles")
for limit in range(10, 70, 10):
    print(f"{np.sum(found.angle_deg + found.error_deg < limit):7} topple below {limit} degrees")
print(f"{np.sum(agree):7} agree with the formula, within {np.max(bound):.1e} degrees")
sys.exit(not np.all(agree))
