# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Many blocks out of a drawing (docs/drawing.md#many-blocks): layers as blocks and ground, in DXF and CSV, against the same blocks
listed in a scene; and what is refused."""

import json

from governing_case import GoverningCase
from harness import main, reads, run

GROUND = [(-9, -1), (9, -1), (9, 0), (-9, 0)]
BLOCKS = [("ROCK", [(0, 0), (2, 0), (2, 1), (0, 1)]), ("CLAY", [(2, 0), (4, 0), (4, 1), (2, 1)]),
          ("ROCK", [(1, 1), (3, 1), (3, 2), (1, 2)])]
NAMES = ["ROCK 1", "ROCK 2", "CLAY 1", "ground"]
REST = "topple: 1\nlength_unit: m\nfriction_angle_deg: 30\nblock: {unit_weight_kn_m3: 25}\ntilt: {towards: left}\n"


def dxf(outlines, closed=1):
    """Closed polylines, in millimetres."""
    text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
    for layer, ring in outlines:
        text += f"0\nLWPOLYLINE\n5\nA1\n100\nAcDbEntity\n8\n{layer}\n100\nAcDbPolyline\n90\n{len(ring)}\n70\n{closed}\n"
        text += "".join(f"10\n{x * 1000}\n20\n{y * 1000}\n" for x, y in ring)
    return text + "0\nENDSEC\n0\nEOF\n"


def table(outlines):
    rows = "".join(f"{x},{y},{layer},{layer}{k}\n" for k, (layer, ring) in enumerate(outlines) for x, y in ring + ring[:1])
    return "x,y,layer,name\n" + rows


def listed(order):
    rows = "".join(f"  - {{name: {name}, {'ground: true, ' if name == 'ground' else ''}outline: {[list(p) for p in ring]}}}\n"
                   for name, ring in order)
    return REST + "blocks:\n" + rows


class Drawn(GoverningCase):
    def system(self, text):
        status, out, err = run("solve", "--json", self.scene(text))
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def drawing(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def test_joints_of_layers(self):
        """A pair of layers is all pairs of their blocks, a block and a layer goes before it, and two blocks before both; cohesion and
        tensile strength too. The same as joints that are listed one by one."""
        self.drawing("section.csv", table([("bedrock", GROUND)] + BLOCKS))
        by_layers = ("joints:\n  - {between: [clay, ROCK], friction_angle_deg: 10, cohesion_kpa: 5}\n"
                     "  - {between: [ROCK, BEDROCK], friction_angle_deg: 20}\n"
                     "  - {between: [CLAY 1, BEDROCK], friction_angle_deg: 15, tension_kpa: 2}\n"
                     "  - {between: [ROCK 2, CLAY], friction_angle_deg: 12}\n  - {between: [ROCK, ROCK], friction_angle_deg: 25}\n")
        by_names = ("joints:\n  - {between: [ROCK 1, CLAY 1], friction_angle_deg: 10, cohesion_kpa: 5}\n"
                    "  - {between: [ROCK 1, ground], friction_angle_deg: 20}\n"
                    "  - {between: [CLAY 1, ground], friction_angle_deg: 15, tension_kpa: 2}\n"
                    "  - {between: [ROCK 2, CLAY 1], friction_angle_deg: 12}\n  - {between: [ROCK 1, ROCK 2], friction_angle_deg: 25}\n")
        drawn = REST + "drawing: {file: section.csv, blocks: [ROCK, CLAY], ground: BEDROCK, unit: m}\n"
        own, other = (self.system(drawn + joints) for joints in (by_layers, by_names))
        self.assertEqual(own["contacts"], other["contacts"])
        self.assertEqual(own["cases"], other["cases"])
        self.assertEqual(sorted({c["friction_angle_deg"]["value"] for c in own["contacts"]}), [10, 12, 15, 20, 25])
        for joints, message in (("joints: [{between: [ROCK, CLAY]}, {between: [CLAY, ROCK]}]\n", "given twice"),
                                ("joints: [{between: [ROCK, SAND], friction_angle_deg: 3}]\n", "no block is named 'SAND'")):
            status, _, err = run("solve", self.scene(drawn + joints))
            self.assertEqual(status, 3)
            self.assertIn(message, err)
        own = self.system(drawn + "joints: [{between: [CLAY, CLAY], friction_angle_deg: 3}]\n")
        self.assertIn("this joint acts nowhere", own["notes"][0]["text"])

    def test_the_same_blocks(self):
        """Layer by layer, by numbers: the blocks, contacts, limits and forces of the same that are listed."""
        rock1, clay, rock2 = (ring for _, ring in BLOCKS)
        plain = self.system(listed(list(zip(NAMES, [rock1, rock2, clay, GROUND]))))
        outlines = [("bedrock", GROUND)] + BLOCKS + [("0", [(50, 50), (51, 50), (51, 51)])]
        self.drawing("section.csv", table(outlines))
        files = [("section.csv", ", unit: m")]
        if reads("dxf"):
            self.drawing("section.dxf", dxf(outlines))
            files.append(("section.dxf", ""))
        for name, more in files:
            own = self.system(REST + f"drawing: {{file: {name}, blocks: [ROCK, CLAY], ground: BEDROCK{more}}}\n")
            self.assertEqual([b["name"] for b in own["blocks"]], NAMES)
            for key in ("blocks", "contacts", "cases"):
                self.assertEqual(own[key], plain[key])

    def test_joints_gaps_and_grounds(self):
        """Joints name what was drawn; gaps of a hand close; two outlines of ground are two."""
        off = [("GROUND", GROUND), ("GROUND", [(5, 0), (9, 0), (9, 2), (5, 2)]),
               ("ROCK", [(0, 0.0003), (2, -0.0002), (2, 1), (0, 1)]), ("ROCK", [(2.0004, 0), (4, 0), (4, 1), (2, 1.0003)])]
        self.drawing("hand.csv", table(off))
        own = self.system(REST + "contact: {within: 0.001}\ndrawing: {file: hand.csv, unit: m, blocks: ROCK}\n"
                          "joints: [{between: [ROCK 1, ROCK 2], friction_angle_deg: 12}]\n")
        self.assertEqual([b["name"] for b in own["blocks"]], ["ROCK 1", "ROCK 2", "ground", "ground 2"])
        self.assertIn("corners were moved so that blocks touch", own["notes"][-1]["text"])
        self.assertIn(12, [c["friction_angle_deg"]["value"] for c in own["contacts"]])

    def test_refusals(self):
        """Each at its place, in the scene or in the drawing."""
        self.drawing("section.csv", table([("GROUND", GROUND)] + BLOCKS))
        self.drawing("over.csv", table([("GROUND", GROUND), ("ROCK", [(0, -0.5), (2, 0), (2, 1)])]))
        for drawing, told in (("blocks: STONE", "nothing of the drawing is on layer 'STONE'"),
                              ("blocks: ROCK, ground: BED", "nothing of the drawing is on layer 'BED'"),
                              ("ground: GROUND", "'blocks' is missing"), ("blocks: ROCK, block: ROCK", "leave out 'block'"),
                              ("blocks: [[ROCK]]", "a layer of the drawing, or a list")):
            status, out, err = run("solve", self.scene(REST + f"drawing: {{file: section.csv, unit: m, {drawing}}}\n"))
            self.assertEqual((status, out), (3, ""), drawing)
            self.assertIn(told, err)
            self.assertRegex(err, r"\.yaml:\d+:\d+: ")
        status, _, err = run("solve", self.scene(REST + "drawing: {file: over.csv, unit: m, blocks: ROCK}\n"))
        self.assertEqual(status, 3)
        self.assertRegex(err, r"over\.csv:\d+.*'ROCK 1' and 'ground' overlap")
        status, _, err = run("solve", self.scene(REST + "drawing: {file: section.csv, unit: m, blocks: ROCK}\ncolumns: {width: 1, heights: [1]}\n"))
        self.assertEqual(status, 3)
        self.assertIn("leave it out", err)


if __name__ == "__main__":
    main()
