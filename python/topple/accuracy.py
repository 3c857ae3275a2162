# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Cost of accuracy: every method in every arithmetic, timed, against exact values."""

from __future__ import annotations

import dataclasses

from ._library import ffi, lib
from .chart import Chart, made
from .converge import Convergence
from .errors import checked
from .record import Bounded, Record, field, record, struct_of, text
from .report import written
from .scene import Scene
from .words import AccuracyMethod, Direction, Level


@dataclasses.dataclass(frozen=True)
class AccuracyRun(Record):
    """One method in one arithmetic. Angles are in degrees; logarithms serve where doubles underflow."""

    method: AccuracyMethod
    level: Level
    bits: int  #: working precision of what follows the sums
    vertices: int
    seconds: float  #: of one evaluation: median of several
    bound: float | None = field(when="has_bound")  #: proven
    log10_bound: float | None = field(when="has_bound")
    true_error: float  #: against the exact value
    log10_true_error: float


@dataclasses.dataclass(frozen=True)
class AccuracyValue(Record):
    """The result of one method, within the bound of every arithmetic."""

    method: AccuracyMethod
    vertices: int
    angle_deg: Bounded


def _sources(c, owner) -> tuple[str | None, ...]:
    return tuple(text(c.sources[k]) for k in range(c.source_count))


@dataclasses.dataclass(frozen=True)
class Accuracy(Record):
    """Every method that a scene requires, in every arithmetic, or of blocks of many sizes (`sweep`)."""

    title: str | None
    sweep: bool
    towards: Direction
    runs: tuple[AccuracyRun, ...] = field(count="run_count")
    values: tuple[AccuracyValue, ...] = field(count="value_count")
    sources: tuple[str, ...] = field(read=_sources)  #: files that the scene was read from
    simulated: Convergence | None  #: of a scene that calls for a tilt test or for shaking

    def report(self) -> str:
        """The report, as `topple accuracy` prints it."""
        return written(lib.tp_report_accuracy, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_accuracy_json, struct_of(self))

    def chart(self) -> Chart:
        """Time against digits; or of a sweep, time and bound against size."""
        return made(lib.tp_chart_accuracy, struct_of(self))

    def _repr_svg_(self) -> str:
        return self.chart().svg()


def accuracy_of_scene(scene: Scene) -> Accuracy:
    """Measure every method that the scene calls for, in the first direction in which it tilts."""
    receives = ffi.new("tp_accuracy **")
    scene._use(lib.tp_accuracy_of_scene, receives, scene._c)
    owner = ffi.gc(receives[0], lib.tp_accuracy_free)
    return record(Accuracy, owner[0], owner)


def accuracy_sweep(least: int, most: int) -> Accuracy:
    """The same for blocks on rough bases of `least` to `most` vertices (10 to 10^7), in steps of
    ten."""
    receives = ffi.new("tp_accuracy **")
    checked(lib.tp_accuracy_sweep, receives, least, most)
    owner = ffi.gc(receives[0], lib.tp_accuracy_free)
    return record(Accuracy, owner[0], owner)
