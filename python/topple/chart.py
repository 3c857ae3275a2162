# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Charts: curves and borders, as tables and as figures."""

from __future__ import annotations

import os
from typing import Any, Sequence, TYPE_CHECKING

from ._library import ffi, lib
from .errors import BadInput, checked
from .given import File, c_path, c_text, refuse_masked
from .options import options_of
from .record import struct_of
from .report import drawn, written
from .running import Progress, Run, Stop

if TYPE_CHECKING:
    from .records import StudyResult, TiltTest
    from .scene import Scene


class Chart:
    """Curves and borders; every point of the table has its error. Figures are drawn by gnuplot."""

    def __init__(self, receives: Any) -> None:
        self._c = ffi.gc(receives[0], lib.tp_chart_free)

    def csv(self) -> str:
        """A row for every point, with its error."""
        return written(lib.tp_report_chart_csv, self._c)

    def to_json(self) -> str:
        """The same as JSON (docs/json.md)."""
        return written(lib.tp_report_chart_json, self._c)

    def write(self, path: File) -> None:
        """Write a file, whole or not at all: .svg, .pdf, .png or .csv."""
        name, kind = c_path(path), ffi.new("tp_chart_format *")
        if not lib.tp_chart_format_read(kind, name):
            raise BadInput(f"{os.fspath(path)!r} must end in .svg, .pdf, .png or .csv")
        checked(lib.tp_report_chart_file, name, self._c, kind[0])

    def svg(self) -> str:
        """The figure as SVG."""
        return drawn(self.write)

    def _repr_svg_(self) -> str:
        return self.svg()


def made(call: Any, *arguments: Any) -> Chart:
    """The chart of a call."""
    receives = ffi.new("tp_chart **")
    checked(call, receives, *arguments)
    return Chart(receives)


def _list(target: Any, numbers: Sequence[float] | None) -> Any:
    """Fill a list of numbers; what must live as long as it is used."""
    if numbers is None:
        return None
    refuse_masked(numbers)
    held = ffi.new("double[]", list(numbers))
    target.count, target.values = len(held), held
    return held


def chart_fos(inverse_slenderness: Sequence[float] | None = None,
              amplitude: Sequence[float] | None = None, sub_blocks: Sequence[int] | None = None,
              tilt_deg: tuple[float, float] | None = None) -> Chart:
    """Factor of safety against tilt about planar, peak and valley axes (Fig. 16 of Alejano et al.).
    `inverse_slenderness` dx / y, 0 to 10; `amplitude` A / y, 0 to 0.5; `sub_blocks` none: by the
    equations, else 2 to 1000 of the exact block; `tilt_deg` from and to, within 0 to 90."""
    options = options_of("chart_fos", tilt_deg=tilt_deg)
    held = [_list(options.inverse_slenderness, inverse_slenderness),
            _list(options.amplitude, amplitude), _list(options.sub_blocks, sub_blocks)]
    chart = made(lib.tp_chart_fos, options)
    del held
    return chart


def chart_mechanisms(friction_deg: float | None = None, roughness_angle_deg: float | None = None,
                     amplitude: float | None = None) -> Chart:
    """Mechanism maps for a planar and for a rough base (Fig. 18), with the blocks of Table 7."""
    return made(lib.tp_chart_mechanisms, options_of("chart_mechanisms", friction_deg=friction_deg,
                                                    roughness_angle_deg=roughness_angle_deg,
                                                    amplitude=amplitude))


def chart_ranges() -> Chart:
    """Critical angles about peak and valley against A / y, for the ranges of Fig. 14."""
    return made(lib.tp_chart_ranges)


def chart_study(result: StudyResult) -> Chart:
    """The results of a study: probability against tilt, distribution, rank correlations,
    convergence."""
    return made(lib.tp_chart_study, struct_of(result))


def chart_study_scatter(result: StudyResult) -> Chart:
    """The critical angle of its samples, against each number that varies."""
    return made(lib.tp_chart_study_scatter, struct_of(result))


def chart_tilt_reactions(test: TiltTest) -> Chart:
    """Reactions of the facets in a tilt test, against the tilt up to where the block begins to move; where
    the table stands still against time."""
    return made(lib.tp_chart_tilt_reactions, struct_of(test))


def chart_tilt_phase(test: TiltTest) -> Chart:
    """Phase portraits of what moves in a tilt test: its turn against its angular velocity, the
    displacement of its centroid along the base against its speed."""
    return made(lib.tp_chart_tilt_phase, struct_of(test))


def chart_overturning(scene: Scene, frequencies: tuple[float, float] | None = None, *,
                      count: int | None = None, tolerance: float | None = None, stop: Stop = None,
                      progress: Progress = None) -> Chart:
    """The overturning spectrum of a scene whose base shakes horizontally: the least shaking of its
    form that overturns the block, as PGA against frequency and PGV, and islands in which stronger
    shaking does not overturn it. `frequencies` from and to, in hertz of a pulse, times as fast of a record;
    `count` of them, 25 unless given; `tolerance` of brackets, 1e-3. `stop` is asked now and then, and
    true ends with the frequencies done by then; `progress` is given their number. Ctrl-C raises
    Interrupted, a KeyboardInterrupt whose `result` is the chart of these."""
    first, last = frequencies or (None, None)
    run = Run(stop, progress)
    options = options_of("overturning", **{"from": first}, to=last, count=count,
                         tolerance=tolerance, **run.options("run_counts"))
    receives = ffi.new("tp_chart **")
    run.call(scene._use, lib.tp_chart_overturning, receives, scene._c, options)
    return run.ended_with(Chart(receives))


def chart_map(scene: Scene, x: tuple[str, float, float],
              y: tuple[str, float, float] | None = None, any_tilt: bool | None = None,
              governing_fos: bool | None = None, levels: Sequence[float] | None = None) -> Chart:
    """The mechanism map of a scene that tilts in one direction and has a friction angle. An axis is
    the key of a number, as in `find`, or `tilt`, with the range that it is taken through: ("tilt",
    0, 60). Over two other numbers it says what the block does at the scene's tilt; `any_tilt`: the
    first motion as it is tilted. `governing_fos`: contours of that factor of safety, else of
    angles, at `levels`, 6 at most."""
    options = options_of("chart_map", scene=scene._c, any_tilt=any_tilt, governing_fos=governing_fos)
    held = [_list(options.levels, levels)]
    for axis, given in ((options.x, x), (options.y, y)):
        if given is not None:
            held.append(c_text(given[0]))
            axis.key = held[-1]
            axis.range = given[1:]
    receives = ffi.new("tp_chart **")
    Run().call(lambda: (scene._use(lib.tp_chart_map, receives, options), held), leaves=True)
    return Chart(receives)
