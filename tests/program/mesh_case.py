# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the tests of meshes share: solids of known form, writers of every format, and the section by a second route.

The oracle joins no chains: of a closed surface whose faces all turn outwards, each face that is cut gives one vector
along the plane, and the sum of their moments is the area and its first moments. All of it in fractions."""

import json
import pathlib
import struct
import tempfile
import unittest
from fractions import Fraction

from harness import run


def octahedron(half=(1, 1, 1), centre=(0, 0, 0), level=0):
    """Halved `level` times and pushed out towards an ellipsoid, to coordinates of 1/1024; faces turn outwards."""
    points = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(level):
        middles, halved = {}, []
        for a, b, c in faces:
            three = []
            for p, q in ((a, b), (b, c), (c, a)):
                key = (min(p, q), max(p, q))
                if key not in middles:
                    sums = [x + y for x, y in zip(points[p], points[q])]
                    size = sum(x * x for x in sums) ** 0.5
                    middles[key] = len(points)
                    points.append(tuple(x / size for x in sums))
                three.append(middles[key])
            ab, bc, ca = three
            halved += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = halved
    placed = [tuple(Fraction(round(1024 * h * x), 1024) + c for x, h, c in zip(p, half, centre)) for p in points]
    return placed, faces


def box(low, high):
    """Six faces of four corners."""
    points = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    return [tuple(map(Fraction, p)) for p in points], faces


def triangles(faces):
    return [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]


def text(number):
    return repr(float(number))


def obj(points, faces, name="block"):
    return (f"o {name}\n" + "".join("v " + " ".join(map(text, p)) + "\n" for p in points)
            + "".join("f " + " ".join(str(k + 1) for k in f) + "\n" for f in faces))


def stl(points, faces, name="block"):
    out = f"solid {name}\n"
    for f in triangles(faces):
        out += " facet normal 0 0 0\n  outer loop\n"
        out += "".join("   vertex " + " ".join(map(text, points[k])) + "\n" for k in f) + "  endloop\n endfacet\n"
    return out + f"endsolid {name}\n"


def binary_stl(points, faces):
    own = triangles(faces)
    return b"made by a test".ljust(80) + struct.pack("<I", len(own)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(float(c) for k in f for c in points[k]), 0) for f in own)


def ply(points, faces, form="ascii", real="float", index="int"):
    head = (f"ply\nformat {form} 1.0\ncomment made by a test\nelement vertex {len(points)}\nproperty {real} x\n"
            f"property {real} y\nproperty uchar red\nproperty {real} z\nelement face {len(faces)}\n"
            f"property list uchar {index} vertex_indices\nproperty list uchar short flags\nend_header\n").encode()
    if form == "ascii":
        rows = [" ".join([text(p[0]), text(p[1]), "200", text(p[2])]) for p in points]
        rows += [" ".join(map(str, (len(f), *f, 1, -7))) for f in faces]
        return head + ("\n".join(rows) + "\n").encode()
    order, codes = "<" if "little" in form else ">", {"float": "f", "double": "d", "int": "i", "ushort": "H"}
    body = b"".join(struct.pack(order + codes[real] * 2 + "B" + codes[real], float(p[0]), float(p[1]), 200, float(p[2]))
                    for p in points)
    return head + body + b"".join(struct.pack(order + "B" + codes[index] * len(f), len(f), *f)
                                  + struct.pack(order + "Bh", 1, -7) for f in faces)


def sections(points, faces, origin, direction):
    """Area and first moments (of s and height) by vectors along the plane, without joining them. `direction` has length
    one. A vertex on the plane counts as left of it, for both faces at an edge alike."""
    dx, dy = direction

    def across(p):
        return dx * (p[1] - origin[1]) - dy * (p[0] - origin[0])

    area = moment_s = moment_z = Fraction(0)
    for f in triangles(faces):
        ends = {}
        for a, b in zip(f, (*f[1:], f[0])):
            u, v = across(points[a]), across(points[b])
            if (u < 0) == (v < 0):
                continue
            t = u / (u - v)
            p = [x + t * (y - x) for x, y in zip(points[a], points[b])]
            ends[v < 0] = (dx * (p[0] - origin[0]) + dy * (p[1] - origin[1]), p[2])
        if ends:
            (s, z), (r, w) = ends[True], ends[False]
            cross = s * w - r * z
            area += cross / 2
            moment_s += cross * (s + r) / 6
            moment_z += cross * (z + w) / 6
    return abs(area), abs(area) and moment_s / area, abs(area) and moment_z / area


def volume(points, faces):
    total = Fraction(0)
    for a, b, c in ((points[k] for k in f) for f in triangles(faces)):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                  + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


class MeshCase(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.holder.name)

    def tearDown(self):
        self.holder.cleanup()

    def write(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())

    def scene(self, name, section="{from: [0, 0], to: [1, 0]}", more="", unit="m", rest=""):
        return (f"topple: 1\nlength_unit: {unit}\nsection: {section}\nblock: {{outline: {{mesh: {name}{more}}}, "
                f"unit_weight_kn_m3: 26}}\n{rest}")

    def solve(self, scene, *options):
        self.write("scene.yaml", scene)
        status, out, err = run("solve", "--json", *options, "scene.yaml", folder=self.folder)
        self.assertEqual((status, err), (0, ""))
        return json.loads(out)

    def block(self, scene, *options):
        return self.solve(scene, *options)["cases"][0]["block"]

    def refuse(self, scene, place, words):
        self.write("scene.yaml", scene)
        status, out, err = run("solve", "scene.yaml", folder=self.folder)
        self.assertEqual((status, out), (3, ""), err)
        self.assertIn(f"topple: {place}: ", err)
        self.assertIn(words, err)
        self.assertNotIn("\n", err.rstrip("\n"))
