# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The influence of the settings of a simulated tilt test on its answer, and the cost of each
(docs/tilt_converge.md). Simulated numbers have no proven bound: they are floats."""

from __future__ import annotations

from ._library import ffi, lib
from .options import options_of
from .record import record
from .records import Convergence
from .running import Progress, Run, Stop
from .scene import Scene


def tilt_converge(scene: Scene, *, stop: Stop = None, progress: Progress = None) -> Convergence:
    """The test that the scene calls for, over stiffness, time step, damping and tolerance. `stop`,
    `progress` and ctrl-C as of `tilt_test`."""
    receives = ffi.new("tp_tilt_convergence **")
    run = Run(stop, progress)
    options = options_of("tilt", **run.options("run_brackets"))
    run.call(scene._use, lib.tp_tilt_converge, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_tilt_convergence_free)
    return run.ended_with(record(Convergence, owner[0], owner))
