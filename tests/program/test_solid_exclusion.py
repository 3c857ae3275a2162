#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""That no motion of a solid on a few contact points can begin, in three dimensions.

The story: forces can hold a rock on points that face different ways although nothing makes sure that they are there. Unless its contacts lay
in a section, or needed no friction, such a rock stayed undecided. Now all modes of its contacts are excluded, where that succeeds: compared
with closed forms of grooves, with bodies that are let go by an iteration that shares no code, and with blocks of the plane."""

import json
import math
import random
import unittest

from harness import main, rounds, run
from letting_go import Body
from mesh_case import box
from test_solid_contacts import down
from test_solid_scenes import SceneCase
from test_solids import exact_obj


def unit(v):
    size = math.sqrt(sum(k * k for k in v))
    return [k / size for k in v]


def inertia_of(size):
    x, y, z = (k * k / 12 for k in size)
    return [[y + z, 0, 0], [0, x + z, 0], [0, 0, x + y]]


class Exclusion(SceneCase):
    def put_box(self, size):
        half = [k / 2 for k in size]
        self.put("rock.obj", exact_obj(*box([-k for k in half], half)))

    def safety(self, contacts, rest):
        listed = ", ".join("{" + ", ".join(f"{key}: {value}" for key, value in c.items()) + "}" for c in contacts)
        path = self.put("scene.yaml", f"topple: 1\nlength_unit: m\nsolid: {{file: rock.obj, unit: m, azimuths: 4, contacts: [{listed}]}}\n{rest}")
        status, out, err = run("solve", "--json", path)
        self.assertIn(status, (0, 1, 4), err)
        return json.loads(out)["safety"]

    def test_grooves(self):
        """Along a groove of the half-angle eta a prism begins to slide at tan = tan(phi) / sin(eta), against friction alone; forces can hold
        it farther. Nothing is excluded beyond."""
        self.put_box((6, 2, 2))
        for eta, phi in ((60, 30), (45, 20), (70, 35)):
            s, c = math.sin(math.radians(eta)), math.cos(math.radians(eta))
            four = [{"at": [x, side, -1], "normal": [0, -side * c, s]} for x in (-3, 3) for side in (-1, 1)]
            onset = math.degrees(math.atan(math.tan(math.radians(phi)) / s))
            for tilt, expected in ((5, "none"), (0.9 * onset, "none"), (1.01 * onset, "undecided")):
                got = self.safety(four, f"friction_angle_deg: {phi}\ntilt: {{angle_deg: {tilt!r}, azimuth_deg: 90}}\n")
                self.assertEqual(got["motion"], expected, (eta, phi, tilt))
                factor = math.tan(math.radians(onset)) / math.tan(math.radians(tilt)) if expected == "none" else 0
                self.assertLessEqual(got.get("least", 0), factor * (1 + 1e-9))
                self.assertGreaterEqual(got.get("least", 0), 1 if factor > 1 else 0)

    def drawn(self, draw):
        """A box on three or four points about its lower half that face roughly inwards and upwards."""
        size = [draw.choice((1, 1.5, 2, 3)) for _ in range(3)]
        contacts = []
        turn = draw.uniform(0, 360)
        for k in range(draw.choice((3, 3, 4))):
            angle = math.radians(turn + 360 * k / 3.5 + draw.uniform(-25, 25))
            lean, twist = draw.uniform(-0.3, 1), draw.uniform(-0.3, 0.3)
            at = [round(size[0] / 2 * math.cos(angle), 3), round(size[1] / 2 * math.sin(angle), 3), round(-size[2] / 2 + draw.uniform(0, 0.4), 3)]
            normal = [round(-lean * math.cos(angle) + twist, 3), round(-lean * math.sin(angle) - twist, 3), 1]
            contacts.append({"at": at, "normal": normal, "friction_angle_deg": draw.randint(10, 45)})
        return size, contacts, draw.randint(3, 25), draw.randint(0, 359)

    def can_move(self, size, contacts, load, draw):
        """Let go from no forces, and from some of any size."""
        own = [(c["at"], unit(c["normal"]), math.tan(math.radians(c["friction_angle_deg"]))) for c in contacts]
        body = Body(inertia_of(size), own)
        found = []
        for k in range(4):
            start = [draw.gauss(0, 1) * 10 ** draw.uniform(-1, 1) for _ in range(body.count)] if k else None
            moved = body.let_go(load, start)
            if moved is not None:
                found.append(moved)
        return max(found) if found else None

    def factors_hold(self, factors, size, contacts, load, draw):
        """Nothing moves up to the factors that are proven: just below them, and between 1 and them."""
        for factor in factors:
            most = min(10, factor.get("least", 1))
            number = 1 + (most - 1) * draw.choice((0.999, draw.random()))
            if factor["definition"] == "driving loads":
                moved = self.can_move(size, contacts, [number * load[0], number * load[1], load[2]], draw)
            else:
                less = [dict(c, friction_angle_deg=math.degrees(math.atan(math.tan(math.radians(c["friction_angle_deg"])) / number)))
                        for c in contacts]
                moved = self.can_move(size, less, load, draw)
            self.assertTrue(moved is None or moved < 1e-7, (factor, number, size, contacts, load, moved))

    def test_let_go(self):
        """Where none can begin none is found; where none is found that is mostly proven."""
        draw, excluded, still, moving = random.Random(60), 0, 0, 0
        for _ in range(rounds(20, 400)):
            size, contacts, tilt, azimuth = self.drawn(draw)
            self.put_box(size)
            got = self.safety(contacts, f"tilt: {{angle_deg: {tilt}, azimuth_deg: {azimuth}}}\n")
            moved = self.can_move(size, contacts, down(tilt, azimuth), draw)
            if got["motion"] == "none":
                excluded += 1
                self.assertTrue(moved is None or moved < 1e-7, (size, contacts, tilt, azimuth, moved))
                self.factors_hold(got["states"][0]["factors"], size, contacts, down(tilt, azimuth), draw)
            if moved is not None:
                moving += moved > 1e-5
                still += moved < 1e-9
        self.assertGreater(moving, rounds(0, 50))
        self.assertGreater(excluded, 0.6 * still, (excluded, still))

    def test_on_a_plane(self):
        """Points of one direction: on one plane, where what forces hold stays, and at different heights, where it need not."""
        draw, words = random.Random(61), {}
        for _ in range(rounds(12, 240)):
            size = [draw.choice((1, 2, 3)), draw.choice((1, 2, 3)), draw.choice((1, 2, 4))]
            self.put_box(size)
            steps, phi = draw.choice((0, 0, 0.3)), draw.randint(10, 40)
            contacts = [{"at": [round(x * draw.uniform(0.2, 0.5) * size[0], 3), round(y * draw.uniform(0.2, 0.5) * size[1], 3),
                                round(-size[2] / 2 + draw.uniform(0, steps), 3)], "normal": [0, 0, 1], "friction_angle_deg": phi}
                        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            tilt, azimuth = draw.randint(3, 35), draw.randint(0, 359)
            if tilt == phi:  # a tie
                continue
            got = self.safety(contacts, f"tilt: {{angle_deg: {tilt}, azimuth_deg: {azimuth}}}\n")
            moved = self.can_move(size, contacts, down(tilt, azimuth), draw)
            words[got["motion"]] = words.get(got["motion"], 0) + 1
            self.assertTrue(got["motion"] != "none" or moved is None or moved < 1e-7, (size, contacts, tilt, azimuth, moved))
            self.assertTrue(got["motion"] != "collapses" or moved is None or moved > 1e-9, (size, contacts, tilt, azimuth, moved))
            self.assertTrue(steps or got["motion"] != "undecided", (size, contacts, tilt, azimuth))
        self.assertGreater(words.get("none", 0), rounds(2, 40))
        self.assertGreater(words.get("collapses", 0), rounds(1, 20))


if __name__ == "__main__":
    main()
