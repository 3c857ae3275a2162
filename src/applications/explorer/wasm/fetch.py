# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Sources of Debian's packages, by apt with lists of its own: nothing of the system changes, no root is needed."""

import csv
import hashlib
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"


def table(name: str) -> list[dict[str, str]]:
    """The rows of a CSV file beside this one, without its comments."""
    lines = (HERE / name).read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def apt_options(work: Path, suite: str) -> list[str]:
    """Options of apt that keep it in a folder of its own, with the sources of one suite alone."""
    own = work / "apt" / suite
    for folder in ("lists/partial", "cache/archives/partial"):
        (own / folder).mkdir(parents=True, exist_ok=True)
    listed = own / "debian.sources"
    listed.write_text(
        f"Types: deb-src\nURIs: http://deb.debian.org/debian\nSuites: {suite}\nComponents: main\nSigned-By: {KEYRING}\n"
    )
    return [
        "-q=2",
        "-o", f"Dir::Etc::SourceList={listed}",
        "-o", "Dir::Etc::SourceParts=-",
        "-o", f"Dir::State::Lists={own}/lists",
        "-o", f"Dir::Cache={own}/cache",
        "-o", "APT::Sandbox::User=",
    ]


def run(command: list[str], where: Path) -> None:
    """Run quietly; where it fails, all it said and what was run."""
    done = subprocess.run(command, cwd=where, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{done.stdout}{done.stderr}failed: {' '.join(command)}")


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def folder_of(work: Path, package: str, version: str) -> Path:
    """Where the sources of a package lie when they are unpacked."""
    return work / "sources" / f"{package}-{version.replace(':', '_')}"


def unpack(row: dict[str, str], downloaded: Path, into: Path) -> None:
    tarballs = [path for path in downloaded.glob("*.orig.tar.*") if sha256(path) == row["sha256"]]
    if len(tarballs) != 1:
        raise SystemExit(f"{row['package']}: no tarball in {downloaded} has the SHA-256 of sources.csv")
    part = into.with_name(into.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    if row["fetched"] == "whole":
        description = next(downloaded.glob("*.dsc"))
        run(["dpkg-source", "--no-check", "-x", str(description), str(part)], downloaded)
    else:
        part.mkdir()
        run(["tar", "-xf", str(tarballs[0]), "-C", str(part), "--strip-components=1"], downloaded)
    patch = HERE / "patches" / f"{row['package']}.patch"
    if patch.is_file():
        run(["patch", "-p1", "--input", str(patch)], part)
    part.rename(into)


def fetch_all(work: Path) -> None:
    """Have the sources of every package of sources.csv in work/sources."""
    (work / "sources").mkdir(parents=True, exist_ok=True)
    known = set()
    for row in table("sources.csv"):
        into = folder_of(work, row["package"], row["version"])
        if into.exists():
            continue
        options = apt_options(work, row["suite"])
        if row["suite"] not in known:
            run(["apt-get", *options, "update"], work)
            known.add(row["suite"])
        downloaded = into.with_name(into.name + ".files")
        downloaded.mkdir(exist_ok=True)
        parts = ["--download-only"] if row["fetched"] == "whole" else ["--download-only", "--tar-only"]
        # A later revision of Debian's has the same tarball, but other patches.
        name = row["package"] + (f"={row['version']}" if row["fetched"] == "whole" else "")
        run(["apt-get", *options, "source", *parts, "--only-source", name], downloaded)
        unpack(row, downloaded, into)
        shutil.rmtree(downloaded)
