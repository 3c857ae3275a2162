# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Back-analysis: the numbers of a scene for which a result has a wanted value."""

from __future__ import annotations

from ._library import ffi, lib
from .given import c_text
from .options import options_of
from .record import record
from .records import Found
from .running import Run
from .scene import Scene
from .word import number_of
from .words import FindTarget


def find(scene: Scene, key: str, target: FindTarget | str, value: float, low: float | None = None,
         high: float | None = None, least_over: str | None = None) -> Found:
    """The numbers at `key` for which the target has the value, between `low` and `high` (unless
    given, 0 and ten times the scene's own number). The scene tilts in one direction; `key` is the
    way to a number in it, as in block.rounded.corners.1.radius, or the name of a parameter.
    `least_over` is the key of an anchor's direction, dip_deg or direction_deg: that of the least force at
    `key`."""
    name = c_text(key)
    direction = None if least_over is None else c_text(least_over)
    options = options_of("find", key=name, target=number_of(FindTarget, target), value=value,
                         low=low, high=high, has_low=low is not None, has_high=high is not None,
                         least_over=direction)
    receives = ffi.new("tp_found **")
    Run().call(lambda: (scene._use(lib.tp_find, receives, scene._c, options), name), leaves=True)
    owner = ffi.gc(receives[0], lib.tp_found_free)
    found = record(Found, owner[0], owner)
    found.__dict__.update(_options=options, _key=name, _direction=direction)
    return found
