# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes rock_on_ground.obj: rough ground under balanced_rock.obj, in metres, of which stones reach up to the foot of the rock.

No scan of real ground: a grid of waves below the foot, in which stones are raised to some millimetres below the face of the rock
over them. Coordinates are written to the millimetre. `python3 rock_on_ground.py` writes the file anew, to the byte."""

import math
import pathlib

HERE = pathlib.Path(__file__)
STEP, REACH = 0.15, 1.2
STONES = [(-0.30, -0.15, 0.001), (0.30, -0.15, 0.001), (0.0, 0.15, 0.001), (-0.30, 0.15, 0.007), (0.30, 0.15, 0.012)]  # and how far below


def read(name):
    points, faces = [], []
    for line in HERE.with_name(name).read_text(encoding="ascii").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:])))
        elif words[:1] == ["f"]:
            faces.append([int(word) - 1 for word in words[1:]])
    return points, faces


def underside(rock, x, y):
    """The least height of the rock over a point."""
    points, faces = rock
    least = math.inf
    for face in faces:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (points[k] for k in face)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0:
            continue
        s = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
        t = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
        if s >= 0 and t >= 0 and s + t <= 1:
            least = min(least, az + s * (bz - az) + t * (cz - az))
    return least


def main():
    rock = read("balanced_rock.obj")
    count = round(2 * REACH / STEP) + 1
    lines = ["# Ground under balanced_rock.obj: made by rock_on_ground.py, no scan of real ground; GPL-3.0-or-later", "o ground"]
    for j in range(count):
        for i in range(count):
            x, y = (round(STEP * k - REACH, 3) for k in (i, j))
            z = -0.06 + 0.03 * math.sin(5 * x + 2 * y) + 0.02 * math.cos(7 * y - 3 * x)
            for *stone, gap in STONES:
                if math.dist(stone, (x, y)) < STEP / 2:
                    z = underside(rock, x, y) - gap
            lines.append(f"v {x:.3f} {y:.3f} {z:.3f}")
    for j in range(count - 1):
        for i in range(count - 1):
            a = j * count + i + 1
            lines += [f"f {a} {a + 1} {a + count + 1}", f"f {a} {a + count + 1} {a + count}"]
    HERE.with_name("rock_on_ground.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
