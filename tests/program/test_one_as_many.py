# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A block on its base is a case of many blocks: every scene of examples/ and tests/hard/ that both can say is solved as two blocks too,
of which the base is one, from the outlines that the solution of the one draws. Limits and factors of safety agree within their
bounds. Two solvers that share little: one climbs through vertices of one block's cone, the other is an interior point method."""

import json
import math
import re

from governing_case import GoverningCase
from harness import ROOT, example_scenes, is_readable, main, run

# What scenes of many blocks do not have, or have in other words.
OTHERS = re.compile(r"^(frame|cases|world|rest|pose|joint|solids?|blocks|columns|within):|arc|ellipse|rounded|barton|facet|smooth|"
                    r"anchors|water|surcharge|pressure|support|moment|stays_level|friction_law|parts|study|shake|at2|place", re.M)
NEAR = 1e-9  # of the size: a vertex of the contact is on that edge


def paths(text):
    return [[tuple(float(v) for v in p.split()) for p in part.rstrip("Z").split("L")] for part in text.split("M")[1:]]


def is_on(point, a, b, size):
    length = math.dist(a, b)
    along = ((point[0] - a[0]) * (b[0] - a[0]) + (point[1] - a[1]) * (b[1] - a[1])) / length
    across = ((point[1] - a[1]) * (b[0] - a[0]) - (point[0] - a[0]) * (b[1] - a[1])) / length
    return abs(across) <= NEAR * size and NEAR * size < along < length - NEAR * size


def with_points(ring, points, size):
    """The ring by way of points that lie on its edges; its vertices at these points are them."""
    own = []
    ring = [next((p for p in points if math.dist(p, v) <= NEAR * size), v) for v in ring]
    for a, b in zip(ring, ring[1:] + ring[:1]):
        own.append(a)
        if math.dist(a, b) > 0:
            own += sorted({p for p in points if is_on(p, a, b, size)}, key=lambda p: math.dist(p, a))
    return [p for k, p in enumerate(own) if p != own[k - 1]]


def written(points):
    return "[" + ", ".join(f"[{x!r}, {y!r}]" for x, y in points) + "]"


class OneAsMany(GoverningCase):
    def as_many(self, scene, one):
        """The scene as two blocks; None: what it has is not said so."""
        text = scene.read_text(encoding="utf-8")
        lines = "\n".join(line.split(" #")[0] for line in text.splitlines() if not line.startswith("#"))
        friction = re.search(r"^friction_angle_deg: *([0-9.]+) *$", lines, re.M)
        if friction is None or OTHERS.search(lines):
            return None
        outlines = one["outlines"]
        rings, base, contact = (paths(outlines[k]) for k in ("block", "base", "contact"))
        size = math.hypot(*outlines["box_m"][2:])
        if len(base) != 1 or any(len(c) < 2 for c in contact):
            return None
        touching = [p for c in contact for p in c]
        low = min(p[1] for p in base[0] + rings[0]) - size
        ground = with_points(base[0] + [(base[0][-1][0], low), (base[0][0][0], low)], touching, size)
        own = dict(re.findall(r"^(parameters|loads|tilt|slope): *(\{.*\}) *$", lines, re.M))
        if outlines["parts"] or ("loads" in lines and "loads" not in own):
            return None
        weight = re.search(r"unit_weight_kn_m3: *([0-9.]+)", lines)
        holes = [f"[{', '.join(written(r) for r in rings[1:])}]"] if len(rings) > 1 else []
        return "\n".join(["topple: 1", "length_unit: m", f"friction_angle_deg: {friction[1]}",
                          *(f"{k}: {v}" for k, v in own.items()), f"block: {{unit_weight_kn_m3: {weight[1]}}}" if weight else "",
                          "blocks:", f"  - {{name: base, ground: true, outline: {written(ground)}}}",
                          f"  - {{name: block, outline: {written(with_points(rings[0], touching, size))}"
                          + "".join(f", holes: {h}" for h in holes) + "}"]) + "\n"

    def compare(self, name, case, many):
        """How many numbers both have."""
        limit, count = case["limit"], 0
        pairs = [(many["critical_angle_deg"], limit["critical_angle_deg"])]
        if many.get("fos_is") is None:
            pairs.append((many["fos"], limit["fos"]))
        for told, truth in pairs:
            if told is None or truth is None:
                continue
            count += 1
            within = told["error"] + truth["error"] + 1e-9 * (1 + abs(truth["value"]))  # outlines are drawn in doubles
            self.assertLessEqual(abs(told["value"] - truth["value"]), within, (name, case["towards"], told, truth))
        return count

    def test_examples_and_hard_cases(self):
        count = 0
        for scene in filter(is_readable, [*example_scenes(), *sorted((ROOT / "tests" / "hard").glob("*.yaml"))]):
            status, out_of_one, _ = run("solve", "--json", "--outlines", scene)
            text = self.as_many(scene, json.loads(out_of_one)) if status in (0, 1) else None
            if text is None:
                continue
            status, out, err = run("solve", "--json", self.scene(text))
            if status == 3:  # doubles cannot draw it
                continue
            self.assertIn(status, (0, 1, 4), (scene, err))
            many = {c["towards"]: c for c in json.loads(out)["cases"]}
            for case in json.loads(out_of_one)["cases"]:
                if case["towards"] in many and case.get("limit"):
                    count += self.compare(scene.name, case, many[case["towards"]])
        self.assertGreaterEqual(count, 90)


if __name__ == "__main__":
    main()
