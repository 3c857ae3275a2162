#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A wedge between two joints: the closed form and the printed example of Hoek and Bray (Rock Slope Engineering, 3rd ed. 1981),
and wedges by chance, with cracks and water, as the polyhedron that all half-spaces have in common."""

import itertools
import json
import math
import random
import unittest

from harness import main, run
from test_solids import Case
from test_solid_contacts import add, cross, dot, times

HOEK_BRAY = "examples/solids/wedge.yaml"
RAD = math.radians


def normal(dip, towards):
    return [math.sin(RAD(dip)) * math.sin(RAD(towards)), math.sin(RAD(dip)) * math.cos(RAD(towards)), math.cos(RAD(dip))]


def meet(planes):
    """The point on three planes (n, d), n . x = d."""
    (a, p), (b, q), (c, r) = planes
    det = dot(a, cross(b, c))
    return None if abs(det) < 1e-12 else times(1 / det, add(add(times(p, cross(b, c)), times(q, cross(c, a))), times(r, cross(a, b))))


class Polyhedron:
    """All x with n . x <= d of each."""

    def __init__(self, planes):
        corners = {k: [] for k in range(len(planes))}
        for some in itertools.combinations(range(len(planes)), 3):
            x = meet([planes[k] for k in some])
            if x is not None and all(dot(n, x) <= d + 1e-7 for n, d in planes):
                for k in some:
                    corners[k].append(x)
        self.areas = [self.area(planes[k][0], corners[k]) for k in range(len(planes))]
        self.volume = sum(d * area for (_, d), area in zip(planes, self.areas)) / 3  # unit normals

    @staticmethod
    def area(n, corners):
        if len(corners) < 3:
            return 0
        middle = times(1 / len(corners), [sum(c[k] for c in corners) for k in range(3)])
        side = cross(n, [n[1], n[2], -n[0]])
        angle = lambda x: math.atan2(dot(cross(n, side), add(x, times(-1, middle))), dot(side, add(x, times(-1, middle))))
        ring = sorted(corners, key=angle)
        total = [0, 0, 0]
        for p, q in zip(ring, ring[1:] + ring[:1]):
            total = add(total, cross(add(p, times(-1, middle)), add(q, times(-1, middle))))
        return math.sqrt(dot(total, total)) / 2


def oracle(a, b, face, upper, height, strength, unit_weight, water=0, crack=None, quake=(0, 0, 0)):
    """(factor, on which) by trying each way of sliding; None where the planes enclose no wedge."""
    na, nb, nf, nu = (normal(*p) for p in (a, b, face, upper))
    line = cross(na, nb)
    line = times(math.copysign(1, line[2]) / math.sqrt(dot(line, line)), line)
    top = times(height / line[2], line)
    planes = [(times(-1, na), 0), (times(-1, nb), 0), (nf, 0), (nu, dot(nu, top))]
    pressure = water * height / 6
    if crack:
        end = meet([(na, 0), (nf, 0), (nu, dot(nu, top))])
        way = add(top, times(-1, end))
        at = add(end, times(crack[2] / math.sqrt(dot(way, way)), way))
        nc = normal(*crack[:2])
        nc = times(math.copysign(1, dot(nc, at)), nc)
        planes.append((nc, dot(nc, at)))
        deep = times(dot(nc, at) / dot(nc, line), line)
        pressure = water * (dot(nu, top) - dot(nu, deep)) / nu[2] / 3
    own = Polyhedron(planes)
    share, towards, up = quake
    push = times(unit_weight * own.volume, [share * math.sin(RAD(towards)), share * math.cos(RAD(towards)), up - 1])
    for (n, _), area, wet in zip(planes, own.areas, (1, 1, 0, 0, 1)):
        push = add(push, times(-pressure * area * wet, n))
    k = dot(na, nb)
    on = [(-dot(push, p) + k * dot(push, q)) / (1 - k * k) for p, q in ((na, nb), (nb, na))]
    if min(on) >= 0:
        return sum(c * area + n * math.tan(RAD(phi)) for (phi, c), area, n in zip(strength, own.areas, on)) / abs(dot(push, line)), "a and b", own
    for name, p, q, (phi, c), area in (("a", na, nb, strength[0], own.areas[0]), ("b", nb, na, strength[1], own.areas[1])):
        pressed = -dot(push, p)
        slide = add(push, times(pressed, p))
        if pressed > 0 and dot(slide, q) > 0:
            return (c * area + pressed * math.tan(RAD(phi))) / math.sqrt(dot(slide, slide)), name, own
    return 0, "neither", own


class Wedges(Case):
    def scene(self, a, b, face, upper, height, strength, unit_weight, water=0, crack=None):
        joint = lambda p, s: f"{{dip_deg: {p[0]}, dip_direction_deg: {p[1]}, friction_angle_deg: {s[0]}, cohesion_kpa: {s[1]}}}"
        plane = lambda p: f"{{dip_deg: {p[0]}, dip_direction_deg: {p[1]}}}"
        return self.put("wedge.yaml", f"topple: 1\nlength_unit: m\nsolid:\n  unit_weight_kn_m3: {unit_weight}\n  wedge:\n    height: {height}\n"
                                      f"    a: {joint(a, strength[0])}\n    b: {joint(b, strength[1])}\n    face: {plane(face)}\n"
                                      f"    upper: {plane(upper)}\n"
                                      + (f"    water: {{unit_weight_kn_m3: {water}}}\n" if water else "")
                                      + (f"    crack: {{dip_deg: {crack[0]}, dip_direction_deg: {crack[1]}, distance: {crack[2]}}}\n" if crack else ""))

    def test_hoek_and_bray(self):
        """They print 1.36, of angles read off a stereonet to whole degrees: so does their formula with those; ours has the angles
        themselves. In other units, and mirrored, the same."""
        s, c, t = (lambda d, f=f: f(RAD(d)) for f in (math.sin, math.cos, math.tan))
        x, y = s(65) / (s(25) * c(50)), s(62) / (s(31) * c(60))
        a, b = ((c(p) - c(q) * c(101)) / (s(31.2) * s(101) ** 2) for p, q in ((45, 70), (70, 45)))
        printed = 3 / (160 * 130) * (500 * x + 1000 * y) + (a - 62.5 / 320 * x) * t(30) + (b - 62.5 / 320 * y) * t(20)
        self.assertEqual(f"{printed:.2f}", "1.36")
        status, out, err = run("solve", "--json", HOEK_BRAY)
        self.assertEqual(status, 0, err)
        got = json.loads(out)["wedge"]
        feet = (45, 105), (70, 235), (65, 185), (12, 195), 130, ((30, 500), (20, 1000)), 160, 62.5
        factor, on, _ = oracle(*feet)
        self.assertEqual((got["slides_on"], got["verdict"], on), ("a and b", "stands", "a and b"))
        self.assertAlmostEqual(got["fos"]["value"], factor, 6)
        self.assertLess(abs(got["fos"]["value"] - printed), 0.02)
        self.assertAlmostEqual(got["plunge_deg"]["value"], 31.2, 1)
        self.assertAlmostEqual(got["trend_deg"]["value"], 157.73, 2)
        mirrored = json.loads(run("solve", "--json", self.scene((45, 255), (70, 125), (65, 175), (12, 165), 130, ((30, 500), (20, 1000)), 160, 62.5))[1])
        self.assertAlmostEqual(mirrored["wedge"]["fos"]["value"], factor, 12)

    def test_wedges_by_chance(self):
        """With water and cracks: volume, areas and factor of those that the program takes; that it takes those that there are."""
        draw, seen = random.Random(5), {}
        for k in range(14):
            a, b = (draw.randint(35, 80), draw.randint(100, 170)), (draw.randint(35, 80), draw.randint(190, 260))
            face, upper = (draw.randint(70, 89), draw.randint(165, 195)), (draw.randint(0, 15), draw.randint(170, 190))
            height, water = draw.randint(5, 40), 9.81 * (k % 2) * (1 + 3 * (k % 3))
            crack = (draw.randint(60, 90), 180, height / 20) if k % 3 == 2 else None
            own = a, b, face, upper, height, ((draw.randint(10, 45), draw.randint(0, 30)), (draw.randint(10, 45), 0)), 26, water, crack
            status, out, err = run("solve", "--json", self.scene(*own))
            if status != 0:
                seen["refused"] = seen.get("refused", 0) + 1
                self.assertEqual(status, 3, err)
                continue
            got = json.loads(out)
            factor, on, shape = oracle(*own)
            self.assertEqual(got["wedge"]["slides_on"], on)
            self.assertAlmostEqual(got["volume_m3"]["value"] / shape.volume, 1, 9)
            for own_area, area in zip(got["wedge"]["areas_m2"], shape.areas):
                self.assertAlmostEqual(own_area["value"] / area, 1, 9)
            self.assertAlmostEqual(got["wedge"]["fos"]["value"], factor, 9)
            self.assertEqual(got["wedge"]["verdict"], "leaves its base" if on == "neither" else "stands" if factor > 1 else "slides")
            seen[on] = seen.get(on, 0) + 1
        self.assertGreater(seen.get("a and b", 0), 2, seen)

    def test_earthquakes(self):
        """Towards any azimuth, with a vertical share, dry and with water: by the oracle; hard into the slope it slides up the line; mirrored."""
        draw, seen = random.Random(2), set()
        own = [(45, 105), (70, 235), (65, 185), (12, 195), 40, ((30, 24), (20, 48)), 25]
        for share, towards, up, water in ((0, 0, 0, 0), (0.15, 158, 0, 9.81), (0.3, 158, -0.1, 0), (0.4, 20, 0.2, 0), (2.5, 338, 0, 0), (2.5, 338, 0, 9.81),
                                          *((draw.uniform(0, 1), draw.randint(0, 359), draw.uniform(-0.3, 0.3), 0) for _ in range(8))):
            path = self.scene(*own, water)
            with open(path, "a", encoding="utf-8") as out:
                out.write(f"loads: {{seismic: {{horizontal: {share!r}, vertical: {up!r}, azimuth_deg: {towards}}}}}\n")
            status, out, err = run("solve", "--json", path)
            self.assertEqual(status, 0, err)
            got = json.loads(out)["wedge"]
            factor, on, _ = oracle(*own, water, None, (share, towards, up))
            self.assertEqual(got["slides_on"], on)
            self.assertAlmostEqual(got["fos"]["value"] / max(factor, 1e-9) if factor else 1, 1, 9)
            self.assertEqual(got["verdict"], "leaves its base" if on == "neither" else "stands" if factor > 1 else "slides")
            seen.add((on, got["driving_n"]["value"] < 0))
            mirror = lambda p: (p[0], (360 - p[1]) % 360)
            path = self.scene(*map(mirror, own[:4]), *own[4:], water)
            with open(path, "a", encoding="utf-8") as out:
                out.write(f"loads: {{seismic: {{horizontal: {share!r}, vertical: {up!r}, azimuth_deg: {(360 - towards) % 360}}}}}\n")
            self.assertAlmostEqual(json.loads(run("solve", "--json", path)[1])["wedge"]["fos"]["value"], got["fos"]["value"], 9)
        self.assertIn(("a and b", False), seen)
        self.assertGreater(len(seen), 1, seen)
        with open(self.scene(*own), "a", encoding="utf-8") as out:
            out.write("loads: {seismic: {horizontal: 0.1}}\n")
        status, out, err = run("solve", out.name)
        self.assertEqual((status, out), (3, ""))
        self.assertIn("a wedge is shaken one way", err)

    def test_refusals_and_rows(self):
        own = [(45, 105), (70, 235), (65, 185), (12, 195), 40, ((30, 24), (20, 48)), 25]
        told = {0: ((54, 221), "below the crest"), 2: ((25, 185), "does not come out of the face"), 3: ((50, 195), "does not rise to the ground")}
        for at, (plane, words) in told.items():
            changed = list(own)
            changed[at] = plane
            status, out, err = run("solve", self.scene(*changed))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(words, err)
        for more, words in (("tilt: {angle_deg: 3}\n", "leave out 'tilt'"), ("friction_angle_deg: 3\n", "leave out 'friction_angle_deg'")):
            with open(self.scene(*own), "a", encoding="utf-8") as out:
                out.write(more)
            self.assertIn(words, run("solve", out.name)[2])
        path = self.scene(*own, 0, (70, 165, 1000))
        self.assertIn("the crack does not cut the wedge", run("solve", path)[2])
        status, out, err = run("solve", "--csv", "--set", "solid.wedge.height=20", self.scene(*own))
        self.assertEqual(status, 0, err)
        row = dict(zip(*(line.split(",") for line in out.splitlines())))
        changed = list(own)
        changed[4] = 20
        self.assertAlmostEqual(float(row["fos"]), oracle(*changed)[0], 9)

    def test_a_study_is_of_the_wedge_as_it_lies(self):
        """No table is tilted; of 64 strata of a joint's friction those slide whose factor by the closed form is below 1."""
        own = [(45, 105), (70, 235), (65, 185), (12, 195), 40, ((30, 24), (20, 48)), 25, 9.81]
        with open(f"{self.scene(*own)}_study.yaml", "w", encoding="utf-8") as study:
            study.write(f"topple_study: 1\nscene: {self.scene(*own)}\nsamples: 64\n"
                        "vary: {solid.wedge.a.friction_angle_deg: {uniform: {low: 1, high: 33}}}\n")
        status, out, err = run("study", study.name)
        self.assertEqual(status, 0, err)
        self.assertIn("\nAs it lies\n", out)
        self.assertNotIn("as the table is tilted", out)
        self.assertIn("by the assumptions of Hoek and Bray", out)  # as "certain to stand" is said by them alone
        factors = [oracle(*own[:5], ((1.25 + k / 2, 24), (20, 48)), *own[6:])[0] for k in range(64)]
        counted = int(next(line.split()[1] for line in out.splitlines() if line.startswith("  slides  ")))
        self.assertAlmostEqual(counted, sum(factor < 1 for factor in factors), delta=1)  # one stratum has both
        self.assertTrue(0 < counted < 64)


if __name__ == "__main__":
    main()
