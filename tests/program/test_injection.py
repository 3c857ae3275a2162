# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""What comes from outside is text, in every language that the program writes.

The story: a title that held the end of a comment became a function of the C that `derive --c`
writes, a line break in one began a command of LaTeX, escape sequences reached the terminal, and a
scene whose outline was /etc/passwd printed a line of it. Here every string position of every input
(titles, keys, values, names, cells, claims, words of the command line) takes every hostile string,
and every output is read by a parser of its language that knows nothing of the program."""

import math
import re
import unittest

import hostile
from harness import ROOT, main, rounds
from hostile import CLAIMS, SCENE, SLAB

class Outputs(hostile.Case):
    def each_title(self, *words, every=1, harmless="x"):
        """Stdout of the command for each hostile title, which has as many lines as for another; of a command that takes
        its time, and writes by the same encoder as one that does not, for every so many alone, but in the long rounds."""
        lines = self.run_bytes(*words, self.scene(harmless))[0].count(b"\n")
        for title in hostile.TEXTS[::rounds(every, 1)]:
            with self.subTest(title=title[:60], words=words):
                out, err = self.run_bytes(*words, self.scene(title))
                self.assertEqual(err, b"")
                yield title, out, lines

    def test_titles_on_a_page(self):
        """Text pages have the lines of a harmless title; a title that can be seen is there as it is."""
        for every, words in ((1, ["solve"]), (5, ["solve", "--elements"]), (1, ["derive"]),
                             (5, ["derive", "--limit", "--rounded", "--elements"]), (5, ["derive", "--for-all", "count"]),
                             (5, ["solve", "--find", "a", "--for", "critical_angle=10"])):
            for title, out, lines in self.each_title(*words, every=every):
                text = hostile.plain(out, self)
                self.assertEqual(out.count(b"\n"), lines)
                if title.strip() and "--find" not in words and not any(map(hostile.unseen, title)):
                    self.assertIn(title, text)

    def test_titles_in_json(self):
        for every, words in ((1, ["solve", "--json"]), (5, ["derive", "--json"]), (5, ["derive", "--json", "--for-all", "count"]),
                             (5, ["solve", "--json", "--find", "a", "--for", "critical_angle=10"])):
            for title, out, _ in self.each_title(*words, every=every):
                document = hostile.as_json(out, self)
                self.assertEqual(document.get("title", title), title)

    def test_titles_in_c(self):
        """The compiler sees the code that it sees under a harmless title, and of that makes the functions of the formulas
        and no other."""
        for every, words in ((1, ["derive", "--c"]), (5, ["derive", "--c", "--for-all", "count"])):
            harmless = self.run_bytes(*words, self.scene("x"))[0]
            names = re.findall(rb"^double (\w+)\(", harmless, re.M)
            hostile.compile_c(harmless, self, self.path, [name.decode() for name in names], thorough=False)
            code = hostile.code_of_c(harmless, self, self.path)
            for _, out, _ in self.each_title(*words, every=every):
                self.assertEqual(hostile.code_of_c(out, self, self.path), code)

    def test_titles_in_latex(self):
        for every, words in ((1, ["derive", "--latex"]), (5, ["derive", "--latex", "--elements", "--limit"]),
                             (5, ["derive", "--latex", "--for-all", "count"])):
            for _, out, lines in self.each_title(*words, every=every):
                hostile.as_latex(out, self)
                self.assertEqual(out.count(b"\n"), lines)

    def test_titles_in_a_table(self):
        for _, out, lines in self.each_title("solve", "--table"):
            hostile.as_markdown(out, self, 14)
            self.assertEqual(out.count(b"\n"), lines)

    def test_titles_in_figures(self):
        """Drawings by Cairo: well-formed, whatever the title."""
        for k, title in enumerate(hostile.TEXTS):
            with self.subTest(title=title[:60]):
                for kind, begins in (("svg", b"<?xml"), ("pdf", b"%PDF"), ("png", b"\x89PNG"))[:1 if k % 8 else 3]:
                    self.run_bytes("solve", "--figure", f"f.{kind}", self.scene(title))
                    data = (self.path / f"f.{kind}").read_bytes()
                    self.assertTrue(data.startswith(begins))
                    if kind == "svg":
                        hostile.as_xml(data, self)
                    if kind == "pdf":
                        self.assertNotIn(b"/Title", data)

    def test_titles_in_charts(self):
        """gnuplot executes nothing, draws well-formed SVG, and shows the title as it is."""
        words = ["chart", "map", "scene.yaml", "--x", "a=20:40", "--y", "tilt=0:40"]
        for title in hostile.TEXTS[::rounds(2, 1)]:
            with self.subTest(title=title[:60]):
                self.scene(title)
                self.run_bytes(*words, "--output", "c.svg")
                root = hostile.as_xml((self.path / "c.svg").read_bytes(), self)
                texts = ["".join(e.itertext()).strip() for e in root.iter() if e.tag.endswith("}text")]
                if title.strip() and not any(map(hostile.unseen, title)) and len(title) < 100:
                    self.assertIn(title.strip().replace("]]>", "]] >"), texts)
                self.assertEqual({p.name for p in self.path.iterdir()}, {"scene.yaml", "c.svg"})

    def test_accuracy(self):
        for title in hostile.TEXTS[::rounds(30, 1)]:  # a second each
            with self.subTest(title=title[:60]):
                self.scene(title, text=SLAB.replace("length_unit", "title: {title}\nlength_unit").replace(
                    "{a: 1, b: 2}", "{{a: 1, b: 2}}").replace("{slab: {width: a, height: b}}", "{{slab: {{width: a, height: b}}}}").replace(
                    "{mated: true}", "{{mated: true}}").replace("{towards: left}", "{{towards: left}}"))
                hostile.plain(self.run_bytes("accuracy", "scene.yaml")[0], self)
                self.assertEqual(hostile.as_json(self.run_bytes("accuracy", "--json", "scene.yaml")[0], self)["title"], title)
                self.run_bytes("accuracy", "--output", "a.svg", "scene.yaml")
                hostile.as_xml((self.path / "a.svg").read_bytes(), self)

    def test_profiles(self):
        for title in hostile.TEXTS[::6]:
            with self.subTest(title=title[:60]):
                self.scene(title)
                hostile.plain(self.run_bytes("profile", "scene.yaml")[0], self)
                self.assertEqual(hostile.as_json(self.run_bytes("profile", "--json", "scene.yaml")[0], self)["title"], title)
                self.run_bytes("profile", "--output", "p.svg", "scene.yaml")
                hostile.as_xml((self.path / "p.svg").read_bytes(), self)

    def test_names_of_parameters(self):
        """Every name that a scene may give, among a few and with all others: C compiles and computes, LaTeX
        stands, and text and JSON keep the name."""
        few, step = rounds((6, 6), (2, 1))
        for names in [*(hostile.NAMES[k:k + few] for k in range(0, len(hostile.NAMES), step)), hostile.NAMES]:
            with self.subTest(names=names):
                widths = "+".join(names)
                values = [k + 1 for k in range(len(names))]
                parameters = ", ".join(f"{n}: {v}" for n, v in zip(names, values))
                text = SLAB.replace("{a: 1, b: 2}", "{%s}" % parameters).replace("width: a, height: b",
                                                                                f"width: {widths}, height: 2*{names[0]}")
                (self.path / "s.yaml").write_text(text.replace("\nbase", "\nfriction_angle_deg: 60\nbase"))
                options = ["--elements"] + ["--limit"] * ("phi" not in names)
                out = self.run_bytes("derive", "--c", *options, "s.yaml")[0]
                functions = re.findall(rb"^(?:double|int) (\w+)\(", out, re.M)
                library = hostile.compile_c(out, self, self.path, [f.decode() for f in functions])
                self.assertEqual(hostile.call(library, "area", *values), 2 * sum(values))
                self.assertEqual(hostile.call(library, "tan_critical_angle_1", *values), sum(values) / 2)
                hostile.as_latex(self.run_bytes("derive", "--latex", *options, "s.yaml")[0], self)
                symbols = hostile.as_json(self.run_bytes("derive", "--json", "s.yaml")[0], self)["symbols"]
                self.assertEqual(symbols, names)

    def test_renamed_parameters_of_a_family(self):
        """N, n and N_ taken: the count has a name of its own, and C says which name is whose."""
        text = SCENE.format(title="x").replace("{a: 30, b: 120, c: 5}", "{N: 30, n: 120, double: 5}").replace(
            "width: a, height: b, depth: c", "width: N, height: n, depth: double")
        (self.path / "s.yaml").write_text(text)
        out = self.run_bytes("derive", "--c", "--for-all", "count", "s.yaml")[0]
        names = [f"tan_critical_angle_{parity}_{side}" for parity in ("odd", "even") for side in ("left", "right")]
        library = hostile.compile_c(out, self, self.path, names)
        self.assertIn(b"p_double for double", out)
        solved = hostile.as_json(self.run_bytes("derive", "--json", "s.yaml")[0], self)
        left = min((p for p in solved["pivots"] if p["governs"]), key=lambda p: p["critical_angle_deg"]["value"])
        self.assertAlmostEqual(math.degrees(math.atan(hostile.call(library, names[0], 3, 30, 120, 5))),
                               left["critical_angle_deg"]["value"], places=9)

    def test_claims(self):
        """Every string of a claims file in all three reports of a verification."""
        (self.path / "slab.yaml").write_text(SLAB)
        lines = None
        for text in ["harmless", *hostile.TEXTS]:
            with self.subTest(text=text[:60]):
                quoted = hostile.yaml(text)
                (self.path / "claims.yaml").write_text(
                    CLAIMS.format(quoted, hostile.yaml(text[:100]), '"26.60"', hostile.yaml("2" + text[:100])))
                out = hostile.plain(self.run_bytes("verify", "claims.yaml", status=1)[0], self)
                lines = lines or len(out.splitlines())
                self.assertEqual(len(out.splitlines()), lines)
                page = self.run_bytes("verify", "--markdown", "claims.yaml", status=1)[0]
                page = hostile.as_markdown(page, self, 4)
                self.assertEqual([line[:3] for line in page.splitlines() if line.startswith(("#", "|"))],
                                 [page.splitlines()[0][:3], "## ", "###", "###", "## ", "| c", "|--"] + [l[:3] for l in page.splitlines()[-2:]])
                claims = hostile.as_json(self.run_bytes("verify", "--json", "claims.yaml", status=1)[0], self)["claims"]
                self.assertEqual([claims[0][k] for k in ("where", "unit", "note")], [text] * 3)
                self.assertNotIn("\ufffd", claims[0]["id"] + claims[1]["id"])  # cut between characters

class Sources(unittest.TestCase):
    """Nobody forgets an encoder: fields that the headers mark as from outside are no arguments of printf's kin."""

    def writers(self):
        """The rooms that write, and of the charts what writes them: what computes one keeps its labels plain."""
        found = [path for room in ("output", "report", "figure", "cli")
                 for path in sorted((ROOT / "src").glob(f"*/{room}/*.c"))]
        found += [ROOT / "src/parametric/chart" / name for name in ("ffmpeg.c", "file.c", "gnuplot.c", "program.c", "script.c", "table.c")]
        self.assertGreater(len(found), 60)
        return found

    def test_json_is_not_written_by_hand(self):
        """No text of the sources ends a key in a quote and a colon: that is the business of output/json.h."""
        for source in (ROOT / "src").rglob("*.[ch]"):
            self.assertNotIn('\\":', source.read_text(encoding="utf-8"), source)

    def test_marked_fields(self):
        fields = set()
        for header in (ROOT / "include" / "topple").glob("topple*.h"):
            for declaration in re.findall(r"TP_OUTSIDE\s+char([^;]*);", header.read_text(encoding="utf-8")):
                fields |= set(re.findall(r"\w+(?=\s*(?:,|$|\[))", declaration))
        self.assertGreaterEqual(fields, {"title", "source", "id", "where", "note", "printed", "called_for_by", "symbols"})
        for source in self.writers():
            # `name` is marked of load cases, of many blocks and of surveyed ones, whose faults have a `text`; of loads and units the
            # one is a word of the library, of other structs the other what the library writes
            marked = fields if re.search("batch|cases|block", source.name) else fields - {"name"}
            if not re.search("report/batch", source.as_posix()):
                marked = marked - {"text"}
            if source.name == "solid_contacts.c":
                marked = marked - {"at"}  # where a contact is
            if source.name == "profile.c":
                marked = marked - {"source"}  # the publication of a correlation
            use = re.compile(r"->(%s)\b(?!\s*[!=]=|\(|\.|->)" % "|".join(sorted(marked)))
            text = re.sub(r"'(?:\\.|[^'\\])'", "0", re.sub(r'"(?:\\.|[^"\\])*"', '""', source.read_text(encoding="utf-8")))
            if source != ROOT / "src/applications/cli/words.c":
                self.assertNotIn("fprintf(stderr", text, source)
            for start in re.finditer(r"\b(tp_text_add|tp_text_append|f?printf|v?snprintf|fputs)\(", text):
                depth, end = 1, start.end()
                while depth > 0:
                    depth += {"(": 1, ")": -1}.get(text[end], 0)
                    end += 1
                self.assertIsNone(use.search(text, start.end(), end), f"{source.name}: {text[start.start():end]}")


if __name__ == "__main__":
    main()
