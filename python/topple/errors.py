# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a call of the library says when it does not do what was asked: a class of exception for each
status."""

from __future__ import annotations

import errno
import os

from typing import Any

from ._library import ffi, lib
from .words import Fault


class ToppleError(Exception):
    """The library did not do what was asked. `str()` says what, where and what to do; `file`, `line` and `column`
    (counted from 1) say where, None where it is not known."""

    def __init__(self, text: str = "", file: str | None = None, line: int | None = None, column: int | None = None) -> None:
        super().__init__(text)
        self.text, self.file, self.line, self.column = text, file, line, column

    def __str__(self) -> str:
        return self.text

    def __reduce__(self) -> Any:
        return type(self), (self.text, self.file, self.line, self.column)


class BadInput(ToppleError, ValueError):
    """The input is wrong; `fault` says which kind of input."""

    def __init__(self, text: Any="", file: Any=None, line: Any=None, column: Any=None, fault: Fault = Fault.NONE) -> None:
        super().__init__(text, file, line, column)
        self.fault = fault

    def __reduce__(self) -> Any:
        return type(self), (self.text, self.file, self.line, self.column, self.fault)


class NoAnswer(ToppleError):
    """No answer exists."""


class Undecided(ToppleError):
    """The precision allowed is not sufficient."""


class OutOfMemory(ToppleError, MemoryError):
    """A request for memory failed."""


class SystemFailed(ToppleError, OSError):
    """A file cannot be read or written. `errno`, `strerror` and `filename` are what the system said, where it
    was the system that refused, else None."""

    def __init__(self, text: Any="", file: Any=None, line: Any=None, column: Any=None, system_error: int | None = None) -> None:
        super().__init__(text, file, line, column)
        if system_error is not None:
            self.errno, self.strerror, self.filename = system_error, os.strerror(system_error), file

    def __reduce__(self) -> Any:
        return type(self), (self.text, self.file, self.line, self.column, self.errno)


class FileNotFound(SystemFailed, FileNotFoundError):
    """A file that is named is not there."""


class PermissionDenied(SystemFailed, PermissionError):
    """The system does not let a file be read or written."""


class DependencyFailed(ToppleError, RuntimeError):
    """A library that Topple uses, or gnuplot, failed."""


class Caution(UserWarning):
    """A warning of what may be wrong with the input, or is not covered by an answer."""


ERRORS = {
    lib.TP_BAD_INPUT: BadInput,
    lib.TP_NO_ANSWER: NoAnswer,
    lib.TP_UNDECIDED: Undecided,
    lib.TP_OUT_OF_MEMORY: OutOfMemory,
    lib.TP_SYSTEM_FAILED: SystemFailed,
    lib.TP_DEPENDENCY_FAILED: DependencyFailed,
}
REFUSALS = {errno.ENOENT: FileNotFound, errno.EACCES: PermissionDenied, errno.EPERM: PermissionDenied}
MESSAGE = ffi.typeof("tp_message *")


def failure(status: int, message: Any=None) -> ToppleError:
    """The exception that a status other than TP_OK is, with the message of the call or the meaning
    of the status."""
    kind = ERRORS[status]
    if not message:
        return kind(_text(lib.tp_status_meaning(status)))
    place = [_text(message.file) or None, message.line or None, message.column or None]
    if kind is SystemFailed and message.system_error:
        return REFUSALS.get(message.system_error, kind)(_text(message.text), *place, message.system_error)
    if kind is BadInput:
        place.append(list(Fault)[message.fault])
    return kind(_text(message.text), *place)


def _text(of: Any) -> str:
    return ffi.string(of).decode("utf-8", "replace")


def checked(call: Any, *arguments: Any) -> None:
    """Call with a message after the arguments; raise what it says unless the status is TP_OK."""
    message = ffi.new(MESSAGE)
    status = call(*arguments, message)
    if status:
        raise failure(status, message)
