# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Pictures of a page, read without a library: the dots of a PNG of 8 bits a channel."""

import collections
import struct
import zlib


def dots(png):
    """(width, height, Counter of (red, green, blue))."""
    place, data = 8, b""
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place:place + 8])
        body = png[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            data += body
        place += 12 + length
    assert depth == 8 and colour in (2, 6), (depth, colour)
    return width, height, counted(zlib.decompress(data), width, height, 3 if colour == 2 else 4)


def counted(raw, width, height, channels):
    found, above, row_length = collections.Counter(), bytearray(width * channels), width * channels
    for y in range(height):
        start = y * (row_length + 1)
        row = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + row_length]), above, channels)
        found.update(zip(row[0::channels], row[1::channels], row[2::channels]))
        above = row
    return found


def unfiltered(kind, row, above, step):
    """The five filters of PNG (section 9.2 of its specification)."""
    if kind == 2:
        return bytearray((a + b) & 255 for a, b in zip(row, above))
    if kind == 0:
        return row
    for i in range(len(row)):
        left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + above[i]) // 2
        else:
            sides = [(abs(left + above[i] - corner - side), order, side) for order, side in enumerate((left, above[i], corner))]
            guess = min(sides)[2]
        row[i] = (row[i] + guess) & 255
    return row
