# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Runs the convex solids of the benchmark by an engine of rigid bodies, as run.py does the blocks.

    python3 run_solids.py RESULTS.csv COMMAND...

The centroid is put into the origin, the largest extent is EXTENT units. Solids that are not convex are left out."""

import math
import sys

import run


def moments_of(points, faces):
    """Centroid, in rational numbers."""
    first, volume = [run.confirm.Fraction(0)] * 3, run.confirm.Fraction(0)
    for a, b, c in ([points[k] for k in face] for face in faces):
        part = determinant(a, b, c)
        volume += part
        first = [f + part * (x + y + z) / 4 for f, x, y, z in zip(first, a, b, c)]
    return [f / volume for f in first]


def determinant(a, b, c):
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])


def is_convex(points, faces, extent):
    """But for 1e-5 of its extent, as corners were rounded to decimals."""
    for a, b, c in ([[float(v) for v in points[k]] for k in face] for face in faces):
        ab, ac = ([y - x for x, y in zip(a, p)] for p in (b, c))
        normal = [ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]]
        size = math.hypot(*normal)
        if any(sum(n * (float(v) - x) for n, v, x in zip(normal, p, a)) > 1e-5 * extent * size for p in points):
            return False
    return True


def main(path, command):
    manifest, _ = run.score.load()
    with open(path, "w", encoding="utf-8") as file:
        print("case,quantity,value", file=file)
        for name, own in manifest.items():
            if "solid" not in own:
                continue
            points, faces = run.confirm.solid_of(own["solid"])
            points = [[v - o for v, o in zip(p, points[0])] for p in points]
            extent = float(max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)))
            if not is_convex(points, faces, extent):
                continue
            centroid = moments_of(points, faces)
            engine = run.Engine(0, command)
            engine.say("case")
            engine.say("friction", math.tan(math.radians(float(own["friction_deg"]))))
            engine.say("time", 0.001, run.STEPS, run.FAR * run.EXTENT)
            engine.say("points", len(points), *(float(v - o) * run.EXTENT / extent for p in points for v, o in zip(p, centroid)))
            for azimuth, (east, north) in {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}.items():
                def moves(tilt):
                    sine, cosine = math.sin(math.radians(tilt)), math.cos(math.radians(tilt))
                    return engine.go(run.GRAVITY * sine * east, run.GRAVITY * sine * north, -run.GRAVITY * cosine)
                print(f"{name},moves_{azimuth}_deg,{run.halved(moves)}", file=file, flush=True)
            engine.process.stdin.close()


if __name__ == "__main__":
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    main(sys.argv[1], sys.argv[2:])
