# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The calls by which a scene in memory says how its tilt test is simulated, and how its base shakes
(topple_tilt_test.h, docs/tilt.md)."""

from __future__ import annotations

from ._library import lib
from .base_builder import BaseBuilder
from .given import Number, Points, c_number, c_points
from .word import number_of
from .words import PulseShape, ShakingAxis, TiltEngine, TiltProtocol
class TiltBuilder(BaseBuilder):
    """The test of a scene in memory."""

    def set_tilt_test(self, engine: TiltEngine | str, protocol: TiltProtocol | str = "ramp",
                      set_down: bool = False) -> None:
        """By which engine, by which protocol; whether the block is set down at each angle, or
        placed level and tilted."""
        self._change(lib.tp_scene_set_tilt_test, number_of(TiltEngine, engine),
                     number_of(TiltProtocol, protocol), set_down)

    def set_tilt_test_stiffness_gpa_m(self, normal_gpa_m: Number, shear_gpa_m: Number) -> None:
        """The stiffness of the contact's springs per unit of its area."""
        self._change_numbers(lib.tp_scene_set_tilt_test_stiffness_gpa_m, normal_gpa_m, shear_gpa_m)

    def add_tilt_test_traction(self, facet: int, first_kpa: Number, last_kpa: Number,
                               shear_kpa: Number) -> None:
        """Stress locked in on a facet of the base before a path: normal at its left end and its
        right one, shear above 0 where it pushes the block to the right."""
        self._change(lib.tp_scene_add_tilt_test_traction, facet, c_number(first_kpa),
                     c_number(last_kpa), c_number(shear_kpa))

    def set_shaking_pulse(self, axis: ShakingAxis | str, shape: PulseShape | str, peak_g: Number,
                          frequency_hz: Number) -> None:
        """A sine pulse of the base, along the horizontal or the vertical."""
        self._change(lib.tp_scene_set_shaking_pulse, number_of(ShakingAxis, axis),
                     number_of(PulseShape, shape), c_number(peak_g), c_number(frequency_hz))

    def set_shaking_record(self, axis: ShakingAxis | str, record: Points,
                           scale: Number = 1) -> None:
        """An accelerogram: seconds and shares of gravity at even steps, shape (n, 2)."""
        coordinates, held = c_points(record)
        self._change(lib.tp_scene_set_shaking_record, number_of(ShakingAxis, axis), coordinates,
                     c_number(scale))
        del held
