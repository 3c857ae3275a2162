# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""A scene solved at each point of a range of one or two of its numbers, as columns."""

from __future__ import annotations

import csv
import dataclasses
import os
from typing import TYPE_CHECKING, Any

from ._library import ffi, lib
from .given import File, c_path, c_text
from .options import options_of
from .running import Run, Stop
from .scene import Scene
from .word import number_of
from .words import Level

if TYPE_CHECKING:
    import numpy
    import pandas  # type: ignore[import]
    import xarray

#: Columns of words; all others are of numbers.
WORDS = {"status", "towards", "verdict", "fos_mechanism", "fos_definition", "limit_mechanism",
         "can_begin", "first", "pivot_kind", "message", "fos_is", "governing_fos_is", "fos_driving_is", "support_is", "collapse", "meets_required"}


@dataclasses.dataclass(frozen=True)
class Sweep:
    """A sweep: a row for each direction of each point, in their order. `numbers` has what was set,
    by the names of the columns (friction_angle_deg, block.slab.width_mm), `columns` what it came
    to, as `topple sweep` prints it: columns["moments_deg"], columns["moments_error"]. A number that
    is not known is NaN, a word empty."""

    numbers: dict[str, numpy.ndarray[Any, Any]]
    columns: dict[str, numpy.ndarray[Any, Any]]

    def __len__(self) -> int:
        return len(self.columns["status"])

    def to_dataframe(self) -> pandas.DataFrame:
        """As a table of pandas, a row each."""
        import pandas

        return pandas.DataFrame({**self.numbers, **self.columns})

    def to_xarray(self) -> xarray.Dataset:
        """As a grid of xarray over the numbers that were swept and the direction of tilt."""
        import xarray

        varied = [name for name, values in self.numbers.items() if len(set(values)) > 1]
        table = self.to_dataframe().set_index([*varied, "towards"])
        return xarray.Dataset.from_dataframe(table)


@ffi.def_extern(error=False)  # type: ignore[misc]
def take_text(context: Any, text: Any) -> bool:
    """A piece of a text that the library writes, until its run is to stop."""
    run, pieces = ffi.from_handle(context)
    pieces.append(ffi.string(text))
    return not run.c.stop


def sweep(scene: Scene, x: str, y: str | None = None, *, threads: int | None = None,
          digits: int | None = None, level: Level | str | None = None, stop: Stop = None) -> Sweep:
    """Solve at each point of `x`, "KEY=FIRST:LAST:STEP" or "KEY=VALUE,VALUE", and of `y`, at each
    of whose values x is swept. Values are exact, and so is each point. A point that is wrong has a
    status and a message instead of numbers. `stop` is asked now and then, and true ends the sweep with the
    points solved by then. Ctrl-C raises Interrupted, a KeyboardInterrupt whose `result` has these."""
    keep = c_text(x), c_text(y) if y is not None else None
    options = options_of("sweep", x=keep[0], y=keep[1], threads=threads, digits=digits,
                         level=None if level is None else number_of(Level, level))
    pieces: list[bytes] = []
    run = Run(stop)
    handle = ffi.new_handle((run, pieces))
    run.call(scene._use, lib.tp_sweep_write, ffi.new("tp_sweep_summary *"), scene._c, options,
             lib.TP_SWEEP_CSV, {"take": lib.take_text, "context": handle})
    return run.ended_with(_columns(b"".join(pieces).decode("utf-8")))


def write_sweep(scene: Scene, path: File, x: str, y: str | None = None, *,
                threads: int | None = None, digits: int | None = None,
                level: Level | str | None = None) -> None:
    """The same into a file, CSV or, where it ends in .json, JSON, which appears whole or not at
    all."""
    keep = c_text(x), c_text(y) if y is not None else None
    options = options_of("sweep", x=keep[0], y=keep[1], threads=threads, digits=digits,
                         level=None if level is None else number_of(Level, level))
    json = os.fspath(path).lower().endswith(".json")
    scene._use(lib.tp_sweep_write_file, ffi.new("tp_sweep_summary *"), c_path(path), scene._c, options, lib.TP_SWEEP_JSON if json else lib.TP_SWEEP_CSV)


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
