# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Makes painted_boulder.png: a picture of a boulder on a slope with a scale bar and a plumb line, to try `topple trace` on.

No photograph: a rough outline before sky and ground, with spots, blur and noise, held askew by 4 degrees as by hand.
`python3 painted_boulder.py` writes the file anew, to the byte; Python alone is needed."""

import math
import pathlib
import random
import struct
import zlib

WIDTH, HEIGHT, ASKEW = 480, 360, math.radians(4)


def outline():
    """Half-axes of 150 and 96 pixels, with bumps, cut off below as by a joint."""
    points = []
    for k in range(360):
        t = 2 * math.pi * k / 360
        r = 1 + 0.05 * math.sin(3 * t + 1) + 0.035 * math.sin(7 * t) + 0.015 * math.sin(17 * t + 2)
        points.append((240 + 150 * r * math.cos(t), min(190 + 96 * r * math.sin(t), 258 + 4 * math.sin(9 * t))))
    return points


def spots(chance, step):
    """Values at the corners of a grid, and between them."""
    columns, rows = WIDTH // step + 2, HEIGHT // step + 2
    grid = [[chance.gauss(0, 1) for _ in range(columns)] for _ in range(rows)]

    def at(x, y):
        i, j = int(x / step), int(y / step)
        u, v = x / step - i, y / step - j
        return ((1 - v) * ((1 - u) * grid[j][i] + u * grid[j][i + 1])
                + v * ((1 - u) * grid[j + 1][i] + u * grid[j + 1][i + 1]))
    return at


def shares(ring, row, fine=3):
    """Which share of each pixel of a row lies within the ring."""
    out = [0.0] * WIDTH
    for k in range(fine):
        level = row + (k + 0.5) / fine
        cuts = sorted(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                      for a, b in zip(ring, ring[1:] + ring[:1]) if (a[1] <= level) != (b[1] <= level))
        for left, right in zip(cuts[::2], cuts[1::2]):
            for x in range(max(0, int(left)), min(WIDTH, int(right) + 1)):
                out[x] += max(0.0, min(right, x + 1) - max(left, x)) / fine
    return out


def main():
    chance, c, s = random.Random(5), math.cos(ASKEW), math.sin(ASKEW)

    def turn(x, y):
        return 240 + c * (x - 240) - s * (y - 180), 180 + s * (x - 240) + c * (y - 180)

    ring = [turn(*p) for p in outline()]
    bar = [turn(*p) for p in ((40, 318), (200, 318), (200, 324), (40, 324))]
    line = [turn(*p) for p in ((438, 30), (440, 30), (440, 200), (438, 200))]
    coarse, middle, fine = spots(chance, 48), spots(chance, 16), spots(chance, 5)
    raw = b""
    for y in range(HEIGHT):
        row = bytearray(b"\0")
        parts = [shares(shape, y) for shape in (ring, bar, line)]
        for x, (rock, black, string) in enumerate(zip(*parts)):
            ground = -s * (x - 240) + c * (y - 180) - 0.05 * (x - 240) > 64
            grain = 6 * coarse(x, y) + 5 * middle(x, y) + 4 * fine(x, y)
            behind = [v + (grain if ground else 0.3 * grain) for v in ((98, 112, 70) if ground else (176, 196, 218))]
            inside = [v + grain - 0.06 * (y - 180) for v in (152, 142, 128)]
            noise = chance.gauss(0, 2)
            for a, b in zip(inside, behind):
                value = rock * a + (1 - rock) * b
                value = (1 - black) * value + black * 20
                value = (1 - string) * value + string * 60 + noise
                row.append(min(255, max(0, round(value / 2) * 2)))
        raw += row

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    head = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)
    pathlib.Path(__file__).with_name("painted_boulder.png").write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
