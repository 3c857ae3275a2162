# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The calls that build a scene in memory, with the names that they have in C (topple_scene.h,
docs/scene_in_memory.md).

Lengths are in the scene's length unit; other units stand in names. A number is a float, taken as
the double that it is, an int, a Fraction, a Decimal, or a text ("0.1", "1/3"). Points are an array
of shape (n, 2) or n pairs of numbers. What is given is copied. `set` replaces what was set before,
`add` adds one more; a call that fails changes nothing and raises BadInput."""

from __future__ import annotations

from ._library import lib
from .base_builder import LeftEnd
from .blocks_builder import BlocksBuilder
from .given import Number, Points, c_number, c_text
from .word import Word, number_of
from .words import Direction
class SeismicDirection(Word):
    """Which way the horizontal part of an earthquake acts on a block that lies on a slope."""

    BOTH = "both"  #: the worse of the two governs
    DOWN_DIP = "down_dip"
    UP_DIP = "up_dip"


class WaterFaces(Word):
    """Which faces of the block water wets."""

    UNSTATED = "unstated"  #: behind, with a caution
    BEHIND = "behind"  #: up-dip of the block
    FRONT = "front"
    BOTH = "both"


class WaterUplift(Word):
    """How water lifts the block."""

    UNSTATED = "unstated"  #: full, with a caution
    NONE = "none"
    TRIANGULAR = "triangular"  #: to nothing at an end of the joint that the water does not wet
    FULL = "full"  #: the pressure of its level at both ends


class UndersideEnd(Word):
    """An end of the underside."""

    LEFT_END = "left_end"
    RIGHT_END = "right_end"


class Towards(Word):
    """Directions of tilt."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


class Along(Word):
    """What x and y lie along."""

    BASE = "base"
    WORLD = "world"


class FrictionIs(Word):
    """What a friction angle was measured on: a smooth surface, or the rough joint."""

    BASIC = "basic"
    APPARENT = "apparent"


