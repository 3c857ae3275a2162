# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Housner's block under pulses, for tests of what shaking overturns: a slab as a scene, and the equation of its rocking integrated
here, which shares no code with Topple."""

import math

GRAVITY = 9.80665
HALF_WIDTH, HALF_HEIGHT = 0.5, 2
SLAB = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 4}, unit_weight_kn_m3: 25}\n" \
       "base: {profile: [[-20, 0], [20, 0]]}\nfriction_angle_deg: 70\ntilt: {towards: left}\n"
PULSE = "shaking: {{horizontal: {{{form}: {{peak_g: 0.5, frequency_hz: {f}}}}}}}\n"


def overturns(peak_g, frequency, periods):
    """theta'' = p^2 (-sin(alpha s - theta) + a cos(alpha s - theta)), s the side that it rocks to, p^2 = 3 g / 4 R; at each
    impact the speed falls to 1 - 3/2 sin^2 alpha of it (Housner 1963). By Runge and Kutta, impacts by secants."""
    alpha, p2 = math.atan2(HALF_WIDTH, HALF_HEIGHT), 3 * GRAVITY / (4 * math.hypot(HALF_WIDTH, HALF_HEIGHT))
    kept, ends = 1 - 1.5 * math.sin(alpha) ** 2, periods / frequency

    def rate(t, theta, side):
        shakes = peak_g * math.sin(2 * math.pi * frequency * t) if t <= ends else 0
        return p2 * (-math.sin(alpha * side - theta) + shakes * math.cos(alpha * side - theta))

    def step(t, theta, speed, side, h):
        k1, l1 = speed, rate(t, theta, side)
        k2, l2 = speed + h / 2 * l1, rate(t + h / 2, theta + h / 2 * k1, side)
        k3, l3 = speed + h / 2 * l2, rate(t + h / 2, theta + h / 2 * k2, side)
        k4, l4 = speed + h * l3, rate(t + h, theta + h * k3, side)
        return theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), speed + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)

    if peak_g <= math.tan(alpha):
        return False
    t, theta, speed, side = math.asin(math.tan(alpha) / peak_g) / (2 * math.pi * frequency), 0, 0, 1
    while t < ends + 12:
        h = 0.0005 if t >= ends else min(0.0005, ends - t + 1e-12)
        after, own = step(t, theta, speed, side, h)
        if abs(after) >= math.pi / 2:
            return True
        if after * side < 0:  # it comes back: shorten the step until it just does
            low, high = 0, h
            for _ in range(40):
                middle = (low + high) / 2
                low, high = (middle, high) if step(t, theta, speed, side, middle)[0] * side >= 0 else (low, middle)
            own = step(t, theta, speed, side, high)[1]
            t, theta, speed, side = t + high, 0, kept * own, -side
            if t > ends and abs(speed) < 1e-3:
                return False
            continue
        t, theta, speed = t + h, after, own
    return False
