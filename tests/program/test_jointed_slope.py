# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Slopes that joint sets cut into blocks (docs/jointed_slope.md): held against columns, against cells cut here from polygons in
rationals, against Euler's formula, and in images; rock bridges, scatter, strength, names and what is refused."""

import fractions
import json
import math
import random

from governing_case import GoverningCase
from harness import ROOT, main, run

F = fractions.Fraction


def simplest(low, high):
    """The fraction of the least denominator within [low, high], by its continued fraction; for 0 <= low."""
    whole = low.numerator // low.denominator
    if whole == low:
        return F(whole)
    if whole + 1 <= high:
        return F(whole + 1)
    return whole + 1 / simplest(1 / (high - whole), 1 / (low - whole))


def direction(degrees):
    """Cosine and sine as the page states them: by a fraction near the tangent of half the angle."""
    t = F(math.tan(math.radians(abs(degrees)) / 2))
    t = simplest(max(t - F(1, 2 ** 34), F(0)), t + F(1, 2 ** 34)) * (1 if degrees >= 0 else -1)
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def normal_of(dip, left):
    """Of a joint, into the slope where it is steep, else up; the face dips to the left."""
    c, s = direction(dip if left else -dip)
    return (s, -c) if left and dip > 45 else (-s, c)


def area(ring):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1])) / 2


def split(ring, normal, offset):
    """A convex polygon cut by normal . p = offset: the pieces that are left, and the length cut in doubles."""
    sides = [normal[0] * x + normal[1] * y - offset for x, y in ring]
    pieces, ends = ([], []), []
    for k, (p, d) in enumerate(zip(ring, sides)):
        q, e = ring[(k + 1) % len(ring)], sides[(k + 1) % len(ring)]
        if d >= 0:
            pieces[0].append(p)
        if d <= 0:
            pieces[1].append(p)
        if d == 0:
            ends.append(p)
        if d * e < 0:
            at = tuple(a + (b - a) * d / (d - e) for a, b in zip(p, q))
            pieces[0].append(at)
            pieces[1].append(at)
            ends.append(at)
    if min(sides) >= 0 or max(sides) <= 0:
        return [ring], 0.0
    return list(pieces), math.dist(*[tuple(map(float, e)) for e in ends])


def wedge(face, height, base):
    """The rock between face, level upper ground and a plane through the toe."""
    c, s = direction(face)
    bc, bs = direction(base)
    return [(F(0), F(0)), (height * bc / bs, height), (height * c / s, height)]


def scene(joints, base="{dip_deg: 30}", more="", top="friction_angle_deg: 35\n", face="{dip_deg: 70, height: 20}", behind=80, unit="m", side="left"):
    sets = "".join(f"    - {{{joint}}}\n" for joint in joints)
    section = f"  face: {face}\n  behind: {behind}\n" if face else ""
    return (f"topple: 1\nlength_unit: {unit}\n{top}tilt: {{towards: {side}}}\nblock: {{unit_weight_kn_m3: 26}}\njointed_slope:\n{section}{more}"
            f"  joints:\n{sets}  base: {base}\n")


