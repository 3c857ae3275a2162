# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Studies: a scene solved many times, as some of its numbers vary."""

from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING, Sequence

from ._library import ffi, lib
from .errors import checked
from .given import NULL, c_path
from .options import options_of
from .record import Record, field, record, struct_of, text
from .report import drawing, sheet_options, written
from .words import FosDefinition, StudyEnd, StudyOutcome, StudyQuantity

if TYPE_CHECKING:
    import numpy


@dataclasses.dataclass(frozen=True)
class StudyShare(Record):
    """A share of the samples, with Wilson's interval of 95 % for the probability."""

    count: int
    share: float
    low: float
    high: float


@dataclasses.dataclass(frozen=True)
class StudyTilt(Record):
    """Outcomes of the samples at a tilt."""

    of_scene: bool  #: at the scene's; where it has none, what happens first as it is tilted
    as_it_lies: bool  #: of a scene in the frame of the world: at the dip of its mean plane
    tilt_varies: bool
    tilt_deg: float | None = field(when="has_tilt")  #: where it varies, that of the scene file
    outcomes: tuple[StudyShare, ...]  #: in the order of `StudyOutcome`
    stands: StudyShare  #: certain to stand: stands and interlocked
    moves: StudyShare  #: certain to move: slides, topples, both, leaves its base

    def __getitem__(self, outcome: StudyOutcome | str) -> StudyShare:
        return self.outcomes[list(StudyOutcome).index(StudyOutcome(outcome))]


@dataclasses.dataclass(frozen=True)
class StudyQuantile(Record):
    """A quantile, with a range that holds it with 95 % certainty; infinite where there are too few
    samples."""

    probability: float
    value: float
    low: float
    high: float


@dataclasses.dataclass(frozen=True)
class StudySpread(Record):
    """How a quantity is distributed."""

    count: int  #: of the samples kept that have it
    quantiles: tuple[StudyQuantile, ...] | None = field(when="count")


@dataclasses.dataclass(frozen=True)
class StudyFactor(Record):
    """The factors of safety of samples that one definition governs."""

    definition: FosDefinition
    governs: StudyShare  #: of all samples
    below: int  #: of these, with a factor below 1
    spread: StudySpread  #: of the factors of the samples kept


@dataclasses.dataclass(frozen=True)
class StudyRank(Record):
    """Spearman's rank correlation, with its interval of 95 %; None where it has none."""

    value: float | None = field(when="known")
    low: float | None = field(when="known")
    high: float | None = field(when="known")


@dataclasses.dataclass(frozen=True)
class StudyIndex(Record):
    """Sobol' indices, with their intervals of 95 %; None where there are none."""

    first: float | None = field(when="known")
    first_low: float | None = field(when="known")
    first_high: float | None = field(when="known")
    total: float | None = field(when="known")
    total_low: float | None = field(when="known")
    total_high: float | None = field(when="known")


@dataclasses.dataclass(frozen=True)
class StudyRare(Record):
    """A probability by samples drawn where it fails; None where it has no result (`why` gives the
    reason), and where it was not requested."""

    asked: bool
    probability: float | None = field(when="known")
    low: float | None = field(when="known")
    high: float | None = field(when="known")
    variation: float | None = field(when="known")  #: its deviation over itself
    calls: int | None = field(when="known")  #: scenes solved for it
    why: str | None


def _values(c, owner) -> tuple[float, ...]:
    return tuple(c.values[k] for k in range(c.value_count))


@dataclasses.dataclass(frozen=True)
class StudyDesignPoint(Record):
    """A design point, more likely than all around it at which the quantity is what it is held against."""

    beta: float  #: its distance in deviations
    probability: float  #: of first order, by itself
    values: tuple[float, ...] = field(read=_values)  #: the numbers there, as the variables


@dataclasses.dataclass(frozen=True)
class StudyReliability(Record):
    """First-order reliability; None all where the study does not request it."""

    quantity: StudyQuantity | None = field(when="known")
    converged: bool | None = field(when="known")
    state: str | None = field(when="known")  #: how the search for the design point ended
    beta: float | None = field(when="known")
    probability: float | None = field(when="known")
    calls: int | None = field(when="known")  #: scenes solved for it
    importance: StudyRare  #: by samples around the design points
    subset: StudyRare  #: by subset simulation
    points: tuple[StudyDesignPoint, ...] = field(count="point_count")  #: the nearest first


@dataclasses.dataclass(frozen=True)
class StudyCorrelation(Record):
    """Two numbers that are drawn with a correlation of their normal scores."""

    one: int  #: of the variables
    other: int
    value: float


@dataclasses.dataclass(frozen=True)
class StudyMeasure(Record):
    """A number of roughness of the base of each sample, or an angle of Eqs. (15) and (16)."""

    name: str  #: amplitude, rms_height, z2, effective_angle_deg, jrc, peak_deg or valley_deg
    unit: str | None
    count: int  #: of the samples kept that have it
    least: float | None = field(when="count")  #: of these
    greatest: float | None = field(when="count")
    ranks: tuple[StudyRank, ...]  #: in the order of `StudyQuantity`


@dataclasses.dataclass(frozen=True)
class StudyDesign(Record):
    """The design value of one number: with it, and all others as they stand in the scene, the quantity
    is what samples have with the probability wanted; None where there is none (`why` gives the reason)."""

    variable: int  #: which of the variables
    probability: float
    quantity: StudyQuantity
    value: float | None = field(when="known")
    low: float | None = field(when="known")
    high: float | None = field(when="known")
    low_is_safe: bool | None = field(when="known")  #: else the high end of the interval
    quantity_value: float | None = field(when="known")  #: of the scene with it
    scene_value: float  #: the number as it stands in the scene
    calls: int  #: scenes solved for it
    why: str | None


