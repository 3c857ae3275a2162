# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The scenes of examples/, examples/blocks/ and examples/solids/, and the files that they name, as JSON for the page:
[{"name", "group", "title", "text", "files"}], sorted by group and name."""

import pathlib
import re

EXAMPLES = pathlib.Path(__file__).resolve().parents[4] / "examples"
NAMED = re.compile(r"[A-Za-z0-9_./-]+\.(?:csv|dxf|svg|wkt|geojson|ply|obj|stl|at2)\b")


GROUPS = {"Examples": ".", "Many blocks": "blocks", "Solids": "solids"}
SCENE = re.compile(r"^topple: *1", re.M)


def example(path, group):
    text = path.read_text(encoding="utf-8")
    title = re.search(r"^title: *(.*)$", text, re.M)
    named = (path.parent / name for name in sorted(set(NAMED.findall(text))))
    files = {str(file.relative_to(path.parent)): file.read_text(encoding="utf-8") for file in named if file.is_file()}
    return {"name": path.name, "group": group, "title": title.group(1).strip("\"'") if title else path.stem, "text": text, "files": files}


def examples():
    paths = ((path, group) for group, folder in GROUPS.items() for path in sorted((EXAMPLES / folder).glob("*.yaml")))
    return [example(path, group) for path, group in paths if SCENE.search(path.read_text(encoding="utf-8"))]
