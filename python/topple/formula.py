# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Formulas of the library in Python: quotients of polynomials, as texts that can be evaluated.

A polynomial in text is a sum of terms, each a product of a whole number and powers of symbols, as
3*a^2*tan(phi) - b. Its value is exact where the symbols' values are (int, Fraction), and a float
where they are floats."""

from __future__ import annotations

import dataclasses
import fractions
import functools
import re
from typing import TYPE_CHECKING, Any, Mapping

from ._library import lib
from .record import Record, struct_of
from .report import written
from .words import Direction

if TYPE_CHECKING:
    from .records import DerivedPivot

TERM = re.compile(r"\s*([+-])?\s*([^\s+-]+)")
FACTOR = re.compile(r"(\d+)|([^\W\d]\w*(?:\(\w+\))?)(?:\^(\d+))?")


@functools.lru_cache(maxsize=256)
def terms_of(polynomial: str) -> tuple[tuple[int, tuple[tuple[str, int], ...]], ...]:
    """The terms of a polynomial in text: whole number, and symbols with their exponents."""
    terms, place = [], 0
    while place < len(polynomial):
        term = TERM.match(polynomial, place)
        if term is None:
            raise not_text(polynomial)
        number, powers = -1 if term[1] == "-" else 1, []
        for factor in term[2].split("*"):
            found = FACTOR.fullmatch(factor)
            if found is None:
                raise not_text(polynomial)
            if found[1]:
                number *= int(found[1])
            else:
                powers.append((found[2], int(found[3] or 1)))
        terms.append((number, tuple(powers)))
        place = term.end()
    return tuple(terms)


def not_text(polynomial: str) -> ValueError:
    """It is LaTeX or C."""
    return ValueError(f"only formulas in the notation 'text' can be evaluated, not {polynomial!r}")


def value_of(polynomial: str, values: Mapping[str, Any]) -> Any:
    """The polynomial at the values of its symbols."""
    total: Any = 0
    for number, powers in terms_of(polynomial):
        product: Any = number
        for symbol, exponent in powers:
            if symbol not in values:
                raise KeyError(symbol)
            product = product * values[symbol] ** exponent
        total = total + product
    return total


class FractionMethods:
    def __call__(self: Any, values: Mapping[str, Any] | None = None, /, **more: Any) -> Any:
        """Its value at those of its symbols, by name; those that are no names of Python, as
        tan(phi), in a mapping: formula({"tan(phi)": 0.5}, a=30, b=120). Of whole numbers and
        Fractions it is exact."""
        given = {**(values or {}), **more}
        top, bottom = value_of(self.numerator, given), value_of(self.denominator, given)
        exact = isinstance(top, int) and isinstance(bottom, int)
        return fractions.Fraction(top, bottom) if exact else top / bottom

    def __str__(self: Any) -> str:
        return self.formula


class DerivationMethods:
    def governing(self: Any, towards: Direction | str) -> DerivedPivot | None:
        """The governing pivot in a direction."""
        for pivot in self.pivots:
            if pivot.governs and pivot.towards is Direction(towards):
                return pivot
        return None

    def report(self: Any) -> str:
        """The report, as `topple derive` prints it."""
        return written(lib.tp_report_derivation, struct_of(self))

    def to_json(self: Any) -> str:
        """JSON (docs/json.md)."""
        return written(lib.tp_report_derivation_json, struct_of(self))


def _parities(name: Any) -> Any:
    """Reads the numbers of teeth of odd and even members."""
    return lambda c, owner: {"odd": tuple(getattr(c, name)[0]), "even": tuple(getattr(c, name)[1])}


@dataclasses.dataclass(frozen=True)
class FamilyMethods(Record):
    #: the N that fix the formulas
    fixed_by: dict[str, tuple[int, ...]] = dataclasses.field(metadata={"read": _parities("fixed_by")})
    #: the N that they were checked on
    checked_on: dict[str, tuple[int, ...]] = dataclasses.field(metadata={"read": _parities("checked_on")})

    def report(self) -> str:
        """The report, as `topple derive --for-all=count` prints it."""
        return written(lib.tp_report_family, struct_of(self))

    def to_json(self) -> str:
        """The same as JSON."""
        return written(lib.tp_report_family_json, struct_of(self))
