# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The tutorial and the questions: every file that they show is written, every command run, and what they say that the
program prints it does print, line by line in that order; what begins at a photograph within 2 % of its numbers, as the
arithmetic of OpenCV depends on the machine. On the other pages: the output below a scene is that of `topple solve`, the
output below a command its own, and every command over a file of examples/ still runs."""

import os
import pathlib
import re
import shlex
import shutil
import tempfile
import unittest

from harness import PROGRAM, ROOT, is_readable, main, reads, run

BUILD = pathlib.Path(os.environ.get("TOPPLE_BUILD", pathlib.Path(PROGRAM).parent))
BLOCK = re.compile(r"(?:(Add to )?`([\w.]+)`:\n\n)?```(\w+)\n(.*?)```\n", re.DOTALL)
SCENE = re.compile(r"```yaml\n(topple: 1\n.*?)```\n\n((?:    [^\n]*\n|\n)+)", re.DOTALL)
SHOWN = re.compile(r"^    \$ topple (.*)\n((?:    .*\n)+)", re.MULTILINE)
COMMAND = re.compile(r"^ {4}(?:\./run|topple) ((?!tilt .*--overturning|chart map .*--y|trace).*?)(?: {3,}.*)?$", re.MULTILINE)
WRITES = re.compile(r" --(output|figure|scatter|rows|report|animation|reactions|phase|language)[ =]\S+")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def alike(shown, printed, share):
    """The same words, and numbers that differ by a share of themselves at most."""
    if share == 0:
        return shown == printed
    if NUMBER.split(shown) != NUMBER.split(printed):
        return False
    return all(abs(float(a) - float(b)) <= share * abs(float(a)) or "e-" in a
               for a, b in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


class Pages(unittest.TestCase):
    def setUp(self):
        self.printed = {}  # by the last command of that text

    def follow(self, text, folder, share=0):
        """Each block in turn; the commands' status and how many lines were compared."""
        commands = lines = 0
        for match in BLOCK.finditer(text):
            language, body = match.group(3), match.group(4)
            if language == "console":
                done = self.run_commands(body, folder, share)
                commands, lines = commands + done[0], lines + done[1]
                continue
            self.assertIsNotNone(match.group(2), f"a file without a name: {body}")
            with open(folder / match.group(2), "a" if match.group(1) else "w", encoding="utf-8") as file:
                file.write(body)
        return commands, lines

    def run_commands(self, body, folder, share):
        count = compared = 0
        for part in re.split(r"^\$ ", body, flags=re.MULTILINE)[1:]:
            command, _, shown = part.partition("\n")
            words = shlex.split(command)
            self.assertEqual(words[0], "topple", command)
            status, out, err = run(*words[1:], folder=folder)
            self.assertIn(status, (0, 1, 3, 4), err)
            self.assertNotEqual(status, 2, err)
            self.printed[command] = out
            printed = (out + err).splitlines()
            at = 0
            for line in shown.splitlines():
                if line == "…":
                    self.assertTrue(printed, command)
                    continue
                compared += 1
                found = next((k for k in range(at, len(printed)) if alike(line, printed[k], share)), None)
                self.assertIsNotNone(found, f"{command}: {line!r} is not in\n" + "\n".join(printed[at:]))
                at = found + 1
            if err and "topple: " in err:
                self.assertIn("topple: ", shown, f"{command} says what the page does not: {err}")
            count += 1
        return count, compared

    def parts_of_tutorial(self):
        """From a photograph, and from a survey."""
        text = (ROOT / "docs/tutorial.md").read_text(encoding="utf-8")
        parts = dict(part.split("\n", 1) for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:])
        self.assertEqual(list(parts), ["From a photograph", "From a survey"])
        return parts["From a photograph"], parts["From a survey"]

    @unittest.skipUnless((BUILD / "libtopple-trace.so").exists(), "topple trace was not built")
    def test_tutorial_from_a_photograph(self):
        """Its words beside the commands, too: 0.77 g, and of the ranks that of the earthquake is the largest, that of the
        outline the least."""
        with tempfile.TemporaryDirectory() as name:
            folder, text = pathlib.Path(name), self.parts_of_tutorial()[0]
            shutil.copy(ROOT / "examples/pictures/painted_boulder.png", folder)
            commands, lines = self.follow(text, folder, 0.02)
            for page in ("boulder.html", "study.html"):
                self.assertIn("Signatures", (folder / page).read_text(encoding="utf-8"))
            self.assertTrue((folder / "boulder.pdf").read_bytes().startswith(b"%PDF"))
            self.assertTrue((folder / "traced.png").read_bytes().startswith(b"\x89PNG"))
            table = self.printed["topple study study.yaml"].split("Rank correlation")[1].splitlines()
            limit = {row.split()[0]: abs(float(row.split()[3])) for row in table[1:4]}
            self.assertEqual(sorted(limit, key=limit.get),
                             ["outline_offset", "friction_angle_deg", "loads.seismic.horizontal"])
            self.assertIn("from 0.77 g on", text)
        self.assertGreaterEqual(commands, 8)
        self.assertGreater(lines, 9)

    def test_tutorial_from_a_survey(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            commands, lines = self.follow(self.parts_of_tutorial()[1], folder)
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

    def in_order(self, shown, printed, what):
        """Each line shown is printed, in that order, but for an ellipsis."""
        at = 0
        for line in filter(str.strip, shown.splitlines()):
            if line.strip() != "…":
                self.assertIn(line[4:], printed[at:], what)
                at = printed.index(line[4:], at) + 1

    def test_output_below_scenes_and_commands(self):
        count = 0
        for page in sorted((ROOT / "docs").glob("*.md")):
            text = page.read_text(encoding="utf-8")
            with tempfile.TemporaryDirectory() as name:
                scene = pathlib.Path(name) / "scene.yaml"
                for match in SCENE.finditer(text) if page.stem != "faq" else ():
                    scene.write_text(match.group(1), encoding="utf-8")
                    self.in_order(match.group(2), run("solve", scene)[1].splitlines(), page.name)
                    count += 1
                scene.unlink(missing_ok=True)
                for match in SHOWN.finditer(text):
                    words = shlex.split(match.group(1))
                    for word in filter(lambda word: (ROOT / "examples" / word).is_file(), words):
                        shutil.copy(ROOT / "examples" / word, name)
                    if ".dxf" not in match.group(1) or reads("dxf"):
                        _, out, err = run(*words, folder=name)
                        self.in_order(match.group(2), (out + err).splitlines(), page.name)
                    count += 1
        self.assertGreaterEqual(count, 6)

    def test_commands_over_examples(self):
        """Without the files that they would write; maps over two numbers, which take seconds, are in test_map.py."""
        commands = {WRITES.sub("", command).split("|")[0] for page in (ROOT / "docs").glob("*.md")
                    for command in COMMAND.findall(page.read_text(encoding="utf-8")) if "examples/" in command}
        self.assertGreater(len(commands), 30)
        for command in sorted(commands):
            words = [path for word in shlex.split(command)
                     for path in (sorted(filter(is_readable, ROOT.glob(word))) if "*" in word and "=" not in word else [word])]
            if "…" not in words:
                with self.subTest(command):
                    status, _, err = run(*words)
                    self.assertIn(status, (0, 1) if words[0] == "verify" or "--batch" in words else (0,), err)

    def test_a_page_that_is_wrong_fails(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for text in ("```console\n$ topple --version\ntopple 9.9\n```\n", "```console\n$ topple solve none.yaml\n```\n"):
                with self.assertRaises(AssertionError):
                    self.follow(text, folder)


if __name__ == "__main__":
    main()
