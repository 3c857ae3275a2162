# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The page as one file: its modules and style sheets bundled by esbuild, and put into index.html. The same sources
give the same bytes: nothing in them tells when or where they were made.

Modules that no file is: topple:examples, topple:keys, topple:libraries, topple:licence_texts, and those that the caller gives, as the core's bytes."""

import base64
import functools
import hashlib
import json
import pathlib
import shutil
import subprocess

from .examples import examples
from .keys import keys
from .phrases import phrases

EXPLORER = pathlib.Path(__file__).resolve().parents[1]
MODULES = EXPLORER / "node_modules"
STAMP = MODULES / ".installed"
COMMON_LICENCES = pathlib.Path("/usr/share/common-licenses")  # of Debian's package base-files
LICENCES = json.loads((EXPLORER / "licences" / "licences.json").read_text(encoding="utf-8"))
STYLE = '<link rel="stylesheet" href="style.css">'
PHRASES = '<script type="application/json" id="phrases"></script>'
SCRIPT = '<script type="module" src="main.js"></script>'
CARRY = '<script src="carry.js"></script>'
CORE = "<core></core>"
PIECE = 256 * 1024  # letters of a piece of the core, of which four are three bytes


def install():
    """The pinned packages, where they are not there yet."""
    lock = hashlib.sha256((EXPLORER / "package-lock.json").read_bytes()).hexdigest()
    if STAMP.is_file() and STAMP.read_text() == lock:
        return
    npm = shutil.which("npm")
    if npm is None:
        raise FileNotFoundError("there is no npm: install Debian's package npm")
    subprocess.run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"], cwd=EXPLORER, check=True,
                   stdout=subprocess.DEVNULL)
    STAMP.write_text(lock)


def esbuild(entry, *options):
    """What the bundler makes of a file, as text."""
    program = MODULES / ".bin" / "esbuild"
    done = subprocess.run([program, entry, "--bundle", "--minify", "--charset=utf8", "--legal-comments=none", "--target=es2022,chrome109,firefox115",
                           "--log-level=warning", *options], cwd=EXPLORER, check=True, stdout=subprocess.PIPE, encoding="utf-8")
    return done.stdout


def licence_texts():
    """Of the GNU licences and the one that part of Emscripten has, and the notices of all libraries: who gets the page gets them with it."""
    texts = {"GNU General Public License, version 3": (EXPLORER.parents[2] / "LICENSE").read_text(encoding="utf-8")}
    for name, title in (("LGPL-3", "GNU Lesser General Public License, version 3"),
                        ("LGPL-2.1", "GNU Lesser General Public License, version 2.1"),
                        ("GPL-2", "GNU General Public License, version 2"), ("Apache-2.0", "Apache License, version 2.0")):
        texts[title] = (COMMON_LICENCES / name).read_text(encoding="utf-8")
    return {"licences": texts, "notices": LICENCES["notices"]}


def packed(content):
    """What the page unpacks by core/packed.js: gzip, by libdeflate, which makes it 4 % smaller than zlib can."""
    done = subprocess.run(["libdeflate-gzip", "-12", "-c"], input=content, check=True, stdout=subprocess.PIPE)
    return base64.b64encode(done.stdout).decode()


def in_pieces(core):
    """The parts of the core as elements at the page's end; those of the first part are each taken up as soon as they have been
    read (page/carry.js)."""
    scripts = []
    for name, content in core.items():
        letters = packed(content)
        for at in range(0, len(letters), PIECE):
            scripts.append(f'<script type="text/plain" data-part="{name}">{letters[at:at + PIECE]}</script>')
            if name == "first":
                scripts.append(f'<script>toppleCarry({"true" if at + PIECE >= len(letters) else "false"})</script>')
    return "\n".join(["<div hidden>", *scripts, "</div>"])


def bundled(folder, modules, core):
    """The page's text. `folder`: where files that it is made from may be written; `modules`: names of modules that no
    file is, and what each is, as JSON; `core`: the bytes of each part of the program, the first
    one first."""
    folder.mkdir(parents=True, exist_ok=True)
    options = []
    for name, value in {"topple:examples": packed(json.dumps(examples(), ensure_ascii=False).encode()), "topple:keys": keys(), "topple:libraries": LICENCES["libraries"],
                        "topple:licence_texts": packed(json.dumps(licence_texts(), ensure_ascii=False).encode()), **modules}.items():
        path = folder / (name.replace(":", "_") + ".json")
        path.write_text(json.dumps(value, ensure_ascii=False), encoding="utf-8")
        options.append(f"--alias:{name}={path}")
    script = esbuild("page/main.js", "--format=esm", *options)
    carry = esbuild("page/carry.js", "--format=iife")
    style = esbuild("page/style.css")
    page = (EXPLORER / "page" / "index.html").read_text(encoding="utf-8")
    for place in (STYLE, PHRASES, CARRY, SCRIPT, CORE):
        if page.count(place) != 1:
            raise ValueError(f"page/index.html has not {place} once")
    # none may end its element before its end
    script, carry = (text.replace("</script", "<\\/script").replace("<!--", "<\\!--") for text in (script, carry))
    style = style.replace("</style", "<\\/style")
    words = PHRASES.replace("></", ">" + json.dumps(phrases(), ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c") + "</")
    # async: the page begins before its core has been read
    parts = {STYLE: f"<style>{style}</style>", PHRASES: words, CARRY: f"<script>{carry}</script>",
             SCRIPT: f'<script type="module" async>{script}</script>', CORE: in_pieces(core)}
    return functools.reduce(lambda text, part: text.replace(*part), parts.items(), page)
