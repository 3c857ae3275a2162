# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The static limit and the onset of motion of a case. Degrees from level, metres, and forces as
shares of the weight."""

from __future__ import annotations

import dataclasses

from ._library import lib
from .contact import Fos
from .record import Bounded, Record, field
from .words import ContactState, LimitKind, Mechanism, OnsetKind


@dataclasses.dataclass(frozen=True)
class Reaction(Record):
    """A force of the base on the block at the limit, along an edge of the friction cone at an end
    of a facet."""

    x_m: Bounded
    y_m: Bounded
    share_x: Bounded
    share_y: Bounded
    of_facet: bool  #: False: of the base that goes on, where the scene's ends
    facet: int  #: from left to right along the contact
    at_right_end: bool
    against_slip: bool  #: friction acts up-dip; else down-dip


@dataclasses.dataclass(frozen=True)
class Limit(Record):
    """The static limit: beyond it no forces of the base hold the block; below it some do."""

    kind: LimitKind
    too_dear: bool  #: undecided, since the proof takes more work than is allowed
    friction_angle_deg: Bounded | None = field(when=lambda c: c.kind != lib.TP_LIMIT_NOT_ASKED)
    critical_angle_deg: Bounded | None = field(when=lambda c: c.kind == lib.TP_LIMIT_AT_ANGLE)
    mechanism: Mechanism
    tie: bool  #: another mechanism has the same limit
    tied_with: Mechanism | None = field(when="tie")
    tie_bits: int  #: 0: exactly
    turns_up_dip: bool
    centre_x_m: Bounded | None = field(when="has_centre")  #: of rotation
    centre_y_m: Bounded | None = field(when="has_centre")
    facet_x0_m: Bounded | None = field(when="has_facet")  #: along which it slides
    facet_y0_m: Bounded | None = field(when="has_facet")
    facet_x1_m: Bounded | None = field(when="has_facet")
    facet_y1_m: Bounded | None = field(when="has_facet")
    reactions: tuple[Reaction, ...] = field(count="reaction_count")
    fos: Fos  #: by strength reduction
    fos_mechanism: Mechanism
    base_beyond_toe: bool  #: of the base that this is the limit for


@dataclasses.dataclass(frozen=True)
class Window(Record):
    """Tilts at which a motion can begin, both ends included. None: it has no end there within -90
    to 90 degrees."""

    from_deg: Bounded | None = field(when=lambda c: not c.from_below)
    to_deg: Bounded | None = field(when=lambda c: not c.to_above)
    begins: Mechanism  #: at its lower end, or, without one, at its upper end
    from_by_strength: bool  #: a little more or less of all strength moves that end; told of the
    to_by_strength: bool  #: ends next to the scene's tilt


def _motions(c, owner) -> tuple[Mechanism, ...]:
    return tuple(mechanism for k, mechanism in enumerate(Mechanism) if c.motions >> k & 1)


@dataclasses.dataclass(frozen=True)
class MotionRange(Record):
    """Tilts throughout which the same motions can begin."""

    from_deg: Bounded | None = field(when=lambda c: not c.from_below)
    to_deg: Bounded | None = field(when=lambda c: not c.to_above)
    motions: tuple[Mechanism, ...] = field(read=_motions)


@dataclasses.dataclass(frozen=True)
class MotionContact(Record):
    """An end of a facet in a motion, and the force on the block there."""

    facet: int
    of_facet: bool
    at_right_end: bool
    state: ContactState
    pivot: int | None = field(when="has_pivot")  #: of the case's pivots the one that it lies in
    share_x: Bounded | None = field(when="has_force")
    share_y: Bounded | None = field(when="has_force")


@dataclasses.dataclass(frozen=True)
class MotionResistance(Record):
    """The resistance to a motion: a force over the weight, and its moment about the centroid
    over the weight."""

    share_x: Bounded
    share_y: Bounded
    moment_m: Bounded


@dataclasses.dataclass(frozen=True)
class Motion(Record):
    """A mode in which the block can begin to move at the scene's tilt. Accelerations in units of
    gravity."""

    mechanism: Mechanism
    acceleration_x_g: Bounded
    acceleration_y_g: Bounded
    angular_g_per_m: Bounded
    accelerations_fixed: bool  #: False: a range of them is possible; the least is given,
    greatest: bool  #: or the greatest
    cohesion: MotionResistance | None = field(when="has_strength")
    bond: MotionResistance | None = field(when="has_strength")
    centre_x_m: Bounded | None = field(when="has_centre")
    centre_y_m: Bounded | None = field(when="has_centre")
    contacts: tuple[MotionContact, ...] = field(count="contact_count")  #: those that do not open


def _beginnings(c, owner) -> tuple[Mechanism, ...]:
    words = tuple(Mechanism)
    return tuple(words[c.beginnings[k]] for k in range(c.beginning_count))


@dataclasses.dataclass(frozen=True)
class Onset(Record):
    """The onset of motion: up to its angle no motion can begin from rest, and the block is certain
    to stand."""

    kind: OnsetKind
    too_dear: bool
    friction_angle_deg: Bounded | None = field(when=lambda c: c.kind != lib.TP_ONSET_NOT_ASKED)
    critical_angle_deg: Bounded | None = field(when=lambda c: c.kind == lib.TP_ONSET_AT_ANGLE)
    mechanism: Mechanism | None = field(when=lambda c: c.kind == lib.TP_ONSET_AT_ANGLE)
    tie: bool
    tied_with: Mechanism | None = field(when="tie")
    tie_bits: int
    centre_x_m: Bounded | None = field(when="has_centre")
    centre_y_m: Bounded | None = field(when="has_centre")
    below_limit: bool  #: by more than 1e-6 degrees: between them the result depends on loading history
    windows: tuple[Window, ...] = field(count="window_count")
    ranges: tuple[MotionRange, ...] | None = field(count="range_count", when="has_ranges")
    paradox: bool  #: of Painlevé: rigid bodies with Coulomb friction have no unique answer
    motions: tuple[Motion, ...] | None = field(count="motion_count", when="has_motions")
    beginnings: tuple[Mechanism, ...] | None = field(read=_beginnings, when="has_motions")
    fos: Fos  #: by a change of all strength at the scene's tilt: above 1 where no motion can begin
    fos_raised: bool  #: what changes it is more strength, not less
    fos_mechanism: Mechanism  #: what begins, or ends, there
