# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Confirms answers.json from the coordinates alone, without Topple, in rational numbers.

    python3 confirm.py [NAME...]

Just below and just above each bracket a tilt is taken whose sine and cosine are rational, t = tan(tilt/2), and the friction
between two rationals: there forces hold the block or none do, motions can begin or none can. Prints a line for each case
that it confirms and ends with status 1 where an answer is wrong."""

import csv
import json
import pathlib
import sys
from fractions import Fraction

import exact
import fall
import shake
from rational import frictions, rational_tilt

HERE = pathlib.Path(__file__).parent
HAIR = Fraction(1, 10**10)  # degrees by which a tilt lies outside its bracket, a tenth of the last place
NEAR = Fraction(1, 10**9)  # metres by which a block at rest may miss its base, as the digits of its pose do
BELOW = (Fraction(1, 2), Fraction(9, 10))  # of the onset: no motion begins there either
MODES = 8  # contact points up to which contact modes are tried


def points(name):
    with open(HERE / name, encoding="utf-8", newline="") as file:
        return [(Fraction(row["x_m"]), Fraction(row["y_m"])) for row in csv.DictReader(file)]


def placed(ring, about, answers):
    """A block as its answers say that it comes to rest: turned about its centroid, which moved."""
    turned, *moved = (sum(Fraction(str(answers[name][end])) for end in ("low", "high")) / 2
                      for name in ("turned_deg", "moved_x_m", "moved_y_m"))
    sine, cosine = rational_tilt(turned)
    arms = [exact.minus(p, about) for p in ring]
    return [(about[0] + moved[0] + cosine * x - sine * y, about[1] + moved[1] + sine * x + cosine * y) for x, y in arms]


def near(ring, base):
    """Contact points of a block that touches but for NEAR: vertices of one beside an edge of the other."""
    found = []
    for chain, lines, of_block in ((ring, exact.edges(base, False), False), (base, exact.edges(ring, True), True)):
        for a, b in lines:
            d = exact.minus(b, a)
            for p in chain:
                r = exact.minus(p, a)
                if exact.cross(d, r)**2 < NEAR**2 * exact.dot(d, d) and 0 < exact.dot(r, d) < exact.dot(d, d):
                    found.append((p, exact.lowest(d)))
    return found


class Single:
    """One block on one base; tilted to the right it is its own mirror image."""

    def __init__(self, own, answers=None):
        block, base = points(own["block"]), points(own["base"])
        if "place" in own and answers:
            block = placed(block, exact.moments(block)[1], answers)
        self.first, self.is_mirrored = block[0], own["towards"] == "right"
        self.area, centroid, self.gyration = exact.moments(block)
        self.offset = exact.minus(centroid, self.first)
        if self.is_mirrored:
            block, base = [(-x, y) for x, y in reversed(block)], [(-x, y) for x, y in reversed(base)]
            centroid = (-centroid[0], centroid[1])
        block, base = ([exact.minus(p, centroid) for p in chain] for chain in (block, base))
        self.contacts = near(block, base) if "place" in own else exact.touching(block, base[::-1], False)
        self.centroid, self.block, self.loads = centroid, block, own["loads"]
        self.weight = self.area * Fraction(own.get("unit_weight_kn_m3", 1))
        self.friction = frictions(own["friction_deg"])

    def applied(self, degrees):
        """Forces in kN and their moment about the centroid, per metre of thickness."""
        sine, cosine = rational_tilt(degrees)
        fx, fy, moment = -self.weight * sine, -self.weight * cosine, Fraction(0)
        for own in self.loads:
            if own["type"] == "seismic":
                k = Fraction(own["horizontal"]) * self.weight
                fx, fy = fx - k * cosine, fy + k * sine
                continue
            at, force = self.pushed(own)
            x, y = exact.minus(at, self.centroid)
            fx, fy, moment = fx + force[0], fy + force[1], moment + x * force[1] - y * force[0]
        return fx, fy, moment

    def pushed(self, own):
        """Point and force of a load that stays on the block."""
        if own["type"] == "force":
            return (Fraction(own["x_m"]), Fraction(own["y_m"])), (Fraction(own["fx_kn"]), Fraction(own["fy_kn"]))
        start, end = ([Fraction(v) for v in own[key]] for key in ("from_m", "to_m"))
        (dx, dy), (p0, p1) = exact.minus(end, start), [Fraction(v) for v in own["kpa"]]
        part = (p0 + 2 * p1) / (3 * (p0 + p1))
        return (start[0] + part * dx, start[1] + part * dy), (-dy * (p0 + p1) / 2, dx * (p0 + p1) / 2)

    def holds(self, degrees, friction):
        return exact.holds(1, [(0, None, contact, friction) for contact in self.contacts], [self.applied(degrees)])

    def begins(self, degrees, friction):
        own = exact.Beginning(self.contacts, friction, (0, 0), self.gyration, [v / self.weight for v in self.applied(degrees)])
        return own.begins()

    def toppling(self, degrees):
        """Is the moment about a contact point overturning, about which the block can turn down-dip without entering the base?
        That is where every contact point's own velocity does not go against its normal."""
        fx, fy, moment = self.applied(degrees)
        for (px, py), _ in self.contacts:
            if all((x - px) * tx + (y - py) * ty >= 0 for (x, y), (tx, ty) in self.contacts):
                if moment - px * fy + py * fx > 0:
                    return True
        return False


