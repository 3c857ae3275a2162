# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Simulated tilt tests, and the shaking of a base (docs/tilt.md). Simulated numbers have no proven
bound: they are floats."""

from __future__ import annotations

import dataclasses
import os

from ._library import ffi, lib
from .contact import Note, notes_of
from .errors import checked
from .given import c_path
from .options import options_of
from .record import Record, field, record, struct_of
from .report import drawing, sheet_options, written
from .scene import Scene
from .words import (Direction, Mechanism, TiltEnd, TiltEngine, TiltEventKind, TiltPlace,
                    TiltProtocol)


@dataclasses.dataclass(frozen=True)
class TiltEvent(Record):
    """An event at a contact, or of the whole block."""

    kind: TiltEventKind
    time_s: float  #: 0 on a quasi-static path
    angle_deg: float  #: of the table
    x_m: float  #: where on the base; of the whole block its centroid
    y_m: float
    facet: int  #: of the base, counted from 1; 0: none, or an end face
    speed_m_s: float  #: of approach, where a contact closes; of slip, where it slips


@dataclasses.dataclass(frozen=True)
class TiltMoment(Record):
    """The block at one moment."""

    time_s: float
    angle_deg: float
    moved_x_m: float  #: of its centroid
    moved_y_m: float
    turned_deg: float  #: counter-clockwise
    speed_x_m_s: float
    speed_y_m_s: float
    turning_rad_s: float
    kinetic_energy_j: float
    energy_balance_j: float  #: 0 but for errors


@dataclasses.dataclass(frozen=True)
class TiltReaction(Record):
    """The reaction on one facet of the base at one moment."""

    moment: int  #: its index
    facet: int  #: counted from 1
    normal_n: float
    shear_n: float  #: positive where it pushes the block towards +x


@dataclasses.dataclass(frozen=True)
class TiltFacet(Record):
    """A facet of the base that events or reactions name, from its left end to its right one."""

    facet: int  #: as they count it: of the base, from 1
    contact: int  #: as statics counts the facets of the contact, from 1; 0: none at the start
    x0_m: float
    y0_m: float
    x1_m: float
    y1_m: float


@dataclasses.dataclass(frozen=True)
class TiltPoint(Record):
    """A vertex in the frame of the base."""

    x_m: float
    y_m: float


@dataclasses.dataclass(frozen=True)
class TiltSettings(Record):
    """The settings of a test, given or by default; those of other engines are 0."""

    engine: TiltEngine
    protocol: TiltProtocol
    set_down: bool  #: at each angle; else placed level and tilted
    speed_deg_min: float
    until_deg: float
    release_deg: float
    from_deg: float  #: of a ramp: where it starts
    tolerance_deg: float
    duration_s: float
    normal_stiffness_pa_m: float
    shear_stiffness_pa_m: float
    stiffness_given: bool  #: by the scene
    damping: float
    rounding_m: float
    time_step_s: float  #: 0: chosen
    restitution: float
    traction_count: int  #: facets with stress locked in before the start


@dataclasses.dataclass(frozen=True)
class TiltShaking(Record):
    """The shaking of the base along one axis; None all where there is none."""

    given: bool
    peak_m_s2: float | None = field(when="given")
    velocity_m_s: float | None = field(when="given")
    last_velocity_m_s: float | None = field(when="given")
    duration_s: float | None = field(when="given")


@dataclasses.dataclass(frozen=True)
class OverturningGrid(Record):
    """Factors on the shaking of the scene that were tried, evenly on a logarithmic axis."""

    least: float
    most: float
    count: int


@dataclasses.dataclass(frozen=True)
class OverturningRange(Record):
    """Factors at all of which, of those that were tried, the block is overturned."""

    spared_below: float  #: the next lower one tried does not overturn it; NaN: none was tried there
    least: float
    most: float
    spared_above: float  #: the next higher one tried does not overturn it; NaN: none was tried there


@dataclasses.dataclass(frozen=True)
class TiltCase(Record):
    """One direction of tilt."""

    towards: Direction
    least_deg: float  #: it stands there; if it never moves, the last tilt tried
    most_deg: float | None = field(when="has_bracket")  #: it begins to move there
    converged: bool  #: the bracket is as narrow as was asked
    softening_deg: float | None = field(when="has_softening")  #: sooner on springs as given
    jumps: int  #: times that a path gave way and came to rest at the same tilt
    first_jump_deg: float  #: of the first of these
    mechanism: Mechanism | None = field(when="has_mechanism")
    centre_x_m: float | None = field(when="has_centre")
    centre_y_m: float | None = field(when="has_centre")
    onset_deg: float | None = field(when="has_onset")  #: of statics: certain to stand up to it
    limit_deg: float | None = field(when="has_limit")  #: certain to move beyond
    place: TiltPlace  #: of the bracket against these
    end: TiltEnd
    ended_s: float
    ended_deg: float
    run_out_m: float  #: of the centroid along the base, down-dip
    turned_deg: float
    kinetic_energy_j: float  #: the greatest
    energy_balance_j: float  #: the largest, in absolute value
    energy_scale_j: float  #: weight times extent
    overturning_scanned: bool  #: it was asked which factors on its shaking overturn it
    overturning_least: float | None = field(when="has_overturning")  #: spares it; 0: none tried
    overturning_most: float | None = field(when="has_overturning")  #: the least found that does
    overturning_grids: tuple[OverturningGrid, ...] = field(count="overturning_grid_count")
    overturning_ranges: tuple[OverturningRange, ...] = field(count="overturning_range_count")
    events: tuple[TiltEvent, ...] = field(count="event_count")
    moments: tuple[TiltMoment, ...] = field(count="moment_count")
    reactions: tuple[TiltReaction, ...] = field(count="reaction_count")
    facets: tuple[TiltFacet, ...] = field(count="facet_count")
    outline: tuple[TiltPoint, ...] = field(count="outline_count")
    base: tuple[TiltPoint, ...] = field(count="base_count")
    centroid_x_m: float
    centroid_y_m: float
    runs: int  #: of the engine
    seconds: float  #: that they took


@dataclasses.dataclass(frozen=True)
class TiltTest(Record):
    """The result of a test."""

    title: str | None
    length_unit: str
    metres_per_unit: float
    settings: TiltSettings
    shaking: tuple[TiltShaking, ...]  #: horizontal, vertical
    cases: tuple[TiltCase, ...] = field(count="case_count")
    notes: tuple[Note, ...] = field(read=notes_of)

    def report(self) -> str:
        """The page, as `topple tilt` prints it."""
        return written(lib.tp_report_tilt, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_tilt_json, struct_of(self))

    def csv(self) -> str:
        """The moments of the motion."""
        return written(lib.tp_report_tilt_csv, struct_of(self))

    def frames(self) -> str:
        """SVG of the block at some moments."""
        return written(lib.tp_report_tilt_frames, struct_of(self))

    def animation(self) -> str:
        """SVG in which the block moves."""
        return written(lib.tp_report_tilt_animation, struct_of(self))

    def draw(self, path: str | os.PathLike, moving: bool = False) -> None:
        """Frames, or where `moving` the one that moves, into an .svg."""
        checked(lib.tp_report_tilt_file, struct_of(self), c_path(path), moving)

    def write_report(self, path: str | os.PathLike, scene: Scene, date: str | None = None,
                     times: bool = True, lines: int = 400) -> None:
        """Write a calculation sheet of the test of that scene into a file: .html, .md or .pdf
        (Solution.write_report)."""
        options, _held = sheet_options(date, times, lines)
        scene._use(drawing().lib.tp_report_sheet_tilt, c_path(path), scene._c, struct_of(self),
                   options)


def tilt_test(scene: Scene, *, moments: int | None = None,
              overturning: bool | None = None,
              factors: tuple[float, float, int] | None = None) -> TiltTest:
    """Run the test that the scene calls for. `moments`: of the history, at most, 400 unless given;
    `overturning`: which factors on the scene's shaking overturn the block, of the least, the
    greatest and the number of them that `factors` gives, else of those of `topple tilt`."""
    receives = ffi.new("tp_tilt_test **")
    least, most, count = factors or (None, None, None)
    options = options_of("tilt", moments=moments, overturning=overturning, overturning_from=least,
                         overturning_to=most, overturning_count=count)
    scene._use(lib.tp_tilt_test_run, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_tilt_test_free)
    return record(TiltTest, owner[0], owner)
