#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Factors of solids on a few contact points that are proven in three dimensions, outside a section.

The story: rock_on_contacts.yaml had the factor that forces hold, 6.769, without a proof that no motion can begin before; then none but 1. Now
stretches of driving loads and of strengths are excluded. Compared with all modes of the contacts by a simplex method, with closed forms of
grooves, with mirror images, and with sections, of which a contact out of place makes none. The proof rounded centroid, inertia and load by
2^-50; now they are exact or within bounds."""

import json
import math
import random
import unittest
from fractions import Fraction

from harness import ROOT, main, rounds, run
from mesh_case import box
from solid_modes_by_glpk import IS_THERE, Modes
from test_solid_contacts import down
from test_solid_exclusion import inertia_of
from test_solid_scenes import SceneCase
from test_solids import exact_obj

ROCK = ROOT / "examples" / "solids"


def tangent(degrees):
    return math.tan(math.radians(degrees))


def drawn(draw, count=4):
    """A box on points about its lower half that face roughly inwards and upwards."""
    size, contacts, turn = [draw.choice((1, 2, 3)) for _ in range(3)], [], draw.uniform(0, 360)
    for k in range(count):
        angle = math.radians(turn + 360 * k / count + draw.uniform(-25, 25))
        lean, twist = draw.uniform(-0.2, 1), draw.uniform(-0.3, 0.3)
        at = [round(size[0] / 2 * math.cos(angle), 3), round(size[1] / 2 * math.sin(angle), 3), round(draw.uniform(0, 0.4) - size[2] / 2, 3)]
        normal = [round(-lean * math.cos(angle) + twist, 3), round(-lean * math.sin(angle) - twist, 3), 1]
        contacts.append({"at": at, "normal": normal, "friction_angle_deg": draw.randint(15, 45)})
    return size, contacts, draw.randint(3, 20), draw.randint(0, 359)


def moments_of(path):
    """Centroid and inertia over the mass of a mesh of triangles, in fractions."""
    points, faces = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append([Fraction(k) for k in rest[:3]])
        elif word == "f":
            faces.append([points[int(k.split("/")[0]) - 1] for k in rest])
    volume, first, second = Fraction(0), [Fraction(0)] * 3, [[Fraction(0)] * 3 for _ in range(3)]
    for p, q, r in faces:
        part = sum(p[i] * (q[(i + 1) % 3] * r[(i + 2) % 3] - q[(i + 2) % 3] * r[(i + 1) % 3]) for i in range(3))
        total = [sum(k) for k in zip(p, q, r)]
        volume += part / 6
        for i in range(3):
            first[i] += part * total[i] / 24
            for j in range(3):
                second[i][j] += part * (total[i] * total[j] + sum(v[i] * v[j] for v in (p, q, r))) / 120
    centroid = [k / volume for k in first]
    second = [[second[i][j] / volume - centroid[i] * centroid[j] for j in range(3)] for i in range(3)]
    trace = sum(second[k][k] for k in range(3))
    return [float(k) for k in centroid], [[float((trace if i == j else 0) - second[i][j]) for j in range(3)] for i in range(3)]


class Factors(SceneCase):
    def solved(self, size, contacts, tilt, azimuth, rest=""):
        half = [k / 2 for k in size]
        self.put("rock.obj", exact_obj(*box([-k for k in half], half)))
        listed = ", ".join("{" + ", ".join(f"{key}: {value}" for key, value in c.items()) + "}" for c in contacts)
        path = self.put("scene.yaml", f"topple: 1\nlength_unit: m\nsolid: {{file: rock.obj, unit: m, azimuths: 4, contacts: [{listed}]}}\n"
                                      f"tilt: {{angle_deg: {tilt!r}, azimuth_deg: {azimuth!r}}}\n{rest}")
        status, out, err = run("solve", "--json", path)
        self.assertIn(status, (0, 1, 4), err)
        return json.loads(out)

    def factors(self, *scene):
        """Verdict, and the bounds of each definition."""
        found = self.solved(*scene)["safety"]
        return found["motion"], {f["definition"]: (f.get("least", 0), f.get("most", math.inf)) for f in found["states"][0]["factors"]}

    # ---- all modes -----------------------------------------------------------------------------

    @unittest.skipUnless(IS_THERE, "GLPK is not installed")
    def test_all_modes(self):
        """Up to each factor that is proven no modes leave a motion: at it, and at numbers below."""
        draw, checked = random.Random(71), 0
        for _ in range(rounds(8, 300)):
            size, contacts, tilt, azimuth = drawn(draw, draw.choice((3, 4)))
            word, factors = self.factors(size, contacts, tilt, azimuth)
            if word != "none":
                continue
            for definition, (least, most) in factors.items():
                self.assertLessEqual(least, most)
                for number in (least, 1 + draw.random() * (least - 1)) if least >= 1 else ():
                    drives = definition == "driving loads"
                    x, y, z = down(tilt, azimuth)
                    load = [number * x, number * y, z] if drives else [x, y, z]
                    own = [(c["at"], c["normal"], tangent(c["friction_angle_deg"]) / (1 if drives else number)) for c in contacts]
                    self.assertEqual(Modes(inertia_of(size), own).most(load), 0, (size, contacts, tilt, azimuth, definition, number))
                    checked += 1
        self.assertGreater(checked, rounds(8, 300))

    @unittest.skipUnless(IS_THERE, "GLPK is not installed")
    def test_rock(self):
        """The rock of the example, its moments in fractions: no modes leave a motion up to 4.966 times the driving loads, and some do at 5.5;
        with a tenth of the friction none do. So 1.5 is met, 5.5 is open, and 6.8 is not met, as then no forces hold it."""
        centroid, inertia = moments_of(ROCK / "balanced_rock.obj")
        text = (ROCK / "rock_on_contacts.yaml").read_text(encoding="utf-8").replace("file: ", f"file: {ROCK}/")
        status, out, err = run("solve", "--json", self.put("scene.yaml", text + "required_fos: 1.5\n"))
        got = json.loads(out)
        self.assertEqual((status, got["safety"]["motion"], got["meets_required"]), (0, "none", "met"), err)
        given = (([-0.1, -0.2, 0.002], [0, 0, 1], 32), ([0.1, -0.25, 0.002], [0.1, 0, 1], 32), ([-0.3, 0.2, 0.002], [0, 0.2, 1], 32),
                 ([0.75, 0.1, 1.2], [-1, 0, 0.1], 20))
        x, y, z = down(5, 120)
        for number, divisor, moves in ((1, 1, False), (4.9660599, 1, False), (5.5, 1, True), (1, 10, False)):
            own = [([p - g for p, g in zip(at, centroid)], normal, tangent(phi) / divisor) for at, normal, phi in given]
            self.assertEqual(Modes(inertia, own).most([number * x, number * y, z]) > 0, moves, number)
        self.assertTrue(4.9 < got["safety"]["least"] < 5.5)
        for required, expected in ((5.5, 4), (6.8, 1)):
            self.assertEqual(run("solve", self.put("scene.yaml", text + f"required_fos: {required}\n"))[0], expected)

    @unittest.skipUnless(IS_THERE, "GLPK is not installed")
    def test_tilts_from_level(self):
        """No modes leave a motion at any tilt up to that which is certain: at it, and at tilts between it and level. Forces hold it farther."""
        draw, checked = random.Random(74), 0
        for _ in range(rounds(8, 300)):
            size, contacts, tilt, azimuth = drawn(draw, draw.choice((3, 4)))
            got = self.solved(size, contacts, tilt, azimuth)
            certain = got["contacts"].get("certain_to_stand_deg", 0)
            if "critical_deg" in got["contacts"]:
                self.assertLessEqual(certain, got["contacts"]["critical_deg"]["value"])
            self.assertTrue(certain < tilt or got["safety"]["motion"] == "none", (size, contacts, tilt, azimuth))
            own = [(c["at"], c["normal"], tangent(c["friction_angle_deg"])) for c in contacts]
            for angle in (certain, draw.random() * certain, 0) if certain else ():
                self.assertEqual(Modes(inertia_of(size), own).most(down(angle, azimuth)), 0, (size, contacts, azimuth, angle))
                checked += 1
        self.assertGreater(checked, rounds(6, 200))

    # ---- closed forms --------------------------------------------------------------------------

    def test_grooves_of_two_frictions(self):
        """A box in a groove of the half-angle eta, contacts at x = -l and l, h below its centroid, with two frictions: downhill along x the normal
        forces of the lower end grow by F h / l, so that tan = (mu1 + mu2) / 2 / (sin(eta) - (mu2 - mu1) h / (2 l)). What is proven ends there."""
        for eta, phi, height in ((60, (10, 40), 1), (60, (40, 10), 1), (75, (30, 20), 0.5), (50, (25, 25), 1)):
            s, c, (one, two) = math.sin(math.radians(eta)), math.cos(math.radians(eta)), map(tangent, phi)
            onset = (one + two) / 2 / (s - (two - one) * height / 6)
            contacts = [{"at": [x, side, -height], "normal": [0, -side * c, s], "friction_angle_deg": own}
                        for x, own in ((-3, phi[0]), (3, phi[1])) for side in (-1, 1)]
            for share in (0.5, 0.9):
                scene = [8, 2, 2], contacts, math.degrees(math.atan(share * onset)), 90
                word, factors = self.factors(*scene)
                certain = tangent(self.solved(*scene)["contacts"]["certain_to_stand_deg"])
                self.assertTrue(0.75 * onset < certain <= onset * (1 + 1e-12), (eta, phi, certain / onset))
                self.assertEqual(word, "none", (eta, phi))
                least, _ = factors["driving loads"]
                self.assertLessEqual(least, (1 + 1e-12) / share, (eta, phi, share))
                self.assertGreater(least, 0.9 / share, (eta, phi, share))
            word, _ = self.factors([8, 2, 2], contacts, math.degrees(math.atan(1.001 * onset)), 90)
            self.assertNotEqual(word, "none", (eta, phi))

    # ---- images --------------------------------------------------------------------------------

    def test_mirrored_and_turned(self):
        """Images of a scene have one truth, which the bounds of all of them hold: mirrored in x, and turned by the angle of 3, 4 and 5."""
        draw, stood = random.Random(72), 0
        for _ in range(rounds(6, 200)):
            size, contacts, tilt, azimuth = drawn(draw, 4)
            size[0] = size[1] = draw.choice((1, 2))
            ways = [lambda p: p, lambda p: [-p[0], p[1], p[2]], lambda p: [0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]]]
            azimuths = [azimuth, -azimuth % 360, (azimuth - math.degrees(math.atan2(4, 3))) % 360]
            found = []
            for way, own in zip(ways, azimuths):
                images = [dict(c, at=[round(k, 12) for k in way(c["at"])], normal=[round(k, 12) for k in way(c["normal"])]) for c in contacts]
                found.append(self.factors(size, images, tilt, own))
            words = {word for word, _ in found if word != "undecided"}
            self.assertLessEqual(len(words), 1, (size, contacts, tilt, azimuth))
            stood += "none" in words
            for definition in ("driving loads", "strength reduction"):
                bounds = [factors[definition] for _, factors in found if definition in factors]
                if bounds:
                    self.assertLessEqual(max(b[0] for b in bounds), min(b[1] for b in bounds) * (1 + 1e-6), (size, contacts, tilt, azimuth))
        self.assertGreater(stood, rounds(2, 60))

    def test_next_to_a_section(self):
        """Contacts in pairs across a section are decided in it; one that is out of place by 1e-7 leaves no section, and motions are excluded in
        three dimensions: no farther than those of the section begin, and mostly as far."""
        draw, near = random.Random(73), 0
        for _ in range(rounds(8, 200)):
            lean, rise, phi = draw.randint(2, 8) / 10, draw.choice((0, 0.2, 0.5)), draw.randint(20, 40)
            tilt, height = draw.randint(4, 15), draw.choice((1, 2))
            contacts = [{"at": [x, y, (rise if x > 0 else 0) - height / 2], "normal": [-lean if x > 0 else lean / 3, 0, 1], "friction_angle_deg": phi}
                        for x in (-1, 1) for y in (-1, 1)]
            scene = tilt, draw.choice((90, 270))
            word, inside = self.factors([2, 2, height], contacts, *scene)
            contacts[0]["at"][1] -= 1e-7
            other, outside = self.factors([2, 2, height], contacts, *scene)
            self.assertTrue(other in (word, "undecided"), (contacts, scene, word, other))
            for definition, (least, most) in outside.items():
                if definition in inside and other == "none":
                    self.assertLessEqual(least, inside[definition][1] * (1 + 1e-5), (contacts, scene, definition))
                    near += least > 0.9 * min(10, inside[definition][0])
        self.assertGreater(near, rounds(8, 200))


if __name__ == "__main__":
    main()
