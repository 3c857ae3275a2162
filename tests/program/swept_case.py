# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Scenes of tests/data/swept with one number changed to what no scene has: zero, numbers next to nothing or beyond all, a right
angle but for its last digit, another number of the scene but for 1e-9. tests/library/test_swept.c changes them likewise."""

import random
import re

from harness import ROOT, rounds

FOLDER = ROOT / "tests" / "data" / "swept"
NUMBER = re.compile(r"(?<![\w.+-])[-+]?\d+(?:\.\d+)?(?![\w.])")
EXTREMES = ["0", *(f"{sign}1e-{digits}" for digits in (12, 30, 100, 200, 300) for sign in ("", "-")),
            "89.9999999999999", "90.0000000000001", "90", "1e300", "-1e300", "1e30"]


def spots(text):
    """Where numbers stand that may vary: not the version, a seed or a count."""
    return [found for found in NUMBER.finditer(text)
            if not re.search(r"(topple|seed|count|azimuths|facet): ?$|#.*$|DA1-$", text[:found.start()].rpartition("\n")[2])]


def variants(text, random_state):
    """Every number changed to each of these, in a random order."""
    found = spots(text)
    cases = [(spot, value) for spot in found for value in EXTREMES]
    for spot in found:
        other = random_state.choice(found).group()
        cases += [(spot, f"{spot.group()}+1e-9"), (spot, f"{other}+1e-9"), (spot, f"{other}-1e-9")]
    random_state.shuffle(cases)
    for spot, value in cases:
        yield text[:spot.start()] + value + text[spot.end():]


def swept(brief, long):
    """Names and texts of changed scenes: so many of each file, or all of them in the long run where `long` is None."""
    random_state = random.Random(59)
    for path in sorted(FOLDER.glob("*.yaml")):
        most = rounds(brief, long)
        for k, text in enumerate(variants(path.read_text(encoding="utf-8"), random_state)):
            if most is not None and k >= most:
                break
            yield path, text
