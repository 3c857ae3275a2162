# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The tutorial and the questions: every file that they show is written, every command run, and what they say that the
program prints it does print, line by line in that order."""

import pathlib
import re
import shlex
import tempfile
import unittest

from harness import ROOT, main, run

BLOCK = re.compile(r"(?:`([\w.]+)`:\n\n)?```(\w+)\n(.*?)```\n", re.DOTALL)


class Pages(unittest.TestCase):
    def follow(self, text, folder):
        """Each block in turn; the commands' status and how many lines were compared."""
        commands = lines = 0
        for match in BLOCK.finditer(text):
            language, body = match.group(2), match.group(3)
            if language == "console":
                done = self.run_commands(body, folder)
                commands, lines = commands + done[0], lines + done[1]
                continue
            self.assertIsNotNone(match.group(1), f"a file without a name: {body}")
            (folder / match.group(1)).write_text(body, encoding="utf-8")
        return commands, lines

    def run_commands(self, body, folder):
        count = compared = 0
        for part in re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]:
            command, _, shown = part.partition("\n")
            words = shlex.split(command)
            self.assertEqual(words[0], "topple", command)
            status, out, err = run(*words[1:], folder=folder)
            self.assertIn(status, (0, 1, 3, 4), err)
            self.assertNotEqual(status, 2, err)
            printed = (out + err).splitlines()
            at = 0
            for line in shown.splitlines():
                if line == "…":
                    self.assertTrue(printed, command)
                    continue
                compared += 1
                self.assertIn(line, printed[at:], f"{command}: {line!r} is not in\n" + "\n".join(printed[at:]))
                at += printed[at:].index(line) + 1
            if err and "topple: " in err:
                self.assertIn("topple: ", shown, f"{command} says what the page does not: {err}")
            count += 1
        return count, compared

    def test_tutorial(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            commands, lines = self.follow((ROOT / "docs/tutorial.md").read_text(encoding="utf-8"), folder)
            self.assertIn("Signatures", (folder / "block.html").read_text(encoding="utf-8"))
            self.assertTrue((folder / "block.pdf").read_bytes().startswith(b"%PDF"))
            self.assertIn("</svg>", (folder / "block.svg").read_text(encoding="utf-8"))
        self.assertGreaterEqual(commands, 9)
        self.assertGreater(lines, 6)

    def test_questions(self):
        """Each in a folder of its own: a mistake, what the program says of it, and an exit status that is no success where
        it is a complaint."""
        text = (ROOT / "docs/faq.md").read_text(encoding="utf-8")
        sections = re.split(r"^## ", text, flags=re.MULTILINE)[1:]
        self.assertGreater(len(sections), 12)
        said = 0
        for section in sections:
            with tempfile.TemporaryDirectory() as name, self.subTest(section.splitlines()[0]):
                _, lines = self.follow(section, pathlib.Path(name))
                self.assertTrue(lines > 0 or "```" not in section)
                said += lines
        self.assertGreater(said, 18)

    def test_a_page_that_is_wrong_fails(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for text in ("```console\n$ topple --version\ntopple 9.9\n```\n", "```console\n$ topple solve none.yaml\n```\n"):
                with self.assertRaises(AssertionError):
                    self.follow(text, folder)


if __name__ == "__main__":
    main()
