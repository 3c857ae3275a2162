# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Back-analysis: the numbers of a scene for which a result has a wanted value."""

from __future__ import annotations

import dataclasses

from ._library import ffi, lib
from .case import GoverningFos
from .given import c_text
from .options import options_of
from .record import Bounded, Record, field, record, struct_of
from .report import written
from .scene import Scene
from .solution import Solution
from .words import FindTarget, number_of


@dataclasses.dataclass(frozen=True)
class FoundInterval(Record):
    """A stretch of solutions."""

    low: Bounded
    high: Bounded


@dataclasses.dataclass(frozen=True)
class Found(Record):
    """The numbers, in scene units, for which the target has the value: at the ends of value ± error
    of each it is certain to lie on different sides."""

    key: str
    low: float  #: the range, cut to where the scene has an answer
    high: float
    least: Bounded  #: of the results at the numbers that were looked at
    greatest: Bounded
    solutions: tuple[Bounded, ...] = field(count="count")
    touching: tuple[Bounded, ...] = field(count="touching_count")  #: a double solution, or none
    intervals: tuple[FoundInterval, ...] = field(count="interval_count")
    #: of each solution, where a factor of safety was looked for
    governing: tuple[GoverningFos, ...] | None = field(count="count", when=lambda c: c.governing != ffi.NULL)

    def report(self) -> str:
        """What was found, as `topple solve --find` prints it."""
        return written(lib.tp_report_found, struct_of(self), self.__dict__["_options"])

    def to_json(self, solution: Solution) -> str:
        """JSON, with a solution of the scene as it is."""
        return written(lib.tp_report_found_json, struct_of(self), struct_of(solution))


def find(scene: Scene, key: str, target: FindTarget | str, value: float, low: float | None = None,
         high: float | None = None) -> Found:
    """The numbers at `key` for which the target has the value, between `low` and `high` (unless
    given, 0 and ten times the scene's own number). The scene tilts in one direction; `key` is the
    way to a number in it, as in block.rounded.corners.1.radius, or the name of a parameter."""
    name = c_text(key)
    options = options_of("find", key=name, target=number_of(FindTarget, target), value=value,
                         low=low, high=high, has_low=low is not None, has_high=high is not None)
    receives = ffi.new("tp_found **")
    scene._use(lib.tp_find, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_found_free)
    found = record(Found, owner[0], owner)
    found.__dict__.update(_options=options, _key=name)
    return found
