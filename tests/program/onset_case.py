# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of the onset share: angles of tangents to 45 digits, and the onset of a contact by trial of modes."""

import random
from fractions import Fraction

import exact
from limit_oracle import contacts
from onset_oracle import Onset, gyration
from test_limit import mirrored

MOST_POINTS = 7


def degrees_of(tangent):
    return exact.degrees(exact.atan(exact.decimal(tangent)))


def onset_of(outline, profile, tangent, towards="left"):
    if towards == "right":
        outline, profile = mirrored(outline), mirrored(profile)
    points = contacts(outline, profile)
    if len(points) > MOST_POINTS or not points:
        return None
    centroid = exact.centroid(exact.block_moments(outline))
    return Onset(points, centroid, gyration(outline, centroid), tangent)


def rough_tangent():
    return random.choice([Fraction(0), Fraction(1), Fraction(random.randint(1, 30), 10),
                          Fraction(random.randint(1, 40), random.randint(1, 12))])
