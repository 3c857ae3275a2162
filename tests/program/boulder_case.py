# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A surveyed boulder above a road and the profile that it lies on, in metres."""

BOULDER = [(0.08, 0.18), (0.41, 0.29), (0.87, 0.5), (1.36, 0.85), (1.56, 1.13), (1.37, 1.71), (0.88, 2.24), (0.34, 2.42),
           (-0.24, 2.23), (-0.55, 1.74), (-0.5, 0.98), (-0.23, 0.33)]
BASE = [(-1.35, -0.66), (-0.18, -0.09), (0.31, 0.27), (0.39, 0.22), (1.07, 0.54), (1.28, 0.79), (1.41, 0.75), (2.14, 1.09),
        (3.54, 1.86)]
