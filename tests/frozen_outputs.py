#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Prove that a change of the sources changes no output: record what a build prints, and compare two records.

    tests/frozen_outputs.py record FOLDER [--program build/topple] [--only TEXT]
    tests/frozen_outputs.py compare FOLDER_BEFORE FOLDER_AFTER [--show COUNT]

A record covers every scene, study, claim and mesh in examples/, tests/hard and tests/bad, and the help of each
command: text, JSON, CSV, sheets in three languages, figures, standard error and exit status. It is one file of hashes,
and the texts themselves, each once, so that `compare` can show a difference. Choose a folder outside the tree. Times
are left out, as they differ from run to run.
"""

import argparse
import concurrent.futures
import difflib
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LANGUAGES = ("en", "es", "de")
COMMANDS = ("solve", "sweep", "derive", "verify", "accuracy", "chart", "profile", "tilt", "trace", "solid", "study",
            "new", "examples", "explain")
MESHES = (".obj", ".stl", ".ply", ".off")
DRAWINGS = (".dxf", ".wkt", ".geojson", ".svg")
SECONDS = 300
# All of what it prints are times.
TIMED = ("accuracy",)
LEVELS = ("exact|exakt|exacta|double|doppelte Genauigkeit|doble precisión|compensated|kompensiert|compensada|ball"
          "|Kugelarithmetik|aritmética de bolas")
# A time, and what follows it, each in its own place of an output.
TIMES = [re.compile(pattern.encode()) for pattern in (
    r'("seconds": )[0-9.e+-]+()', r"(; [a-z]+, )[0-9.e+-]+( ms)", r"( runs?, )[0-9.e+-]+( s\.)",
    rf'(<td>(?:{LEVELS})</td><td class="number">)[0-9.,e+-]+(</td></tr>)', rf"(\| (?:{LEVELS}) \| )[0-9.,e+-]+( \|)")]


def scenes() -> list[Path]:
    folders = [ROOT / "examples", ROOT / "tests" / "hard", ROOT / "tests" / "bad"]
    return sorted(path for folder in folders for path in folder.rglob("*")
                  if path.suffix in (".yaml", *MESHES, *DRAWINGS) and "engines" not in path.parts)


def solve_runs(scene: str, unit: list[str]) -> list[list[str]]:
    """All outputs of one scene; OUT stands for a file whose content is recorded too."""
    begin = ["solve", scene, *unit]
    runs = [begin, [*begin, "--json"], [*begin, "--csv"], [*begin, "--table"], [*begin, "--elements", "--digits=20"]]
    runs += [[*begin, "-q", f"--report=OUT.{kind}", f"--language={language}"]
             for language in LANGUAGES for kind in ("html", "md")]
    runs += [[*begin, "-q", f"--figure=OUT.{kind}"] for kind in ("svg", "dxf")]
    return runs


def study_runs(study: str) -> list[list[str]]:
    begin = ["study", study]
    return [begin, [*begin, "--json"], [*begin, "-q", "--rows=OUT.csv"],
            *([*begin, "-q", "--report=OUT.html", f"--language={language}"] for language in LANGUAGES)]


def runs_of(path: Path) -> list[list[str]]:
    name = str(path.relative_to(ROOT))
    if path.suffix in MESHES:
        begin = ["solid", name, "--unit=m", "--friction=30"]
        return [begin, [*begin, "--json"], [*begin, "--csv"], [*begin, "-q", "--figure=OUT.svg"]]
    if path.suffix in DRAWINGS:
        return solve_runs(name, ["--unit=m"])
    text = path.read_text(encoding="utf-8", errors="replace")
    if "topple_study:" in text:
        return study_runs(name)
    if "topple_claims:" in text:
        return [["verify", name], ["verify", name, "--json"]]
    runs = solve_runs(name, [])
    runs += [["derive", name], ["derive", name, "--json"], ["tilt", name], ["tilt", name, "--json"]]
    return runs


def all_runs() -> list[list[str]]:
    runs = [["--help"], ["--version"], ["examples"]]
    runs += [[command, "--help"] for command in COMMANDS]
    return runs + [run for path in scenes() for run in runs_of(path)]


def without_times(text: bytes) -> bytes:
    for pattern in TIMES:
        text = pattern.sub(rb"\1TIME\2", text)
    return text


class Record:
    """Hashes by run and stream, and each text once."""

    def __init__(self, folder: Path, program: Path):
        self.folder, self.program, self.hashes = folder, program, {}
        (folder / "texts").mkdir(parents=True, exist_ok=True)

    def _keep(self, text: bytes) -> str:
        name = hashlib.sha256(text).hexdigest()[:32]
        path = self.folder / "texts" / name
        if not path.exists():
            path.write_bytes(text)
        return name

    def _run(self, run: list[str]) -> dict[str, str]:
        """Each run has its folder of outputs, of which no path is printed."""
        with tempfile.TemporaryDirectory() as folder:
            outputs = Path(folder)
            command = [str(self.program), *(word.replace("OUT.", folder + "/out.") for word in run)]
            environment = dict(os.environ, LC_ALL="C.UTF-8", SOURCE_DATE_EPOCH="0", COLUMNS="80", NO_COLOR="1")
            try:
                done = subprocess.run(command, cwd=ROOT, capture_output=True, timeout=SECONDS, check=False,
                                      env=environment, stdin=subprocess.DEVNULL)
            except subprocess.TimeoutExpired:
                return {"status": "timed out"}
            streams = {"output": done.stdout, "errors": done.stderr}
            streams.update({path.name: path.read_bytes() for path in sorted(outputs.iterdir())})
            kept = {name: self._keep(without_times(text.replace(folder.encode(), b"FOLDER").replace(str(ROOT).encode(), b"ROOT")))
                    for name, text in streams.items()}
            return {"status": str(done.returncode), **kept}

    def make(self, runs: list[list[str]], jobs: int) -> None:
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            for count, (run, kept) in enumerate(zip(runs, pool.map(self._run, runs)), 1):
                self.hashes[" ".join(run)] = kept
                if count % 200 == 0:
                    print(f"{count} of {len(runs)} runs", file=sys.stderr)
        (self.folder / "hashes.json").write_text(json.dumps(self.hashes, indent=0, sort_keys=True), encoding="utf-8")


def differences(before: dict, after: dict) -> list[tuple[str, str, str | None, str | None]]:
    """By run and stream, with the names of both texts."""
    found = []
    for run in sorted(before.keys() | after.keys()):
        one, other = before.get(run, {}), after.get(run, {})
        found += [(run, stream, one.get(stream), other.get(stream))
                  for stream in sorted(one.keys() | other.keys()) if one.get(stream) != other.get(stream)]
    return found


def lines_of(folder: Path, name: str | None) -> list[str]:
    path = folder / "texts" / (name or "none")
    return path.read_text(encoding="utf-8", errors="replace").splitlines() if path.is_file() else [name or "(nothing)"]


def compare(before: Path, after: Path, shown: int) -> int:
    records = [json.loads((folder / "hashes.json").read_text(encoding="utf-8")) for folder in (before, after)]
    found = differences(*records)
    for run, stream, one, other in found[:shown]:
        print(f"=== topple {run}: {stream}")
        print("\n".join(list(difflib.unified_diff(lines_of(before, one), lines_of(after, other), lineterm="", n=0))[2:22]))
    for run, stream, _, _ in found[shown:]:
        print(f"=== topple {run}: {stream}")
    print(f"{len(records[0])} runs before, {len(records[1])} after: {len(found)} outputs differ")
    return 1 if found else 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = parser.add_subparsers(dest="part", required=True)
    record = parts.add_parser("record")
    record.add_argument("folder", type=Path)
    record.add_argument("--program", type=Path, default=ROOT / "build" / "topple")
    record.add_argument("--only", default="", help="runs with this text in their command line")
    record.add_argument("--jobs", type=int, default=os.cpu_count())
    pair = parts.add_parser("compare")
    pair.add_argument("before", type=Path)
    pair.add_argument("after", type=Path)
    pair.add_argument("--show", type=int, default=20, help="how many differences are shown with their lines")
    given = parser.parse_args()
    if given.part == "compare":
        return compare(given.before, given.after, given.show)
    runs = [run for run in all_runs() if given.only in " ".join(run) and run[0] not in TIMED or run[-1:] == ["--help"]]
    shutil.rmtree(given.folder, ignore_errors=True)
    Record(given.folder, given.program.resolve()).make(runs, given.jobs)
    print(f"{len(runs)} runs recorded in {given.folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
