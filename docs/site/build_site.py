#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The documentation as a site: build_site.py FOLDER [BUILD] puts it into FOLDER, by MkDocs (Debian: apt install mkdocs). With BUILD, a
folder in which the program is built, the explorer stands in it as well, as topple.html, where its tools are there: one folder to publish.

Pages are those of docs/, whose README.md lists them, with README.md for the front and CONTRIBUTING.md. What they link to outside of docs/ (examples, a
table in the source) is copied along, and a folder gets a page that lists it. MkDocs ends with an error where a link leads
nowhere."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import site_markdown

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r"\]\(([^)\s#]+)(#[^)\s]*)?\)")
HIDDEN = '<a id="docs" href="explorer.html" hidden>'  # in the page of the explorer, which has no documentation beside it else
# before anything is loaded: what a server shows for sources/x/y.html is of the folder above
ROOT_SCRIPT = 'const base = document.createElement("base"); base.href = location.pathname.replace(/(?:sources\\/.*|[^/]*)$/, ""); document.head.prepend(base);'
PAGES = {"README.md": "index.md", "docs/README.md": "contents.md", "CONTRIBUTING.md": "contributing.md"}


def place_of(path):
    """Where a file of the project lies among the pages."""
    name = str(path.relative_to(ROOT))
    if name in PAGES:
        return PAGES[name]
    return name.removeprefix("docs/") if name.startswith("docs/") else "sources/" + name


class Site:
    def __init__(self, folder):
        self.folder, self.done = folder, set()

    def write(self, place, text):
        target = self.folder / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def link(self, page, place, name, anchor):
        """A link of a page that lies at a place: what it leads to is put among the pages, and the way there."""
        if re.match(r"[a-z]+:", name):
            return name + anchor
        path = (page.parent / name).resolve()
        if not path.exists():
            sys.exit(f"{page.relative_to(ROOT)}: a link leads to {name}, which is not there")
        return os.path.relpath(self.put(path), os.path.dirname(place) or ".") + anchor

    def put(self, path):
        """The place of a file, a page or a folder, once it is there."""
        place = place_of(path)
        if path.is_dir():
            place += "/index.md"
        if place in self.done:
            return place
        self.done.add(place)
        if path.is_dir():
            self.put_folder(path, place)
        elif path.suffix == ".md":
            text = LINK.sub(lambda match: f"]({self.link(path, place, match[1], match[2] or '')})",
                            path.read_text(encoding="utf-8"))
            self.write(place, site_markdown.spaced(text))
        else:
            (self.folder / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, self.folder / place)
        return place

    def put_folder(self, path, place):
        lines = [f"# {path.relative_to(ROOT)}\n"]
        for entry in sorted(path.iterdir()):
            if entry.name.startswith((".", "__")):
                continue
            way = os.path.relpath(self.put(entry), os.path.dirname(place))
            lines.append(f"- [{entry.name}{'/' if entry.is_dir() else ''}]({way})")
        self.write(place, "\n".join([lines[0], *lines[1:]]) + "\n")


def explorer(build):
    """The page of the explorer, built of the program in a folder; None where what that needs is missing, which is told."""
    missing = [tool for tool in ("emcc", "npm", "libdeflate-gzip", "dpkg-source", "patch") if shutil.which(tool) is None]
    if missing:
        print(f"The site is without the explorer, which needs {', '.join(missing)}: ./run --site installs them", file=sys.stderr)
        return None
    for step in ("build_core", "bundle"):
        done = subprocess.run([ROOT / "src" / "applications" / "explorer" / step], env={**os.environ, "TOPPLE_BUILD": str(build)}, check=False)
        if done.returncode != 0:
            sys.exit(done.returncode)
    return ROOT / "build-explorer" / "explorer.html"


def add_explorer(pages, page):
    """The page itself, with its link to its documentation shown, and a link to it below the heading of that and of the front."""
    text = page.read_text(encoding="utf-8")
    if text.count(HIDDEN) != 1:
        sys.exit(f"{page} has no link to its documentation that could be shown")
    (pages / "topple.html").write_text(text.replace(HIDDEN, HIDDEN.replace(" hidden", "")), encoding="utf-8")
    for name, words in (("explorer.md", "Open the explorer"), ("index.md", "Try it in the browser")):
        text = (pages / name).read_text(encoding="utf-8")
        heading, rest = text.split("\n", 1)
        (pages / name).write_text(f"{heading}\n\n**[{words}](topple.html)**\n{rest}", encoding="utf-8")


def loosen(page):
    """The page of what is not found, which MkDocs ties to the server's root: it is shown for any address, and finds what it loads from
    the folder of that, or the one that has `sources`, so that the site may lie in any folder of a server."""
    text = re.sub(r'((?:href|src)=")/', r"\1", page.read_text(encoding="utf-8")).replace('base_url = "/"', 'base_url = "."')
    if text.count("<head>") != 1:
        sys.exit(f"{page} has not one head")
    page.write_text(text.replace("<head>", f"<head>\n<script>{ROOT_SCRIPT}</script>"), encoding="utf-8")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: build_site.py FOLDER [BUILD]")
    if shutil.which("mkdocs") is None:
        sys.exit("the site is built by MkDocs, which is not installed: apt-get install mkdocs, or ./run --site, which installs all that the site needs")
    target = pathlib.Path(sys.argv[1]).resolve()
    program = explorer(pathlib.Path(sys.argv[2]).resolve()) if len(sys.argv) == 3 else None
    with tempfile.TemporaryDirectory() as name:
        stage = pathlib.Path(name)
        site = Site(stage / "pages")
        for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]:
            site.put(page)
        if program is not None:
            add_explorer(stage / "pages", program)
        for file in ("mkdocs.yml", "site_markdown.py"):
            shutil.copy(ROOT / "docs" / "site" / file, stage)
        environment = {**os.environ, "PYTHONPATH": str(stage), "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--clean", "--site-dir", target], cwd=stage,
                              env=environment, check=False)
    if done.returncode == 0:
        loosen(target / "404.html")
        print(f"{target / 'index.html'}" + ("" if program is None else f", with the explorer as {target / 'topple.html'}"))
    sys.exit(done.returncode)


if __name__ == "__main__":
    main()
