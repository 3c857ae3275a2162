# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Drawings for tests: DXF written group by group, and the outlines that several formats share."""


def group(code, value):
    return f"{code:>3}\n{value}\n"


def entity(name, layer, *pairs):
    return group(0, name) + group(8, layer) + "".join(group(code, value) for code, value in pairs)


def line(layer, x0, y0, x1, y1, *more):
    return entity("LINE", layer, (10, x0), (20, y0), (30, 0), (11, x1), (21, y1), (31, 0), *more)


def arc(layer, x, y, radius, start, end, *more):
    return entity("ARC", layer, (10, x), (20, y), (30, 0), (40, radius), *more, (50, start), (51, end))


def circle(layer, x, y, radius):
    return entity("CIRCLE", layer, (10, x), (20, y), (40, radius))


def light_polyline(layer, points, closed=True, more=()):
    """Of points (x, y) or (x, y, bulge)."""
    pairs = [(90, len(points)), (70, int(closed)), *more]
    for point in points:
        pairs += [(10, point[0]), (20, point[1])]
        if len(point) > 2:
            pairs.append((42, point[2]))
    return entity("LWPOLYLINE", layer, *pairs)


def polyline(layer, points, closed=True):
    text = entity("POLYLINE", layer, (66, 1), (70, int(closed)))
    for point in points:
        pairs = [(10, point[0]), (20, point[1])] + ([(42, point[2])] if len(point) > 2 else [])
        text += entity("VERTEX", layer, *pairs)
    return text + entity("SEQEND", layer)


def block(name, entities, x=0, y=0):
    return (group(0, "BLOCK") + group(8, "0") + group(2, name) + group(70, 0) + group(10, x) + group(20, y) + entities
            + group(0, "ENDBLK") + group(8, "0"))


def insert(layer, name, x, y, *more):
    return entity("INSERT", layer, (2, name), (10, x), (20, y), *more)


def section(name, body):
    return group(0, "SECTION") + group(2, name) + body + group(0, "ENDSEC")


def layer(name, colour=7, flags=0):
    """Of the table of layers: off where its colour is below 0, frozen where 1 is in its flags."""
    return group(0, "LAYER") + group(2, name) + group(70, flags) + group(62, colour) + group(6, "CONTINUOUS")


def dxf(entities, unit=4, version="AC1015", blocks="", layers=""):
    """A whole file; $INSUNITS 4 is mm, None is not said."""
    header = group(9, "$ACADVER") + group(1, version)
    if unit is not None:
        header += group(9, "$INSUNITS") + group(70, unit)
    tables = section("TABLES", group(0, "TABLE") + group(2, "LAYER") + layers + group(0, "ENDTAB")) if layers else ""
    return section("HEADER", header) + tables + section("BLOCKS", blocks) + section("ENTITIES", entities) + group(0, "EOF")
