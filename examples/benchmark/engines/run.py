# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Runs the benchmark by an engine of rigid bodies and writes its answers for score.py.

    python3 run.py RESULTS.csv CORNERS COMMAND...

CORNERS is the most that a convex piece of a block may have, COMMAND a driver of this folder, as built from its first lines; run_solids.py
takes those of solids. Each block lies as its coordinates say, on rock that is fixed, and is let go at a tilt; it moves where its
centroid, or that of any of many blocks, is displaced by more than FAR of the largest extent within STEPS steps of 1 ms. The tilt
is halved between level and upright down to a few thousandths of a degree. Of blocks that are let go the number of steps is halved
after which the centroid is `moved_m` away; of shaken ones the peak is scanned and halved. Lengths are scaled so that the largest extent is EXTENT of
the engine's units, gravity being that of a block of 1 m, and the first corner is put into the origin exactly, without which
single precision has nothing to work with far away."""

import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent))

import confirm  # noqa: E402
from cases_shaken import EDGES  # noqa: E402
import pieces  # noqa: E402
import score  # noqa: E402

EXTENT, FAR, STEP, STEPS, HALVINGS = 100, 0.002, 0.001, 2000, 16
MOST_STEPS = 20000  # of a block that is let go
ROCKS, LARGEST = 12, 3  # seconds after a shaking; shares of gravity
ASKED = ("moves_deg", "moved_s", "overturns_from_g")
GRAVITY = 9.80665 * EXTENT


def shapes(own):
    """Outlines of the blocks of a case, and the line of its rock; the ground of many blocks is closed."""
    if "base" in own:
        return [confirm.points(own["block"])], confirm.points(own["base"])
    outlines = confirm.outlines(own["blocks"])
    ground = outlines.pop("ground")
    return list(outlines.values()), ground[::-1] + ground[-1:]


class Engine:
    def __init__(self, corners, command):
        self.corners = corners
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def say(self, *words):
        print(*words, file=self.process.stdin, flush=True)

    def describe(self, own):
        """One case, with the pieces of its blocks in the engine's units: those of the largest block."""
        blocks, rock = shapes(own)
        origin = blocks[0][0]
        scale = self.scale = EXTENT / max(max(p[k] for p in ring) - min(p[k] for p in ring) for ring in blocks for k in (0, 1))

        def numbers(points):
            return [len(points), *(f"{float((v - o) * scale):.17g}" for p in points for v, o in zip(p, origin))]
        self.say("case")
        self.say("friction", math.tan(math.radians(float(own["friction_deg"]))))
        self.say("time", STEP, STEPS, FAR * EXTENT)
        self.say("rock", *numbers(rock))
        for ring in blocks:
            self.say("block")
            for piece in pieces.convex(ring, self.corners):
                self.say("piece", *numbers(piece))
        if any(load["type"] != "seismic" for load in own.get("loads", ())):
            block = confirm.Single({**own, "towards": "left"})
            for load in own["loads"]:
                at, force = block.pushed(load)
                self.say("load", *numbers([at])[1:], *(float(v / block.weight) * GRAVITY for v in force))

    def go(self, *gravity):
        self.say("go", *gravity)
        for line in self.process.stdout:  # engines may greet
            if line.strip() in ("0", "1"):
                return line.strip() == "1"
        raise RuntimeError("the engine has ended")

    def moves(self, own, tilt):
        k = sum(float(load["horizontal"]) for load in own.get("loads", ()) if load["type"] == "seismic")
        sine, cosine = math.sin(math.radians(tilt)), math.cos(math.radians(tilt))
        x, y = -sine - k * cosine, -cosine + k * sine
        return self.go(GRAVITY * (x if own["towards"] == "left" else -x), GRAVITY * y)


def first_motion(engine, own):
    """The tilt between one at which it stands and one at which it moves; 0 where it does not stand level."""
    engine.describe(own)
    return halved(lambda tilt: engine.moves(own, tilt))


def halved(moves):
    low, high = 0.0, 90.0
    if moves(low):
        return "0"
    if not moves(89.9):
        return "never"
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if moves(middle) else (middle, high)
    return f"{(low + high) / 2:.3f}"


def time_of_fall(engine, own):
    """The time by which it has moved so far; a second of the engine is that of a block of 1 m."""
    engine.describe(own)

    def has_moved(steps):
        engine.say("time", STEP, steps, float(own["moved_m"]) * engine.scale)
        return engine.go(0.0, -GRAVITY)
    low, high = 0, MOST_STEPS
    if not has_moved(high):
        return "never"
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if has_moved(middle) else (middle, high)
    return f"{high * STEP * math.sqrt(EXTENT / engine.scale):.4f}"


def edges_of_overturning(engine, own):
    """The peaks at which overturning begins, ends and begins again, of peaks 1 % apart, each halved; `never` up to LARGEST."""
    engine.describe(own)
    (ring,), _ = shapes(own)
    size = math.hypot(*(float(max(p[k] for p in ring) - min(p[k] for p in ring)) for k in (0, 1)))
    frequency, second = float(own["shaking"]["full_sine"]["frequency_hz"]), math.sqrt(EXTENT / engine.scale)
    engine.say("time", STEP, round((1 / frequency + ROCKS) / second / STEP), 0.45 * size * engine.scale)

    def overturns(peak):
        engine.say("shake", peak * GRAVITY, frequency * second)
        return engine.go(0.0, -GRAVITY)
    found, peak, now = [], 0.05, False
    while len(found) < len(EDGES) and peak < LARGEST:
        low, peak = peak, 1.01 * peak
        if overturns(peak) == now:
            continue
        high = peak
        for _ in range(8):
            middle = (low + high) / 2
            low, high = (middle, high) if overturns(middle) == now else (low, middle)
        found.append(f"{(low + high) / 2:.5f}")
        now = not now
    return found + ["never"] * (len(EDGES) - len(found))


def main(path, corners, command):
    manifest, answers = score.load()
    with open(path, "w", encoding="utf-8") as file:
        print("case,quantity,value", file=file)
        engine = None
        for name, own in manifest.items():
            quantity = next((asked for asked in ASKED if asked in answers[name]), None)
            if quantity is None:
                continue
            engine = engine or Engine(corners, command)
            try:
                if quantity == EDGES[0]:
                    values = dict(zip(EDGES, edges_of_overturning(engine, own)))
                else:
                    values = {quantity: (first_motion if quantity == "moves_deg" else time_of_fall)(engine, own)}
            except (RuntimeError, BrokenPipeError):
                values, engine = {quantity: ""}, None
            for asked, value in values.items():
                print(f"{name},{asked},{value}", file=file, flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        raise SystemExit(__doc__)
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3:])
