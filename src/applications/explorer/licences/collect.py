# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What is inlined into the explorer, with its licences, as JSON for the page: [{"name", "licence", "for", "notice"}];
equal notices stand once, by their number in "notices". Reads linked.csv, package-lock.json and node_modules.
Usage: collect.py licences.json, anew whenever one of these changes."""

import csv
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parent
FOR = {"yaml": "the scene's text as a tree", "uplot": "curves", "uqr": "codes that a camera reads", "d3": "dragging and zooming", "editor": "the editor of the scene"}


def purpose(name):
    return FOR.get(name, FOR["d3"] if name.startswith("d3-") else FOR["editor"])


def packages():
    """Of npm, all that the page may be made of."""
    lock = json.loads((TOP / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    for place, package in sorted(lock.items()):
        if not place or package.get("dev") or package.get("optional"):
            continue
        name = place.removeprefix("node_modules/")
        files = sorted((TOP / place).glob("LICEN[SC]E*"))
        notice = files[0].read_text(encoding="utf-8").strip() if files else ""
        yield {"name": f"{name} {package['version']}", "licence": package["license"], "for": purpose(name), "notice": notice}


def linked():
    lines = (HERE / "linked.csv").read_text(encoding="utf-8").splitlines()
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        notice = (HERE / row["notice"]).read_text(encoding="utf-8").strip() if row["notice"] else ""
        yield {**row, "notice": notice}


def main():
    found = [*linked(), *packages()]
    notices = list(dict.fromkeys(each["notice"] for each in found if each["notice"]))
    for each in found:
        each["notice"] = notices.index(each["notice"]) if each["notice"] else None
    text = json.dumps({"libraries": found, "notices": notices}, ensure_ascii=False, indent=1)
    pathlib.Path(sys.argv[1]).write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
