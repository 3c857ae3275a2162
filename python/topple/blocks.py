# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Many blocks held in arrays: their moments, their critical angles, their verdicts. Python does
nothing block by block.

Outlines are an array of shape (k, n, 2), or of shape (n, 2) for one, or a sequence of arrays of
shape (n_i, 2), of doubles or what doubles hold, of any layout; either way round, the first point
repeated at the end or not. Results are arrays of shape (k,): every number beside its error, NaN
where a block has none. A block that is bad input stops nothing: `status` says which, `summary` how
many and why the first, and a `Caution` is issued."""

from __future__ import annotations

import dataclasses
import enum
import warnings
from typing import TYPE_CHECKING, Any, Sequence, Union

from ._library import ffi, lib
from .errors import BadInput, Caution, checked
from .given import NULL, Points, c_doubles, real_doubles, refuse_masked
from .options import options_of
from .record import Bounded, Record, record
from .running import Run
from .word import number_of
from .words import FosDefinition, Direction, LimitKind, Mechanism, OnsetKind

if TYPE_CHECKING:
    import numpy
    import pandas  # type: ignore[import]

#: Outlines of many blocks.
Outlines = Union["numpy.ndarray[Any, Any]", Sequence["numpy.ndarray[Any, Any]"]]


class Status(enum.IntEnum):
    """Status of one block."""

    OK = 0
    BAD_INPUT = 1
    NO_ANSWER = 2
    UNDECIDED = 3
    OUT_OF_MEMORY = 4
    SYSTEM_FAILED = 5
    DEPENDENCY_FAILED = 6


@dataclasses.dataclass(frozen=True)
class Summary(Record):
    """Summary of the blocks: counts that add up to all of them, but for `climbed`."""

    done: int
    without: int  #: no pivot is admissible
    undecided: int  #: at the precision allowed
    bad: int  #: bad input
    climbed: int  #: of them all, those that doubles did not decide
    first_bad: int | None  #: the first block that is bad input,
    complaint: str | None  #: and what is wrong with it


@dataclasses.dataclass(frozen=True, eq=False)
class Columns:
    """Results of many blocks, an array for each quantity, shape (k,)."""

    status: numpy.ndarray[Any, Any]  #: of `Status`
    summary: Summary

    def __len__(self) -> int:
        return len(self.status)

    def to_dataframe(self) -> pandas.DataFrame:
        """As a table of pandas, a row a block."""
        import pandas

        names = [field.name for field in dataclasses.fields(self) if field.name != "summary"]
        return pandas.DataFrame({name: getattr(self, name) for name in names})


@dataclasses.dataclass(frozen=True, eq=False)
class Moments(Columns):
    """Powers 1 to 4 of the unit that the coordinates are in; second moments of area about the
    centroid."""

    area: numpy.ndarray[Any, Any]
    area_error: numpy.ndarray[Any, Any]
    centroid_x: numpy.ndarray[Any, Any]
    centroid_x_error: numpy.ndarray[Any, Any]
    centroid_y: numpy.ndarray[Any, Any]
    centroid_y_error: numpy.ndarray[Any, Any]
    second_moment_xx: numpy.ndarray[Any, Any]
    second_moment_xx_error: numpy.ndarray[Any, Any]
    second_moment_yy: numpy.ndarray[Any, Any]
    second_moment_yy_error: numpy.ndarray[Any, Any]
    second_moment_xy: numpy.ndarray[Any, Any]
    second_moment_xy_error: numpy.ndarray[Any, Any]


@dataclasses.dataclass(frozen=True, eq=False)
class CriticalAngles(Columns):
    """The tilt at which moments of the weight let each block turn about the governing admissible
    pivot."""

    angle_deg: numpy.ndarray[Any, Any]
    error_deg: numpy.ndarray[Any, Any]
    pivot: numpy.ndarray[Any, Any]  #: the vertex of the outline, from 0, that it turns about; -1: none


@dataclasses.dataclass(frozen=True, eq=False)
class Verdicts(Columns):
    """What `Scene.solve` says of each block. Mechanisms and kinds are arrays of enumerations."""

    mechanism: numpy.ndarray[Any, Any]  #: at the tilt; without one, `first`
    first: numpy.ndarray[Any, Any]  #: what happens first as the table is tilted from level,
    first_angle_deg: numpy.ndarray[Any, Any]  #: and where
    first_error_deg: numpy.ndarray[Any, Any]
    critical_angle_deg: numpy.ndarray[Any, Any]  #: by moments
    critical_error_deg: numpy.ndarray[Any, Any]
    limit_kind: numpy.ndarray[Any, Any]
    limit_angle_deg: numpy.ndarray[Any, Any]
    limit_error_deg: numpy.ndarray[Any, Any]
    onset_kind: numpy.ndarray[Any, Any]
    onset_angle_deg: numpy.ndarray[Any, Any]
    onset_error_deg: numpy.ndarray[Any, Any]
    fos: numpy.ndarray[Any, Any]  #: the governing factor of safety, where there is a tilt and a number
    fos_error: numpy.ndarray[Any, Any]
    fos_mechanism: numpy.ndarray[Any, Any]  #: against which that factor is
    fos_definition: numpy.ndarray[Any, Any]  #: by which it is defined
    fos_moments: numpy.ndarray[Any, Any]  #: of moments, about the pivot that is the least safe
    fos_moments_error: numpy.ndarray[Any, Any]
    fos_sliding: numpy.ndarray[Any, Any]  #: of shear strength
    fos_sliding_error: numpy.ndarray[Any, Any]


@dataclasses.dataclass(frozen=True)
class AreaMoments(Record):
    """The moments of one outline, each with its bound."""

    area: Bounded
    centroid_x: Bounded
    centroid_y: Bounded
    second_moment_xx: Bounded
    second_moment_yy: Bounded
    second_moment_xy: Bounded


def outline_moments(outline: Points) -> AreaMoments:
    """Area, centroid and second moments of one outline, shape (n, 2). That it does not meet itself
    is not checked."""
    doubles = outline_of(outline)
    moments = ffi.new("tp_area_moments *")
    checked(lib.tp_outline_moments, moments, ffi.from_buffer("double[]", doubles), len(doubles))
    return record(AreaMoments, moments[0], moments)


def moments(outlines: Outlines, *, threads: int = 0) -> Moments:
    """Area, centroid and second moments of each. `threads` compute; 0: as many as the process may
    run on."""
    return filled(Moments, lib.tp_outlines_moments, outlines, (), threads=threads)


def critical_angles(outlines: Outlines, towards: Direction | str = Direction.LEFT, *,
                    simple: bool = False, threads: int = 0) -> CriticalAngles:
    """The critical angle of each on a base mated with its underside. `simple`: the caller
    guarantees that no outline meets itself, which is then not checked."""
    return filled(CriticalAngles, lib.tp_blocks_critical_angles, outlines, (),
                  towards=number_of(Direction, towards), simple=simple, threads=threads)


def verdicts(outlines: Outlines, friction_angle_deg: Any = None, tilt_angle_deg: Any = None,
             towards: Direction | str = Direction.LEFT, *, limit: bool = True,
             strength_reduction: bool = True, threads: int = 0) -> Verdicts:
    """The full verdict of each. Friction angle and tilt are one number for all, an array of shape
    (k,), NaN where a block has none, or None."""
    return filled(Verdicts, lib.tp_blocks_solve, outlines, (friction_angle_deg, tilt_angle_deg),
                  towards=number_of(Direction, towards), limit=limit,
                  strength_reduction=strength_reduction, threads=threads)


def outline_of(points: Points) -> numpy.ndarray[Any, Any]:
    """One outline as doubles one after another, shape (n, 2)."""
    import numpy

    refuse_masked(points)
    doubles = c_doubles(numpy.asarray(points))
    if doubles is None:
        raise BadInput("outlines of many blocks must be numbers that doubles hold; a Scene takes"
                       " all others")
    return doubles


def c_outlines(outlines: Outlines) -> tuple[tuple[Any, ...], int, Any]:
    """A tp_outlines, the number of blocks, and what must live as long as it is used."""
    import numpy

    if not hasattr(outlines, "__array__"):
        rows = [outline_of(outline) for outline in outlines]
        first = numpy.zeros(len(rows) + 1, dtype=numpy.uintp)
        numpy.cumsum([len(row) for row in rows], out=first[1:])
        points = numpy.concatenate(rows) if rows else numpy.empty((0, 2))
        pointers = ffi.from_buffer("double[]", points), ffi.from_buffer("size_t[]", first)
        return (len(rows), pointers[0], 0, pointers[1]), len(rows), pointers
    refuse_masked(outlines)
    points = numpy.asarray(outlines)
    count, vertices = points.shape[:-2] or (1,), points.shape[-2:-1]
    if points.ndim not in (2, 3) or points.shape[-1] != 2:
        raise BadInput("outlines must be an array of shape (k, n, 2) or (n, 2), not"
                       f" {points.shape}")
    doubles = ffi.from_buffer("double[]", outline_of(points.reshape(-1, 2)))
    return (count[0], doubles, vertices[0], NULL), count[0], doubles


def c_numbers(given: Any, count: int) -> tuple[tuple[Any, ...], Any]:
    """A tp_numbers, and what must live as long as it is used."""
    import numpy

    refuse_masked(given)
    if given is None or numpy.ndim(given) == 0:
        return (NULL, float("nan") if given is None else float(given)), None
    each = real_doubles(given)
    if each.shape != (count,):
        raise BadInput(f"a number for each of {count} blocks must be an array of shape ({count},),"
                       f" not {each.shape}")
    held = ffi.from_buffer("double[]", each)
    return (held, 0.0), held


#: So many take less than a tenth of a second, and are done in the thread that asks.
FEW = 100
#: Columns of whole numbers, by the enumeration that they are, or that they are none.
WORDS = {"mechanism": Mechanism, "first": Mechanism, "limit_kind": LimitKind,
         "onset_kind": OnsetKind, "fos_mechanism": Mechanism, "fos_definition": FosDefinition}


def filled(kind: Any, call: Any, outlines: Outlines, given: tuple[Any, ...], **options: Any) -> Any:
    """The columns that a call fills in."""
    import numpy

    struct, count, held = c_outlines(outlines)
    columns = ffi.new(ffi.getctype(ffi.typeof(call).args[0].item, "*"))
    arrays = {}
    for name, type_of in ffi.typeof(columns).item.fields:
        item = type_of.type.item
        kind_of = "f8" if item.cname == "double" else f"i{ffi.sizeof(item)}"
        own = arrays[name] = numpy.empty(count, dtype=kind_of)
        setattr(columns, name, ffi.cast(type_of.type, ffi.from_buffer(own, require_writable=True)))
    numbers = [c_numbers(number, count) for number in given]
    summary = ffi.new("tp_blocks_summary *")
    work = (call, columns, summary, ffi.new("tp_outlines *", struct), *[number for number, _ in numbers],
            options_of("blocks", **options))
    keep = held, numbers, arrays
    if count < FEW:
        checked(*work)
    else:
        Run().call(_checked, work, keep, leaves=True)
    for name, words in WORDS.items():
        if name in arrays:
            arrays[name] = numpy.array(list(words), dtype=object)[arrays[name]]
    return kind(summary=summarised(summary), **arrays)


def _checked(call: tuple[Any, ...], keep: Any) -> None:
    """A call, during which what it works on is kept."""
    checked(*call)


def summarised(c: Any) -> Summary:
    """The summary of a call; a warning where blocks are bad input."""
    complaint = ffi.string(c.complaint.text).decode("utf-8", "replace") if c.bad else None
    if c.bad:
        warnings.warn(f"{c.bad} of the blocks bad input; {complaint}", Caution, stacklevel=4)
    return Summary(c.done, c.without, c.undecided, c.bad, c.climbed, c.first_bad if c.bad else None,
                   complaint)
