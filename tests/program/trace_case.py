# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Pictures for the tests of `topple trace`: a block of known outline before sky and ground, with blur and noise, written
as PNG; and reading a PNG back. Python alone, no library of pictures."""

import math
import random
import struct
import zlib


def write_png(path, width, height, rows, kind=2):
    """Rows of bytes, three a pixel (kind 2), or one of grey (kind 0)."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(raw, 6)) + chunk(b"IEND", b""))


def read_png(path):
    """Width, height and rows of (r, g, b), of 8 bits a channel without interlace."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        if name == b"IHDR":
            width, height, bits, kind, _, _, interlace = struct.unpack(">IIBBBBB", data[at + 8:at + 21])
            assert (bits, interlace) == (8, 0) and kind in (2, 6)
        if name == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    step = 3 if kind == 2 else 4
    raw, stride, before, rows = zlib.decompress(packed), step * width, bytearray(step * width), []
    for y in range(height):
        method, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for k in range(stride):
            left, up = row[k - step] if k >= step else 0, before[k]
            corner = before[k - step] if k >= step else 0
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[k] = (row[k] + (0, left, up, (left + up) // 2, nearest)[method]) & 255
        before = row
        rows.append([tuple(row[k:k + 3]) for k in range(0, stride, step)])
    return width, height, rows


def ellipse(x, y, a, b, turn=0, sides=720):
    c, s = math.cos(turn), math.sin(turn)
    return [(x + c * a * math.cos(t) - s * b * math.sin(t), y + s * a * math.cos(t) + c * b * math.sin(t))
            for t in (2 * math.pi * k / sides for k in range(sides))]


def turned(points, angle, about):
    c, s = math.cos(angle), math.sin(angle)
    return [(about[0] + c * (x - about[0]) - s * (y - about[1]), about[1] + s * (x - about[0]) + c * (y - about[1]))
            for x, y in points]


def area(points):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1])) / 2


def perimeter(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:] + points[:1]))


def centroid(points):
    six = 6 * area(points)
    pairs = [(a, b, a[0] * b[1] - b[0] * a[1]) for a, b in zip(points, points[1:] + points[:1])]
    return sum((a[0] + b[0]) * c for a, b, c in pairs) / six, sum((a[1] + b[1]) * c for a, b, c in pairs) / six


def away(point, points):
    """From a point to the nearest edge of a polygon."""
    best = math.inf
    for a, b in zip(points, points[1:] + points[:1]):
        dx, dy = b[0] - a[0], b[1] - a[1]
        t = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / (dx * dx + dy * dy)
        t = min(1, max(0, t))
        best = min(best, math.dist(point, (a[0] + t * dx, a[1] + t * dy)))
    return best


def coverage(width, height, points, fine=4):
    """The share of each pixel that lies within the polygon: `fine` lines across it, along each of them exactly."""
    rows = []
    for y in range(height):
        row = [0.0] * width
        for k in range(fine):
            level = y + (k + 0.5) / fine
            cuts = sorted(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
                          for a, b in zip(points, points[1:] + points[:1]) if (a[1] <= level) != (b[1] <= level))
            for left, right in zip(cuts[::2], cuts[1::2]):
                for x in range(max(0, int(left)), min(width, int(right) + 1)):
                    row[x] += max(0.0, min(right, x + 1) - max(left, x)) / fine
        rows.append(row)
    return rows


def blurred(rows, deviation):
    if deviation == 0:
        return rows
    reach = int(3 * deviation + 1)
    weights = [math.exp(-0.5 * (k / deviation) ** 2) for k in range(-reach, reach + 1)]
    weights = [w / sum(weights) for w in weights]
    for _ in range(2):  # along rows, then along columns
        out = []
        for row in rows:
            wide = [row[0]] * reach + row + [row[-1]] * reach
            out.append([sum(w * wide[x + k] for k, w in enumerate(weights)) for x in range(len(row))])
        rows = [list(column) for column in zip(*out)]
    return rows


def paint(path, points, width=320, height=240, noise=8, blur=0.8, seed=1, rock=(150, 138, 124), grey=False):
    """The block before sky, and ground from seven tenths of the height down."""
    chance, rows = random.Random(seed), []
    for y, shares in enumerate(blurred(coverage(width, height, points), blur)):
        row = bytearray()
        for share in shares:
            behind = (88, 106, 62) if y > 0.7 * height else (168, 190, 216)
            lit = chance.gauss(0, noise)
            for inside, outside in zip(rock, behind):
                value = share * inside + (1 - share) * outside + lit + chance.gauss(0, noise / 2)
                row.append(min(255, max(0, round(value))))
                if grey:
                    break
        rows.append(row)
    write_png(path, width, height, rows, 0 if grey else 2)