class Builder(BlocksBuilder):
    """A scene in memory that is changed call by call."""

    def set_title(self, title: str) -> None:
        """The title of reports."""
        self._change(lib.tp_scene_set_title, c_text(title))

    # The block: exactly one of outline, slab, teeth and ellipse; the last one set is taken.

    def set_outline(self, outline: Points) -> None:
        """The cross-section, shape (n, 2), either way round; the first point may be repeated at the
        end."""
        self._change_points(lib.tp_scene_set_outline, outline)

    def set_number(self, key: str, value: Number) -> None:
        """A number by its key in a scene file, as "joint.closure", of those that stand by themselves, in
        no list and no form."""
        self._change(lib.tp_scene_set_number, c_text(key), c_number(value))

    def set_slab(self, width: Number, height: Number) -> None:
        """A rectangle on the origin."""
        self._change_numbers(lib.tp_scene_set_slab, width, height)

    def set_teeth(self, count: int, width: Number, height: Number, depth: Number,
                  left_end: LeftEnd | str) -> None:
        """`count` teeth of a width, `height` the smaller of their heights and `height` + `depth`
        the larger: N, a, b, c of Fig. 5 of Alejano et al."""
        self._change(lib.tp_scene_set_teeth, count, c_number(width), c_number(height),
                     c_number(depth), number_of(LeftEnd, left_end))

    def set_teeth_over(self, count: int, block_width: Number, mean_height: Number,
                       amplitude: Number, left_end: LeftEnd | str) -> None:
        """The same by the block as a whole, with the wavelength 2 `block_width` / `count`."""
        self._change(lib.tp_scene_set_teeth_over, count, c_number(block_width),
                     c_number(mean_height), c_number(amplitude), number_of(LeftEnd, left_end))

    def set_ellipse(self, width: Number, height: Number, flat: Number) -> None:
        """An ellipse with a flat of a width at its foot."""
        self._change_numbers(lib.tp_scene_set_ellipse, width, height, flat)

    def add_hole(self, outline: Points) -> None:
        """A hole in the block, shape (n, 2)."""
        self._change_points(lib.tp_scene_add_hole, outline)

    def add_part(self, outline: Points, unit_weight_kn_m3: Number) -> None:
        """A part of another unit weight, shape (n, 2)."""
        self._change_points(lib.tp_scene_add_part, outline, c_number(unit_weight_kn_m3))

    def add_arc_through(self, from_x: Number, from_y: Number, through_x: Number,
                        through_y: Number) -> None:
        """The edge of the outline that begins in a vertex is an arc through a point."""
        self._change_numbers(lib.tp_scene_add_arc_through, from_x, from_y, through_x, through_y)

    def add_arc_bulge(self, from_x: Number, from_y: Number, bulge: Number) -> None:
        """The same by the tangent of a quarter of the arc's angle, negative inwards."""
        self._change_numbers(lib.tp_scene_add_arc_bulge, from_x, from_y, bulge)

    def add_rounded_end(self, at: UndersideEnd | str, radius: Number) -> None:
        """A rounded corner at the 'left_end' or 'right_end' of the underside."""
        self._change(lib.tp_scene_add_rounded_end, number_of(UndersideEnd, at), c_number(radius))

    def add_rounded_vertex(self, x: Number, y: Number, radius: Number) -> None:
        """A rounded corner at a vertex."""
        self._change_numbers(lib.tp_scene_add_rounded_vertex, x, y, radius)

    def set_rounding_keeps_mass(self, keeps_mass: bool) -> None:
        """The paper's model (the axis moves, the mass is kept), or the exact one, which is taken
        unless set."""
        self._change(lib.tp_scene_set_rounding_keeps_mass, keeps_mass)

    def set_result_unit(self, name: str) -> None:
        """Print in this unit what is of its kind, as "kip ft"; results stay SI."""
        self._change(lib.tp_scene_set_result_unit, c_text(name))

    def set_repair(self, repair: bool) -> None:
        """Move vertices where rings meet themselves by less than a last digit."""
        self._change(lib.tp_scene_set_repair, repair)

    def set_thickness(self, thickness: Number) -> None:
        """How far the section goes on into the drawing."""
        self._change_numbers(lib.tp_scene_set_thickness, thickness)

    def set_unit_weight_kn_m3(self, unit_weight_kn_m3: Number) -> None:
        """The unit weight of the block; loads need one."""
        self._change_numbers(lib.tp_scene_set_unit_weight_kn_m3, unit_weight_kn_m3)

    # Friction of the contact; the last one set is taken.

    def set_friction_angle_deg(self, angle_deg: Number) -> None:
        """One angle, in [0, 90)."""
        self._change_numbers(lib.tp_scene_set_friction_angle_deg, angle_deg)

    def set_friction_patton(self, basic_angle_deg: Number, roughness_angle_deg: Number) -> None:
        """Patton's phi_b + i."""
        self._change_numbers(lib.tp_scene_set_friction_patton, basic_angle_deg, roughness_angle_deg)

    def set_friction_barton(self, residual_angle_deg: Number, jrc: Number, jcs_mpa: Number) -> None:
        """Barton's law by JRC."""
        self._change_numbers(lib.tp_scene_set_friction_barton, residual_angle_deg, jrc, jcs_mpa)

    def set_friction_barton_test(self, residual_angle_deg: Number, test_angle_deg: Number,
                                 test_normal_stress_kpa: Number, jcs_mpa: Number) -> None:
        """Barton's law by a tilt test."""
        self._change_numbers(lib.tp_scene_set_friction_barton_test, residual_angle_deg,
                             test_angle_deg, test_normal_stress_kpa, jcs_mpa)

    def set_friction_barton_roughness(self, residual_angle_deg: Number, roughness_angle_deg: Number,
                                      jcs_mpa: Number) -> None:
        """Barton's law by the roughness angle."""
        self._change_numbers(lib.tp_scene_set_friction_barton_roughness, residual_angle_deg,
                             roughness_angle_deg, jcs_mpa)

    def add_friction_facets(self, first: int, last: int, angle_deg: Number) -> None:
        """A friction angle of their own for facets of the base: from one number to another, counted
        from 1 from left to right."""
        self._change(lib.tp_scene_add_friction_facets, first, last, c_number(angle_deg))

    def add_friction_between(self, x0: Number, x1: Number, angle_deg: Number) -> None:
        """The same for all facets between two abscissas."""
        self._change_numbers(lib.tp_scene_add_friction_between, x0, x1, angle_deg)

    def set_tilt_towards(self, towards: Towards | str) -> None:
        """The directions of tilt that are looked at: 'left', 'right' or 'both'."""
        towards = Towards(towards)
        self._change(lib.tp_scene_set_tilt_towards, towards is not Towards.RIGHT,
                     towards is not Towards.LEFT)

    def set_tilt_angle_deg(self, angle_deg: Number) -> None:
        """The tilt that the block lies at."""
        self._change_numbers(lib.tp_scene_set_tilt_angle_deg, angle_deg)

    def set_friction_is(self, meaning: FrictionIs | str) -> None:
        """The friction angle is the 'basic' one of a smooth surface, or an 'apparent' one of the rough
        joint: the sole is then levelled, so that its facets do not add to it."""
        self._change(lib.tp_scene_set_friction_is_apparent, FrictionIs(meaning) is FrictionIs.APPARENT)

    def set_frame(self, along: Along | str) -> None:
        """x and y lie along the mean plane of the 'base' and its normal; or are the horizontal and
        the vertical of the 'world', with the mean plane fitted to the contact."""
        own = Along(along) is Along.BASE
        self._change(lib.tp_scene_set_frame_base if own else lib.tp_scene_set_frame_world)

    def set_slope(self, dip_deg: Number, towards: Direction | str,
                  dip_direction_deg: Number | None = None) -> None:
        """x and y run along a slope and normal to it, which dips by `dip_deg`, 0 to 90, towards
        'left' or 'right'; on the map, in reports, to the azimuth `dip_direction_deg`."""
        self._change(lib.tp_scene_set_slope, c_number(dip_deg), number_of(Direction, towards))
        if dip_direction_deg is not None:
            self.set_number("slope.dip_direction_deg", dip_direction_deg)

    def set_mean_plane(self, two_points: Points) -> None:
        """The frame of the world, with the mean plane through two points, the left one first, shape
        (2, 2)."""
        self._change_points(lib.tp_scene_set_mean_plane, two_points)

    # Loads, which a block with a unit weight can bear.

    def set_seismic_direction(self, direction: SeismicDirection | str) -> None:
        """Which way k_h acts on a block in the frame of the world: 'both', 'down_dip', 'up_dip'."""
        self._change(lib.tp_scene_set_seismic_direction, number_of(SeismicDirection, direction))

    def set_water(self, height: Number, unit_weight_kn_m3: Number = "9.81",
                  stays_level: bool = False, uplift: bool = False) -> None:
        """Water behind the block to a height over the up-dip end of the base joint: along the face, or
        vertical where it stays level; with uplift along the base, falling to nothing at the toe."""
        self._change(lib.tp_scene_set_water, c_number(height), c_number(unit_weight_kn_m3),
                     stays_level, uplift)

    def set_water_level(self, level: Number, unit_weight_kn_m3: Number = "9.81",
                        faces: WaterFaces | str = "unstated",
                        uplift: WaterUplift | str = "unstated") -> None:
        """Water up to an elevation: y in the frame of the world, else over the up-dip end of the base
        joint."""
        self._change(lib.tp_scene_set_water_level, c_number(level), c_number(unit_weight_kn_m3),
                     number_of(WaterFaces, faces), number_of(WaterUplift, uplift))

    def set_water_surface(self, points: Points, unit_weight_kn_m3: Number = "9.81",
                          faces: WaterFaces | str = "unstated",
                          uplift: WaterUplift | str = "unstated") -> None:
        """Water below a surface, points from left to right that reach past the block."""
        self._change_points(lib.tp_scene_set_water_surface, points, c_number(unit_weight_kn_m3),
                            number_of(WaterFaces, faces), number_of(WaterUplift, uplift))

    def set_tension_crack_level(self, level: Number) -> None:
        """A crack behind the block, filled to an elevation, as that of set_water_level."""
        self._change_numbers(lib.tp_scene_set_tension_crack_level, level)

    def set_tension_crack_height(self, height: Number, distance: Number = 0) -> None:
        """A crack behind the block, filled to a height over its foot, normal to the mean plane, at a
        distance up-dip of the base joint."""
        self._change_numbers(lib.tp_scene_set_tension_crack_height, height, distance)

    def set_ice(self, ice_kpa: Number, ice_thickness: Number) -> None:
        """Ice on water that was set before, which presses from its level down."""
        self._change_numbers(lib.tp_scene_set_ice, ice_kpa, ice_thickness)

    def add_pressure(self, x0: Number, y0: Number, x1: Number, y1: Number, first_kpa: Number,
                     last_kpa: Number) -> None:
        """A pressure along a line of the outline, at its two ends."""
        self._change_numbers(lib.tp_scene_add_pressure, x0, y0, x1, y1, first_kpa, last_kpa)

    def add_surcharge(self, x0: Number, y0: Number, x1: Number, y1: Number, kpa: Number) -> None:
        """A surcharge along a line of the outline."""
        self._change_numbers(lib.tp_scene_add_surcharge, x0, y0, x1, y1, kpa)

    def add_anchor(self, x: Number, y: Number, direction_deg: Number, force_kn: Number,
                   passive: bool = False) -> None:
        """The direction is that of its pull on the block, from x towards y. A passive anchor counts
        as resistance, an active one is subtracted from the overturning moment."""
        self._change(lib.tp_scene_add_anchor, c_number(x), c_number(y), c_number(direction_deg),
                     c_number(force_kn), passive)

    def add_bolt(self, x: Number, y: Number, dip_deg: Number, force_kn: Number,
                 passive: bool = False) -> None:
        """Bolts whose pull dips below the horizontal towards the up-dip side; they count as anchors do."""
        self._change(lib.tp_scene_add_bolt, c_number(x), c_number(y), c_number(dip_deg),
                     c_number(force_kn), passive)

    def set_bolt_towards(self, number: int, towards: Direction | str) -> None:
        """The side that the bolt added as the number-th of all anchors runs to, where it is not plain."""
        self._change(lib.tp_scene_set_bolt_towards, number, number_of(Direction, towards))

    def set_bolt_length(self, number: int, length: Number) -> None:
        """Its length, with which it must reach the rock behind the block."""
        self._change(lib.tp_scene_set_bolt_length, number, c_number(length))

    def set_bolt_capacity_kn(self, number: int, capacity_kn: Number) -> None:
        """What one of them can bear."""
        self._change(lib.tp_scene_set_bolt_capacity_kn, number, c_number(capacity_kn))

    def set_bolt_spacing(self, number: int, spacing: Number) -> None:
        """The distance of bolts of a row along the slope, out of the section."""
        self._change(lib.tp_scene_set_bolt_spacing, number, c_number(spacing))

    def set_bolt_rows(self, number: int, rows: int, dx: Number, dy: Number) -> None:
        """How many rows there are, each (dx, dy) from the one before."""
        self._change(lib.tp_scene_set_bolt_rows, number, rows, c_number(dx), c_number(dy))

    def add_support_pressure(self, x0: Number, y0: Number, x1: Number, y1: Number, first_kpa: Number,
                             last_kpa: Number, passive: bool = True) -> None:
        """A pressure of a lining or a wall along a line of the outline, at its two ends."""
        self._change(lib.tp_scene_add_support_pressure,
                     *map(c_number, (x0, y0, x1, y1, first_kpa, last_kpa)), passive)
