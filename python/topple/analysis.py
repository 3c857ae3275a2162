# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the results of studies, tests and analyses do; records.py has what they are."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

from ._library import ffi, lib
from .chart import Chart, made
from .errors import checked
from .given import File, c_path, c_text
from .record import Record, struct_of
from .report import drawing, sheet_options, taken, written
from .solution import BlockSystemMethods
from .words import (Design, FosDefinition, ProfileDetrend, ProfileResampling, ProfileWindow, StudyOutcome,
                    StudyQuantity)

if TYPE_CHECKING:
    import numpy
    import pandas  # type: ignore[import]

    from .records import BlockSystem, Solution, StudyShare, StudySpread
    from .scene import Scene


class BatchMethods:
    def report(self) -> str:
        """The table, as `topple solve --batch` prints it."""
        return written(lib.tp_report_batch, struct_of(self))

    def markdown(self) -> str:
        """The same in Markdown."""
        return written(lib.tp_report_batch_markdown, struct_of(self))

    def csv(self) -> str:
        """The same as CSV, each number followed by its bound."""
        return written(lib.tp_report_batch_csv, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_batch_json, struct_of(self))

    def write(self, path: File) -> None:
        """Write the table into a file: .csv, .json or .md."""
        checked(lib.tp_batch_write_file, c_path(path), struct_of(self))

    def write_page(self, path: File, figures: int = 60) -> None:
        """Write a page of HTML with figures of the first blocks."""
        checked(drawing().lib.tp_report_sheet_batch, c_path(path), struct_of(self), figures)

    def write_figures(self, folder: File, ending: str = ".svg") -> None:
        """Draw each block that was solved into a folder: .svg, .pdf, .png or .dxf."""
        checked(drawing().lib.tp_report_figures_batch, c_path(folder), c_text(ending), struct_of(self))


class SolidMethods:
    def report(self) -> str:
        """The report, as `topple solid` prints it."""
        return written(lib.tp_report_solid, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_solid_json, struct_of(self))

    def csv(self) -> str:
        """A row for every azimuth of every band."""
        return written(lib.tp_report_solid_csv, struct_of(self))

    def section(self, azimuth_deg: float) -> str:
        """The section through the centroid at an azimuth, as the text of a scene of a block; its head
        says how far off that is."""
        receives = ffi.new("char **")
        checked(lib.tp_report_solid_section, receives, struct_of(self), azimuth_deg)
        return taken(receives[0])

    def write_figure(self, path: File) -> None:
        """Draw the rock, what of it touches, and the rose into a file: .svg, .pdf or .png; as .glb
        the rock as a model. The mesh is read again, and must be as it was."""
        checked(drawing().lib.tp_report_figure_solid, c_path(path), struct_of(self))

    def write_report(self: Any, path: File, date: str | None = None, times: bool = True,
                     lines: int = 400, letterhead: dict[str, str] | None = None) -> None:
        """Write a calculation sheet to check and sign into a file, as `Solution.write_report`; of a
        solid that a scene was solved for."""
        scene: Scene | None = self.__dict__.get("_scene")
        if scene is None:
            raise TypeError("the sheet of a solid is of a scene: write one with the key 'solid'")
        options, _held = sheet_options(date, times, lines, letterhead)
        scene._use(drawing().lib.tp_report_sheet_solid, c_path(path), scene._c, struct_of(self), options,
                   of=self.__dict__["_version"])

    def row_csv(self) -> str:
        """Of a scene: what `topple solve --csv` prints, a row of the band that governs."""
        return written(lib.tp_report_solid_row_csv, struct_of(self))

    def meets(self, required: float) -> Design:
        """Of a scene: has the band that governs certainly a factor of `required`?"""
        return tuple(Design)[lib.tp_solid_meets(struct_of(self), required)]

    @property
    def undecided(self) -> bool:
        """Of a scene: is it open whether the solid stands?"""
        return bool(lib.tp_solid_is_undecided(struct_of(self)))


class FoundMethods:
    def report(self) -> str:
        """What was found, as `topple solve --find` prints it."""
        return written(lib.tp_report_found, struct_of(self), self.__dict__["_options"])

    def to_json(self, solution: Solution | BlockSystem) -> str:
        """JSON, with a solution of the scene as it is, of one block or of many."""
        of_many = isinstance(solution, BlockSystemMethods)
        call = lib.tp_report_found_block_system_json if of_many else lib.tp_report_found_json
        return written(call, struct_of(self), struct_of(solution))


class AccuracyMethods:
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


class ConvergenceMethods:
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


def _options(c: Any, owner: Any) -> dict[str, Any]:
    own = c.options
    return {"step": own.step, "resampling": tuple(ProfileResampling)[own.resampling],
            "detrend": tuple(ProfileDetrend)[own.detrend],
            "window": tuple(ProfileWindow)[own.window], "mirrored": own.mirrored,
            "scale": own.scale}


