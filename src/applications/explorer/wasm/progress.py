# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Ninja with a word now and then about how far it is: one step of it may take minutes, as GMP's own build does."""

import re
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable
from pathlib import Path

EVERY = 20.0  # seconds between two words

STEP = re.compile(r"\[(\d+)/(\d+)\]")


def words(what: str, step: int, steps: int | None, seconds: float) -> str:
    """One line about how far it is."""
    far = "begun" if steps is None else f"step {step} of {steps}"
    return f"{what}: {far}, {seconds:.0f} s"


def followed(what: str, lines: Iterable[str], tell: Callable[[str], None], every: float = EVERY) -> str:
    """All that a build prints; meanwhile `tell` gets a line each `every` seconds, whether or not a step has ended."""
    began, printed, far, ended = time.monotonic(), [], (0, None), threading.Event()

    def remind() -> None:
        while not ended.wait(every):
            tell(words(what, *far, time.monotonic() - began))

    reminder = threading.Thread(target=remind, daemon=True)
    reminder.start()
    for line in lines:
        printed.append(line)
        if found := STEP.match(line):
            far = (int(found[1]), int(found[2]))
    ended.set()
    reminder.join()
    return "".join(printed)


def ninja(what: str, folder: Path) -> bool:
    """Build all of a folder; what it printed is shown where it failed. @return whether it was built"""
    command = ["ninja", "-C", str(folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as build:
        printed = followed(what, build.stdout, lambda line: print(line, file=sys.stderr, flush=True))
    if build.returncode != 0:
        print(printed[-6000:], file=sys.stderr)
    return build.returncode == 0
