# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Results as frozen dataclasses whose fields are read off the library's structs when first asked
for.

A result of C has hundreds of numbers, of which a program asks for a few: a record keeps its struct,
and the owner of its memory, and turns a field into Python when it is first read. Field by field it
is told by type hints and metadata:

    Bounded, enumerations, records, str, bool, int, float   the field of that name
    X | None             None where `when` is false, a field or a function of the struct, or the pointer is NULL
    tuple[X, ...]        as many as the field `count` says, or as the array of C has; of a list (`items`), which is a struct
                         of items and count, those, and None where its field of that name is false; of a set (`bits`), the
                         words whose bits are set
    dict[Word, X]        an array of C with one for each word, those that are there: `where` is true of them, or a pointer
                         is not NULL"""

from __future__ import annotations

import dataclasses
import functools
import math
import operator
import typing
from typing import Any, Callable

from ._library import ffi
from .word import Word


@dataclasses.dataclass(frozen=True)
class Bounded:
    """A number with a proven bound: the truth lies within `error` of `value`. `digits` is the truth
    in decimals, all of them certain, where more digits were asked for than a double holds."""

    value: float
    error: float
    digits: str | None = None

    def __float__(self) -> float:
        return self.value

    @property
    def low(self) -> float:
        """A double that is not above the truth."""
        return math.nextafter(self.value - self.error, -math.inf)

    @property
    def high(self) -> float:
        """A double that is not below the truth."""
        return math.nextafter(self.value + self.error, math.inf)

    def __str__(self) -> str:
        return f"{self.digits or self.value!r} ± {self.error:.1g}"

    def __format__(self, spec: str) -> str:
        return format(self.value, spec) if spec else str(self)


def bounded(c: Any) -> Bounded:
    """The tp_bounded as Python has it."""
    number = object.__new__(Bounded)
    number.__dict__.update(value=c.value, error=c.error, digits=text(c.digits))
    return number


def text(c: Any) -> str | None:
    """A text of C; None for NULL."""
    return ffi.string(c).decode("utf-8", "replace") if c else None


class Record:
    """A frozen dataclass that may stand on a struct of C."""

    def __getattr__(self, name: str) -> Any:
        own = self.__dict__
        kind: Any = type(self)  # a type can be hashed, whatever mypy thinks of the hash of its instances
        readers = readers_of(kind)
        if "_c" not in own or name not in readers:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}",
                                 name=name, obj=self)
        value = own[name] = readers[name](own["_c"], own["_owner"])
        return value

    def __reduce__(self) -> Any:
        return type(self), tuple(getattr(self, field.name) for field in dataclasses.fields(self))


R = typing.TypeVar("R", bound=Record)


def record(kind: type[R], c: Any, owner: Any) -> R:
    """A record that stands on a struct, whose memory the owner keeps."""
    made = object.__new__(kind)
    made.__dict__.update(_c=c, _owner=owner)
    return made


def struct_of(own: Any) -> Any:
    """The struct that a record stands on."""
    try:
        return ffi.addressof(own.__dict__["_c"])
    except KeyError:
        raise ValueError("this is a copy without the library's own result: ask the one that it was"
                         " made of") from None


@functools.lru_cache(maxsize=None)
def readers_of(kind: Any) -> dict[str, Callable[[Any, Any], Any]]:
    """For each field of a record, the function that reads it of a struct and its owner."""
    hints = typing.get_type_hints(kind)
    return {own.name: reader(own, hints[own.name]) for own in dataclasses.fields(kind)}


def reader(own: dataclasses.Field[Any], hint: Any) -> Callable[[Any, Any], Any]:
    """The function that reads one field."""
    told, name = own.metadata, own.name
    if type(None) in typing.get_args(hint):
        (hint,) = [part for part in typing.get_args(hint) if part is not type(None)]
    read = told.get("read") or value_reader(name, told, hint)
    when = told.get("when")
    if when is None:
        return read
    there = operator.attrgetter(when) if isinstance(when, str) else when
    return lambda c, owner: read(c, owner) if there(c) else None


def value_reader(name: str, told: Any, hint: Any) -> Callable[[Any, Any], Any]:
    """Reads a field that is there."""
    parts = typing.get_args(hint)
    if typing.get_origin(hint) is dict:
        return dict_reader(name, told, *parts)
    if told.get("bits"):
        return lambda c, owner: tuple(word for k, word in enumerate(parts[0]) if getattr(c, name) >> k & 1)
    if "items" in told:
        return items_reader(name, told["items"], item_reader(parts[0]))
    if typing.get_origin(hint) is tuple:
        read = list_reader(told.get("count"), item_reader(parts[0]))
        return lambda c, owner: read(getattr(c, name), c, owner)
    convert = item_reader(hint)
    return lambda c, owner: convert(getattr(c, name), owner)


def list_reader(count: str | None, convert: Any) -> Any:
    """Reads an array of so many items, or of a fixed number."""
    return lambda items, c, owner: tuple([convert(items[k], owner)
                                          for k in range(getattr(c, count) if count else len(items))])


def items_reader(name: str, there: Any, convert: Any) -> Any:
    """Reads a struct of items and count."""

    def read(c: Any, owner: Any) -> Any:
        own = getattr(c, name)
        if there is not True and not getattr(own, there):
            return None
        return tuple([convert(own.items[k], owner) for k in range(own.count)])

    return read


def _always(item: Any) -> bool:
    return True


def dict_reader(name: str, told: Any, word: type[Word], kind: Any) -> Any:
    """Reads an array with one item, or one pointer to some, for each word."""
    lists = typing.get_origin(kind) is tuple
    there = told.get("where")
    where: Any = operator.attrgetter(there) if isinstance(there, str) else there or (bool if lists else _always)
    convert = item_reader(typing.get_args(kind)[0] if lists else kind)
    if lists:
        read = list_reader(told.get("count"), convert)
    else:
        def read(item: Any, c: Any, owner: Any) -> Any:
            return convert(item, owner)

    keys: Any = tuple(word)
    return lambda c, owner: {key: read(item, c, owner) for key, item in zip(keys, getattr(c, name)) if where(item)}


def item_reader(kind: Any) -> Any:
    """Turns a value of C into one of Python."""
    if kind is Bounded:
        return lambda value, owner: bounded(value)
    if kind is str:
        return lambda value, owner: text(value)
    if isinstance(kind, type) and issubclass(kind, Word):
        words: tuple[Any, ...] = tuple(kind)
        return lambda value, owner: words[value]
    if isinstance(kind, type) and issubclass(kind, Record):
        return lambda value, owner: record(kind, value, owner) if value else None
    return lambda value, owner: value