class JointedSlope(GoverningCase):
    def system(self, text, status=0):
        done, out, err = run("solve", "--json", self.scene(text))
        self.assertEqual(done, status, err)
        return json.loads(out)

    def areas(self, system, ground=False):
        return {b["name"]: b["area_m2"]["value"] for b in system["blocks"] if b["ground"] == ground}

    def length(self, system):
        return sum(math.dist(*[[c[f"{end}_{axis}_m"]["value"] for axis in "xy"] for end in ("from", "to")])
                   for c in system["contacts"])

    def names(self, text):
        return [b["name"] for b in self.system(text)["blocks"]]

    def test_columns(self):
        """A steep set through stepped ground is the columns of the slope of Goodman and Bray, turned by their dip: the same blocks,
        contacts and limits. The turn is that of a triangle of 3, 4 and 5, which the angles in degrees mean to the last digit."""
        rule = "{width: 10, step: 1, rise: 5, fall: 5, below_crest: 4, above_crest: 3}"
        dip = math.degrees(math.atan2(3, 4))
        columns = self.system("topple: 1\nlength_unit: m\nfriction_angle_deg: 38\nblock: {unit_weight_kn_m3: 26}\n"
                              f"slope: {{dip_deg: {dip!r}, towards: left}}\ncolumns: {rule}\n")
        tops = [4 * n if n <= 5 else 20 - 6 * (n - 5) for n in range(1, 9)]
        surface = [(-10, 0), (0, 0)]
        for n, top in enumerate(tops):
            surface += [(10 * n, n + top), (10 * n + 10, n + top)]
        surface += [(80, 6), (90, 6)]  # below the last tread, whose height is off by 1e-9 as the angle of the base is
        turned = ", ".join(f"[{F(4 * x - 3 * y, 5)}, {F(3 * x + 4 * y, 5)}]" for x, y in surface)
        base = math.degrees(math.atan2(3, 4) + math.atan2(1, 10))
        own = self.system(scene([f"dip_deg: {90 - dip!r}, towards: right, spacing: 10"],
                                base=f"{{dip_deg: {base!r}, steps: 1}}", top="friction_angle_deg: 38\n",
                                more=f"  surface: [{turned}]\n", face=""))
        self.assertEqual([b["name"] for b in own["blocks"]], ["ground"] + [f"B{n}" for n in range(1, 9)])
        for own_block, block in zip(own["blocks"][1:], columns["blocks"][1:]):
            self.assertAlmostEqual(own_block["area_m2"]["value"], block["area_m2"]["value"], delta=1e-6)
        self.assertEqual(len(own["contacts"]), len(columns["contacts"]))
        case, by = own["cases"][0], columns["cases"][0]
        for factor, other in ((case["fos"], by["fos"]), (case["goodman_bray"]["fos"], by["goodman_bray"]["fos"])):
            number, same = (f["value"] if isinstance(f, dict) and "value" in f else f for f in (factor, other))
            self.assertAlmostEqual(json_number(number), json_number(same), delta=1e-5)

    def test_cells(self):
        """Random sets of joints that run through, against a triangle that is cut by one line after another in rationals: as many
        blocks, the same areas, which sum to that of the rock above the base, and the same length of contacts; and their number is by
        Euler's formula one more than that of joints and of their crossings."""
        draw = random.Random(7)
        for _ in range(4):
            height, base = F(20), draw.randint(15, 40)
            sets = [(draw.randint(5, 85), draw.random() < 0.5, F(draw.randint(20, 60), 10), F(draw.randint(-9, 9), 7))
                    for _ in range(draw.randint(1, 3))]
            rock = wedge(70, height, base)
            lines = []
            for dip, left, spacing, offset in sets:
                normal = normal_of(dip, left)
                reach = [normal[0] * x + normal[1] * y for x, y in rock]
                lines += [(normal, offset + k * spacing) for k in range(math.ceil((min(reach) - offset) / spacing) - 1,
                                                                        math.floor((max(reach) - offset) / spacing) + 2)
                          if min(reach) < offset + k * spacing < max(reach)]
            cells, length = [rock], 0.0
            for normal, offset in lines:
                parts = [split(cell, normal, offset) for cell in cells]
                cells = [piece for pieces, _ in parts for piece in pieces]
                length += sum(cut for _, cut in parts)
            own = self.system(scene([f"dip_deg: {dip}, towards: {'left' if left else 'right'}, spacing: {spacing}, offset: {offset}"
                                     for dip, left, spacing, offset in sets], base=f"{{dip_deg: {base}}}"))
            areas = sorted(self.areas(own).values())
            self.assertEqual(len(areas), len(cells))
            for mine, cell in zip(areas, sorted(map(area, cells))):
                self.assertAlmostEqual(mine, float(cell), delta=1e-12 * 400)
            self.assertAlmostEqual(math.fsum(areas), float(area(rock)), delta=1e-10)
            sole = math.dist(*[tuple(map(float, p)) for p in rock[:2]])
            self.assertAlmostEqual(self.length(own), length + sole, delta=1e-9 * length)
            crossings = 0
            for k, (n, c) in enumerate(lines):
                for m, d in lines[:k]:
                    turn = n[0] * m[1] - n[1] * m[0]
                    if turn == 0:
                        continue
                    at = ((c * m[1] - d * n[1]) / turn, (d * n[0] - c * m[0]) / turn)
                    crossings += all((q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0]) > 0
                                     for p, q in zip(rock, rock[1:] + rock[:1]))
            self.assertEqual(len(cells), 1 + len(lines) + crossings)

    def test_images(self):
        """Mirrored, in other units and far from the origin it is the same slope: names, areas and factor."""
        joints = ["dip_deg: 65, towards: right, spacing: 5, friction_angle_deg: 30", "dip_deg: 20, towards: left, spacing: 8"]
        plain = self.system(scene(joints, base="{dip_deg: 32, steps: 1}"))
        mirrored = [j.replace("right", "LEFT").replace("left", "right").replace("LEFT", "left") for j in joints]
        images = (
            scene(mirrored, base="{dip_deg: 32, steps: 1}", more="  towards: right\n", side="right"),
            scene([j.replace("5,", "5000,").replace("8", "8000") for j in joints], base="{dip_deg: 32, steps: 1}", unit="mm",
                  face="{dip_deg: 70, height: 20000}", behind=80000
                  ).replace("dip_deg: 65000,", "dip_deg: 65,"),
            scene(joints, base="{dip_deg: 32, steps: 1}", more="  toe: [1e8, -3e7]\n"))
        for text in images:
            image = self.system(text)
            self.assertEqual([b["name"] for b in image["blocks"]], [b["name"] for b in plain["blocks"]])
            for name, value in self.areas(plain).items():
                self.assertAlmostEqual(self.areas(image)[name], value, delta=1e-9 * value)
            self.assertEqual(len(image["contacts"]), len(plain["contacts"]))
            self.assertAlmostEqual(fos(image), fos(plain), delta=2e-6 * fos(plain))

    def test_bridges(self):
        """Joints with bridges of rock leave blocks joined: all area is there still, the fewer blocks the less persistent they are,
        and as good as none of the set are those without it."""
        steep = "dip_deg: 70, towards: right, spacing: 4"
        flat = "dip_deg: 15, towards: left, spacing: 3"
        counts = []
        whole = None
        for share in (1, 0.7, 0.4, 1e-3):
            more = "" if share == 1 else f", persistence: {share}, length: 5"
            own = self.system(scene([steep, flat + more], more="  seed: 5\n", top="friction_angle_deg: 45\n"))
            counts.append(len(own["blocks"]))
            whole = whole or math.fsum(self.areas(own).values())
            self.assertAlmostEqual(math.fsum(self.areas(own).values()), whole, delta=1e-9)
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertGreater(counts[0], counts[1])
        alone = self.system(scene([steep], top="friction_angle_deg: 45\n"))
        self.assertEqual(sorted(self.areas(own).values()), sorted(self.areas(alone).values()))

    def test_motions(self):
        """Dips that scatter: corners are rounded, and joints cut into pieces by steps of the base. A block still slides along them, so that a
        motion can begin well before forces no longer hold the slope."""
        for seed, share in ((1, 0.98), (5, 0.99)):
            own = self.system(scene(["dip_deg: 70, towards: right, spacing: 2.5, scatter: {spacing: 0.3, dip_deg: 2}"],
                                    "{dip_deg: 25, steps: 1}", face="{dip_deg: 70, height: 12}", more=f"  seed: {seed}\n"))["cases"][0]
            self.assertLess(own["moving_fos"], share * own["fos"]["value"])
            self.assertLess(own["moving_angle_deg"], own["critical_angle_deg"]["value"])

    def test_scatter(self):
        """A seed is a sample, whatever else is asked; rounded corners still meet, so that what scatters by next to nothing has the
        contacts, the length of contact and the factor of what does not."""
        joints = ["dip_deg: 70, towards: right, spacing: 4, scatter: {spacing: S, dip_deg: D}",
                  "dip_deg: 15, towards: left, spacing: 6, scatter: {dip_deg: D}"]

        def text(spacing, dip, seed=3):
            return scene([j.replace("S", str(spacing)).replace("D", str(dip)) for j in joints], more=f"  seed: {seed}\n",
                         top="friction_angle_deg: 40\n")
        plain, hardly, much = self.system(text(0, 0)), self.system(text(0, "1e-6")), self.system(text(0.5, 5))
        self.assertEqual(plain["notes"], [])
        self.assertIn("corners of blocks were rounded", hardly["notes"][0]["text"])
        edges, same = (sum(not c["corner"] for c in s["contacts"]) for s in (hardly, plain))
        self.assertEqual(edges, same)
        self.assertAlmostEqual(self.length(hardly), self.length(plain), delta=1e-4)
        self.assertAlmostEqual(fos(hardly), fos(plain), delta=1e-4)
        self.assertAlmostEqual(math.fsum(self.areas(much).values()), math.fsum(self.areas(plain).values()), delta=1e-9)
        self.assertEqual(much, self.system(text(0.5, 5)))
        self.assertNotEqual(self.areas(much), self.areas(self.system(text(0.5, 5, seed=4))))

    def test_strength(self):
        """A contact has the strength of the set that made it, along the base that of the base, else the scene's; a joint between two
        blocks has its own before all of these."""
        joints = ["name: steep, dip_deg: 65, towards: right, spacing: 6, friction_angle_deg: 21, cohesion_kpa: 3",
                  "name: flat, dip_deg: 20, towards: left, spacing: 8, friction_angle_deg: 22, tension_kpa: 1"]
        text = scene(joints, base="{dip_deg: 32, steps: steep, friction_angle_deg: 23}", top="friction_angle_deg: 24\n")
        expected = {21: 65, 22: -20, 23: -25}
        contacts = self.system(text)["contacts"]
        self.assertEqual({c["friction_angle_deg"]["value"] for c in contacts}, set(expected))
        for c in contacts:
            run_x, run_y = (c[f"to_{axis}_m"]["value"] - c[f"from_{axis}_m"]["value"] for axis in "xy")
            dip = -math.degrees(math.atan(run_y / run_x))
            self.assertAlmostEqual(dip, expected[c["friction_angle_deg"]["value"]], delta=1e-6)
            self.assertEqual(c["cohesion_kpa"]["value"], 3 if c["friction_angle_deg"]["value"] == 21 else 0)
            self.assertEqual(c["tension_kpa"]["value"], 1 if c["friction_angle_deg"]["value"] == 22 else 0)
        ours = self.system(text + "joints: [{between: [B2-2, B3-2], friction_angle_deg: 9}]\n")["contacts"]
        own = [c for c in ours if {c["first"], c["second"]} == {"B2-2", "B3-2"}]
        self.assertEqual([(c["friction_angle_deg"]["value"], c["cohesion_kpa"]["value"]) for c in own], [(9, 3)])
        silent = text.replace("friction_angle_deg: 24\n", "")
        self.assertEqual(len(self.system(silent)["contacts"]), len(contacts))
        status, _, err = run("solve", self.scene(silent.replace(", friction_angle_deg: 22", "")))
        self.assertEqual(status, 3)
        self.assertIn("need a friction angle", err)

    def test_base_lines(self):
        """A failure surface by points; a bench that is cut off at an end is ground, and says so."""
        joints = ["dip_deg: 90, spacing: 5, offset: 1"]
        line = self.system(scene(joints, base="{line: [[0, 0], [12, 4], [20, 12], [24, 20]]}", top="friction_angle_deg: 50\n"))
        crest = 20 * float(direction(70)[0] / direction(70)[1])
        rock = [(0, 0), (12, 4), (20, 12), (24, 20), (crest, 20)]
        self.assertAlmostEqual(math.fsum(self.areas(line).values()), area(rock), delta=1e-9)
        short = self.system(scene(joints, base="{dip_deg: 5}", behind=21, top="friction_angle_deg: 50\n"))
        self.assertIn("where the rock goes on: 1;", short["notes"][0]["text"])

    def test_refusals(self):
        """Every slip is told with its place and what to do, before any block is cut."""
        joint = "dip_deg: 70, towards: right, spacing: 4"
        for text, told in (
                (scene([joint.replace("4", "4e-4"), "dip_deg: 10, towards: left, spacing: 4e-4"]), "up to 1.6e+10 pieces, and 100000"),
                (scene(["dip_deg: 0, spacing: 4"], base="{dip_deg: 0}", behind=20), "this slope has no blocks: all that"),
                (scene([joint], base="{dip_deg: 30, start: [2, 1]}"), "this slope has no blocks: joints and base cut nothing off"),
                (scene([joint + ", persistence: 0"]), "joints of persistence 0"),
                (scene([joint + ", persistence: 0.5"]), "'length: 6'"), (scene([joint + ", length: 4"]), "have no 'length'"),
                (scene([joint + ", persistence: 0.5, length: 4"]), "'seed: 1'"),
                (scene([joint + ", persistence: 1.5"]), "persistence"),
                (scene(["dip_deg: 70, spacing: 4"]), "'towards' is missing"), (scene(["dip_deg: 70, towards: up, spacing: 4"]), "left or right"),
                (scene(["dip_deg: 70, towards: right"]), "'spacing' is missing"),
                (scene([joint + ", scatter: {spacing: 1}"], more="  seed: 1\n"), "at most 0.9"),
                (scene([joint + ", scatter: {dip_deg: 50}"], more="  seed: 1\n"), "at most 45"),
                (scene([joint + ", dips: 3"]), "dips"), (scene([joint] * 9), "1 to 8 sets"),
                (scene([joint], base="{dip_deg: 30, steps: 2}"), "none is named '2'"),
                (scene([joint], base="{dip_deg: 30, tread_dip_deg: 3}"), "treads are of a base with 'steps'"),
                (scene([joint], base="{dip_deg: 30, line: [[0, 0], [1, 1]]}"), "leave out 'dip_deg'"),
                (scene([joint], base="{}"), "'dip_deg' is missing"),
                (scene(["dip_deg: 30, towards: left, spacing: 4"], base="{dip_deg: 30, steps: 1}"), "run along the base"),
                (scene([joint], face="{dip_deg: 0, height: 20}"), "above zero"),
                (scene([joint], more="  surface: [[0, 0], [1, 1]]\n"), "leave out 'face'"),
                (scene([joint], face="", more="  surface: [[0, 0], [-1, 1]]\n"), "from left to right"),
                (scene([joint], face="", more="  surface: [[0, 0], [9, 9], [9, 0], [3, 9], [12, 9]]\n"), "crosses or touches itself"),
                (scene([joint], more="  toe: [1, 2]\n") + "slope: {dip_deg: 3, towards: left}\n", "below the horizontal"),
                (scene([joint]) + "columns: {width: 1, heights: [1]}\n", "leave one out"),
                (scene([joint + ", offset: 1e9, scatter: {spacing: 0.1}"], more="  seed: 1\n"), "give an 'offset' near it")):
            status, out, err = run("solve", self.scene(text))
            self.assertEqual((status, out), (3, ""), (text, err))
            self.assertIn(told, err)
            self.assertRegex(err, r"\.yaml:\d+:\d+: ")


def json_number(value):
    return value["value"] if isinstance(value, dict) else value


def fos(system):
    return json_number(system["cases"][0]["fos"])


if __name__ == "__main__":
    main()
