# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Verdicts on printed formulas and numbers."""

from __future__ import annotations

import dataclasses
import os

from ._library import ffi, lib
from .errors import checked
from .given import c_path, c_text
from .record import Bounded, Record, field, record, struct_of
from .report import written
from .words import Verdict


@dataclasses.dataclass(frozen=True)
class ClaimResult(Record):
    """The verdict on one claim. Texts are formulas as printed, or derived."""

    id: str
    where: str
    geometry: str | None
    quantity: str
    printed: str
    unit: str | None
    note: str | None
    verdict: Verdict
    is_formula: bool
    derived: str | None  #: the quantity in closed form, of its tangent if it is an angle
    difference: str | None  #: of a refuted formula: printed minus derived
    is_tangent: bool  #: derived and difference are of tangents of angles
    mend: str | None  #: the printed formula, mended by one change
    change: str | None  #: what the change is
    condition: str | None  #: what keeps the verdict from being more, or where a formula holds
    values: str | None = field(when="has_values")
    printed_value: Bounded | None = field(when="has_values")
    computed: Bounded | None = field(when="has_values")
    digits: int  #: of a formula that agrees in numbers
    points: int


@dataclasses.dataclass(frozen=True)
class Verification(Record):
    """The verdicts on the claims of a file."""

    title: str | None
    source: str | None
    claims: tuple[ClaimResult, ...] = field(count="count")
    tally: dict[Verdict, int] = field(read=lambda c, owner: dict(zip(Verdict, c.tally)))

    @property
    def objects(self) -> bool:
        """Is any claim refuted, or in disagreement?"""
        return lib.tp_verification_objects(struct_of(self))

    def report(self) -> str:
        """The report, as `topple verify` prints it."""
        return written(lib.tp_report_verification, struct_of(self))

    def to_json(self) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_verification_json, struct_of(self))

    def markdown(self) -> str:
        """A page in Markdown."""
        return written(lib.tp_report_verification_markdown, struct_of(self))


def _verified(call, *arguments) -> Verification:
    receives = ffi.new("tp_verification **")
    checked(call, receives, *arguments)
    owner = ffi.gc(receives[0], lib.tp_verification_free)
    return record(Verification, owner[0], owner)


def verify(path: str | os.PathLike) -> Verification:
    """Verdicts on the claims of a file."""
    return _verified(lib.tp_verify, c_path(path))


def verify_text(text: str, name: str = "claims") -> Verification:
    """The same from text; the scenes that the claims name are looked for beside a file called
    `name`."""
    return _verified(lib.tp_verify_text, c_text(text), c_path(name))
