# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a solution, a case and a factor of safety do; records.py has what they are."""

from __future__ import annotations

from typing import Any, Iterable, TYPE_CHECKING

from ._library import ffi, lib
from .given import File, c_path
from .record import struct_of
from .report import drawing, drawn, sheet_options, taken, written
from .word import number_of
from .words import Design, Direction, Mechanism, PivotsListed

if TYPE_CHECKING:
    from .records import BlockSystem, Case, LoadCases, Pivot, Solution
    from .scene import Scene


class FosMethods:
    def __float__(self: Any) -> float:
        if self.value is None:
            raise ValueError(f"the factor of safety is not a number: {self.state}")
        return self.value.value


class CaseMethods:
    @property
    def governing_pivot(self: Any) -> Pivot | None:
        """The governing pivot."""
        return None if self.toppling_pivot is None else self.pivots[self.toppling_pivot]

    def meets(self: Any, design_fos: float) -> Design:
        """Is the governing factor of safety certainly as much, at a tilt at which the block
        stands?"""
        return tuple(Design)[lib.tp_case_meets(struct_of(self), design_fos)]


class BlockSystemMethods:
    """What can be asked of many blocks that were solved."""

    def meets(self: Any, required: float) -> Design:
        """Has every case certainly a factor of `required`, where no motion can begin?"""
        return tuple(Design)[lib.tp_block_system_meets(struct_of(self), required)]

    @property
    def undecided(self: Any) -> bool:
        """Did the proofs leave a verdict open?"""
        return bool(lib.tp_block_system_is_undecided(struct_of(self)))

    def report(self: Any) -> str:
        """The page that `topple solve` prints."""
        return written(lib.tp_report_block_system, struct_of(self))

    def to_json(self: Any) -> str:
        """What `topple solve --json` prints."""
        return written(lib.tp_report_block_system_json, struct_of(self))

    def to_json_outlines(self: Any) -> str:
        """The same with the geometry of all blocks, for programs that draw them, as `Solution.to_json_outlines`."""
        scene: Scene = self.__dict__["_scene"]
        receives = ffi.new("char **")
        scene._use(lib.tp_report_block_system_json_outlines, receives, scene._c, struct_of(self), of=self.__dict__["_version"])
        return taken(receives[0])

    def to_csv(self: Any) -> str:
        """What `topple solve --csv` prints: a row for each direction."""
        return written(lib.tp_report_block_system_csv, struct_of(self))

    def write_figure(self: Any, path: File) -> None:
        """Draw the blocks as they lie, and how they begin to move, into a file: .svg, .pdf, .png or .dxf. They
        are drawn of the scene, which must be as it was when it was solved."""
        scene: Scene = self.__dict__["_scene"]
        scene._use(drawing().lib.tp_report_figure_block_system, c_path(path), scene._c, struct_of(self),
                   of=self.__dict__["_version"])

    def animation_svg(self: Any) -> str:
        """How the blocks begin to move, magnified, as an SVG that moves: one instant drawn larger,
        not what follows of it."""
        scene: Scene = self.__dict__["_scene"]
        receives = ffi.new("char **")
        scene._use(lib.tp_report_block_system_animation, receives, scene._c, struct_of(self), of=self.__dict__["_version"])
        return taken(receives[0])

    def write_animation(self: Any, path: File) -> None:
        """The same into a file that ends in .svg."""
        scene: Scene = self.__dict__["_scene"]
        scene._use(lib.tp_report_block_system_animation_file, c_path(path), scene._c, struct_of(self),
                   of=self.__dict__["_version"])

    def write_report(self: Any, path: File, date: str | None = None, times: bool = True,
                     lines: int = 400, letterhead: dict[str, str] | None = None) -> None:
        """Write a calculation sheet to check and sign into a file, as `Solution.write_report`."""
        scene: Scene = self.__dict__["_scene"]
        options, _held = sheet_options(date, times, lines, letterhead)
        scene._use(drawing().lib.tp_report_sheet_block_system, c_path(path), scene._c, struct_of(self), options,
                   of=self.__dict__["_version"])

    def svg(self: Any) -> str:
        """The figure as SVG."""
        return drawn(self.write_figure)

    def _repr_svg_(self: Any) -> str:
        return self.svg()


class SystemCaseMethods:
    """What can be asked of one direction."""

    def meets(self: Any, required: float) -> Design:
        """Has it certainly a factor of `required`, where no motion can begin?"""
        return tuple(Design)[lib.tp_system_case_meets(struct_of(self), required)]


class LoadCasesMethods:
    @property
    def meets(self) -> Design:
        """Do all cases meet what is required of them?"""
        return tuple(Design)[lib.tp_load_cases_meet(struct_of(self))]

    def report(self) -> str:
        """The table of the cases, as `topple solve` prints it."""
        return written(lib.tp_report_load_cases, struct_of(self))

    def to_json(self, pivots: PivotsListed | str = PivotsListed.BY_COUNT) -> str:
        """JSON, as `topple solve --json` prints it of a scene with cases."""
        return written(lib.tp_report_load_cases_json, struct_of(self),
                       number_of(PivotsListed, pivots))