def outlines(name):
    """Many blocks by their names."""
    found = {}
    with open(HERE / name, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["block"], []).append((Fraction(row["x_m"]), Fraction(row["y_m"])))
    return found


class Many:
    """Many blocks on rock, of the same density."""

    def __init__(self, own):
        blocks = outlines(own["blocks"])
        ground = blocks.pop("ground")
        self.blocks, self.friction = list(blocks.values()), frictions(own["friction_deg"])
        self.contacts = []
        for k, ring in enumerate(self.blocks):
            self.contacts += [(k, None, contact) for contact in exact.touching(ring, ground)]
            for j in range(k):
                self.contacts += [(k, j, contact) for contact in exact.touching(ring, self.blocks[j])]

    def holds(self, degrees, friction):
        sine, cosine = rational_tilt(degrees)
        applied = []
        for ring in self.blocks:
            area, (x, y), _ = exact.moments(ring)
            applied.append((-area * sine, -area * cosine, area * (y * sine - x * cosine)))
        return exact.holds(len(self.blocks), [(*contact, friction) for contact in self.contacts], applied)


def check_many(own, answers):
    blocks, (low, high) = Many(own), sides(answers["limit_deg"])
    right = blocks.holds(low, blocks.friction[0]) and not blocks.holds(high, blocks.friction[1])
    return [] if right else ["limit_deg"]


def solid_of(name):
    """Corners and triangles of an OBJ."""
    lines = [line.split() for line in (HERE / name).read_text().splitlines()]
    return ([tuple(map(Fraction, words[1:])) for words in lines if words[0] == "v"],
            [tuple(int(v) - 1 for v in words[1:]) for words in lines if words[0] == "f"])


def lowest_edges(points):
    """Edges of the convex hull, seen from above, of the points that touch the table."""
    low = min(p[2] for p in points)
    flat = sorted({p[:2] for p in points if p[2] == low})
    for p in flat:
        for q in flat:
            turns = [exact.cross(exact.minus(q, p), exact.minus(r, p)) for r in flat]
            if p != q and min(turns) >= 0 and all(turn or exact.dot(exact.minus(r, p), exact.minus(r, q)) <= 0
                                                  for turn, r in zip(turns, flat)):
                yield p, q


