# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The documentation hangs together: links lead somewhere, every page can be reached from README.md, files that pages
name exist, and every section of docs/mechanics.md that the code cites is there."""

import collections
import re
import unittest

from harness import ROOT, main

LINK = re.compile(r"\]\(([^)\s]+)\)")
NAMED = re.compile(r"`((?:include|src|python|tests|docs|examples)/[\w./*-]+|[\w/*]+\.(?:c|h|cpp|hpp|py|md))`")
CITED = re.compile(r"mechanics(?:\.md)?,?\s+(?:[*#]\s+)?section\s+(?:[*#]\s+)?(\d+a?)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]


def text_of(path):
    return path.read_text(encoding="utf-8")


def anchors(path):
    """What a link to a heading of the page may be called, as GitHub does it."""
    plain = (re.sub(r"[^\w\s-]", "", heading.lower()) for heading in HEADING.findall(text_of(path)))
    return {heading.strip().replace(" ", "-") for heading in plain}


def targets(path):
    """(file, anchor) of the links of a page that stay within the project."""
    for link in LINK.findall(text_of(path)):
        if not re.match(r"[a-z]+:", link):
            name, _, anchor = link.partition("#")
            yield ((path.parent / name).resolve() if name else path), anchor


class Docs(unittest.TestCase):
    def test_links_lead_somewhere(self):
        count = 0
        for page in PAGES:
            for target, anchor in targets(page):
                count += 1
                self.assertTrue(target.exists(), f"{page.name}: {target}")
                if anchor:
                    self.assertIn(anchor, anchors(target), f"{page.name}: {target.name}#{anchor}")
        self.assertGreater(count, 50)

    def test_every_page_is_reached(self):
        reached, waiting = set(), collections.deque([ROOT / "README.md"])
        while waiting:
            page = waiting.popleft()
            if page in reached or page.suffix != ".md":
                continue
            reached.add(page)
            waiting.extend(target for target, _ in targets(page))
        self.assertEqual({page.name for page in PAGES if page.resolve() not in reached and page not in reached}, set())

    def test_certain_is_not_claimed_of_all(self):
        """Texts that introduce the program claim a proven bound of solved numbers alone: simulations, samples and the method of Goodman and
        Bray have none. README once said "Every number carries a proven error bound". What certain means is said once, where these lead."""
        claim = re.compile(r"\b(?:every|each|all)\s+(?:(?!solved)\w+\s+)?numbers?\b(?!\s+that\s+is\s+solved)[^.]{0,80}\b(?:proven|certain)\b", re.IGNORECASE)
        introductions = ["README.md", "pyproject.toml", "docs/packaging/debian/control", "python/topple/__init__.py", "src/applications/cli/solve_words.c"]
        self.assertTrue(claim.search("Every number carries a proven error bound"))
        self.assertTrue(claim.search("profile, each number with a proven error bound"))
        for name in introductions:
            text = re.sub(r'"\s*\n\s*"', "", text_of(ROOT / name))  # a text in C goes on in the next line
            if name.endswith(".c"):
                text = text[text.index("tp_solve_parser"):]  # options of it are of solved numbers
            self.assertEqual([found.group() for found in claim.finditer(text)], [], name)
        for name in ("README.md", "docs/glossary.md", "docs/solve.md"):
            self.assertIn("mechanics.md#certain", text_of(ROOT / name))
        self.assertEqual(len(re.findall(r"^#+ Certain$", "\n".join(map(text_of, PAGES)), re.MULTILINE)), 1)

    def test_blocks_are_not_said_to_strain(self):
        """They are rigid: no page, sheet or phrase puts them in plane strain."""
        for path in [*PAGES, ROOT / "src/core/terms/phrases.csv", ROOT / "src/presentation/report/sheet_system.c"]:
            for sentence in re.findall(r"[^.]*plane\s+strain[^.]*", text_of(path)):
                self.assertIn("neither", sentence, path.name)

    def test_files_that_pages_name_exist(self):
        """By their way from the root, or by its end where that is enough; names in capitals stand for others."""
        files = [path.relative_to(ROOT) for folder in ("include", "src", "python", "tests", "docs", "examples")
                 for path in (ROOT / folder).rglob("*")]
        count = 0
        for page in PAGES:
            for name in NAMED.findall(text_of(page)):
                if re.search(r"[A-Z]{3}", name):
                    continue
                count += 1
                self.assertTrue(any(path.match(name) for path in files), f"{page.name}: {name}")
        self.assertGreater(count, 150)

    def test_sections_that_the_code_cites_exist(self):
        sections = set(re.findall(r"^## (\d+a?)\. ", text_of(ROOT / "docs/mechanics.md"), re.MULTILINE))
        cited = set()
        for folder in ("include", "src", "tests", "examples"):
            for path in (ROOT / folder).rglob("*"):
                if path.suffix in (".c", ".h", ".cpp", ".hpp", ".py", ".yaml", ".csv"):
                    for section in CITED.findall(text_of(path)):
                        cited.add(section)
                        self.assertIn(section, sections, path)
        self.assertLessEqual({"2", "3", "4", "5", "6", "9"}, cited)


if __name__ == "__main__":
    main()
