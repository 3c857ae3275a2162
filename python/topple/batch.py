# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Many blocks that were surveyed, a row of a table each, solved and put in order (docs/batch.md)."""

from __future__ import annotations

from typing import Any

from ._library import ffi, lib
from .errors import checked
from .given import NULL, File, c_path, c_text
from .options import options_of
from .record import record
from .records import Batch
from .word import number_of
from .words import Level


def batch(path: File, *, scene: File | None = None,
          threads: int | None = None, digits: int | None = None,
          level: Level | str | None = None) -> Batch:
    """Solve each row of a table of blocks, the worst first. `scene` is the file over which the
    cells of a row are put, where the row names none. A row that is wrong has a remark instead of
    numbers; its `scene`, where there is one, can be read by Scene.from_text."""
    return _solved(lib.tp_batch_solve, (c_path(path),), scene, threads, digits, level)


def batch_text(text: str, name: str = "table", *, scene: File | None = None,
               threads: int | None = None, digits: int | None = None,
               level: Level | str | None = None) -> Batch:
    """The same from text; files that rows name are looked for beside a file called `name`."""
    return _solved(lib.tp_batch_solve_text, (c_text(text), c_path(name)), scene, threads, digits, level)


def _solved(call: Any, table: tuple[Any, ...], scene: File | None, threads: int | None,
            digits: int | None, level: Level | str | None) -> Batch:
    held = NULL if scene is None else c_path(scene)
    options = options_of("batch", scene=held, threads=threads, digits=digits,
                         level=None if level is None else number_of(Level, level))
    receives = ffi.new("tp_batch **")
    checked(call, receives, *table, options)
    owner = ffi.gc(receives[0], lib.tp_batch_free)
    return record(Batch, owner[0], owner)
