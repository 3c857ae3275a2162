# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the library's enumerations are in Python; words.py, made of src/core/terms/words.csv, has them."""

from __future__ import annotations

import enum
import functools
from typing import TypeVar, Union


@functools.total_ordering
class Word(enum.Enum):
    """An enumeration of C, whose words have the order that they have there."""

    def __str__(self) -> str:
        return self.value

    def __lt__(self, other: object) -> bool:
        if not isinstance(other, Word) or type(other) is not type(self):
            return NotImplemented
        words: list[Word] = list(type(self))
        return words.index(self) < words.index(other)

    @classmethod
    def _missing_(cls, value: object) -> None:
        raise ValueError(f"{value!r} is none of " + ", ".join(repr(member.value) for member in cls))


W = TypeVar("W", bound=Word)


def number_of(kind: type[W], word: Union[W, str]) -> int:
    """The C value of a member, or of the word that it stands for."""
    words: list[W] = list(kind)
    return words.index(kind(word))
