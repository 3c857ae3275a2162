# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The closed formulas of a scene in its parameters."""

from __future__ import annotations

import dataclasses

from ._library import ffi, lib
from .contact import Note, notes_of
from .derivation import DerivedElement, DerivedLimit, DerivedOnset, DerivedPivot, DerivedRounding
from .formula import Fraction
from .options import options_of
from .record import Record, field, record, struct_of, text
from .report import written
from .scene import Scene, warn
from .words import Direction, Notation, PivotKind, number_of


def _texts(name):
    """Reads the texts of an array, as many as there are symbols."""
    return lambda c, owner: tuple(text(getattr(c, name)[k]) for k in range(c.symbol_count))


def _by_direction(name, kind, there):
    """Reads those of the two directions that are there."""

    def read(c, owner):
        both = getattr(c, name)
        return {towards: record(kind, both[k], owner) for k, towards in enumerate(Direction)
                if there(both[k])}

    return read


def _elements(c, owner):
    return {towards: tuple(record(DerivedElement, c.elements[k][i], owner)
                           for i in range(c.element_count))
            for k, towards in enumerate(Direction) if c.elements[k]}


@dataclasses.dataclass(frozen=True)
class Derivation(Record):
    """The formulas of a scene. What depends on the direction of tilt is kept by it."""

    title: str | None
    notation: Notation
    area: Fraction
    x_moment: Fraction  #: about the scene's origin, weighted by relative density
    y_moment: Fraction
    symbols: tuple[str, ...] = field(read=_texts("symbols"))  #: as the formulas write them
    parameters: tuple[str, ...] = field(read=_texts("parameters"))  #: as the scene calls them
    pivots: tuple[DerivedPivot, ...] = field(count="pivot_count")
    elements: dict[Direction, tuple[DerivedElement, ...]] = field(read=_elements)
    rounded: dict[Direction, DerivedRounding] = field(read=_by_direction("rounded", DerivedRounding,
                                                                         lambda c: c.known))
    limit: dict[Direction, DerivedLimit] = field(read=_by_direction("limit", DerivedLimit,
                                                                    lambda c: c.known))
    onset: dict[Direction, DerivedOnset] = field(
        read=_by_direction("onset", DerivedOnset, lambda c: c.kind != lib.TP_ONSET_NOT_ASKED))
    notes: tuple[Note, ...] = field(read=notes_of)

    def governing(self, towards: Direction | str) -> DerivedPivot | None:
        """The governing pivot in a direction."""
        for pivot in self.pivots:
            if pivot.governs and pivot.towards is Direction(towards):
                return pivot
        return None

    def report(self) -> str:
        """The report, as `topple derive` prints it."""
        return written(lib.tp_report_derivation, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_derivation_json, struct_of(self))


def derive(scene: Scene, *, notation: Notation | str = Notation.TEXT, elements: bool | None = None,
           rounded: bool | None = None, limit: bool | None = None,
           checked: bool | None = None) -> Derivation:
    """The closed formulas of a scene in its parameters, in scene lengths; a scene from a file or a
    text, as one built in memory has no parameters. `elements`: the elements form; `rounded`: the
    corners at the governing pivots; `limit`: the static limit and the onset of motion; `checked`:
    their conditions checked on both sides in numbers."""
    options = options_of("derive", notation=number_of(Notation, notation), elements=elements,
                         rounded=rounded, limit=limit, checked=checked)
    receives = ffi.new("tp_derivation **")
    scene._use(lib.tp_derive, receives, scene._c, options)
    owner = ffi.gc(receives[0], lib.tp_derivation_free)
    derivation = record(Derivation, owner[0], owner)
    warn(derivation.notes, 3)
    return derivation


@dataclasses.dataclass(frozen=True)
class FamilyFormula(Record):
    """One formula for every number of teeth of one parity, of the toe of one direction of tilt."""

    towards: Direction
    even: bool
    kind: PivotKind  #: of the toe
    tangent: Fraction  #: of the critical angle


def _parities(name):
    """Reads the numbers of teeth of odd and even members."""
    return lambda c, owner: {"odd": tuple(getattr(c, name)[0]), "even": tuple(getattr(c, name)[1])}


@dataclasses.dataclass(frozen=True)
class Family(Record):
    """The formulas of a toothed block for every number N of teeth."""

    title: str | None
    notation: Notation
    count: str  #: what N is: a symbol, or 2 dx / lambda
    count_is_symbol: bool
    symbols: tuple[str, ...] = field(read=_texts("symbols"))
    parameters: tuple[str, ...] = field(read=_texts("parameters"))
    #: the N that fix the formulas
    fixed: dict[str, tuple[int, ...]] = field(read=_parities("fixed"))
    #: the N that they were checked on
    checked: dict[str, tuple[int, ...]] = field(read=_parities("checked"))
    formulas: tuple[FamilyFormula, ...]

    def report(self) -> str:
        """The report, as `topple derive --for-all=count` prints it."""
        return written(lib.tp_report_family, struct_of(self))

    def to_json(self) -> str:
        """The same as JSON."""
        return written(lib.tp_report_family_json, struct_of(self))


def derive_family(scene: Scene, notation: Notation | str = Notation.TEXT) -> Family:
    """One formula for every number of teeth of a toothed block, for the scene's left end."""
    receives = ffi.new("tp_family **")
    scene._use(lib.tp_derive_family, receives, scene._c, number_of(Notation, notation))
    owner = ffi.gc(receives[0], lib.tp_family_free)
    return record(Family, owner[0], owner)
