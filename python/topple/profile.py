# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""How rough a profile is, and which JRC follows from it (docs/profile.md)."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

from ._library import ffi, lib
from .chart import Chart, made
from .contact import Note, notes_of
from .errors import checked
from .given import Points, c_path, c_points, c_text
from .options import options_of
from .record import Bounded, Record, field, record, struct_of, text
from .report import written
from .scene import Scene, warn
from .words import (JrcState, ProfileDetrend, ProfileOrigin, ProfileResampling, ProfileSeries,
                    ProfileWindow, number_of)


@dataclasses.dataclass(frozen=True)
class ProfileEstimate(Record):
    """An estimate from one sample, with the range of 95 % where its spread is known."""

    found: bool  #: else there is none
    value: float | None = field(when="found")
    low: float | None = field(when="has_range")
    high: float | None = field(when="has_range")


@dataclasses.dataclass(frozen=True)
class ProfileFacing(Record):
    """The facets that a block sliding to one side must climb."""

    facets: int
    share: Bounded  #: of the length along the profile
    angle_deg: Bounded  #: i of these
    steepest_deg: Bounded  #: theta*max
    exponent: float  #: C, by least squares
    fit_rms: float
    roughness_deg: float  #: theta*max / (C + 1)


@dataclasses.dataclass(frozen=True)
class ProfileLag(Record):
    """Pairs of heights at one distance."""

    distance: float
    structure: float  #: mean square of their difference
    correlation: float
    pairs: int


@dataclasses.dataclass(frozen=True)
class ProfileDensity(Record):
    """An ordinate of the spectrum: length^3 at a frequency in cycles per length."""

    frequency: float
    density: float


@dataclasses.dataclass(frozen=True)
class ProfileJrc(Record):
    """JRC by one correlation."""

    authors: str
    equation: str
    step: str  #: that it is meant for; empty: any
    own_step: float  #: at which its input was measured; 0: the profile's points
    input: Bounded
    jrc: Bounded
    state: JrcState


def _sources(c, owner) -> tuple[str | None, ...]:
    return tuple(text(c.sources[k]) for k in range(c.source_count))


def _doubles(name: str):
    return lambda c, owner: tuple(ffi.unpack(getattr(c, name), c.point_count))


def _options(c, owner) -> dict[str, Any]:
    own = c.options
    return {"step": own.step, "resampling": tuple(ProfileResampling)[own.resampling],
            "detrend": tuple(ProfileDetrend)[own.detrend],
            "window": tuple(ProfileWindow)[own.window], "mirrored": own.mirrored,
            "scale": own.scale}


@dataclasses.dataclass(frozen=True)
class Profile(Record):
    """The roughness of a profile. Lengths are in its length unit."""

    title: str | None
    origin: ProfileOrigin
    length_unit: str
    metres_per_unit: float
    options: dict[str, Any] = field(read=_options)  #: as they were taken
    notes: tuple[Note, ...] = field(read=notes_of)
    sources: tuple[str, ...] = field(read=_sources)  #: files that it was read from
    given_points: int  #: before resampling
    x: tuple[float, ...] = field(read=_doubles("x"))
    y: tuple[float, ...] = field(read=_doubles("y"))
    even: bool  #: the points lie at equal distances
    step: float  #: mean distance along x
    least_step: float
    largest_step: float
    length: Bounded
    along: Bounded
    amplitude: Bounded
    rms_height: Bounded
    trend_deg: Bounded
    mean_slope: Bounded
    absolute_slope: Bounded
    z2: Bounded
    effective_angle_deg: Bounded  #: i
    rp: Bounded
    sf: Bounded | None = field(when="has_sf")
    facing: tuple[ProfileFacing, ...]  #: of a block that slides to the left, to the right
    series: ProfileSeries
    lags: tuple[ProfileLag, ...] = field(count="lag_count")
    correlation_length: ProfileEstimate
    densities: tuple[ProfileDensity, ...] = field(count="density_count")
    hurst_by_structure: ProfileEstimate
    hurst_by_spectrum: ProfileEstimate
    structure_fit: tuple[float, ...]  #: the least and the largest distance
    spectrum_fit: tuple[float, ...]  #: the least and the largest frequency
    jrc: tuple[ProfileJrc, ...] = field(count="jrc_count")
    jrc_meant: int  #: so many are meant for this profile
    jrc_low: Bounded | None = field(when="jrc_meant")
    jrc_high: Bounded | None = field(when="jrc_meant")
    jrc_median: Bounded | None = field(when="jrc_meant")
    jcs_mpa: float | None = field(when="has_eq_10")
    normal_stress_kpa: float | None = field(when="has_eq_10")
    jrc_eq_10: Bounded | None = field(when="has_eq_10")

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


def _asked(given: dict[str, Any]):
    """The options: words by their names."""
    words = {"resampling": ProfileResampling, "detrend": ProfileDetrend, "window": ProfileWindow}
    return options_of("profile", **{name: number_of(words[name], value) if name in words else value
                                    for name, value in given.items()})


def _taken(receives) -> Profile:
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


def profile_of_file(path: str | os.PathLike, length_unit: str = "mm", **options: Any) -> Profile:
    """The profile in a CSV file of x, y."""
    receives = ffi.new("tp_profile **")
    checked(lib.tp_profile_of_file, receives, c_path(path), c_text(length_unit), _asked(options))
    return _taken(receives)


def profile_of_scene(scene: Scene, **options: Any) -> Profile:
    """The base of a scene: its profile, or of a mated base the part that the block touches."""
    receives = ffi.new("tp_profile **")
    scene._use(lib.tp_profile_of_scene, receives, scene._c, _asked(options))
    return _taken(receives)
