# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What the page is made of, with the licence and the notice of each: Topple itself, the packages of npm that are not
for building alone, the libraries of the core, and the common licences that their notices name."""

import csv
import json
import pathlib

EXPLORER = pathlib.Path(__file__).resolve().parents[1]
TOP = EXPLORER.parents[1]
DOCS = pathlib.Path("/usr/share/doc")
COMMON = pathlib.Path("/usr/share/common-licenses")


def of_npm():
    lock = json.loads((EXPLORER / "package-lock.json").read_text(encoding="utf-8"))
    for place, about in sorted(lock["packages"].items()):
        if not place or about.get("dev") or about.get("optional"):
            continue
        notice = next(iter(sorted((EXPLORER / place).glob("LICEN[CS]E*"))))
        yield {"name": place.removeprefix("node_modules/"), "version": about["version"], "licence": about["license"],
               "text": notice.read_text(encoding="utf-8")}


def of_core():
    lines = (pathlib.Path(__file__).parent / "licences.csv").read_text(encoding="utf-8").splitlines()
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        notice = DOCS / row["package"] / "copyright"
        if not notice.is_file():
            raise FileNotFoundError(f"{notice}: install Debian's package {row['package']}, whose notice goes into the page")
        yield {"name": row["name"], "version": "", "licence": row["licence"],
               "text": notice.read_text(encoding="utf-8", errors="replace")}


def licences():
    own = {"name": "Topple", "version": "", "licence": "GPL-3.0-or-later", "text": (TOP / "LICENSE").read_text(encoding="utf-8")}
    common = [{"name": name, "version": "", "licence": "the text of a licence named above",
               "text": (COMMON / name).read_text(encoding="utf-8")} for name in ("Apache-2.0", "GPL-2", "LGPL-2.1", "LGPL-3")]
    return [own, *of_npm(), *of_core(), *common]
