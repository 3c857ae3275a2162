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

HERE = pathlib.Path(__file__).parent
HAIR = Fraction(1, 10**10)  # degrees by which a tilt lies outside its bracket, a tenth of the last place
BELOW = (Fraction(1, 2), Fraction(9, 10))  # of the onset: no motion begins there either
MODES = 8  # contact points up to which contact modes are tried


def pi(digits=40):
    """By Machin's formula, a rational within 10^-digits."""
    def arctangent(n):
        total, term, k, least = Fraction(0), Fraction(1, n), 1, Fraction(1, 10**(digits + 3))
        while term > least:
            total += term / k if k % 4 == 1 else -term / k
            term /= n * n
            k += 2
        return total
    return 4 * (4 * arctangent(5) - arctangent(239))


PI = pi()


def trigonometry(degrees):
    """Sine and cosine of an angle in degrees within 1e-30, by Taylor's series."""
    angle = Fraction(degrees) * PI / 180
    angle = Fraction(round(angle * 10**40), 10**40)
    sine, cosine, term, k = Fraction(0), Fraction(0), Fraction(1), 0
    while abs(term) > Fraction(1, 10**35):
        sine, cosine = ((sine, cosine + term), (sine + term, cosine), (sine, cosine - term), (sine - term, cosine))[k % 4]
        k += 1
        term = Fraction(round(term * angle / k * 10**40), 10**40)
    return sine, cosine


def rational_tilt(degrees):
    """Exact sine and cosine of a tilt within 1e-18 degrees of this one."""
    sine, cosine = trigonometry(Fraction(degrees))
    t = Fraction(round(sine / (1 + cosine) * 10**20), 10**20)
    return 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)


def frictions(degrees):
    """Rationals just below and just above the tangent of the friction angle."""
    sine, cosine = trigonometry(Fraction(degrees))
    middle = Fraction(round(sine / cosine * 10**20), 10**20)
    return middle - Fraction(1, 10**19), middle + Fraction(1, 10**19)


def points(name):
    with open(HERE / name, encoding="utf-8", newline="") as file:
        return [(Fraction(row["x_m"]), Fraction(row["y_m"])) for row in csv.DictReader(file)]


class Single:
    """One block on one base; tilted to the right it is its own mirror image."""

    def __init__(self, own):
        block, base = points(own["block"]), points(own["base"])
        self.first, self.is_mirrored = block[0], own["towards"] == "right"
        self.area, centroid, self.gyration = exact.moments(block)
        self.offset = exact.minus(centroid, self.first)
        if self.is_mirrored:
            block, base = [(-x, y) for x, y in reversed(block)], [(-x, y) for x, y in reversed(base)]
            centroid = (-centroid[0], centroid[1])
        block, base = ([exact.minus(p, centroid) for p in chain] for chain in (block, base))
        self.contacts = exact.touching(block, base[::-1], False)
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


def within(bracket, value):
    return Fraction(str(bracket["low"])) <= value <= Fraction(str(bracket["high"]))


def sides(bracket):
    """Tilts just below and just above, as far as they lie between level and upright."""
    low, high = (Fraction(str(bracket[key])) for key in ("low", "high"))
    return low - HAIR, high + HAIR


def check_single(own, answers):
    """What is wrong with the answers of a case of one block; an empty list where nothing is."""
    block, wrong = Single(own), []
    truths = {"area_m2": block.area, "centroid_dx_m": block.offset[0], "centroid_dy_m": block.offset[1]}
    wrong += [name for name, truth in truths.items() if name in answers and not within(answers[name], truth)]
    if "topple_deg" in answers:
        low, high = sides(answers["topple_deg"])
        if block.toppling(low) or not block.toppling(high):
            wrong.append("topple_deg")
    if answers["limit_deg"].get("never"):
        if not all(block.holds(tilt, block.friction[0]) for tilt in (0, 30, 60, 89, Fraction("89.999"))):
            wrong.append("limit_deg")
    else:
        low, high = sides(answers["limit_deg"])
        if not block.holds(low, block.friction[0]) or block.holds(high, block.friction[1]):
            wrong.append("limit_deg")
    if len(block.contacts) <= MODES:
        wrong += check_onset(block, answers["stand_deg"])
    return wrong


def check_onset(block, answer):
    """No motion begins below the bracket, one does just above, whichever way the friction is rounded."""
    if answer.get("never"):
        quiet, moving = [Fraction(tilt) for tilt in (15, 45, 75, 89)], []
    else:
        low, high = sides(answer)
        quiet, moving = [low, *(part * low for part in BELOW)], [high]
    right = (all(not block.begins(tilt, mu) for tilt in quiet for mu in block.friction)
             and all(block.begins(tilt, mu) for tilt in moving for mu in block.friction))
    return [] if right else ["stand_deg"]


def main(names):
    manifest, answers = (json.loads((HERE / f"{what}.json").read_text()) for what in ("manifest", "answers"))
    wrong = 0
    for name, own in manifest.items():
        if names and name not in names:
            continue
        found = check_single(own, answers[name])
        print(f"{name}: {'wrong: ' + ', '.join(found) if found else 'confirmed'}", flush=True)
        wrong += bool(found)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
