# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The block of a solution, its frame, and where it touches its base. Metres, newtons and degrees,
as the names say."""

from __future__ import annotations

import dataclasses

from ._library import lib
from .record import Bounded, Record, field, record, text
from .words import (ContactEnd, Direction, ElementKind, FosState, Level, Mechanism, NoteKind,
                    PivotKind)


@dataclasses.dataclass(frozen=True)
class Setting(Record):
    """A number that was set in the scene: its key, the formula, and what it says."""

    key: str
    formula: str
    unit: str | None  #: of a length: that of the scene; None: the key names it, or there is none
    value: Bounded


@dataclasses.dataclass(frozen=True)
class ResultUnit(Record):
    """A unit that reports print in: one of it is `si` of m, N, N m or Pa."""

    name: str | None  #: None: the scene asks for none
    si: float


@dataclasses.dataclass(frozen=True)
class ResultUnits(Record):
    """Those that a scene asks for."""

    length: ResultUnit
    force: ResultUnit
    moment: ResultUnit
    stress: ResultUnit


def settings_of(c, owner) -> tuple[Setting, ...]:
    """The settings of a list."""
    return tuple([record(Setting, own, owner) for own in c.settings.items[0:c.settings.count]])


@dataclasses.dataclass(frozen=True)
class Note(Record):
    """A note or caution beside an answer: `place` is file:line:column, or the call, or empty."""

    kind: NoteKind
    place: str
    text: str


def notes_of(c, owner) -> tuple[Note, ...]:
    """The notes of a list."""
    return tuple([Note(tuple(NoteKind)[note.kind], text(note.place), text(note.text))
                  for note in c.notes.items[0:c.notes.count]])


@dataclasses.dataclass(frozen=True)
class Fos(Record):
    """A factor of safety: a number, or why it is none."""

    state: FosState
    value: Bounded | None = field(when=lambda c: c.state == lib.TP_FOS_NUMBER)

    def __float__(self) -> float:
        if self.value is None:
            raise ValueError(f"the factor of safety is not a number: {self.state}")
        return self.value.value


@dataclasses.dataclass(frozen=True)
class FacetFriction(Record):
    """Facets of the base with a friction angle of their own, from one number to another, counted from
    1 from left to right."""

    first: int
    last: int
    touching: int  #: how many facets and single points of the contact are of them
    angle_deg: Bounded


@dataclasses.dataclass(frozen=True)
class Effect(Record):
    """An effect that was computed, the input that required it, and its time."""

    name: str
    called_for_by: str
    seconds: float
    level: Level


@dataclasses.dataclass(frozen=True)
class Frame(Record):
    """What the coordinates of the scene lie along. In the world's frame results are along the mean
    plane, turned about one point, whose coordinates do not change."""

    stated: bool
    world: bool  #: y runs up: the block lies as it lies
    level: bool  #: results are along the horizontal: an earthquake up-dip
    fitted: bool  #: the mean plane, to the contact; else given
    dips: bool  #: the mean plane is not level
    dips_towards: Direction | None = field(when="dips")
    dip_deg: Bounded | None = field(when="dips")  #: part of the tilt angle
    about_x_m: Bounded | None = field(when="world")
    about_y_m: Bounded | None = field(when="world")
    inclined: bool  #: not stated, and the contact's mean line lies at more than 1 in 10
    inclination_deg: Bounded  #: positive where it rises to the right


def _presses(c) -> bool:
    """The block has a weight, and a contact of some length."""
    return c.weight_per_contact_area_pa.value != 0


@dataclasses.dataclass(frozen=True)
class Earthquake(Record):
    """An earthquake that was considered, for a block that lies on a slope."""

    towards: Direction  #: the side to which its horizontal part drives the block
    up_dip: bool  #: against the dip
    vertical: bool  #: with the scene's vertical part
    mechanism: Mechanism  #: what the block does under it
    fos: Fos  #: its governing factor


@dataclasses.dataclass(frozen=True)
class Contact(Record):
    """Where a block touches its base."""

    mated: bool
    shifted: bool  #: it was mated, before the block was shifted along it
    beyond_stated: bool  #: False: the scene does not say how far the base goes on; taken as 0
    beyond_left_m: Bounded
    beyond_right_m: Bounded
    left_end: ContactEnd
    right_end: ContactEnd
    left_x_m: Bounded
    left_y_m: Bounded
    right_x_m: Bounded
    right_y_m: Bounded
    steep: bool  #: some facet lies at more than 45 degrees from the mean plane
    steepest_deg: Bounded
    reach: Bounded  #: the highest contact over the lowest, a share of the block's height
    reaches_far: bool  #: above a half
    facets: int  #: of positive length
    points: int  #: contacts in a single point
    corner_points: int  #: of these: a corner on a corner
    length_m: Bounded  #: along the facets
    nominal_length_m: Bounded  #: projected on the mean plane
    #: on a profile: that length over that of the underside
    contact_ratio: Bounded | None = field(when="has_contact_ratio")
    weight_per_contact_area_pa: Bounded | None = field(when=_presses)
    weight_per_nominal_area_pa: Bounded | None = field(when=_presses)


@dataclasses.dataclass(frozen=True)
class Rest(Record):
    """How a block that was set down on its base came to rest."""

    turns: int  #: each about another point, or the other way round
    touches: int  #: points of contact at rest
    turned_deg: Bounded  #: in all, counter-clockwise above 0
    moved_x_m: Bounded  #: its centroid
    moved_y_m: Bounded
    #: along x from the outermost contacts to the weight's line; below 0: wedged in
    margin_left_m: Bounded
    margin_right_m: Bounded


@dataclasses.dataclass(frozen=True)
class Joint(Record):
    """The opening of the joint of a block that was shifted along its mated base. Gaps are along y, and
    lengths along x, of the part of the underside that lies above the base."""

    shift_m: Bounded  #: to the right above 0
    above_base_m: Bounded  #: how much of the underside that is
    largest_gap_m: Bounded
    mean_gap_m: Bounded  #: the area of the gap over that length
    closure_m: Bounded | None = field(when="has_closure")  #: gaps up to this count as closed
    matching: Bounded | None = field(when="has_closure")  #: so much of all of the underside is
    #: the most of it that the scene asks for; the last shift that was looked at before this one,
    #: and what is closed there
    matching_sought: Bounded | None = field(when="has_matching_sought")
    shift_before_m: Bounded | None = field(when="has_matching_sought")
    matching_before: Bounded | None = field(when="has_matching_sought")


@dataclasses.dataclass(frozen=True)
class Within(Record):
    """The parts near its contact that were moved there."""

    moved: int  #: vertices of the block, onto its base
    taken: int  #: points of the profile that became vertices of the block
    within_m: Bounded  #: what the scene says
    farthest_m: Bounded  #: the farthest that anything was moved
    gap_left_m: Bounded  #: along y, the largest between the first contact and the last
    overlap_removed_m: Bounded  #: the deepest that a vertex of one lay in the other


@dataclasses.dataclass(frozen=True)
class Block(Record):
    """The block: its area, the centroid of its weight, and its second moments about the centroid,
    weighted by unit weight over mean unit weight."""

    area_m2: Bounded
    centroid_x_m: Bounded
    centroid_y_m: Bounded
    second_moment_xx_m4: Bounded
    second_moment_yy_m4: Bounded
    second_moment_xy_m4: Bounded
    thickness_m: Bounded
    weight_n: Bounded | None = field(when="has_weight")
    vertices: int  #: 0: an ellipse
    holes: int
    parts: int
    triangles: int


@dataclasses.dataclass(frozen=True)
class Teeth(Record):
    """A toothed block in both descriptions of Alejano et al.: N, a, b, c, and dx, y, A, lambda."""

    count: int
    width_m: Bounded
    height_m: Bounded
    depth_m: Bounded
    block_width_m: Bounded
    mean_height_m: Bounded
    amplitude_m: Bounded
    wavelength_m: Bounded
    left_end: PivotKind
    right_end: PivotKind


@dataclasses.dataclass(frozen=True)
class Element(Record):
    """One element of the account of moments about the governing pivot. Weights are in newtons, or
    fractions of the block's where the scene gives no unit weight."""

    kind: ElementKind
    part: int  #: 0: the block; k: its k-th part
    weight: Bounded
    normal_arm_m: Bounded  #: of the component W cos(alpha); above 0 it stabilises
    parallel_arm_m: Bounded  #: of the component W sin(alpha); above 0 it overturns
    stabilising: Bounded
    overturning: Bounded
    area_m2: Bounded
    centroid_x_m: Bounded
    centroid_y_m: Bounded


@dataclasses.dataclass(frozen=True)
class Account(Record):
    """The account of moments by elements, at the scene's tilt or, without one, at the limit."""

    elements: tuple[Element, ...] = field(count="count")
    at_critical_angle: bool
    angle_deg: Bounded
    stabilising: Bounded
    overturning: Bounded
