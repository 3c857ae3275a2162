# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Shapefiles and GeoPackages for tests, byte by byte as their specifications have them (ESRI 1998; OGC 12-128r17), by
nothing that Topple or GDAL is made of."""

import sqlite3
import struct

SWISS = ('PROJCS["CH1903_LV03",GEOGCS["GCS_CH1903",DATUM["D_CH1903",SPHEROID["Bessel_1841",6377397.155,299.1528128]],'
         'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],PROJECTION["Hotine_Oblique_Mercator_Azimuth_Center"],'
         'PARAMETER["False_Easting",600000.0],PARAMETER["False_Northing",200000.0],PARAMETER["Scale_Factor",1.0],'
         'PARAMETER["Azimuth",90.0],PARAMETER["Longitude_Of_Center",7.439583333333333],'
         'PARAMETER["Latitude_Of_Center",46.95240555555556],UNIT["Meter",1.0]]')
WORLD = ('GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],'
         'PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]]')


def in_units(name, metres):
    """The same plane in another unit of length."""
    return SWISS.replace('UNIT["Meter",1.0]', f'UNIT["{name}",{metres}]')


def turn(points):
    """Twice the area of a ring, above 0 counter-clockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, [*points[1:], points[0]]))


def ring(points, clockwise):
    """Closed, and that way round."""
    points = [(float(x), float(y)) for x, y in points]
    points = points if (turn(points) < 0) == clockwise else points[::-1]
    return [*points, points[0]]


# ---- Shapefile ----------------------------------------------------------------------------------

def shape(kind, parts, heights=None):
    """The content of a record: a polyline (3), a polygon (5), with heights (13, 15), or none (0)."""
    if kind == 0:
        return struct.pack("<i", 0)
    points = [p for part in parts for p in part]
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    starts = [sum(len(q) for q in parts[:k]) for k in range(len(parts))]
    body = struct.pack("<i4d2i", kind, min(xs), min(ys), max(xs), max(ys), len(parts), len(points))
    body += struct.pack(f"<{len(starts)}i", *starts) + b"".join(struct.pack("<2d", *p) for p in points)
    if kind > 10:
        body += struct.pack(f"<{2 + len(heights)}d", min(heights), max(heights), *heights)
    return body


def table(columns, rows):
    """A .dbf of texts."""
    width = 40
    head = struct.pack("<4BIHH20x", 3, 126, 11, 23, len(rows), 33 + 32 * len(columns), 1 + width * len(columns))
    for name in columns:
        head += name.encode().ljust(11, b"\0") + b"C" + bytes(4) + bytes([width, 0]) + bytes(14)
    body = b"".join(b" " + b"".join(value.encode().ljust(width) for value in row) for row in rows)
    return head + b"\r" + body + b"\x1a"


def write_shapefile(path, kind, features, columns=("layer", "name"), projection=SWISS):
    """Features are (values of the columns, parts[, heights]); a kind of its own where there are no parts."""
    contents = [shape(kind if f[1] else 0, f[1], *f[2:]) for f in features]
    records, index, at = b"", b"", 50
    for number, content in enumerate(contents, 1):
        records += struct.pack(">2i", number, len(content) // 2) + content
        index += struct.pack(">2i", at, len(content) // 2)
        at += 4 + len(content) // 2
    points = [p for f in features for part in f[1] for p in part] or [(0, 0)]
    box = (min(p[0] for p in points), min(p[1] for p in points), max(p[0] for p in points), max(p[1] for p in points))
    for ending, body in ((".shp", records), (".shx", index)):
        head = struct.pack(">7i", 9994, 0, 0, 0, 0, 0, 50 + len(body) // 2)
        head += struct.pack("<2i8d", 1000, kind, *box, 0, 0, 0, 0)
        path.with_suffix(ending).write_bytes(head + body)
    path.with_suffix(".dbf").write_bytes(table(columns, [f[0] for f in features]))
    path.with_suffix(".prj").unlink(missing_ok=True)
    if projection is not None:
        path.with_suffix(".prj").write_text(projection)


def read_lines(path):
    """The points of every part of polylines and polygons, read back from the bytes."""
    data = path.read_bytes()
    at, lines = 100, []
    while at < len(data):
        length = 2 * struct.unpack_from(">i", data, at + 4)[0]
        kind, *_, parts, count = struct.unpack_from("<i4d2i", data, at + 8)
        if kind:
            starts = [*struct.unpack_from(f"<{parts}i", data, at + 52), count]
            points = list(struct.iter_unpack("<2d", data[at + 52 + 4 * parts: at + 52 + 4 * parts + 16 * count]))
            lines += [points[a:b] for a, b in zip(starts, starts[1:])]
        at += 8 + length
    return lines


# ---- GeoPackage ---------------------------------------------------------------------------------

def chain(points):
    width = len(points[0])
    return struct.pack("<I", len(points)) + b"".join(struct.pack(f"<{width}d", *p) for p in points)


def wkb(kind, body):
    return struct.pack("<bI", 1, kind) + body


def line_string(points):
    return wkb(1002 if len(points[0]) == 3 else 2, chain(points))


def polygon(rings):
    return wkb(3, struct.pack("<I", len(rings)) + b"".join(chain(r) for r in rings))


def collection(kind, members):
    """5 MultiLineString, 6 MultiPolygon, 7 GeometryCollection, 9 CompoundCurve, 10 CurvePolygon."""
    return wkb(kind, struct.pack("<I", len(members)) + b"".join(members))


def arc_string(points):
    return wkb(8, chain(points))


def write_geopackage(path, layers, systems=((2056, SWISS), (4326, WORLD))):
    """Layers are (name, number of its system, features), features (layer, name, WKB or None to be empty)."""
    path.unlink(missing_ok=True)
    base = sqlite3.connect(path)
    base.execute("PRAGMA page_size = 512")
    base.execute("PRAGMA application_id = 0x47504B47")
    base.execute("PRAGMA user_version = 10300")
    base.execute("CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization "
                 "TEXT NOT NULL, organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT)")
    base.execute("CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT, "
                 "description TEXT, last_change DATETIME, min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, "
                 "srs_id INTEGER)")
    base.execute("CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, "
                 "geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL)")
    known = [("Undefined cartesian SRS", -1, "NONE", -1, "undefined"),
             ("Undefined geographic SRS", 0, "NONE", 0, "undefined"),
             *((f"system {number}", number, "LOCAL", number, text) for number, text in systems)]
    base.executemany("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, NULL)", known)
    for name, system, features in layers:
        base.execute("INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id, last_change) "
                     "VALUES (?, 'features', ?, ?, '2026-11-23T00:00:00.000Z')", (name, name, system))
        base.execute("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'GEOMETRY', ?, 2, 0)", (name, system))
        base.execute(f'CREATE TABLE "{name}" (fid INTEGER PRIMARY KEY, geom GEOMETRY, layer TEXT, name TEXT)')
        for layer, own, shape_of in features:
            head = b"GP\0" + bytes([1 if shape_of else 0x11]) + struct.pack("<i", system)
            base.execute(f'INSERT INTO "{name}" (geom, layer, name) VALUES (?, ?, ?)',
                         (head + (shape_of or wkb(7, struct.pack("<I", 0))), layer, own))
    base.commit()
    base.close()
