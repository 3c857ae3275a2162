# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The influence of the settings of a simulated tilt test on its answer, and the cost of each
(docs/tilt_converge.md). Simulated numbers have no proven bound: they are floats."""

from __future__ import annotations

import dataclasses

from ._library import ffi, lib
from .chart import Chart, made
from .contact import Note, notes_of
from .options import options_of
from .record import Record, field, record, struct_of, text
from .report import written
from .scene import Scene
from .tilt import TiltSettings
from .words import ConvergeQuantity, ConvergeSetting, ConvergeVerdict, Direction


@dataclasses.dataclass(frozen=True)
class ConvergeLevel(Record):
    """The test with one setting at one value, all others being as they are set."""

    setting: ConvergeSetting
    value: float  #: in the unit of the setting; infinite: the limit of stiff contacts
    own: bool  #: it is as the scene has it, or as it was refined before
    least: float | None = field(when="known")  #: the bracket, degrees or factors
    most: float | None = field(when="known")
    runs: int  #: of the engine
    seconds: float  #: that they took


@dataclasses.dataclass(frozen=True)
class ConvergeFinding(Record):
    """The result for one setting."""

    setting: ConvergeSetting
    verdict: ConvergeVerdict
    spread: float  #: the width of all that must agree
    needed: float | None = field(when="has_needed")  #: the cheapest value that does
    first: int  #: of its levels among those of the case
    count: int


@dataclasses.dataclass(frozen=True)
class ConvergenceCase(Record):
    """One direction of tilt."""

    towards: Direction
    onset_deg: float | None = field(when="has_onset")  #: of statics
    limit_deg: float | None = field(when="has_limit")
    own_least: float | None = field(when="known")  #: the bracket of the test as it is set
    own_most: float | None = field(when="known")
    least: float | None = field(when="known")  #: over that and the finest levels
    most: float | None = field(when="known")
    converged: bool  #: every setting holds, or was refined
    findings: tuple[ConvergeFinding, ...] = field(count="finding_count")
    levels: tuple[ConvergeLevel, ...] = field(count="level_count")


def _sources(c, owner) -> tuple[str | None, ...]:
    return tuple(text(c.sources[k]) for k in range(c.source_count))


@dataclasses.dataclass(frozen=True)
class Convergence(Record):
    """A test over its settings."""

    title: str | None
    settings: TiltSettings
    quantity: ConvergeQuantity
    asked: float  #: by how much settings may change it: degrees; of a factor its share
    cases: tuple[ConvergenceCase, ...] = field(count="case_count")
    notes: tuple[Note, ...] = field(read=notes_of)
    sources: tuple[str, ...] = field(read=_sources)  #: files that the scene was read from

    def report(self) -> str:
        """The page, as `topple tilt --converge` prints it."""
        return written(lib.tp_report_tilt_convergence, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_tilt_convergence_json, struct_of(self))

    def chart(self) -> Chart:
        """The answer against what it costs."""
        return made(lib.tp_chart_tilt_convergence, struct_of(self))

    def _repr_svg_(self) -> str:
        return self.chart().svg()


def tilt_converge(scene: Scene) -> Convergence:
    """The test that the scene calls for, over stiffness, time step, damping and tolerance."""
    receives = ffi.new("tp_tilt_convergence **")
    scene._use(lib.tp_tilt_converge, receives, scene._c, options_of("tilt"))
    owner = ffi.gc(receives[0], lib.tp_tilt_convergence_free)
    return record(Convergence, owner[0], owner)
