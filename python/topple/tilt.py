# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Simulated tilt tests, and the shaking of a base (docs/tilt.md). Simulated numbers have no proven
bound: they are floats."""

from __future__ import annotations

from ._library import ffi, lib
from .options import options_of
from .record import record
from .records import TiltTest
from .running import Progress, Run, Stop
from .scene import Scene


def tilt_test(scene: Scene, *, moments: int | None = None,
              overturning: bool | None = None,
              factors: tuple[float, float, int] | None = None, smaller: int | None = None,
              stop: Stop = None, progress: Progress = None) -> TiltTest:
    """Run the test that the scene calls for. `moments`: of the history, at most, 400 unless given;
    `overturning`: which factors on the scene's shaking overturn the block, of the least, the
    greatest and the number of them that `factors` gives, else of those of `topple tilt`;
    `smaller`: how many smaller factors are tried, 128 unless given, where it is not overturned.

    `stop` is asked now and then, and true ends the test with what is known by then (`end` is
    TiltEnd.STOPPED); `progress` is given the number of runs. Ctrl-C raises Interrupted, a
    KeyboardInterrupt whose `result` is the test so far."""
    receives = ffi.new("tp_tilt_test **")
    run = Run(stop, progress)
    least, most, count = factors or (None, None, None)
    options = options_of("tilt", moments=moments, overturning=overturning, overturning_from=least,
                         overturning_to=most, overturning_count=count, smaller_count=smaller,
                         **run.options("run_brackets"))
    run.call(scene._use, lib.tp_tilt_test_run, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_tilt_test_free)
    return run.ended_with(record(TiltTest, owner[0], owner))
