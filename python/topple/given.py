# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What Python gives the library: exact numbers, points, texts and paths, as C takes them.

A float is the double that it is, and so is a number of NumPy; an int, a Fraction and a Decimal are
what they are; a text is a decimal ("0.1") or a fraction of decimals ("1/3"). Nothing is rounded on
the way in."""

from __future__ import annotations

import fractions
import math
import numbers
import os
import sys
from decimal import Decimal
from typing import TYPE_CHECKING, Any, Sequence, Union

from ._library import ffi
from .errors import BadInput

if TYPE_CHECKING:
    import numpy

#: A number taken exactly.
Number = Union[float, int, str, fractions.Fraction, Decimal, numbers.Real]
#: Points: an array of shape (n, 2), or n pairs of numbers.
Points = Union["numpy.ndarray[Any, Any]", Sequence[Sequence[Number]]]
#: The name of a file.
File = Union[str, "os.PathLike[str]"]

NULL = ffi.NULL
WHOLE_IN_A_DOUBLE = 2**53


def c_text(text: str) -> Any:
    """A text for C, which ends at its first NUL."""
    if not isinstance(text, str):
        raise TypeError(f"a text must be str, not {type(text).__name__}")
    if "\0" in text:
        raise BadInput("a text must not have a NUL in it")
    return ffi.new("char[]", text.encode("utf-8", "surrogateescape"))


def c_path(path: File | bytes) -> Any:
    """The name of a file for C."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise BadInput("the name of a file must not have a NUL in it")
    return ffi.new("char[]", name)


def exact_text(number: Number) -> str | None:
    """The text that is the number exactly; None for one that is a double."""
    if isinstance(number, str):
        return number
    if isinstance(number, bool) or not isinstance(number, (numbers.Real, Decimal)):
        raise TypeError("a number must be float, int, str, Fraction or Decimal, not"
                        f" {type(number).__name__}")
    if isinstance(number, numbers.Integral):
        whole = int(number)
        return None if -WHOLE_IN_A_DOUBLE <= whole <= WHOLE_IN_A_DOUBLE else str(whole)
    if isinstance(number, numbers.Rational):
        return f"{number.numerator}/{number.denominator}"
    if isinstance(number, Decimal):
        return str(number) if number.is_finite() else None
    other: Any = number
    if getattr(other, "itemsize", 0) > 8 and abs(other) <= sys.float_info.max:
        return "/".join(map(str, other.as_integer_ratio()))  # a long double of NumPy
    return None


def c_number(number: Number) -> tuple[Any, ...]:
    """A tp_exact. It holds its text."""
    if number.__class__ is float:
        return number, NULL
    text = exact_text(number)
    return (float(number), NULL) if text is None else (0.0, c_text(text))


def spelling(number: Number) -> str:
    """A text that is the number exactly."""
    text = exact_text(number)
    if text is not None:
        return text
    value = float(number)
    return "/".join(map(str, value.as_integer_ratio())) if math.isfinite(value) else str(value)


def refuse_masked(given: Any) -> None:
    """An array in which numbers may be masked is refused: what lies below a mask would count."""
    masked = sys.modules.get("numpy.ma")
    if masked is not None and isinstance(given, masked.MaskedArray):
        raise BadInput("a masked array is not taken, since what is masked would count as a number:"
                       " leave such points out, and give the rest as .data")


def real_doubles(given: Any) -> numpy.ndarray[Any, Any]:
    """Numbers as an array of doubles that are exactly those; NaN stays."""
    import numpy

    refuse_masked(given)
    array = numpy.asarray(given)
    if array.dtype.kind not in "iuf":
        raise BadInput(f"an array of numbers must be of reals, not of {array.dtype}")
    doubles = numpy.ascontiguousarray(array, dtype=numpy.float64)
    if not numpy.array_equal(doubles.astype(array.dtype), array, equal_nan=array.dtype.kind == "f"):
        raise BadInput(f"an array of {array.dtype} has a number that no double is")
    return doubles


def c_doubles(points: numpy.ndarray[Any, Any]) -> Any:
    """An array of shape (n, 2) as doubles one after another; None for one whose numbers are no
    doubles."""
    import numpy

    refuse_masked(points)
    points = numpy.asarray(points)
    if points.ndim != 2 or points.shape[1] != 2:
        raise BadInput(f"points must be an array of shape (n, 2), not {points.shape}")
    fits = points.dtype.kind == "f" and points.dtype.itemsize <= 8
    if points.dtype.kind in "iu":
        fits = points.size == 0 or max(-int(points.min()), int(points.max())) <= WHOLE_IN_A_DOUBLE
    return numpy.ascontiguousarray(points, dtype=numpy.float64) if fits else None


def c_points(given: Points) -> tuple[tuple[Any, ...], Any]:
    """A tp_coordinates, and what must live as long as it is used."""
    points: Any = given
    if hasattr(points, "__array__"):
        doubles = c_doubles(points)
        if doubles is not None:
            return (len(doubles), ffi.from_buffer("double[]", doubles), NULL), doubles
        points = points.tolist()
    points = list(points)
    for point in points:
        refuse_masked(point)
    pairs = [tuple(pair) for pair in points]
    if any(len(pair) != 2 for pair in pairs):
        raise BadInput("a point must have two coordinates, x and y")
    flat = [number for pair in pairs for number in pair]
    if all(number.__class__ is float or exact_text(number) is None for number in flat):
        doubles = ffi.new("double[]", flat)
        return (len(pairs), doubles, NULL), doubles
    texts = [c_text(spelling(number)) for number in flat]
    pointers = ffi.new("const char *[]", texts)
    return (len(pairs), NULL, pointers), (pointers, texts)