@dataclasses.dataclass(frozen=True)
class StudyVariable(Record):
    """A number that varies."""

    key: str
    kind: str  #: normal, list and so on
    unit: str | None  #: deg, m, kPa and so on
    law: str  #: by what it varies, in words
    least: float
    greatest: float
    ranks: tuple[StudyRank, ...]  #: in the order of `StudyQuantity`
    indices: tuple[StudyIndex, ...]  #: likewise
    design_value: float  #: where reliability is known: at the design point,
    importance: float  #: and its share of the variance there


@dataclasses.dataclass(frozen=True)
class StudyStep(Record):
    """The probability to move as samples came in."""

    samples: int
    moves: StudyShare


@dataclasses.dataclass(frozen=True)
class StudyBad(Record):
    """A sample whose numbers do not form a valid scene."""

    sample: int
    settings: str  #: KEY=VALUE KEY=VALUE
    why: str


@dataclasses.dataclass(frozen=True)
class StudyResult(Record):
    """The summary of a study. Quantiles, ranks, ranges and columns are of the first `kept` samples."""

    title: str | None
    scene: str
    method: str
    seed: int
    planned: int
    samples: int
    kept: int
    end: StudyEnd
    shard: int
    shards: int
    half_width: float  #: asked of every interval; 0: none was
    open: int  #: samples with a number less certain than to 9 digits
    by_doubles: int  #: samples solved in doubles with proven bounds; the others in higher precision
    doubles_seconds: float  #: of computing, of those solved in this run, by doubles
    ladder_seconds: float  #: and in higher precision
    tilts: tuple[StudyTilt, ...] = field(count="tilt_count")
    variables: tuple[StudyVariable, ...] = field(count="variable_count")
    correlations: tuple[StudyCorrelation, ...] = field(count="correlation_count")
    spreads: tuple[StudySpread, ...]  #: in the order of `StudyQuantity`
    factors: tuple[StudyFactor, ...]  #: in the order of `FosDefinition`
    sensitivity_samples: int  #: of Sobol' indices; 0: none were asked for
    reliability: StudyReliability
    measures: tuple[StudyMeasure, ...] = field(count="measure_count")
    bracketed: int  #: samples kept with both angles of Eqs. (15) and (16); of these
    within: int  #: those whose critical angle by moments lies between
    designs: tuple[StudyDesign, ...] = field(count="design_count")
    steps: tuple[StudyStep, ...] = field(count="step_count")
    bad: tuple[StudyBad, ...] = field(count="bad_count")
    #: by the names in the header of the rows: arrays of shape (kept,), of outcomes `StudyOutcome`, of
    #: definitions `FosDefinition` or None
    columns: dict = field(read=lambda c, owner: _columns(c))
    #: files that it was read from, and those of its rows: no chart of it is written over them
    sources: tuple[str, ...] = field(read=lambda c, owner: _sources(c))

    def spread(self, quantity: StudyQuantity | str) -> StudySpread:
        """Of one quantity."""
        return self.spreads[list(StudyQuantity).index(StudyQuantity(quantity))]

    def report(self) -> str:
        """The summary, as `topple study` prints it."""
        return written(lib.tp_report_study, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_study_json, struct_of(self))

    def write_report(self, path: str | os.PathLike, study: str | os.PathLike,
                     date: str | None = None, times: bool = True, lines: int = 400) -> None:
        """Write a calculation sheet into a file: .html, .md or .pdf (Solution.write_report). `study`
        is the file that was run, of which it names all that it rests on."""
        receives = ffi.new("tp_study **")
        checked(lib.tp_study_read, receives, c_path(study))
        own = ffi.gc(receives[0], lib.tp_study_free)
        options, _held = sheet_options(date, times, lines)
        checked(drawing().lib.tp_report_sheet_study, c_path(path), own, struct_of(self), options)


def _sources(c) -> tuple[str | None, ...]:
    return tuple(text(c.sources[k]) for k in range(c.source_count))


def _columns(c) -> dict[str, numpy.ndarray]:
    """All columns by their names."""
    import numpy

    outcomes = numpy.array(list(StudyOutcome), dtype=object)
    definitions = numpy.array([*FosDefinition, None], dtype=object)  # the last where there is none
    columns = {}
    for k in range(c.column_count if c.kept else 0):
        own = c.columns[k]
        values = numpy.frombuffer(ffi.buffer(own.values, 8 * c.kept), dtype="f8").copy()
        name = ffi.string(own.header).decode("utf-8", "replace")
        outcome = c.variable_count + len(StudyQuantity)
        if outcome <= k <= outcome + c.tilt_count - 1:
            columns[name] = outcomes[values.astype(int)]
        elif k == outcome + c.tilt_count:
            columns[name] = definitions[numpy.where(numpy.isnan(values), -1, values).astype(int)]
        else:
            columns[name] = values
    return columns


def study(path: str | os.PathLike, *, rows: str | os.PathLike | None = None, restart: bool = False,
          threads: int = 0, shard: tuple[int, int] = (1, 1),
          merge: Sequence[str | os.PathLike] = ()) -> StudyResult:
    """Run the study in a file (docs/study.md). `rows` is a CSV file for a row of each sample, by
    which an interrupted study goes on, unless `restart`; `shard` a part, as in (2, 5); `merge` the
    files of all shards, which are put together instead. `columns` of the result are NumPy arrays."""
    receives, result = ffi.new("tp_study **"), ffi.new("tp_study_result **")
    checked(lib.tp_study_read, receives, c_path(path))
    own = ffi.gc(receives[0], lib.tp_study_free)
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