def check_solid(own, answers):
    """Tetrahedra about the first corner; the arm of the weight about each edge of the support."""
    points, faces = solid_of(own["solid"])
    about = [tuple(v - o for v, o in zip(p, points[0])) for p in points]
    volume, first = Fraction(0), [Fraction(0)] * 3
    for (ax, ay, az), (bx, by, bz), (cx, cy, cz) in ([about[k] for k in face] for face in faces):
        part = (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
        volume += part
        first = [f + part * (a + b + c) / 4 for f, a, b, c in zip(first, (ax, ay, az), (bx, by, bz), (cx, cy, cz))]
    centroid = [f / volume for f in first]
    truths = {"volume_m3": volume, **{f"centroid_d{axis}_m": v for axis, v in zip("xyz", centroid)}}
    wrong = [name for name, truth in truths.items() if name in answers and not within(answers[name], truth)]
    height = centroid[2] - min(p[2] for p in about)
    arms = [(exact.cross(exact.minus(q, p), exact.minus(centroid[:2], p)), exact.minus(q, p)) for p, q in lowest_edges(about)]
    tangents = {"least_tilt_deg": min(arm * arm / exact.dot(way, way) for arm, way in arms) / height**2}
    for azimuth, (east, north) in {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}.items():
        reach = min(arm / out for arm, (dx, dy) in arms for out in [dy * east - dx * north] if out > 0)
        tangents[f"moves_{azimuth}_deg"] = min(reach / height, frictions(own["friction_deg"])[0])**2
    for name, square in tangents.items():
        low, high = (rational_tilt(tilt) for tilt in sides(answers[name]))
        if not (low[0] / low[1])**2 < square < (high[0] / high[1])**2:
            wrong.append(name)
    return wrong


def check_fall(own, answers):
    """The distance at both ends of the bracket: by its acceleration, in rational numbers; of a block on one corner by the equation
    of motion in small steps, as long as it does not slip, leave the rock or meet it elsewhere."""
    ring, (a, b) = points(own["block"]), points(own["base"])
    ends, moved = [Fraction(str(answers["moved_s"][end])) for end in ("low", "high")], Fraction(own["moved_m"])
    along = exact.minus(b, a)
    on = [p for p in ring if exact.cross(along, exact.minus(p, a)) == 0]
    centroid = exact.moments(ring)[1]
    if on and not min(x for x, _ in on) < centroid[0] < max(x for x, _ in on):
        low, high = (fall.turned_by(ring, min(on) if centroid[0] < min(on)[0] else max(on), along, end, float(frictions(own["friction_deg"])[0]))
                     for end in ends)
        return [] if low < moved < high else ["moved_s"]
    size = exact.dot(along, along)
    rates = [Fraction(1)] * 2 if not on else [(along[1] - mu * along[0]) / fall.root(size) for mu in frictions(own["friction_deg"])[::-1]]
    low, high = (fall.GRAVITY * rate * end * end / 2 for rate, end in zip(rates, ends))
    return [] if low < moved < high else ["moved_s"]


def check_shaken(own, answers):
    """It overturns on one side of each bracket and not on the other, nor does that change at peaks between the edges."""
    ring, frequency = points(own["block"]), float(own["shaking"]["full_sine"]["frequency_hz"])
    mu, wrong = float(frictions(own["friction_deg"])[0]), []
    last = 1.15 * shake.Rectangle(ring, mu).lift
    for k, (name, answer) in enumerate(answers.items()):
        before, (low, high) = k % 2 == 1, (answer["low"], answer["high"])
        quiet = [last + part * (low - last) for part in (0.05, 0.35, 0.65, 0.95, 1)]
        if any(shake.overturns(ring, mu, peak, frequency) != before for peak in quiet) or shake.overturns(ring, mu, high, frequency) == before:
            wrong.append(name)
        last = high
    return wrong


def check(own, answers):
    if "moved_m" in own:
        return check_fall(own, answers)
    if "shaking" in own:
        return check_shaken(own, answers)
    return (check_single if "base" in own else check_many if "blocks" in own else check_solid)(own, answers)


def within(bracket, value):
    return Fraction(str(bracket["low"])) <= value <= Fraction(str(bracket["high"]))


def sides(bracket):
    """Tilts just below and just above, as far as they lie between level and upright."""
    low, high = (Fraction(str(bracket[key])) for key in ("low", "high"))
    return low - HAIR, high + HAIR


def check_single(own, answers):
    """What is wrong with the answers of a case of one block; an empty list where nothing is."""
    block, wrong = Single(own, answers), []
    truths = {"area_m2": block.area, "centroid_dx_m": block.offset[0], "centroid_dy_m": block.offset[1]}
    wrong += [name for name, truth in truths.items() if name in answers and not within(answers[name], truth)]
    if "place" in own:
        wrong += [] if is_at_rest(block) else ["turned_deg"]
    if "topple_deg" in answers:
        low, high = sides(answers["topple_deg"])
        wrong += ["topple_deg"] if block.toppling(low) or not block.toppling(high) else []
    for name, way in (("limit_deg", 1), ("holds_from_deg", -1)):
        if name in answers and not is_limit(block, answers[name], way):
            wrong.append(name)
    if len(block.contacts) <= MODES:
        wrong += check_onset(block, answers)
    return wrong


def is_at_rest(block):
    """Two contacts or more, with the weight between them. That it came to lie so is for a search in small steps to tell."""
    xs = [x for (x, _), _ in block.contacts]
    return len(xs) >= 2 and min(xs) < 0 < max(xs)


def is_limit(block, answer, way):
    """Forces hold the block on one side of the bracket, and none do on the other; or at every tilt."""
    if answer.get("never"):
        return all(block.holds(tilt, block.friction[0]) for tilt in (0, 30, 60, 89, Fraction("89.999")))
    inside, outside = sides(answer)[::way]
    return block.holds(inside, block.friction[0]) and not block.holds(outside, block.friction[1])


def check_onset(block, answers):
    """No motion begins between both ends of the tilts at which it stands, and one does just beyond, whichever way the friction is
    rounded."""
    first, last, moving = Fraction(0), Fraction(90), []
    if "stands_from_deg" in answers:
        before, first = sides(answers["stands_from_deg"])
        moving.append(before)
    if not answers["stand_deg"].get("never"):
        last, after = sides(answers["stand_deg"])
        moving.append(after)
    quiet = [first + part * (last - first) for part in (*BELOW, 1)] + ([first] if first else [])
    if last == 90:
        quiet = [Fraction(tilt) for tilt in (15, 45, 75, 89)]
    right = (all(not block.begins(tilt, mu) for tilt in quiet for mu in block.friction)
             and all(block.begins(tilt, mu) for tilt in moving for mu in block.friction))
    return [] if right else ["stand_deg"]


def main(names):
    manifest, answers = (json.loads((HERE / f"{what}.json").read_text()) for what in ("manifest", "answers"))
    wrong = 0
    for name, own in manifest.items():
        if names and name not in names:
            continue
        found = check(own, answers[name])
        print(f"{name}: {'wrong: ' + ', '.join(found) if found else 'confirmed'}", flush=True)
        wrong += bool(found)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
