# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Noise of a survey on many blocks (docs/blocks_in_contact.md): what `contact: {within: …}` makes of corners that are off by
millimetres, against the blocks without noise, and the hints where it is not given."""

import json
import random

from governing_case import GoverningCase
from harness import main, run

GROUND = [(-9, -1), (9, -1), (9, 0), (-9, 0)]
#: Two bricks, one across both of them, and a column beside: corners on edges, corners on corners, and three on one edge.
WALL = [[(0, 0), (2, 0), (2, 1), (0, 1)], [(2, 0), (4, 0), (4, 1), (2, 1)], [(1, 1), (3, 1), (3, 2), (1, 2)],
        [(4, 0), (5, 0), (5, 4), (4, 4)]]


def scene(outlines, within=None, unit="m", friction=30):
    rows = "".join(f"  - {{name: b{k}, {'ground: true, ' if k == 0 else ''}outline: [{', '.join(f'[{x}, {y}]' for x, y in own)}]}}\n"
                   for k, own in enumerate(outlines))
    contact = f"contact: {{within: {within}}}\n" if within else ""
    return (f"topple: 1\nlength_unit: {unit}\nfriction_angle_deg: {friction}\nblock: {{unit_weight_kn_m3: 25}}\n"
            f"tilt: {{towards: left}}\n{contact}blocks:\n{rows}")


def noisy(seed, size):
    """Corners of free blocks off by up to a size, each block by its own."""
    draw = random.Random(seed)
    return [GROUND] + [[tuple(round(v + draw.uniform(-size, size), 7) for v in p) for p in ring] for ring in WALL]


class Survey(GoverningCase):
    def system(self, text):
        status, out, err = run("solve", "--json", self.scene(text))
        self.assertEqual(status, 0, err)
        return json.loads(out)

    def limit(self, system):
        return system["cases"][0]["critical_angle_deg"]["value"]

    def pairs(self, system):
        return {frozenset((c["first"], c["second"])) for c in system["contacts"] if not c["corner"]}

    def test_noise_is_taken_out(self):
        """Blocks that are off by up to a millimetre touch where those without noise do, and their limit is that within the noise: a
        millimetre on a metre turns a contact by 2 mrad, 0.11°. No corner is moved by more than three times the noise in x and y."""
        exact = self.system(scene([GROUND] + WALL))
        self.assertEqual(exact["notes"], [])
        for seed in range(6):
            own = self.system(scene(noisy(seed, 1e-3), "3e-3"))
            self.assertEqual(self.pairs(own), self.pairs(exact))
            self.assertAlmostEqual(self.limit(own), self.limit(exact), delta=0.5)
            note = own["notes"][0]["text"]
            self.assertRegex(note, r"^\d+ corners were moved so that blocks touch, by up to [\d.e-]+ m, of 'b\d'")
            self.assertLess(float(note.split("by up to ")[1].split(" ")[0]), 3e-3)

    def test_the_less_the_nearer(self):
        """With the noise its effect goes to nothing, in proportion."""
        exact = self.limit(self.system(scene([GROUND] + WALL)))
        for size in (1e-4, 1e-6):
            off = abs(self.limit(self.system(scene(noisy(3, size), 3 * size))) - exact)
            self.assertLess(off, 600 * size)

    def test_exact_blocks_stay(self):
        """What touches exactly is what it was, with any tolerance below the blocks' own size."""
        exact = self.system(scene([GROUND] + WALL))
        own = self.system(scene([GROUND] + WALL, "0.4"))
        self.assertEqual(own["notes"][0]["text"], "no corner had to be moved so that blocks touch")
        for key in ("blocks", "contacts", "cases"):
            self.assertEqual(own[key], exact[key])

    def test_images(self):
        """Mirrored, in millimetres and a kilometre away it closes the same gaps by as much."""
        blocks = noisy(5, 1e-3)
        plain = self.system(scene(blocks, "3e-3"))
        away = [[(round(x + 1000, 7), y) for x, y in ring] for ring in blocks]
        scaled = [[(f"{x * 1000:.4f}", f"{y * 1000:.4f}") for x, y in ring] for ring in blocks]
        mirrored = [[(-x, y) for x, y in ring] for ring in blocks]
        for text, by in ((scene(away, "3e-3"), 1), (scene(scaled, "3", unit="mm"), 1),
                         (scene(mirrored, "3e-3").replace("towards: left", "towards: right"), 1)):
            own = self.system(text)
            self.assertEqual(self.pairs(own), self.pairs(plain))
            self.assertAlmostEqual(self.limit(own), self.limit(plain), delta=1e-5 * by)
            self.assertEqual(own["notes"][0]["text"].split(" corners")[0], plain["notes"][0]["text"].split(" corners")[0])

    def test_hints(self):
        """Without a tolerance a floating block says what it lies above, a narrow gap is told, an overlap names both, and each how to
        close it; with one, as each says, it is closed."""
        low, beside = [(0, 0), (2, 0), (2, 1), (0, 1)], [(2.001, 0), (3, 0), (3, 3), (2.001, 3)]
        above = [(0, 1.001), (2, 1.001), (2, 2), (0, 2)]
        own = self.system(scene([GROUND, low, beside]))
        self.assertEqual(own["notes"][0]["text"], "blocks 'b1' and 'b2' lie 0.001 m apart and do not touch; if that is noise of a survey, "
                         "'contact: {within: 0.002}' closes it")
        self.assertEqual(len(own["contacts"]), 2)
        self.assertIn({"b1", "b2"}, self.pairs(self.system(scene([GROUND, low, beside], "0.002"))))
        for outlines, told in (([GROUND, low, above], "'b2' touches no other, and lies 0.001 scene lengths from 'b1'"),
                               ([GROUND, low, [(1.999, 0), (3, 0), (3, 3), (1.999, 3)]], "blocks 'b1' and 'b2' overlap")):
            status, out, err = run("solve", self.scene(scene(outlines)))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(told, err)
            self.assertIn("contact: {within: ", err)
            self.system(scene(outlines, "0.002"))
        # What is no noise is not to be closed: a block that hangs in the air, and one that meets another in a corner of both alone.
        for outline, told in (([(0, 1.5), (2, 1.5), (2, 2), (0, 2)], "and lies 0.5 scene lengths from 'b1', the nearest"),
                              ([(2, 1), (4, 1), (4, 2), (2, 2)], "'b2' touches no other but 'b1', and that in a corner of both alone")):
            status, out, err = run("solve", self.scene(scene([GROUND, low, outline])))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(told, err)
            self.assertNotIn("within:", err)
        wide = self.system(scene([GROUND, low, [(2.1, 0), (3, 0), (3, 3), (2.1, 3)]]))
        self.assertEqual(wide["notes"], [])

    def test_refusals(self):
        """Overlaps beyond the tolerance, one that swallows an edge, and scenes whose blocks touch by themselves."""
        low = [(0, 0), (2, 0), (2, 1), (0, 1)]
        over = [(1.9, 0), (3, 0), (3, 3), (1.9, 3)]
        thin = [(2.001, 0), (2.004, 0), (3, 2), (2.001, 2)]
        for text, told in (
                (scene([GROUND, low, over], "0.002"), "blocks 'b1' and 'b2' overlap"),
                (scene([GROUND, low, thin], "0.005"), "no longer than the tolerance"),
                (scene([GROUND, low], "0"), "above zero"), (scene([GROUND, low], "0.1, width: 1"), "width"),
                (scene([GROUND, low], "0.1").split("blocks:")[0] + "columns: {width: 1, heights: [1, 1]}\n", "leave it out")):
            status, out, err = run("solve", self.scene(text))
            self.assertEqual((status, out), (3, ""), text)
            self.assertIn(told, err)
            self.assertRegex(err, r"\.yaml:\d+:\d+: ")


if __name__ == "__main__":
    main()
