# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Which motion can begin under cohesion and bonds, by trial of every contact mode in whole numbers.

As onset_oracle.py, at one tilt: forces of a given size do not grow with the loads, so that tan(tilt) is
no unknown of a linear program any more. Resistance is any force that the law of Mohr and Coulomb with a
bond allows (docs/onset.md, "Cohesion and bonds"):

- the line of a facet of which a point stays closed and slips: all of its cohesion, against the slip;
- of which one stays closed and sticks: any shear up to it;
- all of whose points open: none, for nothing touches any more;
- a facet that opens: all of its bond, as a pull at its middle;
- one whose ends both stay closed: any pull up to its bond, wherever along it.

That is the law "touching". By "found" the last may be any pull: so the onset is found. By "parting" a line all of
whose points open may still be sheared by up to its cohesion, against its motion along itself."""

from fractions import Fraction
from itertools import combinations

from limit_oracle import along, cross2, minus, unit
from onset_oracle import DOWN, PARTS, STICKS, UP, Onset, dot, maximise, sign


def facets(outline, profile):
    """(p, q, t): from end to end, t up-dip towards the left."""
    found = set()
    for a0, a1 in zip(outline, outline[1:] + outline[:1]):
        for b0, b1 in zip(profile, profile[1:]):
            d, e = minus(a1, a0), minus(b1, b0)
            if cross2(d, e) != 0 or d[0] * e[0] + d[1] * e[1] <= 0 or cross2(d, minus(b0, a0)) != 0:
                continue
            ends = {p for p in (a0, a1) if along(p, b0, b1) is not None}
            ends |= {p for p in (b0, b1) if along(p, a0, a1) is not None}
            if len(ends) == 2:
                p, q = sorted(ends, key=lambda end: end[0] * d[0] + end[1] * d[1])
                found.add((p, q, unit(d)))
    return sorted(found)


def opens(state):
    return state.startswith(PARTS)


def slip_of(state):
    """Of the point's motion along its facet, whether it opens or not."""
    return state.removeprefix(PARTS)


class StrongOnset(Onset):
    """`sheared` and `bonded`: cohesion and bond over the weight per length, kPa / (kN/m3 m2)."""

    def __init__(self, points, centroid, gyration, tangent, ends, sheared, bonded):
        self.gyration, self.tangent = gyration, tangent
        self.contacts, self.lines = [], []
        for (x, y), (tx, ty) in points:
            x, y = x - centroid[0], y - centroid[1]
            self.contacts.append(((x, y), (tx, ty), (-ty, tx, tx * x + ty * y), (tx, ty, ty * x - tx * y)))
            self.lines.append(((tx, ty), ty * x - tx * y))
        self.facets = []
        for p, q, t in ends:
            places = [(x - centroid[0], y - centroid[1]) for x, y in (p, q)]
            length = (q[0] - p[0], q[1] - p[1])
            line = (t, t[1] * places[0][0] - t[0] * places[0][1])
            self.facets.append((places, [points.index((end, t)) for end in (p, q)], line,
                                tuple(sheared * x for x in length), (bonded * length[1], -bonded * length[0])))
        self.all_modes = list(self.modes())

    @staticmethod
    def state(contact, twist):
        slip = {1: UP, -1: DOWN, 0: STICKS}[sign(dot(contact[3], twist))]
        return PARTS + slip if dot(contact[2], twist) > 0 else slip

    def column(self, place, force):
        x, y = place
        return (force[0], force[1], (x * force[1] - y * force[0]) / self.gyration)

    def friction(self, states, parted):
        found = []
        for k, (((x, y), (tx, ty), _, _), state) in enumerate(zip(self.contacts, states)):
            if k in parted:
                continue
            for side in {STICKS: (1, -1), UP: (-1,), DOWN: (1,)}.get(state, ()) if self.bears(k, state) else ():
                tan = self.tangent_at(k)
                found.append(self.column((x, y), (-ty + side * tan * tx, tx + side * tan * ty)))
        return found

    def strength(self, states, parted, law):
        """What is fixed, and groups of columns whose factors add up to 1 at most, or to anything (None)."""
        fixed, groups = [], []
        for places, ends, line, shear, pull in self.facets:
            on_line = [s for s, own in zip(states, self.lines) if own == line]
            closed = [k for k, own in enumerate(self.lines) if own == line and k not in parted and not opens(states[k])]
            slip = slip_of(on_line[0])
            back = self.column(places[0], tuple(-x for x in shear) if slip == UP else shear)
            if closed and slip != STICKS:
                fixed.append(back)
            elif closed or law == "parting":
                ways = [back] + ([tuple(-x for x in back)] if slip == STICKS else [])
                groups.append((ways, 1))
            if not any(opens(states[k]) for k in ends):
                groups.append(([self.column(place, pull) for place in places], None if law == "found" else 1))
            else:
                middle = tuple((a + b) / 2 for a, b in zip(*places))
                fixed.append(self.column(middle, pull))
        return fixed, groups

    def can_begin(self, half, law="touching"):
        """The states of a mode that can begin at a tilt of 2 atan(half), or None."""
        square = 1 + half * half
        load = (-2 * half / square, -(1 - half * half) / square, Fraction(0))
        for states, twist in self.all_modes:
            for parted, turn in self.partings(states):
                if self.is_possible(states, parted, twist or turn, load, law):
                    return states
        return None

    @staticmethod
    def partings(states):
        """Every set of contacts that part though they touch to the first order, and the sense in which the block turns."""
        slipping = [k for k, state in enumerate(states) if state in (UP, DOWN)]
        yield set(), ()
        for count in range(1, len(slipping) + 1):
            for parted in combinations(slipping, count):
                yield from ((set(parted), (0, 0, sense)) for sense in (1, -1))

    def is_possible(self, states, parted, twist, load, law):
        fixed, groups = self.strength(states, parted, law)
        load = tuple(sum(own) for own in zip(load, *fixed))
        forces = self.friction(states, parted)
        rows = []
        for ways, most in groups:
            if most is not None:
                rows.append(([0] * len(forces) + [1] * len(ways), most))
            forces += ways
        count = len(forces)
        rows = [(own + [0] * (count + 1 - len(own)), most, False) for own, most in rows]

        def least(row, strict):
            """row . a >= 0, by some slack where that is strict."""
            rows.append(([-dot(row, f) for f in forces] + [1 if strict else 0], dot(row, load), not strict))

        for (_, _, normal, slip), state in zip(self.contacts, states):
            least(normal, opens(state))
            sense = {UP: 1, STICKS: 0, DOWN: -1}[slip_of(state)]
            least(tuple(sense * x for x in slip) if sense != 0 else slip, sense != 0)
        if twist:
            least(twist, True)
        rows.append(([0] * count + [1], 1, False))
        slack = maximise([0] * count + [1], rows, [count])
        return slack is not None and slack > 0
