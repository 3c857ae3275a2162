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


def oracle(*wedge, quake=(0, 0, 0)):
    """(factor, on which, shape) by trying each way of sliding."""
    own = Forces(*wedge)
    return *own.factor(*quake), own.shape


class Forces:
    """Of a wedge as all half-spaces have it in common: its weight, the water's push, and its factor under an earthquake."""

    def __init__(self, a, b, face, upper, height, strength, unit_weight, water=0, crack=None, *quake):
        assert not any(quake)
        self.set_shape(a, b, face, upper, height, unit_weight, water, crack)
        self.strength, self.bolts = strength, [0, 0, 0]

    def pull(self, force, azimuth, dip):
        """One more bolt."""
        self.bolts = add(self.bolts, times(force, [math.cos(RAD(dip)) * math.sin(RAD(azimuth)), math.cos(RAD(dip)) * math.cos(RAD(azimuth)), -math.sin(RAD(dip))]))
        return self

    def set_shape(self, a, b, face, upper, height, unit_weight, water, crack):
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
        self.normals, self.line, self.shape, self.weight = (na, nb), line, own, unit_weight * own.volume
        self.water = [0, 0, 0]
        for (n, _), area, wet in zip(planes, own.areas, (1, 1, 0, 0, 1)):
            self.water = add(self.water, times(-pressure * area * wet, n))

    def push(self, share, towards, up):
        return add(add(self.water, self.bolts), times(self.weight, [share * math.sin(RAD(towards)), share * math.cos(RAD(towards)), up - 1]))

    def factor(self, share, towards, up):
        """(factor, on which)"""
        (na, nb), push, areas, strength = self.normals, self.push(share, towards, up), self.shape.areas, self.strength
        k = dot(na, nb)
        on = [(-dot(push, p) + k * dot(push, q)) / (1 - k * k) for p, q in ((na, nb), (nb, na))]
        if min(on) >= 0:
            return sum(c * area + n * math.tan(RAD(phi)) for (phi, c), area, n in zip(strength, areas, on)) / abs(dot(push, self.line)), "a and b"
        for name, p, q, (phi, c), area in (("a", na, nb, strength[0], areas[0]), ("b", nb, na, strength[1], areas[1])):
            pressed = -dot(push, p)
            slide = add(push, times(pressed, p))
            if pressed > 0 and dot(slide, q) > 0:
                return (c * area + pressed * math.tan(RAD(phi))) / math.sqrt(dot(slide, slide)), name
        return 0, "neither"

    def turn(self, share, up, count=3600):
        """The factor and the way at so many azimuths; the least, and how far it can be above that of all azimuths: what it changes
        by to the next on the same way, on either side."""
        all_of = [self.factor(share, 360 * k / count, up) for k in range(count)]
        at = min(range(count), key=lambda k: all_of[k][0])
        beside = [abs(all_of[k % count][0] - all_of[(k + 1) % count][0]) for k in range(at - 6, at + 6) if all_of[k % count][1] == all_of[(k + 1) % count][1] == all_of[at][1]]
        return all_of, all_of[at][0], max(beside, default=0)


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
            factor, on, _ = oracle(*own, water, quake=(share, towards, up))
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

    WEDGES = (
        ((45, 105), (70, 235), (65, 185), (12, 195), 40, ((30, 24), (20, 48)), 25, 9.81),  # of Hoek and Bray, in metres
        ((45, 105), (70, 235), (65, 185), (12, 195), 40, ((30, 24), (20, 48)), 25, 0),
        ((45, 105), (70, 235), (65, 185), (12, 195), 40, ((38, 0), (33, 0)), 25, 0),  # friction alone
        ((52, 130), (48, 228), (75, 178), (5, 181), 22, ((41, 5), (33, 120)), 26, 0),  # loses much as it leaves B
        ((52, 130), (48, 228), (75, 178), (5, 181), 22, ((33, 120), (41, 5)), 26, 2, (80, 180, 4)),
    )

    def solved(self, own, quake="", bolts=(), required=0):
        path = self.scene(*own)
        loads = [f"seismic: {{{quake}}}"] if quake else []
        told = ", ".join(f"{{force_kn: {force!r}, azimuth_deg: {azimuth!r}, dip_deg: {dip!r}}}" for force, azimuth, dip in bolts)
        loads += [f"anchors: [{told}]"] if bolts else []
        with open(path, "a", encoding="utf-8") as out:
            out.write(f"loads: {{{', '.join(loads)}}}\n" if loads else "")
            out.write(f"required_fos: {required}\n" if required else "")
        status, out, err = run("solve", "--json", path)
        self.assertIn(status, (0, 1, 4) if required else (0,), err)  # 4: the least force gives the factor to its last digit
        return json.loads(out)["wedge"]

    def test_worst_azimuth(self):
        """Without an azimuth an earthquake comes from the worst: the least of 3600 by brute force, which is above it by no more than
        it changes by from one of them to the next; on both joints, on one, and lifted off; so without the azimuth never safer than with it."""
        seen = set()
        for own, (share, up) in itertools.product(self.WEDGES, ((0.05, 0), (0.3, -0.1), (0.6, 0.1), (2.5, 0))):
            got, forces = self.solved(own, f"horizontal: {share}, vertical: {up}"), Forces(*own)
            all_of, least, step = forces.turn(share, up)
            self.assertLessEqual(got["fos"]["value"] - got["fos"]["error"], least * (1 + 1e-12))
            self.assertGreaterEqual(got["fos"]["value"], least - step - 1e-12)
            self.assertLessEqual(got["fos"]["error"], 1e-12 * got["fos"]["value"])
            self.assertEqual((got["fos"], got["azimuth_deg"], got["slides_on"]), (got["worst_fos"], got["worst_azimuth_deg"], got["worst_slides_on"]))
            self.assertAlmostEqual(forces.factor(share, got["azimuth_deg"], up)[0], got["fos"]["value"], 6)
            self.assertEqual(got["verdict"], "leaves its base" if got["slides_on"] == "neither" else "stands" if got["fos"]["value"] > 1 else "slides")
            seen.add(got["slides_on"])
            for way in got["azimuths"]:  # 72 of them
                factor, on = all_of[round(10 * way["azimuth_deg"])]
                if factor > 1e12:  # pressed straight into a joint
                    self.assertNotIn("fos", way)
                    continue
                self.assertEqual(way["slides_on"], on)
                self.assertAlmostEqual(way["fos"]["value"] / max(factor, 1), min(factor, 1), 9)
        self.assertEqual(seen, {"a and b", "a", "b", "neither"})

    def test_least_acceleration(self):
        """No horizontal acceleration below it brings the factor to 1, from any of 720 azimuths; at its own azimuth just more does.
        Towards each azimuth likewise: below the factor is above 1, and there it is 1, or falls below."""
        seen = set()
        for own, up in itertools.product(self.WEDGES, (0, 0.15)):
            got, forces = self.solved(own, f"vertical: {up}"), Forces(*own)
            if forces.factor(0, 0, up)[0] < 1:
                self.assertNotIn("acceleration_g", got)
                continue
            least, error = got["acceleration_g"]["value"], got["acceleration_g"]["error"]
            self.assertLessEqual(error, 1e-12 * least)
            for k in range(720):
                for part in (0.4, 0.9, 1 - 1e-9):
                    self.assertGreater(forces.factor(part * least, k / 2, up)[0], 1)
            self.assertLess(forces.factor((1 + 1e-9) * least, got["acceleration_azimuth_deg"], up)[0], 1 + 1e-9)
            self.assertLess(forces.factor((1 + 1e-6) * least, got["acceleration_azimuth_deg"], up)[0], 1)
            seen.add(got["acceleration_slides_on"])
            for way in got["azimuths"]:
                at = way["acceleration_g"]["value"] if "acceleration_g" in way else 1e6
                self.assertGreaterEqual(at, least - error)
                for part in (0.3, 0.99, 1 - 1e-9):
                    self.assertGreater(forces.factor(part * at, way["azimuth_deg"], up)[0], 1)
                if "acceleration_g" in way:
                    self.assertLess(forces.factor((1 + 1e-9) * at, way["azimuth_deg"], up)[0], 1)
                    seen.add(way["acceleration_slides_on"])
        self.assertLessEqual({"a and b", "a", "b"}, seen, seen)

    def test_slab_as_a_wedge(self):
        """Two joints that mirror each other carry what a slab on their line does, with tan φ over the cosine of their normals to it: so the
        least acceleration is that of the slab in the plane, down the line; rotated about the vertical the same from the rotated azimuth, mirrored from
        the mirrored, in millimetres the same."""
        dip, spread, phi, cohesion, height = 55, 60, 35, 12, 30
        own = ((dip, 180 - spread), (dip, 180 + spread), (80, 180), (0, 180), height, ((phi, cohesion), (phi, cohesion)), 25, 0)
        got, forces = self.solved(own, "horizontal: 0.2"), Forces(*own)
        plunge = RAD(got["plunge_deg"]["value"])
        across = dot(normal(dip, 180 - spread), [0, -math.sin(plunge), math.cos(plunge)])
        hold = math.tan(RAD(phi)) / across
        held = cohesion * sum(forces.shape.areas[:2]) / forces.weight
        slab = (held + hold * math.cos(plunge) - math.sin(plunge)) / (math.cos(plunge) + hold * math.sin(plunge))
        self.assertAlmostEqual(got["acceleration_g"]["value"], slab, 12)
        self.assertAlmostEqual(got["acceleration_azimuth_deg"], 180, 4)
        factor = (held + hold * (math.cos(plunge) - 0.2 * math.sin(plunge))) / (math.sin(plunge) + 0.2 * math.cos(plunge))
        self.assertAlmostEqual(got["fos"]["value"], factor, 11)
        ahead = self.solved(own, "horizontal: 0.2, azimuth_deg: 180")
        self.assertAlmostEqual(ahead["acceleration_ahead_g"]["value"], slab, 14)
        self.assertAlmostEqual(ahead["fos"]["value"], factor, 14)
        own = self.WEDGES[3]
        one = self.solved(own, "horizontal: 0.3")
        for change, back in ((lambda d: (d + 37) % 360, lambda d: (d - 37) % 360), (lambda d: (360 - d) % 360, lambda d: 360 - d)):
            other = self.solved([*((dip, change(towards)) for dip, towards in own[:4]), *own[4:]], "horizontal: 0.3")
            for key in ("fos", "acceleration_g"):
                self.assertAlmostEqual(other[key]["value"], one[key]["value"], 11)
            for key in ("azimuth_deg", "acceleration_azimuth_deg"):
                self.assertAlmostEqual(back(other[key]), one[key], 4)
        path = self.scene(*own[:4], own[4] * 1000, *own[5:])
        with open(path, encoding="utf-8") as scene:
            text = scene.read().replace("length_unit: m", "length_unit: mm") + "loads: {seismic: {horizontal: 0.3}}\n"
        other = json.loads(run("solve", "--json", self.put("mm.yaml", text))[1])["wedge"]
        self.assertAlmostEqual(other["acceleration_g"]["value"], one["acceleration_g"]["value"], 11)
        self.assertAlmostEqual(other["fos"]["value"], one["fos"]["value"], 11)

    def test_bolts(self):
        """Active ones are forces: the factor of the closed form with them, also under an earthquake, from the worst azimuth too, and the acceleration that they
        let the wedge bear; two that pull against each other are none."""
        draw = random.Random(11)
        for own in self.WEDGES:
            bolts = [(draw.randint(500, 9000), draw.randint(300, 380) % 360, draw.randint(-20, 40)) for _ in range(2)]
            forces = Forces(*own)
            for bolt in bolts:
                forces.pull(*bolt)
            got = self.solved(own, "horizontal: 0.2, azimuth_deg: 170", bolts)
            factor, on = forces.factor(0.2, 170, 0)
            self.assertEqual(got["slides_on"], on)
            self.assertAlmostEqual(got["fos"]["value"], factor, 9)
            for told, (force, azimuth, dip) in zip(got["bolts"], bolts):
                self.assertEqual((told["force_n"]["value"], told["azimuth_deg"], told["dip_deg"]), (1000 * force, azimuth, dip))
            _, least, step = forces.turn(0.2, 0, 720)
            self.assertTrue(least - step - 1e-12 <= got["worst_fos"]["value"] <= least * (1 + 1e-12))
            if "acceleration_g" in got:
                at = got["acceleration_g"]["value"], got["acceleration_azimuth_deg"]
                self.assertTrue(forces.factor((1 + 1e-9) * at[0], at[1], 0)[0] < 1 < forces.factor((1 - 1e-9) * at[0], at[1], 0)[0])
            force, azimuth, dip = bolts[0]
            none = self.solved(own, "", [(force, azimuth, dip), (force, (azimuth + 180) % 360, -dip)])
            self.assertAlmostEqual(none["fos"]["value"], self.solved(own)["fos"]["value"], 12)

    def test_support(self):
        """The least further force that gives the required factor: with it as a bolt the factor is that; a force of 0.999 of it along no one of 500
        directions does, nor the same force a degree beside; of two joints that mirror each other it is at atan(tan φ / F) to their line, as of
        a slab. None where the factor is met, or where an earthquake may come from anywhere."""
        draw = random.Random(3)
        for own, required in ((self.WEDGES[0], 1.6), (self.WEDGES[2], 2.2), (self.WEDGES[3], 3)):
            got = self.solved(own, "", [(800, 340, 5)], required)
            force, azimuth, dip = (got[f"support_{key}"]["value"] for key in ("n", "azimuth_deg", "dip_deg"))
            force /= 1000
            bolted = lambda *bolt: Forces(*own).pull(800, 340, 5).pull(*bolt).factor(0, 0, 0)
            self.assertAlmostEqual(bolted(force, azimuth, dip)[0], required, 9)
            self.assertAlmostEqual(self.solved(own, "", [(800, 340, 5), (force, azimuth, dip)], required)["fos"]["value"], required, 9)
            for turned in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                self.assertLess(bolted(force, azimuth + turned[0], dip + turned[1])[0], required)
            for _ in range(500):
                factor, on = bolted(0.999 * force, draw.uniform(0, 360), math.degrees(math.asin(draw.uniform(-1, 1))))
                self.assertTrue(factor < required or on != "a and b")
            self.assertNotIn("support_n", self.solved(own, "", [(800, 340, 5), (1.01 * force, azimuth, dip)], required))
            self.assertNotIn("support_n", self.solved(own, "horizontal: 0.1", (), 9))
        dip, spread, phi = 55, 60, 35
        own = ((dip, 180 - spread), (dip, 180 + spread), (80, 180), (0, 180), 30, ((phi, 12), (phi, 12)), 25, 0)
        got = self.solved(own, "", (), 4)
        plunge = RAD(got["plunge_deg"]["value"])
        across = dot(normal(dip, 180 - spread), [0, -math.sin(plunge), math.cos(plunge)])
        self.assertAlmostEqual(got["support_dip_deg"]["value"], math.degrees(math.atan(math.tan(RAD(phi)) / across / 4) - plunge), 9)
        self.assertAlmostEqual(got["support_azimuth_deg"]["value"] % 360, 0, 9)

    def test_bolts_refused_and_told(self):
        """Every wrong key of a bolt is refused with what to do; the report and the sheet tell bolts and the force that is missing; a force is varied."""
        path = self.scene(*self.WEDGES[0])
        with open(path, encoding="utf-8") as scene:
            text = scene.read()
        bolt = "force_kn: 900, azimuth_deg: 340, dip_deg: 5"
        for wrong, words in ((bolt + ", at: [0, 1]", "leave out 'at'"), (bolt + ", passive: true", "leave out 'passive'"), ("force_kn: 1, dip_deg: 5", "azimuth_deg"),
                             ("force_kn: 1, azimuth_deg: 5", "dip_deg"), ("azimuth_deg: 5, dip_deg: 5", "'force_kn' is missing"),
                             (bolt + ", capacity_kn: 800", "more than the capacity"), (bolt.replace("dip_deg: 5", "dip_deg: 95"), "dip_deg")):
            status, out, err = run("solve", self.put("wrong.yaml", text + f"loads: {{anchors: [{{{wrong}}}]}}\n"))
            self.assertEqual((status, out), (3, ""))
            self.assertIn(words, err)
        block = "topple: 1\nlength_unit: m\nblock: {slab: {width: 1, height: 3}, unit_weight_kn_m3: 26}\nfriction_angle_deg: 40\ntilt: {towards: left}\n"
        err = run("solve", self.put("block.yaml", block + "loads: {anchors: [{at: [0, 1], force_kn: 1, dip_deg: 5, azimuth_deg: 3}]}\n"))[2]
        self.assertIn("'azimuth_deg' is of a bolt in a wedge", err)
        path = self.put("bolted.yaml", text + f"loads: {{anchors: [{{{bolt}, capacity_kn: 1000}}]}}\nrequired_fos: 1.6\n")
        status, out, err = run("solve", path)
        self.assertEqual(status, 1, err)
        self.assertIn("  bolt                   900000 N towards 340°, 5° below the horizontal, 0.9 of its capacity\n", out)
        self.assertIn("The least further active force that gives 1.6 is ", out)
        rows = run("sweep", path, "--x=loads.anchors.1.force_kn=100,900")[1].splitlines()
        fos = [float(row.split(",")[rows[0].split(",").index("fos")]) for row in rows[1:]]
        self.assertLess(fos[0], fos[1])
        for language, words in (("en", "Active bolts"), ("es", "Bulones activos"), ("de", "Aktive Anker")):
            sheet = f"{path}.{language}.html"
            status, out, err = run("solve", "--report", sheet, "--language", language, path)
            self.assertEqual(status, 1, err)
            with open(sheet, encoding="utf-8") as page:
                self.assertIn(words, page.read())

    def test_all_azimuths_told(self):
        """The report says that an azimuth is the worst, what the least of all is where one is given, and the least acceleration; a sweep has it; so many
        azimuths as asked for; a study of accelerations has its share."""
        own = self.WEDGES[0]
        path = self.scene(*own)
        with open(path, "a", encoding="utf-8") as out:
            out.write("loads: {seismic: {horizontal: 0.1}}\n")
        got, text = self.solved(own, "horizontal: 0.1"), run("solve", path)[1]
        self.assertIn(f"0.1 of the weight towards {got['azimuth_deg']:.6g}°, the worst azimuth", text)
        self.assertIn(f"least acceleration     {got['acceleration_g']['value']:.8g} g towards {got['acceleration_azimuth_deg']:.6g}°", text)
        with open(path, encoding="utf-8") as scene:
            text = scene.read().replace("horizontal: 0.1", "horizontal: 0.1, azimuth_deg: 20")
        text = run("solve", self.put("ahead.yaml", text))[1]
        self.assertIn(f"least of all azimuths  {math.floor(1e7 * got['fos']['value']) / 1e7:.7f} towards {got['azimuth_deg']:.6g}°, along the line of both joints", text)
        rows = run("sweep", path, "--x=loads.seismic.horizontal=0.1,0.2,0.3")[1].splitlines()
        names = rows[0].split(",")
        self.assertAlmostEqual(float(rows[2].split(",")[names.index("critical_acceleration_g")]), got["acceleration_g"]["value"], 12)
        self.assertAlmostEqual(float(rows[2].split(",")[names.index("fos")]), self.solved(own, "horizontal: 0.2")["fos"]["value"], 12)
        with open(path, encoding="utf-8") as scene:
            text = scene.read().replace("solid:", "solid:\n  azimuths: 7")
        self.assertEqual(len(json.loads(run("solve", "--json", self.put("seven.yaml", text))[1])["wedge"]["azimuths"]), 7)

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
