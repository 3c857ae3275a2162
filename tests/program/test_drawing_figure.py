# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which object of a drawing became what, in the figure: the legend says the layer of the block, of holes, parts and the base,
and what was not used.

Letters of an SVG by Cairo are glyphs, so layers are called by words that every legend has: what stands for 'contact' there
is known from the figure itself. Hostile layers and names are text, in every kind of file."""

import json
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

import hostile
from harness import main, reads
from svg import LINK, SVG, Drawing, overlap

SQUARE = [[0, 0], [2, 0], [2, 3], [0, 3], [0, 0]]
HOLE = [[0.5, 2], [1.5, 2], [1.5, 2.5], [0.5, 2.5], [0.5, 2]]
SEAMS = [[[0, 0], [2, 0], [2, 0.3], [0, 0.3], [0, 0]], [[0, 0.5], [2, 0.5], [2, 0.8], [0, 0.8], [0, 0.5]],
         [[0, 1], [2, 1], [2, 1.3], [0, 1.3], [0, 1]]]
BASE = [[-1, 0], [3, 0]]


def feature(points, layer, name=""):
    kind = "Polygon" if points[0] == points[-1] else "LineString"
    return {"type": "Feature", "properties": {"layer": layer, "name": name},
            "geometry": {"type": kind, "coordinates": [points] if kind == "Polygon" else points}}


def glyphs(svg):
    """Each text as the letters that it is drawn with, one after the other."""
    groups = ElementTree.fromstring(svg).iter(SVG + "g")
    return [[use.get(LINK) for use in group.findall(SVG + "use")] for group in groups if group.findall(SVG + "use")]


@unittest.skipUnless(reads("geojson"), "Topple was built without RapidJSON")
class DrawnNames(hostile.Case):
    def draw(self, features, drawing="", kind="svg"):
        (self.path / "d.geojson").write_text(json.dumps({"type": "FeatureCollection", "features": features}))
        (self.path / "s.yaml").write_text(f"topple: 1\ndrawing: {{file: d.geojson, unit: m{drawing}}}\n"
                                          "block: {unit_weight_kn_m3: 26}\nfriction_angle_deg: 30\ntilt: {towards: left}\n")
        self.run_bytes("solve", "--quiet", "--figure", f"f.{kind}", "s.yaml")
        return (pathlib.Path(self.path) / f"f.{kind}").read_bytes()

    def section(self, block, hole, seams, base, unused):
        parts = ", ".join(f"{{layer: '{layer}', unit_weight_kn_m3: 20}}" for layer in sorted(set(seams)))
        rest = [feature(own, layer) for own, layer in zip(SEAMS, seams)]
        return self.draw([feature(SQUARE, block), feature(HOLE, hole), feature(BASE, base), *rest,
                          *[feature([[5, k], [6, k]], layer) for k, layer in enumerate(unused)]],
                         f", block: '{block}', hole: '{hole}', base: '{base}', part: [{parts}]")

    def test_layers_in_the_legend(self):
        """'contact' and 'centroid' stand in any legend, once each. An object on a layer of that name adds the name at the end
        of an entry, of each role, and every text stays clear of the others."""
        plain = self.section("A", "B", ["C", "D", "C"], "F", ["G"])
        words = {"contact": None, "centroid": None}
        # the legend begins with block, hole, both densities and base, then 'contact' and 'centroid'
        texts = glyphs(plain)
        for k, _ in enumerate(texts):
            if [len(text) for text in texts[k:k + 7]] == [len(word) for word in (
                    "block: A", "hole: B", "of other density: C", "of another: D", "base: F", "contact", "centroid")]:
                words = {"contact": texts[k + 5], "centroid": texts[k + 6]}
        self.assertNotIn(None, words.values())
        for word, letters in words.items():
            self.assertEqual(sum(text[-len(letters):] == letters for text in texts), 1, word)
            own = ["A", "B", "C", "F", "G"]
            for place in range(len(own)):
                with self.subTest(word=word, place=place):
                    named = own[:place] + [word] + own[place + 1:]
                    svg = self.section(named[0], named[1], [named[2], "D", named[2]], named[3], [named[4]])
                    self.assertEqual(sum(text[-len(letters):] == letters for text in glyphs(svg)), 2)
                    drawing = Drawing(svg.decode())
                    for a, one in enumerate(drawing.texts):
                        self.assertTrue(all(not overlap(one, other) for other in drawing.texts[:a]))

    def test_more_than_there_is_room_for(self):
        """Of many layers the first three; a long one is cut; what is drawn stays on the page."""
        for unused in (["G", "H", "I"], ["G", "H", "I", "J", "K"], ["long " * 200] * 2, ["岩" * 100, "é" * 100, "x" * 400]):
            drawing = Drawing(self.section("W" * 60, "B" * 60, ["C" * 60, "D" * 60, "E" * 60], "F" * 60, unused).decode())
            for box in drawing.texts:
                self.assertTrue(box[0] > 0 and box[2] < drawing.size[0] and box[3] < drawing.size[1], box)

    def test_hostile_layers(self):
        for k, text in enumerate(hostile.TEXTS):
            with self.subTest(text=text[:60]):
                features = [feature(SQUARE, text, text), feature(BASE, text, text)]
                for kind, begins in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG"))[:1 if k % 8 else 3]:
                    data = self.draw(features, kind=kind)
                    self.assertTrue(data.startswith(begins))
                    if kind == "svg":
                        hostile.as_xml(data, self)
                out, err = self.run_bytes("new", "d.geojson", "--unit=m", f"-o{k}.yaml")
                hostile.plain(out, self)
                self.assertEqual(err, b"")


if __name__ == "__main__":
    main()
