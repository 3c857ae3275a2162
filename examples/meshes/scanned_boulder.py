# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes scanned_boulder.obj: a boulder on a slope as a scanner gives it, two objects in metres on a map grid.

No scan of a real site: a sphere of triangles, drawn out to the half-axes of a boulder and roughened by waves of falling
height, over a grid of ground that dips by 12 degrees towards the south-east, with waves of its own. Coordinates are
written to the millimetre, as such files are. `python3 scanned_boulder.py` writes the file anew, to the byte."""

import math
import pathlib
import random

HALF_AXES = (1.1, 0.8, 0.7)
CENTRE = (412.3, 187.6, 52.18)
DIP, DIP_AZIMUTH = math.radians(12), math.radians(135)


def sphere(level):
    """An octahedron whose triangles are halved `level` times, and thrown onto the unit sphere."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(level):
        middles, halved = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                sums = [p + q for p, q in zip(points[a], points[b])]
                size = math.sqrt(sum(c * c for c in sums))
                middles[key] = len(points)
                points.append(tuple(c / size for c in sums))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            halved += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = halved
    return points, faces


def waves(seed, count, longest):
    """Sums of plane waves, each half as long and a good half as high as the one before."""
    chance = random.Random(seed)
    terms = []
    for k in range(count):
        turn, phase = chance.uniform(0, 2 * math.pi), chance.uniform(0, 2 * math.pi)
        lift = chance.uniform(-1, 1)
        step = 2 * math.pi / (longest / 1.7 ** k)
        terms.append((step * math.cos(turn), step * math.sin(turn), step * lift, phase, 0.55 ** k))
    return lambda x, y, z=0.0: sum(h * math.sin(a * x + b * y + c * z + p) for a, b, c, p, h in terms)


def ground_height(x, y, rough):
    along = (x - CENTRE[0]) * math.sin(DIP_AZIMUTH) + (y - CENTRE[1]) * math.cos(DIP_AZIMUTH)
    return 51.4 - math.tan(DIP) * along + 0.03 * rough(x, y)


def main():
    lines = ["# A boulder on a slope: made by scanned_boulder.py, no scan of a real site", "o boulder"]
    points, faces = sphere(4)
    rough = waves(3, 8, 1.5)
    for p in points:
        swell = 1 + 0.06 * rough(*p)
        lines.append("v " + " ".join(f"{c + a * q * swell:.3f}" for c, a, q in zip(CENTRE, HALF_AXES, p)))
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in faces]
    first, count, step = len(points) + 1, 25, 0.2
    lines.append("o ground")
    rough = waves(8, 8, 2.0)
    for j in range(count):
        for i in range(count):
            x, y = CENTRE[0] + (i - count // 2) * step, CENTRE[1] + (j - count // 2) * step
            lines.append(f"v {x:.3f} {y:.3f} {ground_height(x, y, rough):.3f}")
    for j in range(count - 1):
        for i in range(count - 1):
            a = first + j * count + i
            lines += [f"f {a} {a + 1} {a + count + 1}", f"f {a} {a + count + 1} {a + count}"]
    pathlib.Path(__file__).with_name("scanned_boulder.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
