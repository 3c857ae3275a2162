# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Whether any motion of a body on contact points can begin in three dimensions, by all that its contacts can do: each opens, sticks or slips
within a sector of directions, whose forces lie between the chord and the tangents of their arc. Of each combination the greatest work of the
load is a linear program in forces and accelerations, solved by GLPK; sectors are halved while it is above zero. Nothing of Topple takes part."""

import math

import block_forces_by_glpk as glpk
from letting_go import cross, dot
from modes_by_glpk import Program

IS_THERE = glpk.IS_THERE
_FREE, _LOWER, _FIXED = 1, 2, 5
SIDES = 20  # of the polygon about a cone


def _unit(v):
    size = math.sqrt(dot(v, v))
    return [k / size for k in v]


class Modes:
    """A body of mass one, its centroid at the origin; contacts are (point, normal, mu)."""

    def __init__(self, inertia, contacts):
        self.inertia, self.contacts, self.programs = inertia, [], 0
        for at, normal, mu in contacts:
            n = _unit(normal)
            t = _unit(cross(n, [1, 0, 0] if abs(n[0]) < 0.7 else [0, 1, 0]))
            self.contacts.append((at, n, t, cross(n, t), mu))

    def _forces(self, contact, mode):
        _, n, t, u, mu = contact
        if mode[0] == "opens":
            return []
        if mode[0] == "slips":
            low, high = mode[1:]
            around = ((low, -mu), (high, -mu), ((low + high) / 2, -mu / math.cos((high - low) / 2)))
        else:
            around = [(2 * math.pi * k / SIDES, mu / math.cos(math.pi / SIDES)) for k in range(SIDES)]
        return [[a + r * (math.cos(way) * b + math.sin(way) * c) for a, b, c in zip(n, t, u)] for way, r in around]

    def greatest(self, load, modes):
        """The greatest work of a load on an acceleration of these modes; None: there is none."""
        columns = [(c[0], f) for c, m in zip(self.contacts, modes) for f in self._forces(c, m)]
        p = Program(6 + len(columns))
        newton = [{k: 1.0} for k in range(3)] + [{3 + j: self.inertia[k][j] for j in range(3)} for k in range(3)]
        for g, (at, force) in enumerate(columns):
            p.add({6 + g: 1}, _LOWER)
            for k, v in enumerate([*force, *cross(at, force)]):
                newton[k][6 + g] = -v
        for k, row in enumerate(newton):
            p.add(row, _FIXED, load[k] if k < 3 else 0)
        for (at, n, t, u, _), mode in zip(self.contacts, modes):
            def moves(along, at=at):
                return dict(enumerate([*along, *cross(at, along)]))
            p.add(moves(n), _LOWER if mode[0] in ("any", "opens") else _FIXED)
            if mode[0] == "sticks":
                p.add(moves(t), _FIXED)
                p.add(moves(u), _FIXED)
            if mode[0] == "slips":
                for way in (mode[1] + math.pi / 2, mode[2] - math.pi / 2):
                    p.add(moves([math.cos(way) * b + math.sin(way) * c for b, c in zip(t, u)]), _LOWER)
        self.programs += 1
        return p.greatest(dict(enumerate(load)))

    def most(self, load, least=1e-7, narrow=0.03):
        """The greatest work of a load that the modes leave, to `least`; sectors end at `narrow`."""
        left, found = [[("any",)] * len(self.contacts)], 0.0
        while left:
            modes = left.pop()
            work = self.greatest(load, modes)
            if work is None or work <= least:
                continue
            k = next((k for k, m in enumerate(modes) if m[0] == "any"), None)
            if k is not None:
                parts = [("opens",), ("sticks",)] + [("slips", j * math.pi / 2, (j + 1) * math.pi / 2) for j in range(4)]
            else:
                width, k = max((m[2] - m[1] if m[0] == "slips" else 0, k) for k, m in enumerate(modes))
                if width <= narrow:
                    found = max(found, work)
                    continue
                low, high = modes[k][1:]
                parts = [("slips", low, (low + high) / 2), ("slips", (low + high) / 2, high)]
            left += [modes[:k] + [part] + modes[k + 1:] for part in parts]
        return found
