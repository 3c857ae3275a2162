# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""All resting poses of a block on its profile, and from which starting positions it comes to each.
Metres and degrees, as the names say; a starting position is a shift along x from where the scene
has the block."""

from __future__ import annotations

import dataclasses

from .contact import Fos, Rest
from .record import Bounded, Record, field
from .words import Direction, Mechanism, SettlingEnd


def _rests(c) -> bool:
    return tuple(SettlingEnd)[c.end] is SettlingEnd.COMES_TO_REST


@dataclasses.dataclass(frozen=True)
class Basin(Record):
    """Adjacent starting positions with the same outcome."""

    end: SettlingEnd
    pose: int | None = field(when=_rests)  #: index of the one in which it comes to rest
    from_m: Bounded
    to_m: Bounded
    share: Bounded  #: of all starting positions
    #: by what it turns in all next to the borders
    turned_from_deg: Bounded | None = field(when=_rests)
    turned_to_deg: Bounded | None = field(when=_rests)


@dataclasses.dataclass(frozen=True)
class PoseVerdict(Record):
    """Does a block stand in a pose, when the table is tilted in one direction?"""

    towards: Direction
    mechanism: Mechanism
    first: Mechanism
    first_angle_deg: Bounded | None = field(when="has_first_angle")
    fos: Fos  #: the governing one, at the scene's tilt
    least: bool  #: of all poses this one begins to move first as the table is tilted


@dataclasses.dataclass(frozen=True)
class RestingPose(Record):
    """A resting pose: what touches. Its numbers are those from the middle of its widest basin."""

    basins: int  #: that lead to it,
    widest: int  #: the widest of them,
    share: Bounded  #: and the share of all starting positions that they are
    shift_m: Bounded  #: the starting position that its numbers are of
    rest: Rest
    centroid_y_m: Bounded  #: how high it lies: its energy over its weight
    first_x_m: Bounded  #: of its points of contact, along x
    first_y_m: Bounded
    last_x_m: Bounded
    last_y_m: Bounded
    #: as many as the solution has cases; none where it cannot be solved there
    verdicts: tuple[PoseVerdict, ...] = field(count="verdict_count")


@dataclasses.dataclass(frozen=True)
class Poses(Record):
    """The resting poses of a block, the likeliest first."""

    from_m: Bounded  #: all starting positions: some part of it stands over the profile
    to_m: Bounded
    spacing_m: Bounded  #: no basin wider than that is missed; a narrower one may be
    border_m: Bounded  #: borders were narrowed to that, but where their errors say otherwise
    settlings: int  #: starting positions that were tried
    given: int | None = field(when="has_given")  #: index of that of the block as the scene has it
    poses: tuple[RestingPose, ...] = field(count="pose_count")
    basins: tuple[Basin, ...] = field(count="basin_count")  #: from left to right
