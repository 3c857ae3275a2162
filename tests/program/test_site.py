# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The documentation as a site: every page is in its table of contents once, and, where MkDocs is installed, the site that it
builds is whole: each link leads to a file that is there and to a heading in it, and nothing is fetched from elsewhere."""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

from harness import ROOT, main

SITE = ROOT / "docs" / "site"


class Page(html.parser.HTMLParser):
    """Where a page leads to, what it loads, and the names in it that can be led to."""

    def __init__(self, path):
        super().__init__()
        self.links, self.loads, self.names = [], [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        own = dict(attributes)
        self.names |= {own[key] for key in ("id", "name") if own.get(key)}
        if tag == "a" and own.get("href"):
            self.links.append(own["href"])
        for key in ("src", "data", "poster") + (("href",) if tag == "link" else ()):
            if own.get(key) and tag != "meta" and own.get("rel") not in ("canonical",):
                self.loads.append(own[key])


class Contents(unittest.TestCase):
    def test_every_page_once(self):
        text = (SITE / "mkdocs.yml").read_text(encoding="utf-8")
        listed = re.findall(r": ([\w/]+\.md)$", text, re.MULTILINE)
        pages = {path.name for path in (ROOT / "docs").glob("*.md")} - {"README.md"}
        pages |= {"index.md", "contents.md", "contributing.md"}
        self.assertEqual(sorted(listed), sorted(pages))

    def test_the_same_order_in_the_folder(self):
        """docs/README.md, which a forge shows, has the groups and the pages of the site, in its order and by its names."""
        ways = {"contributing.md": "../CONTRIBUTING.md"}
        text = (SITE / "mkdocs.yml").read_text(encoding="utf-8")
        text = text[text.index("contents.md\n"):]
        of_site = re.findall(r"^ +- (\w[^:\n]*):$|^ +- \"?(.+?)\"?: ([\w/]+\.md)$", text, re.MULTILINE)
        of_folder = re.findall(r"^## (.*)$|^- \[(.*)\]\((.*)\)$", (ROOT / "docs/README.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertEqual([(group, name, ways.get(way, way)) for group, name, way in of_site], of_folder)
        self.assertGreater(len(of_folder), 45)

    def test_explorer_in_the_site(self):
        """The page with its link back shown, and a link to it below both headings."""
        sys.path.insert(0, str(SITE))
        sys.dont_write_bytecode = True
        import build_site
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for page in ("explorer.md", "index.md"):
                (folder / page).write_text("# Heading\n\nText\n", encoding="utf-8")
            (folder / "made").write_text(f"<!doctype html>{build_site.HIDDEN}Documentation</a>", encoding="utf-8")
            build_site.add_explorer(folder, folder / "made")
            self.assertEqual((folder / "topple.html").read_text(encoding="utf-8"), '<!doctype html><a id="docs" href="explorer.html">Documentation</a>')
            own = (ROOT / "src/applications/explorer/page/index.html").read_text(encoding="utf-8")
            self.assertEqual(own.count(build_site.HIDDEN), 1)
            self.assertEqual((folder / "explorer.md").read_text(encoding="utf-8"), "# Heading\n\n**[Open the explorer](topple.html)**\n\nText\n")

    def test_markdown(self):
        """Lists below a paragraph, not in code, and names of headings as the links of the pages have them."""
        sys.path.insert(0, str(SITE))
        sys.dont_write_bytecode = True
        import site_markdown
        self.assertEqual(site_markdown.spaced("a\n- b\n- c\n\n```\nx\n- y\n```\n"), "a\n\n- b\n- c\n\n```\nx\n- y\n```\n")
        self.assertEqual(site_markdown.spaced("- b\n  more\n- c\n"), "- b\n  more\n- c\n")
        self.assertEqual(site_markdown.slug("`block: {rounded: …}`", "-"), "block-rounded")


@unittest.skipIf(shutil.which("mkdocs") is None, "MkDocs is not installed")
class Built(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        own = tempfile.TemporaryDirectory()
        cls.addClassCleanup(own.cleanup)
        cls.folder = pathlib.Path(own.name) / "site"
        done = subprocess.run([sys.executable, SITE / "build_site.py", cls.folder], capture_output=True, encoding="utf-8",
                              check=False)
        if done.returncode != 0:
            raise AssertionError(done.stderr + done.stdout)
        cls.pages = {path: Page(path) for path in cls.folder.rglob("*.html")}

    def target(self, path, link):
        """(file, anchor) of a link that stays within the site."""
        way, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:|//", way):
            return None
        return (path.parent / urllib.parse.unquote(way.partition("?")[0])).resolve() if way else path.resolve(), urllib.parse.unquote(anchor)

    def test_links(self):
        count = anchors = 0
        for path, page in self.pages.items():
            for link in page.links:
                found = self.target(path, link)
                if found is None:
                    continue
                file, anchor = found
                count += 1
                file = file / "index.html" if file.is_dir() else file
                self.assertTrue(file.exists(), f"{path.name}: {link}")
                if anchor and file in {own.resolve() for own in self.pages}:
                    anchors += 1
                    own = next(own for own in self.pages if own.resolve() == file)
                    self.assertIn(anchor, self.pages[own].names, f"{path.name}: {link}")
        self.assertGreater(len(self.pages), 40)
        self.assertGreater(count, 2000)
        self.assertGreater(anchors, 200)

    def test_nothing_from_elsewhere(self):
        count = 0
        for path, page in self.pages.items():
            for link in page.loads:
                found = self.target(path, link)
                self.assertIsNotNone(found, f"{path.name} loads {link}")
                self.assertTrue(found[0].exists(), f"{path.name}: {link}")
                count += 1
        self.assertGreater(count, 200)

    def test_what_is_not_found_lies_in_any_folder(self):
        """The page that a server shows for any address leads to the server's root nowhere: links and what it loads, which the tests above look
        at, are from the folder of the address."""
        text = (self.folder / "404.html").read_text(encoding="utf-8")
        self.assertNotRegex(text, r'(?:href|src)="/|base_url = "/')
        self.assertLess(text.index('createElement("base")'), text.index("<link"))

    def test_pages_are_whole(self):
        """A table, a figure and the front page came through; a scene of the examples lies beside them."""
        text = (self.folder / "glossary.html").read_text(encoding="utf-8")
        self.assertIn("<td><strong>factor of safety</strong> FoS</td>", text)
        self.assertIn("Does a rock block stand", (self.folder / "index.html").read_text(encoding="utf-8"))
        self.assertTrue((self.folder / "figures" / "block_e_valley.svg").exists())
        self.assertTrue((self.folder / "sources" / "examples" / "block_e_valley.yaml").exists())


if __name__ == "__main__":
    main()