class SolutionMethods:
    def __repr__(self: Any) -> str:
        return "<topple.Solution " + "; ".join(_told(self, case) for case in self.cases) + ">"

    def case(self: Any, towards: Direction | str) -> Case:
        """The case of a direction of tilt, 'left' or 'right'; KeyError where the scene does not
        tilt there."""
        for case in self.cases:
            if case.towards is Direction(towards):
                return case
        raise KeyError(towards)

    @property
    def is_undecided(self: Any) -> bool:
        """Did the precision allowed leave a mechanism undecided, or a number less certain than
        requested?"""
        return lib.tp_solution_is_undecided(struct_of(self))

    def meets(self: Any, design_fos: float) -> Design:
        """Does every case meet a design factor of safety?"""
        return tuple(Design)[lib.tp_solution_meets(struct_of(self), design_fos)]

    def report(self: Any) -> str:
        """The report, as `topple solve` prints it."""
        return written(lib.tp_report_text, struct_of(self))

    def report_elements(self: Any) -> str:
        """The account of moments by elements, where `solve(elements=True)` drew it up."""
        return written(lib.tp_report_elements, struct_of(self))

    def report_notes(self: Any) -> str:
        """Notes and cautions, as on the page of the report; empty where there are none."""
        return written(lib.tp_report_notes, struct_of(self))

    def report_effects(self: Any) -> str:
        """The effects computed, the input that required each, and its time."""
        return written(lib.tp_report_effects, struct_of(self))

    def to_json(self: Any, pivots: PivotsListed | str = PivotsListed.BY_COUNT) -> str:
        """JSON, as `topple solve --json` prints it (docs/json.md)."""
        return written(lib.tp_report_json_pivots, struct_of(self), number_of(PivotsListed, pivots))

    def to_json_outlines(self: Any, pivots: PivotsListed | str = PivotsListed.BY_COUNT) -> str:
        """The same with the geometry of everything, for programs that draw it: `outlines`. They are of
        the scene, which must be as it was when it was solved."""
        solution = struct_of(self)
        scene: Scene = self.__dict__["_scene"]
        receives = ffi.new("char **")
        scene._use(lib.tp_report_json_outlines, receives, scene._c, solution,
                   number_of(PivotsListed, pivots), of=self.__dict__["_version"])
        return taken(receives[0])

    def csv(self: Any) -> str:
        """A table with a row for each case, each number followed by its bound."""
        return csv([self])

    def table(self: Any) -> str:
        """The same for readers, in Markdown."""
        return table([self])

    def write_figure(self: Any, path: File) -> None:
        """Draw the block on its base into a file: .svg, .pdf, .png or .dxf. It is drawn of the scene,
        which must be as it was when it was solved."""
        solution = struct_of(self)
        scene: Scene = self.__dict__["_scene"]
        scene._use(drawing().lib.tp_report_figure, c_path(path), scene._c, solution,
                   of=self.__dict__["_version"])

    def write_report(self: Any, path: File, date: str | None = None, times: bool = True,
                     lines: int = 400, letterhead: dict[str, str] | None = None,
                     load_cases: LoadCases | None = None) -> None:
        """Write a calculation sheet to check and sign into a file: .html, .md or .pdf. `date` is
        printed as it is; `times` adds the time of each effect, which differs between runs;
        `lines` of each file that the scene was read from are shown. It has the account of moments
        by elements where `solve(elements=True)` drew it up. `letterhead` has keys of the scene's
        `report`, each instead of what that says: {"language": "es", "company": "…"}. `load_cases`
        are those of the scene (`Scene.solve_load_cases`), of which this is the one that governs:
        the first page has a row for each."""
        solution = struct_of(self)
        scene: Scene = self.__dict__["_scene"]
        options, _held = sheet_options(date, times, lines, letterhead, load_cases)
        scene._use(drawing().lib.tp_report_sheet, c_path(path), scene._c, solution, options,
                   of=self.__dict__["_version"])

    def svg(self: Any) -> str:
        """The figure as SVG."""
        return drawn(self.write_figure)

    def _repr_svg_(self: Any) -> str:
        return self.svg()


def _told(s: Solution, case: Case) -> str:
    """The verdict of a case in some words."""
    words = f"towards {case.towards}:"
    if s.tilt_angle_deg is not None:
        words += f" {case.mechanism} at {s.tilt_angle_deg.value:.6g}°,"
    if case.first_angle_deg is not None:
        return f"{words} {case.first} at {case.first_angle_deg.value:.6g}°"
    decided = case.first is not Mechanism.UNDECIDED
    return f"{words} {case.first}" + (" at any tilt" if decided else "")


def _tabled(solutions: Iterable[Solution | BlockSystem], of_one: Any, of_many: Any) -> str:
    kept = list(solutions)
    many = sum(isinstance(solution, BlockSystemMethods) for solution in kept)
    if many and many < len(kept):
        raise TypeError("a table is of scenes of one block or of scenes of many: make two of them")
    listed = ffi.new("tp_block_system *[]" if many else "tp_solution *[]", [struct_of(solution) for solution in kept])
    return written(of_many if many else of_one, listed, len(kept))


def csv(solutions: Iterable[Solution | BlockSystem]) -> str:
    """A table in CSV, a row for each case of each solution, each number followed by its bound."""
    return _tabled(solutions, lib.tp_report_csv, lib.tp_report_block_systems_csv)


def table(solutions: Iterable[Solution | BlockSystem]) -> str:
    """The same for readers, in Markdown."""
    return _tabled(solutions, lib.tp_report_table, lib.tp_report_block_systems_table)
