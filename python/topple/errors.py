# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What a call of the library says when it does not do what was asked: a class of exception for each
status."""

from __future__ import annotations

import errno
import os

from ._library import ffi, lib


class ToppleError(Exception):
    """The library did not do what was asked. `str()` says what, where and what to do."""


class BadInput(ToppleError, ValueError):
    """The input is wrong."""


class NoAnswer(ToppleError):
    """No answer exists."""


class Undecided(ToppleError):
    """The precision allowed is not sufficient."""


class OutOfMemory(ToppleError, MemoryError):
    """A request for memory failed."""


class SystemFailed(ToppleError, OSError):
    """A file cannot be read or written. `errno`, `strerror` and `filename` are what the system said, where it
    was the system that refused, else None."""

    def __init__(self, text: str = ""):
        super().__init__(text)
        self.text = text
        filename, refused, rest = text.partition(": cannot be ")
        reason = rest.partition(": ")[2].partition(";")[0]
        code = REASONS.get(reason)
        if refused and code is not None:
            self.errno, self.strerror, self.filename = code, reason, filename

    def __str__(self) -> str:
        return self.text


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
#: By what the system says of it, which messages end in.
REASONS = {os.strerror(code): code for code in sorted(errno.errorcode, reverse=True)}
REFUSALS = {errno.ENOENT: FileNotFound, errno.EACCES: PermissionDenied, errno.EPERM: PermissionDenied}
MESSAGE = ffi.typeof("tp_message *")


def failure(status: int, message=None) -> ToppleError:
    """The exception that a status other than TP_OK is, with the message of the call or the meaning
    of the status."""
    text = ffi.string(message.text if message else lib.tp_status_meaning(status)).decode("utf-8", "replace")
    kind = ERRORS[status]
    if kind is SystemFailed:
        kind = REFUSALS.get(SystemFailed(text).errno, kind)
    return kind(text)


def checked(call, *arguments) -> None:
    """Call with a message after the arguments; raise what it says unless the status is TP_OK."""
    message = ffi.new(MESSAGE)
    status = call(*arguments, message)
    if status:
        raise failure(status, message)
