# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""Messages, and what else tells of names, keys and words of the command line: plain, bounded, and
silent about files that are none of ours.

The story: an escape sequence in the name of a file, in a key or in an option recoloured the terminal
or gave it a title, and a scene whose outline was /etc/passwd printed a line of it."""

import os
import re

import hostile
from harness import main
from hostile import CLAIMS, SCENE, SLAB


class Messages(hostile.Case):
    def test_formulas_and_names_of_claims(self):
        """What is printed, the quantity, names of geometries, symbols and columns: a verdict or a message."""
        (self.path / "slab.yaml").write_text(SLAB)
        base = CLAIMS.format("x", "y", '"26.60"', "z")
        for number, text in enumerate(hostile.TEXTS):
            quoted = hostile.yaml(text)
            places = [(f'"{old}"', quoted) for old in ("26.60", "a*b + a")]
            places += (("quantity: area", f"quantity: {quoted}"), ("geometry: slab, quantity: area", f"geometry: {quoted}, quantity: area"),
                       ("geometries:", f"symbols: {{{quoted}: 1}}\ngeometries:"), ("scene: slab.yaml", f"scene: {quoted}"),
                       ("unit: x", f"{quoted}: x"), ("towards: left", f"towards: {quoted}"), ("topple_claims: 1", f"topple_claims: {quoted}"))
            for old, new in hostile.share(places, number):
                self.assertIn(old, base)
                self.claims_run(base.replace(old, new))

    def claims_run(self, text):
        (self.path / "claims.yaml").write_text(text)
        out, err = self.run_bytes("verify", "claims.yaml", status=(0, 1, 3, 5))
        hostile.plain(out, self)
        if err:
            hostile.one_line(err, self)

    def test_keys_and_values(self):
        """Hostile keys and values end in one plain line."""
        base = SCENE.format(title="x")
        for number, text in enumerate(hostile.TEXTS):
            quoted = hostile.yaml(text)
            places = (("tilt:", f"{quoted}: 1\ntilt:"), ("{a: 30,", f"{{{quoted}: 30, a: 30,"), ("angle_deg: 20", f"angle_deg: {quoted}"),
                      ("count: 3", f"count: {quoted}"), ("left_end: valley", f"left_end: {quoted}"), ("towards: left", f"towards: {quoted}"),
                      ("length_unit: mm", f"length_unit: {quoted}"), ("topple: 1", f"topple: {quoted}"),
                      ("a: 30", f"{quoted}: 1, {quoted}: 2, a: 30"))
            for old, new in hostile.share(places, number):
                self.assertIn(old, base)
                (self.path / "scene.yaml").write_text(base.replace(old, new))
                with self.subTest(text=text[:60], key=old):
                    out, err = self.run_bytes("solve", "scene.yaml", status=3)
                    self.assertEqual(out, b"")
                    hostile.one_line(err, self)

    def test_names_of_files(self):
        """Any bytes may name a file: where a page, JSON or a message tells the name, it is text."""
        names = [b"a\x1b[31m.yaml", b"\xff\xfe\xc3.yaml", b"a\nb.yaml", b"\xe2\x80\xae.yaml", b"-x\x1b.yaml", b"d'\"`$(id)|<b>.yaml",
                 "é".encode() * 120 + b".yaml", b"x" * 200 + "岩".encode() * 15 + b".yaml"]
        text = SCENE.format(title="x")
        for name in names:
            deep = os.fsencode(self.path) + b"/" + name.replace(b".yaml", b"") + b"/" + name
            os.makedirs(os.path.dirname(deep), exist_ok=True)
            for path in (b"./" + name, deep):
                with open(os.path.join(os.fsencode(self.path), path), "wb") as file:
                    file.write(text.encode())
                with self.subTest(path=path):
                    hostile.plain(self.run_bytes("solve", path)[0], self)
                    for effect in hostile.as_json(self.run_bytes("solve", "--json", path)[0], self)["cases"][0]["effects"]:
                        if ".yaml" in effect["called_for_by"]:
                            self.assertRegex(effect["called_for_by"], r"\.yaml(:\d+)*$")
                    hostile.one_line(self.run_bytes("solve", path + b"/none", status=5)[1], self)
                    hostile.one_line(self.run_bytes("solve", path + b"none", status=5)[1], self)
                    hostile.one_line(self.run_bytes("derive", "--for-all", "count", path + b"none", status=5)[1], self)
                    self.run_bytes("solve", b"--figure", b"./f" + name[:20] + b".svg", path)
                    hostile.one_line(self.run_bytes("solve", b"--figure", path + b"/no/f.svg", path, status=5)[1], self)

    def test_words_of_the_command_line(self):
        """Options and their values, known and unknown, with every hostile string."""
        scene = self.scene("x")
        forms = [["{}"], ["solve", "{}"], ["solve", "--find", "{}", "--for", "fos=1", scene], ["solve", "--find", "a", "--for", "{}", scene],
                 ["solve", "--digits", "{}", scene], ["solve", "--level={}", scene], ["solve", "--figure", "{}", scene], ["solve", "--{}", scene],
                 ["solve", "-{}", scene], ["solve", "--fi{}", scene], ["solve", "--f={}", scene], ["solve", "--json={}", scene],
                 ["solve", scene, "{}"], ["solve", "--from", "{}", scene], ["derive", "--for-all", "{}", scene], ["derive", "-j{}", scene],
                 ["chart", "{}"], ["chart", "map", scene, "--x", "{}=1:2"], ["chart", "map", scene, "--x", "a={}"],
                 ["chart", "map", scene, "--x", "a=20:40", "--output", "{}"], ["chart", "fos", "--tilt", "{}"], ["chart", "fos", "--amplitude", "{}"],
                 ["accuracy", "--sweep={}"], ["accuracy", "--output", "{}", scene],
                 ["profile", "{}"], ["profile", "--step", "{}", scene], ["profile", "--unit", "{}", scene], ["verify", "{}"], ["verify", "a", "{}"]]
        texts = [t.encode() for t in hostile.TEXTS if t] + [b"\xff\xc3", b"\xe2\x80", b"a\xed\xa0\x80"]
        for number, text in enumerate(texts):
            for form in hostile.share(forms, number):
                words = [word.encode().replace(b"{}", text) for word in form]
                with self.subTest(words=[w[:60] for w in words]):
                    out, _ = self.run_bytes(*words, status=(0, 2, 3, 5))
                    hostile.plain(out, self)

    def test_keys_that_are_found(self):
        """A way to a number may be spelt with white space before an index, as numbers are read."""
        (self.path / "s.yaml").write_text(SLAB.replace("{slab: {width: a, height: b}}", "{outline: [[0, 0], [a, 0], [a, b], [0, b]]}").replace(
            "left}", "left, angle_deg: 20}\nfriction_angle_deg: 40"))
        key = "block.outline.\n\t+2.\r1"
        hostile.plain(self.run_bytes("solve", "--find", key, "--for", "critical_angle=20", "s.yaml")[0], self)
        found = hostile.as_json(self.run_bytes("solve", "--json", "--find", key, "--for", "critical_angle=20", "s.yaml")[0], self)
        self.assertEqual(found["find"]["key"], key)
        words = ["chart", "map", "s.yaml", "--x", f"{key}=0.5:2"]
        hostile.as_csv(self.run_bytes(*words)[0], self)
        hostile.as_json(self.run_bytes(*words, "--json")[0], self)
        self.run_bytes(*words, "--output", "c.svg")
        hostile.as_xml((self.path / "c.svg").read_bytes(), self)

    def test_cells(self):
        for text in hostile.TEXTS:
            data = b"0,0\n1,0\n" + text.encode() + b",1\n0,1\n"
            (self.path / "o.csv").write_bytes(data)
            for scene in ("block: {outline: o.csv}", "block: {slab: {width: 1, height: 1}}\nbase: {profile: o.csv}"):
                (self.path / "s.yaml").write_text(f"topple: 1\nlength_unit: m\n{scene}\n")
                _, err = self.run_bytes("solve", "s.yaml", status=(0, 3))
                if err:
                    hostile.one_line(err, self)

    def test_other_files_are_not_told(self):
        """A scene that names a file which is none of ours prints nothing that stands in it."""
        secrets = ["-----BEGIN KEY-----\nc2VjcmV0c2VjcmV0\n", "root:x:0:0:root:/root:/bin/bash\ndaemon:x:1:1:secretsecret\n",
                   "1 2\n3 4\nsecretsecret 5\n", "1,secretsecret\n", "password: secretsecret\npassword: othersecret\n", "secretsecret: [1, 2\n",
                   "secretsecret\n", "'secretsecret", "- secretsecret\n- {a: *secretsecret}\n", "%secretsecret\n---\n", "!secretsecret!x y\n",
                   "{secretsecret: 1, secretsecret: 2}", "secretsecret: 1\n  bad: 2\n", "[secretsecret: 1, 0secretsecret]", "0secretsecret\n", "1/secretsecret 2\n"]
        words = re.compile(r"secret|root|daemon|password|BEGIN|c2Vj|bash")
        for secret in secrets:
            (self.path / "other").write_text(secret)
            for scene in ("block: {outline: other}", "block: {slab: {width: 1, height: 1}}\nbase: {profile: other}",
                          "block: {outline: [[0,0],[1,0],[0,1]], holes: [other]}"):
                (self.path / "s.yaml").write_text(f"topple: 1\nlength_unit: m\n{scene}\n")
                self.untold(words, "solve", "s.yaml")
            self.untold(words, "solve", "other")
            self.untold(words, "verify", "other")
            self.untold(words, "chart", "map", "other", "--x", "passwor=1:2")
            (self.path / "c.yaml").write_text(CLAIMS.format("x", "y", '"1"', "z").replace("slab.yaml", "other"))
            self.untold(words, "verify", "c.yaml")

    def untold(self, words, *command):
        out, err = self.run_bytes(*command, status=3)
        hostile.one_line(err, self)
        self.assertNotRegex(err.decode(), words)
        self.assertEqual(out, b"")

    def test_quotes_are_bounded(self):
        """A message quotes the beginning of what is long, cut at a character."""
        long = "ä" * 5000
        (self.path / "s.yaml").write_text(SCENE.format(title="x").replace("{a: 30", f"{{a: '{long}'"), encoding="utf-8")
        _, err = self.run_bytes("solve", "s.yaml", status=3)
        self.assertIn("ä…'", hostile.one_line(err, self))
        self.assertLess(len(err), 400)


if __name__ == "__main__":
    main()
