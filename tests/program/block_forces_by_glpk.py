# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The greatest load that forces between blocks hold, by the simplex method of GLPK in exact arithmetic (glp_exact), from outlines
alone: contacts are found by comparing all edges, in rationals. Nothing of Topple takes part."""

import ctypes
import ctypes.util
import fractions

_LIBRARY = ctypes.util.find_library("glpk")
IS_THERE = _LIBRARY is not None
_MIN, _MAX, _FREE, _LOWER, _FIXED, _OFF, _OPTIMAL, _UNBOUNDED = 1, 2, 1, 2, 5, 0, 5, 6


def _library():
    glpk = ctypes.CDLL(_LIBRARY)
    glpk.glp_create_prob.restype = ctypes.c_void_p
    glpk.glp_get_obj_val.restype = ctypes.c_double
    for name in ("delete_prob", "set_obj_dir", "add_rows", "add_cols", "simplex", "exact", "get_status", "get_obj_val"):
        getattr(glpk, "glp_" + name).argtypes = [ctypes.c_void_p] + [ctypes.c_int] * (name in ("set_obj_dir", "add_rows", "add_cols"))
    for name in ("simplex", "exact"):
        getattr(glpk, "glp_" + name).argtypes.append(ctypes.c_void_p)
    number, whole = ctypes.c_double, ctypes.c_int
    glpk.glp_set_row_bnds.argtypes = glpk.glp_set_col_bnds.argtypes = [ctypes.c_void_p, whole, whole, number, number]
    glpk.glp_set_obj_coef.argtypes = [ctypes.c_void_p, whole, number]
    glpk.glp_load_matrix.argtypes = [ctypes.c_void_p, whole] + [ctypes.c_void_p] * 3
    glpk.glp_term_out(_OFF)
    return glpk


def area_and_centroid(points):
    area = x = y = fractions.Fraction(0)
    for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
        cross = fractions.Fraction(ax * by - bx * ay)
        area, x, y = area + cross / 2, x + (ax + bx) * cross / 6, y + (ay + by) * cross / 6
    return area, x / area, y / area


def shared(a, b, c, d):
    """The ends of what the edges a → b and c → d, of two blocks that run counter-clockwise, have in common; None: no length."""
    ux, uy = b[0] - a[0], b[1] - a[1]
    if any(ux * (p[1] - a[1]) != uy * (p[0] - a[0]) for p in (c, d)) or ux * (d[0] - c[0]) + uy * (d[1] - c[1]) >= 0:
        return None
    size = ux * ux + uy * uy
    low, high = (fractions.Fraction(ux * (p[0] - a[0]) + uy * (p[1] - a[1]), size) for p in (d, c))
    low, high = max(low, 0), min(high, 1)
    return None if low >= high else [(a[0] + t * ux, a[1] + t * uy) for t in (low, high)]


def contacts(blocks):
    """Numbers of two blocks, the direction of the first one's edge and both ends of what touches."""
    bounds = [[f(p[e] for p in points) for e in range(2) for f in (min, max)] for _, points, _ in blocks]
    for i, (_, one, _) in enumerate(blocks):
        for j, (_, two, _) in enumerate(blocks[:i]):
            if any(bounds[i][e] > bounds[j][e + 1] or bounds[j][e] > bounds[i][e + 1] for e in (0, 2)):
                continue
            for a, b in zip(one, one[1:] + one[:1]):
                for c, d in zip(two, two[1:] + two[:1]):
                    ends = shared(a, b, c, d)
                    if ends is not None and not (blocks[i][2] and blocks[j][2]):
                        yield i, j, (b[0] - a[0], b[1] - a[1]), ends


class _Forces:
    """The columns of all forces in contacts, behind one of what is sought, and rows of equilibrium by free block."""

    def __init__(self, blocks, tangent_of):
        free = [k for k, (_, _, ground) in enumerate(blocks) if not ground]
        self.row = {k: 3 * n + 1 for n, k in enumerate(free)}
        self.places = {k: area_and_centroid(blocks[k][1]) for k in free}
        self.entries, self.columns = [], 1
        for i, j, (ux, uy), ends in contacts(blocks):
            slope = fractions.Fraction(tangent_of(i, j))
            for point in ends:
                for side in (slope, -slope) if slope else (0,):
                    self.columns += 1
                    force = (-uy + side * ux, ux + side * uy)
                    self.push(i, self.columns, force, point)
                    self.push(j, self.columns, (-force[0], -force[1]), point)

    def push(self, k, column, force, point):
        if k in self.row:
            _, x, y = self.places[k]
            values = (force[0], force[1], (point[0] - x) * force[1] - (point[1] - y) * force[0])
            self.entries.extend((self.row[k] + e, column, float(v)) for e, v in enumerate(values) if v != 0)


def greatest_load(blocks, tangent_of, towards_left):
    """s, by which weights act towards a side with s times themselves, or a word: `none` where no s can be held, `any`. `tangent_of` gives
    tan(phi) by the numbers of two blocks. The inside of a block is on the left of its edges, and pushes from there."""
    own = _Forces(blocks, tangent_of)
    for k, row in own.row.items():  # per unit of s
        own.entries.append((row, 1, float(own.places[k][0]) * (-1 if towards_left else 1)))
    return _optimise(own, {row + 1: float(own.places[k][0]) for k, row in own.row.items()}, _MAX, _FREE)


def least_support(blocks, tangent_of, side, on, point, way):
    """The least force at a point of a block along `way`, in areas of unit weight, by which forces hold all while weights act by
    `side` times themselves along x besides; or `none`."""
    own = _Forces(blocks, tangent_of)
    own.push(on, 1, way, point)
    weights = {}
    for k, row in own.row.items():
        weights[row], weights[row + 1] = -side * float(own.places[k][0]), float(own.places[k][0])
    return _optimise(own, weights, _MIN, _LOWER)


def _optimise(own, weights, direction, bounds):
    entries, columns, rows = own.entries, own.columns, 3 * len(own.row)
    glpk = _library()
    program = glpk.glp_create_prob()
    glpk.glp_set_obj_dir(program, direction)
    glpk.glp_add_rows(program, rows)
    glpk.glp_add_cols(program, columns)
    for r in range(1, rows + 1):
        glpk.glp_set_row_bnds(program, r, _FIXED, weights.get(r, 0.0), 0.0)
    glpk.glp_set_col_bnds(program, 1, bounds, 0.0, 0.0)
    for c in range(2, columns + 1):
        glpk.glp_set_col_bnds(program, c, _LOWER, 0.0, 0.0)
    glpk.glp_set_obj_coef(program, 1, 1.0)
    count = len(entries)
    which = [(ctypes.c_int * (count + 1))(0, *(e[k] for e in entries)) for k in range(2)]
    glpk.glp_load_matrix(program, count, *which, (ctypes.c_double * (count + 1))(0, *(e[2] for e in entries)))
    glpk.glp_simplex(program, None)
    glpk.glp_exact(program, None)
    status, value = glpk.glp_get_status(program), glpk.glp_get_obj_val(program)
    glpk.glp_delete_prob(program)
    return value if status == _OPTIMAL else "any" if status == _UNBOUNDED else "none"
