# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The Topple authors
"""gnuplot, and ffmpeg, as other programs: what the user has set for them, and what they do wrong.

`GNUTERM`, a `~/.gnuplot`, POSIXLY_CORRECT and a locale changed or broke the figures; a gnuplot that
hung hung the program."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from harness import PROGRAM, ROOT, main

CHARTS = (("fos",), ("--x", "block.slab.width=20:150", "map", "examples/slab_left.yaml"))

# A gnuplot that ends in some wrong way, and what the program says of it.
FAILURES = {
    "true; exit 0": "drew nothing and said nothing",
    "cat >/dev/null; exit 0": "drew nothing and said nothing",
    "cat >/dev/null; echo half; echo it broke >&2; exit 3": "it broke",
    "echo half; kill -9 $$": "gnuplot failed",
    "echo half; kill -SEGV $$": "gnuplot failed",
    "exec 0<&- 1>&- 2>&-; exit 1": "gnuplot failed",
    "yes complaint | head -c 3000000 >&2; cat >/dev/null; exit 1": "complaint complaint",
    "exit 127": "gnuplot failed",
}
# A gnuplot that does not end.
HANGS = ("exec sleep 100", "cat >/dev/null; echo half; exec sleep 100",
         "exec 0<&- 1>&- 2>&-; exec sleep 100", "sleep 100 & cat >/dev/null; echo half; exit 0",
         "trap '' TERM INT HUP; sleep 100; sleep 100")


class Gnuplot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="topple gnuplot ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def command(self, name, chart=CHARTS[0]):
        # options first, as POSIXLY_CORRECT wants them of this program too
        return [PROGRAM, "chart", "--output", self.folder / name, *chart]

    def stand_in(self, name, script, program="gnuplot"):
        """A folder with a gnuplot of our own, or an ffmpeg."""
        tools = self.folder / name
        tools.mkdir()
        (tools / program).write_text(f"#!/bin/sh\n{script}\n")
        (tools / program).chmod(0o755)
        return {**os.environ, "PATH": f"{tools}:/usr/bin:/bin"}

    def test_what_the_user_has_set(self):
        """One byte of difference, and the setting has reached gnuplot."""
        home = self.folder / "home"
        (home / ".config" / "fontconfig").mkdir(parents=True)
        (home / ".gnuplot").write_text("set term dumb\nset grid\nset decimalsign ','\n")
        (home / "gnuplotrc").write_text("exit\n")
        (home / ".config" / "fontconfig" / "fonts.conf").write_text(
            "<fontconfig><match target='pattern'><edit name='family' mode='assign' binding='strong'>"
            "<string>DejaVu Sans Mono</string></edit></match></fontconfig>")
        settings = {
            "HOME": str(home), "XDG_CONFIG_HOME": str(home / ".config"), "GNUTERM": "dumb",
            "GNUPLOT_LIB": str(home), "GNUPLOT_SHARE_DIR": str(home), "GNUPLOT_PS_DIR": str(home),
            "GNUPLOT_DRIVER_DIR": "/nonexistent", "GNUPLOT_DEFAULT_GDFONT": "none", "GNUHELP": "/nonexistent",
            "GDFONTPATH": "/nonexistent", "GNUPLOT_FONTPATH": "/nonexistent", "GNUFITLOG": "/nonexistent",
            "GNUPLOT_PDF_FONT": "none", "FONTCONFIG_FILE": "/nonexistent", "FONTCONFIG_PATH": "/nonexistent",
            "POSIXLY_CORRECT": "1", "LC_ALL": "de_DE.UTF-8", "LC_NUMERIC": "de_DE.UTF-8", "LANG": "ar_EG.UTF-8",
            "LANGUAGE": "de", "TZ": "Asia/Tokyo", "SOURCE_DATE_EPOCH": "1", "COLUMNS": "3", "LINES": "2",
            "GNUPLOT_BROWSER": "false", "SHELL": "/bin/false", "PAGER": "false", "TERM": "none"}
        environments = {"none": {"PATH": os.environ["PATH"]}, "all": {**os.environ, **settings},
                        **{name: {**os.environ, name: value} for name, value in settings.items()
                           if name.startswith(("GNUTERM", "HOME", "POSIX", "LC_ALL", "FONTCONFIG", "SOURCE"))}}
        for chart in CHARTS:
            for kind in ("svg", "pdf", "png"):
                first = None
                for name, environment in environments.items():
                    done = subprocess.run(self.command(f"a.{kind}", chart), cwd=ROOT, env=environment,
                                          check=False, capture_output=True, encoding="utf-8")
                    self.assertEqual((done.returncode, done.stderr), (0, ""), name)
                    data = (self.folder / f"a.{kind}").read_bytes()
                    first = first or data
                    self.assertTrue(data == first, f"{kind} with {name}")

    def test_failures(self):
        """Status 5, what it said, and the file as before."""
        (self.folder / "a.svg").write_text("as before")
        for k, (script, said) in enumerate(FAILURES.items()):
            done = subprocess.run(self.command("a.svg"), cwd=ROOT, env=self.stand_in(f"tools {k}", script),
                                  check=False, capture_output=True, encoding="utf-8")
            self.assertEqual((done.returncode, done.stdout), (5, ""), script)
            self.assertIn(said, done.stderr)
            self.assertIn("gnuplot failed", done.stderr)
            self.assertEqual((self.folder / "a.svg").read_text(), "as before")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])

    def test_cannot_be_started(self):
        environment = self.stand_in("tools", "exit 0")
        (self.folder / "tools" / "gnuplot").write_text("#!/nonexistent/shell\n")
        for path in (environment["PATH"].split(":")[0], "/nonexistent"):
            done = subprocess.run(self.command("a.svg"), cwd=ROOT, env={"PATH": path},
                                  check=False, capture_output=True, encoding="utf-8")
            self.assertEqual((done.returncode, done.stdout), (5, ""))
            self.assertIn("gnuplot", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["tools"])

    def test_hangs(self):
        """Every kind of hanging ends after a minute, all at the same time here."""
        processes = []
        for k, script in enumerate(HANGS):
            (self.folder / f"{k}.svg").write_text("as before")
            processes.append(subprocess.Popen(  # pylint: disable=consider-using-with
                self.command(f"{k}.svg"), cwd=ROOT, env=self.stand_in(f"tools {k}", script),
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8"))
        animation = [PROGRAM, "tilt", "--json", "--animation", self.folder / "a.webm", "examples/tilt_block_f.yaml"]
        with subprocess.Popen(animation, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8",
                              env=self.stand_in("moving", "cat >/dev/null; exec sleep 100", "ffmpeg")) as film:
            self.assertIn("ffmpeg failed: it did nothing for 60 seconds", film.communicate(timeout=300)[1])
            self.assertEqual(film.returncode, 5)
        self.assertFalse((self.folder / "a.webm").exists())
        for k, process in enumerate(processes):
            out, err = process.communicate(timeout=300)
            self.assertEqual((process.returncode, out), (5, ""), HANGS[k])
            self.assertIn("did nothing for 60 seconds", err)
            self.assertEqual((self.folder / f"{k}.svg").read_text(), "as before")
        self.assertEqual(list(self.folder.glob("**/*.part")), [])


if __name__ == "__main__":
    main()
