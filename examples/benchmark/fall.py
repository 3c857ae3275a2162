# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The motion of a block that turns about a corner, by its equation in small steps, for confirm.py."""

import math
from fractions import Fraction

import exact

GRAVITY = Fraction("9.80665")
STEPS = 4000  # of Runge and Kutta: of 2000 the distance is the same to 1e-12 m


def root(square):
    """The root of a rational square."""
    found = Fraction(math.isqrt(square.numerator), math.isqrt(square.denominator))
    if found**2 != square:
        raise ValueError("no slope of rational sine and cosine")
    return found


def turned_by(ring, corner, along, time, friction):
    """How far the centroid is from where it was after a time, when the block turns about a corner; not a number where it slips
    on the rock, leaves it or meets it elsewhere before."""
    _, centroid, gyration = exact.moments(ring)
    x, y = (float(v) for v in exact.minus(centroid, corner))
    inertia, gravity, length = float(gyration) + x * x + y * y, float(GRAVITY), math.hypot(*map(float, along))
    tx, ty = (float(v) / length for v in along)
    h = float(time) / STEPS

    def rates(angle, speed):
        """The arm turns by the angle; the weight turns it on."""
        arm = x * math.cos(angle) - y * math.sin(angle)
        return speed, -gravity * arm / inertia
    angle = speed = 0.0
    for _ in range(STEPS):
        a1, s1 = rates(angle, speed)
        a2, s2 = rates(angle + h / 2 * a1, speed + h / 2 * s1)
        a3, s3 = rates(angle + h / 2 * a2, speed + h / 2 * s2)
        a4, s4 = rates(angle + h * a3, speed + h * s3)
        angle, speed = angle + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), speed + h / 6 * (s1 + 2 * s2 + 2 * s3 + s4)
        c, s = math.cos(angle), math.sin(angle)
        arm_x, arm_y, turn = c * x - s * y, s * x + c * y, rates(angle, speed)[1]
        force_x, force_y = -turn * arm_y - speed * speed * arm_x, turn * arm_x - speed * speed * arm_y + gravity
        pressure = tx * force_y - ty * force_x
        if not abs(tx * force_x + ty * force_y) <= friction * pressure:
            return math.nan
    for p in ring:
        px, py = (float(v) for v in exact.minus(p, corner))
        if p != corner and not tx * (s * px + c * py) - ty * (c * px - s * py) > 0:
            return math.nan
    return 2 * math.hypot(x, y) * math.sin(abs(angle) / 2)
