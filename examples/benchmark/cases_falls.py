# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The cases of the benchmark of blocks that are let go: they fall, slide or rock, and their motion has a closed form.

Asked is the time `moved_s` after which the centroid is `moved_m` away from where it was. With s that distance:

- it falls freely: s = g t^2 / 2;
- it slides down a plane at the slope i: s = (sin i - tan(friction) cos i) g t^2 / 2;
- it turns about a corner, with the centroid at the distance R from it and at the angle b from the vertical, and the moment of
  inertia J about it over the mass: (db/dt)^2 = 2 g R (cos b0 - cos b) / J and s = 2 R sin((b - b0) / 2). With b = b0 + u^2 the
  time is a smooth integral over u, here by Gauss and Legendre's rule."""

import math
from fractions import Fraction

import exact
from cases import case, decimal, level, ring

GRAVITY = 9.80665
NODES = 40  # of the rule: of 20 the last digits of a double are the same


def turned(outline, degrees):
    """About the first corner, to decimals."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    (x0, y0), *_ = outline
    return [(x0, y0)] + [(x0 + decimal(c * float(x - x0) - s * float(y - y0)), y0 + decimal(s * float(x - x0) + c * float(y - y0)))
                         for x, y in outline[1:]]


def slope(outline):
    """On a slope of 3 in 4, down to the left, of which every coordinate is a decimal."""
    return [(x * Fraction(4, 5) - y * Fraction(3, 5), x * Fraction(3, 5) + y * Fraction(4, 5)) for x, y in outline]


def rule(count):
    """Nodes and weights of Gauss and Legendre's rule on [-1, 1], by Newton's method."""
    for k in range(count):
        x = math.cos(math.pi * (k + 0.75) / (count + 0.5))
        for _ in range(20):
            before, now = 1.0, x
            for n in range(2, count + 1):
                before, now = now, ((2 * n - 1) * x * now - (n - 1) * before) / n
            rate = count * (x * now - before) / (x * x - 1)
            x -= now / rate
        yield x, 2 / ((1 - x * x) * rate * rate)


def turning_time(own):
    """Of a block that turns about its first corner."""
    area, (x, y), gyration = exact.moments(own["block"])
    x0, y0 = own["block"][0]
    arm_x, arm_y = float(x - x0), float(y - y0)
    radius = math.hypot(arm_x, arm_y)
    inertia = float(gyration) + radius * radius
    start = abs(math.atan2(arm_x, arm_y))
    last = math.sqrt(2 * math.asin(float(own["moved_m"]) / (2 * radius)))
    speed = math.sqrt(2 * GRAVITY * radius / inertia)
    # cos b0 - cos b = 2 sin(u^2 / 2) sin(b0 + u^2 / 2)
    whole = 0.0
    for node, weight in rule(NODES):
        u = last * (node + 1) / 2
        whole += weight * 2 * u / math.sqrt(2 * math.sin(u * u / 2) * math.sin(start + u * u / 2))
    return whole * last / 2 / speed


def moved_s(own):
    """The time of a case, to some 1e-13 of it."""
    along = {"falls": 1.0, "slides": 0.6 - 0.8 * math.tan(math.radians(float(own["friction_deg"])))}.get(own["motion"])
    return turning_time(own) if along is None else math.sqrt(2 * float(own["moved_m"]) / (along * GRAVITY))


def falls():
    """It falls, slides, topples on a slope and rocks; slowest is what is let go near its unstable balance."""
    slab, column, blade = (ring((0, 0), (w, 0), (w, h), (0, h)) for w, h in ((1, 2), ("0.5", 3), ("0.2", 4)))
    odd = ring((0, 0), ("0.9", "0.3"), ("1.1", "1.4"), ("0.2", "2.1"), ("-0.3", "0.8"))
    kite = ring((0, 0), (1, 0), ("1.3", "2.5"), ("0.1", "1.8"))
    plane = slope([(Fraction(-20), Fraction(0)), (Fraction(20), Fraction(0))])

    def above(outline, by):
        return level(outline), [(x, y + Fraction(by)) for x, y in outline]
    for title, outline, by, moved in (("A slab falls flat", slab, 1, "0.9"), ("A drawn block falls", odd, 30, "29")):
        rock, block = above(outline, by)
        yield case("falls", title, block, rock, 30, moved_m=moved, motion="falls")
    for title, friction, moved in (("A slab slides down a slope", 20, "3"), ("A slab that hardly slides", "36.8", "0.5")):
        yield case("falls", title, slope(ring((0, 0), (2, 0), (2, 1), (0, 1))), plane, friction, moved_m=moved, motion="slides")
    for title, outline, moved in (("A column topples on a slope", column, "0.5"),
                                  ("A slab that weighs on its toe by a hair", ring((0, 0), ("0.75", 0), ("0.75", "1.001"), (0, "1.001")), "0.1")):
        yield case("falls", title, slope(outline), plane, 70, moved_m=moved, motion="turns")
    for title, outline, degrees, moved in (("A slab rocks back", slab, 10, "0.1"), ("A leaning block rocks back", kite, 8, "0.05"),
                                           ("A blade rocks back", blade, 1, "0.02"), ("A slab near its unstable balance", slab, "26.5", "0.3")):
        block = turned(outline, float(degrees))
        yield case("falls", title, block, level(block), 70, moved_m=moved, motion="turns")


def let_go():
    for number, own in enumerate(falls(), 1):
        yield {"name": f"falls_{number:02}", "difficulty": number, **own}
