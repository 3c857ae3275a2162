# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies: a scene solved many times, as some of its numbers vary."""

from __future__ import annotations

import os
from typing import Sequence

from ._library import ffi, lib
from .errors import checked
from .given import NULL, c_path, c_text
from .options import options_of
from .record import record
from .records import StudyResult


def study(path: str | os.PathLike, *, rows: str | os.PathLike | None = None, restart: bool = False,
          threads: int = 0, shard: tuple[int, int] = (1, 1),
          merge: Sequence[str | os.PathLike] = ()) -> StudyResult:
    """Run the study in a file (docs/study.md). `rows` is a CSV file for a row of each sample, by
    which an interrupted study goes on, unless `restart`; `shard` a part, as in (2, 5); `merge` the
    files of all shards, which are put together instead. `columns` of the result are NumPy arrays."""
    return _run(_read(lib.tp_study_read, c_path(path)), rows, restart, threads, shard, merge)


def study_text(text: str, name: str = "study", *, rows: str | os.PathLike | None = None,
               restart: bool = False, threads: int = 0, shard: tuple[int, int] = (1, 1),
               merge: Sequence[str | os.PathLike] = ()) -> StudyResult:
    """The same from text; files that it names are looked for beside a file called `name`."""
    return _run(_read(lib.tp_study_read_text, c_text(text), c_path(name)), rows, restart, threads, shard, merge)


def _read(call, *arguments):
    """A study, which is freed with what is returned."""
    receives = ffi.new("tp_study **")
    checked(call, receives, *arguments)
    return ffi.gc(receives[0], lib.tp_study_free)


def _run(own, rows, restart, threads, shard, merge) -> StudyResult:
    result = ffi.new("tp_study_result **")
    name = NULL if rows is None else c_path(rows)
    options = options_of("study", rows=name, restart=restart, threads=threads, shard=shard[0],
                         shards=shard[1])
    if merge:
        files = [c_path(file) for file in merge]
        checked(lib.tp_study_merge, result, own, ffi.new("char *[]", files), len(files), options)
    else:
        checked(lib.tp_study_run, result, own, options)
    owner = ffi.gc(result[0], lib.tp_study_result_free)
    return record(StudyResult, owner[0], owner)
