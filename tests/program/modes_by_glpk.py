# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Whether any motion of a few blocks can begin, by all that their contacts can do: each end opens or stays closed, each contact sticks or
slips either way; of each combination Newton's and Coulomb's laws are a linear program, solved by GLPK. So are salient corners of two
blocks that meet in one point. Nothing of Topple takes part."""

import ctypes
import itertools

import block_forces_by_glpk as glpk

_FREE, _LOWER, _FIXED, _UPPER, _MAX, _OPTIMAL, _UNBOUNDED = 1, 2, 5, 3, 2, 5, 6
MODES = [(False, False, None)] + [(a, b, s) for a, b in ((True, False), (False, True), (True, True)) for s in ("sticks", 1, -1)]


def polar_over_area(points, centre):
    """The second polar moment of area about a point, over the area."""
    area = polar = 0.0
    for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
        ax, ay, bx, by = (float(v) - float(c) for v, c in zip((ax, ay, bx, by), (*centre, *centre)))
        cross = ax * by - bx * ay
        area += cross / 2
        polar += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by) / 12
    return polar / area


def _cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def _corners(points):
    for before, at, after in zip(points[-1:] + points[:-1], points, points[1:] + points[:1]):
        ray, back = ((q[0] - at[0], q[1] - at[1]) for q in (after, before))
        if _cross(ray, back) > 0:
            yield at, (ray, back)


def corner_pairs(blocks):
    """Numbers of two blocks, their point, and what their corners fill together as the first one moves: two directions. By these velocities,
    and those between them, the second block would enter the first."""
    for i, (_, one, own) in enumerate(blocks):
        for j, (_, two, other) in enumerate(blocks[:i]):
            for point, rays in _corners(one):
                for also, others in _corners(two):
                    if also != point or (own and other):
                        continue
                    all_rays = [*rays, *((-x, -y) for x, y in others)]
                    border = [[r for r in all_rays if all(sign * _cross(r, q) >= 0 for q in all_rays)][0] for sign in (1, -1)]
                    if _cross(*border) > 0:
                        yield i, j, point, border


CORNER_MODES = [(0, "opens"), (1, "opens"), (0, "slips"), (1, "slips"), (0, "sticks")]


class Program:
    """Columns without bounds; rows of {column: entry} that are zero, above or below a number."""

    def __init__(self, columns):
        self.columns, self.rows = columns, []

    def add(self, row, kind, bound=0.0):
        self.rows.append(({k: float(v) for k, v in row.items() if v != 0}, kind, float(bound)))

    def greatest(self, goal):
        """None where nothing is possible; infinite where nothing limits it."""
        library = glpk._library()
        p = library.glp_create_prob()
        library.glp_set_obj_dir(p, _MAX)
        library.glp_add_rows(p, len(self.rows))
        library.glp_add_cols(p, self.columns)
        for c in range(self.columns):
            library.glp_set_col_bnds(p, c + 1, _FREE, 0.0, 0.0)
            library.glp_set_obj_coef(p, c + 1, float(goal.get(c, 0)))
        entries = []
        for r, (row, kind, bound) in enumerate(self.rows):
            library.glp_set_row_bnds(p, r + 1, kind, bound, bound)
            entries += [(r + 1, c + 1, v) for c, v in row.items()]
        which = [(ctypes.c_int * (len(entries) + 1))(0, *(e[k] for e in entries)) for k in range(2)]
        library.glp_load_matrix(p, len(entries), *which, (ctypes.c_double * (len(entries) + 1))(0, *(e[2] for e in entries)))
        library.glp_simplex(p, None)
        status, value = library.glp_get_status(p), library.glp_get_obj_val(p)
        library.glp_delete_prob(p)
        return value if status == _OPTIMAL else float("inf") if status == _UNBOUNDED else None


class Blocks:
    """Blocks as (name, outline, is ground) that touch along edges; strengths by numbers of two blocks: tan(phi), kPa and kPa."""

    def __init__(self, blocks, weight, strength_of):
        self.free = {k: n for n, k in enumerate(k for k, b in enumerate(blocks) if not b[2])}
        self.places = {k: glpk.area_and_centroid(blocks[k][1]) for k in self.free}
        self.turning = {k: polar_over_area(blocks[k][1], self.places[k][1:]) for k in self.free}
        self.weight, self.strength_of = weight, strength_of
        self.contacts = list(glpk.contacts(blocks))
        self.pairs = list(corner_pairs(blocks))

    def push(self, i, j, force, point):
        """{row: entry} of a force on the first block and back on the second."""
        own = {}
        for k, sign in ((i, 1), (j, -1)):
            if k in self.free:
                _, x, y = (float(v) for v in self.places[k])
                fx, fy = sign * force[0], sign * force[1]
                for e, v in enumerate((fx, fy, (point[0] - x) * fy - (point[1] - y) * fx)):
                    own[3 * self.free[k] + e] = v
        return own

    def can_move(self, gravity, divisor):
        each = [MODES] * len(self.contacts) + [CORNER_MODES] * len(self.pairs)
        return any(self._moves(gravity, divisor, modes) for modes in itertools.product(*each))

    def _add_corners(self, p, newton, pair, mode, divisor, first):
        """N and T of both sides from column `first` on: n points out of the sector, t along its border and away from the point."""
        i, j, point, border = pair
        side, what = mode
        tangent = self.strength_of(i, j)[0] / divisor
        at = tuple(float(v) for v in point)
        for k, (x, y) in enumerate(border):
            size = (x * x + y * y) ** 0.5
            t = (x / size, y / size)
            n = (t[1], -t[0]) if k == 0 else (-t[1], t[0])
            normal, along = self.push(j, i, n, at), self.push(j, i, t, at)
            bears = what == "sticks" or (what == "slips" and k == side)
            for column, row in ((first + 2 * k, normal), (first + 2 * k + 1, along)):
                if not bears:
                    p.add({column: 1}, _FIXED)
                for r, v in row.items():
                    newton[r][column] = newton[r].get(column, 0) - v
            if what == "opens" and k == side:
                p.add(normal, _LOWER)
            if not bears:
                continue
            p.add({first + 2 * k: 1}, _LOWER)
            p.add(normal, _FIXED)
            if what == "slips":
                p.add(along, _LOWER)
                p.add({first + 2 * k + 1: 1, first + 2 * k: tangent}, _FIXED)
            else:
                for sign in (1, -1):
                    p.add({first + 2 * k + 1: sign, first + 2 * k: -tangent}, _UPPER)

    def _moves(self, gravity, divisor, modes):
        width, count = 3 * len(self.free), len(self.contacts)
        pulls = width + 3 * count + 4 * len(self.pairs)  # of bonds, at both ends of each contact
        p = Program(pulls + 2 * count)
        weights = {k: self.weight * float(self.places[k][0]) for k in self.free}
        newton = [{} for _ in range(width)]
        loads = [0.0] * width
        for k, n in self.free.items():
            for e in range(2):
                newton[3 * n + e][3 * n + e] = weights[k]
                loads[3 * n + e] = weights[k] * gravity[e]
            newton[3 * n + 2][3 * n + 2] = weights[k] * self.turning[k]
        for c, ((i, j, (ux, uy), ends), (first, second, slip)) in enumerate(zip(self.contacts, modes)):
            length = (ux * ux + uy * uy) ** 0.5
            t = (ux / length, uy / length)
            n = (-t[1], t[0])
            ends = [tuple(float(v) for v in end) for end in ends]
            span = abs((ends[1][0] - ends[0][0]) * t[0] + (ends[1][1] - ends[0][1]) * t[1])
            tangent, cohesion, tension = (v / divisor for v in self.strength_of(i, j))
            middle = tuple((a + b) / 2 for a, b in zip(*ends))
            whole = first and second  # a bond pulls by any share of it, anywhere; by all of it, at its middle, where the contact opens
            for r, v in self.push(i, j, n, middle).items():
                loads[r] -= 0 if whole else tension * span * v
            for k, end in enumerate(ends):
                p.add({pulls + 2 * c + k: 1}, _LOWER if whole else _FIXED)
                for r, v in self.push(i, j, n, end).items():
                    newton[r][pulls + 2 * c + k] = newton[r].get(pulls + 2 * c + k, 0) + v
            p.add({pulls + 2 * c: 1, pulls + 2 * c + 1: 1}, _UPPER, tension * span)
            own = [width + 3 * c + k for k in range(3)]  # N at both ends, T
            for k, (closed, end) in enumerate(zip((first, second), ends)):
                opening = self.push(i, j, n, end)
                for r, v in opening.items():
                    newton[r][own[k]] = newton[r].get(own[k], 0) - v
                p.add(opening, _FIXED if closed else _LOWER)
                p.add({own[k]: 1}, _LOWER if closed else _FIXED)
            along = self.push(i, j, t, ends[0])
            for r, v in along.items():
                newton[r][own[2]] = newton[r].get(own[2], 0) - v
            if slip is None:
                p.add({own[2]: 1}, _FIXED)
                continue
            if slip == "sticks":
                p.add(along, _FIXED)
                for sign in (1, -1):
                    p.add({own[2]: sign, own[0]: -tangent, own[1]: -tangent}, _UPPER, cohesion * span)
                continue
            p.add({r: slip * v for r, v in along.items()}, _LOWER)
            p.add({own[2]: slip, own[0]: tangent, own[1]: tangent}, _FIXED, -cohesion * span)
        for k, (pair, mode) in enumerate(zip(self.pairs, modes[count:])):
            self._add_corners(p, newton, pair, mode, divisor, width + 3 * count + 4 * k)
        for row, load in zip(newton, loads):
            p.add(row, _FIXED, load)
        most = p.greatest({k: load for k, load in enumerate(loads)})
        return most is not None and most > 1e-7 * self.weight
