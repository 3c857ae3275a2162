# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The scenes of examples/ and the files that they name, as JSON for the page: [{"name", "title", "text", "files"}],
sorted by name."""

import pathlib
import re

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
NAMED = re.compile(r"[A-Za-z0-9_./-]+\.(?:csv|dxf|svg|wkt|geojson|ply|obj|stl|at2)\b")


def example(path):
    text = path.read_text(encoding="utf-8")
    title = re.search(r"^title: *(.*)$", text, re.M)
    named = (path.parent / name for name in sorted(set(NAMED.findall(text))))
    files = {str(file.relative_to(path.parent)): file.read_text(encoding="utf-8") for file in named if file.is_file()}
    return {"name": path.name, "title": title.group(1).strip("\"'") if title else path.stem, "text": text, "files": files}


def examples():
    return [example(path) for path in sorted(EXAMPLES.glob("*.yaml"))]
