# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies: a scene solved many times, as some of its numbers vary."""

from __future__ import annotations

from typing import Any, Sequence

from ._library import ffi, lib
from .errors import checked
from .given import NULL, File, c_path, c_text
from .options import options_of
from .record import record
from .records import StudyResult
from .running import Progress, Run, Stop

def study(path: File, *, rows: File | None = None, restart: bool = False,
          threads: int = 0, shard: tuple[int, int] = (1, 1),
          merge: Sequence[File] = (), stop: Stop = None,
          progress: Progress = None) -> StudyResult:
    """Run the study in a file (docs/study.md). `rows` is a CSV file for a row of each sample, by
    which an interrupted study goes on, unless `restart`; or HDF5, where it ends in .h5, made of the
    CSV beside it. `shard` is a part, as in (2, 5); `merge` the files of all shards, which are put
    together instead. `columns` of the result are NumPy arrays.

    `stop` is asked now and then, and true ends the study with the samples so far (`end` is
    StudyEnd.INTERRUPTED); `progress` is given the samples done and planned, True shows them. Ctrl-C
    raises Interrupted, a KeyboardInterrupt whose `result` is of the samples so far."""
    return _run(_read(lib.tp_study_read, c_path(path)), rows, restart, threads, shard, merge, Run(stop, progress))


def study_text(text: str, name: str = "study", *, rows: File | None = None,
               restart: bool = False, threads: int = 0, shard: tuple[int, int] = (1, 1),
               merge: Sequence[File] = (), stop: Stop = None,
               progress: Progress = None) -> StudyResult:
    """The same from text; files that it names are looked for beside a file called `name`."""
    return _run(_read(lib.tp_study_read_text, c_text(text), c_path(name)), rows, restart, threads, shard, merge,
                Run(stop, progress))


def _read(call: Any, *arguments: Any) -> Any:
    """A study, which is freed with what is returned."""
    receives = ffi.new("tp_study **")
    checked(call, receives, *arguments)
    return ffi.gc(receives[0], lib.tp_study_free)


def _run(own: Any, rows: File | None, restart: bool, threads: int, shard: tuple[int, int], merge: Sequence[File],
         run: Run) -> StudyResult:
    result = ffi.new("tp_study_result **")
    name = NULL if rows is None else c_path(rows)
    options = options_of("study", rows=name, restart=restart, threads=threads, shard=shard[0],
                         shards=shard[1], **run.options("run_counts"))
    if merge:
        files = [c_path(file) for file in merge]
        checked(lib.tp_study_merge, result, own, ffi.new("char *[]", files), len(files), options)
    else:
        run.call(checked, lib.tp_study_run, result, own, options)
    owner = ffi.gc(result[0], lib.tp_study_result_free)
    return run.ended_with(record(StudyResult, owner[0], owner))
