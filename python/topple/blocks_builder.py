# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The calls that give a scene in memory many blocks, their joints and what acts on one of them
(topple_scene.h, docs/blocks_in_contact.md). Blocks, joints and loads have numbers, from 1 on, in the order in which they were added."""

from __future__ import annotations

from typing import Any

from ._library import lib
from .given import NULL, Number, Points, c_number, c_points, c_text
from .tilt_builder import TiltBuilder
from .word import Word, number_of


class PlacedLoad(Word):
    """Loads that act where their points lie."""

    PRESSURE = "pressure"
    SURCHARGE = "surcharge"
    SUPPORT_PRESSURE = "support_pressure"
    BOLT = "bolt"  #: or anchor
    FORCE = "force"


class BlocksBuilder(TiltBuilder):
    """Many blocks of a scene in memory."""

    def add_block(self, outline: Points, name: str | None = None, ground: bool = False) -> None:
        """A block where its outline, shape (n, 2), lies; ground is fixed. None: its name is its number."""
        self._change_points(lib.tp_scene_add_block, outline, NULL if name is None else c_text(name), ground)

    def set_block_unit_weight_kn_m3(self, number: int, unit_weight_kn_m3: Number) -> None:
        """The unit weight of one block, where it is not that of all."""
        self._change(lib.tp_scene_set_block_unit_weight_kn_m3, number, c_number(unit_weight_kn_m3))

    def add_block_hole(self, number: int, outline: Points) -> None:
        """A hole in a block, shape (n, 2)."""
        self._change_ring(lib.tp_scene_add_block_hole, number, outline)

    def add_block_part(self, number: int, outline: Points, unit_weight_kn_m3: Number) -> None:
        """A part of a block of another unit weight, shape (n, 2)."""
        self._change_ring(lib.tp_scene_add_block_part, number, outline, c_number(unit_weight_kn_m3))

    def _change_ring(self, call: Any, number: int, outline: Points, *more: Any) -> None:
        coordinates, held = c_points(outline)
        self._change(call, number, coordinates, *more)
        del held

    def add_joint(self, first: int, second: int) -> None:
        """All contacts between two blocks, which the calls below give strength of their own."""
        self._change(lib.tp_scene_add_joint, first, second)

    def set_joint_friction_angle_deg(self, number: int, angle_deg: Number) -> None:
        """The friction of a joint, in [0, 90)."""
        self._change(lib.tp_scene_set_joint_friction_angle_deg, number, c_number(angle_deg))

    def set_joint_cohesion_kpa(self, number: int, cohesion_kpa: Number) -> None:
        """Its cohesion."""
        self._change(lib.tp_scene_set_joint_cohesion_kpa, number, c_number(cohesion_kpa))

    def set_joint_tension_kpa(self, number: int, tension_kpa: Number) -> None:
        """Its tensile strength."""
        self._change(lib.tp_scene_set_joint_tension_kpa, number, c_number(tension_kpa))

    def add_bolt_to(self, x: Number, y: Number, to_x: Number, to_y: Number, force_kn: Number,
                    passive: bool = False) -> None:
        """A bolt from a point to its far end, which holds in the block that it lies in."""
        self._change(lib.tp_scene_add_bolt_to, *map(c_number, (x, y, to_x, to_y, force_kn)), passive)

    def add_force(self, x: Number, y: Number, direction_deg: Number, force_kn: Number) -> None:
        """A force from outside, per metre of thickness, in a direction from x towards y."""
        self._change_numbers(lib.tp_scene_add_force, x, y, direction_deg, force_kn)

    def set_bolt_into(self, number: int, block: int) -> None:
        """The block in which the far end of an anchor or a bolt holds, where that is not the one that it lies in."""
        self._change(lib.tp_scene_set_bolt_into, number, block)

    def set_load_block(self, load: PlacedLoad | str, number: int, block: int) -> None:
        """The block that a load acts on, of those of a kind: 'pressure', 'surcharge', 'support_pressure',
        'bolt' or 'force'; where it is not said, those that it lies on."""
        self._change(lib.tp_scene_set_load_block, number_of(PlacedLoad, load), number, block)

    def set_support(self, block: int, x: Number, y: Number) -> None:
        """Ask for the force that is needed at a point of a block; its direction and the factor of safety
        that it is for are numbers by their keys, "support.direction_deg" and "support.fos"."""
        self._change(lib.tp_scene_set_support, block, c_number(x), c_number(y))