@dataclasses.dataclass(frozen=True)
class ProfileMethods(Record):
    options: dict[str, Any] = dataclasses.field(metadata={"read": _options})  #: as they were taken

    def report(self) -> str:
        """The report, as `topple profile` prints it."""
        return written(lib.tp_report_profile, struct_of(self))

    def to_json(self, every: bool = False) -> str:
        """JSON (docs/json.md); with every facet and ordinate of the spectrum."""
        return written(lib.tp_report_profile_json, struct_of(self), every)

    def csv(self) -> str:
        """A row for every facet."""
        return written(lib.tp_report_profile_csv, struct_of(self))

    def chart(self) -> Chart:
        """The profile, the rose of its slopes, its structure function and spectrum."""
        return made(lib.tp_chart_profile, struct_of(self))

    def _repr_svg_(self) -> str:
        return self.chart().svg()


class StudyTiltMethods:
    def __getitem__(self: Any, outcome: StudyOutcome | str) -> StudyShare:
        return self.outcomes[list(StudyOutcome).index(StudyOutcome(outcome))]


def _columns(c: Any, owner: Any) -> dict[str, numpy.ndarray[Any, Any]]:
    """All columns by their names."""
    import numpy

    outcomes = numpy.array(list(StudyOutcome), dtype=object)
    definitions = numpy.array([*FosDefinition, None], dtype=object)  # the last where there is none
    quantities = len(StudyQuantity) if c.of_many_blocks else list(StudyQuantity).index(StudyQuantity.FOS) + 1
    columns = {}
    for k in range(c.column_count if c.kept else 0):
        own = c.columns[k]
        values = numpy.frombuffer(ffi.buffer(own.values, 8 * c.kept), dtype="f8").copy()
        name = ffi.string(own.header).decode("utf-8", "replace")
        outcome = c.variable_count + quantities
        if outcome <= k <= outcome + c.tilt_count - 1:
            columns[name] = outcomes[values.astype(int)]
        elif k == outcome + c.tilt_count:
            columns[name] = definitions[numpy.where(numpy.isnan(values), -1, values).astype(int)]
        else:
            columns[name] = values
    return columns


@dataclasses.dataclass(frozen=True)
class StudyResultMethods(Record):
    #: by the names in the header of the rows: arrays of shape (kept,), of outcomes `StudyOutcome`, of
    #: definitions `FosDefinition` or None
    columns: dict[str, Any] = dataclasses.field(metadata={"read": _columns})

    def to_dataframe(self) -> pandas.DataFrame:
        """The samples kept as a table of pandas, a row each."""
        import pandas

        return pandas.DataFrame(self.columns)

    def spread(self, quantity: StudyQuantity | str) -> StudySpread:
        """Of one quantity."""
        return self.quantities[list(StudyQuantity).index(StudyQuantity(quantity))]

    def report(self) -> str:
        """The summary, as `topple study` prints it."""
        return written(lib.tp_report_study, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_study_json, struct_of(self))

    def write_report(self, path: File, study: File,
                     date: str | None = None, times: bool = True, lines: int = 400,
                     letterhead: dict[str, str] | None = None) -> None:
        """Write a calculation sheet into a file: .html, .md or .pdf (Solution.write_report). `study`
        is the file that was run, of which it names all that it rests on."""
        receives = ffi.new("tp_study **")
        checked(lib.tp_study_read, receives, c_path(study))
        own = ffi.gc(receives[0], lib.tp_study_free)
        options, _held = sheet_options(date, times, lines, letterhead)
        checked(drawing().lib.tp_report_sheet_study, c_path(path), own, struct_of(self), options)


class TiltTestMethods:
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

    def draw(self, path: File, moving: bool = False) -> None:
        """Frames, or where `moving` the one that moves, into an .svg."""
        checked(lib.tp_report_tilt_file, c_path(path), struct_of(self), moving)

    def write_report(self, path: File, scene: Scene, date: str | None = None,
                     times: bool = True, lines: int = 400,
                     letterhead: dict[str, str] | None = None) -> None:
        """Write a calculation sheet of the test of that scene into a file: .html, .md or .pdf
        (Solution.write_report)."""
        options, _held = sheet_options(date, times, lines, letterhead)
        scene._use(drawing().lib.tp_report_sheet_tilt, c_path(path), scene._c, struct_of(self),
                   options)


class VerificationMethods:
    @property
    def objects(self) -> bool:
        """Is any claim refuted, or in disagreement?"""
        return lib.tp_verification_objects(struct_of(self))

    def report(self) -> str:
        """The report, as `topple verify` prints it."""
        return written(lib.tp_report_verification, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_verification_json, struct_of(self))

    def markdown(self) -> str:
        """A page in Markdown."""
        return written(lib.tp_report_verification_markdown, struct_of(self))
