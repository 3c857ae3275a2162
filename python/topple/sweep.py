# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A scene solved at each point of a range of one or two of its numbers, as columns."""

from __future__ import annotations

import csv
import dataclasses
import os
from typing import TYPE_CHECKING

from ._library import ffi, lib
from .given import c_path, c_text
from .options import options_of
from .scene import Scene
from .words import Level, number_of

if TYPE_CHECKING:
    import numpy

#: Columns of words; all others are of numbers.
WORDS = {"status", "towards", "verdict", "fos_mechanism", "fos_definition", "limit_mechanism",
         "can_begin", "first", "pivot_kind", "message"}


@dataclasses.dataclass(frozen=True)
class Sweep:
    """A sweep: a row for each direction of each point, in their order. `numbers` has what was set,
    by the names of the columns (friction_angle_deg, block.slab.width_mm), `columns` what it came
    to, as `topple sweep` prints it: columns["moments_deg"], columns["moments_error"]. A number that
    is not known is NaN, a word empty."""

    numbers: dict[str, numpy.ndarray]
    columns: dict[str, numpy.ndarray]

    def __len__(self) -> int:
        return len(self.columns["status"])


@ffi.def_extern(error=False)
def take_text(context, text) -> bool:
    """A piece of a text that the library writes."""
    ffi.from_handle(context).append(ffi.string(text))
    return True


def sweep(scene: Scene, x: str, y: str | None = None, *, threads: int | None = None,
          digits: int | None = None, level: Level | str | None = None) -> Sweep:
    """Solve at each point of `x`, "KEY=FIRST:LAST:STEP" or "KEY=VALUE,VALUE", and of `y`, at each
    of whose values x is swept. Values are exact, and so is each point. A point that is wrong has a
    status and a message instead of numbers."""
    keep = c_text(x), c_text(y) if y is not None else None
    options = options_of("sweep", x=keep[0], y=keep[1], threads=threads, digits=digits,
                         level=None if level is None else number_of(Level, level))
    pieces: list[bytes] = []
    handle = ffi.new_handle(pieces)
    scene._use(lib.tp_sweep_write, ffi.new("tp_sweep_summary *"), scene._c, options,
               lib.TP_SWEEP_CSV, {"take": lib.take_text, "context": handle})
    return _columns(b"".join(pieces).decode("utf-8"))


def write_sweep(scene: Scene, path: str | os.PathLike, x: str, y: str | None = None, *,
                threads: int | None = None, digits: int | None = None,
                level: Level | str | None = None) -> None:
    """The same into a file, CSV or, where it ends in .json, JSON, which appears whole or not at
    all."""
    keep = c_text(x), c_text(y) if y is not None else None
    options = options_of("sweep", x=keep[0], y=keep[1], threads=threads, digits=digits,
                         level=None if level is None else number_of(Level, level))
    json = os.fspath(path).lower().endswith(".json")
    scene._use(lib.tp_sweep_write_file, ffi.new("tp_sweep_summary *"), scene._c, options,
               lib.TP_SWEEP_JSON if json else lib.TP_SWEEP_CSV, c_path(path))


def _columns(text: str) -> Sweep:
    import numpy

    head, *rows = csv.reader(text.splitlines())
    first = len(head) - 1 - head[::-1].index("status")  # a parameter may be called so, too
    columns = list(zip(*rows)) if rows else [()] * len(head)
    made = [numpy.array(column) if k >= first and name in WORDS
            else numpy.array([float(own) if own else numpy.nan for own in column])
            for k, (name, column) in enumerate(zip(head, columns))]
    named = list(zip(head, made))
    return Sweep(dict(named[:first]), dict(named[first:]))
