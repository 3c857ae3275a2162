# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Figures of many blocks (docs/blocks_in_contact.md): outlines turned as they lie and tinted by how they move, the mechanism by
the velocities that the report tells, an arrow for each force; the same of mirrored blocks and of blocks far away, and whatever
blocks are called."""

import fractions
import json
import math
import re
import xml.etree.ElementTree as ElementTree

import hostile
from governing_case import GoverningCase
from harness import ROOT, main, reads, run
from pile_case import EXAMPLE, Pile, box, wall
from svg import SVG, Drawing, covers

# As src/presentation/figure/view.c has them.
TINTS = {"at rest": (0.84, 0.925, 0.975), "slides": (0.985, 0.9, 0.68), "topples": (0.95, 0.72, 0.58),
         "slides and topples": (0.8, 0.66, 0.8)}
PURPLE, VERMILION, BLUE, ROCK = (0.8, 0.475, 0.655), (0.835, 0.369, 0.0), (0.0, 0.447, 0.698), (0.89, 0.88, 0.86)
SMALL = Pile().add("g", box(-9, -1, 9, 0), True).add("b", box(0, 0, 9, 4))
SLOPE = []
ROUNDED = 0.02  # of a point: Cairo's 1/256, of outlines that are turned and shifted


def corners(piece):
    return [complex(x, -y) for x, y in piece]


class FiguresOfBlocks(GoverningCase):
    def draw(self, scene, kind="svg"):
        """A figure, and the result that is drawn."""
        file = self.folder / f"figure.{kind}"
        status, out, err = run("solve", "--json", "--figure", file, scene)
        self.assertEqual((status, err), (0, ""))
        return file.read_bytes(), json.loads(out)

    def drawing(self, scene):
        data, told = self.draw(scene)
        return Drawing(data.decode()), told

    def slope(self):
        """Drawn once for all tests."""
        if not SLOPE:
            SLOPE.append(self.drawing(EXAMPLE))
        return SLOPE[0]

    def outlines(self, drawing):
        """By tint, without the swatch of the legend, which is drawn last."""
        return {name: [area[0] for area in drawing.areas.get(tint, [])[:-1]] for name, tint in TINTS.items()}

    def test_slope(self):
        """Goodman and Bray's slope at a dip of 30°: each column once, in the tint of its motion; the outline of each that moves by
        more than 0.7 points displaced by the velocities of its corners, times one number; an arrow for each force."""
        drawing, told = self.slope()
        case = told["cases"][0]
        free = [(b, m) for b, m in zip(told["blocks"], case["motions"]) if not b["ground"]]
        outlines = self.outlines(drawing)
        for name in TINTS:
            self.assertEqual(len(outlines[name]), sum((m["mechanism"] if m["mechanism"] != "stands" else "at rest") == name
                                                      for _, m in free), name)
        self.assertGreater(sum(map(bool, outlines.values())), 2)
        self.assertEqual(len(drawing.areas[ROCK]), 2)
        forces = [math.hypot(f["normal_n_m"], f["shear_n_m"]) for f in case["forces"]]
        arrows = len(drawing.areas[BLUE]) - 1  # Cairo drops those shorter than it rounds
        self.assertLessEqual(arrows, sum(f > 1e-6 * max(forces) for f in forces))
        self.assertGreaterEqual(arrows, sum(f > 1e-3 * max(forces) for f in forces))
        every = [corners(piece) for pieces in outlines.values() for piece in pieces]
        width = abs(every[0][1] - every[0][0])  # 10 m
        for own in every:
            turned = (own[1] - own[0]) / width
            self.assertLess(abs(turned - complex(math.cos(math.pi / 6), math.sin(math.pi / 6))), 1e-3)
        self.magnified(drawing, every, free, width / 10)

    def test_line_of_thrust(self):
        """One line goes through all columns, from the force of the toe's base by way of those between columns, where the report says that
        they act, to that of the last one's base. The verdict below says from which divisor on a motion can begin."""
        drawing, told = self.slope()
        case = told["cases"][0]
        (lines,) = [stroke for stroke in drawing.strokes[BLUE] if len(stroke) == 16]
        lines = sorted((sorted(corners(line), key=lambda p: p.real) for line in lines), key=lambda line: line[0].real)
        for one, other in zip(lines, lines[1:]):
            self.assertLess(abs(one[1] - other[0]), 2 * ROUNDED)
        between = [complex(f["x_m"], f["y_m"]) for c, f in zip(told["contacts"], case["forces"])
                   if "ground" not in (c["first"], c["second"])]
        drawn = [line[1] for line in lines[:-1]]
        self.assertEqual(len(between), 15)
        scale = (drawn[-1] - drawn[0]) / (between[-1] - between[0])  # turned by the dip
        self.assertAlmostEqual(math.degrees(math.atan2(scale.imag, scale.real)), 30, delta=0.02)
        for own, truth in zip(drawn, between):
            self.assertLess(abs(own - drawn[0] - scale * (truth - between[0])), 4 * ROUNDED)
        words = run("solve", "--figure", self.folder / "figure.dxf", EXAMPLE)[1]
        self.assertIn("motion can begin, strength divided by 0.82198", words)
        if reads("dxf"):
            text = (self.folder / "figure.dxf").read_text(encoding="utf-8").replace("\n", " ")
            self.assertIn("A motion can begin with strength divided by 0.82198", text)
            # Below the drawing the one factor stands first, as in the report, with its mechanism, and then what forces can hold.
            wet = EXAMPLE.with_name("wet_columns.yaml")
            page = run("solve", "--figure", self.folder / "figure.dxf", wet)[1]
            (factor,) = re.findall(r"^  factor of safety +(undecided: at most 1\.185\d+, driving loads, slides)$", page, re.M)
            held = dict(re.findall(r"forces can hold, (\w+ ?\w* \w+) +(up to [\d.]+ \(upper bound\))", page))
            self.assertEqual(list(held), ["driving loads times", "strength divided by"])
            text = (self.folder / "figure.dxf").read_text(encoding="utf-8").replace("\n", " ")
            self.assertIn(f"Factor of safety: {factor}; forces can hold, with strength divided by, {held['strength divided by']}, "
                          f"with driving loads times, {held['driving loads times']}", text)

    def magnified(self, drawing, every, free, scale):
        """`scale`: points of a metre. The columns stand in no order of the list but that of x."""
        every = sorted(every, key=lambda own: own[0].real)
        moved = [corners(stroke[0]) for stroke in drawing.strokes[VERMILION] if len(stroke) == 1 and len(stroke[0]) == 4]
        turn = complex(math.cos(math.pi / 6), math.sin(math.pi / 6))
        expected = []
        for own, (block, motion) in zip(every, free):
            velocity = complex(motion["velocity_x"], motion["velocity_y"]) * turn
            middle = sum(own) / 4
            expected.append([velocity + 1j * motion["turn_per_m"] * (p - middle) / scale for p in own])
        speeds = [max(map(abs, own)) for own in expected]
        self.assertAlmostEqual(max(speeds), 1, delta=1e-4)
        seen = sorted(sorted(range(len(speeds)), key=lambda k: -speeds[k])[:len(moved)])
        steps = [(b - a, v) for k, other in zip(seen, moved) for a, b, v in zip(every[k], other, expected[k])]
        times = sum((step * v.conjugate()).real for step, v in steps) / sum(abs(v) ** 2 for _, v in steps)
        self.assertLess(max(abs(step - times * v) for step, v in steps), 3 * ROUNDED)
        self.assertEqual(seen, [k for k, speed in enumerate(speeds) if times * speed > 0.7])

    def test_loads(self):
        """Under a tilt water is level and the bar of a bolt reaches from its head to its far end, both to scale; each other load has
        its arrows, seven of a line."""
        pile = Pile().add("g", box(-9, -2, 9, 0), True).add("low", box(0, 0, 4, 1)).add("high", box(0, 1, 4, 4))
        for level, depth in ((2, "level: 2"), (None, "surface: [[-9, 2], [2, 3], [9, 3]]")):
            drawing, _ = self.drawing(self.scene(pile.scene(
                35, "tilt: {towards: left, angle_deg: 10}\nloads:\n"
                f"  water: {{{depth}, faces: both, uplift: full}}\n"
                "  anchors: [{block: high, at: [1, 3], to: [4, -1], force_kn: 30}]\n"
                "  surcharges: [{block: high, from: [4, 4], to: [0, 4], kpa: 10}]\n"
                "  forces: [{block: low, at: [0, 0.5], direction_deg: 0, force_kn: 3}]\n")))
            low = min((piece for pieces in self.outlines(drawing).values() for piece in pieces),
                      key=lambda piece: -max(y for _, y in piece))
            width = max(abs(a - b) for a in corners(low) for b in corners(low)) / math.hypot(4, 1)
            lines = [corners(stroke[0]) for stroke in drawing.strokes[PURPLE] if len(stroke) == 1 and len(stroke[0]) == 2]
            self.assertLess(min(abs(abs(a - b) / width - 5) for a, b in lines), 1e-2)
            self.assertEqual(len(drawing.areas[PURPLE]), 7 + 1 + 1 + 1 + 1)  # a head of a bolt, and the legend's arrow
            water = [stroke[0] for stroke in drawing.strokes[BLUE] if len(stroke) == 1]
            if level is not None:
                flat = [s for s in water if len(s) == 2 and s[0][1] == s[1][1] and abs(s[0][0] - s[1][0]) > 300]
                toe = max(corners(low), key=lambda p: -p.imag)  # the origin is the lowest corner that is free
                self.assertAlmostEqual((-flat[0][0][1] - toe.imag) / width, level, delta=1e-2)

    def test_names_lie_in_their_blocks(self):
        """Sixteen names, the middle of each in a column of its own."""
        drawing, _ = self.slope()
        every = [[piece] for pieces in self.outlines(drawing).values() for piece in pieces]
        middles = [((x + u) / 2, (y + v) / 2) for x, y, u, v in drawing.texts]
        inside = [[covers(area, (x - 0.1, y - 0.1, x + 0.1, y + 0.1)) for x, y in middles] for area in every]
        self.assertEqual([sum(own) for own in inside], [1] * 16)

    def test_mirrored(self):
        """The mirror image of a wall, tilted to the other side, is the mirror image: of its outlines, by tint, and of the tips of
        its arrows."""
        tilt = "tilt: {towards: left, angle_deg: 10}"
        pile = Pile().add("g", box(-5, -2, 9, 0), True).add("a", box(0, 0, 2, 5)).add("b", box(2, 0, 5, 3)).add("c", box(2, 3, 3, 6))
        own, _ = self.drawing(self.scene(pile.scene(25, tilt)))
        other, _ = self.drawing(self.scene(pile.moved(lambda x, y: (-x, y)).scene(25, tilt.replace("left", "right"))))
        self.assertEqual(own.size, other.size)
        for name, pieces in self.outlines(own).items():
            images = self.outlines(other)[name]
            self.assertEqual(len(pieces), len(images), name)
            for piece, image in zip(pieces, images):
                self.same(sorted((own.size[0] - x, y) for x, y in piece), sorted(image))

    def same(self, one, other):
        self.assertEqual(len(one), len(other))
        for (x, y), (u, v) in zip(one, other):
            self.assertLess(max(abs(x - u), abs(y - v)), ROUNDED)

    def test_far_away(self):
        """A wall 10¹² m from the origin of its scene is drawn as one at it, its arrows as well as doubles tell where they are; so is
        one on ground that is a million times as large."""
        tilt = "tilt: {towards: left, angle_deg: 10}"
        pile = wall(3, 2)
        own, _ = self.drawing(self.scene(pile.scene(35, tilt)))
        far, _ = self.drawing(self.scene(pile.moved(lambda x, y: (x + 10 ** 12, y - 10 ** 12)).scene(35, tilt)))
        vast = Pile().add("ground", box(-10 ** 7, -10 ** 7, 10 ** 7, 0), True)
        vast.blocks += pile.blocks[1:]
        large, _ = self.drawing(self.scene(vast.scene(35, tilt)))
        for other, shifted in ((far, False), (large, True)):
            for name, pieces in self.outlines(own).items():
                self.assertEqual(len(pieces), len(self.outlines(other)[name]))
                for piece, image in zip(pieces, self.outlines(other)[name]):
                    if shifted:  # more ground is seen: another scale
                        self.assertEqual(len(piece), len(image))
                    else:
                        self.same(piece, image)
        for piece in large.areas[ROCK][0]:
            self.assertLess(max(abs(v) for point in piece for v in point), 2000)

    def test_direction_that_governs(self):
        """A column that leans to the right, tilted to both sides. By 5°: the factor of safety is that of sliding to either, and it
        topples to the right sooner; by 12°: it falls to the right alone. That is drawn, whichever comes first."""
        pile = Pile().add("g", box(-9, -1, 9, 0), True).add("a", [(0, 0), (2, 0), (3, 6), (1, 6)])
        for tilt in (5, 12):
            for image, side in ((pile, -1), (pile.moved(lambda x, y: (-x, y)), 1)):
                drawing, told = self.drawing(self.scene(image.scene(40, f"tilt: {{angle_deg: {tilt}}}")))
                self.assertEqual(len(told["cases"]), 2)
                (own,) = [piece for pieces in self.outlines(drawing).values() for piece in pieces]
                left, right = sorted(sorted(corners(own), key=lambda p: p.imag)[:2], key=lambda p: p.real)
                self.assertEqual(math.copysign(1, (right - left).imag), side)

    def test_holes_and_corners(self):
        """A block with a hole is one area of two pieces; a corner on an edge, a block without weights and a scene without a title
        draw too."""
        text = ("topple: 1\nlength_unit: m\nfriction_angle_deg: 60\ntilt: {towards: left, angle_deg: 5}\nblocks:\n"
                "  - {ground: true, outline: [[-9, -1], [9, -1], [9, 0], [-9, 0]]}\n"
                "  - {outline: [[0, 0], [4, 0], [4, 3], [0, 3]], holes: [[[1, 1], [2, 1], [2, 2], [1, 2]]]}\n"
                "  - {outline: [[2, 3], [3, 5], [1, 5]]}\n  - {outline: [[4, 0], [5, 0], [4.5, 1]]}\n")
        drawing, told = self.drawing(self.scene(text))
        pieces = sorted(len(area) for tint in TINTS.values() for area in drawing.areas.get(tint, [])[:-1])
        self.assertEqual(pieces, [1, 1, 2])
        self.assertEqual(len(told["blocks"]), 4)

    def test_words_from_outside(self):
        """Whatever blocks and title are called, a figure is well-formed, and of letters alone."""
        plain = None
        for text in hostile.TEXTS[::4]:
            scene = SMALL.scene(30)
            name = json.dumps(text if text.strip() else "b")
            scene = scene.replace("name: b,", f"name: {name},").replace("topple: 1\n", f"topple: 1\ntitle: {json.dumps(text)}\n")
            path = self.scene(scene)
            status = run("solve", path)[0]
            if status:  # no name or no YAML
                self.assertEqual(status, 3)
                continue
            data, _ = self.draw(path)
            hostile.as_xml(data, self)
            plain = Drawing(data.decode())
        self.assertEqual(len(plain.areas[ROCK]), 2)

    def test_kinds(self):
        """SVG, PDF, PNG and DXF, the same bytes on each run; another ending is refused, and leaves no file."""
        scene = self.scene(SMALL.scene(30))
        for kind, begins in (("svg", b"<?xml"), ("pdf", b"%PDF-1."), ("png", b"\x89PNG\r\n"), ("dxf", b"999\n")):
            data, _ = self.draw(scene, kind)
            self.assertTrue(data.startswith(begins))
            self.assertEqual(data, self.draw(scene, kind)[0])
        file = self.folder / "drawing.gif"
        status, out, err = run("solve", "--figure", file, scene)
        self.assertEqual((status, out), (2, ""))
        self.assertIn(".svg, .pdf, .png or .dxf", err)
        self.assertFalse(file.exists())

    def test_dxf_is_read_back(self):
        """What a scene's `drawing` reads of a figure is the blocks that were solved, to the digits: their areas, contacts and limit,
        also of a wall 10⁷ m away in decimals; displaced outlines, contacts and forces are on layers of their own."""
        far = (wall(3, 2).moved(lambda x, y: (fractions.Fraction(x) / 10 + 4500100, fractions.Fraction(y) / 10 + 5600020)), 35)
        for pile, friction in ((SMALL, 30), (wall(3, 2), 35), far):
            pile = pile.moved(lambda x, y: (float(x), float(y)))
            tilt = "tilt: {towards: left, angle_deg: 10}"
            data, told = self.draw(self.scene(pile.scene(friction, tilt)), "dxf")
            self.assertTrue(data.endswith(b"EOF\n"))
            layers = set(re.findall(rb"\n  8\n(\w+)\n", data))
            self.assertLessEqual({b"BLOCK", b"BASE", b"CONTACT", b"FORCES", b"MECHANISM", b"TEXT"}, layers)
            if not reads("dxf"):
                continue
            scene = self.scene(f"topple: 1\nlength_unit: m\nfriction_angle_deg: {friction}\n{tilt}\nblock: {{unit_weight_kn_m3: 25}}\n"
                               "drawing: {file: figure.dxf, blocks: BLOCK, ground: BASE}\n")
            status, out, err = run("solve", "--json", scene)
            self.assertEqual(status, 0, err)
            own = json.loads(out)
            self.assertEqual(sorted(b["area_m2"]["value"] for b in own["blocks"]), sorted(b["area_m2"]["value"] for b in told["blocks"]))
            self.assertEqual(len(own["contacts"]), len(told["contacts"]))
            for key in ("critical_angle_deg", "fos"):
                one, other = own["cases"][0][key], told["cases"][0][key]
                self.assertLessEqual(abs(one["value"] - other["value"]), one["error"] + other["error"])

    def test_dxf_of_a_slope(self):
        """Turned as it lies: the longest side of the first column of the example dips by 60°."""
        data, _ = self.draw(EXAMPLE, "dxf")
        text = data.decode()
        first = text[text.index("POLYLINE\n  8\nBLOCK\n"):]
        first = first[:first.index("SEQEND")]
        corners = [complex(float(x), float(y)) for x, y in re.findall(r"VERTEX\n  8\nBLOCK\n 10\n(\S+)\n 20\n(\S+)\n", first)]
        self.assertEqual(len(corners), 4)
        along = corners[1] - corners[0]
        self.assertLess(abs(along / abs(along) - complex(math.cos(math.pi / 6), math.sin(math.pi / 6))), 1e-12)

    def animated(self, scene):
        """Of each panel the heading, and of each group that moves the last of its displacements and turns, by its outline."""
        file = self.folder / "moving.svg"
        status, out, err = run("solve", "--json", "--animation", file, scene)
        self.assertEqual((status, err), (0, ""))
        root = ElementTree.fromstring(file.read_text(encoding="utf-8"))
        panels = []
        for panel in root.findall(f"{SVG}svg"):
            moves = []
            for group in panel.findall(f"{SVG}g"):
                last = {animate.get("type"): [float(n) for n in animate.get("values").split(";")[-1].split()]
                        for animate in group.iter(f"{SVG}animateTransform")}
                moves.append((last.get("translate", [0, 0]), last.get("rotate", [0])[0]))
            panels.append(moves)
        return panels, json.loads(out), " ".join(text.text or "" for text in root.iter(f"{SVG}text"))

    def test_moving(self):
        """Two panels: the motion that is proven, and the collapse. Blocks are displaced by their velocities, turned as they lie, and
        turned by their spins, all by the one way that the heading tells; what rests does not move."""
        panels, told, words = self.animated(EXAMPLE)
        case = told["cases"][0]
        self.assertIn("A motion that can begin as they lie, proven", words)
        self.assertIn("not a simulation", words)
        away = [float(n) for n in re.findall(r"drawn (\S+) m away", words)]
        turn = complex(math.cos(math.pi / 6), math.sin(math.pi / 6))
        for moves, motions, way in zip(panels, (case["start"]["motions"], case["motions"]), away, strict=True):
            free = [m for m, b in zip(motions, told["blocks"]) if not b["ground"]]
            scale = max(math.hypot(*shift) for shift, _ in moves) / max(math.hypot(m["velocity_x"], m["velocity_y"]) for m in free)
            self.assertEqual(len(moves), len(free))
            for (shift, turned), motion in zip(moves, free):
                velocity = complex(motion["velocity_x"], motion["velocity_y"]) * turn
                if motion["mechanism"] == "stands":
                    self.assertEqual((shift, turned), ([0, 0], 0))
                else:
                    self.assertLess(abs(complex(shift[0], -shift[1]) - scale * velocity), 2e-3)
                    self.assertAlmostEqual(turned, -math.degrees(way * motion["turn_per_m"]), delta=5e-3 * abs(turned) + 1e-4)

    def test_moving_refused(self):
        held = Pile().add("g", box(-9, -1, 9, 0), True).add("b", box(0, 0, 9, 4))
        for scene, file, ended, told in ((self.scene(held.scene(30)), "a.gif", 3, "give a name that ends in .svg"),
                                         (ROOT / "examples" / "slab.yaml", "a.svg", 3, "topple tilt --animation")):
            status, _, err = run("solve", "--animation", self.folder / file, scene)
            self.assertEqual(status, ended)
            self.assertIn(told, err)
            self.assertFalse((self.folder / file).exists())

    def test_files_in_the_way(self):
        """Neither the scene, by another name, nor a folder is written over."""
        scene = self.scene(SMALL.scene(30))
        link, folder = self.folder / "link.svg", self.folder / "folder.svg"
        link.symlink_to(scene)
        folder.mkdir()
        for file, ended, told in ((link, 3, "scene"), (folder, 5, "cannot be written")):
            status, out, err = run("solve", "--figure", file, scene)
            self.assertEqual((status, out), (ended, ""))
            self.assertIn(told, err)
        self.assertEqual(scene.read_text(encoding="utf-8"), SMALL.scene(30))

    def test_committed_figure(self):
        """docs/figures shows what the program draws."""
        committed = Drawing((ROOT / "docs/figures/toppling_slope.svg").read_text())
        drawn, _ = self.slope()
        for tint in (*TINTS.values(), BLUE, ROCK):
            self.assertEqual(committed.areas[tint], drawn.areas[tint])


if __name__ == "__main__":
    main()
