# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How rough a profile is, and which JRC follows from it (docs/profile.md)."""

from __future__ import annotations

from typing import Any

from ._library import ffi, lib
from .errors import checked
from .given import File, Points, c_path, c_points, c_text
from .options import options_of
from .record import record
from .records import Profile
from .scene import Scene, warn
from .word import number_of
from .words import ProfileDetrend, ProfileResampling, ProfileWindow
def _asked(given: dict[str, Any]) -> Any:
    """The options: words by their names."""
    words = {"resampling": ProfileResampling, "detrend": ProfileDetrend, "window": ProfileWindow}
    return options_of("profile", **{name: number_of(words[name], value) if name in words else value
                                    for name, value in given.items()})


def _taken(receives: Any) -> Profile:
    owner = ffi.gc(receives[0], lib.tp_profile_free)
    profile = record(Profile, owner[0], owner)
    warn(profile.notes, 4)
    return profile


def profile_of_points(points: Points, length_unit: str = "mm", **options: Any) -> Profile:
    """The profile through points from left to right, shape (n, 2). Options, as docs/profile.md has
    them: `step`, `resampling`, `detrend`, `window`, `mirrored`, `scale`, `jcs_mpa`,
    `normal_stress_kpa`."""
    coordinates, kept = c_points(points)
    receives = ffi.new("tp_profile **")
    checked(lib.tp_profile_of_points, receives, coordinates, c_text(length_unit), _asked(options))
    del kept
    return _taken(receives)


def profile_of_file(path: File, length_unit: str = "mm", **options: Any) -> Profile:
    """The profile in a CSV file of x, y."""
    receives = ffi.new("tp_profile **")
    checked(lib.tp_profile_of_file, receives, c_path(path), c_text(length_unit), _asked(options))
    return _taken(receives)


def profile_of_scene(scene: Scene, **options: Any) -> Profile:
    """The base of a scene: its profile, or of a mated base the part that the block touches."""
    receives = ffi.new("tp_profile **")
    scene._use(lib.tp_profile_of_scene, receives, scene._c, _asked(options))
    return _taken(receives)
