# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a solution says of one direction of tilt. Angles in degrees, 0 level; lengths in metres."""

from __future__ import annotations

import dataclasses

from ._library import lib
from .contact import Account, Fos
from .limit import Limit, Onset
from .record import Bounded, Record, field, struct_of
from .words import (Design, Direction, FactorStanding, FosDefinition, LoadSide, Mechanism, PivotKind,
                    Rolls)


def _turns(c) -> bool:
    return c.told and not c.never and not c.always


@dataclasses.dataclass(frozen=True)
class Pivot(Record):
    """A point of the underside about which the block may topple."""

    kind: PivotKind
    rounded: bool  #: the corner is: (x, y) is where the axis then lies
    admissible: bool  #: to first order: turning about it opens every contact facet
    told: bool  #: its numbers were asked for
    never: bool  #: loads keep it from toppling about this pivot at any tilt
    always: bool  #: or from standing on it at any
    x_m: Bounded | None = field(when="told")
    y_m: Bounded | None = field(when="told")
    critical_angle_deg: Bounded | None = field(when=_turns)  #: above 90 it never topples
    #: with loads: fails, or is held again
    limits_deg: tuple[Bounded, ...] = field(count="limit_count")
    fos_resultant: Fos | None = field(when="told")
    fos_elements: Fos | None = field(when="told")


def _slides(c) -> bool:
    return not c.never and not c.always


@dataclasses.dataclass(frozen=True)
class Sliding(Record):
    """Patton's sliding angle phi_b + i on the governing facet."""

    never: bool
    always: bool
    opens: bool  #: sliding along this facet is not blocked by another one
    uneven: bool  #: facets parallel to this one have more friction
    friction_angle_deg: Bounded
    facet_angle_deg: Bounded  #: positive where the block must climb
    facet_x0_m: Bounded
    facet_y0_m: Bounded
    facet_x1_m: Bounded
    facet_y1_m: Bounded
    critical_angle_deg: Bounded | None = field(when=_slides)
    fos: Fos
    fos_strength: Fos  #: by reducing tan(phi_b)


@dataclasses.dataclass(frozen=True)
class Toe(Record):
    """Can the toe alone hold the block at its critical angle?"""

    holds: bool
    upright: bool  #: a facet at the toe stands upright in the way: it holds at any angle
    limit_angle_deg: Bounded | None = field(when=lambda c: not c.upright)


@dataclasses.dataclass(frozen=True)
class LoadResult(Record):
    """A load's moment about the governing pivot at the scene's tilt, overturning positive."""

    name: str
    called_for_by: str
    moment_nm: Bounded
    side: LoadSide


@dataclasses.dataclass(frozen=True)
class Factor(Record):
    """A factor of safety against one mode of motion, by its definition."""

    definition: FosDefinition
    mechanism: Mechanism
    #: of the case's
    pivot: int | None = field(when=lambda c: c.definition == lib.TP_FOS_BY_MOMENTS)
    toe: bool  #: it is the end of the contact down-dip
    counts: bool  #: False: it is shown for comparison
    fos: Fos
    standing: FactorStanding  #: why it counts, or not
    raised: bool  #: by strength: more of it lets a motion begin, or less would stop it


@dataclasses.dataclass(frozen=True)
class GoverningFos(Record):
    """The governing factor of safety: below 1 exactly where a motion can begin at the tilt."""

    fos: Fos
    factor: int | None = field(when="has_factor")  #: it is that of this one of the factors
    tie: bool
    up_dip: bool
    beyond: bool
    sliding_judged: bool  #: False: the scene gives no friction angle
    complete: bool  #: False: `fos` is an upper bound
    factors: tuple[Factor, ...] = field(count="factor_count")


def _otherwise(c) -> bool:
    return c.limit_otherwise.kind != lib.TP_LIMIT_NOT_ASKED


@dataclasses.dataclass(frozen=True)
class Case(Record):
    """One direction of tilt."""

    towards: Direction
    pivots: tuple[Pivot, ...] = field(count="pivot_count")  #: from left to right along the contact
    #: index of the pivot with the least critical angle
    governing: int | None = field(when="has_governing")
    governing_tie: bool
    governing_tie_bits: int
    rolls: Rolls  #: the corner at the governing pivot
    rest_turn_deg: Bounded | None = field(when="rests")  #: it rolls to a new rest, turned by this
    sliding: Sliding | None = field(when=lambda c: c.sliding.known)
    toe: Toe | None = field(when=lambda c: c.toe.known)
    limit: Limit  #: with the base of the scene
    #: with a base that ends at the toe, or goes on
    limit_otherwise: Limit | None = field(when=_otherwise)
    base_matters: bool
    onset: Onset
    limit_back: Limit | None = field(when=lambda c: c.limit_back.kind != lib.TP_LIMIT_NOT_ASKED)
    mechanism: Mechanism  #: at the scene's tilt; without one, `first`
    first: Mechanism  #: what happens first as the table is tilted from level
    first_angle_deg: Bounded | None = field(when="has_first_angle")  #: where `first` happens
    #: of the tilt to the lower of onset and `first`
    margin_deg: Bounded | None = field(when="has_margin")
    margin_to_first_deg: Bounded | None = field(when="has_margin_to_first")
    slides_sooner: bool
    falls_backwards: bool
    governing_fos: GoverningFos  #: at the scene's tilt
    account: Account | None = field(when=lambda c: c.account.count > 0)
    loads: tuple[LoadResult, ...] = field(count="load_count")
    water_overtops_deg: Bounded | None = field(when="water_overtops")

    @property
    def governing_pivot(self) -> Pivot | None:
        """The governing pivot."""
        return None if self.governing is None else self.pivots[self.governing]

    def meets(self, design_fos: float) -> Design:
        """Is the governing factor of safety certainly as much, at a tilt at which the block
        stands?"""
        return tuple(Design)[lib.tp_case_meets(struct_of(self), design_fos)]
