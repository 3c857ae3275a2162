# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What stands where in an SVG file by Cairo: boxes of its texts, outlines of its filled areas."""

import re
import xml.etree.ElementTree as ElementTree

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
STEPS = 8  # of a curve


def outlines(path):
    """The pieces of path data (M, L, C, Z) as lists of points, curves as chords."""
    pieces = []
    for letter, numbers in re.findall(r"([MLCZ])([^MLCZ]*)", path):
        values = [float(n) for n in numbers.split()]
        points = list(zip(values[::2], values[1::2]))
        if letter == "M":
            pieces.append(points)
        elif letter == "L":
            pieces[-1].extend(points)
        elif letter == "C":
            a, (b, c, d) = pieces[-1][-1], points
            for k in range(1, STEPS + 1):
                t = k / STEPS
                pieces[-1].append(tuple((1 - t) ** 3 * a[i] + 3 * (1 - t) ** 2 * t * b[i]
                                        + 3 * (1 - t) * t * t * c[i] + t ** 3 * d[i] for i in (0, 1)))
    return [piece for piece in pieces if len(piece) > 1]


def box(points):
    """x0, y0, x1, y1 around points."""
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


class Drawing:
    """The texts of a file as boxes around their ink, each a piece that was written at once, and its
    filled areas and its strokes by colour."""

    def __init__(self, text):
        root = ElementTree.fromstring(text)
        self.size = float(root.get("width")[:-2]), float(root.get("height")[:-2])
        self.glyphs = {}
        for symbol in root.iter(SVG + "symbol"):
            pieces = outlines(symbol.find(SVG + "path").get("d"))
            ink = [point for piece in pieces for point in piece]
            self.glyphs["#" + symbol.get("id")] = box(ink) if ink else None
        self.texts = [b for b in (self.text_box(g) for g in root.iter(SVG + "g")) if b]
        self.areas = self.paths(root, "fill")
        self.strokes = self.paths(root, "stroke")

    @staticmethod
    def paths(root, use):
        """Outlines of all paths that are filled, or stroked, by colour."""
        found = {}
        for path in root.iter(SVG + "path"):
            rgb = re.search(use + r":rgb\(([^)]*)\)", path.get("style", ""))
            if rgb:
                colour = tuple(round(float(c.strip().rstrip("%")) / 100, 3)
                               for c in rgb.group(1).split(","))
                found.setdefault(colour, []).append(outlines(path.get("d")))
        return found

    def text_box(self, group):
        """The box of a group that holds nothing but letters; None for another."""
        letters = group.findall(SVG + "use")
        ink = []
        for letter in letters:
            own = self.glyphs.get(letter.get(LINK))
            if own:
                x, y = float(letter.get("x")), float(letter.get("y"))
                ink += [(own[0] + x, own[1] + y), (own[2] + x, own[3] + y)]
        return box(ink) if ink else None


def overlap(a, b):
    """Do two boxes share an area?"""
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def side_enters(p, q, b):
    """Does the segment from p to q enter the box?"""
    begin, end = 0.0, 1.0
    for step, room in ((p[0] - q[0], p[0] - b[0]), (q[0] - p[0], b[2] - p[0]),
                       (p[1] - q[1], p[1] - b[1]), (q[1] - p[1], b[3] - p[1])):
        if step == 0:
            if room < 0:
                return False
        elif step < 0:
            begin = max(begin, room / step)
        else:
            end = min(end, room / step)
    return begin < end


def covers(area, b):
    """Does an area of one or more pieces (even-odd) share anything with a box?"""
    x, y = (b[0] + b[2]) / 2, (b[1] + b[3]) / 2
    inside = False
    for piece in area:
        for p, q in zip(piece, piece[1:] + piece[:1]):
            if side_enters(p, q, b):
                return True
            if (p[1] > y) != (q[1] > y) and p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) > x:
                inside = not inside
    return inside
