# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a derivation holds: pivots, rounding, the limit and the onset in symbols. Lengths are scene
lengths."""

from __future__ import annotations

import dataclasses

from .formula import Fraction
from .record import Bounded, Record, field, text
from .words import CheckVerdict, Direction, ElementKind, Mechanism, OnsetKind, PivotKind


@dataclasses.dataclass(frozen=True)
class DerivedElement(Record):
    """One element about the governing pivot: its area times relative density, and the arms of its
    weight."""

    kind: ElementKind
    part: int
    area: Fraction
    normal_arm: Fraction
    parallel_arm: Fraction
    normal_stabilises: bool
    parallel_overturns: bool


def _split(c) -> bool:
    return c.has_elements and c.splits


@dataclasses.dataclass(frozen=True)
class DerivedPivot(Record):
    """A pivot in symbols. The factor of safety in resultant form is tangent cot(alpha); in elements
    form, where asked for, it is a quotient of sums, which where it splits is fos_cot cot(alpha) +
    fos_constant."""

    towards: Direction
    kind: PivotKind
    admissible: bool
    governs: bool
    x: Fraction
    y: Fraction
    tangent: Fraction  #: of the critical angle
    critical_angle_deg: Bounded  #: at the scene's values
    fos_cot: Fraction | None = field(when=_split)
    fos_constant: Fraction | None = field(when=_split)
    normal_stabilising: Fraction | None = field(when="has_elements")
    parallel_stabilising: Fraction | None = field(when="has_elements")
    normal_overturning: Fraction | None = field(when="has_elements")
    parallel_overturning: Fraction | None = field(when="has_elements")


@dataclasses.dataclass(frozen=True)
class DerivedRounding(Record):
    """The corner at the governing pivot, rounded (Appendix B), in r, sin(i), cos(i) and
    tan(alpha)."""

    kind: PivotKind
    tangent: Fraction
    length: Fraction  #: the r at which the block topples at alpha, (A2.4)
    radius: Fraction | None = field(when="has_radius")  #: the r_c that this r belongs to, (A2.6)


@dataclasses.dataclass(frozen=True)
class DerivedReaction(Record):
    """A force that holds the block at its limit, and its contact point."""

    x: Fraction
    y: Fraction
    against_slip: bool


@dataclasses.dataclass(frozen=True)
class DerivedCheck(Record):
    """A condition checked on both sides in numbers."""

    number: int  #: of the condition
    inside: str  #: the scene's numbers that were changed
    outside: str
    beyond: CheckVerdict


@dataclasses.dataclass(frozen=True)
class DerivedRow(Record):
    """What holds the weight in balance at the onset: a force at a contact point, or what
    accelerates the block."""

    is_force: bool
    against_slip: bool  #: of a force
    turns: bool  #: of a motion; else it slides, and no point is given
    x: Fraction | None = field(when=lambda c: c.is_force or c.turns)
    y: Fraction | None = field(when=lambda c: c.is_force or c.turns)


def _checks(c, owner) -> tuple[DerivedCheck, ...] | None:
    words = tuple(CheckVerdict)
    if not c.checks.run:
        return None
    return tuple(DerivedCheck(check.number, text(check.inside), text(check.outside),
                              words[check.beyond]) for check in c.checks.items[0:c.checks.count])


@dataclasses.dataclass(frozen=True)
class DerivedLimit(Record):
    """The static limit in symbols: it holds wherever no condition is below zero."""

    mechanism: Mechanism
    base_beyond_toe: bool
    tangent: Fraction  #: of the critical angle
    critical_angle_deg: Bounded  #: at the scene's values
    reactions: tuple[DerivedReaction, ...]
    centre_x: Fraction | None = field(when="has_centre")
    centre_y: Fraction | None = field(when="has_centre")
    positive: bool  #: all parameters are, and the conditions suppose so
    conditions: tuple[Fraction, ...] = field(count="condition_count")
    checks: tuple[DerivedCheck, ...] | None = field(read=_checks)


@dataclasses.dataclass(frozen=True)
class DerivedOnset(Record):
    """The onset of motion in symbols: it holds wherever all conditions are above zero."""

    kind: OnsetKind  #: at the scene's values
    mechanism: Mechanism
    below_limit: bool
    reason: str | None  #: why it is not derived
    same_as_limit: bool
    tangent: Fraction | None = field(when="known")
    critical_angle_deg: Bounded | None = field(when="known")
    rows: tuple[DerivedRow, ...] | None = field(when="known")
    positive: bool
    conditions: tuple[Fraction, ...] = field(count="condition_count")
    checks: tuple[DerivedCheck, ...] | None = field(read=_checks)
