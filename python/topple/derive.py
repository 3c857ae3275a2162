# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The closed formulas of a scene in its parameters."""

from __future__ import annotations

from ._library import ffi, lib
from .options import options_of
from .record import record
from .records import Derivation, Family
from .scene import Scene, warn
from .word import number_of
from .words import Notation


def derive(scene: Scene, *, notation: Notation | str = Notation.TEXT, elements: bool | None = None,
           rounded: bool | None = None, limit: bool | None = None,
           checked: bool | None = None) -> Derivation:
    """The closed formulas of a scene in its parameters, in scene lengths; a scene from a file or a
    text, as one built in memory has no parameters. `elements`: the elements form; `rounded`: the
    corners at the governing pivots; `limit`: the static limit and the onset of motion; `checked`:
    their conditions checked on both sides in numbers."""
    options = options_of("derive", notation=number_of(Notation, notation), elements=elements,
                         rounded=rounded, limit=limit, checked=checked)
    receives = ffi.new("tp_derivation **")
    scene._use(lib.tp_derive, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_derivation_free)
    derivation = record(Derivation, owner[0], owner)
    warn(derivation.notes, 3)
    return derivation


def derive_family(scene: Scene, notation: Notation | str = Notation.TEXT) -> Family:
    """One formula for every number of teeth of a toothed block, for the scene's left end."""
    receives = ffi.new("tp_family **")
    scene._use(lib.tp_derive_family, receives, scene._c, number_of(Notation, notation))
    owner = ffi.gc(receives[0], lib.tp_family_free)
    return record(Family, owner[0], owner)
