# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the library's enumerations are in Python; words.py, made of src/core/terms/words.csv, has them."""

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
