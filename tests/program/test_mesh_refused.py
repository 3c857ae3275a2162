# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Meshes as they go wrong: cut off on the way, with counts that lie, holes where the plane passes, faces in the plane.

The story: a wrong mesh that gives some outline all the same is worse than none. Each slip is refused with its place and
what to do, and nothing of a file that may be any file is quoted."""

import struct

from harness import main
from mesh_case import MeshCase, binary_stl, box, obj, octahedron, ply, stl

SOLID = octahedron(level=1)
PLANE = "{from: [0, 0.01], to: [1, 0.01]}"


class MeshRefused(MeshCase):
    def refuse_file(self, name, content, place, words, **scene):
        """At a place of the file."""
        self.write(name, content)
        self.refuse(self.scene(name, **{"section": PLANE, **scene}), f"{name}{place}", words)

    def refuse_scene(self, place, words, content=obj(*SOLID), **scene):
        self.write("a.obj", content)
        self.refuse(self.scene("a.obj", **{"section": PLANE, **scene}), f"scene.yaml:{place}", words)

    def test_binary_stl(self):
        whole = binary_stl(*SOLID)
        self.refuse_file("a.stl", whole[:-7], "", "a binary STL with 32 triangles has 1684 bytes, this one has 1677; "
                         "it was cut off or damaged")
        self.refuse_file("a.stl", whole + b"\0", "", "this one has 1685")
        lies = whole[:80] + struct.pack("<I", 0xffffffff) + whole[84:]
        self.refuse_file("a.stl", lies, "", "with 4294967295 triangles has 214748364834 bytes")
        for bad in (float("nan"), float("inf"), float("-inf")):
            spoilt = bytearray(whole)
            spoilt[84 + 50 * 4 + 12 + 8:84 + 50 * 4 + 12 + 12] = struct.pack("<f", bad)
            self.refuse_file("a.stl", bytes(spoilt), "", "triangle 5: a coordinate that is not a finite number")
        self.refuse_file("a.stl", b"solid" + whole[5:-1], "", "was cut off or damaged")
        self.refuse_file("a.stl", b"", "", "this is not an STL: it neither begins with 'solid' nor has the 84 bytes")
        self.refuse_file("a.stl", whole[:80] + struct.pack("<I", 0), "", "there is no face in it")

    def test_text_stl(self):
        whole = stl(*SOLID)
        self.refuse_file("a.stl", whole[:whole.index("endsolid")], ":226:1", "the file ends without 'endsolid'")
        self.refuse_file("a.stl", whole[:whole.index("endloop")], ":7:3", "'endloop' is expected here")
        self.refuse_file("a.stl", whole.replace("endloop", "vertex 1 2 3", 1), ":7:3", "'endloop' is expected here")
        self.refuse_file("a.stl", whole.replace("outer", "inner", 1), ":3:3", "'outer loop' is expected here")
        self.refuse_file("a.stl", whole.replace("0.0", "0,0", 1), ":4:15", "a comma within a number; write decimals with a p")
        self.refuse_file("a.stl", whole.replace("0.0", "nan", 1), ":4:15", "a coordinate that is not a finite number")
        self.refuse_file("a.stl", whole.replace("0.0", "zero", 1), ":4:15", "this entry is not a number")
        self.refuse_file("a.stl", whole + "root:x:0:0\n", ":227:1", "'solid' is expected here")
        self.refuse_file("a.stl", whole.encode("utf-16"), "", "this text is in UTF-16; save it as UTF-8 or plain ASCII")

    def test_ply(self):
        whole = ply(*SOLID)
        self.refuse_file("a.ply", whole[:-3], ":62:14", "this line ends too early")
        self.refuse_file("a.ply", whole + b"3 0 1 2\n", "", "the file goes on after all elements of its header")
        self.refuse_file("a.ply", whole.replace(b"face 32", b"face 33"), ":63:1", "this line ends too early")
        self.refuse_file("a.ply", whole.replace(b"vertex 18", b"vertex 17"), ":30:1", "the length of a list is a whole number")
        self.refuse_file("a.ply", whole.replace(b"vertex 18", b"vertex 19999999"), ":4:9", "the file is too short for so many")
        self.refuse_file("a.ply", whole.replace(b"vertex 18", b"vertex 20000001"), ":4:16", "more than 20 million")
        self.refuse_file("a.ply", whole.replace(b"vertex 18", b"vertex -1"), ":4:16", "an element line states how many")
        self.refuse_file("a.ply", whole.replace(b"float x", b"float u"), ":4:9", "vertices have the properties x, y and z")
        self.refuse_file("a.ply", whole.replace(b"float x", b"real x"), ":5:10", "a type of PLY is expected here")
        self.refuse_file("a.ply", whole.replace(b"ascii", b"text"), ":2:8", "a format of PLY is ascii, binary_little_endian")
        self.refuse_file("a.ply", whole.replace(b"1.0", b"2.0", 1), ":2:14", "Topple reads PLY of version 1.0")
        self.refuse_file("a.ply", whole.replace(b"face 32", b"cell 32"), "", "a mesh has the elements vertex and face")
        self.refuse_file("a.ply", whole[4:], ":1:1", "this is not a PLY")
        self.refuse_file("a.ply", whole[:60], ":4:17", "the file ends within its header")

    def test_binary_ply(self):
        for form in ("binary_little_endian", "binary_big_endian"):
            order = "<" if "little" in form else ">"
            whole = ply(*SOLID, form=form)
            self.refuse_file("a.ply", whole[:-1], "", "the file ends before all elements of its header")
            self.refuse_file("a.ply", whole + b"\n", "", "the file goes on after all elements of its header")
            at = whole.index(b"end_header\n") + 11
            spoilt = whole[:at + 13] + struct.pack(order + "f", float("nan")) + whole[at + 17:]
            self.refuse_file("a.ply", spoilt, "", "vertex 2: a coordinate that is not a finite number")
            at += 18 * 13
            spoilt = whole[:at + 1] + struct.pack(order + "i", -1) + whole[at + 5:]
            self.refuse_file("a.ply", spoilt, "", "face 1: a corner is the number of a vertex, counted from 0")
            self.refuse_file("a.ply", whole[:at] + b"\2" + whole[at + 1:], "", "face 1: a face has from 3 to 10000 corners")

    def test_obj(self):
        self.refuse_file("a.obj", "v 0 0 0\nf 1 2 3\n", ":2:5", "there is no vertex of this number above this face")
        self.refuse_file("a.obj", "v 0 0 0\nf 1 0 1\n", ":2:5", "a corner of a face is the number of a vertex, counted from 1")
        self.refuse_file("a.obj", "v 0 0 0\nf -1 -2 -1\n", ":2:6", "there is no vertex of this number")
        self.refuse_file("a.obj", "v 0 0\n", ":1:6", "a coordinate is missing")
        self.refuse_file("a.obj", "v 0 0 0\nf 1 1\n", ":2:6", "a face has three corners, or more")
        self.refuse_file("a.obj", "v 0 0 0\nf 1 1 1\n", "", "none of its faces has three different corners")
        self.refuse_file("a.obj", "cstype bezier\n", ":1:1", "a curved surface; export it as a mesh of flat faces")
        self.refuse_file("a.obj", "root:x:0:0:secret\n", ":1:1", "this is not a statement of an OBJ file")
        self.refuse_file("a.obj", "# nothing\n", "", "there is no face in it")
        self.refuse_file("a.obj", "v 1e400 0 0\n", ":1:3", "this entry is larger than 1e308")
        self.refuse_file("a.obj", "".join(f"o {k}\n" for k in range(10001)), "", "more than 10000 objects")
        self.refuse_file("a.dae", "", "", "a mesh is a file whose name ends in .stl, .ply or .obj")
        (self.folder / "b.obj").mkdir()
        self.refuse(self.scene("b.obj"), "b.obj", "is not a regular file")

    def test_where_the_plane_passes(self):
        points, faces = box((0, 0, 0), (2, 3, 1))
        self.refuse_scene("4:18", "lies to the right of it", section="{from: [0, 4], to: [1, 4]}", content=obj(points, faces))
        self.refuse_scene("4:18", "lies to the left of it", section="{from: [0, -1], to: [1, -1]}", content=obj(points, faces))
        for y, line in ((0, 12), (3, 14)):
            self.write("a.obj", obj(points, faces))
            self.refuse(self.scene("a.obj", f"{{from: [0, {y}], to: [1, {y}]}}"), f"a.obj:{line}",
                        "lies in the plane of the section, which has no outline there; shift the plane a little")
        self.refuse_scene("4:18", "the outline of the section is open from (2, 1) to (2, 0), over 1 m: the mesh has a hole",
                          section="{from: [0, 1], to: [1, 1]}", content=obj(points, faces[:3] + faces[4:]))
        self.write("a.obj", obj(points, list(faces) + [faces[0][::-1]]))
        self.refuse(self.scene("a.obj", "{from: [0, 1], to: [1, 1]}"), "a.obj:16", "face 7 shares an edge with two other")
        more, _ = box((4, 0, 0), (5, 3, 1))
        self.refuse_scene("4:18", "the plane cuts 2 outlines where one is expected, the first two 2 and 1 m wide; name one "
                          "'object' of the mesh, or say 'take: largest'", section="{from: [0, 1], to: [1, 1]}",
                          content=obj(points, faces, "a") + obj(more, [[k + 8 for k in f] for f in faces], "b"))

    def test_the_scene(self):
        self.refuse_scene("3:10", "a section goes from one point of the map to another", section="{from: [0, 0]}")
        self.refuse_scene("3:10", "a section goes from", section="{from: [0, 0], to: [1, 0], azimuth_deg: 3}")
        self.refuse_scene("3:10", "'from' and 'to' are one point", section="{from: [1, 0], to: [1, 0]}")
        self.refuse_scene("3:17", "'from' is a point of the map", section="{from: [1, 0, 0], to: [1, 0]}")
        self.refuse_scene("3:36", "azimuth_deg must lie between -360 and 360", section="{at: [0, 0], azimuth_deg: 361}")
        self.refuse_scene("3:41", "up must be z, or y", section="{from: [0, 0], to: [1, 0], up: x}")
        self.refuse_scene("4:40", "the mesh has no object of this name with faces; it has 'block'", more=", object: blok")
        self.refuse_scene("4:38", "unit must be one of mm, cm, m, km, in, ft", more=", unit: yd")
        self.refuse_scene("4:38", "take must be 'largest'", more=", take: all")
        self.refuse_scene("4:37", "gap", more=", gap: -1")
        self.write("scene.yaml", "")
        self.refuse("topple: 1\nlength_unit: m\nblock: {outline: {mesh: a.obj}}\n", "scene.yaml:1:1", "'section' is missing here")
        self.refuse("topple: 1\nlength_unit: m\nsection: {from: [0, 0], to: [1, 0]}\nblock: {slab: {width: 1, height: 2}}\n",
                    "scene.yaml:3:10", "this section cuts nothing")
        self.refuse("topple: 1\nlength_unit: m\nblock: {outline: {file: a.obj}}\n", "scene.yaml:3:18",
                    "must be a list of [x, y], the name of a CSV file, or {mesh: FILE}")


if __name__ == "__main__":
    main()
