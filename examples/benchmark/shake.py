# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A rectangle on a level rock that is shaken by a whole sine, by Housner's equation of rocking in small steps, for confirm.py.

It rocks about its corners without slipping or leaving the rock, and an impact keeps the moment of momentum about the corner that
strikes. Angles are those from where it lies, times in seconds."""

import math


GRAVITY = 9.80665
STEP = 1e-3  # of Runge and Kutta: with half of it the edges move by less than 1e-9 g
LONGEST = 60.0
AT_REST = 1e-6  # radians a second
LIKELY = 0.8  # radians, beyond which a corner that slips or leaves the rock changes nothing


class Rectangle:
    def __init__(self, ring, friction):
        (x0, y0), (x1, y1) = min(ring), max(ring)
        width, height = float(x1 - x0), float(y1 - y0)
        if sorted(ring) != sorted([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]):
            raise ValueError("this is for rectangles that lie level")
        self.slenderness, self.radius = math.atan2(width, height), math.hypot(width, height) / 2
        self.square = 3 * GRAVITY / (4 * self.radius)  # of the frequency parameter p
        self.lift = math.tan(self.slenderness)  # of the acceleration over gravity, at which it begins to rock
        self.kept = 1 - 1.5 * math.sin(self.slenderness) ** 2  # of the speed, by an impact
        self.friction = friction

    def turn(self, angle, side, ground):
        """The acceleration of the angle, of the block on one side of where it lies, on ground that is accelerated."""
        arm = side * self.slenderness - angle
        return -self.square * (math.sin(arm) + ground / GRAVITY * math.cos(arm))

    def sticks(self, angle, speed, side, ground):
        """Does the corner press, within its friction?"""
        arm, turn = self.slenderness - side * angle, side * self.turn(angle, side, ground)
        along = self.radius * (math.cos(arm) * turn + math.sin(arm) * speed**2) + side * ground
        press = self.radius * (math.sin(arm) * turn - math.cos(arm) * speed**2) + GRAVITY
        return abs(along) <= self.friction * press

    def stepped(self, angle, speed, side, now, step, ground):
        turn = self.turn
        s1 = turn(angle, side, ground(now))
        s2 = turn(angle + step / 2 * speed, side, ground(now + step / 2))
        s3 = turn(angle + step / 2 * (speed + step / 2 * s1), side, ground(now + step / 2))
        s4 = turn(angle + step * (speed + step / 2 * s2), side, ground(now + step))
        return angle + step * (speed + step / 6 * (s1 + s2 + s3)), speed + step / 6 * (s1 + 2 * s2 + 2 * s3 + s4)


def overturns(ring, friction, peak_g, frequency_hz):
    """Whether it overturns; an error where it slips or leaves the rock."""
    block, end = Rectangle(ring, friction), 1 / frequency_hz

    def ground(now):
        return peak_g * GRAVITY * math.sin(2 * math.pi * frequency_hz * now) if 0 <= now <= end else 0.0
    if peak_g <= block.lift:
        return False
    # it lifts where the ground first accelerates by more than g tan(slenderness)
    now, angle, speed = math.asin(block.lift / peak_g) / (2 * math.pi * frequency_hz), 0.0, 0.0
    side = -1.0
    while now < LONGEST:
        step = min(STEP, end - now) if now < end else STEP
        after = block.stepped(angle, speed, side, now, step, ground)
        if side * after[0] < 0:
            low, high = 0.0, step
            for _ in range(50):
                middle = (low + high) / 2
                low, high = (middle, high) if side * block.stepped(angle, speed, side, now, middle, ground)[0] >= 0 else (low, middle)
            _, speed = block.stepped(angle, speed, side, now, low, ground)
            now, angle, speed, side = now + low, 0.0, speed * block.kept, -side
            if now >= end and speed**2 / (2 * block.square) + math.cos(block.slenderness) < 1:
                return False
            if abs(speed) < AT_REST:
                raise ValueError("it lies still while the ground moves")
            continue
        (angle, speed), now = after, now + step
        if abs(angle) >= math.pi / 2 or (now >= end and abs(angle) > block.slenderness and angle * speed > 0):
            return True
        if abs(angle) < LIKELY and not block.sticks(angle, speed, side, ground(now)):
            raise ValueError("it slips, or leaves the rock")
        energy = speed**2 / (2 * block.square) + math.cos(block.slenderness - abs(angle))
        if now >= end and energy < 1:  # not enough to pass its unstable balance
            return abs(angle) > block.slenderness
    raise ValueError(f"it still rocks after {LONGEST:g} s")
