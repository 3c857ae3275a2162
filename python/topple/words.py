# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The library's enumerations. A member's value is its word, as JSON and scene files have it:
Direction("left") is Direction.LEFT. Members stand in the order of C."""

from __future__ import annotations

import enum
from typing import TypeVar, Union


class Word(enum.Enum):
    """An enumeration of C."""

    def __str__(self) -> str:
        return self.value

    @classmethod
    def _missing_(cls, value: object):
        raise ValueError(f"{value!r} is none of " + ", ".join(repr(member.value) for member in cls))


W = TypeVar("W", bound=Word)


def number_of(kind: type[W], word: Union[W, str]) -> int:
    """The C value of a member, or of the word that it stands for."""
    return list(kind).index(kind(word))


class Direction(Word):
    """The side that a tilt lowers: left is that of small x."""

    LEFT = "left"
    RIGHT = "right"


class NoteKind(Word):
    """A note states how the input was interpreted; a caution what may be wrong with it, or is
    not covered."""

    NOTE = "note"
    CAUTION = "caution"


class Level(Word):
    """The arithmetic of the moment sums, by rising cost."""

    DOUBLE = "double"
    COMPENSATED = "compensated"
    BALL = "ball"
    EXACT = "exact"


class Mechanism(Word):
    """What a block does, or would do."""

    STANDS = "stands"
    SLIDES = "slides"
    TOPPLES = "topples"
    SLIDES_AND_TOPPLES = "slides and topples"
    INTERLOCKED = "interlocked"  #: neither slides nor topples at any tilt below 90 degrees
    MAY_MOVE = "may move"  #: some forces would hold it, but a motion can begin: depends on loading history
    LEAVES_BASE = "leaves its base"  #: every contact opens
    UNDECIDED = "undecided"


class SettlingEnd(Word):
    """Outcome for a block that is set down."""

    COMES_TO_REST = "comes to rest"
    ROLLS_OFF_LEFT = "rolls off to the left"
    ROLLS_OFF_RIGHT = "rolls off to the right"
    BALANCES = "balances"  #: its centroid lies exactly over the only point that could stop it
    UNDECIDED = "undecided"


class FosState(Word):
    """Why a factor of safety is a number, or is none."""

    NUMBER = "number"
    UNDEFINED = "undefined"  #: the weight lies past the pivot
    NO_TILT = "no tilt"  #: the scene gives no tilt angle
    NO_OVERTURNING = "no overturning"  #: nothing overturns or drives: the factor is unbounded
    UNDECIDED = "undecided"  #: at the precision allowed
    NOT_ASKED = "not asked"


class FosDefinition(Word):
    """By which definition a factor of safety is one."""

    BY_MOMENTS = "moments"  #: what stabilises over what overturns, about a pivot
    BY_SHEAR = "shear strength"  #: over shear force, along the facet that slides
    BY_ROUGHNESS = "shear strength with roughness"  #: tan(phi + i) / tan(tilt) on the mean plane
    #: the divisor, or the multiple, of all strength at which a motion can just begin
    BY_REDUCTION = "strength reduction"
    BY_TILT = "tilt"  #: tan of the tilt at which motions begin, or end, over that of the tilt


class FactorStanding(Word):
    """Does the factor of a way count?"""

    COUNTS = "counts"
    BLOCKED = "blocked"  #: this motion is blocked by a facet
    PREVENTED = "prevented"  #: contact forces prevent it
    UNEVEN = "uneven"  #: facets along which it would slide differ in friction
    SMOOTH = "smooth"  #: there is no shear strength to divide


class PivotKind(Word):
    """Where a pivot lies on the underside of the block."""

    VALLEY = "valley"  #: a low end: both neighbours on the underside are higher
    PEAK = "peak"  #: a high end: both neighbours are lower
    FLAT_END = "flat end"  #: the end of a facet that is parallel to the mean plane
    FLANK = "flank"  #: between a low and a high end


class ElementKind(Word):
    """An element of the account of moments."""

    TRIANGLE = "triangle"
    SLAB = "slab"


class LoadSide(Word):
    """Where a load counts in a factor of safety."""

    STABILISES = "stabilises"
    OVERTURNS = "overturns"
    LESSENS_OVERTURNING = "reduces the overturning moment"


class Rolls(Word):
    """What a rounded toe does beyond its critical angle."""

    NOT = "not"
    BACK = "back"  #: to a new rest
    OVER = "over"


class ContactEnd(Word):
    """Why the contact of a base begins, or ends, where it does."""

    WHOLE = "end of the underside"  #: all of a mated underside
    STATED = "between"  #: the scene's 'between'
    STEEP = "steeper than 45 degrees"  #: from there on it rises by more than it runs
    OVERHANG = "overhang"  #: beyond it the underside turns back over its support
    PROFILE = "profile"  #: where the block touches a separate profile first, or last


class LimitKind(Word):
    """Whether the static limit is an angle."""

    NOT_ASKED = "not asked"
    AT_ANGLE = "angle"
    INTERLOCKED = "every tilt"  #: forces hold it at every tilt up to 90 degrees
    NOWHERE = "nowhere"  #: no forces hold it at any tilt, or at single ones alone
    UNDECIDED = "undecided"


class OnsetKind(Word):
    """Whether the onset of motion is an angle."""

    NOT_ASKED = "not asked"
    AT_ANGLE = "angle"
    NEVER = "never"  #: no motion can begin at any tilt up to 90 degrees
    NOWHERE = "nowhere"  #: a motion can begin level, and at every tilt back from it
    UNDECIDED = "undecided"


class ContactState(Word):
    """What a contact does in a motion."""

    OPENS = "opens"
    STICKS = "sticks"
    SLIPS_DOWN_DIP = "slips down-dip"
    SLIPS_UP_DIP = "slips up-dip"


class PivotsListed(Word):
    """Which pivots get their numbers, and are listed."""

    BY_COUNT = "by count"
    ALL = "all"
    GOVERNING = "governing"


class Design(Word):
    """Whether a design factor of safety is met."""

    MET = "met"
    NOT_MET = "not met"
    OPEN = "open"


class FindTarget(Word):
    """What a number of the scene is found for. Angles in degrees."""

    CRITICAL_ANGLE = "critical_angle"  #: of toppling
    FOS = "fos"  #: against toppling, at the scene's tilt
    SLIDING_ANGLE = "sliding_angle"
    SLIDING_FOS = "sliding_fos"
    LIMIT_ANGLE = "limit_angle"  #: the static limit
    LIMIT_FOS = "limit_fos"  #: by strength reduction
    ONSET_ANGLE = "onset_angle"  #: the onset of motion
    GOVERNING_FOS = "governing_fos"  #: the governing factor at the scene's tilt


class Notation(Word):
    """How derived formulas are written."""

    TEXT = "text"
    LATEX = "latex"
    C = "c"


class CheckVerdict(Word):
    """What the solver finds beside a formula."""

    SAME = "same"
    OTHER = "other"
    NONE = "none"
    CONTACT = "contact"
    REFUSED = "refused"
    UNDECIDED = "undecided"


class Verdict(Word):
    """The verdict on a claim."""

    PROVEN = "proven"
    AGREES = "agrees"
    TRUNCATED = "truncated"
    REFUTED = "refuted"
    DISAGREES = "disagrees"
    UNDECIDED = "undecided"


class AccuracyMethod(Word):
    """A method for a number."""

    BOUNDARY = "boundary sums"
    TRIANGLES = "triangles"
    ROUNDED_PAPER = "rounding, paper's model"
    ROUNDED_EXACT = "rounding, exact model"
    LIMIT = "limit analysis"
    ONSET = "onset of motion"


class ProfileResampling(Word):
    """What lies between the points of a profile."""

    LINEAR = "linear"
    SPLINE = "spline"


class ProfileDetrend(Word):
    """The line that is subtracted from the heights of a profile, or that it is turned onto."""

    NONE = "none"
    LINE = "line"  #: of least squares
    ENDS = "ends"  #: through both ends
    TURN = "turn"  #: onto the mean plane


class ProfileWindow(Word):
    """The window of a spectrum."""

    HANN = "hann"
    NONE = "none"


class ProfileSeries(Word):
    """Whether a profile has series of heights."""

    GIVEN = "given"
    UNEVEN = "uneven"  #: its points lie at uneven distances
    SHORT = "short"


class ProfileOrigin(Word):
    """What a profile was taken from."""

    POINTS = "points"
    FILE = "file"
    BASE = "base profile"
    MATED_BASE = "mated base"


class JrcState(Word):
    """Whether a correlation is meant for a profile."""

    MEANT = "meant for it"
    OTHER_STEP = "meant for another step"
    OTHER_LENGTH = "meant for other lengths"
    OFF_SCALE = "beyond the profiles that it was fitted to"
    NO_NUMBER = "no number"


class StudyOutcome(Word):
    """Outcome of a sample of a study."""

    STANDS = "stands"
    SLIDES = "slides"
    TOPPLES = "topples"
    SLIDES_AND_TOPPLES = "slides and topples"
    LEAVES_BASE = "leaves its base"  #: every contact opens
    INTERLOCKED = "interlocked"  #: stands at every tilt
    MAY_MOVE = "may move"  #: the result depends on loading history
    UNDECIDED = "undecided"
    INVALID = "invalid"  #: the numbers make no scene


class StudyQuantity(Word):
    """A number that a sample of a study has."""

    MOMENTS_DEG = "moments_deg"  #: the critical angle of toppling by moments
    ONSET_DEG = "onset_deg"  #: certain to stand below
    LIMIT_DEG = "limit_deg"  #: certain to move beyond
    FOS = "fos"  #: the governing factor of safety at the scene's tilt


class StudyEnd(Word):
    """Why a study ended."""

    COMPLETE = "complete"
    CERTAIN = "certain"  #: every interval is as narrow as was asked
    INTERRUPTED = "interrupted"
    SHARD = "shard"  #: all samples of its shard


class TiltEngine(Word):
    """How a tilt test is simulated."""

    PATH = "path"
    RIGID = "dynamics by events"
    SPRINGS = "dynamics by springs"


class TiltProtocol(Word):
    """How the table is moved."""

    RAMP = "ramp"
    STEPS = "steps"
    RELEASE = "release"


class TiltEventKind(Word):
    """An event at a contact, or of the whole block."""

    OPENS = "opens"
    CLOSES = "closes"
    SLIPS = "slips"
    STICKS = "sticks"
    COLLAPSES = "begins to move"
    RESTS = "rests"
    OVERTURNS = "overturns"
    LEAVES_BASE = "leaves its base"
    ACCUMULATES = "stops bouncing"


class TiltEnd(Word):
    """How a simulated block ended."""

    STANDS = "stands"
    COLLAPSES = "begins to move"
    RESTS = "rests again"
    MOVES = "still moves"
    OVERTURNED = "overturned"
    LEFT_BASE = "left its base"
    OPEN = "undecided"
    STOPPED = "interrupted"


class TiltPlace(Word):
    """Where a simulated angle lies against the tilts of statics."""

    UNKNOWN = "unknown"
    WITHIN = "within"
    BELOW = "below the onset"
    BEYOND = "beyond the limit"


class ConvergeSetting(Word):
    """What is varied of a simulated test."""

    TOLERANCE = "bracket"
    STIFFNESS = "normal stiffness"
    STIFFNESS_RATIO = "shear over normal stiffness"
    TIME_STEP = "time step"
    DAMPING = "damping"
    ROUNDING = "radius of corners"
    STEP_TOLERANCE = "tolerance of steps"
    LEAST_BOUNCE = "least bounce"


class ConvergeQuantity(Word):
    """The quantity that is to converge."""

    ANGLE = "critical angle"
    OVERTURNING = "overturning factor"


class ConvergeVerdict(Word):
    """The outcome for one setting."""

    HOLDS = "holds"
    REFINED = "refined"
    DEPENDS = "not converged"
    OPEN = "undecided"


class ShakingAxis(Word):
    """Along what a base shakes."""

    HORIZONTALLY = "horizontally"
    VERTICALLY = "vertically"


class PulseShape(Word):
    """Half a period of a sine, or a whole one."""

    HALF_SINE = "half sine"
    FULL_SINE = "full sine"
