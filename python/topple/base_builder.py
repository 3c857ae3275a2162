# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The calls that give a scene in memory its base (topple_scene.h, topple_generate.h); what `builder`
says of its calls holds."""

from __future__ import annotations

from typing import Any

from ._library import lib
from .given import Number, Points, c_number, c_points
from .options import options_of
from .word import Word, number_of
class LeftEnd(Word):
    """What a toothed underside begins with on the left."""

    VALLEY = "valley"
    PEAK = "peak"


class BaseBound(Word):
    """The side of a coordinate on which all vertices of a mated base lie."""

    BELOW = "below"
    LEFT_OF = "left of"
    RIGHT_OF = "right of"


class RoughnessBy(Word):
    """By which number it is said how rough a profile is."""

    RMS_HEIGHT = "rms_height"
    Z2 = "z2"
    JRC = "jrc"


class Wear(Word):
    """How asperities wear by a depth."""

    CUT = "cut"
    ROUNDED = "rounded"
    ABRADED = "abraded"


class BaseBuilder:
    """A scene in memory whose base is changed call by call."""

    def _change(self, call: Any, *arguments: Any) -> None:
        raise NotImplementedError

    def _change_numbers(self, call: Any, *values: Number) -> None:
        self._change(call, *[c_number(value) for value in values])

    def _change_by(self, call: Any, options: str, words: dict[str, Any],
                   **numbers: Number) -> None:
        """A call of the options tp_OPTIONS_options: whole numbers and enumerations as they are, and
        numbers taken exactly, whose texts live as long as the call."""
        held = {name: c_number(value) for name, value in numbers.items()}
        self._change(call, options_of(options, **words, **held))

    def _change_points(self, call: Any, points: Points, *more: Any) -> None:
        coordinates, held = c_points(points)
        self._change(call, coordinates, *more)
        del held

    # The base: mated with the underside, or a profile; the last one set is taken.

    def set_base_mated(self, whole: bool = False) -> None:
        """Mated with the underside, from its leftmost to its rightmost vertex where `whole`."""
        self._change(lib.tp_scene_set_base_mated, whole)

    def set_base_profile(self, profile: Points) -> None:
        """A profile from left to right, shape (n, 2)."""
        self._change_points(lib.tp_scene_set_base_profile, profile)

    def set_base_teeth(self, count: int, wavelength: Number, amplitude: Number,
                       left_end: LeftEnd | str = LeftEnd.VALLEY, *, skew: Number = 0,
                       wavelength_scatter: Number = 0, amplitude_scatter: Number = 0,
                       skew_scatter: Number = 0, start_x: Number = 0, start_y: Number = 0,
                       seed: int = 0) -> None:
        """A profile of teeth (docs/generate.md): `count` facets, two a tooth."""
        self._change_by(lib.tp_scene_set_base_teeth, "base_teeth",
                        {"count": count, "left_end": number_of(LeftEnd, left_end), "seed": seed},
                        wavelength=wavelength, amplitude=amplitude, skew=skew,
                        wavelength_scatter=wavelength_scatter, amplitude_scatter=amplitude_scatter,
                        skew_scatter=skew_scatter, start_x=start_x, start_y=start_y)

    def set_base_self_affine(self, length: Number, step: Number, hurst: Number,
                             by: RoughnessBy | str, roughness: Number, seed: int, *,
                             shortest: Number = 0, longest: Number = 0, start_x: Number = 0,
                             start_y: Number = 0) -> None:
        """A self-affine profile, as rough as one number says: by="jrc", roughness=8. Wavelengths of
        0 are two steps and the length."""
        self._change_by(lib.tp_scene_set_base_self_affine, "base_self_affine",
                        {"by": number_of(RoughnessBy, by), "seed": seed}, length=length, step=step,
                        hurst=hurst, roughness=roughness, shortest=shortest, longest=longest,
                        start_x=start_x, start_y=start_y)

    def set_base_jrc_profile(self, number: int) -> None:
        """A generated profile that stands in for Barton's standard profile of that number, 1 to 10,
        by its length and its JRC."""
        self._change(lib.tp_scene_set_base_jrc_profile, number)

    # What changes the profile that was set last: noise, then scaling, then wear.

    def set_base_noise(self, deviation: Number, seed: int) -> None:
        """Each point moved along y by a random number of that standard deviation."""
        self._change(lib.tp_scene_set_base_noise, c_number(deviation), seed)

    def set_base_scaled(self, by: RoughnessBy | str, roughness: Number) -> None:
        """Heights stretched until the profile is as rough as one number says."""
        self._change(lib.tp_scene_set_base_scaled, number_of(RoughnessBy, by), c_number(roughness))

    def set_base_worn(self, wear: Wear | str, depth: Number) -> None:
        """Asperities cut off, rounded or abraded by a depth."""
        self._change(lib.tp_scene_set_base_worn, number_of(Wear, wear), c_number(depth))

    def set_base_beyond(self, left: Number, right: Number) -> None:
        """By how much a mated base extends past the block."""
        self._change_numbers(lib.tp_scene_set_base_beyond, left, right)

    def set_base_between(self, two_vertices: Points) -> None:
        """A mated base whose contact ends in two vertices, the left one first, shape (2, 2)."""
        self._change_points(lib.tp_scene_set_base_between, two_vertices)

    def set_base_bound(self, bound: BaseBound | str, value: Number) -> None:
        """A mated base whose vertices lie all 'below' a height, or 'left of' or 'right of' an
        abscissa."""
        self._change(lib.tp_scene_set_base_bound, number_of(BaseBound, bound), c_number(value))

    def set_base_rest(self, rests: bool) -> None:
        """Set the block down on the profile, where its coordinates put it, until it rests; else it
        lies as they say."""
        self._change(lib.tp_scene_set_base_rest, rests)

    def set_base_poses(self, all_poses: bool) -> None:
        """Set the block down likewise, and list all its resting poses besides."""
        self._change(lib.tp_scene_set_base_poses, all_poses)

    def set_joint_matching(self, matching: Number, leftwards: bool = False) -> None:
        """The block is shifted by the least at which no more than a share of its underside is
        closed; the scene needs a closure."""
        self._change(lib.tp_scene_set_joint_matching, c_number(matching), leftwards)

