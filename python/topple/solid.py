# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A solid rock, its poses and its tilts, from a mesh (docs/solids.md)."""

from __future__ import annotations

from collections.abc import Sequence

from ._library import ffi, lib
from .errors import checked
from .given import NULL, File, c_path, c_text
from .options import options_of
from .record import record
from .records import Solid
from .scene import warn


def solid_of_file(path: File, *, length_unit: str | None = None, object: str | None = None,
                  unit_weight_kn_m3: float | None = None, friction_angle_deg: float | None = None,
                  up: Sequence[float] | None = None, bands: Sequence[float] | None = None,
                  azimuths: int | None = None, repair: bool | None = None,
                  repair_merge_within: float | None = None, repair_drop_below: float | None = None,
                  below: float | None = None, thin: float | None = None) -> Solid:
    """The solid of a closed mesh, an STL, PLY or OBJ. `object` is a solid, o or g in the file;
    `up` the direction upwards, of any length; `bands` heights over the lowest point, in lengths of
    the mesh, within which all is taken to touch the base. `repair` mends a mesh that is not closed, also by merging points
    as near as `repair_merge_within` and dropping pieces below the share `repair_drop_below` of the area; the solid's
    `repair` says what was done. `below`, instead of bands, is the height of a plane that cuts the solid, which rests on the
    section. `thin` is a length by which the mesh is thinned; the solid's `thinning` says how."""
    unit = NULL if length_unit is None else c_text(length_unit)
    name = NULL if object is None else c_text(object)
    heights = None if bands is None else ffi.new("double[]", [float(band) for band in bands])
    options = options_of("solid", length_unit=unit, object=name, unit_weight_kn_m3=unit_weight_kn_m3,
                         friction_angle_deg=friction_angle_deg, up=None if up is None else [float(x) for x in up],
                         bands=heights, band_count=None if bands is None else len(bands), azimuths=azimuths, repair=repair,
                         repair_merge_within=repair_merge_within, repair_drop_below=repair_drop_below, below=below, thin=thin)
    receives = ffi.new("tp_solid **")
    checked(lib.tp_solid_of_file, receives, c_path(path), options)
    owner = ffi.gc(receives[0], lib.tp_solid_free)
    solid = record(Solid, owner[0], owner)
    warn(solid.notes, 3)
    return solid
