# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What bash proposes where a command line is begun, by its `complete`; the same in zsh where there is one. Whatever the
help lists is proposed, and the values that the scripts name are those of the help."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main, run

FOLDER = ROOT / "docs" / "packaging" / "completion"
COMMANDS = ("solve", "sweep", "derive", "verify", "accuracy", "chart", "profile", "tilt", "solid", "study", "trace", "new",
            "examples", "explain")
# The function that `complete -F` names, called as bash calls it.
ASK = r"""
source "$1"; shift
[[ $(complete -p topple) =~ -F\ ([^ ]+) ]] || exit 1
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
"${BASH_REMATCH[1]}" "$1" "${!#}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}"
"""
# The function of zsh with its options on, and what it hands to the functions that then complete, line by line.
ASK_ZSH = r"""
setopt bareglobqual extendedglob nullglob rcexpandparam
_arguments() { print -rl -- "$@" }
_describe() { print -rl -- "${(@P)@[-1]}" }
_files() { print -r -- "_files $*" }
script=$1; shift
words=("$@") CURRENT=$#
source $script
"""


class Bash(unittest.TestCase):
    def ask(self, *words, folder=ROOT):
        """The proposals for the last of the words."""
        done = subprocess.run(["bash", "-c", ASK, "bash", FOLDER / "topple.bash", PROGRAM, *words], cwd=folder,
                              check=True, capture_output=True, encoding="utf-8")
        self.assertEqual(done.stderr, "")
        return [line for line in done.stdout.splitlines() if line]

    def test_syntax(self):
        subprocess.run(["bash", "-n", FOLDER / "topple.bash"], check=True)

    def test_commands(self):
        self.assertEqual(sorted(self.ask("so")), ["solid", "solve"])
        self.assertEqual(self.ask("--v"), ["--version"])
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file in ("block one.yaml", "table.csv", "b.yml"):
                (folder / file).touch()
            (folder / "scenes").mkdir()
            self.assertEqual(sorted(self.ask("", folder=folder)),
                             sorted([*COMMANDS, "block one.yaml", "b.yml", "scenes"]))
            self.assertEqual(self.ask("solve", "--json", "bl", folder=folder), ["block one.yaml"])
            self.assertEqual(self.ask("solve", "-d", "9", "sc", folder=folder), ["scenes"])

    def test_every_option_of_the_help(self):
        for command in COMMANDS:
            listed = re.findall(r"^ +(?:-., )?(--[a-z-]+)", run(command, "--help")[1], re.M)
            self.assertGreater(len(listed), 2)
            self.assertEqual([word.rstrip("=") for word in self.ask(command, "--")], listed)
        self.assertEqual(self.ask("solve", "--le"), ["--level=", "--least-force"])
        self.assertEqual(self.ask("accuracy", "--sw"), ["--sweep"])
        self.assertEqual(self.ask("block.yaml", "--js"), ["--json"])

    def test_values(self):
        """bash gives --name=value as three words. Each value that is proposed stands in the help."""
        levels = ["double", "compensated", "ball", "exact"]
        self.assertEqual(self.ask("solve", "--level", "="), levels)
        self.assertEqual(self.ask("solve", "--level", "=", "b"), ["ball"])
        self.assertEqual(self.ask("solve", "--level", ""), levels)
        self.assertEqual(self.ask("derive", "--for-all", "="), ["count"])
        results = self.ask("solve", "--for", "=")
        self.assertEqual(len(results), 7)
        help_text = run("solve", "--help")[1]
        for word in results + levels + self.ask("solve", "--pivots", "="):
            self.assertRegex(help_text, rf"\b{word.rstrip('=')}\b")
        with tempfile.TemporaryDirectory() as name:
            for file in ("a.svg", "a.csv", "a.yaml"):
                (pathlib.Path(name) / file).touch()
            self.assertEqual(self.ask("solve", "--figure", "=", "a", folder=name), ["a.svg"])
            self.assertEqual(self.ask("chart", "fos", "-o", "", folder=name), ["a.svg", "a.csv"])
            self.assertEqual(self.ask("profile", "a", folder=name), ["a.yaml", "a.csv"])
        help_text = run("profile", "--help")[1]
        for option in ("--resample", "--detrend", "--window", "--unit"):
            words = self.ask("profile", option, "=")
            self.assertGreater(len(words), 1)
            for word in words:
                self.assertRegex(help_text, rf"\b{word}\b")

    def test_charts(self):
        self.assertEqual(self.ask("chart", ""), ["fos", "mechanisms", "ranges", "map"])
        self.assertEqual(self.ask("chart", "map", "examples/block_e_v"), ["examples/block_e_valley.yaml"])

    def test_examples(self):
        self.assertEqual(self.ask("examples", "block_a"), ["block_a_peak", "block_a_valley", "block_a_worn"])

    def test_without_a_program(self):
        """Nothing is proposed but files, and nothing is said."""
        done = subprocess.run(["bash", "-c", ASK, "bash", FOLDER / "topple.bash", "/nowhere/topple", "so"], cwd=ROOT,
                              check=True, capture_output=True, encoding="utf-8")
        self.assertEqual((done.stdout.strip(), done.stderr), ("", ""))


@unittest.skipIf(shutil.which("zsh") is None, "zsh is not installed")
class Zsh(unittest.TestCase):
    def ask(self, *words):
        done = subprocess.run(["zsh", "-f", "-c", ASK_ZSH, "zsh", FOLDER / "_topple", PROGRAM, *words], cwd=ROOT,
                              check=True, capture_output=True, encoding="utf-8")
        self.assertEqual(done.stderr, "")
        return done.stdout.splitlines()

    def test_syntax(self):
        subprocess.run(["zsh", "-n", FOLDER / "_topple"], check=True)

    def test_commands(self):
        lines = self.ask("so")
        self.assertEqual([line.partition(":")[0] for line in lines], [*COMMANDS, "_files -g *.(yaml|yml)(-.)"])
        self.assertIn("verify:Verdicts on printed formulas and numbers, each proven", lines)

    def test_every_option_of_the_help(self):
        for command in COMMANDS:
            listed = re.findall(r"^ +(?:-., )?(--[a-z-]+)", run(command, "--help")[1], re.M)
            options = [line for line in self.ask(command, "") if line.startswith("--")]
            self.assertEqual([re.match("[a-z-]+", option).group() for option in options], listed)
        lines = self.ask("solve", "")
        self.assertIn("-j[Print the solution as JSON]", lines)
        self.assertIn("-d+[Make every number certain to N digits, 1 to 1000]:N:", lines)
        (level,) = [line for line in lines if line.startswith("--level")]
        self.assertTrue(level.endswith("]:LEVEL:(double compensated ball exact)"), level)

    def test_operands(self):
        self.assertEqual(self.ask("chart", "")[-1], "*:chart:(fos mechanisms ranges map)")
        for words in (("chart", "map", ""), ("solve", ""), ("block.yaml", "")):
            self.assertEqual(self.ask(*words)[-1], "*:file:_files -g '*.(yaml|yml)(-.)'")
        self.assertEqual(self.ask("profile", "")[-1], "*:file:_files -g '*.(yaml|yml|csv)(-.)'")


if __name__ == "__main__":
    main()
