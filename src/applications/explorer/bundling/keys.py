# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The keys of scenes, of the program's own table, src/core/terms/keys.csv: [[path, unit]]; what each means the core explains.
An item of a list that may have another map's keys has these as well, as make_keys.py tells."""

import pathlib
import sys

from .phrases import table

TERMS = pathlib.Path(__file__).resolve().parents[4] / "src" / "core" / "terms"


def included():
    """{list: the map whose keys its items have besides their own}"""
    sys.path.insert(0, str(TERMS))
    from make_keys import INCLUDES

    return INCLUDES


def keys():
    own = [[row["path"], row["unit"]] for row in table(TERMS / "keys.csv") if row["file"] == "scene"]
    more = [[f"{item}[].{path.removeprefix(of + '.')}", unit] for item, of in included().items()
            for path, unit in own if path.startswith(of + ".")]
    return own + more
