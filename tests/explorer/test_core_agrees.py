# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""The core in WebAssembly says what the native program says: every example, hard case and bad scene, by node.

Reports and messages are the same bytes, but for times. So is JSON, but for proven bounds: FLINT's words have 32 bits there
and 64 here, by which a bound is rounded up at another place, and musl's functions may end in another last digit. Where a
number differs, each lies within the bounds of both, and the greatest differences are printed. `outlines` has plain doubles,
for drawing alone, which may differ by 1e-14 of the largest length or share there."""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "program"))

from harness import main, run  # noqa: E402

CORE = ROOT / "build-explorer" / "core_loader.wasm"
NODE = shutil.which("node")
TIMES = re.compile(r'"seconds": [^,}]*|[0-9.e+-]+ m?s\b')
BOUND_SHARE = 1e-6  # of a bound, by which another rounding may move it
DRAWN_SHARE = 1e-14  # of what is drawn: some dozens of roundings


class Core:
    def __init__(self):
        runner = pathlib.Path(__file__).with_name("core_runs.mjs")
        self.process = subprocess.Popen([NODE, runner], stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8")

    def run(self, folder, *args, collect=()):
        self.process.stdin.write(json.dumps({"folder": str(folder), "args": args, "collect": collect}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.wait(timeout=30)
        self.process.stdout.close()


class Differences:
    """Between two values of JSON: those that bounds cover, by size, and those that nothing does."""

    def __init__(self, drawn=1.0):
        """`drawn`: the largest number of the outlines."""
        self.bounds, self.numbers, self.wrong, self.drawn = [], [], [], drawn

    def look(self, one, other, where=""):
        if isinstance(one, dict) and isinstance(other, dict) and list(one) == list(other):
            if set(one) == {"value", "error"} and None not in (*one.values(), *other.values()):
                self.bounded(one, other, where)
            else:
                for key in one:
                    if key != "seconds":
                        self.look(one[key], other[key], f"{where}.{key}")
        elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
            for k, (own, its) in enumerate(zip(one, other)):
                self.look(own, its, f"{where}[{k}]")
        elif isinstance(one, (float, int)) and isinstance(other, (float, int)) and where.startswith(".outlines."):
            if abs(one - other) > DRAWN_SHARE * self.drawn:
                self.wrong.append(f"{where}: {one!r} and {other!r}")
        elif one != other:
            self.wrong.append(f"{where}: {one!r} and {other!r}")

    def bounded(self, one, other, where):
        if one == other:
            return
        apart, most = abs(one["value"] - other["value"]), one["error"] + other["error"]
        greater = max(one["error"], other["error"])
        if apart > 0:
            self.numbers.append((apart / most if most > 0 else float("inf"), where))
        if apart > most or (apart == 0 and abs(one["error"] - other["error"]) > BOUND_SHARE * greater):
            self.wrong.append(f"{where}: {one} and {other}")
        elif apart == 0:
            self.bounds.append((abs(one["error"] - other["error"]) / greater, where))


@unittest.skipIf(NODE is None, "there is no node: install Debian's package nodejs")
@unittest.skipUnless(CORE.is_file(), f"there is no {CORE}: ./run --explorer builds it")
class Agrees(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.core = Core()
        cls.addClassCleanup(cls.core.close)

    def same(self, folder, *args):
        """Same status, message and report, times aside; None, or the differences of the JSON."""
        status, out, err = run(*args, folder=folder)
        answer = self.core.run(folder, *args)
        said = f"{folder.relative_to(ROOT)}: topple {' '.join(args)}"
        self.assertEqual(answer["status"], status, f"{said}: {answer['err']}")
        self.assertEqual(TIMES.sub("", answer["err"]), TIMES.sub("", err), said)
        if "--json" not in args or out == "":
            self.assertEqual(TIMES.sub("", answer["out"]), TIMES.sub("", out), said)
            return Differences()
        expected = json.loads(out)
        box = expected.get("outlines", {}).get("box_m", [])
        found = Differences(max(1.0, *map(abs, box)) if box else 1.0)
        found.look(expected, json.loads(answer["out"]))
        self.assertEqual(found.wrong, [], said)
        return found

    def folder_agrees(self, folder, *questions):
        bounds, numbers, count = [], [], 0
        for scene in sorted(folder.rglob("*.yaml")):
            name = str(scene.relative_to(folder))
            for question in questions:
                with self.subTest(scene=name, question=question):
                    found = self.same(folder, *question, name)
                    bounds += [(*each, name) for each in found.bounds]
                    numbers += [(*each, name) for each in found.numbers]
                    count += 1
        self.assertGreater(count, 20)
        print(f"{folder.name}: {count} runs; {len(numbers)} numbers differ, by {max(numbers, default=(0,))} of their bounds at most; "
              f"{len(bounds)} bounds differ, by {max(bounds, default=(0,))} of themselves at most")

    def test_examples(self):
        self.folder_agrees(ROOT / "examples", ["solve"], ["solve", "--json", "--outlines"], ["derive"], ["derive", "--json"])

    def test_hard_cases(self):
        """The scenes on which doubles go wrong."""
        self.folder_agrees(ROOT / "tests" / "hard", ["solve"], ["solve", "--json"])

    def test_bad_scenes(self):
        """What is refused is refused in the same words, at the same line and column."""
        self.folder_agrees(ROOT / "tests" / "bad", ["solve"], ["solve", "--json"])

    def test_other_commands(self):
        """The paper's claims, 300 digits, sweeps, profiles, terms, help, and words that are wrong."""
        folder = ROOT / "examples"
        for words in (
            ["verify", "--json", "paper/claims.yaml"],
            ["verify", "paper/claims.yaml"],
            ["solve", "--digits", "300", "block_e_valley.yaml"],
            ["solve", "--digits", "300", "--json", "block_e_valley.yaml"],
            ["solve", "--table", "block_e_valley.yaml", "block_f.yaml"],
            ["solve", "--find", "friction_angle_deg", "--for", "fos=1.2", "block_e_valley.yaml"],
            ["sweep", "block_e_valley.yaml", "--x", "tilt.angle_deg=0:40:9"],
            ["chart", "map", "slab_left.yaml", "--x", "block.slab.width=-10:150", "--json"],
            ["derive", "--limit", "block_e_valley.yaml"],
            ["explain", "dilation"],
            ["new", "--help"],
            ["--help"],
            ["--version"],
            ["solve", "--help"],
            ["solve", "--no-such-option", "block_f.yaml"],
            ["solve", "no_such_file.yaml"],
            ["solve", "--digits", "many", "block_f.yaml"],
            ["solve"],
            [],
        ):
            with self.subTest(words=words):
                self.same(folder, *words)

    def test_nothing_stays(self):
        """A run begins as a new process does: quiet is not kept, and memory does not grow in a thousand runs."""
        folder = ROOT / "examples"
        first = self.core.run(folder, "solve", "block_e_valley.yaml")
        self.assertEqual(self.core.run(folder, "solve", "--quiet", "block_e_valley.yaml")["out"], "")
        self.assertEqual(self.core.run(folder, "solve", "--no-such-option", "block_e_valley.yaml")["status"], 2)
        again = self.core.run(folder, "solve", "block_e_valley.yaml")
        self.assertEqual(TIMES.sub("", again["out"]), TIMES.sub("", first["out"]))
        for _ in range(1000):
            last = self.core.run(folder, "solve", "--json", "block_e_valley.yaml")
        self.assertEqual(last["memory"], again["memory"])


if __name__ == "__main__":
    main()
