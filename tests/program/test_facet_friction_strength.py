# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Facets with frictions of their own under cohesion, bonds and loads that do not turn with the tilt: the onset against
trial of every contact mode (onset_strength_oracle.py), the limit against all pairs of forces in floats
(limit_forces.py). TOPPLE_ROUNDS multiplies the number of rounds."""

import math
import random
import unittest
from fractions import Fraction

import exact
from facet_scenes import angle_text, besides, draw_tangents, friction_text, pieces, rough_contacts, spans
from harness import ROUNDS, main, rounds
from limit_forces import Base, wrench
from limit_scenes import Scene, dropped, mated_polygon, mated_teeth, mirrored, worn_profile
from onset_case import rough_tangent
from onset_oracle import gyration
from onset_strength_oracle import StrongOnset

MOST_POINTS = 6
GAMMA = 26


class OwnOnset(StrongOnset):
    """`rough`: ((x, y), t, tan(phi)), `beside` with its sense; `ends`: (p, q, t, tan(phi)) of facets. A contact
    point is told from another at its place by its friction too."""

    def __init__(self, rough, beside, centroid, gyration_square, ends, sheared, bonded):
        places = [(p, t) for p, t, _ in rough] + [(p, t) for p, t, _, _ in beside]
        self.senses = [0] * len(rough) + [sense for _, _, _, sense in beside]
        super().__init__(places, centroid, gyration_square, [own for _, _, own in rough] + [own for _, _, own, _ in beside],
                         [(p, q, t) for p, q, t, _ in ends], sheared, bonded)
        for index, (p, q, t, own) in enumerate(ends):
            facet = self.facets[index]
            self.facets[index] = (facet[0], [rough.index((end, t, own)) for end in (p, q)], *facet[2:])


class Strength(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()
        self.addCleanup(self.scene.folder.cleanup)

    def draw(self):
        """A block with cohesion, with or without a bond, and its contact; the shear and the pull are shares of what the
        weight presses with."""
        while True:
            make = random.choice([mated_polygon, mated_teeth, worn_profile, dropped, pieces, pieces])
            block, base, outline, profile = make()
            scene, tangents, entries = draw_tangents(block, base, profile, make, rough_tangent)
            ends = spans(outline, profile, tangents)
            points = len(rough_contacts(outline, profile, tangents)) + len(besides(outline, profile, tangents))
            if entries and ends and points <= MOST_POINTS:
                break
        area = exact.ring_moments(outline)[0]
        stress = GAMMA * area / sum(abs(q[0] - p[0]) + abs(q[1] - p[1]) for p, q, _, _ in ends)
        shear, bond = (Fraction(round(float(stress * share), 4)).limit_denominator(10000)
                       for share in (Fraction(random.randint(1, 60), 100),
                                     Fraction(random.choice([0, 0, random.randint(1, 40)]), 100)))
        cases = self.scene.solve(block, base, angle_text(scene), friction_text(entries) +
                                 f"loads: {{cohesion_kpa: {shear}, bond_kpa: {bond}}}\n")
        for side, case in cases.items():
            own, under, rough = (outline, profile, tangents) if side == "left" else (
                mirrored(outline), mirrored(profile), tangents[::-1])
            centroid = exact.centroid(exact.block_moments(own))
            yield side, case, OwnOnset(rough_contacts(own, under, rough), besides(own, under, rough), centroid,
                                       gyration(own, centroid), spans(own, under, rough), shear / (GAMMA * area), bond / (GAMMA * area))

    def compare(self, case, trial):
        """No mode can begin below the onset; just above some mode can, or the onset is the limit."""
        onset, limit = case["onset"], case["limit"]["critical_angle_deg"]
        if onset["kind"] == "nowhere":
            return
        end = onset["critical_angle_deg"]["value"] if onset["kind"] == "angle" else 89.9
        if end <= 0:
            return
        for tilt in (end - 1e-6, end * random.random()):
            self.assertIsNone(trial.can_begin(Fraction(math.tan(math.radians(tilt) / 2))), tilt)
        if onset["kind"] == "angle" and (limit is None or abs(limit["value"] - end) > 1e-9):
            self.above += 1
            above = Fraction(math.tan(math.radians(end + 1e-6) / 2))
            self.assertIsNotNone(trial.can_begin(above, "found"), end)

    def test_onset(self):
        random.seed(181)
        self.above = 0
        for _ in range(rounds(6, 20) * ROUNDS):
            for side, case, trial in self.draw():
                with self.subTest(scene=self.scene.text, side=side):
                    self.assertNotEqual(case["onset"]["kind"], "undecided")
                    self.compare(case, trial)
        self.assertGreater(self.above, rounds(1, 3))

    def test_limit(self):
        """Slopes in pieces with an anchor: the tilts that hold, and those with all strength divided by the factor."""
        random.seed(182)
        compared = 0
        for _ in range(30 * ROUNDS):
            block, base, outline, profile = pieces()
            frictions = [random.choice([0, 20, 35, 50]) for _ in profile[1:]]
            area, weight = float(exact.ring_moments(outline)[0]), float(GAMMA * exact.ring_moments(outline)[0])
            cohesion, bond = round(random.random() * area, 3), round(random.choice([0, random.random()]) * area, 3)
            pull, at = round(weight * random.random() / 2, 3), outline[-1]
            entries = "".join(f"  - {{facet: {k + 1}, angle_deg: {phi}}}\n" for k, phi in enumerate(frictions))
            case = self.scene.solve(
                block, base, 30, f"friction:\n  facets:\n{entries}"
                f"loads:\n  cohesion_kpa: {cohesion}\n  bond_kpa: {bond}\n"
                f"  anchors: [{{at: [{at[0]}, {at[1]}], direction_deg: -90, force_kn: {pull}}}]\n",
                ", angle_deg: 10")["left"]
            gx, gy = (float(g) for g in exact.centroid(exact.block_moments(outline)))
            loads = (wrench((gx, gy), (0, -weight)), wrench((gx, gy), (-weight, 0)),
                     wrench([float(x) for x in at], (0, -pull)))
            facets = [tuple(tuple(float(x) for x in p) for p in ends) for ends in zip(profile, profile[1:])]
            held = Base(facets, frictions, cohesion, bond).intervals(*loads)
            with self.subTest(scene=self.scene.text):
                own = next((ends for ends in held if ends[0] <= 0 <= ends[1]), None)
                found = case["limit"]["critical_angle_deg"]
                if own is None or found is None:
                    continue
                compared += 1
                self.assertAlmostEqual(found["value"], own[1], delta=1e-6)
                fos = case["limit"]["fos"]
                if isinstance(fos, dict) and own[1] > 10:
                    for factor, holds in ((fos["value"] * (1 - 1e-6), True), (fos["value"] * (1 + 1e-6), False)):
                        less = [math.degrees(math.atan(math.tan(math.radians(phi)) / factor)) for phi in frictions]
                        reduced = Base(facets, less, cohesion / factor, bond / factor).intervals(*loads)
                        self.assertEqual(any(a <= 10 <= b for a, b in reduced), holds, factor)
        self.assertGreater(compared, 15)


if __name__ == "__main__":
    main()
