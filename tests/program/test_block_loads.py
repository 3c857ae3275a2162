# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Loads on many blocks (docs/blocks_in_contact.md, Loads): water, pressures, surcharges, bolts, forces and the support for a wanted
factor, against scenes of one block, closed forms, sums in rationals, forces instead of bolts, and images."""

import fractions
import json
import math
import random

from governing_case import GoverningCase
from harness import main, rounds, run
from pile_case import EXAMPLE, Pile, box, degrees_of, text_of

GAMMA_W = fractions.Fraction(981, 100)
LEVEL = "tilt: {towards: left, angle_deg: 0}\n"


def force_of(load):
    return load["force_x_n_m"]["value"], load["force_y_n_m"]["value"]


class BlockLoads(GoverningCase):
    def json(self, text, *options):
        done, out, err = run("solve", "--json", *options, self.scene(text))
        self.assertEqual(done, 0, err + text)
        return json.loads(out)

    def case(self, text, *options):
        return self.json(text, *options)["cases"][0]

    def encloses(self, told, truth, within=0.0):
        self.assertLessEqual(abs(told["value"] - truth), told["error"] + within + 1e-12 * abs(truth), (told, truth))

    def same(self, one, other, where):
        self.assertEqual(one is None, other is None, where)
        if one is not None:
            self.assertLessEqual(abs(one["value"] - other["value"]), one["error"] + other["error"] + 1e-12, where)

    def test_as_a_scene_of_one(self):
        """Random blocks on level ground under each load, and under all: critical tilt and factor are those of `topple solve` of the one
        block, whose limit knows all these loads."""
        draw = random.Random(11)
        for _ in range(rounds(8, 60)):
            width, height, lean = draw.randint(3, 8), draw.randint(5, 12), draw.randint(-2, 1)
            outline = [(0, 0), (width, 0), (width + lean, height), (lean + draw.randint(0, 1), height)]
            top, right = (outline[2], outline[3]), (outline[1], outline[2])
            water = draw.choice((2, height + 1)), draw.choice(("behind", "both"))
            of = {"surcharges": f"[{{BLOCKfrom: {list(top[0])}, to: {list(top[1])}, kpa: {draw.randint(3, 40)}}}]",
                  "pressures": f"[{{BLOCKfrom: {list(right[0])}, to: {list(right[1])}, kpa: [{draw.randint(3, 9)}, 1]}}]",
                  "support_pressures": f"[{{BLOCKfrom: {list(outline[3])}, to: [0, 0], kpa: {draw.randint(1, 5)}}}]",
                  "anchors": f"[{{BLOCKINTOat: [1, 2], direction_deg: {draw.randint(-80, -20)}, force_kn: {draw.randint(20, 90)}, "
                             "spacing: 2, rows: 2, row_step: [0.25, 1]}]",
                  "water": f"{{level: {water[0]}, faces: {water[1]}, uplift: full}}"}
            for key in (*of, None):
                own = "\n".join(f"  {k}: {v}" for k, v in of.items() if key in (k, None))
                angle = 0 if key in ("water", None) else draw.choice((0, 4))
                rest = f"tilt: {{towards: left, angle_deg: {angle}}}\nloads:\n{own}\n"
                friction = draw.choice((25, 35, 50))
                one = self.json(f"topple: 1\nlength_unit: m\nblock: {{outline: {text_of(outline)}, unit_weight_kn_m3: 25}}\n"
                                f"base: {{beyond: {{left: 50, right: 50}}}}\nfriction_angle_deg: {friction}\n"
                                + rest.replace("BLOCKINTO", "").replace("BLOCK", ""))["cases"][0]["limit"]
                many = self.case(Pile().add("g", box(-50, -9, 60, 0), True).add("b", outline)
                                 .scene(friction, rest.replace("INTO", "into: g, ").replace("BLOCK", "block: b, ")))
                where = (outline, friction, rest, many, one)
                self.same(many["critical_angle_deg"], one["critical_angle_deg"], where)
                if one["fos"] is None:  # no strength is too little: the loads press it down, and nothing drives it
                    self.assertIn(many.get("fos_is"), ("at least this", "undecided"), where)
                else:
                    self.same(many["fos"], one["fos"], where)

    def test_submerged(self):
        """Of a block under water that stands in its joint too the weight is less by that of the water that it displaces: k W = tan φ
        (W − U). Drained joints bear the water above: tan φ (W + γ_w b d)."""
        gamma, width, height, depth, t = 24, 3, 4, 9, math.tan(math.radians(30))
        pile = Pile().add("g", box(-9, -1, 9, 0), True).add("b", box(0, 0, width, height))
        weight, lift = gamma * width * height, float(GAMMA_W) * width * height
        down = float(GAMMA_W) * width * (depth - height)
        for uplift, truth in (("full", t * (weight - lift) / weight), ("none", t * (weight + down) / weight)):
            own = self.case(pile.scene(30, f"{LEVEL}loads: {{water: {{level: {depth}, faces: both, uplift: {uplift}}}}}", weight=gamma))
            self.encloses(own["critical_acceleration_g"], truth, 1e-9)
        # A surface that lies as it should on the side that is asked for alone: on the other it would go back.
        steep = pile.scene(70, "tilt: {towards: left, angle_deg: 60}\nloads: {water: {surface: [[-20, 20], [20, -20]], faces: both}}")
        self.assertEqual(self.case(steep)["towards"], "left")
        self.assertIn("goes back", run("solve", self.scene(steep.replace("left", "right")))[2])
        # What is left open is told, and is the cautious reading.
        text = pile.scene(30, f"{LEVEL}loads: {{water: {{level: {depth}}}}}", weight=gamma)
        left_out = self.json(text)
        self.assertEqual(len([n for n in left_out["notes"] if n["kind"] == "caution" and "cautious" in n["text"]]), 2)
        self.assertEqual(left_out["cases"][0]["verdict"], "collapses")
        dry = self.json(text.replace("level: 9", "level: -3"))
        self.assertIn("acts nowhere", dry["notes"][0]["text"])

    def test_pressures_in_rationals(self):
        """A wall of bricks below a broken surface: what water in each joint pushes by is the integral of its depth, and what it does to a
        block with all faces wet is −∫ grad p dA: γ_w A upwards and −γ_w s A across, s the slope of the surface above; moments
        about the centroid γ_w s A (h² − w² s / s) / 12 … of a rectangle under one slope nothing but those of the second moments,
        which vanish. Each in rationals."""
        surface = [(-5, 3), (1, 8), (4, 2), (20, fractions.Fraction(5, 2))]

        def depth(x, y):
            for (x0, y0), (x1, y1) in zip(surface, surface[1:]):
                if x0 <= x <= x1:
                    return y0 + fractions.Fraction(y1 - y0) * (x - x0) / (x1 - x0) - y
            raise AssertionError

        def integral(p, q):
            """Along p … q, by its depth at the ends of pieces over which it is linear."""
            cuts = {fractions.Fraction(0), fractions.Fraction(1)}
            for x, _ in surface:
                if p[0] != q[0] and 0 < (share := fractions.Fraction(x - p[0]) / (q[0] - p[0])) < 1:
                    cuts.add(share)
            at = [(p[0] + c * (q[0] - p[0]), p[1] + c * (q[1] - p[1])) for c in sorted(cuts)]
            total, length = fractions.Fraction(0), abs(q[0] - p[0]) + abs(q[1] - p[1])
            for c, d, (a, b) in zip(sorted(cuts), sorted(cuts)[1:], zip(at, at[1:])):
                first, last = depth(*a), depth(*b)
                wet = (d - c) * length
                if first < 0 or last < 0:
                    deep = max(first, last)
                    wet *= 0 if deep <= 0 else deep / abs(first - last)
                    first, last = max(first, 0), max(last, 0)
                total += wet * (first + last) / 2
            return total

        pile = Pile().add("g", box(-4, -2, 12, 0), True)
        for course in range(3):
            for k in range(3):
                left = 2 * k + course % 2
                pile.add(f"b{course}{k}", box(left, 2 * course, left + 2, 2 * course + 2))
        water = f"{LEVEL}loads: {{water: {{surface: {text_of(surface)}, faces: both, uplift: full}}}}"
        own = self.json(pile.scene(40, water))
        case = own["cases"][0]
        self.assertEqual(len(case["forces"]), len(own["contacts"]))
        for contact, force in zip(own["contacts"], case["forces"]):
            p, q = (tuple(fractions.Fraction(contact[f"{end}_{axis}_m"]["value"]) for axis in "xy") for end in ("from", "to"))
            self.encloses(force["water_n_m"], 1000 * float(GAMMA_W * integral(p, q)), 1e-7)
        sums = {name: [0, 0] for name, _, _ in pile.blocks}
        for load in case["loads"]:
            sums[load["block"]] = [a + b for a, b in zip(sums[load["block"]], force_of(load))]
        for name, corners, ground in pile.blocks[1:]:
            if all(depth(*c) >= 0 for c in corners) and not any(corners[0][0] < x < corners[1][0] for x, _ in surface):
                slope = depth(corners[1][0], 0) - depth(corners[0][0], 0)
                for part, truth in zip(sums[name], (-4 * GAMMA_W * slope / 2, 4 * GAMMA_W)):
                    self.assertAlmostEqual(part, 1000 * float(truth), delta=1e-6)

    def test_forces_balance(self):
        """Weights, loads, and what each contact bears and the water in it, which pushes along the normal as the force does, sum to
        nothing on every block, and so do moments, to the 1e-5 that the bracket of the factor leaves."""
        pile = Pile().add("g", box(-9, -1, 19, 0), True).add("low", box(0, 0, 3, 2)).add("high", box(0, 2, 3, 6)).add("by", box(3, 0, 5, 4))
        loads = ("loads:\n  water: {level: 3, faces: both, uplift: full}\n  anchors: [{block: high, at: [1, 5], to: [4, 1], force_kn: 40}]\n"
                 "  surcharges: [{block: by, from: [3, 4], to: [5, 4], kpa: 15}]\n"
                 "  forces: [{block: high, at: [3, 5], direction_deg: 190, force_kn: 25}]\n")
        own = self.json(pile.scene(33, "tilt: {towards: left, angle_deg: 6}\n" + loads))
        case, blocks = own["cases"][0], {b["name"]: b for b in own["blocks"]}
        sine, cosine = math.sin(math.radians(6)), math.cos(math.radians(6))
        sums = {name: [-b["weight_n_m"]["value"] * sine, -b["weight_n_m"]["value"] * cosine, 0] for name, b in blocks.items()}
        for load in case["loads"]:
            if "water in joints" not in load["kind"]:  # that is added contact by contact
                for k, part in enumerate((*force_of(load), load["moment_n"]["value"])):
                    sums[load["block"]][k] += part

        def push(contact, normal, shear, x, y):
            dx = contact["to_x_m"]["value"] - contact["from_x_m"]["value"]
            dy = contact["to_y_m"]["value"] - contact["from_y_m"]["value"]
            size = math.hypot(dx, dy)
            for name, sign in ((contact["first"], 1), (contact["second"], -1)):
                b = blocks[name]
                fx, fy = sign * (shear * dx - normal * dy) / size, sign * (shear * dy + normal * dx) / size
                sums[name][0] += fx
                sums[name][1] += fy
                sums[name][2] += (x - b["centroid_x_m"]["value"]) * fy - (y - b["centroid_y_m"]["value"]) * fx

        for contact, force in zip(own["contacts"], case["forces"]):
            push(contact, force["normal_n_m"], force["shear_n_m"], force["x_m"], force["y_m"])
            ends = [(contact[f"{e}_x_m"]["value"], contact[f"{e}_y_m"]["value"]) for e in ("from", "to")]
            first, last = (max(0.0, 3 - (x * sine + y * cosine)) for x, y in ends)
            if first > 0 and last > 0:  # all joints here are below the water or cut by it at one end
                share = (first + 2 * last) / (3 * (first + last))
                at = [a + share * (b - a) for a, b in zip(*ends)]
            else:
                depths = [3 - (x * sine + y * cosine) for x, y in ends]
                part = depths[0] / (depths[0] - depths[1])
                deep, dry = ends if depths[0] > 0 else ends[::-1]
                part = part if depths[0] > 0 else 1 - part
                at = [a + part / 3 * (b - a) for a, b in zip(deep, dry)]
            push(contact, force["water_n_m"]["value"], 0, *at)
        for name, b in blocks.items():
            if not b["ground"]:
                for part, arm in zip(sums[name], (1, 1, 6)):
                    self.assertLessEqual(abs(part), 2e-5 * arm * b["weight_n_m"]["value"], (name, sums[name]))

    def test_bolts_pull_both_ways(self):
        """A bolt between two blocks is two forces, one on each; one into ground is one. Inside a block that a strong joint divides it
        does nothing, and the divided block is the whole one."""
        pile = Pile().add("g", box(-9, -3, 19, 0), True).add("low", box(0, 0, 3, 2)).add("high", box(0, 2, 2, 7))
        angle = math.degrees(math.atan2(-5, 2))
        bolt = self.case(pile.scene(35, LEVEL + "loads: {anchors: [{block: high, at: [0.5, 6], to: [2.5, 1], force_kn: 70}]}"))
        pair = self.case(pile.scene(35, f"{LEVEL}loads: {{forces: [{{block: high, at: [0.5, 6], direction_deg: {angle!r}, force_kn: 70}}, "
                                        f"{{block: low, at: [2.5, 1], direction_deg: {180 + angle!r}, force_kn: 70}}]}}"))
        ground = self.case(pile.scene(35, LEVEL + "loads: {anchors: [{block: high, at: [0.5, 6], dip_deg: 70, length: 8, force_kn: 70}]}"))
        alone = self.case(pile.scene(35, LEVEL + "loads: {forces: [{block: high, at: [0.5, 6], dip_deg: 70, force_kn: 70}]}"))
        for one, other in ((bolt, pair), (ground, alone)):
            for key in ("critical_angle_deg", "critical_acceleration_g"):
                self.same(one[key], other[key], key)
        self.assertEqual([load["block"] for load in bolt["loads"]], ["high", "low"])
        self.assertEqual([load["block"] for load in ground["loads"]], ["high"])
        loads = "loads: {seismic: {horizontal: 0.05}, water: {level: 2, faces: both, uplift: full}BOLT}"
        joint = "joints: [{between: [a, b], friction_angle_deg: 60, cohesion_kpa: 100000, tension_kpa: 100000}]\n"
        whole = Pile().add("g", box(-9, -3, 19, 0), True).add("a", box(0, 0, 3, 6))
        halves = Pile().add("g", box(-9, -3, 19, 0), True).add("a", box(0, 0, 3, 3)).add("b", box(0, 3, 3, 6))
        own = self.case(whole.scene(35, LEVEL + loads.replace("BOLT", "")))
        for bolted in ("", ", anchors: [{block: b, at: [1, 5], to: [2, 1], force_kn: 900}]"):
            cut = self.case(halves.scene(35, LEVEL + loads.replace("BOLT", bolted)) + joint)
            for key in ("critical_angle_deg", "critical_acceleration_g"):
                self.same(own[key], cut[key], (bolted, key))

    def test_found_by_place(self):
        """Loads without the names of blocks act on those that they lie on: the same result; a pressure along two blocks is shared by
        them, as it is at its ends. A millionth of a block aside of its face is on it, more is not."""
        pile = Pile().add("g", box(-9, -3, 19, 0), True).add("low", box(0, 0, 3, 2)).add("high", box(0, 2, 3, 7))
        named = ("  pressures: [{block: low, from: [3, 0], to: [3, 2], kpa: [7, 5]}, {block: high, from: [3, 2], to: [3, 7], kpa: [5, 0]}]\n"
                 "  surcharges: [{block: high, from: [0, 7], to: [3, 7], kpa: 9}]\n"
                 "  forces: [{block: low, at: [0, 1], direction_deg: 0, force_kn: 2}]\n"
                 "  anchors: [{block: high, at: [0, 5], to: [5, -1], force_kn: 20}]\n")
        found = ("  pressures: [{from: [3, 0], to: [3, 7], kpa: [7, 0]}]\n  surcharges: [{from: [0, 7], to: [3, 7], kpa: 9}]\n"
                 "  forces: [{at: [0, 1], direction_deg: 0, force_kn: 2}]\n  anchors: [{at: [-1e-7, 5], to: [5, -1], force_kn: 20}]\n")
        found, named = found.replace("[7, 0]", "[7, 7]"), named.replace("[7, 5]", "[7, 7]").replace("[5, 0]", "[7, 7]")
        one, other = (self.case(pile.scene(35, f"{LEVEL}loads:\n{loads}")) for loads in (named, found))
        self.assertEqual([load["block"] for load in one["loads"]], [load["block"] for load in other["loads"]])
        for a, b in zip(one["loads"], other["loads"]):
            for key in ("force_x_n_m", "force_y_n_m", "moment_n"):
                self.assertAlmostEqual(a[key]["value"], b[key]["value"], delta=1e-2)
        sloping = self.case(pile.scene(35, f"{LEVEL}loads: {{pressures: [{{from: [3, 0], to: [3, 7], kpa: [7, 0]}}]}}"))["loads"]
        self.assertEqual([force_of(load) for load in sloping], [(-12000, 0), (-12500, 0)])  # 7 to 5 over 2 m, 5 to 0 over 5 m
        for aside, status in (("3.0000001", 0), ("3.001", 3)):
            text = pile.scene(35, f"{LEVEL}loads: {{pressures: [{{block: high, from: [{aside}, 2], to: [{aside}, 7], kpa: 5}}]}}")
            self.assertEqual(run("solve", self.scene(text))[0], status)

    def test_images(self):
        """Mirrored, in millimetres and in a mine's coordinates, blocks under all loads have one limit, one factor, one support."""
        pile = Pile().add("g", box(-9, -3, 19, 0), True).add("low", box(0, 0, 3, 2)).add("high", box(0, 2, 2, 7))
        own = {}
        for name, how, side, unit, size in (("own", lambda x, y: (x, y), "left", "m", 1),
                                            ("mirrored", lambda x, y: (-x, y), "right", "m", 1),
                                            ("in mm", lambda x, y: (1000 * x, 1000 * y), "left", "mm", 1000),
                                            ("in a mine", lambda x, y: (x + 512345, y + 6789012), "left", "m", 1)):
            p = lambda x, y: list(how(x, y))  # noqa: E731
            face = [p(2, 2), p(2, 7)] if name != "mirrored" else [p(2, 7), p(2, 2)]
            text = pile.moved(how).scene(30, (
                f"tilt: {{towards: {side}, angle_deg: 0}}\nsupport: {{block: low, at: {p(0, 1)}, fos: 2}}\nloads:\n"
                f"  seismic: {{horizontal: 0.2}}\n  water: {{level: {p(0, 3)[1]}, uplift: full, faces: behind}}\n"
                f"  pressures: [{{block: high, from: {face[0]}, to: {face[1]}, kpa: 4}}]\n"
                f"  anchors: [{{block: high, at: {p(0, 6)}, to: {p(3, -1)}, force_kn: 30, spacing: {2 * size}}}]\n"
                f"  surcharges: [{{block: high, from: {p(0, 7)}, to: {p(2, 7)}, kpa: 9}}]\n"), unit=unit)
            own[name] = self.case(text)
            for key in ("critical_angle_deg", "critical_acceleration_g", "fos"):
                self.same(own["own"][key] if key in own["own"] else None, own[name].get(key), (name, key))
            self.same(own["own"]["support"]["force_n_m"], own[name]["support"]["force_n_m"], name)

    def test_support(self):
        """A slab on a plane that dips α with tan φ / F: S (cos α + sin α tan φ / F) = W (sin α − cos α tan φ / F). The slope of Goodman and
        Bray at tan φ 0.65: theirs, at the top of the toe's free side, is 2012.9 kN/m; forces that act where it is best need less, and
        with so much as a force hold the slope, with a part in 10⁵ less do not."""
        alpha, t, factor, weight = math.radians(35), math.tan(math.radians(30)), 1.5, 25 * 8 * 2
        slab = Pile().add("g", box(-9, -1, 19, 0), True).add("b", box(0, 0, 8, 2))
        dip = "slope: {dip_deg: 35, towards: left}\nsupport: {block: b, at: [0, 1]"
        sine, cosine = math.sin(alpha), math.cos(alpha)
        for f, ask in ((factor, ", fos: 1.5}"), (1, "}"), (factor, "}\nrequired_fos: 1.5")):
            own = json.loads(run("solve", "--json", self.scene(slab.scene(30, dip + ask)))[1])["cases"][0]
            truth = 1000 * weight * (sine - cosine * t / f) / (cosine + sine * t / f)
            self.encloses(own["support"]["force_n_m"], truth, 1e-9 * truth)
            self.assertLess(own["support"]["force_n_m"]["error"], 1e-6 * truth)
        self.assertEqual(self.case(slab.scene(50, dip + "}"))["support"]["force_is"], "not needed")
        self.assertEqual(self.case(slab.scene(30, dip + ", direction_deg: 180}"))["support"]["force_is"], "none")
        text = EXAMPLE.read_text(encoding="utf-8").replace("blocks:", "EXTRA\nblocks:", 1)
        friction = f"friction_angle_deg={degrees_of(0.65)}"
        own = self.case(text.replace("EXTRA", "support: {block: column 1, at: [0, 4]}"), "--set", friction)
        least = own["support"]["force_n_m"]["value"] / 1000
        self.assertAlmostEqual(own["goodman_bray"]["support_n_m"] / 1000, 2012.9, delta=0.05)
        self.assertLess(least, 2012.9)
        self.assertEqual(own["support"]["direction_deg"]["value"], -30)
        for share, verdict in ((1 + 1e-5, "can be held"), (1 - 1e-5, "collapses")):
            force = f"loads: {{forces: [{{block: column 1, at: [0, 4], direction_deg: -30, force_kn: {least * share!r}}}]}}"
            held = self.case(text.replace("EXTRA", force), "--set", friction)
            self.assertIn(held["verdict"], (verdict, "may move") if verdict == "can be held" else (verdict,))
            # Their columns bear the force too: what they ask for is less by it.
            self.assertTrue(held["goodman_bray"]["applies"])
            self.assertAlmostEqual(held["goodman_bray"]["support_n_m"] / 1000, own["goodman_bray"]["support_n_m"] / 1000 - least * share, delta=1e-4)
            self.assertLess(own["goodman_bray"]["fos"], held["goodman_bray"]["fos"])
            self.assertLess(held["goodman_bray"]["fos"], 1)

    def test_what_is_refused(self):
        """Loads that act on nothing are told by their place and by the names of blocks, before anything is solved."""
        pile = Pile().add("ground", box(-9, -3, 9, 0), True).add("low", box(0, 0, 2, 2)).add("high", box(0, 2, 2, 4))
        bolt = "loads: {{anchors: [{{block: high, at: [1, 3], force_kn: 5, {}}}]}}"
        for more, told in (
                ("loads: {pressures: [{block: hig, from: [2, 2], to: [2, 4], kpa: 3}]}", "no block is named 'hig'; did you mean 'high'?"),
                ("loads: {pressures: [{from: [2, 2], to: [2, 5], kpa: 3}]}", "lies on no straight face"),
                ("loads: {pressures: [{from: [2, 4], to: [2, 2], kpa: 3}]}", "lies on no straight face"),
                ("loads: {forces: [{at: [1, 2], direction_deg: 0, force_kn: 3}]}", "on the border of 'low' and 'high'"),
                ("loads: {forces: [{at: [1, 7], direction_deg: 0, force_kn: 3}]}", "lies in no block"),
                ("loads: {pressures: [{block: low, from: [2, 2], to: [2, 4], kpa: 3}]}", "does not act on an edge"),
                ("loads: {pressures: [{block: high, from: [2, 4], to: [2, 2], kpa: 3}]}", "would pull"),
                ("loads: {surcharges: [{block: high, from: [0, 3], to: [2, 3], kpa: 3}]}", "does not act on an edge"),
                ("loads: {forces: [{block: high, at: [3, 3], direction_deg: 0, force_kn: 3}]}", "'at' lies outside it"),
                ("loads: {forces: [{block: ground, at: [1, -1], direction_deg: 0, force_kn: 3}]}", "is ground"),
                ("loads: {forces: [{block: high, at: [1, 3], force_kn: 3}]}", "direction_deg"),
                (bolt.format("dip_deg: 60"), "say where this bolt holds"),
                (bolt.format("to: [1, 2.5]"), "lies within block 'high'"),
                (bolt.format("to: [1, 9]"), "ends where no block is"),
                (bolt.format("to: [1, 0]"), "on the border of 'ground' and 'low'"),
                (bolt.format("to: [1, 1], dip_deg: 9"), "leave out 'dip_deg'"),
                (bolt.format("direction_deg: -90, into: high"), "pull against each other"),
                (bolt.format("direction_deg: 90, into: ground"), "does not reach 'ground'"),
                (bolt.format("direction_deg: -90, length: 2, into: ground"), "ends outside it"),
                ("loads: {anchors: [{block: ground, at: [5, -1], to: [5, -2], force_kn: 5}]}", "lies within block 'ground'"),
                ("loads: {water: {height: 2}}", "'height' is of one block"),
                ("loads: {water: {level: 2, tension_crack: {level: 2}}}", "draw that up to where it stands in the crack"),
                ("loads: {water: {level: 2, ice_kpa: 150, ice_thickness: 0.5}}", "give the pressure of ice as 'pressures"),
                ("loads: {water: {uplift: full}}", "water needs"),
                ("loads: {water: {level: 1, uplift: triangular}}", "uplift: none"),
                ("loads: {water: {level: 1, faces: front}}", "'behind'"),
                ("loads: {water: {surface: [[1, 1], [5, 1]]}}", "reach past the left"),
                ("support: {block: low, at: [5, 1]}", "outside it"),
                ("support: {block: ground, at: [5, -1]}", "is ground"),
                ("support: {block: low}", "'at' is missing")):
            status, out, err = run("solve", self.scene(pile.scene(30, LEVEL + more)))
            self.assertEqual((status, out), (3, ""), more)
            self.assertIn(told, err)
            self.assertRegex(err, r"\.yaml:\d+:\d+: ")
        weightless = pile.scene(30, f"{LEVEL}loads: {{water: {{level: 1}}}}").replace("block: {unit_weight_kn_m3: 25}\n", "")
        self.assertIn("loads are weighed", run("solve", self.scene(weightless))[2])
        one = "topple: 1\nlength_unit: m\nblock: {slab: {width: 2, height: 4}, unit_weight_kn_m3: 25}\n"
        for more in ("loads: {forces: [{block: b, at: [1, 1], direction_deg: 0, force_kn: 2}]}", "support: {block: b, at: [0, 1]}",
                     "loads: {anchors: [{block: b, at: [1, 1], direction_deg: 0, force_kn: 2}]}",
                     "loads: {surcharges: [{block: b, from: [0, 4], to: [2, 4], kpa: 2}]}"):
            status, out, err = run("solve", self.scene(one + more + "\n"))
            self.assertEqual((status, out), (3, ""), more)
            self.assertIn("of a scene of many 'blocks'", err)


if __name__ == "__main__":
    main()
